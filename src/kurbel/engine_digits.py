"""Certified digits of a turn: settled in balls, or as many as an indicator card supports."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import floor, log10
from typing import TYPE_CHECKING, Any

import flint

from kurbel.certify import NEVER_TIES, TieBits, ball, rounded
from kurbel.engine_quantities import EngineQuantity, Where
from kurbel.engine_request import EngineColumn
from kurbel.engine_ties import energy_ties, force_ties
from kurbel.numerals import nearest
from kurbel.table import Number
from kurbel.turn import Turn, at_bits

if TYPE_CHECKING:
    from kurbel.card_turn import CardTurn

# A quantity with no decimals of its own is printed to so many figures.
FIGURES = 5
ESTIMATE_BITS = 80
FLOAT_ERROR = 1e-12
# What follows from δ, in proportion to it.
SWINGS = ("swing_share", "swing", "inertia", "mass")


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
    return Number(rounded(value, decimals, rounding, _ties(column, turns, where, unit)), decimals)


def _ties(column: EngineColumn, turns: tuple[Turn, ...], where: Where, unit: int) -> TieBits | None:
    # Of roots of equations with π or logarithms no rational one is known, nor of what has the factor π.
    ties = {"tangential": force_ties, "energy": energy_ties}.get(column.quantity.key)
    if ties is None or len(turns) > 1:
        return NEVER_TIES
    assert unit == 1
    return ties(turns[0], where.half_turns)


def estimated(
    column: EngineColumn, turns: tuple[CardTurn, ...], where: Where, unit: int = 1
) -> Number | None:
    """Return the same of an indicator card to as many decimals as it supports, None if not one figure."""

    def value(versions: Sequence[CardTurn]) -> Any:
        first, *others = (column.quantity.value(turn, where) for turn in versions)
        return unit * (first - others[0] if others else first)

    best = value(turns)
    if isinstance(best, Fraction):
        return nearest(best, _decimals(float(best)) if column.decimals is None else column.decimals)
    coarser = [value(versions) for versions in zip(*(turn.coarser for turn in turns), strict=True)]
    # A difference may vanish by chance: what the work allows and what it shows, whichever is more.
    shown = max(abs(best - other) for other in coarser)
    allowed = sum(_sensitivity(column.quantity, turn, best) for turn in turns) * unit
    error = max(shown, allowed) / turns[0].gain + FLOAT_ERROR * (abs(best) + 1)
    wanted = _decimals(best) if column.decimals is None else column.decimals
    supported = min(wanted, floor(-log10(2 * error)))
    return None if column.quantity.arc and supported < 0 else _to_place(Fraction(best), supported)


def _to_place(value: Fraction, decimals: int) -> Number | None:
    """Round to so many decimals, below 0 to tens or hundreds; None if no figure of the value is left."""
    if decimals >= 0:
        return nearest(value, decimals)
    tens = nearest(value / 10**-decimals, 0).scaled * 10**-decimals
    return Number(tens, 0) if tens else None


def _sensitivity(quantity: EngineQuantity, turn: CardTurn, value: float) -> float:
    """How far the quantity can be off where the work of a stroke is off by as much as the coarser cards'."""
    force = turn.mean_force()
    work = 2 * turn.work_apart * len(turn.engine.cranks)
    # An extreme energy 2 A - P α errs by the work twice; δ is the difference of two of them over P.
    irregularity = (4 + 0.64 * turn.irregularity()) * work / 2 / force
    if quantity.arc:
        return 180 * turn.place_apart
    if quantity.scope == "flywheel":
        share = irregularity / turn.irregularity()
        return share * value if quantity.key in SWINGS else 0.0
    return {"delta": irregularity, "mean_force": work}.get(quantity.key, 2 * work)


def _as_ball(value: Any) -> flint.arb:
    return ball(value) if isinstance(value, Fraction) else value


def _decimals(value: float) -> int:
    before_point = floor(log10(abs(value))) + 1 if value else 1
    return max(0, FIGURES - before_point)
