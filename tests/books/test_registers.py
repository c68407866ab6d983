"""Every printed value: the register has the value of the books' formulas by mpmath, and kurbel prints it."""

from __future__ import annotations

import re
import shutil
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from cli import printed, records
from mpmath import mp
from places import SOURCES
from registers import BOOKS, printed_values, register

import kurbel
from kurbel import verify

MOTION = ("blau-31", "blau-32", "roetscher-112")
SOLVED = register(SOURCES / "blau" / "solved.csv")
Row = Mapping[str, str]


def drive(row: Row) -> tuple[str, list[str], str]:
    """Return ratio, angles and quantity of a place: blau-31/1:5/45/x, roetscher-112/1:4/30-330/p."""
    _, ratio, angles, key = row["place"].split("/")
    return ratio, angles.split("-"), key


def decimals(text: str) -> int:
    return len(text.partition(",")[2])


@cache
def collated(key: str) -> Mapping[str, Row]:
    return {row["place"]: row for row in records("collate", key)}


@pytest.mark.parametrize("key", MOTION)
def test_values_of_the_motion_are_those_of_the_textbook_and_of_kurbel(key: str) -> None:
    rows = register(SOURCES / f"{key}.csv")
    assert len(rows) == (6 if key.startswith("blau") else 54)
    for row in rows:
        ratio, angles, name = drive(row)
        places, share = (
            decimals(row["printed"]),
            Fraction(ratio.replace(",", ".").replace(":", "/").split("/")[0]),
        )
        share /= Fraction(ratio.replace(",", ".").split(":")[1])
        value = verify.drive(share).value(name, angles[0], row["method"])
        assert value.confirms(row["computed"]) == verify.CONFIRMED, row
        assert row["record"] == ("agrees" if row["printed"] == row["computed"] else "differs")
        found = collated(key)[row["cell"]]
        assert (found["recomputed"], found["quantity"], found["phi"]) == (row["computed"], name, angles[0])
        assert (found["verdict"] == "right") == (row["record"] == "agrees")
        # The opposite angle has the same acceleration and the opposite velocity.
        for angle in angles:
            away = {"p": 1, "c": -1 if angle != angles[0] else 1}.get(name, 1)
            scaled_value = kurbel.certified(name, ratio, Fraction(angle), digits=places, method=row["method"])
            number = Fraction(str(scaled_value).replace(",", ".").replace("−", "-"))
            assert away * number == Fraction(row["computed"].replace(",", "."))


def test_every_value_of_the_registers_is_there() -> None:
    for key in MOTION:
        told = {row["cell"] for row in register(SOURCES / f"{key}.csv")}
        assert told == {place for place, row in collated(key).items() if row["quantity"]}
    for section in ("149", "150"):
        told = {row["cell"] for row in register(SOURCES / "weisbach" / f"{section}.csv")}
        assert told == {*printed_values(f"weisbach-{section}")}
    rows = records("table", "--layout=roetscher-112")
    found = {row[key].replace(".", ",").replace("-0,000", "0,000") for row in rows for key in ("p", "c")}
    computed = {row["computed"] for row in register(SOURCES / "roetscher-112.csv")} - {"0"} | {"0,000"}
    assert computed <= found


# Blau's examples 33 to 35 -----------------------------------------------------------------------------------

# p over v²/R by the condition, from p = cos α + λ cos 2α, at the dead centre 1 + λ.
SHARES = {
    "p = 0": Fraction(0),
    "p = 1/6 of dead centre": Fraction(1, 6),
    "p = -1/6 of dead centre": Fraction(-1, 6),
}


@pytest.mark.parametrize("row", SOLVED, ids=[row["place"] for row in SOLVED])
def test_a_solved_value_is_that_of_the_quadratic_equation_and_of_kurbel(row: Row) -> None:
    _, ratio, name = row["place"].split("/")
    computed = row["computed"]
    with mp.workdps(40):
        lam, share = 1 / mp.mpf(ratio[2:]), SHARES[row["condition"]]
        value = (1 + lam) * mp.mpf(share.numerator) / share.denominator
        # 2 λ u² + u - λ - p = 0
        root = mp.sqrt(1 + 8 * lam * (lam + value))
        cosine, other = (-1 + root) / (4 * lam), (-1 - root) / (4 * lam)
        path = 1 - cosine + lam / 2 * (1 - cosine**2)
        true: dict[str, Any] = {"cos": cosine, "x": path, "x_stroke": path / 2, "unusable": other}
        true["phi"] = mp.degrees(mp.acos(cosine))
        wanted, unit = number_of(computed)
        assert abs(true[name] - wanted) <= unit / 2
    assert row["record"] == ("agrees" if row["printed"] == computed else "differs")
    words = ("solve", "--method=series", f"--ratio={ratio}", f"--where={row['condition']}")
    if name in ("x", "x_stroke", "phi"):
        digits = 9 if name == "phi" else decimals(computed)
        (out, *_) = records(*words, f"--columns={name}", f"--digits={digits}", "--rounding=half-away")
        if name == "phi":
            assert abs(mp.mpf(out[name]) - wanted) <= unit / 2
        else:
            assert out[name].replace(".", ",") == computed
        return
    page = " ".join(printed(*words, "--lang=de").out.split())
    said = re.search(r"Hingang: cos φ = (?:[^;]*?, also )?([−\d,/]+); ([−\d,/]+) unbrauchbar", page)
    assert said
    shown, _ = number_of(said[1 if name == "cos" else 2])
    assert abs(shown - wanted) <= unit / 2


def number_of(text: str) -> tuple[Any, Any]:
    """Return a printed number and its unit: 0,186, -5/2, 79°16', 77°."""
    text = text.replace("−", "-")
    if "°" in text:
        degrees, minutes = text.rstrip("'").split("°")
        return int(degrees) + mp.mpf(minutes or 0) / 60, mp.mpf(1) / (60 if minutes else 1)
    if "/" in text:
        return mp.mpf(Fraction(text).numerator) / Fraction(text).denominator, mp.mpf("1e-30")
    return mp.mpf(text.replace(",", ".")), mp.mpf(10) ** -decimals(text)


# Weisbach §§ 149, 150 --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("section", "method", "register_of"),
    [
        ("150", "exact", "exact"),
        ("150", "series", "series"),
        ("150", "weisbach", "weisbach"),
        ("149", "exact", "exact"),
        ("149", "approximate", "weisbach"),
    ],
)
def test_kurbel_gives_every_cell_of_weisbachs_sections(
    section: str, method: str, register_of: str, tmp_path: Path
) -> None:
    (tmp_path / "weisbach").mkdir()
    (tmp_path / "weisbach" / "source.toml").write_text(
        f'citation = "Weisbach"\n[tables.{section}]\nmethod = "{method}"\n', encoding="utf-8"
    )
    shutil.copy(BOOKS / "weisbach" / f"{section}.csv", tmp_path / "weisbach")
    found = records("collate", f"weisbach-{section}", "--sources", str(tmp_path))
    own = {row["place"]: row for row in found}
    rows = register(SOURCES / "weisbach" / f"{section}.csv")
    assert len(rows) == (8 if section == "149" else 17)
    for row in rows:
        # The true angles of the beam are no fractions.
        if row[register_of] and own[row["cell"]]["quantity"]:
            assert own[row["cell"]]["recomputed"].replace("′", "'") == row[register_of], row
