"""A handbook in Typst: one source that includes the tables and draws in the figures beside it."""

from __future__ import annotations

import re
from typing import NamedTuple

from kurbel.documents.document import WORDS, Chapter, Item
from kurbel.documents.prose import Index
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentChapter, DocumentMaker, DocumentTitle
from kurbel.formats.typst.layout import paper
from kurbel.formats.typst.strings import string

# The width of the text in millimetres.
MEASURE = 140
# What a fragment says of its width.
_NARROW = re.compile(r"with narrow gaps ([0-9.]+)em")


class TypstPart(NamedTuple):
    """A table or a figure; `path`, `alt` and `label` are strings of code.

    `lang` is the language where it is not the document's; `alt` is the caption for readers that do not see
    the figure; `paper` is that of a table too wide for the pages of the text.
    """

    kind: str
    path: str
    label: str
    text: str
    alt: str
    lang: str
    paper: str = ""


class Maker(DocumentMaker):
    places = True

    def files(self) -> dict[str, str]:
        """Return handbook.typ, which includes the fragments as files of the folder tables."""
        document = self.document
        more = {
            "subtitle": self.title(document.subtitle),
            "author": self.title(document.author),
            "languages": WORDS,
            "indexed": any(
                isinstance(block, Index) for one in document.items("text") for block in one.blocks
            ),
            "kinds": sorted({item.kind for item in document.items("table", "figure")}),
        }
        return {"handbook.typ": self.filled("handbook", self.values() | more)}

    def chapter(self, chapter: Chapter) -> DocumentChapter:
        made: DocumentChapter = super().chapter(chapter)
        return made._replace(label=string(made.label))

    def title(self, label: Label, lang: str = "") -> DocumentTitle:
        return self.titles(label, lang, string)

    def part(self, item: Item) -> TypstPart:
        table = item.kind == "table"
        return TypstPart(
            item.kind,
            string(f"tables/{item.name}.typ" if table else f"figures/{item.name}.svg"),
            string(self.label(item)),
            self.titled(item.caption, item.lang),
            string(self.plain(item.caption, item.lang)),
            self.other(item.lang),
            _paper(self.fragments[item.name]) if table else "",
        )


def _paper(fragment: str) -> str:
    """Return the paper of a table's own page, if it needs one."""
    found = _NARROW.search(fragment)
    return paper(float(found[1]), MEASURE) if found else ""
