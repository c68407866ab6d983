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
from pathlib import Path

import pytest
from cli import kurbel, printed
from completion import COMMANDS, EVERY, GROUPS, PRINTING, described
from programs import Programs
from terminals import own_terminal, shown
from tools import require

from kurbel import __version__ as kurbel_version
from kurbel.cli.app import run

ALONE = [words for words in EVERY if words[0] not in GROUPS]
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


def test_the_help_names_every_command_once() -> None:
    assert printed("--version").out == f"kurbel {kurbel_version}\n"
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
