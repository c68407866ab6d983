"""How many modules a command enters: a reader of a table's way has no more of them to read than before."""

from __future__ import annotations

import re
import subprocess
import sys

from places import ROOT

# The first release entered 37, 47 and 56.
MOST = {"table --ratio 1:5": 35, "delta --eps 4": 47, "handbook build .": 55}


def test_the_way_of_a_table_becomes_no_longer() -> None:
    script = [sys.executable, str(ROOT / "scripts" / "walk.py")]
    printed = subprocess.run(script, capture_output=True, text=True, check=True).stdout
    rows = re.findall(r"^kurbel (.+?) {2,}(\d+) +\d+$", printed, re.MULTILINE)
    entered = {command: int(count) for command, count in rows}
    assert entered.keys() == MOST.keys()
    assert not {command: count for command, count in entered.items() if count > MOST[command]}
