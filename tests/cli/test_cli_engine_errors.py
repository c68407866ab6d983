"""Engines that cannot be and words that cannot be read: one sentence each, and nothing printed."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from cli import kurbel, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from pages import DRIVES, about
from places import CARDS

from kurbel.formats.registry import FORMATS
from kurbel.page.layouts import layout_names
from kurbel.reading import units
from kurbel.reading.extras import how_to_install

TOO_SHORT = "it must be below 1, or the rod is too short to pass the dead centre"
NO_NUMBER = "is not a number; write it as 4.5 or 4,5"
NO_ANGLE = "is not an angle in degrees; write it as 22.5 or 22°30'"
EARLY = "it must be 1 (no expansion) or more, for the cut-off comes after the share 1/ε of the stroke"
SHARE = "it must lie within 0..1, for it is a share of the steam pressure before cut-off"
FALLING = "it must be above 0 and at most 10, for the pressure falls as the steam expands"
SWEPT = "it must lie within 0..10, for it is a share of the volume swept in a stroke"
NO_WORK = (
    "at its best back pressure, that of the steam at the end of the stroke, leaves no work;"
    " give a lower one, for example --back 0"
)
ANGLES_ONLY = (
    'method "weisbach" is about the angles of the extremes, which a turning effort has not; use series'
)
WEISBACH = (
    'method "weisbach" is for one double-acting crank, exponent 1 and no clearance, as in § 150;'
    " use exact or series"
)
MEASURED = "describes an ideal card, and --card gives a measured one; leave one out"
IDEAL = str(CARDS / "ideal-2.csv")
SPEED = "a speed of rotation such as 120/min, 120rpm or 12.5rad/s"
REST = "it must be at least 10^-9 and below 2, at which the flywheel would come to rest in every turn"
IRREGULARITY = ", ".join(
    about("irregularity", "strokes", "evenness", "compressor", "pump", "gas cycle", "cylinders")
)
TURNING_LAYOUTS = ", ".join(about("turning", "speed"))
ALL_TURNING_LAYOUTS = ", ".join(about("turning", "speed", "torques", "areas"))
WORK = (
    "work, full_pressure_work, expansion_work, back_work,"
    " mean_pressure, mean_pressure_kpa, indicated_power, volumetric_efficiency, delivered, delivery,"
    " efficiency"
)
TURN_COLUMNS = (
    "epsilon, ratio, delta, mean_force, back, exponent, clearance, alpha_min, v_min, alpha_max, v_max,"
    f" {WORK}"
)
NO_IRREGULARITY = "cannot be read; write it as 1:100, 0.01 or 1%"

# What every command about engines refuses alike.
ENGINES = [
    (("--eps", "0.5"), f"expansion ratio ε is 0.5; {EARLY}: after 0.5 of it, ε = 2"),
    (("--eps", "-2"), f"expansion ratio ε is -2; {EARLY}"),
    (("--eps", "2;0"), f"expansion ratio ε is 0; {EARLY}"),
    (("--eps", "1"), f"expansion ratio ε = 1 {NO_WORK}"),
    (("--eps", "1..3"), f"expansion ratio ε = 1 {NO_WORK}"),
    (("--eps", "2e6"), "expansion ratio ε is 2000000; at most 1000000 is allowed"),
    (("--eps", "abc"), f'expansion ratio "abc" {NO_NUMBER}'),
    (("--eps", "1:4"), f"expansion ratio ε is 0.25; {EARLY}: after 0.25 of it, ε = 4"),
    (("--eps", "nan"), f'expansion ratio "nan" {NO_NUMBER}'),
    (("--eps", ""), f'expansion ratio "" {NO_NUMBER}'),
    (
        ("--eps", "2,3"),
        'expansion ratio "2,3" can be read as the number 2.3 or the list 2;3; write 2.3 or 2;3',
    ),
    (("--eps", "2;;3"), 'expansion ratio "2;;3" has an empty place; write a list as 2;3;4'),
    (("--eps", "2.."), 'expansion ratio "2.." is not a range; write it as 2..6 or 2..6:0.5'),
    (("--eps", "6..2"), "the expansion ratios run from 6 to 2; the end must not lie before the start"),
    (("--eps", "2..6:0"), "step 0 leads nowhere; it must be above 0"),
    (("--eps", "2..100000"), "99999 expansion ratios were given; at most 10000 are allowed"),
    (("--back", "1.5"), f"back pressure b is 1.5; {SHARE}"),
    (("--back=-0.1",), f"back pressure b is -0.1; {SHARE}"),
    (("--back", "120%"), f"back pressure b is 1.2; {SHARE}"),
    (("--back", "abc"), f'back pressure "abc" {NO_NUMBER}'),
    (("--back", ""), f'back pressure "" {NO_NUMBER}'),
    # (1 + ln 4)/4 is 0.59657359 and (1 + ln 2)/2 is 0.84657359.
    (
        ("--back", "0.9", "--eps", "4"),
        "back pressure b = 0.9 leaves no work at ε = 4; b must be below 0.596573,"
        " or the mean force P would not be above 0",
    ),
    (
        ("--back", "1", "--eps", "2..6"),
        "back pressure b = 1 leaves no work at ε = 2; b must be below 0.846573,"
        " or the mean force P would not be above 0",
    ),
    (("--exponent", "0"), f"exponent n is 0; {FALLING}"),
    (("--exponent=-1.2",), f"exponent n is -1.2; {FALLING}"),
    (("--exponent", "11"), f"exponent n is 11; {FALLING}"),
    (("--exponent", "abc"), f'exponent "abc" {NO_NUMBER}'),
    (("--exponent", ""), f'exponent "" {NO_NUMBER}'),
    (("--clearance=-5%",), f"clearance is -0.05; {SWEPT}"),
    (("--clearance", "11"), f"clearance is 11; {SWEPT}"),
    (("--clearance", "abc"), f'clearance "abc" {NO_NUMBER}'),
    (("--clearance", ""), f'clearance "" {NO_NUMBER}'),
    (("--cranks", "abc"), f'angle "abc" {NO_ANGLE}'),
    (("--cranks", ""), f'angle "" {NO_ANGLE}'),
    (("--cranks", "0;;90"), 'angle "0;;90" has an empty place; write a list as 2;3;4'),
    (
        ("--cranks", "0,90"),
        'angle "0,90" can be read as the number 0.90 or the list 0;90; write 0.90 or 0;90',
    ),
    (("--cranks", "0..24:1"), "the engine has 25 cranks; 1 to 24 are allowed"),
    (("--cranks", "0..360:1e-6"), "the engine has 360000001 cranks; 1 to 24 are allowed"),
    (
        ("--cranks", "90;0"),
        "the first crank is at 90°; angles count from the first crank, write them as 0;90",
    ),
    (("--ratio", "1:1"), f"crank ratio R:L is 1; {TOO_SHORT}"),
    (("--ratio=-1:5",), "crank ratio R:L is -0.2; it must not be negative, for both are lengths"),
    (("--method", "infinite"), 'there is no method "infinite"; choose from exact, series, weisbach'),
    (("--card", "x.csv", "--eps", "2"), f"--eps {MEASURED}"),
    (("--card", "x.csv", "--back", "0"), f"--back {MEASURED}"),
    (("--card", "x.csv", "--exponent", "1.1"), f"--exponent {MEASURED}"),
    (("--card", "x.csv", "--clearance", "5%"), f"--clearance {MEASURED}"),
    (
        ("--card", "x.csv", "--other-side", "1bar"),
        "--other-side is for --single-acting; double-acting, the other end works as well",
    ),
    (
        ("--single-acting", "--other-side", "1bar"),
        "--other-side is for --card; of an ideal card --back is the pressure there",
    ),
    (("--digits", "51"), 'digits "51" cannot be printed; write a whole number from 0 to 50'),
    (
        ("--rounding", "even"),
        'there is no rounding "even" (did you mean half-even?); choose from half-away, half-even',
    ),
    (("-f", "docx"), f'there is no format "docx"; choose from {", ".join(FORMATS)}'),
    (
        ("-o", "x.foo"),
        "the file name 'x.foo' names no format;"
        " its suffix must be one of .txt, .md, .tex, .html, .htm, .typ, .rst, .pdf, .xlsx, .ods, .csv, .dat,"
        " .json",
    ),
    (("--columns", ","), 'columns "," has an empty place; write it as epsilon,delta'),
]
# What his method does not know, of δ and of what follows from δ.
WEISBACHS = [
    (("--single-acting",), WEISBACH),
    (("--cranks", "0;90"), WEISBACH),
    (("--cranks", "0;0"), WEISBACH),
    (("--exponent", "1.13"), WEISBACH),
    (("--clearance", "5%"), WEISBACH),
    (
        ("--card", IDEAL),
        'method "weisbach" has no equations for an indicator card; use exact or series',
    ),
]
DELTAS = [
    (
        ("--cut-off", "25%"),
        "--cut-off is for the cycle of a gas engine; add --compression;"
        " steam cut off after a quarter of the stroke is --eps 4",
    ),
    (
        ("--layout", "kinematics"),
        f"layout kinematics is about something else; choose from {IRREGULARITY}",
    ),
    (("--layout", "turning"), f"layout turning is about something else; choose from {IRREGULARITY}"),
    (
        ("--detail", "--layout", "delta-tafel"),
        "--detail is layout delta-detail, and --layout names delta-tafel; leave one out",
    ),
    (
        ("--method", "exact", "--method", "series", "--layout", "weisbach-150"),
        "layout weisbach-150 shows one method, and 2 were given; use --layout delta-verfahren",
    ),
    (
        ("--eps=4", "--method", "exact", "--method", "series", "--method", "weisbach", "--detail"),
        "layout delta-detail shows one method, and 3 were given; use --layout delta-verfahren",
    ),
    (("--layout", "delta-verfahren", "--single-acting"), WEISBACH),
    (
        ("--card", IDEAL, "--layout", "weisbach-150"),
        "layout weisbach-150 is over ε, which an indicator card does not have; use --layout delta-detail",
    ),
    *(
        (
            ("--card", IDEAL, "--columns", key),
            f"column {key} needs an ideal card, with an expansion ratio; leave it out, or give that",
        )
        for key in ("back", "exponent", "clearance", "alpha_cutoff")
    ),
    (("--columns", "epsilon,ratio"), "there is no column beside the axes; add one, such as delta"),
    (
        ("--layout", "turnings"),
        f'there is no layout "turnings"; choose from {IRREGULARITY}',
    ),
    (
        ("--layout", "delta-tafle"),
        f'there is no layout "delta-tafle" (did you mean delta-tafel?); choose from {IRREGULARITY}',
    ),
    (
        ("--columns", "epsilon,dleta"),
        f'there is no column "dleta" (did you mean delta?); choose from {TURN_COLUMNS}',
    ),
    (
        ("--columns", "power"),
        f'there is no column "power" (did you mean indicated_power?); choose from {TURN_COLUMNS}',
    ),
    (
        ("--detail", "--eps=4", "--cranks", "0;90", "--columns", "alpha_cutoff"),
        "column alpha_cutoff needs one double-acting crank; leave it out, or give that",
    ),
    (
        ("--layout", "delta-verfahren", "--columns", "delta"),
        'there is no column "delta" (did you mean delta_exact, delta_series or delta_weisbach?);'
        " choose from epsilon, ratio, delta_exact,"
        " delta_series, delta_weisbach, difference_series, difference_weisbach",
    ),
    (
        ("--standalone", "-f", "csv"),
        "--standalone is for latex, html and typst; csv has no documents; see kurbel delta --help",
    ),
    (("--longtable", "-f", "html"), "--longtable is for latex; the format is html; see kurbel delta --help"),
    (("1:5",), '"1:5" stands behind no option; write --ratio 1:5; see kurbel delta --help'),
    (("--epz", "2"), 'there is no option "--epz" (did you mean --eps?); see kurbel delta --help'),
    (("--angle", "30"), 'there is no option "--angle"; see kurbel delta --help'),
]
TURNINGS = [
    (
        ("--angle", "0", "--step", "5"),
        "--angle lists the angles and --step runs through the turn; use one or the other",
    ),
    (("--angle", "x"), f'angle "x" {NO_ANGLE}'),
    (("--angle", ""), f'angle "" {NO_ANGLE}'),
    (("--angle", "2e6"), "an angle is beyond 1000000°; give it within one turn, 0..360"),
    (("--step", "0"), "step 0 leads nowhere; it must be above 0"),
    (("--step", ""), f'step "" {NO_ANGLE}'),
    (("--step", "361"), "step 361 is larger than the range 0..360; at most 360 fits"),
    (("--step", "1e-7"), "step 0.0000001 makes a table of 3600000001 rows; at most 10^9 are allowed"),
    (
        ("--step", "1e-6", "--eps", "2..6", "-f", "csv"),
        "the table would have 1800000005 rows; at most 10^9 are allowed",
    ),
    (
        ("--step", "0.001"),
        "a page of 1440004 numbers is too long; at most 300000 are set, use -f csv or -f json",
    ),
    (
        ("--layout", "delta-tafel"),
        f"layout delta-tafel is about something else; choose from {TURNING_LAYOUTS}",
    ),
    (
        ("--method", "exact", "--method", "series"),
        "layout turning shows one method, and 2 were given; leave the others out",
    ),
    (
        ("--columns", "phi,enregy"),
        'there is no column "enregy" (did you mean energy?);'
        " choose from epsilon, ratio, phi, tangential, mean_force, tangential_excess, energy, delta, back,"
        f" exponent, clearance, pin_path, pin_path_mm, tangential_kpa, {WORK}, torque_nm",
    ),
    (("--columns", "epsilon,phi"), "there is no column beside the axes; add one, such as energy"),
    (
        ("--layout", "turnings"),
        f'there is no layout "turnings" (did you mean turning?); choose from {ALL_TURNING_LAYOUTS}',
    ),
    (("--method", "weisbach"), ANGLES_ONLY),
]
WITHIN = "it must lie within 10^-9 and 10^12"
FLYWHEEL = {"--power": "50kW", "--speed": "120/min", "--delta": "1:100", "--eps": "4"}
# What is given in place of, or beside, the flywheel above.
FLYWHEELS = [
    (("--power", "50"), 'power "50" has no unit; write a power such as 50kW or 68PS'),
    (("--power", "50kg"), 'power "50kg" is in kilogram; it must be a power such as 50kW or 68PS'),
    (("--power", "50 xyz"), 'power "50 xyz" has the unknown unit xyz; write a power such as 50kW or 68PS'),
    (("--power", ""), 'power "" is not a power such as 50kW or 68PS'),
    (("--power", "0kW"), 'power "0kW" is out of range; it must be above 0 and at most 10^12 W'),
    (("--power", "-5kW"), 'power "-5kW" is out of range; it must be above 0 and at most 10^12 W'),
    (("--speed", "120"), f'speed "120" has no unit; write {SPEED}'),
    (("--speed", "3m"), f'speed "3m" is in meter; it must be {SPEED}'),
    (
        ("--speed", "0/min"),
        'speed "0/min" is out of range; it must be above 0 and at most 10^9 turns a second',
    ),
    (("--power", "1e-10W"), f"the power is 0.0000000001 W; {WITHIN} W"),
    (("--speed", "1e-10rad/s"), f"the speed is 0.0000000001 1/s; {WITHIN} 1/s"),
    (("--radius", "1e-10m"), f"the radius of the flywheel is 0.0000000001 m; {WITHIN} m"),
    (("--delta", "abc"), f'degree of irregularity "abc" {NO_IRREGULARITY}'),
    (("--delta", ""), f'degree of irregularity "" {NO_IRREGULARITY}'),
    (("--delta", "%"), f'degree of irregularity "%" {NO_IRREGULARITY}'),
    (("--delta", "1:100%"), f'degree of irregularity "1:100%" {NO_IRREGULARITY}'),
    (("--delta", "1:0"), f'degree of irregularity "1:0" {NO_IRREGULARITY}'),
    (("--delta", "1..2"), f'degree of irregularity "1..2" {NO_IRREGULARITY}'),
    (("--delta", "1e-10"), f"degree of irregularity δ is 0.0000000001; {REST}"),
    (("--delta", "200%"), f"degree of irregularity δ is 2; {REST}"),
    (("--delta", "0"), f"degree of irregularity δ is 0; {REST}"),
    (("--delta", "1:inf"), f"degree of irregularity δ is 0; {REST}"),
    (("--delta", "-1:5"), f"degree of irregularity δ is -0.2; {REST}"),
    (("--delta", "1:100;2"), f"degree of irregularity δ is 2; {REST}"),
    (
        ("--delta", "1:50,1:100"),
        'degree of irregularity "1:50,1:100" has commas between its values; write the list as 1:50;1:100',
    ),
    (("--radius", "0m"), 'radius "0m" is out of range; it must be above 0 and at most 10^9 m'),
    (("--radius", "5"), 'radius "5" has no unit; write a length such as 600mm'),
    (("--radius", "abc"), 'radius "abc" is not a length such as 600mm'),
    (
        ("--layout", "weisbach-150"),
        "layout weisbach-150 is about something else; choose from flywheel",
    ),
    (
        ("--method", "exact", "--method", "series"),
        "layout flywheel shows one method, and 2 were given; leave the others out",
    ),
    (
        ("--columns", "mass"),
        "column mass needs the radius at which the mass is, --radius; leave it out, or give that",
    ),
    # What is proposed can be asked for: the mass would need a radius.
    (("--columns", "epsilon,target"), "there is no column beside the axes; add one, such as inertia"),
    (
        ("--columns", "epsilon,target", "--radius", "1m"),
        "there is no column beside the axes; add one, such as mass",
    ),
    (("--layout", "turnings"), 'there is no layout "turnings"; choose from flywheel, flywheel-sizing'),
    (
        ("--columns", "inertai"),
        'there is no column "inertai" (did you mean inertia?); choose from epsilon, ratio, target, power,'
        " speed, omega, mean_torque, swing_share, swing, inertia, inertia_true, mass",
    ),
]


def flywheel(*words: str) -> tuple[str, ...]:
    """Return the words of a flywheel that has nothing wrong but these."""
    # A card stands in the place of the expansion ratio.
    given = {*words, *(("--eps",) if "--card" in words else ())}
    own = [word for name, text in FLYWHEEL.items() if name not in given for word in (name, text)]
    return ("flywheel", *own, *words)


def test_a_card_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    sentence = refusal("delta", "--card", str(tmp_path / "missing.csv"), code=1)
    assert sentence.startswith("cannot read the card ")
    assert sentence.endswith("/missing.csv: No such file or directory")


def labelled(cases: list[tuple[tuple[str, ...], str]]) -> list[object]:
    return [pytest.param(words, sentence, id=" ".join(words)) for words, sentence in cases]


def turning(*words: str) -> tuple[str, ...]:
    """A turning effort under the load of these words, else under steam."""
    loaded = any(word.startswith(("--eps", "--card")) for word in words)
    return ("turning", *(() if loaded else ("--eps=4",)), *words)


@pytest.mark.parametrize(("words", "sentence"), labelled(ENGINES))
def test_a_wrong_engine_is_answered_by_every_command_with_the_same_sentence(
    words: tuple[str, ...], sentence: str
) -> None:
    assert refusal("delta", *words) == sentence
    assert refusal(*turning(*words)) == sentence
    assert refusal(*flywheel(*words)) == sentence


@pytest.mark.parametrize(("words", "sentence"), labelled(WEISBACHS))
def test_an_engine_that_weisbach_does_not_know_is_refused_to_his_method(
    words: tuple[str, ...], sentence: str
) -> None:
    assert refusal("delta", "--method", "weisbach", *words) == sentence
    assert refusal(*flywheel("--method", "weisbach", *words)) == sentence
    assert refusal(*turning("--method", "weisbach", *words)) == ANGLES_ONLY


@pytest.mark.parametrize(("words", "sentence"), labelled(DELTAS))
def test_wrong_usage_of_delta_is_answered_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal("delta", *words) == sentence


@pytest.mark.parametrize(("words", "sentence"), labelled(TURNINGS))
def test_wrong_usage_of_turning_is_answered_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal(*turning(*words)) == sentence


@pytest.mark.parametrize(("words", "sentence"), labelled(FLYWHEELS))
def test_a_wrong_flywheel_is_answered_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal(*flywheel(*words)) == sentence


@pytest.mark.parametrize("missing", ["--speed", "--delta"])
def test_a_flywheel_needs_speed_and_irregularity(missing: str) -> None:
    words = [word for name, text in FLYWHEEL.items() if name != missing for word in (name, text)]
    examples = {"--speed": "--speed 120/min", "--delta": "--delta 1:100"}
    told = f"the flywheel of an engine needs {missing}; add it, for example {examples.get(missing)}"
    assert refusal("flywheel", *words) == told


def test_pages_of_engines_are_not_printed_as_tables_of_motion() -> None:
    for name in set(layout_names()) - set(DRIVES):
        assert refusal("table", "--layout", name) == (
            f"layout {name} is about something else; choose from {', '.join(DRIVES)}"
        )


def test_without_pint_a_flywheel_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    units.registry.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    assert refusal(*flywheel("--power", "68PS"), code=1) == (
        f"quantities with units need pint; install it with: {how_to_install('units')}"
    )
    assert kurbel(*flywheel()).code == 0


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize(
    "words",
    [
        ("delta", "--eps", "0.5"),
        ("delta", "--back", "0.9"),
        ("delta", "--method", "weisbach", "--single-acting"),
        ("turning", "--eps=4", "--columns", "foo"),
        flywheel("--power", "50kg"),
    ],
    ids=" ".join,
)
def test_nothing_is_written_on_an_error(words: tuple[str, ...], form: str, tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_text("as it was")
    for path in (old, new):
        refusal(*words, "-f", form, "-o", str(path))
    assert [path.name for path in tmp_path.iterdir()] == ["old"]
    assert old.read_text() == "as it was"


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("KURBEL_DELTA_EPS", "0.5", f"expansion ratio ε is 0.5; {EARLY}: after 0.5 of it, ε = 2"),
        ("KURBEL_DELTA_BACK", "x", f'back pressure "x" {NO_NUMBER}'),
        (
            "KURBEL_DELTA_METHOD",
            "exakt",
            'there is no method "exakt" (did you mean exact?); choose from exact, series, weisbach',
        ),
        ("KURBEL_LANG", "fr", 'there is no language "fr"; choose from de, en'),
    ],
)
def test_nonsense_in_the_environment_is_answered_with_a_sentence(
    name: str, value: str, sentence: str
) -> None:
    environment = {name: value}
    assert refusal("delta", code=2, **environment) == sentence


options = st.sampled_from(
    [
        "--eps",
        "--ratio",
        "--back",
        "--exponent",
        "--clearance",
        "--cranks",
        "--method",
        "--columns",
        "--digits",
    ]
)
values = st.one_of(
    st.text(st.sampled_from("0123456789.,:;/°'-+e∞% abn\n"), max_size=8),
    st.sampled_from(["2..4", "1:4", "0.1", "10%", "0;90", "series", "weisbach", "delta,back", "5"]),
)


@settings(deadline=None, max_examples=80)
@given(st.lists(st.tuples(options, values), min_size=1, max_size=3))
def test_whatever_is_typed_is_answered_with_a_page_or_a_sentence(typed: list[tuple[str, str]]) -> None:
    words = [f"{option}={value}" for option, value in typed]
    result = kurbel("delta", "--eps", "3", *words, "--digits", "2")
    if result.code == 0:
        assert result.out.endswith("\n")
        assert result.err == ""
    else:
        assert (result.code, result.out, result.err.count("\n")) == (2, "", 1)
        assert result.err.startswith("kurbel: ")
