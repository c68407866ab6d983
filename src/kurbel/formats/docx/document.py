"""The handbook as one page in HTML, for pandoc to make a document of Word of it."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping

from kurbel.documents.document import Document, Item
from kurbel.formats.documents import DocumentMaker, DocumentPart
from kurbel.formats.registry import FORMATS, PageFormat


def page_of(document: Document, fragments: Mapping[str, bytes], templates: str | None) -> str:
    """Return the page, of tables in HTML and of drawings by their names."""
    form = FORMATS["html"]
    assert isinstance(form, PageFormat)
    tables = {item.name for item in document.items("table")}
    texts = {
        name: content.decode() if name in tables else f"data:image/png;base64,{b64encode(content).decode()}"
        for name, content in fragments.items()
    }
    return Maker(form, document, texts, templates).files()["word"]


class Maker(DocumentMaker):
    places = True

    def files(self) -> dict[str, str]:
        """Return the page by the name of its template."""
        return {"word": self.filled("word", self.values())}

    def page(self, chapter: object) -> str:
        return "#"

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        return part._replace(text=self.fragments[item.name])
