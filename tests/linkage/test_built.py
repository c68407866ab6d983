"""Which links turn and swing, and what is said of those that do not; axles of equal cranks."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction

import numpy as np
import pytest
from cli import records
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import kurbel

TENTHS = st.integers(3, 80)
HEIGHTS = st.integers(-80, 80)


def refused(**drive: object) -> str:
    """Return why there is no such drive, or nothing if it turns."""
    try:
        kurbel.compute([0.0], columns="path", **drive)  # type: ignore[arg-type]
    except kurbel.KurbelError as error:
        return str(error)
    return ""


def arc(rod: Fraction, rocker: Fraction, distance: Fraction, height: Fraction) -> str:
    return refused(mechanism="arc", ratio=1 / rod, rocker=rocker, pivot=(distance, height))


def turns_and_swings(rod: float, rocker: float, pivot: complex) -> bool:
    """Whether the links close at every crank angle and the rocker comes back instead of going round."""
    cranks = np.linspace(0, 2 * np.pi, 2881) + cmath.phase(pivot)
    apart = pivot - np.exp(1j * cranks)
    cosine = (rocker**2 + np.abs(apart) ** 2 - rod**2) / (2 * rocker * np.abs(apart))
    if (np.abs(cosine) >= 1).any():
        return False
    turn = np.unwrap(np.angle(-apart) + np.arccos(cosine))
    return bool(abs(turn[-1] - turn[0]) < 1)


@settings(max_examples=200, deadline=None)
@given(rod=st.integers(11, 80), rocker=TENTHS, distance=TENTHS, height=HEIGHTS)
def test_an_arc_crank_is_built_if_and_only_if_it_turns_and_swings(
    rod: int, rocker: int, distance: int, height: int
) -> None:
    pivot = complex(distance, height) / 10
    # Links that come into line, and a pivot on the crank circle, are refused without a scan in floats.
    shortest, *others, longest = sorted((1, rod / 10, rocker / 10, abs(pivot)))
    assume(abs(shortest + longest - sum(others)) > 1e-9)
    assume(abs(abs(pivot) - 1) > 1e-9)
    said = arc(*(Fraction(one, 10) for one in (rod, rocker, distance, height)))
    assert turns_and_swings(rod / 10, rocker / 10, pivot) == (said == "")


@settings(max_examples=100, deadline=None)
@given(rod=st.integers(11, 80), rocker=st.integers(11, 80), distance=TENTHS, height=HEIGHTS)
def test_the_message_names_a_change_that_will_do(rod: int, rocker: int, distance: int, height: int) -> None:
    lengths = [Fraction(each, 10) for each in (rod, rocker, distance, height)]
    said = arc(*lengths)
    assume(said)
    if "pivot left in place" not in said:
        assert "farther than the crank radius" in said
        return
    change = Fraction(said.rsplit(" by ", 1)[1].removesuffix(" R"))
    longer = 0 if "too far" in said or "rod longer" in said else 1
    for place, by in ((longer, change), (1 - longer, change if "too far" in said else -change)):
        changed = list(lengths)
        changed[place] += by
        assert not arc(*changed)
        # No less than the message says, but for its rounding.
        changed[place] -= by / abs(by) * Fraction(4, 10**6)
        assert arc(*changed)


def margins(arm: float, rod: float) -> list[float]:
    """How much the sum of the other two of arm, rod and ground exceeds the crank with the longest, of each
    place of the shaft with which the beam swings alike to both sides and the shaft lies below (Grashof)."""
    swing = np.linspace(np.arcsin(1 / arm), np.pi / 2, 50_001)[:-1] if arm > 1 else np.empty(0)
    half, chord = arm * (1 - np.cos(swing)) / 2, arm * np.sin(swing)
    closing = half < rod - 1
    half, chord, swing = half[closing], chord[closing], swing[closing]
    found = []
    for side in (1, -1):
        height = chord + side * np.sqrt((rod - 1) ** 2 - half**2)
        misses = (height + chord) ** 2 + half**2 - (rod + 1) ** 2
        for at in np.flatnonzero(np.diff(np.sign(misses))):
            x, y = arm * np.cos(swing[at]) + half[at], -height[at]
            shortest, other, longest = sorted((arm, rod, float(np.hypot(x, y))))
            if shortest > 1 and y * arm * np.cos(swing[at]) + x * chord[at] < 0:
                found.append(shortest + other - longest - 1)
    return found


@settings(max_examples=75, deadline=None)
@given(thousandths=st.integers(500, 6000), percent=st.integers(2, 99))
def test_a_beam_engine_is_built_if_and_only_if_its_crank_turns(thousandths: int, percent: int) -> None:
    ways = margins(thousandths / 1000, 100 / percent)
    assume(all(abs(one) > 1e-3 for one in ways))
    said = refused(mechanism="beam", ratio=Fraction(percent, 100), beam=Fraction(thousandths, 1000))
    assert any(one > 0 for one in ways) == (said == "")


# Equal cranks ------------------------------------------------------------------------------------


def test_every_cell_of_the_parallel_crank_is_that_of_its_pin() -> None:
    keys = ("coupler_path", "coupler_velocity", "coupler_acceleration", "coupler_rise",
            "coupler_rise_velocity", "coupler_rise_acceleration")  # fmt: skip
    forces = (
        "tangential_force",
        "torque",
        "radial_force",
        "tangential_force_n",
        "torque_nm",
        "radial_force_n",
    )
    turn = ("--mechanism=parallel", "--step=7.5", "--to=360", "--digits=12", "--columns")
    motion = records("table", *turn, ",".join(("phi", *keys)))
    pushed = records("forces", *turn, ",".join(("phi", *forces)), "--force=10kN", "--stroke=600mm")
    assert len(motion) == len(pushed) == 49
    for moved, force in zip(motion, pushed, strict=True):
        phi = math.radians(float(moved["phi"]))
        sine, cosine = math.sin(phi), math.cos(phi)
        along = (1 - cosine, sine, cosine, sine, cosine, -sine)
        assert [float(moved[key]) for key in keys] == pytest.approx(along, rel=0, abs=1e-12)
        works = (sine, sine, cosine, 10_000 * sine, 3000 * sine, 10_000 * cosine)
        assert [float(force[key]) for key in forces] == pytest.approx(works, rel=1e-14, abs=3e-12)


@pytest.mark.parametrize(("rounding", "half"), [("half-away", "1"), ("half-even", "0")])
def test_ties_of_the_parallel_crank_are_rounded_as_asked(rounding: str, half: str) -> None:
    asked = ("--mechanism=parallel", "--angle=60;30;120", "--digits=0", f"--rounding={rounding}")
    rows = records("table", *asked, "--columns=coupler_path,coupler_velocity,coupler_acceleration")
    assert rows[0]["coupler_path"] == rows[1]["coupler_velocity"] == half
    assert rows[2]["coupler_acceleration"] == f"-{half}".replace("-0", "0")
    assert rows[2]["coupler_path"] == "2"
