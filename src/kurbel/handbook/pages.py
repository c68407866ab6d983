"""What a build of a handbook is about: the parts and what they became, and the documents made of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Literal, NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.errors import HandbookError, KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.folder import LARGEST
from kurbel.handbook.manifest import ChapterPlan, Manifest, Part
from kurbel.handbook.model import COMPILED, ENGINES
from kurbel.page.labels import primed
from kurbel.reading.given import did_you_mean

if TYPE_CHECKING:
    from kurbel.documents.prose import Blocks

PDF = COMPILED.name
KILLED = "its process was ended, for want of memory or from outside"
# Templates of one's own have so many seconds for a page, and so much memory.
PATIENCE, GIGABYTES = 10.0, 4
STOPPED = f"its templates were stopped after {PATIENCE:.0f} s, or at {GIGABYTES} gigabytes"
# A document that they wrote has so many to be set by Typst; a TeX is stopped by itself.
PDF_PATIENCE = 300.0
PDF_STOPPED = f"Typst was stopped after {PDF_PATIENCE:.0f} s"
WORDS = {"de": "Fehlt", "en": "Missing"}


class Task(NamedTuple):
    """A part that is to be made, with all that a process of its own needs to make it.

    Templates of one's own have `patience` in seconds.
    """

    part: Part
    folder: str
    machine: str | None
    templates: str | None
    formats: tuple[str, ...]
    figures: tuple[str, ...]
    patience: float


class Made(NamedTuple):
    """What a part or a document became: its files by their paths in the output folder.

    `inputs` are the files that it was made of, `about` what documents say of a table or figure: its kind,
    caption and language.
    """

    files: Mapping[str, bytes]
    inputs: tuple[str, ...] = ()
    about: tuple[Literal["table", "figure"], str, str] | tuple[()] = ()


# Makes a part, or says in a sentence why it cannot be made.
Maker = Callable[[Task], Made | str]


class Failure(NamedTuple):
    """A part or a document that could not be made."""

    line: int
    name: str
    said: str


@dataclass
class Built:
    """What a build did, file by file, and what failed."""

    written: list[str] = field(default_factory=list)
    unchanged: list[str] = field(default_factory=list)
    removed: list[str] = field(default_factory=list)
    failures: list[Failure] = field(default_factory=list)


def formats_of(manifest: Manifest) -> tuple[str, ...]:
    """Return the formats of the tables: a PDF brings along what it is set from."""
    wanted = manifest.formats
    if PDF in wanted:
        wanted = (*wanted, ENGINES[manifest.engine].source)
    return tuple(name for name in FORMATS if name in wanted and name != PDF)


def task_of(manifest: Manifest, part: Part) -> Task:
    """Return what makes the part."""
    formats = formats_of(manifest)
    # What documents are made of beside their own format.
    figures = tuple(sorted({FORMATS[name].figures for name in formats} - {""}))
    return Task(part, manifest.folder, manifest.machine, manifest.templates, formats, figures, PATIENCE)


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
