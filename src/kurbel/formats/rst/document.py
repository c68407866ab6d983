"""A handbook in reStructuredText: a project of Sphinx with an index and one page a chapter."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kurbel.documents.document import Chapter, Item
from kurbel.documents.prose import Block, Heading, stepwise
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker, DocumentPart
from kurbel.formats.rst.prose import underlined
from kurbel.formats.rst.writer import finish

_CAPTION = re.compile(r"^\.\. table::", re.MULTILINE)


class Maker(DocumentMaker):
    def files(self) -> dict[str, str]:
        """Return rst/index.rst, a page for each chapter, and what Sphinx reads: conf.py and a style sheet."""
        document, values = self.document, self.values()
        values |= {
            "heading": self.heading(values["title"]),
            "project": repr(self.plain(document.title)),
            "by": repr(self.plain(document.author)),
        }
        names = {"index.rst": "index", "conf.py": "conf", "kurbel.css": "style"}
        pages = {f"rst/{file}": self.filled(name, values) for file, name in names.items()}
        for chapter in values["chapters"]:
            pages[f"rst/{chapter.file}.rst"] = self.filled("chapter", values | {"chapter": chapter})
        return pages

    def heading(self, title: str) -> str:
        return underlined(title, 1)

    def parts(self, chapter: Chapter) -> tuple[DocumentPart, ...]:
        above: list[int] = []
        items = (item._replace(blocks=tuple(_as_sections(item.blocks, above))) for item in chapter.items)
        return super().parts(chapter._replace(items=tuple(items)))

    def titled(self, label: Label, lang: str = "") -> str:
        # A line that begins with a blank would be a quotation.
        return finish(super().titled(label, lang)).strip(" ")

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        text = _CAPTION.sub(f".. table:: {part.number}.", part.text, count=1)
        return part._replace(alt=" ".join(part.alt.split()), text=text)


def _as_sections(blocks: Sequence[Block], above: list[int]) -> Iterator[Block]:
    """Yield the blocks with the levels of headings anew: those in lists and quotations are no sections."""
    for block in blocks:
        yield from stepwise((block,), above) if isinstance(block, Heading) else (block,)
