"""reStructuredText, as Sphinx and docutils read it."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="rst",
    rank=60,
    suffixes=(".rst",),
    media="reStructuredText grid tables, for Sphinx",
    legible=4,
    figures="svg",
    folder="rst",
)
