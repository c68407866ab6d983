"""Free text in Typst, as calls of functions, so that no character of the text stands where it is markup."""

from __future__ import annotations

from kurbel.prose import Blocks, Grid, Inlines, Listing
from kurbel.prose_print import ProsePrinter, Reference

_ALIGNS = {None: "left", "left": "left", "center": "center", "right": "right"}
_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


class Printer(ProsePrinter):
    # A semicolon ends each call: an opening parenthesis or a full stop after it would belong to it.
    def heading(self, level: int, content: Inlines) -> str:
        return f"#heading(level: {max(level, 1)})[{self.inlines(content)}];"

    def code_block(self, lines: tuple[str, ...]) -> str:
        code = _string("\n".join(lines))
        return f"#raw({code}, block: true);"

    def quote(self, content: Blocks) -> str:
        return f"#quote(block: true)[\n{self.blocks(content)}\n];"

    def listing(self, listing: Listing) -> str:
        tight = str(listing.tight).lower()
        kind = "list(" if listing.start is None else f"enum(start: {listing.start}, "
        items = ",\n".join(f"[{self.blocks(item)}]" for item in listing.items)
        return f"#{kind}tight: {tight},\n{items},\n);"

    def rule(self) -> str:
        return "#line(length: 100%);"

    def grid(self, grid: Grid) -> str:
        aligns = "".join(f"{_ALIGNS[align]}, " for align in grid.aligns)
        rows = "".join(f"{self._row(row)},\n" for row in grid.rows)
        return (
            f"#table(columns: {len(grid.aligns)}, align: ({aligns}),\n"
            f"table.header({self._row(grid.head)}),\n{rows});"
        )

    def _row(self, cells: tuple[Inlines, ...]) -> str:
        return ", ".join(f"[{self.inlines(cell)}]" for cell in cells)

    def code(self, text: str) -> str:
        return f"#raw({_string(text)});"

    def line_break(self) -> str:
        return "#linebreak();\n"

    def emphasis(self, content: Inlines) -> str:
        return f"#emph[{self.inlines(content)}];"

    def strong(self, content: Inlines) -> str:
        return f"#strong[{self.inlines(content)}];"

    def link(self, address: str, content: Inlines) -> str:
        return f"#link({_string(address)})[{self.inlines(content)}];"

    def reference(self, reference: Reference, content: Inlines) -> str:
        """Return a reference; Typst itself names and counts what it points to."""
        label = f"<{reference.target}>"
        return f"#link({label})[{self.inlines(content)}];" if content else f"#ref({label});"


def _string(text: str) -> str:
    return f'"{text.translate(_STRING)}"'
