"""Faults put into the code on purpose: which of them do the tests see?

    make mutants N=300 SEED=1

draws N faults by this seed from all of src/kurbel, every kind as often: another operator, comparison or
constant, a `not` dropped, `and` for `or`, a statement left out, another default. Each is written into a copy
of the project, and the fast tests that reach its line run there, the cheapest of each file first, until one
fails that passes without the fault, or a minute of them has passed. Which tests reach which line is measured
once, in the same copy, and kept in build/mutants until the code changes. A fault that no test sees is printed
as it is to stand in scripts/survivors.toml, with the reason why it changes nothing that anybody could see:
those are not counted. Ends with 1 where fewer than 95 % of the others are seen.
"""

from __future__ import annotations

import argparse
import ast
import importlib
import json
import math
import multiprocessing
import os
import re
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import closing
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import pytest
from coverage.numbits import numbits_to_nums

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "mutants"
SURVIVORS = ROOT / "scripts" / "survivors.toml"
SOURCE = Path("src") / "kurbel"
WANTED = 0.95
# Libraries that take long to load, and start no thread.
LOADED = (
    "click",
    "flint",
    "jinja2",
    "markdown_it",
    "matplotlib.figure",
    "mpmath",
    "numpy.testing",
    "scipy.optimize",
)
# Tests are tried so many at first, and then as many as take so many seconds; seconds of processor time that
# they may take beyond twice their own, and how many times as long a busy machine may take for them.
FIRST, MOST, PATIENCE, BUSY = 12, 60, 60, 20
OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult,
    ast.Mod: ast.FloorDiv, ast.Pow: ast.Mult, ast.LShift: ast.RShift, ast.RShift: ast.LShift,
}  # fmt: skip
COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip


class Fault(NamedTuple):
    """A fault of one kind: the lines and columns of what it replaces, and by what; `within` are the lines of
    which a test has to reach one."""

    path: str
    kind: str
    start: tuple[int, int]
    end: tuple[int, int]
    old: str
    new: str
    line: str
    within: tuple[int, int]

    def __str__(self) -> str:
        return f"{self.path}:{self.start[0]}: {self.kind}: {self.old} -> {self.new}"

    @property
    def words(self) -> dict[str, str]:
        """What tells it apart wherever its line has moved."""
        return {"path": self.path, "line": self.line, "old": self.old, "new": self.new}

    def put_into(self, text: str) -> str:
        lines = text.encode().splitlines(keepends=True)
        (first, left), (last, right) = self.start, self.end
        before, after = lines[first - 1][:left], lines[last - 1][right:]
        lines[first - 1 : last] = [before + self.new.encode() + after]
        return b"".join(lines).decode()


class Finder(ast.NodeVisitor):
    """Finds every place of a module at which a fault can be put."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.lines = path, text.encode().splitlines()
        self.found: list[Fault] = []
        # What is run when a module is loaded, in whichever test that is, is looked at by all that reach it.
        self.within: tuple[int, int] | None = (1, len(self.lines))

    def add(self, kind: str, node: ast.AST, new: ast.AST | str) -> None:
        assert isinstance(node, ast.expr | ast.stmt)
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        whole = self.lines[node.lineno - 1 : node.end_lineno]
        whole[-1] = whole[-1][: node.end_col_offset]
        whole[0] = whole[0][node.col_offset :]
        changed = new if isinstance(new, str) else f"({ast.unparse(new)})"
        start, end = (node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset)
        old, line = " ".join(b" ".join(whole).decode().split()), self.lines[node.lineno - 1].decode().strip()
        within = self.within or (start[0], end[0])
        self.found.append(Fault(self.path, kind, start, end, old, changed, line, within))

    def visit_BinOp(self, node: ast.BinOp) -> None:
        other = OPERATORS.get(type(node.op))
        # Texts that are put together are left.
        if other and not isinstance(node.left, ast.JoinedStr | ast.Tuple):
            self.add("operator", node, ast.BinOp(node.left, other(), node.right))
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        other = COMPARISONS[type(node.ops[0])]()
        self.add("comparison", node, ast.Compare(node.left, [other, *node.ops[1:]], node.comparators))
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        other = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        self.add("and, or", node, ast.BoolOp(other, node.values))
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        if isinstance(node.op, ast.Not):
            self.add("not", node, node.operand)
        elif isinstance(node.op, ast.USub):
            self.add("operator", node, node.operand)
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, bool):
            self.add("constant", node, str(not node.value))
        elif isinstance(node.value, int | float):
            self.add("constant", node, str(node.value + 1))

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Leave it: Python 3.11 does not say where its parts stand."""

    def visit_Expr(self, node: ast.Expr) -> None:
        if isinstance(node.value, ast.Constant):
            return
        self.add("statement", node, "pass")
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        self.add("statement", node, "pass")
        self.generic_visit(node)

    def visit_Raise(self, node: ast.Raise) -> None:
        self.add("statement", node, "pass")

    def visit_Continue(self, node: ast.Continue) -> None:
        self.add("statement", node, "pass")

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value:
            self.visit(node.value)

    def visit_If(self, node: ast.If) -> None:
        if not (isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"):
            self.generic_visit(node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        # An overload, or what a protocol asks for, is never run.
        if isinstance(node.body[-1], ast.Expr) and ast.unparse(node.body[-1]) == "...":
            return
        defaults = [*node.args.defaults, *(one for one in node.args.kw_defaults if one)]
        above, self.within = self.within, (node.body[0].lineno, node.end_lineno or node.lineno)
        for default in defaults:
            if isinstance(default, ast.Constant) and default.value not in (None, "", ...):
                if isinstance(default.value, bool):
                    new = str(not default.value)
                else:
                    new = "''" if isinstance(default.value, str) else "3" if default.value == 2 else "2"
                self.add("default", default, new)
        for decorator in node.decorator_list:
            self.visit(decorator)
        self.within = None
        for one in node.body:
            self.visit(one)
        self.within = above


def faults() -> list[Fault]:
    found = []
    for path in sorted((ROOT / SOURCE).rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        finder = Finder(str(path.relative_to(ROOT)), text)
        finder.visit(ast.parse(text))
        found += finder.found
    return found


def drawn(count: int, seed: int, only: str) -> list[Fault]:
    """Return so many faults, of every kind as many; another line that changes, or moves, leaves the rest."""

    kinds: dict[str, list[tuple[str, Fault]]] = defaultdict(list)
    alike: Counter[str] = Counter()
    for fault in faults():
        if re.search(only, fault.path):
            text = f"{seed} {fault.line} {fault.old} {fault.new}"
            rank = sha256(f"{text} {alike[text] or ''}".rstrip().encode()).hexdigest()
            alike[text] += 1
            kinds[fault.kind].append((rank, fault))
    groups = [sorted(kinds[kind]) for kind in sorted(kinds)]
    rounds = (group[turn] for turn in range(max(map(len, groups))) for group in groups if turn < len(group))
    return [fault for (_, fault), _ in zip(rounds, range(count), strict=False)]


class Copy:
    """A copy of the project whose tests run on its own sources."""

    def __init__(self, name: str) -> None:
        self.folder = FOLDER / name
        shutil.rmtree(self.folder, ignore_errors=True)
        for name in tracked():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, self.folder / name)
        modules = ROOT / "tests" / "node_modules"
        if modules.exists():
            (self.folder / "tests" / "node_modules").symlink_to(modules)
        # Tests of root turn into somebody else, as whom the lines that they reach are written down.
        self.folder.chmod(0o777)
        self.clock = 0.0
        self.sound: dict[str, bool] = {}

    def pytest(self, words: Sequence[str], seconds: float | None = None) -> int | None:
        """Run tests in a fork of this process, which has loaded what they need but kurbel.

        Return how they ended; None says that they came to no end, a number below 0 that they took more than
        so many seconds of processor time.
        """
        child = os.fork()
        if not child:
            os.setsid()
            if seconds:
                resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds)))
            os.chdir(self.folder)
            log = os.open("log", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            for stream in (1, 2):
                os.dup2(log, stream)
            paths = [str(self.folder / "src"), str(ROOT / "scripts")]
            sys.path[:0] = paths
            os.environ.update(PYTHONPATH=os.pathsep.join(paths), CI="", KURBEL_PROMOTE="")
            code: int = pytest.ExitCode.INTERNAL_ERROR
            try:
                code = pytest.main(["-q", "-p", "no:cacheprovider", "--hypothesis-seed=0", *words])
            finally:
                # Whatever a fault lets through, this process never goes on as one that tries faults.
                os._exit(code)
        until = time.monotonic() + BUSY * (seconds or math.inf)
        while True:
            pid, status = os.waitpid(child, os.WNOHANG)
            if pid:
                return os.waitstatus_to_exitcode(status)
            if time.monotonic() > until:
                os.killpg(child, signal.SIGKILL)
                os.waitpid(child, 0)
                return None
            time.sleep(0.02)

    def is_seen(self, fault: Fault, tests: Sequence[str], seconds: float) -> bool:
        """Return whether one of these tests fails with this fault in the code, and passes without it."""
        left = [one for one in tests if self.sound.get(one, True)]
        while left:
            place = self.folder / fault.path
            kept = place.read_text(encoding="utf-8")
            place.write_text(fault.put_into(kept), encoding="utf-8")
            try:
                self._renew(place)
                code = self._chosen(left, seconds)
            finally:
                place.write_text(kept, encoding="utf-8")
                self._renew(place)
            if code == 0:
                return False
            log = (self.folder / "log").read_text(encoding="utf-8", errors="replace")
            if code == 5:
                raise SystemExit(f"no test was found for {fault}; see {self.folder / 'log'}")
            # A test whose name the fault changes says nothing, and none of the others is run.
            gone = set(re.findall(r"^ERROR: not found: .*?([^/\n]+\.py::[^\[\n]+)", log, re.M))
            named = [one for one in left if one.partition("[")[0].rpartition("/")[2] in gone] or [
                one for one in left if re.search(rf"^(FAILED|ERROR) {re.escape(one)}( - |$)", log, re.M)
            ]
            if code == 1 and named and all(self._passes(one, seconds) for one in named):
                return True
            if not named:
                # It does not even start, or comes to no end.
                return True
            left = [one for one in left if one not in named]
        return False

    def _passes(self, test: str, seconds: float) -> bool:
        """Return whether a test passes alone without a fault."""
        if test not in self.sound:
            self.sound[test] = self._chosen([test], seconds) == 0
            if not self.sound[test]:
                print(f"{test} fails without a fault, and counts for none", file=sys.stderr)
        return self.sound[test]

    def _chosen(self, tests: Sequence[str], seconds: float) -> int | None:
        chosen = self.folder / "chosen"
        chosen.write_text("\n".join(tests), encoding="utf-8")
        return self.pytest(("-x", "--tb=no", f"@{chosen}"), 2 * seconds + PATIENCE)

    def _renew(self, place: Path) -> None:
        """Make the file newer than what was compiled of it, by more than a second."""
        self.clock += 2
        newer = place.stat().st_mtime + self.clock
        os.utime(place, (newer, newer))


def tracked() -> list[str]:
    words = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    return [name for name in names if name and (ROOT / name).is_file()]


class Reach:
    """Which test reaches which line, in which time."""

    def __init__(self, processes: int) -> None:
        state = sha256()
        for name in tracked():
            if name.startswith(("src", "tests", "templates")):
                state.update(name.encode() + (ROOT / name).read_bytes())
        self.lines, self.seconds = FOLDER / "reach.sqlite", FOLDER / "seconds.json"
        mark = FOLDER / "state"
        if not mark.exists() or mark.read_text() != state.hexdigest():
            mark.unlink(missing_ok=True)
            self._measure(processes)
            mark.write_text(state.hexdigest())

    def _measure(self, processes: int) -> None:
        copy = Copy("0")
        print("measuring which tests reach which line", file=sys.stderr)
        plugins = ("-p", "mutants", "--cov=src/kurbel", "--cov-context=test", "--cov-report=")
        copy.pytest(
            (
                "-m",
                "not slow",
                "-n",
                str(processes),
                "--dist",
                "loadfile",
                *plugins,
                "-k",
                "not read_only_directory and not read_only_document and not in_which_kurbel_runs",
                "tests",
            )
        )
        shutil.move(copy.folder / "seconds.json", self.seconds)
        shutil.move(copy.folder / ".coverage", self.lines)

    @cached_property
    def passed(self) -> dict[str, float]:
        times: dict[str, float] = json.loads(self.seconds.read_text(encoding="utf-8"))
        return times

    @cached_property
    def beside(self) -> dict[str, list[str]]:
        """By file the tests."""
        found: dict[str, list[str]] = defaultdict(list)
        for test in self.passed:
            found[test.partition("::")[0]].append(test)
        return found

    @cached_property
    def contexts(self) -> dict[str, dict[int, list[str]]]:
        """By module and line the tests."""
        found: dict[str, dict[int, list[str]]] = defaultdict(lambda: defaultdict(list))
        with closing(sqlite3.connect(self.lines)) as data:
            query = (
                "SELECT file.path, context.context, line_bits.numbits FROM line_bits"
                " JOIN file ON file.id = line_bits.file_id JOIN context ON context.id = line_bits.context_id"
            )
            for path, context, bits in data.execute(query):
                module = str(SOURCE) + path.rpartition(str(SOURCE))[2]
                test = context.rpartition("|")[0]
                for line in numbits_to_nums(bits):
                    found[module][line].append(test)
        return found

    def of(self, fault: Fault) -> Iterator[list[str]]:
        """Yield the tests that reach a fault in parts: the cheapest of each file, its package's, others."""
        own = f"tests/{Path(fault.path).parts[2]}/"
        module = self.contexts[fault.path]
        span = range(fault.within[0], fault.within[1] + 1)
        tests = {test for line in span for test in module[line] if test in self.passed}
        if not tests:
            # It is run when the module is loaded, or reached by a process of its own.
            tests = {test for line in module.values() for test in line if test in self.passed}
        if not tests:
            tests = {test for test in self.passed if test.startswith(own)}
        ordered = sorted(tests, key=self.passed.__getitem__)
        files: dict[str, str] = {}
        for test in ordered:
            files.setdefault(test.partition("::")[0], test)
        first = sorted(files.values(), key=self.passed.__getitem__)[:FIRST]
        # What one test of a file has made, in a fixture or kept by a function, the others look at as well.
        others = {test for file in files for test in self.beside[file]} - tests
        ordered.sort(key=lambda test: not test.startswith(own))
        ordered += sorted(others, key=self.passed.__getitem__)
        spent, rest = 0.0, []
        for test in (one for one in ordered if one not in first):
            spent += self.passed[test]
            if spent < MOST:
                rest.append(test)
        half = len(rest) // 2
        yield from (part for part in (first, rest[:half], rest[half:]) if part)


def known() -> dict[tuple[str, ...], str]:
    """Return the reasons why faults are not seen."""
    if not SURVIVORS.exists():
        return {}
    told = tomllib.loads(SURVIVORS.read_text(encoding="utf-8")).get("fault", [])
    return {(one["path"], one["line"], one["old"], one["new"]): one["reason"] for one in told}


def _start() -> None:
    """Give a process its copy, and load what tests load."""
    global _copy
    _copy = Copy(str(multiprocessing.current_process()._identity[0]))
    for name in LOADED:
        importlib.import_module(name)


def _seen(tried: tuple[Fault, list[list[str]], dict[str, float]]) -> bool:
    fault, parts, passed = tried
    return any(_copy.is_seen(fault, tests, sum(map(passed.__getitem__, tests))) for tests in parts)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--only", default="", help="a regular expression that the path of a module has to match"
    )
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    reach, reasons = Reach(asked.processes), known()
    sample = drawn(asked.count, asked.seed, asked.only)
    counted: Counter[str] = Counter()
    kinds: dict[str, Counter[str]] = defaultdict(Counter)
    tried = [(fault, list(reach.of(fault)), reach.passed) for fault in sample]
    # Workers of a pool of multiprocessing are daemons, in which no test can have processes of its own.
    context = multiprocessing.get_context("fork")
    with ProcessPoolExecutor(asked.processes, context, _start) as pool:
        for fault, is_seen in zip(sample, pool.map(_seen, tried), strict=True):
            outcome = "seen" if is_seen else "equivalent" if (*fault.words.values(),) in reasons else "unseen"
            counted[outcome] += 1
            kinds[fault.kind][outcome] += 1
            if outcome == "unseen":
                print(f"\n# {fault}\n[[fault]]")
                for key, text in (fault.words | {"reason": ""}).items():
                    print(f"{key} = {json.dumps(text, ensure_ascii=False)}", flush=True)
            told = ", ".join(f"{number} {name}" for name, number in counted.items())
            print(f"{counted.total()} of {len(sample)}: {told}", file=sys.stderr, flush=True)
    print()
    for kind, outcomes in sorted(kinds.items()):
        print(f"{kind:12}", *(f"{outcomes[name]:4} {name}" for name in ("seen", "equivalent", "unseen")))
    share = counted["seen"] / max(1, counted["seen"] + counted["unseen"])
    print(f"{share:.1%} of {counted['seen'] + counted['unseen']} faults that are not equivalent are seen")
    return int(share < WANTED)


# As a plugin of pytest it writes down which tests passed in which time. ------------------------------

_copy: Copy
_passed: dict[str, float] = {}


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    before = sum(os.times()[:4])
    yield
    item.user_properties.append(("seconds", sum(os.times()[:4]) - before))


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.when == "call" and report.passed:
        _passed[report.nodeid] = float(str(dict(report.user_properties)["seconds"]))


def pytest_sessionfinish(session: object) -> None:
    if "PYTEST_XDIST_WORKER" not in os.environ:
        Path("seconds.json").write_text(json.dumps(_passed), encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
