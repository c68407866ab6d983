"""Formulas in TeX's notation of mathematics, which others read too."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple

from kurbel.formats.formula_shape import has_bar, has_stroke, is_seen
from kurbel.page.formula import (
    GREEK,
    SIGNS,
    SYMBOLS,
    Fraction,
    Group,
    Nodes,
    Numeral,
    Root,
    Script,
    Sign,
    Space,
    Symbol,
    Upright,
    Variable,
    Word,
)

_COMMAND = re.compile(r"\\[A-Za-z]+$")


class TexMath(NamedTuple):
    """Sets formulas with a decimal mark; `upright` sets the words in them."""

    mark: str
    upright: Callable[[str], str]

    def set(self, nodes: Nodes) -> str:
        r"""Return what stands between dollar signs: x/R, \frac{1}{4{,}5}\cos\varphi. Needs amsmath."""
        result = ""
        for place in range(len(nodes)):
            piece = self._node(nodes, place)
            if piece[:1].isalpha() and _COMMAND.search(result):
                result += " "
            result += piece
        return result

    def _node(self, nodes: Nodes, place: int) -> str:
        node = nodes[place]
        match node:
            case Word(text):
                return f"\\{text}"
            case Variable(text):
                return GREEK.get(text, text)
            case Numeral(text):
                return text.replace(".", "{,}" if self.mark == "," else self.mark)
            case Sign(text):
                return SIGNS[text][1]
            case Symbol(text):
                return SYMBOLS[text][1]
            case Upright(text):
                return f"\\text{{{self.upright(text)}}}"
            case Space():
                return r"\," * is_seen(nodes, place)
            case Group(content, fences):
                left, right = (r"\left", r"\right") if has_bar(content) else ("", "")
                return f"{left}{fences[0]}{self.set(content)}{right}{fences[1]}"
            case Root(content):
                return f"\\sqrt{{{self.set(content)}}}"
            case Fraction(top, bottom) if has_stroke(nodes, place):
                below = self.set(bottom if len(bottom) == 1 else (Group(bottom),))
                return f"{self.set(top)}/{below}"
            case Fraction(top, bottom):
                return f"\\frac{{{self.set(top)}}}{{{self.set(bottom)}}}"
            case Script(base, index, power):
                inner = self.set((base,))
                below = f"_{{{self.set(index)}}}" if index else ""
                above = f"^{{{self.set(power)}}}" if power else ""
                return (f"{{{inner}}}" if isinstance(base, Symbol) else inner) + below + above
