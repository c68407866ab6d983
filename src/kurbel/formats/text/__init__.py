"""Plain text."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="text",
    rank=10,
    suffixes=(".txt",),
    media="plain text for terminals and e-mail",
    legible=2,
    figures="svg",
)
