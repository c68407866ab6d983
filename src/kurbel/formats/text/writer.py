"""A table in plain text, a grid: widths, centred spanners, rules, aligned decimal marks.

Widths count characters; labels have no combining or double-width ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import accumulate
from textwrap import fill
from typing import NamedTuple

from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.spacing import shared, spans, widest
from kurbel.formats.writer import PageWriter, WriteOptions
from kurbel.page.table import HeadCell, Table, Tone

# A table is no wider than the first, or else the second of these if closer columns are a help.
USUAL, WIDEST = 80, 100
# Notes below a small table are not squeezed into its width, nor its caption into that of a word or two.
NARROWEST, NARROWEST_CAPTION = 60, 30
# The share of the line that the caption of a wide table may have.
OF_LINE = 0.85
# So many times the width may a table have for symbols that stand beside the names above columns.
LITTLE = 1.1
# By how many characters gaps become narrower, and how wide they then are at the least; only figures may stand
# closer than words, which need the room to be told apart.
NEXT = 2
CLOSER = ((0, NEXT), (1, NEXT), (1, 1), (2, 1))
TIGHTEST = len(CLOSER) - 1
# Characters for an em, which is the height of a line.
PER_EM = 1.5


class Writer(PageWriter):
    linked = False

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {
            "balanced": balanced,
            "middle": middle,
            "toned": toned,
            "trimmed": trimmed,
            "wrapped": wrapped,
        }

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        width = wishes.width
        if width is not None and grid_of(ready, width).total > width:
            from kurbel.formats.text.reflow import narrowed

            ready = narrowed(table, ready, lambda parted: page(parted, self, mark), width)
        grids = grids_of(ready, width)
        aligned = ready._replace(panels=tuple(map(_aligned, ready.panels, grids)))
        return {"page": aligned, "text": _layout(grids, width), "colours": wishes.colours}


class Span(NamedTuple):
    """Where something stands in a line: the spaces before it, its width, and its texts in several lines."""

    before: int
    width: int
    lines: tuple[str, ...] = ()


def _spans(places: Iterable[tuple[int, int]]) -> Iterator[Span]:
    end = 0
    for left, width in places:
        yield Span(left - end, width)
        end = left + width


class Grid(NamedTuple):
    """Where the columns stand. All panels share one, so that they stand in line below each other."""

    lefts: tuple[int, ...]
    widths: tuple[int, ...]
    figures: tuple[int, ...]
    """The longest figure of each column, which stands in the middle of it."""
    closer: int
    is_flat: bool
    """Whether symbols above columns stand beside the names and not below them."""

    @property
    def total(self) -> int:
        return self.lefts[-1] + self.widths[-1] + 1

    @property
    def columns(self) -> tuple[Span, ...]:
        """The columns, from left to right."""
        return tuple(_spans(zip(self.lefts, self.widths, strict=True)))

    def spans(self, spanners: Sequence[HeadCell]) -> tuple[Span, ...]:
        """Return where the spanners of a level stand, a short one at the bottom of their lines."""
        texts = [(cell.text,) if self.is_flat else cell.lines for cell in spanners]
        deepest = max(map(len, texts), default=0)
        ends = ((self.lefts[cell.first], self.lefts[cell.last] + self.widths[cell.last]) for cell in spanners)
        places = _spans((left, right - left) for left, right in ends)
        return tuple(
            place._replace(lines=("",) * (deepest - len(own)) + own)
            for place, own in zip(places, texts, strict=True)
        )


class TextLayout(NamedTuple):
    """The grid of each panel, and the characters that a line of the caption and of the notes may have."""

    grids: Sequence[Grid]
    over: int
    below: int


def _layout(grids: Sequence[Grid], width: int | None) -> TextLayout:
    total = max(grid.total for grid in grids)
    below = min(max(NARROWEST, total), width or WIDEST + total)
    over = min(total, round(OF_LINE * min(width or WIDEST, WIDEST)))
    return TextLayout(grids, max(over, min(NARROWEST_CAPTION, below)), below)


def wrapped(text: str, room: int, indent: int = 0) -> str:
    """Return prose in lines no longer than the room, the second and later ones indented."""
    return _filled(_with_ends(text, room - indent), room, indent)


def balanced(text: str, room: int) -> str:
    """Return prose in as few lines as the room allows, none much longer than the others."""
    text = _with_ends(text, room)
    lines = _filled(text, room)
    for narrower in range(room - 1, 0, -1):
        closer = _filled(text, narrower)
        if closer.count("\n") > lines.count("\n"):
            break
        lines = closer
    return lines


def _with_ends(text: str, room: int) -> str:
    """Return prose in which a formula that is longer than a line may go on in the next."""
    # The spaces of a formula are no-break spaces until its line is found.
    return " ".join(_plain_spaces(word) if len(word) >= room else word for word in text.split(" "))


def _filled(text: str, room: int, indent: int = 0) -> str:
    hang = " " * (indent + 1)
    lines = fill(
        text, room, initial_indent=" ", subsequent_indent=hang, break_on_hyphens=False, break_long_words=False
    )
    return _plain_spaces(lines)


def _plain_spaces(text: str) -> str:
    """Return the text with the only space that every terminal and every search knows."""
    return text.replace("\u00a0", " ")


def grids_of(page: Page, width: int | None = None) -> list[Grid]:
    """Return the grid of each panel: one for all, unless the terminal has only room for each by itself."""
    shared = grid_of(page, width)
    if width is not None and shared.total > width:
        own = [grid_of(page._replace(panels=(panel,)), width) for panel in page.panels]
        if all(grid.total <= width for grid in own):
            return own
    return [shared] * len(page.panels)


def grid_of(page: Page, width: int | None = None) -> Grid:
    """Return the grid of a page, no wider than `width`, or than a page, if narrower gaps are enough for it.

    Symbols stand beside the names above columns where the page becomes little wider by it.
    """
    measures = [measured(panel) for panel in page.panels]
    grids = [grid for closer in range(TIGHTEST + 1) for grid in _grids_with(page, measures, closer)]
    rooms = ((USUAL, [grid for grid in grids if grid.closer < 2]), (WIDEST, grids))
    # What has no room on a terminal is as elsewhere.
    for most in (width or WIDEST, WIDEST):
        for room, candidates in rooms:
            for grid in candidates:
                if grid.total <= min(most, room):
                    return grid
    return next(grid for grid in grids if grid.closer)


def _grids_with(page: Page, measures: Sequence[Sequence[ColumnWidths]], closer: int) -> Iterator[Grid]:
    """Yield the grids with such gaps, that with symbols beside the names first."""
    stacked = grid_with(page, measures, closer)
    flat = grid_with(page, measures, closer, is_flat=True)
    if flat.total <= LITTLE * stacked.total:
        yield flat
    yield stacked


def grid_with(
    page: Page, measures: Sequence[Sequence[ColumnWidths]], closer: int, is_flat: bool = False
) -> Grid:
    """Return the grid with gaps in one of the steps by which they become closer."""
    gaps = widest(map(partial(_gaps, closer), page.panels, measures))
    widths = widest(
        _widths(panel, own, gaps, is_flat) for panel, own in zip(page.panels, measures, strict=True)
    )
    rights = accumulate(gap + width for gap, width in zip(gaps, widths, strict=True))
    lefts = tuple(right - width for right, width in zip(rights, widths, strict=True))
    figures = widest(
        [one.body if column.align == "right" else 0 for one, column in zip(own, panel.columns, strict=True)]
        for panel, own in zip(page.panels, measures, strict=True)
    )
    return Grid(lefts, tuple(widths), tuple(figures), closer, is_flat)


class ColumnWidths(NamedTuple):
    """The widths of a column: of its heading and of its cells."""

    heading: int
    body: int


def measured(panel: PagePanel) -> list[ColumnWidths]:
    """Return the widths of each column by itself."""
    return [
        ColumnWidths(max(map(len, column.heading), default=0), min(map(len, _block(panel, place)), default=0))
        for place, column in enumerate(panel.columns)
    ]


def _gaps(closer: int, panel: PagePanel, measures: Sequence[ColumnWidths]) -> list[int]:
    """Return the space before each column, one character at the edge."""
    full = [one.heading >= one.body for one in measures]
    less, least = CLOSER[closer]
    gaps = [1]
    for place, column in enumerate(panel.columns[1:], 1):
        words = "left" in (column.align, panel.columns[place - 1].align) or (full[place - 1] and full[place])
        close = least if not words and place > panel.stubs else NEXT
        gaps.append(max(round(column.gap * PER_EM) - less, close))
    return gaps


def _widths(
    panel: PagePanel, measures: Sequence[ColumnWidths], gaps: Sequence[int], is_flat: bool
) -> list[int]:
    """Return the width of each column: its cells, its heading, and its share of the spanners above it."""
    above = spans(panel, lambda cell: len(cell.text) if is_flat else max(map(len, cell.lines)))
    return shared([max(one) for one in measures], above, gaps)


def _block(panel: PagePanel, place: int) -> list[str]:
    """Return the cells of a column, all of one width, so that their decimal marks stand in line.

    Note marks hang to the right of the figures; a missing value stands in the middle.
    """
    cells = [row[place] for row in panel.rows]
    hang = max((len(cell.marks) for cell in cells), default=0)
    if panel.columns[place].align == "left":
        texts = [_seen(cell) + cell.marks for cell in cells]
        own = (text for text, cell in zip(texts, cells, strict=True) if cell.kind != "across")
        room = max(map(len, own), default=0)
        return [text.ljust(room) for text in texts]
    figures = [_seen(cell) + " " * len(cell.tail) for cell in cells]
    room = max((len(text) for text in figures), default=0)
    return [_hung(text, cell, room, hang) for text, cell in zip(figures, cells, strict=True)]


def _hung(text: str, cell: PageCell, room: int, hang: int) -> str:
    if cell.kind == "missing":
        return (text.center(room).rstrip() + cell.marks).ljust(room + hang)
    return text.rjust(room) + cell.marks.ljust(hang)


def _seen(cell: PageCell) -> str:
    return cell.text if cell.down else ""


def middle(text: str, width: int) -> str:
    """Return a text in the middle of a width, an odd space on the left."""
    # str.center gives it to either side by the parity of the width, and heading and figures would lean apart.
    return (" " * ((width - len(text) + 1) // 2) + text).ljust(width)


def trimmed(lines: str) -> str:
    """Return lines without spaces at their ends, and with no other spaces than those of every terminal."""
    return "\n".join(line.rstrip() for line in _plain_spaces(lines).split("\n"))


# Green, yellow, cyan and bold red: the colours that a terminal's theme makes legible on its ground.
CODES: Mapping[Tone, str] = {"right": "32", "near": "33", "other": "36", "wrong": "1;31"}


def toned(text: str, tone: Tone) -> str:
    """Return a text in the colour that a terminal has for what a cell is to be taken as."""
    shown = text.strip()
    return text.replace(shown, f"\x1b[{CODES[tone]}m{shown}\x1b[0m") if tone and shown else text


def _aligned(panel: PagePanel, grid: Grid) -> PagePanel:
    """Return the panel with cells that have all that they show, as wide as the figures of their column."""
    blocks = [
        [text.rjust(room) for text in _block(panel, place)]
        for place, room in zip(range(len(panel.columns)), grid.figures, strict=False)
    ]
    lines = zip(panel.rows, zip(*blocks, strict=True), strict=True)
    return panel.with_rows(
        tuple(cell._replace(text=text, marks="", tail="") for cell, text in zip(cells, texts, strict=True))
        for cells, texts in lines
    )
