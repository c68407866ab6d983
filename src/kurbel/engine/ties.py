"""The cycle of an engine on numbers that know what they are made of, as exact/terms.py has them.

At a rational angle forces are algebraic, and so are energies but for the logarithms of Mariotte's law; with
the mean force comes 1/π, with newtons π, and with the masses a power of it. What of these cancels, the terms
tell. Of the places at which the speed is least or greatest no rational one is known: they are undecided, and
so is what follows from them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NoReturn

from kurbel.engine.cylinder import Cylinder
from kurbel.engine.turn import Turn
from kurbel.exact.kind import Kind
from kurbel.exact.terms import UndecidedError, tie_bits
from kurbel.kernel.circle import Circle


class ExactTurn(Turn):
    """A turn on a kind of number of its own, and at rational angles alone."""

    def __init__(self, turn: Turn, kind: Kind) -> None:
        super().__init__(turn.engine, turn.method)
        self.turn, self.kind = turn, kind
        self._own = self.cylinders_on(kind, self._circle)

    def _circle(self, half_turns: Any) -> Circle[Any]:
        if not isinstance(half_turns, (int, Fraction)):
            raise UndecidedError
        found: Circle[Any] = self.kind.circle(180 * Fraction(half_turns))
        return found

    @property
    def cylinders(self) -> tuple[Cylinder, ...]:
        return self._own

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        return self.turn.has_reached(since, part, stroke)

    def peaks(self, greatest: bool, stroke: int | None = None) -> NoReturn:
        raise UndecidedError

    def at_speed(self, factor: Fraction) -> NoReturn:
        raise UndecidedError


def turn_ties(value: Callable[..., Any], turns: Sequence[Any]) -> Callable[[Fraction], float]:
    """Return how near a value of turns can come to a rounding boundary, as `certify.rounded` asks: of turns
    in balls, of which alone more than a ball is known."""

    def on(kind: Kind) -> Any:
        if not all(isinstance(one, Turn) for one in turns):
            raise UndecidedError
        return value(*(ExactTurn(one, kind) for one in turns))

    return lambda boundary: tie_bits(on, boundary)
