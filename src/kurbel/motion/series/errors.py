"""The greatest error of a series over the turn, for path, velocity and acceleration, enclosed with proof.

Of order n the error of x is the sum of all terms that are left out, each a positive coefficient a_k times
λ^(2k-1) sin^(2k) φ with 2k - 1 > n. It grows with u = sin² φ and is greatest at 90°.

The error of p is the sum of b_k λ^(2k-1) u^(k-1) (2k - 1 - 2k u) with b_k = 2k a_k. No term exceeds its
magnitude at 90°, where u is 1 and the bracket -1: the greatest other one, at u = (1 - 1/k)(1 - 1/2k), is
u^(k-1) (2k - 1)/k in their place, for k >= 2 at most 3/4. So p, too, errs most at 90°.

By powers of u the first coefficient of that sum is positive and all others are negative, for that of u^k is a
multiple of (2k + 1) b_(k+1) λ² - 2k b_k, and b_(k+1) is b_k (2k - 1)/2k. Hence the error of p has one zero
between 0° and 90°, from positive to negative, and there that of c, whose slope it is, is greatest.

All three have the same magnitude at 180° - φ, 180° + φ and 360° - φ, and on the return stroke. Re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel.exact.certify import at_bits, half_turn_circle
from kurbel.exact.jet import ball_jets, slopes
from kurbel.exact.kind import Kind, balls
from kurbel.exact.search import Zero
from kurbel.kernel import kinematics, series
from kurbel.kernel.circle import Circle

QUARTER = Fraction(90)
# The exact formula and that of an order, by their quantities.
FORMULAS: Mapping[str, tuple[Callable[..., Any], Callable[..., Any]]] = {
    "x": (kinematics.piston_path, series.piston_path),
    "c": (kinematics.piston_velocity, series.piston_velocity),
    "p": (kinematics.piston_acceleration, series.piston_acceleration),
}
# A rough value is known to so many bits, and found with at most so many.
ROUGH_BITS, MOST_ROUGH_BITS = 40, 1 << 16


@dataclass(frozen=True)
class Greatest:
    """The greatest errors of one order, of a finite rod."""

    ratio: Fraction
    order: int

    def value(self, key: str, kind: Kind) -> Any:
        """Return the greatest |series - exact| of x, c or p in units of R, v, v²/R; of c on balls alone."""
        circle = half_turn_circle(self.zero.place()) if key == "c" else kind.circle(QUARTER)
        error = self._error(key, circle, kind)
        # The series of p is above at 90°, those of x and c are below.
        return -error if key == "p" else error

    @cached_property
    def zero(self) -> Zero:
        """Where the velocity errs most, in half turns."""
        slope, _ = slopes(lambda half_turns: self._error("p", ball_jets(half_turns), balls()))
        return Zero(
            lambda half_turns: self._error("p", half_turn_circle(half_turns), balls()),
            slope,
            Fraction(0),
            Fraction(1, 2),
            rising=False,
        )

    def rough(self, key: str) -> float:
        """Return the value as a float, however small it is."""
        bits = 2 * ROUGH_BITS
        while bits < MOST_ROUGH_BITS:
            with at_bits(bits):
                found = self.value(key, balls())
                if found.rel_accuracy_bits() >= ROUGH_BITS:
                    break
            bits *= 2
        return float(found.mid())

    def _error(self, key: str, circle: Circle[Any], kind: Kind) -> Any:
        exact, series = FORMULAS[key]
        ratio = kind.of(self.ratio)
        return exact(circle, ratio) - series(circle, ratio, self.order)
