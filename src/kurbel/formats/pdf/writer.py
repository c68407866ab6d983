"""PDF of one page, and of a handbook."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import cast

from kurbel.formats.pdf import Standard
from kurbel.formats.pdf.by_typst import compile_typst, remarks, typeset_pdf
from kurbel.formats.writer import CompiledWriter
from kurbel.page.table import Table


class Writer(CompiledWriter):
    def compiled(self, table: Table, decimal: str | None) -> bytes:
        return typeset_pdf(table, decimal=decimal)

    def remarks(self, cells: int) -> Iterator[str]:
        return remarks(cells)

    def whole(self, folder: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        kept = cast("Sequence[Standard]", standards)
        return compile_typst(read("handbook.typ"), root=folder, standards=kept)
