"""The circle of crank angles: accuracy against balls of 300 bits, exact values, the way back."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb, fmpq
from numpy.typing import NDArray

from kurbel.kernel.circle import arcsine, circle, root

RANDOM = np.random.default_rng(1905)


def rational(number: float) -> fmpq:
    exact = Fraction(float(number))
    return fmpq(exact.numerator, exact.denominator)


def ulps(value: float, true: arb) -> float:
    """Return how many units in the last place of the true value lie between the two."""
    return float(abs(arb(value) - true).mid()) / math.ulp(abs(float(true.mid())))


def sampled_angles() -> NDArray[np.float64]:
    beside = [
        centre + side * 10.0**-power
        for centre in (0, 90, 180, 270, 360)
        for side in (1, -1)
        for power in range(0, 13)
    ]
    return np.concatenate(
        [
            np.arange(0, 361.0),
            RANDOM.uniform(0, 360, 3000),
            RANDOM.uniform(40, 60, 2000),
            RANDOM.uniform(-720, 1080, 500),
            10.0 ** -RANDOM.uniform(0, 135, 500),
            beside,
        ]
    )


@pytest.fixture(autouse=True)
def precision() -> Any:
    with flint.ctx.workprec(300):
        yield


TRUE: dict[str, Callable[[Any], Any]] = {
    "sine": arb.sin_pi_fmpq,
    "cosine": arb.cos_pi_fmpq,
    "versine": lambda turn: 2 * arb.sin_pi_fmpq(turn / 2) * arb.sin_pi_fmpq(turn / 2),
}


@pytest.mark.parametrize(("name", "bound"), [("sine", 0.57), ("cosine", 0.57), ("versine", 0.7)])
def test_every_value_is_within_its_bound_of_the_true_one(name: str, bound: float) -> None:
    angles = sampled_angles()
    values = getattr(circle(angles), name)
    true = TRUE[name]
    errors = [
        ulps(value, true(rational(angle) / 180))
        for angle, value in zip(angles, values, strict=True)
        if value or angle % 90
    ]
    worst = int(np.argmax(errors))
    assert errors[worst] <= bound, f"{name} of {angles[worst]!r}° is {errors[worst]:.2f} ulp off"


def test_tails_are_what_rounding_took() -> None:
    for angle in RANDOM.uniform(0, 360, 500):
        point = circle(float(angle))
        turn = rational(angle) / 180
        sine = arb(point.sine) + arb(point.sine_tail)
        versine = arb(point.versine) + arb(point.versine_tail)
        assert abs(sine - arb.sin_pi_fmpq(turn)) < 2.0**-55
        assert abs(versine - 1 + arb.cos_pi_fmpq(turn)) < 2.0**-54


def test_versine_keeps_its_digits_down_to_the_smallest_angles() -> None:
    for angle in (1e-3, 3e-8, 7e-30, 5e-138):
        true = 2 * arb.sin_pi_fmpq(rational(angle) / 360) ** 2
        assert ulps(circle(angle).versine, true) <= 0.7
    assert circle(1e-300).sine == pytest.approx(1e-300 * math.pi / 180, rel=1e-15, abs=0)


# Degrees, sine, cosine: what a compositor sets without computing.
EXACT = [
    (0, 0, 1),
    (30, 0.5, None),
    (60, None, 0.5),
    (90, 1, 0),
    (120, None, -0.5),
    (150, 0.5, None),
    (180, 0, -1),
    (210, -0.5, None),
    (240, None, -0.5),
    (270, -1, 0),
    (300, None, 0.5),
    (330, -0.5, None),
    (360, 0, 1),
    (-60, None, 0.5),
    (720, 0, 1),
]


@pytest.mark.parametrize(("degrees", "sine", "cosine"), EXACT)
def test_whole_and_half_values_are_exact(degrees: int, sine: float | None, cosine: float | None) -> None:
    point = circle(degrees)
    assert sine is None or point.sine == sine
    assert cosine is None or (point.cosine == cosine and point.versine == 1 - cosine)


def test_sine_and_cosine_are_equal_at_45_degrees() -> None:
    point = circle(45.0)
    assert point.sine == point.cosine == -circle(135.0).cosine == -circle(225.0).sine


def test_no_zero_has_a_sign() -> None:
    angles = np.array([-360, -180, -90, -0.0, 0, 90, 180, 270, 360], dtype=float)
    for values in circle(angles):
        assert not np.signbit(np.asarray(values)[np.asarray(values) == 0]).any()
    for angle in angles:
        assert all(math.copysign(1, value) == 1 for value in circle(float(angle)) if value == 0)


def test_arrays_give_the_bits_of_scalars() -> None:
    angles = sampled_angles()
    points = np.array([circle(float(angle)) for angle in angles]).T
    np.testing.assert_array_equal(np.array(circle(angles)), points)


def test_a_block_in_one_quarter_gives_the_bits_of_mixed_ones() -> None:
    angles = RANDOM.uniform(0, 360, 1000)
    mixed = np.array(circle(angles))
    for quarter in range(5):
        chosen = np.rint(angles / 90) == quarter
        np.testing.assert_array_equal(np.array(circle(angles[chosen])), mixed[:, chosen])


def test_the_shape_of_the_angles_is_kept() -> None:
    assert circle(np.zeros((2, 3))).sine.shape == (2, 3)
    assert circle(np.zeros(0)).versine.shape == (0,)


def test_arcsine_is_within_its_bound_of_the_true_angle() -> None:
    sines = np.concatenate(
        [
            RANDOM.uniform(-1, 1, 2000),
            1 - 10.0 ** -RANDOM.uniform(0, 15, 300),
            10.0 ** -RANDOM.uniform(0, 30, 300),
        ]
    )
    errors = [
        ulps(angle, arb(sine).asin() * 180 / arb.pi())
        for sine, angle in zip(sines, arcsine(sines), strict=True)
    ]
    worst = int(np.argmax(errors))
    assert errors[worst] <= 0.6, f"arcsine of {sines[worst]!r} is {errors[worst]:.2f} ulp off"


def test_arcsine_of_an_array_gives_the_bits_of_scalars() -> None:
    sines = RANDOM.uniform(-1, 1, 5000)
    np.testing.assert_array_equal(arcsine(sines), [arcsine(float(sine)) for sine in sines])


@pytest.mark.parametrize(
    ("sine", "degrees"), [(0.0, 0), (-0.0, 0), (0.5, 30), (-0.5, -30), (1.0, 90), (-1.0, -90)]
)
def test_arcsine_is_exact_where_the_angle_is_whole(sine: float, degrees: int) -> None:
    assert arcsine(sine) == degrees == arcsine(np.array([sine]))[0]
    assert math.copysign(1, arcsine(sine)) == (-1 if degrees < 0 else 1)


def test_root_gives_the_same_bits_for_floats_and_arrays() -> None:
    numbers = RANDOM.uniform(0, 1, 20000)
    np.testing.assert_array_equal(root(numbers), [root(float(number)) for number in numbers])
