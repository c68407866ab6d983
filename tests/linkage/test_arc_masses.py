"""Pages of the arc crank with its moving masses: newtons of Newton's equations in SI units, and ties."""

from __future__ import annotations

import json
from collections.abc import Sequence
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
        " pivot J = 19 kg m², ω = 23 rad/s",
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


HELD = {
    "arc": ("auch die Masse am Schwingenende", "also keeps the mass at the rocker's end"),
    "beam": ("ohne die Masse am Kolben", "without the mass at the piston"),
}


@pytest.mark.parametrize(("mechanism", "length"), [("arc", "--rocker=5"), ("beam", "--beam=5")])
@pytest.mark.parametrize(
    "load", [(), ("--eps=4", "--bore=300mm", "--pressure=8bar")], ids=["masses", "steam"]
)
def test_the_force_of_the_rocker_holds_on_its_arc_what_its_page_says(
    mechanism: str, length: str, load: tuple[str, ...]
) -> None:
    drive = (f"--mechanism={mechanism}", length, "--ratio=1:4", "--stroke=600mm", "--angle=130")
    speed, mass = "--speed=100/min", "--reciprocating=20kg"
    moved = printed(
        "table", *drive, speed, "--columns=slant,velocity_mps", "--digits=9", "-f", "csv"
    ).records()
    forces = ("forces", *drive, speed, mass, *load, "--columns=guide_force_n,rod_force_n")
    force = printed(*forces, "--digits=6", "-f", "csv").records()[0]
    slant, velocity = (float(one) for one in moved[0].values())
    # A rod without mass presses on the end; the rest is m c²/B.
    rest = float(force["guide_force_n"]) - float(force["rod_force_n"]) * mp.sin(mp.radians(slant))
    held = 20 * velocity**2 / 1.5 if mechanism == "arc" else 0
    assert rest == pytest.approx(held, rel=0, abs=1e-5)
    for lang, sentence in zip(("de", "en"), HELD[mechanism], strict=True):
        assert sentence in " ".join(printed(*forces, f"--lang={lang}").out.split())
        assert sentence not in " ".join(
            printed(*forces[:-1], "--columns=rod_force_n", f"--lang={lang}").out.split()
        )


def slope(quantity: str, values: Sequence[Real], step: Real) -> Real:
    """Return the first or the second slope over the angle in radians, of values a step of degrees apart."""
    before, here, after = values
    width = mp.radians(step)
    first = quantity == "velocity"
    return (after - before) / (2 * width) if first else (after - 2 * here + before) / width**2


@pytest.mark.parametrize(
    ("drive", "turning"),
    [
        (("arc", "--rocker=5"), ("Drehung der Schwinge positiv", "turning of the rocker positive")),
        (
            ("arc", "--rocker=5", "--pivot=4;-4.6"),
            ("Drehung der Schwinge positiv", "turning of the rocker positive"),
        ),
        (("beam", "--beam=5"), ("Drehung des Balanciers positiv", "turning of the beam positive")),
    ],
    ids=str,
)
@pytest.mark.parametrize("quantity", ["velocity", "acceleration"])
def test_turning_of_rocker_and_rod_counts_as_their_page_says(
    drive: tuple[str, ...], turning: tuple[str, str], quantity: str
) -> None:
    step, (mechanism, *links) = mp.mpf("0.01"), drive
    words = ("table", f"--mechanism={mechanism}", *links, "--ratio=1:4")

    def at(degrees: float, *columns: str) -> dict[str, mp.mpf]:
        asked = (f"--angle={degrees}", f"--columns={','.join(columns)}", "--digits=12", "-f", "csv")
        return {key: mp.mpf(one) for key, one in printed(*words, *asked).records()[0].items()}

    for stroke in ("", "_return"):
        # ψ grows against the crank; θ, as the crank turns, is positive where the path grows.
        angles = [at(70 + float(step) * place, f"path{stroke}", f"rod{stroke}") for place in (-1, 0, 1)]
        path, rod = ([one[key] for one in angles] for key in (f"path{stroke}", f"rod{stroke}"))
        found = at(70, f"turn_{quantity}{stroke}", f"rod_{quantity}{stroke}")
        assert found[f"turn_{quantity}{stroke}"] == pytest.approx(
            slope(quantity, path, step) / 5, rel=0, abs=1e-4
        )
        assert found[f"rod_{quantity}{stroke}"] == pytest.approx(
            slope(quantity, [mp.radians(one) for one in rod], step), rel=0, abs=1e-4
        )
    columns = f"--columns=turn_{quantity},rod_{quantity}_return"
    for lang, sentence, rod_says in zip(
        ("de", "en"),
        turning,
        ("Stange positiv gegen den Drehsinn", "rod positive against the sense"),
        strict=True,
    ):
        page = " ".join(printed(*words, "--angle=70", columns, f"--lang={lang}").out.split())
        assert sentence in page
        assert rod_says in page


def test_the_page_of_forces_says_the_size_once() -> None:
    run = ("--reciprocating=85kg", "--stroke=0.64m", "--speed=90/min", "--force=7kN", "--angle=40")
    page = " ".join(printed("forces", "--mechanism=arc", "--rocker=6", *run, "--lang=en").out.split())
    assert page.count("R = 320 mm") == page.count("n = 90 min⁻¹") == 1
    # Where no line above has them, the masses have.
    page = " ".join(printed("turning", "--eps=4", "--bore=300mm", "--pressure=8bar", *run[:3]).out.split())
    assert "85 kg, r = 320 mm, n = 90 min⁻¹" in page.replace("R = 320", "r = 320")
