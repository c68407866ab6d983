"""Column-wise text against Python's own formatting, and rounding against fractions."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kurbel.exact.bulk import nearest
from kurbel.formats.columns import Field, Scaled, csv_lines

LONGEST = 2**63 - 1
# Numbers of every length, not only long ones.
INTEGERS = st.integers(0, 63).flatmap(lambda bits: st.integers(-(2**bits) + 1, 2**bits - 1))
DECIMALS = st.integers(0, 18)


def expected(scaled: int, decimals: int, mark: str = ".") -> str:
    return (
        f"{Decimal(scaled).scaleb(-decimals):.{decimals}f}".replace(".", mark)
        if scaled
        else zero(decimals, mark)
    )


def zero(decimals: int, mark: str) -> str:
    return f"0{mark}{'0' * decimals}" if decimals else "0"


def column(numbers: list[int], decimals: int, mark: bytes = b".") -> Scaled:
    return Scaled(np.array(numbers, dtype=np.int64), decimals, mark)


@given(st.lists(st.tuples(INTEGERS, INTEGERS, INTEGERS), min_size=1, max_size=20), DECIMALS, DECIMALS)
def test_columns_stand_side_by_side(rows: list[tuple[int, int, int]], one: int, other: int) -> None:
    first, second, third = (list(numbers) for numbers in zip(*rows, strict=True))
    fields: list[Field] = [
        b"1:5",
        column(first, one, b","),
        column(second, other, b","),
        b"",
        column(third, 0),
    ]
    text = csv_lines(fields, b"; ").decode()
    assert text == "".join(
        f"1:5; {expected(a, one, ',')}; {expected(b, other, ',')}; ; {c}\n" for a, b, c in rows
    )


@pytest.mark.parametrize("length", [1, 4, 8, 9, 16, 17, 19])
def test_short_and_long_numbers_share_a_column(length: int) -> None:
    long = int("1234567890123456789"[:length])
    numbers = [long, 0, -long, 5, -5, 10 ** (length - 1), -(10 ** (length - 1)), 10 ** (length // 2), LONGEST]
    for chosen in (numbers[:-1], numbers):
        lines = csv_lines([column(chosen, 0), column(chosen, 6)], b",").decode().splitlines()
        assert lines == [f"{number},{expected(number, 6)}" for number in chosen]


def test_a_strided_column_is_read_as_it_stands() -> None:
    table = np.arange(12, dtype=np.int64).reshape(6, 2)
    assert csv_lines([Scaled(table[::2, 1], 1)], b",") == b"0.1\n0.5\n0.9\n"
    assert csv_lines([column([], 3), b"1:5"], b",") == b""
    assert csv_lines([column([-1], 18)], b",") == b"-0.000000000000000001\n"


def half_away(value: Fraction) -> int:
    whole = int(abs(value) + Fraction(1, 2))
    return whole if value >= 0 else -whole


FLOATS = st.one_of(
    st.floats(-1e4, 1e4),
    st.floats(allow_nan=False, allow_infinity=False),
    # Floats next to the boundaries: halves of the last place, and a few steps beside them.
    st.builds(
        lambda half, decimals, steps: float(half / 10**decimals * (1 + steps * 2.0**-52)),
        st.integers(-(10**7), 10**7).map(lambda whole: whole + 0.5),
        st.integers(0, 8),
        st.integers(-3, 3),
    ),
)
BOUNDS = st.one_of(st.just(0.0), st.floats(1e-18, 1e-3))


@given(FLOATS, DECIMALS, BOUNDS)
def test_a_number_without_doubt_is_rounded_right_wherever_the_true_value_lies(
    value: float, decimals: int, bound: float
) -> None:
    (scaled,), (doubtful,) = nearest(np.array([value]), decimals, bound)
    if not doubtful:
        for true in (Fraction(value) - Fraction(bound), Fraction(value), Fraction(value) + Fraction(bound)):
            assert half_away(true * 10**decimals) == scaled


@given(FLOATS, DECIMALS, BOUNDS)
def test_only_numbers_near_a_boundary_are_doubtful(value: float, decimals: int, bound: float) -> None:
    _, (doubtful,) = nearest(np.array([value]), decimals, bound)
    exact = abs(Fraction(value)) * 10**decimals
    distance = abs(exact - int(exact) - Fraction(1, 2))
    if doubtful and exact < 2**51:
        assert distance <= Fraction(bound) * 10**decimals * (1 + Fraction(1, 10**14)) + exact / 2**52


@given(st.integers(-(10**9), 10**9), st.integers(1, 8), st.integers(-1000, 1000))
def test_a_bound_that_just_reaches_the_boundary_makes_doubt(whole: int, decimals: int, steps: int) -> None:
    boundary = Fraction(2 * whole + 1, 2 * 10**decimals)
    value = float(boundary) * (1 + steps * 2.0**-52)
    reach = np.nextafter(float(abs(Fraction(value) - boundary)), 1)
    assert nearest(np.array([value]), decimals, float(reach))[1].all()


def test_ties_follow_the_rule_and_are_doubtful() -> None:
    halves = np.array([0.5, 1.5, 2.5, -0.5, -1.5, -2.5])
    away, doubtful = nearest(halves, 0, 0.0)
    assert away.tolist() == [1, 2, 3, -1, -2, -3] and doubtful.all()
    assert nearest(halves, 0, 0.0, half_even=True)[0].tolist() == [0, 2, 2, 0, -2, -2]


def test_numbers_too_large_for_halves_are_doubtful() -> None:
    values = np.array([2.0**52, -1e300, np.inf, np.nan, 1.0])
    assert nearest(values, 0, 0.0)[1].tolist() == [True, True, True, True, False]
    assert nearest(values, 18, 0.0)[1].all()
    # Each number may have its own bound.
    assert nearest(np.array([0.49, 0.49]), 0, np.array([0.001, 0.02]))[1].tolist() == [False, True]
