"""Constructions of paths, velocity and acceleration: their lengths by another certified computation."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from cli import records

import kurbel
from kurbel import verify

# The parts of the crosshead's acceleration about the crank pin, along the rod and square to it.
PARTS = {
    "acceleration": ("p′x", "xq′"),
    "autenrieth": ("QF", "FE"),
    "klein": ("CQ", "QN"),
    "rittershaus": ("CQ", "QN"),
}
DIGITS = 20


def drives(name: str, count: int) -> list[tuple[Fraction, Fraction, Fraction]]:
    """Return rod, offset and angle, the same in every run, then 90° and, where they hold, dead centres."""
    dice = random.Random(name)
    found = []
    for place in range(count):
        rod = Fraction(dice.randint(115, 700), 100)
        reach = int(95 * (rod - 1))
        offset = (
            dice.randint(-reach, reach) if name in ("velocity", "acceleration", "klein") and place % 2 else 0
        )
        found.append((rod, Fraction(offset, 100), Fraction(dice.randint(1, 3599), 10)))
    right = [(Fraction(3), Fraction(0), Fraction(angle)) for angle in (90, 270)]
    ends = [(Fraction(3), Fraction(0), Fraction(angle)) for angle in (0, 180)]
    return found + right + (ends if name != "rittershaus" else [])


def lengths(name: str, *words: str) -> dict[str, Fraction]:
    """Return the drawn lengths of an exact construction by their letters or what they stand for."""
    columns = "--columns=length,symbol,drawn,true,error"
    found = {}
    for row in records("construct", name, *words, "--table", columns, f"--digits={DIGITS}"):
        assert (row["drawn"], row["error"]) == (row["true"], "0")
        for key in {row["length"], row["symbol"]} - {""}:
            found[key] = Fraction(row["drawn"])
    return found


def assert_near(found: Fraction, wanted: Fraction, about: Any) -> None:
    assert abs(found - wanted) < Fraction(51, 100) / 10**DIGITS, about


def near(drive: Any, key: str, angle: Fraction | str, method: str = "exact") -> Fraction:
    return Fraction(drive.value(key, angle, method).near(200))


@pytest.mark.parametrize("name", ["velocity", *PARTS])
def test_velocity_acceleration_and_its_parts_are_certified_to_the_last_digit(name: str) -> None:
    for rod, offset, angle in drives(name, 5):
        words = (
            f"--ratio={1 / rod}",
            f"--angle={float(angle)}",
            *([f"--offset={float(offset)}"] if offset else []),
        )
        drive = verify.drive(1 / rod, offset)
        turned, bent = (near(drive, key, angle) for key in ("rod_velocity", "rod_acceleration"))
        wanted = {"c/ω": near(drive, "c", angle), "u/ω": abs(turned) * rod}
        if name in PARTS:
            wanted |= {"p/ω²": near(drive, "p", angle)}
            wanted |= dict(zip(PARTS[name], (turned**2 * rod, abs(bent) * rod), strict=True))
        found = lengths(name, *words)
        assert len(wanted.keys() & found.keys()) >= (2 if name == "velocity" else 3), (found, wanted)
        for key in wanted.keys() & found.keys():
            assert_near(found[key], wanted[key], (name, rod, offset, angle, key))


# Rod, rocker, pivot, and the way to assemble the links.
ARCS = (("5", "6", ("5", "6"), 1), ("3.5", "4", ("3.6", "-2.75"), 1), ("4", "4.5", ("4", "0"), -1))


@pytest.mark.parametrize("arc", ARCS)
def test_the_end_of_an_arc_crank_moves_along_its_arc(arc: tuple[str, str, tuple[str, str], int]) -> None:
    rod, rocker, pivot, circuit = arc
    drive = verify.drive(1 / Fraction(rod), rocker=rocker, pivot=pivot, circuit=circuit)
    words = ("--mechanism=arc", f"--ratio=1:{rod}", f"--rocker={rocker}", f"--pivot={';'.join(pivot)}")
    for angle in ("37.5", "90", "171.3", "290"):
        turned, bent, swung = (
            near(drive, key, angle) for key in ("rod_velocity", "rod_acceleration", "turn_velocity")
        )
        wanted = {
            "c/ω": near(drive, "velocity", angle),
            "u/ω": abs(turned) * Fraction(rod),
            "p′x": turned**2 * Fraction(rod),
            "xq′": abs(bent) * Fraction(rod),
            "p/ω²": near(drive, "acceleration", angle),
            "o′y": swung**2 * Fraction(rocker),
        }
        for name, count in (("velocity", 2), ("acceleration", 5)):
            found = lengths(name, *words, f"--circuit={circuit}", f"--angle={angle}")
            assert len(wanted.keys() & found.keys()) >= count, found
            for key in wanted.keys() & found.keys():
                assert_near(found[key], wanted[key], (name, angle, key))


@pytest.mark.parametrize(("rod", "angle"), [("2.67", "314.85"), ("1.05", "77.3"), ("8.31", "200.02")])
def test_paths_are_certified_and_forces_do_the_work_of_the_piston(rod: str, angle: str) -> None:
    drive, words = verify.drive(1 / Fraction(rod)), (f"--ratio=1:{rod}", f"--angle={angle}")
    # A straight crank stands on the return stroke as on the outstroke, half a turn on.
    out, back = (near(drive, key, angle) for key in ("x", "x_return"))
    flat = near(drive, "x", angle, "infinite")
    wanted = {
        "blau-9": {"ad": out, "af": flat, "fd": out - flat, "bd′": back, "bf′": flat, "f′d′": flat - back},
        "roetscher-1047-line": {"K₁K": out, "K₂K′": back},
        "roetscher-1047-circle": {"CE": out, "DE′": back},
        "forces": {
            "QS": abs(near(drive, "guide_force", angle)), "PS": near(drive, "rod_force", angle),
            "PT": abs(near(drive, "tangential_force", angle)), "TS": abs(near(drive, "radial_force", angle)),
        },
    }  # fmt: skip
    for name, values in wanted.items():
        found = lengths(name, *words)
        for key, value in values.items():
            assert_near(abs(found[key]) if name == "forces" else found[key], value, (name, key))
    # Rötscher's own relation, as C lies on a circle of radius L; and F_S times its arm is the torque.
    circle = lengths("roetscher-1047-circle", *words)
    apart = circle["CF"] ** 2 - circle["GF"] * (2 * Fraction(rod) - circle["GF"])
    assert abs(apart) < Fraction(10) ** (2 - DIGITS)
    assert abs(found["PS"] * found["OH"] - found["PT"]) < Fraction(10) ** (2 - DIGITS)


@pytest.mark.parametrize("offset", ["0.4", "-0.04"])
def test_the_arc_cuts_the_line_of_an_offset_crank_too(offset: str) -> None:
    found = lengths("roetscher-1047-line", "--ratio=1:3.2", "--angle=49.7", f"--offset={offset}")
    drive = verify.drive(Fraction(10, 32), offset)
    assert_near(found["K₁K"], near(drive, "x", "49.7"), offset)
    # D is opposite to C, and the path counts from the outer dead centre.
    stroke = Fraction(drive.value("stroke").near(200))
    assert_near(found["K₂K′"], stroke - near(drive, "x", "229.7"), offset)


def test_the_exercise_is_drawn_where_the_rod_touches_the_crank_circle() -> None:
    # Eq. (5), (9) and (11) of the exercise; l/r = 16/5, and √(1 + 25/256) is √281/16.
    found = lengths("forces", "--ratio=1:3.2")
    assert [found[key] for key in ("QS", "TS", "OH")] == [Fraction(5, 16), 0, 1]
    for key in ("PS", "PT"):
        assert abs(found[key] ** 2 - Fraction(281, 256)) < Fraction(3) / 10**DIGITS


def test_the_parabola_has_the_acceleration_of_first_order_and_its_error() -> None:
    for rod, _, angle in drives("kuhn", 4):
        words = (f"--ratio={1 / rod}", f"--angle={float(angle)}", "--table", f"--digits={DIGITS}")
        (row,) = (one for one in records("construct", "kuhn", *words) if one["symbol"] == "p/ω²")
        first, p = (near(verify.drive(1 / rod), "p", angle, method) for method in ("series", "exact"))
        for key, value in (("drawn", first), ("true", p), ("error", first - p)):
            assert_near(Fraction(row[key]), value, (rod, angle, key))


# Points ---------------------------------------------------------------------------------------------------


def points(name: str, rod: Fraction, offset: Fraction, angle: Fraction) -> dict[str, complex]:
    """Return where the discs of a drawing stand by their letters."""
    drive: dict[str, Any] = {"ratio": 1 / rod, "angle": angle} | ({"offset": offset} if offset else {})
    axes = kurbel.plot_construction(name, **drive).figure.axes[0]
    discs = (one for one in axes.patches if hasattr(one, "center"))
    return {str(one.get_gid()).split("-")[2]: complex(*one.center) for one in discs}


def square(one: complex, other: complex) -> bool:
    return abs((one * other.conjugate()).real) < 1e-12


def parallel(one: complex, other: complex) -> bool:
    return abs((one * other.conjugate()).imag) < 1e-12


def test_the_points_of_klein_lie_on_both_circles() -> None:
    for drive in drives("klein", 3):
        at = points("klein", *drive)
        for letter in "KL":
            assert abs(at[letter] - at["C"]) == pytest.approx(abs(at["C"] - at["M"]), abs=1e-12)
            # Thales: on the circle with the diameter C P.
            assert square(at["C"] - at[letter], at["P"] - at[letter])
        assert all(parallel(at["L"] - at["K"], at[letter] - at["K"]) for letter in "QN")
        assert parallel(at["P"] - at["C"], at["Q"] - at["C"])


# Letters of lines that are parallel, and of those that are square to each other.
LINES = {
    "rittershaus": ("OP MK, OC OK, CP CQ", "OP KQ, QN CP"),
    "autenrieth": ("PE OQ, EG OP, QG OQ", "DQ DP, DF PQ, FE PQ"),
    "acceleration": ("PE PQ", "PD PQ, DE DQ"),
}


@pytest.mark.parametrize("name", LINES)
def test_the_points_of_a_construction_lie_on_their_lines(name: str) -> None:
    for drive in drives(name, 3):
        at = points(name, *drive)
        for pairs, holds in zip(LINES[name], (parallel, square), strict=True):
            for pair in pairs.split(", "):
                one, other = (at[line[1]] - at[line[0]] for line in pair.split())
                assert holds(one, other), (drive, pair)
        if name == "acceleration":
            assert abs(at["D"] - at["P"]) == pytest.approx(abs(at["C"] - at["P"]), abs=1e-12)
            assert at["p'"] - at["o'"] == pytest.approx(at["O"] - at["P"], abs=1e-12)
            assert at["x"] - at["p'"] == pytest.approx(at["E"] - at["P"], abs=1e-12)
            assert square(at["q'"] - at["x"], at["Q"] - at["P"])
            # The polygon is clear of the drive.
            plan = max(at[one].imag for one in ("o'", "p'", "x", "q'"))
            assert plan < min(-1.0, *(at[one].imag for one in "OPQCDE"))
        if name == "autenrieth":
            assert abs(at["D"] - at["Q"]) == pytest.approx(abs(at["C"] - at["P"]), abs=1e-12)
