"""The compressor, or blowing engine, which the shaft drives: air is sucked, compressed and pushed out."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import floor
from typing import Any, ClassVar, NamedTuple

from kurbel.drive.load import COMPRESSOR
from kurbel.engine.loads.limits import (
    LARGEST_LOSS,
    LARGEST_RATIO,
    LEAST_WORK,
    check_clearance,
    check_exponent,
)
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Number
from kurbel.kernel.law import Between, Constant, Law, Polytrope, steady
from kurbel.kernel.steam import power
from kurbel.reading.notation import about, plain

# A share of the stroke that is left for delivery, below which there is none.
LEAST_DELIVERY = 1e-9


class _Ends(NamedTuple):
    """The pressures in the cylinder in units of the suction pressure, on a kind of number."""

    suction: Number
    delivery: Number
    exponent: Number
    clearance: Number
    # The volume at suction pressure of what has one volume at delivery pressure.
    growth: Number
    # Whether there is a clearance, in which something of the delivery is left.
    kept: bool

    def leaving(self) -> Law:
        """Return the pressure in the end that the piston leaves: what is left expands, then air is sucked."""
        suction = Constant(self.suction)
        if not self.kept:
            return Law((suction,))
        expanding = Polytrope(self.delivery, self.clearance, self.exponent, self.clearance, 1)
        return Law((expanding, suction), (self.clearance * (self.growth - 1),))

    def coming(self) -> Law:
        """Return the pressure in the other end: the air is compressed, then pushed out."""
        whole = 1 + self.clearance
        compressed = Polytrope(self.suction, whole, self.exponent, whole, -1)
        return Law((compressed, Constant(self.delivery)), (whole * (1 - 1 / self.growth),))


@dataclass(frozen=True, slots=True)
class Compressor:
    """Pressure ratio Π = p₂/p₁, exponent n of p V^n = const, clearance as a share of the stroke's volume.

    The losses of the valves are shares of the pressures outside: in the cylinder it is p₁ (1 - ζ_s) at
    suction, p₂ (1 + ζ_d) at delivery. Q is p₁ times the piston's area. A single-acting piston has
    `other_side` p₁ on its other face, by default p₁ itself. Valid for Π > 1, n > 0, as long as something is
    delivered. Derived by us from p V^n = const; the volumetric efficiency is the textbook's.
    """

    name: ClassVar[str] = COMPRESSOR
    driven: ClassVar[bool] = True

    ratio: Fraction
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)
    suction_loss: Fraction = Fraction(0)
    delivery_loss: Fraction = Fraction(0)
    other_side: Fraction = Fraction(1)

    def __post_init__(self) -> None:
        if self.ratio <= 1:
            raise ProblemError(
                f"pressure ratio Π is {about(self.ratio)}; it must be above 1,"
                " for it is the delivery pressure in suction pressures"
            )
        if self.ratio > LARGEST_RATIO:
            raise ProblemError(f"pressure ratio Π is {about(self.ratio)}; at most {LARGEST_RATIO} is allowed")
        check_exponent(self.exponent, "exponent n")
        check_clearance(self.clearance)
        if not 0 <= self.suction_loss < 1:
            raise ProblemError(
                f"suction loss is {about(self.suction_loss)}; it must be 0 or more and below 1,"
                " for it is the share of the suction pressure that is lost in the valve"
            )
        if not 0 <= self.delivery_loss <= LARGEST_LOSS:
            raise ProblemError(
                f"delivery loss is {about(self.delivery_loss)}; it must lie within 0..{LARGEST_LOSS},"
                " for it is the share of the delivery pressure by which the valve raises it"
            )
        self._check_delivery()

    def strokes(self, kind: Kind, double: bool) -> tuple[Between, Between]:
        """Return both strokes; single-acting, air is sucked on the outstroke and compressed on the return."""
        ends = self._ends(kind)
        if double:
            both = Between(ends.leaving(), ends.coming())
            return both, both
        other = steady(kind.of(self.other_side))
        return Between(ends.leaving(), other), Between(other, ends.coming())

    def volumetric_efficiency(self, kind: Kind) -> Number:
        """Return the share of the stroke on which air is sucked: 1 + κ - κ Π'^(1/n), Π' in the cylinder."""
        return 1 + kind.of(self.clearance) * (1 - self._ends(kind).growth)

    def delivered(self, kind: Kind) -> Number:
        """Return the volume that a stroke delivers, as a share of the swept one, at p₁ and the temperature
        of the air that is sucked."""
        return self.volumetric_efficiency(kind) * kind.of(1 - self.suction_loss)

    def _ends(self, kind: Kind) -> _Ends:
        inside = 1 - self.suction_loss, self.ratio * (1 + self.delivery_loss)
        growth = power(kind.of(inside[1] / inside[0]), self._exponent(kind, 1 / self.exponent))
        exponent = self._exponent(kind, self.exponent)
        clearance, kept = kind.of(self.clearance), self.clearance > 0
        return _Ends(kind.of(inside[0]), kind.of(inside[1]), exponent, clearance, growth, kept)

    def _exponent(self, kind: Kind, exponent: Fraction) -> Any:
        return 1 if exponent == 1 else kind.exponent(exponent)

    def _check_delivery(self) -> None:
        growth = float(self._ends(floats()).growth)
        if 1 - float(self.clearance) * (growth - 1) < LEAST_DELIVERY:
            least, most = 1 / (growth - 1), self._largest_ratio()
            raise ProblemError(
                f"clearance {about(self.clearance)} leaves nothing to deliver at Π = {plain(self.ratio)}: the"
                f" air left in it fills the whole stroke again; it must be below {_down(least)}, or Π below"
                f" {_down(most)}"
            )
        if -self.strokes(floats(), True)[0].work(1.0) < LEAST_WORK:
            raise ProblemError(
                f"pressure ratio Π = {about(self.ratio)} leaves no work; it must be farther above 1"
            )

    def _largest_ratio(self) -> float:
        """The pressure ratio at which this clearance delivers nothing any more."""
        inside: float = float(1 + 1 / self.clearance) ** float(self.exponent)
        return inside * float((1 - self.suction_loss) / (1 + self.delivery_loss))


def _down(bound: float) -> str:
    """Return a bound to six decimals, rounded down, or to its first figures."""
    return f"{floor(1e6 * bound) / 1e6:g}" if bound > 1e-4 else f"{bound:.3g}"
