"""Workbooks of Excel, by XlsxWriter. Needs the extra `office`.

No text is run as a formula, and none becomes a number, a time or a link: what is text is written as text, in
cells that Excel leaves as they are typed.
"""

from __future__ import annotations

from datetime import UTC, datetime
from io import BytesIO
from typing import TYPE_CHECKING

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.sheet import CellLook, Sheet, SheetCell, Workbook, bare, quoted, runs
from kurbel.formats.writer import WorkbookWriter
from kurbel.reading.environment import missing_extra

if TYPE_CHECKING:
    from xlsxwriter.format import Format
    from xlsxwriter.workbook import Workbook as File
    from xlsxwriter.worksheet import Worksheet

# A4.
PAPER = 9
# The widest column and the highest row that Excel has.
BROADEST, TALLEST = 255, 409
LINES = {"thin": 1, "heavy": 2}
SUBSCRIPT = 2
PARTS: dict[str, dict[str, object]] = {
    "caption": {"bold": True, "font_size": 12.5, "text_wrap": True, "valign": "top"},
    "head": {"text_wrap": True, "valign": "bottom"},
    "group": {"bold": True, "valign": "bottom"},
    "body": {"valign": "bottom"},
    "note": {"font_size": 9, "text_wrap": True, "valign": "top"},
    "source": {"font_size": 9, "text_wrap": True, "valign": "top", "font_color": "#66625B"},
    "key": {"bold": True, "bottom": 1},
    "entry": {"font_color": "#2B4F7D"},
}
# Text stays text, also where somebody types into the cell: 1:5 is a ratio and no time.
TEXT = "@"


class Writer(WorkbookWriter):
    def written(self, book: Workbook) -> bytes:
        return _Written(book).content


class _Written:
    """A workbook as it is written."""

    def __init__(self, book: Workbook) -> None:
        try:
            import xlsxwriter
        except ImportError:
            raise missing_extra("Excel's workbooks need XlsxWriter", "office") from None
        stream = BytesIO()
        never = dict.fromkeys(("strings_to_formulas", "strings_to_urls", "strings_to_numbers"), False)
        self.file: File = xlsxwriter.Workbook(stream, {"in_memory": True, **never})
        self.formats: dict[tuple[CellLook, bool, bool, bool], Format] = {}
        day = datetime.fromtimestamp(book.epoch, UTC).replace(tzinfo=None)
        self.file.set_properties({"title": bare(book.title), "author": bare(book.author), "created": day})
        for sheet in book.sheets:
            self.sheet(sheet)
        self.file.close()
        self.content = stream.getvalue()

    def sheet(self, sheet: Sheet) -> None:
        to = self.file.add_worksheet(sheet.name)
        for place, width in enumerate(sheet.widths):
            to.set_column(place, place, min(round(width, 2), BROADEST))
        for row, height in sheet.heights.items():
            to.set_row(row, min(height, TALLEST))
        for cell in sheet.cells:
            self.cell(to, cell)
        for number, picture in enumerate(sheet.pictures):
            content = {"image_data": BytesIO(picture.content), "description": picture.words}
            to.insert_image(picture.row, 0, f"{number}.png", content)
        to.freeze_panes(*sheet.frozen)
        if sheet.records:
            to.autofilter(0, 0, max(sheet.rows - 1, 0), max(sheet.columns - 1, 0))
        else:
            to.hide_gridlines(2)
        _set_up_paper(to, sheet)

    def cell(self, to: Worksheet, cell: SheetCell) -> None:
        row, column = cell.row, cell.column
        form = self.form(cell.look, isinstance(cell.value, str))
        if cell.across > 1 or cell.down > 1:
            to.merge_range(row, column, row + cell.down - 1, column + cell.across - 1, "", form)
        match cell.value:
            case Number() as number:
                to.write_number(row, column, float(number_text(number)), form)
            case str() as text if cell.link:
                to.write_url(row, column, f"internal:{quoted(cell.link)}!A1", form, bare(text))
            case str() as text:
                self.text(to, row, column, text, cell.look)
            case None:
                to.write_blank(row, column, None, form)

    def text(self, to: Worksheet, row: int, column: int, text: str, look: CellLook) -> None:
        pieces = runs(text)
        forms = [self.form(look, True, one.italic, one.low) for one in pieces]
        if len(pieces) > 1:
            parts = [part for form, one in zip(forms, pieces, strict=True) for part in (form, one.text)]
            to.write_rich_string(row, column, *parts, self.form(look, True))
        else:
            to.write_string(row, column, pieces[0].text, forms[0])

    def form(self, look: CellLook, is_text: bool, italic: bool = False, low: bool = False) -> Format:
        """Return the format of the file for a look; each is there once."""
        key = look, is_text, italic, low
        if key not in self.formats:
            own = _properties(look, is_text) | ({"italic": True} if italic else {})
            own |= {"font_script": SUBSCRIPT} if low else {}
            self.formats[key] = self.file.add_format(own)
        return self.formats[key]


def _properties(look: CellLook, is_text: bool) -> dict[str, object]:
    own: dict[str, object] = {"align": look.align, **PARTS[look.part]}
    own |= {side: LINES[rule] for side, rule in (("top", look.above), ("bottom", look.below)) if rule}
    own |= {"indent": 1} if look.indented else {}
    own |= {"text_wrap": True, "valign": "top"} if look.wraps else {}
    own["num_format"] = TEXT if is_text else _number_format(look)
    return own


def _number_format(look: CellLook) -> str:
    """Return 0.000, with a mark behind it as text and room as wide as other characters."""
    decimals = f".{'0' * look.decimals}" if look.decimals else ""
    after = f'"{look.after}"' if look.after else ""
    return f"0{decimals}{after}{''.join(f'_{one}' for one in look.blank)}"


def _set_up_paper(to: Worksheet, sheet: Sheet) -> None:
    to.set_paper(PAPER)
    if sheet.landscape:
        to.set_landscape()
    to.set_margins(left=0.6, right=0.6, top=0.7, bottom=0.7)
    to.center_horizontally()
    to.fit_to_pages(1, 0)
    to.set_footer("&C&P")
    first, end = sheet.head
    if end > first:
        to.repeat_rows(first, end - 1)
    if sheet.rows and sheet.columns:
        to.print_area(0, 0, sheet.rows - 1, sheet.columns - 1)
