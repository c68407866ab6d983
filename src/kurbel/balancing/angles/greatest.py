"""Where a free force or moment is greatest over the turn, with proof.

The turn is halved until every part is either below what is reached elsewhere, or bends downwards and has one
place without a slope, or falls or rises to its neighbour.
"""

from __future__ import annotations

from typing import NamedTuple

import flint
from flint import arb

from kurbel.balancing.angles.curve import Curve, midpoint
from kurbel.errors import ProblemError

# No end of a part is an angle at which an engine is greatest.
START = 0.01234567
PARTS = 48
MOST_PARTS = 6_000
SEARCH_BITS = 128
# Places that are as high to so many bits are as high.
ALIKE_BITS = 200


class Part(NamedTuple):
    """From one angle to another, in half turns."""

    start: arb
    end: arb

    @property
    def whole(self) -> arb:
        return self.start.union(self.end)

    @property
    def middle(self) -> arb:
        return midpoint((self.start + self.end) / 2)

    def halves(self) -> tuple[Part, Part]:
        middle = self.middle
        return Part(self.start, middle), Part(middle, self.end)


class Greatest(NamedTuple):
    """The part of the turn that has the greatest value in it, the first where there are several alike."""

    curve: Curve
    part: Part

    def place(self) -> arb:
        """Return the angle in half turns, at the precision in force."""
        bits = flint.ctx.prec
        # Half of the bits of a slope are lost where a value has none left.
        with flint.ctx.workprec(2 * bits + 64):
            near, steps = self.part.middle, 4
            while steps < 4 * bits:
                _, slope, bend = _at(self.curve, near)
                moved = midpoint(near - slope / (2 * bend))
                inside = self.part.start < moved and moved < self.part.end
                near = moved if inside else self._halved(near)
                steps *= 2
            return self._enclosed(near, bits)

    def _halved(self, near: arb) -> arb:
        """Return the middle of that side of a place on which the greatest value is."""
        rises = _at(self.curve, near)[1] > 0
        return midpoint(((self.part.end if rises else self.part.start) + near) / 2)

    def _enclosed(self, near: arb, bits: int) -> arb:
        """Return a ball about a place near it that has it for certain."""
        radius = flint.arb(2) ** -(bits + 8)
        while True:
            start, end = near - radius, near + radius
            if _at(self.curve, start)[1] > 0 and _at(self.curve, end)[1] < 0:
                return start.union(end)
            radius = radius * 4
            if radius > 1:
                return self.part.whole

    def length(self) -> arb:
        return _at(self.curve, self.place())[0].sqrt()


def _at(curve: Curve, half_turns: arb) -> tuple[arb, arb, arb]:
    found = curve.square(half_turns)
    return found[0], found[1], found[2]


def greatest(curve: Curve) -> Greatest:
    """Return the greatest value of a curve that does not vanish and is no circle.

    Raises ProblemError where it is not found within MOST_PARTS parts.
    """
    with flint.ctx.workprec(SEARCH_BITS):
        tops = _tops(curve)
    with flint.ctx.workprec(ALIKE_BITS + 64):
        found = [Greatest(curve, part) for part in tops]
        heights = [one.length() for one in found]
        highest = max(heights, key=lambda height: float(height.mid()))
        alike = [
            one for one, height in zip(found, heights, strict=True) if not height < highest - _within(highest)
        ]
        return min(alike, key=_degrees)


def _within(height: arb) -> arb:
    return abs(height) * flint.arb(2) ** -ALIKE_BITS


def _degrees(one: Greatest) -> float:
    return float(one.place().mid()) * 180 % 360


def _tops(curve: Curve) -> list[Part]:
    """Return the parts that bend downwards, have one top each, and may have the greatest one."""
    step, start = flint.arb(2) / PARTS, flint.arb(START)
    parts = [Part(midpoint(start + step * k), midpoint(start + step * (k + 1))) for k in range(PARTS)]
    reached = max((_at(curve, part.middle)[0].lower() for part in parts), key=float)
    tops: list[tuple[Part, arb]] = []
    seen = 0
    while parts:
        part = parts.pop()
        seen += 1
        if seen > MOST_PARTS:
            raise ProblemError(
                "the greatest of all orders together is not found: it is too small beside the forces of the"
                " cylinders, or nearly the same all around; take --method series, or look at the orders"
            )
        here = _at(curve, part.middle)[0]
        reached = max(reached, here.lower(), key=float)
        value, slope, bend = _at(curve, part.whole)
        highest = (here + slope * (part.whole - part.middle)).upper()
        if min(highest, value.upper(), key=float) < reached:
            continue
        if not bend < 0:
            parts += part.halves()
            continue
        rises, falls = _at(curve, part.start)[1], _at(curve, part.end)[1]
        if rises > 0 and falls < 0:
            tops.append((part, min(highest, value.upper(), key=float)))
        elif not (rises < 0 or falls > 0):
            parts += part.halves()
    return [part for part, highest in tops if not highest < reached]
