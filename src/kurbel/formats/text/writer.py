"""A table in plain text, a grid: widths, centred spanners, rules, aligned decimal marks.

Widths count characters; labels have no combining or double-width ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import accumulate, islice, zip_longest
from textwrap import fill
from typing import NamedTuple, TypeAlias

from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.writer import PageWriter
from kurbel.page.table import HeadCell, Table

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
HEAVY, LIGHT = "━", "─"


class Writer(PageWriter):
    linked = False

    def written(self, table: Table, mark: str, width: int | None) -> str:
        return text_page(self._fitted(table, mark, width), width)

    def coloured(self, table: Table, mark: str, width: int | None) -> str:
        from kurbel.formats.text.colour import painted

        return text_page(self._fitted(table, mark, width), width, painted)

    def _fitted(self, table: Table, mark: str, width: int | None) -> Page:
        ready = page(table, self, mark)
        if width is not None and grid_of(ready, width).total > width:
            from kurbel.formats.text.narrow import narrowed

            ready = narrowed(table, ready, lambda parted: page(parted, self, mark), width)
        return ready


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

    def lines(self, cell: HeadCell) -> tuple[str, ...]:
        """Return the lines of a spanner."""
        return (cell.text,) if self.is_flat else cell.lines

    def extent(self, cell: HeadCell) -> int:
        return self.lefts[cell.last] + self.widths[cell.last] - self.lefts[cell.first]


# Gives the line of a row its colours.
Paint: TypeAlias = Callable[[str, Sequence[PageCell], Grid], str]


def text_page(page: Page, width: int | None = None, paint: Paint | None = None) -> str:
    """Return the whole page: caption, panels, notes and source; prose no wider than `width`."""
    grids = grids_of(page, width)
    total = max(grid.total for grid in grids)
    room = min(max(NARROWEST, total), width or WIDEST + total)
    over = min(total, round(OF_LINE * min(width or WIDEST, WIDEST)))
    over = max(over, min(NARROWEST_CAPTION, room))
    parts = [balanced(page.caption, over) + "\n"] if page.caption else []
    panels = (panel_lines(panel, grid, paint) for panel, grid in zip(page.panels, grids, strict=True))
    parts.append("\n\n".join("\n".join(lines) for lines in panels))
    for note in page.notes:
        hang = len(note.mark) + 1 if note.mark else 0
        parts.append(wrapped(f"{note.mark} {note.text}" if note.mark else note.text, room, hang))
    if page.source:
        parts.append(wrapped(f"{page.words['source']}: {page.source}", room))
    return "\n".join(parts) + "\n"


def panel_lines(panel: PagePanel, grid: Grid, paint: Paint | None) -> list[str]:
    """Return the lines of one panel, from the heavy rule above its head to the one below its body."""
    lines = [HEAVY * grid.total]
    for spanners in panel.spanners:
        lines += _over_columns(spanners, grid)
    lines += [_line(texts, panel, grid) for texts in panel.heading_lines]
    lines.append(LIGHT * grid.total)
    lines += _body(panel, grid, paint)
    lines.append(HEAVY * grid.total)
    return [_plain_spaces(line).rstrip() for line in lines]


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


def _grids_with(page: Page, measures: Sequence[Sequence[Measure]], closer: int) -> Iterator[Grid]:
    """Yield the grids with such gaps, that with symbols beside the names first."""
    stacked = grid_with(page, measures, closer)
    flat = grid_with(page, measures, closer, is_flat=True)
    if flat.total <= LITTLE * stacked.total:
        yield flat
    yield stacked


def grid_with(page: Page, measures: Sequence[Sequence[Measure]], closer: int, is_flat: bool = False) -> Grid:
    """Return the grid with gaps in one of the steps by which they become closer."""
    gaps = longest(map(partial(_gaps, closer), page.panels, measures))
    widths = longest(
        _widths(panel, own, gaps, is_flat) for panel, own in zip(page.panels, measures, strict=True)
    )
    rights = accumulate(gap + width for gap, width in zip(gaps, widths, strict=True))
    lefts = tuple(right - width for right, width in zip(rights, widths, strict=True))
    figures = longest(
        [one.body if column.align == "right" else 0 for one, column in zip(own, panel.columns, strict=True)]
        for panel, own in zip(page.panels, measures, strict=True)
    )
    return Grid(lefts, tuple(widths), tuple(figures), closer, is_flat)


class Measure(NamedTuple):
    """The widths of a column: of its heading and of its cells."""

    heading: int
    body: int


def measured(panel: PagePanel) -> list[Measure]:
    """Return the widths of each column by itself."""
    return [
        Measure(max(map(len, column.heading), default=0), min(map(len, _block(panel, place)), default=0))
        for place, column in enumerate(panel.columns)
    ]


def longest(panels: Iterable[Sequence[int]]) -> list[int]:
    """Return for each column the largest of what the panels have."""
    return [max(column) for column in zip_longest(*panels, fillvalue=0)]


def _gaps(closer: int, panel: PagePanel, measures: Sequence[Measure]) -> list[int]:
    """Return the space before each column, one character at the edge."""
    full = [one.heading >= one.body for one in measures]
    less, least = CLOSER[closer]
    gaps = [1]
    for place, column in enumerate(panel.columns[1:], 1):
        words = "left" in (column.align, panel.columns[place - 1].align) or (full[place - 1] and full[place])
        close = least if not words and place > panel.stubs else NEXT
        gaps.append(max(round(column.gap * PER_EM) - less, close))
    return gaps


def _widths(panel: PagePanel, measures: Sequence[Measure], gaps: Sequence[int], is_flat: bool) -> list[int]:
    """Return the width of each column: its cells, its heading, and its share of the spanners above it."""
    widths = [max(one) for one in measures]
    for spanners in reversed(panel.spanners):
        for cell in spanners:
            members = range(cell.first, cell.last + 1)
            extent = sum(widths[place] for place in members) + sum(gaps[place] for place in members[1:])
            own = len(cell.text) if is_flat else max(map(len, cell.lines))
            for step in range(max(own - extent, 0)):
                widths[members[step % cell.across]] += 1
    return widths


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


def _placed(pieces: Iterable[tuple[int, str]]) -> str:
    """Return a line with each text at its place, counted from the left edge."""
    line = ""
    for left, text in pieces:
        line = line.ljust(left) + text
    return line


def _over_columns(spanners: Sequence[HeadCell], grid: Grid) -> Iterator[str]:
    """Yield the lines of spanners, a short one at the bottom, and the rules below them."""
    texts = [grid.lines(cell) for cell in spanners]
    deepest = max(map(len, texts), default=0)
    for line in zip(*(("",) * (deepest - len(own)) + own for own in texts), strict=True):
        named = zip(spanners, line, strict=True)
        yield _placed((grid.lefts[cell.first], text.center(grid.extent(cell))) for cell, text in named)
    yield _placed((grid.lefts[cell.first], LIGHT * grid.extent(cell)) for cell in spanners if cell.text)


def _line(texts: Sequence[str], panel: PagePanel, grid: Grid) -> str:
    """Return a line of the head or the body: figures and their headings centred, words at the left."""
    return _placed(
        (left, _centred(text, width) if column.align == "right" else text)
        # A panel may have fewer columns than the grid.
        for text, column, left, width in zip(texts, panel.columns, grid.lefts, grid.widths, strict=False)
    )


def _centred(text: str, width: int) -> str:
    # str.center gives the odd space to either side by the parity of the width;
    # here it is always on the left, so that heading and figures lean the same way.
    return " " * ((width - len(text) + 1) // 2) + text


def _body(panel: PagePanel, grid: Grid, paint: Paint | None) -> Iterator[str]:
    lines = zip(*(_block(panel, place) for place in range(len(panel.columns))), strict=True)
    for place, group in enumerate(panel.groups):
        if place:
            yield ""
        if group.label:
            yield f" {group.label}"
        for row, texts in enumerate(islice(lines, len(group.rows))):
            if row in group.pauses:
                yield ""
            in_line = [text.rjust(room) for text, room in zip(texts, grid.figures, strict=False)]
            line = _line(in_line, panel, grid)
            yield paint(line, group.rows[row], grid) if paint else line
