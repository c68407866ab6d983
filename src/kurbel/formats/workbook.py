"""A table as a workbook: the page as a sheet, caption, heads, groups, figures and notes at their places, and
its records to calculate with."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from io import BytesIO
from itertools import chain
from math import ceil
from typing import Literal, NamedTuple
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo

from kurbel.errors import LayoutError
from kurbel.exact.numerals import DECIMALS, Number, number_text
from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.sheet import (
    MOST_COLUMNS,
    MOST_DECIMALS,
    MOST_FIGURES,
    MOST_ROWS,
    CellLook,
    Rule,
    Sheet,
    SheetCell,
    SheetWriter,
    Workbook,
    bare,
    checked_text,
    figures_wide,
    is_kept,
)
from kurbel.formats.spacing import shared, spans, widest
from kurbel.page.labels import plain
from kurbel.page.table import Cell, Group, HeadCell, Panel, Records, Row, Table, Value
from kurbel.reading.environment import source_date_epoch

# In points: a line of the text, of notes and of the caption, and the space before rows that are set apart.
LINE, SMALL_LINE, CAPTION_LINE = 15.0, 12.5, 17.0
PAUSE, APART, BELOW_HEAD = 5.0, 8.0, 3.0
# In figures: the space between columns; the column that ends a spanner's rule before another begins; the
# widest column of words; what notes have at the least.
BETWEEN, APART_RULES, WIDEST_WORDS, LEAST_PROSE = 2.2, 0.8, 60.0, 68.0
# Words are wider in some faces than they are reckoned here.
OF_WORDS = 1.06
# What keeps words clear of figures on their left.
INDENT = 1.5
# The width of a column that nobody set.
USUAL_WIDTH = 9.0
# By how much letters of notes are smaller, and those of a caption larger, than figures.
SMALL, LARGE = 0.84, 1.15


def page_sheet(table: Table, mark: str, name: str) -> Sheet:
    """Return the page of a table as a sheet of that name.

    Panels that go on to the right of each other on no paper do so here.
    """
    model = joined(table)
    ready = page(model, SheetWriter(), mark)
    sheet = _Draft(model, ready).sheet(name)._replace(mark=mark)
    if sheet.columns > MOST_COLUMNS or sheet.rows > MOST_ROWS:
        raise LayoutError(
            f"a sheet of {sheet.rows} rows and {sheet.columns} columns is too large;"
            f" spreadsheets have {MOST_ROWS} and {MOST_COLUMNS} at most, use -f csv"
        )
    return sheet


def joined(table: Table) -> Table:
    """Return the table with panels of the same rows beside each other: a sheet is as wide as it must be."""
    panels: list[Panel] = []
    for panel in table.panels:
        if panels and _rows_of(panels[-1]) == _rows_of(panel):
            panels[-1] = _beside(panels[-1], panel)
        else:
            panels.append(panel)
    return replace(table, panels=tuple(panels))


def _rows_of(panel: Panel) -> object:
    """Return what the rows of a panel are."""
    groups = [(group.label, [row.stub for row in group.rows]) for group in panel.groups]
    return panel.stub, groups if panel.stub else panel


def _beside(left: Panel, right: Panel) -> Panel:
    groups = tuple(
        Group(
            tuple(
                Row(one.stub, one.cells + other.cells)
                for one, other in zip(first.rows, second.rows, strict=True)
            ),
            first.label,
        )
        for first, second in zip(left.groups, right.groups, strict=True)
    )
    return Panel(left.stub, left.columns + right.columns, groups)


class _Draft:
    """A sheet as it is filled, row by row."""

    def __init__(self, model: Table, ready: Page) -> None:
        self.model = model
        self.ready = ready
        self.cells: list[SheetCell] = []
        self.looks: dict[CellLook, CellLook] = {}
        self.heights: dict[int, float] = {}
        self.row = 0
        widths = widest(map(_widths, ready.panels))
        spanners = chain.from_iterable(chain.from_iterable(panel.spanners for panel in ready.panels))
        parted = {cell.first for cell in spanners if cell.first}
        # Where the columns of the page stand in the sheet.
        self.places = [place + sum(one <= place for one in parted) for place in range(len(widths))]
        self.gaps = [self.places[place] - 1 for place in sorted(parted)]
        self.widths = [APART_RULES] * (len(widths) + len(parted))
        for place, width in zip(self.places, widths, strict=True):
            self.widths[place] = width
        lacking = LEAST_PROSE - sum(self.widths)
        self.prose = len(self.widths) + max(0, ceil(lacking / USUAL_WIDTH))

    def sheet(self, name: str) -> Sheet:
        ready = self.ready
        if ready.caption:
            self.prose_row(ready.caption, CellLook("caption"), LARGE, CAPTION_LINE)
            self.heights[self.row] = LINE / 2
            self.row += 1
        head = (self.row, self.row)
        for place, (panel, model) in enumerate(zip(ready.panels, self.model.panels, strict=True)):
            self.row += place > 0
            first = self.row
            self.head(panel)
            head = head if place else (first, self.row)
            self.body(panel, model)
        self.below()
        whole = len(ready.panels) == 1
        stubs = self.places[ready.panels[0].stubs] if ready.panels[0].stubs < len(self.places) else 0
        stubs = stubs if sum(self.widths[:stubs]) < WIDEST_WORDS else 0
        return Sheet(
            name,
            tuple(self.cells),
            tuple(self.widths),
            self.heights,
            (head[1] if whole else 0, stubs),
            head if whole else (0, 0),
        )

    def put(
        self, column: int, value: Number | str | None, look: CellLook, across: int = 1, down: int = 1
    ) -> None:
        content = (checked_text(value) or None) if isinstance(value, str) else value
        own = look._replace(indented=True) if look.align == "left" and column else look
        # Of the looks of a hundred thousand cells each is kept once.
        own = self.looks.setdefault(own, own)
        self.cells.append(SheetCell(self.row, column, content, own, across, down))

    def prose_row(self, text: str, look: CellLook, size: float, line: float) -> None:
        """Put a text over as many columns as it may have, in a row as high as it needs."""
        self.heights[self.row] = height_of_prose(text, self.widths, self.prose, size, line)
        self.put(0, text, look, self.prose)
        self.row += 1

    def head(self, panel: PagePanel) -> None:
        deepest = len(panel.head)
        for level, row in enumerate(panel.head):
            alone = [len(cell.lines) for cell in row if cell.down == 1]
            # What reaches down has its lines in the last row at the latest.
            tall = [len(cell.lines) - (cell.down - 1) for cell in chain(*panel.head) if cell.down > 1]
            last_row = level == deepest - 1
            self.heights[self.row] = max(alone + (tall if last_row else []) + [1]) * LINE + 3
            covered = set()
            for cell in row:
                first, last = self.places[cell.first], self.places[cell.last]
                look = self.head_look(panel, cell, level)
                self.put(first, "\n".join(cell.lines), look, last - first + 1, cell.down)
                covered |= {*range(first, last + 1)}
            rule = CellLook("head", above="" if level else "heavy", below="thin" if last_row else "")
            self.between(rule, covered)
            self.row += 1

    def between(self, look: CellLook, covered: Container[int] = ()) -> None:
        """Have rules go on through the columns that part spanners."""
        for gap in self.gaps if look.above or look.below else ():
            if gap not in covered:
                self.put(gap, None, look)

    def head_look(self, panel: PagePanel, cell: HeadCell, level: int) -> CellLook:
        above: Rule = "" if level else "heavy"
        below: Rule = "thin" if cell.text or level + cell.down == len(panel.head) else ""
        align = "center" if cell.kind == "spanner" else panel.columns[cell.first].align
        return CellLook("head", align, above, below)

    def body(self, panel: PagePanel, model: Panel) -> None:
        columns = tuple(_figures(panel, model, place) for place in range(len(panel.columns)))
        for place, (group, own) in enumerate(zip(panel.groups, model.groups, strict=True)):
            if group.label:
                self.heights[self.row] = LINE + APART
                self.put(0, group.label, CellLook("group"), self.places[len(panel.columns) - 1] + 1)
                self.row += 1
            is_last = place == len(panel.groups) - 1
            for number, (row, cells) in enumerate(zip(group.rows, own.rows, strict=True)):
                space = PAUSE if number in group.pauses else 0.0
                if not number:
                    space = 0.0 if group.label else BELOW_HEAD if not place else APART
                below: Rule = "heavy" if is_last and number == len(group.rows) - 1 else ""
                self.body_row(columns, zip(row, cells.stub + cells.cells, strict=True), space, below)

    def body_row(
        self, columns: Sequence[_Figures], row: Iterable[tuple[PageCell, Cell]], space: float, below: Rule
    ) -> None:
        """Put the cells of a row, above which there may be a space."""
        cells = [*row]
        lines = max(self.lines(place, cell) for place, (cell, _) in enumerate(cells))
        for place, (cell, own) in enumerate(cells):
            column = columns[place]
            look = CellLook("body", column.align, "", below, wraps=lines > 1)
            if not cell.down:
                # What stands for several rows is not merged: rows can be sorted, and stand on one line.
                self.put(self.places[place], None, look)
            elif isinstance(own.value, Number) and column.kept:
                self.put(self.places[place], own.value, column.of_number(look, cell, own.value))
            else:
                centred = cell.kind == "missing" and column.align == "right"
                self.put(
                    self.places[place],
                    cell.text + cell.marks,
                    look._replace(align="center") if centred else look,
                )
        self.between(CellLook("body", below=below))
        if space or lines > 1:
            self.heights[self.row] = lines * LINE + space
        self.row += 1

    def lines(self, place: int, cell: PageCell) -> int:
        """Return how many lines a cell of the body needs."""
        if cell.kind != "label" or not cell.down:
            return 1
        return max(1, ceil(figures_wide(cell.text + cell.marks) / (self.widths[self.places[place]] - 0.5)))

    def below(self) -> None:
        """Put the notes and the source below the panels."""
        self.heights[self.row] = LINE / 2
        self.row += 1
        for note in self.ready.notes:
            text = f"{note.mark} {note.text}" if note.mark else note.text
            self.prose_row(text, CellLook("note"), SMALL, SMALL_LINE)
        if self.ready.source:
            said = f"{self.ready.words['source']}: {self.ready.source}"
            self.prose_row(said, CellLook("source"), SMALL, SMALL_LINE)


def height_of_prose(text: str, widths: Sequence[float], across: int, size: float, line: float) -> float:
    """Return the height in points that a text needs over so many columns."""
    room = sum(widths[:across]) + USUAL_WIDTH * max(0, across - len(widths))
    return max(1, ceil(figures_wide(text) * size * OF_WORDS / room)) * line + 1


class _Figures(NamedTuple):
    """The figures of a column: whether a spreadsheet keeps all of them, and the longest mark behind any."""

    kept: bool
    align: Literal["left", "right"]
    hang: str

    def of_number(self, look: CellLook, cell: PageCell, number: Number) -> CellLook:
        """Return the look of a number of the column."""
        marks = bare(cell.marks)
        blank = f"{cell.tail}{self.hang[len(marks) :]}"
        return look._replace(decimals=number.decimals, after=marks, blank=blank)


def _figures(panel: PagePanel, model: Panel, place: int) -> _Figures:
    values = [(row.stub + row.cells)[place].value for row in model.rows()]
    kept = all(is_kept(value) for value in values if isinstance(value, Number))
    hang = max((bare(row[place].marks) for row in panel.rows), key=len, default="")
    return _Figures(kept, panel.columns[place].align, hang)


def _widths(panel: PagePanel) -> list[float]:
    """Return the widths of the columns of a panel, in figures."""
    widths = [_width(panel, place) for place in range(len(panel.columns))]
    above = spans(panel, lambda cell: max(map(figures_wide, cell.lines)) + 1)
    return shared(widths, above, [0.0] * len(widths))


def _width(panel: PagePanel, place: int) -> float:
    column = panel.columns[place]
    cells = (figures_wide(row[place].text + row[place].tail + row[place].marks) for row in panel.rows)
    heading = max(map(figures_wide, column.heading), default=0.0)
    of_words = column.align == "left"
    widest = min(max(cells, default=0.0), WIDEST_WORDS) * (OF_WORDS if of_words else 1)
    return max(heading, widest) + BETWEEN + (INDENT if place and of_words else 0)


WORDS = {"de": {"page": "Tafel", "records": "Werte"}, "en": {"page": "Table", "records": "Values"}}
# A zip file has no earlier day, and no later one.
EARLIEST, LATEST = 315532800, 4354819198


def epoch() -> int:
    """Return the time that a workbook is of: SOURCE_DATE_EPOCH, else the first day of 1980."""
    return max(source_date_epoch() or 0, EARLIEST)


def zipped(files: Mapping[str, Iterable[bytes]], epoch: int, stored: Container[str] = ()) -> bytes:
    """Return files, by their names and in pieces, as one that is the same everywhere; some `stored` as they
    are."""
    day = datetime.fromtimestamp(min(epoch, LATEST), UTC)
    stream = BytesIO()
    with ZipFile(stream, "w") as whole:
        for name, pieces in files.items():
            one = ZipInfo(name, day.timetuple()[:6])
            one.compress_type, one.create_system = ZIP_STORED if name in stored else ZIP_DEFLATED, 3
            with whole.open(one, "w") as file:
                for piece in pieces:
                    file.write(piece)
    return stream.getvalue()


def table_workbook(table: Table, decimal: str) -> Workbook:
    """Return the workbook of a table: a sheet with its page, and one with its records.

    `decimal` is "comma" or "point", of the numbers in texts.
    """
    mark, words = DECIMALS[decimal], WORDS.get(table.lang, WORDS["en"])
    sheets = page_sheet(table, mark, words["page"]), records_sheet(table.records, mark, words["records"])
    return Workbook(plain(table.caption, mark), "", table.lang, epoch(), sheets)


def remarks(table: Table) -> Iterator[str]:
    """Yield what its author should know of the workbook of a table."""
    cells = (cell for panel in table.panels for row in panel.rows() for cell in row.stub + row.cells)
    if not all(is_kept(cell.value) for cell in cells if isinstance(cell.value, Number)):
        yield (
            f"a spreadsheet keeps {MOST_FIGURES} figures of a number and shows {MOST_DECIMALS} decimals;"
            " columns with more are text, with every digit"
        )


def records_sheet(records: Records, mark: str, name: str) -> Sheet:
    """Return the records as a sheet: a row of keys, as CSV has it, and a row for each record."""
    rows = [*records.rows]
    if len(rows) >= MOST_ROWS:
        raise LayoutError(
            f"a sheet of {len(rows)} records is too long; at most {MOST_ROWS - 1} are in one, use -f csv"
        )
    keys = [field.key for field in records.fields]
    columns = [_column([row[place] for row in rows], mark) for place in range(len(keys))]
    widths = tuple(
        min(max(map(figures_wide, (key, *map(_shown, {*cells}))), default=0.0), WIDEST_WORDS) + BETWEEN
        for key, cells in zip(keys, columns, strict=True)
    )
    figures = [any(isinstance(one, Number) for one in column) for column in columns]
    head = (
        SheetCell(0, place, key, CellLook("key", "right" if figures[place] else "left"))
        for place, key in enumerate(keys)
    )
    body = _records(zip(*columns, strict=True))
    return Sheet(name, (*head, *body), widths, {}, (1, 0), (0, 1), True, mark)


def _column(values: Sequence[Value], mark: str) -> list[Number | str | None]:
    """Return the values of a column; its numbers are text where a spreadsheet would not keep one of them."""
    kept = all(is_kept(value) for value in values if isinstance(value, Number))
    return [
        value
        if value is None or (kept and isinstance(value, Number))
        else number_text(value, mark)
        if isinstance(value, Number)
        else checked_text(plain(value, mark))
        for value in values
    ]


def _shown(value: Number | str | None) -> str:
    return number_text(value) if isinstance(value, Number) else value or ""


def _records(rows: Iterator[Sequence[Number | str | None]]) -> Iterator[SheetCell]:
    looks = [CellLook("body", "right", decimals=decimals) for decimals in range(MOST_DECIMALS + 1)]
    words = CellLook("body", "left")
    for place, row in enumerate(rows, 1):
        for column, value in enumerate(row):
            if isinstance(value, Number):
                yield SheetCell(place, column, value, looks[value.decimals])
            elif value:
                yield SheetCell(place, column, value, words)
