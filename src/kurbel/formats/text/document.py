"""A handbook in plain text: one file to read from the top to the end."""

from __future__ import annotations

from typing import NamedTuple

from kurbel.documents.document import Chapter, Item
from kurbel.formats.documents import DocumentMaker, DocumentPart
from kurbel.formats.text.writer import wrapped

# As wide as texts are.
WIDTH = 78
CHAPTER, TITLE = "━", "═"


class TextPart(NamedTuple):
    """A table or a figure with its number, and as it stands in the contents."""

    kind: str
    name: str
    number: str
    entry: str
    text: str


class TextChapter(NamedTuple):
    """`heading` is the title with its line, `entry` how it stands in the contents."""

    heading: str
    entry: str
    parts: tuple[TextPart | DocumentPart, ...]


class Maker(DocumentMaker):
    level = 2

    def files(self) -> dict[str, str]:
        """Return handbook.txt, which has the tables in it and names the files of the figures."""
        values = self.values()
        values["title"] = _underlined(values["title"], TITLE)
        return {"handbook.txt": self.filled("handbook", values)}

    def chapter(self, chapter: Chapter) -> TextChapter:
        title = self.titled(chapter.title, chapter.lang)
        if chapter.number:
            title = f"{chapter.number}  {title}"
        return TextChapter(_underlined(title, CHAPTER), wrapped(title, WIDTH, 3), self.parts(chapter))

    def part(self, item: Item) -> TextPart:
        number, caption = self.number(item), self.titled(item.caption, item.lang)
        entry = wrapped(f"    {number}. {caption}", WIDTH, 8)
        content = (
            self.fragments[item.name] if item.kind == "table" else wrapped(f"{number}. {caption}", WIDTH)
        )
        return TextPart(item.kind, item.name, number, entry, content)


def _underlined(title: str, line: str) -> str:
    lines = wrapped(title, WIDTH).split("\n")
    return "\n".join((*lines, f" {line * (max(map(len, lines)) - 1)}"))
