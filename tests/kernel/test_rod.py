"""Inertia of the rod in floats, arrays and balls, and what is read of it; Newton is asked by tests/verify."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
import numpy as np
import pytest
from cli import column, printed, refusal
from numpy.testing import assert_allclose

from kurbel.exact import certify
from kurbel.kernel import forces
from kurbel.kernel.circle import circle
from kurbel.kernel.moving import Masses, rod_masses
from kurbel.kernel.rod import LoadedCrank


def force(name: str) -> Callable[..., Any]:
    """Return a force of circle, ratio, masses, offset and piston force."""
    return lambda *state: getattr(LoadedCrank(*state), name)()


FORCES: dict[str, Callable[..., Any]] = {
    "guide": force("guide_force"),
    "along": force("pin_force_along"),
    "across": force("pin_force_across"),
    "pin": force("pin_force"),
    "torque": force("torque"),
}


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with flint.ctx.workprec(200):
        yield


# Forces at the pins.


@pytest.mark.parametrize("offset", [None, 0.9])
def test_inertia_does_no_work_in_a_whole_turn(offset: float | None) -> None:
    # Of a periodic function the mean of equal steps is the integral, but for harmonics above 720.
    torque: Any = LoadedCrank(circle(np.arange(720) / 2), 0.31, Masses(0.58, 0.42, -0.09), offset).torque()
    assert np.ptp(torque) > 0.3
    assert abs(torque.mean()) < 1e-14


def test_without_masses_the_piston_force_alone_acts() -> None:
    point, none = circle(np.arange(0.0, 360, 7)), Masses(0.0, 0.0, 0.0)
    for crank in ((0.23,), (-0.23,), (0.23, 0.8)):
        ratio, offset = crank[0], crank[1] if len(crank) > 1 else None
        loaded: Any = LoadedCrank(point, ratio, none, offset, 3.0)
        guide: Any = forces.guide_force(point, *crank)
        rod: Any = forces.rod_force(point, *crank)
        turning: Any = forces.tangential_force(point, *crank)
        assert_allclose(loaded.guide_force(), 3 * guide, rtol=1e-15, atol=1e-15)
        assert_allclose(loaded.pin_force(), 3 * rod, rtol=1e-15, atol=0)
        assert_allclose(loaded.torque(), 3 * turning, rtol=1e-15, atol=0)
        assert (loaded.pin_force_along() == 3).all()


# Limits and kinds of number.

SAMPLED = np.concatenate([np.arange(0, 361, 15.0), np.random.default_rng(8).uniform(0, 360, 100)])
ROD = Fraction(37, 100), Fraction(9, 100)
FLOATS = rod_masses(*map(float, ROD))


def test_an_infinite_rod_swings_without_turning_the_force_along() -> None:
    point = circle(SAMPLED)
    loaded: Any = LoadedCrank(point, 0.0, FLOATS)
    assert_allclose(loaded.pin_force_along(), -point.cosine, rtol=1e-15, atol=1e-16)
    share = 0.63 + float(FLOATS.couple)
    assert_allclose(loaded.pin_force_across(), -share * point.sine, rtol=1e-15, atol=1e-16)
    for formula in FORCES.values():
        assert_allclose(formula(point, 1e-9, FLOATS), formula(point, 0.0, FLOATS), rtol=0, atol=1e-8)


@pytest.mark.parametrize("name", FORCES)
def test_floats_are_within_their_bound(name: str) -> None:
    cases = (
        ((1 / 3, None), 2), ((-0.21, None), 2), ((0.01, None), 2), ((0.9, None), 16), ((-0.99, None), 16),
        ((0.25, 0.9), 3), ((-0.2, 1.45), 3), ((0.3, 1.9), 12), ((-0.55, 0.6), 12),
    )  # fmt: skip
    for (ratio, offset), bound in cases:
        for masses in (FLOATS, Masses(0.6, 0.4, 0.0), Masses(0.31, 0.69, -0.21), Masses(0.5, 0.5, 0.3)):
            exact = None if offset is None else certify.ball(Fraction(offset))
            balls = Masses(*(certify.ball(Fraction(mass)) for mass in masses))
            values = FORCES[name](circle(SAMPLED), ratio, masses, offset)
            for degrees, value in zip(SAMPLED.tolist(), values.tolist(), strict=True):
                point = certify.ball_circle(Fraction(degrees))
                true = FORCES[name](point, certify.ball(Fraction(ratio)), balls, exact)
                error = float(abs(certify.ball(Fraction(value)) - true))
                assert error <= bound * math.ulp(max(1, abs(value))), (name, ratio, offset, degrees)


@pytest.mark.parametrize("name", FORCES)
def test_arrays_give_the_bits_of_scalars(name: str) -> None:
    for ratio, offset in ((0.2345, None), (-0.2345, None), (0.2345, 0.67)):
        values = FORCES[name](circle(SAMPLED), ratio, FLOATS, offset, 0.3)
        scalars = [FORCES[name](circle(degrees), ratio, FLOATS, offset, 0.3) for degrees in SAMPLED.tolist()]
        np.testing.assert_array_equal(values, scalars)


def test_no_zero_has_a_sign() -> None:
    for degrees in (0.0, 90.0, 180.0, 360.0):
        for ratio in (0.2, -0.2, 0.0):
            point = circle(degrees)
            values = [formula(point, ratio, FLOATS) for formula in FORCES.values()]
            loaded: Any = LoadedCrank(point, ratio, FLOATS)
            values += [loaded.couple(), *loaded.parts]
            assert all(value or math.copysign(1, value) == 1 for value in values), (degrees, ratio)


def test_magnitude_of_balls_that_hold_zero_is_a_ball_about_zero() -> None:
    third = certify.ball(Fraction(1, 3))
    masses = Masses(third, third, 0)
    balanced = third + third * (1 + third)
    value: Any = LoadedCrank(certify.ball_circle(Fraction(0)), third, masses, None, balanced).pin_force()
    assert value.contains(0)
    assert value < 1e-50


# The rod in a file: what texts in tests/transcripts cannot hold.

METRIC = "from [mm];to [mm];mass [kg]\n-60;75;8,4\n75;540;6,1\n540;630;3,3\n"
SHOWN = ["inertia", "--layout=rod-masses"]


@pytest.mark.parametrize(
    "text",
    [
        METRIC.replace("\n", "\r\n"),
        "\ufeff# weighed\n\n" + METRIC.replace("\n75", "\n\n # shank\n75") + ";;\n",
    ],
)
def test_a_rod_is_read_however_its_lines_end(text: str, tmp_path: Path) -> None:
    pages = []
    for name, written in (("plain.csv", METRIC), ("other.csv", text)):
        (tmp_path / name).write_bytes(written.encode())
        pages.append(printed(*SHOWN, f"--rod-file={tmp_path / name}", "--rod=600mm").out)
    assert pages[0] == pages[1]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (METRIC.encode() + b"\xff\n", "line 5: the byte 0xff is not UTF-8"),
        (METRIC.encode() + b"\0\n", "line 5: the character U+0000 is in no text file"),
        (None, "it has 200 MB; a rod has at most 100 MB"),
    ],
)
def test_what_is_no_text_is_refused(data: bytes | None, said: str, tmp_path: Path) -> None:
    path = tmp_path / "rod.csv"
    path.write_bytes(data or b"#")
    if data is None:
        os.truncate(path, 2 * 10**8)
    assert said in refusal(*SHOWN, f"--rod-file={path}", "--rod=1m", code=1)


# At 90° and λ = 3/5: cos ψ = 4/5, tan ψ = 3/4, p = -3/4, c = 1.
@pytest.mark.parametrize(
    ("key", "rod", "digits", "away", "even"),
    [
        ("inertia_guide_railway", "--centre=0.6 --gyration=0.3", 2, "0.23", "0.22"),
        ("inertia_pin_y_railway", "--centre=0.6 --gyration=0.3", 2, "-0.83", "-0.82"),
        ("inertia_guide_two_mass", "--centre=0.6 --gyration=0.3", 2, "0.23", "0.22"),
    ],
)
def test_ties_of_the_masses_are_proved(key: str, rod: str, digits: int, away: str, even: str) -> None:
    words = [
        "inertia",
        "--ratio=3:5",
        *rod.split(),
        "--angle=90",
        f"--digits={digits}",
        f"--columns=phi,{key}",
    ]
    found = [column(key, *words, f"--rounding={one}") for one in ("half-away", "half-even")]
    assert found == [[away], [even]]
