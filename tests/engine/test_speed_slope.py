"""The angular acceleration under a flywheel is the slope of the square of its angular velocity."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import records

STEP = Fraction(1, 10**8)
DEGREE = Fraction(31415926535897932384626433832795, 180 * 10**31)


@pytest.mark.parametrize(
    "words",
    [
        "--eps=3 --ratio=1:4 --flywheel=40 --speed=90/min --cranks=0;90",
        "--eps=4 --stroke=60cm --bore=30cm --pressure=8bar --inertia=900kgm2 --speed=12rad/s --method=series",
        "--eps=4 --flywheel=60 --speed=2/s --method=weisbach",
        "--pressure-ratio=4 --flywheel=50 --speed=150/min",
        "--eps=3 --offset=0.2 --stroke=60cm --bore=30cm --pressure=8bar --inertia=60kgm2 --speed=12rad/s"
        " --reciprocating=300kg",
        "--eps=4 --flywheel=4 --speed=2/s --resistance=square",
    ],
)
def test_it_is_half_the_slope_of_the_square_of_the_speed(words: str) -> None:
    line = ("turning", *words.split(), "--digits=25", "--angle=66.99999999;67;67.00000001")
    before, at, after = records(*line, "--columns=omega,angular_acceleration")
    slope = (Fraction(after["omega"]) ** 2 - Fraction(before["omega"]) ** 2) / (4 * STEP * DEGREE)
    assert abs(slope - Fraction(at["angular_acceleration"])) < Fraction(1, 10**9)


def test_a_share_of_the_stroke_needs_no_length_beside_the_speed() -> None:
    line = ("turning", "--eps=4", "--flywheel=50", "--angle=s=25%", "--columns=phi,omega,tangential")
    (out, _) = records(*line, "--speed=120/min")
    assert (out["phi"], out["tangential"]) == ("55.3765", "0.6883")
