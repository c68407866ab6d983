"""A handbook in reStructuredText: a project of Sphinx with an index and one page a chapter."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.documents.prose import Block, Heading, stepwise
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker, DocumentPart, ProsePrinter, Reference, indented
from kurbel.formats.rst.writer import GridCell, escape, finish, grid_lines, role, width_of

_LINES = "=-~^\"'"
_INDENT = " " * 3
# What ends an indented text, so that it is no part of what stands above it.
_COMMENT = ".."
_TITLE = str.maketrans({"\\": r"\\", "`": r"\`", "<": r"\<", ">": r"\>"})
_LAST_LINE = re.compile(r"_(?=$)")
# docutils ends a line at these, too.
_SEPARATORS = str.maketrans(dict.fromkeys("\u2028\u2029", " "))
# It widens tabs, which would make a heading longer than its line and part the cells of a table.
_ENDS = str.maketrans(dict.fromkeys("\n\t", " "))


class Printer(ProsePrinter):
    # Headings are sections outside of lists and quotations only.
    depth = 0
    # A transition may neither begin nor end a section, nor stand in a list.
    rule = ".. container:: kurbel-rule\n\n   \\* \\* \\*"

    def document(self, blocks: prose.Blocks) -> str:
        return super().document(blocks).translate(_SEPARATORS)

    def blocks(self, blocks: prose.Blocks, between: str | None = None) -> str:
        pieces: list[str] = []
        for before, block in zip((None, *blocks), blocks, strict=False):
            if _would_join(before, block):
                pieces.append(_COMMENT)
            pieces.append(self.block(block))
        return (between or self.between).join(pieces)

    def paragraph(self, content: prose.Inlines) -> str:
        text = self.inlines(content)
        lines = [line.strip(" ") for line in text.split("\n")]
        return text if len(lines) == 1 else "\n".join(f"| {line}".rstrip() for line in lines)

    def heading(self, level: int, content: prose.Inlines) -> str:
        title = self._line(content)
        if self.depth:
            return f".. rubric:: {title}"
        return underlined(title, level)

    def code_block(self, lines: tuple[str, ...]) -> str:
        if not any(line.strip() for line in lines):
            return ""
        return "\n".join((".. code-block:: text", "", *(f"{_INDENT}{line}".rstrip() for line in lines)))

    def quote(self, content: prose.Blocks) -> str:
        return indented(self._within(content), _INDENT, _INDENT)

    def listing(self, listing: prose.Listing) -> str:
        close = listing.tight and all(len(item) < 2 for item in listing.items)
        items = []
        for place, item in enumerate(listing.items):
            mark = "-" if listing.start is None else f"{listing.start + place}."
            items.append(indented(self._within(item), f"{mark} ", " " * (len(mark) + 1)))
        return ("\n" if close else "\n\n").join(items)

    def _within(self, content: prose.Blocks) -> str:
        return self.but(depth=self.depth + 1).blocks(content)

    def grid(self, grid: prose.Grid) -> str:
        rows = (grid.head, *grid.rows)
        cells = [
            GridCell(row, column, (self._line(cell),))
            for row, texts in enumerate(rows)
            for column, cell in enumerate(texts)
        ]
        lines = grid_lines(cells, 1 if grid.rows else 0)
        return "\n".join((".. table::", "   :class: kurbel-prose", "", *(_INDENT + line for line in lines)))

    def inlines(self, content: prose.Inlines) -> str:
        return finish("".join(self.pieces(content, "")))

    def pieces(self, content: prose.Inlines, mark: str) -> Iterator[str]:
        """Yield inlines beside each other, their words between marks such as * for emphasis."""
        for inline in content:
            match inline:
                case prose.Emphasis(inner):
                    yield from self.pieces(inner, mark or "*")
                case prose.Strong(inner):
                    yield from self.pieces(inner, "**")
                case prose.Indexed(_, inner):
                    yield from self.pieces(inner, mark)
                case prose.Text(text) if mark:
                    yield _between(mark, text)
                case _:
                    yield self.inline(inline)

    def _line(self, content: prose.Inlines) -> str:
        """Return inlines where no line may end and no tab stand."""
        return self.inlines(content).translate(_ENDS).strip(" ")

    def code(self, text: str) -> str:
        inner = text.replace("\u00a0", " ").strip()
        if not inner:
            return ""
        if "``" in inner or "`" in (inner[0], inner[-1]):
            return role("literal", inner.replace("\\", r"\\").replace("`", r"\`"))
        return f"\\ ``{inner}``\\ "

    def link(self, address: str, content: prose.Inlines) -> str:
        target = _LAST_LINE.sub(r"\\_", address)
        return f"\\ `{self._title(content) or address.translate(_TITLE)} <{target}>`__\\ "

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        title = self._title(content) or reference.text.translate(_TITLE)
        return role("ref", f"{title} <{reference.target}>")

    def _title(self, content: prose.Inlines) -> str:
        """Return the words of a link, which can be nothing but letters."""
        return " ".join(self.plain(content).split()).translate(_TITLE)


def underlined(title: str, level: int) -> str:
    """Return a heading; level 1 is that of a title or chapter."""
    line = _LINES[max(1, min(level, len(_LINES))) - 1]
    return f"{title}\n{line * width_of(title)}"


def _between(mark: str, text: str) -> str:
    """Return words between marks; white space stands outside of them."""
    inner = text.strip()
    if not inner:
        return text
    before, behind = text[: text.index(inner)], text[text.index(inner) + len(inner) :]
    return f"{before}\\ {mark}{escape(inner)}{mark}\\ {behind}"


def _would_join(before: prose.Block | None, block: prose.Block) -> bool:
    """Tell whether a block would be taken for a part of the one above it."""
    if isinstance(block, prose.Quote):
        return True
    return isinstance(before, prose.Listing | prose.Quote) and isinstance(block, prose.Listing)


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
