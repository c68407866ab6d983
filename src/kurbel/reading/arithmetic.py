"""Formulas as they are written, as trees of Python's with exact numbers, and what their signs do.

Whoever reads a formula allows what may stand in it. What comes of it is bounded, see `exact/separation.py`.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from itertools import accumulate
from types import MappingProxyType
from typing import Any

from kurbel.errors import NotationError
from kurbel.exact import separation
from kurbel.exact.numerals import about

LONGEST, DEEPEST = 500, 100
# Of the powers in a book's formulas.
POWERS = range(10)
_DIGITS = re.compile(r"[0-9]+(\.[0-9]+)?")
OPERATIONS: Mapping[type, Callable[..., Any]] = {
    ast.Add: separation.plus,
    ast.Sub: separation.minus,
    ast.Mult: separation.times,
    ast.Div: separation.over,
}


def wrong_power(text: str, power: Fraction) -> NotationError:
    """Return what is said of a formula with a power that is none of the few that are computed."""
    return NotationError(
        f'"{text[:60]}" has the power {about(power)}; powers are whole numbers from {POWERS[0]} to'
        f" {POWERS[-1]}"
    )


def digits(text: str) -> Fraction:
    """Return a number that is written as 0.125."""
    if not _DIGITS.fullmatch(text):
        raise NotationError(f'"{text[:40]}" is no number of an expression; write digits, such as 0.125')
    return Fraction(text)


def parsed(
    text: str,
    what: str,
    unread: str,
    numbers: Mapping[str, Fraction] = MappingProxyType({}),
    number: Callable[[str], Fraction] = digits,
) -> ast.expr:
    """Return the tree of a formula, its numbers Fractions, also those that have the names of `numbers`.

    `what` it is called, sentences say; `unread` is that of one that cannot be read. `number` reads a number.
    """
    if len(text) > LONGEST:
        raise NotationError(f"the {what} has {len(text)} characters; at most {LONGEST} are read")
    if _depth(text) > DEEPEST:
        raise NotationError(
            f'the {what} "{text[:60]}" has more than {DEEPEST} brackets within each other; write it with'
            " fewer"
        )
    written = text.replace("^", "**").strip()
    try:
        read: ast.expr = _Numbers(written, numbers, number).visit(ast.parse(written, mode="eval")).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise NotationError(unread) from None
    return read


def _depth(text: str) -> int:
    """Return how many brackets stand within each other."""
    return max(accumulate((one in "([") - (one in ")]") for one in text), default=0)


class _Numbers(ast.NodeTransformer):
    """Takes the numbers from the characters, for a decimal fraction is no float."""

    def __init__(
        self, written: str, numbers: Mapping[str, Fraction], number: Callable[[str], Fraction]
    ) -> None:
        self.written = written
        self.numbers = numbers
        self.number = number

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Put its number for a name that has one."""
        return _constant(self.numbers[node.id], node) if node.id in self.numbers else node

    def visit_Constant(self, node: ast.Constant) -> ast.Constant:
        """Put a Fraction for the number as it is written."""
        if isinstance(node.value, str):
            return node
        return _constant(self.number(ast.get_source_segment(self.written, node) or ""), node)


def _constant(value: Fraction, place: ast.expr) -> ast.Constant:
    # The tree is never compiled, so that a constant may be what Python's own are not.
    return ast.copy_location(ast.Constant(value), place)  # type: ignore[arg-type]
