"""Enclosures of elementary functions by mpmath's interval arithmetic, each with its proof.

Taken from mpmath are +, -, *, / and the square root of intervals alone, whose ends are rounded outwards.
Everything else is a series in whole units of 2^-w, with a bound of what is left out and of what is cut off
its terms. An interval x of midpoint m and radius r is passed through a function by its value at m and a bound
of its slope: |f(x) - f(m)| <= r max |f'|.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache, wraps
from typing import ParamSpec, TypeVar

from mpmath import libmp

# mpmath's float: sign, mantissa, exponent and how many bits the mantissa has.
End = tuple[int, int, int, int]
P = ParamSpec("P")
Found = TypeVar("Found")

# Guard bits take up what some dozens of roundings widen, spare ones what the terms of a series are cut off.
GUARD, SPARE = 20, 10


class WorkingPrecision:
    """The precision in force, in bits."""

    bits = 53


@contextmanager
def working(bits: int) -> Iterator[None]:
    """Compute with so many bits and some guard bits."""
    before = WorkingPrecision.bits
    WorkingPrecision.bits = bits + GUARD
    try:
        yield
    finally:
        WorkingPrecision.bits = before


def by_bits(function: Callable[P, Found]) -> Callable[P, Found]:
    """Keep what a function finds, with the bits it was found with."""

    @lru_cache(maxsize=256)
    def kept(bits: int, *given: P.args, **named: P.kwargs) -> Found:
        return function(*given, **named)

    @wraps(function)
    def found(*given: P.args, **named: P.kwargs) -> Found:
        return kept(WorkingPrecision.bits, *given, **named)  # type: ignore[arg-type]

    return found


class Interval:
    """All numbers from one end to the other.

    mpmath's own class makes five calls of each operation, and parses a whole number before it divides by it;
    here a turn is proved in half the time.
    """

    __slots__ = ("ends",)

    def __init__(self, a: End, b: End) -> None:
        self.ends = a, b

    def __add__(self, other: Interval | int) -> Interval:
        return Interval(*libmp.mpi_add(self.ends, _ends(other), WorkingPrecision.bits))

    def __sub__(self, other: Interval | int) -> Interval:
        return Interval(*libmp.mpi_sub(self.ends, _ends(other), WorkingPrecision.bits))

    def __rsub__(self, other: int) -> Interval:
        return Interval(*libmp.mpi_sub(_ends(other), self.ends, WorkingPrecision.bits))

    def __mul__(self, other: Interval | int) -> Interval:
        return Interval(*libmp.mpi_mul(self.ends, _ends(other), WorkingPrecision.bits))

    def __truediv__(self, other: Interval | int) -> Interval:
        return Interval(*libmp.mpi_div(self.ends, _ends(other), WorkingPrecision.bits))

    def __rtruediv__(self, other: int) -> Interval:
        return Interval(*libmp.mpi_div(_ends(other), self.ends, WorkingPrecision.bits))

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Interval:
        return Interval(*libmp.mpi_neg(self.ends))

    def __abs__(self) -> Interval:
        return Interval(*libmp.mpi_abs(self.ends, WorkingPrecision.bits))


def _ends(one: Interval | int) -> tuple[End, End]:
    return one.ends if isinstance(one, Interval) else (whole := libmp.from_int(one), whole)


def of(number: Fraction | int) -> Interval:
    return between(number, number)


def between(low: Fraction | int, high: Fraction | int) -> Interval:
    return Interval(
        libmp.from_rational(low.numerator, low.denominator, WorkingPrecision.bits, libmp.round_floor),
        libmp.from_rational(high.numerator, high.denominator, WorkingPrecision.bits, libmp.round_ceiling),
    )


def low(one: Interval) -> Fraction:
    return _fraction(one.ends[0])


def high(one: Interval) -> Fraction:
    return _fraction(one.ends[1])


def _fraction(raw: End) -> Fraction:
    sign, man, exponent, _ = raw
    if not man and exponent:
        raise OverflowError("an enclosure without an end")
    whole = -int(man) if sign else int(man)
    return Fraction(whole << exponent) if exponent >= 0 else Fraction(whole, 1 << -exponent)


def middle(one: Interval) -> tuple[Interval, Interval]:
    """Return a point m of the interval and [-r, r] with every x of it in m + [-r, r]."""
    inside = libmp.mpi_mid(one.ends, WorkingPrecision.bits)
    centre = Interval(inside, inside)
    return centre, sized(abs(one - centre))


def sized(bound: Interval) -> Interval:
    """Return [-b, b] of the upper end b of a bound."""
    end = bound.ends[1]
    return Interval(libmp.mpf_neg(end), end)


@by_bits
def pi() -> Interval:
    """π = 16 arctan 1/5 - 4 arctan 1/239 (Machin), by the series of `_odd_powers`."""
    return 16 * _odd_powers(of(1) / 5, -1) - 4 * _odd_powers(of(1) / 239, -1)


@by_bits
def log_two() -> Interval:
    """log 2 = 2 artanh 1/3, for (1 + 1/3)/(1 - 1/3) = 2."""
    return 2 * _odd_powers(of(1) / 3, 1)


def _units(point: Interval, spare: int = SPARE) -> tuple[int, int]:
    """Return m and w of a point cut off to m 2^-w; the cut is less than a unit."""
    bits = WorkingPrecision.bits + spare
    return int(low(point) * 2**bits), bits


def _about(units: int, off: int, bits: int) -> Interval:
    return Interval(libmp.from_man_exp(units - off, -bits), libmp.from_man_exp(units + off, -bits))


def _tiny(term: int, bits: int) -> bool:
    return abs(term) <= 1


def sine_cosine(x: Interval) -> tuple[Interval, Interval]:
    """sin x and cos x of an interval within [-1, 1], by Taylor.

    At a point m, |m| <= 1, the terms m^k/k! fall and their signs alternate, so what is left out is at most
    the first term left out. Each is cut off twice, which puts it off by less than (e + 1)/k + 1 units, e that
    of the one before: by less than two, for the first two are whole. Both slopes are at most 1, which gives
    the interval, and one unit for the cut of m.
    """
    point, reach = middle(x)
    m, bits = _units(point)
    assert abs(m) <= 1 << bits
    term, sine, cosine, k = 1 << bits, 0, 0, 0
    while True:
        cosine += term
        odd = (term * m >> bits) // (k + 1)
        sine += odd
        term = -((odd * m >> bits) // (k + 2))
        k += 2
        if _tiny(term, bits):
            break
    off = abs(term) + 2 + k + 1
    return _about(sine, off, bits) + reach, _about(cosine, off, bits) + reach


def arctangent(x: Interval) -> Interval:
    """At the midpoint: arctan x = π/2 - arctan 1/x for x > 1, arctan x = 2 arctan (x/(1 + √(1 + x²)))
    three times, then the series; the slope is at most 1."""
    point, reach = middle(x)
    if low(point) < 0:
        return -arctangent(-x)
    turned = low(point) > 1
    reduced = 1 / point if turned else point
    for _ in range(3):
        reduced = reduced / (1 + root(1 + reduced * reduced))
    angle = 8 * _odd_powers(reduced, -1)
    return (pi() / 2 - angle if turned else angle) + reach


def _odd_powers(x: Interval, sign: int) -> Interval:
    """x + sx³/3 + x⁵/5 + sx⁷/7 + ... of |x| <= 1/3: arctan x with the sign -1, artanh x with 1.

    At a point the terms fall at least ninefold, so what is left out is at most twice the first of it. A power
    is put off by less than e/9 + 1/3 + 1 < 2 units, e that of the one before, and a term by less than two.
    The slopes are at most 9/8.
    """
    point, reach = middle(x)
    m, bits = _units(point)
    square = sign * (m * m >> bits)
    power, total, k = m, 0, 1
    while True:
        total += power // k
        power, k = power * square >> bits, k + 2
        if _tiny(power // k, bits):
            break
    off = 2 * (abs(power // k) + 2) + k + 2
    return _about(total, off, bits) + 2 * reach


def logarithm(x: Interval) -> Interval:
    """At the midpoint m = 2^k r, 3/4 < r <= 3/2: log m = k log 2 + 2 artanh ((r - 1)/(r + 1)); the slope is
    at most 1/x at the lower end."""
    if low(x) <= 0:
        raise ZeroDivisionError("the logarithm of what may not be positive")
    point, reach = middle(x)
    exact = low(point)
    k = exact.numerator.bit_length() - exact.denominator.bit_length()
    while exact > Fraction(3, 2) * Fraction(2) ** k:
        k += 1
    while exact <= Fraction(3, 4) * Fraction(2) ** k:
        k -= 1
    rest = of(exact / Fraction(2) ** k)
    return k * log_two() + 2 * _odd_powers((rest - 1) / (rest + 1), 1) + reach / Interval(*2 * x.ends[:1])


def exponential(x: Interval) -> Interval:
    """e^m = (e^(m/2^k))^(2^k), |m/2^k| <= 1/2, by Taylor with a rest of at most twice the first term left out
    (the terms at least halve); and e^(m + r) = e^m e^r with |e^r - 1| <= 2 |r| for |r| <= 1/2.

    A term is put off by less than (e/2 + 1)/n + 1 < 2 units, e that of the one before, and the cut of m/2^k
    counts twice at most, for the slope is below 2.
    """
    point, reach = middle(x)
    if high(reach) > Fraction(1, 2):
        raise OverflowError("the exponential of a wide enclosure")
    k = max(0, int(abs(high(point))).bit_length() + 1)
    # Squaring k times widens 2^k times.
    m, bits = _units(point / 2**k, SPARE + k)
    term, whole, n = 1 << bits, 0, 1
    while True:
        whole += term
        term, n = (term * m >> bits) // n, n + 1
        if _tiny(term, bits):
            break
    total = _about(whole, 2 * (abs(term) + 2) + 2 * n + 2, bits)
    for _ in range(k):
        total = total * total
    return total * (1 + 2 * reach)


def root(x: Interval) -> Interval:
    """√x; of an interval that reaches below 0, of its part from 0 on."""
    if low(x) < 0:
        if high(x) < 0:
            raise ZeroDivisionError("the root of a negative number")
        x = Interval(libmp.fzero, x.ends[1])
    return Interval(*libmp.mpi_sqrt(x.ends, WorkingPrecision.bits))
