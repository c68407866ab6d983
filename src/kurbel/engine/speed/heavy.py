"""The speed over the turn of an engine whose masses move, by the energy of all that moves.

With ω = s ω_m, where ω_m is the mean speed, the energy of flywheel and masses is (½ I + k) s²: I is J ω_m²
and k that part of the masses' energy at ω_m which changes with the angle, in Q R. So (½ I + k) s² = E + W,
where W is the work of the steam alone above its mean and E = (½ I + k₀) u the energy at the dead centre,
u = s₁². What is not known beforehand is u, for the mean speed ½ (s_max + s_min) is 1. At every angle s rises
with u, and so does that mean: interval Newton encloses the one u.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import NamedTuple

import flint

from kurbel.drive.wheel import Wheel
from kurbel.engine.cylinder import Cylinder
from kurbel.engine.speed.moving import Course, course_at, course_on, slopes_on
from kurbel.engine.speed.run import AnyRun
from kurbel.engine.speed.samples import first_start
from kurbel.engine.turn import GAP_BITS, Extremum, Piece, Turn, place, stationary
from kurbel.errors import ProblemError
from kurbel.exact.roots import ISOLATING_BITS, Function, Root, interval, refined
from kurbel.kernel.circle import Number, root
from kurbel.kernel.steam import larger, smaller

# How far around its first value u is looked for, and so many times sixteen times as far.
NEAR, FARTHER = Fraction(1, 2**22), 4


class Level(NamedTuple):
    """What u makes: ½ I and E, and how these grow with it."""

    half: Number
    energy: Number
    half_growth: Number
    energy_growth: Number

    def square(self, at: Course) -> Number:
        """Return s²."""
        return (self.energy + at.work) / (self.half + at.energy)

    def growth(self, at: Course) -> Number:
        """Return how s² grows with u."""
        return (self.energy_growth - self.square(at) * self.half_growth) / (self.half + at.energy)


class HeavyRun(AnyRun):
    """A turn with moving masses against a constant torque, in balls."""

    turn: Turn

    def __init__(self, turn: Turn, wheel: Wheel) -> None:
        super().__init__(turn, wheel)
        self._begun: dict[int, Course] = {}
        self._states: dict[int, tuple[Level, Number]] = {}
        self._root = self._isolated()

    @property
    def begun(self) -> Course:
        """Work and energy at the dead centre, from which the work counts."""
        bits = flint.ctx.prec
        if bits not in self._begun:
            self._begun[bits] = course_at(self.turn, self.turn.begun())
        return self._begun[bits]

    def level(self, start: Number) -> Level:
        """Return what a u makes."""
        before, mean = self.begun.energy, abs(self.turn.mean_force())
        if self.wheel.number is None:
            half = self.at_mean * mean / 2
            return Level(half, (half + before) * start, 0 * start, half + before)
        first = self.turn.of(self.wheel.number) * mean / 2
        return Level(first / start, first + before * start, -first / (start * start), before)

    @property
    def start(self) -> Number:
        """u, the square of ω₁/ω_m."""
        return self._state[1]

    @property
    def _state(self) -> tuple[Level, Number]:
        """What u makes, and u itself."""
        bits = flint.ctx.prec
        if bits not in self._states:
            start = refined(self._beyond, self._slope, self._root)
            self._states[bits] = self.level(start), start
        return self._states[bits]

    @property
    def number(self) -> Number:
        level, start = self._state
        return 2 * level.half * start / abs(self.turn.mean_force())

    @property
    def first_omega(self) -> Number:
        return self.mean_omega * root(self.start)

    def speed(self, half_turns: Fraction) -> Number:
        return self._relative(course_at(self.turn, self.turn.positions(half_turns)))

    def speed_on(self, cylinders: Sequence[Cylinder], piece: Piece, place: Number) -> Number:
        return self._relative(course_on(cylinders, piece, place))

    def _relative(self, at: Course) -> Number:
        """v/v₁ where work and energy are such."""
        level, start = self._state
        return root(level.square(at._replace(work=at.work - self.begun.work)) / start)

    def extreme_place(self, greatest: bool) -> Number:
        return self._extremes(self.start, greatest)[0][0]

    def extreme_speed(self, greatest: bool) -> Number:
        return root(self._extreme_square(self.start, greatest) / self.start)

    def _isolated(self) -> Root:
        """Return two numbers between which u lies, for certain, and know the extremes between them."""
        start = first_start(self)
        width = start * NEAR
        for _ in range(FARTHER):
            with flint.ctx.workprec(ISOLATING_BITS):
                self._found = tuple(self._stationary(interval(start - width, start + width)))
                ends = [self._beyond(interval(end, end)) for end in (start - width, start + width)]
            if ends[0] < 0 and ends[1] > 0:
                return Root(start - width, start + width, True)
            width *= 16
        raise ProblemError("the speed at the dead centre is not settled; give slightly other numbers")

    def _stationary(self, start: Number) -> Iterator[Extremum]:
        """Yield where the speed is least or greatest, for any u of a ball."""
        for piece, following in pairwise((*self.turn.pieces, self.turn.pieces[0])):
            yield from stationary(piece, *self._functions(start, piece))
            self._check_gap(start, piece, following)

    def _functions(self, start: Number, piece: Piece) -> tuple[Function, Function]:
        """Return what has the sign of the slope of s² over the angle, and its own slope."""
        level, before = self.level(start), self.begun.work

        def parts(at: Number) -> tuple[Number, Number]:
            one = course_on(self.turn.cylinders, piece, at)
            return level.half + one.energy, level.energy + one.work - before

        def change(at: Number) -> Number:
            inertia, energy = parts(at)
            slopes = slopes_on(self.turn, piece, at)
            return slopes.force * inertia - energy * slopes.torque

        def bend(at: Number) -> Number:
            inertia, energy = parts(at)
            slopes = slopes_on(self.turn, piece, at)
            return slopes.bend * inertia - energy * slopes.curve

        return change, bend

    def _check_gap(self, start: Number, before: Piece, after: Piece) -> None:
        """Raise ProblemError if the speed may turn so near to a dead centre that it is not told from it."""
        turns = self.turn.cycle if after.start < before.start else 0
        if before.end == after.start + turns:
            return
        with flint.ctx.workprec(GAP_BITS):
            gap = interval(before.end, after.start + turns)
            behind, beyond = (
                self._functions(start, before)[0](gap),
                self._functions(start, after)[0](gap - turns),
            )
            if behind.union(beyond).contains(0):
                raise ProblemError("the speed turns in a dead centre; its extremes cannot be told apart")

    def _extremes(self, start: Number, greatest: bool) -> list[tuple[Number, Course]]:
        """Return the places where s² may be the greatest or the least, with work and energy there."""
        level, sign, found = self.level(start), 1 if greatest else -1, []
        for one in self._found:
            if one.root.rising is not greatest:
                change, bend = self._functions(start, one.piece)
                at = place(one._replace(function=change, slope=bend))
                course = course_on(self.turn.cylinders, one.piece, at)
                found.append((at, course._replace(work=course.work - self.begun.work)))
        squares = [sign * level.square(course) for _, course in found]
        return [
            one for one, own in zip(found, squares, strict=True) if not any(own < other for other in squares)
        ]

    def _extreme_square(self, start: Number, greatest: bool) -> Number:
        level, found = self.level(start), self._extremes(start, greatest)
        return reduce(larger if greatest else smaller, (level.square(course) for _, course in found))

    def _beyond(self, start: Number) -> Number:
        """The mean speed above 1, where u is such."""
        ends = (root(self._extreme_square(start, greatest)) for greatest in (True, False))
        return sum(ends) / 2 - 1

    def _slope(self, start: Number) -> Number:
        """How that grows with u; the places of the extremes move, which does not matter."""
        level, total = self.level(start), flint.arb(0)
        for greatest in (True, False):
            first, *others = (
                level.growth(course) / (4 * root(level.square(course)))
                for _, course in self._extremes(start, greatest)
            )
            total += reduce(lambda one, other: one.union(other), others, first)
        return total
