"""PDF: by Typst or by a TeX."""

from typing import Literal, get_args

from kurbel.formats.registry import CompiledFormat, Engine

Standard = Literal["a-2a", "a-2b", "a-2u", "a-3a", "a-3b", "a-3u", "a-4", "ua-1"]
STANDARDS: tuple[Standard, ...] = get_args(Standard)
_TEX = Engine("latex", (".tex", ".pdf"))

FORMAT = CompiledFormat(
    name="pdf",
    rank=70,
    suffixes=(".pdf",),
    media="PDF by Typst, always a document",
    engines={
        "typst": Engine("typst", (".typ", ".svg"), STANDARDS, grows=True),
        # Its Lua could write anywhere.
        "lualatex": _TEX._replace(obeys=True),
        "latexmk": _TEX,
    },
)
