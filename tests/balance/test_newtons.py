"""Free forces in newtons: against the masses themselves, moved through a turn."""

from __future__ import annotations

import numpy as np
import pytest
from cli import printed, refusal
from numpy.typing import NDArray

Floats = NDArray[np.float64]
STEPS = 4096
PHI = 2 * np.pi * np.arange(STEPS) / STEPS
RADIUS, ROD, TURNS = 0.31, 1.147, 2.3
MACHINE = (f"--ratio={RADIUS}:{ROD}", f"--stroke={2000 * RADIUS}mm", f"--speed={TURNS * 60}/min")
MASSES = ("--reciprocating=271kg", "--rod-mass=143kg", "--centre=0.62", "--gyration=0.31")


def acceleration(place: Floats) -> Floats:
    """Return the second slope over time of a coordinate over the turn, by its harmonics."""
    orders = np.fft.fftfreq(STEPS, 1 / STEPS)
    found = np.fft.ifft(np.fft.fft(place) * -((2 * np.pi * TURNS * orders) ** 2))
    return np.asarray(found.real)


def pressed(shift: float) -> Floats:
    """Return the force on the frame along the slide, of a cylinder whose crank leads by so many degrees.

    The crank pin's share of the rod, which turns, is taken as balanced.
    """
    phi = PHI + np.radians(shift)
    pin = RADIUS * np.cos(phi)
    crosshead = pin + np.sqrt(ROD**2 - (RADIUS * np.sin(phi)) ** 2)
    # Two points of 143 kg whose centre lies 0.62 of the rod from the crosshead, 0.31 to either side of it.
    rod = [71.5 * (crosshead + share * (pin - crosshead)) for share in (0.62 - 0.31, 0.62 + 0.31)]
    return -acceleration(271 * crosshead + sum(rod) - 0.62 * 143 * pin)


def amplitude(force: Floats, order: int) -> float:
    return float(2 * abs(np.fft.fft(force)[order]) / STEPS)


def page(*words: str) -> dict[tuple[str, int], dict[str, str]]:
    rows = printed("balance", *words, "--orders=4", "--digits=6", "--format=csv").records()
    return {(row["residual"], int(row["order"])): row for row in rows}


def test_masses_that_are_moved_press_on_the_frame_with_the_newtons_of_each_order() -> None:
    cranks, places = (0, 200, 75), (-0.9, 0.1, 0.9)
    said = ("--cranks=0;200;75", "--positions=0;1;1.8", "--spacing=1m")
    found = page(*MACHINE, *MASSES, *said)
    forces = np.array([pressed(crank) for crank in cranks])
    force, moment = forces.sum(axis=0), np.array(places) @ forces
    for residual, of in (("force", force), ("moment", moment)):
        for order in (1, 2, 4):
            assert float(found[residual, order]["along_n"]) == pytest.approx(amplitude(of, order), abs=2e-6)


def test_the_ratio_may_be_that_of_crank_and_rod() -> None:
    sized = (f"--stroke=crank:{1000 * RADIUS}mm", f"--rod={1000 * ROD}mm")
    said = ("--cranks=0;200;75", "--positions=0;1;1.8")
    weighed = ("--reciprocating=271kg", f"--speed={TURNS * 60}/min", *said)
    assert page(*sized, *weighed) == page(*MACHINE, "--reciprocating=271kg", *said)
    assert page(*sized, *said) == page(f"--ratio={RADIUS}:{ROD}", *said)
    refused = refusal("balance", f"--rod={1000 * ROD}mm")
    assert "--rod gives the ratio with the length of the crank; add --stroke" in refused


def test_one_cylinder_is_meant_by_masses_and_moments_need_the_length_of_their_arms() -> None:
    alone = page(*MACHINE, *MASSES)
    assert float(alone["force", 1]["along_n"]) == pytest.approx(amplitude(pressed(0), 1), abs=2e-6)
    assert alone["moment", 1]["along_n"] == "0"
    three = page(*MACHINE, *MASSES, "--engine=inline-3")
    assert (three["moment", 1]["along_n"], three["moment", 1]["across_n"]) == ("", "0")
    arm = page(*MACHINE, *MASSES, "--engine=inline-3", "--spacing=0.5m")["moment", 2]
    own = page(MACHINE[0], "--engine=inline-3")["moment", 2]
    mass = 271 + 143 * (1 - 0.62)
    unit = mass * RADIUS * (2 * np.pi * TURNS) ** 2 * 0.5
    assert float(arm["greatest_n"]) == pytest.approx(float(own["greatest"]) * unit, rel=1e-6)


def test_newtons_of_radians_a_second_that_lie_half_way_are_rounded_away() -> None:
    # 1.25 kg * 0.4 m * (0.5/s)² = 0.125 N.
    words = ("--reciprocating=1.25kg", "--stroke=800mm", "--speed=0.5rad/s", "--columns=along_n")
    rows = printed("balance", *words, "--digits=2", "--format=csv").records()
    assert rows[0] == {"residual": "force", "order": "1", "along_n": "0.13"}
