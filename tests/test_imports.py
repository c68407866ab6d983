"""The layers: who may import whom, read from the sources, and what a command really loads."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

import kurbel

PACKAGE = Path(kurbel.__file__).parent
HEAVY = ("numpy", "scipy", "matplotlib")


def modules() -> dict[str, Path]:
    """Return the source files of the package by their dotted names."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


MODULES = modules()


def imported(name: str) -> set[str]:
    """Return the dotted names of all that a module imports, be it inside a function or for types only."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    return set(imported_names(tree))


def imported_names(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            assert node.module is not None
            submodules = [f"{node.module}.{alias.name}" for alias in node.names]
            found = [one for one in submodules if one in MODULES]
            yield from found
            if len(found) < len(submodules):
                yield node.module


def reached(name: str) -> set[str]:
    """Return the modules of kurbel that a module imports, and those that they import."""
    found: set[str] = set()
    waiting = [name]
    while waiting:
        ours = {one for one in imported(waiting.pop()) if one in MODULES} - found
        found |= ours
        waiting += ours
    return found


def importers(library: str) -> set[str]:
    return {name for name in MODULES if any(one.split(".")[0] == library for one in imported(name))}


def within(package: str, names: set[str]) -> set[str]:
    return {name for name in names if name == package or name.startswith(f"{package}.")}


def test_the_reader_of_imports_sees_those_inside_functions() -> None:
    source = "def f():\n    import numpy.linalg\n    from kurbel import certify, __version__\n"
    assert set(imported_names(ast.parse(source))) == {"numpy.linalg", "kurbel.certify", "kurbel"}


def test_kernel_imports_nothing_of_kurbel_but_itself_and_errors() -> None:
    for name in within("kurbel.kernel", set(MODULES)):
        ours = within("kurbel", imported(name))
        assert ours <= within("kurbel.kernel", ours) | {"kurbel.errors"}, name


@pytest.mark.parametrize("name", [*sorted(within("kurbel.kernel", set(MODULES))), "kurbel.table"])
def test_kernel_and_table_know_neither_click_nor_jinja(name: str) -> None:
    for module in {name} | reached(name):
        assert not {one.split(".")[0] for one in imported(module)} & {"click", "jinja2"}, module


def test_kernel_and_table_do_not_know_each_other() -> None:
    assert not within("kurbel.kernel", reached("kurbel.table"))
    for name in within("kurbel.kernel", set(MODULES)):
        assert "kurbel.table" not in reached(name)


def test_only_render_knows_jinja() -> None:
    assert importers("jinja2") == {"kurbel.render"}


def test_only_the_command_line_knows_click() -> None:
    clicking = importers("click")
    assert clicking
    assert clicking == within("kurbel.cli", clicking)


def test_only_its_start_knows_the_command_line() -> None:
    knowing = {name for name in MODULES if within("kurbel.cli", imported(name))}
    assert knowing == within("kurbel.cli", knowing) | {"kurbel.__main__"}


def test_imports_run_one_way() -> None:
    # kernel <- quantities <- build <- cli; table <- layouts, build, render <- cli.
    order = ["kurbel.kernel.kinematics", "kurbel.quantities", "kurbel.build", "kurbel.cli.table"]
    for low, high in pairwise(order):
        assert low in reached(high)
        assert high not in reached(low)
    for name in ("kurbel.layouts", "kurbel.build", "kurbel.render"):
        assert "kurbel.table" in reached(name)
        assert name not in reached("kurbel.table")
    assert "kurbel.render" not in reached("kurbel.build")
    assert not {"kurbel.quantities", "kurbel.build", "kurbel.certify"} & reached("kurbel.render")


def loaded(code: str, *arguments: str) -> set[str]:
    """Return the top-level modules that a new interpreter has loaded when the code is done."""
    code = f"import atexit, sys\natexit.register(lambda: print(*sys.modules, file=sys.stderr))\n{code}"
    environment = {name: text for name, text in os.environ.items() if not name.startswith("KURBEL_")}
    paths = (str(PACKAGE.parent), os.environ.get("PYTHONPATH", ""))
    environment |= {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True, env=environment
    )
    names = done.stderr.split()
    assert "kurbel" in names
    return {name.split(".")[0] for name in names}


RUN = "import sys\nsys.argv[0] = 'kurbel'\nfrom kurbel.cli import main\nmain()"


def test_import_kurbel_loads_no_library() -> None:
    assert not loaded("import kurbel") & {"click", "jinja2", "flint", "tabulate", "pint", *HEAVY}


@pytest.mark.parametrize("option", ["--help", "-h", "--version"])
def test_help_loads_no_library(option: str) -> None:
    assert not loaded(RUN, option) & {"jinja2", "flint", "tabulate", "pint", *HEAVY}


@pytest.mark.parametrize("name", ["text", "markdown", "latex", "html", "csv", "json"])
def test_a_page_is_made_without_numpy(name: str) -> None:
    assert not loaded(RUN, "table", "--ratio", "1:5", "-f", name) & {"pint", *HEAVY}


@pytest.mark.parametrize("name", ["csv", "json"])
def test_records_are_made_without_jinja(name: str) -> None:
    assert "jinja2" not in loaded(RUN, "table", "--ratio", "1:5", "-f", name)


def test_a_long_table_takes_numpy_but_neither_jinja_nor_scipy() -> None:
    names = loaded(RUN, "table", "--ratio", "1:5", "-f", "csv", "--step", "0.001", "--to", "90")
    assert "numpy" in names
    assert not names & {"jinja2", "scipy", "matplotlib"}
