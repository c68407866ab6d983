"""A flywheel found for a degree of irregularity keeps it, masses at their true speed and all."""

from __future__ import annotations

import pytest
from cli import printed

SIZES = ("--stroke", "600mm", "--bore", "300mm", "--speed", "120/min", "--reciprocating", "300kg")
ROD = ("--rod-mass", "150kg", "--centre", "0.6", "--gyration", "0.3")
STEAM = ("--eps", "4", "--pressure", "8bar")
MACHINES = {
    "steam": (*STEAM, *SIZES, *ROD),
    "two cranks": (*STEAM, *SIZES, "--cranks", "0;90"),
    "offset": (*STEAM, *SIZES, *ROD, "--offset", "0.4", "--ratio", "1:4"),
    "rocker": (*STEAM, *SIZES, *ROD, "--mechanism", "arc", "--rocker", "5"),
    "compressor": ("--pressure-ratio", "4", "--suction-pressure", "1bar", *SIZES),
    "gas engine": ("--compression", "6", "--heat", "8", "--suction-pressure", "1bar", *SIZES[:-1], "60kg"),
}


@pytest.mark.parametrize("machine", MACHINES)
def test_the_flywheel_found_keeps_the_irregularity(machine: str) -> None:
    words, wanted = MACHINES[machine], "0.1"
    page = ("flywheel", *words, "--delta", wanted, "--columns", "inertia_true", "--digits", "6", "-f", "csv")
    inertia = printed(*page).out.split()[-1].split(",")[-1]
    kept = ("delta", *words, "--inertia", f"{inertia}kgm2", "--columns", "delta_mean", "-f", "csv")
    found = printed(*kept, "--digits", "6").out.split()[-1].split(",")[-1]
    assert abs(float(found) - float(wanted)) < 2e-6
