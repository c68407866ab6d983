"""The form of a printed formula that is evaluated: "R * (1 - cos(alpha) + pm * R / (2*L) * sin(alpha)^2)".

A form has numbers, letters, pi, + - * / ^, brackets and functions; angles are in radians. It is evaluated on
whatever numbers an algebra has: exact quotients of polynomials, balls, power series of balls.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any, Protocol

from kurbel.books.expression import OPERATIONS, parsed
from kurbel.errors import NotationError

FUNCTIONS = ("sin", "cos", "tan", "cot", "sqrt", "ln", "arcsin", "arctan")
PI = "pi"
HIGHEST = 10


class Algebra(Protocol):
    """Numbers that forms are evaluated on: of a fraction, pi, and the values of functions."""

    @property
    def pi(self) -> Any: ...
    def of(self, value: Fraction) -> Any: ...
    def apply(self, function: str, value: Any) -> Any: ...


class Form:
    """A form that was read once; `letters` are the names in it."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._tree = parsed(text, {})
        self.letters = frozenset(_letters(self._tree, text))

    def value(self, algebra: Algebra, letter: Callable[[str], Any]) -> Any:
        """Return the value on the numbers of an algebra, with those of its letters."""
        return _value(self._tree, algebra, letter)


def _letters(tree: ast.expr, text: str) -> Iterator[str]:
    """Yield the letters; raise NotationError for what no form may have."""
    match tree:
        case ast.Constant():
            return
        case ast.Name(id=name) if name not in FUNCTIONS:
            if name != PI:
                yield name
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            yield from _letters(inner, text)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=power)) if power in range(HIGHEST):
            yield from _letters(left, text)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            yield from _letters(left, text)
            yield from _letters(right, text)
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            yield from _letters(inner, text)
        case _:
            raise NotationError(
                f'"{text[:60]}" has what no form may; it has numbers, letters, pi, + - * / ^, brackets,'
                f" {', '.join(FUNCTIONS)}"
            )


def _value(tree: ast.expr, algebra: Algebra, letter: Callable[[str], Any]) -> Any:
    match tree:
        case ast.Constant(value=Fraction() as value):
            return algebra.of(value)
        case ast.Name(id=name):
            return algebra.pi if name == PI else letter(name)
        case ast.UnaryOp(operand=inner):
            return -_value(inner, algebra, letter)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=Fraction() as power)):
            base, product = _value(left, algebra, letter), algebra.of(Fraction(1))
            for _ in range(int(power)):
                product = product * base
            return product
        case ast.BinOp(left=left, op=op, right=right):
            return OPERATIONS[type(op)](_value(left, algebra, letter), _value(right, algebra, letter))
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            return algebra.apply(name, _value(inner, algebra, letter))
    raise AssertionError(tree)


class Letters:
    """What the letters of forms stand for on the numbers of an algebra.

    `given` are values, `forms` what other letters are made of.
    """

    def __init__(self, algebra: Algebra, given: Mapping[str, Any], forms: Mapping[str, Form]) -> None:
        self.algebra = algebra
        self.forms = forms
        self.values = dict(given)

    def __call__(self, name: str) -> Any:
        if name not in self.values:
            self.values[name] = self.of(self.forms[name])
        return self.values[name]

    def of(self, form: Form) -> Any:
        return form.value(self.algebra, self)
