"""δ and flywheels with the moving masses, against the kinetic energy of the bodies themselves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from figures import figures, rows
from hypothesis import given, settings
from hypothesis import strategies as st
from machines import machine
from numpy.testing import assert_allclose
from strokes import number, pressure_of

import kurbel
from kurbel.kernel.circle import circle
from kurbel.kernel.moving import Masses
from kurbel.kernel.rod import LoadedCrank

SIZES = {"stroke": "600mm", "bore": "300mm", "speed": "120/min", "reciprocating": "300kg"}
ROD = {"rod_mass": "150kg", "centre": "0.6", "gyration": "0.3"}
STEAM = {"eps": "4", "pressure": "8bar"}
MACHINES: dict[str, dict[str, Any]] = {
    "steam": {**STEAM, **SIZES, **ROD},
    "two cranks": {**STEAM, **SIZES, "cranks": "0;90"},
    "offset": {**STEAM, **SIZES, **ROD, "offset": "0.4", "ratio": "1:4"},
    "rocker": {**STEAM, **SIZES, **ROD, "mechanism": "arc", "rocker": "5"},
    "compressor": {"pressure_ratio": "4", "suction_pressure": "1bar", **SIZES},
    "gas engine": {
        "compression": "6",
        "heat": "8",
        "suction_pressure": "1bar",
        **SIZES,
        "reciprocating": "60kg",
    },
}


@pytest.mark.parametrize("name", MACHINES)
def test_a_flywheel_has_the_energies_of_the_moving_bodies(name: str) -> None:
    options = MACHINES[name]
    one, omega = machine(**options), 2 * math.pi * 2
    unit = math.pi / 4 * number(options["bore"]) ** 2 * pressure_of(options) * 0.3
    columns = ("power", "mean_torque", "swing_share", "swing", "inertia", "inertia_true")
    page = kurbel.flywheel(**options, delta="0.1", columns=columns, digits=6)
    (found,) = figures(page, columns)
    torque, swing = abs(one.turn.mean) * unit, one.turn.swing * unit
    wanted = [torque * omega, torque, one.turn.delta, swing, swing / 0.1 / omega**2]
    assert_allclose(found[:-1], wanted, rtol=1e-11, atol=1e-6)
    # With the masses at their true speed the flywheel keeps the irregularity.
    assert abs(one.speed(inertia=found[-1] * omega**2 / unit).delta - 0.1) < 1e-7


@pytest.mark.parametrize("slope", ["", "-130"])
@pytest.mark.parametrize("name", MACHINES)
def test_energy_and_torque_over_the_turn_are_those_of_the_bodies_and_their_height(
    name: str, slope: str
) -> None:
    options = {**MACHINES[name], **({"slope": slope} if slope and name != "rocker" else {})}
    turn, angles = machine(**options).turn, (17, 158, 241, 322)
    columns = ("tangential", "energy")
    page = kurbel.turning(**options, angle=angles, columns=columns, digits=8)
    wanted = np.column_stack([turn.machine.force(angles), turn.at(turn.energy, angles)])
    assert_allclose(figures(page, columns), wanted, rtol=0, atol=6e-9)


def test_a_bank_leans_by_its_angle_from_the_slope() -> None:
    common: dict[str, Any] = {**MACHINES["steam"], "gravity": "9.81", "columns": "torque_nm", "digits": 4}
    both = kurbel.turning(**common, slope="vertical", cylinder=["angle=0", "bank=60"], angle="25;140")
    first = kurbel.turning(**common, slope="vertical", angle="25;140")
    # The crank reaches the leaning axis by 60° later.
    second = kurbel.turning(**common, slope=150, angle="325;80")
    whole, *parts = (figures(page, ("torque_nm",)) for page in (both, first, second))
    assert_allclose(whole, sum(parts), rtol=0, atol=1.1e-4)


def delta(**options: Any) -> float:
    page = kurbel.delta(**options, columns="delta", digits=9)
    return float(rows(page)[0]["delta"])


def test_speed_in_radians_is_the_same_speed_and_next_to_no_mass_changes_next_to_nothing() -> None:
    assert delta(**{**MACHINES["steam"], "speed": f"{4 * math.pi!r}rad/s"}) == delta(**MACHINES["steam"])
    assert delta(**{**STEAM, **SIZES, "reciprocating": "0.0000001kg"}) == delta(eps="4")


@settings(max_examples=60, deadline=None)
@given(st.floats(0, 360), st.floats(-0.9, 0.9), st.floats(-1, 1))
def test_torque_takes_the_energy_and_its_slope_is_right(degrees: float, ratio: float, couple: float) -> None:
    masses, step = Masses(0.3, 0.7, couple), 1e-3
    at = [circle(degrees + offset * math.degrees(step)) for offset in (-2, -1, 1, 2)]
    weights = np.array([1, -8, 8, -1]) / (12 * step)
    energy: Any = [LoadedCrank(one, ratio, masses).kinetic_energy() for one in at]
    torque: Any = [LoadedCrank(one, ratio, masses).torque() for one in at]
    here: Any = LoadedCrank(circle(degrees), ratio, masses)
    scale = (1 - abs(ratio)) ** -3
    assert_allclose(float(here.torque()), -weights @ energy, rtol=0, atol=1e-8 * scale)
    assert_allclose(float(here.torque_slope()), weights @ torque, rtol=0, atol=1e-7 * scale)


def test_every_extreme_of_a_heavy_engine_is_found() -> None:
    one = machine(**MACHINES["steam"])
    assert len(one.turn.extremes) == 6
    columns = "alpha_min,v_min,alpha_max,v_max"
    (found,) = rows(kurbel.delta(**MACHINES["steam"], columns=columns, digits=8))
    for end in ("min", "max"):
        true = one.turn.extreme(end == "max")
        assert float(found[f"alpha_{end}"]) == pytest.approx(true.degrees, abs=1e-7)
        assert float(found[f"v_{end}"]) == pytest.approx(true.energy, abs=1e-8)
