"""The help: options in sections, no line wider than a terminal, and the way to a page in English."""

from __future__ import annotations

import shlex
import sys
from collections import Counter
from unittest import mock

import click
import pytest
from cli import kurbel, printed
from programs import Programs
from terminals import own_terminal, shown

from kurbel.cli import COMMANDS, GROUPS, LANGUAGES
from kurbel.cli.app import command_of, run
from kurbel.cli.manual.help import folded
from kurbel.cli.manual.sections import LEADING, SECTIONS, names, sections
from kurbel.cli.tables import MakingCommand

PRINTING = [name for name in COMMANDS if isinstance(command_of(name), MakingCommand)]


def options_of(name: str) -> Counter[str]:
    command = command_of(name)
    listed = command.get_params(click.Context(command))
    return Counter(max(one.opts, key=len) for one in listed if isinstance(one, click.Option))


@pytest.mark.parametrize("name", PRINTING)
def test_every_option_stands_in_one_section(name: str) -> None:
    listed = Counter(max(one.opts, key=len) for _, found in sections(command_of(name)) for one in found)
    assert listed == options_of(name)
    help_text = printed(name, "--help").out
    assert [help_text.count(f"\n{title}:\n") for title, _ in sections(command_of(name))] == [
        1 for _ in sections(command_of(name))
    ]


def test_no_section_names_an_option_that_there_is_not() -> None:
    for title in SECTIONS:
        there = {name.lstrip("-").replace("-", "_") for one in PRINTING for name in options_of(one)}
        named = {own for one in PRINTING for own in names(title, one)}
        assert named <= there, title
    assert set(LEADING.values()) <= set(SECTIONS)
    assert set(LEADING) <= set(PRINTING)


def test_every_command_stands_in_one_group() -> None:
    assert Counter(name for listed in GROUPS.values() for name in listed) == Counter([*COMMANDS])


@pytest.mark.parametrize("words", [(), ("handbook",), ("inject",), *((name,) for name in PRINTING)])
def test_help_is_no_wider_than_a_terminal(words: tuple[str, ...]) -> None:
    lines = printed(*words, "--help", COLUMNS="200").out.splitlines()
    assert max(map(len, lines)) <= 80
    # A page in another language is three lines away.
    if words not in (("handbook",), ("inject",)):
        assert any(LANGUAGES in line for line in lines)


@pytest.mark.parametrize("width", [50, 76, 200])
def test_a_folded_example_is_the_same_for_the_shell(width: int) -> None:
    for name in PRINTING:
        help_text = command_of(name).help or ""
        examples = [line for line in help_text.splitlines() if line.startswith("kurbel ")]
        assert examples, name
        for example in examples:
            shortened = folded(example, width)
            assert shlex.split(shortened.replace("\\\n", "")) == shlex.split(example)
            assert width < 76 or max(map(len, shortened.splitlines())) <= width


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
    with (
        own_terminal(80, 500, **settings) as end,
        mock.patch.object(sys, "argv", ["kurbel", *words]),
        mock.patch.object(sys, "stderr", sys.stdout),
    ):
        assert run() == (0, "")
        there = end()
    assert there.endswith(HINT) is hinted
    assert ("English" in there) is hinted


def test_the_hint_is_for_terminals_alone(programs: Programs) -> None:
    assert shown(programs, *PAGE)[0].endswith(HINT)
    # Errors go into a pipe, and what reads it is no reader.
    assert kurbel(*PAGE).err == ""
    with own_terminal(80, 500, LANG="en_GB"):
        assert kurbel(*PAGE).err == ""


def test_the_bytes_of_a_page_do_not_depend_on_the_locale() -> None:
    assert printed(*PAGE, LANG="en_GB.UTF-8").out == printed(*PAGE, LANG="de_DE.UTF-8").out
