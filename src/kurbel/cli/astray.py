"""What was typed at the wrong place: an option twice, or a value without its option.

Loaded where that is found.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import click

from kurbel.cli import COMMANDS
from kurbel.commands.options import Choice, Columns, Kind, LayoutName
from kurbel.errors import KurbelError
from kurbel.reading import notation
from kurbel.reading.unit_text import plain_unit

# What has methods side by side, by the command.
SIDE_BY_SIDE = {
    "table": "--layout verfahren prints exact and series side by side, and --ratio '1:5;1:∞' the infinite rod"
    " beside another",
    "forces": "--layout forces-verfahren prints exact and series side by side",
    "plot": "--infinite draws the infinite rod beside the other",
}
# What options say of themselves to commands that have them not: to one, or to all others.
ELSEWHERE = {
    ("", "--order"): "series of higher order are those of kurbel table, plot and solve, and elsewhere"
    " --method series is of first order",
    ("turning", "--over"): "--layout turning-path has the tangential force over the developed crank circle",
    ("pressures", "--over"): "pressures stand over the stroke by themselves, at --shares of it",
    ("inertia", "--over"): "forces over the path, those of masses too, are of kurbel forces",
    ("solve", "--over"): 'kurbel table has --over path, and here --where "s = 25%" is a share of the stroke',
}
_LONGEST = 60
_NUMBER = re.compile(r"[+−-]?\d[\d.,/]*")


def twice(flag: str, values: Iterable[Any], command: str | None) -> str:
    """Return the sentence that refuses an option which takes one value and was given several."""
    listed = " and as ".join(str(value)[:_LONGEST] for value in values)
    hint = SIDE_BY_SIDE.get(command or "") if flag == "--method" else None
    return f"{flag} is given as {listed}, and takes one value{f'; {hint}' if hint else ''}"


def elsewhere(command: str, flag: str) -> str:
    """Return what an option says to a command that has it not, after a semicolon, nothing if none."""
    found = ELSEWHERE.get((command.rpartition(" ")[2], flag)) or ELSEWHERE.get(("", flag))
    return f"; {found}" if found else ""


def before_command(words: Sequence[str]) -> str:
    """Return the line with its options behind the command, nothing where no command is named."""
    from shlex import join

    place = next((place for place, word in enumerate(words) if word in COMMANDS), None)
    if place is None:
        return ""
    return join(["kurbel", *words[place:], *words[:place]])


def stray(text: str, command: click.Command, words: Sequence[str]) -> str:
    """Return the sentence that refuses one of the words, which has no option, with what is likely meant: an
    option, or quotes about a value with a space."""
    if parted := _parted(text, words):
        return f"{notation.quoted(text)} stands behind no option; a value with a space needs quotes: {parted}"
    options = {one.name or "": one for one in command.params if isinstance(one, click.Option)}
    shown = notation.quoted(text)
    name = next((name for name in _names(text, options) if name in options), "")
    if not name:
        return f"{shown} stands behind no option, and kurbel {command.name} needs no such word"
    return f"{shown} stands behind no option; write {long_flag(options[name])} {_as_typed(text)}"


def _parted(text: str, words: Sequence[str]) -> str:
    """Return the value in quotes of which the word before is the first part: '600 mm', 'x, c'."""
    place = [*words].index(text) if text in words else 0
    before = words[place - 1] if place > 1 else ""
    first = before.rpartition("=")[2]
    if first.endswith((",", ";")) or (_NUMBER.fullmatch(first) and plain_unit(text)):
        return _as_typed(f"{first} {text}")
    return ""


def long_flag(option: click.Option) -> str:
    return next(one for one in option.opts if one.startswith("--"))


def command_for(text: str) -> str:
    """Return the command of a value in place of a command, nothing if none is likely."""
    if _reads(notation.ratios, [text]) and any(mark in text for mark in ":∶"):
        return f"kurbel table --ratio {_as_typed(text)}"
    if _is_condition(text):
        return f"kurbel solve --ratio 1:5 --where {_as_typed(text)}"
    return ""


def _names(text: str, options: Mapping[str, click.Option]) -> Iterable[str]:
    """Yield the names of the options that the value can be for, the likeliest first."""
    from kurbel.formats.registry import FORMATS
    from kurbel.reading import units

    if text.lower().endswith(".toml"):
        yield "machine"
    if any(text.lower().endswith(suffix) for one in FORMATS.values() for suffix in one.suffixes):
        yield from ("output", "card")
    if _is_condition(text):
        yield "where"
    for name in ("lang", "format", "method", "mechanism", "quantity", "engine", "layout", "columns"):
        if name in options and _knows(getattr(options[name].type, "kind", None), text):
            yield name
    if ":" in text and ".." not in text and _reads(notation.ratios, [text]):
        yield "ratio"
    if _reads(notation.ratios, [text]) and text.lstrip().startswith("1:"):
        yield "ratio"
    if ".." in text and _reads(notation.angles, [text]):
        yield "angle"
    for name, read in (("speed", units.speed), ("stroke", _length), ("force", _force)):
        if units.is_measure(text) and _reads(read, text):
            yield name


def _knows(kind: Kind | None, text: str) -> bool:
    """Whether the value is one of those that an option of a few knows."""
    if isinstance(kind, Columns):
        return all(part in {*kind.offered(part, {})} for part in text.split(",") if part) and text != ""
    return isinstance(kind, Choice | LayoutName) and _reads(lambda one: kind.read(one, {}), text)


def _is_condition(text: str) -> bool:
    left, equals, right = text.partition("=")
    return bool(left.strip() and equals and right.strip()) and not text.startswith("-")


def _length(text: str) -> Any:
    from kurbel.reading import units

    return units.length(text, "stroke")


def _force(text: str) -> Any:
    from kurbel.reading import units

    return units.force(text)


def _reads(read: Callable[[Any], Any], text: str | Sequence[str]) -> bool:
    try:
        read(text)
    except KurbelError:
        return False
    return True


def _as_typed(text: str) -> str:
    from shlex import quote

    return quote(text) if len(text) <= _LONGEST else "VALUE"
