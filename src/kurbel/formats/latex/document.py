r"""A handbook in LaTeX: an appendix for \input, and an article around it.

The appendix numbers nothing by itself: its sections, tables and figures take the numbers of the document
that inputs it, and its lists are made of references, so that they hold what is in the appendix and leave
\listoftables to that document.
"""

from __future__ import annotations

from typing import NamedTuple

from kurbel.documents.document import WORDS, Item
from kurbel.documents.prose import Grid, Index
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker, DocumentTitle
from kurbel.formats.latex.writer import string


class TexPart(NamedTuple):
    r"""A text, table or figure. `language` is that of babel where it is not the document's.

    A `long` table is no float and may not overtake those that wait.
    """

    kind: str
    name: str
    label: str
    text: str
    language: str
    long: bool


class Maker(DocumentMaker):
    joint = ":"
    # A chapter is a section, and what stands below it a subsection.
    level = 2
    places = True

    def files(self) -> dict[str, str]:
        """Return appendix.tex and handbook.tex, which input the fragments."""
        values = self.values()
        blocks = [block for item in self.document.items("text") for block in item.blocks]
        uncounted = any(isinstance(block, Grid) and block.long for block in blocks)
        values |= {
            "author": self.title(self.document.author),
            "languages": self.languages(),
            "long": uncounted or any(part.long for chapter in values["chapters"] for part in chapter.parts),
            "wide": any(r"\begin{landscape}" in text for text in self.fragments.values()),
            "linked": any(self.document.items("text")),
            "indexed": any(isinstance(block, Index) for block in blocks),
            "uncounted": uncounted,
        }
        return {f"{name}.tex": self.filled(name, values) for name in ("appendix", "handbook")}

    def text_part(self, item: Item) -> TexPart:
        return TexPart("text", "", "", self.text(item), self.language(item), False)

    def part(self, item: Item) -> TexPart:
        long = item.kind == "table" and r"\begin{longtable}" in self.fragments[item.name]
        caption = self.titled(item.caption, item.lang)
        return TexPart(item.kind, item.name, self.label(item), caption, self.language(item), long)

    def language(self, item: Item) -> str:
        lang = self.other(item.lang)
        return WORDS[lang]["babel"] if lang else ""

    def languages(self) -> str:
        """Return the options of babel, the document's own language last."""
        others = {self.language(item) for item in self.document.items("text", "table", "figure")} - {""}
        return ",".join([*sorted(others), f"main={self.document.words['babel']}"])

    def title(self, label: Label, lang: str = "") -> DocumentTitle:
        return self.titles(label, lang, string)
