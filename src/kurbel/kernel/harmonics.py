"""Harmonics of the straight crank drive: x = Σ A_k cos kφ, c = Σ C_k sin kφ, p = Σ B_k cos kφ.

Units are R, v and v²/R. The crank ratio λ = R/L is a float, an array or a ball. A negative ratio is the
return stroke, whose angle counts from the outer dead centre: the even orders change their signs, but for the
1 in A_0.

Re-derived. With t = tan ½ψ, where ψ = arcsin λ is the rod's greatest angle, cos ψ of any crank angle is
|√(1 + t² e^2iφ)|²/(1 + t²), for (1 + t²)λ = 2t. Two binomial series, multiplied, give for m >= 1

    A_2m = -Σ_j b_j b_(j+m) t^(4j + 2m - 1) = -b_m t^(2m - 1) F(-½, m - ½; m + 1; t⁴),  b_j = (½ over j),

with Gauss's series F, in which all terms but the first, 1, are negative, and A_0 from b_j². A_1 = -1 is the
crank's own share; the other odd orders vanish. By powers of λ the same are `path_series`, which converge
slower: t⁴ is 10^-4 for λ = 1/5 and 0.84 for λ = 0.999, where λ² is 0.998.

Free forces of engines with several cranks: the star of cranks of each order, with exact arithmetic.

All pistons of an engine have the mass m. Each presses on the frame along its slide, away from the shaft,
with m times its acceleration p, the share of order k of which is B_k cos k(φ + δ - β) in units of m v²/R:
φ is the angle of the shaft, δ that of the cylinder's crank pin at φ = 0, β that of its slide, all from the
same line, counted as the shaft turns. As a complex number in the plane of the slides, x along that line,

    e^iβ cos k(φ + δ - β) = ½ e^i(kδ - (k-1)β) e^ikφ + ½ e^-i(kδ - (k+1)β) e^-ikφ,

a vector that turns forward and one that turns backward. Over the cylinders they add up to two `Star`s; times
the cylinders' positions along the shaft, to those of the moment. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import comb, gcd, lcm
from typing import Any, NamedTuple

from kurbel.kernel.circle import Circle, Numeric, cosine_of

_NEGLIGIBLE = 2.0**-56


class Term(NamedTuple):
    """A term of a power series: coefficient times λ to the power."""

    power: int
    coefficient: Fraction


def path_coefficient(order: int, ratio: Numeric) -> Numeric:
    """Return A_k of the piston path from its dead centre, in units of R; A_0 is its mean.

    Floats: relative error at most 3e-15 for k <= 6, 1e-13 for k <= 100, if |λ| <= 1 - 10^-6; beyond, the
    series takes up to 10^6 terms and leaves eleven digits. Valid for |λ| < 1.
    """
    if order == 0:
        return _mean_path(ratio)
    if order == 1:
        return 0 * ratio - 1
    return 0 * ratio + 0 if order % 2 else _even_path(order // 2, ratio)


def slope_factor(order: int, slopes: int) -> int:
    """Return 1 for A_k itself, C_k/A_k = -k of its slope and B_k/A_k = -k² of the slope of that."""
    return -(order**slopes) if slopes else 1


def path_series(order: int, terms: int) -> tuple[Term, ...]:
    """Return the first terms of A_k by powers of λ, exact; fewer where there are no more.

    All have the sign (-1)^(k/2), but for the 1 of A_0, which counts as a term. Re-derived: the powers of
    sin φ in √(1 - λ² sin² φ), expanded in cosines.
    """
    if order % 2:
        return (Term(0, Fraction(-1)),)[:terms] if order == 1 else ()
    if not order:
        return (Term(0, Fraction(1)), *(_power_term(0, n) for n in range(1, terms)))[:terms]
    half = order // 2
    return tuple(_power_term(half, n) for n in range(half, half + terms))


def _power_term(half: int, n: int) -> Term:
    """Return the share of λ^(2n - 1) sin^2n φ in A_2m."""
    share = Fraction(comb(2 * n, n) * comb(2 * n, n - half), 16**n * (2 * n - 1))
    return Term(2 * n - 1, (-1) ** half * (2 if half else 1) * share)


def _half_slant(ratio: Numeric) -> Numeric:
    """Return t = tan ½ψ of the rod's greatest angle, sin ψ = λ."""
    return ratio / (1 + cosine_of(ratio))


def _mean_path(ratio: Numeric) -> Numeric:
    """Return A_0 = 1 + ½ (t - Σ_(j >= 1) b_j² t^(4j - 1))."""
    slant = _half_slant(ratio)
    square = slant * slant
    return 1 + (slant - slant * square * _square_series(square * square)) / 2


def _even_path(half: int, ratio: Numeric) -> Numeric:
    slant = _half_slant(ratio)
    square = slant * slant
    leading = slant / 2
    for j in range(1, half):
        # b_(j+1)/b_j = (½ - j)/(j + 1), and t² a step.
        leading = leading * square * (1 - 2 * j) / (2 * j + 2)
    # A difference, for the negative of 0.0 would have a sign.
    return 0 - leading * _gauss_series(half, square * square)


def _gauss_series(half: int, fourth: Any) -> Numeric:
    """Return F(-½, m - ½; m + 1; t⁴)."""
    if hasattr(fourth, "hypgeom_2f1"):
        minus_half = fourth.__class__(-1) / 2
        # Bounds of the rest pair m - ½ with m + 1, not with 1: else a term of the 268th order takes 0.8 s.
        return fourth.hypgeom_2f1(half + minus_half, minus_half, fourth.__class__(half + 1))
    return _summed(fourth, lambda j: (j - 0.5) * (j + half - 0.5) / ((j + 1) * (j + half + 1)))


def _square_series(fourth: Numeric) -> Numeric:
    """Return Σ_(j >= 1) b_j² t^(4j - 4) = (F(-½, -½; 1; t⁴) - 1)/t⁴."""
    if hasattr(fourth, "hypgeom_2f1"):
        return (_gauss_series(0, fourth) - 1) / fourth
    return _summed(fourth, lambda j: ((j + 0.5) / (j + 2)) ** 2) / 4


def _summed(number: Numeric, quotient: Callable[[int], float]) -> Numeric:
    """Return 1 + q_0 z + q_0 q_1 z² + ... of floats or arrays."""
    total = term = 0 * number + 1.0
    step = 0
    while _matters(term):
        term = term * number * quotient(step)
        total = total + term
        step += 1
    return total


def _matters(term: Numeric) -> bool:
    large = abs(term) > _NEGLIGIBLE
    return bool(large.any()) if hasattr(large, "any") else bool(large)


HALF = Fraction(1, 2)


@dataclass(frozen=True, slots=True)
class Star:
    """Vectors in a plane, added: rays of a rational length at rational parts of a turn, each turn once."""

    rays: tuple[tuple[Fraction, Fraction], ...] = ()

    @classmethod
    def of(cls, rays: Iterable[tuple[Fraction, Fraction]]) -> Star:
        """Return the sum of rays (turn, length)."""
        lengths: dict[Fraction, Fraction] = {}
        for turn, length in rays:
            lengths[turn % 1] = lengths.get(turn % 1, Fraction(0)) + length
        return cls(tuple((turn, length) for turn, length in sorted(lengths.items()) if length))

    @classmethod
    def ray(cls, degrees: Fraction, length: Fraction = Fraction(1)) -> Star:
        return cls.of([(degrees / 360, length)])

    def __add__(self, other: Star) -> Star:
        return Star.of(self.rays + other.rays)

    def __sub__(self, other: Star) -> Star:
        return self + other * -1

    def __mul__(self, other: Star | Fraction | int) -> Star:
        """Return the product as of complex numbers, or a multiple."""
        rays = other.rays if isinstance(other, Star) else ((Fraction(0), Fraction(other)),)
        return Star.of((one + two, long * wide) for one, long in self.rays for two, wide in rays)

    def turned(self, degrees: Fraction) -> Star:
        return self * Star.ray(degrees)

    def mirrored(self) -> Star:
        """Return the conjugate, mirrored in the x-axis."""
        return Star.of((-turn, length) for turn, length in self.rays)

    def square(self) -> Star:
        """Return the square of the magnitude, a vector along the x-axis."""
        return self * self.mirrored()

    def point(
        self, circle: Callable[[Fraction], Circle[Numeric]], of: Callable[[Fraction], Numeric]
    ) -> tuple[Numeric, Numeric]:
        """Return x and y in the kind of number that `circle`, of degrees, and `of` make."""
        x = y = of(Fraction(0))
        for turn, length in self.rays:
            direction = circle(360 * turn)
            x = x + of(length) * direction.cosine
            y = y + of(length) * direction.sine
        return x, y

    def vanishes(self) -> bool:
        """Return whether the vectors add up to nothing, by proof."""
        order = lcm(*(turn.denominator for turn, _ in self.rays))
        return _vanish({int(turn * order): length for turn, length in self.rays}, order)


def forward(order: int, crank: Fraction, bank: Fraction, weight: Fraction) -> Star:
    """Return a cylinder's vector that turns forward, at φ = 0, in units of m R ω² B_k; angles in degrees."""
    return Star.ray(order * crank - (order - 1) * bank, weight * HALF)


def backward(order: int, crank: Fraction, bank: Fraction, weight: Fraction) -> Star:
    """Return a cylinder's vector that turns backward, at φ = 0, in units of m R ω² B_k."""
    return Star.ray((order + 1) * bank - order * crank, weight * HALF)


Powers = Mapping[int, Fraction]
"""Rational multiples of the powers of a primitive root of unity, by exponent."""


def _vanish(powers: Powers, order: int) -> bool:
    """Return whether the sum of the powers of a primitive root ζ of unity of this order is 0.

    A root of p² n-th order has the degree p over those of p n-th order, so that its powers 0..p-1 are
    independent over them: the sums that belong to each must vanish. One of order p, prime to n, has the
    degree p - 1 over those of n-th order, its powers adding up to 0: the sums that belong to each must be
    equal. Where there are fewer powers than p some of them are empty, and all must vanish. Hence
    primes above the number of powers need not be known.
    """
    if len(powers) < 2:
        return not any(powers.values())
    primes = [prime for prime in range(2, len(powers) + 1) if order % prime == 0 and _is_prime(prime)]
    smooth = order
    for prime in primes:
        while smooth % prime == 0:
            smooth //= prime
    rough, smooth = smooth, order // smooth
    return all(_vanish_smooth(part, smooth, primes) for part in _prime_parts(powers, rough, smooth).values())


def _vanish_smooth(powers: Powers, order: int, primes: list[int]) -> bool:
    """The same for an order that has no other primes than these."""
    free = 1
    for prime in primes:
        free *= prime
    square = order // free
    parts: dict[int, dict[int, Fraction]] = {}
    for exponent, length in powers.items():
        parts.setdefault(exponent % square, {})[exponent // square] = length
    return all(_vanish_square_free(part, free, primes) for part in parts.values())


def _vanish_square_free(powers: Powers, order: int, primes: list[int]) -> bool:
    if not primes:
        return not sum(powers.values())
    prime, *rest = primes
    order //= prime
    parts = _prime_parts(powers, prime, order)
    if len(parts) < prime:
        return all(_vanish_square_free(part, order, rest) for part in parts.values())
    first, *others = sorted(parts.values(), key=len)
    return all(_vanish_square_free(_difference(part, first), order, rest) for part in others)


def _prime_parts(powers: Powers, one: int, other: int) -> Mapping[int, Powers]:
    """Return the powers of roots of `one` · `other`-th order, which have no common factor, as powers of the
    `other`-th for each power of the first."""
    to_one, to_other = pow(other, -1, one), pow(one, -1, other)
    parts: dict[int, dict[int, Fraction]] = {}
    for exponent, length in powers.items():
        parts.setdefault(exponent * to_one % one, {})[exponent * to_other % other] = length
    return parts


def _difference(one: Powers, other: Powers) -> Powers:
    return {key: one.get(key, Fraction(0)) - other.get(key, Fraction(0)) for key in {**one, **other}}


def _is_prime(number: int) -> bool:
    return all(gcd(number, divisor) == 1 for divisor in range(2, int(number**0.5) + 1))
