"""Pages on a terminal: through a pager what is long, lists as wide as it is, colours where it has them."""

from __future__ import annotations

import io
import json
import os
import re
import shlex
import signal
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from cli import kurbel, printed, refusal
from places import ROOT
from programs import Programs, wait_until
from terminals import own_terminal, shown

from kurbel import collate, delta
from kurbel.cli import screen
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names

LINES = 24


def lines(count: int) -> list[bytes]:
    return [f"{number:06}\n".encode() for number in range(count)]


@pytest.fixture
def ctrl_c() -> Iterator[Any]:
    """What Python does at Ctrl-C, wherever the tests were started; return that."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield signal.default_int_handler
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize(
    ("page", "paged"),
    [
        (lines(LINES - 1), False),
        (lines(LINES), True),
        # Twelve lines, each as long as two of the terminal.
        ([b"x" * 81 + b"\n"] * (LINES // 2), True),
        # Codes for colours have no width.
        ([b"\x1b[32m" + b"x" * 80 + b"\x1b[0m\n"] * (LINES - 1), False),
        # More than a pipe holds.
        (lines(50_000), True),
    ],
)
def test_what_is_longer_than_the_screen_goes_through_the_pager(
    page: list[bytes], paged: bool, tmp_path: Path, ctrl_c: Any
) -> None:
    file = tmp_path / "page"
    with own_terminal(80, LINES, KURBEL_PAGER=f"tee {shlex.quote(str(file))}", PAGER="false") as end:
        screen.show(iter(page), paging=True)
        there = end()
    # Ctrl-C is ours again.
    assert signal.getsignal(signal.SIGINT) is ctrl_c
    whole = b"".join(page)
    assert (there, file.read_bytes() if file.exists() else b"") == (
        ("", whole) if paged else (whole.decode(), b"")
    )


@pytest.mark.parametrize(
    ("settings", "paging"),
    [
        ({"KURBEL_PAGER": "", "PAGER": "false"}, True),
        ({"KURBEL_PAGER": "cat", "PAGER": "false"}, True),
        ({"PAGER": ""}, True),
        ({"PAGER": "false", "TERM": "dumb"}, True),
        ({"PAGER": "false"}, False),
        # There is no less.
        ({"PATH": "/nowhere"}, True),
    ],
)
def test_a_page_is_printed_where_there_is_to_be_no_pager(settings: dict[str, str], paging: bool) -> None:
    with own_terminal(80, LINES, **settings) as end:
        screen.show(iter(lines(100)), paging)
        assert end() == b"".join(lines(100)).decode()


@pytest.mark.parametrize(("command", "program"), [("lesss -R", "lesss"), ("less '-R", "less '-R")])
def test_a_pager_that_is_not_there_is_named(
    command: str, program: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with own_terminal(80, LINES, PAGER=command) as end:
        screen.show(iter(lines(100)), paging=True)
        assert end() == b"".join(lines(100)).decode()
    assert capsys.readouterr().err == (
        f'kurbel: PAGER is "{command}", and there is no program {program}; name another, or cat for none\n'
    )


def test_less_is_the_pager_with_the_options_that_git_gives_it(tmp_path: Path, ctrl_c: Any) -> None:
    less = tmp_path / "less"
    less.write_text(f'#!/bin/sh\necho "$0 $@ $LESS" > {shlex.quote(str(tmp_path / "asked"))}\n')
    less.chmod(0o755)
    for settings, said in (({}, "-FRX FRX"), ({"PAGER": "less"}, " FRX"), ({"LESS": "i"}, "-FRX i")):
        with own_terminal(80, LINES, PATH=f"{tmp_path}:{os.environ['PATH']}", **settings):
            # It ends before it has read all, which is no mistake.
            screen.show(iter(lines(50_000)), paging=True)
        asked = (tmp_path / "asked").read_text()
        assert (Path(asked.split()[0]).name, asked.partition(" ")[2].strip()) == ("less", said.strip())
        assert signal.getsignal(signal.SIGINT) is ctrl_c


def test_ctrl_c_is_the_pagers_and_what_is_said_meanwhile_stays_seen(
    programs: Programs, tmp_path: Path
) -> None:
    page, read, interrupted = (tmp_path / name for name in ("page", "read", "interrupted"))
    pager = "sh -c " + shlex.quote(
        f"trap 'touch {interrupted}' INT; cat > {page}; touch {read}; "
        f"until [ -e {interrupted} ]; do sleep 0.01; done; echo the pager ends"
    )

    def interrupt(ours: int) -> None:
        wait_until(read.exists)
        os.write(ours, b"\x03")

    words = ("table", "-f", "latex", "--step", "2", "--columns", "phi,x")
    text, code = shown(programs, *words, lines=LINES, meanwhile=interrupt, PAGER=pager, LANG="de_DE")
    assert code == 0
    assert text.endswith(
        "the pager ends\nkurbel: the table is longer than a page;"
        " it is set in parts, with --longtable where it stands\n"
    )
    assert page.read_text(encoding="utf-8") == kurbel(*words).out


MOST = {"handbook": 41}
LISTS = [
    ("layouts",),
    ("quantities", "--lang=en"),
    ("sources",),
    ("example",),
    ("handbook", "list", "examples/appendix"),
]


@pytest.mark.parametrize("words", LISTS, ids=lambda words: words[0])
def test_a_list_has_heads_and_is_no_wider_than_the_terminal(
    words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    plain = printed(*words).out
    for width in (40, 60, 80, 120):
        monkeypatch.setattr(screen, "width", lambda width=width: width)
        listed = printed(*words).out
        rule = max(listed.splitlines(), key=lambda line: line.count("─"))
        head, _, body = listed.partition(f"{rule}\n")
        assert set(rule) == {"─"}
        assert len(head.split()) > 1
        # A word of a command is not broken.
        assert max(map(len, listed.splitlines())) <= max(width, MOST.get(words[0], 0))
        # Nothing is lost; a command that goes on in the next line says so to the shell.
        there = [*head.split(), *body.replace(" \\\n", "\n").split()]
        assert not set(plain.split()) - set(there)


@pytest.mark.parametrize("width", [46, 47, 60, 61, 100])
def test_commands_of_layouts_are_whole_for_the_shell(width: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(screen, "width", lambda: width)
    lines = printed("layouts").out.splitlines()
    left, room = lines[0].index("Seite"), max(len(one) for one in lines if one.startswith("─"))
    joined = "\n".join(line[left:] for line in lines).replace("\\\n", " ").splitlines()
    asked = [shlex.split(line) for line in joined if line.startswith("kurbel ")]
    rows = json.loads(printed("layouts", "-f", "json").out)["rows"]
    assert asked == [shlex.split(row["command"]) for row in rows]
    wholes = iter(shlex.join(one) for one in asked)
    for line, following in pairwise([*lines, ""]):
        assert len(line) <= room
        if line[left:].startswith("kurbel "):
            # It is broken only where it is too long.
            assert line.endswith(" \\") == (left + len(next(wholes)) > room)
        if line.endswith(" \\"):
            # And no sooner than it must be.
            word = re.match(r"('[^']*'|\S)+", following[left:].lstrip())
            assert word
            assert len(line) + len(word[0]) + 1 > room


def test_lists_are_data_for_programs() -> None:
    rows = json.loads(printed("layouts", "-f", "json").out)["rows"]
    assert [row["layout"] for row in rows] == list(layout_names())
    assert all(row["command"].startswith("kurbel ") and row["title"] for row in rows)
    (one,) = (row for row in printed("example", "-f", "csv").records() if row["number"] == "33")
    assert (one["source"], one["options"]) == ("blau", "'--ratio")
    assert 'no format "latex"' in refusal("layouts", "-f", "latex")
    assert "--format is for the page of an example" in refusal("example", "-f", "latex")


@pytest.mark.parametrize(
    ("settings", "terminal", "coloured"),
    [
        ({}, True, True),
        ({}, False, False),
        ({"NO_COLOR": "1"}, True, False),
        ({"NO_COLOR": ""}, True, True),
        ({"NO_COLOR": "1", "FORCE_COLOR": "1"}, True, False),
        ({"CLICOLOR": "0"}, True, False),
        ({"TERM": "dumb"}, True, False),
        ({"FORCE_COLOR": "1"}, False, True),
        ({"CLICOLOR_FORCE": "1"}, False, True),
        ({"CLICOLOR_FORCE": "0"}, False, False),
    ],
)
def test_colours_are_for_terminals_and_for_those_who_ask(
    settings: dict[str, str], terminal: bool, coloured: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    reading, writing = os.pipe()
    with own_terminal(80, LINES, **settings), os.fdopen(writing, "w") as pipe:
        if not terminal:
            monkeypatch.setattr(sys, "stdout", pipe)
        assert screen.has_colours() is coloured
    os.close(reading)


def test_no_file_has_colours(tmp_path: Path) -> None:
    words = ("collate", "blau-33", "--columns", "verdict")
    assert "\x1b" not in printed(*words, FORCE_COLOR="1").out
    printed(*words, "-o", str(tmp_path / "page.txt"), FORCE_COLOR="1")
    assert b"\x1b" not in (tmp_path / "page.txt").read_bytes()


def test_a_collation_on_a_terminal_fits_it_and_is_coloured(programs: Programs) -> None:
    page, code = shown(programs, "collate", "blau-33", columns=60, LANG="de_DE")
    assert (code, page) == (0, render(collate("blau-33"), "text", width=60, colours=True))


def test_a_page_that_takes_long_counts_its_numbers_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    class Screen(io.StringIO):
        def isatty(self) -> bool:
            return True

    for patience, counted in ((0.0, True), (1e9, False)):
        error = Screen()
        monkeypatch.setattr(sys, "stderr", error)
        with screen.counted(patience):
            page = delta(eps="2;3;4")
        assert ("3 numbers" in error.getvalue(), "100%" in error.getvalue()) == (counted, counted)
        assert str(page) == str(delta(eps="2;3;4"))
