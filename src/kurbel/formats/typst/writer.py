"""Labels in Typst, and the space that a table takes, which its templates read.

Typst sets figures flush under the right edge of a wide heading and gives the width that a spanner needs
beyond its columns to the last of them. Widths are estimated, so that the figures stand in the middle of both.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import partial
from itertools import chain, zip_longest
from typing import NamedTuple

from kurbel.documents.document import WORDS
from kurbel.exact.numerals import Label
from kurbel.formats.formula import has_bar, has_stroke, is_seen
from kurbel.formats.page import Page, PageCell, PagePanel
from kurbel.formats.page import page as plain_page
from kurbel.formats.spacing import Span, StretchableWidth, added, bodies, headings, overhangs, spans, widest
from kurbel.formats.spacing import em as computer_modern
from kurbel.formats.writer import PERCENT_DELIMITERS, PLAIN, PageWriter, WriteOptions
from kurbel.page import formula as tree
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, parse
from kurbel.page.table import HeadCell, Table

_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


def string(text: str) -> str:
    """Return a text as a string of Typst's code, quotation marks included."""
    return f'"{text.translate(_STRING)}"'


# Of Libertinus; all else is a little narrower than in Computer Modern.
_EM = {**dict.fromkeys("0123456789", 0.465), **dict.fromkeys(",.", 0.24), "−": 0.56}


def em(text: str) -> float:
    """Return the width of a text in units of the type size; a little too much."""
    return added(_EM.get(one) or 0.95 * computer_modern(one) for one in text)


NOTHING = PageCell("", "", "label")
# What makes room for a fraction of full size.
_HIGH = "#box(height"


class TypstLayout(NamedTuple):
    """The space that a table takes.

    `width` is at least its width in em, `narrow` at least that with the narrowest gaps, which are the share
    `least` of the usual ones; the
    heights of its rows and of its `notes` lie between two numbers each. `gaps` stand between columns;
    `sides` are the spaces left and right of the headings of a column, which a wide spanner needs, and
    `margins` those of its cells. `widest` has, for each panel, rows of the widest cells of its columns, which
    Typst measures: to have it measure the whole table takes longer than to set it, and ten times the memory.
    `above` and `below` have the em above and below the cells of rows that are
    not as the others, counted from 0 over the heads and bodies of all panels. `stacked` are the spanners,
    by panel, level and first column, whose symbol stands below their name; `long` the notes, from 0, with a
    formula that may be wider than they are, as one of a `long_caption` may be. `paper` is that of a page of
    its own.
    """

    label: str
    table: str
    paper: str
    width: float
    narrow: float
    least: float
    rows: tuple[float, ...]
    notes: tuple[float, ...]
    widest: tuple[tuple[tuple[PageCell, ...], ...], ...]
    columns: tuple[str, ...]
    gaps: tuple[str, ...]
    sides: tuple[str, ...]
    margins: tuple[str, ...]
    above: Mapping[int, float]
    below: Mapping[int, float]
    stacked: frozenset[tuple[int, int, int]]
    long: tuple[int, ...]
    long_caption: bool


# A table no wider fits most lines with gaps a little smaller than usual: 140 mm take 42 em of 9.5 points.
ROOMY = 45.0
# The width of the text on a page of its own, and on one turned on its side, in millimetres.
MEASURE, TURNED = 150, 237
# Points that every reader can read, and those of a millimetre.
LEAST_TYPE, MM = 7, 72 / 25.4
# The share of the gaps that remains before type becomes smaller.
LEAST = 0.5
# Above and below the cells of a row, in em; beside a rule, before a group without a label, and in a pause.
USUAL, BESIDE_RULE, PARTED, PAUSE = 0.27, 0.5, 0.8, 0.67
# The least and the greatest height of a row of figures, of one with a fraction of full size, of a line of
# notes and of one with such a fraction.
ROW, HIGH_ROW, NOTE, HIGH_NOTE = (1.18, 1.22), (2.4, 3.1), (0.9, 1.1), (1.8, 2.9)
NARROWEST_NOTE, SHORT_FORMULA = 24.0, 20.0
# The widest of these cells in print is the widest of its column, though another may be so by the estimate.
CANDIDATES = 3


def typst_layout(table: Table, mark: str, ready: Page) -> TypstLayout:
    """Return the layout for a table with that decimal mark; `ready` is its page for Typst."""
    # Its characters are what is measured.
    page = plain_page(table, PLAIN, mark)
    cells, heads = (widest(of(panel, em) for panel in page.panels) for of in (bodies, headings))
    columns, gaps = (
        widest((cells, heads)),
        widest([one.gap for one in panel.columns] for panel in page.panels),
    )
    stacked = frozenset(_stacked(page, columns, gaps))
    left, right = ([room.at() for room in side] for side in _overhangs(page, columns, gaps, stacked))
    width = added(map(added, zip(left, columns, right, strict=True))) + added(gaps)
    narrow = width - (1 - LEAST) * added(gaps)
    figures = [
        all(panel.columns[place].align == "right" for panel in page.panels if place < len(panel.columns))
        for place in range(len(columns))
    ]
    spare = [(column - own) / 2 * right for column, own, right in zip(columns, cells, figures, strict=True)]
    above, below = _spaces(page)
    if any(group.held for panel in page.panels for group in panel.groups):
        # Cells of a column without width hold the rows of a line together.
        for side in (left, right, spare, gaps):
            side.append(0.0)
        figures.append(False)
    return TypstLayout(
        label=string(f"tab-{page.anchor}"),
        table=WORDS.get(page.lang, WORDS["en"])["table"],
        paper=paper(narrow, MEASURE) or 'paper: "a4"',
        width=round(width, 1),
        narrow=round(narrow, 1),
        least=LEAST,
        rows=tuple(round(height, 1) for height in _rows_heights(page, ready)),
        notes=tuple(round(height, 1) for height in _notes_heights(page, ready, width)),
        widest=tuple(map(_widest_rows, page.panels, ready.panels)),
        columns=tuple("right" if one else "left" for one in figures),
        gaps=tuple(f"{gap:g}em" for gap in gaps[1:]),
        sides=tuple(map(_sides, left, right)),
        margins=tuple(_sides(a + one, b + one) for a, b, one in zip(left, right, spare, strict=True)),
        above=above,
        below=below,
        stacked=stacked,
        long=tuple(
            place for place, note in enumerate(table.notes) if _longest_formula(note.text) > SHORT_FORMULA
        ),
        long_caption=_longest_formula(table.caption) > SHORT_FORMULA,
    )


def paper(narrow: float, measure: float) -> str:
    """Return the paper of a page for a table that type of 7 points does not make narrower than the measure.

    `narrow` is in em, the measure in millimetres; margins take 60 mm of the width of the paper. It is empty
    for a table that needs none.
    """
    width = narrow * LEAST_TYPE / MM
    if width <= measure:
        return ""
    return (
        'paper: "a4", flipped: true' if width <= 237 else f"width: {math.ceil(width) + 60}mm, height: 210mm"
    )


def _sides(left: float, right: float) -> str:
    return f"(left: {left:.2f}em, right: {right:.2f}em)"


def _overhangs(
    page: Page, columns: Sequence[float], gaps: Sequence[float], stacked: Set[tuple[int, int, int]]
) -> tuple[list[StretchableWidth], list[StretchableWidth]]:
    """Return what spanners of any panel are wider than their columns, which stay together."""

    def width(number: int, cell: HeadCell) -> float:
        return max(map(em, cell.lines)) if (number, cell.level, cell.first) in stacked else em(cell.text)

    above = (spans(panel, partial(width, number)) for number, panel in enumerate(page.panels))
    return overhangs(columns, chain.from_iterable(above), gaps)


def _stacked(page: Page, columns: Sequence[float], gaps: Sequence[float]) -> Iterator[tuple[int, int, int]]:
    """Yield the spanners whose symbols stand below their names: all of a row for which there is no room."""
    for number, panel in enumerate(page.panels):
        for row in panel.spanners:
            wanted = [Span(cell.first, cell.across, em(cell.text)) for cell in row]
            beyond = 2 * added(room.at() for room in overhangs(columns, wanted, gaps)[0])
            if beyond and added(columns) + added(gaps) + beyond > ROOMY:
                yield from ((number, cell.level, cell.first) for cell in row if len(cell.lines) > 1)


def _widest_rows(panel: PagePanel, ready: PagePanel) -> tuple[tuple[PageCell, ...], ...]:
    """Return rows of the cells of each column that are widest in plain text, as Typst has them."""
    columns = [
        _widest_cells(plain, made)
        for plain, made in zip(zip(*panel.rows, strict=True), zip(*ready.rows, strict=True), strict=True)
    ]
    return tuple(zip_longest(*columns, fillvalue=NOTHING))


def _widest_cells(plain: Sequence[PageCell], made: Sequence[PageCell]) -> list[PageCell]:
    """Return the cells of a column that may be the widest: of figures one, for all digits are as wide."""
    widths = [em(cell.text + cell.tail) for cell in plain]
    order = sorted(range(len(plain)), key=widths.__getitem__, reverse=True)
    figures = all(cell.kind == "number" for cell in plain)
    return [made[row]._replace(down=1) for row in order[: 1 if figures else CANDIDATES]]


def _rows_heights(page: Page, ready: Page) -> Iterator[float]:
    """Yield the least height of the heads and rows, and the greatest."""
    heads = sum(len(panel.spanners) + len(panel.heading_lines) for panel in page.panels)
    groups = [group for panel in page.panels for group in panel.groups]
    labels = sum(bool(group.label) for group in groups)
    fractions = [any(_HIGH in cell.text for cell in row) for panel in ready.panels for row in panel.rows]
    for side in (0, 1):
        heads_height = heads * (1.2, 1.5)[side] + len(page.panels) * (0.0, 3.0)[side]
        groups_height = labels * (1.8, 2.0)[side] + (len(groups) - labels) * (0.0, PARTED)[side]
        pauses_height = sum(len(group.pauses) for group in groups) * (PAUSE - USUAL)
        rows_height = fractions.count(False) * ROW[side] + fractions.count(True) * HIGH_ROW[side]
        yield heads_height + groups_height + pauses_height + rows_height


def _notes_heights(page: Page, ready: Page, width: float) -> Iterator[float]:
    """Yield the least height of the notes, and the greatest."""
    room = max(min(width, ROOMY), NARROWEST_NOTE)
    notes = [
        (em(plain.text), _HIGH in made.text) for plain, made in zip(page.notes, ready.notes, strict=True)
    ]
    notes += [(em(page.source), False)] if page.source else []
    for side in (0, 1):
        yield sum(
            (math.ceil(long * 0.85 / room) if side else 1) * (HIGH_NOTE if high else NOTE)[side] + 0.5 * side
            for long, high in notes
        )


def _longest_formula(text: Label) -> float:
    """Return the width of the widest formula of a note, in em of the table."""
    formulas = (part for part in parse(text) if isinstance(part, Formula))
    return max((em(formula_plain(one)) * 0.85 for one in formulas), default=0.0)


def _spaces(page: Page) -> tuple[dict[int, float], dict[int, float]]:
    """Return the space above, and below, the rows of the table that are not as the others."""
    above, below = {}, {}
    at = 0
    for number, panel in enumerate(page.panels):
        # Each panel but the first has a line above its head, which may say that it goes on.
        at += len(panel.head) + (number > 0)
        opening = at
        for group in panel.groups:
            at += bool(group.label)
            if at > opening and not group.label:
                above[at] = PARTED
            above |= {at + place: PAUSE for place in group.pauses}
            if at == opening:
                above[at] = BESIDE_RULE
            at += len(group.rows)
        below[at - 1] = BESIDE_RULE
    return above, below


class Writer(PageWriter):
    # Typst has hash signs, braces and dollar signs, but no percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark without a link: a document that prints a table twice would not compile with it."""
        return f"#super[{escape(mark)})];"

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        """Return a formula with a text for readers that do not see it, which PDF/UA asks for.

        `display` gives fractions their full size, and the line the height for it.
        """
        content = _typst(formula.content, mark)
        alternative = string(formula_plain(formula, mark))
        if display and has_bar(formula.content):
            # The empty box is as high above the middle of the digits beside it as it is deep below.
            content = f"display({content})#box(height: 2.9em, baseline: 1.12em)"
        return f"#math.equation(alt: {alternative}, ${content}$);"

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        return {"typst": typst_layout(table, mark, ready)}


# Characters that Typst obeys anywhere.
_ANYWHERE = re.compile(r"[\\#$*_@<`~\[\]\"']")
# A hyphen stays before a letter only: with another one, ?, a digit or a space it makes a dash, a break, a
# minus sign or a list. Points make an ellipsis, strokes a comment or, after a colon, a link.
_PAIRS = re.compile(r"-(?=(.?))|\.(?=\.)|(?<=\.)\.|/(?=[/*])|(?<=/)/", re.DOTALL)
_APOSTROPHE = re.compile(r"(?<=[^\W\d_])'(?=[^\W\d_])")
# At the start of a line these make a heading, a list or a term.
_START = re.compile(r"^( *)([=+/])|^( *[0-9]+)(\.)")


def _paired(sign: re.Match[str]) -> str:
    # A fraction or a Roman numeral of one character is a number too.
    beside = sign.group(1)
    return sign.group() if beside and unicodedata.category(beside).startswith("L") else f"\\{sign.group()}"


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed.

    An apostrophe between letters is that of print, as a TeX sets it.
    """
    escaped = _PAIRS.sub(_paired, _ANYWHERE.sub(r"\\\g<0>", _APOSTROPHE.sub("’", prose)))
    return _START.sub(r"\1\3\\\2\4", escaped)


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
        case tree.Overline(content):
            return f"overline({_typst(content, mark)})"
        case tree.Fraction(top, bottom) if has_stroke(nodes, place):
            below = _typst(bottom if len(bottom) == 1 else (tree.Group(bottom),), mark)
            return f"{_typst(top, mark)}\\/{below}"
        case tree.Fraction(top, bottom):
            return f"frac({_typst(top, mark)}, {_typst(bottom, mark)})"
        case tree.Script(base, index, power):
            below = f"_({_typst(index, mark)})" if index else ""
            above = f"^({_typst(power, mark)})" if power else ""
            return _typst((base,), mark) + below + above
