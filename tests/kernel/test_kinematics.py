"""Kinematics: accuracy against the textbook in balls of 300 bits, and what must hold for any crank."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb, fmpq
from numpy.typing import NDArray

from kurbel.exact import bulk
from kurbel.kernel import kinematics
from kurbel.kernel.circle import circle, rod_angle

Ball = Any
Textbook = Callable[[Ball, Ball, Ball], Ball]


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with flint.ctx.workprec(300):
        yield


def ball(number: float) -> Ball:
    exact = Fraction(float(number))
    return arb(fmpq(exact.numerator, exact.denominator))


def textbook_path(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    """x from the outermost position of the crosshead, all lengths in R; the rod is 1/λ long."""
    rod = 1 / ratio
    crosshead = phi.cos() + (rod**2 - (phi.sin() - offset) ** 2).sqrt()
    return ((rod + 1) ** 2 - offset**2).sqrt() - crosshead


def textbook_velocity(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    psi = (ratio * (phi.sin() - offset)).asin()
    return (phi + psi).sin() / psi.cos()


def textbook_acceleration(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    psi = (ratio * (phi.sin() - offset)).asin()
    return phi.cos() - phi.sin() * psi.tan() + ratio * phi.cos() ** 2 / psi.cos() ** 3


def textbook_rod_angle(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    return (ratio * (phi.sin() - offset)).asin() * 180 / arb.pi()


def textbook_rod_velocity(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    """By the velocity of the pin across the slide, which the rod's slope takes: L ψ̇ cos ψ = R cos φ."""
    return ratio * phi.cos() / (ratio * (phi.sin() - offset)).asin().cos()


def textbook_rod_acceleration(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    """By the acceleration of the pin across the slide: L (ψ̈ cos ψ - ψ̇² sin ψ) = -R sin φ."""
    psi = (ratio * (phi.sin() - offset)).asin()
    velocity = textbook_rod_velocity(phi, ratio, offset)
    return (velocity**2 * psi.sin() - ratio * phi.sin()) / psi.cos()


def blau_path(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    return 1 - phi.cos() + ratio * phi.sin() ** 2 / 2


def blau_velocity(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    return phi.sin() + ratio * (2 * phi).sin() / 2


def blau_acceleration(phi: Ball, ratio: Ball, offset: Ball) -> Ball:
    return phi.cos() + ratio * (2 * phi).cos()


# Formula, textbook, the magnitude below which an ulp shrinks no further, bound for |λ| <= 1/3, bound for
# larger λ. Below 1e-50 a ball is the zero of a dead centre.
TINY = 1e-50


def steep(ratio: float) -> float:
    return 4 / (1 - ratio)


STRAIGHT: dict[str, Any] = {
    "x": (kinematics.piston_path, textbook_path, TINY, 1.6, steep),
    "c": (kinematics.piston_velocity, textbook_velocity, TINY, 1.8, steep),
    "p": (kinematics.piston_acceleration, textbook_acceleration, 1.0, 2, lambda ratio: 10),
    "psi": (rod_angle, textbook_rod_angle, TINY, 1, lambda ratio: 1),
    "rod_velocity": (kinematics.rod_velocity, textbook_rod_velocity, TINY, 3, lambda ratio: 3),
    "rod_acceleration": (kinematics.rod_acceleration, textbook_rod_acceleration, TINY, 6, lambda ratio: 6),
    "x series": (kinematics.piston_path_first_order, blau_path, TINY, 1.6, steep),
    "c series": (kinematics.piston_velocity_first_order, blau_velocity, TINY, 1.8, steep),
    "p series": (kinematics.piston_acceleration_first_order, blau_acceleration, 1.0, 2, lambda ratio: 3),
}
# Formula, textbook, magnitude as above.
OFFSET: dict[str, Any] = {
    "x": (kinematics.offset_path, textbook_path, 1.0),
    "c": (kinematics.piston_velocity, textbook_velocity, 1.0),
    "p": (kinematics.piston_acceleration, textbook_acceleration, 1.0),
    "psi": (rod_angle, textbook_rod_angle, 5.0),
    "rod_velocity": (kinematics.rod_velocity, textbook_rod_velocity, 1.0),
    "rod_acceleration": (kinematics.rod_acceleration, textbook_rod_acceleration, 1.0),
}
# What the return stroke makes of the value at 180° + α; the rod angle and its slopes stay as they are.
RETURNED: dict[str, Callable[[Ball, Ball], Ball]] = {
    "x": lambda value, travel: travel - value,
    "c": lambda value, travel: -value,
    "p": lambda value, travel: -value,
    "psi": lambda value, travel: value,
    "rod_velocity": lambda value, travel: value,
    "rod_acceleration": lambda value, travel: value,
}


def sampled_angles(seed: int) -> NDArray[np.float64]:
    random = np.random.default_rng(seed)
    beside = [
        centre + side * 10.0**-power
        for centre in (0, 90, 180, 270, 360)
        for side in (1, -1)
        for power in (1, 2, 4, 6, 8, 10)
    ]
    return np.concatenate(
        [np.arange(0, 361, 5.0), np.round(random.uniform(0, 360, 60), 1), random.uniform(0, 360, 300), beside]
    )


def worst(values: Any, true: list[Ball], floor: float) -> tuple[float, int]:
    """Return the largest error in units in the last place of max(|true|, floor), and its row."""
    errors = [
        float(abs(arb(float(value)) - expected).mid()) / math.ulp(max(abs(float(expected.mid())), floor))
        for value, expected in zip(values, true, strict=True)
    ]
    row = int(np.argmax(errors))
    return errors[row], row


def textbook_strokes(
    quantity: str, textbook: Textbook, angles: NDArray[np.float64], ratio: float, offset: float
) -> tuple[list[Ball], list[Ball]]:
    """Return the textbook's values on the outstroke, and on the return stroke at the same angles."""
    lam, eta = ball(ratio), ball(offset)
    travel = ((1 / lam + 1) ** 2 - eta**2).sqrt() - ((1 / lam - 1) ** 2 - eta**2).sqrt()
    radians = [ball(angle) * arb.pi() / 180 for angle in angles]
    returned = RETURNED[quantity.split()[0]]
    return [textbook(phi, lam, eta) for phi in radians], [
        returned(textbook(phi + arb.pi(), lam, eta), travel) for phi in radians
    ]


def assert_within(
    bound: float, quantity: str, entry: Any, ratio: float, offset: float, *crank: float
) -> None:
    """Compare both strokes with the textbook; `crank` is what the formula takes besides the circle."""
    formula, textbook, floor = entry[:3]
    angles = sampled_angles(int(1e6 * ratio))
    outward, back = textbook_strokes(quantity, textbook, angles, ratio, offset)
    for true, sign in ((outward, 1), (back, -1)):
        values = formula(circle(angles), *(sign * number for number in crank))
        error, row = worst(values, true, floor)
        assert error <= bound, (
            f"{quantity} is {error:.2f} ulp off at φ = {angles[row]!r}°, λ = {sign * ratio!r}, η = {offset!r}"
        )


@pytest.mark.parametrize("ratio", [1 / 3, 0.3101, 0.25, 1 / 4.5, 0.2, 0.1234, 0.01, 1e-6])
@pytest.mark.parametrize("quantity", STRAIGHT)
def test_usual_ratios_are_within_two_ulp_of_the_textbook(quantity: str, ratio: float) -> None:
    assert_within(STRAIGHT[quantity][3], quantity, STRAIGHT[quantity], ratio, 0.0, ratio)


@pytest.mark.parametrize(("quantity", "ratio"), [("x", 0.258), ("c", 0.28)])
def test_the_bound_holds_where_the_rod_takes_most_away(quantity: str, ratio: float) -> None:
    # Without the tails of sine and versine this search finds 1.7 ulp for x and 2.0 ulp for c.
    formula, textbook, floor, bound, _ = STRAIGHT[quantity]
    angles = np.arange(1, 4000) / 100
    _, back = textbook_strokes(quantity, textbook, angles, ratio, 0.0)
    error, row = worst(formula(circle(angles), -ratio), back, floor)
    assert error <= bound, f"{error:.2f} ulp at {angles[row]!r}°"


@pytest.mark.parametrize("ratio", [0.4, 0.55, 0.7, 0.9, 0.98, 0.99])
@pytest.mark.parametrize("quantity", STRAIGHT)
def test_short_rods_are_within_the_stated_bound(quantity: str, ratio: float) -> None:
    assert_within(STRAIGHT[quantity][4](ratio), quantity, STRAIGHT[quantity], ratio, 0.0, ratio)


@pytest.mark.parametrize(
    ("ratio", "offset", "bound"),
    [(0.25, 0.9, 3), (0.2, -1.45, 3), (1 / 3, 0.4, 3), (0.3, 1.9, 12), (0.55, -0.6, 12)],
)
@pytest.mark.parametrize("quantity", OFFSET)
def test_offset_cranks_are_within_the_stated_bound(
    quantity: str, ratio: float, offset: float, bound: float
) -> None:
    assert_within(1 if quantity == "psi" else bound, quantity, OFFSET[quantity], ratio, offset, ratio, offset)


def test_an_infinite_rod_gives_pure_sine() -> None:
    point = circle(sampled_angles(7))
    for path in (kinematics.piston_path, kinematics.piston_path_first_order):
        np.testing.assert_array_equal(path(point, 0), point.versine)
    for velocity in (kinematics.piston_velocity, kinematics.piston_velocity_first_order):
        np.testing.assert_array_equal(velocity(point, 0), point.sine)
    for acceleration in (kinematics.piston_acceleration, kinematics.piston_acceleration_first_order):
        np.testing.assert_array_equal(acceleration(point, 0), point.cosine)
    np.testing.assert_array_equal(rod_angle(point, 0.0), 0)


FORMULAS = [entry[0] for entry in STRAIGHT.values()]


@pytest.mark.parametrize("formula", FORMULAS)
def test_arrays_give_the_bits_of_scalars(formula: Any) -> None:
    angles = sampled_angles(11)
    for ratio in (0.2345, -0.2345):
        values = formula(circle(angles), ratio)
        np.testing.assert_array_equal(values, [formula(circle(float(angle)), ratio) for angle in angles])


@pytest.mark.parametrize("formula", FORMULAS)
def test_no_zero_has_a_sign(formula: Any) -> None:
    for angle in (0.0, 180.0, 360.0):
        for ratio in (0.2, -0.2, 0.0):
            value = formula(circle(angle), ratio)
            assert value or math.copysign(1, value) == 1, f"{formula.__name__} at {angle}°, λ = {ratio}"


def test_dead_centres_are_exact() -> None:
    assert kinematics.piston_path(circle(180), 0.3) == 2 == kinematics.piston_path(circle(180), -0.3)
    assert kinematics.piston_velocity(circle(180), 0.3) == 0 == kinematics.piston_path(circle(360), -0.3)
    assert kinematics.piston_acceleration(circle(0), 0.25) == 1.25
    assert kinematics.piston_acceleration(circle(180), 0.25) == -0.75
    assert kinematics.piston_acceleration_first_order(circle(45), 0.25) == circle(45).cosine


@pytest.mark.parametrize("cores", [1, 3])
def test_bulk_gives_the_bits_of_the_kernel(monkeypatch: pytest.MonkeyPatch, cores: int) -> None:
    monkeypatch.setattr(bulk, "cores", lambda: cores)
    monkeypatch.setattr(bulk, "BLOCK", 100)
    angles = sampled_angles(3)
    functions: list[bulk.Column] = [
        lambda point: kinematics.piston_path(point, 0.2345),
        lambda point: rod_angle(point, 0.2345),
        lambda point: 0.0,
    ]
    whole = circle(angles)
    table = bulk.evaluate(functions, angles)
    assert table.shape == (3, len(angles))
    for row, function in zip(table, functions, strict=True):
        np.testing.assert_array_equal(row, np.broadcast_to(function(whole), len(angles)))


def test_an_error_in_a_bulk_thread_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bulk, "cores", lambda: 2)
    monkeypatch.setattr(bulk, "BLOCK", 10)
    with pytest.raises(ZeroDivisionError):
        bulk.evaluate([lambda point: 1 / 0], sampled_angles(5))


def test_no_angles_give_no_columns() -> None:
    assert bulk.evaluate([lambda point: point.sine], np.empty(0)).shape == (1, 0)


@pytest.mark.parametrize(
    ("quantity", "angle", "ratio"), [("c", 180.95213232, 0.9990974744), ("x", 357.33954, 0.94514826)]
)
def test_the_worst_cases_of_a_long_search_keep_the_bound(quantity: str, angle: float, ratio: float) -> None:
    formula, textbook, floor, _, larger = STRAIGHT[quantity]
    around = angle + np.arange(-200, 200, dtype=np.float64) * 1e-6
    for stroke in (1, -1):
        values = formula(circle(around), stroke * ratio)
        out, back = textbook_strokes(quantity, textbook, around, ratio, 0.0)
        error, row = worst(values, out if stroke > 0 else back, floor)
        assert error <= larger(ratio), f"{error} ulp at {around[row]}°"
