"""Formulas: what engines that set them must be told of their shape, and how TeX and MathML note them."""

from __future__ import annotations

import html
import re
from collections.abc import Callable
from typing import NamedTuple

from kurbel.page import formula as tree
from kurbel.page.labels import beside, is_sum

_RELATIONS = frozenset("=<>≤≥≈:")
_COMMAND = re.compile(r"\\[A-Za-z]+$")

# Characters that TeX obeys, as it prints them.
TEX_OBEYED = {character: f"\\{character}" for character in "#$%&_{}"} | {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "`": r"\textasciigrave{}",
}


def has_stroke(nodes: tree.Nodes, place: int) -> bool:
    """Tell whether an engine should set a fraction with a stroke: x/R, not a small x over a small R.

    So it does for a fraction of letters and numbers that is a whole side of its formula. One that stands
    among factors or in a sum would be misread, and one of functions is easier to read with a bar.
    """
    fraction = nodes[place]
    assert isinstance(fraction, tree.Fraction)
    neighbours = [beside(nodes, place, step) for step in (-1, 1) if 0 <= place + step < len(nodes)]
    if not all(isinstance(node, tree.Sign) and node.text in _RELATIONS for node in neighbours):
        return False
    parts = fraction.top + fraction.bottom
    return not is_sum(parts) and not any(tree.is_function(node) for node in parts)


def has_bar(nodes: tree.Nodes) -> bool:
    """Tell whether a sequence has a fraction with a bar, which needs height."""
    return any(
        has_bar(node.content)
        if isinstance(node, tree.Group | tree.Root | tree.Overline)
        else isinstance(node, tree.Fraction) and not has_stroke(nodes, place)
        for place, node in enumerate(nodes)
    )


def is_seen(nodes: tree.Nodes, place: int) -> bool:
    """Tell whether a space must be set because the engine, which spaces by itself, would set none.

    A unit needs it, and two numbers, which would run into one.
    """
    before, after = nodes[place - 1], nodes[place + 1]
    both_numbers = isinstance(before, tree.Numeral) and isinstance(after, tree.Numeral)
    return both_numbers or _is_unit(before) or _is_unit(after)


def _is_unit(node: tree.Node) -> bool:
    """Tell whether a node is a unit or the power of one: min^(-1)."""
    return isinstance(node.base if isinstance(node, tree.Script) else node, tree.Upright)


class TexMath(NamedTuple):
    """Sets formulas with a decimal mark; `upright` sets the words in them, `dots` is the command of …."""

    mark: str
    upright: Callable[[str], str]
    dots: str = tree.SYMBOLS["…"][1]

    def set(self, nodes: tree.Nodes) -> str:
        r"""Return what stands between dollar signs: x/R, \frac{1}{4{,}5}\cos\varphi. Needs amsmath."""
        result = ""
        for place in range(len(nodes)):
            piece = self._node(nodes, place)
            if piece[:1].isalpha() and _COMMAND.search(result):
                result += " "
            result += piece
        return result

    def _node(self, nodes: tree.Nodes, place: int) -> str:
        node = nodes[place]
        match node:
            case tree.Word(text):
                return f"\\{text}"
            case tree.Variable(text):
                return tree.GREEK.get(text, text)
            case tree.Numeral(text):
                return text.replace(".", "{,}" if self.mark == "," else self.mark)
            case tree.Sign(text):
                return tree.SIGNS[text][1]
            case tree.Symbol("…"):
                return self.dots
            case tree.Symbol(text):
                return tree.SYMBOLS[text][1]
            case tree.Upright(text):
                return f"\\text{{{self.upright(text)}}}"
            case tree.Space():
                return r"\," * is_seen(nodes, place)
            case tree.Group(content, fences):
                left, right = (r"\left", r"\right") if has_bar(content) else ("", "")
                return f"{left}{fences[0]}{self.set(content)}{right}{fences[1]}"
            case tree.Root(content):
                return f"\\sqrt{{{self.set(content)}}}"
            case tree.Overline(content):
                return f"\\overline{{{self.set(content)}}}"
            case tree.Fraction(top, bottom) if has_stroke(nodes, place):
                below = self.set(bottom if len(bottom) == 1 else (tree.Group(bottom),))
                return f"{self.set(top)}/{below}"
            case tree.Fraction(top, bottom):
                return f"\\frac{{{self.set(top)}}}{{{self.set(bottom)}}}"
            case tree.Script(base, index, power):
                inner = self.set((base,))
                below = f"_{{{self.set(index)}}}" if index else ""
                above = f"^{{{self.set(power)}}}" if power else ""
                return (f"{{{inner}}}" if isinstance(base, tree.Symbol) else inner) + below + above


def mathml(nodes: tree.Nodes, mark: str) -> str:
    """Return the elements of MathML within <math>, numbers with a decimal mark."""
    return "".join(_mathml_node(nodes, place, mark) for place in range(len(nodes)))


def _mathml_node(nodes: tree.Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case tree.Word(text):
            return f'{_apart(nodes, place)}<mi class="name">{text}</mi>{_apply(nodes, place)}'
        case tree.Variable(text):
            return f'<mi mathvariant="normal">{text}</mi>' if text in tree.CAPITALS else f"<mi>{text}</mi>"
        case tree.Numeral(text):
            return f"<mn>{text.replace('.', mark)}</mn>"
        case tree.Sign(text):
            tight = ' lspace="0" rspace="0"' if text == ":" else ""
            return f"<mo{tight}>{html.escape(tree.SIGNS[text][0], quote=False)}</mo>"
        case tree.Symbol(text):
            return f'<mi mathvariant="normal">{tree.SYMBOLS[text][0]}</mi>'
        case tree.Upright(text):
            return f"<mtext>{html.escape(text, quote=False)}</mtext>"
        case tree.Space():
            return _THIN * is_seen(nodes, place)
        case tree.Group(content, fences):
            # Fences that may stretch are set with side bearings, even around a single line.
            grows = str(has_bar(content)).lower()
            opening, closing = (f'<mo stretchy="{grows}">{fence}</mo>' for fence in fences)
            return f"<mrow>{opening}{mathml(content, mark)}{closing}</mrow>"
        case tree.Root(content):
            return f"<msqrt>{mathml(content, mark)}</msqrt>"
        case tree.Overline(content):
            bar = '<mo stretchy="true">&#x203E;</mo>'
            return f'<mover accent="true"><mrow>{mathml(content, mark)}</mrow>{bar}</mover>'
        case tree.Fraction(top, bottom) if has_stroke(nodes, place):
            below = mathml(bottom if len(bottom) == 1 else (tree.Group(bottom),), mark)
            return f'{mathml(top, mark)}<mo lspace="0" rspace="0">/</mo>{below}'
        case tree.Fraction(top, bottom):
            return f"<mfrac>{_row(top, mark)}{_row(bottom, mark)}</mfrac>"
        case tree.Script(base, index, power):
            tag = "m" + "sub" * bool(index) + "sup" * bool(power)
            inner = "".join(_row(nodes, mark) for nodes in ((base,), index, power) if nodes)
            function = tree.is_function(base)
            before, after = (_apart(nodes, place), _apply(nodes, place)) if function else ("", "")
            return f"{before}<{tag}>{inner}</{tag}>{after}"


def _row(nodes: tree.Nodes, mark: str) -> str:
    content = mathml(nodes, mark)
    # A fraction with a stroke is one node but three elements.
    single = len(nodes) == 1 and not (isinstance(nodes[0], tree.Fraction) and has_stroke(nodes, 0))
    return content if single else f"<mrow>{content}</mrow>"


_THIN = '<mspace width="0.167em"/>'


def _apart(nodes: tree.Nodes, place: int) -> str:
    """Return the thin space between a factor and a function, which browsers do not set by themselves."""
    return "" if place == 0 or isinstance(beside(nodes, place, -1), tree.Sign) else _THIN


def _apply(nodes: tree.Nodes, place: int) -> str:
    """Return the invisible sign that binds a function to what follows it, and the space after it."""
    if place == len(nodes) - 1 or isinstance(beside(nodes, place, 1), tree.Sign):
        return ""
    argument = beside(nodes, place, 1)
    return "<mo>&#x2061;</mo>" + _THIN * (
        not isinstance(argument, tree.Group | tree.Word) and not tree.is_function(argument)
    )
