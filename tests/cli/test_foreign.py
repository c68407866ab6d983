"""Options and commands as others call them: each word of the table leads to what it stands for."""

from __future__ import annotations

import click
import pytest
from cli import refusal

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.reading import foreign
from kurbel.reading.notation import in_shell


def flags(command: str) -> set[str]:
    return {
        flag.removeprefix("--")
        for one in command_of(command).params
        if isinstance(one, click.Option)
        for flag in one.opts
    }


HAVE = {name: flags(name) for name in COMMANDS}


@pytest.mark.parametrize("row", foreign.OPTIONS, ids=lambda row: f"{row.option}-{row.words.split()[0]}")
def test_every_word_leads_to_the_option_in_a_command_that_has_it(row: foreign.Alias) -> None:
    for word in row.words.split():
        flag = f"--{word.replace('_', '-')}"
        # Gas engines have a --cut-off, which is refused beside steam where it is read.
        if word == "cut_off":
            continue
        value = "25%" if "cutoff" in row.words and row.option == "eps" else row.example
        line = f"write --{row.option} {in_shell(row.example)};"
        having = [
            name for name, own in HAVE.items() if row.option in own and word.replace("_", "-") not in own
        ]
        assert any(line in refusal(name, flag, value) for name in having), (flag, having)


def test_a_bare_number_gets_the_unit_of_the_option_and_another_keeps_its_own() -> None:
    assert "write --speed 120rpm" in refusal("table", "--rpm", "120")
    assert "write --speed 2/s" in refusal("table", "--rpm=2/s")
    # Cut off after three eighths, steam expands to 8/3 of its volume.
    assert "write --eps 8/3" in refusal("delta", "--cutoff", "3/8")
    assert "write --cut-off 2" in refusal("delta", "--cutoff", "2")


@pytest.mark.parametrize("name", foreign.COMMANDS)
def test_every_word_for_a_command_leads_to_it(name: str) -> None:
    for word in foreign.COMMANDS[name].split():
        assert refusal(word).endswith(f'"{word}"; write kurbel {name}'), word
