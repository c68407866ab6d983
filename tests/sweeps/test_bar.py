"""The bar of a sweep on a terminal: how far it is, how fast, and how long it still takes."""

from __future__ import annotations

import io
import re
import sys

import pytest
from small_parts import SmallParts, Sweep, plan_of

from kurbel.cli.sweep import SweepOptions, running
from kurbel.commands.part import Values


class Screen(io.StringIO):
    """A terminal that keeps what it shows."""

    def isatty(self) -> bool:
        return True


CODES = re.compile("\x1b\\[[?0-9]*[a-zA-Z]")
ASKED = SweepOptions(Values({}, {}))


def test_a_terminal_shows_how_far_a_sweep_is(monkeypatch: pytest.MonkeyPatch) -> None:
    screen, clock = Screen(), [0.0]
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setattr("time.time", lambda: clock[0])
    with running(ASKED, SmallParts(plan_of(400)), "delta.parquet") as how:
        for _ in range(3):
            clock[0] += 2.0
            how.watch(100)
    # 50 rows a second, of which 900 are left.
    shown = CODES.sub("", screen.getvalue()).split("\r")[-1].split()
    assert shown == ["delta.parquet", f"[{'#' * 9}{'-' * 27}]", "25%", "00:00:18", "50", "rows/s"]


def test_a_pipe_and_a_sweep_of_one_part_have_no_bar(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with running(ASKED, SmallParts(plan_of(400)), "delta.parquet") as how:
        how.watch(100)
    assert capsys.readouterr() == ("", "")
    monkeypatch.setattr(sys, "stderr", screen := Screen())
    with running(ASKED, Sweep(plan_of(400)), "delta.parquet") as how:
        how.watch(1200)
    assert screen.getvalue() == ""
