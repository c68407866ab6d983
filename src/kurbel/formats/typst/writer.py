"""Labels in Typst, the space in its tables, and what its templates read.

Typst sets figures flush under the right edge of a wide heading and gives the width that a spanner needs
beyond its columns to the last of them, as TeX does; the widths are estimated for both alike.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from typing import Any, NamedTuple

from kurbel.formats.formula import has_bar, has_stroke, is_seen
from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.writer import PERCENT_DELIMITERS, PLAIN, PageWriter, column_widths, em, spare_widths
from kurbel.page import formula as tree
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain
from kurbel.page.table import Table


class Writer(PageWriter):
    # Typst has hash signs, braces and dollar signs, but no percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark without a link: a document that prints a table twice would not compile with it."""
        return f"#super[{escape(mark)})];"

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        """Return a formula with a text for readers that do not see it, which PDF/UA asks for.

        `display` gives fractions their full size, and the line the height for it.
        """
        content = _typst(formula.content, mark)
        alternative = string(formula_plain(formula, mark))
        if display and has_bar(formula.content):
            # The empty box is as high above the middle of the digits beside it as it is deep below.
            content = f"display({content})#box(height: 2.9em, baseline: 1.12em)"
        return f"#math.equation(alt: {alternative}, ${content}$);"

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        return {"typst": typst_layout(page(table, PLAIN, mark), ready)}


# Characters that Typst obeys anywhere.
_ANYWHERE = re.compile(r"[\\#$*_@<`~\[\]\"']")
# A hyphen stays before a letter only: with another one, ?, a digit or a space it makes a dash, a break, a
# minus sign or a list. Points make an ellipsis, strokes a comment or, after a colon, a link.
_PAIRS = re.compile(r"-(?=(.?))|\.(?=\.)|(?<=\.)\.|/(?=[/*])|(?<=/)/", re.DOTALL)
# At the start of a line these make a heading, a list or a term.
_START = re.compile(r"^( *)([=+/])|^( *[0-9]+)(\.)")


def _paired(sign: re.Match[str]) -> str:
    # A fraction or a Roman numeral of one character is a number too.
    beside = sign.group(1)
    return sign.group() if beside and unicodedata.category(beside).startswith("L") else f"\\{sign.group()}"


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    escaped = _PAIRS.sub(_paired, _ANYWHERE.sub(r"\\\g<0>", prose))
    return _START.sub(r"\1\3\\\2\4", escaped)


_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


def string(text: str) -> str:
    """Return a text as a string of Typst's code, quotation marks included."""
    return f'"{text.translate(_STRING)}"'


# Beside these nothing runs together; a space beside quotation marks would be printed.
_TYPST_CLOSED = frozenset('()[]"')


def _typst(nodes: tree.Nodes, mark: str) -> str:
    result = ""
    for place in range(len(nodes)):
        piece = _typst_node(nodes, place, mark)
        result += " " * _would_join(result[-1:], piece[:1]) + piece
    return result


def _would_join(before: str, after: str) -> bool:
    """Tell whether two characters would be read as one word or, as -> is, one sign."""
    if not before or not after or {before, after} & _TYPST_CLOSED:
        return False
    return _in_word(before) == _in_word(after)


def _in_word(character: str) -> bool:
    """Tell whether Typst reads a character behind a letter as part of the word, as it does with a · too."""
    return f"x{character}".isidentifier()


def _typst_node(nodes: tree.Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case tree.Word(text) | tree.Variable(text):
            return text
        case tree.Numeral(text):
            # A comma in quotes, for else it is set with the space of a list.
            return text.replace(".", '","' if mark == "," else mark)
        case tree.Sign(":"):
            return '":"'
        case tree.Sign(text):
            return tree.SIGNS[text][0]
        case tree.Symbol(text):
            return f'"{tree.SYMBOLS[text][0]}"'
        case tree.Upright(text):
            return string(text)
        case tree.Space():
            return "thin" * is_seen(nodes, place)
        case tree.Group(content, fences):
            return f"{fences[0]}{_typst(content, mark)}{fences[1]}"
        case tree.Root(content):
            return f"sqrt({_typst(content, mark)})"
        case tree.Fraction(top, bottom) if has_stroke(nodes, place):
            below = _typst(bottom if len(bottom) == 1 else (tree.Group(bottom),), mark)
            return f"{_typst(top, mark)}\\/{below}"
        case tree.Fraction(top, bottom):
            return f"frac({_typst(top, mark)}, {_typst(bottom, mark)})"
        case tree.Script(base, index, power):
            below = f"_({_typst(index, mark)})" if index else ""
            above = f"^({_typst(power, mark)})" if power else ""
            return _typst((base,), mark) + below + above


class TypstLayout(NamedTuple):
    """The space that a table takes.

    `width` and `height` are bounds in em; `margins` are the em on both sides of the cells of each column;
    `widest` has, for each panel, rows of the widest cells of its columns, which Typst measures: to have it
    measure the whole table takes longer than to set it, and ten times the memory. The rest are numbers of
    rows, counted from 0 over the heads and bodies of all panels. An `opening` row follows a rule, a `closing`
    one stands before a rule, a `parted` one begins a group without a label.
    """

    label: str
    width: float
    height: float
    widest: tuple[tuple[tuple[PageCell, ...], ...], ...]
    columns: tuple[str, ...]
    margins: tuple[str, ...]
    opening: tuple[int, ...]
    closing: tuple[int, ...]
    parted: tuple[int, ...]


# On both sides of every cell; between two columns there are twice as many and the gutter.
MARGIN, GUTTER = 0.3, 0.6
# The height of a row, of one with a fraction of full size, and of a line of notes: rather too much.
ROW, HIGH_ROW, NOTE = 1.2, 3.1, 1.2
NARROWEST_NOTE = 24.0
# The widest of these cells in print is the widest of its column, though another may be so by the estimate.
CANDIDATES = 4


def typst_layout(page: Page, ready: Page) -> TypstLayout:
    """Return the layout for a page set as plain text, whose characters are what is measured.

    `ready` is the same page for Typst, where fractions may have their full size.
    """
    widths = column_widths(page)
    spare = tuple(spare_widths(page, widths))
    width = sum(widths) + 2 * MARGIN * len(widths) + GUTTER * (len(widths) - 1)
    rows = tuple(_rows(page))
    return TypstLayout(
        label=string(f"tab-{page.key}"),
        width=round(width, 1),
        height=round(_rows_height(ready) + _notes_height(page, max(width, NARROWEST_NOTE)), 1),
        widest=tuple(map(_widest_rows, page.panels, ready.panels)),
        columns=tuple("left" if one is None else "right" for one in spare),
        margins=tuple(f"{MARGIN + (one or 0) / 2:.2f}em" for one in spare),
        **{
            kind: tuple(place for place, found in enumerate(rows) if kind in found)
            for kind in ("opening", "closing", "parted")
        },
    )


def _widest_rows(panel: PagePanel, ready: PagePanel) -> tuple[tuple[PageCell, ...], ...]:
    """Return rows of the cells of each column that are widest in plain text, as Typst has them."""
    columns = []
    for plain, made in zip(zip(*panel.rows, strict=True), zip(*ready.rows, strict=True), strict=True):
        widths = [em(cell.text + cell.tail) for cell in plain]
        order = sorted(range(len(plain)), key=widths.__getitem__, reverse=True)
        columns.append([made[row]._replace(down=1) for row in order[:CANDIDATES]])
    return tuple(zip(*columns, strict=True))


def _rows_height(page: Page) -> float:
    heads = sum(len(panel.spanners) + len(panel.heading_lines) + 3 for panel in page.panels)
    groups = sum(len(panel.groups) for panel in page.panels)
    rows = [any("#box(height" in cell.text for cell in row) for panel in page.panels for row in panel.rows]
    return (heads + 2 * groups + rows.count(False)) * ROW + rows.count(True) * HIGH_ROW


def _notes_height(page: Page, width: float) -> float:
    texts = [*(note.text for note in page.notes), page.source]
    return sum(2 * NOTE + em(text) / width * NOTE for text in texts if text)


def _rows(page: Page) -> Iterator[set[str]]:
    """Yield what is special about each row of the table."""
    for number, panel in enumerate(page.panels):
        # Each panel but the first has a line above its head that says that it goes on.
        yield from [set()] * (len(panel.head) + (number > 0))
        rows: list[set[str]] = []
        for group in panel.groups:
            rows += [set()] * bool(group.label)
            rows += [{"parted"} if rows and not group.label else set(), *[set()] * (len(group.rows) - 1)]
        rows[0] = rows[0] | {"opening"}
        rows[-1] = rows[-1] | {"closing"}
        yield from rows
