"""Ctrl-C ends a command with 130 and without a word, whatever runs as it comes."""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from threading import Event
from typing import NoReturn

import pytest
from cli import kurbel
from programs import PATIENCE, Programs

CTRL_C = signal.SIGINT
# As a process starts that is to compute for another.
SITE = """\
import signal, sys
if "spawn_main" in " ".join(sys.orig_argv):
    open("started", "w").close()
    signal.raise_signal(signal.SIGINT)
"""
BOOK = 'title = "T"\nformats = ["text"]\n[[chapter]]\ntitle = "C"\n' + "".join(
    f'[[chapter.part]]\nrun = "table --angle {angle}"\nname = "t{angle}"\n' for angle in (1, 2, 3, 4)
)


@pytest.fixture(autouse=True)
def heard() -> Iterator[None]:
    before = signal.signal(CTRL_C, signal.default_int_handler)
    yield
    signal.signal(CTRL_C, before)


def plainly(question: object) -> None:
    signal.raise_signal(CTRL_C)


def taken_for_an_error(question: object) -> NoReturn:
    try:
        signal.raise_signal(CTRL_C)
    except KeyboardInterrupt:
        raise ImportError("multiarray failed to import") from None
    raise AssertionError


def printed_and_taken_for_an_error(question: object) -> NoReturn:
    # As NumPy's C code does.
    try:
        signal.raise_signal(CTRL_C)
    except KeyboardInterrupt:
        sys.excepthook(*sys.exc_info())
        raise ImportError("multiarray failed to import") from None
    raise AssertionError


class Goes:
    def __del__(self) -> None:
        signal.raise_signal(CTRL_C)


def swallowed(question: object) -> NoReturn:
    going = Goes()
    del going
    Event().wait(PATIENCE)
    raise AssertionError


@pytest.mark.parametrize(
    "comes",
    [plainly, taken_for_an_error, printed_and_taken_for_an_error, swallowed],
    ids=lambda one: one.__name__,
)
def test_ctrl_c_is_the_end(
    comes: Callable[[object], object], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("kurbel.page.build.build", comes)
    result = kurbel("table", "-o", str(tmp_path / "table.txt"))
    assert (result.code, result.out, result.err.strip()) == (130, "", "")
    assert not [*tmp_path.iterdir()]


def test_ctrl_c_ends_at_once_what_has_only_to_end(monkeypatch: pytest.MonkeyPatch) -> None:
    handlers: list[object] = []
    monkeypatch.setattr(gc, "freeze", lambda: handlers.append(signal.getsignal(CTRL_C)))
    assert kurbel("table").code == 0
    assert handlers == [signal.SIG_DFL]


@pytest.mark.parametrize(
    "words",
    [
        ("sweep", "harmonics", "--ratio=1:3..8:0.02", "--jobs=2", "-oh.csv"),
        ("handbook", "build", "--quiet", "--jobs=2"),
    ],
)
def test_processes_that_compute_never_hear_ctrl_c(
    words: tuple[str, ...], programs: Programs, tmp_path: Path
) -> None:
    (tmp_path / "sitecustomize.py").write_text(SITE)
    (tmp_path / "handbook.toml").write_text(BOOK)
    run = programs.kurbel(*words, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)})
    _, errors = run.communicate()
    assert (tmp_path / "started").exists()
    assert (run.returncode, b"Traceback" in errors) == (0, False), errors
