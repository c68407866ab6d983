"""Certified digits of a turn: settled in balls, or as many as an indicator card supports."""

from __future__ import annotations

from fractions import Fraction
from math import floor, log10
from typing import Any

import flint

from kurbel.certify import NEVER_TIES, ball, rounded
from kurbel.engine_quantities import Where
from kurbel.engine_request import EngineColumn
from kurbel.numerals import nearest
from kurbel.table import Number
from kurbel.turn import Turn, at_bits

# A quantity with no decimals of its own is printed to so many figures.
FIGURES = 5
ESTIMATE_BITS = 80


def settled(
    column: EngineColumn, turns: tuple[Turn, ...], where: Where, rounding: str, unit: int = 1
) -> Number:
    """Return the column's value times `unit` at a place, rounded correctly; of two turns the difference."""

    def value() -> Any:
        first, *others = (column.quantity.value(turn, where) for turn in turns)
        return unit * (first - others[0] if others else first)

    decimals = column.decimals
    if decimals is None:
        decimals = _decimals(float(_as_ball(at_bits(ESTIMATE_BITS, value))))
    exact = value()
    if isinstance(exact, Fraction):
        return nearest(exact, decimals, rounding)
    # What is left are roots of equations with π or logarithms; no rational number is known among them.
    return Number(rounded(value, decimals, rounding, NEVER_TIES), decimals)


def _as_ball(value: Any) -> flint.arb:
    return ball(value) if isinstance(value, Fraction) else value


def _decimals(value: float) -> int:
    before_point = floor(log10(abs(value))) + 1 if value else 1
    return max(0, FIGURES - before_point)
