"""An engine that turns with a given flywheel, in steady state.

Speeds are in units of v₁, that at the inner dead centre of the first crank; angles are half turns from there.
The work above the mean of every turn is the same, and so is the speed at each angle. Without moving masses
and against a constant torque `root_speed` or, by Weisbach's method, `first_order_speed` gives it of the work;
else it is solved for.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cached_property, lru_cache
from math import ceil, floor, log10
from typing import Any, NoReturn, TypeVar

from kurbel.drive.at import known
from kurbel.drive.wheel import SQUARE, Wheel
from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.speed.course import Bounds, energies
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, kept
from kurbel.kernel import forces
from kurbel.kernel.circle import Numeric
from kurbel.reading.notation import plain

# Steps of a search for where the crank comes to rest, a degree each, and how often one is halved.
SEARCHED = 360
NARROWINGS = 24
CHECKED_BITS = 128
# To multiples of so many bits series are computed; columns of few decimals more or less have one precision.
STEP = 64
KEPT = 512
T = TypeVar("T", float, Fraction)


class Run:
    """A turn of an engine with its flywheel, in balls or, of a card, in floats.

    This one is without moving masses and against a constant torque. Raises ProblemError where it comes to
    rest.
    """

    def __init__(self, turn: AnyTurn, wheel: Wheel) -> None:
        # Of cards it knows its errors, too.
        self.turn: Any = turn
        self.wheel = wheel
        bounds: Bounds = {}
        self.courses = kept(lambda: _courses(turn, bounds), STEP)
        self.times = kept(lambda: self.slowness().sum(), STEP)
        self._number_of_mean = kept(self._of_mean)
        with at_bits(CHECKED_BITS):
            self.check()

    @property
    def method(self) -> str:
        method: str = self.turn.method
        return method

    @property
    def law(self) -> Callable[[Any, Any], Numeric]:
        """How the speed follows from the excess."""
        return forces.first_order_speed if self.method == "weisbach" else forces.root_speed

    def extreme_excess(self, greatest: bool) -> Any:
        """Return w = W/(P r) where it is greatest or least."""
        return self.turn.extreme(greatest).energy / abs(self.turn.mean_force())

    @property
    def number(self) -> Numeric:
        """M = m₁ v₁²/(P r)."""
        return self._number_of_mean() if self.wheel.number is None else self.turn.of(self.wheel.number)

    def _of_mean(self) -> Numeric:
        first = self.method == "weisbach"
        found = forces.first_number_of_mean if first else forces.number_of_mean
        return found(self.at_mean, self.extreme_excess(greatest=True), self.extreme_excess(greatest=False))

    def speed(self, half_turns: Fraction) -> Numeric:
        """Return v/v₁ at an angle."""
        excess = self.turn.energy_at(half_turns) / abs(self.turn.mean_force())
        return self.law(excess, self.number)

    def slowness(self) -> Any:
        """Return v₁/v over a cycle."""
        first = self.method == "weisbach"
        once = self.number * abs(self.turn.mean_force()) / (1 if first else 2)
        relative = self.courses()[0] / once + 1
        return relative.power(Fraction(-1) if first else Fraction(-1, 2))

    def extreme_place(self, greatest: bool) -> Numeric:
        """Return where the speed is greatest or least."""
        place: Numeric = self.turn.peaks(greatest)[0].place
        return place

    def extreme_speed(self, greatest: bool) -> Numeric:
        """Return v_max/v₁ or v_min/v₁."""
        return self.law(self.extreme_excess(greatest), self.number)

    def acceleration(self, half_turns: Fraction) -> Numeric:
        """Return the angular acceleration dω/dt in 1/s²: (T - P) r/J, for ω dω/dφ = ω₁² w'/M; of first order
        as much more as the speed is."""
        mean = self.turn.mean_force()
        found: Numeric = (self.turn.power(half_turns) - mean) / (abs(mean) * self.number)
        share = self.speed(half_turns) if self.method == "weisbach" else 1
        return found * share * self.first_omega * self.first_omega

    @property
    def mean_omega(self) -> Numeric:
        """The mean speed ½ (ω_max + ω_min) in 1/s."""
        return known(self.wheel.speed).omega(self.turn)

    @property
    def first_omega(self) -> Numeric:
        """ω₁ in 1/s."""
        return 2 * self.mean_omega / (self.extreme_speed(greatest=True) + self.extreme_speed(greatest=False))

    @property
    def at_mean(self) -> Any:
        """J ω_m²/(P r), the number of the flywheel at the mean speed."""
        mean, power = self.mean_omega, self.wheel.power
        if power is None:
            torque = abs(self.turn.mean_force()) * self.turn.torque_unit()
        else:
            torque = self.turn.of(power) / mean
        return self.turn.of(known(self.wheel.inertia)) * mean * mean / torque

    def irregularity(self) -> Any:
        """Return (v_max - v_min)/v_m."""
        return forces.irregularity_of_mean(
            self.extreme_speed(greatest=True), self.extreme_speed(greatest=False)
        )

    def first_irregularity(self) -> Numeric:
        """Return (v_max - v_min)/v₁, as Weisbach defines it."""
        return self.extreme_speed(greatest=True) - self.extreme_speed(greatest=False)

    def time(self, half_turns: Fraction) -> Numeric:
        """Return the seconds since the inner dead centre."""
        turned: Numeric = self.times().at(half_turns) * self.turn.pi
        return turned / self.first_omega

    @cached_property
    def coarser(self) -> tuple[Run, ...]:
        """The runs by the two cards that have every second point."""
        return tuple(type(self)(half, self.wheel) for half in self.turn.coarser)

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        """How far the place of an extreme may be off by a card, in half turns."""
        error: float = self.turn.place_error(greatest, stroke)
        return error

    def sensitivity(self, key: str, value: float, swing: float) -> float:
        """How far a quantity is off where the work of a stroke is off by 1, and the energy swing by so much.

        By that much an excess is off at most, as the difference of two of them is.
        """
        least = float(self.extreme_speed(greatest=False))
        # By inertia the number is off as well, by twice the swing of which the speed takes a share δ.
        of_speed = swing * (1 + 3 * float(self.irregularity())) / (float(self.number) * least * least)
        match key.partition("_")[0]:
            case "number":
                return 0.0 if self.wheel.number is not None else 2 * swing
            case "speed" | "delta":
                return of_speed
            case "one":
                return of_speed * value * value
            case "angular":
                # By as much as the tangential force is, too.
                force = 4 * len(self.turn.engine.cranks) / abs(float(self.turn.mean_force()))
                of_force = force * float(self.first_omega) ** 2 / float(self.number)
                return 2 * of_speed * abs(value) + of_force
        # The speed at the angle and at the dead centre; before that the time is below 0.
        return 2 * of_speed * abs(value)

    def check(self) -> None:
        """Raise ProblemError for a flywheel that would come to rest."""
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
            inertia = self.turn.of(self.wheel.inertia) * bound / at_mean
            self.refuse(180 * float(self.extreme_place(greatest=False)), inertia)

    def _rest(self) -> float:
        """Return the first angle in degrees at which the speed is zero."""
        number = float(self.number) / (1 if self.method == "weisbach" else 2)
        mean = float(abs(self.turn.mean_force()))

        def left(degrees: Fraction) -> float:
            return 1 + float(self.turn.energy_at(degrees / 180)) / mean / number

        steps = map(Fraction, range(SEARCHED * self.turn.cycle // 2 + 1))
        high = next((one for one in steps if not left(one) > 0), None)
        if high is None:
            return 180 * float(self.extreme_place(greatest=False))
        return float(halved(max(high - 1, Fraction(0)), high, lambda one: left(one) > 0, NARROWINGS))

    def refuse(self, degrees: float, bound: Numeric) -> NoReturn:
        """Raise ProblemError for a flywheel that would come to rest at an angle, with its bound."""
        raise ProblemError(
            f"{self.wheel.named} is too light to pass the turn: at φ = {plain(Fraction(f'{degrees:.1f}'))}°"
            f" it would come to rest; {self.wheel.letter} must be above {above(bound)}{self.wheel.unit}"
        )


def _courses(turn: Any, bounds: Bounds) -> tuple[Any, Any]:
    """Return the work above its mean and the energy of the masses over a cycle, on the turn's numbers."""
    if isinstance(turn, Turn):
        return energies(turn, bounds)
    from kurbel.engine.speed.samples import energies_of_card

    return energies_of_card(turn)


def above(bound: Numeric) -> str:
    """Return a number to three figures, rounded up."""
    value = float(bound)
    decimals = 2 - floor(log10(value))
    scale = Fraction(10) ** decimals
    return plain(Fraction(ceil(Fraction(value) * scale)) / scale)


def halved(low: T, high: T, is_low: Callable[[T], bool], times: int) -> T:
    """Return the upper end of an interval that was halved so many times about where a number is too low."""
    for _ in range(times):
        middle = (low + high) / 2
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return high


@lru_cache(KEPT)
def run_of(turn: AnyTurn, wheel: Wheel) -> Run:
    """Return the engine's run with the flywheel; the latest ones are kept.

    Raises ProblemError where the run against the square of the speed is not computed.
    """
    moving = any(part.crank.moving is not None for part in turn.engine.parts)
    if wheel.resistance == SQUARE:
        for unknown, instead in (
            (moving, "with moving masses"),
            (turn.method == "weisbach", "by Weisbach's method"),
            (turn.mean_sign <= 0, "of a driven machine"),
        ):
            if unknown:
                raise ProblemError(
                    f"the speed {instead} is computed against a constant torque; leave --resistance out"
                )
    elif not moving:
        return Run(turn, wheel)
    from kurbel.engine.speed.solved import SolvedRun

    return SolvedRun(turn, wheel)
