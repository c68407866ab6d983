"""Labels in HTML, with formulas in MathML."""

from __future__ import annotations

import re

from kurbel.formats.formula import has_bar, has_stroke, is_seen
from kurbel.formats.writer import PageWriter
from kurbel.page import formula as tree
from kurbel.page.formula import Formula
from kurbel.page.labels import beside


class Writer(PageWriter):
    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        text = f"{escape(mark)})"
        return f'<sup><a href="#{escape(target)}">{text}</a></sup>' if target else f"<sup>{text}</sup>"

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        style = ' displaystyle="true"' if display and has_bar(formula.content) else ""
        return f"<math{style}>{_mathml(formula.content, mark)}</math>"

    def finish(self, label: str) -> str:
        """Return a label that was set, with every formula on one line with the signs that touch it."""
        return _BESIDE_FORMULA.sub(_kept, label)

    def drawing(self, svg: str, name: str, title: str) -> str:
        from kurbel.formats.html.svg import inline

        return inline(svg, name, title, own_page=False)


_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return prose.translate(_HTML)


# Browsers break a line between a formula and a sign beside it, whatever the sign.
_BESIDE_FORMULA = re.compile(r"(?<![^\s<>])(?:[^\s<>]*<math.*?</math>)+[^\s<>]*")


def _kept(match: re.Match[str]) -> str:
    text = match[0]
    alone = text.startswith("<math") and text.endswith("</math>")
    return text if alone else f'<span class="kept">{text}</span>'


def _mathml(nodes: tree.Nodes, mark: str) -> str:
    return "".join(_mathml_node(nodes, place, mark) for place in range(len(nodes)))


def _mathml_node(nodes: tree.Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case tree.Word(text):
            return f"{_apart(nodes, place)}<mi>{text}</mi>{_apply(nodes, place)}"
        case tree.Variable(text):
            return f'<mi mathvariant="normal">{text}</mi>' if text in tree.CAPITALS else f"<mi>{text}</mi>"
        case tree.Numeral(text):
            return f"<mn>{text.replace('.', mark)}</mn>"
        case tree.Sign(text):
            tight = ' lspace="0" rspace="0"' if text == ":" else ""
            return f"<mo{tight}>{escape(tree.SIGNS[text][0])}</mo>"
        case tree.Symbol(text):
            return f'<mi mathvariant="normal">{tree.SYMBOLS[text][0]}</mi>'
        case tree.Upright(text):
            return f"<mtext>{escape(text)}</mtext>"
        case tree.Space():
            return _THIN * is_seen(nodes, place)
        case tree.Group(content, fences):
            # Fences that may stretch are set with side bearings, even around a single line.
            fixed = "" if has_bar(content) else ' stretchy="false"'
            opening, closing = (f"<mo{fixed}>{fence}</mo>" for fence in fences)
            return f"<mrow>{opening}{_mathml(content, mark)}{closing}</mrow>"
        case tree.Root(content):
            return f"<msqrt>{_mathml(content, mark)}</msqrt>"
        case tree.Fraction(top, bottom) if has_stroke(nodes, place):
            below = _mathml(bottom if len(bottom) == 1 else (tree.Group(bottom),), mark)
            return f'{_mathml(top, mark)}<mo lspace="0" rspace="0">/</mo>{below}'
        case tree.Fraction(top, bottom):
            return f"<mfrac>{_row(top, mark)}{_row(bottom, mark)}</mfrac>"
        case tree.Script(base, index, power):
            tag = "m" + "sub" * bool(index) + "sup" * bool(power)
            inner = "".join(_row(nodes, mark) for nodes in ((base,), index, power) if nodes)
            function = tree.is_function(base)
            before, after = (_apart(nodes, place), _apply(nodes, place)) if function else ("", "")
            return f"{before}<{tag}>{inner}</{tag}>{after}"


def _row(nodes: tree.Nodes, mark: str) -> str:
    content = _mathml(nodes, mark)
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
