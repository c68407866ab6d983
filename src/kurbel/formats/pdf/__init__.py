"""PDF: by Typst or by a TeX."""

from kurbel.formats.registry import CompiledFormat

FORMAT = CompiledFormat(name="pdf", rank=70, suffixes=(".pdf",), media="PDF by Typst, always a document")
