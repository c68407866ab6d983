"""An engine that turns with a given flywheel against a constant torque, in steady state.

Speeds are in units of v₁, that at the inner dead centre of the first crank; angles are half turns from there.
The work above the mean of every turn is the same, and so is the speed at each angle: `root_speed` or, by
Weisbach's method, `first_order_speed` gives it of the work. Samples of a turn in floats tell nearly how a
flywheel turns whose speeds follow by no formula, and how light it may be.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from fractions import Fraction
from math import ceil, floor, log10
from typing import Any, NamedTuple, NoReturn, TypeVar

import flint

from kurbel.drive.at import known
from kurbel.drive.wheel import Wheel
from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.speed.course import Course, energies
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball, kept
from kurbel.kernel import forces
from kurbel.kernel.circle import Numeric
from kurbel.reading.notation import plain

# Steps of a search for where the crank comes to rest, a degree each, and how often one is halved.
SEARCHED = 360
NARROWINGS = 24
CHECKED_BITS = 128
# To multiples of so many bits series are computed; columns of few decimals more or less have one precision.
STEP = 64
T = TypeVar("T", float, Fraction)
# In a turn; a multiple of all that cranks are usually apart.
SAMPLES = 720
HALVINGS = 80
# s₁ is below 2, for the mean speed is 1 and no speed is below 0.
MOST = 4.0
# The mean speed is hit so nearly, or none of the run is.
MOST_MISSED = 1e-6


class AnyRun(ABC):
    """A turn of an engine with its flywheel, in steady state: in balls or, of a card, in floats."""

    def __init__(self, turn: AnyTurn, wheel: Wheel) -> None:
        self.turn = turn
        self.wheel = wheel
        self.times = kept(lambda: self.slowness().sum(), STEP)

    @property
    def method(self) -> str:
        return self.turn.method

    @property
    @abstractmethod
    def number(self) -> Numeric:
        """M = m₁ v₁²/(P r)."""

    @abstractmethod
    def speed(self, half_turns: Fraction) -> Numeric:
        """Return v/v₁ at an angle."""

    @abstractmethod
    def slowness(self) -> Course:
        """Return v₁/v over a cycle."""

    @abstractmethod
    def extreme_place(self, greatest: bool) -> Numeric:
        """Return where the speed is greatest or least."""

    @abstractmethod
    def extreme_speed(self, greatest: bool) -> Numeric:
        """Return v_max/v₁ or v_min/v₁."""

    @property
    def mean_omega(self) -> Numeric:
        """The mean speed ½ (ω_max + ω_min) in 1/s."""
        return known(self.wheel.speed).omega(self.turn)

    @property
    def first_omega(self) -> Numeric:
        """ω₁ in 1/s."""
        return 2 * self.mean_omega / (self.extreme_speed(greatest=True) + self.extreme_speed(greatest=False))

    @property
    def mean_torque(self) -> Numeric:
        """P r in N m."""
        power = self.wheel.power
        if power is None:
            return abs(self.turn.mean_force()) * self.turn.torque_unit()
        return self.turn.of(power) / self.mean_omega

    @property
    def at_mean(self) -> Numeric:
        """J ω_m²/(P r), the number of the flywheel at the mean speed."""
        mean = self.mean_omega
        return self.turn.of(known(self.wheel.inertia)) * mean * mean / self.mean_torque

    def irregularity(self) -> Numeric:
        """Return (v_max - v_min)/v_m."""
        return forces.irregularity_of_mean(
            self.extreme_speed(greatest=True), self.extreme_speed(greatest=False)
        )

    def first_irregularity(self) -> Numeric:
        """Return (v_max - v_min)/v₁, as Weisbach defines it."""
        return self.extreme_speed(greatest=True) - self.extreme_speed(greatest=False)

    def turned(self, half_turns: Fraction) -> Numeric:
        """Return the time at an angle, in half turns at v₁, ∫ v₁/v dφ since the dead centre."""
        return self.times().at(half_turns)

    def time(self, half_turns: Fraction) -> Numeric:
        """Return the seconds since the inner dead centre."""
        return self.turned(half_turns) * self.turn.pi / self.first_omega

    def acceleration(self, half_turns: Fraction) -> Numeric:
        """Return the angular acceleration dω/dt in 1/s²."""
        raise ProblemError(
            "the angular acceleration of the shaft is computed under ideal steam and the like, without moving"
            " masses and against a constant torque; leave angular_acceleration out"
        )

    def refuse(self, degrees: float, bound: Numeric) -> NoReturn:
        """Raise ProblemError for a flywheel that would come to rest at an angle, with its bound."""
        raise ProblemError(
            f"{self.wheel.named} is too light to pass the turn: at φ = {plain(Fraction(f'{degrees:.1f}'))}°"
            f" it would come to rest; {self.wheel.letter} must be above {above(bound)}{self.wheel.unit}"
        )


class Run(AnyRun):
    """A turn without moving masses, against a constant torque. Raises ProblemError where it comes to rest."""

    def __init__(self, turn: AnyTurn, wheel: Wheel) -> None:
        super().__init__(turn, wheel)
        self._numbers: dict[int, Numeric] = {}
        with at_bits(CHECKED_BITS):
            self._check()

    @property
    def law(self) -> Callable[[Any, Any], Numeric]:
        """How the speed follows from the excess."""
        return forces.first_order_speed if self.method == "weisbach" else forces.root_speed

    def excess(self, energy: Numeric) -> Numeric:
        """Return w = W/(P r) of an excess work in Q r."""
        return energy / abs(self.turn.mean_force())

    def extreme_excess(self, greatest: bool) -> Numeric:
        return self.excess(self.turn.extreme(greatest).energy)

    @property
    def number(self) -> Numeric:
        if self.wheel.number is not None:
            return self.turn.of(self.wheel.number)
        bits = flint.ctx.prec
        if bits not in self._numbers:
            extremes = self.extreme_excess(greatest=True), self.extreme_excess(greatest=False)
            first = self.method == "weisbach"
            found = forces.first_number_of_mean if first else forces.number_of_mean
            self._numbers[bits] = found(self.at_mean, *extremes)
        return self._numbers[bits]

    def speed_of(self, energy: Numeric) -> Numeric:
        """Return v/v₁ where the excess work is such."""
        return self.law(self.excess(energy), self.number)

    def speed(self, half_turns: Fraction) -> Numeric:
        return self.speed_of(self.turn.energy_at(half_turns))

    def acceleration(self, half_turns: Fraction) -> Numeric:
        """Return (T - P) r/J, for ω dω/dφ = ω₁² w'/M; of first order as much more as the speed is."""
        mean = self.turn.mean_force()
        found = (self.turn.power(half_turns) - mean) / (abs(mean) * self.number)
        share = self.speed(half_turns) if self.method == "weisbach" else 1
        return found * share * self.first_omega * self.first_omega

    def slowness(self) -> Course:
        assert isinstance(self.turn, Turn)
        first = self.method == "weisbach"
        share = ball((1 if first else 2) / (self.number * abs(self.turn.mean_force())))
        return (energies(self.turn, {})[0] * share + ball(1)).power(
            Fraction(-1) if first else Fraction(-1, 2)
        )

    def extreme_place(self, greatest: bool) -> Numeric:
        return self.turn.peaks(greatest)[0].place

    def extreme_speed(self, greatest: bool) -> Numeric:
        return self.law(self.extreme_excess(greatest), self.number)

    def _check(self) -> None:
        least, greatest = self.extreme_excess(greatest=False), self.extreme_excess(greatest=True)
        if self.wheel.inertia is not None:
            self._check_mean(least, greatest)
            return
        bound = -least if self.method == "weisbach" else -2 * least
        if not self.number > bound:
            self.refuse(self._rest(), bound)

    def _check_mean(self, least: Numeric, greatest: Numeric) -> None:
        at_mean = self.at_mean
        bound = half = (greatest - least) / 2
        if self.method == "weisbach":
            # Of first order v_1 is a root of a quadratic equation; for all its roots v_min may be above zero.
            bound = 2 * (greatest + least) if greatest + least > half else half * half / -least
        if not at_mean > bound:
            inertia = self.turn.of(self.wheel.inertia or Fraction(0)) * bound / at_mean
            self.refuse(180 * float(self.extreme_place(greatest=False)), inertia)

    def _rest(self) -> float:
        """Return the first angle in degrees at which the speed is zero."""
        number = float(self.number) / (1 if self.method == "weisbach" else 2)

        def left(degrees: Fraction) -> float:
            return 1 + float(self.excess(self.turn.energy_at(degrees / 180))) / number

        turns = range(SEARCHED * self.turn.cycle // 2 + 1)
        steps = map(Fraction, turns)
        high = next((one for one in steps if not left(one) > 0), None)
        if high is None:
            return 180 * float(self.extreme_place(greatest=False))
        return float(halved(max(high - 1, Fraction(0)), high, lambda one: left(one) > 0, NARROWINGS))


def above(bound: Numeric) -> str:
    """Return a number to three figures, rounded up."""
    value = float(bound)
    decimals = 2 - floor(log10(value))
    scale = Fraction(10) ** decimals
    return plain(Fraction(ceil(Fraction(value) * scale)) / scale)


class SampledRun(NamedTuple):
    """Samples of W and k over a cycle, ½ I where u is 1, k₀, and whether the flywheel goes by its number."""

    works: Sequence[float]
    energies: Sequence[float]
    half: float
    first: float
    by_number: bool

    def squares(self, start: float, factor: float = 1.0) -> list[float]:
        """s² at all samples, of a flywheel so many times as heavy."""
        own = factor * self.half / (start if self.by_number else 1)
        level = (own + self.first) * start
        pairs = zip(self.works, self.energies, strict=True)
        return [(level + work) / (own + energy) for work, energy in pairs]

    def start(self, run: AnyRun, degrees: float) -> float:
        """Return u, of samples from so many degrees on. Raises ProblemError for too light a flywheel."""

        def solved(factor: float) -> float | None:
            return hit(lambda start: mean_of(self.squares(start, factor)), 1.0, MOST)

        start = solved(1.0)
        if start is None:
            # Where the speed is just nowhere below 0.
            rest = self.squares(halved(0.0, MOST, lambda start: min(self.squares(start)) < 0))
            place = degrees + 360 * rest.index(min(rest)) / SAMPLES
            run.refuse(place, given_of(run.wheel) * least_factor(solved))
        return start


def given_of(wheel: Wheel) -> float:
    """Return what a flywheel is known by."""
    return float(known(wheel.inertia if wheel.number is None else wheel.number))


def hit(value: Callable[[float], float | None], target: float, most: float) -> float | None:
    """Return where a value has come to a target that rises up to `most`, None where it does not.

    It is None where the flywheel comes to rest.
    """

    def is_low(at: float) -> bool:
        found = value(at)
        return found is None or found < target

    high = halved(0.0, most, is_low)
    found = value(high)
    return high if found is not None and abs(found - target) < MOST_MISSED * found else None


def halved(low: T, high: T, is_low: Callable[[T], bool], times: int = HALVINGS) -> T:
    """Return the upper end of an interval that was halved so many times about where a number is too low."""
    for _ in range(times):
        middle = (low + high) / 2
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return high


def least_factor(found: Callable[[float], float | None]) -> float:
    low, high = 1.0, 2.0
    for _ in range(HALVINGS):
        if found(high) is not None:
            break
        low, high = high, 2 * high
    else:
        raise ProblemError("the speed over the turn is not settled; give slightly other numbers")
    return halved(low, high, lambda factor: found(factor) is None, HALVINGS // 4)


def mean_of(squares: Sequence[float]) -> float | None:
    """½ (s_max + s_min), None where the speed would be below 0."""
    least, greatest = -top([-one for one in squares]), top(squares)
    return (greatest**0.5 + least**0.5) / 2 if least >= 0 else None


def top(values: Sequence[float]) -> float:
    """Return the greatest value, of the parabola through the samples about it."""
    highest = max(range(len(values)), key=values.__getitem__)
    before, at, after = values[highest - 1], values[highest], values[(highest + 1) % len(values)]
    bend = before - 2 * at + after
    return at - (after - before) ** 2 / (8 * bend) if bend else at
