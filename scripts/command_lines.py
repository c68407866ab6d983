"""The command lines of scripts/corpus: those written there, some put together at random, and every option
of a command beside each of its cases.

A line in a *.txt is a command line without `kurbel`, as typed into a shell, perhaps behind variables of the
environment; ` && ` joins several. {a|b} stands for one line each, {name} for the alternatives of a line
`name := a|b` above it. ␊, ␍, ␛ and ␡ are a line end, a carriage return, an escape and the byte 0xff, which is
no UTF-8. `cp`, `ln`, `rm`, `mkdir` and `write FILE TEXT` do what they say.

All of them run in one folder, which begins as scripts/corpus/files. What they write into its folder `out` is
recorded; what a line names there is put there before, where files/given has it. Lines that begin with # are
comments.
"""

from __future__ import annotations

import re
import shlex
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

CORPUS = Path(__file__).parent / "corpus"
_CHOICE = re.compile(r"\{([^{}]*)\}")
_VARIABLE = re.compile(r"(_?[A-Z][A-Z_]*)=(.*)", re.DOTALL)
_PICTURES = str.maketrans("␊␍␛␡", "\n\r\x1b\udcff")
# What may stand anywhere in a value.
_LETTERS = "0123456789.,:;/°'-+e∞% xcpmskgabn"


class Command(NamedTuple):
    """The words behind `kurbel`, and the variables that are set for them."""

    words: tuple[str, ...]
    environment: Mapping[str, str]


def command_lines() -> list[str]:
    """Return every command line once, in the order of the files."""
    lines = [line for path in sorted(CORPUS.glob("*.txt")) for line in lines_of(path)]
    with (CORPUS / "random.toml").open("rb") as file:
        lines += [line for name, one in tomllib.load(file).items() for line in random_lines(name, one)]
    with (CORPUS / "pairs.toml").open("rb") as file:
        lines += paired_lines(**tomllib.load(file))
    return list(dict.fromkeys(lines))


def paired_lines(cases: Mapping[str, Sequence[str]], values: Mapping[str, str]) -> Iterator[str]:
    """Yield each case of a command with each of the command's options that it has not, one at a time."""
    from kurbel.cli.app import command_of

    for name, beginnings in cases.items():
        options = [one for one in command_of(name).params if one.opts[-1].startswith("--")]
        for beginning in beginnings:
            for one in options:
                flag, key = one.opts[-1], one.opts[-1][2:].replace("-", "_")
                value = "" if getattr(one, "is_flag", False) else values.get(key)
                if value is not None and f"{flag} " not in f"{beginning} ":
                    yield f"{name} {beginning} {flag}{f'={shlex.quote(value)}' if value else ''}"


def lines_of(path: Path) -> Iterator[str]:
    """Yield the command lines of a file, each alternative by itself."""
    names: dict[str, Sequence[str]] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, given, alternatives = line.partition(" := ")
        if given:
            names[name] = [one for text in alternatives.split("|") for one in expanded(text, names)]
        else:
            yield from expanded(line, names)


def expanded(line: str, names: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """Yield the line with each choice of its alternatives."""
    pieces = _CHOICE.split(line)
    choices = [
        [piece] if not place % 2 else piece.split("|") if "|" in piece else names.get(piece, [f"{{{piece}}}"])
        for place, piece in enumerate(pieces)
    ]
    for chosen in product(*choices):
        yield "".join(chosen)


def commands_of(line: str) -> Iterator[Command]:
    """Yield the commands that a line joins."""
    for text in line.split(" && "):
        words = [word.translate(_PICTURES) for word in shlex.split(text)]
        environment: dict[str, str] = {}
        while words and (match := _VARIABLE.fullmatch(words[0])):
            environment[match[1]] = match[2]
            words = words[1:]
        yield Command(tuple(words), environment)


def random_lines(name: str, one: Mapping[str, Any]) -> Iterator[str]:
    """Yield as many lines as the entry says: its start with one to `most` of its options."""
    random = Random(name)
    options: Mapping[str, Sequence[str]] = one["options"]
    for _ in range(one["lines"]):
        chosen = random.choices(list(options), k=random.randint(1, one["most"]))
        words = [value_of(option, random.choice([*options[option], "?"]), random) for option in chosen]
        yield f"{one['start']} {shlex.join(filter(None, words))}"


def value_of(option: str, value: str, random: Random) -> str:
    """Return an option with its value; "?" is any text, and an option without values a flag."""
    if option.endswith("!"):
        return option[:-1]
    if value == "?":
        value = "".join(random.choices(_LETTERS, k=random.randint(0, 8)))
    return f"{option}={value}"
