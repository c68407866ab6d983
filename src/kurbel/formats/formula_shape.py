"""What engines that set formulas must be told of their shape: strokes or bars, and spaces that are seen."""

from __future__ import annotations

from kurbel.page.formula import (
    Fraction,
    Group,
    Node,
    Nodes,
    Numeral,
    Root,
    Script,
    Sign,
    Upright,
    is_function,
)
from kurbel.page.labels import beside, is_sum

_RELATIONS = frozenset("=<>≤≥≈:")


def has_stroke(nodes: Nodes, place: int) -> bool:
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


def has_bar(nodes: Nodes) -> bool:
    """Tell whether a sequence has a fraction with a bar, which needs height."""
    return any(
        has_bar(node.content)
        if isinstance(node, Group | Root)
        else isinstance(node, Fraction) and not has_stroke(nodes, place)
        for place, node in enumerate(nodes)
    )


def is_seen(nodes: Nodes, place: int) -> bool:
    """Tell whether a space must be set because the engine, which spaces by itself, would set none.

    A unit needs it, and two numbers, which would run into one.
    """
    before, after = nodes[place - 1], nodes[place + 1]
    both_numbers = isinstance(before, Numeral) and isinstance(after, Numeral)
    return both_numbers or _is_unit(before) or _is_unit(after)


def _is_unit(node: Node) -> bool:
    """Tell whether a node is a unit or the power of one: min^(-1)."""
    return isinstance(node.base if isinstance(node, Script) else node, Upright)
