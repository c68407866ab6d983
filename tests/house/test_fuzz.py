"""Random command lines and damaged files find nothing, nor do kills; `make fuzz` and `faults` try more."""

from __future__ import annotations

import subprocess
import sys

import pytest
from places import ROOT


def script(name: str, *words: str) -> str:
    """Run a script, which must find nothing; return what it prints."""
    line = [sys.executable, str(ROOT / "scripts" / name), *words]
    run = subprocess.run(line, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


def test_random_command_lines_and_damaged_files_find_nothing() -> None:
    assert script("fuzz.py", "60", "--seed", "6", "--jobs", "1").rstrip().endswith(": 0 failed")


@pytest.mark.slow
def test_killed_runs_go_on_to_the_same_bytes_and_leave_nothing() -> None:
    assert script("faults.py", "24").rstrip().endswith(": 0 wrong")
