"""The functions of `import kurbel` about printed tables and what they should be."""

from __future__ import annotations

from collections.abc import Iterable
from os import PathLike

from kurbel.books.verdict import ONLY
from kurbel.errors import ProblemError
from kurbel.page.folders import LANGUAGES
from kurbel.page.layouts import layout_of
from kurbel.page.table import Table
from kurbel.reading.choices import choose
from kurbel.reading.given import as_names


def make_collation_table(
    table: str | None = None,
    *,
    csv: str | PathLike[str] | None = None,
    quantity: str | None = None,
    ratio: str | None = None,
    method: str | None = None,
    only: str = "all",
    sources: str | None = None,
    layout: str = "collation",
    columns: str | Iterable[str] = (),
    lang: str = "de",
    label: str = "",
) -> Table:
    """Return the page of a book's table with its apparatus, as `kurbel collate` prints it.

    `table` is a key of `kurbel sources`, in place of which `csv` is a transcription of one's own, with the
    quantity, the ratio and the method by which it is recomputed. `only` is "all" or "deviations"; `sources`
    is a folder with books of one's own. Raises KurbelError.

    >>> from kurbel import typeset
    >>> page = make_collation_table("blau-32", only="deviations", columns="place,printed,recomputed,verdict")
    >>> print(typeset(page, "csv"), end="")
    place,printed,recomputed,verdict
    x_45,"0,356","0,355",last_place
    """
    from kurbel.books.collate_page import CollateRequest
    from kurbel.books.transcription import collated_table
    from kurbel.page.build import build

    if (table is None) == (csv is None):
        raise ProblemError("give either a table of a book, such as roetscher-112, or your own transcription")
    found, collated = collated_table(table, csv, quantity, ratio, method, sources)
    return build(
        CollateRequest(
            layout=layout_of(layout, ("collation",)),
            table=found,
            collated=collated,
            only=choose(only, ONLY, "choice"),
            lang=choose(lang, LANGUAGES, "language"),
            columns=as_names(columns),
            label=label,
        )
    )
