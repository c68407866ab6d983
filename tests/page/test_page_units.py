"""Pages in other units: each number is the metric one times an exact factor, and every unit stands there.

Long numbers stand in a larger unit, digit for digit those of the data, which stay as they are.
"""

from __future__ import annotations

import json
import re
import shlex
from collections import Counter
from decimal import Decimal
from fractions import Fraction
from typing import Any

import pytest
from cli import kurbel as kurbel_in
from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st
from places import CARDS, ROOT

import kurbel as library

# How many of the SI's each is, by NIST SP 811.
SIZES: dict[str, Fraction] = {
    "in": Fraction("0.0254"), "ft": Fraction("0.3048"), "in²": Fraction("0.00064516"),
    "ft/s": Fraction("0.3048"), "ft/s²": Fraction("0.3048"), "lb": Fraction("0.45359237"),
    "lbf": Fraction("4.4482216152605"), "lbf ft": Fraction("1.3558179483314004"),
    "ft lbf": Fraction("1.3558179483314004"), "hp": Fraction("745.69987158227022"),
    "psi": Fraction("4.4482216152605") / Fraction("0.00064516"), "lb ft²": Fraction("0.0421401100938048"),
    "ft³/min": Fraction("0.028316846592") / 60, "lb ft": Fraction("0.138254954376"),
    "mph": Fraction("0.44704"), "lb/h": Fraction("0.45359237") / 3600,
    "lb/(hp h)": Fraction("0.45359237") / (Fraction("745.69987158227022") * 3600),
    "mm": Fraction(1, 1000), "cm²": Fraction(1, 10**4), "kN": Fraction(1000), "kPa": Fraction(1000),
    "bar": Fraction(10**5), "MPa": Fraction(10**6), "kW": Fraction(1000), "kJ": Fraction(1000),
    "m³/min": Fraction(1, 60), "km/h": 1 / Fraction("3.6"), "kg/h": Fraction(1, 3600),
    "kg/kWh": 1 / Fraction(3_600_000),
}  # fmt: skip


def page(words: tuple[str, ...], *units: str) -> Any:
    result = kurbel_in(*words, *units, "-f", "json")
    assert result.code == 0, result.err
    return json.loads(result.out, parse_float=str)


MACHINE = "--stroke 600mm --speed 120/min --reciprocating 200kg"
STEAM = "--eps 4 --bore 300mm --pressure 8bar"
WEIGHED = f"balance --engine inline-3 --spacing 0.9m {MACHINE}"
PAGES = (
    f"table {MACHINE.replace('--reciprocating 200kg', '')} --angle 30;60 --columns phi,x,x_mm,c_mps,p_mps2",
    f"forces {MACHINE} --bore 300mm --head-pressure 5bar --friction 500N --angle 30;60",
    f"forces {MACHINE} {STEAM} --angle 30;60",
    "forces --mechanism arc --rocker 6 --stroke 600mm --force 10kN --angle 30;60",
    "inertia --centre 0.6 --gyration 0.3 --rod-mass 150kg --stroke 600mm --speed 120/min --angle 30",
    "inertia --layout inertia-errors --centre 0.6 --gyration 0.3 --rod-mass 150kg --stroke 600mm --speed 2/s",
    "inertia --layout rod-masses --centre 0.6 --gyration 0.3 --rod-mass 10kg --rod 1m",
    "turning --torque '5000 + 1500 sin(3φ)' --inertia 500kgm2 --speed 300/min",
    "flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4 --radius 1.5m",
    f"power {STEAM} --stroke 450mm --speed 200/min --specific-volume '0.24 m3/kg' --efficiency 0.8",
    "power --pressure-ratio 4 --suction-pressure 1bar --bore 300mm --stroke 450mm --speed 200/min",
    f"pressures {MACHINE} {STEAM}",
    "rotor --masses '200;300kg' --radii '0.2;0.15m' --angles 0;45 --planes 0;400mm --speed 300/min",
    WEIGHED,
    f"{WEIGHED} --layout balance-greatest",
    "balance --cranks 0;90 --positions '-0.7;0.8m' --reciprocating 300kg --stroke 600mm --speed 2/s"
    " --columns residual,order,along_n",
    "locomotive --spacing 2m --gauge 1.5m --stroke 660mm --reciprocating 240kg --revolving 150kg"
    " --velocity 90km/h --wheel 1.7m --wheel-load 60kN --balance-radius 550mm",
    f"solve {MACHINE.replace('--reciprocating 200kg', '')} --where c=max --columns phi,x_mm,c_mps",
    "solve --unknown force --ratio 1:4 --stroke 300mm --angle 60 --where 'torque = 500 N m'",
    "table --ratio 2:9 --angle 30..31:1/500 --columns phi,x_mm,p_mps2 --stroke 610mm --speed 130/min",
    "deadcentres --ratio 2:9 --offset 40mm --stroke 610mm --speed 130/min",
    f"flywheel --card {CARDS / 'ideal-2.csv'} --speed 130/min --power 40kW --delta 1:90",
    "flywheel --swing 5kJ --speed 310/min --delta 1:50 --rim-diameter 2m --density 7200kg/m³"
    " --rim-section 7:3",
    f"turning {MACHINE} {STEAM} --angle 37 --columns phi,torque_nm,tangential_kpa,mean_pressure_kpa",
)
# The unit of metric pages in the imperial one.
PAIRS = {
    ("mm", "in"), ("m/s", "ft/s"), ("m/s²", "ft/s²"), ("N", "lbf"), ("N m", "lbf ft"), ("J", "ft lbf"),
    ("W", "hp"), ("kW", "hp"), ("kPa", "psi"), ("bar", "psi"), ("kg", "lb"), ("kg m²", "lb ft²"),
    ("m³/min", "ft³/min"), ("m", "in"), ("cm²", "in²"), ("MPa", "psi"), ("N, N m", "lbf, lbf ft"),
    ("kg m", "lb ft"), ("km/h", "mph"), ("kg/h", "lb/h"), ("kg/kWh", "lb/(hp h)"),
}  # fmt: skip


@pytest.mark.parametrize("words", PAGES)
def test_a_page_in_imperial_units_has_the_values_of_the_metric_one(words: str) -> None:
    name = tuple(shlex.split(words))
    metric = page(name)
    other = page(name, "--units", "imperial")
    changed = 0
    for one, column in zip(metric["columns"], other["columns"], strict=True):
        assert (one["key"] == column["key"]) == (one["unit"] == column["unit"])
        assert one["unit"] == column["unit"] or (one["unit"], column["unit"]) in PAIRS
    assert len(metric["rows"]) == len(other["rows"])
    for row, own in zip(metric["rows"], other["rows"], strict=True):
        for one, column in zip(metric["columns"], other["columns"], strict=True):
            value, converted = row[one["key"]], own[column["key"]]
            units = _unit(one, row), _unit(column, row)
            if units[0] == units[1] or value is None:
                assert value == converted, (one["key"], units)
                continue
            changed += 1
            apart = _si(value, units[0]) - _si(converted, units[1])
            assert abs(apart) <= _half(value, units[0]) + _half(converted, units[1]), (
                one["key"],
                value,
                converted,
            )
    assert changed


def _unit(column: Any, row: Any) -> str:
    """Return the unit of a column in a row; some have forces in some rows and moments in others."""
    unit: str = column["unit"]
    force, _, moment = unit.partition(", ")
    row_of = row.get("residual") or row.get("force")
    return moment if moment and row_of in ("moment", "couple", "torque") else force


def _si(value: Any, unit: str) -> Fraction:
    size: Fraction = SIZES.get(unit, Fraction(1))
    return Fraction(str(value)) * size


def _half(value: Any, unit: str) -> Fraction:
    """Return half a unit of the last place, in the SI's."""
    places = len(str(value).partition(".")[2])
    found: Fraction = SIZES.get(unit, Fraction(1)) / (2 * 10**places)
    return found


ENGINE = "--stroke 24in --rod 5ft --speed 120/min --reciprocating 300lb"
ACTED = "--eps 4 --bore 12in --pressure 120psi"
METRIC = re.compile(
    r"(?<![\w/])([kM]?N m|[kM]N|[cm]m|m/s²?|km/h|kg[^\s,;]*|kWh|[kM]?Pa|bar|[kM]W|[kM]J|m³\S+|[cm]?m²)(?!\w)"
    r"|\bin N\b|\d [NJWm](?=[,;.]|$)",
    re.MULTILINE,
)


DRAWN = (
    ("table --stroke 24in --rod 5ft --columns x_mm", "in mm: 609.60 at 180°", "in inches: 24.000 at 180°"),
    (
        "table --stroke 24in --rod 5ft --speed 2/s --columns c_mps --layout over-path",
        "c in m/s: ",
        "c in ft/s: ",
    ),
    ("forces --force 1000lbf --stroke 24in --columns torque_nm", "in N m: 1382.7 at", "in lbf ft: 1019.8 at"),
    (f"forces --polar {ACTED} --stroke 24in", "in kN", "in 10³ lbf"),
    (f"pressures {ACTED} {ENGINE}", "in bar", "in psi"),
    (
        "turning --torque '(50000 + 15000 sin(3φ)) lbf ft'",
        "in kN m: T, T_L = 67.791 kN m; Excess energy W in kJ: ΔW = 13.558 kJ",
        "in 10³ lbf ft: T, T_L = 50.000 · 10³ lbf ft; Excess energy W in 10³ ft lbf: ΔW = 10.000 · 10³ ft",
    ),
    ("table --point 0.5 --columns path_along_mm --stroke 24in", "ξ in mm", "ξ in inches"),
)


@pytest.mark.parametrize(("words", "metric", "imperial"), DRAWN)
def test_a_drawing_has_the_units_that_are_given(words: str, metric: str, imperial: str) -> None:
    given = (*shlex.split(words), "--lang", "en", "-f", "svg", "--width", "150mm")
    for units, said in (((), imperial), (("--units", "metric"), metric)):
        drawn = kurbel_in(*given, *units)
        assert drawn.err == ""
        (told,) = re.findall("<desc>(.*?)</desc>", drawn.out)
        assert said in told
        assert bool(METRIC.search(told.replace("N:", ""))) is (said == metric)


@pytest.mark.parametrize(
    ("units", "key", "unit", "force", "moment"),
    [
        ("imperial", "along_lbf", "lbf, lbf ft", SIZES["lbf"], SIZES["lbf ft"]),
        ("kN; kN m", "along_kn", "kN, kN m", Fraction(1000), Fraction(1000)),
        ("kN", "along_kn_nm", "kN, N m", Fraction(1000), Fraction(1)),
        ("lbf ft", "along_n_lbfft", "N, lbf ft", Fraction(1), SIZES["lbf ft"]),
        ("lbf; lbf in", "along_lbf_lbfin", "lbf, lbf in", SIZES["lbf"], SIZES["lbf ft"] / 12),
    ],
)
def test_a_column_of_forces_and_moments_has_each_in_its_unit(
    units: str, key: str, unit: str, force: Fraction, moment: Fraction
) -> None:
    words = "balance --cranks 0;90 --reciprocating 31kg --spacing 1.3m --stroke 610mm --speed 130/min"
    asked = (*words.split(), "--columns", "residual,order,along_n", "--digits", "9", "-f", "json", "--units")
    metric, other = (json.loads(printed(*asked, one).out) for one in ("metric", units))
    assert (other["columns"][-1]["key"], other["columns"][-1]["unit"]) == (key, unit)
    for before, after in zip(metric["rows"], other["rows"], strict=True):
        size = moment if before["residual"] == "moment" else force
        was, now = Fraction(str(before["along_n"])), Fraction(str(after[key]))
        assert abs(was / size - now) <= (1 / size + 1) / (2 * 10**9)


@settings(max_examples=25, deadline=None)
@given(st.integers(1, 4000), st.sampled_from([0, 2, 5]))
def test_what_lies_half_way_between_two_printed_numbers_is_rounded_away(eighths: int, digits: int) -> None:
    """In inches the stroke of so many eighths is exact, and a tie at few digits."""
    asked = ("solve", "--ratio", "1:4", "--stroke", f"{eighths}/8 in", "--where", "s=1", "--units", "in")
    shown = printed(*asked, "--columns", "x_mm", "--digits", str(digits), "-f", "csv").records()[0]["x_in"]
    exact, unit = Decimal(eighths) / 8, Decimal(1).scaleb(-digits)
    assert Decimal(shown) == exact.quantize(unit, rounding="ROUND_HALF_UP")


# Powers of ten by the prefixes of the SI.
PREFIXED = {
    "N": ("kN", "MN"), "N m": ("kN m", "MN m"), "J": ("kJ", "MJ"), "W": ("kW", "MW"), "kW": ("MW",),
    "N, N m": ("kN, kN m",), "kPa": ("MPa",),
}  # fmt: skip
CARD_MACHINE = f"--machine {ROOT / 'examples/engine.toml'}"
LARGE = (
    f"forces {CARD_MACHINE} --step 30",
    f"forces {CARD_MACHINE} --layout rod-load-turn --step 45",
    f"forces {CARD_MACHINE} --layout rod-load",
    "forces --reciprocating 900kg --stroke 600mm --speed 200/min --layout forces-verfahren",
    # Meganewtons, and a force beside a torque that has four digits.
    "forces --force 12345678N --stroke 1m --step 60 --columns phi,rod_force_n,torque_nm",
    "forces --mechanism arc --rocker 6 --stroke 600mm --force 120kN --step 60",
    f"inertia {CARD_MACHINE} --speed 600/min --step 60",
    f"solve {CARD_MACHINE} --where torque=max",
    f"flywheel {CARD_MACHINE}",
    f"turning {CARD_MACHINE} --step 60 --columns phi,torque_nm,tangential_kpa --speed 300/min",
    f"balance {CARD_MACHINE} --engine inline-3 --spacing 1m",
    f"balance {CARD_MACHINE} --layout balance-greatest",
    "rotor --masses '200;300kg' --radii '0.2;0.15m' --angles '0;45' --planes '0;400mm' --speed 600/min",
    "locomotive --spacing 2m --gauge 1.5m --stroke crank:30cm --reciprocating 240kg --speed 300/min"
    " --wheel 1.8m --wheel-load 80kN",
    "power --eps 3 --pressure 8bar --bore 3m --stroke 4m --speed 200/min",
)


NUMBER = re.compile(r"-?\d+(\.\d+)?")


def shown_cells(words: list[str], lang: str) -> tuple[Counter[Decimal], str]:
    """Return the numbers in the cells of the page, and all that it says."""
    text = printed(*words, "-f", "html", "--lang", lang, "--decimal", "point").out
    bodies = re.findall(r"<td[^>]*>(.*?)</td>", text, re.DOTALL)
    plain = [re.sub(r"<[^>]+>", "", one).replace("−", "-").strip() for one in bodies]
    numbers = Counter(Decimal(one).normalize() for one in plain if NUMBER.fullmatch(one))
    return numbers, re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", text).replace("\N{NO-BREAK SPACE}", " "))


@pytest.mark.parametrize(("place", "words"), [*enumerate(LARGE)])
def test_a_page_has_every_digit_of_the_data_in_the_larger_unit(place: int, words: str) -> None:
    lang = ("de", "en")[place % 2]
    asked = shlex.split(words)
    shown, said = shown_cells(asked, lang)
    found = json.loads(printed(*asked, "-f", "json", "--lang", "en").out, parse_float=str)
    moved = 0
    for unit in {column["unit"] for column in found["columns"]} & set(PREFIXED):
        keys = [column["key"] for column in found["columns"] if column["unit"] == unit]
        values = [Decimal(str(row[key])) for row in found["rows"] for key in keys if row[key] is not None]
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


def test_data_are_the_same_from_a_page_and_without_one() -> None:
    words = ("forces", "--force", "56549N", "--stroke", "600mm", "--angle", "0;30", "--lang", "en")
    table = library.forces("1:5", force="56549N", stroke="600mm", angle="0;30", lang="en")
    assert "kN" in table.typeset("text")
    for name in ("csv", "json", "dat"):
        assert table.typeset(name) == printed(*words, "--ratio", "1:5", "-f", name).out
        assert "kN" not in table.typeset(name)
