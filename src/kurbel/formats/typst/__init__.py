"""Typst."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="typst",
    rank=50,
    suffixes=(".typ",),
    media="Typst, for #include or as a document",
    legible=5,
    takes=("standalone",),
    figures="svg",
    marked=True,
)
