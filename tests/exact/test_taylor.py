"""Power series with bounds: against the functions themselves, in mpmath and by flint's integrals."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import flint
import pytest
from flint import arb
from mpmath import mp, mpf

from kurbel.exact.certify import ball
from kurbel.exact.search import crossing
from kurbel.exact.taylor import ComplexNumber, Taylor, bounded, expanded, half_turn_circle

LOW, HIGH = Fraction(3, 10), Fraction(2, 5)
PLACES = [LOW, Fraction(31, 100), Fraction(7, 20), HIGH]
RADII = 4


def rod(place: ComplexNumber) -> ComplexNumber:
    """√(1 - λ² sin² φ) and a logarithm, as steam has them."""
    return (1 - half_turn_circle(place).sine ** 2 / 9) ** 0.5 + (place + Fraction(1, 5)).log() * place


def true_rod(place: Any) -> Any:
    return mp.sqrt(1 - mp.sin(mp.pi * place) ** 2 / 9) + mp.log(place + mpf(1) / 5) * place


def series(function: Callable[[ComplexNumber], ComplexNumber], bits: int) -> Taylor:
    bound = bounded(function, LOW, HIGH, RADII, 1e6)
    assert bound is not None
    with flint.ctx.workprec(bits):
        return expanded(function, LOW, HIGH, RADII, bound)


def encloses(found: arb, true: Any, bits: int) -> None:
    low, high = (mpf(int(end.fmpq().p)) / int(end.fmpq().q) for end in (found.lower(), found.upper()))
    assert low <= true <= high
    assert high - low < mpf(2) ** (20 - bits)


@pytest.mark.parametrize("bits", [64, 200])
@pytest.mark.parametrize("order", [0, 1, 2])
def test_series_and_its_slopes_are_enclosed_closely(bits: int, order: int) -> None:
    with flint.ctx.workprec(bits), mp.workprec(bits + 200):
        found = series(rod, bits)
        halved = found.about(Fraction(3, 8))
        for place in PLACES:
            true = mp.diff(true_rod, mpf(place.numerator) / place.denominator, order)
            encloses(found.at(ball(place), order), true, bits - 12 * order)
            if place >= found.middle:
                encloses(halved.at(ball(place), order), true, bits - 12 * order)


@pytest.mark.parametrize("exponent", [Fraction(1, 2), Fraction(-1)])
def test_power_integral_lag_and_quotient_are_enclosed_closely(exponent: Fraction) -> None:
    bits = 128
    found = series(rod, bits)
    with flint.ctx.workprec(bits), mp.workprec(300):
        middle, raised = mpf(7) / 20, mpf(exponent.numerator) / exponent.denominator
        power, share = found.power(exponent), (found / series(lambda place: place + 1, bits))
        inverse = share.power(-exponent)
        assert power is not None and inverse is not None
        lag = power.lagging(ball(3), ball(2))
        for place in PLACES:
            at = mpf(place.numerator) / place.denominator
            encloses(power.at(ball(place)), true_rod(at) ** raised, bits)
            true = mp.quad(lambda x: true_rod(x) ** raised, [middle, at])
            encloses(power.sum().at(ball(place)), true, bits)
            true = mp.quad(lambda x: 3 * true_rod(x) ** raised * mp.exp(3 * (x - middle)), [middle, at])
            encloses(lag.at(ball(place)), (2 - true) * mp.exp(3 * (middle - at)), bits)
            encloses(inverse.at(ball(place)), (true_rod(at) / (at + 1)) ** -raised, bits)
            for order in range(3):
                true = mp.diff(lambda x: true_rod(x) / (x + 1), at, order)
                encloses(share.at(ball(place), order), true, bits - 12 * order)


def test_what_is_left_out_is_not_small_where_few_terms_are_kept() -> None:
    whole = series(lambda place: 1 / (place + Fraction(1, 2)), 64)
    short = replace(whole, terms=whole.terms.truncate(12), length=12)
    with flint.ctx.workprec(64):
        true, middle = 1 / (ball(HIGH) + 0.5), ball(whole.middle)
        power = short.power(Fraction(-1, 2))
        assert power is not None
        for found, at in (
            (short, true),
            (short.about(Fraction(37, 100)), true),
            (short + short, 2 * true),
            (short * short, true * true),
            (short / whole, arb(1)),
            (short.sum(), (1 / true / (middle + 0.5)).log()),
            (power, 1 / true.sqrt()),
        ):
            assert found.at(ball(HIGH)).contains(at)
            assert not arb(found.at(ball(HIGH)).mid()).overlaps(at)


def test_no_series_about_a_pole_and_no_root_of_what_may_vanish() -> None:
    assert bounded(lambda place: 1 / (place - Fraction(1, 4)), LOW, HIGH, RADII, 1e6) is None
    assert series(lambda place: place - Fraction(3, 10), 64).power(Fraction(-1, 2)) is None


@pytest.mark.parametrize("bits", [64, 128, 400])
def test_a_crossing_is_enclosed_to_the_last_bits(bits: int) -> None:
    with flint.ctx.workprec(bits), mp.workprec(bits + 40):
        found = crossing(lambda x: x * x * x - 2, Fraction(5, 4), Fraction(4, 3))
        encloses(found, mp.cbrt(2), bits)
        # Far from straight.
        found = crossing(lambda x: (40 * x).exp() - 2, Fraction(-1), Fraction(1, 2))
        encloses(found, mp.log(2) / 40, bits)


def test_a_crossing_of_balls_stays_within_what_they_tell() -> None:
    with flint.ctx.workprec(128):
        found = crossing(lambda x: x - 1 + arb(0, 1e-9), Fraction(1, 2), Fraction(2))
        assert found.contains(1)
        assert 1e-9 < found.rad() < 1e-7
