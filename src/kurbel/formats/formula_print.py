"""Formulas in print: one line of Unicode, LaTeX, MathML, Typst.

A new format adds a function named after it; `Format.formula` finds it by this name.
"""

from __future__ import annotations

import re

from kurbel.formats.escapes import escape_html, escape_latex, escape_markdown, string_typst
from kurbel.page.formula import (
    CAPITALS,
    GREEK,
    SIGNS,
    SYMBOLS,
    Formula,
    Fraction,
    Group,
    Node,
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
    is_function,
)
from kurbel.page.plain import beside, formula_plain, is_sum


def formula_text(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula in one line of Unicode that no line end may cut."""
    return formula_plain(formula, mark).replace(" ", "\u00a0")


_RELATIONS = frozenset("=<>≤≥≈:")


def _has_stroke(nodes: Nodes, place: int) -> bool:
    """Tell whether an engine should set a fraction with a stroke: x/R, not a small x over a small R.

    So it does for a fraction of letters and numbers that is a whole side of its formula. One that stands
    among factors or in a sum would be misread, and one of functions is easier to read with a bar.
    """
    fraction = nodes[place]
    assert isinstance(fraction, Fraction)
    neighbours = [beside(nodes, place, step) for step in (-1, 1) if 0 <= place + step < len(nodes)]
    if not all(isinstance(node, Sign) and node.text in _RELATIONS for node in neighbours):
        return False
    parts = fraction.top + fraction.bottom
    return not is_sum(parts) and not any(is_function(node) for node in parts)


def _has_bar(nodes: Nodes) -> bool:
    """Tell whether a sequence has a fraction with a bar, which needs height."""
    return any(
        _has_bar(node.content)
        if isinstance(node, Group | Root)
        else isinstance(node, Fraction) and not _has_stroke(nodes, place)
        for place, node in enumerate(nodes)
    )


def formula_markdown(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula as text; dollar signs are left alone, since many readers of Markdown print them."""
    return escape_markdown(formula_plain(formula, mark))


_COMMAND = re.compile(r"\\[A-Za-z]+$")


def formula_latex(formula: Formula, mark: str = ".", display: bool = False) -> str:
    r"""Return a formula for LaTeX, dollar signs included: $x/R$, $\frac{1}{4{,}5}\cos\varphi$. Needs amsmath.

    `display` gives fractions their full size, and the line the height for it.
    """
    content = _latex(formula.content, mark)
    if display and _has_bar(formula.content):
        return f"$\\displaystyle {content}\\rule[-1.05em]{{0pt}}{{2.7em}}$"
    return f"${content}$"


def _latex(nodes: Nodes, mark: str) -> str:
    result = ""
    for place in range(len(nodes)):
        piece = _latex_node(nodes, place, mark)
        if piece[:1].isalpha() and _COMMAND.search(result):
            result += " "
        result += piece
    return result


def _latex_node(nodes: Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case Word(text):
            return f"\\{text}"
        case Variable(text):
            return GREEK.get(text, text)
        case Numeral(text):
            return text.replace(".", "{,}" if mark == "," else mark)
        case Sign(text):
            return SIGNS[text][1]
        case Symbol(text):
            return SYMBOLS[text][1]
        case Upright(text):
            return f"\\text{{{escape_latex(text)}}}"
        case Space():
            return r"\," * _is_seen(nodes, place)
        case Group(content, fences):
            left, right = (r"\left", r"\right") if _has_bar(content) else ("", "")
            return f"{left}{fences[0]}{_latex(content, mark)}{right}{fences[1]}"
        case Root(content):
            return f"\\sqrt{{{_latex(content, mark)}}}"
        case Fraction(top, bottom) if _has_stroke(nodes, place):
            below = _latex(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f"{_latex(top, mark)}/{below}"
        case Fraction(top, bottom):
            return f"\\frac{{{_latex(top, mark)}}}{{{_latex(bottom, mark)}}}"
        case Script(base, index, power):
            inner = _latex((base,), mark)
            below = f"_{{{_latex(index, mark)}}}" if index else ""
            above = f"^{{{_latex(power, mark)}}}" if power else ""
            return (f"{{{inner}}}" if isinstance(base, Symbol) else inner) + below + above


def _is_seen(nodes: Nodes, place: int) -> bool:
    """Tell whether a space must be set because the engine, which spaces by itself, would set none.

    A unit needs it, and two numbers, which would run into one.
    """
    before, after = nodes[place - 1], nodes[place + 1]
    both_numbers = isinstance(before, Numeral) and isinstance(after, Numeral)
    return both_numbers or _is_unit(before) or _is_unit(after)


def _is_unit(node: Node) -> bool:
    """Tell whether a node is a unit or the power of one: min^(-1)."""
    return isinstance(node.base if isinstance(node, Script) else node, Upright)


def formula_html(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula in MathML; `display` gives fractions their full size."""
    style = ' displaystyle="true"' if display and _has_bar(formula.content) else ""
    return f"<math{style}>{_mathml(formula.content, mark)}</math>"


def _mathml(nodes: Nodes, mark: str) -> str:
    return "".join(_mathml_node(nodes, place, mark) for place in range(len(nodes)))


def _mathml_node(nodes: Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case Word(text):
            return f"{_apart(nodes, place)}<mi>{text}</mi>{_apply(nodes, place)}"
        case Variable(text):
            return f'<mi mathvariant="normal">{text}</mi>' if text in CAPITALS else f"<mi>{text}</mi>"
        case Numeral(text):
            return f"<mn>{text.replace('.', mark)}</mn>"
        case Sign(text):
            tight = ' lspace="0" rspace="0"' if text == ":" else ""
            return f"<mo{tight}>{escape_html(SIGNS[text][0])}</mo>"
        case Symbol(text):
            return f'<mi mathvariant="normal">{SYMBOLS[text][0]}</mi>'
        case Upright(text):
            return f"<mtext>{escape_html(text)}</mtext>"
        case Space():
            return _THIN * _is_seen(nodes, place)
        case Group(content, fences):
            # Fences that may stretch are set with side bearings, even around a single line.
            fixed = "" if _has_bar(content) else ' stretchy="false"'
            opening, closing = (f"<mo{fixed}>{fence}</mo>" for fence in fences)
            return f"<mrow>{opening}{_mathml(content, mark)}{closing}</mrow>"
        case Root(content):
            return f"<msqrt>{_mathml(content, mark)}</msqrt>"
        case Fraction(top, bottom) if _has_stroke(nodes, place):
            below = _mathml(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f'{_mathml(top, mark)}<mo lspace="0" rspace="0">/</mo>{below}'
        case Fraction(top, bottom):
            return f"<mfrac>{_row(top, mark)}{_row(bottom, mark)}</mfrac>"
        case Script(base, index, power):
            tag = "m" + "sub" * bool(index) + "sup" * bool(power)
            inner = "".join(_row(nodes, mark) for nodes in ((base,), index, power) if nodes)
            function = is_function(base)
            before, after = (_apart(nodes, place), _apply(nodes, place)) if function else ("", "")
            return f"{before}<{tag}>{inner}</{tag}>{after}"


def _row(nodes: Nodes, mark: str) -> str:
    content = _mathml(nodes, mark)
    # A fraction with a stroke is one node but three elements.
    single = len(nodes) == 1 and not (isinstance(nodes[0], Fraction) and _has_stroke(nodes, 0))
    return content if single else f"<mrow>{content}</mrow>"


_THIN = '<mspace width="0.167em"/>'


def _apart(nodes: Nodes, place: int) -> str:
    """Return the thin space between a factor and a function, which browsers do not set by themselves."""
    return "" if place == 0 or isinstance(beside(nodes, place, -1), Sign) else _THIN


def _apply(nodes: Nodes, place: int) -> str:
    """Return the invisible sign that binds a function to what follows it, and the space after it."""
    if place == len(nodes) - 1 or isinstance(beside(nodes, place, 1), Sign):
        return ""
    argument = beside(nodes, place, 1)
    return "<mo>&#x2061;</mo>" + _THIN * (
        not isinstance(argument, Group | Word) and not is_function(argument)
    )


def formula_typst(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula for Typst with a text for readers that do not see it, which PDF/UA asks for.

    `display` gives fractions their full size, and the line the height for it.
    """
    content = _typst(formula.content, mark)
    alternative = string_typst(formula_plain(formula, mark))
    if display and _has_bar(formula.content):
        # The empty box is as high above the middle of the digits beside it as it is deep below.
        content = f"display({content})#box(height: 2.9em, baseline: 1.12em)"
    return f"#math.equation(alt: {alternative}, ${content}$);"


# Beside these nothing runs together; a space beside quotation marks would be printed.
_TYPST_CLOSED = frozenset('()[]"')


def _typst(nodes: Nodes, mark: str) -> str:
    result = ""
    for place in range(len(nodes)):
        piece = _typst_node(nodes, place, mark)
        result += " " * _would_join(result[-1:], piece[:1]) + piece
    return result


def _would_join(before: str, after: str) -> bool:
    """Tell whether two characters would be read as one word or, as -> is, one sign."""
    if not before or not after or {before, after} & _TYPST_CLOSED:
        return False
    return _in_word(before) == _in_word(after)


def _in_word(character: str) -> bool:
    """Tell whether Typst reads a character behind a letter as part of the word, as it does with a · too."""
    return f"x{character}".isidentifier()


def _typst_node(nodes: Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case Word(text) | Variable(text):
            return text
        case Numeral(text):
            # A comma in quotes, for else it is set with the space of a list.
            return text.replace(".", '","' if mark == "," else mark)
        case Sign(":"):
            return '":"'
        case Sign(text):
            return SIGNS[text][0]
        case Symbol(text):
            return f'"{SYMBOLS[text][0]}"'
        case Upright(text):
            return string_typst(text)
        case Space():
            return "thin" * _is_seen(nodes, place)
        case Group(content, fences):
            return f"{fences[0]}{_typst(content, mark)}{fences[1]}"
        case Root(content):
            return f"sqrt({_typst(content, mark)})"
        case Fraction(top, bottom) if _has_stroke(nodes, place):
            below = _typst(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f"{_typst(top, mark)}\\/{below}"
        case Fraction(top, bottom):
            return f"frac({_typst(top, mark)}, {_typst(bottom, mark)})"
        case Script(base, index, power):
            below = f"_({_typst(index, mark)})" if index else ""
            above = f"^({_typst(power, mark)})" if power else ""
            return _typst((base,), mark) + below + above
