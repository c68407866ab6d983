"""reStructuredText, as Sphinx and docutils read it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from kurbel.formats.format import PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.formats.page import Page
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula
    from kurbel.page.table import Table


class ReStructuredText(PageFormat):
    name = "rst"
    rank = 60
    suffixes = (".rst",)
    media = "reStructuredText grid tables, for Sphinx"
    legible = 4
    figures = "svg"
    folder = "rst"

    def escape(self, prose: str) -> str:
        from kurbel.formats.rst.escapes import escape

        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        from kurbel.formats.rst.escapes import note_mark

        return note_mark(mark)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        from kurbel.formats.rst.formula import math

        return math(formula, mark, display)

    def finish(self, label: str) -> str:
        from kurbel.formats.rst.escapes import finish

        return finish(label)

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        from kurbel.formats.rst.escapes import finish
        from kurbel.formats.rst.grid import grid_table, left_columns

        return {"finish": finish, "grid_table": grid_table, "left_columns": left_columns}

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        # The value of an option is no prose.
        return {"name": table.key}

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.rst.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.rst.document import files

        return files(document, fragments, templates)


FORMAT = ReStructuredText()
