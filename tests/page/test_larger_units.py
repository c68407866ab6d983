"""Long numbers of pages stand in a larger unit, digit for digit those of the data, which stay as they are."""

from __future__ import annotations

import json
import re
import shlex
from collections import Counter
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
from cli import printed
from places import ROOT

import kurbel as library

# Powers of ten by the prefixes of the SI.
PREFIXED = {
    "N": ("kN", "MN"), "N m": ("kN m", "MN m"), "J": ("kJ", "MJ"), "W": ("kW", "MW"), "kW": ("MW",),
    "N, N m": ("kN, kN m",), "kPa": ("MPa",),
}  # fmt: skip
ENGINE = f"--machine {ROOT / 'examples/engine.toml'}"
PAGES = (
    f"forces {ENGINE} --step 30",
    f"forces {ENGINE} --layout rod-load-turn --step 45",
    f"forces {ENGINE} --layout rod-load",
    "forces --force 56549.25N --stroke 600mm --step 60",
    "forces --reciprocating 900kg --stroke 600mm --speed 200/min --layout forces-verfahren",
    # Meganewtons, and a force beside a torque that has four digits.
    "forces --force 12345678N --stroke 1m --step 60 --columns phi,rod_force_n,torque_nm",
    "forces --force 12kN --stroke 100mm --step 60",
    "forces --mechanism arc --rocker 6 --stroke 600mm --force 120kN --step 60",
    f"inertia {ENGINE} --speed 600/min --step 60",
    f"inertia {ENGINE} --speed 600/min --layout inertia-errors",
    f"solve {ENGINE} --where torque=max",
    f"flywheel {ENGINE}",
    f"turning {ENGINE} --step 60 --columns phi,torque_nm,tangential_kpa --speed 300/min",
    f"balance {ENGINE} --engine inline-3 --spacing 1m",
    f"balance {ENGINE} --angle '0;30'",
    f"balance {ENGINE} --layout balance-greatest",
    "rotor --masses '200;300kg' --radii '0.2;0.15m' --angles '0;45' --planes '0;400mm' --speed 600/min",
    "locomotive --spacing 2m --gauge 1.5m --crank 30cm --reciprocating 240kg --speed 300/min"
    " --wheel 1.8m --wheel-load 80kN",
    "power --eps 3 --pressure 8bar --bore 3m --stroke 4m --speed 200/min",
)


NUMBER = re.compile(r"-?\d+(\.\d+)?")


def cells(words: list[str], lang: str) -> tuple[Counter[Decimal], str]:
    """Return the numbers in the cells of the page, and all that it says."""
    text = printed(*words, "-f", "html", "--lang", lang, "--decimal", "point").out
    bodies = re.findall(r"<td[^>]*>(.*?)</td>", text, re.DOTALL)
    plain = [re.sub(r"<[^>]+>", "", one).replace("−", "-").strip() for one in bodies]
    numbers = Counter(Decimal(one).normalize() for one in plain if NUMBER.fullmatch(one))
    return numbers, re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", text).replace("\N{NO-BREAK SPACE}", " "))


def data(words: list[str]) -> Any:
    return json.loads(printed(*words, "-f", "json", "--lang", "en").out, parse_float=str)


@pytest.mark.parametrize(("place", "words"), [*enumerate(PAGES)])
def test_a_page_has_every_digit_of_the_data_in_the_larger_unit(place: int, words: str) -> None:
    lang = ("de", "en")[place % 2]
    asked = shlex.split(words)
    shown, said = cells(asked, lang)
    records = data(asked)
    moved = 0
    for unit in {column["unit"] for column in records["columns"]} & set(PREFIXED):
        keys = [column["key"] for column in records["columns"] if column["unit"] == unit]
        values = [Decimal(str(row[key])) for row in records["rows"] for key in keys if row[key] is not None]
        steps = 0
        while max(map(abs, values)).scaleb(-3 * steps) >= 10_000:
            steps += 1
        # No digit is lost.
        assert not Counter(value.scaleb(-3 * steps).normalize() for value in values) - shown, unit
        if steps:
            moved += 1
            assert PREFIXED[unit][steps - 1] in said
            assert not any(value.normalize() in shown for value in values if abs(value) >= 10_000)
    assert moved


def test_four_digits_stay_in_the_unit_that_they_are_in() -> None:
    words = ("forces", "--stroke", "600mm", "--angle", "90", "--columns", "rod_force_n", "--lang", "en")
    # S = F/cos ψ, sin ψ = 1/5: 9999.0 N and 10000.0 N.
    for force, shown in (("9796.98N", "9999.0"), ("9797.96N", "10.0000")):
        page = printed(*words, "--force", force).out
        assert f" {shown}" in page
        assert ("S in N" in page) is (shown == "9999.0")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("56549N", "F = 56.549 kN"),
        ("10kN", "F = 10 kN"),
        ("9999.99N", "F = 9999.99 N"),
        ("12345678N", "F = 12.345678 MN"),
    ],
)
def test_what_was_given_exactly_stays_exact(given: str, said: str) -> None:
    words = ("forces", "--force", given, "--columns", "phi,rod_force", "--angle", "0", "--lang", "en")
    assert f"{said}\n" in printed(*words).out


def test_digits_count_in_the_larger_unit_and_a_unit_that_was_asked_for_stays() -> None:
    words = ("forces", "--force", "56549N", "--stroke", "600mm", "--angle", "0", "--columns", "rod_force_n")
    # 56549 N without a rod's slant; one decimal of kN is five hundred times that of N.
    assert " 56.5" in printed(*words, "--digits", "1", "--lang", "en").out
    assert printed(*words, "--digits", "1", "-f", "csv").out.split() == ["rod_force_n", "56549.0"]
    page = printed(*words, "--units", "N", "--lang", "en").out
    assert "S in N" in page and "56549.0" in page and "F = 56549 N" in page
    assert "S in kN" in printed(*words, "--units", "cm", "--lang", "en").out
    assert "rod_force_n" in printed(*words, "--units", "cm", "-f", "csv").out


def test_data_are_the_same_from_a_page_and_without_one() -> None:
    words = ("forces", "--force", "56549N", "--stroke", "600mm", "--angle", "0;30", "--lang", "en")
    table = library.forces_table("1:5", force="56549N", stroke="600mm", angle="0;30", lang="en")
    assert "kN" in table.typeset("text")
    for name in ("csv", "json", "dat"):
        assert table.typeset(name) == printed(*words, "--ratio", "1:5", "-f", name).out
        assert "kN" not in table.typeset(name)


LAYOUT = """
title = "Kräfte"
caption = "Kräfte"
subject = "mass forces"
ratios = ["1:5"]
angles = ["0;90"]
down = ["ratio", "angle"]
stub = ["angle"]
across = ["column"]
columns = [
    {{ quantity = "rod_force_n", heading = ["{first}"] }},
    {{ quantity = "guide_force_n", heading = ["$N$ in N"] }},
]
"""


@pytest.mark.parametrize(("head", "changed"), [("$S$ in N", True), ("$S$ [N]", False), ("Kraft", False)])
def test_a_head_that_says_its_unit_otherwise_keeps_its_numbers(
    head: str, changed: bool, tmp_path: Path
) -> None:
    (tmp_path / "own").mkdir()
    (tmp_path / "own/layout.toml").write_text(LAYOUT.format(first=head), encoding="utf-8")
    table = library.forces_table(
        layout="own", layouts=tmp_path, force="100kN", stroke="1m", lang="en", angle="90"
    )
    text = table.typeset("text")
    # F/cos ψ with sin ψ = 1/5.
    assert ("102.0621" in text, "102062.1" in text) == (changed, not changed)
    assert ("N in kN" in text) is changed
