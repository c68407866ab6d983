"""Free forces at an angle: against Newton's forces of the masses themselves, and the textbooks' formulas."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed
from courses import course, slide
from hypothesis import given, settings
from hypothesis import strategies as st

TURNS = 7
SQUARE = (2 * math.pi * TURNS) ** 2
RADIUS = 0.1
SIZE = (f"--stroke={2 * RADIUS}m", f"--speed={TURNS}/s")
Row = dict[str, str]


def page(*words: str) -> dict[tuple[str, float, str], Row]:
    rows = printed("balance", *words, "--digits=6", "--format=csv").records()
    return {(row["residual"], float(row["phi"]), row["order"]): row for row in rows}


def said(row: Row, unit: str = "_n") -> complex:
    return complex(float(row[f"along{unit}"]), float(row[f"across{unit}"]))


@dataclass(frozen=True)
class Cylinder:
    mass: float
    revolving: float
    crank: float
    bank: float
    place: float

    def pressed(self, phi: Any, rod: int, method: str = "exact") -> Any:
        """Return the force of the masses on the frame, in R ω²."""
        pin, leaning = np.radians(phi + self.crank), math.radians(self.bank)
        piston = course(slide(Fraction(1, rod), 0, method), "p")(pin - leaning)
        return self.mass * piston * cmath.exp(1j * leaning) + self.revolving * np.exp(1j * pin)


ENGINES = st.lists(
    st.builds(
        Cylinder,
        mass=st.integers(1, 9),
        revolving=st.integers(1, 5),
        crank=st.integers(0, 359),
        bank=st.integers(-90, 90),
        place=st.integers(0, 2000),
    ),
    min_size=1,
    max_size=5,
    unique_by=lambda one: (one.bank, one.place),
)


@settings(max_examples=10, deadline=None)
@given(engine=ENGINES, rod=st.integers(3, 6), phi=st.integers(0, 359), about=st.integers(-500, 500))
def test_all_orders_together_are_the_forces_of_the_masses(
    engine: list[Cylinder], rod: int, phi: int, about: int
) -> None:
    lists = {
        name: ";".join(str(getattr(one, name)) for one in engine)
        for name in ("mass", "revolving", "crank", "bank", "place")
    }
    found = page(
        *SIZE, f"--ratio=1:{rod}", f"--angle={phi}", f"--about={about}mm", f"--cranks={lists['crank']}",
        f"--banks={lists['bank']}", f"--positions={lists['place']}mm", f"--reciprocating={lists['mass']}kg",
        f"--revolving={lists['revolving']}kg",
    )  # fmt: skip
    forces = [RADIUS * SQUARE * one.pressed(phi, rod) for one in engine]
    moment = sum(force * (one.place - about) / 1000 for force, one in zip(forces, engine, strict=True))
    for residual, true in (("force", sum(forces)), ("moment", moment)):
        row = found[residual, phi, "all"]
        assert said(row) == pytest.approx(true, rel=1e-12, abs=1e-6)
        assert float(row["magnitude_n"]) == pytest.approx(abs(true), rel=1e-12, abs=1e-6)
        if row["direction"] and abs(true) > 1:
            assert cmath.rect(1, math.radians(float(row["direction"]))) == pytest.approx(
                true / abs(true), abs=1e-7
            )


@pytest.mark.parametrize("phi", [0, 25, 90, 214])
def test_a_v_twin_of_60_degrees_has_the_textbook_s_forces(phi: int) -> None:
    # m/2 √(9 cos² φ + sin² φ), and of the second order what the two slides have along and across.
    found = page("--cranks=0;0", "--banks=-30;30", "--ratio=1:4", f"--angle={phi}", "--method=series")
    angle = math.radians(phi)
    primary = math.hypot(3 * math.cos(angle), math.sin(angle)) / 2
    assert float(found["force", phi, "1"]["magnitude"]) == pytest.approx(primary, abs=1e-6)
    along = 2 * math.cos(math.radians(30)) * math.cos(2 * angle) * math.cos(math.radians(60)) / 4
    across = 2 * math.sin(math.radians(30)) * math.sin(2 * angle) * math.sin(math.radians(60)) / 4
    assert said(found["force", phi, "2"], "") == pytest.approx(complex(along, across), abs=1e-6)
    both = said(found["force", phi, "1"], "") + said(found["force", phi, "2"], "")
    assert said(found["force", phi, "sum"], "") == pytest.approx(both, abs=2e-6)


def test_a_share_balanced_leaves_the_textbook_s_force_and_names_the_counterweight() -> None:
    words: tuple[str, ...] = (
        "--engine=inline-1",
        "--share=0.65",
        "--reciprocating=50kg",
        "--revolving=37kg",
        *SIZE,
    )
    words += ("--revolving-share=1", "--balance-radius=400mm", "--angle=60", "--method=infinite")
    row = page(*words)["force", 60, "1"]
    angle = math.radians(60)
    force = 50 * RADIUS * SQUARE * math.hypot(0.35 * math.cos(angle), 0.65 * math.sin(angle))
    assert float(row["magnitude_n"]) == pytest.approx(force, abs=1e-6)
    text = " ".join(printed("balance", *words, "--lang=en").out.split())
    assert (
        f"mass times radius in kg m: {(0.65 * 50 + 37) * RADIUS:g}; at the radius 400 mm: 17.375 kg" in text
    )


def test_what_vanishes_at_every_angle_is_nought_by_proof() -> None:
    six = page("--engine=inline-6", "--angle=17", "--orders=4")
    assert {said(row, "") for key, row in six.items() if key[2] != "all"} == {0}
    boxer = printed("balance", "--engine=boxer-4", "--angle=17;80", "--format=csv").records()
    assert {row["magnitude"] for row in boxer if row["residual"] == "force"} == {"0"}
    assert {row["direction"] for row in boxer if row["residual"] == "force"} == {""}


@settings(max_examples=3, deadline=None)
@given(engine=ENGINES, rod=st.integers(2, 6), method=st.sampled_from(["exact", "series"]))
def test_the_greatest_is_that_of_a_fine_turn_and_is_reached_where_it_is_said(
    engine: list[Cylinder], rod: int, method: str
) -> None:
    words = (
        f"--ratio=1:{rod}", f"--cranks={';'.join(str(one.crank) for one in engine)}",
        f"--banks={';'.join(str(one.bank) for one in engine)}", f"--method={method}",
        f"--positions={';'.join(str(one.place) for one in engine)}",
    )  # fmt: skip
    shaft = np.radians(np.arange(0, 360, 0.05))
    middle = (min(one.place for one in engine) + max(one.place for one in engine)) / 2
    force = np.zeros(len(shaft), complex)
    moment = np.zeros(len(shaft), complex)
    for one in engine:
        pushed = replace(one, mass=1, revolving=0).pressed(np.degrees(shaft), rod, method)
        force += pushed
        moment += pushed * (one.place - middle)
    rows = printed("balance", *words, "--layout=balance-greatest", "--digits=4", "--format=csv").records()
    for row in rows:
        if row["order"] not in ("all", "sum"):
            continue
        curve = abs(force if row["residual"] == "force" else moment)
        height = float(np.max(curve))
        assert float(row["greatest"]) == pytest.approx(height, rel=2e-6, abs=1e-4)
        if row["greatest_phi"]:
            there = float(np.interp(math.radians(float(row["greatest_phi"])), shaft, curve))
            assert there == pytest.approx(height, rel=1e-5, abs=1e-4)


def test_what_lies_half_way_at_the_greatest_is_rounded_away() -> None:
    words = ("balance", "--engine=inline-1", "--ratio=1:4", "--layout=balance-greatest", "--format=csv")
    rows = printed(*words, "--digits=1").records()
    assert (rows[2]["order"], rows[2]["greatest"], rows[2]["greatest_phi"]) == ("all", "1.3", "0.0")
