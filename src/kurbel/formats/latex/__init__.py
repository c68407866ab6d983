"""LaTeX."""

from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(
    name="latex",
    rank=30,
    suffixes=(".tex",),
    media=r"LaTeX with booktabs rules, for \input or as a document",
    legible=4,
    takes=("standalone", "longtable", "siunitx", "plain"),
    figures="pdf",
    usual=True,
    marked=True,
)
