"""How many of Rötscher's steps it takes until the printed digits of GF stand."""

from __future__ import annotations

from fractions import Fraction
from math import floor
from typing import Any

import flint

from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind, balls, settled
from kurbel.exact.terms import vanishes
from kurbel.kernel import kinematics
from kurbel.kernel.series import chord

# Of a first guess, which exact digits put right, and so many of them are sure.
_BITS, _SURE_BITS = 128, 40


def steps_to(crank: Crank, angle: Fraction, decimals: int, rounding: str) -> int | None:
    """Return after how many steps GF in units of R has the digits of the exact value, and keeps them.

    None where it never has: the exact value lies half-way between two printed ones and is rounded up, and
    all steps lie below it. As the steps rise, digits that are reached stay.
    """
    wanted = settled(lambda kind: kinematics.rod_versine(*_at(crank, angle, kind)), decimals, rounding)
    lowest = Fraction(2 * wanted - 1, 2 * 10**decimals)
    if wanted == 0:
        return 0
    if _is_exactly(crank, angle, lowest):
        return None

    def stands(steps: int) -> bool:
        found = settled(lambda kind: chord.closed(*_at(crank, angle, kind), steps), decimals, rounding)
        return found == wanted

    steps = _guess(crank, angle, lowest)
    while not stands(steps):
        steps += 1
    return steps


def _at(crank: Crank, angle: Fraction, kind: Kind) -> tuple[Any, Any]:
    return kind.circle(angle), kind.of(crank.ratio)


def _is_exactly(crank: Crank, angle: Fraction, value: Fraction) -> bool:
    """Whether GF is exactly a number, proved by the separation bound."""

    def apart(kind: Kind) -> Any:
        return kinematics.rod_versine(*_at(crank, angle, kind)) - kind.of(value)

    return vanishes(apart)


def _guess(crank: Crank, angle: Fraction, lowest: Fraction) -> int:
    """Return how many steps reach a number below GF, or one too few: (GF - g)/(2 L - GF - g) is q^(k+1)."""
    precision = _BITS
    while True:
        with flint.ctx.workprec(precision):
            kind = balls()
            circle, ratio = _at(crank, angle, kind)
            whole, share = kinematics.rod_versine(circle, ratio), chord.shrinking(circle, ratio)
            left = (whole - kind.of(lowest)) / (whole / share - kind.of(lowest))
            if left.rel_accuracy_bits() > _SURE_BITS:
                return max(1, floor(float((left.log() / share.log()).mid())) - 1)
        precision *= 2
