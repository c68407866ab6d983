"""Printed numbers and labels: from exact values and scaled integers to text."""

from __future__ import annotations

from decimal import Context, Decimal
from fractions import Fraction
from math import floor, log10
from typing import NamedTuple

ROUNDINGS = ("half-away", "half-even")
MOST_DIGITS = 50
# Of a whole number, which Python would write with 4300; no number that is typed has half as many.
MOST_FIGURES = 3000
# A quantity with no decimals of its own is printed to so many figures.
FIGURES = 5
# What is longer is written as a fraction.
LONGEST_EXACT = 60
LONGEST_RATIO = 30

DECIMALS = {"comma": ",", "point": "."}
DECIMAL_OF_LANGUAGE = {"de": "comma", "en": "point"}

# Prose with formulas between dollar signs, in the notation of page/labels.py.
Label = str


class Number(NamedTuple):
    """A printed number: scaled / 10**decimals, already rounded; every digit is meant."""

    scaled: int
    decimals: int


def nearest(value: Fraction, decimals: int, rounding: str = "half-away") -> Number:
    """Return the exact value rounded to so many decimals.

    Half away from zero, as compositors did, or half to the even digit.
    """
    scaled = value * 10**decimals
    doubled = abs(2 * scaled)
    whole = (doubled.numerator // doubled.denominator + 1) // 2
    if rounding == "half-even" and doubled == 2 * whole - 1 and whole % 2:
        whole -= 1
    return Number(whole if scaled >= 0 else -whole, decimals)


def finite_decimals(value: Fraction) -> int | None:
    """Return how many decimals write the value exactly, or None if no number of them does."""
    denominator, count = value.denominator, 0
    for prime in (2, 5):
        power = 0
        while denominator % prime == 0:
            denominator //= prime
            power += 1
        count = max(count, power)
    return count if denominator == 1 else None


def given(value: Fraction, decimals: int | None, rounding: str) -> Number:
    """Return a rational value, as it was given where it is short: 50000, 120."""
    if decimals is None:
        exact, decimals = finite_decimals(value), figures(float(value))
        decimals = decimals if exact is None else min(exact, decimals)
    return nearest(value, decimals, rounding)


def figures(value: float) -> int:
    """Return the decimals that print so many figures of a value."""
    # 9.99996 is 10.000 to five figures.
    rounded_off = float(f"{value:.{FIGURES - 1}e}")
    before_point = floor(log10(abs(rounded_off))) + 1 if value else 1
    return max(0, FIGURES - before_point)


def number_text(number: Number, mark: str = ".", minus: str = "-") -> str:
    """Return the digits of a number: "-0.025", "1250", with the mark and the minus of the format.

    A zero has no sign, whatever it was before rounding.
    """
    sign = minus if number.scaled < 0 else ""
    digits = str(abs(number.scaled)).rjust(number.decimals + 1, "0")
    if not number.decimals:
        return sign + digits
    return f"{sign}{digits[: -number.decimals]}{mark}{digits[-number.decimals :]}"


def ratio_text(value: Fraction, mark: str = ".") -> str:
    """Return the ratio as books print it: 1:5, 1:4.5, 3:7, 1:∞."""
    if not value:
        return "1:∞"
    if max(value.numerator, value.denominator) > 10**LONGEST_RATIO:
        # That of a crank which is known by its decimals.
        return f"1:{number_text(nearest(1 / value, 4), mark)}"
    if finite_decimals(1 / value) is not None:
        return f"1:{plain(1 / value, mark)}"
    return f"{value.numerator}:{value.denominator}"


def plain(value: Fraction, mark: str = ".", minus: str = "-") -> str:
    """Return the shortest exact decimal, or the value to 15 places where none is exact."""
    decimals = finite_decimals(value)
    if decimals is not None and decimals <= LONGEST_EXACT:
        return number_text(nearest(value, decimals), mark, minus)
    return number_text(nearest(value, 15), mark, minus)


def about(value: Fraction) -> str:
    """Return the value for a message: exact where that is short, else "1e-300" or 0.333333333333333."""
    exact = plain(value)
    if finite_decimals(value) is not None and len(exact) <= 20 and bool(value) == (exact.strip("-0.") != ""):
        return exact
    shortened = Decimal(value.numerator) / value.denominator
    return f"{shortened.normalize(Context(prec=15)):g}"


def exact_text(value: Fraction, mark: str = ".") -> str:
    """Return the shortest exact decimal, or the fraction where none is exact or short: 0.25, 1/6."""
    decimals = finite_decimals(value)
    text = "" if decimals is None or decimals > LONGEST_EXACT else number_text(nearest(value, decimals), mark)
    return text if 0 < len(text) <= LONGEST_EXACT else f"{value.numerator}/{value.denominator}"


def figure(value: Fraction) -> str:
    """Return the exact decimal or fraction where there is a short one, else three places."""
    decimals = finite_decimals(value)
    if decimals is not None and decimals <= 6:
        return plain(value)
    if value.denominator < 1000:
        return f"{value.numerator}/{value.denominator}"
    return number_text(nearest(value, 3))


def degrees_text(angle: Fraction, mark: str = ".", minus: str = "-") -> str:
    """Return an angle in degrees, minutes and, where they are needed, seconds: 2°30', 0°0'20".

    The angle is exact: seconds that are no finite decimal are rounded to three places. Rounding happens
    once, on the smallest unit, so that 5.9999999° is 6°0' and never 5°60'.
    """
    seconds = abs(angle) * 3600
    decimals = min(finite_decimals(seconds) or 0, 3) if finite_decimals(seconds) is not None else 3
    scaled = nearest(seconds, decimals).scaled
    minutes, rest = divmod(scaled, 60 * 10**decimals)
    tail = f'{number_text(Number(rest, decimals), mark)}"' if rest else ""
    return f"{minus if angle < 0 and scaled else ''}{minutes // 60}°{minutes % 60}'{tail}"
