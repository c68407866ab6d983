"""The form of a printed formula that is evaluated: "R * (1 - cos(alpha) + pm * R / (2*L) * sin(alpha)^2)".

A form has numbers, letters, pi, + - * / ^, brackets, functions, and slope(form, letter); angles are in
radians. It is evaluated on whatever numbers an algebra has: exact quotients of polynomials, balls, power
series of balls.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, Protocol, Self, TypeVar

from kurbel.errors import NotationError
from kurbel.reading.arithmetic import OPERATIONS, POWERS, parsed, wrong_power


class Reckoned(Protocol):
    """What can be reckoned with what is of its kind."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __neg__(self) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __truediv__(self, other: Self, /) -> Self: ...


Value = TypeVar("Value", bound=Reckoned)


@dataclass(frozen=True, slots=True)
class Dual(Generic[Value]):
    """A value and its slope."""

    value: Value
    slope: Value

    def __add__(self, other: Self) -> Self:
        return type(self)(self.value + other.value, self.slope + other.slope)

    def __sub__(self, other: Self) -> Self:
        return type(self)(self.value - other.value, self.slope - other.slope)

    def __neg__(self) -> Self:
        return type(self)(-self.value, -self.slope)

    def __mul__(self, other: Self) -> Self:
        return type(self)(self.value * other.value, self.slope * other.value + self.value * other.slope)

    def __truediv__(self, other: Self) -> Self:
        quotient = self.value / other.value
        return type(self)(quotient, (self.slope - quotient * other.slope) / other.value)


# A product of such numbers has three of those that they are made of.
PRODUCTS = 3


class Duals(Generic[Value]):
    """The algebra of such numbers on another one."""

    def __init__(self, algebra: Algebra[Value]) -> None:
        self.algebra = algebra
        self.pi = self.constant(algebra.pi)

    def spend(self, operations: float) -> None:
        self.algebra.spend(PRODUCTS * operations)

    def constant(self, value: Value) -> Dual[Value]:
        return Dual(value, self.algebra.of(Fraction(0)))

    def of(self, value: Fraction) -> Dual[Value]:
        return self.constant(self.algebra.of(value))

    def letter(self, value: Value) -> Dual[Value]:
        """Return the letter by which the slope is taken."""
        return Dual(value, self.algebra.of(Fraction(1)))

    def apply(self, function: str, value: Dual[Value]) -> Dual[Value]:
        found = self.algebra.apply(function, value.value)
        return Dual(found, self._slope(function, value.value, found) * value.slope)

    def _slope(self, function: str, value: Value, found: Value) -> Value:
        """Return the slope of a function at a value, of which it makes what was found."""
        apply, one = self.algebra.apply, self.algebra.of(Fraction(1))
        slopes: Mapping[str, Callable[[], Value]] = {
            "sin": lambda: apply("cos", value),
            "cos": lambda: -apply("sin", value),
            "tan": lambda: one + found * found,
            "cot": lambda: -one - found * found,
            "sqrt": lambda: one / (found + found),
            "ln": lambda: one / value,
            "arcsin": lambda: one / apply("sqrt", one - value * value),
            "arctan": lambda: one / (one + value * value),
        }
        return slopes[function]()


UNREAD = '"{}" is no expression; write one such as 1 - cos(45)'
FUNCTIONS = ("sin", "cos", "tan", "cot", "sqrt", "ln", "arcsin", "arctan")
PI, SLOPE = "pi", "slope"
# A slope in a slope doubles the work.
MOST_SLOPES = 4
# Operations that the value of a function costs.
OF_FUNCTION = 5


class Algebra(Protocol[Value]):
    """Numbers that forms are evaluated on: of a fraction, pi, and the values of functions.

    So many operations are spent before they are done; too many are refused.
    """

    @property
    def pi(self) -> Value: ...
    def spend(self, operations: float) -> None: ...
    def of(self, value: Fraction) -> Value: ...
    def apply(self, function: str, value: Value) -> Value: ...


class Form:
    """A form that was read once; `letters` are the names in it."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._tree = parsed(text, "form", UNREAD.format(text[:60]))
        self.letters = frozenset(_letters(self._tree, text))
        if text.count(SLOPE) > MOST_SLOPES:
            raise NotationError(f'"{text[:60]}" has more than {MOST_SLOPES} slopes')

    def value(self, letters: Letters[Value]) -> Value:
        """Return the value on the numbers of an algebra, with those of its letters."""
        return _value(self._tree, letters)


def _letters(tree: ast.expr, text: str) -> Iterator[str]:
    """Yield the letters; raise NotationError for what no form may have."""
    match tree:
        case ast.Constant(value=Fraction()):
            return
        case ast.Name(id=name) if name not in (*FUNCTIONS, SLOPE):
            if name != PI:
                yield name
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            yield from _letters(inner, text)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=power)) if power in POWERS:
            yield from _letters(left, text)
        case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=Fraction() as power)):
            raise wrong_power(text, power)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            yield from _letters(left, text)
            yield from _letters(right, text)
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            yield from _letters(inner, text)
        case ast.Call(func=ast.Name(id="slope"), args=[inner, ast.Name(id=name)], keywords=[]) if name != PI:
            yield from {name, *_letters(inner, text)}
        case _:
            raise NotationError(
                f'"{text[:60]}" has what no form may; it has numbers, letters, pi, + - * / ^, brackets,'
                f" {', '.join(FUNCTIONS)}, and slope(form, letter)"
            )


def _value(tree: ast.expr, letters: Letters[Value]) -> Value:
    letters.algebra.spend(OF_FUNCTION if isinstance(tree, ast.Call) else 1)
    match tree:
        case ast.Constant(value=Fraction() as value):
            return letters.algebra.of(value)
        case ast.Name(id=name):
            return letters.algebra.pi if name == PI else letters(name)
        case ast.UnaryOp(operand=inner):
            return -_value(inner, letters)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=Fraction() as power)):
            base, product = _value(left, letters), letters.algebra.of(Fraction(1))
            letters.algebra.spend(int(power))
            for _ in range(int(power)):
                product = product * base
            return product
        case ast.BinOp(left=left, op=op, right=right):
            found: Value = OPERATIONS[type(op)](_value(left, letters), _value(right, letters))
            return found
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            return letters.algebra.apply(name, _value(inner, letters))
        case ast.Call(args=[inner, ast.Name(id=name)]):
            return _value(inner, letters.by(name)).slope
    raise AssertionError(tree)


class Letters(Generic[Value]):
    """What the letters of forms stand for on the numbers of an algebra.

    `given` are values, `forms` what other letters are made of.
    """

    def __init__(
        self, algebra: Algebra[Value], given: Mapping[str, Value], forms: Mapping[str, Form]
    ) -> None:
        self.algebra = algebra
        self.given = given
        self.forms = forms
        self.values = dict(given)

    def __call__(self, name: str) -> Value:
        if name not in self.values:
            self.values[name] = self.of(self.forms[name])
        return self.values[name]

    def of(self, form: Form) -> Value:
        return form.value(self)

    def by(self, name: str) -> Letters[Dual[Value]]:
        """Return the same letters with their slopes by one of them."""
        duals = Duals(self.algebra)
        slopes = {one: duals.constant(value) for one, value in self.given.items()}
        return Letters(duals, slopes | {name: duals.letter(self(name))}, self.forms)
