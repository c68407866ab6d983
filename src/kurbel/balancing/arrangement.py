"""Balance of engines with several cranks: free forces and moments of each order, with certified digits.

Forces are in units of m R ω², m being the reciprocating mass of a cylinder; moments in that times the unit
of the cylinders' positions. They are vectors in the plane across the shaft, see kernel/harmonics.py.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import inf
from typing import NamedTuple

import flint

from kurbel.balancing import harmonics
from kurbel.drive.at import known
from kurbel.drive.crank import LARGEST_ANGLE, Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, at_bits, ball, rounded
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Number
from kurbel.exact.real import Known, Real
from kurbel.kernel import harmonics as of_kernel
from kurbel.kernel.circle import Numeric
from kurbel.kernel.harmonics import Star
from kurbel.reading.notation import about, check_bounds

MOST_CYLINDERS = 24
LARGEST_POSITION = 10**6


class Cylinder(NamedTuple):
    """Angle of the crank pin and of the slide (`bank`) in degrees, from the same line and counted as the
    shaft turns; position along the shaft in any unit, from the point to which moments refer.

    `mass` is what goes to and fro, and `revolving` what turns with the crank at its radius and is not
    balanced, both in units of m.
    """

    crank: Fraction
    position: Fraction = Fraction(0)
    bank: Fraction = Fraction(0)
    mass: Fraction = Fraction(1)
    revolving: Fraction = Fraction(0)


@dataclass(frozen=True)
class Arrangement:
    """The cylinders of an engine, and the share of each reciprocating mass that counterweights balance.

    The counterweights turn with the shaft, opposite each cylinder's pin; rotating masses are balanced
    apart, but what a cylinder has as `revolving`. Two rods on a pin bring two counterweights: of a V of 90°
    the share ½ is one whole reciprocating mass opposite each pin. Valid for 1 to 24 cylinders, no two of
    them in one place, and 0 <= share <= 1.
    """

    cylinders: tuple[Cylinder, ...]
    share: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_count(len(self.cylinders))
        check_bounds(
            "share of the counterweights", self.share,
            "lie within 0..1, for it is a share of the reciprocating mass",
        )  # fmt: skip
        places: dict[tuple[Fraction, Fraction], int] = {}
        for number, cylinder in enumerate(self.cylinders, 1):
            _check_cylinder(number, cylinder)
            first = places.setdefault((cylinder.position, cylinder.bank % 360), number)
            if first != number:
                raise ProblemError(
                    f"cylinders {first} and {number} are both at position {about(cylinder.position)} in the"
                    f" bank at {about(cylinder.bank)}°; they must differ in one of the two"
                )


def check_count(cylinders: int) -> None:
    """Raise ProblemError unless an engine can have so many cylinders."""
    if not 1 <= cylinders <= MOST_CYLINDERS:
        raise ProblemError(f"{cylinders} cylinders were given; an engine has 1 to {MOST_CYLINDERS}")


def _check_cylinder(number: int, cylinder: Cylinder) -> None:
    if abs(cylinder.position) > LARGEST_POSITION:
        raise ProblemError(f"cylinder {number} lies beyond {LARGEST_POSITION}; take a larger unit of length")
    for what, angle in (("crank", cylinder.crank), ("bank", cylinder.bank)):
        if abs(angle) > LARGEST_ANGLE:
            raise ProblemError(
                f"{what} angle of cylinder {number} is beyond {LARGEST_ANGLE}°;"
                " give it within one turn, 0..360"
            )


def row(
    cranks: Sequence[Fraction | int],
    banks: Sequence[Fraction | int] = (),
    share: Fraction = Fraction(0),
) -> Arrangement:
    """Return cylinders the unit of length apart, each with a pin and a bank of its own, all in one bank
    without any; moments are about the middle."""
    places = zip(cranks, _positions(len(cranks)), banks or [0] * len(cranks), strict=True)
    cylinders = (Cylinder(Fraction(crank), position, Fraction(bank)) for crank, position, bank in places)
    return Arrangement(tuple(cylinders), share)


def vee(
    cranks: Sequence[Fraction | int], bank_angle: Fraction | int, share: Fraction = Fraction(0)
) -> Arrangement:
    """Return two cylinders at each pin, in banks on either side of the middle line, from which angles count;
    the pins are the unit of length apart."""
    half = Fraction(bank_angle) / 2
    places = zip(cranks, _positions(len(cranks)), strict=True)
    cylinders = (Cylinder(Fraction(crank), z, bank) for crank, z in places for bank in (-half, half))
    return Arrangement(tuple(cylinders), share)


def _positions(count: int) -> list[Fraction]:
    return [Fraction(2 * number - count + 1, 2) for number in range(count)]


@cache
def usual() -> Mapping[str, Arrangement]:
    """Return the usual arrangements by name, without counterweights.

    Three to six cylinders in a line fire in the order 1-3-2, 1-3-4-2, 1-2-4-5-3, 1-5-3-6-2-4, at equal
    intervals over two turns.
    """
    six = (0, 240, 120, 120, 240, 0)
    return {
        "inline-1": row((0,)),
        "inline-2-180": row((0, 180)),
        "inline-2-360": row((0, 0)),
        "inline-3": row((0, 240, 120)),
        "inline-4": row((0, 180, 180, 0)),
        "inline-5": row((0, 216, 144, 72, 288)),
        "inline-6": row(six),
        "v2-90": vee((0,), 90),
        "v6-90": vee((0, 240, 120), 90),
        "v8-90": vee((0, 90, 270, 180), 90),
        "v12-60": vee(six, 60),
        "boxer-2": row((0, 180), (0, 180)),
        "boxer-4": row((0, 180, 180, 0), (0, 180, 0, 180)),
    }


class Residual(NamedTuple):
    """What is left of an order: a vector that turns forward by kφ and one backward, at φ = 0.

    In units of m R ω² |B_k|, for a moment times the unit of length. The angle φ of the shaft counts as the
    crank angles do; a direction counts as the banks do.
    """

    forward: Star
    backward: Star

    def component(self, degrees: Fraction) -> Star:
        """Return the component in a direction: its magnitude is the amplitude, its angle α the phase of
        cos(kφ + α)."""
        return self.forward.turned(-degrees) + self.backward.turned(-degrees).mirrored()


def force(arrangement: Arrangement, order: int) -> Residual:
    """Return the free force of an order."""
    return _residual(arrangement, order, lambda cylinder: Fraction(1))


def moment(arrangement: Arrangement, order: int) -> Residual:
    """Return the free moment of an order: each force times its position along the shaft.

    It is the vector of the forces of the couple, in their direction; the axis of the couple is square to it.
    """
    return _residual(arrangement, order, lambda cylinder: cylinder.position)


def _residual(arrangement: Arrangement, order: int, weigh: Callable[[Cylinder], Fraction]) -> Residual:
    check_order(order)
    # B_k is negative for k = 4, 8, 12, ...
    sign = -1 if order % 4 == 0 else 1
    forward, backward = Star(), Star()
    for cylinder in arrangement.cylinders:
        weight = sign * weigh(cylinder) * cylinder.mass
        forward += of_kernel.forward(order, cylinder.crank, cylinder.bank, weight)
        backward += of_kernel.backward(order, cylinder.crank, cylinder.bank, weight)
        if order == 1:
            turning = weigh(cylinder) * cylinder.revolving - weight * arrangement.share
            forward += Star.ray(cylinder.crank, turning)
    return Residual(forward, backward)


def check_order(order: int) -> None:
    """Raise ProblemError unless the order is one of 1..MOST_ORDERS."""
    if not 1 <= order <= harmonics.MOST_ORDERS:
        raise ProblemError(
            f"free forces of order {order} were asked for; orders 1 to {harmonics.MOST_ORDERS} are given"
        )


def factor(order: int, crank: Crank, method: str = "exact") -> Real:
    """Return |B_k|, by which residuals are multiplied to be in units of m R ω²."""
    check_order(order)
    harmonics.check_straight(crank)
    harmonic = harmonics.HARMONICS["p"]
    # 1, λ or 0.
    exact = harmonics.rational(harmonic, order, crank, method)
    if exact is not None:
        return Real.of(exact)
    return Real.transcendental(lambda kind: abs(harmonic.value(order, kind.of(crank.ratio))))


class Length(NamedTuple):
    """A magnitude of the residual: whether it is 0, its ball, and whether it is a rational number > 0."""

    vanishes: Callable[[Residual], bool]
    value: Callable[[Residual, Kind], Numeric]
    equals: Callable[[Residual, Fraction], bool]


def _magnitude(star_of: Callable[[Residual], Star]) -> Length:
    return Length(
        lambda residual: star_of(residual).vanishes(),
        lambda residual, kind: _length(star_of(residual), kind),
        lambda residual, length: (star_of(residual).square() - Star.ray(Fraction(0), length**2)).vanishes(),
    )


def _length(star: Star, kind: Kind) -> Numeric:
    # A ball around 0 has no root.
    if star.vanishes():
        return kind.of(Fraction(0))
    x, y = star.point(kind.circle, kind.of)
    return (x * x + y * y) ** 0.5


def _half_axis(sign: int) -> Length:
    """Return the half axis |f| ± |b| of the ellipse that the two vectors describe; a line's lesser is 0."""

    def vanishes(residual: Residual) -> bool:
        if sign > 0:
            return residual.forward.vanishes() and residual.backward.vanishes()
        return (residual.forward.square() - residual.backward.square()).vanishes()

    def value(residual: Residual, kind: Kind) -> Numeric:
        return abs(_length(residual.forward, kind) + sign * _length(residual.backward, kind))

    def equals(residual: Residual, length: Fraction) -> bool:
        forward, backward = residual.forward.square(), residual.backward.square()
        product = forward * backward * 4
        # With l = |f| ± |b| the rest is ±2 |f| |b|; its square alone fits both axes.
        rest = Star.ray(Fraction(0), length**2) - forward - backward
        if not (rest * rest - product).vanishes():
            return False
        return product.vanishes() or _sign(rest) == sign

    return Length(vanishes, value, equals)


def _sign(star: Star) -> int:
    """Return the sign of x of a star that is not 0 and lies along the x-axis."""
    kind, bits = balls(), flint.ctx.prec
    while True:
        with at_bits(bits):
            x = ball(star.point(kind.circle, kind.of)[0])
        if not x.contains(0):
            return 1 if x > 0 else -1
        bits *= 2


LENGTHS: Mapping[str, Length] = {
    "along": _magnitude(lambda residual: residual.component(Fraction(0))),
    "across": _magnitude(lambda residual: residual.component(Fraction(90))),
    "forward": _magnitude(lambda residual: residual.forward),
    "backward": _magnitude(lambda residual: residual.backward),
    "greatest": _half_axis(1),
    "least": _half_axis(-1),
}
"""Amplitudes of the components along and across the line from which angles count; the magnitudes of the
two turning vectors; the half axes of the ellipse that they describe."""


def certified_length(
    length: Length, residual: Residual, decimals: int, factor: Known = 1, rounding: str = "half-away"
) -> Number:
    """Return a magnitude times the factor, correctly rounded; 0 where it is proved to be 0.

    Magnitudes are algebraic, and whether one is a rational number is decided by exact arithmetic. |B_k|
    is transcendental where it is not rational (`harmonics.certified`), and so is its product with one.
    """
    scale = Real.of(factor)
    if scale.rational == 0 or length.vanishes(residual):
        return Number(0, decimals)
    whole, share = Real(lambda kind: length.value(residual, kind)) * scale, scale.rational

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if length.equals(residual, boundary / known(share)) else inf

    ties = NEVER_TIES if share is None else tie_bits
    return Number(rounded(lambda: whole.on(balls()), decimals, rounding, ties), decimals)
