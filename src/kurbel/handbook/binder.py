"""A handbook as one workbook: its contents, and a sheet for each table and each drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from struct import unpack

import msgspec

from kurbel.documents.document import Chapter, Document, Item
from kurbel.exact.numerals import Label
from kurbel.formats.sheet import (
    Look,
    Picture,
    Sheet,
    SheetCell,
    SheetWriter,
    Workbook,
    checked_text,
    sheet_name,
)
from kurbel.formats.workbook import CAPTION_LINE, LARGE, LINE, epoch, height_of_prose
from kurbel.page.labels import plain, set_label

# What a sheet is called before its number and its name.
SHORT = {
    "de": {"table": "Tab.", "figure": "Abb.", "contents": "Inhalt"},
    "en": {"table": "Table", "figure": "Fig.", "contents": "Contents"},
}
# In figures: the columns of the contents.
NUMBERS, CAPTIONS = 14.0, 80.0
# Dots to the inch of a drawing that does not say it; a point is the 72nd part of an inch.
DOTS, POINTS = 100.0, 72.0
METRE = 0.0254


def kept(sheet: Sheet) -> bytes:
    """Return the sheet of a table as it waits for the handbook."""
    return msgspec.json.encode(sheet)


def document_workbook(document: Document, fragments: Mapping[str, bytes]) -> Workbook:
    """Return the handbook without its texts.

    `fragments` has by their names the sheets of tables, as they were kept, and drawings.
    """
    contents = SHORT[document.lang]["contents"]
    taken = {contents.lower()}
    sheets: list[Sheet] = []
    names: dict[str, str] = {}
    for item in document.items("table", "figure"):
        name = sheet_name(f"{SHORT[item.lang or document.lang][item.kind]} {item.number} {item.name}", taken)
        taken.add(name.lower())
        names[item.name] = name
        made = _table if item.kind == "table" else _drawing
        sheet = made(document, item, name, fragments[item.name])
        back = SheetCell(sheet.rows + 1, 0, contents, Look("entry"), link=contents)
        sheets.append(sheet._replace(cells=(*sheet.cells, back)))
    first = _contents(document, contents, names)
    title, author = (plain(one, document.mark()) for one in (document.title, document.author))
    return Workbook(title, author, document.lang, epoch(), (first, *sheets))


def _table(document: Document, item: Item, name: str, content: bytes) -> Sheet:
    sheet = msgspec.json.decode(content, type=Sheet)
    cells, heights = [], dict(sheet.heights)
    for cell in sheet.cells:
        if cell.look.part == "caption":
            cell = cell._replace(value=f"{document.title_of(item, item.lang)}: {cell.value}")
            heights[cell.row] = _height(str(cell.value), sheet.widths, cell.across)
        cells.append(cell)
    return sheet._replace(name=name, cells=tuple(cells), heights=heights)


def _drawing(document: Document, item: Item, name: str, content: bytes) -> Sheet:
    caption = _said(document, item.caption, item.lang)
    text = f"{document.title_of(item, item.lang)}: {caption}"
    across, widths = 8, (10.0,) * 8
    cell = SheetCell(0, 0, checked_text(text), Look("caption"), across)
    picture = Picture(2, content, *_size(content), plain(item.caption, document.mark(item.lang)))
    rows = int(picture.height / LINE) + 3
    heights = {0: _height(text, widths, across)}
    return Sheet(name, (cell, SheetCell(rows, 0, None, Look())), widths, heights, pictures=(picture,))


def _height(text: str, widths: Sequence[float], across: int) -> float:
    return height_of_prose(text, widths, across, LARGE, CAPTION_LINE)


def _size(png: bytes) -> tuple[float, float]:
    """Return the width and the height of a picture in points."""
    pixels = unpack(">II", png[16:24])
    place = png.find(b"pHYs")
    dots = unpack(">I", png[place + 4 : place + 8])[0] * METRE if place > 0 else DOTS
    width, height = (count / dots * POINTS for count in pixels)
    return width, height


def _contents(document: Document, name: str, names: Mapping[str, str]) -> Sheet:
    """Return the sheet with the titles of the chapters and of what is in them."""
    widths = (NUMBERS, CAPTIONS)
    heads = [label for label in (document.title, document.subtitle, document.author) if label]
    texts = [checked_text(_said(document, label)) for label in heads]
    cells = [SheetCell(row, 0, text, Look("note" if row else "caption"), 2) for row, text in enumerate(texts)]
    heights = {
        row: height_of_prose(text, widths, 2, 1.0, LINE) if row else _height(text, widths, 2)
        for row, text in enumerate(texts)
    }
    row = len(cells)
    for chapter in document.chapters:
        lines = [*_lines(document, chapter, names)]
        if lines:
            title = _said(document, chapter.title, chapter.lang)
            head = f"{chapter.number}  {title}" if chapter.number else title
            heights[row] = 2 * LINE
            cells.append(SheetCell(row, 0, checked_text(head), Look("group"), 2))
            row += 1
        for number, caption, target in lines:
            heights[row] = height_of_prose(caption, widths[1:], 1, 1.0, LINE)
            cells.append(SheetCell(row, 0, number, Look("entry", wraps=True), link=target))
            cells.append(SheetCell(row, 1, caption, Look("body", wraps=True)))
            row += 1
    return Sheet(name, tuple(cells), widths, heights)


def _lines(document: Document, chapter: Chapter, names: Mapping[str, str]) -> Iterator[tuple[str, str, str]]:
    for item in chapter.items:
        if item.name in names:
            caption = checked_text(_said(document, item.caption, item.lang))
            yield document.title_of(item, item.lang), caption, names[item.name]


def _said(document: Document, label: Label, lang: str = "") -> str:
    """Return a title or a caption as it is set in a cell."""
    writer, mark = SheetWriter(), document.mark(lang)
    return set_label(label, writer.escape, lambda formula: writer.formula(formula, mark), lambda note: "")
