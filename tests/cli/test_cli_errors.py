"""Bad input: one sentence, no file, the right exit code. The sentences stand in tests/transcripts/refused."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest
from cli import answered, kurbel, printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st


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


def test_signs_that_a_terminal_obeys_are_shown_as_they_are_written() -> None:
    assert refusal("table", "--ratio", "1\n:5\x1b[31m").startswith('crank ratio "1\\n:5\\x1b[31m" is not a')


# One that makes its file at the end, two that stream, and two of bytes.
@pytest.mark.parametrize("format_name", ["text", "csv", "json", "pdf", "xlsx"])
def test_nothing_is_written_on_an_error(format_name: str, tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_text("as it was")
    for words in ("--ratio 1:1", "--columns foo", "--offset 0.1 --method series", "--stroke 3kg"):
        for path in (old, new):
            refusal("table", "-f", format_name, *words.split(), "-o", str(path))
    assert [path.name for path in tmp_path.iterdir()] == ["old"]
    assert old.read_text() == "as it was"


def test_what_says_nothing_is_refused_if_it_was_typed_and_gives_way_if_it_serves_many(tmp_path: Path) -> None:
    machine = tmp_path / "engine.toml"
    machine.write_text('[steam]\nbore = "300mm"\n')
    bare = ("forces", "--ratio", "1:5", "--angle", "30")
    assert refusal(*bare, "--bore", "300mm").startswith("--bore is for the steam of an engine")
    assert printed(*bare, KURBEL_FORCES_BORE="300mm") == printed(*bare)
    assert printed(*bare, "--machine", str(machine)) == printed(*bare)


def test_a_traceback_is_left_to_faults_of_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    def fault(question: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("kurbel.page.build.build", fault)
    with pytest.raises(ZeroDivisionError):
        kurbel("table")


WORDS = ["1:5", "0.3", "600mm", "1500mm", "120/min", "x,c", "0..20:10", "series", "csv", "en", "5"]
NUMBERS = st.text(st.sampled_from("0123456789.,:;/°'-+e∞ xcpmskg\n"), max_size=10) | st.sampled_from(WORDS)
OPTIONS = (
    *("ratio", "angle", "from", "to", "step", "columns", "offset", "stroke", "rod", "speed", "layout"),
    *("format", "lang", "decimal", "digits", "method", "rounding"),
)


@settings(max_examples=100)
@given(
    st.lists(st.tuples(st.sampled_from(OPTIONS), NUMBERS | st.sampled_from(WORDS)), min_size=1, max_size=3)
)
def test_whatever_is_typed_is_answered_with_a_table_or_a_sentence(typed: list[tuple[str, str]]) -> None:
    words = [f"--{option}={value}" for option, value in typed]
    answered("table", "--layout", "kinematics", *words, "--digits", "2")


def _list(count: int, text: str = "{}", first: int = 0) -> str:
    return ";".join(text.format(number) for number in range(first, first + count))


MASSES = "forces --angle=30 --stroke=600mm"
TINY = f"0.{'2' * 58}"


# What lies just beyond each stands in tests/transcripts/refused.
@pytest.mark.parametrize(
    "words",
    [
        "table --angle=-1000000;1000000",
        f"table --angle={TINY} --ratio={TINY}",
        "table --angle=30 --ratio=1:1000000000",
        "table --angle=30 --digits=50",
        f"table --angle=30 --caption={'x' * 2000}",
        "table --angle=30 --mechanism=arc --rocker=1000000000",
        "table --angle=30 --mechanism=beam --beam=1000000000",
        "table --angle=30 --method=series --order=9",
        f"{MASSES} --force=1000000000000N",
        f"{MASSES} --force=1N --friction=1000000000000N",
        f"{MASSES} --speed=2/s --reciprocating=1000000000kg",
        "inertia --angle=30 --centre=0.6 --gyration=0.3 --stroke=1m --speed=1/s --rod-mass=1000000000kg",
        "forces --angle=30 --eps=4 --bore=1m --pressure=1000000000000Pa",
        "delta --eps=1000000",
        "delta --eps=4 --exponent=10 --clearance=10",
        "delta --eps=4 --exponent=1.000001",
        "delta --eps=4 --exponent=0.999999",
        "delta --eps=4 --ratio=0.999999999999",
        f"delta --eps=4 --cranks={_list(24)}",
        "delta --compression=1000 --heat=1000000000",
        "delta --pressure-ratio=1000000",
        "delta --pressure-ratio=4 --delivery-loss=10 --exponent=10",
        "delta --pressure-ratio=4 --exponent=1.000001",
        "flywheel --eps=4 --power=1000000000000W --speed=1/s --delta=1e-9;1.999",
        "harmonics --orders=100",
        f"balance --cranks={_list(24)}",
        "balance --engine=inline-4 --orders=100",
        "rotor --masses=1000000kg --radii=10mm --angles=0",
        f"locomotive --spacing=1m --gauge=1.5m --stroke=1m --reciprocating=9kg --cranks={_list(8)}",
        "turning --torque=sin^20φ",
        "turning --torque=1+sin(200φ)",
        f"turning --torque={'(' * 30}1+sinφ{')' * 30}",
        f"turning --torque=1+sinφ{'+0' * 497}",
        f"turning --areas=1;{'0;' * 998}-1 --area-scale=1J",
        f"firing --cranks={';'.join('0' * 14)} -f csv",
        f"plot -o - -f svg --positions={_list(36)}",
        f"table -o - -f svg --columns=x --width=1000 --height=1000 --ratio={_list(12, '1:{}', 2)}",
        "plot -o - -f svg --positions=0 --animate --seconds=120",
        "table -o - -f svg --columns=x --step=0.1 --to=1999.9",
        f"sweep delta --eps=2;3 -o - -f csv --only=eps<40{'+0' * 247}",
        "sweep delta --eps=2 -o - -f csv --jobs=1024",
        "sweep delta --eps=2..3 -o - -f csv --sample=lhs:2 --seed=9999",
    ],
    ids=lambda words: words[:60],
)
def test_a_limit_is_allowed_itself(words: str) -> None:
    assert kurbel(*words.split()).code == 0


def test_a_list_of_several_options_stays_one_and_the_same_twice_is_once() -> None:
    line = "table --angle=30 -f csv "
    twice = printed(*f"{line} --ratio=1:4 --ratio=1:5 --columns=x --columns=c --lang=en --lang=EN".split())
    assert twice.out == printed(*f"{line} --ratio=1:4;1:5 --columns=x,c --lang=en".split()).out


@pytest.mark.parametrize(
    "line",
    [
        *(
            "example blau 33 --ratio 1:5",
            "solve --where v=max",
            "balance --engine V8",
            "table --lang English",
        ),
        *("harmonics --quantity velocity", "forces --force 10kN"),
    ],
)
def test_the_option_that_a_value_astray_is_told_takes_it(line: str) -> None:
    assert kurbel(*line.split(), "-f", "csv").code == 0


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("forces --at tangent --cylinder eps=4", "--cylinder does not go with --at tangent"),
        ("forces --eps 4 --cylinder eps=3", "--eps says nothing about the cylinders, each of which has"),
        ("solve --unknown speed --angle 30 --where crosshead_load=0 --stroke 600mm --force 10kN"
         " --reciprocating 200kg --order 3", "--order says nothing on this page; leave it out"),
        ("table --zero 30 -o x.svg", "--zero is for pages, and svg is a drawing; leave it out"),
        ("table -f drawing -o x.docx", "a drawing is no docx; name a file such as -o kurbel.svg"),
        ("sweep rotor --strict -o x.csv", "--masses is missing, without which there is nothing to compute"),
        ("sweep locomotive --spacing 0.7m -o x.csv", "--gauge is missing"),
    ],
)  # fmt: skip
def test_what_is_typed_in_vain_is_refused(line: str, sentence: str) -> None:
    found = kurbel(*shlex.split(line))
    assert found.code == 2
    assert sentence in found.err


@pytest.mark.parametrize("form", ["svg", "drawing"])
def test_a_drawing_by_the_environment_is_for_pages_that_have_one(form: str) -> None:
    assert "Reihenmotor" in printed("firing", "--engine", "inline-4", KURBEL_FORMAT=form).out
    assert printed("table", "--columns", "x", KURBEL_FORMAT=form).out.startswith("<?xml")
    assert printed("construct", "klein", KURBEL_FORMAT=form).out.startswith("<?xml")
