"""Random command lines and damaged files: kurbel prints, or refuses in a sentence, and leaves nothing behind.

    .venv/bin/python scripts/fuzz.py lines 20000 --seed 1
    .venv/bin/python scripts/fuzz.py files 7000 --seed 1

`lines` puts options of each command together, with good, strange and wrong values; `files` damages the files
of scripts/corpus and examples, byte by byte, line by line, number by number, and gives them to the commands
that read them. A call may take 10 s of processor time and 500 MB; it may end with 0, 1 or 2, print nothing
beside an error but where it compares, and write nothing but its output. What fails is printed with its line,
which can be copied into a shell; `1 --first NUMBER --keep FOLDER` leaves the files of a single one to try.
"""

from __future__ import annotations

import argparse
import random
import re
import resource
import shlex
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import chdir
from pathlib import Path
from typing import NamedTuple

import click
from command_lines import CORPUS
from same_bytes import kurbel

ROOT = Path(__file__).resolve().parents[1]
SECONDS, BYTES = 10.0, 500 << 20
# 130 and 141 are those of Ctrl-C and of a pipe that nobody reads.
CODES = (0, 1, 2, 130, 141)
# What compares, or builds several parts, tells what it found and ends with 1.
TELLING = ("check", "build", "--check", "--strict")
# It ends by Ctrl-C alone.
ENDLESS = ("watch",)
STRANGE = (
    *("", " ", "0", "-1", "-0", "1e309", "1e-400", "1e99999", "nan", "inf", "∞", "1:0", "1:1", "1:∞", "1/0"),
    *("2;3;4", "2..6", "2..6:0.5", "0..360:1e-9", "6..2", ";", "..", ":", "1;;2", "1,5,2", "50%"),
    *("-5°", "2°30'", "3bar", "120/min", "0.3 m", "1e9kg", "x", "max", "x=0.5", "x,c,p", "[", "{", "$x"),
    *("$x/R$", "\\", "%s", "é", "φ", "\u202e", "\U0001f600", "\udcff", "a b", "--", "-", ".", ".."),
    *("/", "out", "none/none", "9" * 70, "9" * 400),
)  # fmt: skip
OUTPUTS = ("-", "out/page.html", "out/page.csv", "out/page.svg", "out/page.tex", "out/s.parquet", "out/x")
# Commands that read a file, by what it is called; @ is the file, and % the folder that it lies in.
READERS = {
    "examples/*/handbook.toml": ("handbook list %",),
    "handbook.toml": ("handbook list %", "handbook build % -j 1 --quiet", "handbook check % -j 1 --quiet"),
    "layout.toml": ("table --layouts %/.. --layout slant", "layouts --layouts %/.."),
    "source.toml": ("collate --sources %/.. own-1", "sources --sources %/.."),
    "weg.csv": ("collate --sources %/.. own-1",),
    "sweep.toml": ("sweep @ --dry-run", "sweep @ -o out/s.csv -j 1"),
    "rod.csv": ("inertia --rod-file @ --stroke 240mm --ratio 1:5 --step 90",),
    "scan.csv": ("collate --csv @ --quantity p --ratio 1:4",),
    "torque.csv": ("turning --torque-file @ --step 90", "delta --torque-file @ --columns delta"),
    "cards/*.csv": ("delta --card @", "turning --card @ --step 90", "power --card @"),
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


class Choice(NamedTuple):
    """An option, or an argument without a flag, with values that are likely to be good; None takes none."""

    flag: str
    values: Sequence[str] | None


def options_of(command: click.Command, files: Sequence[str]) -> list[Choice]:
    """Return what a command takes. Good values are those that shells offer, and examples in the help."""
    found = []
    context = click.Context(command, info_name=command.name)
    for param in command.get_params(context):
        flag = max(param.opts, key=len) if isinstance(param, click.Option) else ""
        if getattr(param, "is_flag", False):
            found.append(Choice(flag, None))
            continue
        if param.name == "output":
            values: Sequence[str] = OUTPUTS
        elif (
            isinstance(param.type, click.Path) or "FILE" in str(param.metavar) or "DIR" in str(param.metavar)
        ):
            values = files
        else:
            known = [one.value for one in param.shell_complete(context, "") if one.type == "plain"]
            said = re.findall(r"[^\s;,()]*\d[^\s;()]*(?<![.,:])", getattr(param, "help", None) or "")
            values = [*known, *said]
        found.append(Choice(flag, values))
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


def random_line(
    known: Sequence[tuple[tuple[str, ...], Sequence[Choice]]], chance: random.Random
) -> list[str]:
    """Return a command with one to six of its options."""
    words, options = chance.choice(known)
    line = list(words)
    for one in chance.sample(options, min(len(options), chance.choice((1, 1, 2, 3, 4, 6)))):
        if one.values is None:
            line.append(one.flag)
        else:
            value = value_of(one.values, chance)
            line.append(f"{one.flag}={value}" if one.flag else value)
    return line


def value_of(good: Sequence[str], chance: random.Random) -> str:
    """Return a good value, a strange one, two of them, or one that is damaged."""
    value = chance.choice(good if good and chance.random() < 0.6 else STRANGE)
    if chance.random() < 0.1:
        value += chance.choice((";", ",", "..", ":", " ", "")) + chance.choice((*good, *STRANGE))
    if value and chance.random() < 0.1:
        place = chance.randrange(len(value))
        value = value[:place] + chance.choice("0123456789.,:;/°'-+e∞% xcpφ=()") + value[place + 1 :]
    return value


def damaged(content: bytes, chance: random.Random) -> bytes:
    """Return a content with one to three faults: in bytes, lines, numbers, nesting or encoding."""
    for _ in range(chance.randint(1, 3)):
        lines = content.split(b"\n")
        place, row = chance.randrange(len(content) + 1), chance.randrange(len(lines))
        match chance.randrange(10):
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
                numbers = [*re.finditer(rb"[\d.,]+", content)]
                if numbers:
                    one = chance.choice(numbers)
                    content = content[: one.start()] + value + content[one.end() :]
            case 7:
                content = (
                    content[:place]
                    + chance.choice((b"[", b"]", b"{", b'"', b"=", b"<!--", b"]]"))
                    * chance.choice((1, 1, 500))
                    + content[place:]
                )
            case 8:
                text = content.decode(errors="replace")
                content = text.encode(chance.choice(("utf-16", "latin-1", "utf-8-sig")), errors="replace")
            case 9:
                lines[row] = lines[row] * chance.choice((0, 2, 300))
                content = b"\n".join(lines)
    return content


def fill(work: Path) -> None:
    """Make the folder in which commands run."""
    shutil.copytree(CORPUS / "files", work)
    shutil.copytree(ROOT / "examples", work / "examples", dirs_exist_ok=True)
    (work / "sweep.toml").write_text(SWEEP)
    (work / "out").mkdir()


def readers_in(work: Path) -> dict[Path, Sequence[str]]:
    """Return the files that commands read, each with these."""
    found: dict[Path, Sequence[str]] = {}
    for pattern, lines in READERS.items():
        for path in sorted(work.rglob(pattern)):
            found.setdefault(path.relative_to(work), lines)
    return found


def damaging_line(readers: dict[Path, Sequence[str]], chance: random.Random, work: Path) -> list[str]:
    """Damage a file and return a command that reads it."""
    path = chance.choice(list(readers))
    line = chance.choice(readers[path])
    (work / path).write_bytes(damaged((work / path).read_bytes(), chance))
    return [one.replace("@", str(path)).replace("%", str(path.parent)) for one in shlex.split(line)]


def limited() -> None:
    """Let this process have so much more memory than it has."""
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + BYTES, resource.RLIM_INFINITY))


def wrong(words: Sequence[str], work: Path) -> str:
    """Run a command and return what is wrong with what came of it, or nothing."""
    before = state(work)
    limited()
    code, out, err = kurbel(tuple(words), {}, SECONDS)
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    if code not in CODES:
        return str(code)
    if b"Traceback" in err:
        return err.decode(errors="replace")[-300:]
    if code and not err.strip() and not out:
        return f"ends with {code} and says nothing"
    telling = any(word in TELLING for word in words)
    if code in (1, 2) and out and not telling:
        return f"ends with {code} and prints {len(out)} bytes"
    # What is asked for by name may begin with a dot.
    left = [one for one in sorted(state(work).keys() - before.keys()) if one.split("/")[0] not in words]
    if left and code and not telling:
        return f"ends with {code} and leaves {', '.join(left[:3])}"
    if hidden := [
        one for one in left if re.search(r"(^|/)\.(?!kurbel/|kurbel$|gitignore$)|\.(tmp|parts)(/|$)", one)
    ]:
        return f"leaves {', '.join(hidden[:3])}"
    return ""


def state(work: Path) -> dict[str, tuple[int, int]]:
    """Return what is in the folder, and what changes as it is written."""
    found = {str(path.relative_to(work)): path.lstat() for path in work.rglob("*")}
    return {name: (one.st_size, one.st_mtime_ns) for name, one in found.items()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("what", choices=["lines", "files"])
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first one: repeats a single one")
    parser.add_argument("--keep", type=Path, help="a new folder in which to work, and that stays")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="kurbel-fuzz-") as folder:
        work = (chosen.keep or Path(folder) / "work").resolve()
        found = fuzzed(chosen, work)
    print(f"{chosen.count} {chosen.what} with seed {chosen.seed}: {found} failed")
    return int(found > 0)


def fuzzed(chosen: argparse.Namespace, work: Path) -> int:
    """Return how many commands failed; each is printed."""
    from kurbel.cli.app import cli

    fill(work)
    clean, readers = state(work), readers_in(work)
    known = [(words, options_of(command, sorted(clean))) for words, command in commands(cli)]
    found = 0
    for number in range(chosen.first, chosen.first + chosen.count):
        chance = random.Random(f"{chosen.what} {chosen.seed} {number}")
        words = damaging_line(readers, chance, work) if chosen.what == "files" else random_line(known, chance)
        with chdir(work):
            said = wrong(words, work)
        if said:
            found += 1
            print(f"# {number}: {said}\nkurbel {shlex.join(words)}", flush=True)
        if number < chosen.first + chosen.count - 1 and state(work) != clean:
            shutil.rmtree(work)
            fill(work)
            clean = state(work)
    return found


if __name__ == "__main__":
    sys.exit(main())
