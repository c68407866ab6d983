"""Weisbach-Herrmann §§ 149, 150: each printed value worked out anew; where the book contradicts itself."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import ROUND_HALF_UP, Decimal
from functools import cache
from itertools import pairwise
from typing import Any

import pytest
from cli import records
from expansion import LOWER, UPPER, Expansion
from machines import machine
from mpmath import mp
from places import SOURCES
from registers import register

DIGITS = 30
METHODS = ("exact", "series", "weisbach")
DEAD_CENTRES, TURNING = (register(SOURCES / "weisbach" / f"{section}.csv") for section in ("149", "150"))
PRINTED = {row["place"].removeprefix("weisbach-150/1:5/"): row["printed"] for row in TURNING}
# § 149 as far as scanned: r/a = 1/3, r/l = 1/5, all lengths in r.
BEAM, ROD = 3, 5


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(DIGITS):
        yield


@cache
def engine(expansion: int, method: str = "weisbach") -> Expansion:
    with mp.workdps(DIGITS):
        return Expansion(mp.mpf(1) / 5, expansion, method=method)


def his_loss(angle: Any, sign: int, expansion: int) -> Any:
    """The bracket of v_min, divided by ε."""
    return engine(expansion).energy(angle, sign)


def his_least(angle: Any, sign: int, expansion: int) -> Any:
    """sin α₁ less the right side of its equation."""
    return engine(expansion).excess_at_full_pressure(angle, sign) * expansion / (expansion - 1)


def mean_force(expansion: int) -> Any:
    """P/Q."""
    return engine(expansion).mean


@cache
def value(method: str, expansion: int, key: str) -> Any:
    """Return the value in radians, Q r, Q or P r by a method."""
    with mp.workdps(DIGITS):
        return engine(expansion, method).value(key)


def shown(number: Any, like: str) -> str:
    """Return the number as the book prints one like it: decimals, or degrees and minutes, with halves."""
    if "°" in like:
        units = 2 if "½" in like else 1
        degrees, rest = divmod(int(mp.nint(mp.degrees(number) * 60 * units)), 60 * units)
        minutes, half = divmod(rest, units)
        return f"{degrees}°{minutes}{'½' if half else ''}'"
    decimals = len(like.partition(",")[2])
    scaled = int(mp.nint(abs(number) * 10**decimals))
    sign = "-" if number < 0 and scaled else ""
    return f"{sign}{scaled // 10**decimals},{scaled % 10**decimals:0{decimals}}"


def radians(text: str) -> Any:
    degrees, minutes = text.rstrip("'").split("°")
    return mp.radians(int(degrees) + mp.mpf(minutes.replace("½", ".5")) / 60)


def assert_recorded(row: dict[str, str]) -> None:
    """Check whether his own way agrees with the print, and which of the other methods does."""
    others = [method for method in ("exact", "series") if row[method] == row["printed"]]
    verdict = "agrees" if row["weisbach"] == row["printed"] else "differs"
    assert row["record"] == (f"{verdict}: {' '.join(others)}" if others else verdict)


@pytest.mark.parametrize("expansion", range(2, 7))
def test_the_values_are_those_of_a_turn_by_quadrature_and_his_own_those_of_kurbel(expansion: int) -> None:
    """So what cells are held against is not checked by itself."""
    for method in ("exact", "series"):
        options = {"method": method} if method == "series" else {}
        turn = machine(eps=expansion, ratio="1:5", **options).turn
        assert turn.mean == pytest.approx(float(value(method, expansion, "mean_force")), rel=1e-12)
        assert turn.delta == pytest.approx(float(value(method, expansion, "delta")), rel=1e-10)
        keys = ("min", "max", "min_return", "max_return")
        for key, found in zip(keys, turn.extremes, strict=True):
            angle = float(mp.degrees(value(method, expansion, f"alpha_{key}")))
            assert found.degrees % 180 == pytest.approx(angle, abs=1e-7)
            assert found.energy == pytest.approx(float(value(method, expansion, f"v_{key}")), abs=1e-12)
    # The greatest speed of the turn is in the outstroke, the least in the return.
    columns = ("alpha_max", "v_max", "alpha_min", "v_min", "delta")
    words = (f"--eps={expansion}", "--method=weisbach", f"--columns={','.join(columns)}", "--digits=9")
    (row,) = records("delta", *words)
    for key in columns:
        true = value("weisbach", expansion, f"{key}_return" if "min" in key else key)
        shown_angle = mp.degrees(true) + (180 if "min" in key else 0)
        assert float(row[key]) == pytest.approx(float(shown_angle if "alpha" in key else true), abs=1e-9)


@pytest.mark.parametrize("row", TURNING, ids=[row["place"] for row in TURNING])
def test_every_cell_of_section_150_is_the_value_of_its_method(row: dict[str, str]) -> None:
    *_, expansion, key = row["place"].split("/")
    for method in METHODS:
        assert row[method] == shown(value(method, int(expansion), key), row["printed"])
    assert_recorded(row)


def test_every_cell_of_section_149_is_the_value_of_his_formula() -> None:
    mu, nu = (mp.mpf(1) / (4 * BEAM * (ROD + side)) for side in (1, -1))
    values = {
        "mu": mu,
        "nu": nu,
        "distance_1": mp.pi + (nu - mu),
        "distance_2": mp.pi - (nu - mu),
        "path_1": 1 - mp.cos(mu),
        "path_2": 1 - mp.cos(nu),
    }
    for row in DEAD_CENTRES:
        key = row["place"].split("/")[-1]
        if key.endswith("_radians"):
            assert row["weisbach"] == f"1/{mp.nstr(1 / values[key[:2]], 2)}".removesuffix(".0")
        else:
            assert row["weisbach"] == shown(values[key], row["printed"])
        assert_recorded(row)
    # The paths follow from the printed angles, too.
    assert shown(1 - mp.cos(radians("0°48'")), "0,00010") == "0,00010"
    assert shown(1 - mp.cos(radians("1°12'")), "0,00022") == "0,00022"


def decimal(text: str) -> Decimal:
    return Decimal(text.replace(",", "."))


def quotient(sum_of: tuple[str, str], divisor: str) -> str:
    """Return (one + other)/divisor to three places, as the book works it out from printed figures."""
    ratio = (decimal(sum_of[0]) + decimal(sum_of[1])) / decimal(divisor)
    return str(ratio.quantize(Decimal("0.001"), ROUND_HALF_UP)).replace(".", ",")


def test_least_speed_of_the_outstroke_does_not_follow_from_its_printed_angle() -> None:
    printed, angle = PRINTED["2/v_min"], radians(PRINTED["2/alpha_min"])
    assert printed == "-0,0667"
    assert shown(his_loss(angle, LOWER, 2), printed) == "-0,0413"


def test_no_angle_of_either_stroke_gives_the_printed_least_speed() -> None:
    # The sum is below zero for small angles alone; its least values are those at the two α₁.
    least = {
        sign: min(his_loss(mp.pi * step / 1500, sign, 2) for step in range(1501)) for sign in (UPPER, LOWER)
    }
    assert shown(least[UPPER], "-0,0000") == "-0,0613"
    assert shown(least[LOWER], "-0,0000") == "-0,0413"


def test_simple_slips_do_not_give_the_printed_least_speed_either() -> None:
    angle, other = radians("21°50'"), radians("32°5½'")
    arc = 2 / mp.pi * mp.log(2)
    slips = {
        "the sign of the other stroke": his_loss(angle, UPPER, 2),
        "the angle of the other stroke": his_loss(other, LOWER, 2),
        "no rod": (1 - mp.cos(angle) - arc * angle) / 2,
        "r/l for r/2l": (1 - mp.cos(angle) + mp.sin(angle) ** 2 / 5 - arc * angle) / 2,
        "r/l for r/2l and the other sign": (1 - mp.cos(angle) - mp.sin(angle) ** 2 / 5 - arc * angle) / 2,
        "not divided by ε": 2 * his_loss(angle, LOWER, 2),
        "sin 2α for sin² α": (1 - mp.cos(angle) + mp.sin(2 * angle) / 10 - arc * angle) / 2,
    }
    assert {name: shown(wrong, "-0,0000") for name, wrong in slips.items()} == {
        "the sign of the other stroke": "-0,0551",
        "the angle of the other stroke": "-0,0331",
        "no rod": "-0,0482",
        "r/l for r/2l": "-0,0344",
        "r/l for r/2l and the other sign": "-0,0620",
        "not divided by ε": "-0,0826",
        "sin 2α for sin² α": "-0,0137",
    }


def test_sum_and_irregularity_at_two_rest_on_that_slip() -> None:
    greatest, divisor = PRINTED["2/v_max"], PRINTED["2/divisor"]
    assert decimal(greatest) - decimal(PRINTED["2/v_min"]) == decimal(PRINTED["2/sum"])
    assert quotient((greatest, "0,0667"), divisor) == PRINTED["2/delta"] == PRINTED["2/delta"]
    # The least speed of the whole turn is then that of the return stroke.
    assert quotient((greatest, "0,0613"), divisor) == "1,281"
    assert shown(value("weisbach", 2, "delta"), "1,305") == "1,281"


def test_row_is_smooth_with_the_corrected_value_and_has_a_dent_as_printed() -> None:
    row = [int(decimal(PRINTED[f"{expansion}/delta"]) * 1000) for expansion in range(2, 7)]
    steps = [after - before for before, after in pairwise(row)]
    assert steps == [69, 47, 32, 24]
    corrected = [1281, *row[1:]]
    assert [after - before for before, after in pairwise(corrected)] == [93, 47, 32, 24]


def test_first_angle_as_transcribed_does_not_fulfil_its_equation() -> None:
    transcribed, read = radians(PRINTED["2/alpha_min_return"]), radians("32°5½'")
    step = his_least(radians("32°6'"), UPPER, 2) - his_least(radians("32°5½'"), UPPER, 2)
    assert abs(his_least(read, UPPER, 2)) < step / 2
    assert his_least(transcribed, UPPER, 2) > 90 * step


def test_coefficient_does_not_tell_the_first_angle() -> None:
    # Near its minimum the energy hardly changes: 46' make 0,00003.
    for text in (PRINTED["2/alpha_min_return"], "32°5½'"):
        assert shown(his_loss(radians(text), UPPER, 2), "-0,0613") == PRINTED["2/v_min_return"]


def test_second_angle_is_a_minute_short_by_his_equation() -> None:
    printed = radians(PRINTED["2/alpha_min"])
    residuals = [
        abs(his_least(printed + mp.radians(mp.mpf(minute) / 60), LOWER, 2)) for minute in (-1, 0, 1, 2)
    ]
    assert residuals.index(min(residuals)) == 2


def test_mean_force_is_cut_off_in_the_fifth_place() -> None:
    assert mp.nstr(mean_force(2), 7) == "0.2206356"
    assert PRINTED["2/mean_force"] == "0,22063"


def test_irregularity_at_three_is_a_unit_high_by_his_own_way() -> None:
    assert shown(value("weisbach", 3, "delta"), "1,3740") == "1,3732"
    assert shown(value("series", 3, "delta"), "1,3740") == "1,3733"
    assert shown(value("exact", 3, "delta"), "1,3740") == "1,3745"
    assert PRINTED["3/delta"] == "1,374"


def test_neither_exact_motion_nor_four_place_figures_explain_the_row() -> None:
    printed = [PRINTED[f"{expansion}/delta"] for expansion in range(3, 7)]
    assert [shown(value("exact", expansion, "delta"), "1,000") for expansion in range(3, 7)] == [
        "1,374",
        "1,423",
        "1,454",
        "1,478",
    ]
    assert [four_places(expansion) for expansion in range(3, 7)] == ["1,374", "1,422", "1,453", "1,478"]
    assert printed == ["1,374", "1,421", "1,453", "1,477"]


def four_places(expansion: int) -> str:
    """δ from coefficients and P rounded to four places, as the book works out ε = 2."""
    return quotient(
        (
            shown(value("weisbach", expansion, "v_max"), "0,0000"),
            shown(-value("weisbach", expansion, "v_min_return"), "0,0000"),
        ),
        shown(mean_force(expansion), "0,0000"),
    )
