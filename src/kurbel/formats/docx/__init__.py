"""Documents of Word, by pandoc."""

from kurbel.formats.registry import DocumentFormat

FORMAT = DocumentFormat(
    name="docx",
    rank=72,
    suffixes=(".docx",),
    media="a document of Word, by pandoc",
    figures="png",
)
