"""LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from kurbel.formats.format import PERCENT_DELIMITERS, PLAIN, PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.documents.inject import Kind
    from kurbel.formats.page import Page
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula
    from kurbel.page.table import Table


class Latex(PageFormat):
    name = "latex"
    rank = 30
    suffixes = (".tex",)
    media = r"LaTeX with booktabs rules, for \input or as a document"
    legible = 4
    minus = "$-$"
    missing = "--"
    standalone = True
    breaks = True
    figures = "pdf"
    usual = True
    # It is full of braces and percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        from kurbel.formats.latex.escapes import escape

        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        from kurbel.formats.latex.escapes import note_mark

        return note_mark(mark)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        from kurbel.formats.latex.formula import math

        return math(formula, mark, display)

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        from kurbel.formats.latex.layout import blank_filled

        return {"blank_filled": blank_filled}

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        from kurbel.formats.latex.layout import tex_layout
        from kurbel.formats.page import page

        tex = tex_layout(page(table, PLAIN, mark), ready)
        # A float longer than a page would run out of a document that has nothing else on it.
        return {"tex": tex, "longtable": longtable or (alone and tex.tall)}

    def is_tall(self, table: Table) -> bool:
        from kurbel.formats.latex.layout import tex_layout
        from kurbel.formats.page import page

        return tex_layout(page(table, PLAIN, "."), page(table, self, ".")).tall

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.latex.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.latex.document import files

        return files(document, fragments, templates)

    def marked(self) -> Kind:
        from kurbel.formats.latex.marked import KIND

        return KIND


FORMAT = Latex()
