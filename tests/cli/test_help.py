"""The help and the scripts of shells, and the way to a page in English.

What shells are offered stands in tests/transcripts/printed/completion.txt.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import click
import pytest
from cli import kurbel, printed
from completion import COMMANDS, EVERY, GROUPS, PRINTING, described
from places import CARDS, ROOT
from programs import Programs
from terminals import own_terminal, shown
from tools import require

from kurbel import __version__ as kurbel_version
from kurbel.cli.app import command_of, run
from kurbel.cli.manual import topics

ALONE = [words for words in EVERY if words[0] not in GROUPS]
# Commands that print no table of a machine, but have topics.
OF_TOPICS = (
    *(words for words in EVERY if words[0] in ("collate", "example", "plot", "construct")),
    *(words for words in EVERY if words[0] == "sweep" and len(words) == 2),
)
WITH_TOPICS = [*((one,) for one in PRINTING), *OF_TOPICS]
# Without which these print no page.
NEEDED = {
    "inertia": "--centre 0.6 --gyration 0.3",
    "solve": "--where p=0",
    "turning": "--eps 4",
    "pressures": "--eps 4 --bore 300mm --pressure 8bar",
    "flywheel": "--power 50kW --speed 120/min --delta 1:100 --eps 4",
}
SCHEMAS = {
    "machine.toml": "commands/machine.schema.json",
    "layout.toml": "page/layout.schema.json",
    "sweep.toml": "sweeps/sweep.schema.json",
    "handbook.toml": "handbook/handbook.schema.json",
}
LISTS = (("sources",), ("layouts",), ("quantities",))
ENGLISH = "Pages are in German; in English with --lang en, or KURBEL_LANG=en for all."


@pytest.mark.parametrize("words", EVERY, ids=" ".join)
def test_the_help_has_every_option_once_and_is_no_wider_than_a_terminal(words: tuple[str, ...]) -> None:
    text = printed(*words, "--help", COLUMNS="200").out
    assert max(map(len, text.splitlines())) <= 80
    listed = re.findall(r"^  (?:-\w, )?(--[\w-]+)", text[text.index(":\n  ") :], re.MULTILINE)
    assert sorted(listed) == sorted(described(*words, "--"))
    # Where an example prints a page, one in another language is three lines away.
    assert (ENGLISH in text) == (words[-1] in (*PRINTING, "collate", "example", "plot", "construct"))


def listed_topics(*words: str) -> list[str]:
    """Return the topics that the short help of a command names."""
    text = printed(*words, "-h").out
    return text[text.index("\nTopics:") : text.index("\nMore:")].split()[1:]


@pytest.mark.parametrize("words", EVERY, ids=" ".join)
def test_the_short_help_fits_a_screen(words: tuple[str, ...]) -> None:
    lines = printed(*words, "-h", COLUMNS="200").out.splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 80
    # What stands there is an option of the command.
    first = re.findall(r"^  (?:-\w, )?(--[\w-]+)", "\n".join(lines), re.MULTILINE)
    assert {*first} <= {*described(*words, "--")}
    assert len(first) <= 15


def test_kurbel_itself_fits_a_screen_and_names_every_command() -> None:
    text = printed("-h").out
    assert len(text.splitlines()) <= 40
    groups = re.findall(r"^[A-Z][a-z ]+: +(\w.*)$", text.partition("\n")[2], re.MULTILINE)
    assert sorted(" ".join(groups).split()) == sorted(COMMANDS)
    assert printed("--no-pager", "-h").out == text
    alone = kurbel()
    assert (alone.code, alone.out, alone.err) == (2, "", text)


def test_who_looks_at_a_command_first_takes_no_option_from_it() -> None:
    assert topics.options_of(click.Command("new"))["help"].opts == ["-h", "--help"]


@pytest.mark.parametrize("words", WITH_TOPICS, ids=" ".join)
def test_every_option_stands_in_one_topic(words: tuple[str, ...]) -> None:
    listed = listed_topics(*words)
    assert len(listed) == len({*listed})
    assert not {*listed} & {*COMMANDS}
    found = []
    for topic in listed:
        text = printed(*words, "--help", topic, COLUMNS="200").out
        assert max(map(len, text.splitlines())) <= 80
        head = text.partition("\n\n")[0]
        found += re.findall(r"^  (?:-\w, )?(--[\w-]+)", head, re.MULTILINE)
    # `help` finds a topic for every command in one way.
    assert printed("help", *words, listed[-1], COLUMNS="200").out == text
    assert sorted(found) == sorted(described(*words, "--"))


def test_no_table_of_the_help_names_an_option_that_is_none() -> None:
    known = {words: {one[2:].replace("-", "_") for one in described(*words, "--")} for words in WITH_TOPICS}
    every = {name for names in known.values() for name in names}
    for topic in topics.TOPICS:
        for name in f"{topic.leading} {topic.also}".split():
            assert name.rpartition(".")[2] in every, (topic.name, name)
    for (name, *below), names in known.items():
        assert below or {*vars(command_of(name))["in_short"].split()} <= names, name
    for name in (*topics.SHORTER, *topics.DEFAULTS):
        assert name.rpartition(".")[2] in every, name


def lines_of(text: str) -> list[list[str]]:
    """Return the words of the examples in a help, without what stands beside them."""
    whole = re.sub(r" \\\n +", " ", text)
    return [
        shlex.split(line.partition("   ")[0])
        for line in re.findall(r"^  (kurbel .*)$", whole, re.MULTILINE)
        if not line.startswith("kurbel help") and not line.endswith(" -h")
    ]


@pytest.fixture
def examples(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work in a folder that has the examples, and the files that lines of the help name."""
    monkeypatch.chdir(shutil.copytree(ROOT / "examples", tmp_path / "examples"))
    shutil.rmtree("appendix")
    shutil.copy(CARDS / "ideal-2.csv", "card.csv")
    Path("notes.md").write_text("<!-- kurbel: table --ratio 1:5 -->\n<!-- /kurbel -->\n")
    Path("rod.csv").write_text("from [mm];to [mm];mass [kg]\n-120;140;17\n140;1350;24\n1350;1580;9\n")
    Path("scan.csv").write_text("phi;p\n0;1,250\n60;0,375\n90;-0,250\n180;-0,750\n")


def check_lines(lines: list[list[str]], *begin: str) -> None:
    for name, *words in lines:
        assert (name, *words[: len(begin)]) == ("kurbel", *begin)
        result = kurbel(*words)
        assert result.code == 0, (words, result.err)


@pytest.mark.parametrize("words", WITH_TOPICS, ids=" ".join)
def test_the_examples_of_the_short_help_run(words: tuple[str, ...], examples: None) -> None:
    first, *others = lines_of(printed(*words, "-h").out.partition("\nFirst:")[0])
    if words[0] == "sweep" and words[-1] != "table":
        # How much and how long is told of every sweep in one way.
        assert others == [[*first, "--dry-run"]]
        others = []
    check_lines([first, *others], *words)


@pytest.mark.parametrize("name", [name for name in PRINTING if "[1:5]" in printed(name, "-h").out])
def test_the_ratio_that_the_short_help_names_is_that_of_a_page(name: str) -> None:
    line = (name, *NEEDED.get(name, "").split())
    assert printed(*line).out == printed(*line, "--ratio", "1:5").out


TOPICS = [(*words, topic) for words in WITH_TOPICS for topic in listed_topics(*words)]


@pytest.mark.slow
@pytest.mark.parametrize("words", TOPICS, ids=" ".join)
def test_the_example_of_a_topic_runs_and_shows_it(words: tuple[str, ...], examples: None) -> None:
    *command, topic = words
    text = printed(*command, "--help", topic).out
    lines = lines_of(text)
    check_lines(lines, *command)
    for line in lines:
        flags = {one.partition("=")[0] for one in line if one.startswith("-")}
        short = {"--output"} if "-o" in flags else set()
        assert (flags | short) & {*re.findall(r"--[\w-]+", text.partition("\n\n")[0])} or "?" in line


WANTS = re.findall(r"^  (\w+)  ", printed("help").out.partition("\nMore:")[0], re.MULTILINE)


@pytest.mark.parametrize("want", WANTS)
def test_what_one_wants_is_done_by_lines_that_run(want: str, examples: None) -> None:
    text = printed("help", want).out
    assert want not in COMMANDS
    assert max(map(len, text.splitlines())) <= 80
    assert len(lines_of(text)) >= 1
    if want == "book":
        shutil.rmtree("appendix", ignore_errors=True)
    check_lines(lines_of(text.partition("\nMore:")[0]))
    for page in re.findall(r"kurbel help (\w+/[\w-]+)", text):
        assert printed("help", page).out == (ROOT / "docs" / f"{page}.md").read_text("utf-8").rstrip() + "\n"


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("pressure", ["--pressure", "mean_pressure", "kurbel pressures -h"]),
        ("rpm", ["--speed"]),
        ("RPM", ["kurbel table --help crank"]),
        ("4-bar linkage", ["kurbel help linkage"]),
        ("slider-crank", ["kurbel table -h", "kurbel help motion"]),
        ("coefficient of fluctuation of speed", ["--delta"]),
        ("cutoff", ["--eps"]),
        ("turning moment", ["kurbel help diagram", "kurbel turning -h"]),
        ("Drehmoment", ["torque"]),
        ("excel", ["kurbel help howto/spreadsheets"]),
        ("roetscher-112", ["roetscher-112"]),
        ("Walzwerk", ["kurbel help load-over-three-turns"]),
        ("velocity diagram", ["kurbel construct velocity"]),
        ("air delivered per minute", ["kurbel help air-compressor"]),
    ],
)
def test_a_search_finds_what_others_call_otherwise(words: str, found: list[str]) -> None:
    text = printed("help", "--search", words).out
    for one in found:
        assert re.search(rf"^ +{re.escape(one)}", text, re.MULTILINE), text
    assert max(map(len, text.splitlines())) <= 80


TEN = (ROOT / "docs" / "howto" / "problem-to-command.md").read_text(encoding="utf-8")
WAYS = re.findall(
    r"^\*\*`([\w-]+)`\*\*: [^$]*?\sTyped: ([^$]*)\n```console\n\$ kurbel (.*)$", TEN, re.MULTILINE
)


def read_toml(file: Path) -> dict[str, Any]:
    return tomllib.loads(file.read_text(encoding="utf-8"))


@pytest.mark.parametrize(("problem", "way", "line"), WAYS, ids=[name for name, *_ in WAYS])
def test_a_problem_of_a_textbook_is_found_from_help_alone(problem: str, way: str, line: str) -> None:
    """Each page that is asked for names the next one's command, and together they have every option; the
    line is that of the problem, but for columns and format."""
    files = (ROOT / "examples" / "problems").glob("*.toml")
    runs = {one["name"]: one["run"] for file in files for one in read_toml(file).get("problem", [])}
    name, *rest = shlex.split(runs[problem])
    text = printed("help").out
    for step in re.findall(r"`kurbel ([^`]+)`", way):
        word = step.removeprefix("help ").split()[0]
        assert re.search(rf"\b{word}\b", text) or "--search" in step, step
        text += printed(*step.split()).out
    assert f"kurbel {name}" in text
    flags = {one.partition("=")[0] for one in rest if one.startswith("--")}
    assert {one for one in shlex.split(line) if one.startswith("--")} | {"--columns"} == flags | {"--columns"}
    assert f"\n  kurbel {name} " in printed("help", problem).out
    assert flags <= {*re.findall(r"--[\w-]+", text)}


def test_ten_problems_are_found_on_a_short_page() -> None:
    assert len(WAYS) == 10
    assert len(TEN.splitlines()) <= 130


def test_help_goes_through_the_pager(programs: Programs) -> None:
    seen = "sed s/^/paged:/"
    for words in (("--help",), ("forces", "--help"), ("forces", "--help", "masses"), ("help", "steam")):
        text, code = shown(programs, *words, lines=20, PAGER=seen)
        assert code == 0
        assert all(line.startswith("paged:") for line in text.splitlines()), words
    assert "paged:" not in shown(programs, "--no-pager", "forces", "--help", lines=20, PAGER=seen)[0]
    assert "paged:" not in shown(programs, "forces", "-h", lines=41, PAGER=seen)[0]


def test_the_help_names_every_command_once() -> None:
    assert printed("--version").out == printed("version").out == f"kurbel {kurbel_version}\n"
    listed = re.findall(r"^  (\w+)  ", printed("--help").out, re.MULTILINE)
    assert sorted(listed) == sorted(COMMANDS)


@pytest.mark.parametrize("words", ALONE, ids=" ".join)
def test_a_folded_example_is_the_same_for_the_shell(words: tuple[str, ...]) -> None:
    def examples(width: int) -> list[list[str]]:
        text = printed(*words, "--help", COLUMNS=str(width)).out
        lines = text.replace("\\\n", " ").splitlines()
        return [shlex.split(line) for line in lines if line.startswith("  kurbel ")]

    assert examples(50) == examples(80)
    assert examples(50) or words in LISTS


def test_an_example_that_fills_a_line_is_not_folded() -> None:
    example = "  kurbel forces --eps 4 --bore 300mm --pressure 8bar"
    # The last two columns of a screen stay free.
    assert example in printed("forces", "--help", COLUMNS=str(len(example) + 2)).out.splitlines()


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_every_shell_gets_its_script(shell: str) -> None:
    script = printed(_KURBEL_COMPLETE=f"{shell}_source").out
    assert f"_KURBEL_COMPLETE={shell}_complete" in script
    assert "python" not in script
    if shutil.which(shell):
        subprocess.run([shell, "-n"], input=script, text=True, check=True, capture_output=True)


def test_fish_itself_completes() -> None:
    lines = {
        "kurbel table --layout roetscher-1": "roetscher-112",
        "kurbel table --columns phi,x,psi_": "phi,x,psi_return",
        "kurbel table -f mark": "markdown",
    }
    asked = "; ".join(f"complete -C '{line}'" for line in lines)
    script = f"_KURBEL_COMPLETE=fish_source kurbel | source; {asked}"
    environment = {name: value for name, value in os.environ.items() if "KURBEL" not in name}
    environment["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), environment["PATH"]])
    fish = [require("fish"), "--no-config", "-c", script]
    run = subprocess.run(fish, check=True, capture_output=True, text=True, env=environment)
    assert run.stdout.split() == [*lines.values()]


HINT = "kurbel: English: --lang en, or KURBEL_LANG=en for all; KURBEL_LANG=de ends this\n"
PAGE = ("table", "--angle", "0")


@pytest.mark.parametrize(
    ("words", "settings", "hinted"),
    [
        (PAGE, {"LANG": "en_GB.UTF-8"}, True),
        (("sources",), {"LANG": "C"}, True),
        (PAGE, {}, True),
        (PAGE, {"LC_ALL": "fr_FR", "LANG": "de_DE.UTF-8"}, True),
        (PAGE, {"LC_ALL": "", "LC_MESSAGES": "de_AT", "LANG": "en_US"}, False),
        (PAGE, {"LANG": "en_GB", "KURBEL_LANG": "de"}, False),
        (PAGE, {"LANG": "en_GB", "KURBEL_TABLE_LANG": "de"}, False),
        ((*PAGE, "--lang", "de"), {"LANG": "en_GB"}, False),
        # Its keys are the same in every language.
        ((*PAGE, "-f", "csv"), {"LANG": "en_GB"}, False),
    ],
)
def test_an_english_reader_is_told_of_english_after_a_german_page(
    words: tuple[str, ...], settings: dict[str, str], hinted: bool
) -> None:
    with own_terminal(80, 500, **settings) as end:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(sys, "argv", ["kurbel", *words])
            patch.setattr(sys, "stderr", sys.stdout)
            assert run() == (0, "")
        there = end()
    assert there.endswith(HINT) is hinted
    assert ("English" in there) is hinted


def test_the_hint_is_for_terminals_alone(programs: Programs) -> None:
    assert shown(programs, *PAGE)[0].endswith(HINT)
    # Errors go into a pipe, and what reads it is no reader.
    with own_terminal(80, 500, LANG="en_GB"):
        assert kurbel(*PAGE).err == ""
    assert printed(*PAGE, LANG="en_GB.UTF-8").out == printed(*PAGE, LANG="de_DE.UTF-8").out
