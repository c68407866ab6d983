"""The manual pages of the commands and of the files that they read, out of the program itself."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from importlib.resources import files
from typing import Any, NamedTuple

import click

from kurbel.cli import COMMANDS, GROUPS, LANGUAGES, SUMMARY, VARIABLES
from kurbel.cli.app import HELP_OPTIONS, command_of
from kurbel.cli.manual import roff
from kurbel.cli.manual.help import folded
from kurbel.cli.manual.topics import topics_of
from kurbel.cli.tables import MakingCommand

WIDTH = 68
CODES = (
    ("0", "Done."),
    ("1", "Failed, or with --check and --strict something is stale or deviates; one sentence says what."),
    ("2", "Wrong usage."),
)
# The JSON Schemas of the files, what the files are, and the command that takes them.
FILES = {
    "machine.toml": ("drive/machine.schema.json", "a machine, for --machine of every command", "forces"),
    "layout.toml": ("page/layout.schema.json", "a page layout of one's own, for --layouts", "layouts"),
    "sweep.toml": ("sweeps/sweep.schema.json", "a sweep, for kurbel sweep", "sweep"),
    "handbook.toml": ("handbook/handbook.schema.json", "the manifest of a handbook", "handbook"),
}


class Page(NamedTuple):
    """A manual page: its name and section, and what makes it."""

    name: str
    section: int
    lines: Callable[[], Iterator[str]]

    @property
    def file(self) -> str:
        return f"man{self.section}/{self.name}.{self.section}"

    def text(self) -> bytes:
        return roff.whole(self.lines())


def pages() -> Mapping[str, Page]:
    """Return the pages by what one asks for: kurbel, table, handbook-build, handbook.toml."""
    found = {"kurbel": Page("kurbel", 1, _kurbel)}
    for name, (_, line) in COMMANDS.items():
        command = command_of(name)
        found[name] = Page(f"kurbel-{name}", 1, partial(_command, command, f"kurbel {name}", line))
        if isinstance(command, click.Group):
            for one, inner in command.commands.items():
                line = inner.get_short_help_str(WIDTH)
                path = f"kurbel {name} {one}"
                found[f"{name}-{one}"] = Page(f"kurbel-{name}-{one}", 1, partial(_command, inner, path, line))
    for name in FILES:
        found[name] = Page(f"kurbel-{name}", 5, partial(_file, name))
    return found


def _kurbel() -> Iterator[str]:
    yield from roff.title("kurbel", 1, "certified tables of the crank drive")
    yield from roff.heading("Synopsis")
    yield f"{roff.bold('kurbel')} {roff.italic('COMMAND')} [{roff.italic('OPTIONS')}]"
    yield from roff.heading("Description")
    yield from roff.paragraph(SUMMARY)
    yield from roff.paragraph(LANGUAGES)
    yield from roff.heading("Commands")
    for title, names in GROUPS.items():
        yield from roff.section(title)
        for name in names:
            yield from roff.entry(_reference(f"kurbel-{name}", 1), COMMANDS[name][1])
    yield from roff.heading("Environment")
    yield from roff.paragraph(VARIABLES)
    yield from _end([f"kurbel-{name}(5)" for name in FILES])


def _command(command: click.Command, path: str, line: str) -> Iterator[str]:
    context = click.Context(command, info_name=path, terminal_width=WIDTH)
    context.help_option_names = HELP_OPTIONS
    yield from roff.title(path.replace(" ", "-"), 1, line[:1].lower() + line[1:].rstrip("."))
    yield from roff.heading("Synopsis")
    pieces = (roff.italic(piece) for piece in command.collect_usage_pieces(context))
    yield " ".join((roff.bold(path), *pieces))
    yield from roff.heading("Description")
    is_making = isinstance(command, MakingCommand)
    yield from _described(
        inspect.cleandoc(command.help or "").partition("\f")[0], LANGUAGES if is_making else ""
    )
    if isinstance(command, click.Group) and command.commands:
        yield from roff.heading("Commands")
        for name, inner in command.commands.items():
            reference = _reference(f"{path} {name}".replace(" ", "-"), 1)
            yield from roff.entry(reference, inner.get_short_help_str(WIDTH))
    yield from roff.heading("Options")
    if is_making:
        for topic, options in topics_of(command):
            yield from roff.section(topic.title)
            for option in options:
                yield from _option(option, context)
    else:
        for one in command.get_params(context):
            if isinstance(one, click.Option):
                yield from _option(one, context)
        for title, options in _further(command).items():
            yield from roff.section(title)
            for option in options:
                yield from _option(option, context)
    if is_making:
        yield from roff.heading("Environment")
        yield from roff.paragraph(VARIABLES)
    yield from _end(["kurbel(1)"])


def _further(command: click.Command) -> Mapping[str, Sequence[click.Option]]:
    """Return the options that all commands of a group have, where it says so."""
    return command.further() if hasattr(command, "further") else {}


def _described(text: str, more: str) -> Iterator[str]:
    """Yield the paragraphs of a help, and its examples under a head of their own."""
    examples = []
    for block in text.split("\n\n"):
        lines = block.split("\n")
        if lines[0] != "\b":
            yield from roff.paragraph(block)
        elif lines[1].startswith("kurbel "):
            examples += lines[1:]
        else:
            yield from roff.verbatim(lines[1:])
    if more:
        yield from roff.paragraph(more)
    if examples:
        yield from roff.heading("Examples")
        yield from roff.verbatim(folded("\n".join(examples), WIDTH).split("\n"))


def _option(option: click.Option, context: click.Context) -> Iterator[str]:
    if record := option.get_help_record(context):
        written, said = record
        words = (roff.bold(one) if one.startswith("-") else roff.italic(one) for one in written.split(" "))
        yield from roff.entry(" ".join(words), said)


def _reference(name: str, number: int) -> str:
    return f"{roff.bold(name)}({number})"


def _end(others: list[str]) -> Iterator[str]:
    yield from roff.heading("Exit status")
    for code, said in CODES:
        yield from roff.entry(roff.bold(code), said)
    yield from roff.heading("See also")
    pairs = (one.removesuffix(")").split("(") for one in others)
    yield ", ".join(_reference(name, int(number)) for name, number in pairs)


def _file(name: str) -> Iterator[str]:
    place, line, command = FILES[name]
    schema = json.loads(files("kurbel").joinpath(place).read_text(encoding="utf-8"))
    yield from roff.title(f"kurbel-{name}", 5, line)
    yield from roff.heading("Description")
    yield from roff.paragraph(
        f"A file in TOML with these keys; another key, or a value of another type, is an error with its line"
        f" and the nearest key. The package has its JSON Schema, kurbel/{place}, for editors."
    )
    yield from roff.heading("Keys")
    yield from _keys(schema, "")
    yield from _end([f"kurbel-{command}(1)", "kurbel(1)"])


def _keys(schema: Mapping[str, Any], path: str) -> Iterator[str]:
    """Yield the keys of a section, and then the sections in it."""
    inner = []
    for key, one in schema.get("properties", {}).items():
        shape = one.get("items", {})
        if key != "defaults" and "properties" in one:
            inner.append((f"[{path}{key}]", one, f"{path}{key}."))
        elif "properties" in shape:
            inner.append((f"[[{path}{key}]]", shape, f"{path}{key}."))
        else:
            yield from roff.entry(roff.bold(key), _said(one))
    for head, section, below in inner:
        yield from roff.section(head)
        yield from _keys(section, below)


def _said(value: Mapping[str, Any]) -> str:
    """Return what a key is, and what it may be."""
    several = value.get("items", {}).get("enum")
    allowed = several or value.get("enum") or ()
    parts = [value.get("description", "")]
    if len(allowed) > 1 and not all(str(one) in parts[0] for one in allowed):
        parts.append(f"{'some' if several else 'one'} of {', '.join(map(str, allowed))}")
    return "; ".join(filter(None, parts)) + "."
