"""Zeros are found all, once each and in order, and enclosed as narrowly as asked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint
import pytest
from cli import column
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel import certified
from kurbel.exact.certify import ball
from kurbel.exact.place import Field, SecondRootError
from kurbel.exact.search import LEAST_WIDTH, Zero, isolate

Ball = Any
Pair = tuple[Callable[[Ball], Ball], Callable[[Ball], Ball]]

SEVENTH, THIRD, ELEVENTHS = Fraction(1, 7), Fraction(1, 3), Fraction(9, 11)


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with flint.ctx.workprec(flint.ctx.prec):
        yield


def product(zeros: Sequence[Fraction]) -> Pair:
    """Π (x - zero), and its slope."""

    def function(x: Ball) -> Ball:
        value = arb(1)
        for zero in zeros:
            value *= x - ball(zero)
        return value

    def slope(x: Ball) -> Ball:
        total = arb(0)
        for left in range(len(zeros)):
            rest = arb(1)
            for index, zero in enumerate(zeros):
                if index != left:
                    rest *= x - ball(zero)
            total += rest
        return total

    return function, slope


def waves(count: int) -> Pair:
    """sin(π count x - 1), zero at (1/π + k)/count."""
    return (
        lambda x: (arb.pi() * count * x - 1).sin(),
        lambda x: arb.pi() * count * (arb.pi() * count * x - 1).cos(),
    )


def found(pair: Pair, start: Fraction = Fraction(0), end: Fraction = Fraction(1)) -> list[Zero]:
    return isolate(*pair, start, end)


def holds(root: Zero, zero: Fraction) -> bool:
    return root.low <= zero <= root.high


@pytest.mark.parametrize("count", [1, 7, 40])
def test_every_zero_of_a_wave_is_found_in_order(count: int) -> None:
    flint.ctx.prec = 200
    roots = found(waves(count))
    assert [root.rising for root in roots] == [index % 2 == 0 for index in range(count)]
    for index, root in enumerate(roots):
        assert root.place().overlaps((1 / arb.pi() + index) / count)


@settings(max_examples=40, deadline=None)
@given(st.sets(st.integers(1, 996), min_size=1, max_size=6))
def test_every_zero_of_a_polynomial_is_found_once(places: set[int]) -> None:
    # 997 is prime: no zero lies where an interval is parted.
    zeros = [Fraction(count, 997) for count in sorted(places)]
    roots = found(product(zeros))
    assert len(roots) == len(zeros)
    assert all(holds(root, zero) for root, zero in zip(roots, zeros, strict=True))
    assert [root.rising for root in roots] == [(len(zeros) - index) % 2 == 1 for index in range(len(zeros))]


@pytest.mark.parametrize("distance", [Fraction(1, 10**3), Fraction(1, 10**6), Fraction(1, 10**8)])
def test_close_zeros_are_parted(distance: Fraction) -> None:
    zeros = [THIRD, THIRD + distance, ELEVENTHS]
    roots = found(product(zeros))
    assert [root.rising for root in roots] == [True, False, True]
    assert all(holds(root, zero) for root, zero in zip(roots, zeros, strict=True))
    assert all(one.low < one.high <= other.low for one, other in pairwise(roots))


def test_function_without_zeros_has_none() -> None:
    assert found((lambda x: x * x + ball(Fraction(1, 10**6)), lambda x: 2 * x), Fraction(-1)) == []
    assert found(product([Fraction(-1, 10**6), Fraction(1) + Fraction(1, 10**6)])) == []


def test_zeros_beyond_the_ends_are_not_reported() -> None:
    zeros = [-THIRD, THIRD, 1 + THIRD]
    for start, end, within in ((0, 1, zeros[1:2]), (-1, 2, zeros), (-2, 0, zeros[:1]), (2, 5, [])):
        roots = found(product(zeros), Fraction(start), Fraction(end))
        assert len(roots) == len(within)
        assert all(holds(root, zero) for root, zero in zip(roots, within, strict=True))


@pytest.mark.parametrize("apart", [Fraction(0), LEAST_WIDTH / 1000])
@pytest.mark.parametrize("zero", [THIRD, Fraction(1, 2), SEVENTH])
def test_double_zero_is_reported_undecided(zero: Fraction, apart: Fraction) -> None:
    roots = found(product([zero, zero + apart]))
    assert roots
    assert all(root.rising is None for root in roots)
    assert any(holds(root, zero) for root in roots)
    # Next to the narrow interval that holds it neighbours may stay undecided, but none far away.
    assert all(abs(root.low - zero) < 100 * LEAST_WIDTH for root in roots)


@pytest.mark.parametrize("zero", [Fraction(0), Fraction(1), Fraction(1, 8), Fraction(1, 2)])
def test_zero_at_an_end_or_where_the_interval_is_parted_is_not_missed(zero: Fraction) -> None:
    roots = found(product([zero]))
    assert roots
    assert all(holds(root, zero) for root in roots)
    # Where the interval is parted there, both sides are undecided.
    assert all(root.rising or root.high - root.low < 2 * LEAST_WIDTH for root in roots)


def kinked(height: Fraction) -> Pair:
    """height - |x - 1/3|: a roof with its ridge at 1/3, zero at height to both sides."""

    def slope(x: Ball) -> Ball:
        if x < ball(THIRD):
            return arb(1)
        return arb(-1) if x > ball(THIRD) else arb(-1).union(arb(1))

    return lambda x: ball(height) - abs(x - ball(THIRD)), slope


@pytest.mark.parametrize("height", [Fraction(1, 5), Fraction(1, 10**4), Fraction(1, 10**8)])
def test_zeros_beside_a_kink_are_found(height: Fraction) -> None:
    roots = found(kinked(height))
    assert [root.rising for root in roots] == [True, False]
    assert holds(roots[0], THIRD - height)
    assert holds(roots[1], THIRD + height)


def test_zero_on_a_kink_is_reported_undecided() -> None:
    roots = found(kinked(Fraction(0)))
    assert any(holds(root, THIRD) for root in roots)
    assert all(root.rising is None for root in roots)
    assert found(kinked(Fraction(-1, 10**8))) == []


def test_zero_on_a_kink_that_it_crosses_is_decided() -> None:
    # 2x beyond 0, x before.
    def function(x: Ball) -> Ball:
        return (x - ball(THIRD)).max(2 * (x - ball(THIRD)))

    def slope(x: Ball) -> Ball:
        if x < ball(THIRD):
            return arb(1)
        return arb(2) if x > ball(THIRD) else arb(1).union(arb(2))

    roots = found((function, slope))
    assert [root.rising for root in roots] == [True]
    assert holds(roots[0], THIRD)


def test_isolating_leaves_the_precision_as_it_was() -> None:
    flint.ctx.prec = 123
    found(product([THIRD]))
    assert flint.ctx.prec == 123
    with pytest.raises(ArithmeticError):
        isolate(broken, broken, Fraction(0), Fraction(1))
    assert flint.ctx.prec == 123


def broken(x: Ball) -> Ball:
    raise ArithmeticError


@pytest.mark.parametrize("bits", [53, 64, 200, 500, 3000])
def test_refined_zero_is_held_as_narrowly_as_the_precision_allows(bits: int) -> None:
    roots = found(waves(3))
    flint.ctx.prec = bits
    for index, root in enumerate(roots):
        zero = root.place()
        assert zero.rad() < arb(2) ** (12 - bits)
        flint.ctx.prec = bits + 100
        assert zero.contains((1 / arb.pi() + index) / 3)
        flint.ctx.prec = bits


@pytest.mark.parametrize("rising", [True, False])
def test_refined_zero_of_a_steep_bend(rising: bool) -> None:
    # Newton's step from the middle leads far out of the interval: the slope grows from 1e-9 to 1e9.
    sign = 1 if rising else -1

    def function(x: Ball) -> Ball:
        return sign * ((x * 20).exp() - (ball(THIRD) * 20).exp())

    def slope(x: Ball) -> Ball:
        return sign * 20 * (x * 20).exp()

    flint.ctx.prec = 500
    zero = Zero(function, slope, Fraction(-1), Fraction(1), rising).place()
    assert zero.contains(ball(THIRD))
    assert zero.rad() < arb(2) ** -480


def test_undecided_zero_is_not_refined() -> None:
    flint.ctx.prec = 500
    root = Zero(*product([THIRD, THIRD]), THIRD, THIRD + LEAST_WIDTH, None)
    zero = root.place()
    assert zero.contains(ball(root.low))
    assert zero.contains(ball(root.high))


def test_a_triple_zero_in_the_middle_is_found_by_signs_beside_it() -> None:
    zero = Zero(lambda x: x**3, lambda x: 3 * x**2, Fraction(-1), Fraction(1)).place()
    assert zero.contains(0)
    assert zero.rad() < arb(2) ** -10


@pytest.mark.parametrize(("key", "half"), [("x", 1), ("p", 1), ("rod_force", 2)])
def test_a_value_that_is_had_where_its_interval_is_cut_is_found(key: str, half: int) -> None:
    # Half turns, or quarters, are cut after 5/11.
    at = Fraction(900, 11 * half)
    value = certified(key, "1:5", at, digits=45)
    found = column("phi_turn", "solve", f"--where={key}={value}", "--columns=phi_turn", "--digits=9")
    assert f"{float(at):.9f}" in found


def test_a_second_root_is_not_taken() -> None:
    field = Field()
    root = field.surd([1, 0, 1], [1]) ** 0.5
    assert (root * root - field.surd([1, 0, 1], [1])).is_zero
    for other in (1 + root, field.surd([2, 0, 1], [1])):
        with pytest.raises(SecondRootError):
            _ = other**0.5
