"""Free text in HTML."""

from __future__ import annotations

from collections.abc import Iterable

from kurbel.documents import prose
from kurbel.formats.html.writer import beside, escape
from kurbel.formats.printer import ProsePrinter, Reference


class Printer(ProsePrinter):
    emphasised, strong = ("<em>", "</em>"), ("<strong>", "</strong>")
    quoted = ("<blockquote>\n", "\n</blockquote>")
    rule, line_end = "<hr>", "<br>\n"

    def paragraph(self, content: prose.Inlines) -> str:
        return f"<p>{beside(self.inlines(content))}</p>"

    def blocks(self, blocks: prose.Blocks, between: str = "\n") -> str:
        return super().blocks(blocks, between)

    def heading(self, level: int, content: prose.Inlines) -> str:
        level = min(level, 6)
        return f"<h{level}>{self.inlines(content)}</h{level}>"

    def code_block(self, lines: tuple[str, ...]) -> str:
        # A long line scrolls, also by the keyboard.
        code = escape("".join(f"{line}\n" for line in lines))
        return f'<pre tabindex="0"><code>{code}</code></pre>'

    def listing(self, listing: prose.Listing) -> str:
        tag = "ul" if listing.start is None else "ol"
        start = "" if listing.start in (None, 1) else f' start="{listing.start}"'
        items = "\n".join(self._item(item, listing.tight) for item in listing.items)
        return f"<{tag}{start}>\n{items}\n</{tag}>"

    def _item(self, item: prose.Blocks, tight: bool) -> str:
        """Return an item; in a tight list its paragraphs stand bare."""
        blocks = (
            self.inlines(block.content) if tight and isinstance(block, prose.Paragraph) else self.block(block)
            for block in item
        )
        return "\n".join(blocks).join(("<li>", "</li>"))

    def grid(self, grid: prose.Grid) -> str:
        head = self._row(grid.head, grid.aligns, "th", ' scope="col"')
        rows = "\n".join(self._row(row, grid.aligns, "td") for row in grid.rows)
        body = f"<tbody>\n{rows}\n</tbody>\n" if rows else ""
        table = f"<table>\n<thead>\n{head}\n</thead>\n{body}</table>"
        return f'<div class="scroll" tabindex="0">\n{table}\n</div>'

    def _row(
        self, cells: Iterable[prose.Inlines], aligns: Iterable[prose.Align | None], tag: str, scope: str = ""
    ) -> str:
        styles = (f' style="text-align: {align}"' if align else "" for align in aligns)
        tags = (
            f"<{tag}{scope}{style}>{self.inlines(cell)}</{tag}>"
            for cell, style in zip(cells, styles, strict=True)
        )
        return f"<tr>{''.join(tags)}</tr>"

    def index(self, index: prose.Index) -> str:
        return super().index(index).join(('<div class="index">\n', "\n</div>"))

    def marked(self, place: Reference, words: str) -> str:
        return f'<span id="{escape(place.target.removeprefix("#"))}">{words}</span>'

    def code(self, text: str) -> str:
        return f"<code>{escape(text)}</code>"

    def link(self, address: str, content: prose.Inlines) -> str:
        return f'<a href="{escape(address)}">{self.inlines(content)}</a>'
