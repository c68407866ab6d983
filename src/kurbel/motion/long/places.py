"""A long run of exact crank angles, as floats with bounds that are rounded once."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

from kurbel.exact.bulk import Integers
from kurbel.exact.enclosures.enclosure import UNIT, Enclosure
from kurbel.exact.enclosures.functions import half_turn_circle
from kurbel.kernel.circle import Circle
from kurbel.motion.bulk import integer_angles
from kurbel.reading.notation import Progression


class Angle(Enclosure):
    """Half turns whose circle is computed once for all that is asked of them."""

    __slots__ = ("__dict__",)

    @cached_property
    def circle(self) -> Circle[Enclosure]:
        return half_turn_circle(self)


class Places:
    """A run of crank angles, as exact half turns: integers over one denominator. What is asked of them more
    than once is `kept`."""

    def __init__(self, angles: Progression) -> None:
        numerators, denominator = integer_angles(angles)
        self.numerators, self.denominator = numerators, 180 * denominator
        self.kept: dict[Any, Any] = {}

    def __len__(self) -> int:
        return len(self.numerators)

    @property
    def half_turns(self) -> Enclosure:
        return quotient(self.numerators, self.denominator)

    @cached_property
    def angle(self) -> Angle:
        """The half turns within a turn."""
        found = quotient(*self.since(Fraction(0), 2))
        return Angle(found.value, found.error)

    def since(self, start: Fraction, cycle: int) -> tuple[Integers, int]:
        """Return the half turns since a start, within a cycle, as numerators and their denominator."""
        denominator = lcm(self.denominator, start.denominator)
        gone = self.numerators * (denominator // self.denominator) - int(start * denominator)
        return gone % (cycle * denominator), denominator


def quotient(numerators: Integers, denominator: int) -> Enclosure:
    """Return exact fractions; both are below 2**53, so that the division alone rounds."""
    value = numerators / denominator
    return Enclosure(value, abs(value) * UNIT)
