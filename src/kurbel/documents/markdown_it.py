"""Markdown, in which texts are written: what markdown-it reads in it, and text that it does not obey."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.rules_inline import StateInline
    from markdown_it.tree import SyntaxTreeNode

    Rule = Callable[[StateInline, bool], bool]


def tree_of(text: str) -> SyntaxTreeNode:
    """Return the tree of a text. Its links, images and formulas say in `meta` where they begin."""
    from markdown_it.tree import SyntaxTreeNode

    return SyntaxTreeNode(_parser().parse(text))


@lru_cache(maxsize=1)
def _parser() -> MarkdownIt:
    from markdown_it import MarkdownIt
    from markdown_it.rules_inline import autolink, image, link

    # Beyond its nesting the parser drops text: what a text may have must lie well below.
    parser = MarkdownIt("commonmark", {"html": False, "maxNesting": 20}).enable("table")
    # What links may be is said in a sentence; an address that is refused here would only be printed.
    parser.validateLink = lambda url: True  # type: ignore[method-assign]
    parser.inline.ruler.push("formula", _placed(_formula))
    for name, rule in (("link", link), ("autolink", autolink), ("image", image)):
        parser.inline.ruler.at(name, _placed(rule))
    return parser


def _placed(rule: Rule) -> Rule:
    """Return the rule, which then notes in its first token where in the text it was found."""

    def placed(state: StateInline, silent: bool) -> bool:
        start, count = state.pos, len(state.tokens)
        found = rule(state, silent)
        for token in state.tokens[count:] if found and not silent else ():
            if token.type in ("link_open", "image", "formula"):
                token.meta["at"] = start
                break
        return found

    return placed


def _formula(state: StateInline, silent: bool) -> bool:
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


_OBEYED = re.compile(r"[\\`*_\[\]<>|~$]|&(?=[#A-Za-z])")
# At the start of a line these make a list or a heading.
_START = re.compile(r"^( *)([-+=]|#+|[0-9]+(?=[.)](?: |$)))(?=[ .)]|$)")


def escaped(text: str) -> str:
    """Return a text so that every character of it is printed and none obeyed."""
    return _START.sub(_escape_start, _OBEYED.sub(r"\\\g<0>", text))


def _escape_start(match: re.Match[str]) -> str:
    space, start = match.groups()
    return f"{space}{start}\\" if start.isdigit() else f"{space}\\{start}"
