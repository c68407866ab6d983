"""A handbook in plain text: one file to read from the top to the end. Marks of emphasis fall away, addresses
of links stand in angle brackets."""

from __future__ import annotations

from textwrap import fill, wrap
from typing import NamedTuple

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.formats.documents import DocumentMaker, DocumentPart, ProsePrinter, Reference, indented, is_own
from kurbel.formats.text.writer import wrapped

# As wide as texts are.
WIDTH = 78
# A list in a list in a quotation keeps some room.
_NARROWEST = 40


class Printer(ProsePrinter):
    room = WIDTH

    def block(self, block: prose.Block) -> str:
        return "─" * self.room if isinstance(block, prose.Rule) else super().block(block)

    def document(self, blocks: prose.Blocks) -> str:
        # The spaces of a formula are no-break spaces until its line is found.
        return super().document(blocks).replace("\u00a0", " ")

    def paragraph(self, content: prose.Inlines) -> str:
        return self._filled(self.inlines(content))

    def _filled(self, text: str) -> str:
        lines = (
            fill(line, self.room, break_on_hyphens=False, break_long_words=False) for line in text.split("\n")
        )
        return "\n".join(lines)

    def heading(self, level: int, content: prose.Inlines) -> str:
        text = self._filled(self.inlines(content).replace("\n", " "))
        longest = max(len(line) for line in text.splitlines() or [""])
        return f"{text}\n{('━' if level <= 2 else '─') * longest}"

    def code_block(self, lines: tuple[str, ...]) -> str:
        return indented("\n".join(lines), "    ", "    ")

    def quote(self, content: prose.Blocks) -> str:
        return self._within(content, "  │ ", "  │ ")

    def listing(self, listing: prose.Listing) -> str:
        marks = [
            "•" if listing.start is None else f"{listing.start + place}."
            for place in range(len(listing.items))
        ]
        width = max(map(len, marks)) + 1
        items = (
            self._within(item, f"{mark:>{width}} ", " " * (width + 1), listing.tight)
            for mark, item in zip(marks, listing.items, strict=True)
        )
        return ("\n" if listing.tight else "\n\n").join(items)

    def _within(self, content: prose.Blocks, first: str, rest: str, tight: bool = False) -> str:
        within = self.but(room=max(self.room - len(first), _NARROWEST))
        return indented(within.blocks(content, "\n" if tight else "\n\n"), first, rest)

    def grid(self, grid: prose.Grid) -> str:
        from tabulate import tabulate

        def texts(cells: tuple[prose.Inlines, ...]) -> list[str]:
            return [self.inlines(cell) for cell in cells]

        rows = [texts(row) for row in (grid.head, *grid.rows)]
        if grid.long:
            self._fold(rows)
        return tabulate(
            rows[1:],
            rows[0],
            tablefmt="simple",
            disable_numparse=True,
            colalign=[align or "left" for align in grid.aligns] if grid.rows else None,
        )

    def _fold(self, rows: list[list[str]]) -> None:
        """Break the lines of the widest column where the rows are wider than the text."""
        widths = [max(map(len, cells)) for cells in zip(*rows, strict=True)]
        widest = widths.index(max(widths))
        left = self.room - sum(widths) + widths[widest] - 2 * (len(widths) - 1)
        for row in rows:
            row[widest] = "\n".join(wrap(row[widest], max(left, 1))) or ""

    def code(self, text: str) -> str:
        return text.replace(" ", "\u00a0")

    def link(self, address: str, content: prose.Inlines) -> str:
        text = self.inlines(content)
        return text if is_own(address, content) else f"{text} <{address}>"

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        text = self.inlines(content)
        name = reference.text.replace(" ", "\u00a0")
        return f"{text} ({name})" if text and reference.kind != "matter" else text or name


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
