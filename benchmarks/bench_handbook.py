"""500 tables in 4 text formats as a handbook: built anew, and again with nothing changed.

Beside it stands the cold start of kurbel, one table on a terminal: building nothing must not take twice that.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

TABLES, FORMATS, TIMES = 500, ("text", "markdown", "latex", "html"), 9


def manifest() -> str:
    """Return a manifest of so many tables of different ratios in ten chapters."""
    lines = ['title = "Tafeln"', f"formats = {[*FORMATS]}"]
    for number in range(TABLES):
        if number % 50 == 0:
            lines += ["[[chapter]]", f'title = "Kapitel {number // 50}"']
        lines += ["[[chapter.part]]", f'run = "table --ratio 1:{3 + number / 100:.2f}"']
    return "\n".join(lines)


def seconds(*words: str) -> float:
    """Return how long kurbel takes with these words."""
    started = time.perf_counter()
    subprocess.run([sys.executable, "-m", "kurbel", *words], check=True, capture_output=True)
    return time.perf_counter() - started


def main() -> None:
    with TemporaryDirectory() as folder:
        Path(folder, "handbook.toml").write_text(manifest(), encoding="utf-8")
        anew = seconds("handbook", "build", folder)
        pairs = [
            (seconds("handbook", "build", folder), seconds("table", "--ratio", "1:5")) for _ in range(TIMES)
        ]
    nothing, cold = (statistics.median(column) for column in zip(*pairs, strict=True))
    print(f"handbook of {TABLES} tables in {len(FORMATS)} formats, built anew: {anew:.1f} s")
    print(
        f"built again with nothing changed: {1000 * nothing:.0f} ms, {nothing / cold:.2f} times"
        f" the cold start of `kurbel table` ({1000 * cold:.0f} ms), medians of {TIMES}"
    )


if __name__ == "__main__":
    main()
