"""What a format is: a few facts and functions, which the folder of the format states.

Cheap to import: the help text and shell completion read it. What a function needs, it imports itself.
"""

from __future__ import annotations

import os
import sys
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple

from kurbel.errors import ChoiceError
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.documents.inject import Kind
    from kurbel.formats.columns import Field
    from kurbel.formats.page import Page
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula
    from kurbel.page.table import Table

    # Called with the decimal mark, yields the columns of each chunk by their names.
    Chunks = Callable[[str], Iterator[Mapping[str, Field]]]


class Format:
    """What all formats have.

    `rank` is its place where formats are listed, `media` what it is in a few words. `decimal` is "language"
    or "point": where the decimal mark comes from unless the user sets it. `usual` formats are built by a
    handbook that names none. Of several, the `legible` one of the lowest number, from 1, shows a reader best
    what changed. What only pages have is empty here: see `PageFormat`.
    """

    name: ClassVar[str] = ""
    rank: ClassVar[int] = 0
    suffixes: ClassVar[tuple[str, ...]] = ()
    media: ClassVar[str] = ""
    kind: ClassVar[Literal["page", "records", "compiled"]]
    decimal: ClassVar[Literal["language", "point"]] = "language"
    usual: ClassVar[bool] = False
    legible: ClassVar[int] = 0
    standalone: ClassVar[bool] = False
    breaks: ClassVar[bool] = False
    figures: ClassVar[str] = ""
    folder: ClassVar[str] = ""

    def decimal_name(self, lang: str, decimal: str | None = None) -> str:
        """Return "comma" or "point": what the user asks for, else the rule of the format."""
        if decimal is not None:
            if decimal not in DECIMALS:
                raise ChoiceError(f"decimal mark is {decimal!r}; it must be {' or '.join(DECIMALS)}")
            return decimal
        return DECIMAL_OF_LANGUAGE.get(lang, "point") if self.decimal == "language" else "point"

    def decimal_mark(self, lang: str, decimal: str | None = None) -> str:
        """Return the character "," or "."."""
        return DECIMALS[self.decimal_name(lang, decimal)]

    def is_tall(self, table: Table) -> bool:
        """Tell whether a table is longer than a page and must be told to break."""
        return False


class RecordsFormat(Format, ABC):
    """A format of records, which need not fit in memory."""

    kind = "records"
    decimal = "point"

    @abstractmethod
    def rows(self, table: Table, decimal: str) -> Iterator[str]:
        """Yield the records in pieces; `decimal` is "comma" or "point"."""

    @abstractmethod
    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        """Yield records that come as whole columns, of these names; the table has none of its own."""


class Engine(NamedTuple):
    """What sets a whole document as bytes: of that in which format, and from files with these suffixes.

    `standards` are those that it can keep. One that `grows` takes the memory of whoever calls it, where
    others are processes of their own. One that `obeys` runs what a template may have written.
    """

    source: str
    suffixes: tuple[str, ...]
    standards: tuple[str, ...] = ()
    grows: bool = False
    obeys: bool = False


class CompiledFormat(Format, ABC):
    """A format of bytes, made of the document in another format."""

    kind = "compiled"

    @abstractmethod
    def compiled(self, table: Table, decimal: str | None) -> bytes:
        """Return the page as a document."""

    @abstractmethod
    def engines(self) -> Mapping[str, Engine]:
        """Return by their names what can set whole documents; the first does unless another one is named."""

    @abstractmethod
    def whole(self, folder: str, engine: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        """Return the handbook whose documents lie in the folder; `read` returns one of them as text."""


class PageFormat(Format):
    """A format of pages, whose labels are plain text unless it says otherwise.

    `standalone` tells that a whole page differs from a fragment, `breaks` that a table longer than a page can
    be told to break. A format of whole documents has their `figures` as files of that suffix, and a `folder`
    if a document is many files. An author's own documents can have
    drawings if it `draws`. `delimiters` are those of its templates, where braces are not free.
    """

    kind = "page"
    minus: ClassVar[str] = "−"
    missing: ClassVar[str] = "–"
    draws: ClassVar[bool] = False
    delimiters: ClassVar[Mapping[str, Any]] = {}

    @property
    def templates(self) -> str:
        """The folder of the format's templates."""
        return os.path.join(os.path.dirname(str(sys.modules[type(self).__module__].__file__)), "templates")

    def escape(self, prose: str) -> str:
        """Return prose of which every character is printed and none obeyed."""
        return prose

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark with a link to the note of the given name.

        The name is empty for the mark before the note itself.
        """
        from kurbel.page.labels import mark_text

        return mark_text(mark)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        """Return a formula with a decimal mark, and on wish with fractions of full size."""
        from kurbel.page.labels import formula_plain

        # No line end may cut it.
        return formula_plain(formula, mark).replace(" ", "\u00a0")

    def finish(self, label: str) -> str:
        """Return a label of which all parts are set."""
        return label

    def written(self, table: Table, mark: str, width: int | None) -> str | None:
        """Return the page if it needs no template, no wider than `width` characters where that is given."""
        return None

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        """Return the filters of its templates."""
        return {}

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        """Return what its templates read beside the page, which is `alone` in its document or not."""
        return {}

    def printer(self) -> type[ProsePrinter]:
        """Return what sets free text."""
        raise ChoiceError(f"{self.name} has no whole documents, and no texts in them")

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        """Return the whole documents as texts by their paths in the output folder.

        `fragments` has each table by its name, rendered in the format, and each figure that is a text;
        `templates` is a folder of the user's own templates.
        """
        raise ChoiceError(f"{self.name} has no whole documents")

    def marked(self) -> Kind | None:
        """Return how tables are marked in an author's own document, if they can be."""
        return None

    def drawing(self, svg: str, name: str, title: str) -> str:
        """Return an SVG file as it stands in an author's own document, where the format `draws`.

        `name` begins its ids, `title` is for those who do not see it.
        """
        return svg


# For templates whose text is full of braces.
PERCENT_DELIMITERS: Mapping[str, str] = {
    "block_start_string": "<%",
    "block_end_string": "%>",
    "variable_start_string": "<<",
    "variable_end_string": ">>",
    "comment_start_string": "<#",
    "comment_end_string": "#>",
}
# Its labels are what estimates of widths measure.
PLAIN = PageFormat()
