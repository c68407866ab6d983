"""What a workbook as OpenDocument has beside its sheets: pages of paper, what it is, what is in view."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import UTC, datetime
from html import escape

from kurbel.formats.ods.xml import NAMESPACES, document, element
from kurbel.formats.sheet import Sheet, Workbook, bare

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
