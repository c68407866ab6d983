"""A handbook in Markdown: a folder with an index and one page a chapter."""

from __future__ import annotations

import re
from typing import NamedTuple

from kurbel.documents.document import Chapter, Item
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker, DocumentPart

# A # at the end of a heading would be taken for its end.
_LAST_HASHES = re.compile(r"(#+)$")


class MarkdownChapter(NamedTuple):
    """`heading` is the title where it stands behind # signs."""

    title: str
    heading: str
    label: str
    file: str
    parts: tuple[DocumentPart, ...]


class Maker(DocumentMaker):
    def files(self) -> dict[str, str]:
        """Return markdown/index.md and a page for each chapter."""
        document = self.document
        chapters = [self.chapter(chapter) for chapter in document.chapters]
        title = self.titled(document.title)
        common = {
            "words": document.words,
            "title": title,
            "heading": _heading(title),
            "subtitle": self.titled(document.subtitle),
            "author": self.titled(document.author),
            "chapters": chapters,
        }
        pages = {"markdown/index.md": self.filled("index", common)}
        for before, chapter, after in zip((None, *chapters), chapters, (*chapters[1:], None), strict=False):
            values = common | {"chapter": chapter, "before": before, "after": after}
            pages[f"markdown/{chapter.file}"] = self.filled("chapter", values)
        return pages

    def chapter(self, chapter: Chapter) -> MarkdownChapter:
        title = self.titled(chapter.title, chapter.lang)
        file = f"{self.file(chapter)}.md"
        return MarkdownChapter(title, _heading(title), self.label(chapter), file, self.parts(chapter))

    def page(self, chapter: Chapter) -> str:
        return f"{self.file(chapter)}.md#"

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        return part._replace(alt=self.writer.escape(part.alt))


def _heading(title: Label) -> str:
    return _LAST_HASHES.sub(r"\\\1", title)
