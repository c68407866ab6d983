"""Points of the rod: against their links enclosed, pages of piston and crank, and second differences."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import records
from drives import ARCS, BEAMS, Drive, confirm, slide
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

import kurbel

QUANTITIES = [f"{key}_{way}" for key in ("path", "velocity", "acceleration") for way in ("along", "across")]
QUANTITIES += [f"{key}{end}" for key in ("velocity", "acceleration") for end in ("", "_direction")]
EVERY = ",".join(QUANTITIES)


def figures(*words: str) -> list[dict[str, str]]:
    return records("table", *words)


def assert_closed(drive: Drive, share: str, beside: str, degrees: str) -> None:
    about = (f"--point={share},{beside}", f"--angle={degrees}", f"--columns={EVERY}", "--digits=12")
    (row,) = figures(*drive.words, *about)
    confirm(drive.true, [row | {"phi": degrees}], QUANTITIES, point=(share, beside))


@settings(deadline=None, max_examples=8, derandomize=True)
@given(
    rod=st.fractions(2, 9, max_denominator=20),
    offset=st.fractions(-1, 1, max_denominator=9),
    share=st.integers(-200, 300).filter(bool),
    beside=st.sampled_from(["0.0", "0.14", "-0.3"]),
    degrees=st.fractions(-400, 400, max_denominator=60),
)
def test_points_of_a_rod_at_a_crosshead_are_those_of_the_closed_triangle(
    rod: Fraction, offset: Fraction, share: int, beside: str, degrees: Fraction
) -> None:
    drive = slide(1 / rod, offset * (rod - 1) * Fraction(9, 10))
    assert_closed(drive, f"{share / 100:.2f}", beside, str(degrees))


@pytest.mark.parametrize("drive", [*ARCS, BEAMS[0]], ids=str)
def test_points_of_a_rod_at_a_rocker_are_those_of_the_closed_links(drive: Drive) -> None:
    for share, beside, degrees in (("0.37", "0.0", "73.1"), ("-0.3", "0.21", "251"), ("1.2", "-0.4", "0")):
        assert_closed(drive, share, beside, degrees)


def test_both_ends_are_the_crosshead_and_the_crank_pin() -> None:
    about = ("--ratio=3:10", "--offset=0.4", "--digits=9", "--step=35")
    piston = figures(*about, "--columns=phi,x,c,p")
    crosshead = figures(*about, "--point=B", f"--columns=phi,{EVERY}")
    assert [{key: row[key] for key in "xcp"} for row in piston] == [
        {
            letter: row[f"{key}_along"]
            for letter, key in zip("xcp", ("path", "velocity", "acceleration"), strict=True)
        }
        for row in crosshead[: len(piston)]
    ]
    assert {row["path_across"] for row in crosshead} == {"0.400000000"}
    still = {row[key] for row in crosshead for key in ("velocity_across", "acceleration_across")}
    assert still == {"0.000000000"}
    assert {row["velocity_direction"] for row in crosshead} == {"0.000000000", "180.000000000"}
    for row in figures("--ratio=3:10", "--point=A", "--step=35", f"--columns=phi,{EVERY}", "--digits=9"):
        phi = np.radians(int(row["phi"]))
        assert float(row["path_across"]) == pytest.approx(np.sin(phi), abs=1e-9)
        assert (row["velocity"], row["acceleration"]) == ("1.000000000", "1.000000000")
        # Square to the crank, and along it to the shaft.
        assert float(row["velocity_direction"]) == (int(row["phi"]) + 90) % 360
        assert float(row["acceleration_direction"]) == (int(row["phi"]) + 180) % 360


def test_what_stands_still_has_no_direction_and_what_points_ahead_is_told_0() -> None:
    rows = figures("--ratio=1:4", "--point=0;0.5", "--angle=0;180;270", "--columns=velocity_direction")
    assert [row["velocity_direction"] for row in rows] == ["", "", "0.000", "90.000", "270.000", "0.000"]
    # e = ½ (L + R): the dead centre is at 30°, where the velocity is no sum of nothing.
    offset = figures("--ratio=1:4", "--offset=2.5", "--point=0", "--angle=30", "--columns=velocity_direction")
    assert offset == [{"velocity_direction": ""}]
    # Of the arc crank whose dead centre is at φ = 0.
    arc = ("--mechanism=arc", "--ratio=1:3", "--rocker=3", "--pivot=2.2;-2.4", "--angle=0")
    assert figures(*arc, "--point=0", "--columns=velocity,velocity_direction") == [
        {"velocity": "0.0000", "velocity_direction": ""}
    ]


def test_ties_are_proved() -> None:
    # ½ (1.2 + 1): the middle of the rod of 1:5 in its dead centre, and ¼ of sin 30° across.
    (row,) = figures("--point=0.25", "--angle=30", "--digits=2", "--columns=path_across")
    assert row["path_across"] == "0.13"
    # 1 + (1 - s)/4 is 1.125 at the dead centre of 1:4 for s = ½.
    about = ("--ratio=1:4", "--point=0.5", "--angle=0", "--digits=2", "--columns=acceleration,velocity")
    assert figures(*about)[0] == {"acceleration": "1.13", "velocity": "0.50"}
    assert figures(*about, "--rounding=half-even")[0]["acceleration"] == "1.12"
    # A direction of the crank pin is exact: 22.125° + 90°.
    (row,) = figures("--point=1", "--angle=22.125", "--columns=velocity_direction", "--digits=2")
    assert row["velocity_direction"] == "112.13"
    (row,) = figures("--point=1", "--angle=269.996", "--columns=velocity_direction", "--digits=2")
    assert row["velocity_direction"] == "0.00"


def test_an_accelerated_crank_carries_every_point_along() -> None:
    # α = 50 rad/s² at ω = 10 rad/s: a = p + ½ c, along and across.
    about = ("--ratio=1:4", "--point=0.3,0.2", "--angle=40", "--digits=9")
    rows = [
        figures(*about, "--stroke=200mm", "--speed=10rad/s", f"--columns={EVERY}", *gain)[0]
        for gain in ((), ("--acceleration=50rad/s²",))
    ]
    even, driven = ({key: float(one) for key, one in row.items()} for row in rows)
    for part in ("along", "across"):
        gained = driven[f"acceleration_{part}"] - even[f"acceleration_{part}"]
        assert gained == pytest.approx(even[f"velocity_{part}"] / 2, abs=2e-9)
    # p of the crosshead is 1.25 at the dead centre, α/ω² times nothing more, though ω has a factor π.
    tie = figures(
        "--ratio=1:4", "--point=0", "--angle=0", "--stroke=1m", "--speed=60/min", "--acceleration=3rad/s²",
        "--columns=acceleration_along", "--digits=1", "--rounding=half-even",
    )  # fmt: skip
    assert tie[0]["acceleration_along"] == "1.2"


def test_the_infinite_rod_has_ellipses_and_the_parallel_crank_circles() -> None:
    about = ("--point=0.4", "--step=20", "--digits=8", "--columns=phi,path_along,path_across")
    for row in figures("--method=infinite", *about):
        across = float(row["path_across"]) / 0.4
        assert (1 - float(row["path_along"])) ** 2 + across**2 == pytest.approx(1, abs=1e-7)
    circles = figures("--mechanism=parallel", "--point=0.4;7.0,2.0", "--step=20", f"--columns=phi,{EVERY}")
    pin = figures("--ratio=1:5", "--point=1", "--step=20", f"--columns=phi,{EVERY}")
    assert circles == [{"point": point, **row} for point in ("0.4", "7,2") for row in pin]


def test_the_first_order_is_that_of_the_crosshead() -> None:
    about = ("--ratio=1:4", "--method=series", "--angle=50;130", "--digits=8")
    point = figures(*about, "--point=0.3,0.2", f"--columns={EVERY}")
    sine, cosine = np.sin(np.radians([50, 130])), np.cos(np.radians([50, 130]))
    x, c, p = 1 - cosine + sine**2 / 8, sine + sine * cosine / 4, cosine + np.cos(np.radians([100, 260])) / 4
    true = {
        "path_along": 0.7 * x + 0.3 * (1 - cosine) - 0.2 * sine,
        "path_across": 0.3 * sine + 0.2 * (4 - sine**2 / 8),
        "velocity_along": 0.7 * c + 0.3 * sine - 0.2 * cosine,
        "velocity_across": 0.3 * cosine - 0.2 * sine * cosine / 4,
        "acceleration_along": 0.7 * p + 0.3 * cosine + 0.2 * sine,
        "acceleration_across": -0.3 * sine - 0.2 * np.cos(np.radians([100, 260])) / 4,
    }
    for key, expected in true.items():
        assert_allclose([float(row[key]) for row in point], expected, rtol=0, atol=6e-9)


def test_units_and_lengths_say_the_same() -> None:
    size = ("--stroke=200mm", "--rod=500mm", "--speed=300/min", "--angle=50", "--digits=6")
    by_length, by_share = (
        figures(*size, f"--point={one}", "--columns=path_along_mm,velocity_mps,acceleration_mps2")
        for one in ("150mm,-50 mm", "0.3,-0.1")
    )
    assert by_length == by_share
    (bare,) = figures(
        "--ratio=1:5", "--point=0.3,-0.1", "--angle=50", "--digits=12",
        "--columns=path_along,velocity,acceleration",
    )  # fmt: skip
    pin = 0.1 * 10 * np.pi
    true = [float(one) for one in bare.values()] * np.array([100, pin, pin**2 / 0.1])
    assert_allclose([float(one) for one in by_length[0].values()], true, rtol=1e-7, atol=0)


DRIVES: list[dict[str, Any]] = [
    {"ratio": "1:5"},
    {"ratio": "1:3", "offset": "-0.8"},
    {"ratio": "1:4.5", "mechanism": "arc", "rocker": "7", "offset": "0.7"},
    {"ratio": "1:5", "mechanism": "beam", "beam": "3"},
    {"mechanism": "parallel"},
]


@pytest.mark.parametrize("drive", DRIVES, ids=str)
def test_second_differences_of_the_path_are_its_acceleration(drive: dict[str, Any]) -> None:
    """At 10³ angles. With steps h the differences are off by h²/12 times a fourth slope of less than 60, and
    by rounding, 4·10⁻¹⁵/h²: together less than 10⁻⁵; first ones by h²/6 times a third slope."""
    step = 1e-3
    degrees = np.linspace(0, 360, 1000, endpoint=False) + 0.01
    before, here, after = (
        kurbel.compute(degrees + np.degrees(one), columns=EVERY, point="0.37,0.2", **drive)
        for one in (-step, 0.0, step)
    )
    for part in ("along", "across"):
        first, middle, last = (one[f"path_{part}"] for one in (before, here, after))
        slope, bend = (last - first) / (2 * step), (last - 2 * middle + first) / step**2
        assert_allclose(here[f"velocity_{part}"], slope, rtol=0, atol=1e-5)
        assert_allclose(here[f"acceleration_{part}"], bend, rtol=0, atol=1e-5)
