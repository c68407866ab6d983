"""HTML with MathML."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="html",
    rank=40,
    suffixes=(".html", ".htm"),
    media="HTML with MathML, for a page or as a page",
    legible=6,
    takes=("standalone", "interactive"),
    figures="svg",
    usual=True,
    own_pages=True,
    marked=True,
    draws=True,
)
