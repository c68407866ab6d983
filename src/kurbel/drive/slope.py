"""The slope of a crank drive's slide, by which its masses have a weight in it; checked once."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.forces import Weight
from kurbel.reading.notation import about

# By definition, of the third general conference on weights and measures, in m/s².
STANDARD_GRAVITY = Fraction(980665, 100000)
VERTICAL = Fraction(90)
STEEPEST = 180
GREATEST_GRAVITY = 1000


@dataclass(frozen=True, slots=True)
class Slope:
    """By how many degrees the slide rises from the shaft to the cylinder, in the sense of rotation, and g in
    m/s²: 90 is a cylinder above the shaft, -90 one below it. At 0 it lies, and the crank pin passes above
    the shaft on the outstroke, beyond 90 and -90 below it.
    """

    angle: Fraction
    gravity: Fraction = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        if abs(self.angle) > STEEPEST:
            raise ProblemError(
                f"the slope is {about(self.angle)}°; it must lie within -180..180, for 90 is a cylinder above"
                " the shaft and -90 one below it"
            )
        if not 0 < self.gravity <= GREATEST_GRAVITY:
            raise ProblemError(
                f"gravity is {about(self.gravity)} m/s²; it must be above 0 and at most 1000, on earth"
                " 9.80665"
            )

    @property
    def upright(self) -> bool:
        """Whether no weight acts across the slide."""
        return abs(self.angle) == VERTICAL

    @property
    def over(self) -> bool:
        """Whether the crank pin passes above the shaft on the outstroke."""
        return abs(self.angle) < VERTICAL

    def weight(self, kind: Kind, pin: Fraction, crosshead: Fraction, reciprocating: Fraction) -> Weight[Any]:
        """Return what masses in kg weigh in newtons, on a kind of number."""
        circle = kind.circle(self.angle)
        at_pin, at_end, own = (kind.of(self.gravity * mass) for mass in (pin, crosshead, reciprocating))
        return Weight(at_pin, at_end, own, circle.sine, circle.cosine)
