"""Formulas, prose and marks of labels as plain Unicode text."""

from __future__ import annotations

from kurbel.page.formula import (
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

# Characters that Unicode has raised.
POWERS = dict(
    zip(
        "0123456789−+)abcdefghijklmnoprstuvwxyz",
        "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ",
        strict=True,
    )
)


def escape_text(prose: str) -> str:
    return prose


def mark_text(mark: str, target: str = "") -> str:
    """Return a mark raised, ᵃ⁾, or as it is, *), where Unicode has no raised character. Text has no links."""
    closed = f"{mark})"
    return "".join(POWERS[character] for character in closed) if set(closed) <= POWERS.keys() else closed


def formula_plain(formula: Formula, mark: str = ".", display: bool = False) -> str:
    """Return a formula in one line of Unicode: sin(φ±ψ)/cos ψ, xₘ, φ². It has no other size."""
    return _text(formula.content, mark)


def _text(nodes: Nodes, mark: str) -> str:
    return "".join(_text_node(nodes, place, mark) for place in range(len(nodes)))


def _text_node(nodes: Nodes, place: int, mark: str) -> str:
    match nodes[place]:
        case Sign(text):
            return SIGNS[text][0]
        case Symbol(text):
            return SYMBOLS[text][0]
        case Numeral(text):
            return text.replace(".", mark)
        case Space():
            return " "
        case Group(content, fences):
            return f"{fences[0]}{_text(content, mark)}{fences[1]}"
        case Root((Numeral(text),)) if text.isdigit():
            return f"√{text}"
        case Root(content):
            return f"√({_text(content, mark)})"
        case Fraction(top, bottom):
            return _text_fraction(nodes, place, top, bottom, mark)
        case Script(Root(content), index, power):
            scripts = _small(index, "_", _INDICES, mark) + _small(power, "^", POWERS, mark)
            return f"√({_text(content, mark)}){scripts}"
        case Script(base, index, power):
            scripts = _small(index, "_", _INDICES, mark) + _small(power, "^", POWERS, mark)
            return _text((base,), mark) + scripts
        case Word(text) | Variable(text) | Upright(text):
            return text


def _text_fraction(nodes: Nodes, place: int, top: Nodes, bottom: Nodes, mark: str) -> str:
    """Write a fraction with a stroke, and with parentheses where the stroke alone would be misread."""
    alone_before = place == 0 or isinstance(beside(nodes, place, -1), Sign)
    alone_after = place == len(nodes) - 1 or isinstance(beside(nodes, place, 1), Sign)
    above, below = _text(top, mark), _text(bottom, mark)
    if is_sum(top) or _is_open(top) or (len(top) > 1 and not alone_before):
        above = f"({above})"
    if is_sum(bottom) or (len(bottom) > 1 and not (alone_after and is_function(bottom[0]))):
        below = f"({below})"
    return f"{above}/{below}"


def _is_open(nodes: Nodes) -> bool:
    """Tell whether the argument of a function has no parentheses: (cos φ)/2 is not cos φ/2."""
    return any(
        is_function(node) and not isinstance(after, Group)
        for node, after in zip(nodes, (*nodes[1:], None), strict=True)
    )


def beside(nodes: Nodes, place: int, step: int) -> Node:
    """Return the next node that is not a space; spaces never end a sequence."""
    place += step
    return nodes[place + step] if isinstance(nodes[place], Space) else nodes[place]


def is_sum(nodes: Nodes) -> bool:
    return any(isinstance(node, Sign | Fraction) for node in nodes)


_INDICES = dict(zip("0123456789aehijklmnoprstuvxβγρφχ", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ", strict=True))


def _small(nodes: Nodes, sign: str, small: dict[str, str], mark: str) -> str:
    if not nodes:
        return ""
    text = _text(nodes, mark)
    if all(character in small for character in text):
        return "".join(small[character] for character in text)
    return f"{sign}{text}" if len(text) == 1 else f"{sign}({text})"
