"""Random command lines, formulas and damaged files: kurbel prints, or says why not, and leaves nothing.

    make fuzz N=20000 SEED=1

makes N calls, drawn by this seed, of five kinds: `lines` of the options that the commands declare, with good,
strange and wrong values; `typed`, lines of scripts/corpus that are changed, and changed again where they were
accepted; `texts`, formulas, conditions and measures for the options that read them; `files` of examples and
scripts/corpus, damaged byte by byte, line by line, value by value, for the commands that read them; and
`documents` and handbooks of such lines. A new option, command or example is tried without a line here.

A call may take 10 s of processor time and 500 MB; it may end with 0, 1 or 2, print nothing beside an error
but where it compares, and write nothing but its output. What fails is made as small as it still fails, and
printed as a block for tests/transcripts. Ends with 1 where any fails.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import random
import re
import resource
import shlex
import shutil
import sys
import tempfile
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import chdir
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import click
from command_lines import CORPUS, commands_of, lines_of, paired_lines
from same_bytes import DONE_HERE, kurbel
from tabulate import tabulate

ROOT = Path(__file__).resolve().parents[1]
KINDS = ("lines", "lines", "typed", "typed", "texts", "files", "files", "documents")
SECONDS, BYTES = 10.0, 500 << 20
# 130 and 141 are those of Ctrl-C and of a pipe that nobody reads.
CODES = (0, 1, 2, 130, 141)
# What compares, or builds several parts, tells what it found and ends with 1.
TELLING = ("check", "build", "verify", "--check", "--strict")
# Lines of more words are not made longer.
LONGEST = 12
# It ends by Ctrl-C alone.
ENDLESS = ("watch",)
# So many smaller calls are tried of one that fails, for so many seconds.
SHRINKS, LONGEST_SHRINK = 1000, 60.0
STRANGE = (
    *("", " ", "0", "-1", "-0", "1e309", "1e-400", "1e99999", "nan", "inf", "∞", "1:0", "1:1", "1:∞", "1/0"),
    *("2;3;4", "2..6", "2..6:0.5", "0..360:1e-9", "6..2", ";", "..", ":", "1;;2", "1,5,2", "50%", "?"),
    *("-5°", "2°30'", "3bar", "120/min", "0.3 m", "1e9kg", "x", "max", "x=0.5", "x,c,p", "[", "{", "$x"),
    *("$x/R$", "\\", "%s", "é", "φ", "\u202e", "\U0001f600", "\udcff", "a b", "--", "-", ".", ".."),
    *("/", "out", "none/none", "9" * 70, "9" * 400),
)  # fmt: skip
# What may stand in a file of TOML in place of a value.
VALUES = (
    *("1", "-1", "0", "1e400", "nan", "-inf", "true", '""', '"x"', "[]", "{}", "[[]]", "{ x = 1 }"),
    *("1979-05-27", '["1:5", 3]', '"1:3..8"', '"?"', "9" * 400, "[1, 2, 3]"),
    *('[{ x = "y" }]', "'''\n'''", '"../x"', '"/"'),
)  # fmt: skip
OUTPUTS = ("-", "out/page.html", "out/page.csv", "out/page.svg", "out/page.tex", "out/s.parquet", "out/x")
NUMBERS = (
    *("0", "1", "2", "3", "0.5", "1/3", "1:5", "1:4,5", "0,3", "1e3", "1e-30", "-7", "60", "90", "180"),
    *("100", "1/0", "0.1", "50%", "1.", ".5", "1e400", "2..6", "1;2;3", "∞", "π", "2π", "12345678901234567"),
)  # fmt: skip
SIGNS = (
    "+",
    "-",
    "*",
    "/",
    "**",
    "^",
    "//",
    "%",
    "<",
    "<=",
    "=",
    "==",
    "!=",
    ">",
    " and ",
    " or ",
    ",",
    "..",
)
FUNCTIONS = ("sin", "cos", "sqrt", "root", "abs", "max", "min", "log", "exp", "not ", "-", "+", "lambda ", "")
NAMES = (
    *("x", "c", "p", "s", "v", "phi", "φ", "psi", "eps", "ratio", "back", "delta", "R", "L", "r", "F", "T"),
    *("pi", "π", "max", "min", "dead centre", "__class__", "x.y", "x[0]", "None", "velocity", "dc", "E", "e"),
    *("eps", "back", "ratio", "eps", "back", "ratio", "torque", "rod_force"),
)  # fmt: skip
# How a marker stands in a document, by its suffix.
MARKERS = {
    ".md": ("<!-- kurbel: {} -->", "<!-- /kurbel -->"),
    ".html": ("<!-- kurbel: {} -->", "<!-- /kurbel -->"),
    ".tex": ("% kurbel: {}", "% /kurbel"),
    ".typ": ("// kurbel: {}", "// /kurbel"),
}
# Commands that read a file, by what it is called; @ is the file, and % the folder that it lies in.
READERS = {
    # They have more to build than a call may take.
    "examples/*/handbook.toml": ("handbook list %",),
    "appendix/handbook.toml": ("handbook list %",),
    "handbook.toml": ("handbook list %", "handbook build % -j 1 --quiet", "handbook check % -j 1 --quiet"),
    "layout.toml": ("table --layouts %/.. --layout slant", "layouts --layouts %/.."),
    "source.toml": ("collate --sources %/.. own-1", "sources --sources %/.."),
    "weg.csv": ("collate --sources %/.. own-1",),
    "constructions/*.toml": ("construct --constructions %", "construct --constructions % hebelarm"),
    "sweep.toml": ("sweep @ --dry-run", "sweep @ -o out/s.csv -j 1"),
    "rod.csv": ("inertia --rod-file @ --stroke 240mm --ratio 1:5 --step 90",),
    "scan.csv": ("collate --csv @ --quantity p --ratio 1:4",),
    "torque.csv": ("turning --torque-file @ --step 90", "delta --torque-file @ --columns delta"),
    "cards/*.csv": ("delta --card @", "turning --card @ --step 90", "power --card @"),
    "page.json": ("verify @",),
    "*.md": ("inject @",),
    "*.jinja": ("handbook build given/templates -j 1 --quiet",),
    "problems/*.toml": ("handbook list %",),
    "*.toml": tuple(
        f"{name} --machine @"
        for name in ("table --step 90", "forces --step 90", "turning --step 90", "inertia --step 90", "delta",
                     "flywheel", "power", "balance", "deadcentres", "harmonics", "pressures",
                     "sweep delta --dry-run")
    ),
}  # fmt: skip
SWEEP = """\
command = "delta"
only = ["eps*back < 1"]
[axes]
eps = "1..4:0.5"
back = [0, 0.1]
[options]
ratio = "1:5"
"""
State: TypeAlias = Mapping[str, tuple[int, int]]


class Choice(NamedTuple):
    """An option, or an argument without a flag, with values that are likely to be good; None takes none."""

    flag: str
    values: Sequence[str] | None
    # What it writes, or the folder that it makes, has to lie where it is looked for.
    is_place: bool = False


@dataclass(frozen=True)
class Call:
    """The words behind `kurbel`, the variables that are set for them, and files that are written before."""

    words: tuple[str, ...]
    environment: Mapping[str, str] = field(default_factory=dict)
    files: Mapping[str, bytes] = field(default_factory=dict)

    def __str__(self) -> str:
        return "\n".join((*(written(*one) for one in self.files.items()), f"$ {self.line}"))

    @property
    def line(self) -> str:
        variables = (f"{name}={shlex.quote(value)}" for name, value in self.environment.items())
        return " ".join((*variables, "kurbel", shlex.join(self.words)))


def written(name: str, content: bytes) -> str:
    """Return a file as it stands in tests/transcripts, or else as a line of Python."""
    text = content.decode(errors="replace")
    lines = text.split("\n")[:-1]
    if text.encode() == content and "\n".join((*lines, "")) == text and text.isascii():
        return "\n".join((f"file {name}", *(f"    {line}" for line in lines)))
    return f"# Path({name!r}).write_bytes({content!r})"


@dataclass
class Drawing:
    """Draws calls for a folder; what is accepted is drawn again."""

    seed: int
    work: Path
    only: str = ""
    accepted: list[Call] = field(default_factory=list)

    def call(self, number: int) -> tuple[str, Call]:
        chance = random.Random(f"{self.seed} {number}")
        kind = self.only or chance.choice(KINDS)
        return kind, getattr(self, f"_{kind}")(chance)

    def accept(self, call: Call) -> None:
        if len(call.words) < LONGEST:
            self.accepted.append(call)

    def known_call(self, chance: random.Random) -> Call:
        """Return a line of the corpus, or one that was made of it."""
        return chance.choice(self.accepted if self.accepted and chance.random() < 0.6 else self.corpus)

    @cached_property
    def commands(self) -> Mapping[tuple[str, ...], Sequence[Choice]]:
        from kurbel.cli.app import cli

        files = sorted(state(self.work))
        return {words: options_of(command, files, self.values) for words, command in commands(cli)}

    @cached_property
    def corpus(self) -> Sequence[Call]:
        """The lines of scripts/corpus that are a command, or write files for the one that follows."""
        found = []
        lines = [line for path in sorted(CORPUS.glob("*.txt")) for line in lines_of(path)]
        lines += paired_lines(**tomllib.loads((CORPUS / "pairs.toml").read_text(encoding="utf-8")))
        for line in lines:
            *before, last = commands_of(line)
            if (
                all(one.words[0] == "write" for one in before)
                and last.words
                and last.words[0] not in DONE_HERE
            ):
                files = {one.words[1]: one.words[2].encode(errors="surrogateescape") for one in before}
                found.append(Call(last.words, last.environment, files))
        return found

    @cached_property
    def readers(self) -> Mapping[str, Sequence[str]]:
        """The files that commands read, each with these."""
        found: dict[str, Sequence[str]] = {}
        for pattern, lines in READERS.items():
            for path in sorted(self.work.rglob(pattern)):
                found.setdefault(str(path.relative_to(self.work)), lines)
        return found

    @cached_property
    def printing(self) -> Collection[str]:
        from kurbel.cli.asking import printing_commands

        return printing_commands()

    @cached_property
    def units(self) -> Sequence[str]:
        from kurbel.reading.amounts import FACTORS, UNITS

        return (*FACTORS, *UNITS, "m**9", "1/min", "rpm", "", "", "°C", "R")

    @cached_property
    def values(self) -> Mapping[str, Iterable[str]]:
        """The values that options have in the corpus."""
        known: dict[str, dict[str, None]] = defaultdict(dict)
        for call in self.corpus:
            for word, after in zip(call.words, (*call.words[1:], ""), strict=True):
                flag, sign, value = word.partition("=")
                known[flag][value if sign else after] = None
        return known

    @cached_property
    def quantities(self) -> Sequence[str]:
        """What conditions ask of in the corpus."""
        found = (re.match(r"([a-z_]+) *=", one) for one in self.values["--where"])
        return sorted({one[1] for one in found if one})

    def _lines(self, chance: random.Random) -> Call:
        words, options = chance.choice([*self.commands.items()])
        return self._with_options(Call(words), options, chance, (1, 1, 2, 3, 4, 6))

    def _with_options(
        self,
        call: Call,
        options: Sequence[Choice],
        chance: random.Random,
        counts: Sequence[int],
        good: float = 0.6,
    ) -> Call:
        """Return the call with some of its options more; now and then a variable says one."""
        words, environment = list(call.words), dict(call.environment)
        for one in chance.sample(options, min(len(options), chance.choice(counts))):
            if one.values is None:
                words.append(one.flag)
                continue
            value = value_of(one, chance, good)
            if one.flag and chance.random() < 0.03 and "\0" not in value:
                environment[f"KURBEL_{call.words[0]}_{one.flag[2:]}".upper().replace("-", "_")] = value
            else:
                words.append(f"{one.flag}={value}" if one.flag else value)
        return replace(call, words=tuple(words), environment=environment)

    def _typed(self, chance: random.Random) -> Call:
        call = self.known_call(chance)
        words = list(call.words)
        for _ in range(chance.choice((0, 0, 1, 1, 2))):
            place = chance.randrange(len(words))
            match chance.randrange(8):
                case 0 if place:
                    del words[place]
                case 1:
                    words.insert(place + 1, chance.choice(chance.choice(self.corpus).words))
                case 2 if place:
                    flag, sign, value = words[place].rpartition("=")
                    words[place] = flag + sign + spoilt(value, chance)
                case _:
                    words[place] = renumbered(words[place], chance)
        call = replace(call, words=tuple(words))
        own = self.commands.get(call.words[:1]) or self.commands.get(call.words[:2])
        return self._with_options(call, own, chance, (0, 1, 1, 1, 2), good=0.95) if own else call

    def _texts(self, chance: random.Random) -> Call:
        """A call whose option has a formula, a condition or a measure as its value."""
        match chance.randrange(3):
            case 0:
                sized = ("--stroke=600mm", "--speed=120/min", "--bore=300mm", "--pressure=8bar", "--eps=4")
                words = ["solve", *sized[: chance.randrange(6)], f"--where={self._text(chance)}"]
            case 1:
                axes = ("--eps=1..4:1", "--back=0;0.1", "--ratio=1:4;1:5")
                words = [
                    "sweep",
                    "delta",
                    *axes,
                    f"--only={self._compared(chance)}",
                    "-o",
                    "out/s.csv",
                    "-j",
                    "1",
                ]
            case _:
                call = self.known_call(chance)
                while not self._measured(call.words):
                    call = self.known_call(chance)
                words = list(call.words)
                place = chance.choice(self._measured(words))
                words[place] = words[place].partition("=")[0] + "=" + self._text(chance)
                return replace(call, words=tuple(words))
        return Call(tuple(words))

    def _measured(self, words: Sequence[str]) -> list[int]:
        """Return where options stand whose values have a number."""
        return [place for place, word in enumerate(words) if re.match(r"--[\w-]+=.*\d", word)]

    def _text(self, chance: random.Random) -> str:
        match chance.randrange(6):
            case 0:
                return formula(chance)
            case 1 | 2:
                number = chance.choice(NUMBERS)
                right = (
                    number,
                    f"{number} of dead centre",
                    f"{number}{chance.choice(self.units)}",
                    "max",
                    "min",
                )
                sign = "=" if chance.random() < 0.9 else chance.choice(SIGNS)
                return chance.choice(self.quantities) + sign + chance.choice(right)
            case _:
                listed = (
                    chance.choice(NUMBERS) + chance.choice(("", " ")) + chance.choice(self.units)
                    for _ in range(chance.choice((1, 1, 1, 1, 2, 3)))
                )
                return chance.choice((";", ";", ",", "..", ":", "x")).join(listed)

    def _compared(self, chance: random.Random) -> str:
        """Return a condition of combinations, most of them such as can be read."""
        if chance.random() < 0.3:
            return formula(chance)
        names = ("eps", "back", "ratio", "2", "0", "0.5", "1e-30", "(1/3)", "10**9", "-1")

        def term(deep: int) -> str:
            if deep == 0:
                return chance.choice(names)
            return f"({term(deep - 1)}{chance.choice(('+', '-', '*', '/', '**'))}{chance.choice(names)})"

        sides = (term(chance.randrange(4)) for _ in range(chance.choice((2, 2, 3))))
        return chance.choice(("<", "<=", ">", "==", "!=", " < ")).join(sides)

    def _files(self, chance: random.Random) -> Call:
        path = chance.choice([*self.readers])
        line = chance.choice(self.readers[path])
        content = (self.work / path).read_bytes()
        other = (self.work / chance.choice([*self.readers])).read_bytes()
        words = [one.replace("@", path).replace("%", str(Path(path).parent)) for one in shlex.split(line)]
        return Call(tuple(words), files={path: self._damaged(content, other, chance)})

    def _documents(self, chance: random.Random) -> Call:
        """A document or a handbook with lines of commands, damaged or not."""
        suffix = chance.choice([*MARKERS, ".toml"])
        draw = (self._lines, self._typed, self.known_call, self.known_call)
        drawn = [chance.choice(draw)(chance).words for _ in range(30)]
        # That a document takes no list and writes its own files, one in ten finds.
        if chance.random() < 0.9:
            drawn = [tuple(for_document(words)) for words in drawn if words[0] in self.printing]
        runs = [shlex.join(words) for words in drawn[: chance.choice((1, 1, 2, 3))]]
        if suffix == ".toml":
            parts = "".join(f"[[chapter.part]]\nrun = '''{run}'''\n" for run in runs)
            name, text = "out/handbook.toml", f'title = "T"\n[[chapter]]\ntitle = "C"\n{parts}'
            words: tuple[str, ...] = ("handbook", chance.choice(("list", "build", "check")), "out")
        else:
            begin, end = MARKERS[suffix]
            name, text = f"out/notes{suffix}", "".join(f"{begin.format(run)}\nold\n{end}\n" for run in runs)
            words = ("inject", name, *chance.choice(((), (), ("--check",))))
        content = text.encode(errors="surrogateescape")
        if chance.random() < 0.3:
            content = self._damaged(content, content, chance)
        return Call(words, files={name: content})

    def _damaged(self, content: bytes, other: bytes, chance: random.Random) -> bytes:
        """Return a content with one to three faults: in bytes, lines, values, nesting or encoding."""
        for _ in range(chance.randint(1, 3)):
            lines = content.split(b"\n")
            place, row = chance.randrange(len(content) + 1), chance.randrange(len(lines))
            match chance.randrange(13):
                case 0:
                    content = content[:place] + bytes(chance.choices(range(256), k=3)) + content[place + 1 :]
                case 1:
                    content = content[:place]
                case 2:
                    content = b"\n".join([*lines[:row], *lines[row + 1 :]])
                case 3:
                    content = b"\n".join([*lines[: row + 1], *lines[row:]])
                case 4:
                    chance.shuffle(lines)
                    content = b"\n".join(lines)
                case 5 | 6:
                    value = chance.choice(STRANGE).encode(errors="surrogateescape")
                    content = put_at(content, rb"[\d.,]+", value, chance)
                case 7:
                    sign = chance.choice((b"[", b"]", b"{", b'"', b"=", b"<!--", b"]]", b"(", b"-"))
                    content = content[:place] + sign * chance.choice((1, 1, 500)) + content[place:]
                case 8:
                    text = content.decode(errors="replace")
                    encoding = chance.choice(("utf-16", "latin-1", "utf-8-sig"))
                    content = text.encode(encoding, errors="replace")
                case 9:
                    lines[row] = lines[row] * chance.choice((0, 2, 300))
                    content = b"\n".join(lines)
                case 10:
                    lines.insert(row, chance.choice(other.split(b"\n")))
                    content = b"\n".join(lines)
                case 11:
                    value = b"= " + chance.choice(VALUES).encode()
                    content = put_at(content, rb"(?m)= *[^\n]+$", value, chance)
                case 12:
                    value = b'"' + self._text(chance).encode() + b'"'
                    content = put_at(content, rb'"[^"\n]*"', value, chance)
        return content


def options_of(
    command: click.Command, files: Sequence[str], known: Mapping[str, Iterable[str]]
) -> list[Choice]:
    """Return what a command takes. Good values are known ones, those that shells offer, and the help's."""
    found = []
    context = click.Context(command, info_name=command.name)
    for param in command.get_params(context):
        flag = max(param.opts, key=len) if isinstance(param, click.Option) else ""
        if getattr(param, "is_flag", False):
            found.append(Choice(flag, None))
            continue
        is_path = isinstance(param.type, click.Path)
        if param.name == "output":
            values: Sequence[str] = OUTPUTS
        elif is_path or "FILE" in str(param.metavar) or "DIR" in str(param.metavar):
            values = files
        else:
            offered = [one.value for one in param.shell_complete(context, "") if one.type == "plain"]
            said = re.findall(r"[^\s;,()]*\d[^\s;()]*(?<![.,:])", getattr(param, "help", None) or "")
            values = [*known.get(flag, ()), *offered, *said]
        found.append(Choice(flag, values, is_place=is_path))
    return found


def commands(
    group: click.Group, words: tuple[str, ...] = ()
) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    """Yield all commands of a group, and of those in it, with the words that call them."""
    context = click.Context(group)
    for name in group.list_commands(context):
        found = group.get_command(context, name)
        if isinstance(found, click.Group):
            yield from commands(found, (*words, name))
        elif found and name not in ENDLESS:
            yield (*words, name), found


def for_document(words: Sequence[str]) -> list[str]:
    """Return the words of a command without the file that it writes, and the format."""
    pairs = zip(words, ("", *words), strict=False)
    return [
        word
        for word, before in pairs
        if not word.startswith(("-o", "-f", "--output", "--format"))
        and before not in ("-o", "-f", "--output", "--format")
    ]


def value_of(option: Choice, chance: random.Random, share: float) -> str:
    """Return a good value, by this share at least, a strange one, two of them, or one that is damaged."""
    good = option.values
    value = chance.choice(good if good and chance.random() < share else STRANGE)
    if chance.random() > share:
        value += chance.choice((";", ",", "..", ":", " ", "")) + chance.choice((*(good or ()), *STRANGE))
    if chance.random() > share:
        value = spoilt(value, chance)
    elif chance.random() < 0.3:
        value = renumbered(value, chance)
    return "out/x" if option.is_place and value.startswith(("/", "..")) else value


def renumbered(text: str, chance: random.Random) -> str:
    """Return the text with another number in place of one, near it or far away."""
    found = [*re.finditer(r"\d+(?:[.,]\d+)?", text)]
    if not found:
        return text
    one = chance.choice(found)
    times = chance.choice((0, 0.5, 0.9, 0.999999, 1.000001, 1.1, 2, 10, 1e-3, 1e-9, 1e6, 1e12))
    changed = f"{float(one[0].replace(',', '.')) * times:.12g}".replace("e+", "e")
    return text[: one.start()] + changed + text[one.end() :]


def spoilt(value: str, chance: random.Random) -> str:
    """Return the value with another letter at one place."""
    place = chance.randrange(len(value) + 1)
    return value[:place] + chance.choice("0123456789.,:;/°'-+e∞% xcpφ=()?") + value[place + 1 :]


def formula(chance: random.Random, deep: int = 3) -> str:
    """Return a formula or a condition, which seldom means anything."""
    draw = chance.random()
    if deep == 0 or draw < 0.2:
        return chance.choice((chance.choice(NUMBERS), chance.choice(NAMES)))
    if draw < 0.7:
        return formula(chance, deep - 1) + chance.choice(SIGNS) + formula(chance, deep - 1)
    if draw < 0.98:
        return f"{chance.choice(FUNCTIONS)}({formula(chance, deep - 1)})"
    return chance.choice(("(", "-", "1+", "2**", "[")) * chance.choice((90, 600)) + formula(chance, deep - 1)


def put_at(content: bytes, pattern: bytes, value: bytes, chance: random.Random) -> bytes:
    """Return the content with the value in place of one that the pattern finds, if any."""
    found = [*re.finditer(pattern, content)]
    if not found:
        return content
    one = chance.choice(found)
    return content[: one.start()] + value + content[one.end() :]


class Folder:
    """The folder in which calls run, made anew where one has changed it."""

    def __init__(self, work: Path) -> None:
        self.work, self._whole = work, work.with_name(f"{work.name}-whole")
        shutil.copytree(CORPUS / "files", self._whole)
        shutil.copytree(ROOT / "examples", self._whole / "examples", dirs_exist_ok=True)
        shutil.copytree(ROOT / "examples" / "constructions", self._whole / "constructions")
        (self._whole / "sweep.toml").write_text(SWEEP)
        (self._whole / "out").mkdir()
        with chdir(self._whole):
            kurbel(("forces", "--eps=4", "--ratio=1:5", "--step=60", "-o", "page.json"), {})
        self.renew()

    def renew(self) -> None:
        shutil.rmtree(self.work, ignore_errors=True)
        shutil.copytree(self._whole, self.work)
        self.clean = state(self.work)

    def wrong(self, call: Call) -> tuple[int | str, str]:
        """Make a call; return how it ended, and what is wrong with what came of it, or nothing."""
        for name, content in call.files.items():
            (self.work / name).parent.mkdir(parents=True, exist_ok=True)
            (self.work / name).write_bytes(content)
        before = state(self.work) if call.files else self.clean
        with chdir(self.work):
            limit(BYTES)
            code, out, err = kurbel(call.words, call.environment, SECONDS)
            limit(None)
        after = state(self.work)
        found = fault(call, code, out, err, sorted(after.keys() - before.keys()))
        if after != self.clean:
            self.renew()
        return code, found

    def shrunk(self, call: Call) -> Call:
        """Return the smallest call that was found to fail in the same way, words and bytes dropped."""
        kind = kind_of(self.wrong(call)[1])
        end, tries = time.monotonic() + LONGEST_SHRINK, SHRINKS
        smaller: Call | None = call
        while smaller:
            call = smaller
            smaller = None
            for one in smaller_ones(call):
                tries -= 1
                if tries < 0 or time.monotonic() > end:
                    break
                if kind_of(self.wrong(one)[1]) == kind:
                    smaller = one
                    break
        return call


def kind_of(fault: str) -> str:
    return fault.partition(":")[0]


def smaller_ones(call: Call) -> Iterator[Call]:
    """Yield the call without one of its files, variables and words, or with less of them."""
    for name, content in call.files.items():
        yield replace(call, files={one: each for one, each in call.files.items() if one != name})
        for piece in without_pieces(content.splitlines(keepends=True)):
            yield replace(call, files={**call.files, name: b"".join(piece)})
        if len(content) < 400:
            for letters in without_pieces([content[at : at + 1] for at in range(len(content))]):
                yield replace(call, files={**call.files, name: b"".join(letters)})
    for name in call.environment:
        yield replace(call, environment={one: each for one, each in call.environment.items() if one != name})
    for words in without_pieces(call.words[1:]):
        yield replace(call, words=(call.words[0], *words))
    for place, word in enumerate(call.words):
        flag, sign, value = word.partition("=")
        for fewer in without_pieces([*value] if sign and flag.startswith("--") else []):
            shorter = f"{flag}={''.join(fewer)}"
            yield replace(call, words=(*call.words[:place], shorter, *call.words[place + 1 :]))


def without_pieces(whole: Sequence[Any]) -> Iterator[Sequence[Any]]:
    """Yield a sequence without each of its halves, quarters, eighths and so on."""
    size = len(whole)
    while size > 1:
        size = -(-size // 2)
        for start in range(0, len(whole), size):
            yield [*whole[:start], *whole[start + size :]]
    if len(whole) == 1:
        yield []


def limit(more: int | None) -> None:
    """Let this process have so much more memory than it has, or as much as there is."""
    # Memory to write to. Of all addresses libraries and threads reserve 400 MB that nobody fills: with these
    # counted, pyarrow had no room for a word of one letter, and said that it was of an unexpected type.
    used = int(Path("/proc/self/statm").read_text().split()[5]) * resource.getpagesize()
    most = resource.RLIM_INFINITY if more is None else used + more
    resource.setrlimit(resource.RLIMIT_DATA, (most, resource.RLIM_INFINITY))


def fault(call: Call, code: int | str, out: bytes, err: bytes, left: Sequence[str]) -> str:
    """Return what is wrong with how a call ended, what it printed and what it left, or nothing."""
    if code not in CODES:
        return str(code)
    if b"Traceback" in err:
        return f"traceback: {err.decode(errors='replace')[-300:]}"
    if code and not err.strip() and not out:
        return f"ends with {code} and says nothing"
    telling = any(word in TELLING for word in call.words)
    if code in (1, 2) and out and not telling:
        return f"ends with {code} and prints: {len(out)} bytes"
    # What is asked for by name may begin with a dot.
    left = [one for one in left if one.split("/")[0] not in call.words]
    if left and code and not telling:
        return f"ends with {code} and leaves: {', '.join(left[:3])}"
    if hidden := [
        one for one in left if re.search(r"(^|/)\.(?!kurbel/|kurbel$|gitignore$)|\.(tmp|parts)(/|$)", one)
    ]:
        return f"leaves: {', '.join(hidden[:3])}"
    return ""


def state(work: Path) -> State:
    """Return what is in the folder, and what changes as it is written."""
    found = {str(path.relative_to(work)): path.lstat() for path in work.rglob("*")}
    return {name: (one.st_size, one.st_mtime_ns) for name, one in found.items()}


def tried(seed: int, only: str, numbers: Sequence[int]) -> Counter[tuple[str, str]]:
    """Make the calls of these numbers; return how many of each kind ended how. What fails is printed."""
    counts: Counter[tuple[str, str]] = Counter()
    with tempfile.TemporaryDirectory(prefix="kurbel-fuzz-") as place:
        folder = Folder((Path(place) / "work").resolve())
        drawing = Drawing(seed, folder.work, only)
        for number in numbers:
            kind, call = drawing.call(number)
            code, said = folder.wrong(call)
            counts[kind, "failed" if said else str(code)] += 1
            if code == 0 and not said and kind in ("lines", "typed"):
                drawing.accept(call)
            if said:
                print(f"\n# Call {number} with seed {seed}: {said}\n{folder.shrunk(call)}", flush=True)
    return counts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=sorted(set(KINDS)), default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes")
    chosen = parser.parse_args()
    start = time.monotonic()
    numbers = range(chosen.count)
    jobs = min(chosen.jobs, chosen.count)
    counts: Counter[tuple[str, str]] = Counter()
    # Of processes that are told their work at once none waits; one that dies is a fault, too.
    with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
        for found in pool.map(
            tried, [chosen.seed] * jobs, [chosen.only] * jobs, [numbers[job::jobs] for job in range(jobs)]
        ):
            counts += found
    ends = ("0", "1", "2", "failed")
    rows = [(kind, *(counts[kind, end] for end in ends)) for kind in sorted({kind for kind, _ in counts})]
    print(tabulate(rows, ("", "printed", "ended with 1", "refused", "failed"), disable_numparse=True))
    failed = sum(count for (_, end), count in counts.items() if end == "failed")
    print(
        f"{chosen.count} calls with seed {chosen.seed} in {time.monotonic() - start:.0f} s: {failed} failed"
    )
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
