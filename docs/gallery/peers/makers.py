"""The tables as a practised user of each library sets it, in some twenty lines, by its documentation."""

from __future__ import annotations

import io
from importlib import import_module
from pathlib import Path
from typing import Any

from data import CAPTION, LONG, SPANNERS, USUAL, WIDE, Case, comma

from kurbel.formats.render import render

FOLDER = Path(__file__).parent
# Of the terminal.
COLUMNS = 80


def _frame(case: Case) -> Any:
    pandas = import_module("pandas")
    heads = ["ratio", "phi", *case.columns]
    lines = [(f"R:L = {row.ratio}", row.phi, *map(float, row.values)) for row in case.rows]
    return pandas.DataFrame(lines, columns=heads)


# In the terminal.


def kurbel_text(case: Case = USUAL) -> str:
    return render(case.page, "text", width=COLUMNS)


def tabulate_text(case: Case = USUAL) -> str:
    tabulate = import_module("tabulate").tabulate
    heads = ["φ in °", *(f"{symbol}\n{head}" for _, _, symbol in SPANNERS for head in case.heads)]
    blocks = []
    for ratio in case.ratios:
        lines = [[row.phi, *map(comma, row.values)] for row in case.of(ratio)]
        form = {"tablefmt": "simple", "disable_numparse": True, "colalign": ("right",) * len(heads)}
        blocks.append(f"R:L = {ratio}\n" + str(tabulate(lines, heads, **form)))
    return CAPTION + "\n\n" + "\n\n".join(blocks)


def rich_text(case: Case = USUAL) -> str:
    """Return the page with its escape codes."""
    box, console, table = (import_module(f"rich.{name}") for name in ("box", "console", "table"))
    made = table.Table(title=CAPTION, box=box.SIMPLE_HEAD, header_style="bold")
    made.add_column("φ in °", justify="right")
    for _, _, symbol in SPANNERS:
        for head in case.heads:
            made.add_column(f"{symbol}\n{head}", justify="right")
    for ratio in case.ratios:
        made.add_row(f"[italic]R:L = {ratio}[/]")
        block = case.of(ratio)
        for row in block:
            made.add_row(str(row.phi), *map(comma, row.values), end_section=row is block[-1])
    stream = io.StringIO()
    console.Console(file=stream, width=COLUMNS, force_terminal=True, color_system="standard").print(made)
    return stream.getvalue()


# In HTML.


def kurbel_html(case: Case = USUAL) -> str:
    return case.page.typeset("html", standalone=True)


def great_tables_html(case: Case = USUAL) -> str:
    gt = import_module("great_tables")
    made = gt.GT(_frame(case), rowname_col="phi", groupname_col="ratio").tab_header(title=CAPTION)
    made = made.fmt_number(columns=case.columns, decimals=4, locale="de").tab_stubhead(
        label=gt.html("<i>φ</i> in °")
    )
    for (name, symbol, _), keys in zip(SPANNERS, case.keys, strict=True):
        made = made.tab_spanner(label=gt.html(f"{name} {symbol}"), columns=[*keys])
        made = made.cols_label(dict(zip(keys, case.heads, strict=True)))
    made = made.tab_source_note(gt.html("sin <i>ψ</i> = <i>λ</i> sin <i>φ</i>, <i>λ</i> = <i>R</i>/<i>L</i>"))
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    return head + str(made.as_raw_html())


def pandas_html(case: Case = USUAL) -> str:
    pandas = import_module("pandas")
    frame = _frame(case).set_index(["ratio", "phi"])
    frame.index.names = ["", "φ in °"]
    frame.columns = pandas.MultiIndex.from_tuples(
        [(f"{name} {symbol}", head) for name, symbol, _ in SPANNERS for head in case.heads]
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
\begin{document}
%s
\end{document}
"""


def kurbel_latex(case: Case = USUAL) -> str:
    return _ARTICLE % (r"\usepackage{longtable,rotating}", case.page.typeset("latex", longtable=case is LONG))


def pandas_latex(case: Case = USUAL) -> str:
    pandas = import_module("pandas")
    frame = _frame(case).set_index(["ratio", "phi"])
    frame.index.names = ["", r"$\varphi$ in °"]
    frame.columns = pandas.MultiIndex.from_tuples(
        [(f"{name} ${symbol}$", head) for name, _, symbol in SPANNERS for head in case.heads]
    )
    style = frame.style.format("{:.4f}", decimal=",")
    options = {"hrules": True, "caption": CAPTION, "multicol_align": "c"}
    long = {"environment": "longtable"} if case is LONG else {"position_float": "centering"}
    form = "ll" + "r" * len(case.columns)
    return _ARTICLE % (r"\usepackage{longtable}", style.to_latex(column_format=form, **options, **long))


def great_tables_latex(case: Case = USUAL) -> str:
    gt = import_module("great_tables")
    made = gt.GT(_frame(case), rowname_col="phi", groupname_col="ratio").tab_header(title=CAPTION)
    made = made.fmt_number(columns=case.columns, decimals=4, locale="de")
    for (name, _, symbol), keys in zip(SPANNERS, case.keys, strict=True):
        made = made.tab_spanner(label=f"{name} {symbol.replace('^2', '²')}", columns=[*keys])
        made = made.cols_label(dict(zip(keys, case.heads, strict=True)))
    needs = r"\usepackage{caption,array,xcolor,longtable,tabularx}\DeclareUnicodeCharacter{2212}{$-$}"
    return _ARTICLE % (needs, made.as_latex(use_longtable=case is LONG))


def hand_latex(case: Case = USUAL) -> str:
    """Set it as a careful hand does, with booktabs and siunitx, what is tall by longtable, what is wide by
    rotating."""
    name = "hand.tex" if case is USUAL else "hand-wide.tex" if case is WIDE else "hand-long.tex"
    lines = []
    for ratio in case.ratios:
        lines.append(
            rf"\multicolumn{{{len(case.columns) + 1}}}{{@{{}}l}}{{$R:L={ratio}$}}\\*\addlinespace[2pt]"
        )
        every = 5 if case is LONG else 30
        for row in case.of(ratio):
            pause = r"\addlinespace[3pt]" if row.phi % every == 0 and row.phi else ""
            lines.append(f"{pause}{row.phi} & {' & '.join(row.values)}\\\\")
        lines.append(r"\addlinespace")
    return _by_hand(name, lines[:-1])


def _by_hand(name: str, lines: list[str]) -> str:
    written = (FOLDER / name).read_text(encoding="utf-8")
    return written.replace("CAPTION", CAPTION).replace("ROWS", "\n".join(lines))


# In Typst; each returns a document.


def kurbel_typst(case: Case = USUAL) -> str:
    return case.page.typeset("typst", standalone=True)


def hand_typst(case: Case = USUAL) -> str:
    """Set it as a careful hand does, with the table of Typst itself."""
    lines = []
    for ratio in case.ratios:
        label = f"$R : L = {ratio.replace(':', ' : ')}$"
        lines.append(f"table.cell(colspan: 7, align: left, inset: (top: .8em))[{label}],")
        for row in case.of(ratio):
            top = ".6em" if row.phi % 30 == 0 and row.phi else ".25em"
            cells = (str(row.phi), *map(comma, row.values))
            lines.append("".join(f"table.cell(inset: (top: {top}))[{one}]," for one in cells))
    return _by_hand("hand.typ", lines)
