"""A hundred thousand numbers of arrays: how far they lie from the true ones, which balls enclose."""

from __future__ import annotations

import math
from fractions import Fraction

import flint
import numpy as np
from flint import arb, fmpq

import kurbel

RANDOM = np.random.default_rng(1907)
# Units in the last place, of p and the radial force counted in no number below 1: kernel/kinematics.py,
# kernel/circle.py and kernel/forces.py up to R:L = 1:3.
BOUNDS = {
    "x": 1.6, "c": 1.8, "p": 2.0, "psi": 1.0,
    "rod_force": 1.5, "guide_force": 1.5, "tangential_force": 1.8, "radial_force": 2.0,
}  # fmt: skip
LEAST = {"p": 1.0, "radial_force": 1.0}


def rational(number: float) -> fmpq:
    return fmpq(*number.as_integer_ratio())


def in_balls(degrees: float, ratio: arb) -> dict[str, arb]:
    """Return the textbook formulas at an angle, by the law of sines."""
    sine, cosine = arb.sin_cos_pi_fmpq(rational(degrees) / 180)
    psi = (ratio * sine).asin()
    half, tangent, secant = (psi / 2).sin(), psi.tan(), 1 / psi.cos()
    velocity = sine + cosine * tangent
    return {
        "x": 2 * arb.sin_pi_fmpq(rational(degrees) / 360) ** 2 + 2 * half**2 / ratio,
        "c": velocity,
        "p": cosine - sine * tangent + ratio * cosine**2 * secant**3,
        "psi": psi * 180 / arb.pi(),
        "rod_force": secant,
        "guide_force": tangent,
        "tangential_force": velocity,
        "radial_force": cosine - sine * tangent,
    }


def test_a_hundred_thousand_values_are_within_two_units_of_the_last_place() -> None:
    worst = dict.fromkeys(BOUNDS, 0.0)
    for ratio in RANDOM.uniform(0.001, 1 / 3, 40).tolist():
        # In order, at random, and beside the dead centres.
        near = 10.0 ** -RANDOM.uniform(0, 8, 20)
        degrees = np.concatenate([RANDOM.uniform(-720, 720, 292), near, 180 - near])
        # A return is the outstroke with the rod on the other side: φ + 180°, of which x counts from there.
        for sign, end in ((1, ""), (-1, "_return")):
            keys = [f"{key}{end}" for key in BOUNDS]
            found = kurbel.compute(degrees, Fraction(ratio), ",".join(keys))
            columns = [np.asarray(found[key]).tolist() for key in keys]
            with flint.ctx.workprec(150):
                slope = arb(rational(ratio)) * sign
                for place, angle in enumerate(degrees.tolist()):
                    if sign < 0 and place % 5:
                        continue
                    for (key, true), column in zip(in_balls(angle, slope).items(), columns, strict=True):
                        unit = math.ulp(max(abs(float(true.mid())), LEAST.get(key, 0.0)))
                        off = float(abs(arb(column[place]) - true).mid()) / unit
                        worst[key] = max(worst[key], off)
    assert {key: off for key, off in worst.items() if off > BOUNDS[key]} == {}
    # Bounds that say much more than is true say nothing.
    assert all(off > BOUNDS[key] / 3 for key, off in worst.items()), worst
