"""The masses that stand in for a rod have its mass, centre and moment of inertia; k is that of its swing."""

from __future__ import annotations

from math import pi, sqrt

import pytest
from cli import printed

POINTS = (("crosshead_mass", "crosshead_place"), ("centre_mass", ""), ("crank_mass", "crank_place"))


def models(*words: str) -> dict[str, dict[str, float]]:
    rows = printed("inertia", "--layout=rod-masses", *words, "--digits=12", "-f", "csv").records()
    return {
        row["model"]: {key: float(value or 0) for key, value in row.items() if key != "model"} for row in rows
    }


@pytest.mark.parametrize(("centre", "gyration"), [(0.65, 0.35), (0.3, 0.6)])
def test_masses_move_like_the_rod(centre: float, gyration: float) -> None:
    found = models(f"--centre={centre}", f"--gyration={gyration}")
    assert [*found] == ["pins", "crosshead", "crank", "three"]
    for model, row in found.items():
        masses = [(row[mass], row[place] if place else centre) for mass, place in POINTS]
        inertia = sum(mass * (place - centre) ** 2 for mass, place in masses)
        assert sum(mass for mass, _ in masses) == pytest.approx(1, abs=1e-11)
        assert sum(mass * place for mass, place in masses) == pytest.approx(centre, abs=1e-11)
        assert inertia + row["lacking_inertia"] == pytest.approx(gyration**2, abs=1e-11)
        assert (row["lacking_inertia"] == 0) == (model != "pins")
    assert found["crosshead"]["crosshead_place"] == 0
    assert found["crank"]["crank_place"] == 1


@pytest.mark.parametrize(("pin", "distance"), [("crosshead", 0.4), ("crank", 0.2)])
def test_the_radius_of_gyration_is_that_of_the_swing(pin: str, distance: float) -> None:
    # A rod of 0.6 m and 5 kg with k = 0.17 m, by the compound pendulum.
    time = 2 * pi * sqrt((0.17**2 + distance**2) / (9.81 * distance))
    swing = (f"--pendulum={time:.17f}s", f"--pendulum-from={pin}", "--gravity=9.81")
    rod = ("--rod=600mm", "--centre=400mm", "--rod-mass=5kg")
    given = models(*rod, "--gyration=170mm")
    for model, row in models(*rod, *swing).items():
        assert row == pytest.approx(given[model], abs=1e-9)
