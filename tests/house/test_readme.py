"""The README's commands are run and their output compared; KURBEL_PROMOTE=1 writes the output anew."""

from __future__ import annotations

import contextlib
import doctest
import os
import re
import shlex
import shutil
from pathlib import Path

import pytest
from cli import kurbel
from places import ROOT, SOURCES
from registers import register

README = ROOT / "README.md"
PAGES = (
    README,
    *(
        ROOT / "docs" / f"{name}.md"
        for name in ("engines", "speed", "flywheels", "diagrams", "balance", "effort", "given", "motion")
    ),
)
BLOCK = re.compile(r"(?<=```console\n).*?(?=```)", re.DOTALL)
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


def reader(folder: Path) -> Path:
    """Return a folder with the examples and nothing else, in which the commands are typed in turn."""
    shutil.copytree(README.parent / "examples", folder / "examples")
    return folder


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_command_prints_what_stands_there(page: Path, tmp_path: Path) -> None:
    text = page.read_text(encoding="utf-8")
    if os.environ.get("KURBEL_PROMOTE") == "1":
        promoted = reader(tmp_path / "promoted")
        text = BLOCK.sub(lambda block: true_block(block.group(), promoted), text)
        page.write_text(text, encoding="utf-8")
    assert len(commands(text)) >= 5
    folder = reader(tmp_path / "typed")
    for block in BLOCK.findall(text):
        assert block == true_block(block, folder)


@pytest.mark.parametrize("name", ["engine.toml", "layouts/slant/layout.toml"])
def test_files_of_the_readme_are_the_examples(name: str) -> None:
    example = README.parent / "examples" / name
    assert f"```toml\n{example.read_text(encoding='utf-8')}```" in README.read_text(encoding="utf-8")


def test_the_first_command_prints_a_table() -> None:
    text = README.read_text(encoding="utf-8")
    assert commands(text)[0] == "kurbel table --ratio 1:5"
    assert re.search(r"^ +90 +1,1010 +0,8990 ", text.split("```")[1], re.MULTILINE)


def test_the_python_session_of_the_readme_is_true(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    tests = doctest.DocTestParser().get_doctest(
        "".join(re.findall(r"```pycon\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)),
        {}, "README", str(README), 0,
    )  # fmt: skip
    assert len(tests.examples) >= 4
    assert doctest.DocTestRunner().run(tests).failed == 0
    assert {path.name for path in tmp_path.iterdir()} == {"table.tex", "turning.svg"}


def test_the_tables_of_printed_values_are_those_of_the_sources() -> None:
    rows = register(SOURCES / "weisbach" / "150.csv")
    cells = {row["place"].split("/", 2)[2]: row for row in rows}
    readme = README.read_text(encoding="utf-8")
    for expansion in range(2, 7):
        cell = cells[f"{expansion}/delta_table"]
        methods = (f"{cell[one]} ({apart(cell[one], cell['printed'])})" for one in METHODS)
        assert f"| {expansion} | {cell['printed']} | {' | '.join(methods)} |" in readme
    for name, key in READABLE.items():
        cell = cells[f"2/{key}"]
        values = " | ".join(cell[one] for one in ("printed", *METHODS)).replace("-", "−")
        assert f"| {name} | {values} |" in readme


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
