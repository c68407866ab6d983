"""Integrals over the turn of what is analytic between dead centres and corners, enclosed with proof.

Flint encloses them where one formula holds. A dead centre or a corner that no rational number of half turns
says lies in a gap between two near ones, over which the integrand is a ball.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import Any, NamedTuple

import flint

from kurbel.engine.cylinder import Cylinder
from kurbel.engine.turn import Piece, Turn
from kurbel.exact.certify import ball
from kurbel.exact.continued import Continued, continued, half_turn_circle, integrated
from kurbel.exact.place import fraction
from kurbel.exact.roots import interval
from kurbel.kernel.circle import Number

# Of cylinders on a kind of number, a piece and a place in it.
Integrand = Callable[[Sequence[Cylinder], Piece, Any], Any]

# Bits beyond those of the precision in force to which a corner is known.
NARROWER = 32


class Span(NamedTuple):
    """A part of the cycle, in half turns, and the pieces that it lies in; what is not smooth is a gap."""

    start: Fraction
    end: Fraction
    pieces: tuple[Piece, ...]
    smooth: bool = False


class Integral:
    """An integral over the half turns from the beginning of the first piece on, at the precision in force.

    What was computed once helps with what comes later.
    """

    def __init__(self, turn: Turn, integrand: Integrand) -> None:
        self.turn, self.integrand = turn, integrand
        self.spans = tuple(spans(turn))
        self.cylinders = turn.cylinders_on(continued(), half_turn_circle)
        self.places, self.values = [turn.pieces[0].start], [flint.arb(0)]

    @property
    def before(self) -> Number:
        """What it may be from the dead centre to the first piece, in the gap between them."""
        last = self.spans[-1]
        return flint.arb(0) if last.smooth else self._over(last, last.start, last.end).union(flint.arb(0))

    @property
    def gap(self) -> Fraction:
        """How wide that gap is."""
        last = self.spans[-1]
        return Fraction(0) if last.smooth else last.end - last.start

    @property
    def whole(self) -> Number:
        """That over a cycle."""
        return self.to(self.turn.pieces[0].start + self.turn.cycle)

    def to(self, half_turns: Fraction) -> Number:
        """Return the integral to a place, at most a cycle on."""
        index = bisect_right(self.places, half_turns) - 1
        place, value = self.places[index], self.values[index]
        for span in self.spans:
            start, end = max(span.start, place), min(span.end, half_turns)
            if start < end:
                value = value + self._over(span, start, end)
                self._keep(end, value)
        return value

    def _keep(self, place: Fraction, value: Number) -> None:
        index = bisect_right(self.places, place)
        self.places.insert(index, place)
        self.values.insert(index, value)

    def _over(self, span: Span, start: Fraction, end: Fraction) -> Number:
        if not span.smooth:
            return ball(end - start) * self._gap(span)
        middle = float((span.start + span.end) / 2)
        (piece,) = span.pieces

        def value(place: Any, analytic: bool) -> Any:
            return self.integrand(self.cylinders, piece, Continued(place, middle)).ball

        return integrated(value, ball(start), ball(end)).real

    def _gap(self, span: Span) -> Number:
        """The integrand over a gap; the last one of the cycle is in the first piece again."""
        over, turn = interval(span.start, span.end), self.turn
        values = (
            self.integrand(turn.cylinders, piece, over - turn.cycle * (piece.end < span.start))
            for piece in span.pieces
        )
        return reduce(lambda one, other: one.union(other), values)


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
