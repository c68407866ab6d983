r"""Free text: Markdown (CommonMark and the tables of GitHub) with formulas and references -> a small tree.

The crank turns *evenly* at $v = R ω$      a formula in the grammar of `formula.py`
[](#delta), [the table](#delta)            a reference to a table, a figure or a chapter
5 \$                                       a dollar sign

Raw HTML is text like any other. What cannot be set, such as an image, is a ProseError.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields, is_dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Literal, cast
from urllib.parse import unquote

from kurbel.errors import ProseError
from kurbel.page.formula import Formula, MalformedError, parse_formula
from kurbel.page.labels import WHITE, primed

if TYPE_CHECKING:
    from markdown_it.token import Token

Align = Literal["left", "center", "right"]


@dataclass(frozen=True, slots=True)
class Text:
    text: str


@dataclass(frozen=True, slots=True)
class Code:
    """Characters of a program or a command line."""

    text: str


@dataclass(frozen=True, slots=True)
class Break:
    """The end of a line that the author asked for."""


@dataclass(frozen=True, slots=True)
class Emphasis:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Strong:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Link:
    """A link to another site; `address` is percent-encoded."""

    address: str
    content: Inlines


@dataclass(frozen=True, slots=True)
class Refer:
    """A reference to a part of the same handbook; without content it prints the number of the part."""

    name: str
    content: Inlines


Inline = Text | Formula | Code | Break | Emphasis | Strong | Link | Refer
Inlines = tuple[Inline, ...]


@dataclass(frozen=True, slots=True)
class Paragraph:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Heading:
    """A heading; its level is 1 for a single #."""

    level: int
    content: Inlines


@dataclass(frozen=True, slots=True)
class CodeBlock:
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Quote:
    content: Blocks


@dataclass(frozen=True, slots=True)
class Listing:
    """A list; `start` is its first number, or None for bullets. The items of a tight one stand close."""

    start: int | None
    tight: bool
    items: tuple[Blocks, ...]


@dataclass(frozen=True, slots=True)
class Rule:
    """A line across the page."""


@dataclass(frozen=True, slots=True)
class Grid:
    """A table written in the text."""

    aligns: tuple[Align | None, ...]
    head: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]


Block = Paragraph | Heading | CodeBlock | Quote | Listing | Rule | Grid
Blocks = tuple[Block, ...]


def references(content: object) -> Iterator[str]:
    """Yield the names that a text, or any part of one, refers to."""
    if isinstance(content, Refer):
        yield content.name
    if isinstance(content, tuple):
        for one in content:
            yield from references(one)
    elif is_dataclass(content) and not isinstance(content, type):
        for field in fields(content):
            yield from references(getattr(content, field.name))


LONGEST = 200_000
# LaTeX numbers lists four deep.
DEEPEST = 4
_DEEPEST_INLINE = 10
_TAB = 4
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff]")
_SCHEME = re.compile(r"(?:https?:|mailto:)", re.IGNORECASE)
_ALIGN = re.compile(r"text-align:(left|center|right)")


@lru_cache(maxsize=64)
def parse_prose(text: str) -> Blocks:
    """Return the blocks of a text.

    Raises ProseError, with the line, for images, links to other schemes than http, https and mailto,
    malformed formulas, control characters, and more text or deeper nesting than any page has.
    """
    if len(text) > LONGEST:
        raise ProseError(1, f"the text has {len(text)} characters; {LONGEST} are allowed")
    if control := _CONTROL.search(text):
        line = text.count("\n", 0, control.start()) + 1
        raise ProseError(line, f"the character U+{ord(control.group()):04X} is a control and not printed")
    from kurbel.documents.markdown_it import tokens_of

    return _Reader(tokens_of(text)).blocks()


class _Reader:
    """Turns the tokens of markdown-it, which open and close, into a tree."""

    def __init__(self, tokens: Iterable[Token]) -> None:
        self.tokens = iter(tokens)
        self.line = 1
        self.depth = 0
        self.loose = False

    def blocks(self) -> Blocks:
        """Return the blocks up to the end of the one that is open."""
        blocks = (self._block(token) for token in self._inside())
        return tuple(block for block in blocks if block != Paragraph(()))

    def _inside(self) -> Iterator[Token]:
        for token in self.tokens:
            if token.nesting < 0:
                return
            if token.map:
                self.line = token.map[0] + 1
            yield token

    def _block(self, token: Token) -> Block:
        match token.type:
            case "paragraph_open":
                self.loose |= not token.hidden
                return Paragraph(self._content())
            case "heading_open":
                return self._heading(int(token.tag[1]))
            case "fence" | "code_block":
                return CodeBlock(_lines(token.content.expandtabs(_TAB)))
            case "hr":
                return Rule()
            case "blockquote_open":
                return self._quote()
            case "bullet_list_open" | "ordered_list_open":
                return self._listing(token)
            case "table_open":
                return self._grid()
        raise AssertionError(token.type)

    def _deeper(self) -> Blocks:
        self.depth += 1
        if self.depth > DEEPEST:
            raise ProseError(self.line, f"lists and quotations are nested more than {DEEPEST} deep")
        content = self.blocks()
        self.depth -= 1
        return content

    def _quote(self) -> Quote:
        # Only paragraphs that stand directly in an item set the items of a list apart.
        outside = self.loose
        quote = Quote(self._deeper())
        self.loose = outside
        return quote

    def _content(self) -> Inlines:
        """Return what the paragraph, heading or cell holds that is open."""
        content: Inlines = ()
        for token in self._inside():
            content = _Line(token, self.line).inlines()
        return _trimmed(content)

    def _heading(self, level: int) -> Heading:
        line = self.line
        content = self._content()
        if not content:
            raise ProseError(line, r"a heading has no words; a # in prose is written \#")
        return Heading(level, content)

    def _listing(self, token: Token) -> Listing:
        start = int(token.attrs.get("start", 1)) if token.type == "ordered_list_open" else None
        outside, self.loose = self.loose, False
        items = tuple(self._deeper() for _ in self._inside())
        # A single block has nothing to stand apart from.
        tight = not self.loose or (len(items) == 1 and len(items[0]) == 1)
        self.loose = outside
        return Listing(start, tight, items)

    def _grid(self) -> Grid:
        rows: list[tuple[Inlines, ...]] = []
        aligns: tuple[Align | None, ...] = ()
        for _part in self._inside():
            for _row in self._inside():
                cells = [(_align(cell), self._content()) for cell in self._inside()]
                aligns = aligns or tuple(align for align, _ in cells)
                rows.append(tuple(content for _, content in cells))
        return Grid(aligns, rows[0], tuple(rows[1:]))


def _trimmed(content: Inlines) -> Inlines:
    """Drop white space and ends of lines before the first word and after the last."""
    kept = [place for place, inline in enumerate(content) if inline not in (Break(), Text(" "))]
    return content[kept[0] : kept[-1] + 1] if kept else ()


def _lines(code: str) -> tuple[str, ...]:
    return tuple(code.removesuffix("\n").split("\n")) if code else ()


def _align(cell: Token) -> Align | None:
    found = _ALIGN.match(str(cell.attrs.get("style", "")))
    return cast("Align", found[1]) if found else None


class _Line:
    """Turns the tokens of one run of text into inlines."""

    def __init__(self, run: Token, line: int) -> None:
        self.run = run
        self.first = line
        self.tokens = iter(run.children or ())
        self.depth = 0

    def inlines(self) -> Inlines:
        """Return the inlines up to the end of the one that is open."""
        self.depth += 1
        if self.depth > _DEEPEST_INLINE:
            raise ProseError(self.first, f"emphasis is nested more than {_DEEPEST_INLINE} deep")
        found: list[Inline] = []
        for token in self.tokens:
            if token.nesting < 0:
                break
            found.append(self._inline(token))
        self.depth -= 1
        return tuple(_joined(found))

    def _inline(self, token: Token) -> Inline:
        match token.type:
            case "text" | "text_special":
                return Text(token.content)
            case "softbreak":
                return Text(" ")
            case "hardbreak":
                return Break()
            case "code_inline":
                return Code(token.content)
            case "em_open":
                return Emphasis(self.inlines())
            case "strong_open":
                return Strong(self.inlines())
            case "link_open":
                return self._link(token, str(token.attrs["href"]))
            case "formula":
                return self._formula(token)
            case "image":
                raise self._refused(token, "a text can hold no images; a figure has its own place")
        raise AssertionError(token.type)

    def _link(self, token: Token, address: str) -> Inline:
        content = self.inlines()
        if address.startswith("#") and address != "#":
            return Refer(unquote(address[1:]), content)
        if _SCHEME.match(address):
            return Link(address, content or (Text(address),))
        raise self._refused(
            token,
            f'the link to "{address[:60]}" cannot be set; it must begin with http:, https: or mailto:,'
            " or be # and the name of a table, figure or chapter",
        )

    def _formula(self, token: Token) -> Formula:
        if token.markup == "$":
            raise self._refused(token, r"a formula needs a second $; a dollar sign in prose is written \$")
        try:
            return parse_formula(token.content)
        except MalformedError as error:
            written = WHITE.sub(" ", token.content)[:60]
            raise self._refused(token, f'the formula "{written}" cannot be set: {error}') from None

    def _refused(self, token: Token, reason: str) -> ProseError:
        return ProseError(self.first + self.run.content.count("\n", 0, token.meta["at"]), reason)


def _joined(inlines: Iterable[Inline]) -> Iterator[Inline]:
    """Yield the inlines, neighbouring pieces of text as one."""
    pieces: list[str] = []
    for inline in (*inlines, None):
        if isinstance(inline, Text):
            pieces.append(inline.text)
            continue
        if text := primed(WHITE.sub(" ", "".join(pieces))):
            yield Text(text)
        pieces.clear()
        if inline is not None:
            yield inline
