"""The time since the dead centre, ∫ dφ/ω, enclosed with proof in balls.

Times are in half turns of a crank that turns at v₁ all the while. Between two dead centres, and the corners
of the force between them, 1/v is analytic, and flint encloses its integral. A dead centre or a corner that no
rational number of half turns says lies in a gap between two near ones, over which 1/v is a ball.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import flint

from kurbel.engine.turn import Piece, Turn
from kurbel.exact.certify import ball
from kurbel.exact.continued import Continued, continued, half_turn_circle
from kurbel.exact.place import fraction
from kurbel.exact.roots import interval
from kurbel.kernel.circle import Number

if TYPE_CHECKING:
    from kurbel.engine.speed.run import AnyRun

# Bits beyond those of the precision in force to which a corner is known.
NARROWER = 32


class Span(NamedTuple):
    """A part of the cycle, in half turns, and the pieces that it lies in. On a smooth one the speed has one
    formula; another one is a gap."""

    start: Fraction
    end: Fraction
    pieces: tuple[Piece, ...]
    smooth: bool = False


class Clock:
    """The time over the cycle of a run in balls."""

    def __init__(self, run: AnyRun, turn: Turn) -> None:
        self.run, self.turn = run, turn
        self._courses: dict[int, _Course] = {}

    def time(self, half_turns: Fraction) -> Number:
        """Return the time at any angle."""
        course, start = self._course, self.turn.pieces[0].start
        before, rest = divmod(half_turns - start, self.turn.cycle)
        time = course.begun + course.time(start + rest)
        return time + int(before) * course.time(start + self.turn.cycle) if before else time

    @property
    def _course(self) -> _Course:
        bits = flint.ctx.prec
        if bits not in self._courses:
            self._courses[bits] = _Course(self.run, self.turn)
        return self._courses[bits]


class _Course:
    """The time over a cycle at one precision; what was computed once helps with what comes later."""

    def __init__(self, run: AnyRun, turn: Turn) -> None:
        self.run, self.turn = run, turn
        self.spans = tuple(spans(turn))
        self.cylinders = turn.cylinders_on(continued(), half_turn_circle)
        self.places, self.times = [turn.pieces[0].start], [flint.arb(0)]

    @property
    def begun(self) -> Number:
        """The time where the first piece begins, since the dead centre in the gap before it."""
        last = self.spans[-1]
        return flint.arb(0) if last.smooth else self._elapsed(last, last.start, last.end).union(flint.arb(0))

    def time(self, half_turns: Fraction) -> Number:
        """Return the time since the first piece began."""
        index = bisect_right(self.places, half_turns) - 1
        place, time = self.places[index], self.times[index]
        for span in self.spans:
            start, end = max(span.start, place), min(span.end, half_turns)
            if start < end:
                time = time + self._elapsed(span, start, end)
                self._keep(end, time)
        return time

    def _keep(self, place: Fraction, time: Number) -> None:
        index = bisect_right(self.places, place)
        self.places.insert(index, place)
        self.times.insert(index, time)

    def _elapsed(self, span: Span, start: Fraction, end: Fraction) -> Number:
        if not span.smooth:
            return ball(end - start) / self._speed_over(span)
        middle = float((span.start + span.end) / 2)
        (piece,) = span.pieces

        def slowness(place: Any, analytic: bool) -> Any:
            return (1 / self.run.speed_on(self.cylinders, piece, Continued(place, middle))).ball

        return flint.acb.integral(slowness, ball(start), ball(end)).real

    def _speed_over(self, span: Span) -> Number:
        """The speed over a gap; the last one of the cycle is in the first piece again."""
        over, run = interval(span.start, span.end), self.run
        first, *others = (
            run.speed_on(self.turn.cylinders, piece, over - self.turn.cycle * (piece.end < span.start))
            for piece in span.pieces
        )
        for other in others:
            first = first.union(other)
        return first


def spans(turn: Turn) -> Iterator[Span]:
    """Yield what lies between dead centres and corners, and the gaps that hold these, over a cycle."""
    first = turn.pieces[0]
    last = first._replace(start=first.start + turn.cycle)
    for piece, following in pairwise((*turn.pieces, last)):
        start = piece.start
        for low, high in _corners(turn, piece):
            if start < low:
                yield Span(start, low, (piece,), smooth=True)
            yield Span(max(start, low), high, (piece,))
            start = high
        if start < piece.end:
            yield Span(start, piece.end, (piece,), smooth=True)
        if piece.end < following.start:
            yield Span(piece.end, following.start, (piece, first if following is last else following))


def _corners(turn: Turn, piece: Piece) -> list[tuple[Fraction, Fraction]]:
    """Return where the corners of the force lie within a piece, each between two places."""
    with flint.ctx.workprec(flint.ctx.prec + NARROWER):
        found = [
            turn.angle_of(part, stroke, corner) + ball(begun)
            for part, stroke, begun in piece.strokes
            for corner in _corners_of(turn.cylinders[part].strokes[stroke])
            if corner > 0 and corner < 1
        ]
    ends = sorted((fraction(one.lower()), fraction(one.upper())) for one in found)
    joined: list[tuple[Fraction, Fraction]] = []
    for low, high in ends:
        if high <= piece.start or low >= piece.end:
            continue
        if joined and low <= joined[-1][1]:
            low, high = joined[-1][0], max(high, joined.pop()[1])
        joined.append((max(low, piece.start), min(high, piece.end)))
    return joined


def _corners_of(stroke: Any) -> tuple[Number, ...]:
    return tuple(stroke.corners)
