"""Certified digits of a turn: settled in balls, or as many as an indicator card supports."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import ceil, floor, log10
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import CRANK_FORCES, known
from kurbel.engine.cylinder import TurnPlace
from kurbel.engine.engine_quantities import AT_ANGLE, EXTREMES, OF_RUNS, engine_registry, value
from kurbel.engine.turn import turn_ties
from kurbel.errors import CardError
from kurbel.exact.certify import TieBits, at_bits, rounded
from kurbel.exact.numerals import Number, figures, given, nearest
from kurbel.kernel.circle import Numeric
from kurbel.page.quantity import Column, Of, Quantity, bare

if TYPE_CHECKING:
    from kurbel.engine.card.force import CardTurn

# What the key of a value of a card has in addition for its error.
ERROR = "_error"
ESTIMATE_BITS = 80
FLOAT_ERROR = 1e-12
# A gain from which on the points are on a curve, not in a cloud.
CLEAN = 8
# What the crank angle tells, whatever the card.
KNOWN = ("pin_path", "pin_path_mm")
# What follows from δ, in proportion to it.
SWINGS = ("swing_share", "swing", "inertia", "inertia_true", "mass")


class CellValue(NamedTuple):
    """A column's value times `unit` at a place of a turn; of two turns their difference.

    The turns are all in balls, or all of cards.
    """

    column: Column
    turns: Sequence[Any]
    where: TurnPlace
    unit: int = 1

    def value(self) -> Numeric:
        first, *others = (value(self.column.quantity, turn, self.where) for turn in self.turns)
        return self.unit * (first - others[0] if others else first)


def settled(asked: CellValue, rounding: str) -> Number:
    """Return the value, rounded correctly."""

    def ties(boundary: Fraction) -> float:
        # Few values touch a boundary.
        return turn_ties(lambda *turns: asked._replace(turns=turns).value(), asked.turns)(boundary)

    return certified(asked.value, asked.column, rounding, ties)


def certified(value: Callable[[], Numeric], column: Column, rounding: str, ties: TieBits | None) -> Number:
    """Return a column's value, which balls or a fraction tell, rounded correctly."""
    decimals = column.decimals
    if column.quantity.decimals is None:
        with at_bits(ESTIMATE_BITS):
            near = value()
        if isinstance(near, Fraction):
            return given(near, decimals, rounding)
        decimals = figures(float(near)) if decimals is None else decimals
    return Number(rounded(value, known(decimals), rounding, ties), known(decimals))


def printed(asked: CellValue, rounding: str, carded: bool) -> Number | None:
    """Return the number of a column, or the error that stands beside it; of a card None if not one figure."""
    if asked.column.key.endswith(ERROR):
        return error_number(estimate(asked).error)
    return estimated(asked, rounding) if carded else settled(asked, rounding)


class Estimate(NamedTuple):
    """A value from a card and how far it may be off."""

    value: Fraction | float
    error: float


def estimate(asked: CellValue) -> Estimate:
    """Return the value from an indicator card; a fraction is exact."""
    found = asked.value()
    if isinstance(found, Fraction):
        return Estimate(found, 0.0)
    best = float(found)
    quantity, where, unit = asked.column.quantity, asked.where, asked.unit
    turns = asked.turns
    if quantity.key in KNOWN:
        return Estimate(best, FLOAT_ERROR * (abs(best) + 1))
    if quantity.minutes:
        errors = (turn.place_error(EXTREMES[quantity.of], where.stroke) for turn in turns)
        return Estimate(best, unit * 180 * sum(errors))
    if quantity.of is Of.CRANK:
        key = quantity.key.removesuffix("_n")
        of_force = sum(turn.crank_force_error(CRANK_FORCES[key], where.half_turns) for turn in turns)
        return Estimate(best, unit * _newtons(quantity, turns[0]) * of_force + FLOAT_ERROR * (abs(best) + 1))
    coarser = [
        asked._replace(turns=halves).value() for halves in zip(*(one.coarser for one in turns), strict=True)
    ]
    # A difference may vanish by chance: what the work allows and what it shows, whichever is more.
    shown = max(abs(best - float(other)) for other in coarser)
    cards = [turn.turn if quantity.of in OF_RUNS else turn for turn in turns]
    off = [unit * _sensitivity(quantity, turn, best) for turn in turns]
    allowed = sum(one * card.work_apart for one, card in zip(off, cards, strict=True))
    # What twice the points do not bring nearer to the truth is noise, half of which both have in common.
    noisy = 2 if cards[0].gain < CLEAN else 1
    written = sum(one * card.step / 2 for one, card in zip(off, cards, strict=True))
    error = noisy * max(shown, allowed) / cards[0].gain + written + FLOAT_ERROR * (abs(best) + 1)
    return Estimate(best, error)


def estimated(asked: CellValue, rounding: str) -> Number | None:
    """Return the same to as many decimals as the card supports, None if not one figure."""
    best, error = estimate(asked)
    quantity, decimals = asked.column.quantity, asked.column.decimals
    if isinstance(best, Fraction):
        return given(best, decimals, rounding)
    lost = quantity.of not in AT_ANGLE and error > abs(best)
    return None if lost else supported(best, error, decimals, rounding, quantity.minutes)


def supported(
    best: float, error: float, decimals: int | None, rounding: str, units: bool = False
) -> Number | None:
    """Return a value to as many decimals as its error leaves, of tens or hundreds too unless in `units`."""
    wanted = figures(best) if decimals is None else decimals
    places = min(wanted, floor(-log10(2 * error)))
    return None if units and places < 0 else to_place(Fraction(best), places, rounding)


def check_card(turn: Any, rounding: str) -> None:
    """Raise CardError for a card, by its turn, that supports not one figure of the mean force."""
    mean = engine_registry()["mean_force"]
    if estimated(CellValue(bare(mean, turn.method, mean.decimals), (turn,), TurnPlace()), rounding) is None:
        raise CardError(
            f"{turn.diagram.card.name}: the points are too few or scatter too much for one figure of the mean"
            " force; give a smoother card, or look for a mistyped pressure"
        )


def error_number(error: float) -> Number:
    """Return an error to two figures, rounded up."""
    if not error:
        return Number(0, 0)
    decimals = max(0, 1 - floor(log10(error)))
    return Number(ceil(error * 10**decimals), decimals)


def _sensitivity(quantity: Quantity, turn: Any, value: float) -> float:
    """How far the quantity is off where the work of a stroke is off by 1."""
    if quantity.of in OF_RUNS:
        return float(turn.sensitivity(quantity.key, value, _of_irregularity(turn.turn)))
    work, irregularity = 2 * len(turn.engine.cranks), _of_irregularity(turn)
    if quantity.of is Of.FLYWHEEL:
        return irregularity / float(turn.irregularity()) * value if quantity.key in SWINGS else 0.0
    return {"delta": irregularity, "mean_force": work}.get(quantity.key, 2 * work * _newtons(quantity, turn))


def _of_irregularity(turn: CardTurn) -> float:
    """How far δ is off there."""
    # An extreme energy 2 A - P α errs by the work twice; δ is the difference of two of them over P.
    work = 2 * len(turn.engine.cranks)
    return float((4 + 0.64 * turn.irregularity()) * work / 2 / abs(turn.mean_force()))


def _newtons(quantity: Quantity, turn: CardTurn) -> float:
    return float(quantity.scale(turn)) if quantity.scale else 1.0


def to_place(value: Fraction, decimals: int, rounding: str) -> Number | None:
    """Round to so many decimals, below 0 to tens or hundreds; None if no figure of the value is left."""
    if decimals >= 0:
        return nearest(value, decimals, rounding)
    tens = nearest(value / 10**-decimals, 0, rounding).scaled * 10**-decimals
    return Number(tens, 0) if tens else None
