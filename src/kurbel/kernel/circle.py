"""The crank angle as a point on the unit circle: sine, cosine and versine of degrees, and back.

Only + - * /, rounding to whole numbers and the square root touch the numbers, in one order. The results
are therefore the same bits for floats and arrays and on every machine; the sines of the C libraries differ
from one to the next.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Generic, NamedTuple, Protocol, TypeAlias, TypeVar


class Numeric(Protocol):
    """A number of any kind: float, array, ball, terms. The other one is of the same kind, or rational.

    Numbers without an order, as separation bounds and surds, run through formulas that ask for none.
    """

    def __add__(self, other: Any, /) -> Numeric: ...
    def __radd__(self, other: Any, /) -> Numeric: ...
    def __sub__(self, other: Any, /) -> Numeric: ...
    def __rsub__(self, other: Any, /) -> Numeric: ...
    def __mul__(self, other: Any, /) -> Numeric: ...
    def __rmul__(self, other: Any, /) -> Numeric: ...
    def __truediv__(self, other: Any, /) -> Numeric: ...
    def __rtruediv__(self, other: Any, /) -> Numeric: ...
    def __pow__(self, exponent: Any, /) -> Numeric: ...
    def __neg__(self) -> Numeric: ...
    def __abs__(self) -> Numeric: ...
    def __float__(self) -> float: ...
    def __lt__(self, other: Any, /) -> Any: ...
    def __le__(self, other: Any, /) -> Any: ...
    def __gt__(self, other: Any, /) -> Any: ...
    def __ge__(self, other: Any, /) -> Any: ...


Kind = TypeVar("Kind", covariant=True)
Same = TypeVar("Same", bound=Numeric)


class Circle(NamedTuple, Generic[Kind]):
    """sin φ, cos φ and 1 - cos φ of the crank angle φ, all of one kind of number.

    The tails are what rounding took from floats: sin φ is sine + sine_tail to 60 bits. Balls have none.
    """

    sine: Kind
    cosine: Kind
    versine: Kind
    sine_tail: Kind | int = 0
    versine_tail: Kind | int = 0


class _Split(NamedTuple):
    """An unrounded number high + low, low being small."""

    high: Any
    low: Any


Turns: TypeAlias = Sequence[Sequence[Numeric]]
"""Whole and sign of sine, cosine and versine, as in QUARTERS."""


# π/180 as 8 bits, of which products with a 9-bit angle and their cubes are exact, and the rest.
RADIAN = 0.017453292519943295
RADIAN_HIGH = 0.017333984375
RADIAN_LOW = 0.00011930814494329577

# Minimax for b up to 45°: sin b = b - b³/6 + b⁵ R(b²), relative error 2**-62.6, and
# 1 - cos b = b²/2 - b⁴ Q(b²), relative error 2**-58.6.
SINE_TAIL = (
    0.00833333333333333,
    -0.0001984126984126115,
    2.7557319216859563e-06,
    -2.5052105517633784e-08,
    1.6058435369828982e-10,
    -7.581780065642984e-13,
)
VERSINE_TAIL = (
    0.041666666666666644,
    -0.0013888888888882057,
    2.480158729441724e-05,
    -2.7557315763614026e-07,
    2.087591245875724e-09,
    -1.1369285812946273e-11,
)

# Minimax for t up to 1: twice the arc of t in degrees, over t, too small by 5e-9 to 3.6e-8 of it. From an arc
# that is too great there would be no way back near 90°.
TWICE_ARC = (
    114.59155498840258,
    -38.19688763,
    22.90985344,
    -16.27617451,
    12.19360094,
    -8.599264373,
    4.89205973,
    -1.841311983,
    0.3265689737,
)
TWO_RADIANS = 114.59155902616465

# For each quarter turn, sine, cosine and versine as whole + sign * part of the angle beyond the quarter,
# the part being its sine or its versine: cos(180° + r) = -1 + versine r.
QUARTERS = (
    ((0.0, 1.0), (1.0, -1.0), (0.0, 1.0)),
    ((1.0, -1.0), (0.0, -1.0), (1.0, 1.0)),
    ((0.0, -1.0), (-1.0, 1.0), (2.0, -1.0)),
    ((-1.0, 1.0), (0.0, 1.0), (1.0, -1.0)),
)


def circle(degrees: Same) -> Circle[Same]:
    """Return sine, cosine and versine of an angle in degrees, a float or a float64 array of any shape.

    Sine and cosine are at most 0.57 ulp from the true value, the versine 0.71 ulp (below 1e-140° it loses
    digits, being subnormal). Exact where the value is 0, ±½, ±1, 1½ or 2; no zero has a sign. Valid for
    |φ| < 2**50 degrees.
    """
    (of_sine, of_cosine, of_versine), across, along = _unrounded(degrees)
    sine, sine_tail = _settled(of_sine, across)
    cosine, _ = _settled(of_cosine, along)
    versine, versine_tail = _settled(of_versine, along)
    found: Circle[Any] = Circle(sine, cosine, versine, sine_tail, versine_tail)
    return found


def _unrounded(degrees: Any) -> tuple[Turns, _Split, _Split]:
    """Return the row of QUARTERS, the part that the sine takes and the one that cosine and versine take."""
    if isinstance(degrees, (int, float)):
        quarter = round(degrees / 90)
        return _of_one_quarter(quarter, _parts(degrees - 90.0 * quarter))
    if hasattr(degrees, "unrounded"):
        # Numbers of kernel/trace.py choose no branch.
        return degrees.unrounded(_parts)
    import numpy as np

    quarters = np.rint(degrees / 90)
    parts = _parts(degrees - 90.0 * quarters)
    # Long tables run through the angles in order: nearly every block lies in one quarter and needs no
    # selection, which is a third of the time.
    if quarters.size and (quarters == quarters.flat[0]).all():
        return _of_one_quarter(int(quarters.flat[0]), parts)
    index = quarters.astype(np.int64) & 3
    even = index & 1 == 0
    sine, versine = parts
    across = _Split(*(np.where(even, *either) for either in zip(sine, versine, strict=True)))
    along = _Split(*(np.where(even, *either) for either in zip(versine, sine, strict=True)))
    turns = np.array(QUARTERS).transpose(1, 2, 0)
    return [[column.take(index) for column in turn] for turn in turns], across, along


def _of_one_quarter(quarter: int, parts: tuple[_Split, _Split]) -> tuple[Turns, _Split, _Split]:
    sine, versine = parts
    turns = QUARTERS[quarter & 3]
    return (turns, versine, sine) if quarter & 1 else (turns, sine, versine)


def _settled(turn: Sequence[Numeric], part: _Split) -> tuple[Numeric, Numeric]:
    """Return whole + sign * part rounded, and what rounding took from it."""
    whole, sign = turn
    high = sign * part.high
    total = whole + high
    rest = whole - total
    rest += high
    rest += sign * part.low
    settled = total + rest
    total -= settled
    total += rest
    return settled, total


def _parts(degrees: Numeric) -> tuple[_Split, _Split]:
    """Return sine and versine of an angle within ±45°, unrounded."""
    high, low = _radians(degrees)
    angle = high + low
    # b² = high² + (b² - high²), where high² is exact.
    span = angle + high
    exact, rest = high * high, low * span
    square = exact + rest
    fourth = square * square
    sine = _sine(high, low, angle * fourth, square, span)
    exact /= 2
    rest /= 2
    fourth *= _polynomial(VERSINE_TAIL, square)
    rest -= fourth
    return sine, _Split(exact, rest)


def _sine(high: Numeric, low: Numeric, fifth: Numeric, square: Numeric, span: Numeric) -> _Split:
    # b³/6 is a tenth of the sine at 45°; with its few roundings it may not be added to low, or sin 45°
    # differs from cos 45° and the versine next door, 1 - sin b, loses half an ulp.
    cube = high * high
    cube *= high
    cube /= 6
    share = high * span
    share += square
    share *= low
    share /= 6
    fifth *= _polynomial(SINE_TAIL, square)
    fifth -= share
    fifth += low
    upper = high - cube
    rest = high - upper
    rest -= cube
    rest += fifth
    return _Split(upper, rest)


def _radians(degrees: Numeric) -> _Split:
    """Return the angle in radians; high has 17 bits, so that its cube is exact."""
    head = _head(degrees, 44)
    low = degrees - head
    low *= RADIAN
    low += head * RADIAN_LOW
    head *= RADIAN_HIGH
    return _Split(head, low)


def _head(number: Numeric, bits: int) -> Numeric:
    """Return the number without its last so many bits, rounded (Veltkamp)."""
    raised = (2.0**bits + 1) * number
    raised -= raised - number
    return raised


def _polynomial(coefficients: tuple[float, ...], number: Numeric) -> Numeric:
    total = coefficients[-1] * number
    for coefficient in coefficients[-2:0:-1]:
        total += coefficient
        total *= number
    total += coefficients[0]
    return total


def arcsine(sine: Same, tail: Numeric = 0.0) -> Same:
    """Return the angle in degrees, within ±90, whose sine is sine + tail; a float or a float64 array.

    tail is what rounding took from the sine, if known. At most 0.6 ulp from the true value.
    """
    # The libraries' arcsines differ in the last place. Half of the digits are those of twice the arc of
    # tan a/2 = sin a/(1 + cos a); the rest comes from the circle, by
    # sin a - sin b = tan((a - b)/2) (cos a + cos b).
    cosine = cosine_of(sine)
    half = sine / (1 + cosine)
    near = half * _polynomial(TWICE_ARC, half * half)
    turns, across, along = _unrounded(near)
    whole, sign = turns[0]
    difference = (((sine - whole) - sign * across.high) - sign * across.low) + tail
    cosines = cosine + _settled(turns[1], along)[0]
    return near + difference / cosines * TWO_RADIANS + 0.0


def rod_angle(circle: Circle[Numeric], ratio: Numeric, offset: Numeric = 0.0) -> Numeric:
    """Return the rod angle ψ = arcsin(λ (sin φ - η)) in degrees, positive while the pin is on that side.

    Floats and float64 arrays only. At most 1 ulp from the true value while |sin ψ| <= 0.99; with an
    offset, 1 ulp of max(|ψ|, 5°). Source: Rötscher, eq. (285).
    """
    # Nothing that rounding takes from sin φ - η and from the product may be lost: near sin ψ = 1 the
    # angle changes seven times as fast as its sine, and near sin φ = η only the difference counts.
    pin = circle.sine - offset
    taken = pin - circle.sine
    pin_tail = (circle.sine - (pin - taken)) - (offset + taken) + circle.sine_tail
    sine = ratio * pin
    return arcsine(sine, _product_error(ratio, pin, sine) + ratio * pin_tail)


def _product_error(one: Numeric, other: Numeric, product: Numeric) -> Numeric:
    """Return one * other - product exactly (Dekker)."""
    one_high, other_high = _head(one, 27), _head(other, 27)
    one_low, other_low = one - one_high, other - other_high
    return ((one_high * other_high - product) + one_high * other_low + one_low * other_high) + (
        one_low * other_low
    )


def cosine_of(sine: Same) -> Same:
    """Return the cosine of an angle within ±90° from its sine."""
    square: Any = (1 - sine) * (1 + sine)
    return root(square)


def root(number: Same) -> Same:
    """Return the square root of a number of any kind, correctly rounded for floats and arrays."""
    # float ** 0.5 is libm's pow, which differs from NumPy's square root in one result of a thousand.
    found: Any = math.sqrt(number) if isinstance(number, float) else number**0.5
    return found
