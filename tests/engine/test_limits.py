"""Drives that come near to the straight crank print its pages, digit for digit."""

from __future__ import annotations

import pytest
from cli import printed

NEAR = {
    "offset": ("--offset", "0.000000000001"),
    "arc": ("--mechanism", "arc", "--rocker", "1000000000"),
    "arc from below": ("--mechanism", "arc", "--rocker", "1000000000", "--pivot", "5;-1000000000"),
}
HEAVY = (
    "--stroke", "600mm", "--bore", "300mm", "--pressure", "8bar", "--speed", "120/min", "--reciprocating",
    "300kg", "--rod-mass", "150kg", "--centre", "0.6", "--gyration", "0.3",
)  # fmt: skip
# Between the dead centres, for in them the forces jump.
ANGLES = ("--angle", "10;45;90;137;190;225;270;353")
PAGES = {
    "delta": ("delta", "--eps", "2..4", "--columns", "epsilon,delta,mean_force,v_min,v_max"),
    "heavy delta": ("delta", "--eps", "4", *HEAVY),
    "turning": ("turning", "--eps", "3", "--cranks", "0;90"),
    "forces": ("forces", "--eps", "4", *ANGLES),
    "heavy forces": ("forces", "--eps", "4", *HEAVY, *ANGLES),
    "flywheel": ("flywheel", "--eps", "4", "--power", "50kW", "--speed", "2/s", "--delta", "1:100"),
}


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("drive", NEAR)
def test_a_drive_near_the_straight_crank_prints_its_digits(drive: str, page: str) -> None:
    words = (*PAGES[page], "-f", "csv")
    assert printed(*words, *NEAR[drive]).out == printed(*words).out


@pytest.mark.parametrize("page", PAGES)
def test_no_offset_is_the_straight_crank(page: str) -> None:
    assert printed(*PAGES[page], "--offset", "0").out == printed(*PAGES[page]).out
