"""Bad input: one sentence on standard error, nothing on standard output, no file, and the right exit code."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import kurbel, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from pages import DRIVES as TABLES

from kurbel.cli import COMMANDS
from kurbel.formats.registry import FORMATS
from kurbel.motion.quantities import registry
from kurbel.page.layouts import LANGUAGES

TOO_SHORT = "it must be below 1, or the rod is too short to pass the dead centre"
NO_RATIO = "is not a ratio R:L; write it as 1:5, 1:4,5, 1/4.5 or 0.2, and 1:∞ or 1:inf for an infinite rod"
NO_ANGLE = "is not an angle in degrees; write it as 22.5 or 22°30'"
HELP = "see kurbel table --help"
LAYOUTS = ", ".join(TABLES)
ENDLESS_ROD = (
    "crank ratio R:L is below 1:1000000000; no rod is that long, write 1:∞ or 1:inf for an infinite one"
)

RATIOS = [
    ("-1:5", "crank ratio R:L is -0.2; it must not be negative, for both are lengths"),
    ("1:1", f"crank ratio R:L is 1; {TOO_SHORT}"),
    ("3:2", f"crank ratio R:L is 1.5; {TOO_SHORT}"),
    ("1e400", f"crank ratio R:L is 1e+400; {TOO_SHORT}"),
    ("1:1e400", ENDLESS_ROD),
    ("1:", f'crank ratio "1:" {NO_RATIO}'),
    ("", f'crank ratio "" {NO_RATIO}'),
    ("abc", f'crank ratio "abc" {NO_RATIO}'),
    ("nan", f'crank ratio "nan" {NO_RATIO}'),
    ("１:５", f'crank ratio "１:５" {NO_RATIO}'),
    ("1\n:5\x1b[31m", f'crank ratio "1\\n:5\\x1b[31m" {NO_RATIO}'),
    ("2,3", 'crank ratio "2,3" can be read as the number 2.3 or the list 2;3; write 2.3 or 2;3'),
    ("1:3..1000000:0.001", "999997001 crank ratios were given; at most 10000 are allowed"),
]
ANGLES = [
    (("--step", "0"), "step 0 leads nowhere; it must be above 0"),
    (("--step", "-1"), "step -1 leads nowhere; it must be above 0"),
    (("--step", "361"), "step 361 is larger than the range 0..360; at most 360 fits"),
    (("--step", "1e-7"), "step 0.0000001 makes a table of 3600000001 rows; at most 10^9 are allowed"),
    (("--step", "1e-300"), "step 1e-300 makes a table of 3.6e+302 rows; at most 10^9 are allowed"),
    (("--step", ""), f'step "" {NO_ANGLE}'),
    (("--from", "x"), f'first angle "x" {NO_ANGLE}'),
    (("--to", "nan"), f'last angle "nan" {NO_ANGLE}'),
    (
        ("--from", "20", "--to", "10"),
        "the angles run from 20 to 10; the end must not lie before the start",
    ),
    (("--to", "1e30"), "step 10 makes a table of 1e+29 rows; at most 10^9 are allowed"),
    (
        ("--to", "1e6", "--from", "999999", "--angle", "5"),
        "--angle lists the angles and --from, --to, --step run through them; use one or the other",
    ),
    (
        ("--to", "1000010", "--from", "999990"),
        "an angle is beyond 1000000°; give it within one turn, 0..360",
    ),
    (("--angle", ""), f'angle "" {NO_ANGLE}'),
    (("--angle", "2,3"), 'angle "2,3" can be read as the number 2.3 or the list 2;3; write 2.3 or 2;3'),
    (
        ("--angle", "0..360:1e-6;5"),
        "360000001 angles in a list were given; at most 1000000 are allowed",
    ),
    (
        ("--ratio", "1:3..12", "--step", "1e-6"),
        "10 ratios at 360000001 angles make a table of 3600000010 rows; at most 10^9 are allowed",
    ),
    (
        ("--step", "0.001"),
        "a page of 1080006 numbers is too long; at most 300000 are set, use -f csv or -f json",
    ),
]
CHOICES = [
    (
        ("--layout", "kinematic"),
        f'there is no layout "kinematic" (did you mean kinematics?); choose from {LAYOUTS}',
    ),
    (("--layout", "?"), f'there is no layout "?"; choose from {LAYOUTS}'),
    (("--layout", "turnings"), f'there is no layout "turnings"; choose from {LAYOUTS}'),
    (("--layout", "../base"), f'there is no layout "../base"; choose from {LAYOUTS}'),
    (
        ("-f", "latx"),
        f'there is no format "latx" (did you mean latex?); choose from {", ".join(FORMATS)}',
    ),
    (("-f", ""), f'there is no format ""; choose from {", ".join(FORMATS)}'),
    (("--lang", "fr"), f'there is no language "fr"; choose from {", ".join(LANGUAGES)}'),
    (
        ("--decimal", "komma"),
        'there is no decimal mark "komma" (did you mean comma?); choose from comma, point',
    ),
    (
        ("--rounding", "even"),
        'there is no rounding "even" (did you mean half-even?); choose from half-away, half-even',
    ),
    (
        ("--method", "exakt"),
        'there is no method "exakt" (did you mean exact?); choose from exact, series, infinite',
    ),
    (("--columns", ","), 'columns "," has an empty place; write it as phi,x,c,p'),
    (("--columns", ""), 'columns "" has an empty place; write it as phi,x,c,p'),
    (
        ("--columns", "ratio,phi"),
        "--columns names no quantity; add one, for example --columns phi,x,c,p",
    ),
    (("--columns", "phi,x_mm"), "column x_mm is in mm and needs --stroke"),
    (("--columns", "phi,c_mps"), "column c_mps is in m/s and needs --stroke and --speed"),
    (("--digits", "51"), 'digits "51" cannot be printed; write a whole number from 0 to 50'),
    (("--digits", "-1"), 'digits "-1" cannot be printed; write a whole number from 0 to 50'),
    (("--digits", ""), 'digits "" cannot be printed; write a whole number from 0 to 50'),
    (("--digits", "٣"), 'digits "٣" cannot be printed; write a whole number from 0 to 50'),
    (
        ("--standalone", "-f", "csv"),
        f"--standalone is for latex, html and typst; csv has no documents; {HELP}",
    ),
    (("--longtable", "-f", "html"), f"--longtable is for latex; the format is html; {HELP}"),
    (
        ("--layout", "roetscher-112", "--method", "exact"),
        "layout roetscher-112 states its formulas in its heads and takes no method;"
        " use --layout kinematics to choose one",
    ),
]
DRIVES = [
    (
        ("--offset", "4"),
        "offset e = 4 R is too large for R:L = 1:5; the crank turns only if |e| < L - R = 4 R, for at"
        " φ = 270° the rod stands square to the slide",
    ),
    (
        ("--offset", "-4,5"),
        "offset e = -4.5 R is too large for R:L = 1:5; the crank turns only if |e| < L - R = 4 R, for at"
        " φ = 30° the rod stands square to the slide",
    ),
    (("--offset", "abc"), 'offset "abc" is not a number; write it as 4.5 or 4,5'),
    (
        ("--offset", "5mm"),
        'offset "5mm" is a length, but no length of the crank is known;'
        " add --stroke or give e as a share of R",
    ),
    (
        ("--offset", "0.1", "--method", "series"),
        'method "series" has no formulas for an offset crank; use exact, or leave the offset out',
    ),
    (("--stroke", "3kg"), 'stroke "3kg" is in kilogram; it must be a length such as 600mm'),
    (("--stroke", "600"), 'stroke "600" has no unit; write a length such as 600mm'),
    (("--stroke", ""), 'stroke "" is not a length such as 600mm'),
    (("--stroke", "600mm", "--rod", "200mm"), f"crank ratio R:L is 1.5; {TOO_SHORT}"),
    (
        ("--stroke", "600mm", "--rod", "1.5m", "--ratio", "1:5"),
        "--stroke and --rod already give the ratio; leave --ratio out",
    ),
    (
        ("--stroke", "600mm", "--rod", "2m", "--ratio", "1:5"),
        "--stroke and --rod give the ratio 3:20, and --ratio says 1:5; leave one out",
    ),
    (
        ("--rod", "3m", "--ratio", "1:∞"),
        "--rod gives the rod a length, but ratio 1:∞ asks for an infinite one; leave one out",
    ),
    (
        ("--speed", "120/min"),
        "a speed needs a length to give m/s; add --stroke, for example --stroke 600mm",
    ),
    (
        ("--stroke", "1m", "--speed", "3m"),
        'speed "3m" is in meter; it must be a speed of rotation such as 120/min, 120rpm or 12.5rad/s',
    ),
]
USAGE = [
    (
        ("tabel",),
        f'there is no command "tabel" (did you mean table?); choose from {", ".join(COMMANDS)}',
    ),
    (("",), f'there is no command ""; choose from {", ".join(COMMANDS)}'),
    (("--foo",), 'there is no option "--foo"; see kurbel --help'),
    (("table", "--ratoi", "1:5"), f'there is no option "--ratoi" (did you mean --ratio?); {HELP}'),
    (("table", "1:5"), f'"1:5" stands behind no option; write --ratio 1:5; {HELP}'),
    (("table", "--ratio"), "Option '--ratio' requires an argument"),
    (("layouts", "--lang", "xx"), 'there is no language "xx"; choose from de, en'),
]
# What is given with a file name in place of {}.
OUTPUTS = [
    (
        ("-o=-",),
        'the file to write is called "=-"; write -o - or --output=-, and ./=- for a file of that name',
    ),
    (("-o", ""), f"--output names no file; - is standard output; {HELP}"),
    (("-f", "csv", "-o", ""), f"--output names no file; - is standard output; {HELP}"),
    (
        ("-o", "x.foo"),
        "the file name 'x.foo' names no format;"
        " its suffix must be one of .txt, .md, .tex, .html, .htm, .typ, .rst, .pdf, .xlsx, .ods, .csv, .dat,"
        " .json",
    ),
]


def labelled(cases: list[tuple[tuple[str, ...], str]]) -> list[object]:
    return [pytest.param(words, sentence, id=" ".join(words)) for words, sentence in cases]


@pytest.mark.parametrize(("text", "sentence"), RATIOS)
def test_a_wrong_ratio_is_answered_with_a_sentence(text: str, sentence: str) -> None:
    assert refusal("table", "--ratio", text) == sentence


@pytest.mark.parametrize(("words", "sentence"), labelled(ANGLES + CHOICES + DRIVES + OUTPUTS))
def test_wrong_usage_of_the_table_is_answered_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal("table", *words) == sentence


@pytest.mark.parametrize(("words", "sentence"), labelled(USAGE))
def test_a_wrong_command_or_option_is_answered_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal(*words) == sentence


@pytest.mark.parametrize(
    "words",
    [
        ("table", "--{}"),
        ("table", "{}"),
        ("table", "--machine", "{}"),
        ("table", "-o", "{}/x.csv"),
        ("handbook", "build", "{}"),
        ("inject", "{}.md"),
        ("table", "--caption", "\0{}"),
    ],
)
def test_what_was_typed_is_not_echoed_whole(words: tuple[str, ...]) -> None:
    answer = kurbel(*(word.format("z" * 5000) for word in words))
    assert answer.code in (1, 2)
    assert len(answer.err) < 600
    assert answer.err.count("\n") == 1


def test_an_unknown_column_is_answered_with_the_nearest_and_all_of_the_layout() -> None:
    sentence = refusal("table", "--columns", "phi,x_retrun")
    start = 'there is no column "x_retrun" (did you mean x_return?); choose from '
    assert sentence.startswith(start)
    assert set(sentence.removeprefix(start).split(", ")) == {"ratio", "phi", *registry()}
    assert refusal("table", "--layout", "lueger-kolbenbewegung", "--columns", "pbracket").startswith(
        'there is no column "pbracket" (did you mean p_bracket?); choose from ratio, phi, '
    )


@pytest.mark.parametrize("format_name", FORMATS)
@pytest.mark.parametrize(
    "words",
    [
        ("--ratio", "1:1"),
        ("--columns", "foo"),
        ("--offset", "0.1", "--method", "series"),
        ("--stroke", "3kg"),
    ],
)
def test_nothing_is_written_on_an_error(words: tuple[str, ...], format_name: str, tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_text("as it was")
    for path in (old, new):
        refusal("table", "-f", format_name, *words, "-o", str(path))
    assert [path.name for path in tmp_path.iterdir()] == ["old"]
    assert old.read_text() == "as it was"


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("KURBEL_LANG", "xx", 'there is no language "xx"; choose from de, en'),
        ("KURBEL_FORMAT", "docx", f'there is no format "docx"; choose from {", ".join(FORMATS)}'),
        ("KURBEL_DECIMAL", ".", 'there is no decimal mark "."; choose from comma, point'),
        ("KURBEL_TABLE_RATIO", "1:1", f"crank ratio R:L is 1; {TOO_SHORT}"),
        ("KURBEL_TABLE_STEP", "x", f'step "x" {NO_ANGLE}'),
        ("KURBEL_TABLE_DIGITS", "many", 'digits "many" cannot be printed; write a whole number from 0 to 50'),
        ("KURBEL_TABLE_LAYOUT", "?", f'there is no layout "?"; choose from {LAYOUTS}'),
    ],
)
def test_nonsense_in_the_environment_is_answered_with_a_sentence(
    name: str, value: str, sentence: str
) -> None:
    environment = {name: value}
    assert refusal("table", code=2, **environment) == sentence


def test_a_flag_of_the_environment_is_yes_or_no() -> None:
    assert "'maybe' is not a valid boolean" in refusal("table", KURBEL_TABLE_STANDALONE="maybe")


def test_a_traceback_is_left_to_faults_of_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    def fault(question: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("kurbel.page.build.build", fault)
    with pytest.raises(ZeroDivisionError):
        kurbel("table")


options = st.sampled_from(
    [
        "--ratio",
        "--angle",
        "--from",
        "--to",
        "--step",
        "--columns",
        "--offset",
        "--stroke",
        "--rod",
        "--speed",
        "--layout",
        "-f",
        "--lang",
        "--decimal",
        "--digits",
        "--method",
        "--rounding",
    ]
)
values = st.one_of(
    st.text(st.sampled_from("0123456789.,:;/°'-+e∞ xcpmskg\n"), max_size=10),
    st.sampled_from(
        ["1:5", "0.3", "600mm", "1500mm", "120/min", "x,c", "0..20:10", "series", "csv", "en", "5"]
    ),
)


@settings(deadline=None, max_examples=150)
@given(st.lists(st.tuples(options, values), min_size=1, max_size=3))
def test_whatever_is_typed_is_answered_with_a_table_or_a_sentence(typed: list[tuple[str, str]]) -> None:
    words = [
        f"{option}={value}" if option.startswith("--") else f"{option}{value}" for option, value in typed
    ]
    result = kurbel("table", "--layout", "kinematics", *words, "--digits", "2")
    if result.code == 0:
        assert result.out.endswith("\n")
        assert result.err == ""
    else:
        assert (result.code, result.out, result.err.count("\n")) == (2, "", 1)
        assert result.err.startswith("kurbel: ")


def test_an_offset_crank_has_no_first_order_formulas_and_nobody_is_sent_in_circles() -> None:
    for name in ("roetscher-112", "blau-kolbenwege", "lueger-kolbenbewegung", "verfahren"):
        result = kurbel("table", "--layout", name, "--offset", "0.1")
        assert (result.code, result.out) == (2, "")
        assert result.err == (
            f"kurbel: layout {name} prints first-order formulas, which an offset crank does not have;"
            " use --layout kinematics or leave the offset out\n"
        )


def test_label_with_signs_that_references_do_not_have_is_refused() -> None:
    for command in ("table", "delta"):
        assert refusal(command, "--label", "a}b") == (
            'label "a}b" may have letters, digits and the signs -.: only'
        )
        assert kurbel(command, "--label", "a-b.c:9").code == 0


def test_a_mass_is_no_offset_with_or_without_a_stroke() -> None:
    for words in ((), ("--stroke", "600mm")):
        assert "kilogram" in kurbel("table", "--offset", "3kg", *words).err


def test_a_group_without_a_command_prints_its_help_in_lines() -> None:
    result = kurbel("handbook")
    assert (result.code, result.out) == (2, "")
    assert result.err.startswith("Usage: kurbel handbook [OPTIONS] COMMAND")
    assert "\n  build " in result.err


def _list(count: int, text: str = "{}", first: int = 0) -> str:
    return ";".join(text.format(number) for number in range(first, first + count))


MASSES = "forces --angle=30 --stroke=600mm"
LIMITS = [
    ("table --angle={}", "1000000", "1000000.001", "beyond 1000000°"),
    ("table --angle={}", "-1000000", "-1000000.001", "beyond 1000000°"),
    ("table --angle=30 --ratio=1:{}", "1000000000", "1000000001", "below 1:1000000000"),
    ("table --angle=30 --ratio={}", f"0.{'2' * 58}", f"0.{'2' * 59}", "is not a ratio R:L"),
    ("table --angle={}", f"0.{'2' * 58}", f"0.{'2' * 59}", "is not an angle in degrees"),
    ("table --angle=30 --digits={}", "50", "51", "a whole number from 0 to 50"),
    ("table --angle=30 --caption={}", "x" * 2000, "x" * 2001, "at most 2000 are set"),
    ("table --angle=30 --mechanism=arc --rocker={}", "1000000000", "1000000001", "beyond 1000000000 R"),
    ("table --angle=30 --mechanism=beam --beam={}", "1000000000", "1000000001", "beyond 1000000000 r"),
    ("table --angle=30 --method=series --order={}", "9", "10", "from 1 to 9"),
    (f"{MASSES} --force={{}}N", "1000000000000", "1000000000001", "at most 10^12 N"),
    (f"{MASSES} --force=1N --friction={{}}N", "1000000000000", "1000000000001", "at most 10^12 N"),
    (f"{MASSES} --speed=2/s --reciprocating={{}}kg", "1000000000", "1000000001", "at most 10^9 kg"),
    (
        "inertia --angle=30 --centre=0.6 --gyration=0.3 --stroke=1m --speed=1/s --rod-mass={}kg",
        "1000000000", "1000000001", "at most 10^9 kg",
    ),
    ("forces --angle=30 --eps=4 --bore=1m --pressure={}Pa", "1000000000000", "1000000000001", "10^12 Pa"),
    ("delta --eps={}", "1000000", "1000001", "at most 1000000"),
    ("delta --eps=4 --exponent={}", "10", "10.001", "at most 10,"),
    ("delta --eps=4 --exponent={}", "1.000001", "1.0000009", "nearer to 1 than 10^-6"),
    ("delta --eps=4 --exponent={}", "0.999999", "0.9999991", "nearer to 1 than 10^-6"),
    ("delta --eps=4 --clearance={}", "10", "10.001", "within 0..10,"),
    ("delta --eps=4 --ratio={}", "0.999999999999", "0.9999999999991", "nearer to 1 than 10^-12"),
    ("delta --eps=4 --cranks={}", _list(24), _list(25), "1 to 24 are allowed"),
    ("delta --compression={} --heat=5", "1000", "1000.001", "at most 1000,"),
    ("delta --compression=6 --heat={}", "1000000000", "1000000001", "at most 10^9,"),
    ("delta --pressure-ratio={}", "1000000", "1000001", "at most 1000000"),
    ("delta --pressure-ratio=4 --delivery-loss={}", "10", "10.001", "within 0..10,"),
    ("delta --pressure-ratio=4 --exponent={}", "10", "10.001", "at most 10,"),
    ("delta --pressure-ratio=4 --exponent={}", "1.000001", "1.0000009", "nearer to 1 than 10^-6"),
    ("flywheel --eps=4 --power=5kW --speed=1/s --delta={}", "1.999", "2", "below 2"),
    ("flywheel --eps=4 --power=5kW --speed=1/s --delta={}", "1e-9", "0.9e-9", "at least 10^-9"),
    ("flywheel --eps=4 --power={}W --speed=1/s --delta=0.1", "1000000000000", "1000000000001", "10^12 W"),
    ("harmonics --orders={}", "100", "101", "from 1 to 100"),
    ("balance --engine=inline-4 --orders={}", "100", "101", "from 1 to 100"),
    ("balance --cranks={}", _list(24), _list(25), "an engine has 1 to 24"),
    ("rotor --masses={} --radii=10mm --angles=0", "1000000kg", "1000000.1kg", "at most 1000000 kg"),
    (
        "locomotive --spacing=1m --gauge=1.5m --stroke=1m --reciprocating=9kg --cranks={}",
        _list(8), _list(9), "an axle has 1 to 8",
    ),
    ("turning --torque=sin^{}φ", "20", "21", "from 1 to 20"),
    ("turning --torque=1+sin({}φ)", "200", "201", "an order above 200"),
    ("turning --torque={}", f"{'(' * 30}1+sinφ{')' * 30}", f"{'(' * 31}1+sinφ{')' * 31}", "more than 30 br"),
    ("turning --torque=1+sinφ{}", "+0" * 497, f"{'+0' * 496}+00", "at most 1000 are read"),
    ("turning --areas=1;{}-1 --area-scale=1J", "0;" * 998, "0;" * 999, "at most 1000 are allowed"),
    ("firing --cranks={}", ";".join(["0"] * 14), ";".join(["0"] * 15), "cannot fire at equal intervals"),
    ("plot -o - -f svg --positions={}", _list(36), _list(37), "at most 36"),
    ("plot -o - -f svg --width={}", "1000", "1001", "from 20 to 1000 mm"),
    ("plot -o - -f svg --height={}", "1000", "1001", "from 20 to 1000 mm"),
    ("plot -o - -f svg --columns=x --ratio={}", _list(12, "1:{}", 2), _list(13, "1:{}", 2), "at most 12"),
    ("plot -o - -f svg --positions=0 --animate --seconds={}", "120", "121", "120"),
    ("plot -o - -f svg --columns=x --step=0.1 --to={}", "1999.9", "2000", "at most 20000"),
    ("sweep delta --eps=2;3 -o - -f csv --only=eps<40{}", "+0" * 247, "+0" * 248, "at most 500"),
    ("sweep delta --eps=2;3 -o - -f csv --jobs={}", "1024", "1025", "from 1 to 1024"),
    ("sweep delta --eps=2..3 -o - -f csv --sample=lhs:2 --seed={}", "9999", "10000", "from 0 to 9999"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("words", "most", "beyond", "said"), LIMITS, ids=[f"{one[0]} {one[3]}" for one in LIMITS]
)
def test_a_limit_is_allowed_itself_and_what_is_just_beyond_it_is_refused(
    words: str, most: str, beyond: str, said: str
) -> None:
    assert kurbel(*words.format(most).split()).code == 0
    assert said in refusal(*words.format(beyond).split())
