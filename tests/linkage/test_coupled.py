"""Coupled axles: against the equilibrium of every axle and every pin, solved as it stands."""

from __future__ import annotations

import math

import numpy as np
import pytest
from cli import printed

ANGLES = ("11", "90", "163.5", "217")


def equilibrium(weights: list[float], driven: int, angle: float) -> list[list[float]]:
    """Return torque and force of the rod to the next axle, of each axle, for F = 1 at the driven pin.

    Unknown are the rods' forces and the effort of the whole; every axle is in equilibrium about its shaft.
    """
    count, sine = len(weights), math.sin(math.radians(angle))
    matrix, right = np.zeros((count, count)), np.zeros(count)
    for axle, weight in enumerate(weights):
        # A rod that presses one pin forward presses the other back; the sign is that away from the driven.
        for rod, side in ((axle - 1, -1), (axle, 1)):
            if 0 <= rod < count - 1:
                away = -side if rod >= driven - 1 else side
                matrix[axle, rod] = away * sine
        matrix[axle, -1] = -weight
        right[axle] = -sine if axle == driven - 1 else 0.0
    *rods, effort = np.linalg.solve(matrix, right).tolist()
    return [[weight * effort, rod] for weight, rod in zip(weights, [*rods, math.nan], strict=True)]


@pytest.mark.parametrize(
    ("weights", "driven"), [([14, 15.5, 13], 2), ([1, 1, 1, 1], 1), ([2.5, 7], 2), ([3, 1, 4, 1, 5], 4)]
)
def test_every_axle_is_in_equilibrium_with_the_coupling_rods(weights: list[float], driven: int) -> None:
    alike = len(set(weights)) == 1
    said = str(len(weights)) if alike else ";".join(map(str, weights))
    words = (
        "forces",
        "--mechanism=parallel",
        f"--axles={said}",
        f"--driven={driven}",
        f"--angle={';'.join(ANGLES)}",
    )
    columns = "phi,axle,tangential_force,radial_force,torque_nm,coupling_force,coupling_force_n"
    rows = printed(
        *words, f"--columns={columns}", "--force=7kN", "--stroke=1.2m", "--digits=9", "-f", "csv"
    ).records()
    assert [(row["phi"], row["axle"]) for row in rows] == [
        (angle if "." in angle else f"{angle}.0", str(axle))
        for angle in ANGLES
        for axle in range(1, len(weights) + 1)
    ]
    for row in rows:
        torque, rod = equilibrium(weights, driven, float(row["phi"]))[int(row["axle"]) - 1]
        assert float(row["tangential_force"]) == pytest.approx(torque, abs=1e-9)
        assert float(row["torque_nm"]) == pytest.approx(7000 * 0.6 * torque, abs=1e-5)
        across = torque / math.tan(math.radians(float(row["phi"])))
        assert float(row["radial_force"]) == pytest.approx(across, abs=1e-9)
        if int(row["axle"]) == len(weights):
            assert (row["coupling_force"], row["coupling_force_n"]) == ("", "")
        else:
            assert float(row["coupling_force"]) == pytest.approx(rod, abs=1e-9)
            assert float(row["coupling_force_n"]) == pytest.approx(7000 * rod, abs=1e-5)
