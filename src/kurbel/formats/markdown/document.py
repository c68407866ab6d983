"""A handbook in Markdown, a folder with an index and one page a chapter; and its free text, which readers of
CommonMark, and of GitHub's tables, show as they show the source."""

from __future__ import annotations

import re
import string

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.documents.inject import MARKUP_COMMENT, Code, Kind, without_raw
from kurbel.formats.documents import DocumentMaker, DocumentPart, ProsePrinter, indented

_FENCE = re.compile(rb"(`{3,})[^`]*\Z|(~{3,})", re.DOTALL)
_ITEM = re.compile(rb"(?:[-*+]|[0-9]{1,9}[.)])(?: +|\Z)")
# What ends a paragraph that otherwise goes on, however its lines are indented.
_BEGINNING = re.compile(rb"[<>#]|```|~~~|" + _ITEM.pattern)
_QUOTE = re.compile(rb"(?: {0,3}>)+ ?")

# No block of code, item or quotation begins with one of these; most lines of a text do.
_PLAIN = frozenset(range(256)) - frozenset(b" \t\r\n\f\v>-*+0123456789`~")


class MarkdownCode(Code):
    """Fenced and indented code, also in items of lists and in quotations.

    Source: CommonMark 0.31, sections 4.4, 4.5, 5.1 and 5.2.
    """

    def __init__(self) -> None:
        self.fence = b""
        self.of_fence = 0
        # Where the texts of the open items begin, outermost first.
        self.items: list[int] = []
        self.quoted = False
        # The items that a quotation is in.
        self.outside: list[int] = []
        self.after_blank = True
        # Whether the last line began an item and has nothing else.
        self.bare = False

    def holds(self, line: bytes) -> bool:
        if line[0] in b"\r\n" and not self.quoted:
            return self._blank()
        if line[0] in _PLAIN and not (self.fence or self.items or self.quoted):
            self.after_blank = False
            return False
        # In a fence that is not of a quotation > is a letter like others.
        quote = None if self.fence and not self.quoted else _QUOTE.match(line)
        if bool(quote) != self.quoted:
            self._quote(line)
        text = line[quote.end() if quote else 0 :].rstrip().expandtabs(4)
        if not text:
            return self._blank()
        stripped = text.lstrip(b" ")
        indent = len(text) - len(stripped)
        if self.fence and indent >= self.of_fence:
            self._close(indent, stripped)
            return True
        if self.fence:
            # Its item has ended, and no paragraph goes on.
            self.fence, self.after_blank = b"", True
        return self._block(indent, stripped)

    def _blank(self) -> bool:
        if self.bare:
            self.items.pop()
        self.after_blank, self.bare = True, False
        return bool(self.fence)

    def _quote(self, line: bytes) -> None:
        """Begin or end a quotation, which has items of its own and ends with all that is in it."""
        self.quoted = not self.quoted
        if self.quoted:
            lead = len(line) - len(line.lstrip(b" "))
            self.outside, self.items = [item for item in self.items if item <= lead], []
        else:
            self.items, self.fence = self.outside, b""
        self.bare = False

    def _close(self, indent: int, stripped: bytes) -> None:
        # At least as many of the same sign, and nothing behind them.
        ends = stripped.startswith(self.fence) and not stripped.strip(self.fence[:1])
        if ends and indent - self.of_fence < 4:
            self.fence = b""
            self.after_blank = True

    def _block(self, indent: int, stripped: bytes) -> bool:
        self.bare = False
        home = [item for item in self.items if item <= indent]
        if indent - (home[-1] if home else 0) >= 4:
            # Without a blank line before it, it goes on with a paragraph; no table can stand there.
            return True
        if self.after_blank or _BEGINNING.match(stripped):
            self.items = home
        while (item := _ITEM.match(stripped)) and indent - self._base() < 4:
            width = item.end() if stripped[item.end() :] else len(item[0].rstrip()) + 1
            if width - len(item[0].rstrip()) > 4:
                width = len(item[0].rstrip()) + 1
            self.items.append(indent + width)
            indent, stripped = indent + item.end(), stripped[item.end() :]
            self.bare = not stripped
        self.after_blank = False
        if fence := _FENCE.match(stripped):
            self.fence = fence[1] or fence[2]
            self.of_fence = self._base()
        return bool(self.fence)

    def _base(self) -> int:
        return self.items[-1] if self.items else 0

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
