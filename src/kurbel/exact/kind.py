"""The kinds of number on which a formula runs, and what settles the digits of one that runs on any.

Neither floats nor separation bounds load flint.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.exact.separation import Separation, circle_separation
from kurbel.kernel import circle as on_floats
from kurbel.kernel.circle import Circle, Numeric

if TYPE_CHECKING:
    from flint import arb

    from kurbel.exact.surd import Field

# Of balls that become floats.
_ROUNDED_BITS = 192


class Kind(NamedTuple):
    """A kind of number: how it is made of a rational number, the circle of an angle in degrees, the arcsine
    in degrees, π, the rod angle in degrees of circle, λ and e/R or None, what an exponent is to it, and how
    it is made of a number that is known by its balls alone. Of `bounded` numbers every root counts, as of
    separation bounds: formulas with few of them are best.

    Separation bounds have neither arcs nor π; functions of the crank angle come with their own circle.
    """

    of: Callable[[Fraction], Any]
    circle: Any = None
    arc: Any = None
    pi: Any = None
    rod_angle: Any = None
    exponent: Any = None
    enclosed: Any = None
    bounded: bool = False


def balls() -> Kind:
    """Return balls at the precision in force."""
    import flint

    return _balls(flint.ctx.prec)


@lru_cache(maxsize=16)
def _balls(precision: int) -> Kind:
    from kurbel.exact import certify as on

    return Kind(on.ball, on.ball_circle, on.ball_degrees, on.pi(), on.rod_angle, on.ball, _itself)


def _itself(value: Callable[[], arb]) -> arb:
    return value()


def bounds() -> Kind:
    """Return separation bounds."""
    return Kind(Separation.rational, circle_separation, exponent=Fraction, bounded=True)


def settled(value: Callable[[Kind], Any], decimals: int, rounding: str = "half-away") -> int:
    """Return what `rounded` does of a value on any kind of number; of what it is made its ties follow."""
    from kurbel.exact import certify

    def tie_bits(boundary: Fraction) -> float:
        # Few values touch a boundary.
        from kurbel.exact import terms

        return terms.tie_bits(value, boundary)

    return certify.rounded(lambda: value(balls()), decimals, rounding, tie_bits)


def floats() -> Kind:
    """Return floats, or arrays of them."""

    def angle(point: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
        return on_floats.rod_angle(point, ratio, offset or 0.0)

    def circle(degrees: Any) -> Circle[Any]:
        return on_floats.circle(float(degrees) if isinstance(degrees, Fraction) else degrees)

    return Kind(float, circle, on_floats.arcsine, math.pi, angle, float, _rounded)


def _rounded(value: Callable[[], arb]) -> float:
    from kurbel.exact.certify import at_bits

    with at_bits(_ROUNDED_BITS):
        return float(value().mid())


def surds(field: Field) -> Kind:
    """Return functions of the tangent in the field, with their slopes."""
    from kurbel.exact.jet import Jet

    return Kind(lambda number: Jet(field.of(number), field.of(0), field.of(0)), bounded=True)
