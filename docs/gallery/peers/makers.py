"""The table as a practised user of each library sets it, in some twenty lines, by its documentation."""

from __future__ import annotations

import io
from importlib import import_module
from pathlib import Path
from typing import Any

from data import CAPTION, KEYS, PAIRS, RATIOS, STROKES, comma, page, rows

from kurbel.formats.render import render

FOLDER = Path(__file__).parent
# Of the terminal.
COLUMNS = 80


def _frame() -> Any:
    pandas = import_module("pandas")
    heads = ["ratio", "phi", *KEYS]
    lines = [(f"R:L = {row.ratio}", row.phi, *map(float, row.values)) for row in rows()]
    return pandas.DataFrame(lines, columns=heads)


# In the terminal.


def kurbel_text() -> str:
    return render(page(), "text", width=COLUMNS)


def tabulate_text() -> str:
    tabulate = import_module("tabulate").tabulate
    heads = ["φ in °", *(f"{symbol}\n{stroke}" for _, _, symbol, _ in PAIRS for stroke in STROKES)]
    blocks = []
    for ratio in RATIOS:
        lines = [[row.phi, *map(comma, row.values)] for row in rows() if row.ratio == ratio]
        form = {"tablefmt": "simple", "disable_numparse": True, "colalign": ("right",) * 7}
        blocks.append(f"R:L = {ratio}\n" + str(tabulate(lines, heads, **form)))
    return CAPTION + "\n\n" + "\n\n".join(blocks)


def rich_text() -> str:
    """Return the page with its escape codes."""
    box, console, table = (import_module(f"rich.{name}") for name in ("box", "console", "table"))
    made = table.Table(title=CAPTION, box=box.SIMPLE_HEAD, header_style="bold")
    made.add_column("φ in °", justify="right")
    for _, _, symbol, _ in PAIRS:
        for stroke in STROKES:
            made.add_column(f"{symbol}\n{stroke}", justify="right")
    for ratio in RATIOS:
        made.add_row(f"[italic]R:L = {ratio}[/]")
        block = [row for row in rows() if row.ratio == ratio]
        for row in block:
            made.add_row(str(row.phi), *map(comma, row.values), end_section=row is block[-1])
    stream = io.StringIO()
    console.Console(file=stream, width=COLUMNS, force_terminal=True, color_system="standard").print(made)
    return stream.getvalue()


# In HTML.


def kurbel_html() -> str:
    return page().typeset("html", standalone=True)


def great_tables_html() -> str:
    gt = import_module("great_tables")
    made = gt.GT(_frame(), rowname_col="phi", groupname_col="ratio").tab_header(title=CAPTION)
    made = made.fmt_number(columns=[*KEYS], decimals=4, locale="de").tab_stubhead(
        label=gt.html("<i>φ</i> in °")
    )
    for name, symbol, _, keys in PAIRS:
        made = made.tab_spanner(label=gt.html(f"{name} {symbol}"), columns=[*keys])
        made = made.cols_label(dict(zip(keys, STROKES, strict=True)))
    made = made.tab_source_note(gt.html("sin <i>ψ</i> = <i>λ</i> sin <i>φ</i>, <i>λ</i> = <i>R</i>/<i>L</i>"))
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    return head + str(made.as_raw_html())


def pandas_html() -> str:
    pandas = import_module("pandas")
    frame = _frame().set_index(["ratio", "phi"])
    frame.index.names = ["", "φ in °"]
    frame.columns = pandas.MultiIndex.from_tuples(
        [(f"{name} {symbol}", stroke) for name, symbol, *_ in PAIRS for stroke in STROKES]
    )
    styles = [
        {"selector": "", "props": "border-collapse: collapse; font: 16px serif; margin: 2em auto"},
        {"selector": "th, td", "props": "padding: .1em .7em; text-align: right; font-weight: normal"},
        {"selector": "th.col_heading.level0", "props": "text-align: center; border-bottom: 1px solid"},
        {"selector": "thead", "props": "border-top: 2px solid; border-bottom: 1px solid"},
        {"selector": "tbody", "props": "border-bottom: 2px solid"},
        {"selector": "th.row_heading.level0", "props": "vertical-align: top"},
        {"selector": "caption", "props": "padding-bottom: .8em"},
    ]
    style = frame.style.format("{:.4f}", decimal=",").set_caption(CAPTION).set_table_styles(styles)
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    return head + str(style.to_html())


# In LaTeX; each returns a document.

_ARTICLE = r"""\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}\usepackage{lmodern}\usepackage[ngerman]{babel}\usepackage{amsmath,booktabs,multirow,siunitx}
%s
\begin{document}\pagestyle{empty}
%s
\end{document}
"""


def kurbel_latex() -> str:
    return _ARTICLE % ("", page().typeset("latex"))


def pandas_latex() -> str:
    pandas = import_module("pandas")
    frame = _frame().set_index(["ratio", "phi"])
    frame.index.names = ["", r"$\varphi$ in °"]
    frame.columns = pandas.MultiIndex.from_tuples(
        [(f"{name} ${symbol}$", stroke) for name, _, symbol, _ in PAIRS for stroke in STROKES]
    )
    style = frame.style.format("{:.4f}", decimal=",")
    options = {"hrules": True, "caption": CAPTION, "position_float": "centering", "multicol_align": "c"}
    return _ARTICLE % ("", style.to_latex(column_format="llrrrrrr", **options))


def great_tables_latex() -> str:
    gt = import_module("great_tables")
    made = gt.GT(_frame(), rowname_col="phi", groupname_col="ratio").tab_header(title=CAPTION)
    made = made.fmt_number(columns=[*KEYS], decimals=4, locale="de")
    for name, _, symbol, keys in PAIRS:
        made = made.tab_spanner(label=f"{name} {symbol.replace('^2', '²')}", columns=[*keys])
        made = made.cols_label(dict(zip(keys, STROKES, strict=True)))
    needs = r"\usepackage{caption,array,xcolor,longtable,tabularx}\DeclareUnicodeCharacter{2212}{$-$}"
    return _ARTICLE % (needs, made.as_latex())


def hand_latex() -> str:
    """Set it as a careful hand does, with booktabs and siunitx."""
    lines = []
    for ratio in RATIOS:
        lines.append(rf"\multicolumn{{7}}{{@{{}}l}}{{$R:L={ratio}$}}\\\addlinespace[2pt]")
        for row in rows():
            if row.ratio == ratio:
                pause = r"\addlinespace[3pt]" if row.phi % 30 == 0 and row.phi else ""
                lines.append(f"{pause}{row.phi} & {' & '.join(row.values)}\\\\")
        lines.append(r"\addlinespace")
    return _by_hand("hand.tex", lines[:-1])


def _by_hand(name: str, lines: list[str]) -> str:
    written = (FOLDER / name).read_text(encoding="utf-8")
    return written.replace("CAPTION", CAPTION).replace("ROWS", "\n".join(lines))


# In Typst; each returns a document.


def kurbel_typst() -> str:
    return page().typeset("typst", standalone=True)


def hand_typst() -> str:
    """Set it as a careful hand does, with the table of Typst itself."""
    lines = []
    for ratio in RATIOS:
        label = f"$R : L = {ratio.replace(':', ' : ')}$"
        lines.append(f"table.cell(colspan: 7, align: left, inset: (top: .8em))[{label}],")
        for row in rows():
            if row.ratio == ratio:
                top = ".6em" if row.phi % 30 == 0 and row.phi else ".25em"
                cells = (str(row.phi), *map(comma, row.values))
                lines.append("".join(f"table.cell(inset: (top: {top}))[{one}]," for one in cells))
    return _by_hand("hand.typ", lines)
