"""Engines whose piston and masses move to first order, against the formulas of textbooks on a fine grid."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from figures import rows
from places import CARDS

import kurbel

ENGINE: dict[str, Any] = {
    "ratio": "1:4", "stroke": "600mm", "speed": "14rad/s", "bore": "300mm", "pressure": "8bar",
    "reciprocating": "230kg", "rod_mass": "120kg", "centre": "0.62", "gyration": "0.29", "back": "0.1",
}  # fmt: skip
# n = L/R; masses at crosshead and pin, and M (k² - a b), by which two masses are wrong.
N, RADIUS, OMEGA, LENGTH = 4.0, 0.3, 14.0, 1.2
CROSSHEAD, COUPLE = 230 + 120 * (1 - 0.62), 120 * (0.29**2 - 0.62 * 0.38) * LENGTH**2
STEAM = 8e5 * np.pi / 4 * 0.3**2


def acting(degrees: Any, cut_off: float) -> Any:
    """Return the force on the piston in N and that of the moving masses at the crosshead, by
    x = r (1 - cos θ + sin² θ/2n) and ω² r (cos θ + cos 2θ/n)."""
    theta = np.radians(degrees % 180)
    sign = np.where(degrees % 360 < 180, 1, -1)
    share = (1 - np.cos(theta) + sign * np.sin(theta) ** 2 / (2 * N)) / 2
    steam = STEAM * (np.where(share <= cut_off, 1, cut_off / np.maximum(share, cut_off)) - 0.1)
    return steam, CROSSHEAD * RADIUS * OMEGA**2 * (np.cos(theta) + sign * np.cos(2 * theta) / N)


def turned(degrees: Any, cut_off: float) -> Any:
    """Return the torque of the engine in N m, of the forces at the angle φ of the rod: r sin (θ + φ)/cos φ;
    the correction couple's is a force on the guide."""
    theta = np.radians(degrees % 180)
    rod = np.arcsin(np.where(degrees % 360 < 180, 1, -1) * np.sin(theta) / N)
    steam, inertia = acting(degrees, cut_off)
    arm = RADIUS * np.sin(theta + rod) / np.cos(rod)
    # -I ε, of ε = -ω² sin θ/n, is held by the guide L cos φ off the pin, whose arm is r cos θ.
    guide = COUPLE * OMEGA**2 * np.sin(theta) / N / (LENGTH * np.cos(rod))
    return (steam - inertia) * arm + guide * RADIUS * np.cos(theta)


def power(degrees: Any, cut_off: float) -> Any:
    """Return the work over the angle in N m: the velocity of the piston r (sin θ + sin 2θ/2n), that of the
    rod cos θ/n."""
    theta = np.radians(degrees % 180)
    sign = np.where(degrees % 360 < 180, 1, -1)
    steam, inertia = acting(degrees, cut_off)
    velocity = RADIUS * (np.sin(theta) + sign * np.sin(2 * theta) / (2 * N))
    return (steam - inertia) * velocity + COUPLE * OMEGA**2 * np.sin(theta) * np.cos(theta) / N**2


def column(page: kurbel.Table, key: str) -> list[float]:
    return [float(row[key]) for row in rows(page)]


def test_the_turning_effort_is_that_of_textbooks() -> None:
    page = kurbel.turning(eps=2.5, method="series", angle="0..350:7", columns="torque_nm", digits=5, **ENGINE)
    angles = np.arange(0, 351, 7)
    assert column(page, "torque_nm") == pytest.approx(turned(angles, 0.4), rel=0, abs=1e-4)


def test_the_energy_swing_is_that_of_the_work() -> None:
    page = kurbel.flywheel(eps=2.5, method="series", delta="1:80", columns="swing", digits=2, **ENGINE)
    angles = np.arange(0, 360, 0.01) + 0.005
    torque = power(angles, 0.4)
    energy = np.cumsum(torque - torque.mean()) * np.radians(0.01)
    assert column(page, "swing") == pytest.approx([energy.max() - energy.min()], rel=1e-6)


COMPOSED = ("piston_force", "guide_force", "rod_force", "crank_pin_force", "tangential_force", "radial_force")
MASSES = {key: ENGINE[key] for key in ("reciprocating", "rod_mass", "centre", "gyration", "speed")}


@pytest.mark.parametrize("angle", [40, 118, 250])
def test_the_same_force_on_the_piston_has_the_same_effect_as_steam_and_as_a_force(angle: int) -> None:
    asked: dict[str, Any] = {"method": "series", "columns": (*(f"{key}_n" for key in COMPOSED), "torque_nm")}
    page = kurbel.forces(eps=2.5, angle=angle, digits=6, **asked, **ENGINE)
    by_steam = {key: column(page, key)[0] for key in asked["columns"]}
    # On the return an engine's pages keep the frame of the outstroke, those of a force its stroke's.
    sign = 1 if angle < 180 else -1
    force = f"{sign * by_steam['piston_force_n']:.6f}N"
    page = kurbel.forces(
        force=force, angle=angle % 180, stroke="600mm", ratio="1:4", digits=6, method="series", **MASSES,
        columns=[key if sign > 0 else key.replace("_n", "_return_n") for key in asked["columns"]],
    )  # fmt: skip
    for key in asked["columns"]:
        alone = column(page, key if sign > 0 else key.replace("_n", "_return_n"))[0]
        framed = sign if key in ("piston_force_n", "guide_force_n", "rod_force_n") else 1
        assert by_steam[key] == pytest.approx(framed * alone, rel=1e-9, abs=1e-5), key


@pytest.mark.parametrize("rod", [{}, {"rod_mass": "120kg", "centre": "0.62", "gyration": "0.29"}])
def test_tangential_and_radial_force_make_the_force_of_the_crank_pin(rod: dict[str, Any]) -> None:
    engine = {key: value for key, value in ENGINE.items() if key not in MASSES} | {"speed": "14rad/s"}
    page = kurbel.forces(
        eps=4, method="series", reciprocating="230kg", angle="0..350:7", digits=4, **engine, **rod,
        columns=[f"{key}_n" for key in COMPOSED] + ["torque_nm"],
    )  # fmt: skip
    found = {key: np.array(column(page, f"{key}_n")) for key in COMPOSED}
    composed = np.hypot(found["tangential_force"], found["radial_force"])
    assert found["crank_pin_force"] == pytest.approx(composed, rel=0, abs=2e-4)
    assert column(page, "torque_nm") == pytest.approx(found["tangential_force"] * RADIUS, rel=0, abs=1e-4)


def test_every_command_has_the_tangential_force_of_the_forces() -> None:
    asked: dict[str, Any] = {"eps": 4, "method": "series", **ENGINE}
    page = kurbel.forces(angle="0..350:14", columns="tangential_force_n", digits=4, **asked)
    torque = np.array(column(page, "tangential_force_n")) * RADIUS
    page = kurbel.turning(angle="0..350:14", columns="torque_nm", digits=4, **asked)
    assert column(page, "torque_nm") == pytest.approx(torque, rel=0, abs=1e-4)
    arrays = {key: value for key, value in asked.items() if key != "ratio"}
    drawn = kurbel.compute(np.arange(0.0, 351.0, 14.0), "1:4", "torque_nm", **arrays)
    assert drawn["torque_nm"].ravel() == pytest.approx(torque, rel=0, abs=1e-4)


def test_harmonics_are_those_of_the_tangential_force() -> None:
    load: dict[str, Any] = {"card": CARDS / "ideal-2.csv"}
    page = kurbel.harmonics("1:3", quantity="torque", method="series", orders=4, digits=6, **load)
    degrees = np.arange(0, 360) + 0.5
    turn = kurbel.turning(
        ratio="1:3", method="series", angle="0.5..359.5:1", columns="tangential", digits=9, **load
    )
    force = np.array(column(turn, "tangential"))
    for order, cosine, sine in zip(*(column(page, key) for key in ("order", "cosine", "sine")), strict=True):
        wave = 2 * (force * np.exp(1j * order * np.radians(degrees))).mean()
        # The power of first order would be off by ten times as much.
        assert complex(cosine, sine) == pytest.approx(complex(wave), abs=1e-4)
