"""Markdown."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from kurbel.formats.format import PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.documents.inject import Kind
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula


class Markdown(PageFormat):
    name = "markdown"
    rank = 20
    suffixes = (".md",)
    media = "Markdown tables as GitHub and most wikis read them"
    legible = 3
    figures = "svg"
    usual = True
    folder = "markdown"

    def escape(self, prose: str) -> str:
        from kurbel.documents.markdown_it import escaped

        return escaped(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        # An anchor in Markdown is HTML, which many readers drop: there is no link.
        return self.escape(super().note_mark(mark))

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        from kurbel.page.labels import formula_plain

        # Dollar signs are left alone, since many readers of Markdown print them.
        return self.escape(formula_plain(formula, mark))

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        from kurbel.formats.markdown.pipes import pipe_tables

        return {"pipe_tables": pipe_tables}

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.markdown.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.markdown.document import files

        return files(document, fragments, templates)

    def marked(self) -> Kind:
        from kurbel.formats.markdown.marked import KIND

        return KIND


FORMAT = Markdown()
