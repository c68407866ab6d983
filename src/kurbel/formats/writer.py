"""What writes a format: the bases of the `Writer` in each format's folder."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, mark_text
from kurbel.page.table import Table

if TYPE_CHECKING:
    from kurbel.formats.columns import Field
    from kurbel.formats.page import Page

    # Called with the decimal mark, yields the columns of each chunk by their names.
    Chunks = Callable[[str], Iterator[Mapping[str, Field]]]


class RecordsWriter(ABC):
    """Writes records."""

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


class CompiledWriter(ABC):
    """Makes bytes of a document in another format.

    `engines` are, by their names, what can set whole documents; the first does unless another one is named.
    """

    engines: ClassVar[Mapping[str, Engine]]

    @abstractmethod
    def compiled(self, table: Table, decimal: str | None) -> bytes:
        """Return the page as a document."""

    @abstractmethod
    def whole(self, folder: str, engine: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        """Return the handbook whose documents lie in the folder; `read` returns one of them as text."""


class PageWriter:
    """Sets the labels and the pages of a format; what it does not say anew is as in plain text.

    `minus` is the sign of numbers, `missing` stands for a missing value, `delimiters` are those of the
    templates, where braces are not free.
    """

    minus: ClassVar[str] = "−"
    missing: ClassVar[str] = "–"
    delimiters: ClassVar[Mapping[str, Any]] = {}

    def escape(self, prose: str) -> str:
        """Return prose of which every character is printed and none obeyed."""
        return prose

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark with a link to the note of the given name.

        The name is empty for the mark before the note itself.
        """
        return mark_text(mark)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        """Return a formula with a decimal mark, and on wish with fractions of full size."""
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

    def is_tall(self, table: Table) -> bool:
        """Tell whether a table is longer than a page, in a format that breaks."""
        return False

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
