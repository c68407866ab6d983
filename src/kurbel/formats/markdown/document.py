"""A handbook in Markdown: a folder with an index and one page a chapter."""

from __future__ import annotations

import re

from kurbel.documents.document import Chapter, Item
from kurbel.formats.documents import DocumentMaker, DocumentPart

# A # at the end of a heading would be taken for its end.
_LAST_HASHES = re.compile(r"(#+)$")


class Maker(DocumentMaker):
    def files(self) -> dict[str, str]:
        """Return markdown/index.md and a page for each chapter."""
        values = self.values()
        values["heading"] = self.heading(values["title"])
        pages = {"markdown/index.md": self.filled("index", values)}
        chapters = values["chapters"]
        for before, chapter, after in zip((None, *chapters), chapters, (*chapters[1:], None), strict=False):
            places = {"chapter": chapter, "before": before, "after": after}
            pages[f"markdown/{chapter.file}"] = self.filled("chapter", values | places)
        return pages

    def heading(self, title: str) -> str:
        return _LAST_HASHES.sub(r"\\\1", title)

    def file(self, chapter: Chapter) -> str:
        return f"{super().file(chapter)}.md"

    def page(self, chapter: Chapter) -> str:
        return f"{self.file(chapter)}#"

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        return part._replace(alt=self.writer.escape(part.alt))
