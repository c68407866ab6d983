"""Engines whose piston and masses move to first order, against the formulas of textbooks on a fine grid."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kurbel

ENGINE: dict[str, Any] = {
    "ratio": "1:4", "stroke": "600mm", "speed": "14rad/s", "bore": "300mm", "pressure": "8bar",
    "reciprocating": "230kg", "rod_mass": "120kg", "centre": "0.62", "gyration": "0.29", "back": "0.1",
}  # fmt: skip
# n = L/R; masses at crosshead and pin, and M (k² - a b), by which two masses are wrong.
N, RADIUS, OMEGA, LENGTH = 4.0, 0.3, 14.0, 1.2
CROSSHEAD, COUPLE = 230 + 120 * (1 - 0.62), 120 * (0.29**2 - 0.62 * 0.38) * LENGTH**2
STEAM = 8e5 * np.pi / 4 * 0.3**2


def turned(degrees: Any, cut_off: float) -> Any:
    """Return the torque of the engine in N m: force on the piston times r (sin θ + sin 2θ/2n), and the
    correction couple's by the rod's velocity ω cos θ/n."""
    theta = np.radians(degrees % 180)
    sign = np.where(degrees % 360 < 180, 1, -1)
    share = (1 - np.cos(theta) + sign * np.sin(theta) ** 2 / (2 * N)) / 2
    steam = STEAM * (np.where(share <= cut_off, 1, cut_off / np.maximum(share, cut_off)) - 0.1)
    inertia = CROSSHEAD * RADIUS * OMEGA**2 * (np.cos(theta) + sign * np.cos(2 * theta) / N)
    arm = RADIUS * (np.sin(theta) + sign * np.sin(2 * theta) / (2 * N))
    # The couple -I ε works at the rod's angular velocity; ε = -ω² sin θ/n.
    return (steam - inertia) * arm + COUPLE * OMEGA**2 * np.sin(theta) * np.cos(theta) / N**2


def column(page: kurbel.Table, key: str) -> list[float]:
    head, *rows = kurbel.typeset(page, "csv").splitlines()
    return [float(row.split(",")[head.split(",").index(key)]) for row in rows]


def test_the_turning_effort_is_that_of_textbooks() -> None:
    page = kurbel.turning_table(
        eps=2.5, method="series", angle="0..350:7", columns="torque_nm", digits=5, **ENGINE
    )
    angles = np.arange(0, 351, 7)
    assert column(page, "torque_nm") == pytest.approx(turned(angles, 0.4), rel=0, abs=1e-4)


def test_the_energy_swing_is_that_of_the_effort() -> None:
    page = kurbel.flywheel_table(eps=2.5, method="series", delta="1:80", columns="swing", digits=2, **ENGINE)
    angles = np.arange(0, 360, 0.01) + 0.005
    torque = turned(angles, 0.4)
    energy = np.cumsum(torque - torque.mean()) * np.radians(0.01)
    assert column(page, "swing") == pytest.approx([energy.max() - energy.min()], rel=1e-6)


def test_forces_of_an_engine_are_those_of_its_turning_effort() -> None:
    page = kurbel.forces_table(
        eps=2.5, method="series", angle="40;250", columns="tangential_force_n,torque_nm", digits=4, **ENGINE
    )
    torque = turned(np.array([40, 250]), 0.4)
    assert column(page, "torque_nm") == pytest.approx(torque, rel=0, abs=1e-3)
    assert column(page, "tangential_force_n") == pytest.approx(torque / RADIUS, rel=0, abs=1e-3)
