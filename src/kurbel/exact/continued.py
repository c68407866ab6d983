"""Formulas continued from between two corners: beyond them, into the complex plane, or as a power series.

A formula of the house may be of another shape on both sides of a corner, as the force of steam is at cut-off.
Between two corners only one of these shapes holds, and that one is continued, to balls that reach over a
corner, where a slope of both shapes would tell nothing, or to complex ones on which an integrand or a series
is bounded: a number carries what it is at a point between the same corners, and comparisons are of these.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from flint import acb, arb

from kurbel.errors import ProblemError
from kurbel.exact.certify import ball, pi
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle

# A comparison of floats nearer than this, or by so much of what they are, is left undecided.
NEAREST = 1e-13


class Continued:
    """A complex ball, a power series, a jet or, of a constant, a real ball, and the float that the same
    formula has at the point that stands for its piece."""

    __slots__ = ("at", "ball")

    def __init__(self, ball: Any, at: float) -> None:
        self.ball = ball
        self.at = at

    @classmethod
    def of(cls, number: Any) -> Continued:
        """Return a number of another kind as a constant."""
        if isinstance(number, Continued):
            return number
        # Whole numbers first: of what is none, an abstract class such as Fraction is asked slowly.
        if not isinstance(number, int) and isinstance(number, Fraction):
            return cls(ball(number), float(number))
        return cls(arb(number), float(number))

    def __neg__(self) -> Continued:
        return Continued(-self.ball, -self.at)

    def __add__(self, other: Any) -> Continued:
        other = Continued.of(other)
        return Continued(self.ball + other.ball, self.at + other.at)

    def __sub__(self, other: Any) -> Continued:
        other = Continued.of(other)
        return Continued(self.ball - other.ball, self.at - other.at)

    def __mul__(self, other: Any) -> Continued:
        other = Continued.of(other)
        return Continued(self.ball * other.ball, self.at * other.at)

    def __truediv__(self, other: Any) -> Continued:
        other = Continued.of(other)
        return Continued(self.ball / other.ball, self.at / other.at)

    def __rsub__(self, other: Any) -> Continued:
        return Continued.of(other) - self

    def __rtruediv__(self, other: Any) -> Continued:
        return Continued.of(other) / self

    def __abs__(self) -> Continued:
        return self if self._above(0) >= 0 else -self

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, exponent: Any) -> Continued:
        if isinstance(exponent, int):
            return Continued(self.ball**exponent, self.at**exponent)
        if exponent == 0.5:
            return Continued(self.ball.sqrt(**self._cuts), self.at**0.5)
        other = Continued.of(exponent)
        raised = self.ball.pow(other.ball, analytic=True) if self._cuts else self.ball**other.ball
        return Continued(raised, self.at**other.at)

    @property
    def _cuts(self) -> dict[str, bool]:
        """What makes a complex function no number on its cut."""
        return {"analytic": True} if isinstance(self.ball, acb) else {}

    def log(self) -> Continued:
        return Continued(self.ball.log(**self._cuts), math.log(self.at))

    def __eq__(self, other: object) -> bool:
        return bool(self.ball == Continued.of(other).ball)

    def __lt__(self, other: Any) -> bool:
        return self._above(other) < 0

    def __gt__(self, other: Any) -> bool:
        return self._above(other) > 0

    def max(self, other: Any) -> Continued:
        return self if self._above(other) >= 0 else Continued.of(other)

    def union(self, other: Any) -> Continued:
        """Two shapes, of which a ball over a corner has both, do not meet here."""
        raise ProblemError("a corner lies where none was looked for; give slightly other numbers")

    def rad(self) -> Any:
        """The radius, by which formulas know a ball."""
        return self.ball.rad()

    def _above(self, other: Any) -> float:
        other = Continued.of(other)
        if self == other:
            return 0.0
        apart = self.at - other.at
        if abs(apart) < NEAREST * max(1.0, abs(self.at)):
            raise ProblemError("two corners lie too near to each other; give slightly other numbers")
        return float(apart)


def continued() -> Kind:
    """Return these numbers as a kind, at the precision in force; exponents are balls of reals."""
    return Kind(
        Continued.of,
        lambda degrees: half_turn_circle(degrees / 180),
        _degrees,
        Continued.of(pi()),
        exponent=ball,
        enclosed=lambda value: Continued.of(value()),
    )


def _degrees(sine: Any) -> Continued:
    """Return the angle within -90°..90° that has this sine; on the cuts beyond -1 and 1 it is no number."""
    place = Continued.of(sine)
    angle = place.ball.asin()
    if isinstance(place.ball, acb):
        cut = (1 - place.ball * place.ball).sqrt(analytic=True)
        angle = angle if cut.is_finite() else cut
    return Continued(angle * 180 / arb.pi(), math.degrees(math.asin(place.at)))


def half_turn_circle(half_turns: Any) -> Circle[Continued]:
    """Return sine, cosine and versine of half turns, exact ones or continued."""
    place = Continued.of(half_turns)
    sine, cosine = place.ball.sin_cos_pi()
    half, angle = (place.ball / 2).sin_pi(), math.pi * place.at
    return Circle(
        Continued(sine, math.sin(angle)),
        Continued(cosine, math.cos(angle)),
        Continued(2 * half * half, 2 * math.sin(angle / 2) ** 2),
    )
