"""What README and docs/ show is run and compared; KURBEL_PROMOTE=1 writes what the commands print anew.

A page is done from its top: what stands in ```console is typed, and a block such as ```toml file=engine.toml
is written, in a folder that has the examples and nothing else.
"""

from __future__ import annotations

import contextlib
import doctest
import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from cli import kurbel
from places import ROOT, SOURCES
from registers import register
from tex import compiled, complaints
from tools import require, require_library

README = ROOT / "README.md"
DOCS = ROOT / "docs"
# The pages for developers have tests of their own, which do what these say in a copy of the house.
PAGES = (README, *(page for page in sorted(DOCS.rglob("*.md")) if "developers" not in page.parts))
BLOCK = re.compile(r"(?<=```console\n).*?(?=```)", re.DOTALL)
PART = re.compile(r"^```((\S+)(?: file=(\S+))?)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
# What the Python sessions of a page write.
SAVED = {
    "constructions.md": {"fig9.html"},
    "columns.md": {"delta.nc", "delta.parquet"},
    "interactive.md": {"motion.html"},
    "python.md": {"table.tex", "turning.svg"},
    "sweeps.md": {"delta.parquet", "motion.parquet"},
}
COMMAND = re.compile(r"^\$ (.+)\n", re.MULTILINE)


def commands(text: str) -> list[str]:
    return [command for block in BLOCK.findall(text) for command in COMMAND.findall(block)]


def printed(command: str, folder: Path) -> str:
    """What a terminal shows of the command, run in the folder."""
    program, *arguments = shlex.split(command)
    assert program == "kurbel"
    with contextlib.chdir(folder):
        result = kurbel(*arguments)
    assert result.code == 0
    # No command prints on both.
    assert not (result.out and result.err)
    return result.out + result.err


def true_block(block: str, folder: Path) -> str:
    return "\n".join(f"$ {command}\n{printed(command, folder)}" for command in COMMAND.findall(block))


def done(part: re.Match[str], folder: Path) -> str:
    """Do in the folder what a part of a page says, and return what it then shows."""
    _, kind, name, text = part.groups()
    if name:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return true_block(text, folder) if kind == "console" else text


def reader(folder: Path) -> Path:
    """Return a folder with the examples and nothing else, in which the commands are typed in turn."""
    shutil.copytree(README.parent / "examples", folder / "examples")
    return folder


def after(page: Path, folder: Path) -> Path:
    """Return a folder in which all has been done that a page says."""
    folder = reader(folder / "typed")
    for part in PART.finditer(page.read_text(encoding="utf-8")):
        done(part, folder)
    return folder


def with_blocks(kind: str) -> pytest.MarkDecorator:
    """Return the pages that have such blocks, as what a test is tried with."""
    found = [page for page in PAGES if f"```{kind}\n" in page.read_text(encoding="utf-8")]
    assert found
    return pytest.mark.parametrize("page", found, ids=lambda page: str(page.relative_to(ROOT)))


@with_blocks("console")
def test_every_command_prints_what_stands_there(page: Path, tmp_path: Path) -> None:
    text = page.read_text(encoding="utf-8")
    if os.environ.get("KURBEL_PROMOTE") == "1":
        promoted = reader(tmp_path / "promoted")
        text = PART.sub(lambda part: f"```{part[1]}\n{done(part, promoted)}```", text)
        page.write_text(text, encoding="utf-8")
    assert commands(text)
    folder = reader(tmp_path / "typed")
    for part in PART.finditer(text):
        assert part[4] == done(part, folder)


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("subjects/forces.md", "engine.toml"),
        ("howto/layouts.md", "layouts/slant/layout.toml"),
        ("subjects/constructions.md", "constructions/hebelarm.toml"),
    ],
)
def test_files_of_the_pages_are_the_examples(page: str, name: str) -> None:
    example = ROOT / "examples" / name
    assert f"```toml\n{example.read_text(encoding='utf-8')}```" in (DOCS / page).read_text(encoding="utf-8")


def test_the_readme_is_short_and_its_first_command_prints_a_table() -> None:
    text = README.read_text(encoding="utf-8")
    assert len(text.encode()) <= 7000
    assert commands(text)[0] == "kurbel table --ratio 1:5 --step 30 --lang en"
    assert re.search(r"^ +90 +1\.1010 +0\.8990 ", text.split("```")[1], re.MULTILINE)


def test_every_line_of_the_readme_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the extras that it recommends and no others."""
    text = README.read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    recommended = set(re.findall(r"'\.\[([a-z,]+)\]'", text)[0].split(","))
    left_out = {
        re.split("[<>=]", one)[0]
        for extra, wanted in project["optional-dependencies"].items()
        if extra not in recommended
        for one in wanted
    }
    for module, distributions in packages_distributions().items():
        if left_out & {*distributions}:
            monkeypatch.setitem(sys.modules, module, None)
    (lines,) = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    folder = reader(tmp_path / "typed")
    language, *typed = lines.splitlines()
    assert language.startswith("export KURBEL_LANG=en ")
    for line in typed:
        printed(line.partition(" # ")[0], folder)
    assert {path.name for path in folder.iterdir()} >= {"page.html", "drive.svg", "appendix"}


def test_the_readme_names_no_extra_that_there_is_not() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    named = re.findall(r"'\.\[([a-z,]+)\]'", README.read_text(encoding="utf-8"))
    assert len(named) == 4
    for extras in named:
        assert project["optional-dependencies"].keys() >= set(extras.split(","))


def for_the_shell(page: Path) -> str:
    """The lines of the blocks for a shell, without those that run until they are ended."""
    blocks = re.findall(r"```sh\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    return "".join(line for line in "".join(blocks).splitlines(True) if " watch " not in line)


# The README has a test of its own, the set-up of the first page needs the net, tests/playground builds the
# playground and tests/handbook the handbooks of the other two.
TYPED_ELSEWHERE = {
    README,
    DOCS / "index.md",
    DOCS / "howto" / "handbook.md",
    DOCS / "howto" / "playground.md",
    DOCS / "subjects" / "teaching.md",
}


@pytest.mark.slow
@pytest.mark.parametrize(
    "page",
    [page for page in PAGES if page not in TYPED_ELSEWHERE and for_the_shell(page)],
    ids=lambda page: page.name,
)
def test_every_line_for_the_shell_runs(page: Path, tmp_path: Path) -> None:
    folder, script = after(page, tmp_path), for_the_shell(page)
    for program in ("pdflatex", "pandoc"):
        if program in script:
            require(program)
    environment = {name: text for name, text in os.environ.items() if "KURBEL" not in name}
    environment["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    typed = subprocess.run(
        ["bash", "-e", "-c", script], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert typed.returncode == 0, typed.stderr


@pytest.mark.slow
@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("tutorial.md", "notes.tex"),
        ("anleitung.md", "bericht.tex"),
        ("howto/latex.md", "paper.tex"),
        ("howto/latex.md", "book.tex"),
    ],
)
def test_a_document_of_a_page_compiles_without_a_complaint(page: str, name: str, tmp_path: Path) -> None:
    folder = after(DOCS / page, tmp_path)
    document = (folder / name).read_text(encoding="utf-8")
    assert complaints(compiled("pdflatex", document, folder, runs=3)) == []


@pytest.mark.slow
def test_the_paper_in_typst_compiles(tmp_path: Path) -> None:
    require_library("typst")
    import typst

    paper = after(DOCS / "howto" / "typst.md", tmp_path) / "paper.typ"
    assert typst.compile(str(paper), ignore_system_fonts=True).startswith(b"%PDF")


@with_blocks("pycon")
def test_every_python_session_is_true(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(reader(tmp_path / "typed"))
    blocks = re.findall(r"```pycon\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    session = doctest.DocTestParser().get_doctest("".join(blocks), {}, page.name, str(page), 0)
    assert session.examples
    assert doctest.DocTestRunner().run(session).failed == 0
    assert {path.name for path in Path().iterdir()} == {"examples"} | SAVED.get(page.name, set())


def test_every_cell_of_the_notebook_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    page = (DOCS / "howto" / "notebooks.md").read_text(encoding="utf-8")
    cells = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert len(cells) >= 3
    for cell in cells:
        exec(compile(cell, "notebooks.md", "exec"), names)


def test_the_tables_of_printed_values_are_those_of_the_sources() -> None:
    rows = register(SOURCES / "weisbach" / "150.csv")
    cells = {row["place"].split("/", 2)[2]: row for row in rows}
    page = (DOCS / "books" / "weisbach.md").read_text(encoding="utf-8")
    for expansion in range(2, 7):
        cell = cells[f"{expansion}/delta"]
        methods = (f"{cell[one]} ({apart(cell[one], cell['printed'])})" for one in METHODS)
        assert f"| {expansion} | {cell['printed']} | {' | '.join(methods)} |" in page
    for name, key in READABLE.items():
        cell = cells[f"2/{key}"]
        values = " | ".join(cell[one] for one in ("printed", *METHODS)).replace("-", "−")
        assert f"| {name} | {values} |" in page


METHODS = ("exact", "series", "weisbach")
READABLE = {
    "α₁, return stroke": "alpha_min_return",
    "α₁, outstroke": "alpha_min",
    "least speed, return stroke": "v_min_return",
    "least speed, outstroke": "v_min",
    "α₂, return stroke": "alpha_max_return",
    "α₂, outstroke": "alpha_max",
    "greatest speed, return stroke": "v_max_return",
    "greatest speed, outstroke": "v_max",
    "P/Q": "mean_force",
}


def apart(computed: str, printed: str) -> str:
    units = int(computed.replace(",", "")) - int(printed.replace(",", ""))
    return f"{units:+d}".replace("-", "−") if units else "0"
