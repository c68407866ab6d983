"""Floats of the formulas of the arc crank: their bounds against balls, the slide as a limit, arrays."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from kurbel.exact.kind import balls
from kurbel.kernel import kinematics
from kurbel.kernel import linkage as kernel
from kurbel.kernel.circle import circle

ANGLES = np.arange(0, 360, 2.9)
FIELDS = (kernel.chord, kernel.slide_path, kernel.rise, kernel.velocity, kernel.acceleration,
          kernel.path_half_sine, kernel.rod_velocity, kernel.rod_acceleration)  # fmt: skip
FORCES = (kernel.rod_force, kernel.rocker_force, kernel.radial_force)


def values(turn: Any, *inputs: Any) -> list[Any]:
    """Return all quantities: forces take no dead centre."""
    arc = kernel.arc(*inputs)
    place = kernel.place(kernel.from_dead_centre(turn, arc), arc)
    return [formula(place, arc) for formula in FIELDS] + [formula(place) for formula in FORCES]


def random_inputs(random: np.random.Generator, steepest: float) -> list[float]:
    """Return λ, β, η and σ of links that turn, no rod steeper on the arc than this cosine."""
    while True:
        rod, rocker, distance, height = random.integers(105, 800, 4) / 100
        circuit, side = random.choice([1, -1], 2)
        ground = math.hypot(distance, height)
        cosines = [abs(rod**2 + rocker**2 - (ground + one) ** 2) / (2 * rod * rocker) for one in (1, -1)]
        if max(cosines) <= steepest and ground > 1:
            return [1 / rod, circuit * side / rocker, side * height - circuit * side * rocker, distance - rod]


@pytest.mark.parametrize(("steepest", "bound"), [(0.7, 12), (0.95, 60)])
def test_floats_are_within_the_stated_bound(steepest: float, bound: float) -> None:
    random = np.random.default_rng(5)
    for _ in range(20):
        inputs, angles = random_inputs(random, steepest), random.uniform(0, 360, 10)
        found = values(circle(angles), *inputs)
        with flint.ctx.workprec(300):
            kind = balls()
            exact = [kind.of(Fraction(float(each))) for each in inputs]
            for row, angle in enumerate(angles):
                true = values(kind.circle(Fraction(float(angle))), *exact)
                for number, one in enumerate(true):
                    error = abs(kind.of(Fraction(float(found[number][row]))) - one)
                    ulp = math.ulp(max(abs(float(one.mid())), 1))
                    assert float(error.mid()) / ulp <= bound, f"{number} of {inputs} at {angle!r}°"


@pytest.mark.parametrize(("ratio", "offset"), [(0.2, 0.0), (0.31, 0.8), (-0.31, -0.8), (0.0, 0.4)])
@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_an_arc_without_curvature_is_the_slide(ratio: float, offset: float, shift: float) -> None:
    turn = circle(ANGLES)
    chord, path, rise, velocity, acceleration, *_ = values(turn, ratio, 0.0, offset, shift)
    for found, formula in (
        (chord, kinematics.offset_path),
        (path, kinematics.offset_path),
        (velocity, kinematics.piston_velocity),
        (acceleration, kinematics.piston_acceleration),
    ):
        slide: Any = formula(turn, ratio, offset)
        assert_allclose(found, slide, rtol=0, atol=4e-15)
    assert_allclose(rise, 0, rtol=0, atol=2e-15)


def test_arrays_give_the_bits_of_scalars() -> None:
    inputs = 2 / 7, -1 / 9, -0.2, 0.2
    by_array = values(circle(ANGLES), *inputs)
    by_angle = [values(circle(float(angle)), *inputs) for angle in ANGLES]
    assert_array_equal(by_array, np.transpose(by_angle))
