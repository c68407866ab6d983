"""Engines whose piston works at a rocker's end: turns against brute force on a fine grid, limits, pages."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from cli import printed, refusal
from links import CRANKS, shown
from numpy.testing import assert_allclose
from places import CARDS
from rocker_curve import Curve, Weights
from rocker_curve import Steam as Card

from kurbel.drive.crank_forces import CRANK_FORCES
from kurbel.drive.rod import Moving, rod_of_sections
from kurbel.drive.rod import Section as Part
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.turn import Turn
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.reading.units import Speed

EACH = pytest.mark.parametrize("crank", CRANKS, ids=shown)
# Angles at which no crank of these is cut off.
PLACES = (17, 63, 130, 222, 341)
ARC = ("--mechanism", "arc", "--rocker", "6")


@EACH
def test_a_turn_under_steam_is_that_of_a_fine_grid(crank: ArcCrank) -> None:
    curve, turn = (
        Curve(crank, Card(4.0, 0.1)),
        Turn(Engine(crank, Steam(Fraction(4), Fraction(1, 10))), "exact"),
    )
    assert_allclose(float(turn.mean_force()), curve.mean, rtol=0, atol=1e-10)
    assert_allclose(float(turn.irregularity()), curve.irregularity, rtol=0, atol=1e-9)
    for degrees in PLACES:
        half_turns = Fraction(degrees, 180)
        energy, force = curve.at(curve.energy, degrees), curve.at(curve.force, degrees)
        assert_allclose(float(turn.energy_at(half_turns)), energy, rtol=0, atol=1e-9)
        assert_allclose(float(turn.tangential_force(half_turns)), force, rtol=0, atol=1e-8)


def heavy(crank: ArcCrank) -> ArcCrank:
    """The crank with a rod of two points, in kg, a mass and a moment of inertia at its rocker."""
    parts = (Part(Fraction(0), Fraction(0), Fraction(20)), Part(Fraction(3, 5), Fraction(3, 5), Fraction(30)))
    moving = Moving(Fraction(80), rod_of_sections(parts, kilograms=True), rocker=Fraction(15))
    known = replace(
        crank.crank, radius=Fraction(3, 10), speed=Speed(Fraction(11), turns=False), moving=moving
    )
    changed = crank.of(known)
    assert isinstance(changed, ArcCrank)
    return changed


@pytest.mark.parametrize("crank", CRANKS[1:7:2], ids=shown)
def test_a_turn_with_masses_is_that_of_a_fine_grid(crank: ArcCrank) -> None:
    load, steam = Load(Fraction(3, 10), Fraction(800_000)), Steam(Fraction(3), Fraction(1, 20))
    turn = Turn(Engine(heavy(crank), steam, load=load), "exact")
    unit = 0.3 * 11**2 / (np.pi / 4 * 0.3**2 * 800_000)
    rod = ((0.0, 0.0, 20 * unit), (0.6, 0.0, 30 * unit))
    rocker = 15 * unit / (float(crank.rocker) * 0.3) ** 2
    curve = Curve(crank, Card(3.0, 0.05), Weights(80 * unit, rocker, rod), 36_000)
    assert_allclose(float(turn.irregularity()), curve.irregularity, rtol=0, atol=1e-7)
    for degrees in PLACES:
        half_turns = Fraction(degrees, 180)
        energy, force = curve.at(curve.energy, degrees), curve.at(curve.force, degrees)
        assert_allclose(float(turn.energy_at(half_turns)), energy, rtol=0, atol=1e-8)
        assert_allclose(float(turn.tangential_force(half_turns)), force, rtol=0, atol=1e-7)
        # What turns the shaft is what the force at the crank pin does.
        own = turn.crank_force(CRANK_FORCES["tangential_force"], half_turns)
        assert_allclose(float(own), force, rtol=0, atol=1e-7)


@EACH
def test_the_cut_off_counts_on_the_arc_from_its_own_dead_centres(crank: ArcCrank) -> None:
    turn, curve = Turn(Engine(crank, Steam(Fraction(4), Fraction(0))), "exact"), Curve(crank, Card(4.0, 0.0))
    for stroke in (0, 1):
        begun = stroke + float(turn.cylinder.drive.dead_centre(stroke))
        place = 180 * (begun + float(turn.cut_off(stroke))) % 360
        assert_allclose(curve.at(curve.share, place), 0.25, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    "asked",
    [
        ("delta", "--eps", "2..6", "--digits", "7"),
        ("turning", "--eps", "4", "--back", "0.1", "--step", "30"),
        ("flywheel", "--eps", "4", "--power", "50kW", "--speed", "120/min", "--delta", "1:100"),
        ("forces", "--eps", "4", "--bore", "300mm", "--pressure", "8bar", "--stroke", "600mm",
         "--reciprocating", "90kg", "--speed", "2/s", "--rod-mass", "50kg", "--centre", "0.6",
         "--gyration", "0.3", "--angle", "20;140;250"),
        ("delta", "--card", str(CARDS / "condenser.csv")),
    ],
    ids=lambda asked: asked[0],
)  # fmt: skip
def test_a_long_rocker_gives_the_pages_of_the_straight_crank(asked: tuple[str, ...]) -> None:
    words = (*asked, "--ratio", "1:4.5", "-f", "csv")
    assert printed(*words, "--mechanism", "arc", "--rocker", "1000000000").out == printed(*words).out


def test_pages_call_the_parts_of_the_drive_by_their_names() -> None:
    asked = ("forces", *ARC, "--eps", "4", "--columns", "guide_force,crosshead_pin_force,rod_force")
    page = " ".join(printed(*asked, "--lang", "en").out.split())
    for said in (
        "Rocker force", "Rocker-pin force", "N along the rocker on its end", "S at the rocker's end",
        "G magnitude at the rocker pin", "The piston acts at the rocker's end, along its arc",
        "B = 6 R, D = 5 R",
    ):  # fmt: skip
        assert said in page
    assert "rosshead" not in page
    assert "Kreuzkopf" not in printed(*asked, "--lang", "de").out


def test_first_order_formulas_are_those_of_the_slide() -> None:
    said = 'method "series" has no formulas for the arc crank; use exact'
    assert refusal("delta", "--eps", "4", *ARC, "--method", "series") == said


def test_a_constant_force_on_a_rocker_is_greatest_at_a_dead_centre() -> None:
    # Over a wide interval a rocker may stand anywhere; that the force does not change is to be seen even so.
    asked = (
        "forces",
        *ARC,
        "--layout",
        "rod-load",
        "--pump",
        "--columns",
        "thrust,thrust_angle",
        "-f",
        "csv",
    )
    rows = [row.split(",")[-2:] for row in printed(*asked).out.split()[1:]]
    assert rows[0] == ["1.0000", "179.60"]
