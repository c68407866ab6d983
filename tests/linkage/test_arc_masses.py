"""Pages of the arc crank with its moving masses: newtons of Newton's equations in SI units, and ties."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from bodies import Body, Mass, Real, spread
from cli import printed, refusal
from links import CRANKS, DIGITS, real, shown
from mpmath import mp
from rockers import Heavy

import kurbel
from kurbel.linkage.arc.crank import ArcCrank

KEYS = (
    "rod_force", "guide_force", "tangential_force", "radial_force", "crosshead_pin_force", "crank_pin_force",
    "bearing_along", "bearing_across", "bearing_force",
)  # fmt: skip
NAMES = {"tangential_force": "torque", "crank_pin_force": "pin_force"}
MASSES = ("--reciprocating=85kg", "--rod-mass=55kg", "--centre=0.62", "--gyration=0.31", "--rotating=21kg")
RUN = ("--stroke=0.64m", "--speed=23rad/s", "--force=7kN", "--rocker-inertia=19kg m²", "--digits=9")


def words(crank: ArcCrank) -> list[str]:
    ratio, height = crank.crank.ratio, crank.pivot_height
    distance = crank.distance or 1 / ratio
    return [
        "forces",
        "--mechanism=arc",
        f"--ratio={ratio.numerator}/{ratio.denominator}",
        f"--rocker={float(crank.rocker)}",
        f"--pivot={float(distance)};{float(height)}",
    ]


def newtons(crank: ArcCrank) -> Heavy:
    """The same machine in units of R and of the forces m R ω²."""
    radius, speed = mp.mpf("0.32"), mp.mpf(23)
    unit = radius * speed**2
    body = spread(mp.mpf("0.38"), mp.mpf("0.31") ** 2)
    masses = (mp.mpf(55) * unit, mp.mpf(85) * unit, 19 * unit / (real(crank.rocker) * radius) ** 2, 21 * unit)
    return Heavy(crank, body, *masses, mp.mpf(7000))


@pytest.mark.parametrize("crank", [one for one in CRANKS if one.circuit == 1][1:4], ids=shown)
def test_pages_print_the_forces_of_newtons_equations(crank: ArcCrank) -> None:
    columns = [f"{key}{part}_n" for key in KEYS for part in ("", "_return")]
    asked = (*words(crank), *MASSES, *RUN, "--angle=37;160", "-f", "json", "--columns")
    rows = json.loads(printed(*asked, ",".join((*columns, "torque_nm", "torque_return_nm"))).out)["rows"]
    with mp.workdps(DIGITS):
        for row, degrees in zip(rows, (37, 160), strict=True):
            for stroke, part in ((1, ""), (-1, "_return")):
                expected = newtons(crank).newton(stroke, mp.radians(degrees))
                for key in KEYS:
                    assert is_rounded(row[f"{key}{part}_n"], expected[NAMES.get(key, key)]), key
                assert is_rounded(row[f"torque{part}_nm"], mp.mpf("0.32") * expected["torque"])


def is_rounded(found: Real, expected: Real) -> bool:
    return bool(abs(mp.mpf(found) - expected) < mp.mpf("0.502e-9") + abs(expected) * mp.mpf(10) ** -15)


ROD = ("--centre=0.62", "--gyration=0.31", "--columns")
NAMES_OF_ROD = {
    "guide": "guide_force", "pin_x": "pin_force_along", "pin_y": "pin_force_across", "pin": "pin_force",
    "torque": "torque",
}  # fmt: skip


@pytest.mark.parametrize("model", ["", "_two_mass", "_railway"])
def test_the_inertia_of_the_rod_is_that_of_newtons_equations(model: str) -> None:
    crank = CRANKS[2]
    bodies = {
        "": spread(mp.mpf("0.38"), mp.mpf("0.31") ** 2),
        "_two_mass": ends("0.38"),
        "_railway": ends("0.4"),
    }
    columns = ",".join(f"inertia_{key}{model}" for key in NAMES_OF_ROD)
    asked = ("inertia", *words(crank)[1:], *ROD, columns, "--angle=73;260", "--digits=9", "-f", "json")
    rows = json.loads(printed(*asked).out)["rows"]
    with mp.workdps(DIGITS):
        still = mp.mpf(0)
        body = Heavy(crank, bodies[model], mp.mpf(1), still, still, still, still)
        for row, degrees in zip(rows, (73, 260), strict=True):
            expected = body.newton(1, mp.radians(degrees))
            for key, name in NAMES_OF_ROD.items():
                assert is_rounded(row[f"inertia_{key}{model}"], expected[name]), key


def ends(crosshead: str) -> Body:
    """Two masses at the pins, this share at the rocker."""
    share = mp.mpf(crosshead)
    return [Mass(mp.mpf(0), 1 - share), Mass(mp.mpf(1), share)]


def test_a_tie_of_a_force_of_masses_is_told_where_the_speed_is_in_radians() -> None:
    # Where crank and rod are in line the rod slants by asin 3/5 from the arc, c = 0 and p = (1 + λ)/(4/5):
    # the mass of 6 kg pulls the rod by 6 p/(4/5) = 11.25.
    for rounding, expected in (("half-away", "-11.3"), ("half-even", "-11.2")):
        page = kurbel.forces_table(
            "1:5",
            mechanism="arc",
            rocker=Fraction(5, 3),
            pivot=(5, Fraction(4, 3)),
            reciprocating=6,
            stroke=2,
            speed="1rad/s",
            angle=0,
            columns="rod_force_n",
            rounding=rounding,
        )
        assert kurbel.typeset(page, "csv").split()[1] == expected


def test_pages_say_where_the_masses_are() -> None:
    asked = (*words(CRANKS[0]), *MASSES, *RUN)
    page = " ".join(printed(*asked, "--lang", "en").out.split())
    for said in (
        "Masses: at the rocker's end 85 kg, crank less counterweight, at its pin 21 kg, rocker about its"
        " pivot J = 19 kg m², R = 320 mm, ω = 23 rad/s",
        "centre of mass a = 0.62 L from the rocker pin",
        "F along the arc, in the direction of the stroke",
    ):
        assert said in page
    assert "mean piston speed" not in page
    bare = printed("forces", *(one for one in asked[1:] if "force" not in one), "--lang", "de").out
    assert "$F$ längs" not in bare
    assert "am Schwingenende 85 kg" in " ".join(bare.split())


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (
            ("--stroke", "600mm", "--speed", "2/s", "--rocker-inertia", "20kg"),
            'rocker inertia "20kg" is in kilogram; it must be a moment of inertia such as 20kg m²',
        ),
        (("--rocker-inertia", "20kg m²"), "--rocker-inertia needs --stroke, --speed to become a force"),
    ],
)
def test_a_moment_of_inertia_has_its_unit_and_needs_a_speed(more: tuple[str, ...], said: str) -> None:
    assert refusal("forces", "--mechanism", "arc", "--rocker", "6", *more) == said


def test_the_straight_crank_has_no_rocker() -> None:
    said = "--rocker-inertia does not belong to the straight crank; it is for --mechanism arc or beam"
    assert refusal("forces", "--reciprocating", "3kg", "--rocker-inertia", "2kg m²") == said


def test_the_parallel_crank_has_no_rod_that_swings() -> None:
    assert refusal("inertia", "--mechanism", "parallel") == (
        "the parallel crank has no rod that swings; its inertia is computed of the straight, offset and arc"
        " crank and of the beam engine"
    )
