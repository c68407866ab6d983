"""The lengths of Blau's and Rötscher's constructions and of the triangle of forces, by mpmath alone."""

from __future__ import annotations

import random
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp
from textbook import Drive, evaluate, real

import kurbel
from kurbel.exact.numerals import Number
from kurbel.page.labels import plain

DIGITS = 30
DRIVES = [
    (f"1:{Fraction(dice.randint(105, 900), 100)}", str(Fraction(dice.randint(1, 35999), 100)))
    for dice in [random.Random(1047)]
    for _ in range(3)
]


def drawn(name: str, ratio: str, angle: str | None, **drive: Any) -> Mapping[str, Fraction]:
    """Return the drawn lengths of a construction by their letters, which are the true ones if it is exact."""
    ratio = f"1:{float(Fraction(ratio[2:]))}"
    page = kurbel.construction_table(
        name, ratio=ratio, angle=None if angle is None else float(Fraction(angle)), digits=DIGITS,
        columns="length,drawn,true,error", **drive,
    )  # fmt: skip
    found = {}
    for letters, given, true, error in page.records.rows:
        assert isinstance(given, Number)
        assert given == true
        assert error == Number(0, 0)
        found[plain(str(letters))] = Fraction(given.scaled, 10**given.decimals)
    return found


def near(found: Fraction, wanted: Any) -> bool:
    """Whether a printed number is the wanted one to its last digit."""
    return bool(abs(real(found) - wanted) <= mp.mpf(10) ** -DIGITS * 0.5000001)


@pytest.mark.parametrize(("ratio", "angle"), DRIVES)
def test_paths_are_those_of_the_textbook(ratio: str, angle: str) -> None:
    drive, phi = Drive(1 / Fraction(ratio[2:])), Fraction(angle)
    # A straight crank stands on the return stroke as on the outstroke, half a turn on.
    with mp.workdps(60):
        out, back = (evaluate(key, "exact", drive, phi) for key in ("x", "x_return"))
        flat = 1 - mp.cos(real(phi) * mp.pi / 180)
        blau = drawn("blau-9", ratio, angle)
        line, circle = (drawn(f"roetscher-1047-{way}", ratio, angle) for way in ("line", "circle"))
        wanted = {"ad": out, "af": flat, "fd": out - flat, "bd′": back, "bf′": flat, "f′d′": flat - back}
        assert all(near(blau[letters], value) for letters, value in wanted.items())
        assert near(line["K₁K"], out)
        assert near(line["K₂K′"], back)
        assert near(circle["CE"], out)
        assert near(circle["DE′"], back)
        # Rötscher's own relation, as C lies on a circle of radius L.
        cf, gf = real(circle["CF"]), real(circle["GF"])
        assert abs(cf**2 - gf * (2 / real(drive.ratio) - gf)) < mp.mpf(10) ** (3 - DIGITS)


@pytest.mark.parametrize("offset", ["0.4", "-0.04"])
def test_the_arc_cuts_the_line_of_an_offset_crank_too(offset: str) -> None:
    drive, phi = Drive(Fraction(10, 32), Fraction(offset)), Fraction(497, 10)
    found = drawn("roetscher-1047-line", "1:16/5", str(phi), offset=offset)
    with mp.workdps(60):
        assert near(found["K₁K"], evaluate("x", "exact", drive, phi))
        # D is opposite to C, and the path counts from the outer dead centre.
        rod, e, turn = 1 / real(drive.ratio), real(drive.offset), real(phi) * mp.pi / 180
        outer = mp.sqrt((rod - 1) ** 2 - e**2)
        head = -mp.cos(turn) + mp.sqrt(rod**2 - (mp.sin(turn) + e) ** 2)
        assert near(found["K₂K′"], head - outer)


@pytest.mark.parametrize(("ratio", "angle"), DRIVES)
def test_forces_are_in_balance_and_do_the_work_of_the_piston(ratio: str, angle: str) -> None:
    printed = drawn("forces", ratio, angle)
    with mp.workdps(40):
        found = {letters: real(force) for letters, force in printed.items()}
        rod, turn = real(Fraction(ratio[2:])), real(Fraction(angle)) * mp.pi / 180
        tolerance = mp.mpf(10) ** (2 - DIGITS)
        # F along the slide and F_Q across it are F_S; so are F_T and F_R.
        assert abs(1 + found["QS"] ** 2 - found["PS"] ** 2) < tolerance
        assert abs(found["PT"] ** 2 + found["TS"] ** 2 - found["PS"] ** 2) < tolerance
        # The torque F_T R is the piston force times the slope of the path, and F_S times its arm.
        slope = mp.diff(lambda at: -mp.cos(at) - mp.sqrt(rod**2 - mp.sin(at) ** 2), turn)
        assert abs(found["PT"] - slope) < mp.mpf(10) ** -12
        assert abs(found["PS"] * found["OH"] - found["PT"]) < tolerance


def test_the_exercise_is_drawn_where_the_rod_touches_the_crank_circle() -> None:
    # Eq. (5), (9) and (11) of the exercise; l/r = 16/5.
    found = drawn("forces", "1:16/5", None)
    with mp.workdps(40):
        slope = mp.mpf(5) / 16
        wanted = {"QS": slope, "PS": mp.sqrt(1 + slope**2), "PT": mp.sqrt(1 + slope**2), "TS": 0, "OH": 1}
        assert all(near(found[letters], value) for letters, value in wanted.items())
