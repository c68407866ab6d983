"""The whole documents of a handbook: from its parts, as they were made, to pages in each format, and to one
workbook with its contents, and a sheet for each table and each drawing."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import nullcontext
from itertools import count, repeat
from struct import unpack
from typing import NamedTuple

import msgspec

from kurbel.documents import prose
from kurbel.documents.document import PLACE, Chapter, Document, Item
from kurbel.errors import HandbookError, KurbelError
from kurbel.exact.numerals import Label
from kurbel.formats.registry import FORMATS, DocumentFormat, PageFormat, WorkbookFormat
from kurbel.formats.render import as_one_page
from kurbel.formats.sheet import (
    CellLook,
    Picture,
    Sheet,
    SheetCell,
    SheetWriter,
    Workbook,
    checked_text,
    sheet_name,
)
from kurbel.formats.workbook import CAPTION_LINE, LARGE, LINE, epoch, height_of_prose
from kurbel.handbook.folder import LARGEST, SHEETS
from kurbel.handbook.manifest import ChapterPlan, Manifest, Part
from kurbel.handbook.matter import with_matter
from kurbel.handbook.model import COMPILED
from kurbel.handbook.pool import PDF_PATIENCE, BuiltFiles, ListEntry
from kurbel.page.labels import plain, primed, set_label
from kurbel.reading.given import HANDBOOK, File
from kurbel.reading.names import did_you_mean

WORDS = {"de": "Fehlt", "en": "Missing"}
# Where the sheet of a table waits for its workbook, and its page for a document of Word or one in its format.
SHEET, PAGE, INSIDE = (f"{SHEETS}/{{}}.{suffix}" for suffix in ("json", "html", "htm"))


class Failure(NamedTuple):
    """A part or a document that could not be made."""

    line: int
    name: str
    sentence: str


def document_of(manifest: Manifest, made: Mapping[str, ListEntry], failures: list[Failure]) -> Document:
    """Return the document with its tables and figures numbered; `made` has what is to know of them by name.

    A text that cannot be set is one failure more. What failed stands in the document as a text that nobody
    overlooks.
    """
    made_of = _Items(manifest, made, failures)
    chapters = tuple(made_of.chapter(number, plan) for number, plan in enumerate(manifest.chapters, 1))
    mark = manifest.decimal or ""
    whole = Document(manifest.title, manifest.lang, mark, chapters, manifest.subtitle, manifest.author)
    if not manifest.matter:
        return whole
    return with_matter(whole, manifest, made)


class _Items:
    """Makes the items of the chapters from their parts."""

    def __init__(self, manifest: Manifest, made: Mapping[str, ListEntry], failures: list[Failure]) -> None:
        self.folder = manifest.folder
        self.outside = manifest.outside
        self.matter = manifest.matter
        self.made = made
        self.failures = failures
        self.counts = {"table": 0, "figure": 0}
        self.places = map("{}{}".format, repeat(PLACE), count(1))
        self.names = [plan.name for plan in manifest.chapters] + list(manifest.matter)
        self.names += [part.name for part in manifest.parts() if part.words]

    def chapter(self, number: int, plan: ChapterPlan) -> Chapter:
        # The levels of the headings that hold at the end of the last text.
        above: list[int] = []
        return Chapter(
            plan.title, plan.name, number, tuple(self.item(part, above) for part in plan.parts), plan.lang
        )

    def item(self, part: Part, above: list[int]) -> Item:
        if about := self.made.get(part.name):
            self.counts[about.kind] += 1
            return Item(about.kind, part.name, self.counts[about.kind], about.lang, about.caption)
        lang = str(part.options["lang"])
        if part.words:
            blocks = _missing(
                next(one.sentence for one in self.failures if one.name == part.name), part, lang
            )
        else:
            blocks = self.text(part, lang, above)
        # With a name it is what should have been a table or a figure, and references lead to its chapter.
        return Item("text", part.name, lang=lang, blocks=blocks)

    def file(self, name: str) -> File:
        return File(name, self.folder, inside="" if self.outside else HANDBOOK)

    def text(self, part: Part, lang: str, above: list[int]) -> prose.Blocks:
        """Return a text, of the manifest or of its own file, or a failure in its place."""
        from kurbel.documents.markdown import LONGEST, parse_prose

        try:
            text = _text_of(os.fspath(self.file(part.file)), LONGEST) if part.file else part.text
            blocks = parse_prose(text)
            for name in prose.references(blocks):
                if name not in self.names:
                    raise HandbookError(
                        f'there is no table, figure or chapter "{name[:60]}"{did_you_mean(name, self.names)}'
                    )
        except KurbelError as error:
            self.failures.append(Failure(part.line, part.file or part.problems or "text", str(error)))
            return _missing(str(error), part, lang)
        if "index" in self.matter:
            blocks = prose.with_places(blocks, self.places)
        return prose.stepwise(blocks, above)


def _text_of(path: str, longest: int) -> str:
    if os.path.exists(path) and not os.path.isfile(path):
        raise HandbookError(f"cannot read the text {path}: it is a directory or a device; name a file")
    try:
        with open(path, encoding="utf-8-sig") as file:
            text = file.read(longest + 1)
    except (OSError, ValueError) as error:
        said = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise HandbookError(f"cannot read the text {path}: {said}") from None
    if len(text) > longest:
        raise HandbookError(f"the text {path} has more than {longest} characters; make several of it")
    return text


def _missing(said: str, part: Part, lang: str) -> prose.Blocks:
    """Return a text that nobody overlooks in place of what is not there."""
    what = part.shown if part.words else part.file or part.text[:40]
    head = prose.Strong((prose.Text(primed(f"{WORDS[lang]}: {_printable(what)}.")),))
    rest = prose.Text(primed(f" {_printable(said)}"))
    return (prose.Quote((prose.Paragraph((head, rest)),)),)


def _printable(text: str) -> str:
    """Return a text as one line; what a command has that cannot be printed may be why it failed."""
    return "".join(one if one.isprintable() else "\ufffd" for one in " ".join(text.split()))


def fragment_paths(document: Document, name: str) -> dict[str, str]:
    """Return, by the names of tables and figures, the files that the document in a format is made of."""
    form = FORMATS[name]
    waiting = {"workbook": SHEET, "document": PAGE}
    table = waiting.get(form.kind, f"tables/{{}}{form.suffixes[0]}")
    if isinstance(form, PageFormat) and form.own_pages:
        table = INSIDE
    ways = {"table": table, "figure": f"figures/{{}}.{form.figures}"}
    return {item.name: ways[item.kind].format(item.name) for item in document.items(*ways)}


def make_document(
    document: Document, format: str, fragments: Mapping[str, bytes], templates: str | None
) -> BuiltFiles:
    """Return the files of the document in a format, of the fragments by their names."""
    form = FORMATS[format]
    if isinstance(form, WorkbookFormat):
        return BuiltFiles(
            {f"handbook{form.suffixes[0]}": form.writer.written(document_workbook(document, fragments))}
        )
    from kurbel.formats.documents import document_files

    if isinstance(form, DocumentFormat):
        with as_one_page(templates):
            return BuiltFiles(
                {f"handbook{form.suffixes[0]}": form.writer.whole(document, fragments, templates)}
            )

    # Drawings in PDF are files beside the document and no text.
    texts = {name: content.decode("utf-8", "replace") for name, content in fragments.items()}
    with as_one_page(templates):
        files = document_files(document, format, texts, templates)
    return BuiltFiles({path: text.encode() for path, text in files.items()})


def make_pdf(folder: str, standards: tuple[str, ...], limited: bool) -> BuiltFiles:
    """Return the PDF of the documents in a folder.

    It is `limited` where templates may have written its source, which is then not trusted.
    """

    def read(name: str) -> str:
        return _text_of(os.path.join(folder, name), LARGEST)

    from kurbel.formats.templates import deadline

    with deadline(PDF_PATIENCE, None) if limited else nullcontext():
        return BuiltFiles({f"handbook.{COMPILED.name}": COMPILED.writer.whole(folder, standards, read)})


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
        back = SheetCell(sheet.rows + 1, 0, contents, CellLook("entry"), link=contents)
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
    cell = SheetCell(0, 0, checked_text(text), CellLook("caption"), across)
    picture = Picture(2, content, *_size(content), plain(item.caption, document.mark(item.lang)))
    rows = int(picture.height / LINE) + 3
    heights = {0: _height(text, widths, across)}
    return Sheet(name, (cell, SheetCell(rows, 0, None, CellLook())), widths, heights, pictures=(picture,))


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
    cells = [
        SheetCell(row, 0, text, CellLook("note" if row else "caption"), 2) for row, text in enumerate(texts)
    ]
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
            cells.append(SheetCell(row, 0, checked_text(head), CellLook("group"), 2))
            row += 1
        for number, caption, target in lines:
            heights[row] = height_of_prose(caption, widths[1:], 1, 1.0, LINE)
            cells.append(SheetCell(row, 0, number, CellLook("entry", wraps=True), link=target))
            cells.append(SheetCell(row, 1, caption, CellLook("body", wraps=True)))
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
