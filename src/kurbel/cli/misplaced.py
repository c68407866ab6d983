"""What was typed at the wrong place: an option twice, a value without its option, and what click refuses.

Loaded where that is found.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import chain
from shlex import join
from typing import TypeVar

import click

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.manual.topics import topics_of
from kurbel.commands.options import Choice, Columns, Kind, LayoutName
from kurbel.errors import KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.reading import notation, units
from kurbel.reading.amounts import plain_unit
from kurbel.reading.foreign import command, line, ours
from kurbel.reading.names import did_you_mean, enumerated

# What has methods side by side, by the command.
SIDE_BY_SIDE = {
    "table": "--layout verfahren prints exact and series side by side, and --ratio '1:5;1:∞' the infinite rod"
    " beside another",
    "forces": "--layout forces-verfahren prints exact and series side by side",
}
# What options say of themselves to commands that have them not: to one, or to all others.
ELSEWHERE = {
    ("", "--order"): "series of higher order are those of kurbel table and solve, and elsewhere"
    " --method series is of first order",
    ("turning", "--over"): "--layout turning-path has the tangential force over the developed crank circle,"
    " and --over-path draws it so",
    ("pressures", "--over"): "pressures stand over the stroke by themselves, at --shares of it",
    ("inertia", "--over"): "forces over the path, those of masses too, are of kurbel forces",
    ("solve", "--over"): '--where "s = 25%" is a share of the stroke',
    (
        "",
        "--over",
    ): "shares of the stroke are angles at which the piston has gone them, --angle 's=0..100%:5%'",
    **dict.fromkeys(
        (("collate", "--machine"), ("example", "--machine")),
        "it computes with the numbers of a book or of your transcription, and not with those of a machine",
    ),
    (
        "forces",
        "--flywheel",
    ): "kurbel turning --flywheel 50 --speed 120/min --columns phi,angular_acceleration"
    " has how an engine's shaft is accelerated, and forces under a --force that of a shaft by its --inertia",
    ("locomotive", "--unknown"): "what follows are columns: kurbel locomotive --wheel-load 80kN --columns"
    " share,lift_speed, and with --hammer-blow share_most",
    ("rotor", "--unknown"): "a mass, a radius or an angle that is asked for is a ? in its list:"
    " --masses '?;3kg' --radii 100mm --angles '?;90'",
    ("", "--unknown"): "kurbel solve --unknown asks for a number with which a condition holds, kurbel power"
    " and flywheel for one of theirs",
    ("", "--pdf-engine"): "Typst sets the PDF; for that of a TeX, let it compile handbook.tex",
}
# What pages draw themselves, by the flag that once drew it.
DRAWN = {
    "--forces": "forces --eps 4 -o forces.svg",
    "--polar": "forces --eps 4 --polar -o pin.svg",
    "--pressures": "pressures --machine engine.toml -o pressures.svg",
    "--turning": "turning --eps 4 -o turning.svg",
    "--columns": "table --columns x,c -o motion.svg",
    "--infinite": "table --ratio 1:5 --infinite -o motion.svg",
    "--over": "table --ratio 1:5 --angle 's=0..100%:10%' -o ellipse.svg",
}
# Commands that list what there is.
LISTS = ("kurbel quantities", "kurbel layouts")
# Whose values have words with spaces between them.
SENTENCES = ("where", "only", "torque", "load_torque", "caption", "note", "source")
# Commands that there were once.
GONE = {
    "man": "manual pages are made by make docs, in the folder build/man of kurbel's source, and the same is"
    " said by kurbel COMMAND --help",
}
_LONGEST = 60
# More commands that have an option are not listed.
_OWNERS = 4
_NUMBER = re.compile(r"[+−-]?\d[\d.,/]*")
Typed = TypeVar("Typed", str, Sequence[str])


def one_line(error: click.ClickException, words: Sequence[str]) -> str:
    """Return what click says of the words that were typed as one of our sentences."""
    match error:
        case click.NoSuchOption():
            message = _no_option(error, words)
        case click.BadOptionUsage() if "requires an argument" in error.message:
            message = f"{error.option_name} needs a value{_example(error.ctx, error.option_name)}"
        case click.BadOptionUsage() if "does not take a value" in error.message:
            message = f"{error.option_name} takes no value; leave out what follows the sign ="
        case click.MissingParameter():
            message = _missing(error)
        case click.UsageError() if found := re.fullmatch(
            r"Got unexpected extra arguments? \((.*)\)", error.message
        ):
            name = error.ctx.command_path if error.ctx else "kurbel"
            message = f"{name} needs no such word as {notation.quoted(found[1])}; leave it out"
            if name in LISTS:
                message = message.replace("leave it out", f"write kurbel help --search {_as_typed(found[1])}")
        case _:
            message = " ".join(error.format_message().split()).rstrip(".").replace(". ", "; ")
    context = getattr(error, "ctx", None)
    return f"{message}; see {context.command_path} --help" if context else message


def _no_option(error: click.NoSuchOption, words: Sequence[str]) -> str:
    """Return the sentence about an option that there is not: which is meant, or which command has it."""
    name, command = error.option_name, error.ctx.command if error.ctx else None
    options = _flags(command)
    begun = f"there is no option {notation.quoted(name)}"
    if isinstance(command, click.Group):
        if moved := _before_command(words, name):
            return f"{begun} before a command; write {moved}"
        typed = " ".join(filter(None, (name, _as_typed(_value_of(name, words)))))
        having = ["table"] if _has("table", name) else [one for one in COMMANDS if _has(one, name)]
        if len(having) == 1:
            return f"{begun} before a command; write kurbel {having[0]} {typed}"
        owners = _owners(name)
        return f"{begun} before a command{owners}" if owners else begun
    value = _value_of(name, words)
    if ours := line(name, value, options):
        return f"{begun}; write {ours}"
    single = next((word for word in words if word.startswith(name) and word.lstrip("-") in options), "")
    if len(name) == 2 and single:
        return f"there is no option {notation.quoted(single)}; write -{single}"
    if command is not None and command.name == "plot" and name in DRAWN:
        return f"{begun}, for drawings of pages are a format of them; write kurbel {DRAWN[name]}"
    swept = command.name if command is not None and getattr(command, "swept", False) else ""
    if swept and name.lstrip("-") in _flags(command_of(swept)):
        return (
            f"{begun} in a sweep, which has columns of numbers and neither pages nor drawings; leave it out"
        )
    begins = [one for one in options if one.startswith(name[1:])] if len(name) == 2 else []
    hint = did_you_mean(name, [f"--{one}" for one in options])
    if not hint and len(begins) == 1:
        hint = f" (did you mean --{begins[0]}?)"
    path = getattr(error.ctx, "command_path", "")
    if not hint and name.removeprefix("--") in _topics(command):
        return f"{begun}, which is a topic; write {path} --help {name[2:]}"
    return begun + (elsewhere(path, name) or hint or _owners(name, value))


def _flags(command: click.Command | None) -> Mapping[str, click.Option]:
    """Return the options of a command by their names without dashes."""
    options = (one for one in (command.params if command else ()) if isinstance(one, click.Option))
    return {flag.lstrip("-"): one for one in options for flag in one.opts if flag.startswith("--")}


def _topics(command: click.Command | None) -> Sequence[str]:
    return [topic.name for topic, _ in topics_of(command)] if isinstance(command, TopicCommand) else []


def _has(command: str, flag: str) -> bool:
    return any(flag in one.opts for one in command_of(command).params)


def _value_of(name: str, words: Sequence[str]) -> str:
    """Return the value that was typed behind a flag, nothing if none was."""
    for word, behind in zip(words, [*words[1:], ""], strict=True):
        flag, _, value = word.partition("=")
        if flag == name:
            return value or ("" if behind.startswith("--") else behind)
    return ""


def _owners(flag: str, value: str = "") -> str:
    """Return which commands have an option that this one has not, or one of that meaning; nothing if none."""
    flags = {name: _flags(command_of(name)) for name in COMMANDS}
    name = flag.lstrip("-")
    found = (
        name
        if any(name in own for own in flags.values())
        else ours(name, value, {*chain(*flags.values())})[0]
    )
    owners = [command for command, own in flags.items() if found in own]
    if not owners:
        return ""
    listed = enumerated([*owners[:_OWNERS], *(["others"] if len(owners) > _OWNERS else [])])
    return f"; kurbel {listed} {'have' if owners[1:] else 'has'} {'it' if found == name else f'--{found}'}"


def _missing(error: click.MissingParameter) -> str:
    """Return the sentence about all that a command cannot do without, with the first line of its help."""
    assert error.ctx is not None
    needed = [one for one in error.ctx.command.params if one.required]
    listed = enumerated(
        one.opts[-1] if isinstance(one, click.Option) else one.make_metavar(error.ctx) for one in needed
    )
    path = error.ctx.command_path
    example = re.search(rf"^\s*({path} .*)$", error.ctx.command.help or "", re.MULTILINE)
    return f"{path} needs {listed}{f', as in {example[1]}' if example else ''}"


def _example(context: click.Context | None, flag: str) -> str:
    """Return what an option may be given, out of its sentence in the help."""
    option = _flags(context.command if context else None).get(flag.lstrip("-"))
    found = re.search(r": ('[^']+'|[^\s;,']*\d[^\s;,']*)", (option and option.help) or "")
    return f", as in {flag} {found[1].rstrip('.,')}" if found else ""


def twice(flag: str, values: Iterable[object], command: str | None) -> str:
    """Return the sentence that refuses an option which takes one value and was given several."""
    listed = " and as ".join(str(value)[:_LONGEST] for value in values)
    hint = SIDE_BY_SIDE.get(command or "") if flag == "--method" else None
    return f"{flag} is given as {listed}, and takes one value{f'; {hint}' if hint else ''}"


def elsewhere(command: str, flag: str) -> str:
    """Return what an option says to a command that has it not, after a semicolon, nothing if none."""
    found = ELSEWHERE.get((command.rpartition(" ")[2], flag)) or ELSEWHERE.get(("", flag))
    return f"; {found}" if found else ""


def _before_command(words: Sequence[str], name: str) -> str:
    """Return the line with its options behind the command, nothing where none is named behind them, or one
    that does not have this option."""
    place = next((place for place, word in enumerate(words) if word in COMMANDS), 0)
    known = place and _has(words[place], name)
    return join(["kurbel", *words[place:], *words[:place]]) if known else ""


def stray(text: str, command: click.Command, words: Sequence[str]) -> str:
    """Return the sentence that refuses one of the words, which has no option, with what is likely meant: an
    option, or quotes about a value with a space."""
    if option := _flags(command).get(text):
        value = "" if option.is_flag else f" {option.metavar or text.upper()}"
        return f"{notation.quoted(text)} stands behind no option; write --{text}{value}"
    if "where" in _flags(command) and (condition := _condition(text, words)):
        return f"{notation.quoted(text)} stands behind no option; write --where {_as_typed(condition)}"
    if parted := _parted(text, words):
        return f"{notation.quoted(text)} stands behind no option; a value with a space needs quotes: {parted}"
    options = {one.name or "": one for one in command.params if isinstance(one, click.Option)}
    shown = notation.quoted(text)
    flag, values = _before(text, words)
    option = _flags(command).get(flag.lstrip("-"))
    name = next((name for name in _names(text, options) if name in options), "")
    if option and not option.is_flag and (not name or options[name] is option):
        joined = _joined(option, values)
        if joined:
            return f"{shown} stands behind no option; write {flag} {_as_typed(joined)}"
    if not name and text in _topics(command):
        return f"{shown} stands behind no option; its options are kurbel {command.name} --help {text}"
    if not name and text == "help":
        return f"{shown} stands behind no option; write kurbel {command.name} -h"
    if not name:
        return f"{shown} stands behind no option, and kurbel {command.name} needs no such word"
    return f"{shown} stands behind no option; write {long_flag(options[name])} {_as_typed(text)}"


def _condition(text: str, words: Sequence[str]) -> str:
    """Return a condition that was typed as several words, of which this is the first, nothing for others."""
    place = [*words].index(text) if text in words else len(words)
    typed = words[place : place + 3]
    return " ".join(typed) if len(typed) == 3 and typed[1] == "=" else ""


def _before(text: str, words: Sequence[str]) -> tuple[str, Sequence[str]]:
    """Return the flag before a word, and all words from that to the next flag."""
    place = [*words].index(text) if text in words else 0
    start = next((at for at in range(place, -1, -1) if words[at].startswith("--")), None)
    if start is None:
        return "", ()
    end = next((at for at in range(place, len(words)) if words[at].startswith("-")), len(words))
    flag, equals, value = words[start].partition("=")
    return flag, [*([value] if equals else []), *words[start + 1 : end]]


def _joined(option: click.Option, values: Sequence[str]) -> str:
    """Return several words behind an option as its one value; nothing where it takes no such value."""
    kind = getattr(option.type, "kind", None)
    if isinstance(kind, Columns):
        return ",".join(value.strip(",;") for value in values)
    if option.name in SENTENCES:
        return " ".join(values)
    # A word without a figure is none of a list of numbers.
    alike = len({any(map(str.isdigit, value)) for value in values}) == 1
    return ";".join(value.strip(",;") for value in values) if option.multiple and alike else ""


def _parted(text: str, words: Sequence[str]) -> str:
    """Return the value in quotes of which the word before is the first part: '600 mm', 'x, c'."""
    place = [*words].index(text) if text in words else 0
    before = words[place - 1] if place > 1 else ""
    first = before.rpartition("=")[2]
    if _NUMBER.fullmatch(first) and plain_unit(text):
        return _as_typed(f"{first} {text}")
    return ""


def long_flag(option: click.Option) -> str:
    return next(one for one in option.opts if one.startswith("--"))


def instead_of(text: str) -> str:
    """Return what to do in place of a command that is none, such as a value or another word for one; nothing
    if nothing is likely."""
    if _reads(notation.ratios, [text]) and any(mark in text for mark in ":∶"):
        return f"write kurbel table --ratio {_as_typed(text)}"
    if _is_condition(text):
        return f"write kurbel solve --ratio 1:5 --where {_as_typed(text)}"
    found = command(text)
    return f"write kurbel {found}" if found else GONE.get(text, "")


def _names(text: str, options: Mapping[str, click.Option]) -> Iterable[str]:
    """Yield the names of the options that the value can be for, the likeliest first."""
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
    for name, read in (("speed", units.speed), ("stroke", units.length), ("force", units.force)):
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


def _reads(read: Callable[[Typed], object], text: Typed) -> bool:
    try:
        read(text)
    except KurbelError:
        return False
    return True


def _as_typed(text: str) -> str:
    return notation.in_shell(text) if text and len(text) <= _LONGEST else text and "VALUE"
