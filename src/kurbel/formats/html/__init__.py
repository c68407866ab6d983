"""HTML with MathML."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from kurbel.formats.format import PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.documents.inject import Kind
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.formula import Formula


class Html(PageFormat):
    name = "html"
    rank = 40
    suffixes = (".html", ".htm")
    media = "HTML with MathML, for a page or as a page"
    legible = 6
    standalone = True
    figures = "svg"
    usual = True
    draws = True

    def escape(self, prose: str) -> str:
        from kurbel.formats.html.escapes import escape

        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        from kurbel.formats.html.escapes import note_mark

        return note_mark(mark, target)

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        from kurbel.formats.html.formula import mathml

        return mathml(formula, mark, display)

    def finish(self, label: str) -> str:
        from kurbel.formats.html.escapes import finish

        return finish(label)

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.html.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.html.document import files

        return files(document, fragments, templates)

    def drawing(self, svg: str, name: str, title: str) -> str:
        from kurbel.formats.html.svg import inline

        return inline(svg, name, title, own_page=False)

    def marked(self) -> Kind:
        from kurbel.formats.html.marked import KIND

        return KIND


FORMAT = Html()
