"""Steam in an end of the cylinder: pressure and work over the share of the stroke, with its expansion.

Pressures are in units of the steam pressure before cut-off, work in units of that pressure times the whole
stroke: a piston force Q works 2 Q R times the work here. The share counts from the dead centre at which
the stroke begins, 0 to 1. Numbers are floats, arrays or balls.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from kurbel.kernel.circle import Circle, Numeric, root


class Expansion(NamedTuple):
    """A stroke with cut-off at its share 1/ε, then expansion by p V^n = const from the volume 1/ε + κ.

    The clearance κ is a share of the volume swept in a stroke; n = 1 is Mariotte's law. The back pressure b
    is that on the other face.
    """

    cut_off: Numeric
    back: Numeric
    exponent: Numeric
    clearance: Numeric

    def pressure(self, share: Numeric) -> Numeric:
        """Return the pressure on the piston at a share of the stroke."""
        return power(1 / self.growth(share), self.exponent)

    @property
    def corners(self) -> tuple[Numeric, ...]:
        """The shares of the stroke at which the force has a corner."""
        return (self.cut_off,) if self.cut_off < 1 else ()

    def work(self, share: Numeric) -> Numeric:
        """Return the work done on the piston from the dead centre to a share of the stroke.

        Source: Weisbach-Herrmann, § 150 (A₁ + A₂); the exponent and the clearance are ours.
        """
        gain = expansion_work(self.growth(share), self.exponent)
        return smaller(share, self.cut_off) + (self.cut_off + self.clearance) * gain

    def whole(self) -> Numeric:
        """Return the work of the whole stroke, on numbers that need not compare."""
        room = self.cut_off + self.clearance
        return self.cut_off + room * expansion_work((1 + self.clearance) / room, self.exponent)

    def slope(self, share: Numeric) -> Numeric:
        """Return the change of the pressure with the share, a ball; over the cut-off it holds both sides."""
        if share < self.cut_off:
            return share * 0
        beyond: Any = self.expansion_slope(share)
        return beyond if share > self.cut_off else beyond.union(share * 0)

    def expansion_slope(self, share: Numeric) -> Numeric:
        """Return the change of the pressure with the share beyond cut-off, at cut-off from the right."""
        return -self.exponent * self.pressure(share) / self._expanded(share)

    def growth(self, share: Numeric) -> Numeric:
        """Return how many times its volume at cut-off the steam fills; before cut-off 1."""
        return self._expanded(share) / (self.cut_off + self.clearance)

    def _expanded(self, share: Numeric) -> Numeric:
        # Before cut-off the volume at cut-off stands in: one formula for both periods, also for a ball that
        # reaches over both.
        return larger(share, self.cut_off) + self.clearance


def best_back(cut_off: Numeric, exponent: Numeric, clearance: Numeric) -> Numeric:
    """Return the pressure of the steam at the end of the stroke, the best back pressure.

    1/ε for n = 1, κ = 0. Source: Weisbach-Herrmann, § 150 (Q = εR); the exponent and the clearance are ours.
    """
    return power((cut_off + clearance) / (1 + clearance), exponent)


def power(base: Numeric, exponent: Numeric) -> Numeric:
    """Return a power, of which the first needs no root."""
    return base if exponent == 1 else base**exponent


def expansion_work(volumes: Numeric, exponent: Numeric) -> Numeric:
    """Return ∫ V^-n dV from 1 to so many volumes."""
    if exponent == 1:
        return logarithm(volumes)
    return (1 - volumes ** (1 - exponent)) / (exponent - 1)


def crank_versine(path: Numeric, ratio: Numeric) -> Numeric:
    """Return 1 - cos φ at which the piston has covered the path from its dead centre, in units of R.

    A negative ratio is the return stroke. Re-derived from the triangle of crank, rod and slide, of which
    all three sides are known.
    """
    return path * (2 - ratio * path) / (2 * (1 + ratio * (1 - path)))


def crank_versine_first_order(path: Numeric, ratio: Numeric) -> Numeric:
    """Return 1 - cos φ at which 1 - cos φ + ½ λ sin² φ is the path, in units of R.

    Source: Weisbach-Herrmann, § 150 (cos α_ε), solved for the cosine.
    """
    lever = 1 + ratio
    return 2 * path / (lever + root(lever * lever - 2 * ratio * path))


def weisbach_maximum(
    half: tuple[Numeric, Numeric],
    circle: Circle[Numeric],
    ratio: Numeric,
    loss: Numeric,
    gain: Numeric,
    pi: Numeric,
) -> tuple[Numeric, Numeric]:
    """Return the relation cot(α/2) = gain/(π [...]) for the greatest speed as a function with that zero.

    And its slope over α. `half` is (sin α/2, cos α/2), `gain` is 1 + ln ε - ε b, `loss` is ε b. The
    function is π [...] cos(α/2) - gain sin(α/2), above zero before the angle and below zero beyond, as the
    excess force is. His upper sign is the negative ratio. Source: Weisbach-Herrmann, § 150.
    """
    sine, cosine = half
    square = sine * sine
    lever = 1 + ratio * circle.cosine
    bracket = 1 - ratio * square - loss * square * lever
    change = -circle.sine / 2 * (ratio + loss * (lever - 2 * ratio * square))
    value = pi * bracket * cosine - gain * sine
    slope = pi * (change * cosine - bracket * sine / 2) - gain * cosine / 2
    return value, slope


def logarithm(number: Any) -> Numeric:
    """Return the natural logarithm of a float, a float64 array or a ball."""
    if isinstance(number, (int, float)):
        return math.log(number)
    if hasattr(number, "log"):
        return number.log()
    import numpy as np

    return np.log(number)


def larger(one: Any, other: Any) -> Numeric:
    """Return the larger of two numbers of a kind; of balls that overlap, one that holds either."""
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return max(one, other)
    for first, second in ((one, other), (other, one)):
        if hasattr(first, "union"):
            return first.max(second)
    import numpy as np

    return np.maximum(one, other)


def smaller(one: Numeric, other: Numeric) -> Numeric:
    """Return the smaller of two numbers of a kind; of balls that overlap, one that holds either."""
    return -larger(-one, -other)
