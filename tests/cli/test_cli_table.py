"""`kurbel table` and the lists: what is asked for is what is printed."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction

import pytest
from cli import kurbel, printed
from hypothesis import given, settings
from hypothesis import strategies as st
from textbook import Drive, evaluate, rounded
from textbook import printed as digits

from kurbel.balance import harmonics
from kurbel.balance.angles.extremes import PLACE
from kurbel.balance.angles.page import quantities as angle_quantities
from kurbel.balance.firing_page import cylinders_registry, orders_registry
from kurbel.balance.locomotives.quantities import quantities as locomotive_quantities
from kurbel.balance.page import balance_registry
from kurbel.balance.rotors.page import quantities as rotor_quantities
from kurbel.engine.harmonics.quantities import registry as torques
from kurbel.engine.quantities import engine_registry
from kurbel.linkage import dead_centres
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.beam import engine as beam
from kurbel.linkage.beam.quantities import beam_registry
from kurbel.linkage.coupled import coupled_registry
from kurbel.linkage.parallel import parallel_registry
from kurbel.motion.inertia import inertia_registry
from kurbel.motion.inertia_page import error_columns
from kurbel.motion.points.quantities import points_registry
from kurbel.motion.quantities import registry
from kurbel.page.layouts import layout_names
from kurbel.page.subject import subject
from kurbel.solve.page import own_columns

NINTHS = Fraction(2, 9)


def csv(*words: str, **environment: str) -> list[dict[str, str]]:
    return printed("table", "-f", "csv", *words, **environment).records()


def column(key: str, *words: str) -> list[str]:
    return [record[key] for record in csv(*words)]


def textbook(key: str, drive: Drive, angle: Fraction, decimals: int, method: str = "exact") -> str:
    scaled = rounded(evaluate(key, method, drive, angle), decimals)
    assert scaled is not None
    return digits(scaled, decimals)


def test_the_default_is_the_crank_of_one_to_five_every_ten_degrees() -> None:
    assert printed("table").out == printed("table", "--ratio", "1:5", "--angle", "0..180:10").out


def test_ratios_are_repeated_listed_and_run_through_in_the_order_typed() -> None:
    words = ("--ratio", "1:4,5;1:3", "-r", "1:5..6:0,5", "--angle", "60", "--digits", "6")
    records = csv(*words)
    assert [record["ratio"] for record in records] == ["1:4.5", "1:3", "1:5", "1:5.5", "1:6"]
    rods = [Fraction(9, 2), Fraction(3), Fraction(5), Fraction(11, 2), Fraction(6)]
    assert [record["x"] for record in records] == [
        textbook("x", Drive(1 / rod), Fraction(60), 6) for rod in rods
    ]


@pytest.mark.parametrize("ratio", ["0", "1:∞", "1:inf"])
def test_the_infinite_rod_gives_the_pure_sine(ratio: str) -> None:
    (record,) = csv("--ratio", ratio, "--angle", "30", "--digits", "5")
    assert record["ratio"] == "1:∞"
    # 1 - √3/2, 1/2 and √3/2.
    assert [record[key] for key in ("x", "x_return", "c", "p")] == [
        "0.13397",
        "0.13397",
        "0.50000",
        "0.86603",
    ]


@pytest.mark.parametrize(
    ("words", "angles"),
    [
        (("--step", "90"), ["0", "90", "180"]),
        (("--step", "90", "--to", "360"), ["0", "90", "180", "270", "360"]),
        (("--from", "350"), ["350", "360"]),
        (("--to", "5"), ["0", "5"]),
        (("--from", "20", "--to", "40"), ["20", "30", "40"]),
        (("--from", "7", "--to", "7"), ["7"]),
        (("--from", "-30", "--to", "30", "--step", "22,5"), ["-30.0", "-7.5", "15.0"]),
        (("--angle", "0;45;90"), ["0", "45", "90"]),
        (("--angle", "80..90:5", "--angle", "11.25"), ["80.00", "85.00", "90.00", "11.25"]),
        (("--angle", "2°30'", "--angle", "7°45'"), ["2.50", "7.75"]),
        (("--step", "30'", "--to", "1"), ["0.0", "0.5", "1.0"]),
        (("--step", "1°30'", "--from", "1°30'", "--to", "4°30'"), ["1.5", "3.0", "4.5"]),
    ],
)
def test_angles_are_listed_and_run_through(words: tuple[str, ...], angles: list[str]) -> None:
    assert column("phi", *words) == angles


def test_angles_that_are_no_decimals_are_printed_in_degrees_and_minutes() -> None:
    page = printed("table", "--angle", "0°20';0°40'").out
    assert "0°20′" in page
    assert "0°40′" in page


def test_columns_are_picked_and_ordered() -> None:
    out = printed("table", "-f", "csv", "--columns", "c, phi;psi", "--angle", "90", "--ratio", "1:2").out
    assert out == "c,phi,psi\n1.0000,90,30.000\n"


def test_a_column_named_twice_is_printed_once() -> None:
    assert list(csv("--columns", "x,phi,x")[0]) == ["x", "phi"]


def test_columns_of_a_page_are_those_of_its_records() -> None:
    page = printed("table", "--columns", "phi,psi", "--angle", "90", "--ratio", "1:2", "--lang", "en").out
    assert "30.000" in page
    assert "velocity" not in page.split("\n", 2)[2]


def test_digits_are_the_decimals_of_every_column() -> None:
    for count in (0, 7, 50):
        (record,) = csv("--angle", "60", "--ratio", "1:4,5", "--digits", str(count))
        for key in ("x", "c_return", "p"):
            assert record[key] == textbook(key, Drive(NINTHS), Fraction(60), count)


def test_ties_are_rounded_as_asked() -> None:
    # p = 1 + 1/8 at the inner dead centre.
    words = ("--ratio", "1:8", "--angle", "0", "--digits", "2")
    assert column("p", *words) == ["1.13"]
    assert column("p", *words, "--rounding", "half-even") == ["1.12"]


@pytest.mark.parametrize("method", ["exact", "series", "infinite"])
def test_the_method_is_the_formula_of_the_columns(method: str) -> None:
    (record,) = csv("--angle", "50", "--ratio", "1:4,5", "--method", method)
    for key in ("x", "x_return", "c", "c_return", "p", "p_return"):
        assert record[key] == textbook(key, Drive(NINTHS), Fraction(50), 4, method)


def test_an_offset_is_a_share_of_the_crank_radius() -> None:
    (record,) = csv("--offset", "-0,25", "--angle", "50", "--ratio", "1:4,5")
    for key in ("x", "x_return", "c", "p"):
        assert record[key] == textbook(key, Drive(NINTHS, Fraction(-1, 4)), Fraction(50), 4)


@pytest.mark.parametrize(("length", "share"), [("75mm", "0.25"), ("-7,5 cm", "-1/4"), ("0mm", "0")])
def test_an_offset_is_a_length_where_the_stroke_is_known(length: str, share: str) -> None:
    machine = ("--stroke", "600mm", "--rod", "1350mm", "--angle", "50")
    drive = Drive(NINTHS, Fraction(share), radius=Fraction(3, 10))
    (record,) = csv(*machine, "--offset", length)
    assert record["x_mm"] == textbook("x_mm", drive, Fraction(50), 2)
    assert record["c"] == textbook("c", drive, Fraction(50), 4)


@pytest.mark.parametrize(
    ("speed", "value", "turns"),
    [("120/min", Fraction(2), True), ("720deg/s", Fraction(2), True), ("12.5rad/s", Fraction(25, 2), False)],
)
def test_a_machine_is_printed_in_millimetres_and_metres_per_second(
    speed: str, value: Fraction, turns: bool
) -> None:
    (record,) = csv("--stroke", "600mm", "--rod", "1350mm", "--speed", speed, "--angle", "50")
    drive = Drive(NINTHS, radius=Fraction(3, 10), speed=value, turns=turns)
    assert record["ratio"] == "1:4.5"
    places = {
        "x_mm": 2,
        "x_return_mm": 2,
        "c_mps": 3,
        "c_return_mps": 3,
        "p_mps2": 2,
        "p_return_mps2": 2,
        "x": 4,
    }
    for key, decimals in places.items():
        assert record[key] == textbook(key, drive, Fraction(50), decimals)


def test_a_rod_and_a_ratio_give_the_stroke() -> None:
    by_rod = csv("--rod", "1350mm", "--ratio", "1:4,5", "--angle", "50")
    by_stroke = csv("--stroke", "600mm", "--ratio", "1:4,5", "--angle", "50")
    assert by_rod == by_stroke


def test_csv_has_commas_and_points_unless_commas_are_asked_for() -> None:
    words = ("table", "-f", "csv", "--angle", "22.5", "--ratio", "1:4,5", "--columns", "ratio,phi,p_return")
    value = textbook("p_return", Drive(NINTHS), Fraction(45, 2), 4)
    assert printed(*words).out == f"ratio,phi,p_return\n1:4.5,22.5,{value}\n"
    with_commas = f"ratio;phi;p_return\n1:4,5;22,5;{value}\n".replace(".", ",")
    assert printed(*words, "--decimal", "comma").out == with_commas


def test_json_has_the_rows_of_csv() -> None:
    words = ("--ratio", "1:4;1:6", "--step", "45")
    rows = json.loads(printed("table", "-f", "json", *words).out, parse_float=str, parse_int=str)["rows"]
    assert rows == csv(*words)


@pytest.mark.parametrize("format_name", ["text", "markdown", "latex", "html"])
def test_every_page_has_the_values_with_the_decimal_mark_of_the_language(format_name: str) -> None:
    value = textbook("c", Drive(NINTHS), Fraction(50), 4)
    words = ("table", "-f", format_name, "--ratio", "1:4,5", "--angle", "50")
    assert value.replace(".", ",") in printed(*words).out
    assert value in printed(*words, "--lang", "en").out
    assert value in printed(*words, "--decimal", "point").out


def test_layouts_are_listed_a_line_each() -> None:
    lines = printed("layouts").out.splitlines()
    assert [line.split()[0] for line in lines] == list(layout_names())
    assert all(len(line.split()) > 3 for line in lines)
    assert printed("layouts", "--lang", "en").out.splitlines() != lines


def test_quantities_are_listed_a_line_each() -> None:
    lines = printed("quantities").out.splitlines()
    keys = [line.split()[0] for line in lines]
    approximated = [
        one.key for about in ("series errors", "successive") for one, _ in subject(about).entries()
    ]
    motion = ["ratio", "phi", *registry(), *approximated]
    loaded = (
        "cylinders", "power", "torques", "areas", "speed", "evenness", "rod load", "flywheel sizing",
        "pressures",
    )  # fmt: skip
    own = [one.key for key in loaded for one, _ in subject(key).entries()]
    engines = [*engine_registry(), *own, *beam.registry(), *dead_centres.registry()]
    links = [*arc_registry(), *parallel_registry(), *beam_registry(), *coupled_registry()]
    firing = [*orders_registry(), *cylinders_registry()]
    turned = [*angle_quantities(), PLACE, *rotor_quantities(), *locomotive_quantities()]
    rods = [*inertia_registry(), *error_columns(), *(one.key for one, _ in subject("rod masses").entries())]
    assert keys == [
        *motion, *engines, *("value" for _ in harmonics.HARMONICS), *torques(), *balance_registry(), *turned,
        *firing, *links, *points_registry(), *rods, *(one.key for _, one in own_columns()),
        *(one.key for about in ("over path", "unknown") for one, _ in subject(about).entries()),
        *(one.key for one, _ in subject("construction").entries()),
    ]  # fmt: skip
    assert all(len(line.split()) > 2 for line in lines)
    assert printed("quantities", "--lang", "en").out.splitlines() != lines


def test_the_environment_sets_defaults_and_options_override_them() -> None:
    words = ("table", "--angle", "50")
    environment = {"KURBEL_FORMAT": "csv", "KURBEL_TABLE_RATIO": "1:4", "KURBEL_TABLE_DIGITS": "2"}
    (record,) = printed(*words, **environment).records()
    assert (record["ratio"], record["c"]) == ("1:4", textbook("c", Drive(Fraction(1, 4)), Fraction(50), 2))
    (record,) = printed(*words, "--ratio", "1:6", **environment).records()
    assert record["ratio"] == "1:6"
    assert printed(*words, "-f", "text", **environment).out.lstrip().startswith("Kolbenweg")
    assert printed(*words, KURBEL_LANG="en").out == printed(*words, "--lang", "en").out
    assert printed(*words, KURBEL_TABLE_RATIO="1:4 1:6").out == printed(*words, "--ratio", "1:4;1:6").out
    assert printed(*words, KURBEL_TABLE_RATIO="").out == printed(*words).out


def test_help_and_version_are_answers_and_not_errors() -> None:
    assert printed("--version").out.split()[0] == "kurbel"
    assert printed("-h").out == printed("--help").out
    assert printed("table", "-h").out == printed("table", "--help").out
    assert printed("--help").out.startswith("Usage: kurbel ")


def test_a_table_made_for_a_document_leaves_the_help_of_its_command() -> None:
    code = (
        "import sys; from kurbel.cli import main; from kurbel.cli.asking import asked;"
        " asked(['balance'], {}); sys.argv = ['kurbel', 'balance', '-h']; main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("Usage: kurbel balance ")


def test_without_a_command_the_help_is_shown_as_an_error() -> None:
    result = kurbel()
    assert (result.code, result.out) == (2, "")
    assert result.err == printed("--help").out


drives = st.builds(
    lambda rod, share: (rod, (rod - 1) * share),
    st.fractions(min_value=Fraction(11, 10), max_value=20, max_denominator=10),
    st.fractions(min_value=Fraction(-9, 10), max_value=Fraction(9, 10), max_denominator=10),
)


@settings(deadline=None, max_examples=30)
@given(
    drive=drives,
    seconds=st.sampled_from([(-360 * 3600, 720 * 3600), (0, 180 * 3600)]).flatmap(
        lambda ends: st.lists(st.integers(*ends), min_size=1, max_size=3, unique=True)
    ),
    decimals=st.integers(0, 30),
)
def test_every_digit_of_a_random_table_is_that_of_the_textbook(
    drive: tuple[Fraction, Fraction], seconds: list[int], decimals: int
) -> None:
    rod, offset = drive
    angles = [Fraction(count, 3600) for count in seconds]
    written = ";".join(
        f"{'-' * (count < 0)}{abs(count) // 3600}°{abs(count) % 3600 // 60}'{abs(count) % 60}\""
        for count in seconds
    )
    # Numbers on the command line are decimals; e = share of R to 12 places.
    share = round(offset, 12)
    ratio = f"{rod.denominator}:{rod.numerator}"
    # The return stroke ends at 180°.
    both = all(0 <= angle <= 180 for angle in angles)
    keys = ("x", *["x_return"] * both, "c", "p", "psi")
    words = (
        "--ratio",
        ratio,
        "--offset",
        f"{float(share):.12f}",
        "--digits",
        str(decimals),
        "--columns",
        ",".join(keys),
    )
    records = csv(*words, f"--angle={written}")
    assert len(records) == len(angles)
    for record, angle in zip(records, angles, strict=True):
        for key in keys:
            scaled = rounded(evaluate(key, "exact", Drive(1 / rod, share), angle), decimals)
            if scaled is not None:
                assert record[key] == digits(scaled, decimals), (ratio, share, angle, key)


def test_formats_are_known_by_their_suffixes_too() -> None:
    assert printed("table", "-f", "md").out == printed("table", "-f", "markdown").out
    assert printed("table", "-f", "tex").out == printed("table", "-f", "latex").out


def test_label_is_the_name_of_the_reference() -> None:
    assert r"\label{tab:eins}" in printed("table", "-f", "latex", "--label", "eins").out
    assert r"\label{tab:kinematics}" in printed("table", "-f", "latex").out
    assert 'id="tab-eins"' in printed("table", "-f", "html", "--label", "eins").out


def test_environment_gives_way_to_what_is_typed() -> None:
    typed = ("table", "--stroke", "600mm", "--rod", "1500mm", "--angle", "90")
    assert printed(*typed, KURBEL_TABLE_RATIO="1:3").out == printed(*typed).out
    csv = printed("table", "--angle", "90", KURBEL_TABLE_FORMAT="csv").out
    assert csv == printed("table", "--angle", "90", "-f", "csv").out
    assert printed("table", KURBEL_TABLE_STANDALONE="1").out == printed("table").out
    step = printed("table", "--step", "90", KURBEL_TABLE_ANGLE="30").out
    assert step == printed("table", "--step", "90").out
    ratio = printed("table", "--ratio", "1:4", KURBEL_TABLE_STROKE="600mm", KURBEL_TABLE_ROD="1500mm").out
    assert ratio == printed("table", "--ratio", "1:4", "--stroke", "600mm").out


def test_columns_may_be_given_in_several_options() -> None:
    header = printed("table", "-f", "csv", "--columns", "phi", "--columns", "c;x").out.splitlines()[0]
    assert header == "phi,c,x"


def test_offset_is_read_as_the_page_prints_it() -> None:
    assert printed("table", "--offset", "0,2 R").out == printed("table", "--offset", "0.2").out


def test_an_angle_that_is_no_decimal_leaves_the_others_as_they_are() -> None:
    records = printed("table", "--angle", "11.25;0°20'", "-f", "csv").records()
    assert [row["phi"] for row in records] == ["11.25", "0.333333333333333"]


def test_captions_speak_of_the_columns_on_the_page() -> None:
    assert "Prozent" not in printed("table", "--layout", "kolbenwege", "--columns", "c").out
    assert printed("table", "--layout", "roetscher-112", "--columns", "c", "--ratio", "1:5").out.startswith(
        " Kolbengeschwindigkeit für R:L = 1:5; genaue Formeln\n"
    )
    both = printed("table", "--columns", "psi,psi_return", "--method", "series").out
    assert "sin ψ = ± λ sin φ" in both
    assert "oberes Zeichen" in both
    assert "Unterschied" not in printed("table", "--layout", "verfahren", "--columns", "p_exact,p_series").out


def test_fixed_formulas_keep_their_ratio_beside_an_infinite_rod() -> None:
    words = (
        "table",
        "--layout",
        "lueger-kolbenbewegung",
        "--ratio",
        "1:4",
        "--method",
        "infinite",
        "--angle",
        "0",
    )
    assert printed(*words, "-f", "csv").records() == [
        {"ratio": "1:4", "phi": "0", "x_percent": "0.00", "p_bracket": "1.2500"}
    ]


def test_one_stroke_has_one_sign() -> None:
    page = printed("table", "--columns", "x_return,psi_return", "--angle", "60").out
    assert "±" not in page
    assert "1 − cos φ − (1 − cos ψ)/λ" in page
    assert "sin ψ = − λ sin φ" in page


def test_records_of_paired_pages_are_at_the_angles_asked_for() -> None:
    words = ("table", "--layout", "roetscher-112", "--ratio", "1:5", "--angle", "160;200", "-f", "csv")
    assert [(row["phi"], row["c"]) for row in printed(*words).records()] == [
        ("160", "0.278"),
        ("200", "-0.278"),
    ]


def test_notes_do_not_divide_by_the_ratio_of_an_infinite_rod() -> None:
    page = printed("table", "--ratio", "1:inf", "--angle", "90", "--columns", "x").out
    assert " x/R = 1 − cos φ\n" in page
    assert "λ" not in page
