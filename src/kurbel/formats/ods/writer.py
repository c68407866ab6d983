"""Workbooks as OpenDocument: a few files of XML in a zip file.

They are written as text. A library that has an object for each cell, odfdo, takes 0.4 ms for one, and two
minutes for a page of 300,000 numbers.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime
from hashlib import sha256
from html import escape
from io import BytesIO
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.ods.parts import LINE, MANIFEST, MIME, Looks, around, element, opened, parts_of
from kurbel.formats.sheet import Picture, Sheet, SheetCell, Workbook, runs
from kurbel.formats.writer import WorkbookWriter

# A zip file has no later day than the end of 2107.
LATEST = 4354819198
EMPTY = "<table:table-cell/>"


class Writer(WorkbookWriter):
    def written(self, book: Workbook) -> bytes:
        pictures = [picture for sheet in book.sheets for picture in sheet.pictures]
        shown = {_name_of(picture): [picture.content] for picture in pictures}
        files: dict[str, Iterable[bytes]] = {"mimetype": [MIME.encode()], "content.xml": _content(book)}
        parts = {name: [text.encode()] for name, text in parts_of(book, ("content.xml", *shown)).items()}
        listed = {MANIFEST: parts.pop(MANIFEST)}
        return _zipped({**files, **parts, **shown, **listed}, book)


def _name_of(picture: Picture) -> str:
    return f"Pictures/{sha256(picture.content).hexdigest()[:24]}.png"


def _zipped(files: Mapping[str, Iterable[bytes]], book: Workbook) -> bytes:
    """Return the files as one, each of the same day; what the file is must stand first, as it is."""
    day = datetime.fromtimestamp(min(book.epoch, LATEST), UTC)
    stream = BytesIO()
    with ZipFile(stream, "w") as whole:
        for name, pieces in files.items():
            one = ZipInfo(name, day.timetuple()[:6])
            one.compress_type = ZIP_STORED if name == "mimetype" else ZIP_DEFLATED
            # The same on every system.
            one.create_system = 3
            with whole.open(one, "w") as file:
                for piece in pieces:
                    file.write(piece)
    return stream.getvalue()


def _content(book: Workbook) -> Iterator[bytes]:
    """Yield the sheets in pieces: as one text a long table takes ten times the memory of its file."""
    looks = Looks()
    for sheet in book.sheets:
        looks.meet(sheet)
    begin, end = around("document-content")
    yield f"{begin}{element('office:automatic-styles', *looks.styles)}".encode()
    yield b"<office:body><office:spreadsheet>"
    for sheet in book.sheets:
        for row in _Table(sheet, looks).pieces(sheet):
            yield row.encode()
    filters = "".join(_filter(sheet, place) for place, sheet in enumerate(book.sheets) if sheet.records)
    ranges = element("table:database-ranges", filters) if filters else ""
    yield f"{ranges}</office:spreadsheet></office:body>{end}".encode()


class _Table:
    """A sheet as a table of OpenDocument."""

    def __init__(self, sheet: Sheet, looks: Looks) -> None:
        self.looks = looks
        self.mark = sheet.mark
        # What cells above cover, by rows and columns.
        self.covered: defaultdict[int, dict[int, str]] = defaultdict(dict)

    def pieces(self, sheet: Sheet) -> Iterator[str]:
        """Yield the element of the table in pieces."""
        yield opened(
            "table:table",
            table__name=sheet.name,
            table__style_name=self.looks.sheet(sheet),
            table__print_ranges=_whole(sheet),
        )
        if sheet.pictures:
            yield element("table:shapes", *map(_shape, sheet.pictures))
        for width in sheet.widths:
            yield element("table:table-column", table__style_name=self.looks.column(width))
        first, end = sheet.head
        for place, row in enumerate(self.rows(sheet)):
            before = "<table:table-header-rows>" if place == first < end else ""
            behind = "</table:table-header-rows>" if first < end == place + 1 else ""
            yield f"{before}{row}{behind}"
        yield "</table:table>"

    def rows(self, sheet: Sheet) -> Iterator[str]:
        """Yield all rows; the cells of a sheet are in the order of these."""
        cells = iter(sheet.cells)
        cell = next(cells, None)
        for place in range(sheet.rows):
            row = self.covered.pop(place, {})
            while cell and cell.row == place:
                self.put(cell, row)
                cell = next(cells, None)
            style = self.looks.row(sheet.heights.get(place))
            text = "".join(_filled(row)) or EMPTY
            yield f'<table:table-row table:style-name="{style}">{text}</table:table-row>'

    def put(self, cell: SheetCell, row: dict[int, str]) -> None:
        """Put a cell into its row, and what it covers into that and those below."""
        look = self.looks.cell(cell.look, self.mark if isinstance(cell.value, Number) else "")
        named = f'table:style-name="{look}"'
        spans = ""
        if cell.across > 1 or cell.down > 1:
            spans = f' table:number-columns-spanned="{cell.across}" table:number-rows-spanned="{cell.down}"'
            for down in range(cell.down):
                below = self.covered[cell.row + down] if down else row
                columns = range(cell.column, cell.column + cell.across)
                below |= dict.fromkeys(columns, f"<table:covered-table-cell {named}/>")
        row[cell.column] = f"<table:table-cell {named}{spans}{self.content(cell)}"

    def content(self, cell: SheetCell) -> str:
        """Return the rest of the element of a cell."""
        match cell.value:
            case Number() as number:
                shown = number_text(number, self.mark) + escape(cell.look.after)
                value = f' office:value-type="float" office:value="{number_text(number)}"'
                return f"{value}><text:p>{shown}</text:p></table:table-cell>"
            case str() as text:
                lines = "".join(element("text:p", self.line(line, cell.link)) for line in text.split("\n"))
                return f' office:value-type="string">{lines}</table:table-cell>'
            case None:
                return "/>"

    def line(self, text: str, link: str) -> str:
        pieces = "".join(
            element("text:span", escape(one.text), text__style_name=style)
            if (style := self.looks.run(one))
            else escape(one.text)
            for one in runs(text)
        )
        if not link:
            return pieces
        return element("text:a", pieces, xlink__href=f"#{_quoted(link)}.A1", xlink__type="simple")


def _shape(picture: Picture) -> str:
    """Return a picture below its row, at the left edge of the sheet."""
    image = element("draw:image", xlink__href=_name_of(picture), xlink__type="simple")
    return element(
        "draw:frame",
        image,
        element("svg:title", escape(picture.words)),
        svg__width=f"{picture.width:.1f}pt",
        svg__height=f"{picture.height:.1f}pt",
        svg__x="0pt",
        svg__y=f"{picture.row * LINE:.1f}pt",
    )


def _filled(cells: Mapping[int, str]) -> Iterator[str]:
    """Yield the cells of a row in their order, with what is empty between them."""
    done = 0
    for column in sorted(cells):
        if column > done:
            yield f'<table:table-cell table:number-columns-repeated="{column - done}"/>'
        yield cells[column]
        done = column + 1


def _filter(sheet: Sheet, place: int) -> str:
    return element(
        "table:database-range",
        table__name=f"__Anonymous_Sheet_DB__{place}",
        table__target_range_address=_whole(sheet),
        table__display_filter_buttons="true",
    )


def _whole(sheet: Sheet) -> str:
    """Return the address of all cells of a sheet."""
    return f"{_place(sheet, 0, 0)}:{_place(sheet, sheet.rows - 1, sheet.columns - 1)}"


def _place(sheet: Sheet, row: int, column: int) -> str:
    """Return the address of a cell: 'Tafel'.A1."""
    letters = ""
    number = column + 1
    while number:
        number, rest = divmod(number - 1, 26)
        letters = f"{chr(ord('A') + rest)}{letters}"
    return f"{_quoted(sheet.name)}.{letters}{row + 1}"


def _quoted(name: str) -> str:
    return "'" + name.replace("'", "''") + "'"
