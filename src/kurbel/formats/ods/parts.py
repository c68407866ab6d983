"""The parts of a workbook of OpenDocument but for its content, and the looks of cells, as text."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import UTC, datetime
from html import escape

from kurbel.exact.numerals import Number
from kurbel.formats.page import blank
from kurbel.formats.sheet import Look, Run, Sheet, Workbook, bare, runs

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


def document(root: str, *content: str) -> str:
    """Return a file of OpenDocument."""
    begin, end = around(root)
    return f"{begin}{''.join(content)}{end}"


def around(root: str) -> tuple[str, str]:
    """Return what stands before and behind the content of a file."""
    begin = f'<?xml version="1.0" encoding="UTF-8"?>\n<office:{root} {NAMESPACES} office:version="1.3">'
    return begin, f"</office:{root}>\n"


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


class Looks:
    """Gives each look its name, and knows the styles of all that were named.

    Numbers have the decimal mark of the page, whatever the language of the program that shows them.
    """

    def __init__(self) -> None:
        self.names: dict[tuple[object, ...], str] = {}
        self.cells: dict[tuple[Look, str], str] = {}
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

    def cell(self, look: Look, mark: str) -> str:
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

    def number(self, look: Look, mark: str) -> str:
        """Return the name of the style of a number: its decimals, and what stands behind it."""
        figures = element(
            "number:number",
            number__decimal_places=look.decimals,
            number__min_decimal_places=look.decimals,
            number__min_integer_digits=1,
        )
        language, country = LOCALES[mark]
        behind = look.after + _spaces(look.blank)
        after = element("number:text", escape(behind)) if behind else ""
        return self.named(
            "nu",
            "number:number-style",
            figures + after,
            number__language=language,
            number__country=country,
        )


def _spaces(characters: str) -> str:
    """Return spaces as wide as these characters."""
    spaces = blank(characters)
    return "".join(one if one.isspace() else RAISED for one in spaces)


def _properties(look: Look) -> str:
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
COUNTRIES = {"de": "DE", "en": "GB"}
FACE = "Liberation Sans"
SIZE = "10pt"
# A4 in portrait; landscape has them the other way.
SIDES = ("210mm", "297mm")


def styles(book: Workbook) -> str:
    """Return the styles of all cells, and the two kinds of pages."""
    text = element(
        "style:text-properties",
        style__font_name=FACE,
        fo__font_size=SIZE,
        fo__language=book.lang,
        fo__country=COUNTRIES.get(book.lang, "none"),
    )
    default = element("style:default-style", text, style__family="table-cell")
    plain = element("style:style", style__name="Default", style__family="table-cell")
    face = element("style:font-face", style__name=FACE, svg__font_family=f"'{FACE}'")
    return document(
        "document-styles",
        element("office:font-face-decls", face),
        element("office:styles", default, plain),
        element("office:automatic-styles", _centred(), _layout("Portrait"), _layout("Landscape")),
        element("office:master-styles", _master("Portrait"), _master("Landscape")),
    )


def _centred() -> str:
    middle = element("style:paragraph-properties", fo__text_align="center")
    return element("style:style", middle, style__name="Centred", style__family="paragraph")


def _layout(turned: str) -> str:
    width, long = SIDES if turned == "Portrait" else reversed(SIDES)
    page = element(
        "style:page-layout-properties",
        fo__page_width=width,
        fo__page_height=long,
        style__print_orientation=turned.lower(),
        **{f"fo__margin_{side}": "15mm" for side in ("top", "bottom", "left", "right")},
        style__table_centering="horizontal",
        # As many pages below each other as there must be, none beside each other.
        style__scale_to_X=1,
        style__scale_to_Y=0,
    )
    height = element("style:header-footer-properties", fo__min_height="8mm", fo__margin_top="3mm")
    foot = element("style:footer-style", height)
    return element("style:page-layout", page, "<style:header-style/>", foot, style__name=f"{turned}Page")


def _master(turned: str) -> str:
    number = element("text:p", element("text:page-number", "1"), text__style_name="Centred")
    return element(
        "style:master-page",
        element("style:header", style__display="false"),
        element("style:footer", number),
        style__name=turned,
        style__page_layout_name=f"{turned}Page",
    )


def meta(book: Workbook) -> str:
    """Return what the workbook is."""
    day = datetime.fromtimestamp(book.epoch, UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
    author = bare(book.author)
    return document(
        "document-meta",
        element(
            "office:meta",
            element("meta:generator", "kurbel"),
            element("dc:title", escape(bare(book.title))),
            element("meta:initial-creator", escape(author)) if author else "",
            element("dc:language", "-".join(filter(None, (book.lang, COUNTRIES.get(book.lang))))),
            element("meta:creation-date", day),
            element("dc:date", day),
        ),
    )


def settings(book: Workbook) -> str:
    """Return what of each sheet stays in view, and which of them has lines between its cells."""
    tables = "".join(_entry(_seen(sheet), sheet.name) for sheet in book.sheets)
    named = element("config:config-item-map-named", tables, config__name="Tables")
    first = _item("ActiveTable", "string", book.sheets[0].name)
    views = element("config:config-item-map-indexed", _entry(first + named), config__name="Views")
    return document(
        "document-settings",
        element(
            "office:settings", element("config:config-item-set", views, config__name="ooo:view-settings")
        ),
    )


def _seen(sheet: Sheet) -> str:
    rows, columns = sheet.frozen
    return "".join(
        (
            _item("HorizontalSplitMode", "short", 2 if columns else 0),
            _item("VerticalSplitMode", "short", 2 if rows else 0),
            _item("HorizontalSplitPosition", "int", columns),
            _item("VerticalSplitPosition", "int", rows),
            _item("ActiveSplitRange", "short", 3 if rows and columns else 2),
            _item("PositionRight", "int", columns),
            _item("PositionBottom", "int", rows),
            _item("ShowGrid", "boolean", "true" if sheet.records else "false"),
        )
    )


def _entry(items: str, name: str | None = None) -> str:
    return element("config:config-item-map-entry", items, config__name=name)


def _item(name: str, kind: str, value: object) -> str:
    return element("config:config-item", escape(str(value)), config__name=name, config__type=kind)


def manifest(names: Iterable[str]) -> str:
    """Return the list of the files."""
    kinds = {".xml": "text/xml", ".png": "image/png"}
    files = [("/", MIME), *((name, kinds[name[-4:]]) for name in names)]
    entries = "".join(
        element("manifest:file-entry", manifest__full_path=name, manifest__media_type=kind)
        for name, kind in files
    )
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<manifest:manifest {NAMESPACES} manifest:version="1.3">'
        f"{entries}</manifest:manifest>\n"
    )
