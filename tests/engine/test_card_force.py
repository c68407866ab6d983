"""The piston force of indicator cards: ideal ones against their closed form, and any others."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from kurbel.engine.card.card import Card
from kurbel.engine.card.force import card_strokes, curve

EXPANSIONS = (1.5, 2, 2.7, 3, 4, 6, 10)
# Nine points that fall with the stroke, in bar; nothing about them repeats.
SHARES = (0.0, 0.1, 0.22, 0.36, 0.5, 0.61, 0.74, 0.88, 1.0)
FORWARD = (8.1, 8.0, 7.7, 6.2, 4.9, 4.1, 3.5, 2.9, 2.3)
BACK = (2.7, 1.9, 1.4, 1.2, 1.1, 1.15, 1.2, 1.25, 1.3)

# The ideal card, whose force and work have closed forms (Weisbach-Herrmann, § 150).

Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]


def ideal_pressure(share: Array, expansion: float) -> Array:
    return 1 / np.maximum(1, expansion * share)


def ideal_work(share: Array, expansion: float) -> Array:
    """Return A₁ + A₂: 1/ε (1 + ln εσ) beyond cut-off."""
    return np.minimum(share, 1 / expansion) + np.log(np.maximum(1, expansion * share)) / expansion


def even(expansion: float) -> Array:
    return np.linspace(0, 1, 200)


def with_cut_off(expansion: float) -> Array:
    shares = np.linspace(0, 1, 200)
    shares[np.argmin(abs(shares - 1 / expansion))] = 1 / expansion
    return shares


def equal_angles(expansion: float) -> Array:
    return np.append((1 - np.cos(np.linspace(0, np.pi, 200)))[:-1] / 2, 1)


def dense_at_first(expansion: float) -> Array:
    return np.linspace(0, 1, 200) ** 1.5


def uneven(expansion: float) -> Array:
    steps = np.random.default_rng(7).uniform(0.5, 1.5, 199)
    return np.append(0, np.append(np.cumsum(steps)[:-1] / steps.sum(), 1))


def ideal_card(shares: Array, expansion: float, back: float, scale: float = 7.3e5) -> Card:
    forward = scale * ideal_pressure(shares, expansion)
    return Card(tuple(shares.tolist()), tuple(forward.tolist()), (scale * back,) * len(shares))


def corners(stroke: Any) -> list[float]:
    """Return the shares at which the slope of the force jumps."""
    return sorted({*stroke.behind.corners, *stroke.before.corners})


SPACINGS = (even, with_cut_off, equal_angles, dense_at_first, uneven)
DENSE = np.linspace(0, 1, 20_011)


@pytest.mark.parametrize("spacing", SPACINGS)
@pytest.mark.parametrize("expansion", EXPANSIONS)
def test_the_ideal_card_of_200_points_has_the_work_and_force_of_its_closed_form(
    spacing: Callable[[float], Array], expansion: float
) -> None:
    stroke: Any = card_strokes(ideal_card(spacing(expansion), expansion, 0.07), double_acting=True)[0]
    # Two works and the mean force make an energy: a tenth of 1e-6 leaves δ its 1e-6 at ε = 10, where
    # P is 0.14 Q.
    assert_allclose(stroke.work(DENSE), ideal_work(DENSE, expansion) - 0.07 * DENSE, rtol=0, atol=2e-8)
    assert_allclose(stroke.force(DENSE), ideal_pressure(DENSE, expansion) - 0.07, rtol=0, atol=5e-6)
    assert_allclose(corners(stroke), [1 / expansion], rtol=0, atol=5e-7)


@pytest.mark.parametrize("expansion", EXPANSIONS)
def test_half_the_ideal_card_shows_the_error_of_the_whole(expansion: float) -> None:
    card = ideal_card(even(expansion), expansion, 0.1)
    whole: Any
    half: Any
    whole, half = (card_strokes(one, double_acting=True)[0].work(DENSE) for one in (card, card.halves()[0]))
    error = np.max(abs(whole - ideal_work(DENSE, expansion) + 0.1 * DENSE))
    assert 2 * error < np.max(abs(whole - half)) < 1e-6


# The forces of any card.


def steep_card() -> Card:
    return Card(SHARES, tuple(p * 1e5 for p in FORWARD), tuple(p * 1e5 for p in BACK))


@pytest.mark.parametrize("share", [0.0, 0.137, 0.5, 0.93, 1.0])
def test_work_is_the_integral_of_the_force(share: float) -> None:
    stroke: Any = card_strokes(steep_card(), double_acting=True)[0]
    # Gauss-Legendre with two nodes is exact for a cubic.
    edges = np.unique(np.clip([*SHARES, *(1 - np.array(SHARES)), *corners(stroke), share], 0, share))
    middle, half = (edges[1:] + edges[:-1]) / 2, np.diff(edges) / 2
    total = sum(np.sum(half * stroke.force(middle + sign * half / math.sqrt(3))) for sign in (-1, 1))
    assert_allclose(stroke.work(share), total, rtol=1e-13, atol=1e-16)


def test_floats_give_the_numbers_of_arrays() -> None:
    stroke: Any = card_strokes(steep_card(), double_acting=True)[0]
    shares = np.array([[0.0, 0.31], [0.77, 1.0]])
    for of in (stroke.force, stroke.work):
        assert of(shares).shape == (2, 2)
        assert [[of(float(share)) for share in row] for row in shares] == of(shares).tolist()
        assert type(of(0.3)) is float
    assert stroke.force(1 + 2e-16) == stroke.force(1.0)
    assert stroke.work(np.array([-0.01, 1.01])).tolist() == [0, stroke.work(1.0)]


def test_corners_are_mirrored_with_the_exhausting_end() -> None:
    shares = np.linspace(0, 1, 101)
    # Compression begins at 0.253 of the stroke from this dead centre.
    rising = 1e5 * (1 + 9 * np.maximum(0, 0.253 - shares) * 1.3)
    card = Card(tuple(shares.tolist()), tuple((8e5 - 4e5 * shares).tolist()), tuple(rising.tolist()))
    stroke: Any = card_strokes(card, double_acting=True)[0]
    assert_allclose(corners(stroke), [1 - 0.253], rtol=0, atol=1e-12)


# Curves that no ideal engine draws.


@pytest.mark.parametrize("noise", [1e-6, 1e-3, 0.03])
@pytest.mark.parametrize("count", [8, 21, 200])
def test_a_noisy_card_stays_within_its_neighbours(noise: float, count: int) -> None:
    random = np.random.default_rng(count)
    shares = np.append(0, np.append(np.sort(random.uniform(0.001, 0.999, count - 2)), 1))
    noisy = ideal_pressure(shares, 3.3) + random.normal(0, noise, count)
    drawn = curve(shares.tolist(), noisy.tolist())
    check_monotone(drawn, shares, noisy)
    widths = np.diff(shares)
    least, most = np.minimum(noisy[1:], noisy[:-1]) @ widths, np.maximum(noisy[1:], noisy[:-1]) @ widths
    assert least <= drawn.work(1.0) <= most


def check_monotone(drawn: Any, shares: Array, pressures: Array) -> None:
    inner = np.linspace(0, 1, 33)
    for left, right, first, last in zip(shares, shares[1:], pressures, pressures[1:], strict=False):
        steps = np.diff(drawn.pressure(left + (right - left) * inner)) * np.sign(last - first)
        size = max(abs(first), abs(last), 1e-300)
        assert np.all(steps >= -1e-12 * size) or (first == last and np.all(abs(steps) < 1e-12 * size))
        assert_allclose(drawn.pressure(np.array([left, right])), [first, last], rtol=0, atol=1e-11 * size)


@settings(deadline=None, max_examples=40)
@given(
    st.lists(
        st.tuples(st.integers(1, 10**6 - 1), st.integers(-1000, 1000)),
        min_size=6, max_size=30, unique_by=lambda point: point[0],
    )
)  # fmt: skip
def test_every_curve_is_monotone_between_its_points(points: list[tuple[int, int]]) -> None:
    points = [(0, 7), *sorted(points), (10**6, -3)]
    shares = np.array([point[0] for point in points]) / 1e6
    pressures = np.array([point[1] for point in points]) / 10.0
    check_monotone(curve(shares.tolist(), pressures.tolist()), shares, pressures)


def test_smooth_curves_have_no_corners() -> None:
    shares = np.linspace(0, 1, 60)
    for pressures in (
        np.sin(6 * shares),
        np.exp(-5 * shares),
        shares**3,
        0 * shares + 2.5,
        1 / (1 + 40 * shares),
    ):
        assert curve(shares.tolist(), pressures.tolist()).corners == ()


def test_a_corner_of_two_bent_lines_at_a_point_is_at_that_point() -> None:
    shares = np.linspace(0, 1, 41)
    for node in range(5, 35):
        far = shares - shares[node]
        pressures = 2 + np.where(far < 0, np.sinh(far), np.exp(-3 * far) - 1)
        corners_found = curve(shares.tolist(), pressures.tolist()).corners
        assert_allclose(corners_found, [shares[node]], rtol=0, atol=1e-6)


def test_two_corners_of_one_line_are_both_found() -> None:
    shares = np.linspace(0, 1, 80)
    pressures = np.where(
        shares < 0.311, 1 + shares, np.where(shares < 0.74, 1.311 - 2 * (shares - 0.311), 0.453)
    )
    drawn = curve(shares.tolist(), pressures.tolist())
    assert_allclose(drawn.corners, [0.311, 0.74], rtol=0, atol=1e-12)
