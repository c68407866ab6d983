r"""Markdown (CommonMark and the tables of GitHub), in which texts are written, with formulas and references.

The crank turns *evenly* at $v = R ω$      a formula in the grammar of `formula.py`
[](#delta), [the table](#delta)            a reference to a table, a figure or a chapter
5 \$                                       a dollar sign
[dead centres](index:), [them](<index:dead centre>)  words that the index lists, as they are or by a term

Raw HTML is text like any other. What cannot be set, such as an image, is a ProseError.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from itertools import groupby
from typing import cast
from urllib.parse import unquote

from markdown_it import MarkdownIt
from markdown_it.rules_inline import StateInline, autolink, image, link
from markdown_it.tree import SyntaxTreeNode

from kurbel.documents import prose
from kurbel.errors import ProseError
from kurbel.page.formula import Formula, MalformedError, parse_formula
from kurbel.page.labels import WHITE, primed

InlineRule = Callable[[StateInline, bool], bool]

LONGEST = 200_000
# LaTeX numbers lists four deep.
DEEPEST = 4
_DEEPEST_INLINE = 10
_TAB = 4
_INDEX, _LONGEST_TERM = "index:", 80
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff]")
_SCHEME = re.compile(r"(?:https?:|mailto:)", re.IGNORECASE)


@lru_cache(maxsize=64)
def parse_prose(text: str) -> prose.Blocks:
    """Return the blocks of a text.

    Raises ProseError, with the line, for images, links to other schemes than http, https and mailto,
    malformed formulas, control characters, and more text or deeper nesting than any page has.
    """
    if len(text) > LONGEST:
        raise ProseError(1, f"the text has {len(text)} characters; {LONGEST} are allowed")
    if control := _CONTROL.search(text):
        line = text.count("\n", 0, control.start()) + 1
        raise ProseError(line, f"the character U+{ord(control.group()):04X} is a control and not printed")
    return _blocks(SyntaxTreeNode(_parser().parse(text)), 0)


@lru_cache(maxsize=1)
def _parser() -> MarkdownIt:
    # Beyond its nesting the parser drops text: what a text may have must lie well below.
    parser = MarkdownIt("commonmark", {"html": False, "maxNesting": 20}).enable("table")
    # What links may be is said in a sentence; an address that is refused here would only be printed.
    parser.validateLink = lambda url: True  # type: ignore[method-assign]
    parser.inline.ruler.push("formula", _placed(_read_formula))
    for name, rule in (("link", link), ("autolink", autolink), ("image", image)):
        parser.inline.ruler.at(name, _placed(rule))
    return parser


def _placed(rule: InlineRule) -> InlineRule:
    """Return the rule, which then notes in its first token where it was found: links, images, formulas."""

    def placed(state: StateInline, silent: bool) -> bool:
        start, count = state.pos, len(state.tokens)
        found = rule(state, silent)
        for token in state.tokens[count:] if found and not silent else ():
            if token.type in ("link_open", "image", "formula"):
                token.meta["at"] = start
                break
        return found

    return placed


def _read_formula(state: StateInline, silent: bool) -> bool:
    """Read a formula between dollar signs, in which no character is Markdown. A lone sign is one, too."""
    start = state.pos
    if state.src[start] != "$":
        return False
    end = state.src.find("$", start + 1, state.posMax)
    if not silent:
        token = state.push("formula", "", 0)
        token.markup = "$" if end < 0 else "$$"
        token.content = state.src[start + 1 : end] if end >= 0 else ""
    state.pos = start + 1 if end < 0 else end + 1
    return True


def _blocks(outside: SyntaxTreeNode, depth: int) -> prose.Blocks:
    """Return the blocks in a node of the tree; so many lists and quotations are around it."""
    blocks = (_block(node, depth) for node in outside.children)
    return tuple(block for block in blocks if block != prose.Paragraph(()))


def _block(node: SyntaxTreeNode, depth: int) -> prose.Block:
    match node.type:
        case "paragraph":
            return prose.Paragraph(_content(node))
        case "heading":
            if content := _content(node):
                return prose.Heading(int(node.tag[1]), content)
            raise _refused(node, r"a heading has no words; a # in prose is written \#")
        case "fence" | "code_block":
            return prose.CodeBlock(_lines(node.content.expandtabs(_TAB)))
        case "hr":
            return prose.Rule()
        case "blockquote":
            return prose.Quote(_deeper(node, depth))
        case "bullet_list" | "ordered_list":
            return _listing(node, depth)
        case "table":
            return _grid(node)
    raise AssertionError(node.type)


def _deeper(node: SyntaxTreeNode, depth: int) -> prose.Blocks:
    if depth == DEEPEST:
        raise _refused(node, f"lists and quotations are nested more than {DEEPEST} deep")
    return _blocks(node, depth + 1)


def _listing(node: SyntaxTreeNode, depth: int) -> prose.Listing:
    items = tuple(_deeper(item, depth) for item in node.children)
    # Only paragraphs that stand directly in an item set the items of a list apart, and a single block has
    # nothing to stand apart from.
    loose = any(one.type == "paragraph" and not one.hidden for item in node.children for one in item.children)
    tight = not loose or (len(items) == 1 and len(items[0]) == 1)
    return prose.Listing(
        int(node.attrs.get("start", 1)) if node.type == "ordered_list" else None, tight, items
    )


def _grid(node: SyntaxTreeNode) -> prose.Grid:
    rows = [row.children for part in node.children for row in part.children]
    head, *body = [tuple(map(_content, row)) for row in rows]
    styles = (str(cell.attrs.get("style", "")).removeprefix("text-align:") for cell in rows[0])
    aligns = tuple(cast("prose.Align | None", style or None) for style in styles)
    return prose.Grid(aligns, head, tuple(body))


def _content(node: SyntaxTreeNode) -> prose.Inlines:
    """Return what a paragraph, heading or cell holds, without white space and ends of lines around it."""
    content = _inlines(node.children[0], 0) if node.children else ()
    kept = [place for place, inline in enumerate(content) if inline not in (prose.Break(), prose.Text(" "))]
    return content[kept[0] : kept[-1] + 1] if kept else ()


def _lines(code: str) -> tuple[str, ...]:
    return tuple(code.removesuffix("\n").split("\n")) if code else ()


def _inlines(outside: SyntaxTreeNode, depth: int) -> prose.Inlines:
    """Return the inlines in a node, a run of text or emphasis in it; so much emphasis is around it."""
    if depth > _DEEPEST_INLINE:
        raise _refused(outside, f"emphasis is nested more than {_DEEPEST_INLINE} deep")
    return tuple(_joined(_inline(node, depth) for node in outside.children))


def _inline(node: SyntaxTreeNode, depth: int) -> prose.Inline:
    match node.type:
        case "text" | "text_special":
            return prose.Text(node.content)
        case "softbreak":
            return prose.Text(" ")
        case "hardbreak":
            return prose.Break()
        case "code_inline":
            return prose.Code(node.content)
        case "em":
            return prose.Emphasis(_inlines(node, depth + 1))
        case "strong":
            return prose.Strong(_inlines(node, depth + 1))
        case "link":
            return _link(node, str(node.attrs["href"]), _inlines(node, depth + 1))
        case "formula":
            return _formula(node)
        case "image":
            raise _refused(node, "a text can hold no images; a figure has its own place")
    raise AssertionError(node.type)


def _link(node: SyntaxTreeNode, address: str, content: prose.Inlines) -> prose.Inline:
    if address.startswith(_INDEX):
        return _indexed(node, " ".join(unquote(address.removeprefix(_INDEX)).split()), content)
    if address.startswith("#") and address != "#":
        return prose.Refer(unquote(address[1:]), content)
    if _SCHEME.match(address):
        return prose.Link(address, content or (prose.Text(address),))
    raise _refused(
        node,
        f'the link to "{address[:60]}" cannot be set; it must begin with http:, https: or mailto:,'
        " or be # and the name of a table, figure or chapter",
    )


def _indexed(node: SyntaxTreeNode, term: str, content: prose.Inlines) -> prose.Inline:
    """Return words for the index; the term is the words themselves where the text names no other."""
    if not content or not (term or all(isinstance(one, prose.Text) for one in content)):
        raise _refused(
            node, "words for the index are [words](index:) or, with another term, [words](<index:the term>)"
        )
    said = term or "".join(one.text for one in content if isinstance(one, prose.Text))
    if not said.isprintable() or len(said) > _LONGEST_TERM:
        raise _refused(node, f"a term of the index may have {_LONGEST_TERM} characters, all of them printed")
    return prose.Indexed(said, content)


def _formula(node: SyntaxTreeNode) -> Formula:
    if node.markup == "$":
        raise _refused(node, r"a formula needs a second $; a dollar sign in prose is written \$")
    try:
        return parse_formula(node.content)
    except MalformedError as error:
        written = WHITE.sub(" ", node.content)[:60]
        raise _refused(node, f'the formula "{written}" cannot be set: {error}') from None


def _refused(node: SyntaxTreeNode, reason: str) -> ProseError:
    """Return the error with the line of a block, or of the place in a run of text where a node was found."""
    around = node
    while not around.map and around.parent:
        around = around.parent
    line = around.map[0] + 1 if around.map else 1
    return ProseError(line + around.content.count("\n", 0, node.meta.get("at", 0)), reason)


def _joined(inlines: Iterable[prose.Inline]) -> Iterator[prose.Inline]:
    """Yield the inlines, neighbouring pieces of text as one."""
    for is_text, run in groupby(inlines, key=lambda inline: isinstance(inline, prose.Text)):
        if not is_text:
            yield from run
        elif text := primed(WHITE.sub(" ", "".join(one.text for one in run if isinstance(one, prose.Text)))):
            yield prose.Text(text)
