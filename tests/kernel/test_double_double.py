"""Ten million angles: how far floats lie from the true values, by sums of two floats, which balls prove."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import double_double
import flint
import numpy as np
import pytest
from flint import arb, fmpq
from numpy.typing import NDArray

from kurbel.motion.arrays import motion

Floats = NDArray[np.float64]
RANDOM = np.random.default_rng(1907)
BLOCK = 1 << 16
# Units in the last place, of p and the radial force counted in no number below 1: kernel/kinematics.py,
# kernel/circle.py and kernel/forces.py up to R:L = 1:3.
BOUNDS = {
    "x": 1.6,
    "c": 1.8,
    "p": 2.0,
    "psi": 1.0,
    "rod_force": 1.5,
    "guide_force": 1.5,
    "tangential_force": 1.8,
    "radial_force": 2.0,
}
LEAST = {"p": 1.0, "radial_force": 1.0}


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 300
    yield
    flint.ctx.prec = before


def rational(number: float) -> fmpq:
    exact = Fraction(float(number))
    return fmpq(exact.numerator, exact.denominator)


def in_balls(degrees: float, ratio: float) -> dict[str, Any]:
    """Return the textbook formulas at an angle, by the law of sines."""
    turn, slope = rational(degrees) / 180, arb(rational(ratio))
    sine, cosine = arb.sin_pi_fmpq(turn), arb.cos_pi_fmpq(turn)
    psi = (slope * sine).asin()
    return {
        "x": 2 * arb.sin_pi_fmpq(turn / 2) ** 2 + 2 * (psi / 2).sin() ** 2 / slope,
        "c": sine + cosine * psi.tan(),
        "p": cosine - sine * psi.tan() + slope * cosine**2 / psi.cos() ** 3,
        "psi": psi * 180 / arb.pi(),
        "rod_force": 1 / psi.cos(),
        "guide_force": psi.tan(),
        "radial_force": cosine - sine * psi.tan(),
    }


def test_sums_of_two_floats_are_true_to_ninety_bits() -> None:
    degrees = np.concatenate(
        [
            RANDOM.uniform(0, 360, 200),
            RANDOM.uniform(-1e4, 1e4, 50),
            10.0 ** -RANDOM.uniform(0, 8, 50),
            180 - 10.0 ** -RANDOM.uniform(0, 8, 50),
        ]
    )
    ratios = RANDOM.uniform(-0.6, 0.6, len(degrees))
    found = double_double.motion(degrees, ratios)
    assert {*found} == {*BOUNDS} - {"tangential_force"}
    for place, (angle, ratio) in enumerate(zip(degrees.tolist(), ratios.tolist(), strict=True)):
        for key, true in in_balls(angle, ratio).items():
            number = found[key]
            value = arb(float(number.high[place])) + arb(float(number.low[place]))
            least = LEAST.get(key, abs(float(true.mid())))
            assert abs(float((value - true).mid())) < 2.0**-90 * least, (key, angle, ratio)


@pytest.mark.slow
def test_ten_million_values_are_within_two_units_of_the_last_place() -> None:
    # Half of them in order, as a table has them; each angle has a ratio of its own.
    degrees = np.concatenate([np.linspace(0, 360, 5_000_000), RANDOM.uniform(0, 360, 5_000_000)])
    ratios = RANDOM.uniform(0, 1 / 3, len(degrees))
    for sign, part in ((1, slice(None)), (-1, slice(None, None, 5))):
        keys = [key if sign > 0 else f"{key}_return" for key in BOUNDS]
        values = motion(keys, degrees[part], ratios[part], fast=True)
        for fast, plain in zip(values, motion(keys, degrees[part], ratios[part], fast=False), strict=True):
            assert (fast.view(np.int64) == plain.view(np.int64)).all()
        worst = worst_ulps(values, degrees[part], sign * ratios[part])
        for key, bound in BOUNDS.items():
            assert worst[key] <= bound, f"{key} is {worst[key]:.2f} units in the last place off"


def worst_ulps(values: list[Floats], degrees: Floats, ratios: Floats) -> dict[str, float]:
    worst = dict.fromkeys(BOUNDS, 0.0)
    for start in range(0, len(degrees), BLOCK):
        block = slice(start, start + BLOCK)
        true = double_double.motion(degrees[block], ratios[block])
        true = {**true, "tangential_force": true["c"]}
        for key, column in zip(BOUNDS, values, strict=True):
            off = double_double.ulps(column[block], true[key], LEAST.get(key, 0.0))
            worst[key] = max(worst[key], float(off.max()))
    return worst
