"""The excess of a driving torque over that of the load, in steady state: its energy and its extremes.

The excess energy is the integral of the excess over the angle from 0 on. With one of the two torques alone
the other is constant, its mean. Re-derived; closed form, with every digit certified.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel.engine.diagram.fluctuation import Extreme, work_of
from kurbel.engine.diagram.torque import TURN, Line, Torque, common_cycle
from kurbel.engine.diagram.waves import QUARTER, Waves
from kurbel.engine.diagram.zeros import Zero, is_plain, over_cycle, waves_at, zeros
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls, floats
from kurbel.reading.given import Given
from kurbel.reading.notation import about


@dataclass(frozen=True)
class Excess(Given):
    """A driving torque and that of the load, whose means are the same; in J per degree if `by_degree`.

    So diagrams are whose areas are given: those are rational, and the torques have 1/π.
    """

    drive: Torque
    load: Torque
    by_degree: bool = False

    def __post_init__(self) -> None:
        one, two = self.drive.mean, self.load.mean
        if not _agree(one, two):
            means = " and that of the load ".join(
                about(Fraction(float(mean.at(Fraction(0), floats()))).limit_denominator(10**9))
                for mean in (one, two)
            )
            raise ProblemError(
                f"the mean torque of the drive is {means} N m; over a cycle in steady state they must be the"
                " same, or the speed grows or falls from cycle to cycle"
            )
        if not self.excess.waves and is_plain(self.excess):
            raise ProblemError(
                "the torques of the drive and of the load are the same everywhere; the speed does not vary"
            )

    @classmethod
    def between(cls, drive: Torque | None, load: Torque | None, by_degree: bool) -> Excess:
        """Return the excess, where one of both is missing over the mean of the other."""
        if drive is None and load is None:
            raise ProblemError(
                "no torque was given; add --torque '5000 + 1500 sin(3φ)' or its points, '0:0; 60:90; 180:0',"
                " or that of the load, --load-torque"
            )
        if drive is None:
            assert load is not None
            return cls(_constant(load), load, by_degree)
        return cls(drive, _constant(drive) if load is None else load, by_degree)

    @cached_property
    def cycle(self) -> Fraction:
        """The degrees of a cycle of both."""
        return common_cycle(self.drive.cycle, self.load.cycle)

    @property
    def turns(self) -> Fraction:
        return self.cycle / TURN

    @cached_property
    def excess(self) -> Torque:
        """The drive's torque less the load's, whose mean is 0."""
        found = self.drive - self.load
        level = sum(one.area for one in found.lines) / found.cycle
        lines = tuple(one._replace(first=one.first - level) for one in found.lines)
        return Torque(_without_nothing(found.waves - found.waves.level), lines)

    def torque(self, torque: Torque, degrees: Fraction, kind: Kind) -> Any:
        """Return one of its torques at a crank angle, in N m."""
        own = torque.at(degrees, kind)
        return own * 180 / kind.pi if self.by_degree else own

    def greatest_torque(self, torque: Torque) -> float:
        """Return a bound of a torque's magnitude, in N m."""
        return float(torque.most) * (180 / floats().pi if self.by_degree else 1)

    def mean_torque(self, kind: Kind) -> Any:
        mean = self.drive.mean.at(Fraction(0), kind)
        return mean * 180 / kind.pi if self.by_degree else mean

    def work(self, kind: Kind) -> Any:
        if self.by_degree:
            return self.drive.mean.at(Fraction(0), kind) * kind.of(self.cycle)
        return work_of(self.mean_torque(kind), self.turns, kind)

    def energy(self, degrees: Fraction, kind: Kind) -> Any:
        """Return the excess energy in J at a crank angle, from 0° on."""
        return self._energy(Zero(degrees), kind)

    def swing(self, kind: Kind) -> Any:
        return self.extreme_energy(kind, greatest=True) - self.extreme_energy(kind, greatest=False)

    def extreme_energy(self, kind: Kind, *, greatest: bool) -> Any:
        """Return the greatest or the least excess energy in J."""
        return self._energy((self._greatest if greatest else self._least)[0], kind)

    def extremes(self, *, greatest: bool) -> tuple[Extreme, ...]:
        """Return the places within a cycle, in order."""
        return over_cycle(self._greatest if greatest else self._least, self.excess, self.cycle)

    @cached_property
    def _candidates(self) -> list[Zero]:
        return zeros(self.excess)

    @cached_property
    def _greatest(self) -> Sequence[Zero]:
        return self._choose(1)

    @cached_property
    def _least(self) -> Sequence[Zero]:
        return self._choose(-1)

    def _choose(self, sign: int) -> Sequence[Zero]:
        """Return where the energy, times the sign, is greatest; several only if they cannot be told apart."""
        from kurbel.exact.search import greatest as greatest_of

        left = self._candidates
        if not self.excess.waves:
            areas = [sign * (self._area(one) or 0) for one in left]
            return [one for one, area in zip(left, areas, strict=True) if area == max(areas)]
        left = greatest_of(left, lambda one: self._energy(one, balls()), sign)
        if any(one.is_open for one in left):
            raise ProblemError(
                "the speed rests where it should turn; its extremes cannot be told apart; give slightly other"
                " numbers"
            )
        return left

    def _energy(self, zero: Zero, kind: Kind) -> Any:
        if self.by_degree:
            return kind.of(self._area(zero) or Fraction(0))
        waves, area = self.excess.waves.integral, self._area(zero)
        gained = waves_at(waves, zero, self.excess.waves, kind) - waves.at(Fraction(0), kind)
        if is_plain(self.excess):
            return gained
        if area is not None:
            return gained + kind.of(area / 180) * kind.pi
        return gained + _below(self.excess, zero.line, zero.degrees(kind), kind) * kind.pi / 180

    def _area(self, zero: Zero) -> Fraction | None:
        """Return what is below the lines up to an exact place, in N m times degrees; else None."""
        if zero.exact is None:
            return None
        place = zero.exact % self.excess.cycle
        return Fraction(self.excess.area(place, self.excess.line_at(place)))


def _below(excess: Torque, number: int, degrees: Any, kind: Kind) -> Any:
    """Return what is below the lines up to a ball of degrees."""
    line = excess.lines[number]
    behind = degrees - kind.of(line.start)
    before = Fraction(excess.area(line.start, number))
    return kind.of(before) + kind.of(line.first) * behind + kind.of(line.slope) * behind * behind / 2


def _constant(torque: Torque) -> Torque:
    """Return the mean of a torque as one of its own."""
    level = torque.mean.rational
    waves = Waves({}) if level is not None else torque.mean
    return Torque(waves, (Line(Fraction(0), torque.cycle, level or Fraction(0)),))


def _agree(one: Waves, two: Waves) -> bool:
    """Whether two constants are equal."""
    apart = one - two
    return not apart.rational if apart.rational is not None else apart.vanishes(Fraction(0))


def _without_nothing(waves: Waves) -> Waves:
    """Return the waves without those of an order that come to nothing together, as of cranks at 120°."""
    found = waves
    for order in waves.orders:
        own = Waves({wave: a for wave, a in waves.amplitudes.items() if wave[0] == order})
        several = len(own.amplitudes) > 1
        if several and all(own.vanishes(place) for place in (Fraction(0), QUARTER / order)):
            found -= own
    return found
