"""What is accepted counts; `scripts/unused_options.py` tries all options beside all cases."""

from __future__ import annotations

import re
import subprocess
import sys

from places import ROOT


def test_options_that_are_accepted_change_what_is_printed() -> None:
    script = [
        sys.executable,
        str(ROOT / "scripts" / "unused_options.py"),
        "--only",
        "^(?!.* -f svg )",
        "--sample",
        "199",
    ]
    run = subprocess.run(script, capture_output=True, text=True, check=False)
    assert re.fullmatch(r"\d\d pairs: 0 to be mended\n", run.stdout), run.stdout + run.stderr
    assert run.returncode == 0
