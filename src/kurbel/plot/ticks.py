"""Ticks at round numbers, written with the decimal mark and the minus sign of print."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import NamedTuple

from kurbel.exact.numerals import Label, finite_decimals, nearest, number_text
from kurbel.page.axes import PHI

MINUS = "−"
_ROUND = (Fraction(1), Fraction(2), Fraction(5, 2), Fraction(5), Fraction(10))
_ANGLE_STEPS = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360)
MOST_STEPS = 12
# The float 0.3 is below 3/10, and still has the tick 0,3.
_SLACK = 1e-9
# Powers of ten that numbers at an axis may have before a power is taken out of them.
_LARGEST, _SMALLEST = 4, -2
# The prefixes of the SI in steps of a thousand, and the units that have them at axes.
PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}
PREFIXED = ("N", "J", "W", "Pa", "m", "s")


class Ticks(NamedTuple):
    """Places of ticks and their numbers."""

    places: tuple[float, ...]
    texts: tuple[str, ...]


class Across(NamedTuple):
    """An axis from left to right: its name, and its ticks between two values with a decimal mark, at most so
    many steps of them."""

    label: Label
    ticks: Callable[[float, float, str, int], Ticks]


def value_ticks(low: float, high: float, step: Fraction, power: int, mark: str) -> Ticks:
    """Return ticks at the multiples of a step between two values, the numbers in units of 10**power."""
    shown = step / Fraction(10) ** power
    decimals = finite_decimals(shown) or 0
    numbers = range(math.ceil(low / step - _SLACK), math.floor(high / step + _SLACK) + 1)
    return Ticks(
        tuple(float(number * step) for number in numbers),
        tuple(number_text(nearest(number * shown, decimals), mark, MINUS) for number in numbers),
    )


def round_step(least: float) -> Fraction:
    """Return the least of 1, 2, 2½, 5 times a power of ten that is not below a number above 0."""
    power = Fraction(10) ** math.floor(math.log10(least))
    return next(number * power for number in _ROUND if number * power >= least * (1 - _SLACK))


def angle_ticks(low: float, high: float, mark: str, most: int = MOST_STEPS) -> Ticks:
    """Return ticks at angles that divide the turn, in so many steps at most: every 30° from 0° to 360°."""
    least = (high - low) / most
    if least > _ANGLE_STEPS[-1]:
        step = Fraction(_ANGLE_STEPS[-1] * math.ceil(least / _ANGLE_STEPS[-1]))
    elif least > _ANGLE_STEPS[0]:
        step = Fraction(next(step for step in _ANGLE_STEPS if step >= least))
    else:
        step = round_step(least)
    ticks = value_ticks(low, high, step, 0, mark)
    return Ticks(ticks.places, tuple(f"{text}°" for text in ticks.texts))


def over_angle(lang: str) -> Across:
    """Return the axis of the crank angle."""
    return Across(f"{PHI[lang]} $φ$", angle_ticks)


def plain_ticks(low: float, high: float, mark: str, most: int = MOST_STEPS) -> Ticks:
    """Return ticks at round numbers, in so many steps at most."""
    return value_ticks(low, high, round_step((high - low) / most), 0, mark)


def degrees(angle: float | Fraction, mark: str) -> str:
    """Return an angle in degrees with at most two decimals: "−30°", "22,5°"."""
    exact = nearest(Fraction(angle), 2)
    decimals = finite_decimals(Fraction(exact.scaled, 100)) or 0
    return f"{number_text(nearest(Fraction(angle), decimals), mark, MINUS)}°"


def power_of_thousand(values: Iterable[float]) -> int:
    """Return the power of ten, a multiple of 3, to be taken out of the numbers at an axis; mostly 0."""
    largest = max(map(abs, values), default=0.0)
    power = math.floor(math.log10(largest)) if largest else 0
    return 0 if _SMALLEST <= power < _LARGEST else 3 * (power // 3)


def axis_label(label: Label, unit: Label, power: int = 0) -> Label:
    """Return what is written at an axis: "Kolbenkraft $P$ in kN", "$p$ in $10^3$ m/s²"."""
    return " in ".join(filter(None, (label, measure(unit, power))))


def measure(unit: Label, power: int) -> Label:
    """Return a unit times a power of ten: of 10³ N kN, of 10³ mm m, else with the power, 10³ m/s²."""
    factor, named = prefixed(unit, power)
    return " ".join(filter(None, (f"${factor}$" if factor else "", named)))


def prefixed(unit: Label, power: int) -> tuple[str, Label]:
    """Return the same as a factor in a formula, 10^3, empty where a prefix says it, and a unit.

    Units that take a prefix, or have one, are those of `PREFIXED`, alone or before others: N m.
    """
    first, *others = unit.split(" ")
    base = first if first in PREFIXED else first[1:]
    powers = {f"{prefix}{base}": known for known, prefix in PREFIXES.items()}
    if base in PREFIXED and first in powers and powers[first] + power in PREFIXES:
        return "", " ".join((PREFIXES[powers[first] + power] + base, *others))
    return f"10^{power if power > 0 else f'({power})'}" if power else "", unit


def amount(number: str, unit: Label, power: int) -> tuple[str, Label]:
    """Return a number of such measures in a formula, 5 or 5 · 10^3, and the unit."""
    factor, named = prefixed(unit, power)
    return " · ".join(filter(None, (number, factor))), named
