"""Weisbach-Herrmann §§ 149, 150: each printed value worked out anew; where the book contradicts itself."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import ROUND_HALF_UP, Decimal
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import flint
import pytest
import textbook
from energy_curve import Exact, Plant
from mpmath import mp
from places import SOURCES
from registers import register

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.turn import Turn, turn_of
from kurbel.exact.numerals import degrees_text, number_text
from kurbel.linkage.beam import engine as beam
from kurbel.linkage.beam.engine import BeamEngine

FOLDER = SOURCES / "weisbach"
METHODS = ("exact", "series", "weisbach")
FIFTH = Fraction(1, 5)
DIGITS = 30
BITS = 110
# His upper sign, "Niedergang" and "Hingang der Kurbel", is the return stroke; he brackets the other.
UPPER, LOWER = 1, -1
STARTS = {
    2: (32, 22, 117, 104),
    3: (25, 17, 106, 94),
    4: (21, 14, 100, 88),
    5: (18, 12, 95, 84),
    6: (16, 11, 92, 81),
}


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(DIGITS):
        yield


class Cell(NamedTuple):
    """One printed value, what each method gives to as many places, and the record."""

    place: str
    cell: str
    exact: str
    series: str
    weisbach: str
    record: str
    printed: str

    @property
    def expansion(self) -> int:
        return int(self.place.split("/")[2])

    @property
    def key(self) -> str:
        return self.place.split("/")[-1]

    def computed(self, method: str) -> str:
        return str(getattr(self, method))


def cells(section: str) -> list[Cell]:
    return [Cell(**row) for row in register(FOLDER / f"{section}.csv")]


DEAD_CENTRES, TURNING = cells("149"), cells("150")


class Extremes(NamedTuple):
    """Least and greatest speed: angles in radians from the stroke's dead centre, energies in Q r."""

    least: Any
    greatest: Any
    loss: Any
    gain: Any


def path(angle: Any, sign: int) -> Any:
    """1 - cos α ∓ r/2l sin² α."""
    return 1 - mp.cos(angle) - sign * mp.sin(angle) ** 2 / 10


def his_loss(angle: Any, sign: int, expansion: int) -> Any:
    """The bracket of v_min, divided by ε."""
    arc = 2 / mp.pi * angle * mp.log(expansion)
    return ((expansion - 1) * path(angle, sign) - arc) / expansion


def his_gain(angle: Any, sign: int, expansion: int) -> Any:
    """The bracket of v_max, divided by ε."""
    bracket = 1 + mp.cos(angle) + sign * mp.sin(angle) ** 2 / 10
    bracket += 2 * mp.log(path(angle, sign) * expansion / 2)
    return (bracket - 2 / mp.pi * angle * mp.log(expansion)) / expansion


def his_least(angle: Any, sign: int, expansion: int) -> Any:
    """sin α₁ less the right side of its equation."""
    right = 2 * mp.log(expansion) / (mp.pi * (expansion - 1)) + sign * mp.sin(2 * angle) / 10
    return mp.sin(angle) - right


def his_greatest(angle: Any, sign: int, expansion: int) -> Any:
    """cot(α₂/2) less the right side of its equation."""
    bracket = mp.cos(angle / 2) ** 2 * (1 + sign * mp.mpf("0.4") * mp.sin(angle / 2) ** 2)
    return mp.cot(angle / 2) - mp.log(expansion) / (mp.pi * bracket)


@lru_cache
def extremes(method: str, sign: int, expansion: int) -> Extremes:
    """Return angles and energies of one stroke, in mpmath."""
    with mp.workdps(DIGITS):
        upper = sign == UPPER
        near = [degrees for index, degrees in enumerate(STARTS[expansion]) if (index % 2 == 0) == upper]
        return (_his if method == "weisbach" else _walked)(method, sign, expansion, near)


def _his(method: str, sign: int, expansion: int, near: list[int]) -> Extremes:
    least, greatest = (
        mp.findroot(lambda angle, f=function: f(angle, sign, expansion), mp.radians(start))
        for function, start in zip((his_least, his_greatest), near, strict=True)
    )
    return Extremes(least, greatest, his_loss(least, sign, expansion), his_gain(greatest, sign, expansion))


def _walked(method: str, sign: int, expansion: int, near: list[int]) -> Extremes:
    begun = 180 if sign == UPPER else 0
    exact = _plant(method, expansion)
    least, greatest = (exact.stationary(begun + start) for start in near)
    start = mp.radians(begun)
    return Extremes(least - start, greatest - start, exact.energy(least), exact.energy(greatest))


@lru_cache
def _plant(method: str, expansion: int) -> Exact:
    return Exact(Plant(Fraction(expansion), FIFTH, method=method))


def mean_force(expansion: int) -> Any:
    """P/Q."""
    return 2 / mp.pi * mp.log(expansion) / expansion


def swing(method: str, expansion: int) -> Any:
    strokes = [extremes(method, sign, expansion) for sign in (UPPER, LOWER)]
    return max(one.gain for one in strokes) - min(one.loss for one in strokes)


def value(method: str, expansion: int, key: str) -> Any:
    """Return the value in radians, Q r, Q or P r by a method."""
    name = key.removesuffix("_return")
    stroke = extremes(method, UPPER if key.endswith("_return") else LOWER, expansion)
    return {
        "alpha_min": lambda: stroke.least,
        "alpha_max": lambda: stroke.greatest,
        "v_min": lambda: stroke.loss,
        "v_max": lambda: stroke.gain,
        "sum": lambda: swing(method, expansion),
        "mean_force": lambda: mean_force(expansion),
        "divisor": lambda: mean_force(expansion),
        "delta": lambda: swing(method, expansion) / mean_force(expansion),
        "delta_table": lambda: swing(method, expansion) / mean_force(expansion),
    }[name]()


def shown(number: Any, like: str) -> str:
    """Return the number as the book prints one like it: decimals, or degrees and minutes, with halves."""
    if "°" in like:
        return degrees_and_minutes(number, halves="½" in like)
    decimals = len(like.partition(",")[2])
    scaled = textbook.rounded(number, decimals)
    assert scaled is not None
    return textbook.printed(scaled, decimals, ",")


def degrees_and_minutes(angle: Any, halves: bool) -> str:
    units = 2 if halves else 1
    count = int(mp.nint(mp.degrees(angle) * 60 * units))
    degrees, rest = divmod(count, 60 * units)
    minutes, half = divmod(rest, units)
    return f"{degrees}°{minutes}{'½' if half else ''}'"


def radians(text: str) -> Any:
    degrees, minutes = text.rstrip("'").split("°")
    return mp.radians(int(degrees) + mp.mpf(minutes.replace("½", ".5")) / 60)


def record(cell: Cell) -> str:
    """Whether his own way agrees with the print, and which of the other methods does."""
    others = [method for method in ("exact", "series") if cell.computed(method) == cell.printed]
    verdict = "agrees" if cell.weisbach == cell.printed else "differs"
    return f"{verdict}: {' '.join(others)}" if others else verdict


each_turning = pytest.mark.parametrize("cell", TURNING, ids=[cell.place for cell in TURNING])
each_dead_centre = pytest.mark.parametrize("cell", DEAD_CENTRES, ids=[cell.place for cell in DEAD_CENTRES])


@each_turning
@pytest.mark.parametrize("method", METHODS)
def test_every_cell_of_section_150_is_the_value_of_its_method(cell: Cell, method: str) -> None:
    assert cell.computed(method) == shown(value(method, cell.expansion, cell.key), cell.printed)


@each_turning
def test_record_says_who_agrees_with_the_book(cell: Cell) -> None:
    assert cell.record == record(cell)


@each_turning
@pytest.mark.parametrize("method", METHODS)
def test_kurbel_gives_every_cell_of_section_150(cell: Cell, method: str) -> None:
    turn = turn_of(Engine(Crank(FIFTH), Steam(Fraction(cell.expansion))), method)
    assert isinstance(turn, Turn)
    with flint.ctx.workprec(BITS):
        ball = kurbel(turn, cell.key)
    number = mp.mpf(ball.mid().str(DIGITS + 2, radius=False))
    assert cell.computed(method) == shown(number, cell.printed)


def kurbel(turn: Turn, key: str) -> Any:
    stroke = int(key.endswith("_return"))
    name = key.removesuffix("_return")
    if name in ("alpha_min", "alpha_max"):
        return turn.extreme(name == "alpha_max", stroke).place * flint.arb.pi()
    if name in ("v_min", "v_max"):
        return turn.extreme(name == "v_max", stroke).energy
    if name == "sum":
        return turn.irregularity() * turn.mean_force()
    return turn.irregularity() if name.startswith("delta") else turn.mean_force()


def test_every_value_of_the_sections_is_there() -> None:
    in_text = ["alpha_min_return", "alpha_min", "v_min_return", "v_min", "alpha_max_return", "alpha_max"]
    in_text += ["v_max_return", "v_max", "sum", "mean_force", "divisor", "delta"]
    assert [cell.place for cell in TURNING] == [
        *(f"weisbach-150/1:5/2/{key}" for key in in_text),
        *(f"weisbach-150/1:5/{expansion}/delta_table" for expansion in range(2, 7)),
    ]
    keys = ("mu_radians", "nu_radians", "mu", "nu", "distance_1", "distance_2", "path_1", "path_2")
    assert [cell.place for cell in DEAD_CENTRES] == [f"weisbach-149/1:5/{key}" for key in keys]


# § 149 as far as scanned: r/a = 1/3, r/l = 1/5, all lengths in r.
BEAM, ROD = 3, 5
MU = Fraction(1, 4 * BEAM * (ROD + 1))
NU = Fraction(1, 4 * BEAM * (ROD - 1))


def dead_centre(key: str, like: str) -> str:
    """Return what his formula gives."""
    mu, nu = textbook.real(MU), textbook.real(NU)
    radians = {
        "mu": mu,
        "nu": nu,
        "distance_1": mp.pi + (nu - mu),
        "distance_2": mp.pi - (nu - mu),
        "path_1": 1 - mp.cos(mu),
        "path_2": 1 - mp.cos(nu),
    }
    fractions = {"mu_radians": MU, "nu_radians": NU}
    return str(fractions[key]) if key in fractions else shown(radians[key], like)


def kurbels_dead_centre(key: str, exact: bool) -> str:
    quantity = beam.registry()[key]
    engine, method = BeamEngine(Fraction(BEAM), FIFTH), beam.EXACT if exact else beam.APPROXIMATE
    if quantity.minutes:
        minutes = beam.certified(quantity, engine, method, 0, times=60)
        return degrees_text(Fraction(minutes.scaled, 60))
    return number_text(beam.certified(quantity, engine, method, beam.PATH_DECIMALS), ",")


@each_dead_centre
def test_every_cell_of_section_149_is_the_value_of_his_formula(cell: Cell) -> None:
    assert cell.weisbach == dead_centre(cell.key, cell.printed)
    assert cell.record == record(cell)


@each_dead_centre
def test_kurbel_gives_every_cell_of_section_149(cell: Cell) -> None:
    # The motion of the first order has no formulas for a beam, and the true angles are no fractions.
    assert cell.series == ""
    if cell.key.endswith("_radians"):
        assert cell.exact == ""
    else:
        assert cell.weisbach == kurbels_dead_centre(cell.key, exact=False)
        # Which is the true geometry's: tests/linkage/test_beam.py.
        assert cell.exact == kurbels_dead_centre(cell.key, exact=True)


def test_paths_of_section_149_follow_from_the_printed_angles_too() -> None:
    assert shown(1 - mp.cos(radians("0°48'")), "0,00010") == "0,00010"
    assert shown(1 - mp.cos(radians("1°12'")), "0,00022") == "0,00022"


PRINTED = {cell.place.removeprefix("weisbach-150/1:5/"): cell.printed for cell in TURNING}


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
        sign: min(his_loss(mp.pi * step / 4000, sign, 2) for step in range(4001)) for sign in (UPPER, LOWER)
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
    assert quotient((greatest, "0,0667"), divisor) == PRINTED["2/delta"] == PRINTED["2/delta_table"]
    # The least speed of the whole turn is then that of the return stroke.
    assert quotient((greatest, "0,0613"), divisor) == "1,281"
    assert shown(value("weisbach", 2, "delta"), "1,305") == "1,281"


def test_row_is_smooth_with_the_corrected_value_and_has_a_dent_as_printed() -> None:
    row = [int(decimal(PRINTED[f"{expansion}/delta_table"]) * 1000) for expansion in range(2, 7)]
    steps = [after - before for before, after in pairwise(row)]
    assert steps == [69, 47, 32, 24]
    corrected = [1281, *row[1:]]
    assert [after - before for before, after in pairwise(corrected)] == [
        93,
        47,
        32,
        24,
    ]


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
    assert PRINTED["3/delta_table"] == "1,374"


def test_neither_exact_motion_nor_four_place_figures_explain_the_row() -> None:
    printed = [PRINTED[f"{expansion}/delta_table"] for expansion in range(3, 7)]
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
