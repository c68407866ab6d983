"""Free text in Typst, as calls of functions, so that no character of the text stands where it is markup."""

from __future__ import annotations

import re

from kurbel.documents import prose
from kurbel.formats.printer import ProsePrinter, Reference
from kurbel.formats.typst.strings import string

_ALIGNS = {None: "left", "left": "left", "center": "center", "right": "right"}
_LONG_WORD = re.compile(r"\S{30}")
_BREAK = r'show regex("\S{30,}"): it => it.text.clusters().join(box())'


class Printer(ProsePrinter):
    emphasised, strong = ("#emph[", "];"), ("#strong[", "];")
    quoted = ("#quote(block: true)[\n", "\n];")
    rule, line_end = "#line(length: 100%);", "#linebreak();\n"

    # A semicolon ends each call: an opening parenthesis or a full stop after it would belong to it.
    def heading(self, level: int, content: prose.Inlines) -> str:
        return f"#heading(level: {max(level, 1)})[{self.inlines(content)}];"

    def code_block(self, lines: tuple[str, ...]) -> str:
        return _raw("\n".join(lines), ", block: true")

    def listing(self, listing: prose.Listing) -> str:
        tight = str(listing.tight).lower()
        kind = "list(" if listing.start is None else f"enum(start: {listing.start}, "
        items = ",\n".join(f"[{self.blocks(item)}]" for item in listing.items)
        return f"#{kind}tight: {tight},\n{items},\n);"

    def grid(self, grid: prose.Grid) -> str:
        aligns = "".join(f"{_ALIGNS[align]}, " for align in grid.aligns)
        rows = "".join(f"{self._row(row)},\n" for row in grid.rows)
        columns = f"({self._widths(grid)})" if grid.long else len(grid.aligns)
        table = (
            f"#align(center, table(columns: {columns}, align: ({aligns}), stroke: none,\n"
            f"table.hline(stroke: .08em), table.header({self._row(grid.head)}), table.hline(stroke: .05em),\n"
            f"{rows}table.hline(stroke: .08em)));"
        )
        return f"#[#set text(size: .9em);\n{table}];" if grid.long else table

    def _widths(self, grid: prose.Grid) -> str:
        """Return the widths of the columns of a long table, of which the widest has what the others leave."""
        rows = (grid.head, *grid.rows)
        letters = [sum(len(self.plain(cell)) for cell in cells) for cells in zip(*rows, strict=True)]
        return "".join("1fr, " if one == max(letters) else "auto, " for one in letters)

    def _row(self, cells: tuple[prose.Inlines, ...]) -> str:
        return ", ".join(f"[{self.inlines(cell)}]" for cell in cells)

    def index(self, index: prose.Index) -> str:
        groups = "".join(
            f"({string(letter)}, ({''.join(map(self._term, terms))})),\n" for letter, terms in index.groups
        )
        return f"#index((\n{groups}));"

    def _term(self, term: prose.Term) -> str:
        targets = "".join(f"{string(self.refer(name).target)}, " for name in term.places)
        return f"([{self.text(term.words)}], ({targets}), [{self.text(term.more)}]),\n"

    def marked(self, place: Reference, words: str) -> str:
        return f"#[#metadata(none)#label({string(place.target)})];{words}"

    def code(self, text: str) -> str:
        return _raw(text)

    def link(self, address: str, content: prose.Inlines) -> str:
        return f"#link({string(address)})[{self.inlines(content)}];"

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        """Return a reference; Typst itself names and counts what it points to."""
        label = f"<{reference.target}>"
        return f"#link({label})[{self.inlines(content)}];" if content else f"#ref({label});"


def _raw(code: str, options: str = "") -> str:
    """Return code in which a word that is longer than a line may be broken at any character."""
    call = f"raw({string(code)}{options})"
    return f"#{{ {_BREAK}; {call} }};" if _LONG_WORD.search(code) else f"#{call};"
