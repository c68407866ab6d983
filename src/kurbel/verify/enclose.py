"""Enclosures of elementary functions in mpmath's interval arithmetic, each with its proof.

Taken from mpmath are +, -, *, / and the square root of intervals alone, whose ends are rounded outwards.
Everything else is a series of these with a bound of what is left out. An interval x of midpoint m and radius
r is passed through a function by its value at m and a bound of its slope: |f(x) - f(m)| <= r max |f'|.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from mpmath.ctx_iv import MPIntervalContext

# mpmath has no types.
Interval = Any

# A context of its own: nobody's precision changes.
iv = MPIntervalContext()
# Guard bits take up what some dozens of roundings widen.
GUARD = 20

_constants: dict[tuple[str, int], Interval] = {}


@contextmanager
def working(bits: int) -> Iterator[None]:
    """Compute with so many bits and some guard bits."""
    before = iv.prec
    iv.prec = bits + GUARD
    try:
        yield
    finally:
        iv.prec = before


def of(number: Fraction | int) -> Interval:
    exact = Fraction(number)
    return iv.mpf(exact.numerator) / exact.denominator


def between(low: Fraction, high: Fraction) -> Interval:
    return iv.mpf([of(low).a, of(high).b])


def low(one: Interval) -> Fraction:
    return _fraction(one._mpi_[0])


def high(one: Interval) -> Fraction:
    return _fraction(one._mpi_[1])


def _fraction(raw: Any) -> Fraction:
    sign, man, exponent, _ = raw
    if not man and exponent:
        raise OverflowError("an enclosure without an end")
    size = Fraction(int(man)) * Fraction(2) ** exponent
    return -size if sign else size


def middle(one: Interval) -> tuple[Interval, Interval]:
    """Return a point m of the interval and [-r, r] with every x of it in m + [-r, r]."""
    centre = one.mid
    centre = iv.mpf([centre.a, centre.a])
    reach = max((one - centre).b, (centre - one).b)
    return centre, iv.mpf([-reach, reach])


def sized(bound: Interval) -> Interval:
    """Return [-b, b] of the upper end b of a bound."""
    return iv.mpf([-bound.b, bound.b])


def pi() -> Interval:
    """π = 16 arctan 1/5 - 4 arctan 1/239 (Machin), by the series of `_small_arctangent`."""
    return _constant("pi", lambda: 16 * _small_arctangent(of(1) / 5) - 4 * _small_arctangent(of(1) / 239))


def log_two() -> Interval:
    """log 2 = 2 artanh 1/3, for (1 + 1/3)/(1 - 1/3) = 2."""
    return _constant("log 2", lambda: 2 * _artanh(of(1) / 3))


def _constant(name: str, compute: Any) -> Interval:
    key = name, iv.prec
    if key not in _constants:
        _constants[key] = compute()
    return _constants[key]


def _tiny(bound: Interval) -> bool:
    return high(bound) < Fraction(1, 2 ** (iv.prec + 4))


def sine_cosine(x: Interval) -> tuple[Interval, Interval]:
    """sin x and cos x of an interval within [-1, 1], by Taylor.

    At a point m, |m| <= 1, the terms m^k/k! fall and their signs alternate, so what is left out is at most
    the first term left out. Both slopes are at most 1, which gives the interval.
    """
    point, reach = middle(x)
    assert abs(point).b <= 1
    term, sine, cosine = iv.mpf(1), iv.mpf(0), iv.mpf(0)
    k = 0
    while True:
        cosine += term
        odd = term * point / (k + 1)
        sine += odd
        term = -odd * point / (k + 2)
        k += 2
        if _tiny(abs(term)):
            break
    rest = sized(abs(term))
    return sine + rest + reach, cosine + rest + reach


def arctangent(x: Interval) -> Interval:
    """At the midpoint: arctan x = π/2 - arctan 1/x for x > 1, arctan x = 2 arctan (x/(1 + √(1 + x²)))
    three times, then the series; the slope is at most 1."""
    point, reach = middle(x)
    if point < 0:
        return -arctangent(-x)
    turned = bool(point > 1)
    reduced = 1 / point if turned else point
    for _ in range(3):
        reduced = reduced / (1 + iv.sqrt(1 + reduced * reduced))
    angle = 8 * _small_arctangent(reduced)
    return (pi() / 2 - angle if turned else angle) + reach


def _small_arctangent(x: Interval) -> Interval:
    """Σ (-1)^k x^(2k+1)/(2k+1) for 0 <= x < 1: terms fall and alternate, so that the first one left out
    bounds the rest."""
    square, power, total, k = x * x, x, iv.mpf(0), 1
    while True:
        total += power / k
        power, k = -power * square, k + 2
        if _tiny(abs(power / k)):
            return total + sized(abs(power / k))


def _artanh(z: Interval) -> Interval:
    """Σ z^(2k+1)/(2k+1) for |z| < 1; the rest is less than |z|^(2n+1)/((2n+1)(1 - z²)), geometrically."""
    square, power, total, k = z * z, z, iv.mpf(0), 1
    while True:
        total += power / k
        power, k = power * square, k + 2
        rest = abs(power) / (k * (1 - square))
        if _tiny(rest):
            return total + sized(rest)


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
    return k * log_two() + 2 * _artanh((rest - 1) / (rest + 1)) + reach / x.a


def exponential(x: Interval) -> Interval:
    """e^m = (e^(m/2^k))^(2^k), |m/2^k| <= 1/2, by Taylor with a rest of at most twice the first term left out
    (the terms at least halve); and e^(m + r) = e^m e^r with |e^r - 1| <= 2 |r| for |r| <= 1/2."""
    point, reach = middle(x)
    if high(reach) > Fraction(1, 2):
        raise OverflowError("the exponential of a wide enclosure")
    k = max(0, int(abs(high(point))).bit_length() + 1)
    # Squaring k times widens 2^k times.
    small, term, total, n = point / 2**k, iv.mpf(1), iv.mpf(0), 1
    while True:
        total += term
        term, n = term * small / n, n + 1
        if _tiny(abs(term)):
            total += sized(2 * abs(term))
            break
    for _ in range(k):
        total = total * total
    return total * (1 + 2 * reach)


def root(x: Interval) -> Interval:
    """√x; of an interval that reaches below 0, of its part from 0 on."""
    if low(x) < 0:
        if high(x) < 0:
            raise ZeroDivisionError("the root of a negative number")
        x = iv.mpf([0, x.b])
    return iv.sqrt(x)
