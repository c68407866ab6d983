"""The digits of a harmonic: certified in balls, or as many as an indicator card supports."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import degrees, hypot
from typing import TYPE_CHECKING, cast

import flint

from kurbel.balancing.arrangement import Residual
from kurbel.balancing.harmonics_page import EXACT_ZERO
from kurbel.balancing.lengths import LENGTHS, certified_length
from kurbel.engine.digits import CLEAN, ESTIMATE_BITS, FLOAT_ERROR, Estimate, supported
from kurbel.engine.harmonics.fourier import PARTS, Floats, Spectrum, Wave
from kurbel.engine.harmonics.quantities import PHASES, SPEED, STAR, At, star, value
from kurbel.exact.certify import NEVER_TIES, rounded
from kurbel.exact.numerals import Number, figures, given
from kurbel.exact.precision import at_bits
from kurbel.kernel.balance import Star
from kurbel.page.quantity import Column

if TYPE_CHECKING:
    from kurbel.engine.card.turn import CardTurn

# Steps of orders beside one at which the cards' differences are looked at: one alone may vanish by chance.
BESIDE = (-1, 0, 1)


def number_of(column: Column, at: At, rounding: str) -> Number | None:
    """Return the printed number; None of the phase of nothing."""
    needs, is_phase = column.quantity.needs, column.quantity.key in PHASES
    if needs == STAR:
        return _star(at, column.places, rounding)
    if needs != SPEED:
        if at.wave is None:
            return None if is_phase else EXACT_ZERO
        if is_phase and all(one == 0 for one in at.wave):
            return None
        if isinstance(at.spectrum, Floats):
            best, error = estimate(column, at)
            return supported(best, error, column.places, rounding, is_phase)
    return _certified(column, at, rounding)


def _certified(column: Column, at: At, rounding: str) -> Number:
    decimals, quantity = column.decimals, column.quantity
    if decimals is None:
        with at_bits(ESTIMATE_BITS):
            near = value(quantity, at)
        if isinstance(near, Fraction):
            return given(near, None, rounding)
        decimals = figures(float(near))
    return Number(
        rounded(lambda: flint.arb(1) * value(quantity, at), decimals, rounding, NEVER_TIES), decimals
    )


def _star(at: At, decimals: int, rounding: str) -> Number:
    length, residual = LENGTHS["forward"], Residual(star(at), Star())
    if length.vanishes(residual):
        return EXACT_ZERO
    return certified_length(length, residual, decimals, rounding=rounding)


def estimate(column: Column, at: At) -> Estimate:
    """Return a value from a card and how far it may be off."""
    turn, best = cast("CardTurn", at.turn), float(value(column.quantity, at))
    off = _off(at, turn)
    if column.quantity.key in PHASES:
        wave = at.wave or Wave(0.0, 0.0)
        away = off / max(hypot(*wave), off)
        return Estimate(best, degrees(away) if column.quantity.key == "phase" else away)
    unit = float(column.quantity.scale(turn)) if column.quantity.scale else 1.0
    return Estimate(best, unit * off + FLOAT_ERROR * (abs(best) + 1))


def _off(at: At, turn: CardTurn) -> float:
    """How far the harmonic, as a vector, may be off in Q."""
    shown = max(_apart(at, half, turn) for half in turn.coarser)
    # What twice the points do not bring nearer to the truth is noise, half of which both have in common.
    noisy = 2 if turn.gain < CLEAN else 1
    cranks = sum(len(part.starts) for part in turn.engine.parts) if at.member.part is None else 1
    summed = _between(at, Floats(turn, PARTS // 2))
    return noisy * shown / turn.gain + turn.step * cranks + summed


def _apart(at: At, half: CardTurn, turn: CardTurn) -> float:
    """How far the coarser card's harmonics are away, at this order and those beside it."""
    step, other = Fraction(2, turn.cycle), _spectrum(half)
    orders = [order for index in BESIDE if (order := at.order + index * step) > 0]
    return max(_between(at._replace(order=order), other) for order in orders)


def _between(at: At, other: Spectrum) -> float:
    """How far another spectrum's harmonic is away."""
    one, two = at.wave, at._replace(spectrum=other).wave
    return hypot(one.cosine - two.cosine, one.sine - two.sine) if one and two else 0.0


@lru_cache(maxsize=16)
def _spectrum(turn: CardTurn) -> Floats:
    return Floats(turn)
