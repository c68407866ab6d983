"""Formulas in Typst."""

from __future__ import annotations

from kurbel.formats.formula_shape import has_bar, has_stroke, is_seen
from kurbel.formats.typst.escapes import string
from kurbel.page.formula import (
    SIGNS,
    SYMBOLS,
    Formula,
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
from kurbel.page.labels import formula_plain


def equation(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula for Typst with a text for readers that do not see it, which PDF/UA asks for.

    `display` gives fractions their full size, and the line the height for it.
    """
    content = _typst(formula.content, mark)
    alternative = string(formula_plain(formula, mark))
    if display and has_bar(formula.content):
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
            return string(text)
        case Space():
            return "thin" * is_seen(nodes, place)
        case Group(content, fences):
            return f"{fences[0]}{_typst(content, mark)}{fences[1]}"
        case Root(content):
            return f"sqrt({_typst(content, mark)})"
        case Fraction(top, bottom) if has_stroke(nodes, place):
            below = _typst(bottom if len(bottom) == 1 else (Group(bottom),), mark)
            return f"{_typst(top, mark)}\\/{below}"
        case Fraction(top, bottom):
            return f"frac({_typst(top, mark)}, {_typst(bottom, mark)})"
        case Script(base, index, power):
            below = f"_({_typst(index, mark)})" if index else ""
            above = f"^({_typst(power, mark)})" if power else ""
            return _typst((base,), mark) + below + above
