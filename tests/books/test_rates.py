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
ACCELERATIONS = ["autenrieth", "klein", "rittershaus"]
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
def test_the_velocity_of_an_arc_crank_is_that_along_its_arc(arc: tuple[str, str, str, int, int]) -> None:
    rod, rocker, at, circuit, side = arc
    for angle in ("0", "37.5", "90", "171.3", "290"):
        page = kurbel.construction_table(
            "velocity",
            mechanism="arc",
            ratio=f"1:{rod}",
            rocker=rocker,
            pivot=at,
            circuit=str(circuit),
            angle=angle,
            columns="symbol,drawn,true",
            digits=DIGITS,
        )
        found = {
            row[0]: row[1:] for row in (line.split(",") for line in kurbel.typeset(page, "csv").splitlines())
        }
        with mp.workdps(60):
            pivot = mpc(*map(mpf, at.split(";")))
            end = partial(rod_end, mpf(rod), mpf(rocker), pivot, side)
            place = mp.radians(mpf(angle))
            slope = mp.diff(end, place)
            # On the outstroke the rod's end comes nearer to the shaft: dead centres are at L + R and L - R.
            nearer = -mp.sign(mp.re(mp.conj(end(place)) * slope))
            true = {"c/ω": nearer * abs(slope), "u/ω": abs(slope - mpc(0, 1) * mp.expj(place))}
            for symbol, value in true.items():
                assert [*found[symbol]] == [found[symbol][0]] * 2
                assert abs(mpf(found[symbol][0]) - value) < mpf(10) ** -DIGITS * 0.51, (angle, symbol)


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


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_the_parts_are_the_sides_of_the_acceleration(name: str) -> None:
    # p of the crosshead is that of the crank pin, of length R, and the two parts square to each other.
    for rod, offset, angle in drives(name, 4):
        found = lengths(name, rod, offset, angle)
        along, across = (
            float(found[letters][0]) for letters in (("QF", "FE") if name == "autenrieth" else ("CQ", "QN"))
        )
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
