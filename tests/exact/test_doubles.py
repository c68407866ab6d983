"""Sums of two floats: every bound holds the true number, and long tables have the digits of balls."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb, fmpq

from kurbel.drive.crank import Crank
from kurbel.exact.enclosures.double import Double
from kurbel.exact.enclosures.doubles import circle, settled
from kurbel.motion import bulk
from kurbel.motion.evaluation import columns_in_balls
from kurbel.motion.quantities import registry
from kurbel.page.quantity import bare
from kurbel.reading.notation import Progression

RANDOM = np.random.default_rng(1971)
COUNT = 400


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 400
    yield
    flint.ctx.prec = before


def rational(number: Any) -> fmpq:
    exact = Fraction(number)
    return fmpq(exact.numerator, exact.denominator)


def some() -> tuple[Double, list[fmpq]]:
    """Return numbers of all sizes, of which the true ones lie at the ends of the bounds."""
    high = RANDOM.uniform(0.5, 1, COUNT) * 10.0 ** RANDOM.integers(-12, 13, COUNT)
    low = RANDOM.uniform(-0.5, 0.5, COUNT) * np.spacing(high)
    error = abs(high) * 2.0 ** -RANDOM.integers(60, 110, COUNT)
    ends = RANDOM.choice([-1, 0, 1], COUNT)
    parts = zip(high.tolist(), low.tolist(), error.tolist(), ends.tolist(), strict=True)
    true = [rational(Fraction(one) + Fraction(rest) + end * Fraction(off)) for one, rest, off, end in parts]
    return Double(high, low, error), true


def assert_holds(found: Double, true: list[Any]) -> None:
    columns = (np.broadcast_to(part, (len(true),)).tolist() for part in (found.high, found.low, found.error))
    for number, (high, low, error) in zip(true, zip(*columns, strict=True), strict=True):
        off = abs(arb(rational(high) + rational(low)) - arb(number))
        assert not off > arb(rational(error)), (high, low, error)


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


@pytest.mark.parametrize(
    ("ratio", "offset", "method", "digits", "rounding"),
    [
        ("2/9", "0", "exact", 14, "half-away"),
        ("19/20", "0", "exact", 13, "half-away"),
        ("1/5", "3/10", "exact", 15, "half-away"),
        ("1/4", "0", "series", 16, "half-even"),
        ("1/4", "0", "exact", 12, "half-away"),
    ],
)
def test_more_digits_than_floats_have_are_those_of_balls(
    ratio: str, offset: str, method: str, digits: int, rounding: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bulk, "MANY", 1)
    angles = Progression(Fraction(-30), Fraction(15, 7), 150)
    crank, keys = Crank(Fraction(ratio), offset=Fraction(offset)), ("x", "c", "p", "x_return", "p_return")
    columns = [bare(registry()[key], method, digits) for key in keys]
    assert all(bulk.suits_doubles(column, crank, angles) for column in columns)
    balls = columns_in_balls(columns, crank, angles, rounding)
    asked: list[int] = []
    in_balls = bulk.Sharp._in_balls

    def counted(sharp: bulk.Sharp, column: Any, row: int) -> int:
        asked.append(row)
        return in_balls(sharp, column, row)

    monkeypatch.setattr(bulk.Sharp, "_in_balls", counted)
    sharp = bulk.columns_in_floats(columns, crank, angles, rounding)
    assert [column.tolist() for column in sharp] == balls
    # Exact values alone, at whole multiples of 30 degrees, are left to balls.
    assert {angles[row] % 30 for row in asked} <= {0}
