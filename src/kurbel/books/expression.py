"""Arithmetic of a source's cells: "1 - cos(45) + 0.1 * sin(45)^2", "v_max - v_min", on numbers of any kind.

An expression has numbers, names of other cells, + - * / ^, brackets and the functions sin, cos (of degrees),
arccos (in degrees), sqrt and ln. It is evaluated on balls, or on separation bounds to tell whether its value
can be a tie.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

from kurbel.errors import NotationError
from kurbel.exact.separation import power
from kurbel.reading.arithmetic import OPERATIONS, POWERS, parsed, wrong_power

UNREAD = '"{}" is no expression; write one such as 1 - cos(45)'
FUNCTIONS = ("sin", "cos", "sqrt", "ln", "arccos")


class Kind(NamedTuple):
    """A kind of number: of a fraction, sine and cosine of exact degrees, logarithm, arc and root."""

    of: Callable[[Fraction], Any]
    circle: Callable[[Fraction], Any]
    ln: Callable[[Any], Any]
    arccos: Callable[[Any], Any]
    root: Callable[[Any], Any] = lambda value: value**0.5


class IrrationalError(ArithmeticError):
    """A value is not of the kind, or not known to be."""


def irrational(value: Any) -> Any:
    """Raise IrrationalError: what stands for a function whose values are not of the kind."""
    raise IrrationalError


def fraction_root(square: Fraction) -> Fraction:
    """Return the square root; raise IrrationalError if it is no fraction."""
    root = Fraction(isqrt(max(square.numerator, 0)), isqrt(square.denominator))
    return root if root * root == square else irrational(square)


class Expression:
    """An expression that was read once; `names` are the other cells in it, `transcendental` has a logarithm
    or an arc.

    `numbers` stand in place of their names, also in sines and cosines. With `later` those of names in sines
    and cosines are to come, by `with_numbers`.
    """

    def __init__(
        self, text: str, numbers: Mapping[str, Fraction] | None = None, *, later: bool = False
    ) -> None:
        self.text = text
        self._tree = parsed(text, "expression", UNREAD.format(text[:60]), numbers or {})
        _check(self._tree, text, later)
        named = {node.id for node in ast.walk(self._tree) if isinstance(node, ast.Name)}
        self.names = frozenset(named - {*FUNCTIONS})
        self.transcendental = bool(named & {"ln", "arccos"})

    def with_numbers(self, numbers: Mapping[str, Fraction]) -> Expression:
        """Return the same with numbers in place of their names."""
        return Expression(self.text, numbers)

    def value(self, kind: Kind, cell: Callable[[str], Any]) -> Any:
        """Return the value on a kind of number, with those of the cells that it names."""
        return _value(self._tree, kind, cell)


def _check(tree: ast.expr, text: str, later: bool) -> None:
    """Raise NotationError for anything but numbers, names, the four operations, powers and functions."""
    match tree:
        case ast.Constant(value=Fraction()) | ast.Name():
            return
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            _check(inner, text, later)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=height)) if height in POWERS:
            _check(left, text, later)
        case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=Fraction() as height)):
            raise wrong_power(text, height)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            _check(left, text, later)
            _check(right, text, later)
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            _check(inner, text, later)
            if name in ("sin", "cos") and not (later and _has_names(inner)):
                _rational(inner, text)
        case _:
            raise NotationError(
                f'"{text[:60]}" has what no expression may; it has numbers, names of cells, + - * / ^,'
                f" brackets, {', '.join(FUNCTIONS)}"
            )


def _has_names(tree: ast.expr) -> bool:
    return any(isinstance(node, ast.Name) for node in ast.walk(tree))


def _rational(tree: ast.expr, text: str) -> Fraction:
    """Return a number written out, as the argument of sin and cos must be."""
    match tree:
        case ast.Constant(value=Fraction() as value):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -_rational(inner, text)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            try:
                return Fraction(OPERATIONS[type(op)](_rational(left, text), _rational(right, text)))
            except ZeroDivisionError:
                raise NotationError(f'"{text[:60]}" divides by zero') from None
    raise NotationError(f'"{text[:60]}" has a sine or cosine of no number; write its degrees out')


def _value(tree: ast.expr, kind: Kind, cell: Callable[[str], Any]) -> Any:
    match tree:
        case ast.Constant(value=Fraction() as value):
            return kind.of(value)
        case ast.Name(id=name):
            return cell(name)
        case ast.UnaryOp(operand=inner):
            return -_value(inner, kind, cell)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=Fraction() as height)):
            return power(_value(left, kind, cell), int(height))
        case ast.BinOp(left=left, op=op, right=right):
            return OPERATIONS[type(op)](_value(left, kind, cell), _value(right, kind, cell))
        case ast.Call(func=ast.Name(id="sin"), args=[inner]):
            return kind.circle(_rational(inner, "")).sine
        case ast.Call(func=ast.Name(id="cos"), args=[inner]):
            return kind.circle(_rational(inner, "")).cosine
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            functions = {"ln": kind.ln, "arccos": kind.arccos, "sqrt": kind.root}
            return functions[name](_value(inner, kind, cell))
    raise AssertionError(tree)
