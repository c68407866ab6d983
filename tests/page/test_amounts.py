"""Pages in other units: each number is the metric one times an exact factor, and every unit stands there."""

from __future__ import annotations

import json
from decimal import Decimal
from fractions import Fraction

import pytest
from cli import printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from places import CARDS

# By the definitions of 1959: the foot, the pound, and the pound-force by standard gravity.
FOOT, POUND = Fraction("0.3048"), Fraction("0.45359237")
FORCE = POUND * Fraction("9.80665")
# The unit of metric pages in the imperial one, by both.
FACTORS = {
    ("mm", "in"): Fraction("25.4"),
    ("m/s", "ft/s"): FOOT,
    ("m/s²", "ft/s²"): FOOT,
    ("N", "lbf"): FORCE,
    ("N m", "lbf ft"): FORCE * FOOT,
    ("J", "ft lbf"): FORCE * FOOT,
    ("W", "hp"): 550 * FORCE * FOOT,
    ("kW", "hp"): 550 * FORCE * FOOT / 1000,
    ("kPa", "psi"): FORCE / (FOOT / 12) ** 2 / 1000,
    ("bar", "psi"): FORCE / (FOOT / 12) ** 2 / 10**5,
    ("kg", "lb"): POUND,
    ("kg m²", "lb ft²"): POUND * FOOT**2,
    ("m³/min", "ft³/min"): FOOT**3,
    ("m", "in"): FOOT / 12,
    ("cm²", "in²"): (100 * FOOT / 12) ** 2,
    ("MPa", "psi"): FORCE / (FOOT / 12) ** 2 / 10**6,
}
SIZES = "--stroke 610mm --speed 130/min"
MASSES = f"{SIZES} --bore 305mm --pressure 7bar --reciprocating 210kg"


@pytest.mark.parametrize(
    ("words", "units"),
    [
        (f"table --ratio 2:9 --angle 37 {SIZES}", {"mm", "m/s", "m/s²"}),
        (f"table --ratio 2:9 --angle 30..31:1/500 --columns phi,x_mm,p_mps2 {SIZES}", {"mm", "m/s²"}),
        (f"forces --ratio 2:9 --angle 37 --force 3kN {SIZES} --reciprocating 9kg", {"N", "N m"}),
        (f"deadcentres --ratio 2:9 --offset 40mm {SIZES}", {"mm", "m/s"}),
        (f"delta --eps 3 {MASSES} --columns indicated_power,mean_pressure_kpa", {"kW", "kPa"}),
        (f"flywheel --eps 3 {MASSES} --delta 1:90 --radius 2m", {"kg m²", "kg", "J", "W", "N m"}),
        (
            f"flywheel --card {CARDS / 'ideal-2.csv'} --speed 130/min --power 40kW --delta 1:90",
            {"kg m²", "J", "W", "N m"},
        ),
        (
            "flywheel --swing 5kJ --speed 310/min --delta 1:50 --rim-diameter 2m --density 7200kg/m³"
            " --rim-section 7:3",
            {"J", "kg m²", "m", "m/s", "MPa", "kg", "cm²", "mm"},
        ),
        (f"turning --eps 3 --angle 37 {MASSES} --columns phi,torque_nm,tangential_kpa", {"N m", "kPa"}),
        (f"pressures --eps 3 --shares 0.3 {MASSES}", {"bar"}),
        (f"solve --ratio 2:9 --where c=max {SIZES} --columns x_mm,c_mps,p_mps2", {"mm", "m/s", "m/s²"}),
        (f"solve --eps 3 {MASSES} --where torque=max", {"N", "N m"}),
    ],
)
def test_every_number_is_the_metric_one_in_its_unit(words: str, units: set[str]) -> None:
    digits = () if "--card" in words else ("--digits", "9")
    metric, other = (
        json.loads(printed(*words.split(), *digits, "-f", "json", "--units", one).out)
        for one in ("metric", "imperial")
    )
    seen = set()
    for old, new in zip(metric["columns"], other["columns"], strict=True):
        factor = FACTORS.get((old["unit"], new["unit"]), Fraction(1))
        assert (factor == 1) == (old["unit"] == new["unit"])
        seen |= {old["unit"]} if factor != 1 else set()
        assert (old["key"] == new["key"]) == (factor == 1)
        for before, after in zip(metric["rows"], other["rows"], strict=True):
            was, now = before[old["key"]], after[new["key"]]
            if factor == 1:
                assert was == now
                continue
            # Half a unit in the last place of either.
            unit = sum(half_unit(one) * scale for one, scale in ((was, 1 / factor), (now, 1)))
            assert abs(Fraction(str(was)) / factor - Fraction(str(now))) <= unit
    assert seen == units


def half_unit(number: object) -> Fraction:
    exponent = Decimal(str(number)).as_tuple().exponent
    assert isinstance(exponent, int)
    return Fraction(10) ** exponent / 2


def test_what_is_typed_in_inches_is_printed_in_inches_but_data_stay_metric() -> None:
    words = ("table", "--crank", "6in", "--rod", "2ft", "--speed", "300rpm", "--angle", "90", "--lang", "en")
    page = printed(*words).out
    assert "x in inches" in page
    assert "R = 6 in, L = 24 in; n = 300 min⁻¹, v = 15.708 ft/s" in page
    # 6 in (1 + 4 - √15) at the middle of the turn.
    assert " 6.762 " in page
    assert "x_mm" in printed(*words, "-f", "csv").out
    assert "x_in" in printed(*words, "-f", "csv", "--units", "imperial").out
    assert "x in mm" in printed(*words, "--units", "metric").out
    assert "x in mm" in printed(*words[:3], "--rod", "60cm").out


@pytest.mark.parametrize(
    ("words", "amounts"),
    [
        # 300 mm, 1.5 m and 1 mm over 25.4 mm.
        (f"table --ratio 1:5 {SIZES.replace('610', '600')}", "R = 11.811 in, L = 59.055 in"),
        ("table --ratio 1:5 --stroke 2mm", "R = 0.0394 in, L = 0.197 in"),
        # What is a short decimal stays exact.
        ("table --ratio 1:5 --stroke 635mm", "R = 12.5 in, L = 62.5 in"),
        ("table --ratio 1:5 --stroke 50.8mm", "R = 1 in, L = 5 in"),
        (
            "balance --cranks 0;90 --positions 0;40cm --reciprocating 3;2kg --stroke 20cm --speed 9/s",
            "R = 3.937 in",
        ),
        (
            "locomotive --spacing 0.7m --gauge 1.5m --stroke 600mm --reciprocating 300kg",
            "centre lines: −13.780 in; 13.780 in; wheels at −29.528 in; 29.528 in; R = 11.811 in",
        ),
    ],
)
def test_an_amount_in_a_unit_that_it_was_not_given_in_is_a_decimal(words: str, amounts: str) -> None:
    page = " ".join(printed(*words.split(), "--units", "imperial", "--lang", "en").out.split())
    assert amounts in page
    assert "/127" not in page


@pytest.mark.parametrize(
    ("units", "key", "unit", "force", "moment"),
    [
        ("imperial", "along_lbf", "lbf, lbf ft", FORCE, FORCE * FOOT),
        ("kN; kN m", "along_kn", "kN, kN m", Fraction(1000), Fraction(1000)),
        ("kN", "along_kn_nm", "kN, N m", Fraction(1000), Fraction(1)),
        ("lbf ft", "along_n_lbfft", "N, lbf ft", Fraction(1), FORCE * FOOT),
        ("lbf; lbf in", "along_lbf_lbfin", "lbf, lbf in", FORCE, FORCE * FOOT / 12),
    ],
)
def test_a_column_of_forces_and_moments_has_each_in_its_unit(
    units: str, key: str, unit: str, force: Fraction, moment: Fraction
) -> None:
    words = f"balance --cranks 0;90 --reciprocating 31kg --spacing 1.3m {SIZES}"
    asked = (*words.split(), "--columns", "residual,order,along_n", "--digits", "9", "-f", "json", "--units")
    metric, other = (json.loads(printed(*asked, one).out) for one in ("metric", units))
    assert (other["columns"][-1]["key"], other["columns"][-1]["unit"]) == (key, unit)
    for before, after in zip(metric["rows"], other["rows"], strict=True):
        size = moment if before["residual"] == "moment" else force
        was, now = Fraction(str(before["along_n"])), Fraction(str(after[key]))
        assert abs(was / size - now) <= (1 / size + 1) / (2 * 10**9)
    assert f"in {unit}" in printed(*words.split(), "--units", units, "--lang", "en").out


@settings(max_examples=25, deadline=None)
@given(st.integers(1, 4000), st.sampled_from([0, 2, 5]))
def test_what_lies_half_way_between_two_printed_numbers_is_rounded_away(eighths: int, digits: int) -> None:
    """In inches the stroke of so many eighths is exact, and a tie at few digits."""
    asked = ("solve", "--ratio", "1:4", "--stroke", f"{eighths}/8 in", "--where", "s=1", "--units", "in")
    shown = printed(*asked, "--columns", "x_mm", "--digits", str(digits), "-f", "csv").records()[0]["x_in"]
    exact, unit = Decimal(eighths) / 8, Decimal(1).scaleb(-digits)
    assert Decimal(shown) == exact.quantize(unit, rounding="ROUND_HALF_UP")


def test_units_that_are_none_or_two_of_a_kind_are_refused() -> None:
    assert (
        'units "furlong" has the unit "furlong"; write metric, imperial or a list of mm, cm, m, in'
        in refusal("table", "--units", "furlong")
    )
    assert 'units "cm; in" has cm and in, both of length; leave one out' in refusal(
        "table", "--units", "cm; in"
    )
