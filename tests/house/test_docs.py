"""The pages of the documentation: what they link to is there, and the reference leaves no option out."""

from __future__ import annotations

import re
import runpy
from collections.abc import Iterator

import click
from places import ROOT

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of

DOCS = ROOT / "docs"
REFERENCE = DOCS / "generate" / "reference.py"


def options(command: click.Command) -> Iterator[tuple[str, str]]:
    """Every command that has no commands of its own, with its options."""
    if isinstance(command, click.Group):
        for inner in command.commands.values():
            yield from options(inner)
    for parameter in command.params:
        if isinstance(parameter, click.Option) and not parameter.hidden:
            yield str(command.name), parameter.opts[-1]


def test_the_reference_describes_every_option_of_every_command() -> None:
    sections = runpy.run_path(str(REFERENCE))["reference"]().split("\n### kurbel ")
    described = {section.split("\n")[0]: section for section in sections[1:]}
    assert described.keys() >= set(COMMANDS)
    for name in COMMANDS:
        for one, option in options(command_of(name)):
            assert re.search(rf"^ +(-\w, )?{option}\b", described[name], re.MULTILINE), (name, one, option)
