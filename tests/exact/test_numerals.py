"""Printed numbers against Python's decimal arithmetic."""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, ROUND_HALF_UP, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kurbel.exact.numerals import Number, degrees_text, finite_decimals, nearest, number_text

EXACT = 200
# Decimal's HALF_UP is half away from zero.
MODES = {"half-away": ROUND_HALF_UP, "half-even": ROUND_HALF_EVEN}

decimals_typed = st.decimals(
    allow_nan=False, allow_infinity=False, places=8, min_value=-(10**6), max_value=10**6
)
# Odd multiples of half a unit: each is a tie.
ties = st.builds(
    lambda odd, places: (Decimal(2 * odd + 1) / 2).scaleb(-places), st.integers(-999, 999), st.integers(0, 6)
)


def quantized(value: Decimal, places: int, mode: str) -> str:
    """The digits by decimal arithmetic; Decimal keeps the sign of a zero, a printed table does not."""
    rounded = value.quantize(Decimal(1).scaleb(-places), rounding=MODES[mode], context=Context(prec=EXACT))
    return format(rounded or abs(rounded), "f")


@pytest.mark.parametrize("mode", MODES)
@given(value=st.one_of(decimals_typed, ties), places=st.integers(0, 10))
def test_numbers_are_rounded_as_decimal_arithmetic_rounds(mode: str, value: Decimal, places: int) -> None:
    assert number_text(nearest(Fraction(value), places, mode)) == quantized(value, places, mode)


@given(decimals_typed)
def test_digits_carry_the_mark_and_the_minus_of_the_format(value: Decimal) -> None:
    number = nearest(Fraction(value), 8)
    assert number_text(number, ",", "−") == number_text(number).replace(".", ",").replace("-", "−")


def test_a_number_without_decimals_has_no_mark() -> None:
    assert number_text(Number(1250, 0)) == "1250"
    assert number_text(Number(-7, 3), ",") == "-0,007"


@given(st.integers(-(10**9), 10**9), st.integers(0, 30))
def test_finite_decimals_are_counted(scaled: int, places: int) -> None:
    value = Fraction(scaled, 10**places)
    count = finite_decimals(value)
    assert count is not None
    assert (value * 10**count).denominator == 1
    assert count == 0 or (value * 10 ** (count - 1)).denominator != 1
    assert finite_decimals(value + Fraction(1, 7)) is None


@pytest.mark.parametrize(
    ("angle", "text"),
    [
        (Fraction(5, 2), "2°30'"),
        (Fraction("5.9999999"), "6°0'"),
        (Fraction("5.99999"), "5°59'59.964\""),
        (Fraction("59.9999999999"), "60°0'"),
        (Fraction(0), "0°0'"),
        (Fraction(1, 180), "0°0'20\""),
        (Fraction(1, 7), "0°8'34.286\""),
        (Fraction(-5, 4), "-1°15'"),
        (Fraction(-1, 10**9), "0°0'"),
    ],
)
def test_degrees_are_rounded_once_and_then_carried(angle: Fraction, text: str) -> None:
    assert degrees_text(angle) == text


@given(st.fractions(min_value=-720, max_value=720))
def test_minutes_and_seconds_never_reach_sixty(angle: Fraction) -> None:
    degrees, rest = degrees_text(angle).split("°")
    minutes, seconds = rest.split("'")
    assert 0 <= int(minutes) < 60
    assert 0 <= Fraction(seconds.removesuffix('"') or 0) < 60
    shown = abs(int(degrees)) + Fraction(int(minutes), 60) + Fraction(seconds.removesuffix('"') or 0) / 3600
    assert abs(shown - abs(angle)) <= Fraction(1, 2000 * 3600)
    assert degrees.startswith("-") == (angle < 0 and shown > 0)
