"""A table in plain text, a grid: widths, centred spanners, rules, aligned decimal marks.

Widths count characters; labels have no combining or double-width ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate, islice, zip_longest
from textwrap import fill
from typing import NamedTuple

from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.writer import PageWriter
from kurbel.page.table import HeadCell, Table

GAP = 2
SPANNER_GAP = 3
WIDEST = 100
# A caption above a small table is not squeezed into its width.
NARROWEST = 60
HEAVY, LIGHT = "━", "─"


class Writer(PageWriter):
    def written(self, table: Table, mark: str, width: int | None) -> str:
        if width is not None:
            from kurbel.formats.text.narrow import narrowed

            table = narrowed(table, lambda parted: grid_of(page(parted, self, mark)).total <= width)
        return text_page(page(table, self, mark), width)


class Grid(NamedTuple):
    """Where the columns stand. All panels share one grid, so that they stand in line below each other."""

    lefts: tuple[int, ...]
    widths: tuple[int, ...]
    figures: tuple[int, ...]
    """The longest figure of each column, which stands in the middle of it."""

    @property
    def total(self) -> int:
        return self.lefts[-1] + self.widths[-1] + 1

    def extent(self, cell: HeadCell) -> int:
        return self.lefts[cell.last] + self.widths[cell.last] - self.lefts[cell.first]


def text_page(page: Page, width: int | None = None) -> str:
    """Return the whole page: caption, panels, notes and source; prose no wider than `width`."""
    grid = grid_of(page)
    room = min(max(NARROWEST, grid.total), width or WIDEST + grid.total)
    parts = [wrapped(page.caption, room) + "\n"] if page.caption else []
    parts.append("\n\n".join("\n".join(panel_lines(panel, grid)) for panel in page.panels))
    for note in page.notes:
        hang = len(note.mark) + 1 if note.mark else 0
        parts.append(wrapped(f"{note.mark} {note.text}" if note.mark else note.text, room, hang))
    if page.source:
        parts.append(wrapped(f"{page.words['source']}: {page.source}", room))
    return "\n".join(parts) + "\n"


def panel_lines(panel: PagePanel, grid: Grid) -> list[str]:
    """Return the lines of one panel, from the heavy rule above its head to the one below its body."""
    lines = [HEAVY * grid.total]
    for spanners in panel.spanners:
        lines += _spanner_lines(spanners, grid)
    lines += [_line(texts, panel, grid) for texts in panel.heading_lines]
    lines.append(LIGHT * grid.total)
    lines += _body(panel, grid)
    lines.append(HEAVY * grid.total)
    return [_plain_spaces(line).rstrip() for line in lines]


def wrapped(text: str, room: int, indent: int = 0) -> str:
    """Return prose in lines no longer than the room, the second and later ones indented."""
    hang = " " * (indent + 1)
    # The spaces of a formula are no-break spaces until its line is found.
    lines = fill(
        text,
        room,
        initial_indent=" ",
        subsequent_indent=hang,
        break_on_hyphens=False,
        break_long_words=False,
    )
    return _plain_spaces(lines)


def _plain_spaces(text: str) -> str:
    """Return the text with the only space that every terminal and every search knows."""
    return text.replace("\u00a0", " ")


def grid_of(page: Page) -> Grid:
    """Return the grid of a page, with narrower gaps if it then fits the width of a page."""
    grid = _grid_with(page, 0)
    narrower = _grid_with(page, 1) if grid.total > WIDEST else grid
    return narrower if narrower.total <= WIDEST else grid


def _grid_with(page: Page, narrower: int) -> Grid:
    """Return the grid with all gaps narrower by so many characters."""
    gaps = _longest(_gaps(panel, narrower) for panel in page.panels)
    widths = _longest(_widths(panel, gaps) for panel in page.panels)
    rights = accumulate(gap + width for gap, width in zip(gaps, widths, strict=True))
    lefts = tuple(right - width for right, width in zip(rights, widths, strict=True))
    return Grid(lefts, tuple(widths), tuple(_longest(_figures(panel) for panel in page.panels)))


def _figures(panel: PagePanel) -> list[int]:
    return [
        max(map(len, _block(panel, place)), default=0) if column.align == "right" else 0
        for place, column in enumerate(panel.columns)
    ]


def _longest(panels: Iterable[Sequence[int]]) -> list[int]:
    return [max(column) for column in zip_longest(*panels, fillvalue=0)]


def _block(panel: PagePanel, place: int) -> list[str]:
    """Return the cells of a column, all of one width, so that their decimal marks stand in line.

    Note marks hang to the right of the figures; a missing value stands in the middle.
    """
    cells = [row[place] for row in panel.rows]
    hang = max((len(cell.marks) for cell in cells), default=0)
    if panel.columns[place].align == "left":
        texts = [_seen(cell) + cell.marks for cell in cells]
        room = max(map(len, texts), default=0)
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


def _gaps(panel: PagePanel, narrower: int) -> list[int]:
    """Return the space before each column: one at the edge, more where the outermost spanner changes."""
    outermost = panel.spanners[0] if panel.spanners else ()
    edges = {edge for cell in outermost for edge in (cell.first, cell.last + 1)}
    gaps = [1] + [SPANNER_GAP if place in edges else GAP for place in range(1, len(panel.columns))]
    full = [_is_filled_by_heading(panel, place) for place in range(len(panel.columns))]
    # Only figures may stand closer; words need the room to be told apart.
    return [
        gap - narrower if place > panel.stubs and not (full[place - 1] and full[place]) else gap
        for place, gap in enumerate(gaps)
    ]


def _is_filled_by_heading(panel: PagePanel, place: int) -> bool:
    heading = max(map(len, panel.columns[place].heading), default=0)
    return heading >= max(map(len, _block(panel, place)), default=0)


def _widths(panel: PagePanel, gaps: Sequence[int]) -> list[int]:
    """Return the width of each column: its cells, its heading, and its share of the spanners above it."""
    widths = [
        max(len(text) for text in (*column.heading, *_block(panel, place), ""))
        for place, column in enumerate(panel.columns)
    ]
    for spanners in reversed(panel.spanners):
        for cell in spanners:
            members = range(cell.first, cell.last + 1)
            extent = sum(widths[place] for place in members) + sum(gaps[place] for place in members[1:])
            for step in range(max(len(cell.text) - extent, 0)):
                widths[members[step % cell.across]] += 1
    return widths


def _placed(pieces: Iterable[tuple[int, str]]) -> str:
    """Return a line with each text at its place, counted from the left edge."""
    line = ""
    for left, text in pieces:
        line = line.ljust(left) + text
    return line


def _spanner_lines(spanners: Sequence[HeadCell], grid: Grid) -> tuple[str, str]:
    texts, rules = [], []
    for cell in spanners:
        text, left = cell.text, grid.lefts[cell.first]
        texts.append((left, text.center(grid.extent(cell))))
        if text:
            rules.append((left, LIGHT * grid.extent(cell)))
    return _placed(texts), _placed(rules)


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


def _body(panel: PagePanel, grid: Grid) -> Iterator[str]:
    lines = zip(*(_block(panel, place) for place in range(len(panel.columns))), strict=True)
    for place, group in enumerate(panel.groups):
        if place:
            yield ""
        if group.label:
            yield group.label.center(grid.total)
            yield ""
        for texts in islice(lines, len(group.rows)):
            in_line = [text.rjust(room) for text, room in zip(texts, grid.figures, strict=False)]
            yield _line(in_line, panel, grid)
