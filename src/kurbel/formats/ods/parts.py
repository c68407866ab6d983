"""The parts of a workbook of OpenDocument but for its content, and the looks of cells, as text."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
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
