"""The segments of a turn: what lies between two neighbouring dead centres or corners of the forces.

Over a segment every force of every crank is one smooth formula, which also goes on beyond both of its edges.
Angles are half turns of the first crank's φ.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from math import floor
from typing import Any, NamedTuple

import flint
from flint import arb

from kurbel.engine.cylinder import Cylinder, Standing
from kurbel.engine.turn import EQUAL_BITS, Turn, circle
from kurbel.exact.branch import Branched
from kurbel.exact.certify import ball
from kurbel.exact.jet import Jet, ball_jets
from kurbel.exact.place import Place, fraction
from kurbel.exact.roots import ISOLATING_BITS
from kurbel.kernel.turning import Stroke

PRECISIONS_KEPT = 32


class Crank(NamedTuple):
    """A crank of a turn: which part of the engine it is of, and the half turns by which it follows."""

    part: int
    start: Fraction


class _Pinned(NamedTuple):
    """A stroke by the branch of its formula that holds where the piston has gone the share `witness`."""

    stroke: Stroke
    witness: arb

    def force(self, share: Any) -> Any:
        """Return the force at a share of the stroke, of a jet as a jet."""
        found: Any = self.stroke.force(Branched(share, self.witness))
        return found.number if isinstance(found, Branched) else found


class Acting(NamedTuple):
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
    standing: tuple[Standing, ...]

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

    def cranks(self, half_turns: arb) -> Iterator[Acting]:
        """Yield what each crank does at a place, in or near the segment."""
        for cylinder, (_, stroke, angle) in zip(self._pinned(flint.ctx.prec), self.standing, strict=True):
            yield Acting(cylinder, stroke, half_turns - ball(self.middle - angle))


def _on_jets(cylinder: Cylinder, stroke: int, angle: Fraction) -> Cylinder:
    witness = cylinder.share(stroke, circle(angle))
    strokes: Any = tuple(_Pinned(one, witness) for one in cylinder.strokes)
    return cylinder._replace(strokes=strokes, circle=ball_jets)


def jet_of(value: Any) -> Jet:
    """Return a value with its slopes; what has none is constant."""
    return value if isinstance(value, Jet) else Jet(value, 0, 0)


def cranks_of(turn: Turn) -> list[Crank]:
    """Return all cranks of a turn."""
    return [Crank(part, start) for part, one in enumerate(turn.engine.parts) for start in one.starts]


def segments(turn: Turn, cranks: Sequence[Crank], cycle: int) -> list[Segment]:
    """Return the segments of these cranks' forces in order, from the first one's dead centre over a cycle of
    so many half turns."""
    first, *others = [place for crank in cranks for place in _edges(turn, crank, cycle)]
    found = []
    for start, end in pairwise(_in_order(first, others, cycle)):
        with flint.ctx.workprec(ISOLATING_BITS):
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
    return Place(lambda: ball(begun) + turn.cylinders[part].drive.dead_centre(stroke % 2))


def _corner(turn: Turn, part: int, stroke: int, begun: Fraction, index: int) -> Place:
    def half_turns() -> arb:
        share = turn.cylinders[part].strokes[stroke].corners[index]
        angle: arb = turn.angle_of(part, stroke, share)
        return ball(begun) + angle

    return Place(half_turns)


def _in_order(first: Place, others: Sequence[Place], cycle: int) -> list[Place]:
    """Return places in order over a cycle, from the first on to where it comes again; those only once that
    agree to EQUAL_BITS."""
    with flint.ctx.workprec(EQUAL_BITS):
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
