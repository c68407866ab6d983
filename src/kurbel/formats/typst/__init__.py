"""Typst."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from kurbel.formats.format import PERCENT_DELIMITERS, PLAIN, PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.documents.inject import Kind
    from kurbel.formats.page import Page
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula
    from kurbel.page.table import Table


class Typst(PageFormat):
    name = "typst"
    rank = 50
    suffixes = (".typ",)
    media = "Typst, for #include or as a document"
    legible = 5
    standalone = True
    figures = "svg"
    # It has hash signs, braces and dollar signs, but no percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        from kurbel.formats.typst.escapes import escape

        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        from kurbel.formats.typst.escapes import note_mark

        return note_mark(mark)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        from kurbel.formats.typst.formula import equation

        return equation(formula, mark, display)

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        from kurbel.formats.page import page
        from kurbel.formats.typst.rows import typst_layout

        return {"typst": typst_layout(page(table, PLAIN, mark), ready)}

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.typst.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.typst.document import files

        return files(document, fragments, templates)

    def marked(self) -> Kind:
        from kurbel.formats.typst.marked import KIND

        return KIND


FORMAT = Typst()
