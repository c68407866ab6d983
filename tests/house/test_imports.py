"""The layers: who may import whom, read from the sources, and what a command really loads."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from itertools import cycle
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


@cache
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
    source = "def f():\n    import numpy.linalg\n    from kurbel import errors, __version__\n"
    assert set(imported_names(ast.parse(source))) == {"numpy.linalg", "kurbel.errors", "kurbel"}


def test_kernel_imports_nothing_of_kurbel_but_itself_and_errors() -> None:
    for name in within("kurbel.kernel", set(MODULES)):
        ours = within("kurbel", imported(name))
        assert ours <= within("kurbel.kernel", ours) | {"kurbel.errors"}, name


@pytest.mark.parametrize("name", [*sorted(within("kurbel.kernel", set(MODULES))), "kurbel.page.table"])
def test_kernel_and_table_know_neither_click_nor_jinja(name: str) -> None:
    for module in {name} | reached(name):
        assert not {one.split(".")[0] for one in imported(module)} & {"click", "jinja2"}, module


def test_only_render_knows_jinja() -> None:
    assert importers("jinja2") == {"kurbel.formats.render", "kurbel.formats.sandbox"}
    assert {name for name in MODULES if "kurbel.formats.sandbox" in imported(name)} == {
        "kurbel.formats.apart",
        "kurbel.formats.render",
    }


def test_only_the_command_line_knows_click() -> None:
    clicking = importers("click")
    assert clicking
    assert clicking == within("kurbel.cli", clicking)


def test_only_its_start_knows_the_command_line() -> None:
    knowing = {name for name in MODULES if within("kurbel.cli", imported(name))}
    assert knowing == within("kurbel.cli", knowing) | {"kurbel.__main__"}


def test_only_drawings_know_matplotlib() -> None:
    names = (
        *("plotting", "style", "polar", "mechanism", "arc", "links", "sketch", "lettering"),
        *(
            "chart.legend",
            "chart.marks",
            "chart.stroke_lines",
            "paper.letters",
            "paper.pgf",
            "construct.steps",
        ),
        *(f"film.{one}" for one in ("model", "scene", "mechanism", "curves", "vector", "svg", "frames")),
    )
    drawing = {f"kurbel.plot.{name}" for name in names}
    assert importers("matplotlib") == drawing | {"kurbel.plot.drawings"}
    knowing = {name for name in MODULES if drawing & {name, *reached(name)}}
    above = ("kurbel.commands.", "kurbel.sweeps.", "kurbel.cli", "kurbel.__main__")
    assert all(name == "kurbel" or name.startswith(("kurbel.plot.", *above)) for name in knowing)


def test_only_fast_loops_know_numba() -> None:
    names = {name for name, path in MODULES.items() if '"numba"' in path.read_text(encoding="utf-8")}
    assert not importers("numba")
    # The third names it among the libraries that a sweep's bytes depend on.
    assert names == {"kurbel.kernel.fast.loops", "kurbel.kernel.fast.worth", "kurbel.sweeps.work.versions"}


def test_only_pdf_knows_its_compiler() -> None:
    assert importers("typst") == {"kurbel.formats.pdf.by_typst"}
    assert "typst" not in {one.split(".")[0] for one in at_import("kurbel.formats.pdf.by_typst")}


@pytest.mark.parametrize("library", ["dask", "distributed", "h5netcdf", "pyarrow", "xarray", "zarr"])
def test_only_sweeps_know_frames_and_clusters(library: str) -> None:
    assert importers(library) <= SWEEPS


def test_no_circle_of_modules_that_import_each_other_as_they_are_imported() -> None:
    waiting = {name: at_import(name) & set(MODULES) for name in MODULES}
    while free := {name for name, needed in waiting.items() if not needed & set(waiting)}:
        waiting = {name: needed for name, needed in waiting.items() if name not in free}
    assert not waiting


def loaded(code: str, *arguments: str) -> set[str]:
    """Return the top-level modules that a new interpreter has loaded when the code is done."""
    return {name.split(".")[0] for name in modules_loaded(code, *arguments)}


def modules_loaded(code: str, *arguments: str) -> set[str]:
    """Return the same by their whole names."""
    code = f"import atexit, sys\natexit.register(lambda: print(*sys.modules, file=sys.stderr))\n{code}"
    names = interpreted(code, *arguments).stderr.split()
    assert "kurbel" in names
    return {*names}


def interpreted(code: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {name: text for name, text in os.environ.items() if not name.startswith("KURBEL_")}
    paths = (str(PACKAGE.parent), os.environ.get("PYTHONPATH", ""))
    environment |= {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True, env=environment
    )


RUN = "import sys\nsys.argv[0] = 'kurbel'\nfrom kurbel.cli import main\nmain()"


# Modules about arrays or drawings and nothing else, which others import inside functions.
SWEEPS = within("kurbel.sweeps", set(MODULES))
DRAWINGS = within("kurbel.plot", set(MODULES)) - {"kurbel.plot", "kurbel.plot.style", "kurbel.plot.ticks"}
ARRAYS = {
    *SWEEPS,
    *DRAWINGS,
    "kurbel.commands.arrays.asked",
    "kurbel.engine.arrays",
    "kurbel.engine.card.force",
    "kurbel.engine.card.turn",
    "kurbel.engine.irregularity",
    "kurbel.engine.long.irregularity",
    "kurbel.engine.long.columns",
    "kurbel.engine.long.turn",
    "kurbel.engine.rodload.card",
    "kurbel.engine.speed.card",
    "kurbel.engine.speed.heavy_card",
    "kurbel.exact.bulk",
    "kurbel.exact.enclosures.digits",
    "kurbel.exact.enclosures.double",
    "kurbel.exact.enclosures.doubles",
    "kurbel.exact.enclosures.enclosure",
    "kurbel.exact.enclosures.functions",
    "kurbel.formats.columns",
    "kurbel.kernel.fast.extremes",
    "kurbel.kernel.irregularity.extremes",
    "kurbel.kernel.irregularity.half_tangent",
    "kurbel.kernel.irregularity.load",
    "kurbel.linkage.long",
    "kurbel.motion.arrays",
    "kurbel.motion.long.columns",
    "kurbel.motion.long.places",
    "kurbel.motion.points.long",
}


def test_heavy_libraries_are_imported_inside_functions_only() -> None:
    for name in set(MODULES) - ARRAYS:
        at_once = at_import(name)
        assert not {one.split(".")[0] for one in at_once} & {"pint", *HEAVY}, name
        assert not at_once & ARRAYS, name


def at_import(name: str) -> set[str]:
    """Return what a module imports as soon as it is imported itself."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    return {one for node in at_once(tree.body) for one in imported_names(node)}


def at_once(body: list[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield the statements that run when a module is imported: not those of functions or for types only."""
    for node in body:
        if isinstance(node, (ast.If, ast.Try, ast.With, ast.ClassDef)):
            if not (isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"):
                yield from at_once(node.body)
            yield from at_once(getattr(node, "orelse", []))
        elif not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node


def test_the_reader_of_what_runs_at_once_leaves_out_functions_and_types() -> None:
    source = (
        "if TYPE_CHECKING:\n    import a\nelse:\n    import b\n"
        "def f():\n    import c\nclass D:\n    import d\n    def g(self):\n        import e\n"
    )
    names = {one for node in at_once(ast.parse(source).body) for one in imported_names(node)}
    assert names == {"b", "d"}


# kurbel's own modules that a small page loads; each is half a millisecond, a hundredth of its libraries.
MOST_LOADED = {
    "table --ratio 1:5": 58,
    "table --ratio 1:5 -f html": 75,
    "delta --eps 2..6": 101,
    "solve --ratio 1:5 --where p=0": 81,
}


@pytest.mark.parametrize(("words", "most"), MOST_LOADED.items(), ids=MOST_LOADED)
def test_a_small_page_loads_no_more_modules_than_before(words: str, most: int) -> None:
    names = modules_loaded(RUN, *words.split())
    own = within("kurbel", names)
    assert len(own) <= most, sorted(own)
    # Of other mechanisms and of engines nothing is asked.
    if words.startswith(("table", "solve")):
        assert not within("kurbel.linkage", own) | within("kurbel.engine", own)


def test_import_kurbel_loads_no_library() -> None:
    assert not loaded("import kurbel") & {"click", "jinja2", "flint", "tabulate", "pint", *HEAVY}


@pytest.mark.parametrize("option", ["--help", "-h", "--version"])
def test_help_loads_no_library(option: str) -> None:
    assert not loaded(RUN, option) & {"click", "jinja2", "flint", "re", "typing", "tabulate", "pint", *HEAVY}


def test_the_help_of_plot_loads_no_matplotlib() -> None:
    assert not loaded(RUN, "plot", "--help") & set(HEAVY)


def test_a_table_loads_no_reader_of_models_and_a_long_one_no_balls() -> None:
    assert "msgspec" not in loaded(RUN, "table", "--ratio", "1:5")
    assert "flint" not in loaded(RUN, "table", "--step", "0.05", "-f", "csv")


PAGES = [
    ("table", "--ratio", "1:5"),
    ("delta", "--eps", "2..6"),
    ("turning", "--eps", "4"),
    ("deadcentres",),
    ("harmonics",),
    ("balance",),
]
PAGES += [("table", "--mechanism", "arc", "--rocker", "6"), ("table", "--mechanism", "parallel")]
PAGES += [("table", "--mechanism", "beam", "--beam", "3")]
PAGES += [
    ("inertia", "--centre=0.6", "--gyration=0.4", f"--layout={name}")
    for name in ("inertia", "inertia-errors")
]
PAGES += [("forces", "--at", "tangent"), ("solve", "--where", "p=0")]
PAGES += [("example", "blau", "33"), ("example", "weisbach", "150")]


# Pages of one interpreter, one after the other: what a page loads stays loaded for those after it.
RUN_EACH = """import json, sys
from kurbel.cli import main
for words in json.loads(sys.argv[1]):
    sys.argv = ["kurbel", *words]
    try:
        main()
    except SystemExit as end:
        assert end.code == 0
    print("loaded:", *sys.modules, file=sys.stderr)
"""


def loaded_page_by_page(pages: list[tuple[str, ...]]) -> dict[tuple[str, ...], set[str]]:
    """Return the top-level modules that are loaded when each page is printed."""
    done = interpreted(RUN_EACH, json.dumps(pages))
    lines = [line.split()[1:] for line in done.stderr.splitlines() if line.startswith("loaded:")]
    return {words: {name.split(".")[0] for name in names} for words, names in zip(pages, lines, strict=True)}


@pytest.mark.parametrize(
    "formats",
    [("text", "csv", "json"), ("markdown", "latex", "html", "typst", "rst")],
    ids=["records", "templates"],
)
def test_a_page_is_made_without_numpy(formats: tuple[str, ...]) -> None:
    # The first page in every format, the others in one after the other.
    pages = [(*PAGES[0], "-f", name) for name in formats]
    pages += [(*words, "-f", name) for words, name in zip(PAGES[1:], cycle(formats), strict=False)]
    for words, libraries in loaded_page_by_page(pages).items():
        assert not libraries & {"pint", *HEAVY}, words


def test_a_long_table_takes_numpy_but_neither_jinja_nor_scipy() -> None:
    names = loaded(RUN, "table", "--ratio", "1:5", "-f", "csv", "--step", "0.001", "--to", "90")
    assert "numpy" in names
    assert not names & {"jinja2", "scipy", "matplotlib", "numba"}
