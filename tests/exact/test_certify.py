"""Every printed digit against an independent computation for random cranks, angles and decimals."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from cli import records
from drives import confirm
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel import certified, verify
from kurbel.exact.certify import ball, half_turn_circle, vanishes

MOST_DECIMALS = 50
PAIRS = ("x", "c", "p", "psi", "rod_velocity", "rod_acceleration", "x_stroke", "x_percent")
FORCES = ("rod_force", "guide_force", "tangential_force", "radial_force", "torque")


def strokes(*keys: str, unit: str = "") -> list[str]:
    """Return the keys of both strokes: x_stroke is x_return_stroke on the return."""
    back = [key.replace("x_", "x_return_") if key[:2] == "x_" else f"{key}_return" for key in keys]
    return [f"{key}{unit}" for key in (*keys, *back)]


MOTION, FORCED = strokes(*PAIRS), strokes(*FORCES)


def decimal(least: int, most: int, places: int) -> st.SearchStrategy[Fraction]:
    """Numbers with up to so many decimals."""
    return st.integers(0, places).flatmap(
        lambda count: st.integers(least * 10**count, most * 10**count).map(lambda n: Fraction(n, 10**count))
    )


RATIOS = st.one_of(
    decimal(101, 900, 2).map(lambda rod: 100 / rod),
    st.integers(1, 990_000).map(lambda millionths: Fraction(millionths, 10**6)),
    st.integers(3, 9).map(lambda power: Fraction(7, 10**power)),
    st.sampled_from([Fraction(0), Fraction(2, 9), Fraction(99, 100)]),
)
ANGLES = st.one_of(
    st.integers(-360, 720).map(Fraction),
    decimal(0, 360, 9),
    # Degrees and minutes: 0°20' is a third of a degree.
    st.integers(0, 360 * 60).map(lambda minutes: Fraction(minutes, 60)),
    st.integers(0, 360 * 32).map(lambda parts: Fraction(parts, 32)),
    st.tuples(st.integers(0, 4), st.sampled_from([-1, 1]), st.integers(1, 30)).map(
        lambda near: 90 * near[0] + Fraction(near[1], 10 ** near[2])
    ),
    decimal(-(10**6), 10**6, 3),
)


@pytest.mark.parametrize("offset", [False, True], ids=["straight", "offset"])
@settings(max_examples=10, deadline=None)
@given(ratio=RATIOS, angle=ANGLES, share=st.integers(-999, 999), drawn=st.data())
def test_every_digit_is_that_of_an_independent_computation(
    offset: bool, ratio: Fraction, angle: Fraction, share: int, drawn: Any
) -> None:
    eta = (1 / ratio - 1) * Fraction(share, 1000) if offset and ratio else Fraction(0)
    drive = verify.drive(ratio, eta)
    for key in [*MOTION, *FORCED, *(() if eta else ("fd",))]:
        methods = ["exact"] if eta else ["exact", "infinite"]
        if not eta and key in MOTION:
            methods += ["series", "series-5"]
        method = drawn.draw(st.sampled_from(methods))
        decimals = drawn.draw(st.integers(0, MOST_DECIMALS))
        named, _, order = method.partition("-")
        found = certified(
            key, ratio, angle, digits=decimals, method=named, order=int(order) if order else None, offset=eta
        )
        assert f"{found:f}" == drive.value(key, angle, method).digits(decimals), (key, method)


def columns(keys: list[str]) -> str:
    return "--columns=" + ",".join(["phi", *keys])


@pytest.mark.parametrize(
    ("ratio", "method", "digits", "step"),
    [
        ("0.987", "exact", 6, "0.05"), ("0.3101", "series", 9, "0.03"), ("0.25", "exact", 2, "0.05"),
        # At 12 decimals a float alone is rounded wrongly once in some thousand cells.
        ("0.3101", "series", 12, "0.06"),
        # Sums of two floats.
        ("2:9", "exact", 14, "0.04"), ("0.95", "exact", 13, "0.04"), ("0.25", "series", 16, "0.04"),
    ],
)  # fmt: skip
def test_long_csv_has_the_independent_digits(ratio: str, method: str, digits: int, step: str) -> None:
    # An arc is not for sums of two floats.
    keys = ["x", "x_return", "c", "p", *(["psi"] if digits < 13 else [])]
    rows = records(
        "table", f"--ratio={ratio}", f"--step={step}", f"--digits={digits}", f"--method={method}",
        columns(keys),
    )  # fmt: skip
    assert len(rows) == 180 // Fraction(step) + 1
    # Every angle where a zero can be, and a draw of the others.
    chosen = [row for row in rows if Fraction(row["phi"]) % 15 == 0]
    confirm(verify.drive(ratio), chosen + random.Random(112).sample(rows, 12), keys, method=method)


@pytest.mark.parametrize("last", [180, 360])
@pytest.mark.parametrize("rounding", ["half-away", "half-even"])
def test_long_csv_meets_the_ties_of_the_short_one(rounding: str, last: int) -> None:
    about = ["--ratio=0.2;0.12;0.28;0.36", "--method=series", "--digits=2"]
    run = [*about, f"--rounding={rounding}", f"--to={last}"]
    long = {(row["ratio"], Fraction(row["phi"])): row for row in records("table", *run, "--step=0.1")}
    short = records("table", *run, "--step=30")
    assert (len(long), len(short)) == (4 * (10 * last + 1), 4 * (last // 30 + 1))
    for row in short:
        assert {**long[row["ratio"], Fraction(row["phi"])], "phi": ""} == {**row, "phi": ""}
    at_60 = [row["x"] for row in short if row["phi"] == "60"]
    # 1/2 + 3/8 λ: 0.575, 0.545, 0.605, 0.635.
    assert at_60 == (
        ["0.58", "0.55", "0.61", "0.64"] if rounding == "half-away" else ["0.58", "0.54", "0.60", "0.64"]
    )


def test_a_value_is_zero_only_where_its_ball_is_narrower_than_its_distance_from_zero() -> None:
    """A sum of great terms is wide long after the precision has passed the bits that part it from zero."""

    def sum_of_great_terms(rest: Fraction) -> arb:
        great = ball(Fraction(10) ** 300 / 7)
        return great + ball(rest) - great

    tiny = Fraction(1, 3 * 2**60)
    assert not vanishes(lambda: sum_of_great_terms(tiny), 70)
    assert vanishes(lambda: sum_of_great_terms(Fraction(0)), 70)
    assert vanishes(lambda: sum_of_great_terms(tiny) - ball(tiny), 70)


def test_a_ball_about_exactly_zero_has_a_circle() -> None:
    third = ball(Fraction(1, 3))
    found = half_turn_circle(third - third)
    assert found.versine.contains(0)
    assert found.versine.abs_upper() < 1e-20
