"""Arc cranks and beam engines under steam and with masses: quadrature, and Newton and Euler."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from cli import printed, records
from drives import ARCS, BEAMS, Drive, confirm, of_size, typed
from machines import machine
from mpmath import mp
from places import CARDS

from kurbel import verify

STEAM = {"eps": "3", "back": "0.1"}
SIZED = {"stroke": "600mm", "bore": "300mm", "pressure": "8bar", "speed": "11rad/s"}
MASSES = {"reciprocating": "80kg", "rod_mass": "50kg", "centre": "0.64", "gyration": "0.3",}  # fmt: skip
DRIVES: list[dict[str, Any]] = [
    {"mechanism": "arc", "ratio": "1:4.5", "rocker": "7", "offset": "0.7"},
    {"mechanism": "arc", "ratio": "1:3.5", "rocker": "9", "pivot": "3.7;-9.2"},
    {"mechanism": "arc", "ratio": "1:2.3", "rocker": "3.1", "pivot": "0.6;-2.7"},
    {"mechanism": "beam", "ratio": "2:7", "beam": "1.7"},
]


@pytest.mark.parametrize("drive", DRIVES, ids=lambda one: f"{one['mechanism']} {one['ratio']}")
@pytest.mark.parametrize("load", [STEAM, STEAM | SIZED | MASSES], ids=["steam", "masses"])
def test_a_turn_is_that_of_the_quadrature(drive: dict[str, Any], load: dict[str, Any]) -> None:
    inertia = {"rocker_inertia": "15"} if "speed" in load else {}
    true = machine(**drive, **load, **inertia)
    words = typed(drive | load | {key: f"{one}kg m²" for key, one in inertia.items()})
    (row,) = records("delta", *words, "--columns=mean_force,delta", "--digits=9")
    assert float(row["mean_force"]) == pytest.approx(true.turn.mean, abs=1.5e-9)
    assert float(row["delta"]) == pytest.approx(true.turn.delta, abs=1e-8)
    # At none of these steam is cut off.
    asked = ("--angle=17;63;130;222;341", "--columns=phi,tangential,energy", "--digits=9")
    for row in records("turning", *words, *asked):
        degrees = float(row["phi"])
        assert float(row["tangential"]) == pytest.approx(true.force(degrees), abs=1e-8)
        assert float(row["energy"]) == pytest.approx(true.turn.at(true.turn.energy, degrees), abs=1e-8)


@pytest.mark.parametrize(
    "asked",
    [
        ("delta", "--eps=2..6", "--digits=7"),
        ("flywheel", "--eps=4", "--power=50kW", "--speed=120/min", "--delta=1:100"),
        ("forces", "--eps=4", "--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--reciprocating=90kg",
         "--speed=2/s", "--rod-mass=50kg", "--centre=0.6", "--gyration=0.3", "--angle=20;140;250"),
        ("delta", "--card", str(CARDS / "condenser.csv")),
    ],
    ids=lambda asked: asked[0],
)  # fmt: skip
def test_a_long_rocker_or_beam_gives_the_pages_of_the_straight_crank(asked: tuple[str, ...]) -> None:
    words, long = (*asked, "--ratio=1:4.5", "-f", "csv"), "1000000000"
    straight = printed(*words).out
    assert printed(*words, "--mechanism=arc", f"--rocker={long}").out == straight
    if asked[0] != "forces":
        # A beam's piston draws at its end across the rod, not along the slide.
        assert printed(*words, "--mechanism=beam", f"--beam={long}").out == straight


def test_a_constant_force_on_a_rocker_is_greatest_at_a_dead_centre() -> None:
    # Over a wide interval a rocker may stand anywhere; that the force does not change is to be seen even so.
    asked = ("--mechanism=arc", "--rocker=6", "--layout=rod-load", "--pump", "--columns=thrust,thrust_angle")
    assert list(records("forces", *asked)[0].values())[-2:] == ["1.0000", "179.60"]


def test_two_cylinders_alike_on_one_beam_turn_as_one() -> None:
    cylinders = 2 * ("--cylinder", "bore=500mm pressure=3bar eps=3")
    beam = ("--mechanism=beam", "--beam=3", "--columns=delta", "--digits=6")
    assert records("delta", *beam, "--stroke=1.2m", *cylinders) == records("delta", *beam, "--eps=3")


# Masses ------------------------------------------------------------------------------------------

KEYS = (
    "rod_force", "guide_force", "tangential_force", "radial_force", "crosshead_pin_force", "crank_pin_force",
    "bearing_along", "bearing_across", "bearing_force",
)  # fmt: skip
RUN = ("--stroke=0.64m", "--speed=23rad/s", "--force=7kN", "--rocker-inertia=19kg m²", "--digits=9")
HEAVY = ("--reciprocating=85kg", "--rod-mass=55kg", "--centre=0.62", "--gyration=0.31", "--rotating=21kg")


@pytest.mark.parametrize("drive", [*ARCS, *BEAMS], ids=str)
def test_pages_print_the_forces_of_newtons_equations(drive: Drive) -> None:
    links, at_end, swinging = of_size(drive, "0.32", "23").true, Fraction(85), Fraction(19)
    if links.beam:
        # The piston of a beam acts at its end, too, but draws nothing square to the arc.
        assert links.rocker
        at_end, swinging = Fraction(0), swinging + 85 * (links.rocker * links.radius) ** 2
    rod = {"rod_mass": 55, "centre": "0.62", "gyration": "0.31", "rotating": 21}
    heavy = verify.bodies(links, reciprocating=at_end, inertia=swinging, force=7000, **rod)
    columns = [f"{key}{end}_n" for key in KEYS for end in ("", "_return")]
    columns += ["torque_nm", "torque_return_nm"]
    asked = (*HEAVY, *RUN, "--angle=37;160", f"--columns=phi,{','.join(columns)}")
    confirm(heavy, records("forces", *drive.words, *asked), columns)


def test_a_tie_of_a_force_of_masses_is_told_where_the_speed_is_in_radians() -> None:
    # Where crank and rod are in line the rod slants by asin 3/5 from the arc, c = 0 and p = (1 + λ)/(4/5):
    # the mass of 6 kg pulls the rod by 6 p/(4/5) = 11.25.
    drive = ("--mechanism=arc", "--ratio=1:5", "--rocker=5/3", "--pivot=5;4/3", "--angle=0")
    mass = ("--reciprocating=6kg", "--stroke=2m", "--speed=1rad/s", "--columns=rod_force_n")
    for rounding, expected in (("half-away", "-11.3"), ("half-even", "-11.2")):
        assert records("forces", *drive, *mass, f"--rounding={rounding}") == [{"rod_force_n": expected}]


@pytest.mark.parametrize(("mechanism", "length"), [("arc", "--rocker=5"), ("beam", "--beam=5")])
@pytest.mark.parametrize(
    "load", [(), ("--eps=4", "--bore=300mm", "--pressure=8bar")], ids=["masses", "steam"]
)
def test_the_force_of_the_rocker_holds_on_its_arc_what_its_page_says(
    mechanism: str, length: str, load: tuple[str, ...]
) -> None:
    drive = (f"--mechanism={mechanism}", length, "--ratio=1:4", "--stroke=600mm", "--angle=130")
    run = (*drive, "--speed=100/min", "--digits=9")
    ((slant, velocity),) = (row.values() for row in records("table", *run, "--columns=slant,velocity_mps"))
    forces = ("forces", *run, "--reciprocating=20kg", *load, "--columns=guide_force_n,rod_force_n")
    ((guide, rod),) = (row.values() for row in records(*forces))
    # A rod without mass presses on the end; the rest is m c²/B.
    rest = float(guide) - float(rod) * mp.sin(mp.radians(mp.mpf(slant)))
    held = 20 * float(velocity) ** 2 / 1.5 if mechanism == "arc" else 0
    assert rest == pytest.approx(held, rel=0, abs=1e-5)
    said = {"arc": "also keeps the mass at the rocker's end", "beam": "without the mass at the piston"}[
        mechanism
    ]
    assert said in " ".join(printed(*forces, "--lang=en").out.split())
    assert said not in " ".join(printed(*forces[:-1], "--columns=rod_force_n", "--lang=en").out.split())
