"""The segments of a turn: what lies between two neighbouring dead centres or corners of the forces.

Over a segment every force of every crank is one smooth formula, which also goes on beyond both of its edges.
A quantity is a jet of a segment and a place in it; at an edge it has the limits from both sides, which
differ where it jumps. Where it has a value, and where it is greatest or least, is enclosed with proof.
Angles are half turns of the first crank's φ.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from itertools import pairwise
from math import floor
from operator import pos
from typing import Any, NamedTuple

import flint
from flint import arb

from kurbel.engine.cylinder import Crank, CrankPosition, Cylinder
from kurbel.engine.turn import Turn, circle
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.place import PRECISIONS, Place, fraction, unsettled
from kurbel.exact.search import (
    EQUAL_BITS,
    ISOLATING_BITS,
    Function,
    Jet,
    ball_jets,
    between,
    greatest,
    slopes,
)
from kurbel.exact.taylor import ComplexNumber
from kurbel.kernel.circle import Numeric
from kurbel.kernel.law import Stroke

PRECISIONS_KEPT = 32
# Shares of a segment at which nothing is likely to be zero.
ANYWHERE = (Fraction(3, 17), Fraction(5, 11), Fraction(23, 29))


class _Pinned(NamedTuple):
    """A stroke by the branch of its formula that holds where the piston has gone the share `at`."""

    stroke: Stroke
    at: float

    def force(self, share: Numeric) -> Numeric:
        """Return the force at a share of the stroke, of a jet as a jet."""
        pinned: Any = ComplexNumber(share, self.at)
        found = self.stroke.force(pinned)
        return found.ball if isinstance(found, ComplexNumber) else found


class CylinderOnJets(NamedTuple):
    """A crank's cylinder on jets at a place, its stroke, and the angle in that."""

    cylinder: Cylinder
    stroke: int
    angle: arb


@dataclass(frozen=True, eq=False)
class Segment:
    """A part of a turn from edge to edge, each a place where a stroke begins or a force has a corner.

    `middle` lies between them, where the cranks are `standing`.
    """

    turn: Turn
    start: Place
    end: Place
    middle: Fraction
    standing: tuple[CrankPosition, ...]

    @property
    def stroke(self) -> int:
        """The stroke of the first crank."""
        return self.standing[0].stroke

    @cached_property
    def _pinned(self) -> Callable[[int], tuple[Cylinder, ...]]:
        return lru_cache(PRECISIONS_KEPT)(self._pinned_at)

    def _pinned_at(self, precision: int) -> tuple[Cylinder, ...]:
        """The cylinders on jets, each by the branch that its stroke has here."""
        return tuple(_on_jets(self.turn.cylinders[part], *where) for part, *where in self.standing)

    def cranks(self, half_turns: arb) -> Iterator[CylinderOnJets]:
        """Yield what each crank does at a place, in or near the segment."""
        for cylinder, (_, stroke, angle) in zip(self._pinned(flint.ctx.prec), self.standing, strict=True):
            yield CylinderOnJets(cylinder, stroke, half_turns - ball(self.middle - angle))


def _on_jets(cylinder: Cylinder, stroke: int, angle: Fraction) -> Cylinder:
    at = float(cylinder.share(stroke, circle(angle)))
    strokes: Any = tuple(_Pinned(one, at) for one in cylinder.strokes)
    return cylinder._replace(strokes=strokes, circle=ball_jets)


Quantity = Callable[[Segment, arb], Jet]


class At(NamedTuple):
    """A place in a segment, or the limit at one of its edges."""

    segment: Segment
    place: Place

    def value(self, quantity: Quantity) -> arb:
        """Return the quantity as a ball at the precision in force."""
        return ball(quantity(self.segment, self.place.half_turns()).value)


class Part(NamedTuple):
    """A part of a segment over which a quantity is above zero, 1, below it, -1, or zero throughout, 0."""

    start: Place
    end: Place
    sign: int


def zeros(segment: Segment, quantity: Quantity, value: Function) -> list[Place]:
    """Return where in a segment the quantity has a value, its edges included.

    A quantity that is constant there has no such place, nor one that only comes near; where it touches the
    value, the place is known to 2e-10 of half a turn.
    """

    def apart(half_turns: arb) -> arb:
        found: arb = quantity(segment, half_turns).value
        return found - value(half_turns)

    if is_level(segment, quantity):
        return []
    slope, _ = slopes(partial(quantity, segment))
    return [*between(apart, slope, segment.start, segment.end)]


def stationary(segment: Segment, quantity: Quantity) -> list[Place]:
    """Return where within a segment the slope of the quantity is zero, the edges left out."""
    if is_level(segment, quantity):
        return []
    edges = segment.start, segment.end
    return [place for place in between(*slopes(partial(quantity, segment)), *edges) if place not in edges]


def is_level(segment: Segment, quantity: Quantity) -> bool:
    """Whether the quantity is constant over a segment: its slope is zero to EQUAL_BITS at places of no
    meaning, as no smooth formula's is by chance."""
    with at_bits(2 * EQUAL_BITS):
        low, high = (fraction(place.half_turns().mid()) for place in (segment.start, segment.end))
        rates = [quantity(segment, ball(low + (high - low) * part)).slope for part in ANYWHERE]
        least = ball(2) ** -EQUAL_BITS
        return all(bool(abs(arb(rate)) < least) for rate in rates)


def extremes(
    segments: Sequence[Segment],
    quantity: Quantity,
    sign: int = 1,
    measure: Callable[[arb], arb] = pos,
) -> list[At]:
    """Return where the quantity, or a measure of it, is greatest or, with sign -1, least, in order.

    Several only if they cannot be told apart, as on both strokes of the infinite rod.
    """
    places = [
        At(segment, place)
        for segment in segments
        for place in (segment.start, *stationary(segment, quantity), segment.end)
    ]
    return greatest(places, lambda one: measure(one.value(quantity)), sign)


def extreme_value(found: Sequence[At], quantity: Quantity, sign: int = 1) -> arb:
    """Return the value that all of these places may have, a ball at the precision in force."""
    first, *others = (sign * one.value(quantity) for one in found)
    for other in others:
        first = first.max(other)
    return sign * first


def parts(segment: Segment, quantity: Quantity) -> Iterator[Part]:
    """Yield the parts of a segment in order, at each of which the quantity has one sign."""
    inner = zeros(segment, quantity, lambda half_turns: ball(0))
    edges = (segment.start, segment.end)
    places = [segment.start, *(place for place in inner if place not in edges), segment.end]
    for start, end in pairwise(places):
        yield Part(start, end, _sign_between(segment, quantity, start, end))


def _sign_between(segment: Segment, quantity: Quantity, start: Place, end: Place) -> int:
    for bits in PRECISIONS:
        with at_bits(bits):
            middle = ball(fraction(((start.half_turns() + end.half_turns()) / 2).mid()))
            value = quantity(segment, middle).value
            if not value.contains(0):
                return 1 if value > 0 else -1
            if bits > EQUAL_BITS and is_level(segment, quantity):
                return 0
    raise unsettled("which sign a force has")


def segments(turn: Turn, cranks: Sequence[Crank], cycle: int) -> list[Segment]:
    """Return the segments of these cranks' forces in order, from the first one's dead centre over a cycle of
    so many half turns."""
    first, *others = [place for crank in cranks for place in _edges(turn, crank, cycle)]
    found = []
    for start, end in pairwise(_in_order(first, others, cycle)):
        with at_bits(ISOLATING_BITS):
            middle = fraction(((start.half_turns() + end.half_turns()) / 2).mid())
        standing = tuple(turn.standing(middle, *crank) for crank in cranks)
        found.append(Segment(turn, start, end, middle, standing))
    return found


def _edges(turn: Turn, crank: Crank, cycle: int) -> Iterator[Place]:
    """Yield where the strokes of a crank begin over a cycle, from its first one on, and all corners."""
    part, start = crank
    strokes = len(turn.cylinders[part].strokes)
    for stroke in range(cycle):
        begun = start + stroke
        yield _dead_centre(turn, part, stroke % strokes, begun)
        for index in range(len(turn.cylinders[part].strokes[stroke % strokes].corners)):
            yield _corner(turn, part, stroke % strokes, begun, index)


def _dead_centre(turn: Turn, part: int, stroke: int, begun: Fraction) -> Place:
    if turn.cylinders[part].drive.regular:
        return Place(lambda: ball(begun), exact=begun)
    return Place(lambda: ball(begun) + ball(turn.cylinders[part].drive.dead_centre(stroke % 2)))


def _corner(turn: Turn, part: int, stroke: int, begun: Fraction, index: int) -> Place:
    def half_turns() -> arb:
        share = turn.cylinders[part].strokes[stroke].corners[index]
        angle: arb = turn.angle_of(part, stroke, share)
        return ball(begun) + angle

    return Place(half_turns)


def _in_order(first: Place, others: Sequence[Place], cycle: int) -> list[Place]:
    """Return places in order over a cycle, from the first on to where it comes again; those only once that
    agree to EQUAL_BITS."""
    with at_bits(EQUAL_BITS):
        start = first.half_turns()
        begin, end = _shifted(first, 0), _shifted(first, cycle)
        kept = [(start, begin), (start + cycle, end)]
        for place in others:
            at = place.half_turns()
            turns = floor(float(at.mid() - start.mid()) / cycle) * cycle
            # Just before the first place may be the last one.
            if not any((at - turns).overlaps(one) for one, _ in kept):
                kept.append((at - turns, _shifted(place, -turns)))
    return [place for _, place in sorted(kept, key=lambda one: float(one[0].mid()))]


def _shifted(place: Place, half_turns: int) -> Place:
    if not half_turns:
        return place
    exact = None if place.exact is None else place.exact + half_turns
    return Place(lambda: place.half_turns() + half_turns, exact=exact)
