"""A page for a narrow terminal: its words take less room, in further lines of their cells or in notes, or a
panel goes on below."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, zip_longest
from string import ascii_lowercase
from typing import NamedTuple

from kurbel.formats.page import Page, PageCell, PageGroup, PageNote, PagePanel
from kurbel.formats.spacing import partings, widest
from kurbel.formats.text.writer import TIGHTEST, ColumnWidths, grid_with, grids_of, measured
from kurbel.page.labels import fitted, lines_of, longest_word, mark_text
from kurbel.page.table import Table

# A column of words is not squeezed below that.
NARROWEST = 14
# How far the further lines of a row's name are indented.
INDENT = " "
NOTHING = PageCell("", "", "label")
_SIGN = "[=·±∓+−]\u00a0"
# A formula goes on in a further line before a sign, at best before one that is in no innermost brackets.
BEFORE_SIGN = re.compile(f"\u00a0(?={_SIGN})")
BETWEEN_BRACKETS = re.compile(BEFORE_SIGN.pattern + r"(?![^()]*\))")
# A formula has a sign, and no space elsewhere.
FORMULA = re.compile(f"(?!.* (?!{_SIGN})).*{_SIGN}")


def reflowed(page: Page, width: int) -> Iterator[Page]:
    """Yield the page, then with words in further lines, with formulas in further lines, with long words in
    notes, with the names of rows above these, with panels apart."""
    yield page
    pages = (page, _loosened(page, BETWEEN_BRACKETS), _loosened(page, BEFORE_SIGN))
    for one in (*pages, *(_noted(one, width) for one in pages)):
        if narrow := one and _in_lines(one, width):
            yield narrow
    if all(_has_names(panel, width) for panel in page.panels):
        above = page._replace(panels=tuple(_names_above(panel, width) for panel in page.panels))
        yield above
        for one in (above, _noted(above, width)):
            if narrow := one and _in_lines(one, width):
                yield narrow
    if len(page.panels) > 1:
        alone = [_in_lines(page._replace(panels=(panel,)), width) for panel in page.panels]
        if all(alone):
            yield page._replace(panels=tuple(one.panels[0] for one in alone if one))


def _has_names(panel: PagePanel, width: int) -> bool:
    """Tell whether rows have names of words, each of which has room in a line."""
    words = _words(row[0].text + row[0].marks for row in panel.rows)
    return panel.stubs == 1 and panel.columns[0].align == "left" and words + len(INDENT) < width


def _names_above(panel: PagePanel, width: int) -> PagePanel:
    """Return a panel in which the name of a row stands on a line of its own, and its cells below."""
    groups = []
    for group in panel.groups:
        rows: list[tuple[PageCell, ...]] = []
        pauses = set()
        for place, (name, *cells) in enumerate(group.rows):
            if place in group.pauses:
                pauses.add(len(rows))
            if name.down:
                for line in lines_of(name.text + name.marks, width - 1, INDENT):
                    rows.append((name._replace(text=line, marks="", kind="across"), *[NOTHING] * len(cells)))
            if any(cell.text or cell.marks for cell in cells):
                rows.append((NOTHING, *cells))
        groups.append(group._replace(rows=tuple(rows), pauses=frozenset(pauses)))
    return panel._replace(groups=tuple(groups))


class _Rooms(NamedTuple):
    """What is known of the widths of columns: those of the page, the least of heads and of bodies, and how
    much room there is for all."""

    own: Sequence[int]
    heads: Sequence[int]
    bodies: Sequence[int]
    room: int

    def fitted(self, bodies: Sequence[int]) -> list[int] | None:
        """Return the widths with which the page has room, the least of bodies being these; None if none."""
        least = map(min, map(max, self.heads, bodies), self.own)
        return fitted(self.own, [*least], self.room)


def _rooms(page: Page, width: int) -> _Rooms:
    measures = [measured(panel) for panel in page.panels]
    grid = grid_with(page, measures, TIGHTEST)
    return _Rooms(
        grid.widths,
        widest([_words(column.heading) for column in panel.columns] for panel in page.panels),
        widest(map(_least, page.panels, measures)),
        width - (grid.total - sum(grid.widths)),
    )


def _least(panel: PagePanel, measures: Sequence[ColumnWidths]) -> list[int]:
    """Return the least room of the cells of each column: that of figures, or of the longest word."""
    rooms = []
    for place, (column, own) in enumerate(zip(panel.columns, measures, strict=True)):
        if column.align == "left" and own.body > NARROWEST:
            indent = len(INDENT) if place < panel.stubs else 0
            words = _words(row[place].text + row[place].marks for row in panel.rows)
            rooms.append(max(words + indent, NARROWEST))
        else:
            rooms.append(own.body)
    return rooms


def _words(texts: Iterable[str]) -> int:
    return max(map(longest_word, texts), default=0)


def _in_lines(page: Page, width: int) -> Page | None:
    """Return the page with words, and the heads of columns, in as many lines as they need."""
    rooms = _rooms(page, width)
    fitting = rooms.fitted(rooms.bodies)
    if fitting is None:
        return None
    return page._replace(panels=tuple(_panel_in_lines(panel, fitting) for panel in page.panels))


def _panel_in_lines(panel: PagePanel, rooms: Sequence[int]) -> PagePanel:
    columns = tuple(
        column._replace(heading=tuple(chain.from_iterable(lines_of(line, room) for line in column.heading)))
        for column, room in zip(panel.columns, rooms, strict=False)
    )
    groups = tuple(_group_in_lines(group, panel, rooms) for group in panel.groups)
    return panel._replace(columns=columns, groups=groups)


def _group_in_lines(group: PageGroup, panel: PagePanel, rooms: Sequence[int]) -> PageGroup:
    rows: list[tuple[PageCell, ...]] = []
    pauses = set()
    for place, row in enumerate(group.rows):
        if place in group.pauses:
            pauses.add(len(rows))
        cells = [
            _cell_in_lines(cell, room, INDENT if number < panel.stubs else "")
            if column.align == "left"
            else [cell]
            for number, (cell, column, room) in enumerate(zip(row, panel.columns, rooms, strict=False))
        ]
        rows += zip_longest(*cells, fillvalue=NOTHING)
    return group._replace(rows=tuple(rows), pauses=frozenset(pauses))


def _cell_in_lines(cell: PageCell, room: int, indent: str) -> list[PageCell]:
    text = cell.text + cell.marks
    if cell.kind != "label" or not cell.down or len(text) <= room:
        return [cell]
    return [cell._replace(text=line, marks="") for line in lines_of(text, room, indent)]


def _loosened(page: Page, places: re.Pattern[str]) -> Page:
    """Return the page with formulas beside the stub that can go on in further lines at some places."""

    def loosened(cell: PageCell) -> PageCell:
        return cell._replace(text=places.sub(" ", cell.text)) if cell.kind == "label" else cell

    def row_of(row: Sequence[PageCell], stubs: int) -> tuple[PageCell, ...]:
        return (*row[:stubs], *map(loosened, row[stubs:]))

    panels = (panel.with_rows(row_of(row, panel.stubs) for row in panel.rows) for panel in page.panels)
    return page._replace(panels=tuple(panels))


def _noted(page: Page, width: int) -> Page | None:
    """Return the page with long texts in notes; None without them, or where letters are too few for them."""
    rooms = _rooms(page, width)
    shortest = {place: min(map(len, texts)) for place, texts in _prose(page).items()}
    fitting = rooms.fitted([shortest.get(place, body) for place, body in enumerate(rooms.bodies)])
    if fitting is None:
        return None
    long = {
        place: [text for text in texts if len(text) > fitting[place]] for place, texts in _prose(page).items()
    }
    used = {note.mark for note in page.notes}
    free = [mark for mark in map(mark_text, ascii_lowercase) if mark not in used]
    found = dict.fromkeys(chain.from_iterable(long.values()))
    if not found or len(found) > len(free):
        return None
    marks = dict(zip(found, free, strict=False))
    notes = tuple(PageNote(text, mark, "") for text, mark in marks.items())
    panels = tuple(_panel_noted(panel, {place: marks for place in long}) for panel in page.panels)
    return page._replace(panels=panels, notes=(*notes, *page.notes))


def _prose(page: Page) -> Mapping[int, Sequence[str]]:
    """Return the texts of each column of prose beside the stub, which has no formulas."""
    found: dict[int, list[str]] = {}
    for panel in page.panels:
        for place, column in enumerate(panel.columns):
            texts = [row[place].text for row in panel.rows if row[place].text]
            if place >= panel.stubs and column.align == "left" and any(" " in text for text in texts):
                found.setdefault(place, []).extend(texts)
    return {place: texts for place, texts in found.items() if not any(map(FORMULA.match, texts))}


def _panel_noted(panel: PagePanel, marks: Mapping[int, Mapping[str, str]]) -> PagePanel:
    def noted(place: int, cell: PageCell) -> PageCell:
        mark = marks.get(place, {}).get(cell.text)
        return cell if mark is None else cell._replace(text="", marks=cell.marks + mark)

    return panel.with_rows(tuple(noted(place, cell) for place, cell in enumerate(row)) for row in panel.rows)


def narrowed(table: Table, page: Page, annotated: Callable[[Table], Page], width: int) -> Page:
    """Return the page in as few panels as fit, parted between spanners if that is enough.

    What stands side by side stays so if lines of its texts can be shorter, or if long ones become notes. A
    table of which not even single columns fit is returned as it is.
    """
    parted = (replace(table, panels=panels) for panels in partings(table.panels))
    for ready in (page, *map(annotated, parted)):
        for attempt in reflowed(ready, width):
            if all(grid.total <= width for grid in grids_of(attempt, width)):
                return attempt
    return page
