"""Every printed digit against an independent computation for random cranks, angles and decimals."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product
from typing import Any

import pytest
import textbook
from cli import printed
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from textbook import Drive
from timed import WITHOUT_UNITS, kurbel, runs

from kurbel.exact.certify import ball, half_turn_circle, vanishes
from kurbel.motion.evaluation import DIFFERENCE, METHODS, REACH
from kurbel.motion.quantities import registry

MOST_DECIMALS = 50
BITS = 640
"""50 decimals take 166 bits and the check of the boundary 150; a rod of 10^9 R costs the textbook 60."""


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


@st.composite
def drives(draw: st.DrawFn, offset: bool) -> Drive:
    ratio = draw(RATIOS)
    eta = Fraction(0)
    if offset and ratio:
        eta = (1 / ratio - 1) * Fraction(draw(st.integers(-999, 999)), 1000)
    radius, speed = draw(decimal(1, 900, 3)) / 100, draw(decimal(1, 300, 2))
    return Drive(ratio, eta, radius, speed, draw(st.booleans()), draw(decimal(1, 10**5, 2)))


# Forces that only moving masses have are those of tests/engine/test_machine_forces.py.
MASSLESS = [key for key, quantity in registry().items() if "exact" in quantity.formulas]


def methods(key: str, drive: Drive) -> st.SearchStrategy[str]:
    """The methods that have formulas for the crank."""
    if drive.offset:
        return st.just("exact")
    if "force" in key or key.startswith("torque"):
        return st.sampled_from(["exact", "infinite"])
    return st.sampled_from([*METHODS, *REACH, *([] if key.startswith("psi") else [DIFFERENCE])])


@pytest.mark.parametrize("offset", [False, True], ids=["straight", "offset"])
@settings(max_examples=60, deadline=None)
@given(drawn=st.data())
def test_every_digit_is_that_of_an_independent_computation(offset: bool, drawn: Any) -> None:
    drive, angle = drawn.draw(drives(offset)), drawn.draw(ANGLES)
    for key in MASSLESS:
        if offset and key.startswith("fd"):
            # Of the straight crank alone.
            continue
        method = drawn.draw(methods(key, drive))
        decimals = drawn.draw(st.integers(0, MOST_DECIMALS))
        expected = textbook.rounded(textbook.evaluate(key, method, drive, angle, BITS), decimals)
        if expected is not None:
            assert kurbel(key, method, drive, angle, decimals) == expected, key


@pytest.mark.parametrize("angle", [Fraction(text) for text in ("11.25", "1/3", "1/3600", "359.999")], ids=str)
@pytest.mark.parametrize("key", MASSLESS)
def test_angles_in_minutes_and_small_fractions(key: str, angle: Fraction) -> None:
    drive = Drive(Fraction(2, 9), Fraction(0), Fraction(3, 10), Fraction(2), True, Fraction(7, 3))
    for decimals in (0, 7, MOST_DECIMALS):
        expected = textbook.rounded(textbook.evaluate(key, "exact", drive, angle, BITS), decimals)
        assert kurbel(key, "exact", drive, angle, decimals) == expected


# Of forces there are no first-order formulas.
MOTION = [key for key in WITHOUT_UNITS if "force" not in key and not key.startswith("torque")]


def table(*options: str) -> list[dict[str, str]]:
    return printed("table", *options, "-f", "csv").records()


def assert_cell(shown: str, key: str, method: str, drive: Drive, angle: Fraction, bits: int = BITS) -> None:
    decimals = len(shown.partition(".")[2])
    expected = textbook.rounded(textbook.evaluate(key, method, drive, angle, bits), decimals, bits=bits)
    if expected is not None:
        assert shown == textbook.printed(expected, decimals), f"{key} ({method}) of {drive} at {angle}°"


@settings(max_examples=40, deadline=None)
@given(
    lengths=st.lists(decimal(101, 900, 3), min_size=1, max_size=3, unique=True),
    method=st.sampled_from([*METHODS]),
    digits=st.integers(0, MOST_DECIMALS),
    drawn=st.data(),
)
def test_csv_of_the_command_line_has_the_independent_digits(
    lengths: list[Fraction], method: str, digits: int, drawn: Any
) -> None:
    last, keys = drawn.draw(st.sampled_from(runs(MOTION)))
    angles = drawn.draw(st.lists(decimal(0, last, 5), min_size=1, max_size=6, unique=True))
    columns = drawn.draw(st.lists(st.sampled_from(keys), min_size=1, unique=True))
    rods = [length / 100 for length in lengths]
    records = table(
        *(f"--ratio=1:{float(rod)}" for rod in rods),
        "--angle=" + ";".join(f"{float(angle):.5f}" for angle in angles),
        f"--method={method}", f"--digits={digits}", "--columns=" + ",".join(["ratio", "phi", *columns]),
    )  # fmt: skip
    # All ratios are one where the rod is of infinite length.
    shown = ["∞"] if method == "infinite" else [str(float(rod)).removesuffix(".0") for rod in rods]
    expected = ((rod, text, angle) for rod, text in zip(rods, shown, strict=False) for angle in angles)
    for row, (rod, text, angle) in zip(records, expected, strict=True):
        assert (row["ratio"], Fraction(row["phi"])) == (f"1:{text}", angle)
        for key in columns:
            assert len(row[key].partition(".")[2]) == digits
            assert_cell(row[key], key, method, Drive(1 / rod), angle)


def test_csv_with_units_has_the_independent_digits() -> None:
    by_needs = {key: registry()[key].needs for key in MASSLESS}
    motion = [key for key, needs in by_needs.items() if needs in ("length", "speed", "time")]
    loaded = [key for key, needs in by_needs.items() if needs in ("force", "torque")]
    size = ("--stroke=600mm", "--rod=1500mm", "--step=7.5")
    drive = Drive(Fraction(1, 5), Fraction(0), Fraction(3, 10), Fraction(2), True, Fraction(1250))
    for command, every, scale in (("table", motion, "--speed=120/min"), ("forces", loaded, "--force=1.25kN")):
        assert every
        for last, keys in runs(every):
            columns = "--columns=phi," + ",".join(keys)
            shown = printed(command, *size, scale, f"--to={last}", columns, "-f", "csv")
            for row, key in product(shown.records(), keys):
                assert_cell(row[key], key, "exact", drive, Fraction(row["phi"]))


def test_csv_of_an_offset_crank_has_the_independent_digits() -> None:
    # Blau's fd is of the straight crank.
    for last, keys in runs([key for key in WITHOUT_UNITS if not key.startswith("fd")]):
        records = table(
            "--ratio=1:4,5", "--offset=-0.7", f"--to={last}", "--step=12.5", "--digits=9",
            "--columns=phi," + ",".join(keys),
        )  # fmt: skip
        for row, key in product(records, keys):
            assert_cell(row[key], key, "exact", Drive(Fraction(2, 9), Fraction(-7, 10)), Fraction(row["phi"]))


@pytest.mark.parametrize(
    ("ratio", "method", "digits", "step"),
    [("0.987", "exact", 6, "0.05"), ("0.3101", "series", 9, "0.03"), ("0.25", "exact", 2, "0.05")],
)
def test_long_csv_has_the_independent_digits(ratio: str, method: str, digits: int, step: str) -> None:
    for last, keys in runs(["x", "x_return", "c", "p", "psi"]):
        records = table(
            f"--ratio={ratio}", f"--to={last}", f"--step={step}", f"--digits={digits}", f"--method={method}",
            "--columns=phi," + ",".join(keys),
        )  # fmt: skip
        assert len(records) == last / Fraction(step) + 1
        # Every angle where a zero can be, and a draw of the others.
        chosen = [row for row in records if Fraction(row["phi"]) % 15 == 0]
        chosen += random.Random(112).sample(records, 150)
        for row, key in product(chosen, keys):
            assert_cell(row[key], key, method, Drive(Fraction(ratio)), Fraction(row["phi"]), bits=320)


def test_every_cell_of_a_long_csv_with_all_the_digits_of_floats() -> None:
    # At 12 decimals a float alone is rounded wrongly once in some thousand cells.
    records = table("--ratio=0.3101", "--method=series", "--digits=12", "--step=0.04", "--columns=phi,x,p,c")
    assert len(records) == 9001
    for row in records:
        for key in ("x", "p"):
            assert_cell(row[key], key, "series", Drive(Fraction("0.3101")), Fraction(row["phi"]), bits=240)


@pytest.mark.parametrize("last", [180, 360])
@pytest.mark.parametrize("rounding", ["half-away", "half-even"])
def test_long_csv_meets_the_ties_of_the_short_one(rounding: str, last: int) -> None:
    about = ["--ratio=0.2;0.12;0.28;0.36", "--method=series", "--digits=2"]
    run = [*about, f"--rounding={rounding}", f"--to={last}"]
    long = {(row["ratio"], Fraction(row["phi"])): row for row in table(*run, "--step=0.1")}
    short = table(*run, "--step=30")
    assert (len(long), len(short)) == (4 * (10 * last + 1), 4 * (last // 30 + 1))
    for row in short:
        same = long[row["ratio"], Fraction(row["phi"])]
        assert {**same, "phi": ""} == {**row, "phi": ""}
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
