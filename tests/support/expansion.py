"""Weisbach-Herrmann § 150 in mpmath: work, speed and its extremes of a stroke, from the book's equations."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from mpmath import mp

# mpmath has no types.
Real = Any
# His upper sign, "Niedergang" and "Hingang der Kurbel", is the return stroke; he brackets the other.
UPPER, LOWER = 1, -1


class Expansion:
    """An engine by ratio, expansion and back pressure; angles in radians from the dead centre,
    energies in Q r.

    The path is exact or, by `series` and `weisbach`, of first order; the greatest speed of `weisbach` is that
    of the book's own relation.
    """

    def __init__(self, ratio: Real, eps: Real, back: Real | None = None, method: str = "weisbach") -> None:
        self.ratio, self.eps, self.method = mp.mpf(ratio), mp.mpf(eps), method
        self.back = 1 / self.eps if back is None else mp.mpf(back)
        self.mean = 2 / mp.pi * ((1 + mp.log(self.eps)) / self.eps - self.back)

    def path(self, angle: Real, sign: int) -> Real:
        bow = self.ratio / 2 * mp.sin(angle) ** 2
        if self.method == "exact":
            bow = (1 - mp.sqrt(1 - (self.ratio * mp.sin(angle)) ** 2)) / self.ratio
        return 1 - mp.cos(angle) - sign * bow

    def slope(self, angle: Real, sign: int) -> Real:
        rise = self.ratio / 2 * mp.sin(2 * angle)
        if self.method == "exact":
            rise /= mp.sqrt(1 - (self.ratio * mp.sin(angle)) ** 2)
        return mp.sin(angle) - sign * rise

    def energy(self, angle: Real, sign: int) -> Real:
        path, cut_off = self.path(angle, sign), 2 / self.eps
        work = path if path < cut_off else cut_off * (1 + mp.log(path / cut_off))
        return work - self.back * path - self.mean * angle

    def excess_at_full_pressure(self, angle: Real, sign: int) -> Real:
        return (1 - self.back) * self.slope(angle, sign) - self.mean

    def least(self, sign: int) -> Real:
        return _root(lambda angle: self.excess_at_full_pressure(angle, sign), 8, 40)

    def greatest(self, sign: int) -> Real:
        def excess(angle: Real) -> Real:
            pressure = 2 / self.eps / self.path(angle, sign) - self.back
            return pressure * self.slope(angle, sign) - self.mean

        loss = self.eps * self.back

        def relation(angle: Real) -> Real:
            square = mp.sin(angle / 2) ** 2
            bracket = 1 + sign * self.ratio * square
            bracket -= loss * square * (1 - sign * self.ratio * mp.cos(angle))
            return mp.pi * bracket - (1 + mp.log(self.eps) - loss) * mp.tan(angle / 2)

        return _root(relation if self.method == "weisbach" else excess, 76, 125)

    def swing(self) -> Real:
        highest = max(self.energy(self.greatest(sign), sign) for sign in (UPPER, LOWER))
        return highest - min(self.energy(self.least(sign), sign) for sign in (UPPER, LOWER))

    def value(self, key: str) -> Real:
        """Return an angle, an energy, a force or δ by the name of its cell."""
        sign, name = UPPER if key.endswith("_return") else LOWER, key.removesuffix("_return")
        values: dict[str, Callable[[], Real]] = {
            "alpha_min": lambda: self.least(sign),
            "alpha_max": lambda: self.greatest(sign),
            "v_min": lambda: self.energy(self.least(sign), sign),
            "v_max": lambda: self.energy(self.greatest(sign), sign),
            "sum": self.swing,
            "mean_force": lambda: self.mean,
            "divisor": lambda: self.mean,
            "delta": lambda: self.swing() / self.mean,
        }
        return values[name]()


def _root(function: Callable[[Real], Real], low: int, high: int) -> Real:
    return mp.findroot(function, (mp.radians(low), mp.radians(high)), "anderson")
