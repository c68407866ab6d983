"""Functions over a cycle of the engine, as power series on sections between dead centres and corners.

A dead centre or a corner that no rational number of half turns says lies in a gap between two near ones.
There a section ends and the next one begins, and the series of both reach over the gap.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial, reduce
from itertools import pairwise, repeat
from operator import add, truediv
from typing import TYPE_CHECKING, Any, NamedTuple

import flint
from flint import arb

from kurbel.engine.turn import Turn, TurnPiece
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.place import fraction
from kurbel.exact.search import Function, Zero, interval, isolate
from kurbel.exact.taylor import (
    ComplexNumber,
    Formula,
    bounded,
    continued,
    expanded,
    half_turn_circle,
)
from kurbel.kernel.circle import Numeric
from kurbel.kernel.steam import larger, smaller

if TYPE_CHECKING:
    from kurbel.engine.speed.samples import Samples

# Bits to which a corner is known, or so many beyond the precision in force if that is more: up to there all
# precisions have the same sections.
CORNER_BITS, NARROWER = 288, 32
# The half widths that the disk about a section has, how many times a function may be there what it is in the
# middle, and a section so narrow that no formula is analytic there.
RADII, MOST, NARROWEST = 4, 1e5, Fraction(1, 2**24)
# Sections are halved until a power of a function is known on a disk about each.
MOST_HALVINGS = 24
# By so much of its width a section is searched beyond its ends, where a zero of a slope may lie by a hair.
BEYOND = Fraction(1, 18)

# Of sections by their ends the bounds of the two formulas, None where they have none.
Bounds = dict[tuple[Fraction, Fraction], tuple[arb | None, ...]]


class Span(NamedTuple):
    """A part of the cycle, in half turns, and the pieces that it lies in; what is not smooth is a gap."""

    start: Fraction
    end: Fraction
    pieces: tuple[TurnPiece, ...]
    smooth: bool = False


class Section(NamedTuple):
    """A function where one series, or a quotient of two, has it: for certain from `low` to `high`, and from a
    ball to another."""

    low: Fraction
    high: Fraction
    start: arb
    end: arb
    function: Any

    @property
    def slopes(self) -> tuple[Function, Function]:
        """The slope over the half turns, and its own slope."""
        return partial(self.function.at, order=1), partial(self.function.at, order=2)

    def powers(self, exponent: Fraction, halvings: int = MOST_HALVINGS) -> Iterator[Section]:
        """Yield a power of what is above 0, of halves where it is not known of the whole."""
        found = self.function.power(exponent)
        if found is not None:
            yield self._replace(function=found)
            return
        if not halvings:
            raise ProblemError(
                "the speed is not settled, for it all but comes to rest; give a heavier flywheel"
            )
        middle = (self.low + self.high) / 2
        for low, high, ends in (
            (self.low, middle, (self.start, ball(middle))),
            (middle, self.high, (ball(middle), self.end)),
        ):
            half = Section(low, high, *ends, self.function.about((low + high) / 2))
            yield from half.powers(exponent, halvings - 1)


class Course:
    """A function over a cycle of so many half turns, section by section, and by how much it grows in one."""

    def __init__(self, sections: Iterable[Section], cycle: int, gain: arb | int = 0) -> None:
        self.sections, self.cycle, self.gain = tuple(sections), cycle, gain
        self.lows = [one.low for one in self.sections]

    @property
    def first(self) -> arb:
        """The function where the first section begins, at the dead centre."""
        return ball(self.sections[0].function.at(self.sections[0].start))

    def at(self, half_turns: Fraction) -> arb:
        """Return the function at a place of any cycle."""
        cycles, rest = divmod(half_turns - self.lows[0], self.cycle)
        place = self.lows[0] + rest
        index = bisect_right(self.lows, place) - 1
        own, following = self.sections[index], self.sections[(index + 1) % len(self.sections)]
        value: arb = own.function.at(ball(place))
        if place > own.high:
            # In a gap either series may hold.
            turns = int(own is self.sections[-1])
            value = value.union(following.function.at(ball(place - turns * self.cycle)) + turns * self.gain)
        return value + cycles * self.gain

    def __add__(self, other: Course | arb) -> Course:
        return self._with(other, add)

    def __truediv__(self, other: Course | arb) -> Course:
        return self._with(other, truediv)

    def _with(self, other: Course | arb, combined: Callable[[Any, Any], Any]) -> Course:
        """Return what both make, of a number or of a course of the same sections."""
        others = [one.function for one in other.sections] if isinstance(other, Course) else repeat(other)
        pairs = zip(self.sections, others, strict=False)
        return Course((one._replace(function=combined(one.function, own)) for one, own in pairs), self.cycle)

    def power(self, exponent: Fraction) -> Course:
        """Return a power of what is above 0."""
        return Course((part for one in self.sections for part in one.powers(exponent)), self.cycle)

    def sum(self) -> Course:
        """Return the integral from where the first section begins."""
        total, found = arb(0), []
        for one in self.sections:
            own = one.function.sum()
            own = own + (total - own.at(one.start))
            total = own.at(one.end)
            found.append(one._replace(function=own))
        return Course(found, self.cycle, total)

    def lagging(self, rate: arb) -> Course:
        """Return y of the cycle after which it comes again, where y' = -rate (f + y) of the function f."""
        begun, middles = arb(0), []
        for one in self.sections:
            own = one.function.lagging(rate)
            before, behind = (rate * (place - ball(own.middle)) for place in (one.start, one.end))
            middles.append((begun - own.at(one.start)) * before.exp())
            begun = own.at(one.end) + middles[-1] * (-behind).exp()
        # So much is still to be there when the cycle begins anew, and decays beside the rest.
        begun /= 1 - (-rate * self.cycle).exp()
        found = []
        for one, middle in zip(self.sections, middles, strict=True):
            more = begun * (rate * (self.sections[0].start - ball(one.function.middle))).exp()
            found.append(one._replace(function=one.function.lagging(rate, middle + more)))
        return Course(found, self.cycle)

    def turnings(self) -> Iterator[tuple[int, Zero]]:
        """Yield by their sections the zeros of the slope, of all functions that the balls hold."""
        for index, (before, one) in enumerate(pairwise((self.sections[-1], *self.sections))):
            if before.function.at(before.end, 1) * one.function.at(one.start, 1) < 0:
                raise ProblemError("the speed turns in a dead centre; its extremes cannot be told apart")
            more = (one.high - one.low) * BEYOND
            for zero in isolate(*one.slopes, one.low - more, one.high + more):
                yield index, zero

    def extreme(self, greatest: bool, turnings: Iterable[tuple[int, Zero]]) -> tuple[arb, arb]:
        """Return where the function is greatest or least, and what it is there, of these places."""
        sign, found = 1 if greatest else -1, []
        for index, zero in turnings:
            if zero.rising is not greatest:
                section = self.sections[index]
                at = zero.of(*section.slopes).place()
                if not (at < section.start or at > section.end):
                    found.append((at, section.function.at(at)))
        left = [one for one in found if not any(sign * one[1] < sign * other for _, other in found)]
        values: Iterator[Numeric] = (value for _, value in left)
        return left[0][0], ball(reduce(larger if greatest else smaller, values))

    def in_floats(self) -> Samples:
        """Return the same on samples, nearly."""
        from kurbel.engine.speed.samples import SAMPLES, Samples

        start, steps = self.lows[0], range(self.cycle // 2 * SAMPLES)
        values = [float(self.at(start + Fraction(2 * step, SAMPLES))) for step in steps]
        return Samples(values, float(start), self.cycle)


def energies(turn: Turn, bounds: Bounds) -> tuple[Course, Course]:
    """Return the work of the pressure above its mean since the dead centre, and the energy of the masses at
    the mean speed, as far as it changes, in Q R.

    `bounds` keeps what was bounded for another precision.
    """
    cylinders = turn.cylinders_on(continued(), half_turn_circle)
    still = [one.still for one in cylinders]
    begun = sum(turn.cylinders[part].still.energy(*one) for part, *one in turn.begun())

    def work(piece: TurnPiece, place: ComplexNumber) -> ComplexNumber:
        return ComplexNumber.of(_sum(piece, place, [one.energy for one in still]) - begun)

    def energy(piece: TurnPiece, place: ComplexNumber) -> ComplexNumber:
        return ComplexNumber.of(_sum(piece, place, [one.kinetic_energy for one in cylinders]))

    found: list[tuple[Section, Section]] = []
    smooth = [one for one in spans(turn) if one.smooth]
    ends = (smooth[-1].end - turn.cycle, *(one.end for one in smooth))
    starts = (*(one.start for one in smooth), smooth[0].start + turn.cycle)
    edges = [interval(end, start) for end, start in zip(ends, starts, strict=True)]
    for span, (start, end) in zip(smooth, pairwise(edges), strict=True):
        formulas = [partial(one, span.pieces[0]) for one in (work, energy)]
        found += _sections(formulas, bounds, span.start, span.end, start, end)
    works, moved = zip(*found, strict=True)
    return Course(works, turn.cycle), Course(moved, turn.cycle)


def _sections(
    formulas: Sequence[Formula], bounds: Bounds, low: Fraction, high: Fraction, start: arb, end: arb
) -> Iterator[tuple[Section, Section]]:
    """Yield the sections of two formulas within an interval, so short that both have a series there."""
    if (low, high) not in bounds:
        bounds[low, high] = tuple(bounded(one, low, high, RADII, MOST) for one in formulas)
    known = [one for one in bounds[low, high] if one is not None]
    if len(known) == len(formulas):
        pairs = zip(formulas, known, strict=True)
        work, energy = (expanded(one, low, high, RADII, bound) for one, bound in pairs)
        yield Section(low, high, start, end, work), Section(low, high, start, end, energy)
        return
    if high - low < NARROWEST:
        raise ProblemError("the speed is not settled beside a dead centre; give slightly other numbers")
    middle = (low + high) / 2
    yield from _sections(formulas, bounds, low, middle, start, ball(middle))
    yield from _sections(formulas, bounds, middle, high, ball(middle), end)


def _sum(piece: TurnPiece, place: ComplexNumber, formulas: Sequence[Callable[[int, Any], Any]]) -> Any:
    return sum(
        count * formulas[part](stroke, place - ball(begun)) for count, part, stroke, begun in piece.unlike
    )


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


def _corners(turn: Turn, piece: TurnPiece) -> list[tuple[Fraction, Fraction]]:
    """Return where the corners of the force lie within a piece, each between two places."""
    with at_bits(max(CORNER_BITS, flint.ctx.prec + NARROWER)):
        found = [
            turn.angle_of(part, stroke, corner) + ball(begun)
            for part, stroke, begun in piece.strokes
            for corner in turn.cylinders[part].strokes[stroke].corners
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
