"""The masses that stand in for a rod have its mass, centre and moment of inertia; k is that of its swings."""

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


def swing(distance: float) -> str:
    """The time of a rod with k = 0.17 m, by the compound pendulum."""
    return f"{2 * pi * sqrt((0.17**2 + distance**2) / (9.81 * distance)):.17f}s"


@pytest.mark.parametrize(
    "how",
    [
        f"--centre=400mm --pendulum={swing(0.4)} --pendulum-from=crosshead --gravity=9.81",
        f"--centre=400mm --pendulum={swing(0.2)} --pendulum-from=crank --gravity=9.81",
        f"--pendulum={swing(0.45)};{swing(0.28)} --pendulum-from=-50mm;680mm --gravity=9.81",
        f"--centre=400mm --rod-inertia={5 * (0.17**2 + 0.15**2):.6f}kgm2 --rod-inertia-about=250mm",
    ],
)
def test_the_radius_of_gyration_is_that_of_swings_or_of_a_moment_of_inertia(how: str) -> None:
    rod = ("--rod=600mm", "--rod-mass=5kg")
    given = models(*rod, "--centre=400mm", "--gyration=170mm")
    for model, row in models(*rod, *how.split()).items():
        assert row == pytest.approx(given[model], abs=1e-9)
