"""Random command lines and damaged files find nothing; `scripts/fuzz.py` tries more of them."""

from __future__ import annotations

import subprocess
import sys

import pytest
from places import ROOT


@pytest.mark.parametrize(("what", "count"), [("lines", 50), ("files", 20)])
def test_random_command_lines_and_damaged_files_find_nothing(what: str, count: int) -> None:
    script = [sys.executable, str(ROOT / "scripts" / "fuzz.py"), what, str(count), "--seed", "6"]
    run = subprocess.run(script, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (0, f"{count} {what} with seed 6: 0 failed\n"), run.stderr
