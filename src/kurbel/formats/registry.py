"""The registry of output formats: the folders beside this file, each with its `FORMAT`.

A `FORMAT` states facts and is cheap to import: the help text and shell completion read it. How the format is
written stands in other modules of its folder: see `Format.module`.
"""

from __future__ import annotations

import os
from abc import abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, ClassVar, Literal

import kurbel.formats
from kurbel.errors import ChoiceError, FormatError
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS
from kurbel.reading.given import allowed_name, choose

if TYPE_CHECKING:
    from types import ModuleType

    from kurbel.documents.inject import Kind
    from kurbel.formats.writer import (
        CompiledWriter,
        DocumentWriter,
        PageWriter,
        RecordsWriter,
        WorkbookWriter,
    )
    from kurbel.page.table import Table

# What is printed where nobody asks for a format.
DEFAULT = "text"
# What a page is drawn as: each is its own suffix. DRAWN leaves it to the suffix, of what is a page, too.
DRAWINGS = ("svg", "png", "pgf", "gif")
DRAWN = "drawing"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Format:
    """What all formats state.

    `rank` is its place where formats are listed, `media` what it is in a few words. `decimal` is "language"
    or "point": where the decimal mark comes from unless the user sets it. `usual` formats are built by a
    handbook that names none. Of several, the `legible` one of the lowest number, from 1, shows a reader best
    what changed. `takes` are the options that are not for all formats. One of whole documents has their
    `figures` as files of that suffix.
    """

    kind: ClassVar[Literal["page", "records", "compiled", "workbook", "document"]]
    name: str
    rank: int
    suffixes: tuple[str, ...]
    media: str
    decimal: Literal["language", "point"] = "language"
    usual: bool = False
    legible: int = 0
    takes: tuple[str, ...] = ()
    figures: str = ""

    def decimal_name(self, lang: str, decimal: str | None = None) -> str:
        """Return "comma" or "point": what the user asks for, else the rule of the format."""
        if decimal is not None:
            return choose(decimal, DECIMALS, "decimal mark")
        return DECIMAL_OF_LANGUAGE.get(lang, "point") if self.decimal == "language" else "point"

    def decimal_mark(self, lang: str, decimal: str | None = None) -> str:
        """Return the character "," or "."."""
        return DECIMALS[self.decimal_name(lang, decimal)]

    def is_tall(self, table: Table) -> bool:
        """Tell whether a table is longer than a page and must be told to break."""
        return False

    def remarks(self, table: Table, breaks: bool) -> Iterator[str]:
        """Yield what its author should know of a table in the format, which may break over pages or not."""
        yield from ()

    @property
    def home(self) -> str:
        """The format's folder, where its templates stand in `base` if not among those of pages."""
        return os.path.dirname(str(self.module().__file__))

    def module(self, name: str = "") -> ModuleType:
        """Return a module of the format's folder.

        `writer` has a `Writer` of tables; where there are `figures`, `document` has a `Maker` of whole
        documents and a `Printer` of their free text; where an author's documents are `marked`, their `KIND`.
        """
        return import_module(f"kurbel.formats.{self.name}.{name}".rstrip("."))


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RecordsFormat(Format):
    """A format of records, which need not fit in memory. One that Excel opens has a `variant` for it."""

    kind = "records"
    variant: str = "Writer"

    @property
    def writer(self) -> RecordsWriter:
        writer: RecordsWriter = getattr(self.module("writer"), self.variant)()
        return writer

    @property
    def for_excel(self) -> RecordsFormat:
        """The same as Excel opens it, in the language of the table."""
        return replace(self, variant="ForExcel", decimal="language") if "excel" in self.takes else self


class BytesFormat(Format):
    """A format that is bytes and no text: a file, always a whole document."""

    # What is said where it is asked for as a text.
    no_text: ClassVar[str]

    @abstractmethod
    def content(self, table: Table, decimal: str | None) -> bytes:
        """Return the page as a file."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class CompiledFormat(BytesFormat):
    """A format of bytes, made of the document in another format, the `source`, and of files with the suffixes
    `sources`; it can keep the `standards`."""

    kind = "compiled"
    source: str
    sources: tuple[str, ...]
    standards: tuple[str, ...] = ()
    no_text = "a {name} is bytes and no text; make it with kurbel.typeset_{name}"

    @property
    def writer(self) -> CompiledWriter:
        writer: CompiledWriter = self.module("writer").Writer()
        return writer

    def content(self, table: Table, decimal: str | None) -> bytes:
        return self.writer.compiled(table, decimal)

    def remarks(self, table: Table, breaks: bool) -> Iterator[str]:
        rows = (row for panel in table.panels for row in panel.rows())
        yield from self.writer.remarks(sum(len(row.stub) + len(row.cells) for row in rows))


class WorkbookFormat(BytesFormat):
    """A format of spreadsheets: a workbook of sheets."""

    kind = "workbook"
    no_text = (
        "a workbook is bytes and no text; write it with the method save of a table: save('table.{name}')"
    )

    @property
    def writer(self) -> WorkbookWriter:
        writer: WorkbookWriter = self.module("writer").Writer()
        return writer

    def content(self, table: Table, decimal: str | None) -> bytes:
        from kurbel.formats.workbook import table_workbook

        return self.writer.written(table_workbook(table, self.decimal_name(table.lang, decimal)))

    def remarks(self, table: Table, breaks: bool) -> Iterator[str]:
        from kurbel.formats.workbook import remarks

        yield from remarks(table)


class DocumentFormat(BytesFormat):
    """A format of an office's documents: pages, and whole handbooks of them."""

    kind = "document"
    no_text = "a {name} is bytes and no text; write it with the method save of a table: save('table.{name}')"

    @property
    def writer(self) -> DocumentWriter:
        writer: DocumentWriter = self.module("writer").Writer()
        return writer

    def content(self, table: Table, decimal: str | None) -> bytes:
        return self.writer.written(table, decimal)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PageFormat(Format):
    """A format of pages.

    One of whole documents has a `folder` if a document is many files, and `own_pages` if its tables are not
    those of an author's document. Such documents can be `marked` with places for tables, and have drawings
    there if the format `draws`.
    """

    kind = "page"
    folder: str = ""
    own_pages: bool = False
    marked: bool = False
    draws: bool = False

    @property
    def writer(self) -> PageWriter:
        writer: PageWriter = self.module("writer").Writer()
        return writer

    def is_tall(self, table: Table) -> bool:
        return "longtable" in self.takes and self.writer.is_tall(table)

    def remarks(self, table: Table, breaks: bool) -> Iterator[str]:
        if not breaks and self.is_tall(table):
            yield "the table is longer than a page; it is set in parts, with --longtable where it stands"
        if "longtable" in self.takes:
            yield from self.writer.remarks(table)


class _Formats(Mapping[str, Format]):
    """The formats by their names, in their order; asked for by name, only its own folder is read. What no
    format can be made of raises FormatError.

    A folder elsewhere joins them once its parent is on `kurbel.formats.__path__`.
    """

    def __getitem__(self, name: str) -> Format:
        if name not in _folders(*kurbel.formats.__path__):
            raise KeyError(name)
        try:
            form = import_module(f"kurbel.formats.{name}").FORMAT
        except Exception as error:
            said = " ".join(f"{type(error).__name__}: {error}".split())[:300]
            raise FormatError(f"the format folder {name} cannot be read: {said}") from error
        if not isinstance(form, Format) or form.name != name:
            found = getattr(form, "name", form)
            raise FormatError(f"FORMAT in the format folder {name} is {found!r}; its name must be {name!r}")
        return form

    def __iter__(self) -> Iterator[str]:
        return iter(_in_order(*kurbel.formats.__path__))

    def __len__(self) -> int:
        return len(_folders(*kurbel.formats.__path__))


@cache
def _folders(*path: str) -> frozenset[str]:
    return frozenset(
        entry.name
        for place in path
        for entry in os.scandir(place)
        if os.path.exists(f"{entry.path}/__init__.py")
    )


@cache
def _in_order(*path: str) -> tuple[str, ...]:
    return tuple(sorted(_folders(*path), key=lambda name: FORMATS[name].rank))


FORMATS: Mapping[str, Format] = _Formats()


def format_names() -> tuple[str, ...]:
    """Return the names of all formats, those of drawings last."""
    return (*FORMATS, *DRAWINGS, DRAWN)


def by_name(name: str) -> Format:
    """Return the format of that name, by any word for it; raise ChoiceError if there is none."""
    # To ask for all names would load all formats.
    return FORMATS[name if name in FORMATS else allowed_name(name, FORMATS, "format")]


def compiled_format() -> CompiledFormat:
    """Return the format of bytes in which handbooks are set."""
    return next(form for form in FORMATS.values() if isinstance(form, CompiledFormat))


def for_suffix(path: str) -> Format:
    """Return the format that a file name asks for; raise ChoiceError if its suffix belongs to none."""
    suffix = os.path.splitext(path)[1].lower()
    for entry in FORMATS.values():
        if suffix in entry.suffixes:
            return entry
    drawings = (f".{name}" for name in DRAWINGS)
    known = ", ".join((*(one for entry in FORMATS.values() for one in entry.suffixes), *drawings))
    word = "; Word opens .docx" if suffix == ".doc" else ""
    raise ChoiceError(f"the file name {str(path)!r} names no format; its suffix must be one of {known}{word}")


def kinds() -> list[tuple[PageFormat, Kind]]:
    """Return the formats whose documents can have marked places; those whose comments have an end first."""
    marked = [form for form in FORMATS.values() if isinstance(form, PageFormat) and form.marked]
    found: list[tuple[PageFormat, Kind]] = [(form, form.module("document").KIND) for form in marked]
    return sorted(found, key=lambda one: not one[1].right)


def kind_of(path: str) -> tuple[PageFormat, Kind]:
    """Return the format of a document with marked places, and its kind, by the suffix of its name."""
    suffix = os.path.splitext(path)[1].lower()
    for form, kind in kinds():
        if suffix in kind.suffixes:
            return form, kind
    known = ", ".join(suffix for _, kind in kinds() for suffix in kind.suffixes)
    raise ChoiceError(
        f'the name "{path[-60:]}" tells no kind of document with markers; its suffix must be one of {known}'
    )
