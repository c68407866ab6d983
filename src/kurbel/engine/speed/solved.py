"""Speeds over the turn but for one number: with moving masses, or against the square of the speed.

With ω = s ω_m, where ω_m is the mean speed ½ (v_max + v_min), the energy of flywheel and masses is
(½ I + k) s²: I is J ω_m² and k that part of the masses' energy at ω_m which changes with the angle, in Q R.
Its slope is the moment of the steam less the resistance. W is the work of the steam above its mean P.

Against a constant resistance (½ I + k) s² = E + W, where E = (½ I + k₀) u is the energy at the dead centre
and u = s₁² the number. Against the square of the speed, without masses, the energy of the flywheel is h, the
resistance a h and the equation h' = P + W' - a h linear in h; its one periodic solution is h = P/a + W + y,
where y' = -a (W + y). The number is 1/a, the lag of the speed in radians. Re-derived.

The number is such that the squares of the speeds, in a fixed unit, rise with it at every angle. So does the
mean speed, by which it is known. Samples of the turn in floats give it nearly, which is all that a card has;
else it is enclosed between two numbers at which the mean is proved to be too low and too high.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import pi
from typing import Any, NamedTuple, NoReturn

from flint import arb

from kurbel.drive.at import known
from kurbel.drive.wheel import SQUARE, Wheel
from kurbel.engine.speed.run import STEP, Run, above, halved
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball, kept
from kurbel.exact.place import fraction
from kurbel.exact.search import ISOLATING_BITS, crossing
from kurbel.kernel.circle import root
from kurbel.kernel.steam import larger

# Around its first value the number is looked for so many times as far as this misses the mean speed, and
# then sixteen times as far; both as shares, the nearest and the farthest.
MARGIN, NEAREST, FARTHEST = 4, 2.0**-40, 2.0**-4
# u is below 2, for the mean speed is 1 and no speed is below 0; the lag is not above so many radians.
MOST, MOST_LAG = 4.0, 1e13
LEAST_LAG = 0.15
HALVINGS = 90
# By no more samples miss the square of the least speed.
MOST_MISSED = 1e-3
# Floats know where they are greatest to half of their digits, in half turns.
FLAT = 1e-7


class Equation(NamedTuple):
    """W and k over a cycle, ½ I where the number is 1, k₀ and P, of a wheel: in balls or in floats."""

    works: Any
    energies: Any
    half: Any
    first: Any
    mean: Any
    wheel: Wheel

    @property
    def square(self) -> bool:
        return self.wheel.resistance == SQUARE

    def squares(self, number: Any, factor: float = 1) -> Any:
        """Return the squares of the speed that a number makes, of a flywheel so many times as heavy.

        They are in units of the mean speed, or of v₁ where that of the flywheel's number is not the mean one.
        """
        half = self.wheel_energy(number) * factor
        if self.square:
            rate = (pi if isinstance(number, float) else arb.pi()) / number
            return (self.works + self.works.lagging(rate) + self.mean * number) / half
        return (self.works + (half + self.first) * number) / (self.energies + half)

    def wheel_energy(self, number: Any) -> Any:
        """Return ½ I."""
        of_first = self.wheel.number is not None and not self.square
        return self.half / number if of_first else self.half

    def beyond(self, squares: Any, turnings: Sequence[Any] = ()) -> Any:
        """Return what is zero at the true number and rises with it: the mean speed above 1 or, against the
        square of the speed, that at the dead centre of a flywheel known by its number. Where it would come
        to rest the speed is 0."""
        if self.square and self.wheel.number is not None:
            return root(larger(squares.first, 0)) - 1
        ends = (squares.extreme(greatest, turnings)[1] for greatest in (True, False))
        return sum(root(larger(one, 0)) for one in ends) / 2 - 1

    def in_floats(self) -> Equation:
        """Return the same on samples, nearly."""
        half, first, mean = map(float, (self.half, self.first, self.mean))
        return Equation(self.works.in_floats(), self.energies.in_floats(), half, first, mean, self.wheel)

    def number(self, factor: float = 1.0, turnings: Sequence[Any] = ()) -> float:
        """Return the number by samples, of a flywheel so many times as heavy."""
        return halved(
            0.0, self.most, lambda at: self.beyond(self.squares(at, factor), turnings) < 0, HALVINGS
        )

    def rests(self, factor: float = 1.0, margin: float = 0.0) -> bool:
        """Whether by samples the square of a speed of such a flywheel is so far below 0."""
        return bool(self.squares(self.number(factor), factor).extreme(greatest=False)[1] < -margin)

    @property
    def most(self) -> float:
        """What no number is above."""
        return MOST_LAG if self.square else MOST

    def least_factor(self) -> float:
        """Return how many times as heavy a flywheel must be that comes to rest."""
        low, high = 1.0, 2.0
        for _ in range(HALVINGS):
            if not self.rests(high):
                return halved(low, high, self.rests, HALVINGS // 4)
            low, high = high, 2 * high
        raise ProblemError("the speed over the turn is not settled; give slightly other numbers")


class SolvedRun(Run):
    """A turn whose squares of the speed are known but for one number."""

    def check(self) -> None:
        """Know the number nearly. Raises ProblemError for a flywheel that would come to rest."""
        self._solved = kept(self._solution, STEP)
        equation = self._equation()
        floats = equation.in_floats()
        self._guess = floats.number()
        given = float(known(self.wheel.inertia if self.wheel.number is None else self.wheel.number))
        if floats.rests(margin=MOST_MISSED):
            self._refuse_rest(floats, given)
        if equation.square and self._guess < LEAST_LAG:
            factor = (1 + floats.beyond(floats.squares(LEAST_LAG))) ** 2
            raise ProblemError(
                f"{self.wheel.named} is too light: the speed follows the torque at every angle, as if there"
                f" were none; {self.wheel.letter} must be above {above(given * factor)}"
                f"{self.wheel.unit}"
            )
        if isinstance(self.turn, Turn):
            self._ends = self._isolated(equation, Fraction(self._guess))
        else:
            self._turnings = equation.squares(self._guess).turnings()
        if not self._squares().extreme(False, self._turnings)[1] > 0:
            self._refuse_rest(floats, given)

    def _refuse_rest(self, floats: Equation, given: float) -> NoReturn:
        # Where the speed is just nowhere below 0.
        last = halved(0.0, floats.most, lambda one: floats.squares(one).extreme(False)[1] < 0, HALVINGS)
        self.refuse(180 * floats.squares(last).extreme(False)[0], given * floats.least_factor())

    def _equation(self) -> Equation:
        works, energies = self.courses()
        mean = abs(self.turn.mean_force())
        weight = self.at_mean if self.wheel.number is None else self.turn.of(self.wheel.number)
        return Equation(
            works, energies, weight * mean / 2, self.turn.kinetic_energy_begun(), mean, self.wheel
        )

    def _isolated(self, equation: Equation, guess: Fraction) -> tuple[Fraction, Fraction]:
        """Return two numbers between which the true one lies, and know the extremes between them."""

        def beyond(number: arb) -> arb:
            squares = equation.squares(number)
            return ball(equation.beyond(squares, tuple(squares.turnings())))

        missed = float(abs(beyond(ball(guess))).upper()) + NEAREST
        while missed < FARTHEST:
            ends = [guess * (1 + sign * MARGIN * Fraction(missed)) for sign in (-1, 1)]
            if beyond(ball(ends[0])) < 0 and beyond(ball(ends[1])) > 0:
                with at_bits(ISOLATING_BITS):
                    found = crossing(beyond, *ends)
                self._turnings = tuple(equation.squares(found).turnings())
                return fraction(found.lower()), fraction(found.upper())
            missed *= 16
        raise ProblemError("the speed at the dead centre is not settled; give slightly other numbers")

    def _solution(self) -> tuple[Any, Any]:
        """Return the number and the squares of the speed."""
        equation = self._equation()
        number: Any = self._guess
        if isinstance(self.turn, Turn):
            number = crossing(lambda one: equation.beyond(equation.squares(one), self._turnings), *self._ends)
        else:
            number = equation.number(turnings=self._turnings)
            self._turnings = equation.squares(number).turnings()
        return number, equation.squares(number)

    def _squares(self) -> Any:
        return self._solved()[1]

    @property
    def number(self) -> Any:
        if self.wheel.number is not None:
            return self.turn.of(self.wheel.number)
        share = self.first_omega / self.mean_omega
        return self.at_mean * share * share

    def speed(self, half_turns: Fraction) -> Any:
        squares = self._squares()
        return root(squares.at(half_turns) / squares.first)

    def slowness(self) -> Any:
        squares = self._squares()
        return (squares / squares.first).power(Fraction(-1, 2))

    def extreme_place(self, greatest: bool) -> Any:
        return self._squares().extreme(greatest, self._turnings)[0]

    def extreme_speed(self, greatest: bool) -> Any:
        squares = self._squares()
        return root(squares.extreme(greatest, self._turnings)[1] / squares.first)

    def sensitivity(self, key: str, value: float, swing: float) -> float:
        """The same; what lags behind the work is off by as much again."""
        return super().sensitivity(key, value, swing * (1 + (self.wheel.resistance == SQUARE)))

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        return super().place_error(greatest, stroke) + FLAT

    def acceleration(self, half_turns: Fraction) -> Any:
        """Return the angular acceleration dω/dt in 1/s², half the slope of ω², from that of the energy."""
        turn, equation, (number, squares) = self.turn, self._equation(), self._solved()
        square, half = squares.at(half_turns), equation.wheel_energy(number)
        standing = turn.positions(half_turns)
        steam = sum(turn.cylinders[part].still.power(*one) for part, *one in standing)
        resistance = half * square / number if equation.square else turn.mean_force()
        slope = steam - resistance - square * (steam - turn.power(half_turns))
        share = slope / (2 * (half + equation.energies.at(half_turns)) * squares.first)
        return share * self.first_omega * self.first_omega
