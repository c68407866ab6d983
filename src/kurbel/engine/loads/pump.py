"""The piston pump: a constant resistance on each stroke, by what acts on the faces of the piston."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from kurbel.drive.load import PUMP
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Number
from kurbel.kernel.law import Between, steady
from kurbel.reading.given import choose
from kurbel.reading.notation import about

DOUBLE, SINGLE, DIFFERENTIAL = KINDS = ("double", "single", "differential")
# Beyond this multiple of the pressure that the pump makes there is no suction head nor feed.
LARGEST_HEAD = 10**6


@dataclass(frozen=True, slots=True)
class Pump:
    """A pump of a kind: double-acting, single-acting or differential, with a stepped piston.

    Q is the delivery pressure less the suction pressure, times the piston's area; pressures are in units of
    that difference, above that on the other face. `suction` is the suction pressure: below 0 the water
    is lifted, above 0 it is fed. The differential pump has on its other side a ring, `small_area` of the
    piston's area, in a chamber that is open to the delivery: it takes part of what the piston delivers, and
    delivers it on the outstroke. With ½ both strokes deliver alike. Derived by us.
    """

    name: ClassVar[str] = PUMP
    driven: ClassVar[bool] = True

    kind: str = DOUBLE
    suction: Fraction = Fraction(0)
    small_area: Fraction = Fraction(1, 2)

    def __post_init__(self) -> None:
        choose(self.kind, KINDS, "pump")
        if not 0 < self.small_area < 1:
            raise ProblemError(
                f"the small area is {about(self.small_area)}; it must be above 0 and below 1,"
                " for it is a share of the piston's area"
            )
        if abs(self.suction) > LARGEST_HEAD:
            raise ProblemError(
                f"the suction pressure is {about(self.suction)} times what the pump makes, the delivery"
                f" pressure less it; at most {LARGEST_HEAD} times is allowed"
            )

    def delivered(self, kind: Kind) -> Number:
        """Return the volume that a stroke of the piston delivers, as a share of the swept one: all of it."""
        return kind.of(Fraction(1))

    @property
    def double(self) -> bool:
        """Whether both strokes do the same."""
        return self.kind == DOUBLE

    def strokes(self, kind: Kind, double: bool) -> tuple[Between, Between]:
        """Return both strokes; but for the double-acting pump the outstroke sucks, the return delivers."""
        filling, other = steady(kind.of(self.suction)), steady(kind.of(Fraction(0)))
        emptying = steady(kind.of(self.suction + 1))
        if self.kind == DOUBLE:
            return Between(filling, emptying), Between(filling, emptying)
        if self.kind == DIFFERENTIAL:
            # The ring has the delivery pressure on both strokes.
            other = steady(kind.of(self.small_area * (self.suction + 1)))
        return Between(filling, other), Between(other, emptying)
