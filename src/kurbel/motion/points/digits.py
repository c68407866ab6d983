"""A quantity of a point of the rod at a crank angle, on any kind of number, and its certified digits."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.exact.kind import Kind, balls, settled
from kurbel.kernel import kinematics
from kurbel.kernel.coupler import Reach, Rod, first_order_reach, slide_reach, slide_rod
from kurbel.motion.points import direction
from kurbel.motion.points.point import Point
from kurbel.motion.points.quantities import (
    DIRECTION,
    At,
    acceleration,
    vector_of,
    velocity,
)
from kurbel.page.quantity import Quantity

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.exact.kind import Kind


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
        from kurbel.drive.at import gain

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

        return settled(at, decimals, rounding)

    def _direction(self, quantity: Quantity, angle: Fraction, decimals: int, rounding: str) -> int | None:
        vector = vector_of(quantity)
        if (exact := self._exact_direction(quantity, angle)) is not None:
            return direction.reduced(exact, decimals, rounding)
        return direction.digits(lambda kind: vector(self.at(kind.circle(angle), kind)), decimals, rounding)

    def _exact_direction(self, quantity: Quantity, angle: Fraction) -> Fraction | None:
        """Return the direction of what moves as the crank pin that turns evenly: φ and a quarter or two."""
        if self._is_driven(quantity):
            return None
        rod = self.at(balls().circle(angle), balls()).rod
        if not self.point.is_pin and rod.driven is not rod.pin:
            return None
        return angle + (90 if vector_of(quantity) is velocity else 180)

    def _is_driven(self, quantity: Quantity) -> bool:
        """Whether the crank's own acceleration has a part in it."""
        return bool(self.crank.acceleration) and vector_of(quantity) is acceleration


def rod(
    drive: Crank, method: str, circle: Any, kind: Kind, beside: bool
) -> tuple[Rod[Any], Reach[Any] | None]:
    """Return the ends of the rod at a crank angle, and its reach if points beside its axis are asked for."""
    ratio = kind.of(drive.ratio)
    if drive.offset:
        offset = kind.of(drive.offset)
        by = (kinematics.offset_path, kinematics.offset_velocity, kinematics.offset_acceleration)
        x, c, p = (one(circle, ratio, offset) for one in by)
        return slide_rod(circle, ratio, offset, (x, c, p)), (
            slide_reach(circle, ratio, offset) if beside else None
        )
    first_order = method == "series"
    formulas = _FIRST_ORDER if first_order else _EXACT
    x, c, p = (one(circle, ratio) for one in formulas)
    ends = slide_rod(circle, ratio, None, (x, c, p))
    if not beside:
        return ends, None
    return ends, first_order_reach(circle, ratio) if first_order else slide_reach(circle, ratio, None)


_EXACT = (kinematics.piston_path, kinematics.piston_velocity, kinematics.piston_acceleration)
_FIRST_ORDER = (
    kinematics.piston_path_first_order,
    kinematics.piston_velocity_first_order,
    kinematics.piston_acceleration_first_order,
)
