"""First values of what balls then enclose, from samples of the turn in floats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import exp, pi
from typing import TYPE_CHECKING, NamedTuple

import flint

from kurbel.engine.speed.run import above
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits
from kurbel.exact.search import ISOLATING_BITS

if TYPE_CHECKING:
    from kurbel.engine.speed.course import Course
    from kurbel.engine.speed.run import AnyRun
    from kurbel.engine.speed.solved import HeavyRun, SquareRun

# In a turn; a multiple of all that cranks are usually apart.
SAMPLES = 720
HALVINGS = 80
# s₁ is below 2, for the mean speed is 1 and no speed is below 0.
MOST = 4.0
# The lag of the speed, 1/a in radians.
LEAST_LAG, MOST_LAG = 0.15, 1e6
# The mean speed is hit so nearly, or none of the run is.
NEAR = 1e-6


def first_start(run: HeavyRun) -> Fraction:
    """Return u nearly. Raises ProblemError for a flywheel that comes to rest."""
    with at_bits(ISOLATING_BITS):
        works, moved = (_sampled(one, Fraction(0)) for one in run.energies())
        half, _ = map(float, run.level(flint.arb(1)))
        first = float(run.turn.kinetic_energy_begun())
    wheel = Sampled(works, moved, half, first, run.wheel.number is not None)
    return Fraction(wheel.start(run, 0.0))


def _sampled(course: Course, start: Fraction) -> list[float]:
    steps = range(course.cycle // 2 * SAMPLES)
    return [float(course.at(start + Fraction(2 * step, SAMPLES))) for step in steps]


class Sampled(NamedTuple):
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
        start = _solved(self.squares)
        if start is None:
            factor = _least_factor(lambda factor: _solved(lambda start: self.squares(start, factor)))
            rest = self.squares(_slowest(self.squares))
            given = run.wheel.inertia if run.wheel.number is None else run.wheel.number
            assert given is not None
            run.refuse(degrees + 360 * rest.index(min(rest)) / SAMPLES, float(given) * factor)
        return start


def first_lag(run: SquareRun) -> Fraction:
    """Return 1/a nearly. Raises ProblemError for a flywheel that comes to rest."""
    with at_bits(ISOLATING_BITS):
        excess = run.excess()
        first = excess.lows[0]
        works = _sampled(excess, first)
        weight = float(run.at_mean) if run.wheel.number is None else float(run.wheel.number)

    def weight_of(level: Sequence[float]) -> float | None:
        """What the flywheel would be, by its number or its inertia, None where it comes to rest."""
        mean = _mean(level)
        if mean is None:
            return None
        return 2 * (level[0] if run.wheel.number is not None else mean * mean)

    def solved(factor: float) -> float | None:
        low, high = 0.0, MOST_LAG
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            found = weight_of(_level(works, middle))
            low, high = (middle, high) if found is None or found < factor * weight else (low, middle)
        found = weight_of(_level(works, high))
        return high if found is not None and abs(found - factor * weight) < NEAR * found else None

    lag = solved(1.0)
    given = run.wheel.inertia if run.wheel.number is None else run.wheel.number
    assert given is not None
    if lag is not None and lag < LEAST_LAG:
        factor = weight_of(_level(works, LEAST_LAG))
        assert factor is not None
        raise ProblemError(
            f"{run.wheel.named} is too light: the speed follows the torque at every angle, as if there were"
            f" none; {run.wheel.letter} must be above {above(float(given) * factor / weight)}{run.wheel.unit}"
        )
    if lag is None:
        factor = _least_factor(solved)
        level = _level(works, solved(factor) or MOST_LAG)
        place = 360 * level.index(min(level)) / SAMPLES + 180 * float(first)
        run.refuse(place, float(given) * factor)
    return Fraction(lag)


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


def _solved(squares: Callable[[float], Sequence[float]]) -> float | None:
    """Return the u at which the mean speed is 1, None if there is none."""
    low, high = 0.0, MOST
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        mean = _mean(squares(middle))
        low, high = (middle, high) if mean is None or mean < 1 else (low, middle)
    mean = _mean(squares(high))
    return high if mean is not None and abs(mean - 1) < NEAR else None


def _slowest(squares: Callable[[float], Sequence[float]]) -> float:
    """Return the least u at which the speed is nowhere below 0."""
    low, high = 0.0, MOST
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if min(squares(middle)) < 0 else (low, middle)
    return high


def _least_factor(found: Callable[[float], float | None]) -> float:
    low, high = 1.0, 2.0
    for _ in range(HALVINGS):
        if found(high) is not None:
            break
        low, high = high, 2 * high
    else:
        raise ProblemError("the speed over the turn is not settled; give slightly other numbers")
    for _ in range(HALVINGS // 4):
        middle = (low + high) / 2
        low, high = (middle, high) if found(middle) is None else (low, middle)
    return high


def _mean(squares: Sequence[float]) -> float | None:
    """½ (s_max + s_min), None where the speed would be below 0."""
    least, greatest = -top([-one for one in squares]), top(squares)
    return (greatest**0.5 + least**0.5) / 2 if least >= 0 else None


def top(values: Sequence[float]) -> float:
    """Return the greatest value, of the parabola through the samples about it."""
    highest = max(range(len(values)), key=values.__getitem__)
    before, at, after = values[highest - 1], values[highest], values[(highest + 1) % len(values)]
    bend = before - 2 * at + after
    return at - (after - before) ** 2 / (8 * bend) if bend else at
