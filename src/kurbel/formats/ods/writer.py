"""Workbooks as OpenDocument: a few files of XML in a zip file.

They are written as text. A library that has an object for each cell, odfdo, takes 0.4 ms for one, and two
minutes for a page of 100,000 numbers.
"""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import UTC, datetime
from hashlib import sha256
from html import escape

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.page import blank
from kurbel.formats.sheet import CellLook, Picture, Run, Sheet, SheetCell, Workbook, bare, quoted, runs
from kurbel.formats.workbook import zipped
from kurbel.formats.writer import WorkbookWriter

NAMESPACES = " ".join(
    f'xmlns:{prefix}="{name}"'
    for prefix, name in {
        **{
            prefix: f"urn:oasis:names:tc:opendocument:xmlns:{name}:1.0"
            for prefix, name in {
                "office": "office", "table": "table", "text": "text", "style": "style", "draw": "drawing",
                "number": "datastyle", "meta": "meta", "config": "config", "fo": "xsl-fo-compatible",
                "svg": "svg-compatible", "manifest": "manifest",
            }.items()
        },
        "dc": "http://purl.org/dc/elements/1.1/",
        "xlink": "http://www.w3.org/1999/xlink",
    }.items()
)  # fmt: skip


def element(name: str, *content: str, **attributes: object) -> str:
    """Return an element; style__row_height="15pt" is its attribute style:row-height, None is left out."""
    inner, begin = "".join(content), opened(name, **attributes)
    return f"{begin}{inner}</{name}>" if inner else f"{begin[:-1]}/>"


def opened(name: str, **attributes: object) -> str:
    """Return how an element begins."""
    said = "".join(
        f' {key.replace("__", ":").replace("_", "-")}="{escape(str(value))}"'
        for key, value in attributes.items()
        if value is not None
    )
    return f"<{name}{said}>"


def around(root: str, prefix: str = "office") -> tuple[str, str]:
    """Return what stands before and behind the content of a file."""
    tag = f"{prefix}:{root}"
    begin = f'<?xml version="1.0" encoding="UTF-8"?>\n<{tag} {NAMESPACES} {prefix}:version="1.3">'
    return begin, f"</{tag}>\n"


RULES = {"thin": "0.5pt solid #1c1b19", "heavy": "1.5pt solid #1c1b19"}
SIZES = {"caption": "11.5pt", "note": "8.5pt", "source": "8.5pt"}
BOLD = frozenset(("caption", "group", "key"))
COLOURS = {"source": "#66625b", "entry": "#2b4f7d"}
WRAPPED = frozenset(("caption", "head", "note", "source"))
TOP = frozenset(("caption", "note", "source"))
INDENT = "8pt"
ALIGNS = {"left": "start", "center": "center", "right": "end"}
# In points: a line, a figure, and what is beside the figures of a column.
LINE, FIGURE, BESIDE = 15.0, 5.6, 3.0
# As wide as a letter of a note's mark.
RAISED = "\u2004"
# The language whose numbers have this mark.
LOCALES = {",": ("de", "DE"), ".": ("en", "GB")}


class CellStyles:
    """Gives each look its name, and knows the styles of all that were named.

    Numbers have the decimal mark of the page, whatever the language of the program that shows them.
    """

    def __init__(self) -> None:
        self.names: dict[tuple[object, ...], str] = {}
        self.cells: dict[tuple[CellLook, str], str] = {}
        self.styles: list[str] = []
        self.text = self.named("nt", "number:text-style", element("number:text-content"))

    def meet(self, sheet: Sheet) -> None:
        """Name all looks of a sheet: their styles stand before it."""
        self.sheet(sheet)
        for width in sheet.widths:
            self.column(width)
        for height in (None, *sheet.heights.values()):
            self.row(height)
        for cell in sheet.cells:
            self.cell(cell.look, sheet.mark if isinstance(cell.value, Number) else "")
            for run in runs(cell.value) if isinstance(cell.value, str) else ():
                self.run(run)

    def named(self, prefix: str, tag: str, content: str, **attributes: object) -> str:
        """Return the name of a style, which is there once."""
        key = (tag, content, *attributes.items())
        if key not in self.names:
            name = self.names[key] = f"{prefix}{len(self.names) + 1}"
            self.styles.append(element(tag, content, style__name=name, **attributes))
        return self.names[key]

    def style(self, prefix: str, family: str, content: str, **attributes: object) -> str:
        return self.named(prefix, "style:style", content, style__family=family, **attributes)

    def column(self, width: float) -> str:
        size = f"{width * FIGURE + BESIDE:.1f}pt"
        return self.style(
            "co", "table-column", element("style:table-column-properties", style__column_width=size)
        )

    def row(self, height: float | None) -> str:
        own = element(
            "style:table-row-properties",
            style__row_height=f"{LINE if height is None else height:.1f}pt",
            style__use_optimal_row_height="true" if height is None else "false",
        )
        return self.style("ro", "table-row", own)

    def run(self, run: Run) -> str:
        """Return the name of the style of a piece of text, nothing where it is as its cell."""
        if not run.italic and not run.low:
            return ""
        own = element(
            "style:text-properties",
            fo__font_style="italic" if run.italic else None,
            style__text_position="sub 65%" if run.low else None,
        )
        return self.style("tx", "text", own)

    def sheet(self, sheet: Sheet) -> str:
        master = "Landscape" if sheet.landscape else "Portrait"
        own = element("style:table-properties", table__display="true")
        return self.style("ta", "table", own, style__master_page_name=master)

    def cell(self, look: CellLook, mark: str) -> str:
        """Return the name of the style of a cell; the mark is that of its number, or nothing of a text."""
        key = look, mark
        if key not in self.cells:
            numbers = self.number(look, mark) if mark else self.text
            self.cells[key] = self.style(
                "ce",
                "table-cell",
                _properties(look),
                style__parent_style_name="Default",
                style__data_style_name=numbers,
            )
        return self.cells[key]

    def number(self, look: CellLook, mark: str) -> str:
        """Return the name of the style of a number: its decimals, and what stands behind it."""
        figures = element(
            "number:number",
            number__decimal_places=look.decimals,
            number__min_decimal_places=look.decimals,
            number__min_integer_digits=1,
        )
        language, country = LOCALES[mark]
        # Spaces as wide as other characters.
        behind = look.after + "".join(one if one.isspace() else RAISED for one in blank(look.blank))
        after = element("number:text", escape(behind)) if behind else ""
        return self.named(
            "nu",
            "number:number-style",
            figures + after,
            number__language=language,
            number__country=country,
        )


def _properties(look: CellLook) -> str:
    cell = element(
        "style:table-cell-properties",
        fo__border_top=RULES.get(look.above),
        fo__border_bottom=RULES.get(look.below, RULES["thin"] if look.part == "key" else None),
        fo__wrap_option="wrap" if look.wraps or look.part in WRAPPED else None,
        style__vertical_align="top" if look.wraps or look.part in TOP else "bottom",
        style__text_align_source="fix",
    )
    paragraph = element(
        "style:paragraph-properties",
        fo__text_align=ALIGNS[look.align],
        fo__margin_left=INDENT if look.indented else "0pt",
    )
    text = element(
        "style:text-properties",
        fo__font_size=SIZES.get(look.part),
        fo__font_weight="bold" if look.part in BOLD else None,
        fo__color=COLOURS.get(look.part),
    )
    return cell + paragraph + text


MIME = "application/vnd.oasis.opendocument.spreadsheet"
MANIFEST = "META-INF/manifest.xml"
COUNTRIES = {"de": "DE", "en": "GB"}
# Between elements of the template.
_WHITE = re.compile(r"(?<=>)\s+(?=<)")


def parts_of(book: Workbook, names: Sequence[str]) -> Mapping[str, str]:
    """Return the files beside the content of a workbook by their names: the styles of all cells and the two
    kinds of pages, what it is, what stays in view, and the list of the files, which has these names too."""
    from jinja2 import Environment, FileSystemLoader

    environment = Environment(loader=FileSystemLoader(os.path.dirname(__file__)))
    environment.filters["escaped"] = lambda value: escape(str(value))
    own = {"styles.xml": "styles", "meta.xml": "meta", "settings.xml": "settings"}
    values = {
        "book": book,
        "names": (names[0], *own, *names[1:]),
        "title": bare(book.title),
        "author": bare(book.author),
        "country": COUNTRIES.get(book.lang),
        "day": datetime.fromtimestamp(book.epoch, UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
    }
    module = environment.get_template("parts.xml.jinja").make_module(values)

    def filled(macro: str) -> str:
        return _WHITE.sub("", getattr(module, macro)().strip())

    files = {name: filled(macro).join(around(f"document-{macro}")) for name, macro in own.items()}
    listed = filled("manifest").join(around("manifest", "manifest"))
    return files | {MANIFEST: listed}


EMPTY = "<table:table-cell/>"


class Writer(WorkbookWriter):
    def written(self, book: Workbook) -> bytes:
        pictures = [picture for sheet in book.sheets for picture in sheet.pictures]
        shown = {_name_of(picture): [picture.content] for picture in pictures}
        files: dict[str, Iterable[bytes]] = {"mimetype": [MIME.encode()], "content.xml": _content(book)}
        parts = {name: [text.encode()] for name, text in parts_of(book, ("content.xml", *shown)).items()}
        listed = {MANIFEST: parts.pop(MANIFEST)}
        # What the file is must stand first, as it is.
        return zipped({**files, **parts, **shown, **listed}, book.epoch, stored=("mimetype",))


def _name_of(picture: Picture) -> str:
    return f"Pictures/{sha256(picture.content).hexdigest()[:24]}.png"


def _content(book: Workbook) -> Iterator[bytes]:
    """Yield the sheets in pieces: as one text a long table takes ten times the memory of its file."""
    looks = CellStyles()
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

    def __init__(self, sheet: Sheet, looks: CellStyles) -> None:
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
        return element("text:a", pieces, xlink__href=f"#{quoted(link)}.A1", xlink__type="simple")


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
    return f"{quoted(sheet.name)}.{letters}{row + 1}"
