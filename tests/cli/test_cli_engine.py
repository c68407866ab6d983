"""`kurbel delta`, `turning` and `flywheel`: what is asked for is what is printed, and its digits are true.

True digits come from energy_curve.py, which integrates the force over the angle, and from § 150 of
Weisbach-Herrmann.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from cli import printed, refusal
from energy_curve import Curve, Exact, Plant, real
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from places import CARDS
from textbook import printed as digits
from textbook import rounded

from kurbel.cli import COMMANDS
from kurbel.engine.quantities import engine_registry
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.page.labels import unprompted

BITS = 160
FIFTH, QUARTER = Fraction(1, 5), Fraction(1, 4)
OUT, RETURN, TURN = "outstroke", "return", "turn"
SPANS = {OUT: (0, 180), RETURN: (180, 360), TURN: (0, 360)}
TASK = ("--power", "50kW", "--speed", "120/min", "--delta", "1:100")


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with mp.workprec(BITS):
        yield


class Extreme(NamedTuple):
    """Degrees from the dead centre of the span, and energy in Q r."""

    place: Any
    energy: Any


class Solved(NamedTuple):
    """A turn by quadrature: mean force, and by the name of a span its least and greatest speed."""

    exact: Exact
    least: dict[str, Extreme]
    greatest: dict[str, Extreme]

    @property
    def delta(self) -> Any:
        return (self.greatest[TURN].energy - self.least[TURN].energy) / self.exact.mean_force


@cache
def solved(plant: Plant) -> Solved:
    exact = Exact(plant)
    found = []
    for near, rising in Curve(plant).stationary():
        angle = exact.stationary(near)
        found.append((angle * 180 / mp.pi, exact.energy(angle), rising))
    least, greatest = {}, {}
    for span, (start, end) in SPANS.items():
        within = [one for one in found if start <= one[0] <= end]
        lows = [one for one in within if one[2]]
        highs = [one for one in within if not one[2]]
        if lows and highs:
            low, high = min(lows, key=lambda one: one[1]), max(highs, key=lambda one: one[1])
            least[span], greatest[span] = Extreme(low[0] - start, low[1]), Extreme(high[0] - start, high[1])
    return Solved(exact, least, greatest)


# His upper sign, the return stroke, has s = 1 - cos α - ½ λ sin² α.
SIGNS = {RETURN: 1, OUT: -1}


def angles_by_weisbach(expansion: int, ratio: Fraction, upper: int) -> tuple[Any, Any]:
    """α₁ and α₂ of § 150 for the best back pressure."""
    eps, lam = mp.mpf(expansion), real(ratio)

    def least(angle: Any) -> Any:
        right = 2 * mp.log(eps) / (mp.pi * (eps - 1)) + upper * lam / 2 * mp.sin(2 * angle)
        return mp.sin(angle) - right

    def greatest(angle: Any) -> Any:
        below = mp.cos(angle / 2) ** 2 * (1 + upper * 2 * lam * mp.sin(angle / 2) ** 2)
        return mp.cot(angle / 2) - mp.log(eps) / (mp.pi * below)

    return (
        mp.findroot(least, (mp.mpf("0.1"), mp.mpf("0.7")), solver="anderson"),
        mp.findroot(greatest, (mp.mpf("1.3"), mp.mpf("2.2")), solver="anderson"),
    )


def by_weisbach(expansion: int, ratio: Fraction) -> Any:
    """δ of § 150 for the best back pressure, from his v_min and v_max of both strokes."""
    eps, lam = mp.mpf(expansion), real(ratio)
    done = 2 / mp.pi * mp.log(eps)
    lows, highs = [], []
    for upper in SIGNS.values():
        low, high = angles_by_weisbach(expansion, ratio, upper)
        first, second = (1 - mp.cos(one) - upper * lam / 2 * mp.sin(one) ** 2 for one in (low, high))
        lows.append((eps - 1) * first - done * low)
        highs.append(2 - second + 2 * mp.log(second * eps / 2) - done * high)
    return (max(highs) - min(lows)) / done


def of(value: Any, decimals: int) -> str:
    """Return the true digits."""
    scaled = rounded(value, decimals, bits=BITS)
    assert scaled is not None
    return digits(scaled, decimals)


def csv(*words: str, **environment: str) -> list[dict[str, str]]:
    return printed(*words, "-f", "csv", **environment).records()


def column(key: str, *words: str) -> list[str]:
    return [record[key] for record in csv(*words)]


def minutes(degrees: Any) -> str:
    """Return degrees and minutes as pages print them."""
    whole = rounded(degrees * 60, 0, bits=BITS)
    assert whole is not None
    return f"{whole // 60}°{whole % 60}′"


def ratio_of(text: str) -> Fraction:
    crank, rod = text.split(":")
    return Fraction(0) if rod == "∞" else Fraction(crank) / Fraction(rod)


# kurbel delta ------------------------------------------------------------------------------------


def test_delta_of_the_book_has_its_true_digits() -> None:
    records = csv("delta", "--eps", "2..6")
    assert [record["epsilon"] for record in records] == ["2", "3", "4", "5", "6"]
    assert {record["ratio"] for record in records} == {"1:5"}
    found = [record["delta"] for record in records]
    assert found == ["1.282", "1.374", "1.423", "1.454", "1.478"]
    assert found == [of(solved(Plant(Fraction(eps), FIFTH)).delta, 3) for eps in range(2, 7)]
    assert printed("delta").out == printed("delta", "--eps", "2..6", "--ratio", "1:5").out


def test_delta_by_weisbach_is_that_of_his_own_equations() -> None:
    found = column("delta", "delta", "--eps", "2..6", "--method", "weisbach", "--digits", "25")
    assert found == [of(by_weisbach(eps, FIFTH), 25) for eps in range(2, 7)]
    # He prints 1,305, 1,374, 1,421, 1,453, 1,477; the first two are slips of his.
    assert [f"{float(one):.3f}" for one in found] == ["1.281", "1.373", "1.421", "1.453", "1.477"]


@pytest.mark.parametrize(
    ("words", "expansions"),
    [
        (("--eps", "4"), ["4"]),
        (("--eps", "2;3,5;4"), ["2.0", "3.5", "4.0"]),
        (("--eps", "2..3:0.5"), ["2.0", "2.5", "3.0"]),
        (("--eps", "2,5..3,5"), ["2.5", "3.5"]),
        (("--eps", "1.5;2..4;2"), ["1.5", "2.0", "3.0", "4.0"]),
        (("--eps", "5", "--eps", "2"), ["5", "2"]),
        (("--eps", "2e1"), ["20"]),
    ],
)
def test_expansions_are_read_as_lists_and_ranges(words: tuple[str, ...], expansions: list[str]) -> None:
    records = csv("delta", *words)
    assert [record["epsilon"] for record in records] == expansions
    for record in records:
        plant = Plant(Fraction(record["epsilon"]), FIFTH)
        assert record["delta"] == of(solved(plant).delta, 3)


def test_several_ratios_are_printed_side_by_side() -> None:
    words = ("delta", "--eps", "2;3", "--ratio", "1:4;1:∞")
    assert printed(*words).out == printed(*words, "--layout", "delta-tafel").out
    records = csv(*words)
    assert [(record["epsilon"], record["ratio"]) for record in records] == [
        ("2", "1:4"), ("2", "1:∞"), ("3", "1:4"), ("3", "1:∞"),
    ]  # fmt: skip
    for record in records:
        plant = Plant(Fraction(record["epsilon"]), ratio_of(record["ratio"]))
        assert record["delta"] == of(solved(plant).delta, 3)
    first, second = (record["delta"].replace(".", ",") for record in records[2:])
    lines = [line.split() for line in printed(*words).out.splitlines()]
    assert lines.count(["3", first, second]) == 1


def test_ratios_may_be_given_in_several_options() -> None:
    words = ("delta", "--eps", "2")
    both = printed(*words, "--ratio", "1:4", "-r", "1:6").out
    assert both == printed(*words, "--ratio", "1:4;1:6").out


STEAMS = {
    (): Plant(Fraction(3), QUARTER),
    ("--back", "0,2"): Plant(Fraction(3), QUARTER, Fraction(1, 5)),
    ("--back", "10%"): Plant(Fraction(3), QUARTER, Fraction(1, 10)),
    ("--back", "0"): Plant(Fraction(3), QUARTER, Fraction(0)),
    ("--exponent", "1,13"): Plant(Fraction(3), QUARTER, exponent=Fraction(113, 100)),
    ("--clearance", "5%"): Plant(Fraction(3), QUARTER, clearance=Fraction(1, 20)),
    ("--exponent", "1.13", "--clearance", "0.05", "--back", "0.1"): Plant(
        Fraction(3), QUARTER, Fraction(1, 10), Fraction(113, 100), Fraction(1, 20)
    ),
    ("--single-acting",): Plant(Fraction(3), QUARTER, double=False),
    ("--cranks", "0;90"): Plant(Fraction(3), QUARTER, cranks=(Fraction(0), Fraction(90))),
    ("--cranks", "0..240:120", "--single-acting", "--back", "0.1"): Plant(
        Fraction(3), QUARTER, Fraction(1, 10), double=False, cranks=tuple(map(Fraction, (0, 120, 240)))
    ),
    ("--method", "series"): Plant(Fraction(3), QUARTER, method="series"),
    ("--method", "series", "--cranks", "0°0';67°30'"): Plant(
        Fraction(3), QUARTER, cranks=(Fraction(0), Fraction(135, 2)), method="series"
    ),
}  # fmt: skip
each_steam = pytest.mark.parametrize("words", STEAMS, ids=" ".join)


@each_steam
def test_engine_that_was_described_is_the_engine_that_is_computed(words: tuple[str, ...]) -> None:
    asked = ("delta", "--eps", "3", "--ratio", "1:4", *words, "--columns", "delta,mean_force,back")
    (record,) = csv(*asked, "--digits", "12")
    turn = solved(STEAMS[words])
    assert record == {
        "delta": of(turn.delta, 12),
        "mean_force": of(turn.exact.mean_force, 12),
        "back": of(turn.exact.back, 12),
    }


def test_full_pressure_and_infinite_rod_have_the_closed_form() -> None:
    # W/(Q r) = 1 - cos φ - (2/π) φ with extremes at sin φ = 2/π, whatever the back pressure takes away.
    alpha = mp.asin(2 / mp.pi)
    swing = 2 * mp.cos(alpha) - 2 / mp.pi * (mp.pi - 2 * alpha)
    words = ("delta", "--eps", "1", "--ratio", "1:inf", "--digits", "20")
    for back in ("0", "0.5"):
        assert column("delta", *words, "--back", back) == [of(swing * mp.pi / 2, 20)]


def test_two_cranks_at_one_angle_do_twice_the_work_as_unevenly() -> None:
    words = ("--eps", "3", "--ratio", "1:4", "--digits", "20")
    turn = solved(Plant(Fraction(3), QUARTER))
    for cranks, count in (("0", 1), ("0;0", 2), ("0;360;-360", 3)):
        asked = ("delta", *words, "--cranks", cranks, "--columns", "delta,mean_force,v_min,v_max")
        (record,) = csv(*asked)
        assert record == {
            "delta": of(turn.delta, 20),
            "mean_force": of(count * turn.exact.mean_force, 20),
            "v_min": of(count * turn.least[TURN].energy, 20),
            "v_max": of(count * turn.greatest[TURN].energy, 20),
        }
        (at_40,) = csv("turning", *words, "--cranks", cranks, "--angle", "40")
        place = 2 * mp.pi / 9
        assert at_40["tangential"] == of(count * turn.exact.force(place), 20)
        assert at_40["energy"] == of(count * turn.exact.energy(place), 20)


def test_two_cranks_of_a_card_at_one_angle_do_twice_the_work_as_unevenly() -> None:
    words = ("delta", "--card", str(CARDS / "ideal-2.csv"), "--columns", "delta,mean_force", "--digits", "7")
    one, two = csv(*words)[-1], csv(*words, "--cranks", "0;0")[-1]
    turn = solved(Plant(Fraction(2), FIFTH))
    assert one["delta"] == two["delta"] == of(turn.delta, 7)
    assert [one["mean_force"], two["mean_force"]] == [of(n * turn.exact.mean_force, 7) for n in (1, 2)]


def test_cranks_follow_the_first_by_their_angles() -> None:
    cranks = (Fraction(0), Fraction(90), Fraction(225))
    plant = Plant(Fraction(3), QUARTER, Fraction(1, 10), cranks=cranks)
    words = ("--eps", "3", "--ratio", "1:4", "--back", "0.1", "--cranks")
    curve, angles = Curve(plant), (30, 100, 200, 310)
    found = csv("turning", *words, "0;90;225", "--angle", "30;100;200;310", "--digits", "6")
    for record, angle in zip(found, angles, strict=True):
        place = int(angle / curve.step)
        assert abs(float(record["tangential_excess"]) - curve.excess[place]) < 1e-6
        assert abs(float(record["energy"]) - curve.energy[place]) < 1e-6
        # At φ the second crank has turned by φ - 90° and the third by φ - 225°.
        own = [(angle - crank) % 360 for crank in (0, 90, 225)]
        one = csv("turning", *words, "0", "--angle", ";".join(map(str, own)), "--digits", "9")
        assert record["tangential"] == f"{sum(float(each['tangential']) for each in one):.6f}"
    for order in ("0;90;225", "0;225;90"):
        (delta,) = column("delta", "delta", *words, order, "--digits", "9")
        assert abs(float(delta) - curve.irregularity) < 1e-6
    # Going ahead by as much is another turn.
    ahead = csv("turning", *words, "0;270;135", "--angle", "30;100;200;310", "--digits", "6")
    assert all(
        behind["tangential"] != before["tangential"] for behind, before in zip(found, ahead, strict=True)
    )


def test_cranks_of_a_card_follow_the_first_too() -> None:
    words = ("--cranks", "0;90;225", "--angle", "30;100;200;310", "--columns", "tangential,energy")
    keys = ("tangential", "energy")
    measured = csv("turning", "--card", str(CARDS / "ideal-2.csv"), *words, "--digits", "6")
    for record, ideal in zip(measured, csv("turning", "--eps", "2", *words, "--digits", "6"), strict=True):
        assert [record[key] for key in keys] == [ideal[key] for key in keys]


def test_a_machine_of_more_cranks_turns_more_evenly() -> None:
    one, two, three = (
        float(*column("delta", "delta", "--eps", "4", "--cranks", cranks))
        for cranks in ("0", "0;90", "0;60;120")
    )
    assert one > two > three


# kurbel delta --detail ---------------------------------------------------------------------------


def test_detail_has_every_stroke_and_the_whole_turn() -> None:
    words = ("delta", "--detail", "--eps", "3", "--ratio", "1:4", "--back", "0.1", "--digits", "8")
    records = csv(*words)
    turn = solved(Plant(Fraction(3), QUARTER, Fraction(1, 10)))
    assert [record["stroke"] for record in records] == [OUT, RETURN, TURN]
    for record in records:
        span = record["stroke"]
        low, high = turn.least[span], turn.greatest[span]
        assert record["alpha_min"] == of(low.place, 8)
        assert record["v_min"] == of(low.energy, 8)
        assert record["alpha_max"] == of(high.place, 8)
        assert record["v_max"] == of(high.energy, 8)
    degrees = [turn.exact.cut_off_angle(returning) * 180 / mp.pi for returning in (False, True)]
    assert [record["alpha_cutoff"] for record in records] == [*(of(one, 8) for one in degrees), ""]
    assert [record["mean_force"] for record in records] == ["", "", of(turn.exact.mean_force, 8)]
    assert [record["delta"] for record in records] == ["", "", of(turn.delta, 8)]
    assert printed(*words).out == printed(*words, "--layout", "delta-detail").out


@pytest.mark.parametrize("expansion", [2, 5])
def test_detail_prints_the_angles_of_his_equations_to_the_minute(expansion: int) -> None:
    words = ("delta", "--detail", "--eps", str(expansion), "--method", "weisbach", "--lang", "en")
    rows = [line.split()[-3:] for line in printed(*words).out.splitlines() if "speed at" in line]
    roots = {span: angles_by_weisbach(expansion, FIFTH, upper) for span, upper in SIGNS.items()}
    for place, row in enumerate(rows):
        out, back = (roots[span][place] * 180 / mp.pi for span in (OUT, RETURN))
        # The least speed of the turn is that of the return stroke, the greatest that of the outstroke.
        turn = (back + 180, out)[place]
        assert row == [minutes(out), minutes(back), minutes(turn)]


def test_detail_prints_the_angles_of_the_book() -> None:
    # He has 21°50', 104°12' and 116°32'; his 32°51½' on the return stroke does not solve his equation.
    words = ("delta", "--detail", "--eps", "2", "--method", "weisbach")
    rows = [line.split()[-3:-1] for line in printed(*words).out.splitlines() if "digkeit bei" in line]
    assert rows == [["21°51′", "32°6′"], ["104°12′", "116°32′"]]


def test_detail_marks_the_two_speeds_that_make_delta() -> None:
    page = printed("delta", "--detail", "--eps", "2", "--lang", "en").out
    marked = [word for line in page.splitlines() for word in line.split() if word.endswith("ᵃ⁾")]
    turn = solved(Plant(Fraction(2), FIFTH))
    lowest, highest = of(turn.least[TURN].energy, 4), of(turn.greatest[TURN].energy, 4)
    assert marked[:2] == [f"{lowest.replace('-', '−')}ᵃ⁾", f"{highest}ᵃ⁾"]
    assert "δ follows from these two" in page


def test_detail_of_several_cranks_has_the_turn_alone() -> None:
    words = ("delta", "--detail", "--eps", "3", "--ratio", "1:4", "--cranks", "0;90", "--digits", "6")
    (record,) = csv(*words)
    turn = solved(Plant(Fraction(3), QUARTER, cranks=(Fraction(0), Fraction(90))))
    assert record == {
        "epsilon": "3",
        "ratio": "1:4",
        "stroke": TURN,
        "mean_force": of(turn.exact.mean_force, 6),
        "alpha_min": of(turn.least[TURN].place, 6),
        "v_min": of(turn.least[TURN].energy, 6),
        "alpha_max": of(turn.greatest[TURN].place, 6),
        "v_max": of(turn.greatest[TURN].energy, 6),
        "delta": of(turn.delta, 6),
    }
    page = printed(*words).out
    assert "Hingang" not in page
    assert "ᵃ⁾" not in page
    assert "Kurbeln um 90° hinter der ersten, Zylinder gleich" in " ".join(page.split())


def test_detail_of_several_engines_has_a_group_for_each() -> None:
    words = ("delta", "--detail", "--eps", "2;3", "--ratio", "1:4;1:5", "--lang", "en")
    heads = [line.strip() for line in printed(*words).out.splitlines() if line.strip().startswith("ε = ")]
    assert heads == [f"ε = {eps}, r:l = 1:{rod}" for eps in (2, 3) for rod in (4, 5)]
    assert len(csv(*words)) == 4 * 3


# Several methods ---------------------------------------------------------------------------------

METHODS = {
    ("exact", "series", "weisbach"): (
        "delta_exact", "delta_series", "delta_weisbach", "difference_series", "difference_weisbach",
    ),
    ("exact", "series"): ("delta_exact", "delta_series", "difference_series"),
    ("weisbach", "exact"): ("delta_exact", "delta_weisbach", "difference_weisbach"),
    ("series", "weisbach"): ("delta_series", "delta_weisbach"),
}  # fmt: skip


@pytest.mark.parametrize("methods", METHODS, ids="-".join)
def test_several_methods_are_compared_by_those_columns_alone(methods: tuple[str, ...]) -> None:
    words = ("delta", "--eps", "2;4", *(word for method in methods for word in ("--method", method)))
    assert printed(*words).out == printed(*words, "--layout", "delta-verfahren").out
    records = csv(*words, "--digits", "9")
    assert tuple(records[0]) == ("epsilon", "ratio", *METHODS[methods])
    for record in records:
        true = {
            "exact": solved(Plant(Fraction(record["epsilon"]), FIFTH)).delta,
            "series": solved(Plant(Fraction(record["epsilon"]), FIFTH, method="series")).delta,
            "weisbach": by_weisbach(int(record["epsilon"]), FIFTH),
        }
        for key in METHODS[methods]:
            kind, method = key.split("_")
            value = true[method] if kind == "delta" else true["exact"] - true[method]
            assert record[key] == of(value, 9)


def test_a_method_given_twice_is_one() -> None:
    words = ("delta", "--eps", "2", "--method", "series")
    assert printed(*words, "--method", "series").out == printed(*words).out


def test_the_layout_of_methods_shows_those_asked_for() -> None:
    words = ("delta", "--eps", "3", "--layout", "delta-verfahren")
    assert tuple(csv(*words)[0]) == ("epsilon", "ratio", *METHODS["exact", "series", "weisbach"])
    assert tuple(csv(*words, "--method", "series")[0]) == ("epsilon", "ratio", "delta_series")
    with_series = csv(*words, "--columns", "difference_series,epsilon")
    assert [tuple(record) for record in with_series] == [("difference_series", "epsilon")]


# Indicator cards ---------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["exact", "series"])
def test_the_ideal_card_makes_the_page_of_its_expansion(method: str) -> None:
    words = ("delta", "--detail", "--ratio", "1:4", "--method", method)
    measured, ideal = csv(*words, "--card", str(CARDS / "ideal-2.csv")), csv(*words, "--eps", "2")
    for record, expected in zip(measured, ideal, strict=True):
        assert record.pop("card").endswith("ideal-2.csv")
        errors = {key: record.pop(key) for key in tuple(record) if key.endswith("_error")}
        assert {key: expected[key] for key in record} == record
        # Each value is followed by its error, which so good a card has hardly any of.
        for key, error in errors.items():
            assert (error == "") == (record[key.removesuffix("_error")] == "")
            assert not error or 0 < float(error) < 1e-5
    cards = ("delta", "--card", str(CARDS / "ideal-2.csv"))
    assert printed(*cards).out == printed(*cards, "--detail").out


def test_cards_are_compared_a_row_each() -> None:
    files = [str(CARDS / name) for name in ("ideal-2.csv", "condenser.csv")]
    words = ("delta", "--layout", "delta-tafel", "--ratio", "1:4;1:5", "--card", files[0], "--card", files[1])
    records = csv(*words)
    assert [(Path(record["card"]).name, record["ratio"]) for record in records] == [
        ("ideal-2.csv", "1:4"), ("ideal-2.csv", "1:5"), ("condenser.csv", "1:4"), ("condenser.csv", "1:5"),
    ]  # fmt: skip
    assert [record["delta"] for record in records[:2]] == [
        of(solved(Plant(Fraction(2), ratio)).delta, 3) for ratio in (QUARTER, FIFTH)
    ]


# Columns, digits, languages, formats -------------------------------------------------------------


def test_the_column_of_the_cut_off_chooses_the_page_of_strokes() -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4", "--columns", "delta,alpha_cutoff")
    assert printed(*words).out == printed(*words, "--detail").out
    exact = solved(Plant(Fraction(3), QUARTER)).exact
    degrees = [exact.cut_off_angle(returning) * 180 / mp.pi for returning in (False, True)]
    assert column("alpha_cutoff", *words) == [*(of(one, 3) for one in degrees), ""]


def test_exponent_and_clearance_are_columns_too() -> None:
    words = ("--eps", "3", "--exponent", "1,13", "--clearance", "5%", "--columns", "exponent,clearance")
    assert csv("delta", *words) == [{"exponent": "1.13", "clearance": "0.05"}]
    assert csv("turning", *words, "--angle", "5") == [{"exponent": "1.13", "clearance": "0.05"}]
    assert csv("delta", *words, "--digits", "1", "--rounding", "half-even") == [
        {"exponent": "1.1", "clearance": "0.0"}
    ]
    page = printed("delta", *words, "--lang", "en").out
    assert "Exponent of the expansion n" in page
    assert "Clearance κ" in page


def test_columns_are_picked_and_ordered() -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4")
    (record,) = csv(*words, "--columns", "v_max, delta", "--columns", "epsilon;alpha_min")
    turn = solved(Plant(Fraction(3), QUARTER))
    assert list(record.items()) == [
        ("v_max", of(turn.greatest[TURN].energy, 4)),
        ("delta", of(turn.delta, 3)),
        ("epsilon", "3"),
        ("alpha_min", of(turn.least[TURN].place, 3)),
    ]
    page = printed(*words, "--columns", "mean_force,delta", "--lang", "en").out
    assert page.index("Mean tangential force P") < page.index("Degree of irregularity δ")


@pytest.mark.parametrize("decimals", [0, 30])
def test_digits_go_for_every_column(decimals: int) -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4", "--digits", str(decimals))
    (record,) = csv(*words, "--columns", "delta,mean_force,v_min,alpha_max")
    turn = solved(Plant(Fraction(3), QUARTER))
    values = (turn.delta, turn.exact.mean_force, turn.least[TURN].energy, turn.greatest[TURN].place)
    assert list(record.values()) == [of(value, decimals) for value in values]
    assert of(turn.delta, decimals).replace(".", ",") in printed(*words).out


def test_rounding_tells_what_becomes_of_a_tie() -> None:
    words = ("flywheel", "--eps", "4", "--power", "2.5W", *TASK[2:], "--digits", "0")
    assert column("power", *words) == ["3"]
    assert column("power", *words, "--rounding", "half-even") == ["2"]
    delta = ("delta", "--eps", "2", "--rounding")
    assert printed(*delta, "half-even").out == printed(*delta, "half-away").out


@pytest.mark.parametrize("name", ["delta", "turning", "flywheel"])
def test_language_and_decimal_mark_are_the_users(name: str) -> None:
    words = (name, *(TASK if name == "flywheel" else ()), "--eps", "4")
    german, english = printed(*words).out, printed(*words, "--lang", "en").out
    assert "Dampfmaschine" in german
    # The caption may end a line between the words.
    assert "steam engine" in " ".join(english.split())
    assert not set("äöüß") & set(english)
    number = {"delta": "1,423", "turning": "0,5902", "flywheel": "3584,3"}[name]
    point = number.replace(",", ".")
    assert (number in german, point in german) == (True, False)
    assert (number in english, point in english) == (False, True)
    assert point in printed(*words, "--decimal", "point").out
    assert number in printed(*words, "--lang", "en", "--decimal", "comma").out
    with_commas = printed(*words, "-f", "csv", "--decimal", "comma")
    assert any(number in record.values() for record in with_commas.records(";"))


@pytest.mark.parametrize("form", [name for name, one in FORMATS.items() if not isinstance(one, BytesFormat)])
@pytest.mark.parametrize("name", ["delta", "turning", "flywheel"])
def test_every_format_has_the_digits_and_a_file_is_what_is_printed(
    name: str, form: str, tmp_path: Path
) -> None:
    words = (name, *(TASK if name == "flywheel" else ()), "--eps", "4", "--lang", "en")
    text = printed(*words, "-f", form).out
    assert {"delta": "1.423", "turning": "0.5902", "flywheel": "3584.3"}[name] in text
    path = tmp_path / f"anhang{FORMATS[form].suffixes[0]}"
    assert printed(*words, "-o", str(path)).out == ""
    assert path.read_text(encoding="utf-8") == text
    if FORMATS[form].standalone:
        assert printed(*words, "-f", form, "--standalone").out.count(text.splitlines()[-1]) == 1


def test_json_has_the_rows_of_csv_and_null_where_there_is_no_value() -> None:
    words = ("delta", "--detail", "--eps", "2;3")
    rows = json.loads(printed(*words, "-f", "json").out, parse_float=str, parse_int=str)["rows"]
    assert [{key: value or "" for key, value in row.items()} for row in rows] == csv(*words)
    assert rows[0]["delta"] is None
    head = json.loads(printed(*words, "-f", "json", "--lang", "en").out)
    delta = next(one for one in head["columns"] if one["key"] == "delta")
    assert (delta["name"], delta["symbol"], delta["unit"], delta["decimals"], delta["method"]) == (
        "Degree of irregularity", "δ", "P r/(m₁ v₁²)", 3, "exact",
    )  # fmt: skip


def test_label_is_the_name_of_the_reference() -> None:
    assert r"\label{tab:zwei}" in printed("delta", "-f", "latex", "--label", "zwei").out
    assert r"\label{tab:weisbach-150}" in printed("delta", "-f", "latex").out
    assert 'id="tab-drei"' in printed("turning", "--eps=4", "-f", "html", "--label", "drei").out


def test_the_page_says_what_engine_it_is_about() -> None:
    def told(*words: str) -> str:
        return " ".join(printed("delta", "--eps", "4", "--lang", "en", *words).out.split())

    assert "Expansion by Mariotte's law (--exponent); no clearance (--clearance); " in told()
    assert (
        "back pressure R_b = Q/ε, the most favourable (--back); double-acting (else --single-acting)"
        in told()
    )
    assert "Expansion by p Vⁿ = const, n = 1.13" in told("--exponent", "1.13")
    best = "back pressure equal to the steam's at the end of the stroke, the most favourable"
    assert best in told("--exponent", "1.13")
    assert best in told("--clearance", "5%")
    assert "clearance 0.05 of the swept volume" in told("--clearance", "5%")
    assert "back pressure R_b = 0.1 Q" in told("--back", "10%")
    assert "single-acting" in told("--single-acting")
    vacuum = "back pressure R_b = 0; double-acting (else --single-acting) Source: "
    assert told("--back", "0").endswith(vacuum + told().partition("Source: ")[2])
    assert "cranks 90° behind the first, cylinders alike" in told("--cranks", "0;90")
    assert "cranks 0°, 225° behind the first, cylinders alike" in told("--cranks", "0;0;225")
    assert "first-order formulas" in told("--method", "series")
    assert "by Weisbach's equations for α₁ and α₂" in told("--method", "weisbach")
    full = printed("delta", "--eps", "1", "--back", "0", "--lang", "en").out
    assert "Full pressure over the whole stroke" in full
    assert "Mariotte" not in full


@pytest.mark.parametrize(
    ("words", "lang", "said"),
    [
        (("--pump=double",), "de", "Pumpe doppeltwirkend (sonst --pump single)"),
        (("--pump=double",), "en", "Double-acting pump (else --pump single)"),
        (("--compression=6", "--heat=9"), "en", "Otto cycle (--cycle); four-stroke (else --two-stroke), 0°"),
        (("--pressure-ratio=3",), "de", "ohne schädlichen Raum (--clearance)"),
        (("--pressure-ratio=3",), "de", "doppeltwirkend (sonst --single-acting)"),
    ],
)  # fmt: skip
def test_an_option_that_names_another_choice_is_not_taken_for_what_was_given(
    words: tuple[str, ...], lang: str, said: str
) -> None:
    page = " ".join(printed("delta", *words, f"--lang={lang}").out.split())
    assert said in page
    assert not re.search("\\(--(single|two|pump)", page)
    # Handbooks leave it out.
    assert "--" not in unprompted(said)


# kurbel turning ----------------------------------------------------------------------------------


def test_turning_runs_through_the_turn_in_steps_of_ten_degrees() -> None:
    words = ("turning", "--eps", "4", "--ratio", "1:5")
    assert column("phi", *words) == [str(angle) for angle in range(0, 361, 10)]
    assert printed(*words[:3]).out == printed(*words).out
    assert printed(*words, "--step", "10").out == printed(*words).out
    assert column("phi", *words, "--step", "22.5")[:3] == ["0.0", "22.5", "45.0"]
    assert column("phi", *words, "--angle", "0;45..90:15;200") == ["0", "45", "60", "75", "90", "200"]


@each_steam
def test_turning_effort_is_the_force_and_its_integral(words: tuple[str, ...]) -> None:
    angles = ("17", "77.5", "163", "201", "302.25")
    asked = ("turning", "--eps", "3", "--ratio", "1:4", "--angle", ";".join(angles), *words)
    exact = solved(STEAMS[words]).exact
    for record, angle in zip(csv(*asked, "--digits", "9"), angles, strict=True):
        place = mp.mpf(angle) * mp.pi / 180
        assert Fraction(record["phi"]) == Fraction(angle)
        assert record["tangential"] == of(exact.force(place), 9)
        assert record["tangential_excess"] == of(exact.force(place) - exact.mean_force, 9)
        assert record["energy"] == of(exact.energy(place), 9)


def test_turning_begins_and_ends_its_turn_without_energy() -> None:
    first, *_, last = csv("turning", "--eps", "3", "--cranks", "0;90", "--digits", "20")
    for record in (first, last):
        assert record["energy"] == "0.00000000000000000000"
    assert first["tangential"] == last["tangential"]


def test_turning_tells_the_mean_force_of_every_engine() -> None:
    records = csv("turning", "--eps", "2;3", "--step", "90", "--digits", "7")
    assert len(records) == 2 * 5
    for record in records:
        exact = solved(Plant(Fraction(record["epsilon"]), FIFTH)).exact
        assert record["mean_force"] == of(exact.mean_force, 7)
    lines = printed("turning", "--eps", "3", "--step", "90", "--lang", "en").out.splitlines()
    force = of(solved(Plant(Fraction(3), FIFTH)).exact.mean_force, 4)
    assert sum(line.split()[2:3] == [force] for line in lines) == 5


def test_turning_effort_in_the_turn_before_is_that_of_this_turn() -> None:
    assert column("tangential", "turning", "--eps=4", "--angle=-340;20;740") == [
        column("tangential", "turning", "--eps=4", "--angle", "20")[0]
    ] * 3  # fmt: skip


# kurbel flywheel ---------------------------------------------------------------------------------


def five(value: Any) -> str:
    """Return the number to five figures, which is what flywheels are printed to, or whole if given so."""
    whole = mp.nint(value)
    if abs(value - whole) < mp.mpf(10) ** -30:
        return str(int(whole))
    before_point = int(mp.floor(mp.log10(value))) + 1
    return of(value, max(0, 5 - before_point))


def wheel(plant: Plant, power: Any, omega: Any, target: Any, radius: Any = 1) -> dict[str, Any]:
    """The flywheel by arithmetic of its own: ΔW = δ₀ P r, P r = N/ω, J = ΔW/(δ ω²)."""
    torque = power / omega
    swing = solved(plant).delta * torque
    inertia = swing / (target * omega**2)
    return {
        "power": power,
        "speed": omega * 30 / mp.pi,
        "omega": omega,
        "mean_torque": torque,
        "swing_share": solved(plant).delta,
        "swing": swing,
        "inertia": inertia,
        "mass": inertia / radius**2,
    }


def test_flywheel_keeps_each_irregularity_that_was_asked_for() -> None:
    words = ("flywheel", "--power", "50kW", "--speed", "120/min", "--eps", "3", "--ratio", "1:4")
    records = csv(*words, "--delta", "1:50;0,015", "--delta", "1/150", "--radius", "1,3m")
    assert [record["target"] for record in records] == ["0.02", "0.015", "0.006666666666667"]
    for record, target in zip(records, (mp.mpf(1) / 50, mp.mpf(3) / 200, mp.mpf(1) / 150), strict=True):
        expected = wheel(Plant(Fraction(3), QUARTER), mp.mpf(50_000), 4 * mp.pi, target, mp.mpf(13) / 10)
        assert (record["epsilon"], record["ratio"]) == ("3", "1:4")
        for key, value in expected.items():
            shown = of(value, 4) if key == "swing_share" else five(value)
            assert record[key] == shown, key
        # J δ ω² is the swing, and the swing is the coefficient of δ times the mean torque.
        inertia, swing = mp.mpf(record["inertia"]), mp.mpf(record["swing"])
        assert abs(inertia * target * (4 * mp.pi) ** 2 / swing - 1) < mp.mpf("1e-4")
        assert abs(mp.mpf(record["swing_share"]) * 50_000 / (4 * mp.pi) / swing - 1) < mp.mpf("1e-4")


@pytest.mark.parametrize(
    ("text", "number", "head"),
    [
        ("1:100", "0.01", "1:100"),
        ("0,01", "0.01", "1:100"),
        ("1%", "0.01", "1:100"),
        ("1/100", "0.01", "1:100"),
        ("1:62.5", "0.016", "1:62.5"),
        ("1.6%", "0.016", "1:62.5"),
        ("0.015", "0.015", "0.015"),
        ("1e-9", "0.000000001", "1:1000000000"),
    ],
)
def test_irregularity_is_read_as_ratio_decimal_or_percent(text: str, number: str, head: str) -> None:
    words = ("flywheel", "--eps", "4", *TASK[:4], "--delta", text)
    (record,) = csv(*words)
    assert record["target"] == number
    assert head in printed(*words, "--decimal", "point").out.split()
    target = json.loads(printed(*words, "-f", "json").out, parse_float=str)["rows"][0]["target"]
    assert Fraction(target) == Fraction(number)


def test_a_list_of_irregularities_may_have_decimal_commas() -> None:
    words = ("flywheel", "--eps", "4", *TASK[:4], "--delta", "0,02;1%;1:50;1/150")
    assert column("target", *words) == ["0.02", "0.01", "0.006666666666667"]


@pytest.mark.parametrize(
    ("words", "power", "speed", "omega"),
    [
        (("--power", "50kW", "--speed", "120/min"), "50000", "120", of(4 * mp.pi, 3)),
        (("--power", "1234567.5W", "--speed", "12.5rad/s"), "1234568", of(mp.mpf(375) / mp.pi, 2), "12.5"),
        (("--power", "2.5W", "--speed", "1/s"), "2.5", "60", of(2 * mp.pi, 4)),
    ],
)
def test_given_values_are_printed_as_they_were_given(
    words: tuple[str, ...], power: str, speed: str, omega: str
) -> None:
    (record,) = csv("flywheel", *words, "--delta", "1:100", "--eps", "4")
    assert (record["power"], record["speed"], record["omega"]) == (power, speed, omega)


def test_speed_in_radians_is_the_angular_velocity_itself() -> None:
    words = (
        "flywheel",
        "--power",
        "68PS",
        "--delta",
        "1:80",
        "--eps",
        "3",
        "--ratio",
        "1:4",
        "--digits",
        "15",
    )
    (record,) = csv(*words, "--speed", "12.5rad/s")
    # A Pferdestärke lifts 75 kg by a metre a second.
    watts = 68 * 75 * mp.mpf("9.80665")
    expected = wheel(Plant(Fraction(3), QUARTER), watts, mp.mpf("12.5"), mp.mpf(1) / 80)
    for key in ("power", "speed", "omega", "mean_torque", "swing", "inertia"):
        assert record[key] == of(expected[key], 15), key
    assert "mass" not in record


def test_flywheel_of_more_cranks_is_lighter_by_the_ratio_of_their_swings() -> None:
    words = ("flywheel", *TASK, "--eps", "3", "--ratio", "1:4", "--digits", "10")
    (one,) = csv(*words, "--radius", "2m")
    (two,) = csv(*words, "--radius", "2m", "--cranks", "0;90")
    plants = [Plant(Fraction(3), QUARTER), Plant(Fraction(3), QUARTER, cranks=(Fraction(0), Fraction(90)))]
    for record, plant in zip((one, two), plants, strict=True):
        expected = wheel(plant, mp.mpf(50_000), 4 * mp.pi, mp.mpf(1) / 100, 2)
        assert {key: record[key] for key in expected} == {key: of(expected[key], 10) for key in expected}


def test_flywheels_of_several_engines_are_told_apart() -> None:
    words = ("flywheel", *TASK, "--eps", "2;4", "--ratio", "1:4;1:5", "--columns", "epsilon,ratio,inertia")
    records = csv(*words)
    assert [(record["epsilon"], record["ratio"]) for record in records] == [
        (eps, ratio) for eps in ("2", "4") for ratio in ("1:4", "1:5")
    ]
    assert len({record["inertia"] for record in records}) == 4


def test_every_quantity_of_an_engine_is_listed_with_its_command() -> None:
    # The linkages have forces of the same keys, a flywheel's speed, each cylinder, the power, flywheels and
    # diagrams without an engine, unknowns, rotors and locomotives those of their tasks.
    listed = printed("quantities").out.splitlines()
    others = (
        "--mechanism",
        "--flywheel",
        "--layout cylinders",
        "--layout flywheel-sizing",
        "--torque",
        "--areas",
        "--unknown",
        " locomotive",
        " rotor",
        " power",
        "solve --unknown",
    )
    lines = [line.split() for line in listed if not any(other in line for other in others)]
    commands = {words[0]: next(word for word in words[1:] if word in COMMANDS) for words in lines}
    scopes = {"angle": "turning", "crank": "forces", "flywheel": "flywheel"}
    for key, quantity in engine_registry().items():
        assert commands[key] == scopes.get(quantity.of, "delta")


# Environment -------------------------------------------------------------------------------------


def test_the_environment_sets_defaults_and_options_override_them() -> None:
    words = ("delta", "-f", "csv")
    environment = {"KURBEL_DELTA_EPS": "3", "KURBEL_DELTA_RATIO": "1:4", "KURBEL_DELTA_DIGITS": "6"}
    (record,) = printed(*words, **environment).records()
    assert record == {
        "epsilon": "3", "ratio": "1:4", "delta": of(solved(Plant(Fraction(3), QUARTER)).delta, 6),
    }  # fmt: skip
    (record,) = printed(*words, "--eps", "2", **environment).records()
    assert record["epsilon"] == "2"
    assert printed("delta", KURBEL_LANG="en").out == printed("delta", "--lang", "en").out
    turning = ("turning", "--eps", "4")
    assert printed(*turning, KURBEL_DECIMAL="point").out == printed(*turning, "--decimal", "point").out
    assert printed("delta", KURBEL_FORMAT="csv").out == printed("delta", "-f", "csv").out
    detail = ("delta", "--eps", "4")
    assert printed(*detail, KURBEL_DELTA_DETAIL="1").out == printed(*detail, "--detail").out
    methods = printed("delta", KURBEL_DELTA_METHOD="exact series").out
    assert methods == printed("delta", "--method", "exact", "--method", "series").out
    # What is set for one command is nothing to another.
    assert printed("harmonics", KURBEL_DELTA_RATIO="1:3").out == printed("harmonics").out
    power = printed("flywheel", "--eps", "4", *TASK[2:], KURBEL_FLYWHEEL_POWER="50kW").out
    assert power == printed("flywheel", "--eps", "4", *TASK).out


def test_what_the_environment_says_of_the_steam_gives_way_to_what_is_typed() -> None:
    card = str(CARDS / "ideal-2.csv")
    ideal = {"KURBEL_DELTA_EPS": "3", "KURBEL_DELTA_BACK": "0.1", "KURBEL_DELTA_EXPONENT": "1.2",
             "KURBEL_DELTA_CLEARANCE": "5%"}  # fmt: skip
    words = ("delta", "--card", card)
    assert printed(*words, **ideal).out == printed(*words).out
    # A card of the environment gives way with the page that it would choose.
    words = ("delta", "--eps", "4")
    assert printed(*words, KURBEL_DELTA_CARD=card).out == printed(*words).out
    assert printed("delta", KURBEL_DELTA_CARD=card).out == printed("delta", "--card", card).out
    # Neither of two of the environment, nor of two that are typed.
    said = "describes an ideal card, and --card gives a measured one; leave one out"
    assert refusal("delta", KURBEL_DELTA_CARD=card, KURBEL_DELTA_EPS="3") == f"--eps {said}"
    assert refusal("delta", "--card", card, "--back", "0.1", KURBEL_DELTA_EPS="3") == f"--back {said}"


# At random ---------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=12, derandomize=True)
@given(
    expansion=st.integers(100, 1200),
    ratio=st.integers(0, 60),
    back=st.one_of(st.none(), st.integers(0, 20)),
    exponent=st.integers(70, 150),
    clearance=st.integers(0, 15),
    double=st.booleans(),
    decimals=st.integers(0, 20),
)
def test_every_digit_of_a_random_engine_is_that_of_the_quadrature(
    expansion: int, ratio: int, back: int | None, exponent: int, clearance: int, double: bool, decimals: int
) -> None:
    eps = Fraction(expansion + (back is None), 100)
    plant = Plant(
        eps,
        Fraction(ratio, 100),
        None if back is None else Fraction(back, 100),
        Fraction(exponent, 100),
        Fraction(clearance, 100),
        double,
    )
    words = ["--eps", f"{float(eps):.2f}", "--ratio", f"0.{ratio:02}", "--exponent", f"{exponent / 100:.2f}"]
    words += ["--clearance", f"{clearance}%", "--columns", "delta,mean_force", "--digits", str(decimals)]
    words += [] if back is None else ["--back", f"{back}%"]
    words += [] if double else ["--single-acting"]
    (record,) = csv("delta", *words)
    with mp.workprec(BITS):
        turn = solved(plant)
        assert record == {
            "delta": of(turn.delta, decimals),
            "mean_force": of(turn.exact.mean_force, decimals),
        }
