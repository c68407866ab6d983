"""`kurbel delta`, `turning` and `flywheel`: what is asked for is what is printed, and its digits are true.

True digits come from `kurbel.verify`, and from § 150 of Weisbach-Herrmann.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import column, printed, records, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from machines import machine
from mpmath import mp
from places import CARDS
from verified import verified, words

from kurbel import verify
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.verify import Value
from kurbel.verify.numbers import number

BITS = 160
OUT, RETURN, TURN = "outstroke", "return", "turn"
# Of most tests.
ENGINE = {"eps": "3", "ratio": "1:4"}
TASK = ("--power", "50kW", "--speed", "120/min", "--delta", "1:100")


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with mp.workprec(BITS):
        yield


solved = cache(verified)


# His upper sign, the return stroke, has s = 1 - cos α - ½ λ sin² α.
SIGNS = {RETURN: 1, OUT: -1}


def angles_by_weisbach(expansion: int, upper: int) -> tuple[Any, Any]:
    """α₁ and α₂ of § 150 for the best back pressure."""
    eps, lam = mp.mpf(expansion), mp.mpf(1) / 5

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


def by_weisbach(expansion: int) -> Any:
    """δ of § 150 for the best back pressure, from his v_min and v_max of both strokes."""
    eps, lam = mp.mpf(expansion), mp.mpf(1) / 5
    done = 2 / mp.pi * mp.log(eps)
    lows, highs = [], []
    for upper in SIGNS.values():
        low, high = angles_by_weisbach(expansion, upper)
        first, second = (1 - mp.cos(one) - upper * lam / 2 * mp.sin(one) ** 2 for one in (low, high))
        lows.append((eps - 1) * first - done * low)
        highs.append(2 - second + 2 * mp.log(second * eps / 2) - done * high)
    return (max(highs) - min(lows)) / done


def of(value: Any, decimals: int) -> str:
    """Return the true digits."""
    if not isinstance(value, Value):
        fraction = Fraction(mp.nstr(value, 45))
        value = Value(lambda: number(fraction))
    found: str = value.digits(decimals)
    return found


def minutes(degrees: Any) -> str:
    """Return degrees and minutes as pages print them."""
    whole = int(of(degrees * 60, 0))
    return f"{whole // 60}°{whole % 60}′"


# kurbel delta ------------------------------------------------------------------------------------


def turned(eps: object, ratio: str = "1:5") -> str:
    """Return δ to three places by quadrature."""
    return f"{machine(eps=str(eps), ratio=ratio).turn.delta:.3f}"


def test_delta_of_the_book_has_its_true_digits() -> None:
    rows = records("delta", "--eps", "2..6")
    assert [record["epsilon"] for record in rows] == ["2", "3", "4", "5", "6"]
    assert {record["ratio"] for record in rows} == {"1:5"}
    found = [record["delta"] for record in rows]
    assert found == ["1.282", "1.374", "1.423", "1.454", "1.478"]
    assert found == [turned(eps) for eps in range(2, 7)]
    assert printed("delta").out == printed("delta", "--eps", "2..6", "--ratio", "1:5").out


def test_delta_by_weisbach_is_that_of_his_own_equations() -> None:
    found = column("delta", "delta", "--eps", "2..6", "--method", "weisbach", "--digits", "25")
    assert found == [of(by_weisbach(eps), 25) for eps in range(2, 7)]
    # He prints 1,305, 1,374, 1,421, 1,453, 1,477; the first two are slips of his.
    assert [f"{float(one):.3f}" for one in found] == ["1.281", "1.373", "1.421", "1.453", "1.477"]


@pytest.mark.parametrize(
    ("words", "expansions"),
    [
        (("--eps", "2,5..3,5"), ["2.5", "3.5"]),
        (("--eps", "1.5;2..4;2"), ["1.5", "2.0", "3.0", "4.0"]),
        (("--eps", "5", "--eps", "2"), ["5", "2"]),
        (("--eps", "2e1"), ["20"]),
    ],
)
def test_expansions_are_read_as_lists_and_ranges(words: tuple[str, ...], expansions: list[str]) -> None:
    rows = records("delta", *words)
    assert [record["epsilon"] for record in rows] == expansions


def test_several_ratios_are_printed_side_by_side() -> None:
    words = ("delta", "--eps", "2;3", "--ratio", "1:4;1:∞")
    assert printed(*words).out == printed(*words, "--layout", "delta-tafel").out
    rows = records(*words)
    assert [(record["epsilon"], record["ratio"]) for record in rows] == [
        ("2", "1:4"), ("2", "1:∞"), ("3", "1:4"), ("3", "1:∞"),
    ]  # fmt: skip
    for record in rows:
        assert record["delta"] == turned(record["epsilon"], record["ratio"])
    first, second = (record["delta"].replace(".", ",") for record in rows[2:])
    lines = [line.split() for line in printed(*words).out.splitlines()]
    assert lines.count(["3", first, second]) == 1


STEAMS: list[tuple[tuple[str, ...], dict[str, Any]]] = [
    ((), {}),
    (("--back", "0,2"), {"back": "0.2"}),
    (("--back", "0"), {"back": "0"}),
    (("--exponent", "1,13"), {"exponent": "1.13"}),
    (("--clearance", "5%"), {"clearance": "0.05"}),
    (
        ("--exponent", "1.13", "--clearance", "0.05", "--back", "0.1"),
        {"exponent": "1.13", "clearance": "0.05", "back": "0.1"},
    ),
    (("--single-acting",), {"single_acting": True}),
    (("--cranks", "0;90"), {"cranks": "0;90"}),
    (("--cranks", "0;90;225", "--back", "0.1"), {"cranks": "0;90;225", "back": "0.1"}),
    (
        ("--cranks", "0..240:120", "--single-acting", "--back", "0.1"),
        {"cranks": "0;120;240", "single_acting": True, "back": "0.1"},
    ),
    (("--method", "series"), {"method": "series"}),
    (("--method", "series", "--cranks", "0°0';67°30'"), {"method": "series", "cranks": "0;67.5"}),
]


@pytest.mark.parametrize(("words", "options"), STEAMS, ids=str)
def test_the_engine_that_was_described_is_the_engine_that_is_computed(
    words: tuple[str, ...], options: dict[str, Any]
) -> None:
    engine = ("--eps", "3", "--ratio", "1:4", *words)
    (record,) = records("delta", *engine, "--columns", "delta,mean_force,back", "--digits", "12")
    plant = machine(eps="3", ratio="1:4", **options)
    assert float(record["delta"]) == pytest.approx(plant.turn.delta, abs=2e-11)
    assert float(record["mean_force"]) == pytest.approx(plant.turn.mean, abs=1e-11)
    assert "back" not in options or float(record["back"]) == float(options["back"])
    angles = (17, 77.5, 163, 201, 302.25)
    rows = records("turning", *engine, f"--angle={';'.join(map(str, angles))}", "--digits", "11")
    for row, angle in zip(rows, angles, strict=True):
        force = float(plant.force(np.array([angle]))[0])
        assert float(row["phi"]) == angle
        assert float(row["tangential"]) == pytest.approx(force, abs=1e-10)
        assert float(row["tangential_excess"]) == pytest.approx(force - plant.turn.mean, abs=1e-10)
        assert float(row["energy"]) == pytest.approx(
            float(plant.turn.at(plant.turn.energy, np.array([angle]))[0]), abs=2e-10
        )
    first, *_, last = records("turning", *engine, "--step=90")
    assert {first["energy"], last["energy"]} == {"0.0000"}
    assert first["tangential"] == last["tangential"]


def test_full_pressure_and_infinite_rod_have_the_closed_form() -> None:
    # W/(Q r) = 1 - cos φ - (2/π) φ with extremes at sin φ = 2/π, whatever the back pressure takes away.
    alpha = mp.asin(2 / mp.pi)
    swing = 2 * mp.cos(alpha) - 2 / mp.pi * (mp.pi - 2 * alpha)
    words = ("delta", "--eps", "1", "--ratio", "1:inf", "--digits", "20")
    for back in ("0", "0.5"):
        assert column("delta", *words, "--back", back) == [of(swing * mp.pi / 2, 20)]


def test_two_cranks_at_one_angle_do_twice_the_work_as_unevenly() -> None:
    words = ("--eps", "3", "--ratio", "1:4", "--digits", "20")
    turn = solved(**ENGINE)
    for cranks, count in (("0", 1), ("0;0", 2), ("0;360;-360", 3)):
        asked = ("delta", *words, "--cranks", cranks, "--columns", "delta,mean_force,v_min,v_max")
        (record,) = records(*asked)
        assert record == {
            "delta": of(turn.value("delta"), 20),
            **{key: of(turn.value(key) * count, 20) for key in ("mean_force", "v_min", "v_max")},
        }
        (at_40,) = records("turning", *words, "--cranks", cranks, "--angle", "40")
        for key in ("tangential", "energy"):
            assert at_40[key] == of(turn.value(key, 40) * count, 20)


def test_two_cranks_of_a_card_at_one_angle_do_twice_the_work_as_unevenly() -> None:
    words = ("delta", "--card", str(CARDS / "ideal-2.csv"), "--columns", "delta,mean_force", "--digits", "7")
    one, two = records(*words)[-1], records(*words, "--cranks", "0;0")[-1]
    turn = solved(eps="2")
    assert one["delta"] == two["delta"] == of(turn.value("delta"), 7)
    assert [one["mean_force"], two["mean_force"]] == [of(turn.value("mean_force") * n, 7) for n in (1, 2)]


def test_cranks_of_a_card_follow_the_first_too() -> None:
    words = ("--cranks", "0;90;225", "--angle", "30;100;200;310", "--columns", "tangential,energy")
    keys = ("tangential", "energy")
    measured = records("turning", "--card", str(CARDS / "ideal-2.csv"), *words, "--digits", "6")
    for record, ideal in zip(
        measured, records("turning", "--eps", "2", *words, "--digits", "6"), strict=True
    ):
        assert [record[key] for key in keys] == [ideal[key] for key in keys]


# kurbel delta --detail ---------------------------------------------------------------------------


def cut_offs(turn: verify.Turn, decimals: int) -> list[str]:
    return [of(turn.value("alpha_cutoff", stroke=stroke), decimals) for stroke in (OUT, RETURN)]


def test_detail_has_every_stroke_and_the_whole_turn() -> None:
    words = ("delta", "--detail", "--eps", "3", "--ratio", "1:4", "--back", "0.1", "--digits", "8")
    rows = records(*words)
    turn = solved(**ENGINE, back="0.1")
    assert [record["stroke"] for record in rows] == [OUT, RETURN, TURN]
    for record in rows:
        for key in ("alpha_min", "v_min", "alpha_max", "v_max"):
            assert record[key] == of(turn.value(key, stroke=record["stroke"]), 8)
    assert [record["alpha_cutoff"] for record in rows] == [*cut_offs(turn, 8), ""]
    assert [record["mean_force"] for record in rows] == ["", "", of(turn.value("mean_force"), 8)]
    assert [record["delta"] for record in rows] == ["", "", of(turn.value("delta"), 8)]
    assert printed(*words).out == printed(*words, "--layout", "delta-detail").out


@pytest.mark.parametrize("expansion", [2, 5])
def test_detail_prints_the_angles_of_his_equations_to_the_minute(expansion: int) -> None:
    words = ("delta", "--detail", "--eps", str(expansion), "--method", "weisbach", "--lang", "en")
    rows = [line.split()[-3:] for line in printed(*words).out.splitlines() if "speed at" in line]
    roots = {span: angles_by_weisbach(expansion, upper) for span, upper in SIGNS.items()}
    for place, row in enumerate(rows):
        out, back = (roots[span][place] * 180 / mp.pi for span in (OUT, RETURN))
        # The least speed of the turn is that of the return stroke, the greatest that of the outstroke.
        turn = (back + 180, out)[place]
        assert row == [minutes(out), minutes(back), minutes(turn)]


def test_detail_of_several_cranks_has_the_turn_alone() -> None:
    words = ("delta", "--detail", "--eps", "3", "--ratio", "1:4", "--cranks", "0;90", "--digits", "6")
    (record,) = records(*words)
    turn = solved(**ENGINE, cranks="0;90")
    assert record == {
        "epsilon": "3",
        "ratio": "1:4",
        "stroke": TURN,
        **{key: of(turn.value(key), 6) for key in ("mean_force", "alpha_min", "v_min", "alpha_max", "v_max")},
        "delta": of(turn.value("delta"), 6),
    }
    page = printed(*words).out
    assert "Hingang" not in page
    assert "ᵃ⁾" not in page
    assert "Kurbeln um 90° hinter der ersten, Zylinder gleich" in " ".join(page.split())


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
    rows = records(*words, "--digits", "9")
    assert tuple(rows[0]) == ("epsilon", "ratio", *METHODS[methods])
    for record in rows:
        true = {
            **{method: exact(solved(eps=record["epsilon"], method=method)) for method in ("exact", "series")},
            "weisbach": by_weisbach(int(record["epsilon"])),
        }
        for key in METHODS[methods]:
            kind, method = key.split("_")
            value = true[method] if kind == "delta" else true["exact"] - true[method]
            assert record[key] == of(value, 9)


def test_the_layout_of_methods_shows_those_asked_for() -> None:
    words = ("delta", "--eps", "3", "--layout", "delta-verfahren")
    assert tuple(records(*words)[0]) == ("epsilon", "ratio", *METHODS["exact", "series", "weisbach"])
    assert tuple(records(*words, "--method", "series")[0]) == ("epsilon", "ratio", "delta_series")
    with_series = records(*words, "--columns", "difference_series,epsilon")
    assert [tuple(record) for record in with_series] == [("difference_series", "epsilon")]


# Indicator cards ---------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["exact", "series"])
def test_the_ideal_card_makes_the_page_of_its_expansion(method: str) -> None:
    words = ("delta", "--detail", "--ratio", "1:4", "--method", method)
    measured, ideal = records(*words, "--card", str(CARDS / "ideal-2.csv")), records(*words, "--eps", "2")
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
    rows = records(*words)
    assert [(Path(record["card"]).name, record["ratio"]) for record in rows] == [
        ("ideal-2.csv", "1:4"), ("ideal-2.csv", "1:5"), ("condenser.csv", "1:4"), ("condenser.csv", "1:5"),
    ]  # fmt: skip
    assert [record["delta"] for record in rows[:2]] == [turned(2, ratio) for ratio in ("1:4", "1:5")]


# Columns, digits, languages, formats -------------------------------------------------------------


def test_the_column_of_the_cut_off_chooses_the_page_of_strokes() -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4", "--columns", "delta,alpha_cutoff")
    assert printed(*words).out == printed(*words, "--detail").out
    assert column("alpha_cutoff", *words) == [*cut_offs(solved(**ENGINE), 3), ""]


def test_columns_are_picked_and_ordered() -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4")
    (record,) = records(*words, "--columns", "v_max, delta", "--columns", "epsilon;alpha_min")
    turn = solved(**ENGINE)
    assert list(record.items()) == [
        ("v_max", of(turn.value("v_max"), 4)),
        ("delta", of(turn.value("delta"), 3)),
        ("epsilon", "3"),
        ("alpha_min", of(turn.value("alpha_min"), 3)),
    ]
    page = printed(*words, "--columns", "mean_force,delta", "--lang", "en").out
    assert page.index("Mean tangential force P") < page.index("Degree of irregularity δ")


@pytest.mark.parametrize("decimals", [0, 30])
def test_digits_go_for_every_column(decimals: int) -> None:
    words = ("delta", "--eps", "3", "--ratio", "1:4", "--digits", str(decimals))
    (record,) = records(*words, "--columns", "delta,mean_force,v_min,alpha_max")
    turn = solved(**ENGINE)
    assert record == {key: of(turn.value(key), decimals) for key in record}
    assert record["delta"].replace(".", ",") in printed(*words).out


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
@pytest.mark.parametrize("name", ["delta", "flywheel"])
def test_every_format_has_the_digits_and_a_file_is_what_is_printed(
    name: str, form: str, tmp_path: Path
) -> None:
    words = (name, *(TASK if name == "flywheel" else ()), "--eps", "4", "--lang", "en")
    text = printed(*words, "-f", form).out
    assert {"delta": "1.423", "turning": "0.5902", "flywheel": "3584.3"}[name] in text
    path = tmp_path / f"anhang{FORMATS[form].suffixes[0]}"
    assert printed(*words, "-o", str(path)).out == ""
    assert path.read_text(encoding="utf-8") == text
    if "standalone" in FORMATS[form].takes:
        assert printed(*words, "-f", form, "--standalone").out.count(text.splitlines()[-1]) == 1


def test_json_has_the_rows_of_csv_and_null_where_there_is_no_value() -> None:
    words = ("delta", "--detail", "--eps", "2;3")
    rows = json.loads(printed(*words, "-f", "json").out, parse_float=str, parse_int=str)["rows"]
    assert [{key: value or "" for key, value in row.items()} for row in rows] == records(*words)
    assert rows[0]["delta"] is None
    head = json.loads(printed(*words, "-f", "json", "--lang", "en").out)
    delta = next(one for one in head["columns"] if one["key"] == "delta")
    assert (delta["name"], delta["symbol"], delta["unit"], delta["decimals"], delta["method"]) == (
        "Degree of irregularity", "δ", "P r/(m₁ v₁²)", 3, "exact",
    )  # fmt: skip


# kurbel turning ----------------------------------------------------------------------------------


def test_turning_runs_through_the_turn_in_steps_of_ten_degrees() -> None:
    words = ("turning", "--eps", "4", "--ratio", "1:5")
    assert column("phi", *words) == [str(angle) for angle in range(0, 361, 10)]
    assert printed(*words[:3]).out == printed(*words).out
    assert printed(*words, "--step", "10").out == printed(*words).out
    assert column("phi", *words, "--step", "22.5")[:3] == ["0.0", "22.5", "45.0"]
    assert column("phi", *words, "--angle", "0;45..90:15;200") == ["0", "45", "60", "75", "90", "200"]


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


def exact(turn: verify.Turn) -> Any:
    """δ as mpmath has it."""
    found = turn.value("delta").near()
    return mp.mpf(found.numerator) / found.denominator


def wheel(turn: verify.Turn, power: Any, omega: Any, target: Any, radius: Any = 1) -> dict[str, Any]:
    """The flywheel by arithmetic of its own: ΔW = δ₀ P r, P r = N/ω, J = ΔW/(δ ω²)."""
    torque = power / omega
    swing = exact(turn) * torque
    inertia = swing / (target * omega**2)
    return {
        "power": power,
        "speed": omega * 30 / mp.pi,
        "omega": omega,
        "mean_torque": torque,
        "swing_share": exact(turn),
        "swing": swing,
        "inertia": inertia,
        "mass": inertia / radius**2,
    }


def test_flywheel_keeps_each_irregularity_that_was_asked_for() -> None:
    words = ("flywheel", "--power", "50kW", "--speed", "120/min", "--eps", "3", "--ratio", "1:4")
    rows = records(*words, "--delta", "1:50;0,015", "--delta", "1/150", "--radius", "1,3m")
    assert [record["target"] for record in rows] == ["0.02", "0.015", "0.006666666666667"]
    for record, target in zip(rows, (mp.mpf(1) / 50, mp.mpf(3) / 200, mp.mpf(1) / 150), strict=True):
        expected = wheel(solved(**ENGINE), mp.mpf(50_000), 4 * mp.pi, target, mp.mpf(13) / 10)
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
        ("1%", "0.01", "1:100"),
        ("1:62.5", "0.016", "1:62.5"),
        ("0.015", "0.015", "0.015"),
        ("1e-9", "0.000000001", "1:1000000000"),
    ],
)
def test_irregularity_is_read_as_ratio_decimal_or_percent(text: str, number: str, head: str) -> None:
    words = ("flywheel", "--eps", "4", *TASK[:4], "--delta", text)
    (record,) = records(*words)
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
    (record,) = records("flywheel", *words, "--delta", "1:100", "--eps", "4")
    assert (record["power"], record["speed"], record["omega"]) == (power, speed, omega)


def test_speed_in_radians_is_the_angular_velocity_itself() -> None:
    words = ("flywheel", "--power=68PS", "--delta=1:80", "--eps=3", "--ratio=1:4", "--digits=15")
    (record,) = records(*words, "--speed", "12.5rad/s")
    # A Pferdestärke lifts 75 kg by a metre a second.
    watts = 68 * 75 * mp.mpf("9.80665")
    expected = wheel(solved(**ENGINE), watts, mp.mpf("12.5"), mp.mpf(1) / 80)
    for key in ("power", "speed", "omega", "mean_torque", "swing", "inertia"):
        assert record[key] == of(expected[key], 15), key
    assert "mass" not in record


def test_flywheel_of_more_cranks_is_lighter_by_the_ratio_of_their_swings() -> None:
    words = ("flywheel", *TASK, "--eps", "3", "--ratio", "1:4", "--digits", "10")
    (one,) = records(*words, "--radius", "2m")
    (two,) = records(*words, "--radius", "2m", "--cranks", "0;90")
    for record, cranks in ((one, "0"), (two, "0;90")):
        expected = wheel(solved(**ENGINE, cranks=cranks), mp.mpf(50_000), 4 * mp.pi, mp.mpf(1) / 100, 2)
        assert {key: record[key] for key in expected} == {key: of(expected[key], 10) for key in expected}


def test_every_column_of_an_engine_is_listed() -> None:
    listed = {line.split()[0] for line in printed("quantities").out.splitlines() if line.strip()}
    for command in ("delta", "turning", "flywheel"):
        sentence = refusal(command, "--eps=4", *(TASK if command == "flywheel" else ()), "--columns=no-such")
        names = {*sentence.partition("; choose from ")[2].split(", ")}
        assert names - {"epsilon", "ratio", "phi", "target"} <= listed


# Environment -------------------------------------------------------------------------------------


def test_the_environment_sets_defaults_and_options_override_them() -> None:
    words = ("delta", "-f", "csv")
    environment = {"KURBEL_DELTA_EPS": "3", "KURBEL_DELTA_RATIO": "1:4", "KURBEL_DELTA_DIGITS": "6"}
    (record,) = printed(*words, **environment).records()
    assert record == {
        "epsilon": "3", "ratio": "1:4", "delta": of(solved(**ENGINE).value("delta"), 6),
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
    assert refusal("delta", KURBEL_DELTA_CARD=card, KURBEL_DELTA_EPS="3") == f"KURBEL_DELTA_EPS: --eps {said}"
    assert refusal("delta", "--card", card, "--back", "0.1", KURBEL_DELTA_EPS="3") == f"--back {said}"


# At random ---------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=3, derandomize=True)
@given(
    expansion=st.integers(100, 1200),
    ratio=st.integers(0, 60),
    back=st.one_of(st.none(), st.integers(0, 20)),
    exponent=st.integers(70, 150),
    clearance=st.integers(0, 15),
    double=st.booleans(),
    decimals=st.integers(0, 20),
)
def test_every_digit_of_a_random_engine_is_true(
    expansion: int, ratio: int, back: int | None, exponent: int, clearance: int, double: bool, decimals: int
) -> None:
    eps = Fraction(expansion + (back is None), 100)
    options = {
        "eps": f"{float(eps):.2f}", "ratio": f"0.{ratio:02}", "exponent": f"{exponent / 100:.2f}",
        "clearance": f"{clearance}%", "single_acting": not double,
    } | ({} if back is None else {"back": f"{back}%"})  # fmt: skip
    asked = ["--columns", "delta,mean_force", "--digits", str(decimals)]
    (record,) = records("delta", *words(options), *asked)
    turn = verified(**options)
    assert record == {key: of(turn.value(key), decimals) for key in ("delta", "mean_force")}
