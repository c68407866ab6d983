"""Separation bounds: no value comes nearer to a fraction than its bound says, unless it is that fraction."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import flint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel.exact import certify
from kurbel.exact.separation import Separation, circle_separation

WIDE = 4000
"""Bits at which values are compared with their bounds."""


@pytest.fixture
def wide() -> Iterator[None]:
    with flint.ctx.workprec(WIDE):
        yield


def assert_bound(number: Any, bound: Separation) -> None:
    """A number is 0, or at least as large as its bound; beyond WIDE bits nothing is claimed."""
    if bound.bits() < WIDE - 200 and not (number.contains(0) and number.rad() < flint.arb(2) ** (200 - WIDE)):
        assert abs(number) > flint.arb(2) ** -int(bound.bits() + 1)


def convergents(number: Any, largest: int) -> Iterator[Fraction]:
    """Yield the continued fractions of a ball, the best of all rational approximations."""
    above, below, before = (1, 0), (0, 1), number
    while True:
        whole = before.floor().unique_fmpz()
        if whole is None or above[0] * int(whole) > largest or above[1] * int(whole) > largest:
            return
        above, below = (int(whole) * above[0] + below[0], int(whole) * above[1] + below[1]), above
        if above[1]:
            yield Fraction(*above)
        rest = before - whole
        if rest.contains(0):
            return
        before = 1 / rest


ANGLES = (15, 18, 24, 30, 36, 40, 45, 60, 72, 90, 108, 120, 225)
Expression = tuple[Any, Separation]
"""A number, be it a ball or a fraction, and its bound."""


@st.composite
def expressions(draw: st.DrawFn) -> Expression:
    """Numbers made by sums, products, quotients and roots from fractions and the sines of one angle."""
    angle = draw(st.sampled_from([Fraction(n) for n in ANGLES]))
    circle, bounds = certify.ball_circle(angle)[:3], circle_separation(angle)[:3]
    leaves: list[Expression] = list(zip(circle, bounds, strict=True))
    for fraction in draw(st.lists(st.fractions(-3, 3, max_denominator=5), min_size=1, max_size=3)):
        leaves.append((certify.ball(fraction), Separation.rational(fraction)))
    for _ in range(draw(st.integers(1, 5))):
        places = st.integers(0, len(leaves) - 1)
        one, other = leaves[draw(places)], leaves[draw(places)]
        allowed = "+-*2" + "/" * (not other[0].contains(0)) + "r" * bool(one[0] > 0)
        leaves.append(combined(draw(st.sampled_from(allowed)), one, other))
    return leaves[-1]


def combined(operation: str, one: Expression, other: Expression) -> Expression:
    (number, bound), (second, second_bound) = one, other
    if operation == "/":
        return number / second, bound / second_bound
    if operation == "r":
        return number**0.5, bound**0.5
    if operation == "2":
        return number**2, bound**2
    if operation == "*":
        return number * second, bound * second_bound
    if operation == "-":
        return number - second, bound - second_bound
    return number + second, bound + second_bound


@settings(max_examples=200, deadline=None)
@given(drawn=st.data())
def test_no_expression_comes_nearer_to_zero_than_its_bound(drawn: Any) -> None:
    with flint.ctx.workprec(WIDE):
        number, bound = drawn.draw(expressions())
        for fraction in convergents(number, 2**100):
            assert_bound(number - certify.ball(fraction), bound - Separation.rational(fraction))


@given(
    first=st.integers(-9, 9).map(Fraction),
    others=st.lists(st.tuples(st.sampled_from("+-*/"), st.integers(1, 40), st.booleans()), max_size=6),
)
def test_rational_numbers_keep_their_bound(first: Fraction, others: list[tuple[str, int, bool]]) -> None:
    # Whole numbers and their inverses come as near to the bound as any.
    number, bound = first, Separation.rational(first)
    for operation, whole, inverted in others:
        other = Fraction(1, whole) if inverted else Fraction(whole)
        number, bound = combined(operation, (number, bound), (other, Separation.rational(other)))
    assert not number or abs(number) >= Fraction(1, 2 ** int(bound.bits() + 1))


@pytest.mark.parametrize("bits", [2500, 9000])
def test_numbers_of_two_angles_are_bounded_in_the_field_of_both(bits: int) -> None:
    # The field of 2 sin 40° and 2 sin 72° has the degree 24; that of either alone claims too much.
    angles = Fraction(40), Fraction(72)
    with flint.ctx.workprec(bits + 3000):
        one, other = (2 * certify.ball_circle(angle).sine for angle in angles)
        coefficients = small_combination(one, other, bits)
        number = polynomial(coefficients, one, other, certify.ball)
        first, second = (2 * circle_separation(angle).sine for angle in angles)
        bound = polynomial(coefficients, first, second, Separation.rational)
        assert 0 < abs(number) < flint.arb(2) ** (-bits * 9 // 10)
        assert abs(number) > flint.arb(2) ** -int(bound.bits() + 1)


def small_combination(one: Any, other: Any, bits: int) -> list[list[int]]:
    """Return whole c[i][j] that make the sum of c one^i other^j tiny: a short vector of a lattice."""
    powers = [one**i * other**j for i in range(6) for j in range(4)]
    rows = [
        [int(row == column) for column in range(24)]
        + [int((powers[row] * flint.arb(2) ** bits).floor().unique_fmpz())]
        for row in range(24)
    ]
    short = flint.fmpz_mat(rows).lll()
    return [[int(short[0, 4 * i + j]) for j in range(4)] for i in range(6)]


def polynomial(coefficients: list[list[int]], one: Any, other: Any, of: Any) -> Any:
    total = of(Fraction(0))
    for row in reversed(coefficients):
        inner = of(Fraction(0))
        for coefficient in reversed(row):
            inner = inner * other + of(Fraction(coefficient))
        total = total * one + inner
    return total


@pytest.mark.usefixtures("wide")
def test_bound_of_a_root_is_not_far_from_the_truth() -> None:
    # A convergent p/q of √2 is about 1/(2√2 q²) away, log2 of which the bound may miss by a few bits.
    number, bound = certify.ball(2) ** 0.5, Separation.rational(2) ** 0.5
    for fraction in convergents(number, 2**120):
        distance = abs(number - certify.ball(fraction))
        bits = (bound - Separation.rational(fraction)).bits()
        assert flint.arb(2) ** -int(bits + 1) < distance < flint.arb(2) ** -int(bits - 4)


@pytest.mark.usefixtures("wide")
@pytest.mark.parametrize("exponent", [Fraction(1, 3), Fraction(3, 2), Fraction(-5, 7), Fraction(-2)])
def test_bound_of_a_power_lies_below_its_distance_from_near_fractions(exponent: Fraction) -> None:
    number = certify.ball(2) ** certify.ball(exponent)
    bound = Separation.rational(2) ** exponent
    for fraction in convergents(number, 2**60):
        distance = abs(number - certify.ball(fraction))
        bits = (bound - Separation.rational(fraction)).bits()
        assert distance == 0 or flint.arb(2) ** -int(bits + 1) < distance


def test_bound_of_either_number_holds_for_both() -> None:
    one, other = Separation.rational(Fraction(3, 7)), Separation.rational(Fraction(1, 1000)) ** Fraction(1, 3)
    for either in (one.max(other), other.union(one)):
        assert either.bits() >= max(one.bits(), other.bits())


@given(st.integers(1, 10**30), st.integers(1, 10**30))
def test_root_of_a_fraction_bounds_its_numerator_and_its_denominator(top: int, bottom: int) -> None:
    # sqrt(a/b) = sqrt(ab)/b: both are algebraic integers, and b is the denominator the bound must know.
    fraction = Fraction(top, bottom)
    root = Separation.rational(fraction) ** 0.5
    with mp.workprec(300):
        denominator = mp.mpf(fraction.denominator)
        numerator = mp.sqrt(mp.mpf(fraction.numerator) * denominator)
        slack = mp.mpf(2) ** -40
        assert mp.log(numerator, 2) <= root.upper + slack
        assert mp.log(denominator, 2) <= root.lower + slack
