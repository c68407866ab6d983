"""What can stand in a table of points of the rod: an entry each, its certified digits, and directions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, Protocol

from flint import arb

from kurbel.drive.at import gain
from kurbel.drive.crank import Crank
from kurbel.drive.moved import Drive
from kurbel.exact.certify import GUARD_BITS, NEVER_TIES, at_bits, ball, ball_degrees, rounded
from kurbel.exact.kind import Kind, balls, settled
from kurbel.exact.numerals import nearest
from kurbel.exact.terms import vanishes
from kurbel.kernel import coupler as kernel
from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.coupler import Point, Reach, Rod, first_order_reach, slide_reach, slide_rod
from kurbel.kernel.rod import Vector
from kurbel.motion.entries import headed, in_units
from kurbel.motion.evaluation import OFFSET
from kurbel.motion.points import RodPoint
from kurbel.page.quantity import Formula, Of, Quantity, words


class At(NamedTuple):
    """What a kernel call takes: the rod, the point, the reach of one beside its axis, the kind of number, and
    α/ω² of a crank that is itself accelerated."""

    rod: Rod[Numeric]
    point: Point[Numeric]
    reach: Reach[Numeric] | None
    kind: Kind
    gain: Numeric | None = None


Vectorial = Callable[[At], Vector[Numeric]]


def path(at: At) -> Vector[Numeric]:
    return kernel.path(at.rod, at.point, at.reach)


def velocity(at: At) -> Vector[Numeric]:
    return kernel.velocity(at.rod, at.point)


def acceleration(at: At) -> Vector[Numeric]:
    even = kernel.acceleration(at.rod, at.point)
    if at.gain is None:
        return even
    # What the crank's own acceleration adds is along the velocity.
    along, across = velocity(at)
    return Vector(even.along + at.gain * along, even.across + at.gain * across)


ALONG, ACROSS = words("längs|along"), words("quer|across")
_AMOUNT, _DIRECTION = words("Betrag|magnitude"), words("Richtung|direction")


class _Kind(NamedTuple):
    """A vector of the point: its key, name, letters along and across and unit, and its formulas along and
    across, of the straight and of the offset crank; those of a point beside the axis have a further term."""

    key: str
    name: str
    letters: tuple[str, str]
    unit: str
    of: Vectorial
    along: tuple[str, str, str, str]
    across: tuple[str, str, str, str]


_VECTORS = (
    _Kind(
        "path", "Weg|Path", ("ξ", "η"), "R", path,
        (
            "ξ/R = (1 - s) x/R + s (1 - cos φ)", " - t sin φ",
            "ξ/R = (1 - s) x/R + s (cos φ_i - cos φ)", " - t (sin φ - sin φ_i)",
        ),
        ("η/R = s sin φ", " + t (cos ψ)/λ", "η/R = (1 - s) e/R + s sin φ", " + t (cos ψ)/λ"),
    ),
    _Kind(
        "velocity", "Geschwindigkeit|Velocity", ("c_ξ", "c_η"), "v", velocity,
        2 * ("c_ξ/v = (1 - s) c/v + s sin φ", " - t cos φ"),
        2 * ("c_η/v = s cos φ", " + t (sin φ - c/v)"),
    ),
    _Kind(
        "acceleration", "Beschleunigung|Acceleration", ("p_ξ", "p_η"), "v²/R",
        acceleration,
        2 * ("(p_ξ R)/v^2 = (1 - s) (p R)/v^2 + s cos φ", " + t sin φ"),
        2 * ("(p_η R)/v^2 = -s sin φ", " + t (cos φ - (p R)/v^2)"),
    ),
)  # fmt: skip
# What the keys of formulas have at their end that are printed of points beside the axis.
BESIDE = " beside"


@cache
def points_registry() -> Mapping[str, Quantity]:
    """Return every quantity of a point of the rod by its key."""
    found: list[Quantity] = []
    for one in _VECTORS:
        found += _components(one)
        if one.key != "path":
            found += _amounts(one)
    return {one.key: one for one in found}


def vector_of(quantity: Quantity) -> Vectorial:
    """Return the vector that a quantity is a part of, its amount or its direction."""
    return next(one.of for one in _VECTORS if quantity.key.startswith(one.key))


def parts_of(quantity: Quantity) -> tuple[str, ...]:
    """Return the parts of its vector that a quantity takes."""
    part = next((one for one in Vector._fields if f"_{one}" in quantity.key), None)
    return Vector._fields if part is None else (part,)


def _components(one: _Kind) -> list[Quantity]:
    found: list[Quantity] = []
    for part, direction, letter, printed in zip(
        Vector._fields, (ALONG, ACROSS), one.letters, (one.along, one.across), strict=True
    ):
        formulas = _formulas(_part(one.of, part), printed)
        found += in_units(f"{one.key}_{part}", one.name, letter, one.unit, formulas, part=direction)
    return found


def _part(vector: Vectorial, part: str) -> Callable[[At], Numeric]:
    return lambda at: getattr(vector(at), part)


def _amounts(one: _Kind) -> list[Quantity]:
    along, across = one.letters
    # The crosshead's own have no index.
    letter, turn = f"{along[0]}_P", f"γ_{along[0]}"

    def whole(at: At) -> Numeric:
        return one.of(at).size()

    def direction(at: At) -> Numeric:
        return of_floats(one.of(at))

    printed = f"{letter} = sqrt({along}^2 + {across}^2)"
    towards = f"tan {turn} = -{across}/{along}"
    amounts = _formulas(whole, 2 * (printed, ""))
    found = in_units(one.key, one.name, letter, one.unit, amounts, part=_AMOUNT, of=Of.AMOUNT)
    angles, key = _formulas(direction, 2 * (towards, "")), f"{one.key}_direction"
    angle = headed(key, one.name, turn, "°", angles, part=_DIRECTION, of=Of.DIRECTION)
    return [*found, angle]


def _formulas(call: Callable[[At], Numeric], printed: tuple[str, str, str, str]) -> Mapping[str, Formula]:
    """Return the formulas of the straight and of the offset crank, with and without their further term."""
    straight, further, offset, more = printed
    return {
        "exact": Formula(call, f"${straight}$"),
        OFFSET: Formula(call, f"${offset}$"),
        "exact" + BESIDE: Formula(call, f"${straight}{further}$"),
        OFFSET + BESIDE: Formula(call, f"${offset}{more}$"),
    }


# What makes a vector on a kind of number.
Made = Callable[[Kind], Vector[Numeric]]
TURN, QUARTER = 360, 90
FIRST_BITS = 2 * GUARD_BITS


def of_floats(vector: Vector[Any]) -> Numeric:
    """Return the direction of floats or arrays, in degrees; that of no vector is 0."""
    import numpy as np

    found: Numeric = np.degrees(np.arctan2(vector.across, 0.0 - vector.along)) % TURN
    return found


def continued(values: Any, amounts: Any) -> Numeric:
    """Return directions over the crank angle, as floats, without steps by a whole turn; that of no vector is
    no number."""
    import numpy as np

    known = amounts != 0
    found = np.full(np.shape(values), np.nan)
    found[known] = np.unwrap(values[known], period=TURN)
    return found


def reduced(degrees: Fraction, decimals: int, rounding: str) -> int:
    """Return an exact direction times 10**decimals, rounded, within a turn."""
    return nearest(degrees % TURN, decimals, rounding).scaled % _turn(decimals)


def digits(made: Made, decimals: int, rounding: str) -> int | None:
    """Return the direction of a vector times 10**decimals, rounded correctly; None where there is no vector.

    The angle of a vector is no rational number of degrees but at few places, and a tie at none that is known:
    one is not taken for proved (`certify.rounded` then raises ProblemError).
    """
    sector = _sector(made)
    if sector is None:
        return None
    found = rounded(lambda: _in_sector(made(balls()), sector), decimals, rounding, NEVER_TIES)
    return found % _turn(decimals)


def _turn(decimals: int) -> int:
    return int(TURN * 10**decimals)


def _sector(made: Made) -> int | None:
    """Return the quarter, from 0, in whose middle or near it the vector points; None if there is none."""
    precision = GUARD_BITS
    while True:
        precision *= 2
        with at_bits(precision):
            one = made(balls())
            forth, up = ball(-one.along), ball(one.across)
            level = abs(forth).mid() >= abs(up).mid()
            strong = forth if level else up
            if not strong.contains(0):
                return (0 if strong > 0 else 2) if level else (1 if strong > 0 else 3)
        if precision == FIRST_BITS and _is_none(made):
            return None


def _is_none(made: Made) -> bool:
    return vanishes(lambda kind: made(kind).along) and vanishes(lambda kind: made(kind).across)


def _in_sector(vector: Vector[Numeric], sector: int) -> arb:
    """Return the degrees of a vector in its quarter, within 45° of the middle of that or somewhat more."""
    forth, up = ball(-vector.along), ball(vector.across)
    aside = (up, -forth, -up, forth)[sector]
    return QUARTER * sector + ball_degrees(aside / ball(vector.size()))


class RodEnds(Protocol):
    """What gives the rod of a drive, by a method, at a crank angle, with its reach if that is asked for."""

    def __call__(
        self, drive: Drive, method: str, circle: Circle[Numeric], kind: Kind, beside: bool
    ) -> tuple[Rod[Numeric], Reach[Numeric] | None]: ...


@dataclass(frozen=True)
class MovedPoint:
    """A point on the rod of a drive: how its ends are found, by a method."""

    ends: RodEnds
    drive: Drive
    method: str
    point: RodPoint

    @property
    def crank(self) -> Crank:
        return self.drive.crank

    def at(self, circle: Circle[Numeric], kind: Kind) -> At:
        """Return what the kernel calls of its quantities take."""
        rod, reach = self.ends(self.drive, self.method, circle, kind, bool(self.point.beside))
        own = gain(self.crank, kind) if self.crank.acceleration else None
        return At(rod, self.point.on(kind), reach, kind, own)

    def value(self, quantity: Quantity, circle: Any, kind: Kind) -> Numeric:
        """Return a quantity in its unit."""
        found: Numeric = quantity.formulas["exact"].kernel(self.at(circle, kind))
        return found * quantity.scale(self.crank, kind) if quantity.scale else found

    def certified(self, quantity: Quantity, angle: Fraction, decimals: int, rounding: str) -> int | None:
        """Return it at an exact angle in degrees times 10**decimals, rounded correctly; None of the direction
        of what is zero there."""
        if quantity.of is Of.DIRECTION:
            return self._direction(quantity, angle, decimals, rounding)

        def at(kind: Kind) -> Numeric:
            return self.value(quantity, kind.circle(angle), kind)

        return settled(at, decimals, rounding)

    def _direction(self, quantity: Quantity, angle: Fraction, decimals: int, rounding: str) -> int | None:
        vector = vector_of(quantity)
        if (exact := self._exact_direction(quantity, angle)) is not None:
            return reduced(exact, decimals, rounding)
        return digits(lambda kind: vector(self.at(kind.circle(angle), kind)), decimals, rounding)

    def _exact_direction(self, quantity: Quantity, angle: Fraction) -> Fraction | None:
        """Return the direction of what moves as the crank pin that turns evenly: φ and a quarter or two."""
        # The crank's own acceleration has a part in it.
        if self.crank.acceleration and vector_of(quantity) is acceleration:
            return None
        rod = self.at(balls().circle(angle), balls()).rod
        if not self.point.is_pin and rod.driven is not rod.pin:
            return None
        return angle + (90 if vector_of(quantity) is velocity else 180)


def rod(
    drive: Crank, method: str, circle: Circle[Numeric], kind: Kind, beside: bool
) -> tuple[Rod[Numeric], Reach[Numeric] | None]:
    """Return the ends of the rod at a crank angle, and its reach if points beside its axis are asked for."""
    ratio, offset = kind.of(drive.ratio), kind.of(drive.offset) if drive.offset else None
    if method == "series":
        x, c, p = (one(circle, ratio) for one in _FIRST_ORDER)
    else:
        x, c, p = (one(circle, ratio, offset) for one in _EXACT)
    ends = slide_rod(circle, ratio, offset, (x, c, p))
    if not beside:
        return ends, None
    first_order = method == "series"
    return ends, first_order_reach(circle, ratio) if first_order else slide_reach(circle, ratio, offset)


_EXACT = (kinematics.piston_path, kinematics.piston_velocity, kinematics.piston_acceleration)
_FIRST_ORDER = (
    kinematics.piston_path_first_order,
    kinematics.piston_velocity_first_order,
    kinematics.piston_acceleration_first_order,
)
