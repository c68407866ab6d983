"""Constructions of velocity and acceleration against derivatives of the crosshead's path in mpmath."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import partial

import pytest
from mpmath import mp, mpc, mpf

import kurbel
from kurbel.books.constructions.geometry import Point, cross, distance, dot, to
from kurbel.books.constructions.model import Placed, Points
from kurbel.books.constructions.registry import CONSTRUCTIONS, construction
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.kind import floats

RATES = {
    name for name, place in CONSTRUCTIONS.items() if place.startswith("kurbel.books.constructions.rates")
}
# The parts of the crosshead's acceleration about the crank pin, along the rod and square to it.
PARTS = {
    "acceleration": ("p′x", "xq′"),
    "autenrieth": ("QF", "FE"),
    "klein": ("CQ", "QN"),
    "rittershaus": ("CQ", "QN"),
}
ACCELERATIONS = [*PARTS]
EXACT = ["velocity", *ACCELERATIONS]
DIGITS = 20


def crosshead(rod: Fraction, offset: Fraction, angle: mpf) -> mpf:
    """Return how far the crosshead stands from the shaft along the slide, in units of R."""
    side = mp.sin(angle) - mpf(offset.numerator) / offset.denominator
    return mp.cos(angle) + mp.sqrt((mpf(rod.numerator) / rod.denominator) ** 2 - side**2)


def drives(name: str, count: int) -> list[tuple[Fraction, Fraction, Fraction]]:
    """Return rod, offset and angle, the same in every run, then 90° and, where they hold, dead centres."""
    dice = random.Random(name)
    holds = construction(name).holds
    found = []
    for place in range(count):
        rod = Fraction(dice.randint(115, 700), 100)
        reach = int(95 * (rod - 1))
        offset = dice.randint(-reach, reach) if "offset" in holds and place % 2 else 0
        found.append((rod, Fraction(offset, 100), Fraction(dice.randint(1, 3599), 10)))
    right = [(Fraction(3), Fraction(0), Fraction(angle)) for angle in (90, 270)]
    ends = [(Fraction(3), Fraction(0), Fraction(angle)) for angle in (0, 180)]
    return found + right + (ends if name != "rittershaus" else [])


def lengths(name: str, rod: Fraction, offset: Fraction, angle: Fraction) -> dict[str, tuple[str, ...]]:
    """Return what the page says of each length: drawn, true and error as text."""
    page = kurbel.construction_table(
        name,
        ratio=1 / rod,
        angle=angle,
        columns="length,symbol,drawn,true,error",
        digits=DIGITS,
        mechanism="offset" if offset else None,
        offset=offset or None,
    )
    rows = [line.split(",") for line in kurbel.typeset(page, "csv").splitlines()[1:]]
    return {row[1] or row[0]: tuple(row[2:]) for row in rows}


@pytest.mark.parametrize("name", EXACT)
def test_a_length_is_the_derivative_of_the_path_to_the_last_digit(name: str) -> None:
    for rod, offset, angle in drives(name, 6):
        with mp.workdps(60):
            place, at = mp.radians(mpf(angle.numerator) / angle.denominator), partial(crosshead, rod, offset)
            slope = mp.diff(at, place)
            # c and p count towards the shaft; u is how fast the crosshead moves against the crank pin.
            swing = mp.hypot(slope + mp.sin(place), mp.cos(place))
            true = {"c/ω": -slope, "p/ω²": -mp.diff(at, place, 2), "u/ω": swing}
            found = lengths(name, rod, offset, angle)
            for symbol in true.keys() & found.keys():
                drawn, certified, error = found[symbol]
                assert drawn == certified
                assert error == "0"
                assert abs(mpf(drawn) - true[symbol]) < mpf(10) ** -DIGITS * 0.51, (
                    rod,
                    offset,
                    angle,
                    symbol,
                )
        assert {"c/ω", "u/ω"} <= found.keys()
        assert all(drawn == certified for drawn, certified, _ in found.values())


def rod_end(rod: mpf, rocker: mpf, pivot: mpc, side: int, angle: mpf) -> mpc:
    """Return where the rod of an arc crank ends: on two circles, right (-1) of the way to the pivot."""
    pin = mp.expj(angle)
    way = pivot - pin
    far = abs(way)
    along = (far**2 + rod**2 - rocker**2) / (2 * far)
    return pin + way / far * mpc(along, side * mp.sqrt(rod**2 - along**2))


# Rod, rocker, pivot, the way to assemble the links, and on which side of the pivot the rod then ends.
ARCS = (
    ("5", "6", "5;6", 1, -1),
    ("3.5", "4", "3.6;-2.75", 1, 1),
    ("4", "4.5", "4;0", -1, 1),
)


@pytest.mark.parametrize("arc", ARCS)
def test_the_end_of_an_arc_crank_moves_along_its_arc(arc: tuple[str, str, str, int, int]) -> None:
    rod, rocker, at, circuit, side = arc
    for angle in ("0", "37.5", "90", "171.3", "290"):
        found = {}
        for name in ("velocity", "acceleration"):
            page = kurbel.construction_table(
                name,
                mechanism="arc",
                ratio=f"1:{rod}",
                rocker=rocker,
                pivot=at,
                circuit=str(circuit),
                angle=angle,
                columns="length,symbol,drawn,true",
                digits=DIGITS,
            )
            rows = (line.split(",") for line in kurbel.typeset(page, "csv").splitlines()[1:])
            found[name] = {symbol or letters: values for letters, symbol, *values in rows}
        with mp.workdps(60):
            true = of_arc(mpf(rod), mpf(rocker), mpc(*map(mpf, at.split(";"))), side, mp.radians(mpf(angle)))
            assert {*found["acceleration"]} == {*true}
            for symbol, values in (*found["velocity"].items(), *found["acceleration"].items()):
                assert values[0] == values[1]
                assert abs(mpf(values[0]) - true[symbol]) < mpf(10) ** -DIGITS * 0.51, (angle, symbol)


def of_arc(rod: mpf, rocker: mpf, pivot: mpc, side: int, angle: mpf) -> dict[str, mpf]:
    """Return what moves the rod's end, by derivatives: its velocity and acceleration, and those about the
    crank pin, in parts along the links and square to them."""
    end, pin = partial(rod_end, rod, rocker, pivot, side), mp.expj(angle)
    place, slope, bend = (mp.diff(end, angle, order) for order in range(3))
    # On the outstroke the rod's end comes nearer to the shaft: dead centres are at L + R and L - R.
    nearer = -mp.sign(mp.re(mp.conj(place) * slope))
    about, link = bend + pin, place - pin
    on_link = mp.conj(link / abs(link)) * about
    on_path = mp.conj(slope / abs(slope)) * bend
    return {
        "c/ω": nearer * abs(slope),
        "u/ω": abs(slope - mpc(0, 1) * pin),
        "p′x": -mp.re(on_link),
        "xq′": abs(mp.im(on_link)),
        "p/ω²": nearer * mp.re(on_path),
        "o′y": abs(mp.im(on_path)),
        "o′q′": abs(bend),
    }


def points(name: str, rod: Fraction, offset: Fraction, angle: Fraction) -> Points:
    return construction(name).points(Placed(Crank(1 / rod, offset), angle, floats()))


def square(one: Point, other: Point) -> bool:
    return float(abs(dot(one, other))) < 1e-12


def parallel(one: Point, other: Point) -> bool:
    return float(abs(cross(one, other))) < 1e-12


def test_the_points_of_klein_lie_on_both_circles() -> None:
    for drive in drives("klein", 12):
        at = points("klein", *drive)
        about = distance(at["C"], at["M"])
        for letter in "KL":
            assert distance(at["C"], at[letter]) == pytest.approx(about, abs=1e-12)
            # Thales: on the circle with the diameter C P.
            assert square(to(at[letter], at["C"]), to(at[letter], at["P"]))
        for letter in "QN":
            assert parallel(to(at["K"], at["L"]), to(at["K"], at[letter]))
        assert parallel(to(at["C"], at["P"]), to(at["C"], at["Q"]))


def test_the_points_of_rittershaus_lie_on_their_lines() -> None:
    for drive in drives("rittershaus", 12):
        at = points("rittershaus", *drive)
        slide = to(at["O"], at["P"])
        assert parallel(slide, to(at["M"], at["K"]))
        assert parallel(to(at["O"], at["C"]), to(at["O"], at["K"]))
        assert square(slide, to(at["K"], at["Q"]))
        assert parallel(to(at["C"], at["P"]), to(at["C"], at["Q"]))
        assert square(to(at["Q"], at["N"]), to(at["C"], at["P"]))


def test_the_points_of_autenrieth_lie_on_their_lines() -> None:
    for drive in drives("autenrieth", 12):
        at = points("autenrieth", *drive)
        assert distance(at["Q"], at["D"]) == pytest.approx(distance(at["P"], at["C"]), abs=1e-12)
        assert square(to(at["D"], at["Q"]), to(at["D"], at["P"]))
        assert square(to(at["D"], at["F"]), to(at["P"], at["Q"]))
        assert square(to(at["F"], at["E"]), to(at["P"], at["Q"]))
        assert parallel(to(at["P"], at["E"]), to(at["O"], at["Q"]))
        assert parallel(to(at["E"], at["G"]), to(at["O"], at["P"]))
        assert parallel(to(at["Q"], at["G"]), to(at["O"], at["Q"]))


def test_the_altitude_and_the_sides_of_the_plan_lie_on_their_lines() -> None:
    for drive in drives("acceleration", 12):
        at = points("acceleration", *drive)
        rod = to(at["P"], at["Q"])
        assert distance(at["P"], at["D"]) == pytest.approx(distance(at["P"], at["C"]), abs=1e-12)
        assert square(to(at["P"], at["D"]), rod)
        assert square(to(at["D"], at["E"]), to(at["D"], at["Q"]))
        assert parallel(to(at["P"], at["E"]), rod)
        assert to(at["o'"], at["p'"]) == pytest.approx(to(at["P"], at["O"]))
        assert to(at["p'"], at["x"]) == pytest.approx(to(at["P"], at["E"]), abs=1e-12)
        assert square(to(at["x"], at["q'"]), rod)
        assert at["o'"].y == pytest.approx(at["q'"].y)
        # The polygon is clear of the drive.
        assert max(at[one].y for one in ("o'", "p'", "x", "q'")) < min(-1.0, *(at[one].y for one in "OPQCDE"))


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_the_parts_are_the_sides_of_the_acceleration(name: str) -> None:
    # p of the crosshead is that of the crank pin, of length R, and the two parts square to each other.
    for rod, offset, angle in drives(name, 4):
        found = lengths(name, rod, offset, angle)
        along, across = (float(found[letters][0]) for letters in PARTS[name])
        p = float(found["p/ω²"][0])
        turn = mp.radians(mpf(angle.numerator) / angle.denominator)
        # The difference of both accelerations, along the slide and across it.
        assert along**2 + across**2 == pytest.approx(float((p - mp.cos(turn)) ** 2 + mp.sin(turn) ** 2))


def test_the_parabola_has_the_acceleration_of_first_order_and_its_error() -> None:
    assert {*EXACT, "kuhn"} == RATES
    for rod, _, angle in drives("kuhn", 6):
        found = lengths("kuhn", rod, Fraction(0), angle)["p/ω²"]
        with mp.workdps(60):
            place = mp.radians(mpf(angle.numerator) / angle.denominator)
            first = mp.cos(place) + mp.cos(2 * place) * rod.denominator / rod.numerator
            p = -mp.diff(partial(crosshead, rod, Fraction(0)), place, 2)
            for text, value in zip(found, (first, p, first - p), strict=True):
                assert abs(mpf(text) - value) < mpf(10) ** -DIGITS * 0.51


@pytest.mark.parametrize("angle", ["0", "180", "360"])
def test_rittershaus_has_no_point_at_a_dead_centre(angle: str) -> None:
    with pytest.raises(ProblemError, match=r"at a dead centre .* take klein, or an angle beside it"):
        kurbel.construction_table("rittershaus", angle=angle)


@pytest.mark.parametrize("name", ["rittershaus", "autenrieth"])
def test_what_holds_for_the_straight_crank_alone_names_what_holds_for_the_other(name: str) -> None:
    with pytest.raises(ProblemError, match="for the straight crank alone; klein holds for the offset one"):
        kurbel.construction_table(name, mechanism="offset", offset="0.3")


@pytest.mark.parametrize("name", ["mohr", "Mehmke", "bour-pröll"])
def test_a_construction_without_a_source_says_so(name: str) -> None:
    with pytest.raises(ChoiceError, match="no source that says its steps was found; klein, rittershaus"):
        kurbel.plot_construction(name)
