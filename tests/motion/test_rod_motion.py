"""What the rod does: its angular velocity and acceleration, against triangles that mpmath differentiates."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from links import DIGITS, pointer
from mpmath import mp

import kurbel
from kurbel.drive.crank import Crank
from kurbel.motion.evaluation import certified
from kurbel.motion.quantities import registry
from kurbel.reading.units import Speed

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


def test_the_time_from_dead_centre_to_half_stroke_is_that_of_the_even_crank() -> None:
    page = kurbel.solve_table(
        "s=50%", stroke="300mm", rod="500mm", offset="60mm", speed="12rad/s", columns="time", digits=7
    )
    found = [float(row.split(",")[-1]) for row in kurbel.typeset(page, "csv").splitlines()[1:]]
    r, rod, e = mp.mpf(150), mp.mpf(500), mp.mpf(60)
    far, near = (mp.sqrt((rod + side * r) ** 2 - e**2) for side in (1, -1))

    def path(phi: object) -> object:
        return far - r * mp.cos(phi) - mp.sqrt(rod**2 - (r * mp.sin(phi) - e) ** 2)

    begun = mp.asin(e / (rod + r)), mp.pi + mp.asin(e / (rod - r))
    halves = [mp.findroot(lambda phi: path(phi) - (far - near) / 2, start) for start in (1.5, 4.8)]
    true = [float((half - first) / 12) for half, first in zip(halves, begun, strict=True)]
    assert found == pytest.approx(true, rel=0, abs=6e-8)


def test_strokes_of_an_offset_crank_take_their_times() -> None:
    given: dict[str, Any] = {"stroke": "300mm", "rod": "500mm", "offset": "60mm", "speed": "90/min"}
    page = kurbel.dead_centres_table(columns="outstroke_time,return_time", **given, digits=7)
    found = [float(one) for one in kurbel.typeset(page, "csv").splitlines()[1].split(",")]
    ends = mp.asin(mp.mpf(60) / 650), mp.pi + mp.asin(mp.mpf(60) / 350)
    out = (ends[1] - ends[0]) / (3 * mp.pi)
    assert found[-2:] == pytest.approx([float(out), float(mp.mpf(2) / 3 - out)], rel=0, abs=6e-8)
    # Arrays have the same times, at an angle beyond the turn, too.
    rows = kurbel.compute([400.0, 30.0], columns="time", **given)["time"]
    true = [(mp.radians(angle) - ends[0]) / (3 * mp.pi) for angle in (400, 30)]
    assert rows == pytest.approx([float(one) for one in true], rel=1e-14)


def test_a_time_on_a_rounding_boundary_is_told() -> None:
    # 27° at 100/min are 0.045 s; at e/(L + R) = 1/2 the outstroke begins at 30°, and 57° are the same.
    straight = Crank(Fraction(1, 4), radius=Fraction(1), speed=Speed(Fraction(5, 3)))
    offset = Crank(Fraction(1, 7), Fraction(4), Fraction(1), Speed(Fraction(5, 3)))
    for crank, degrees in ((straight, 27), (offset, 57)):
        found = certified(registry()["time"], "exact", crank, Fraction(degrees), 2, "half-even")
        assert found == 4
