"""The beam engine as conditions see it: an arc crank whose formulas no polynomial with rational numbers has.

Where a quantity rises and falls is therefore proved by balls: all zeros of its slope are enclosed
(`roots.isolate`), and a value that is just reached stays unsettled.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import flint
from flint import arb

from kurbel.exact.certify import half_turn_circle, pi
from kurbel.exact.course import Course
from kurbel.exact.jet import Jet, ball_jets
from kurbel.exact.kind import balls
from kurbel.exact.place import FIRST_BITS, Centre, Place, fraction, unsettled
from kurbel.exact.roots import Function, Root, isolate, refined
from kurbel.linkage.arc.drive import ArcDrive, with_share
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.beam.quantities import beam_registry
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Quantity

# How far beyond the ends zeros are sought, so that no halving cuts at a round angle, and the bits to which a
# zero is told from an end: the infinite rod has both.
BEFORE, BEHIND = Fraction(5, 11 << 20), Fraction(7, 13 << 20)
EQUAL_BITS = 512
# What is zero at the dead centres.
AT_REST = ("velocity", "tangential_force", "torque")


@cache
def beam_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place: the outstroke's quantities, which stand for either stroke."""
    return with_share({key: one for key, one in beam_registry().items() if one.stroke == OUT})


class BeamDrive(ArcDrive):
    """The beam engine."""

    columns_of = staticmethod(beam_columns)
    page = "beam"

    def __init__(self, crank: BeamCrank) -> None:
        super().__init__(crank)

    def is_free(self, quantity: Quantity) -> bool:
        return False

    def ends(self, stroke: int) -> tuple[Place, Place]:
        begin, end = (Place(angle, self.centre) for angle in self._dead_angles(stroke))
        return begin, end

    def _course(self, quantity: str, stroke: int) -> Course:
        one = self.asked(quantity, stroke)
        if one.rises:
            return super()._course(quantity, stroke)

        def at(half_turns: arb) -> Any:
            return self.value(one, half_turn_circle(half_turns), balls())

        def jet(half_turns: arb) -> Jet:
            found: Jet = self.value(one, ball_jets(half_turns), balls())
            return found

        def slope(half_turns: arb) -> Any:
            return jet(half_turns).slope * pi()

        def bend(half_turns: arb) -> Any:
            return jet(half_turns).bend * pi() * pi()

        begin, end = self.ends(stroke)
        rest = Fraction(0) if one.key in AT_REST else None
        inner = tuple(_level(slope, bend, begin, end))
        return Course(at, slope, begin, end, ends=(rest, rest), inner=inner)


def _level(slope: Function, bend: Function, begin: Place, end: Place) -> Iterator[Place]:
    """Yield, in order, the places between both ends where the slope is zero."""
    with flint.ctx.workprec(FIRST_BITS):
        low, high = fraction(begin.half_turns().lower()), fraction(end.half_turns().upper())
    for root in isolate(slope, bend, low - BEFORE, high + BEHIND):
        if root.rising is None:
            raise unsettled("where a quantity rises and where it falls")
        place = _place(slope, bend, root, begin.centre)
        if _is_between(begin, place, end):
            yield place


def _is_between(begin: Place, place: Place, end: Place) -> bool:
    """Whether a place lies between two others, and not so near to one that it is taken for it."""
    with flint.ctx.workprec(EQUAL_BITS):
        apart = place.half_turns() - begin.half_turns(), end.half_turns() - place.half_turns()
        return all(bool(one > 0) for one in apart)


def _place(slope: Function, bend: Function, root: Root, centre: Centre) -> Place:
    return Place(lambda: refined(slope, bend, root), centre)
