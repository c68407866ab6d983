"""The beam engine as a crank drive: links closed by mpmath, § 149, quadrature under steam, limits, pages."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from bodies import spread
from cli import printed, refusal
from links import DIGITS, links, real
from mpmath import mp
from numpy.testing import assert_allclose
from rocker_curve import Curve
from rocker_curve import Steam as Card
from rockers import Heavy

from kurbel.drive.crank import Crank
from kurbel.drive.rod import Moving, Rod
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.turn import Turn
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.beam.engine import EXACT, BeamEngine, registry
from kurbel.linkage.beam.engine import certified as dead_centre
from kurbel.linkage.beam.quantities import beam_registry
from kurbel.linkage.linkage import certified
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.reading.units import Speed

DECIMALS = 12
BEAMS = [
    BeamCrank(Crank(Fraction(1, 5)), Fraction(3)),
    BeamCrank(Crank(Fraction(2, 7)), Fraction("1.7")),
    BeamCrank(Crank(Fraction(1, 9)), Fraction("6.3")),
]
EACH = pytest.mark.parametrize("drive", BEAMS, ids=lambda one: f"{one.arm},{one.crank.ratio}")
BEAM = ("--mechanism", "beam", "--beam", "3")


@EACH
@pytest.mark.parametrize(("stroke", "degrees"), [(OUT, "37"), (OUT, "205.5"), (RETURN, "71")])
def test_motion_is_that_of_closed_links(drive: BeamCrank, stroke: int, degrees: str) -> None:
    with mp.workdps(DIGITS):
        for key in ("path", "velocity", "acceleration", "rocker", "rod", "slant", "rod_acceleration"):
            entry = beam_registry()[key if stroke == OUT else f"{key}_return"]
            found = certified(entry, drive, Fraction(degrees), DECIMALS)
            expected = links(drive).value(key, stroke, Fraction(degrees))
            assert abs(found - expected * 10**DECIMALS) < 0.501, key


@EACH
def test_dead_centres_and_small_paths_are_those_of_149(drive: BeamCrank) -> None:
    """The rod leans there by μ and ν, and the beam moves by the path up to the vertical crank."""
    book = BeamEngine(drive.arm, drive.crank.ratio)
    for key, stroke in (("path_1", OUT), ("path_2", RETURN)):
        entry = beam_registry()["path" if stroke == OUT else "path_return"]
        exact = dead_centre(registry()[key], book, EXACT, DECIMALS)
        assert certified(entry, drive, Fraction(0), DECIMALS) == exact.scaled
    inner, outer, apart = (
        dead_centre(registry()[key], book, EXACT, 8).scaled / 1e8 for key in ("mu", "nu", "distance_1")
    )
    with mp.workdps(DIGITS):
        found = [mp.degrees(dead[0]) for dead in (links(drive).inner, links(drive).outer)]
        assert abs(found[0] - inner) < 1e-8
        assert abs(found[1] - 180 - outer) < 1e-8
        assert abs(found[1] - found[0] - apart) < 1e-8


@EACH
def test_the_torque_is_that_of_virtual_work(drive: BeamCrank) -> None:
    with mp.workdps(DIGITS):
        for degrees in ("23", "140"):
            slope = links(drive).value("velocity", OUT, Fraction(degrees))
            found = certified(beam_registry()["torque"], drive, Fraction(degrees), DECIMALS)
            assert abs(found - slope * 10**DECIMALS) < 0.501


@EACH
def test_masses_at_the_piston_draw_nothing_to_the_rods_end(drive: BeamCrank) -> None:
    rod = Rod(Fraction("0.38"), Fraction("0.0961"), Fraction(50))
    moving = Moving(Fraction(90), rod, Fraction(12), Fraction(70))
    speed = Speed(Fraction(7), turns=False)
    loaded = drive.of(replace(drive.crank, radius=Fraction(1, 2), speed=speed, moving=moving))
    with mp.workdps(DIGITS):
        unit, arm = mp.mpf("24.5"), real(drive.arm) / 2
        tangential = (90 + 70 / arm**2) * unit
        body = Heavy(drive, spread(mp.mpf("0.38"), mp.mpf("0.0961")), 50 * unit, mp.mpf(0), tangential,
                     12 * unit, mp.mpf(0))  # fmt: skip
        for stroke, part in ((OUT, ""), (RETURN, "_return")):
            expected = body.newton(stroke, mp.radians(67))
            for key in ("rod_force", "guide_force", "radial_force", "bearing_across", "crosshead_pin_force"):
                found = certified(beam_registry()[f"{key}{part}_n"], loaded, Fraction(67), 9)
                assert abs(found - expected[key] * 10**9) < 0.502, key
            found = certified(beam_registry()[f"torque{part}_nm"], loaded, Fraction(67), 9)
            assert abs(found - expected["torque"] * 10**9 / 2) < 0.502


@EACH
def test_a_turn_under_steam_is_that_of_a_fine_grid(drive: BeamCrank) -> None:
    curve = Curve(drive, Card(3.0, 0.1))
    turn = Turn(Engine(drive, Steam(Fraction(3), Fraction(1, 10))), "exact")
    assert_allclose(float(turn.mean_force()), curve.mean, rtol=0, atol=1e-10)
    assert_allclose(float(turn.irregularity()), curve.irregularity, rtol=0, atol=1e-9)
    for degrees in (17, 63, 130, 222, 341):
        half_turns = Fraction(degrees, 180)
        energy, force = curve.at(curve.energy, degrees), curve.at(curve.force, degrees)
        assert_allclose(float(turn.energy_at(half_turns)), energy, rtol=0, atol=1e-9)
        assert_allclose(float(turn.tangential_force(half_turns)), force, rtol=0, atol=1e-8)


def test_conditions_hold_where_the_links_say() -> None:
    drive, asked = (
        BEAMS[0],
        ("solve", *BEAM, "--ratio", "1:5", "--columns", "phi_turn", "--digits", "9", "-f", "csv"),
    )
    with mp.workdps(DIGITS):
        for condition, key, aim in (
            ("p=0", "acceleration", 0),
            ("c=0.5", "velocity", 0.5),
            ("θ=7", "rocker", 7),
        ):
            rows = printed(*asked, "--where", condition).records()
            assert len(rows) in (2, 4)
            for row in rows:
                degrees = Fraction(row["phi_turn"])
                stroke = OUT if degrees < 181 else RETURN
                here = degrees if stroke == OUT else degrees - 180
                assert abs(links(drive).value(key, stroke, here) - aim) < 1e-7, condition
        assert printed(*asked, "--where", "c=max").out == printed(*asked, "--where", "p=0").out


@pytest.mark.parametrize(
    ("asked", "columns"),
    [
        (("table", "--step", "30"), ("x,x_return,c,p", "path,path_return,velocity,acceleration")),
        (("delta", "--eps", "2..5", "--digits", "6"), ()),
        (("turning", "--eps", "4", "--step", "40"), ()),
        (("forces", "--eps", "4", "--angle", "20;140;250"), ()),
    ],
    ids=lambda one: one[0] if one else "all",
)
def test_a_long_beam_gives_the_pages_of_the_straight_crank(
    asked: tuple[str, ...], columns: tuple[str, ...]
) -> None:
    ends: list[tuple[str, ...]] = [("--columns", one) for one in columns] or [(), ()]
    straight = printed(*asked, "-f", "csv", *ends[0]).out
    beam = printed(*asked, "--mechanism", "beam", "--beam", "1000000000", "-f", "csv", *ends[1]).out
    assert beam.split()[1:] == straight.split()[1:]


def test_an_infinite_rod_stays_vertical() -> None:
    page = printed(
        "table", *BEAM, "--ratio", "1:∞", "--angle", "0;180", "--columns", "phi,path,velocity", "-f", "csv"
    )
    assert page.out.split()[1:] == ["0,0.0000,0.0000", f"180,{6 * float(mp.asin(mp.mpf(1) / 3)):.4f},0.0000"]


def test_pages_say_what_the_drive_is() -> None:
    page = " ".join(printed("forces", *BEAM, "--eps", "4", "--lang", "en").out.split())
    for said in (
        "Beam force",
        "N along the beam on its end",
        "Watt's linkage is taken as perfect",
        "a = 3 R",
    ):
        assert said in page
    assert "ocker" not in page
    motion = printed("table", *BEAM, "--lang", "de").out
    assert "Kolbenweg" in motion
    assert "chwinge" not in motion


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("--mechanism", "beam"),
            "the beam engine needs the arm of its beam; add --beam, for example --beam 3",
        ),
        (("--beam", "3"), "--beam does not belong to the straight crank; it is for --mechanism beam"),
        (
            ("--mechanism", "beam", "--beam", "0.9"),
            "beam arm a is 0.9 r; it must be longer than the crank radius r, for the beam's end rises and"
            " falls by r at least",
        ),
        (
            (*BEAM, "--method", "series"),
            'method "series" has no formulas for the beam engine; use exact, with --ratio 1:∞ for the'
            " infinite rod",
        ),
        ((*BEAM, "--rocker", "4"), "--rocker does not belong to the beam engine; it is for --mechanism arc"),
    ],
)
def test_what_is_no_beam_engine_is_refused(words: tuple[str, ...], said: str) -> None:
    assert refusal("table", *words) == said


def test_dead_centres_of_the_drive_are_those_of_the_true_geometry() -> None:
    asked = ("deadcentres", "--beam", "3", "--ratio", "1:5", "--digits", "3", "-f", "csv", "--columns")
    drive = printed(*asked, "phi_i,phi_o,lead", "--mechanism", "beam").out.split()[1]
    mu, nu, apart = map(float, printed(*asked, "mu,nu,distance_1", "--exact").out.split()[1].split(","))
    assert list(map(float, drive.split(","))) == [mu, 180 + nu, round(apart - 180, 3)]
    several = refusal("deadcentres", "--mechanism", "beam", "--beam", "3;4")
    assert several == (
        "--mechanism beam is one engine, and 2 arms were given; leave --mechanism out for the angles of § 149"
    )


MACHINE = """
[crank]
mechanism = "beam"
beam = 3
ratio = "1:5"
stroke = "1.2m"
speed = "30/min"

[steam]
eps = 3
bore = "800mm"
pressure = "3bar"

[masses]
reciprocating = "900kg"
rocker = "9000kg m²"
"""
DRIVE = (*BEAM, "--ratio", "1:5", "--stroke", "1.2m", "--speed", "30/min")
STEAM = ("--eps", "3", "--bore", "800mm", "--pressure", "3bar")
MASSES = ("--reciprocating", "900kg", "--rocker-inertia", "9000kg m²")


@pytest.mark.parametrize(
    "asked",
    [("delta", *DRIVE, *STEAM, *MASSES), ("deadcentres", *DRIVE), ("solve", "--where", "c=max", *DRIVE),
     ("inertia", "--centre", "0.6", "--gyration", "0.4", *DRIVE)],
    ids=lambda asked: asked[0],
)  # fmt: skip
def test_a_machine_may_be_a_beam_engine(asked: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_text(MACHINE, encoding="utf-8")
    own = asked[: asked.index("--mechanism")]
    assert printed(*own, "--machine", str(path)).out == printed(*asked).out
    said = refusal("balance", "--machine", str(path), code=1)
    assert said.endswith(
        "crank.mechanism is beam, and kurbel balance is about the straight crank; leave the mechanism out of"
        " the machine"
    )


def test_what_is_reached_nowhere_is_told_with_its_bounds() -> None:
    said = refusal("solve", *BEAM, "--where", "c=1.1", code=1)
    assert said.startswith(
        "velocity = 1.1 is reached nowhere for R:L = 1:5; velocity lies between 0.0000 and 1.0"
    )
    rows = printed("solve", *BEAM, "--where", "c=0", "--columns", "path", "-f", "csv").records()
    assert [row["path"] for row in rows] == 2 * ["0.0000"]
    assert refusal("table", "--mechanism", "beam", "--beam", "3m") == (
        'beam "3m" is a length, but no length of the crank is known; add --crank or --stroke, or give it in'
        " units of R, for example 6"
    )


def test_two_cylinders_alike_on_one_beam_turn_as_one() -> None:
    cylinders = 2 * ("--cylinder", "bore=500mm pressure=3bar eps=3")
    asked = ("delta", *BEAM, "--columns", "delta", "--digits", "6", "-f", "csv")
    assert printed(*asked, "--stroke", "1.2m", *cylinders).out == printed(*asked, "--eps", "3").out
    page = printed("turning", *BEAM, "--stroke", "1.2m", *cylinders, "--lang", "en").out
    assert "Watt's linkage" in " ".join(page.split())


def test_conditions_hold_with_an_infinite_rod_too() -> None:
    # Its dead centres and the zero of its acceleration are at quarters of the turn.
    asked = ("solve", *BEAM, "--ratio", "1:∞", "--where", "p=0", "--columns", "phi_turn", "-f", "csv")
    assert [row["phi_turn"] for row in printed(*asked).records()] == ["90.0000", "270.0000"]
