"""Tell whether two versions of kurbel print the same bytes, over the command lines of scripts/corpus.

    PYTHON scripts/same_bytes.py record FILE          # with the Python of the version that is to be recorded
    PYTHON scripts/same_bytes.py compare OLD NEW
    PYTHON scripts/same_bytes.py list

The base is the last release, and `make same` does all of this. By hand:

    git worktree add ../base v0.3.0               # without the tag, the commit that dated it in CHANGELOG.md
    PYTHONPATH=$(realpath ../base)/src .venv/bin/python scripts/same_bytes.py record build/base.jsonl
    .venv/bin/python scripts/same_bytes.py record build/now.jsonl
    .venv/bin/python scripts/same_bytes.py compare build/base.jsonl build/now.jsonl

A recording holds the exit code, standard output and standard error of every command line, and the files that
it wrote. `compare` shows what differs, but for what corpus/wanted.toml names, and then ends with 1.
"""

from __future__ import annotations

import argparse
import hashlib
import io
import json
import os
import re
import shutil
import signal
import sys
import tempfile
import time
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, chdir, redirect_stderr, redirect_stdout
from decimal import Decimal
from difflib import unified_diff
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias
from unittest import mock

from command_lines import CORPUS, Command, command_lines, commands_of

HANDLED = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
# What pages depend on beside the command line.
SETTLED = {"COLUMNS": "80", "LINES": "24", "SOURCE_DATE_EPOCH": "1000000000", "PYTHONHASHSEED": "0"}
# What is longer is told by its hash alone.
LONGEST = 200_000
# Processor time in seconds, after which a command counts as endless.
MOST_SECONDS = 60
# What a handbook knows of its last build, which depends on the files of the program.
STATE = ".kurbel"
# The line, its `runs` (exit code, standard output, standard error) and its `files` with what stands in them.
Came: TypeAlias = dict[str, Any]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("what", choices=["record", "compare", "list"])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--only", default="", metavar="REGEX", help="command lines with this")
    parser.add_argument("--sample", default=1, type=int, metavar="N", help="every Nth of them")
    parser.add_argument("--lines", default=12, type=int, help="compare: lines shown of each difference")
    parser.add_argument("--shown", default=40, type=int, help="compare: differences shown")
    chosen = parser.parse_args()
    files = {"record": 1, "compare": 2, "list": 0}[chosen.what]
    if len(chosen.files) != files:
        parser.error(f"{chosen.what} takes {files} files")
    if chosen.what == "compare":
        old, new = map(read, chosen.files)
        return compare(old, new, chosen)
    lines = [line for line in command_lines() if re.search(chosen.only, line)][:: chosen.sample]
    if chosen.what == "list":
        print(*lines, sep="\n")
    else:
        record(lines, chosen.files[0])
    return 0


# Recording.


def record(lines: Iterable[str], path: Path) -> None:
    """Run the command lines in a folder of their own and write what came of each, one JSON object a line."""
    path.parent.mkdir(parents=True, exist_ok=True)
    times: list[tuple[float, str]] = []
    with tempfile.TemporaryDirectory() as folder, path.open("w", encoding="utf-8") as recording:
        work = Path(folder).resolve()
        prepare(work)
        recording.write(json.dumps({"inputs": hash_of_folder(work)}) + "\n")
        for line in lines:
            before = time.process_time()
            with chdir(work):
                came = outcome(line, work)
            recording.write(json.dumps(came, ensure_ascii=False) + "\n")
            times.append((time.process_time() - before, line))
    print(f"{len(times)} command lines, {sum(one for one, _ in times):.0f} s of processor time; the slowest:")
    for seconds, line in sorted(times, reverse=True)[:10]:
        print(f"{seconds:7.1f} s  {line[:100]}", flush=True)


def prepare(work: Path) -> None:
    """Fill the folder with all files that command lines name."""
    shutil.copytree(CORPUS / "files", work, dirs_exist_ok=True)
    (work / "large.csv").write_text("position,p_forward [bar],p_return [bar]\n" + "\n" * 2_000_000)
    (work / "long.md").write_text("x" * 200_001)
    (work / "wide.md").write_text("<!-- kurbel: table -->", encoding="utf-16")
    (work / "latin.md").write_text("Größe\n<!-- kurbel: table -->\n<!-- /kurbel -->\n", encoding="latin-1")
    (work / "large.toml").write_text("# " + "x" * 30_000)
    (work / "deep.toml").write_text("x = " + "[" * 5000)
    (work / "dotted.toml").write_text(".".join("a" * 5000) + " = 1")
    (work / "long-scan.csv").write_text(
        "phi;1:5\n" + "".join(f"{at / 20:.2f};{at % 97 / 100:.2f}\n" for at in range(7200))
    )


def hash_of_folder(folder: Path) -> str:
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    pieces = (f"{path.relative_to(folder)} {hash_of(path.read_bytes())}" for path in files)
    return hash_of("\n".join(pieces).encode())


def hash_of(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def outcome(line: str, work: Path) -> Came:
    """Return what the commands of a line print, and the files that stand in `out` afterwards."""
    out = work / "out"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    for name in dict.fromkeys(re.findall(r"\bout/([\w.-]+)", line)):
        given = work / "given" / name
        if given.is_dir():
            shutil.copytree(given, out / name)
        elif given.is_file():
            shutil.copy(given, out / name)
    runs = [run(command, str(work)) for command in commands_of(line)]
    return {"line": line, "runs": runs, "files": dict(written(out, work / "given"))}


def written(out: Path, given: Path) -> Iterator[tuple[str, str]]:
    """Yield the files that are not as they were given, with what stands in them."""
    for path in sorted(out.rglob("*")):
        name = path.relative_to(out)
        if path.is_file() and STATE not in name.parts:
            content = path.read_bytes()
            if not (given / name).is_file() or (given / name).read_bytes() != content:
                yield name.as_posix(), shown(content)


def run(command: Command, work: str) -> list[Any]:
    """Return exit code, standard output and standard error of a command run in this process."""
    if command.words and command.words[0] in DONE_HERE:
        return [done_here(*command.words), "", ""]
    code, out, err = kurbel(command.words, command.environment)
    return [code, *(shown(one.replace(work.encode(), b"WORK")) for one in (out, err))]


def _written(path: str, text: str) -> None:
    Path(path).write_bytes(text.encode("utf-8", errors="surrogateescape"))


def done_here(name: str, *words: str) -> int | str:
    try:
        DONE_HERE[name](*words)
    except OSError as error:
        # What should stand there, the program did not write.
        return str(error)
    return 0


DONE_HERE: Mapping[str, Callable[..., object]] = {
    "cp": shutil.copy, "ln": os.symlink, "rm": os.remove, "mkdir": os.mkdir, "write": _written,
}  # fmt: skip


class EndlessError(BaseException):
    """Ends a command, which is not to take it for a mistake of its own."""


def end(number: int, frame: object) -> None:
    raise EndlessError


def kurbel(
    words: tuple[str, ...], environment: Mapping[str, str], seconds: float = MOST_SECONDS
) -> tuple[int | str, bytes, bytes]:
    """Run `kurbel` with these words; an exception that leaves it stands for the exit code."""
    from kurbel.cli import main as program

    streams = [io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True) for _ in range(2)]
    clean = {name: value for name, value in os.environ.items() if "KURBEL" not in name}
    handlers = {number: signal.getsignal(number) for number in HANDLED}
    code: int | str = ""
    with ExitStack() as stack:
        stack.enter_context(mock.patch.object(sys, "argv", ["kurbel", *words]))
        stack.enter_context(mock.patch.dict(os.environ, {**clean, **SETTLED, **environment}, clear=True))
        stack.enter_context(redirect_stdout(streams[0]))
        stack.enter_context(redirect_stderr(streams[1]))
        signal.signal(signal.SIGPROF, end)
        signal.setitimer(signal.ITIMER_PROF, seconds)
        try:
            program()
        except SystemExit as end_of_program:
            code = end_of_program.code or 0
            if code == 128 + signal.SIGTERM:
                raise
        except EndlessError:
            code = f"more than {seconds:g} s of processor time"
        except Exception as error:
            code = f"{type(error).__name__}: {error}"
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            for number, handler in handlers.items():
                signal.signal(number, handler)
    out, err = (content_of(stream) for stream in streams)
    return code, out, err


def content_of(stream: io.TextIOWrapper) -> bytes:
    stream.flush()
    assert isinstance(stream.buffer, io.BytesIO)
    return stream.buffer.getvalue()


def shown(content: bytes) -> str:
    """Return the content if it is text that is not too long, else its hash."""
    text = content.decode("utf-8", errors="replace")
    if "\ufffd" not in text and "\0" not in text and len(content) <= LONGEST:
        return text
    return f"{len(content)} bytes with the hash {hash_of(content)}"


# Comparing.


class Recording(NamedTuple):
    """The hash of the files that commands could read, and what came of each command line."""

    inputs: str
    came: dict[str, Came]


def read(path: Path) -> Recording:
    with path.open(encoding="utf-8") as recording:
        inputs = json.loads(next(recording))["inputs"]
        return Recording(inputs, {one["line"]: one for one in map(json.loads, recording)})


def compare(old: Recording, new: Recording, chosen: argparse.Namespace) -> int:
    """Print what differs between two recordings; return 1 if there is something that is not wanted."""
    if old.inputs != new.inputs:
        print("the two recordings were made with other files; make both anew with the same scripts/corpus")
    changes = tomllib.loads((CORPUS / "wanted.toml").read_text(encoding="utf-8")).get("change", [])
    lines = [line for line in old.came if line in new.came and re.search(chosen.only, line)]
    different = [line for line in lines if old.came[line] != new.came[line]]
    left = [line for line in different if not is_wanted(old.came[line], new.came[line], changes)]
    for line in left[: chosen.shown]:
        print(f"\n$ {line}", *difference(old.came[line], new.came[line], chosen.lines), sep="\n")
    if len(left) > chosen.shown:
        print("\nand in these:", *left[chosen.shown :], sep="\n$ ")
    print(
        f"\n{len(lines)} command lines compared: {len(lines) - len(different)} the same,"
        f" {len(different) - len(left)} differ as wanted, {len(left)} differ;"
        f" {len(old.came.keys() ^ new.came.keys())} stand in one recording only"
    )
    return int(bool(left) or old.inputs != new.inputs or not lines)


def is_wanted(old: Came, new: Came, changes: Sequence[Mapping[str, str]]) -> bool:
    """Tell whether the wanted changes, each a pattern and what takes its place, make the new of the old.

    A change of `figures` is one of the look of pages: exit code, errors and every printed decimal stay, or it
    stands there with all its digits in a unit a thousand or a million times as large. One without a pattern
    is of command lines whose difference was read and is wanted as it is.
    """
    text, alike = "\0".join(said(old)), False
    for change in changes:
        if re.search(change.get("lines", ""), old["line"]):
            if "figures" in change:
                alike = True
            elif "old" not in change:
                return True
            else:
                text = re.sub(change["old"], change["new"], text)
    fresh = [*said(new)]
    return text == "\0".join(fresh) or (alike and has_figures_of(text.split("\0"), fresh))


# What is no figure of a table: a style sheet, a drawing, and a measure of typography.
_LOOK = re.compile(
    r"(?s:<style.*?</style>|<svg.*?</svg>)|</?[a-z][^<>]*>|[0-9.]+(?:(?:em|rem|pt|px|mm|cm|ch|%|fr)\b|\\[a-z])"
)
_DECIMAL = re.compile(r"(?<![\w.,:])[0-9]+[.,][0-9]+(?![\w.,])")


def has_figures_of(old: Sequence[str], new: Sequence[str]) -> bool:
    """Tell whether no decimal of the old is lost, and all but the pages is the same."""
    return len(old) == len(new) and all(
        one == other or (_place(one) == _place(other) != "err" and has_decimals_of(one, other))
        for one, other in zip(old, new, strict=True)
    )


def _place(said: str) -> str:
    return said.partition(":")[0]


def has_decimals_of(old: str, new: str) -> bool:
    there = decimals(new)
    return all(
        any(str(Decimal(one).scaleb(-power)) in there for power in (0, 3, 6)) for one in decimals(old) - there
    )


def decimals(text: str) -> set[str]:
    return {one.replace(",", ".") for one in _DECIMAL.findall(_LOOK.sub(" ", text.replace("{,}", ",")))}


def difference(old: Came, new: Came, most: int) -> list[str]:
    """Return the first lines of the difference, of all that came of a command line."""
    texts = [[line for text in said(one) for line in text.split("\n")] for one in (old, new)]
    lines = list(unified_diff(texts[0], texts[1], "old", "new", n=1, lineterm=""))
    return [line[:300] for line in lines[:most]] + ["..."] * (len(lines) > most)


def said(one: Came) -> Iterator[str]:
    """Yield the texts of a recorded outcome, each behind where it stood."""
    for code, out, err in one["runs"]:
        yield from (f"exit code {code}", f"out: {out}", f"err: {err}")
    for name, content in one["files"].items():
        yield f"{name}: {content}"


if __name__ == "__main__":
    sys.exit(main())
