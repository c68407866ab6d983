"""Plain text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from kurbel.formats.format import PageFormat

if TYPE_CHECKING:
    from kurbel.documents.document import Document
    from kurbel.formats.printer import ProsePrinter
    from kurbel.page.table import Table


class PlainText(PageFormat):
    name = "text"
    rank = 10
    suffixes = (".txt",)
    media = "plain text for terminals and e-mail"
    legible = 2
    figures = "svg"

    def written(self, table: Table, mark: str, width: int | None) -> str:
        from kurbel.formats.page import page
        from kurbel.formats.text.grid import grid_of, text_page

        if width is not None:
            from kurbel.formats.narrow import narrowed

            table = narrowed(table, lambda parted: grid_of(page(parted, self, mark)).total <= width)
        return text_page(page(table, self, mark), width)

    def printer(self) -> type[ProsePrinter]:
        from kurbel.formats.text.prose import Printer

        return Printer

    def documents(
        self, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> dict[str, str]:
        from kurbel.formats.text.document import files

        return files(document, fragments, templates)


FORMAT = PlainText()
