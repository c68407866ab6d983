"""What writes a format: the bases of the `Writer` in each format's folder."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple

from kurbel.exact.numerals import Label
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, mark_text, set_label
from kurbel.page.table import Table

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.formats.columns import Field
    from kurbel.formats.page import Page
    from kurbel.formats.sheet import Workbook

# Called with the decimal mark, yields the columns of each chunk by their names.
Chunks = Callable[[str], Iterator[Mapping[str, "Field"]]]


class RecordsWriter(ABC):
    """Writes records."""

    delimiters: ClassVar[Mapping[str, Any]] = {}

    @abstractmethod
    def rows(self, table: Table, decimal: str, folders: Sequence[str] = ()) -> Iterator[str]:
        """Yield the records in pieces; `decimal` is "comma" or "point", `folders` a user's with templates."""

    def filters(self) -> Mapping[str, Callable[..., object]]:
        """Return the filters of its template, if it has one."""
        return {}

    @abstractmethod
    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        """Yield records that come as whole columns, of these names; the table has none of its own."""


class CompiledWriter(ABC):
    """Makes bytes of a document in another format."""

    @abstractmethod
    def compiled(self, table: Table, decimal: str | None) -> bytes:
        """Return the page as a document."""

    @abstractmethod
    def remarks(self, cells: int, tables: int = 1) -> Iterator[str]:
        """Yield what is to be known, before it is made, of a document of so many cells and tables."""

    @abstractmethod
    def whole(self, folder: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        """Return the handbook whose documents lie in the folder; `read` returns one of them as text."""


class WorkbookWriter(ABC):
    """Writes workbooks."""

    @abstractmethod
    def written(self, book: Workbook) -> bytes:
        """Return the workbook as a file."""


class DocumentWriter(ABC):
    """Writes documents of an office."""

    @abstractmethod
    def written(self, table: Table, decimal: str | None) -> bytes:
        """Return the page as a document."""

    @abstractmethod
    def kept(self, table: Table, decimal: str | None, templates: str | None = None) -> str:
        """Return the page as it waits for a handbook."""

    @abstractmethod
    def whole(self, document: Document, fragments: Mapping[str, bytes], templates: str | None) -> bytes:
        """Return a handbook, of the pages that waited and of drawings."""


Place = Literal["", "document", "step", "handbook"]


class WriteOptions(NamedTuple):
    """How a page is to be written beside its decimal mark: whether it may break over pages, has numbers as
    they are typed, for siunitx, and is `plain` as an author writes it; on a terminal no wider than `width`
    characters, and in `colours`. `place` says where it stands: in a document of its author's, in one of ours,
    in an author's as one step of many, or in a handbook, below its number."""

    longtable: bool = False
    siunitx: bool = False
    plain: bool = False
    width: int | None = None
    colours: bool = False
    place: Place = ""


class PageWriter:
    """Sets the labels and the pages of a format; what it does not say anew is as in plain text.

    `minus` is the sign of numbers, `missing` stands for a missing value, `delimiters` are those of the
    templates, where braces are not free. Where tables are `linked`, they have the names of their variants.
    """

    minus: ClassVar[str] = "−"
    missing: ClassVar[str] = "–"
    linked: ClassVar[bool] = True
    delimiters: ClassVar[Mapping[str, Any]] = {}

    def escape(self, prose: str) -> str:
        """Return prose of which every character is printed and none obeyed."""
        return prose

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark with a link to the note of the given name.

        The name is empty for the mark before the note itself.
        """
        return mark_text(mark)

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        """Return a formula with a decimal mark, and on wish with fractions of full size."""
        # No line end may cut it.
        return formula_plain(formula, mark).replace(" ", "\u00a0")

    def finish(self, label: str) -> str:
        """Return a label of which all parts are set."""
        return label

    def label(
        self, label: Label, mark: str, display: bool = False, noted: Callable[[str], str] = lambda note: ""
    ) -> str:
        """Return a label with a decimal mark; `noted` returns the marks of notes in it."""
        return self.finish(
            set_label(label, self.escape, lambda formula: self.formula(formula, mark, display), noted)
        )

    def filters(self) -> Mapping[str, Callable[..., object]]:
        """Return the filters of its templates."""
        return {}

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        """Return what its templates read beside the page, or in its place."""
        return {}

    def stepped(
        self, table: Table, fragment: str, page: Callable[[Table], str], mark: str, place: Place
    ) -> dict[str, object]:
        """Return what the template of an interactive page reads, of the page that is shown first and of what
        sets the others, in a format that has such pages."""
        return {"fragment": fragment}

    def is_tall(self, table: Table) -> bool:
        """Tell whether a table is longer than a page, in a format that breaks."""
        return False

    def remarks(self, table: Table) -> Iterator[str]:
        """Yield what else its author should know of a table."""
        yield from ()

    def drawing(self, svg: str, name: str, title: str) -> str:
        """Return an SVG file as it stands in an author's own document, where the format draws.

        `name` begins its ids, `title` is for those who do not see it.
        """
        return svg


# Its labels are what estimates of widths measure.
PLAIN = PageWriter()
# For templates whose text is full of braces.
PERCENT_DELIMITERS: Mapping[str, str] = {
    "block_start_string": "<%",
    "block_end_string": "%>",
    "variable_start_string": "<<",
    "variable_end_string": ">>",
    "comment_start_string": "<#",
    "comment_end_string": "#>",
}
