"""A handbook in Markdown, a folder with an index and one page a chapter; and its free text, which readers of
CommonMark, and of GitHub's tables, show as they show the source."""

from __future__ import annotations

import re
import string
from functools import cache
from typing import TYPE_CHECKING

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.documents.inject import MARKUP_COMMENT, Code, Kind, without_raw
from kurbel.formats.documents import DocumentMaker, DocumentPart, ProsePrinter, indented

if TYPE_CHECKING:
    from markdown_it import MarkdownIt

_LINE = rb"(?<![^\r\n])[A-Za-z\x80-\xff][^<>\r\n]*(?:\r\n?|\n)"
_PARAGRAPH = rb"%s(?:\r\n?|\n)+" % _LINE
# Of lines of paragraphs, one after another, and of paragraphs, what can be left out.
_LONG = re.compile(rb"(%s)(?:%s)+" % (_LINE, _LINE))
_MANY = re.compile(rb"((?:%s){2})(?:%s)+" % (_PARAGRAPH, _PARAGRAPH))
_LEAVES = ("fence", "code_block", "html_block", "inline")


@cache
def _reader() -> MarkdownIt:
    from markdown_it import MarkdownIt

    return MarkdownIt("commonmark").disable("inline")


class MarkdownCode(Code):
    """Fenced and indented code, also in items of lists and quotations, as a reader of CommonMark sees it."""

    def __init__(self) -> None:
        # What was read, from where the last block began that is in no other.
        self.lines: list[bytes] = []

    def holds(self, line: bytes) -> bool:
        self.lines.append(line)
        if b"kurbel" not in line:
            return False
        # A document may have millions of lines: paragraphs are not read to their ends.
        text = _MANY.sub(rb"\1", _LONG.sub(rb"\1", b"".join(self.lines)))
        tokens = _reader().parse(text.decode("latin-1"))
        begun = [one.map[0] for one in tokens if one.map and not one.level]
        self.lines = text.splitlines(keepends=True)[begun[-1] if begun else 0 :]
        last = next((one.type for one in reversed(tokens) if one.type in _LEAVES), "")
        # In the midst of a paragraph no table can stand.
        return last in ("fence", "code_block") or (last == "inline" and line.lstrip().startswith(b"<!--"))

    def without_inline(self, line: bytes) -> bytes:
        return without_raw(line)


KIND = Kind(
    name="Markdown",
    suffixes=(".md", ".markdown", ".qmd", ".rmd"),
    left="<!--",
    right="-->",
    comment=MARKUP_COMMENT,
    code=MarkdownCode,
    apart=True,
    labelled=False,
)


# What would begin a list, a heading, a rule, or underline the line before as a heading or a table.
_START = re.compile(r"^(?:[-+=#:]|[0-9]{1,9}(?=[.)]))", re.MULTILINE)
_BACKTICKS = re.compile("`+")
_ENTITY = re.compile(r"&(?=[#A-Za-z])")
_LAST_HASH = re.compile(r"(?<!\\)#$")
_BESIDE = f" {string.punctuation}"
_LARGEST = 999_999_999
_DASHES = {None: "---", "left": ":---", "center": ":---:", "right": "---:"}


class Printer(ProsePrinter):
    # Two lists in a row, or a list that begins another, need different marks: "- - -" is a rule.
    depth = lists = 0
    emphasised, strong = ("<em>", "</em>"), ("<strong>", "</strong>")
    rule, line_end = "___", "\\\n"
    bar = "|"

    def paragraph(self, content: prose.Inlines) -> str:
        lines = (line.strip(" ") for line in self.inlines(content).split("\n"))
        return _START.sub(_escaped, "\n".join(lines))

    def blocks(self, blocks: prose.Blocks, between: str | None = None) -> str:
        pieces: list[str] = []
        lists = 0
        for before, block in zip((None, *blocks), blocks, strict=False):
            lists = lists + 1 if isinstance(before, prose.Listing) and isinstance(block, prose.Listing) else 0
            # Without an empty line between them two quotations would be one.
            apart = between == "\n" and isinstance(before, prose.Quote) and isinstance(block, prose.Quote)
            pieces.append("<!-- -->\n" * apart + self.but(lists=lists).block(block))
        return (between or self.between).join(pieces)

    def heading(self, level: int, content: prose.Inlines) -> str:
        return f"{'#' * max(1, min(level, 6))} {_LAST_HASH.sub(_escaped, self._line(content))}"

    def _line(self, content: prose.Inlines) -> str:
        """Return inlines where no line may end."""
        return self.but(line_end="<br>").inlines(content).strip(" ")

    def code_block(self, lines: tuple[str, ...]) -> str:
        fence = "`" * max(3, _longest("\n".join(lines)) + 1)
        return "\n".join([fence, *lines, fence])

    def quote(self, content: prose.Blocks) -> str:
        return indented(self.blocks(content), "> ", "> ")

    def listing(self, listing: prose.Listing) -> str:
        odd = (self.lists + self.depth) % 2
        within = self.but(depth=self.depth + 1)
        between = "\n" if listing.tight else "\n\n"
        items = []
        for place, item in enumerate(listing.items):
            number = min((listing.start or 0) + place, _LARGEST)
            mark = "-+"[odd] if listing.start is None else f"{number}{'.)'[odd]}"
            items.append(indented(within.blocks(item, between), f"{mark} ", " " * (len(mark) + 1)))
        return between.join(items)

    def grid(self, grid: prose.Grid) -> str:
        dashes = " | ".join(_DASHES[align] for align in grid.aligns)
        head, *rows = map(self.but(bar=r"\|")._row, (grid.head, *grid.rows))
        return "\n".join([head, f"| {dashes} |", *rows])

    def _row(self, cells: tuple[prose.Inlines, ...]) -> str:
        return f"| {' | '.join(map(self._line, cells))} |"

    def inlines(self, content: prose.Inlines) -> str:
        pieces = []
        for place, inline in enumerate(content):
            before = content[place - 1] if place else None
            after = content[place + 1] if place + 1 < len(content) else None
            pieces.append(self._marked(inline) if _is_free(inline, before, after) else self.inline(inline))
        return "".join(pieces)

    def _marked(self, inline: prose.Inline) -> str:
        """Return emphasis with asterisks, which only open and close where words and spaces meet."""
        assert isinstance(inline, prose.Emphasis | prose.Strong)
        stars = "*" if isinstance(inline, prose.Emphasis) else "**"
        return f"{stars}{self.inlines(inline.content)}{stars}"

    def code(self, text: str) -> str:
        text = text.replace("|", self.bar)
        ticks = "`" * (_longest(text) + 1)
        padded = text[:1] == "`" or text[-1:] == "`" or (text[:1] == text[-1:] == " " and text.strip(" "))
        return f"{ticks} {text} {ticks}" if padded else f"{ticks}{text}{ticks}"

    def link(self, address: str, content: prose.Inlines) -> str:
        return f"[{self.inlines(content)}](<{_ENTITY.sub('&amp;', address)}>)"


def _is_free(inline: prose.Inline, before: prose.Inline | None, after: prose.Inline | None) -> bool:
    """Tell whether asterisks around an inline can mean nothing but its emphasis."""
    if not isinstance(inline, prose.Emphasis | prose.Strong) or not inline.content:
        return False
    first, last = inline.content[0], inline.content[-1]
    return (
        (before is None or (isinstance(before, prose.Text) and before.text[-1] in _BESIDE))
        and (after is None or (isinstance(after, prose.Text) and after.text[0] in _BESIDE))
        and isinstance(first, prose.Text)
        and isinstance(last, prose.Text)
        and first.text[0].isalnum()
        and last.text[-1].isalnum()
    )


def _longest(text: str) -> int:
    """Return the length of the longest run of backticks."""
    return max((len(run) for run in _BACKTICKS.findall(text)), default=0)


def _escaped(match: re.Match[str]) -> str:
    found = match.group()
    return f"{found}\\" if found.isdigit() else f"\\{found}"


# A # at the end of a heading would be taken for its end.
_LAST_HASHES = re.compile(r"(#+)$")


class Maker(DocumentMaker):
    def files(self) -> dict[str, str]:
        """Return markdown/index.md and a page for each chapter."""
        values = self.values()
        values["heading"] = self.heading(values["title"])
        pages = {"markdown/index.md": self.filled("index", values)}
        chapters = values["chapters"]
        for before, chapter, after in zip((None, *chapters), chapters, (*chapters[1:], None), strict=False):
            places = {"chapter": chapter, "before": before, "after": after}
            pages[f"markdown/{chapter.file}"] = self.filled("chapter", values | places)
        return pages

    def heading(self, title: str) -> str:
        return _LAST_HASHES.sub(r"\\\1", title)

    def file(self, chapter: Chapter) -> str:
        return f"{super().file(chapter)}.md"

    def page(self, chapter: Chapter) -> str:
        return f"{self.file(chapter)}#"

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        return part._replace(alt=self.writer.escape(part.alt))
