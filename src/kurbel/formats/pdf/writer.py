"""PDF of one page, and of a handbook."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar, cast

from kurbel.formats.pdf.by_typst import (
    STANDARDS,
    Standard,
    compile_typst,
    source_date_epoch,
    typeset_pdf,
)
from kurbel.formats.writer import CompiledWriter, Engine
from kurbel.page.table import Table

_TEX = Engine("latex", (".tex", ".pdf"))


class Writer(CompiledWriter):
    engines: ClassVar[Mapping[str, Engine]] = {
        "typst": Engine("typst", (".typ", ".svg"), STANDARDS, grows=True),
        # Its Lua could write anywhere.
        "lualatex": _TEX._replace(obeys=True),
        "latexmk": _TEX,
    }

    def compiled(self, table: Table, decimal: str | None) -> bytes:
        return typeset_pdf(table, decimal=decimal)

    def whole(self, folder: str, engine: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        if self.engines[engine].grows:
            kept = cast("Sequence[Standard]", standards)
            return compile_typst(read("handbook.typ"), root=folder, standards=kept)
        from kurbel.formats.pdf.by_tex import compile_tex

        return compile_tex(folder, "handbook", engine, source_date_epoch() or 0)
