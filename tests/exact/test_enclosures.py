"""Floats and sums of two with bounds: the true number of flint's balls lies within, whatever is asked."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb, fmpq

from kurbel.exact.doubles import Double, circle, settled
from kurbel.exact.enclosure import PI, UNIT, Enclosure, arc, half_turn_circle

SIZE = 400
# No bound is so wide that floats would be of no use: the true error takes up a tenth of it somewhere.
LEAST_SHARE = 0.1


def spread(low: float, high: float, error: float = 0.0, seed: int = 1) -> Enclosure:
    """Return numbers of which the true ones lie at the ends of the bounds."""
    value = np.random.default_rng(seed).uniform(low, high, SIZE)
    return Enclosure(value, np.full(SIZE, error))


def ends(number: Enclosure, of: Callable[[arb], Any]) -> list[Any]:
    """Return what balls make of the true numbers, which lie at the upper and the lower end in turn."""
    with flint.ctx.workprec(200):
        signs = [1 if row % 2 else -1 for row in range(SIZE)]
        places = zip(number.value, number.error, signs, strict=True)
        return [of(arb(float(value)) + sign * arb(float(error))) for value, error, sign in places]


def share(found: Enclosure, true: list[Any]) -> float:
    """Return the greatest share of the bound that the error takes up."""
    with flint.ctx.workprec(200):
        return max(
            float(abs(arb(float(value)) - one).upper()) / float(error)
            for value, error, one in zip(found.value, found.error, true, strict=True)
        )


FUNCTIONS: dict[str, tuple[Callable[[Enclosure], Enclosure], Callable[[arb], Any], float, float]] = {
    "sine": (lambda one: half_turn_circle(one).sine, lambda one: one.sin_pi(), -7, 7),
    "cosine": (lambda one: half_turn_circle(one).cosine, lambda one: one.cos_pi(), -7, 7),
    "versine": (lambda one: half_turn_circle(one).versine, lambda one: 1 - one.cos_pi(), -7, 7),
    "logarithm": (lambda one: one.log(), lambda one: one.log(), 0.001, 40),
    "logarithm beside 1": (lambda one: one.log(), lambda one: one.log(), 0.99, 1.01),
    "power": (lambda one: one ** Enclosure.of(1.25), lambda one: (one.log() * arb(1.25)).exp(), 0.02, 40),
    "steep power": (lambda one: one ** Enclosure.of(-9.5), lambda one: (one.log() * arb(-9.5)).exp(), 0.5, 3),
    "arc": (lambda one: arc(one), lambda one: one.asin() * 180 / arb.pi(), -0.999, 0.999),
    "root": (lambda one: one**0.5, lambda one: one.sqrt(), 0.01, 9),
    "quotient": (lambda one: (one - 3) / (one * one + one), lambda one: (one - 3) / (one * one + one), 1, 9),
    "cube": (lambda one: 2 - one**3 * Fraction(1, 7), lambda one: 2 - one * one * one / 7, -2, 2),
    "magnitude": (abs, abs, -2, 2),
}  # fmt: skip


@pytest.mark.parametrize("error", [0.0, 1e-13, 1e-4])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_true_number_lies_within_the_bound(name: str, error: float) -> None:
    function, ball, low, high = FUNCTIONS[name]
    given = spread(low, high, error)
    found = share(function(given), ends(given, ball)) if error or name != "magnitude" else 1.0
    assert LEAST_SHARE < found <= 1


def test_at_a_corner_the_larger_number_is_as_near_as_both() -> None:
    one, other = spread(-1, 1, 0.5), spread(-1, 1, 0.25, seed=2)
    true = [max(a, b) for a, b in zip(ends(one, float), ends(other, float), strict=True)]
    found = one.max(other)
    assert (abs(found.value - np.array(true)) <= found.error).all()
    assert (found.error <= 0.5).all()


def test_a_piece_is_the_one_on_which_the_number_lies_or_both() -> None:
    at = Enclosure(np.array([0.2, 0.5 - 1e-9, 0.5, 0.5 + 1e-9, 0.7]), np.full(5, 1e-6))
    found = at.piecewise((Enclosure.of(0.5),), (Enclosure.of(3), Enclosure.of(4.0)))
    assert found.error[[0, 4]].max() < 1e-9
    assert found.value[[0, 4]].tolist() == [3, 4]
    for row in (1, 2, 3):
        assert found.value[row] - found.error[row] <= 3 < 4 <= found.value[row] + found.error[row]


def test_nothing_is_known_beyond_a_pole_or_an_end() -> None:
    about_nothing = Enclosure(np.array([0.0, 1e-9, -1e-9]), np.full(3, 1e-6))
    with np.errstate(all="ignore"):
        for found in (1 / about_nothing, about_nothing.log(), arc(1 - about_nothing)):
            assert not np.isfinite(found.error).any()
        # A square is 0 at least.
        assert (about_nothing.root().error >= 0.001 - 1e-9).all()


def test_exact_numbers_have_no_error_and_others_half_a_place() -> None:
    assert Enclosure.of(Fraction(3, 8)).error == Enclosure.of(7).error == 0
    tenth = Enclosure.of(Fraction(1, 10))
    assert abs(Fraction(tenth.value) - Fraction(1, 10)) <= Fraction(tenth.error) <= Fraction(UNIT) / 5
    with flint.ctx.workprec(200):
        assert abs(arb(float(PI.value)) - arb.pi()) < arb(float(PI.error))


# Sums of two floats.

RANDOM = np.random.default_rng(1971)


def rational(number: Any) -> fmpq:
    exact = Fraction(number)
    return fmpq(exact.numerator, exact.denominator)


def some() -> tuple[Double, list[fmpq]]:
    """Return numbers of all sizes, of which the true ones lie at the ends of the bounds."""
    high = RANDOM.uniform(0.5, 1, SIZE) * 10.0 ** RANDOM.integers(-12, 13, SIZE)
    low = RANDOM.uniform(-0.5, 0.5, SIZE) * np.spacing(high)
    error = abs(high) * 2.0 ** -RANDOM.integers(60, 110, SIZE)
    ends = RANDOM.choice([-1, 0, 1], SIZE)
    parts = zip(high.tolist(), low.tolist(), error.tolist(), ends.tolist(), strict=True)
    true = [rational(Fraction(one) + Fraction(rest) + end * Fraction(off)) for one, rest, off, end in parts]
    return Double(high, low, error), true


def assert_holds(found: Double, true: list[Any]) -> None:
    columns = (np.broadcast_to(part, (len(true),)).tolist() for part in (found.high, found.low, found.error))
    for number, (high, low, error) in zip(true, zip(*columns, strict=True), strict=True):
        off = abs(arb(rational(high) + rational(low)) - arb(number))
        assert not off > arb(rational(error)), (high, low, error)


@flint.ctx.workprec(400)
def test_the_bound_of_every_operation_holds_the_true_number() -> None:
    (one, ones), (other, others) = some(), some()
    pairs = [*zip(ones, others, strict=True)]
    assert_holds(one + other, [a + b for a, b in pairs])
    assert_holds(one * other, [a * b for a, b in pairs])
    assert_holds(one / other, [a / b for a, b in pairs])
    assert_holds(one**0.5, [arb(a).sqrt() for a in ones])
    # What is nearly alike takes digits away.
    near = Double(one.high * (1 + 2.0**-30), one.low, one.error * 0)
    sums = zip(near.high.tolist(), near.low.tolist(), strict=True)
    exact = [rational(Fraction(high) + Fraction(low)) for high, low in sums]
    # The low of the first is not below its last place any more.
    near = near + 0
    assert_holds(near - one, [b - a for a, b in zip(ones, exact, strict=True)])
    assert_holds(near * one - one * one, [a * b - a * a for a, b in zip(ones, exact, strict=True)])


@flint.ctx.workprec(400)
def test_the_circle_of_exact_angles_has_a_hundred_bits() -> None:
    numerators = np.concatenate([RANDOM.integers(-5040000, 5040000, 300), np.arange(-7, 8) * 315])
    found = circle(numerators, 7)
    turns = [fmpq(int(one), 7 * 180) for one in numerators]
    assert_holds(found.sine, [arb.sin_pi_fmpq(one) for one in turns])
    assert_holds(found.cosine, [arb.cos_pi_fmpq(one) for one in turns])
    assert_holds(found.versine, [2 * arb.sin_pi_fmpq(one / 2) ** 2 for one in turns])
    for part in (found.sine, found.cosine, found.versine):
        assert float(np.asarray(part.error).max()) < 2.0**-98


def test_a_cell_whose_bound_holds_a_boundary_is_asked_for() -> None:
    error = np.array([2e-16, 1e-24, 1e-24, 0.0, np.inf])
    found = Double(np.array([1.25, 1.25, 1.25, 1e40, 1.0]), np.array([1e-16, 1e-16, -1e-16, 0.0, 0.0]), error)
    asked: list[int] = []

    def exactly(row: int) -> int:
        asked.append(row)
        return 77

    assert settled(found, 5, 1, exactly).tolist() == [77, 13, 12, 77, 77]
    assert asked == [0, 3, 4]
