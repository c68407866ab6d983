"""A list with semicolons stands in quotes wherever it may be copied into a shell, which would end the line
there and print a page without the rest of the list."""

from __future__ import annotations

import re
from collections.abc import Iterator

import click
from places import ROOT, TRANSCRIPTS

from kurbel.cli.app import cli

# What is in quotes already; that of minutes, as in 2°30', begins none.
QUOTED = re.compile(r"""(?<![\w°'])'[^'\n]+'(?![\w'])|(?<!\w)"[^"\n]*"|“[^”]*”""")
LIST = re.compile(r"[^\s;(]+;[^\s;)]+")
# Lines of a shell: those behind a prompt, and those of blocks that are a shell's.
BLOCK = re.compile(r"^```(?P<kind>[\w{}-]*)[^\n]*\n(?P<lines>.*?)^```", re.MULTILINE | re.DOTALL)
SHELL = ("sh", "bash", "shell")
CODE = re.compile(r"`([^`\n]*(?:--[a-z]|kurbel )[^`\n]*)`")


def bare(text: str) -> list[str]:
    """Return the lists of a text that stand in no quotes."""
    return LIST.findall(QUOTED.sub("", text))


def commands(group: click.Group, path: str) -> Iterator[tuple[str, click.Command]]:
    context = click.Context(group)
    for name in group.list_commands(context):
        found = group.get_command(context, name)
        assert found is not None
        yield f"{path} {name}", found
        if isinstance(found, click.Group):
            yield from commands(found, f"{path} {name}")


def test_lists_in_helps_stand_in_quotes() -> None:
    found = {
        (path, text)
        for path, command in commands(cli, "kurbel")
        for text in [command.help or "", *(getattr(one, "help", None) or "" for one in command.params)]
        if bare(text)
    }
    assert not found


def test_lists_in_sentences_stand_in_quotes() -> None:
    found = []
    for path in sorted(TRANSCRIPTS.glob("refused/*.txt")):
        for line in path.read_text(encoding="utf-8").splitlines():
            # The heads of a file that is to be written are for no shell.
            said = line.partition("it starts with its heads")[0]
            if not line.startswith(("$ ", ">>> ", "file ", "    ", "#")) and bare(said):
                found.append(f"{path.stem}: {line}")
    assert not found, "\n".join(found)


def test_lists_in_lines_of_a_shell_stand_in_quotes() -> None:
    pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").rglob("*.md")]
    found = []
    for page in pages:
        text = page.read_text(encoding="utf-8")
        lines = [one[1] for one in CODE.finditer(text)]
        for block in BLOCK.finditer(text):
            own = block["lines"].replace("\\\n", " ").splitlines()
            prompted = [line[2:] for line in own if line.startswith("$ ")]
            lines += own if block["kind"] in SHELL else prompted
        found += [f"{page.relative_to(ROOT)}: {line}" for line in lines if bare(line)]
    assert not found, "\n".join(found)
