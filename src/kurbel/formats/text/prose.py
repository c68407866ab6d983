"""Free text in plain text: marks of emphasis fall away, addresses of links stand in angle brackets."""

from __future__ import annotations

from textwrap import fill, wrap

from kurbel.documents import prose
from kurbel.formats.printer import ProsePrinter, Reference, indented, is_own

_WIDTH = 78
# A list in a list in a quotation keeps some room.
_NARROWEST = 40


class Printer(ProsePrinter):
    room = _WIDTH

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
