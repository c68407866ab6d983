"""Markdown."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="markdown",
    rank=20,
    suffixes=(".md",),
    media="Markdown tables as GitHub and most wikis read them",
    legible=3,
    figures="svg",
    usual=True,
    folder="markdown",
    marked=True,
)
