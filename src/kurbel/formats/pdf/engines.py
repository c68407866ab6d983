"""What sets the PDF of a handbook."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import cast

from kurbel.formats.format import Engine
from kurbel.formats.pdf.by_typst import STANDARDS, Standard, compile_typst, source_date_epoch

_TEX = Engine("latex", (".tex", ".pdf"))
ENGINES: Mapping[str, Engine] = {
    "typst": Engine("typst", (".typ", ".svg"), STANDARDS, grows=True),
    # Its Lua could write anywhere.
    "lualatex": _TEX._replace(obeys=True),
    "latexmk": _TEX,
}


def handbook(folder: str, engine: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
    """Return the PDF of the documents in the folder; raise KurbelError if they cannot be set."""
    if ENGINES[engine].grows:
        return compile_typst(
            read("handbook.typ"), root=folder, standards=cast("Sequence[Standard]", standards)
        )
    from kurbel.formats.pdf.by_tex import compile_tex

    return compile_tex(folder, "handbook", engine, source_date_epoch() or 0)
