"""A machine in a TOML file gives the options of every command."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import printed, refusal
from places import CARDS

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.drive.machine import read_machine
from kurbel.drive.sections import SECTIONS
from kurbel.errors import MachineError

MACHINE = """
[crank]
ratio = "1:4,5"
stroke = "600mm"
speed = "120/min"

[steam]
eps = [3, 4.5]
back = "10%"
bore = "300mm"
pressure = "8bar"

[masses]
reciprocating = "300kg"

[flywheel]
delta = ["1:100", 0.02]
"""
TYPED = (
    "--ratio 1:4,5 --eps 3;4.5 --back 0.1 --bore 300mm --pressure 8bar --reciprocating 300kg --stroke 600mm"
)


@pytest.fixture
def machine(tmp_path: Path) -> str:
    path = tmp_path / "engine.toml"
    path.write_text(MACHINE, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize(
    ("command", "typed"),
    [
        ("delta", f"{TYPED} --speed 120/min"),
        ("turning --step 60", f"{TYPED} --speed 120/min"),
        ("flywheel", f"{TYPED} --speed 120/min --delta 1:100;1:50"),
        ("table --angle 0;60", "--ratio 1:4,5 --stroke 600mm --speed 120/min"),
        ("forces --angle 0;60", f"{TYPED} --speed 120/min"),
        ("forces --at tangent", "--ratio 1:4,5 --stroke 600mm"),
        ("inertia --centre 0.6 --gyration 0.3", "--ratio 1:4,5 --stroke 600mm --speed 120/min"),
        ("harmonics", "--ratio 1:4,5"),
        ("balance", "--ratio 1:4,5 --reciprocating 300kg --stroke 600mm --speed 120/min"),
    ],
)
def test_the_file_says_what_could_be_typed(command: str, typed: str, machine: str) -> None:
    words = (*command.split(), "-f", "csv")
    assert printed(*words, "--machine", machine).out == printed(*words, *typed.split()).out


def test_what_is_typed_outdoes_the_file(machine: str) -> None:
    shown = printed("delta", "--machine", machine, "--eps", "6", "-f", "csv")
    assert [record["epsilon"] for record in shown.records()] == ["6"]


@pytest.mark.parametrize(
    "words",
    [
        "table --angle 60 --rod 1500mm --speed 120/min",
        "forces --ratio 1:5 --force 10kN --angle 60",
        "deadcentres --rod 1500mm --offset 200mm --speed 2/s",
        "delta --ratio 1:5 --eps 4 --reciprocating 300kg --speed 120/min --bore 300mm --pressure 8bar",
        "solve --rod 1500mm --speed 120/min --where c=max",
        "balance --reciprocating 2kg --speed 3000/min",
        "harmonics --rod 1500mm",
    ],
)
def test_a_crank_radius_is_half_a_stroke_wherever_one_is_given(words: str, tmp_path: Path) -> None:
    (tmp_path / "machine.toml").write_text('[crank]\nradius = "300mm"\n', encoding="utf-8")
    by_stroke = printed(*words.split(), "--stroke", "600mm").out
    assert by_stroke == printed(*words.split(), "--crank", "300mm").out
    assert by_stroke == printed(*words.split(), "--crank", "3/10 m", "--stroke", "60cm").out
    assert by_stroke == printed(*words.split(), "--machine", str(tmp_path / "machine.toml")).out


def test_a_crank_and_a_stroke_that_contradict_each_other_are_both_named(tmp_path: Path) -> None:
    contradiction = "the stroke 2R is 500mm and the crank R is 300mm, which makes a stroke of 600mm;"
    assert contradiction in refusal("table", "--rod", "1m", "--crank", "300mm", "--stroke", "500mm")
    (tmp_path / "machine.toml").write_text('[crank]\nradius = "300mm"\nstroke = "500mm"', encoding="utf-8")
    assert contradiction in refusal("table", "--machine", str(tmp_path / "machine.toml"), code=1)
    cylinder = "crank=300mm stroke=500mm bore=300mm pressure=8bar"
    assert contradiction in refusal("delta", "--eps", "4", "--cylinder", cylinder)


# 300 mm to 1350 mm.
NINE = ("--ratio", "1:4,5", "--stroke", "600mm")


@pytest.mark.parametrize(
    "lengths",
    [
        ('ratio = "1:4,5"', 'rod = "1350mm"'),
        ('stroke = "600mm"', 'rod = "135cm"'),
        ("ratio = 0.2222", 'stroke = "600mm"'),
    ],
)
def test_two_lengths_of_the_crank_are_enough(lengths: tuple[str, str], tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    text = MACHINE.replace('ratio = "1:4,5"\nstroke = "600mm"', "\n".join(lengths))
    assert text != MACHINE
    path.write_text(text, encoding="utf-8")
    for command in ("delta", "forces", "table"):
        found = printed(command, "--machine", str(path), "-f", "csv").records()
        typed = printed(command, "--machine", str(path), *NINE, "-f", "csv").records()
        if "rod" in lengths[1]:
            assert found == typed
        else:
            assert found != typed


@pytest.mark.parametrize(
    ("lengths", "typed", "ratio", "radius"),
    [
        ('ratio = "1:5"\nstroke = "600mm"', ("--ratio", "1:4"), "1:4", "300"),
        ('ratio = "1:5"\nrod = "1500mm"', ("--ratio", "1:4"), "1:4", "375"),
        ('ratio = "1:5"\nrod = "1500mm"', ("--stroke", "500mm"), "1:6", "250"),
        ('stroke = "600mm"\nrod = "1500mm"', ("--stroke", "500mm"), "1:6", "250"),
        ('stroke = "600mm"\nrod = "1500mm"', ("--rod", "1200mm"), "1:4", "300"),
        ('stroke = "600mm"\nrod = "1500mm"', ("--ratio", "1:4", "--rod", "1000mm"), "1:4", "250"),
        ('ratio = "1:5"\nstroke = "600mm"\nrod = "1500mm"', ("--rod", "1800mm"), "1:6", "300"),
        ('ratio = "1:3"\nrod = "1m"', (), "1:3", "333.333333333333"),
    ],
)
def test_a_typed_length_outdoes_that_of_the_file_and_leaves_the_others(
    lengths: str, typed: tuple[str, ...], ratio: str, radius: str, tmp_path: Path
) -> None:
    path = tmp_path / "engine.toml"
    path.write_text(f"[crank]\n{lengths}\n[steam]\neps = 4\nbore = 0.3\n".replace("0.3", '"300mm"')
                    + 'pressure = "8bar"\n[masses]\nreciprocating = "1kg"\n', encoding="utf-8")  # fmt: skip
    words = ("--machine", str(path), *typed, "-f", "csv", "--digits", "9")
    columns = ("--columns", "ratio,x_mm", "--angle", "180")
    (record,) = printed("table", *words, *columns).records()
    assert record["ratio"] == ratio
    assert abs(float(record["x_mm"]) - 2 * float(radius)) < 1e-8
    (engine,) = printed("forces", *words, "--columns", "ratio,torque_nm", "--angle", "70",
                        "--speed", "1e-9/s").records()  # fmt: skip
    steam = ("--eps=4", "--bore=300mm", "--pressure=8bar")
    (alike,) = printed("forces", *steam, f"--ratio={ratio}", "--angle=70",
                       "--columns=tangential_force_n", "-f", "csv", "--digits=9").records()  # fmt: skip
    assert engine["ratio"] == ratio
    assert abs(float(engine["torque_nm"]) / float(alike["tangential_force_n"]) - float(radius) / 1000) < 1e-12


@pytest.mark.parametrize(
    ("lengths", "typed", "sentence"),
    [
        (
            'stroke = "1m"\nrod = "2m"\nratio = "1:5"',
            (),
            "stroke 1m and rod 2m give R:L = 1:4, and the ratio is 1:5; leave one of the three out",
        ),
        (
            'stroke = "1m"\nrod = "2m"',
            ("--ratio", "1:3"),
            "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod as well",
        ),
    ],
)
def test_lengths_that_contradict_each_other_are_refused(
    lengths: str, typed: tuple[str, ...], sentence: str, tmp_path: Path
) -> None:
    path = tmp_path / "engine.toml"
    path.write_text(f"[crank]\n{lengths}\n", encoding="utf-8")
    for command in ("table", "delta", "inertia --centre 0.5 --gyration 0.3"):
        assert refusal(*command.split(), "--machine", str(path), *typed) == sentence


def test_a_rod_file_outdoes_the_centre_of_the_machine(machine: str, tmp_path: Path) -> None:
    rod = tmp_path / "rod.csv"
    rod.write_text("position,mass\n0,60kg\n0.5,30kg\n1,60kg\n", encoding="utf-8")
    heavy = tmp_path / "heavy.toml"
    given = '[masses]\nrod = "9kg"\ncentre = 0.3\ngyration = 0.3'
    heavy.write_text(MACHINE.replace("[masses]", given), encoding="utf-8")
    words = ("forces", "--rod-file", str(rod), "--angle", "50", "-f", "csv")
    assert printed(*words, "--machine", str(heavy)).out == printed(*words, "--machine", machine).out


def test_a_typed_force_outdoes_the_steam_of_the_machine(machine: str) -> None:
    shown = printed("forces", "--machine", machine, "--force", "1kN", "--angle", "50", "-f", "csv").out
    typed = ("--ratio=1:4,5", "--stroke=600mm", "--speed=120/min", "--reciprocating=300kg")
    assert shown == printed("forces", *typed, "--force=1kN", "--angle=50", "-f", "csv").out
    assert printed("forces", "--machine", machine, "--layout", "forces", "--angle", "50", "-f", "csv").out


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("", "the machine's file has no name; give one, such as --machine engine.toml"),
        (".", "cannot read the machine .: it is a directory or a device; name a TOML file"),
        ("/dev/zero", "cannot read the machine /dev/zero: it is a directory or a device; name a TOML file"),
    ],
)
def test_what_is_no_file_is_answered_with_a_sentence(name: str, sentence: str) -> None:
    assert refusal("delta", "--machine", name, code=1) == sentence


def test_a_mark_before_the_text_is_read_over(machine: str, tmp_path: Path) -> None:
    marked = tmp_path / "marked.toml"
    marked.write_bytes(b"\xef\xbb\xbf" + MACHINE.encode())
    assert printed("delta", "--machine", str(marked)).out == printed("delta", "--machine", machine).out


def test_an_offset_is_read_but_where_the_crank_is_taken_for_straight(tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_text('[crank]\noffset = "0.2"\n[steam]\neps = 4\n', encoding="utf-8")
    for command in ("balance",):
        assert refusal(command, "--machine", str(path), code=1).endswith(
            f"crank.offset is 0.2, and kurbel {command} is about the straight crank;"
            " leave the offset out of the machine"
        )
    for command in ("delta", "turning", "forces"):
        typed = printed(command, "--offset", "0.2", "--eps", "4").out
        assert printed(command, "--machine", str(path)).out == typed
    assert printed("table", "--machine", str(path)).out == printed("table", "--offset", "0.2").out


def test_a_rod_in_a_file_lies_beside_the_machine(tmp_path: Path) -> None:
    (tmp_path / "rod.csv").write_text("position,mass\n0,60kg\n0.5,30kg\n1,60kg\n", encoding="utf-8")
    path = tmp_path / "engine.toml"
    path.write_text(MACHINE.replace("[masses]", '[masses]\nfile = "rod.csv"'), encoding="utf-8")
    typed = ("--centre", "0.5", "--gyration", str((0.2) ** 0.5), "--rod-mass", "150kg")
    words = ("forces", "--angle", "20;130", "--digits", "0", "-f", "csv")
    plain = tmp_path / "plain.toml"
    plain.write_text(MACHINE, encoding="utf-8")
    assert printed(*words, "--machine", str(path)).out == printed(*words, "--machine", str(plain), *typed).out


def test_a_card_lies_beside_the_file(tmp_path: Path) -> None:
    card = CARDS / "ideal-2.csv"
    (tmp_path / "card.csv").write_bytes(card.read_bytes())
    path = tmp_path / "engine.toml"
    path.write_text('[steam]\ncard = "card.csv"\n', encoding="utf-8")
    shown = printed("delta", "--machine", str(path), "-f", "csv").out
    assert shown == printed("delta", "--card", str(tmp_path / "card.csv"), "-f", "csv").out


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("[stem]\neps = 3", 'there is no section "stem" (did you mean steam?); choose from'),
        ("[steam]\nepz = 3", 'there is no entry of [steam], "epz" (did you mean eps?); choose from'),
        ("steam = 3", "steam is 3; it must be a section, [steam]"),
        ("[steam]\nsingle_acting = 1", "steam.single_acting is 1; it must be true or false"),
        ("[steam]\neps = {}", 'steam.eps is a table; it must be text such as "600mm", a number or a list'),
        ("[steam]\neps = []", 'steam.eps is an empty list; it must be text such as "600mm"'),
        ("[steam]\neps = true", 'steam.eps is true; it must be text such as "600mm", a number or a list'),
        ("[steam\neps = 3", "(at line 1, column 7)"),
        ("\udcff", "line 1: the byte 0xff is not UTF-8; save the machine so"),
        ('ratio = "1:5"', "ratio stands outside of the sections; write it under [crank]"),
        ('[crank]\nstroke = ["1m", "2m"]', "crank.stroke is a list; it must be one value"),
        ("[crank]\nstroke = 1979-05-27", "crank.stroke is 1979-05-27; it must be text such as"),
        (f"[crank]\nstroke = {2**3999}", f"crank.stroke is {str(2**3999)[:40]}; it must be text such as"),
        (
            f"[crank]\nstroke = {2**4000}",
            "crank.stroke is a number of very many digits; it must be text such",
        ),
        (f"{'a.' * 199}a = 1", 'there is no section "a"'),
        (f"{'a.' * 200}a = 1", "has a key of very many parts; a machine has sections with entries"),
        ("[crank]\nratio = " + "[" * 5000, "is nested too deeply; a machine has sections with entries"),
    ],
)
def test_a_file_that_is_no_machine_is_answered_with_a_sentence(
    text: str, sentence: str, tmp_path: Path
) -> None:
    path = tmp_path / "engine.toml"
    path.write_bytes(text.encode(errors="surrogateescape"))
    said = refusal("delta", "--machine", str(path), code=1)
    assert sentence in said
    assert str(path) in said


def test_a_missing_file_is_answered_with_a_sentence() -> None:
    assert refusal("delta", "--machine", "nowhere.toml", code=1) == (
        "cannot read the machine nowhere.toml: there is no such file"
    )


def test_every_entry_is_an_option_of_some_command() -> None:
    options = set()
    for name in COMMANDS:
        options |= {parameter.name for parameter in command_of(name).params}
    assert {option for section in SECTIONS.values() for option in section.__struct_fields__} <= options


def test_a_huge_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "huge.toml"
    path.write_bytes(b"#" * 20_000)
    read_machine(str(path))
    path.write_bytes(b"#" * 20_001)
    with pytest.raises(MachineError, match="has more than 20000 bytes"):
        read_machine(str(path))
