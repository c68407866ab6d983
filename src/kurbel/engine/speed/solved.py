"""Speeds over the turn but for one number: with moving masses, or against the square of the speed.

That number is such that the squares of the speeds, in a fixed unit, rise with it at every angle. So does the
mean speed ½ (v_max + v_min), by which it is known. Samples of the turn in floats give it nearly; then it is
enclosed between two numbers at which the mean is proved to be too low and too high.

With ω = s ω_m, where ω_m is the mean speed, the energy of flywheel and masses is (½ I + k) s²: I is J ω_m²
and k that part of the masses' energy at ω_m which changes with the angle, in Q R. So (½ I + k) s² = E + W,
where W is the work of the steam alone above its mean and E = (½ I + k₀) u the energy at the dead centre,
u = s₁², the number.

Against the square of the speed the mass of a flywheel alone is h = ½ J ω²/(P r), and with τ = T/P the
equation of motion h' = τ - a h is linear in h; P is the mean torque, for over a turn a h has the mean 1. With
the excess work w, whose slope is τ - 1, its one periodic solution is h = 1/a + w + y, where y' = -a (w + y).
The number is 1/a. Re-derived.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache, partial, reduce
from itertools import pairwise
from math import exp, pi
from typing import NamedTuple

from flint import arb

from kurbel.drive.at import known
from kurbel.drive.wheel import SQUARE, Wheel
from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.speed.course import Bounds, Course, Section, energies
from kurbel.engine.speed.run import (
    SAMPLES,
    STEP,
    AnyRun,
    Run,
    SampledRun,
    above,
    given_of,
    hit,
    least_factor,
    mean_of,
)
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball, kept
from kurbel.exact.search import ISOLATING_BITS, Function, Zero, crossing, interval, isolate
from kurbel.exact.taylor import Taylor, exponential
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.steam import larger, smaller

# How far around its first value the number is looked for, as a share of it, and so many times sixteen times
# as far.
NEAR, FARTHER = Fraction(1, 2**20), 4
# By so much of its width a section is searched beyond its ends, where a zero of a slope may lie by a hair.
BEYOND = Fraction(1, 18)
# The lag of the speed, 1/a in radians.
LEAST_LAG, MOST_LAG = 0.15, 1e6
KEPT = 512


class SpeedExtreme(NamedTuple):
    """Where the speed is least or greatest: within the section about a place."""

    middle: Fraction
    zero: Zero


class SolvedRun(AnyRun):
    """A turn in balls whose squares of the speed are known but for one number."""

    turn: Turn

    def __init__(self, turn: Turn, wheel: Wheel) -> None:
        super().__init__(turn, wheel)
        bounds: Bounds = {}
        self.energies = kept(lambda: energies(turn, bounds), STEP)
        self._squares = kept(self._solved, STEP)
        self._low, self._high = self._isolated()

    @abstractmethod
    def first_guess(self) -> Fraction:
        """Return the number nearly. Raises ProblemError for a flywheel that comes to rest."""

    @abstractmethod
    def squares(self, number: arb) -> Course:
        """Return the squares of the speed that a number makes."""

    def beyond(self, squares: Course) -> arb:
        """What is zero at the true number and rises with it: the mean speed above 1."""
        return ball(sum(root(self._extreme(squares, greatest)) for greatest in (True, False))) / 2 - 1

    @property
    def number(self) -> Numeric:
        if self.wheel.number is not None:
            return self.turn.of(self.wheel.number)
        share = self.first_omega / self.mean_omega
        return self.at_mean * share * share

    def speed(self, half_turns: Fraction) -> arb:
        squares = self._squares()
        return root(squares.at(half_turns) / _first(squares))

    def slowness(self) -> Course:
        squares = self._squares()
        return (squares * (1 / _first(squares))).power(Fraction(-1, 2))

    def extreme_place(self, greatest: bool) -> arb:
        return self._extremes(self._squares(), greatest)[0][0]

    def extreme_speed(self, greatest: bool) -> arb:
        squares = self._squares()
        return root(self._extreme(squares, greatest) / _first(squares))

    def _solved(self) -> Course:
        return self.squares(crossing(lambda number: self.beyond(self.squares(number)), self._low, self._high))

    def _isolated(self) -> tuple[Fraction, Fraction]:
        """Return two numbers between which the true one lies, and know the extremes between them."""
        guess = self.first_guess()
        width = guess * NEAR
        for _ in range(FARTHER):
            ends = guess - width, guess + width
            with at_bits(ISOLATING_BITS):
                self._found = tuple(_stationary(self.squares(interval(*ends))))
                below, above = (self.beyond(self.squares(ball(end))) for end in ends)
            if below < 0 and above > 0:
                return ends
            width *= 16
        raise ProblemError("the speed at the dead centre is not settled; give slightly other numbers")

    def _extremes(self, squares: Course, greatest: bool) -> list[tuple[arb, arb]]:
        """Return the places where the speed may be greatest or least, and its squares there."""
        sign, found = 1 if greatest else -1, []
        for one in self._found:
            if one.zero.rising is not greatest:
                section = squares.around(one.middle)
                at = one.zero.of(*_slopes(section)).place()
                if not (at < section.start or at > section.end):
                    found.append((at, section.function.at(at)))
        return [one for one in found if not any(sign * one[1] < sign * other for _, other in found)]

    def _extreme(self, squares: Course, greatest: bool) -> arb:
        found: Iterator[Numeric] = (one for _, one in self._extremes(squares, greatest))
        return ball(reduce(larger if greatest else smaller, found))


def _first(squares: Course) -> arb:
    """The square at the dead centre, where the first section begins."""
    return squares.sections[0].function.at(squares.sections[0].start)


def _slopes(section: Section) -> tuple[Function, Function]:
    """Return the slope of the squares over a section, and its own slope."""
    return partial(section.function.at, order=1), partial(section.function.at, order=2)


def _stationary(squares: Course) -> Iterator[SpeedExtreme]:
    """Yield where the speed is least or greatest, for all squares that the balls hold."""
    for before, one in pairwise((squares.sections[-1], *squares.sections)):
        if before.function.at(before.end, 1) * one.function.at(one.start, 1) < 0:
            raise ProblemError("the speed turns in a dead centre; its extremes cannot be told apart")
        more = (one.high - one.low) * BEYOND
        for zero in isolate(*_slopes(one), one.low - more, one.high + more):
            yield SpeedExtreme(one.function.middle, zero)


class HeavyRun(SolvedRun):
    """A turn with moving masses against a constant torque."""

    def first_guess(self) -> Fraction:
        with at_bits(ISOLATING_BITS):
            works, moved = (_sampled(one, Fraction(0)) for one in self.energies())
            half, _ = map(float, self.level(arb(1)))
            first = float(self.turn.kinetic_energy_begun())
        return Fraction(SampledRun(works, moved, half, first, self.wheel.number is not None).start(self, 0.0))

    def squares(self, number: arb) -> Course:
        half, energy = self.level(number)
        works, moved = self.energies()
        return (moved + half).power(Fraction(-1)) * (works + energy)

    def level(self, number: arb) -> tuple[arb, arb]:
        """Return ½ I and E of a number."""
        before, mean = ball(self.turn.kinetic_energy_begun()), abs(ball(self.turn.mean_force()))
        if self.wheel.number is None:
            half = ball(self.at_mean) * mean / 2
            return half, (half + before) * number
        first = ball(self.turn.of(self.wheel.number)) * mean / 2
        return first / number, first + before * number


class SquareRun(SolvedRun):
    """A turn against the square of the speed, without moving masses."""

    def first_guess(self) -> Fraction:
        with at_bits(ISOLATING_BITS):
            excess = self.excess()
            first = excess.lows[0]
            works = _sampled(excess, first)
            weight = float(self.at_mean) if self.wheel.number is None else float(self.wheel.number)

        def weight_of(lag: float) -> float | None:
            """What the flywheel would be, by its number or its inertia, None where it comes to rest."""
            level = _level(works, lag)
            mean = mean_of(level)
            if mean is None:
                return None
            return 2 * (level[0] if self.wheel.number is not None else mean * mean)

        def solved(factor: float) -> float | None:
            return hit(weight_of, factor * weight, MOST_LAG)

        lag = solved(1.0)
        if lag is not None and lag < LEAST_LAG:
            factor = known(weight_of(LEAST_LAG))
            least = above(given_of(self.wheel) * factor / weight)
            raise ProblemError(
                f"{self.wheel.named} is too light: the speed follows the torque at every angle, as if there"
                f" were none; {self.wheel.letter} must be above {least}{self.wheel.unit}"
            )
        if lag is None:
            factor = least_factor(solved)
            level = _level(works, solved(factor) or MOST_LAG)
            place = 360 * level.index(min(level)) / SAMPLES + 180 * float(first)
            self.refuse(place, given_of(self.wheel) * factor)
        return Fraction(lag)

    def excess(self) -> Course:
        """Return w over the cycle."""
        return self.energies()[0] * (1 / ball(self.turn.mean_force()))

    def squares(self, number: arb) -> Course:
        unit = ball(self.at_mean if self.wheel.number is None else self.turn.of(self.wheel.number))
        excess = self.excess()
        return (excess + self._lagging(excess, arb.pi() / number) + number) * (2 / unit)

    def beyond(self, squares: Course) -> arb:
        """The same or, of a flywheel known by its number, the square at the dead centre above 1."""
        return super().beyond(squares) if self.wheel.number is None else _first(squares) - 1

    def _lagging(self, excess: Course, rate: arb) -> Course:
        """Return y, of which a π is the rate: on each section it is (c - a π ∫ w e^(aθ)) e^(-aθ)."""
        growing = excess.mapped(lambda one: exponential(one, rate))
        parts = (excess * growing).mapped(Taylor.sum) * -rate
        decaying = excess.mapped(lambda one: exponential(one, -rate))
        begun, found = arb(0), []
        for part, decay in zip(parts.sections, decaying.sections, strict=True):
            begun = _ended(part, decay, begun, rate)[1]
        begun /= 1 - (-rate * self.turn.cycle).exp()
        for part, decay in zip(parts.sections, decaying.sections, strict=True):
            constant, begun = _ended(part, decay, begun, rate)
            found.append(part._replace(function=(part.function + constant) * decay.function))
        return Course(found, self.turn.cycle)


def _ended(part: Section, decay: Section, begun: arb, rate: arb) -> tuple[arb, arb]:
    """Return c of a section at whose start y is such, and y at its end."""
    away = part.start - ball(part.function.middle)
    constant = begun * (rate * away).exp() - part.function.at(part.start)
    return constant, (part.function.at(part.end) + constant) * decay.function.at(part.end)


def _sampled(course: Course, start: Fraction) -> list[float]:
    steps = range(course.cycle // 2 * SAMPLES)
    return [float(course.at(start + Fraction(2 * step, SAMPLES))) for step in steps]


def _level(works: Sequence[float], lag: float) -> list[float]:
    """h at all samples, of a = 1/lag."""
    step = 2 * pi / SAMPLES
    kept = exp(-step / lag)
    # y over a step in which w goes in a straight line.
    left, right = _weights(step / lag)
    gains = [-(left * one + right * other) for one, other in pairwise([*works, works[0]])]
    total = 0.0
    for gain in gains:
        total = kept * total + gain
    first = total / (1 - kept ** len(works))
    level = []
    for work, gain in zip(works, gains, strict=True):
        level.append(lag + work + first)
        first = kept * first + gain
    return level


def _weights(share: float) -> tuple[float, float]:
    """The weights of w at both ends of a step, ∫ e^(t - share) dt over it times a straight line."""
    if share < 1e-3:
        return share / 2 - share * share / 3, share / 2 - share * share / 6
    end = (1 - exp(-share)) / share
    return end - exp(-share), 1 - end


@lru_cache(KEPT)
def run_of(turn: AnyTurn, wheel: Wheel) -> AnyRun:
    """Return the engine's run with the flywheel; the latest ones are kept."""
    if wheel.resistance == SQUARE:
        return _against_square(turn, wheel)
    if any(part.crank.moving is not None for part in turn.engine.parts):
        if isinstance(turn, Turn):
            return HeavyRun(turn, wheel)
        from kurbel.engine.card.force import CardTurn
        from kurbel.engine.speed.card import HeavyCardRun

        assert isinstance(turn, CardTurn)
        return HeavyCardRun(turn, wheel)
    if turn.engine.carded:
        from kurbel.engine.speed.card import CardRun

        return CardRun(turn, wheel)
    return Run(turn, wheel)


def _against_square(turn: AnyTurn, wheel: Wheel) -> AnyRun:
    """Return the run against the square of the speed. Raises ProblemError where that is not computed."""
    moving = any(part.crank.moving is not None for part in turn.engine.parts)
    for unknown, instead in (
        (not isinstance(turn, Turn), "of an indicator card"),
        (moving, "with moving masses"),
        (turn.method == "weisbach", "by Weisbach's method"),
        (turn.mean_sign <= 0, "of a driven machine"),
    ):
        if unknown:
            raise ProblemError(
                f"the speed {instead} is computed against a constant torque; leave --resistance out"
            )
    assert isinstance(turn, Turn)
    return SquareRun(turn, wheel)
