"""Arrays of any quantity over the crank angle."""

from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kurbel
from kurbel import verify

TURN = np.arange(0.0, 720.0, 7.5)
STEAM: dict[str, Any] = {
    "eps": 3,
    "bore": 0.3,
    "pressure": 8e5,
    "stroke": 0.6,
    "speed": 2,
    "reciprocating": 200,
}
MACHINES: tuple[dict[str, Any], ...] = (
    {"eps": 4, "cranks": "0;90", "single_acting": True},
    {"eps": 3, "mechanism": "beam", "beam": 3},
    {"offset": "0.4", **STEAM},
    {"slope": "vertical", "friction": 500, "piston_rod": 0.05, **STEAM},
    {"pressure_ratio": 4, "clearance": "5%"},
    {"compression": 6, "heat": 10},
)


def test_the_torque_under_a_force_with_masses_is_that_of_newton() -> None:
    angles = TURN[::5]
    found = kurbel.compute(
        angles, "1:4", "torque_nm", stroke=0.6, force=10_000, speed=5, reciprocating=40, method="exact"
    )
    drive = verify.drive("1:4", radius="0.3", speed=5, turns=True)
    bodies = verify.bodies(drive, reciprocating=40, force=10_000)
    true = [float(bodies.value("torque_nm", str(angle))) for angle in angles]
    assert found["torque_nm"] == pytest.approx(true, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize("given", MACHINES, ids=lambda given: "-".join(given))
def test_arrays_of_engines_are_the_digits_that_pages_prove(given: dict[str, Any]) -> None:
    keys = ["tangential", "energy", "guide_force", "crank_pin_force"]
    found = kurbel.compute(TURN[1::5], "1:5", keys, **given)
    angles = ";".join(map(str, TURN[1::5]))
    page = kurbel.forces("1:5", angle=angles, columns=keys, digits=9, **given).to_numpy()
    for key in keys:
        assert np.abs(found[key] - page[key]).max() < 0.501e-9, key


def test_an_array_at_a_dead_centre_has_the_force_of_the_stroke_that_begins() -> None:
    force = kurbel.compute([-1e-9, 0, 180, 360], "1:5", "piston_force", eps=4, back=0)["piston_force"]
    assert force.tolist() == pytest.approx([-0.25, 1, -1, 1], abs=1e-9)


def test_an_indicator_card_has_arrays(tmp_path: Path) -> None:
    card = tmp_path / "card.csv"
    card.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(f"{x / 8},4,1" for x in range(9)))
    found = kurbel.compute(
        [[90], [270]], "1:∞", ["piston_force", "torque_nm"], card=str(card), bore=1, stroke=2
    )
    assert found["piston_force"].ravel().tolist() == pytest.approx([0.75, -0.75])
    assert found["torque_nm"].shape == (2, 1)
    assert found["torque_nm"][0, 0] == pytest.approx(3e5 * pi / 4)


def test_a_diagram_without_an_engine_has_arrays_over_any_turns() -> None:
    told: dict[str, Any] = {"torque": "5000 + 1500 sin(3φ)", "load_torque": "5000 + 600 sin φ"}
    keys = ["torque", "excess_torque", "excess_energy", "angular_acceleration"]
    found = kurbel.compute(TURN.reshape(2, -1), columns=keys, inertia=40, **told)
    phi = np.radians(TURN).reshape(2, -1)
    excess = 1500 * np.sin(3 * phi) - 600 * np.sin(phi)
    energy = 500 * (1 - np.cos(3 * phi)) - 600 * (1 - np.cos(phi))
    true = [5000 + 1500 * np.sin(3 * phi), excess, energy, excess / 40]
    for key, values in zip(keys, true, strict=True):
        np.testing.assert_allclose(found[key], values, rtol=1e-12, atol=1e-9, err_msg=key)


def test_several_ratios_broadcast_with_the_angles() -> None:
    texts, angles = ["1:4", "2:9", "1:4", "1:5"], np.array([[30.0], [200.0], [725.0]])
    singles = [kurbel.compute(angles.ravel(), one, ["x", "p"]) for one in texts]
    several: tuple[Any, ...] = (texts, np.array(texts), np.array([texts]), [0.25, "2:9", "0.25", 0.2])
    grids = (kurbel.compute(angles, ratios, ["x", "p"]) for ratios in several)
    for grid in grids:
        for key in ("x", "p"):
            assert grid[key].tolist() == np.array([one[key] for one in singles]).T.tolist()
    pairs = kurbel.compute([30, 60, 90, 120], texts, "torque_nm", force=1000, stroke=0.5)["torque_nm"]
    each = [
        kurbel.compute(angle, one, "torque_nm", force=1000, stroke=0.5)["torque_nm"].item()
        for angle, one in zip((30, 60, 90, 120), texts, strict=True)
    ]
    assert pairs.tolist() == each
    assert kurbel.compute([30, 60], "1:4;1:5", "c")["c"].shape == (2,)
    assert kurbel.compute([30, 60], [["1:4"]], "c")["c"].shape == (1, 2)
    assert kurbel.compute([], ["1:4"], "c")["c"].shape == (0,)
    with pytest.raises(
        kurbel.KurbelError, match=r"^angles and ratio have the shapes \(3,\), \(2,\); they do"
    ):
        kurbel.compute([1, 2, 3], ["1:4", "1:5"])


def test_ratios_of_engines_are_text_too() -> None:
    found = np.asarray(kurbel.compute_delta([[2], [3]], ["1:4", "1:5"]))
    assert found.tolist() == np.asarray(kurbel.compute_delta([[2], [3]], [0.25, 0.2])).tolist()
    assert found.tolist() == np.asarray(kurbel.compute_delta([[2], [3]], "1:4;1:5")).tolist()
