"""Sums of square roots with rational factors: what proves that a value is a tie, and a zero one."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

# Radicand to factor; the radicand 1 is the rational part. No entry is zero, and the empty sum is 0.
Surd = dict[int, Fraction]

# Longer sums, and longer fractions, are left to the enclosures.
TERMS, BITS = 6, 3000
PRIMES = [n for n in range(2, 200) if all(n % p for p in range(2, isqrt(n) + 1))]


def rational(number: Fraction | int) -> Surd:
    return {1: Fraction(number)} if number else {}


def added(one: Surd, other: Surd) -> Surd | None:
    found = dict(one)
    for radicand, factor in other.items():
        found[radicand] = found[radicand] + factor if radicand in found else factor
    return _kept(found)


def multiplied(one: Surd, other: Surd) -> Surd | None:
    if len(one) * len(other) > 2 * TERMS:
        return None
    found: Surd = {}
    for left, factor in one.items():
        for right, times in other.items():
            outside, inside = (1, left * right) if 1 in (left, right) else parted(left * right)
            product = factor * times * outside
            found[inside] = found[inside] + product if inside in found else product
    return _kept(found)


def inverse(one: Surd) -> Surd | None:
    """Return 1/one of one or two terms: √m takes 1/(f√m) = √m/(f m), and two their conjugate."""
    if len(one) == 1:
        ((radicand, factor),) = one.items()
        return {radicand: 1 / (factor * radicand)}
    if len(one) == 2:
        (m, f), (n, g) = one.items()
        norm = f * f * m - g * g * n
        return _kept({m: f / norm, n: -g / norm}) if norm else None
    return None


def root(one: Surd) -> Surd | None:
    """Return the square root of a rational number that is not negative."""
    if not one:
        return {}
    if set(one) != {1} or one[1] < 0:
        return None
    square = one[1]
    outside, inside = parted(square.numerator * square.denominator)
    return {inside: Fraction(outside, square.denominator)}


def parted(number: int) -> tuple[int, int]:
    """Return a, b with number = a² b, b free of small squares."""
    outside, small, rest = 1, 1, number
    for prime in PRIMES:
        while rest % (prime * prime) == 0:
            outside, rest = outside * prime, rest // (prime * prime)
        if rest % prime == 0:
            small, rest = small * prime, rest // prime
    # Small primes apart, the rest may still be a square.
    whole = isqrt(rest)
    return (outside * whole, small) if whole * whole == rest else (outside, small * rest)


def _kept(found: Surd) -> Surd | None:
    found = {radicand: factor for radicand, factor in found.items() if factor}
    if len(found) > TERMS:
        return None
    if any(f.numerator.bit_length() + f.denominator.bit_length() > BITS for f in found.values()):
        return None
    return found
