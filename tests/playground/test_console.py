"""What is typed into the playground, as its side in Python takes it; the same runs in the browser."""

from __future__ import annotations

import importlib.util
import re
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
from cli import HANDLED, kurbel
from places import ROOT


@pytest.fixture(scope="module")
def console() -> ModuleType:
    spec = importlib.util.spec_from_file_location("console", ROOT / "docs" / "playground" / "console.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.chdir(tmp_path)
    handlers = {number: signal.getsignal(number) for number in HANDLED}
    yield
    for number, handler in handlers.items():
        signal.signal(number, handler)


def test_a_file_has_what_a_pipe_would_have_on_the_machine(console: ModuleType) -> None:
    words = ("table", "--ratio", "1:5", "--angle", "0;90", "--columns", "phi,x", "-f", "csv")
    ran = console.run("$ kurbel table --ratio 1:5 --angle '0;90' --columns phi,x -f csv > a.csv", 80)
    assert ran == (0, b"", "", "")
    assert Path("a.csv").read_text() == kurbel(*words).out
    assert console.run("cat a.csv", 80).out == Path("a.csv").read_bytes()
    # As in a shell, what begins with a dot is not listed.
    Path(".kurbel").mkdir()
    assert console.run("ls", 80).out == b"a.csv\n"


def test_a_telephone_s_quotes_and_strokes_are_understood(console: ModuleType) -> None:
    meant = console.run("table --ratio 1:5 --angle '0;90' --lang en", 80)
    assert console.run("table —ratio 1:5 —angle ‘0;90’ —lang en", 80) == meant
    assert meant.code == 0


def test_a_variable_before_the_command_holds_for_it_alone(console: ModuleType) -> None:
    line = "kurbel table --angle 90 --columns phi,x"
    assert "Crank" not in console.run(line, 80).out.decode()
    assert console.run(f"KURBEL_LANG=en {line}", 80) == console.run(f"{line} --lang en", 80)
    assert console.run(line, 80).out != console.run(f"{line} --lang en", 80).out


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        (
            "kurbel layouts | less",
            '"|" is for a shell; here runs one command at a time, "> FILE" may end it\n',
        ),
        ("kurbel table --angle '0;90", "a quotation mark is opened and not closed\n"),
        ("rm", "rm: write the name of a file behind it\n"),
    ],
)
def test_what_only_a_shell_does_is_refused(console: ModuleType, line: str, sentence: str) -> None:
    ran = console.run(line, 80)
    assert (ran.code, ran.out, ran.err) == (2, b"", sentence)


def test_what_lacks_a_library_of_the_machine_is_called_neither_a_drawing_nor_a_sweep(
    console: ModuleType,
) -> None:
    with pytest.raises(console.AbsentError, match=r"^this needs NumPy and SciPy, as sweeps, drawings and"):
        console.watch.find_spec("numpy")


def test_words_are_completed_as_in_a_shell(console: ModuleType) -> None:
    Path("engine.toml").touch()
    assert [value for value, _ in console.complete("kurbel delt")] == ["delta"]
    assert [value for value, _ in console.complete("table --lang ")] == ["de", "en"]
    assert console.complete("kurbel table --machine eng") == [("engine.toml", "")]


@pytest.mark.slow
def test_every_example_of_the_page_works(console: ModuleType) -> None:
    shutil.copytree(ROOT / "examples", "examples")
    page = (ROOT / "docs" / "playground" / "page" / "examples.js").read_text(encoding="utf-8")
    lines = re.findall(r'^    \["(kurbel [^"]*)", "[^"]+"\],$', page, re.MULTILINE)
    assert len(lines) == page.count('["')
    for line in lines:
        ran = console.run(line, 80)
        assert (line, ran.code, ran.err) == (line, 0, "")
