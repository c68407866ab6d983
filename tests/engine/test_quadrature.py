"""Integrals of one function with many waves: against those that flint encloses one by one."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import flint
import pytest
from flint import acb, arb

from kurbel.engine.fourier import sampled
from kurbel.exact.certify import ball

MOST = Fraction(100)


def root(number: Any) -> Any:
    return number.sqrt(analytic=True) if isinstance(number, acb) else number.nonnegative_part().sqrt()


def near_poles(place: Any) -> Any:
    return 1 / ((place - 1) * (place - 1) + 1e-4)


def near_branch_points(place: Any) -> Any:
    """As the rod nearly as short as the crank has it."""
    return place * root(1 + 1e-6 - place * place)


def nothing(place: Any) -> Any:
    return 0 * place


@pytest.mark.parametrize("bits", [32, 64, 192])
@pytest.mark.parametrize("half_turns", [Fraction(1, 2), Fraction(7), MOST])
@pytest.mark.parametrize("function", [near_poles, near_branch_points, nothing])
def test_the_integral_with_a_wave_is_enclosed_closely(
    function: Callable[[Any], Any], half_turns: Fraction, bits: int
) -> None:
    with flint.ctx.workprec(bits):
        cosine, sine = sampled(function, function, Fraction(0), Fraction(1), MOST).with_wave(half_turns)
    with flint.ctx.workprec(256):
        turns = acb(0, ball(half_turns) * arb.pi())
        true = acb.integral(lambda place, analytic: function(place) * (turns * place).exp(), 0, 1)
        assert true.rad() < 1e-60
        assert cosine.overlaps(true.real)
        assert sine.overlaps(true.imag)
        assert max(cosine.rad(), sine.rad()) < arb(2) ** (20 - bits)


def test_where_no_formula_is_analytic_at_an_end_the_integral_is_enclosed_all_the_same() -> None:
    with flint.ctx.workprec(96):
        cosine, sine = sampled(root, root, Fraction(0), Fraction(1), MOST).with_wave(Fraction(7))
    with flint.ctx.workprec(256):
        turns = acb(0, 7 * arb.pi())
        # With x = t².
        true = acb.integral(lambda t, analytic: 2 * t * t * (turns * t * t).exp(), 0, 1)
        assert cosine.overlaps(true.real)
        assert sine.overlaps(true.imag)
        assert max(cosine.rad(), sine.rad()) < 1e-20
