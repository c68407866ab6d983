"""PDF: by Typst or by a TeX."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from kurbel.formats.format import CompiledFormat, Engine

if TYPE_CHECKING:
    from kurbel.page.table import Table


class Pdf(CompiledFormat):
    name = "pdf"
    rank = 70
    suffixes = (".pdf",)
    media = "PDF by Typst, always a document"

    def compiled(self, table: Table, decimal: str | None) -> bytes:
        from kurbel.formats.pdf.by_typst import typeset_pdf

        return typeset_pdf(table, decimal=decimal)

    def engines(self) -> Mapping[str, Engine]:
        from kurbel.formats.pdf.engines import ENGINES

        return ENGINES

    def whole(self, folder: str, engine: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        from kurbel.formats.pdf.engines import handbook

        return handbook(folder, engine, standards, read)


FORMAT = Pdf()
