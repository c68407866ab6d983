"""The kinds of number on which the formulas of worked examples run: balls, separation bounds, fractions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, ball_circle, rounded
from kurbel.exact.separation import Separation, circle_separation
from kurbel.examples.figures import Figure, Form
from kurbel.kernel.circle import root

Given = Mapping[str, Fraction]
"""The numbers of a part of an example, by their options: ratio, angle."""


class Kind(NamedTuple):
    """How a rational number becomes one of the kind, its root, and sine and cosine of an exact angle."""

    of: Callable[[Fraction], Any]
    root: Callable[[Fraction], Any]
    circle: Callable[[Fraction], Any]


Formula = Callable[[Given, Kind], Any]


def exact_root(square: Fraction) -> Fraction | None:
    """Return the square root if it is a fraction."""
    result = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return result if result * result == square else None


def _fraction_root(square: Fraction) -> Fraction:
    result = exact_root(square)
    if result is None:
        raise ProblemError(f"the root of {square} is no fraction")
    return result


def _no_circle(angle: Fraction) -> Any:
    raise ProblemError("sine and cosine are no fractions")


def balls() -> Kind:
    """Return the kind of the precision in force."""
    return Kind(ball, lambda square: root(ball(square)), ball_circle)


BOUNDS = Kind(
    Separation.rational, lambda square: root(Separation.rational(square)),
    lambda angle: _Bounded(*circle_separation(angle)[:2]),
)  # fmt: skip
FRACTIONS = Kind(lambda value: value, _fraction_root, _no_circle)


class _Bounded(NamedTuple):
    sine: Separation
    cosine: Separation


def certified(formula: Formula, given: Given, form: Form, transcendental: bool = False) -> Figure:
    """Return the value of a formula in a form, rounded once, half away from zero.

    `transcendental` claims that no value is a tie, for logarithms or π enter it. Nor is an angle a tie, an
    odd number of quarters or halves of a minute or degree: the angles of the examples are rational over π, or
    have a cosine of at most degree 2 over the rationals, and those odd numbers one of a higher degree.
    """
    if form.fraction:
        return Figure(formula(given, FRACTIONS), form)

    def value() -> Any:
        return formula(given, balls()) * max(form.parts, 1)

    def tie_bits(boundary: Fraction) -> float:
        return float((formula(given, BOUNDS) - Separation.rational(boundary)).bits())

    ties: TieBits | None = NEVER_TIES if form.parts or transcendental else tie_bits
    return Figure(Fraction(rounded(value, form.decimals, "half-away", ties)), form)
