"""A machine in a TOML file gives the options of every command."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import printed, records, refusal
from completion import PRINTING
from places import CARDS

from kurbel.cli.app import command_of
from kurbel.cli.tables import TableCommand
from kurbel.commands.machine_file import machine_keys

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
    (tmp_path / "machine.toml").write_text('[crank]\nstroke = "crank:300mm"\n', encoding="utf-8")
    by_stroke = printed(*words.split(), "--stroke", "600mm").out
    assert by_stroke == printed(*words.split(), "--stroke", "crank:3/10 m").out
    assert by_stroke == printed(*words.split(), "--machine", str(tmp_path / "machine.toml")).out


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
    ("lengths", "typed", "ratio", "radius"),
    [
        ('ratio = "1:5"\nstroke = "600mm"', "--ratio 1:4", "1:4", "300"),
        ('ratio = "1:5"\nrod = "1500mm"', "--ratio 1:4", "1:4", "375"),
        ('ratio = "1:5"\nrod = "1500mm"', "--stroke 500mm", "1:6", "250"),
        ('stroke = "600mm"\nrod = "1500mm"', "--stroke 500mm", "1:6", "250"),
        ('stroke = "600mm"\nrod = "1500mm"', "--rod 1200mm", "1:4", "300"),
        ('stroke = "600mm"\nrod = "1500mm"', "--ratio 1:4 --rod 1000mm", "1:4", "250"),
        ('ratio = "1:5"\nstroke = "600mm"\nrod = "1500mm"', "--rod 1800mm", "1:6", "300"),
        ('ratio = "1:3"\nrod = "1m"', "", "1:3", "1000/3"),
        ('stroke = "600mm"\nrod = "135cm"', "", "1:4.5", "300"),
    ],
)
def test_a_typed_length_outdoes_that_of_the_file_and_leaves_the_others(
    lengths: str, typed: str, ratio: str, radius: str, tmp_path: Path
) -> None:
    path = tmp_path / "engine.toml"
    more = '[steam]\neps = 4\nbore = "300mm"\npressure = "8bar"\n[masses]\nreciprocating = "90kg"\n'
    path.write_text(f'[crank]\n{lengths}\nspeed = "2/s"\n{more}', encoding="utf-8")
    machine = ("--machine", str(path), *typed.split())
    crank = ("--ratio", ratio, "--stroke", f"crank:{radius} mm", "--speed", "2/s")
    engine = ("--eps", "4", "--bore", "300mm", "--pressure", "8bar", "--reciprocating", "90kg")
    pages = ((("table", "--angle=70", "--columns=ratio,x_mm"), ()), (("forces", "--step=50"), engine))
    for words, given in (*pages, (("delta",), engine)):
        assert records(*words, *machine, "--digits=9") == records(*words, *crank, *given, "--digits=9")


def test_files_lie_beside_the_machine(tmp_path: Path) -> None:
    (tmp_path / "rod.csv").write_text("position,mass\n0,60kg\n0.5,30kg\n1,60kg\n", encoding="utf-8")
    (tmp_path / "card.csv").write_bytes((CARDS / "ideal-2.csv").read_bytes())
    path = tmp_path / "engine.toml"
    path.write_text('[steam]\ncard = "card.csv"\n', encoding="utf-8")
    shown = printed("delta", "--machine", str(path)).out
    assert shown == printed("delta", "--card", str(tmp_path / "card.csv")).out
    words = ("forces", "--angle", "20;130", "--digits", "0", "-f", "csv")
    texts = [MACHINE.replace("[masses]", '[masses]\nfile = "rod.csv"'), MACHINE]
    typed = ("--centre", "0.5", "--gyration", str((0.2) ** 0.5), "--rod-mass", "150kg")
    pages = []
    for text, more in zip(texts, ((), typed), strict=True):
        path.write_text(text, encoding="utf-8")
        pages.append(printed(*words, "--machine", str(path), *more).out)
    assert pages[0] == pages[1]


def test_an_offset_is_read_and_so_is_a_mark_before_the_text(tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_bytes(b"\xef\xbb\xbf" + b'[crank]\noffset = "0.2"\n[steam]\neps = 4\n')
    for command in ("delta", "turning", "forces"):
        typed = printed(command, "--offset", "0.2", "--eps", "4").out
        assert printed(command, "--machine", str(path)).out == typed
    assert printed("table", "--machine", str(path)).out == printed("table", "--offset", "0.2").out


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (b"\xff", "line 1: the byte 0xff is not UTF-8; save the machine so"),
        (
            b"[crank]\nstroke = %d" % 2**3999,
            f"line 2: stroke is {str(2**3999)[:40]}; it must be text such as",
        ),
        (
            b"[crank]\nstroke = %d" % 2**4000,
            "line 2: stroke is a number of very many digits; it must be text",
        ),
        (b"a." * 199 + b"a = 1", 'there is no section "a"'),
        (b"a." * 200 + b"a = 1", "has a key of very many parts; a machine has sections with entries"),
        (b"[crank]\nratio = " + b"[" * 5000, "is nested too deeply; a machine has sections with entries"),
        (b"#" * 20_001, "has more than 20000 bytes"),
    ],
)
def test_a_huge_or_damaged_file_is_answered_with_its_name(text: bytes, sentence: str, tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_bytes(text)
    said = refusal("delta", "--machine", str(path), code=1)
    assert sentence in said
    assert str(path) in said


def test_a_machine_of_the_greatest_size_is_read(tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_bytes(b"[steam]\neps = 4\n" + b"#" * 19_984)
    assert path.stat().st_size == 20_000
    assert printed("delta", "--machine", str(path)).out == printed("delta", "--eps", "4").out


@pytest.mark.parametrize("name", PRINTING)
def test_every_option_that_is_declared_for_the_file_stands_there(name: str) -> None:
    command = command_of(name)
    assert isinstance(command, TableCommand)
    known = {(home, one.name) for home, keys in machine_keys().items() for one in keys.values()}
    for option in command.made_by.options.values():
        homes = {place.partition(".")[0] for place in option.machine.split()}
        assert {(home, option.name) for home in homes} <= known
