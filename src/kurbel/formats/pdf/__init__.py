"""PDF: by Typst or by a TeX."""

from __future__ import annotations

from kurbel.formats.format import CompiledFormat


class Pdf(CompiledFormat):
    name = "pdf"
    rank = 70
    suffixes = (".pdf",)
    media = "PDF by Typst, always a document"


FORMAT = Pdf()
