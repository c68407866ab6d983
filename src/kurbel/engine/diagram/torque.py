"""A torque over a cycle of the crank: a sum of waves, straight lines, or both, in N m, with rational numbers.

Angles are in degrees, from the beginning of the cycle on, and the torque comes again after the cycle. Where
it jumps it has the value behind the jump.

Sums of waves a cos(kφ + α) with rational a, k and α in degrees: what sines of φ and their products are.

Such a sum stays one when it is added, multiplied, turned, differentiated or integrated, so that a torque in
sines has its mean, its energy and its slope in closed form. Angles are in degrees.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate, pairwise
from math import gcd, lcm
from typing import NamedTuple, TypeAlias

import flint
from flint import arb

from kurbel.errors import ProblemError
from kurbel.exact.certify import MOST_BITS, ball, vanishes
from kurbel.exact.kind import Kind, balls, separation_of
from kurbel.exact.separation import plus, times
from kurbel.kernel.circle import Numeric
from kurbel.reading.given import FrozenValue
from kurbel.reading.notation import about

TURN = 360
MOST_TURNS = 100
MOST_LINES = 20_000


class Line(NamedTuple):
    """What a torque has in addition from one angle to another: its first value, and its slope per degree."""

    start: Fraction
    end: Fraction
    first: Fraction
    slope: Fraction = Fraction(0)

    def value(self, degrees: Fraction) -> Fraction:
        return self.first + self.slope * (degrees - self.start)

    @property
    def last(self) -> Fraction:
        return self.value(self.end)

    @property
    def area(self) -> Fraction:
        """What is below it, in N m times degrees."""
        return (self.end - self.start) * (self.first + self.last) / 2


@dataclass(frozen=True)
class Torque(FrozenValue):
    """A sum of waves and the lines beside it, one behind the other over the whole cycle."""

    waves: Waves
    lines: tuple[Line, ...]

    @classmethod
    def of(cls, waves: Waves, cycle: Fraction) -> Torque:
        """Return a sum of waves, of which the cycle is a multiple of the period."""
        level = waves.level.rational
        line = Line(Fraction(0), cycle, level or Fraction(0))
        return cls(waves if level is None else waves - waves.level, (line,))

    @property
    def cycle(self) -> Fraction:
        """The degrees of a cycle."""
        return self.lines[-1].end

    @property
    def turns(self) -> Fraction:
        return self.cycle / TURN

    @cached_property
    def mean(self) -> Waves:
        """The mean over a cycle, a sum of constants."""
        return self.waves.level + Waves.constant(sum(one.area for one in self.lines) / self.cycle)

    @cached_property
    def most(self) -> Fraction:
        """A bound of its magnitude."""
        level = max(max(abs(one.first), abs(one.last)) for one in self.lines)
        return level + sum(map(abs, self.waves.amplitudes.values()))

    @property
    def jumps(self) -> bool:
        """Whether it jumps anywhere, at the end of the cycle too."""
        return any(self.jump(one.start) for one in self.lines)

    def jump(self, degrees: Fraction) -> Fraction:
        """Return by how much it jumps at an angle, 0 where it does not."""
        place = degrees % self.cycle
        number = self.line_at(place)
        line = self.lines[number]
        return line.first - self.lines[number - 1].last if line.start == place else Fraction(0)

    @cached_property
    def _starts(self) -> list[Fraction]:
        return [one.start for one in self.lines]

    @cached_property
    def _areas(self) -> list[Fraction]:
        """What is below the lines before each."""
        return [Fraction(0), *accumulate(one.area for one in self.lines)]

    def line_at(self, degrees: Fraction) -> int:
        """Return the number of the line at an angle of the cycle, behind a corner."""
        return bisect_right(self._starts, degrees) - 1

    def at(self, degrees: Fraction, kind: Kind) -> Numeric:
        """Return the torque at a crank angle."""
        place = degrees % self.cycle
        return self.waves.at(degrees, kind) + kind.of(self.lines[self.line_at(place)].value(place))

    def area(self, degrees: Fraction, number: int) -> Fraction:
        """Return what is below the lines from 0 to an angle on one of them, in N m times degrees."""
        line = self.lines[number]
        behind = degrees - line.start
        return self._areas[number] + line.first * behind + line.slope * behind * behind / 2

    def __add__(self, other: Torque) -> Torque:
        cycle = common_cycle(self.cycle, other.cycle)
        one, two = self.over(cycle), other.over(cycle)
        ends = sorted({*(line.end for line in one.lines), *(line.end for line in two.lines)})
        return Torque(one.waves + two.waves, tuple(_joined(one, two, ends)))

    def __sub__(self, other: Torque) -> Torque:
        minus = Fraction(-1)
        lines = (one._replace(first=-one.first, slope=-one.slope) for one in other.lines)
        return self + Torque(other.waves.times(minus), tuple(lines))

    def over(self, cycle: Fraction) -> Torque:
        """Return the same over a multiple of its cycle."""
        times = int(cycle / self.cycle)
        if times * len(self.lines) > MOST_LINES:
            raise ProblemError(
                f"the diagram has {times * len(self.lines)} lines over its cycle; at most {MOST_LINES} are"
                " computed"
            )
        return Torque(
            self.waves,
            tuple(
                one._replace(start=one.start + begun, end=one.end + begun)
                for begun in (number * self.cycle for number in range(times))
                for one in self.lines
            ),
        )

    def turned(self, degrees: Fraction) -> Torque:
        """Return the torque of a crank that follows by an angle."""
        waves, behind = self.waves.turned(degrees), degrees % self.cycle
        if not behind:
            return Torque(waves, self.lines)
        shifted = [one._replace(start=one.start + behind, end=one.end + behind) for one in self.lines]
        return Torque(waves, tuple(_wrapped(shifted, self.cycle)))

    def superposed(self, cranks: Sequence[Fraction]) -> Torque:
        """Return the torque of cranks alike that follow by these angles."""
        first, *others = (self.turned(one) for one in cranks)
        return sum(others, first)


def common_cycle(one: Fraction, other: Fraction) -> Fraction:
    """Return the shortest cycle that is a multiple of both."""
    above = lcm(one.numerator * other.denominator, other.numerator * one.denominator)
    cycle = Fraction(above, one.denominator * other.denominator)
    if cycle > MOST_TURNS * TURN:
        raise ProblemError(
            f"cycles of {about(one)}° and {about(other)}° have none in common within {MOST_TURNS} turns"
        )
    return cycle


def own_cycle(waves: Waves, turns: Fraction | None, what: str) -> Fraction:
    """Return the degrees of a cycle of a formula: of these turns, or the fewest whole ones."""
    base = waves.base
    if turns is None:
        # A period is 360°/base: q/p turns of the base p/q, of which p make whole ones.
        turns = Fraction(base.denominator) if base else Fraction(1)
        if turns > MOST_TURNS:
            raise ProblemError(
                f"the formula of the {what} comes again after {turns} turns; at most {MOST_TURNS} are"
                " computed"
            )
    elif (turns * base).denominator != 1:
        raise ProblemError(
            f"the formula of the {what} comes again after {about(TURN / base)}°, and a cycle of"
            f" {turns} turns has {about(turns * TURN)}°; give a multiple of"
            f" {1 / base} turns as --turns"
        )
    return turns * TURN


def _joined(one: Torque, two: Torque, ends: Iterable[Fraction]) -> Iterable[Line]:
    for start, end in pairwise((Fraction(0), *ends)):
        parts = [torque.lines[torque.line_at(start)] for torque in (one, two)]
        first, slope = sum(part.value(start) for part in parts), sum(part.slope for part in parts)
        yield Line(start, end, Fraction(first), Fraction(slope))


def _wrapped(lines: Iterable[Line], cycle: Fraction) -> Iterable[Line]:
    """Return lines that go beyond the cycle within it, in order."""
    found = []
    for one in lines:
        if one.start >= cycle:
            found.append(one._replace(start=one.start - cycle, end=one.end - cycle))
        elif one.end > cycle:
            found.append(one._replace(end=cycle))
            found.append(Line(Fraction(0), one.end - cycle, one.value(cycle), one.slope))
        else:
            found.append(one)
    return sorted(found)


# Of a wave its order k and its phase α, at least 0° and below 180°, of a constant at most 90°.
Wave: TypeAlias = tuple[Fraction, Fraction]
# Cosines that are rational numbers; no other angles of the first quarter have one (Niven).
_COSINES = {0: Fraction(1), 60: Fraction(1, 2), 90: Fraction(0)}
HALF_TURN, QUARTER = Fraction(180), Fraction(90)


@dataclass(frozen=True)
class Waves(FrozenValue):
    """A sum of waves by their amplitudes, each of which is not zero."""

    amplitudes: Mapping[Wave, Fraction]

    @classmethod
    def of(cls, parts: Iterable[tuple[Fraction, Fraction, Fraction]]) -> Waves:
        """Return the sum of waves of these amplitudes, orders and phases."""
        found: dict[Wave, Fraction] = {}
        for amplitude, order, phase in parts:
            wave, own = _normal(amplitude, order, phase)
            found[wave] = plus(found.get(wave, Fraction(0)), own)
        return cls({wave: found[wave] for wave in sorted(found) if found[wave]})

    @classmethod
    def constant(cls, value: Fraction) -> Waves:
        return cls.of([(value, Fraction(0), Fraction(0))])

    @classmethod
    def cosine(cls, order: Fraction, phase: Fraction) -> Waves:
        """Return cos(kφ + α)."""
        return cls.of([(Fraction(1), order, phase)])

    @property
    def parts(self) -> Iterable[tuple[Fraction, Fraction, Fraction]]:
        """The amplitude, the order and the phase of each wave."""
        return ((amplitude, *wave) for wave, amplitude in self.amplitudes.items())

    def __bool__(self) -> bool:
        return bool(self.amplitudes)

    def __add__(self, other: Waves) -> Waves:
        return Waves.of((*self.parts, *other.parts))

    def __sub__(self, other: Waves) -> Waves:
        return self + other.times(Fraction(-1))

    def __mul__(self, other: Waves) -> Waves:
        # cos A cos B = ½ cos(A + B) + ½ cos(A - B)
        return Waves.of(
            (times(a, b) / 2, k + sign * order, phase + sign * turned)
            for a, k, phase in self.parts
            for b, order, turned in other.parts
            for sign in (1, -1)
        )

    def times(self, factor: Fraction) -> Waves:
        return Waves.of((times(factor, amplitude), *wave) for wave, amplitude in self.amplitudes.items())

    def turned(self, degrees: Fraction) -> Waves:
        """Return the same behind by an angle: what it was at φ it is at φ + angle."""
        return Waves.of((a, order, phase - order * degrees) for a, order, phase in self.parts)

    @cached_property
    def level(self) -> Waves:
        """The constant part."""
        return Waves({wave: a for wave, a in self.amplitudes.items() if not wave[0]})

    @cached_property
    def rational(self) -> Fraction | None:
        """The sum where it is one rational number, None where it is not."""
        if not self.amplitudes:
            return Fraction(0)
        return self.amplitudes.get((Fraction(0), Fraction(0))) if len(self.amplitudes) == 1 else None

    @cached_property
    def orders(self) -> tuple[Fraction, ...]:
        """The orders above 0, each once."""
        return tuple(dict.fromkeys(order for order, _ in self.amplitudes if order))

    @property
    def base(self) -> Fraction:
        """The greatest order of which all are multiples; 0 of a constant."""
        if not self.orders:
            return Fraction(0)
        above = gcd(*(order.numerator for order in self.orders))
        return Fraction(above, lcm(*(order.denominator for order in self.orders)))

    @cached_property
    def slope(self) -> Waves:
        """The slope over the angle in radians."""
        return Waves.of((a * order, order, phase + QUARTER) for a, order, phase in self.parts)

    @cached_property
    def integral(self) -> Waves:
        """What has the sum without its constant part as its slope over the angle in radians."""
        return Waves.of((a / order, order, phase - QUARTER) for a, order, phase in self.parts if order)

    def placed(self, degrees: Fraction) -> Waves:
        """Return the sum at a crank angle as one of constants, of which equal ones are one."""
        return Waves.of((a, Fraction(0), order * degrees + phase) for a, order, phase in self.parts)

    def at(self, degrees: Fraction, kind: Kind) -> Numeric:
        """Return the sum at a crank angle, on a kind of number."""
        total = kind.of(Fraction(0))
        for amplitude, _, phase in self.placed(degrees).parts:
            own = kind.of(amplitude)
            total = total + (own * kind.circle(phase).cosine if phase else own)
        return total

    def within(self, degrees: arb) -> arb:
        """Return the sum at an angle that is a ball."""
        total, half_turns = arb(0), degrees / 180
        for amplitude, order, phase in self._balls(flint.ctx.prec):
            total += amplitude * (order * half_turns + phase).cos_pi()
        return total

    def _balls(self, precision: int) -> list[tuple[arb, arb, arb]]:
        """Return the waves as balls, phases in half turns; made once for each precision."""
        if precision not in self._enclosed:
            self._enclosed[precision] = [
                (ball(amplitude), ball(order), ball(phase / 180)) for amplitude, order, phase in self.parts
            ]
        return self._enclosed[precision]

    @cached_property
    def _enclosed(self) -> dict[int, list[tuple[arb, arb, arb]]]:
        return {}

    def vanishes(self, degrees: Fraction, level: Fraction = Fraction(0)) -> bool:
        """Whether the sum and a number beside it are 0 at a crank angle, proved within MOST_BITS."""
        if not self.placed(degrees) + Waves.constant(level):
            return True

        def value(kind: Kind) -> Numeric:
            return self.at(degrees, kind) + kind.of(level)

        bits = separation_of(value).bits()
        return bits < MOST_BITS and vanishes(lambda: ball(value(balls())), bits)


def _normal(amplitude: Fraction, order: Fraction, phase: Fraction) -> tuple[Wave, Fraction]:
    """Return the wave with an order and a phase that are not negative, and its amplitude."""
    if order < 0:
        order, phase = -order, -phase
    phase %= 360
    if phase >= HALF_TURN:
        amplitude, phase = -amplitude, phase - HALF_TURN
    if not order and phase > QUARTER:
        amplitude, phase = -amplitude, HALF_TURN - phase
    if not order and phase in _COSINES:
        amplitude, phase = amplitude * _COSINES[int(phase)], Fraction(0)
    return (order, phase), amplitude
