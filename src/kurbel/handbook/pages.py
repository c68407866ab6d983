"""The whole documents of a handbook: from its parts, as they were made, to pages in each format."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.errors import HandbookError, KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.folder import LARGEST
from kurbel.handbook.manifest import ChapterPlan, Manifest, Part
from kurbel.handbook.model import COMPILED, ENGINES
from kurbel.handbook.parts import GIGABYTES, PATIENCE, PDF, PDF_PATIENCE, Made
from kurbel.page.labels import primed
from kurbel.reading.given import did_you_mean

if TYPE_CHECKING:
    from kurbel.documents.prose import Blocks

WORDS = {"de": "Fehlt", "en": "Missing"}


class Entry(NamedTuple):
    """A part as documents see it: a text, or what is to know of a table or figure: kind, caption, language.

    A text that cannot be set, or stands for what could not be made, is `said`.
    """

    part: Part
    text: str = ""
    about: tuple[str, ...] = ()
    said: str = ""


class PlannedChapter(NamedTuple):
    plan: ChapterPlan
    entries: tuple[Entry, ...]


class PageTask(NamedTuple):
    """A document that is to be made in a format, of the fragments by their names."""

    format: str
    document: Document
    fragments: Mapping[str, str]
    templates: str | None


class PdfTask(NamedTuple):
    """A PDF that is to be set from the documents in a folder."""

    folder: str
    engine: str
    standards: tuple[str, ...]
    # Where templates may have written the source, which is then not trusted.
    limited: bool


def entry_of_text(manifest: Manifest, part: Part, names: Sequence[str]) -> Entry:
    """Return a text, of the manifest or of its own file, or what keeps it from being set.

    It may refer to these names only.
    """
    from kurbel.documents.markdown import LONGEST, parse_prose
    from kurbel.documents.prose import references

    try:
        text = _text_of(os.path.join(manifest.folder, part.file), LONGEST) if part.file else part.text
        for name in references(parse_prose(text)):
            if name not in names:
                said = f'there is no table, figure or chapter "{name[:60]}"{did_you_mean(name, names)}'
                return Entry(part, said=said)
    except KurbelError as error:
        return Entry(part, said=str(error))
    return Entry(part, text)


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


def document_of(manifest: Manifest, chapters: Sequence[PlannedChapter]) -> Document:
    """Return the document with its tables and figures numbered."""
    counts = {"table": 0, "figure": 0}
    made = []
    for number, (plan, entries) in enumerate(chapters, 1):
        above: list[int] = []
        items = tuple(_item(entry, counts, above) for entry in entries)
        made.append(Chapter(plan.title, plan.name, number, items, plan.lang))
    return Document(
        manifest.title, manifest.lang, manifest.decimal, tuple(made), manifest.subtitle, manifest.author
    )


def _item(entry: Entry, counts: dict[str, int], above: list[int]) -> Item:
    from kurbel.documents.markdown import parse_prose
    from kurbel.documents.prose import stepwise

    if not entry.about:
        lang = str(entry.part.options["lang"])
        blocks = _missing(entry, lang) if entry.said else stepwise(parse_prose(entry.text), above)
        # With a name it is what should have been a table or a figure, and references lead to its chapter.
        return Item("text", entry.part.name, lang=lang, blocks=blocks)
    kind, caption, own_lang = entry.about
    counts[kind] += 1
    return Item("table" if kind == "table" else "figure", entry.part.name, counts[kind], own_lang, caption)


def _missing(entry: Entry, lang: str) -> Blocks:
    """Return a text that nobody overlooks in place of what is not there."""
    from kurbel.documents.prose import Paragraph, Quote, Strong, Text

    what = entry.part.shown if entry.part.words else entry.part.file or entry.part.text[:40]
    head = Strong((Text(primed(f"{WORDS[lang]}: {_printable(what)}.")),))
    return (Quote((Paragraph((head, Text(primed(f" {_printable(entry.said)}")))),)),)


def _printable(text: str) -> str:
    """Return a text as one line; what a command has that cannot be printed may be why it failed."""
    return "".join(one if one.isprintable() else "\ufffd" for one in " ".join(text.split()))


def fragment_paths(chapters: Sequence[PlannedChapter], name: str) -> dict[str, str]:
    """Return, by the names of tables and figures, the files that a document of the format is made of."""
    form = FORMATS[name]
    paths = {}
    for entry in (entry for chapter in chapters for entry in chapter.entries if entry.about):
        stem, is_table = entry.part.name, entry.about[0] == "table"
        paths[stem] = f"tables/{stem}{form.suffixes[0]}" if is_table else f"figures/{stem}.{form.figures}"
    return paths


def make_document(task: PageTask) -> Made | str:
    """Return the files of a document, or in a sentence why it cannot be made."""
    from kurbel.formats.documents import document_files
    from kurbel.handbook.pool import deadline

    try:
        with deadline(PATIENCE, GIGABYTES, task.templates is not None):
            files = document_files(task.document, task.format, task.fragments, task.templates)
    except KurbelError as error:
        return str(error)
    return Made({path: text.encode() for path, text in files.items()})


def make_pdf(task: PdfTask) -> Made | str:
    """Return the PDF, or in a sentence why it cannot be made."""
    from kurbel.handbook.pool import deadline

    try:
        # A TeX is a process of its own, with a time of its own: it would outlive this one.
        with deadline(PDF_PATIENCE, None, task.limited and ENGINES[task.engine].grows):
            read = partial(_document_in, task.folder)
            return Made(
                {f"handbook.{PDF}": COMPILED.writer.whole(task.folder, task.engine, task.standards, read)}
            )
    except KurbelError as error:
        return str(error)


def _document_in(folder: str, name: str) -> str:
    return _text_of(os.path.join(folder, name), LARGEST)
