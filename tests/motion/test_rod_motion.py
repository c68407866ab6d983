"""What the rod does, and the times of the strokes, by kurbel.verify; at conditions and in arrays."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from cli import records
from figures import figures

import kurbel
from kurbel import verify

RADPS = ("rod_velocity_radps", "rod_acceleration_radps2", "rod_along", "slowest_point")


@pytest.mark.parametrize(("degrees", "offset"), [("60", "0"), ("217", "0"), ("60", "-40"), ("310", "70")])
def test_the_rod_of_a_slider_crank_turns_as_the_closed_triangle_does(degrees: str, offset: str) -> None:
    # "The crank of a slider-crank turns at 300/min, crank 150 mm, rod 600 mm; find ... of the rod at 60°."
    size = ("--stroke=300mm", "--rod=600mm", "--speed=300/min", f"--offset={offset}mm", "--digits=12")
    (row,) = records("table", *size, f"--angle={degrees}", f"--columns={','.join(RADPS)}")
    drive = verify.drive("1:4", Fraction(offset) / 150, speed=5, turns=True)
    for key in RADPS:
        assert drive.value(key, degrees).confirms(row[key]) == verify.CONFIRMED, key


def test_conditions_on_the_rod_hold_where_its_slope_vanishes() -> None:
    where = ("--where=rod_velocity=max", "--where=rod_acceleration=0")
    words = ("solve", *where, "--ratio=1:2.5", "--offset=0.4", "--columns=phi_turn", "--digits=9")
    found = sorted({Fraction(row["phi_turn"]) for row in records(*words)})
    drive, step = verify.drive("1:2.5", "0.4"), Fraction(1, 10**8)
    # In a turn the rod turns fastest either way once; at a dead centre the return stroke begins with less.
    assert drive.value("phi_i").scaled(9) == found[0] * 10**9
    for angle in found[1:]:
        slopes = [float(drive.value("rod_acceleration", angle + side * step)) for side in (-1, 1)]
        assert slopes[0] * slopes[1] < 0
    assert len(found) == 3


def test_strokes_of_an_offset_crank_take_their_times() -> None:
    given: dict[str, Any] = {"stroke": "300mm", "rod": "500mm", "offset": "60mm", "speed": "90/min"}
    drive = verify.drive("3:10", "0.4", speed=Fraction(3, 2), turns=True)
    # Arrays have the times of pages, at an angle beyond the turn, too.
    found = kurbel.compute([400.0, 30.0], columns="time", **given)["time"]
    assert found == pytest.approx([float(drive.value("time", angle)) for angle in (400, 30)], rel=1e-14)


def test_a_time_on_a_rounding_boundary_is_told() -> None:
    # 27° at 100/min are 0.045 s; at e/(L + R) = 1/2 the outstroke begins at 30°, and 57° are the same.
    for drive, angle in (({"ratio": "1:4"}, 27), ({"ratio": "1:7", "offset": "4"}, 57)):
        page = kurbel.table(
            **drive, stroke="2m", speed="100/min", angle=angle, columns="time", digits=2, rounding="half-even"
        )
        assert figures(page, ["time"]) == [[0.04]]
