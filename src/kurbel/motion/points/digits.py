"""A quantity of a point of the rod at a crank angle, on any kind of number, and its certified digits."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.exact.certify import vanishes
from kurbel.exact.kind import Kind, balls, bounds, settled
from kurbel.kernel.coupler.point import Reach, Rod
from kurbel.motion.points import direction
from kurbel.motion.points.point import Point
from kurbel.motion.points.quantities import (
    DIRECTION,
    At,
    acceleration,
    parts_of,
    path,
    vector_of,
    velocity,
)
from kurbel.page.quantity import Quantity

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank


class Ends(Protocol):
    """What gives the rod of a drive, by a method, at a crank angle, with its reach if that is asked for."""

    def __call__(
        self, drive: Any, method: str, circle: Any, kind: Kind, beside: bool
    ) -> tuple[Rod[Any], Reach[Any] | None]: ...


@dataclass(frozen=True)
class Moved:
    """A point on the rod of a drive: how its ends are found, by a method."""

    ends: Ends
    drive: Any
    method: str
    point: Point

    @property
    def crank(self) -> Crank:
        found: Crank = self.drive.crank
        return found

    def at(self, circle: Any, kind: Kind) -> At:
        """Return what the kernel calls of its quantities take."""
        rod, reach = self.ends(self.drive, self.method, circle, kind, bool(self.point.beside))
        return At(rod, self.point.on(kind), reach, kind, self._gain(kind))

    def _gain(self, kind: Kind) -> Any:
        if not self.crank.acceleration:
            return None
        from kurbel.drive.spin import gain

        return gain(self.crank, kind)

    def value(self, quantity: Quantity, circle: Any, kind: Kind) -> Any:
        """Return a quantity in its unit."""
        found = quantity.formulas["exact"].kernel(self.at(circle, kind))
        return found * quantity.scale(self.crank, kind) if quantity.scale else found

    def certified(self, quantity: Quantity, angle: Fraction, decimals: int, rounding: str) -> int | None:
        """Return it at an exact angle in degrees times 10**decimals, rounded correctly; None of the direction
        of what is zero there."""
        if quantity.of == DIRECTION:
            return self._direction(quantity, angle, decimals, rounding)

        def at(kind: Kind) -> Any:
            return self.value(quantity, kind.circle(angle), kind)

        return settled(at, decimals, rounding, lambda: self._is_algebraic(quantity, angle))

    def _direction(self, quantity: Quantity, angle: Fraction, decimals: int, rounding: str) -> int | None:
        vector = vector_of(quantity)
        if (exact := self._exact_direction(quantity, angle)) is not None:
            return direction.reduced(exact, decimals, rounding)
        mixed = self._is_driven(quantity) and self._by_turns
        return direction.digits(
            lambda kind: vector(self.at(kind.circle(angle), kind)),
            decimals,
            rounding,
            exact=self._is_rational and not mixed,
        )

    def _exact_direction(self, quantity: Quantity, angle: Fraction) -> Fraction | None:
        """Return the direction of what moves as the crank pin that turns evenly: φ and a quarter or two."""
        if self._is_driven(quantity):
            return None
        rod = self.at(bounds().circle(angle), bounds()).rod if self._is_rational else None
        if not self.point.is_pin and (rod is None or rod.driven is not rod.pin):
            return None
        return angle + (90 if vector_of(quantity) is velocity else 180)

    @property
    def _is_rational(self) -> bool:
        """Whether all lengths are rational numbers in units of R."""
        return bool(getattr(self.drive, "is_rational", True))

    @property
    def _by_turns(self) -> bool:
        speed = self.crank.speed
        return speed is not None and bool(speed.turns)

    def _is_driven(self, quantity: Quantity) -> bool:
        """Whether the crank's own acceleration has a part in it."""
        return bool(self.crank.acceleration) and vector_of(quantity) is acceleration

    def _is_algebraic(self, quantity: Quantity, angle: Fraction) -> bool:
        """Whether it is no multiple of π or π².

        Of a crank that turns so many times a second and is itself accelerated, an acceleration is the even
        one's in v²/R and the velocity over π², or in m/s² the even one's times π² and the velocity.
        """
        if not self._is_rational:
            return False
        if not self._by_turns:
            return True
        if not self._is_driven(quantity):
            return quantity.scale is None or vector_of(quantity) is path
        other = velocity if quantity.scale is None else _even
        return all(self._vanishes(other, part, angle) for part in parts_of(quantity))

    def _vanishes(self, vector: Any, part: str, angle: Fraction) -> bool:
        def value(kind: Kind) -> Any:
            return getattr(vector(self.at(kind.circle(angle), kind)), part)

        return vanishes(lambda: value(balls()), float(value(bounds()).bits()))


def _even(at: At) -> Any:
    return acceleration(at._replace(gain=None))
