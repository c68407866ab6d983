"""The excess of a driving torque over that of the load in steady state, its energy, and the extremes of both.

The excess energy is the integral of the excess over the angle from 0 on. With one of the two torques alone
the other is constant, its mean. The excess itself, by which a flywheel has its angular acceleration, is
greatest and least where the slope of a sum of waves is zero, of straight lines at their ends; of both
together in one diagram that is not sought. Re-derived; closed form, with every digit certified.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from typing import NamedTuple

from kurbel.drive.at import known
from kurbel.engine.diagram.fluctuation import Extreme, places
from kurbel.engine.diagram.torque import QUARTER, TURN, Line, Torque, Waves, common_cycle
from kurbel.engine.diagram.zeros import Zero, is_plain, over_cycle, waves_at, zeros
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.kind import Kind, balls, floats
from kurbel.exact.numerals import Label, number_text
from kurbel.exact.real import Product
from kurbel.exact.search import greatest as greatest_of
from kurbel.kernel.circle import Numeric
from kurbel.page.quantity import Texts
from kurbel.reading.given import FrozenValue
from kurbel.reading.notation import about

WORDS = Texts("engine.diagram", "diagram")


@dataclass(frozen=True)
class ExcessTorque(FrozenValue):
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
    def between(cls, drive: Torque | None, load: Torque | None, by_degree: bool) -> ExcessTorque:
        """Return the excess, where one of both is missing over the mean of the other."""
        if drive is None and load is None:
            raise ProblemError(
                "no torque was given; add --torque '5000 + 1500 sin(3φ)' or its points, '0:0; 60:90; 180:0',"
                " or that of the load, --load-torque"
            )
        if drive is None:
            return cls(_constant(known(load)), known(load), by_degree)
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

    def torque(self, torque: Torque, degrees: Fraction, kind: Kind) -> Numeric:
        """Return one of its torques at a crank angle, in N m."""
        own = torque.at(degrees, kind)
        return own * 180 / kind.pi if self.by_degree else own

    def greatest_torque(self, torque: Torque) -> float:
        """Return a bound of a torque's magnitude, in N m."""
        return float(torque.most) * (180 / math.pi if self.by_degree else 1)

    def mean_torque(self, kind: Kind) -> Numeric:
        """Return the mean torque that drives the shaft in N m."""
        mean = self.drive.mean.at(Fraction(0), kind)
        return mean * 180 / kind.pi if self.by_degree else mean

    def work(self, kind: Kind) -> Numeric:
        """Return the work of a cycle in J."""
        if self.by_degree:
            return self.drive.mean.at(Fraction(0), kind) * kind.of(self.cycle)
        return self.mean_torque(kind) * kind.of(2 * self.turns) * kind.pi

    def energy(self, degrees: Fraction, kind: Kind) -> Numeric:
        """Return the excess energy in J at a crank angle, from 0° on."""
        return self._energy(Zero(degrees), kind)

    def swing(self, kind: Kind) -> Numeric:
        """Return the greatest excess energy less the least, in J."""
        return self.extreme_energy(kind, greatest=True) - self.extreme_energy(kind, greatest=False)

    def extreme_energy(self, kind: Kind, *, greatest: bool) -> Numeric:
        """Return the greatest or the least excess energy in J."""
        return self._energy(self._extremes[greatest][0], kind)

    def extremes(self, *, greatest: bool) -> tuple[Extreme, ...]:
        """Return the places within a cycle, in order."""
        return over_cycle(self._extremes[greatest], self.excess, self.cycle)

    @cached_property
    def _extremes(self) -> dict[bool, Sequence[Zero]]:
        candidates = zeros(self.excess)
        return {greatest: self._choose(candidates, 1 if greatest else -1) for greatest in (True, False)}

    def _choose(self, left: list[Zero], sign: int) -> Sequence[Zero]:
        """Return where the energy, times the sign, is greatest; several only if they cannot be told apart."""
        if not self.excess.waves:
            areas = [sign * (self._area(one) or 0) for one in left]
            return [one for one, area in zip(left, areas, strict=True) if area == max(areas)]
        left = greatest_of(left, lambda one: ball(self._energy(one, balls())), sign)
        if any(one.is_open for one in left):
            raise ProblemError(
                "the speed rests where it should turn; its extremes cannot be told apart; give slightly other"
                " numbers"
            )
        return left

    def _energy(self, zero: Zero, kind: Kind) -> Numeric:
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
        return self.excess.area(place, self.excess.line_at(place))


def _below(excess: Torque, number: int, degrees: Numeric, kind: Kind) -> Numeric:
    """Return what is below the lines up to a ball of degrees."""
    line = excess.lines[number]
    behind = degrees - kind.of(line.start)
    before = excess.area(line.start, number)
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


class Peak(NamedTuple):
    """The magnitude of the greatest or the least excess torque in N m, and the places where it is so: each
    from one angle to another, which may be the same."""

    torque: Product
    places: Sequence[tuple[Extreme, Extreme]]


def acceleration_line(
    excess: ExcessTorque, inertias: Sequence[Product], rounding: str, lang: str
) -> Iterator[Label]:
    """Yield what is said of the acceleration of flywheels of these moments of inertia in kg m²."""
    peaks = [peak_of(excess, greatest=greatest) for greatest in (True, False)]
    if None in peaks:
        return
    high, low = (peak for peak in peaks if peak is not None)
    figures = [
        "; ".join(
            f"${sign}{number_text((peak.torque / inertia).number(None, rounding))}$" for inertia in inertias
        )
        for peak, sign in ((high, ""), (low, "-"))
    ]
    listed = ["; ".join(_listed(peak, lang)) for peak in (high, low)]
    yield WORDS["acceleration"][lang].format(most=figures[0], least=figures[1], high=listed[0], low=listed[1])


def peak_of(excess: ExcessTorque, *, greatest: bool) -> Peak | None:
    """Return the greatest or the least excess torque, None where it is not sought."""
    own, sign = excess.excess, 1 if greatest else -1
    if not own.waves:
        return _of_lines(own.lines, sign, excess)
    return _of_waves(own.waves, sign, excess.cycle) if is_plain(own) else None


def _of_lines(lines: Sequence[Line], sign: int, excess: ExcessTorque) -> Peak:
    most = max(sign * value for one in lines for value in (one.first, one.last))
    spans: list[tuple[Fraction, Fraction]] = []
    for one in lines:
        ends = [at for at, value in ((one.start, one.first), (one.end, one.last)) if sign * value == most]
        if ends and spans and spans[-1][1] == ends[0]:
            spans[-1] = (spans[-1][0], ends[-1])
        elif ends:
            spans.append((ends[0], ends[-1]))
    # The end of the cycle is its beginning.
    if len(spans) > 1 and spans[0][0] == 0 and spans[-1] == (excess.cycle, excess.cycle):
        del spans[-1]
    torque = Product.of(most * 180, -1) if excess.by_degree else Product.of(most)
    return Peak(torque, [(_exact(start), _exact(end)) for start, end in spans])


def _of_waves(waves: Waves, sign: int, cycle: Fraction) -> Peak | None:
    slope = waves.slope
    steepness = Torque(slope, (Line(Fraction(0), cycle, Fraction(0)),))

    def torque(zero: Zero, kind: Kind) -> Numeric:
        value = waves_at(waves, zero, slope, kind)
        return value if sign > 0 else kind.of(Fraction(0)) - value

    found = greatest_of(zeros(steepness), lambda one: ball(torque(one, balls())))
    if any(one.is_open for one in found):
        return None
    most = Product.reduced(partial(torque, found[0]))
    return Peak(most, [(one, one) for one in over_cycle(found, steepness, cycle)])


def _exact(angle: Fraction) -> Extreme:
    return Extreme(degrees=lambda kind: kind.of(angle), exact=angle)


def _listed(peak: Peak, lang: str) -> Iterator[Label]:
    if all(start is end or start.exact == end.exact for start, end in peak.places):
        yield places([start for start, _ in peak.places])
        return
    for start, end in peak.places:
        one, other = places([start]), places([end])
        yield one if one == other else WORDS["from_to"][lang].format(start=one, end=other)
