"""Balance of engines with several cranks: free forces and moments of each order, with certified digits.

Forces are in units of m R ω², m being the reciprocating mass of a cylinder; moments in that times the unit
of the cylinders' positions. They are vectors in the plane across the shaft, see kernel/balance.py.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import inf
from typing import Any, NamedTuple, TypeAlias

from kurbel.balance import harmonics
from kurbel.drive.crank import LARGEST_ANGLE, Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number, nearest
from kurbel.kernel import balance
from kurbel.kernel.balance import Star, component
from kurbel.reading.notation import about

MOST_CYLINDERS = 24
LARGEST_POSITION = 10**6


class Cylinder(NamedTuple):
    """Angle of the crank pin and of the slide (`bank`) in degrees, from the same line and counted as the
    shaft turns; position along the shaft in any unit, from the point to which moments refer."""

    crank: Fraction
    position: Fraction = Fraction(0)
    bank: Fraction = Fraction(0)


@dataclass(frozen=True, slots=True)
class Arrangement:
    """The cylinders of an engine, and the share of each reciprocating mass that counterweights balance.

    The counterweights turn with the shaft, opposite each cylinder's pin; rotating masses are balanced
    apart. Two rods on a pin bring two counterweights: of a V of 90° the share ½ is one whole reciprocating
    mass opposite each pin. Valid for 1 to 24 cylinders, no two of them in one place, and 0 <= share <= 1.
    """

    cylinders: tuple[Cylinder, ...]
    share: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_count(len(self.cylinders))
        if not 0 <= self.share <= 1:
            raise ProblemError(
                f"share of the counterweights is {about(self.share)}; it must lie within 0..1,"
                " for it is a share of the reciprocating mass"
            )
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
    cranks: Sequence[Fraction | int], banks: Sequence[Fraction | int], share: Fraction = Fraction(0)
) -> Arrangement:
    """Return cylinders the unit of length apart, each with a pin and a bank of its own; moments are about
    the middle."""
    places = zip(cranks, _positions(len(cranks)), banks, strict=True)
    cylinders = (Cylinder(Fraction(crank), position, Fraction(bank)) for crank, position, bank in places)
    return Arrangement(tuple(cylinders), share)


def inline(cranks: Sequence[Fraction | int], share: Fraction = Fraction(0)) -> Arrangement:
    """Return cylinders in one bank, the unit of length apart."""
    return row(cranks, [0] * len(cranks), share)


def vee(
    cranks: Sequence[Fraction | int], bank_angle: Fraction | int, share: Fraction = Fraction(0)
) -> Arrangement:
    """Return two cylinders at each pin, in banks on either side of the middle line, from which angles count;
    the pins are the unit of length apart."""
    half = Fraction(bank_angle) / 2
    places = list(zip(cranks, _positions(len(cranks)), strict=True))
    pairs = [[Cylinder(Fraction(crank), z, bank) for bank in (-half, half)] for crank, z in places]
    return Arrangement(tuple(cylinder for pair in pairs for cylinder in pair), share)


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
        "inline-1": inline((0,)),
        "inline-2-180": inline((0, 180)),
        "inline-2-360": inline((0, 0)),
        "inline-3": inline((0, 240, 120)),
        "inline-4": inline((0, 180, 180, 0)),
        "inline-5": inline((0, 216, 144, 72, 288)),
        "inline-6": inline(six),
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
        return component(self.forward, self.backward, degrees)


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
        weight = sign * weigh(cylinder)
        forward += balance.forward(order, cylinder.crank, cylinder.bank, weight)
        backward += balance.backward(order, cylinder.crank, cylinder.bank, weight)
        if order == 1:
            forward -= Star.ray(cylinder.crank, weight * arrangement.share)
    return Residual(forward, backward)


def check_order(order: int) -> None:
    """Raise ProblemError unless the order is one of 1..MOST_ORDERS."""
    if not 1 <= order <= harmonics.MOST_ORDERS:
        raise ProblemError(
            f"free forces of order {order} were asked for; orders 1 to {harmonics.MOST_ORDERS} are given"
        )


Factor: TypeAlias = Fraction | Callable[[], Any]
"""|B_k|: exact, or a function that returns a ball around a transcendental number."""


def factor(order: int, crank: Crank, method: str = "exact") -> Factor:
    """Return |B_k|, by which residuals are multiplied to be in units of m R ω²."""
    check_order(order)
    harmonics.check_straight(crank)
    harmonic = harmonics.HARMONICS["p"]
    exact = harmonics.rational(harmonic, order, crank, method)
    if exact is not None:
        # 1, λ or 0.
        return exact

    def value() -> Any:
        from kurbel.exact.certify import ball

        return abs(harmonic.value(order, ball(crank.ratio)))

    return value


class Length(NamedTuple):
    """A magnitude of the residual: whether it is 0, its ball, and whether it is a rational number > 0."""

    vanishes: Callable[[Residual], bool]
    value: Callable[[Residual], Any]
    equals: Callable[[Residual, Fraction], bool]


def _magnitude(star_of: Callable[[Residual], Star]) -> Length:
    return Length(
        lambda residual: star_of(residual).vanishes(),
        lambda residual: _ball_length(star_of(residual)),
        lambda residual, length: (star_of(residual).square() - _real(length**2)).vanishes(),
    )


def _ball_length(star: Star) -> Any:
    # A ball around 0 has no root.
    if star.vanishes():
        return _ball(Fraction(0))
    x, y = _ball_point(star)
    return (x * x + y * y) ** 0.5


def _ball_point(star: Star) -> tuple[Any, Any]:
    from kurbel.exact import certify

    return star.point(certify.ball_circle, certify.ball)


def _ball(value: Fraction) -> Any:
    from kurbel.exact import certify

    return certify.ball(value)


def _real(value: Fraction) -> Star:
    return Star.ray(Fraction(0), value)


def _half_axis(axis: Callable[[Any, Any], Any], sign: int) -> Length:
    """Return the half axis |f| ± |b| of the ellipse."""

    def vanishes(residual: Residual) -> bool:
        if sign > 0:
            return residual.forward.vanishes() and residual.backward.vanishes()
        return (residual.forward.square() - residual.backward.square()).vanishes()

    def value(residual: Residual) -> Any:
        return axis(_ball_length(residual.forward), _ball_length(residual.backward))

    def equals(residual: Residual, length: Fraction) -> bool:
        forward, backward = residual.forward.square(), residual.backward.square()
        product = forward * backward * 4
        # With l = |f| ± |b| the rest is ±2 |f| |b|; its square alone fits both axes.
        rest = _real(length**2) - forward - backward
        if not (rest * rest - product).vanishes():
            return False
        return product.vanishes() or _sign(rest) == sign

    return Length(vanishes, value, equals)


def _sign(star: Star) -> int:
    """Return the sign of x of a star that is not 0 and lies along the x-axis."""
    import flint

    before = flint.ctx.prec
    try:
        while True:
            x, _ = _ball_point(star)
            if x > 0 or x < 0:
                return 1 if x > 0 else -1
            flint.ctx.prec *= 2
    finally:
        flint.ctx.prec = before


LENGTHS: Mapping[str, Length] = {
    "along": _magnitude(lambda residual: residual.component(Fraction(0))),
    "across": _magnitude(lambda residual: residual.component(Fraction(90))),
    "forward": _magnitude(lambda residual: residual.forward),
    "backward": _magnitude(lambda residual: residual.backward),
    "greatest": _half_axis(balance.greatest, 1),
    "least": _half_axis(balance.least, -1),
}
"""Amplitudes of the components along and across the line from which angles count; the magnitudes of the
two turning vectors; the half axes of the ellipse that they describe."""


def certified_length(
    length: Length,
    residual: Residual,
    decimals: int,
    factor: Factor = Fraction(1),
    rounding: str = "half-away",
) -> Number:
    """Return a magnitude times the factor, correctly rounded; 0 where it is proved to be 0.

    Magnitudes are algebraic, and whether one is a rational number is decided by exact arithmetic. |B_k|
    is transcendental where it is not rational (`harmonics.certified`), and so is its product with one.
    """
    from kurbel.exact import certify

    if factor == 0 or length.vanishes(residual):
        return Number(0, decimals)
    scale, ties = _scale_and_ties(length, residual, factor)
    scaled = certify.rounded(lambda: scale() * length.value(residual), decimals, rounding, ties)
    return Number(scaled, decimals)


def _scale_and_ties(length: Length, residual: Residual, factor: Factor) -> tuple[Callable[[], Any], Any]:
    """Return the factor as a function that makes balls, and which boundaries the product can lie on."""
    from kurbel.exact.certify import NEVER_TIES

    if not isinstance(factor, Fraction):
        return factor, NEVER_TIES
    exact = factor

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if length.equals(residual, boundary / exact) else inf

    return lambda: _ball(exact), tie_bits


def phase(star: Star, decimals: int, rounding: str = "half-away") -> Number | None:
    """Return the angle of a vector in degrees, above -180 and at most 180, correctly rounded; None of 0."""
    return _angle(star, 1, decimals, rounding)


def direction(residual: Residual, decimals: int, rounding: str = "half-away") -> Number | None:
    """Return the direction of the ellipse's longer axis in degrees, above -90 and at most 90.

    None where there is none, for the ellipse is a circle or nothing.
    """
    return _angle(residual.forward * residual.backward, 2, decimals, rounding)


def _angle(star: Star, divisor: int, decimals: int, rounding: str) -> Number | None:
    """Return the angle of a star, divided."""
    from kurbel.exact import certify

    if star.vanishes():
        return None
    straight = Fraction(180, divisor)
    if _is_real(star):
        return nearest(Fraction(0) if _sign(star) > 0 else straight, decimals, rounding)

    def value() -> Any:
        import flint

        x, y = _ball_point(star)
        return flint.arb.atan2(y, x) * 180 / (divisor * certify.pi())

    def tie_bits(boundary: Fraction) -> float:
        # The angle is known to be near the boundary or its negative, and so not opposite to them.
        lines = (star.turned(side * divisor * boundary) for side in (1, -1))
        return 0.0 if any(map(_is_real, lines)) else inf

    scaled = certify.rounded(value, decimals, rounding, tie_bits)
    least = nearest(-straight, decimals, rounding).scaled
    return Number(-least if scaled == least else scaled, decimals)


def _is_real(star: Star) -> bool:
    return (star - star.mirrored()).vanishes()
