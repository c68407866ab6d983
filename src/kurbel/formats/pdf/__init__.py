"""PDF by Typst."""

from typing import Literal, get_args

from kurbel.formats.registry import CompiledFormat

Standard = Literal["a-2a", "a-2b", "a-2u", "a-3a", "a-3b", "a-3u", "a-4", "ua-1"]
STANDARDS: tuple[Standard, ...] = get_args(Standard)

FORMAT = CompiledFormat(
    name="pdf",
    rank=70,
    suffixes=(".pdf",),
    media="PDF by Typst, always a document",
    source="typst",
    sources=(".typ", ".svg"),
    standards=STANDARDS,
)
