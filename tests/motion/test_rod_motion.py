"""What the rod does: its angular velocity and acceleration, against triangles that mpmath differentiates."""

from __future__ import annotations

import pytest
from links import DIGITS, pointer
from mpmath import mp

import kurbel

RADPS = "rod_velocity_radps,rod_acceleration_radps2"


def figures(table: kurbel.Table) -> list[float]:
    """Return the numbers of a page of one row."""
    _, row = kurbel.typeset(table, "csv").splitlines()
    return [float(one) for one in row.split(",")]


@pytest.mark.parametrize(("degrees", "offset"), [("60", "0"), ("217", "0"), ("60", "-40mm"), ("310", "70mm")])
def test_the_rod_of_a_slider_crank_turns_as_the_closed_triangle_does(degrees: str, offset: str) -> None:
    # "The crank of a slider-crank turns at 300/min, crank 150 mm, rod 600 mm; find ... of the rod at 60°."
    page = kurbel.table(
        stroke="300mm", rod="600mm", speed="300/min", offset=offset, angle=degrees, columns=RADPS, digits=6
    )
    with mp.workdps(DIGITS):
        aside = mp.mpf(offset.removesuffix("mm"))

        def rod(time: object) -> object:
            # The crosshead is where the rod reaches the slide; the rod points to it from the pin.
            pin = 150 * pointer(mp.radians(mp.mpf(degrees)) + 10 * mp.pi * time)
            across = aside - pin.imag
            return -mp.arg(mp.mpc(mp.sqrt(600**2 - across**2), across))

        true = [float(mp.diff(rod, 0)), float(mp.diff(rod, 0, 2))]
    assert figures(page) == pytest.approx(true, rel=0, abs=6e-7)


def test_conditions_on_the_rod_hold_where_its_slope_vanishes() -> None:
    page = kurbel.solve_table(
        ["rod_velocity=max", "rod_acceleration=0"], ratio="1:2.5", offset="0.4", columns="phi_turn", digits=5
    )
    rows = kurbel.typeset(page, "csv").splitlines()[1:]
    found = sorted(float(row.split(",")[-1]) for row in rows)

    def slope(phi: object) -> object:
        return mp.diff(lambda at: mp.asin((mp.sin(at) - mp.mpf("0.4")) / mp.mpf("2.5")), phi, 2)

    # In a turn the rod turns fastest either way once, near the dead centres.
    true = [mp.degrees(mp.findroot(slope, start)) for start in (3.2, 6.2)]
    ends = [mp.degrees(mp.asin(mp.mpf("0.4") / (mp.mpf("2.5") + side))) for side in (1, -1)]
    assert found == pytest.approx([float(one) for one in (ends[0], true[0], true[1], true[1])], abs=6e-6)
