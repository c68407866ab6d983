"""What is loaded with what: libraries by the packages that need them, and what a command really loads.

Who may import whom of the floors, import-linter holds.
"""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from itertools import cycle
from pathlib import Path

import pytest

import kurbel
from kurbel.drive.mechanisms import SUBJECTS

PACKAGE = Path(kurbel.__file__).parent
HEAVY = {"numpy", "scipy", "matplotlib", "pint", "numba"}
# Who alone knows a library; where there is nobody it is loaded by its name.
KNOWN = {
    "click": "kurbel.cli",
    "jinja2": "kurbel.formats",
    "matplotlib": "kurbel.plot",
    "typst": "kurbel.formats.pdf",
    **dict.fromkeys(("dask", "distributed", "h5netcdf", "pyarrow", "xarray", "zarr"), "kurbel.sweeps"),
    "numba": "nobody",
}
MODULES = {
    ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__"): path
    for path in sorted(PACKAGE.rglob("*.py"))
}


SOURCES = {name: path.read_text(encoding="utf-8") for name, path in MODULES.items()}


def at_once(node: ast.AST) -> Iterator[ast.ImportFrom]:
    """Yield the imports that run as a module is imported itself, also those within `if` and `try`."""
    for one in ast.iter_child_nodes(node):
        if isinstance(one, ast.ImportFrom):
            yield one
        elif isinstance(one, ast.If) and ast.unparse(one.test) == "TYPE_CHECKING":
            yield from at_once(ast.Module(one.orelse, []))
        elif not isinstance(one, ast.FunctionDef | ast.expr):
            yield from at_once(one)


def test_a_library_is_known_to_those_alone_who_need_it() -> None:
    statement = re.compile(rf"^\s*(?:from|import) ({'|'.join(KNOWN)})\b", re.MULTILINE)
    for name, text in SOURCES.items():
        for library in statement.findall(text):
            assert f"{name}.".startswith(f"{KNOWN[library]}."), f"{name} imports {library}"


def test_no_circle_of_modules_that_import_each_other_as_they_are_imported() -> None:
    waiting: dict[str, set[str]] = {}
    for name, text in SOURCES.items():
        needed = waiting[name] = set()
        for one in at_once(ast.parse(text)):
            names = {f"{one.module}.{alias.name}" for alias in one.names}
            needed |= names if names <= MODULES.keys() else {*(names & MODULES.keys()), str(one.module)}
    while free := {name for name, needed in waiting.items() if not needed & waiting.keys()}:
        waiting = {name: needed for name, needed in waiting.items() if name not in free}
    assert not waiting


# Lines of one interpreter, one after the other: what a page loads stays loaded for those after it.
RUN = """import sys
import kurbel
for words in map(str.split, sys.argv[1].split(";;")):
    if words:
        from kurbel.cli import main
        sys.argv = ["kurbel", *words]
        try:
            main()
        except SystemExit as end:
            assert end.code == 0
    print("loaded:", *sys.modules, file=sys.stderr)
"""


def loaded(*lines: str) -> list[set[str]]:
    """Return the modules that a new interpreter has loaded after each line, of which "" only imports."""
    environment = {name: text for name, text in os.environ.items() if not name.startswith("KURBEL_")}
    paths = (str(PACKAGE.parent), os.environ.get("PYTHONPATH", ""))
    done = subprocess.run(
        [sys.executable, "-c", RUN, ";;".join(lines)],
        capture_output=True, text=True, check=True,
        env=environment | {"PYTHONPATH": os.pathsep.join(filter(None, paths))},
    )  # fmt: skip
    found = [{*line.split()[1:]} for line in done.stderr.splitlines() if line.startswith("loaded:")]
    assert len(found) == len(lines)
    return found


def test_import_and_help_load_no_library() -> None:
    libraries = {"click", "jinja2", "flint", "tabulate", *HEAVY}
    nothing, version, short, help_of_plot = loaded("", "--version", "-h", "plot --help")
    assert not nothing & libraries
    assert not (version | short) & {*libraries, "re", "typing"}
    assert not help_of_plot & HEAVY


@pytest.mark.parametrize("line", ["--help", "-h", "--version", "version"])
def test_kurbels_own_help_loads_hardly_anything_of_ours(line: str) -> None:
    (names,) = loaded(line)
    assert len({name for name in names if name.partition(".")[0] == "kurbel"}) <= 10


def test_a_small_page_loads_nothing_of_other_mechanisms_or_of_engines() -> None:
    for names in loaded("table --ratio 1:5", "solve --ratio 1:5 --where p=0"):
        assert not {one for one in names if one.startswith(("kurbel.linkage.", "kurbel.engine."))}


PAGES = (
    *("table --ratio 1:5", "delta --eps 2..6", "turning --eps 4", "deadcentres", "harmonics", "balance"),
    *(one.sample for one in SUBJECTS.values()),
    *("inertia --centre=0.6 --gyration=0.4", "inertia --centre=0.6 --gyration=0.4 --layout=inertia-errors"),
    *("forces --at tangent", "solve --where p=0", "example blau 33", "example weisbach 150"),
)
FORMATS = ("text", "csv", "json", "markdown", "latex", "html", "typst", "rst")


def test_a_page_is_made_without_numpy() -> None:
    # The first page in every format, the others in one after the other.
    lines = [f"{PAGES[0]} -f {name}" for name in FORMATS]
    lines += [f"{line} -f {name}" for line, name in zip(PAGES[1:], cycle(FORMATS), strict=False)]
    for line, names in zip(lines, loaded(*lines), strict=True):
        assert not names & HEAVY, line


@pytest.mark.parametrize(
    ("line", "needed", "spared"),
    [
        ("table --ratio 1:5", {"jinja2", "flint"}, {"msgspec"}),
        ("table --step 0.05 -f csv", set(), {"flint", "jinja2"}),
        ("table --ratio 1:5 -f csv --step 0.001 --to 90", {"numpy"}, {"jinja2", *HEAVY} - {"numpy"}),
    ],
)  # fmt: skip
def test_a_table_loads_what_it_needs(line: str, needed: set[str], spared: set[str]) -> None:
    (names,) = loaded(line)
    assert needed <= names
    assert not spared & names
