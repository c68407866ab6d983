"""Sweeps that are killed at random moments (kill -9), and gone on with: the same bytes, and no litter.

    .venv/bin/python scripts/kill_sweeps.py --count 100 --seed 1

Every second of them computes in processes, the others in threads. Some are killed again as they go on. The
moments are spread over the time that the run takes undisturbed, from its start to its end.
"""

from __future__ import annotations

import argparse
import os
import random
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

IN_THREADS = "table --ratio 1:3..8:0.05 --step 0.005 --columns x,c,p"
IN_PROCESSES = "harmonics --ratio 1:3..8:0.002"
# So many of those that go on are killed, too.
AGAIN = 0.3
# Seconds in which processes notice that the one that started them is gone.
PATIENCE = 60.0


class Undisturbed(NamedTuple):
    """What a sweep writes if nobody kills it, and how long that takes."""

    words: list[str]
    content: bytes
    seconds: float


def main() -> int:
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    reader.add_argument("--count", type=int, default=100, help="how many runs are killed")
    reader.add_argument("--seed", type=int, default=1)
    asked = reader.parse_args()
    moments = random.Random(asked.seed)
    with TemporaryDirectory(prefix="kurbel-kills-") as folder:
        target = Path(folder) / "sweep.parquet"
        sweeps = [undisturbed(sweep, target) for sweep in (IN_THREADS, IN_PROCESSES)]
        kills = parts = 0
        while kills < asked.count:
            sweep = sweeps[kills % 2]
            if not killed(sweep, target, moments, resume=False):
                target.unlink()
                continue
            kills += 1
            parts += len([*Path(f"{target}.parts").rglob("*.arrow")])
            while moments.random() < AGAIN and killed(sweep, target, moments, resume=True):
                kills += 1
            wrong = gone_on(sweep, target)
            if wrong:
                print(f"kill {kills}, seed {asked.seed}: {wrong}")
                return 1
            target.unlink()
    print(
        f"{kills} kills: the same bytes each time, and nothing left; {parts} finished parts were gone on with"
    )
    return 0


def undisturbed(sweep: str, target: Path) -> Undisturbed:
    """Run a sweep twice, for the first run finds nothing in the caches of the system."""
    words = [sys.executable, "-m", "kurbel", "sweep", *shlex.split(sweep), "-o", str(target)]
    for _ in range(2):
        start = time.monotonic()
        subprocess.run(words, check=True, stderr=subprocess.DEVNULL)
        seconds = time.monotonic() - start
        content = target.read_bytes()
        target.unlink()
    return Undisturbed(words, content, seconds)


def killed(sweep: Undisturbed, target: Path, moments: random.Random, resume: bool) -> bool:
    """Start a run and kill it at a random moment; tell whether it had not ended before."""
    words = [*sweep.words, *(["--resume"] if resume else [])]
    process = subprocess.Popen(words, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        process.wait(moments.uniform(0, sweep.seconds))
    except subprocess.TimeoutExpired:
        process.kill()
    ended = process.wait()
    wait_for_the_others(process.pid)
    assert ended in (0, -signal.SIGKILL), f"{shlex.join(words)} ended with {ended}"
    return ended != 0


def wait_for_the_others(group: int) -> None:
    """Return when no process of a group runs; they end with the one that started them."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.01)
    os.killpg(group, signal.SIGKILL)
    raise SystemExit(f"processes that a killed run started still ran {PATIENCE:.0f} s later")


def gone_on(sweep: Undisturbed, target: Path) -> str:
    """Go on with what was killed, and return what is wrong then, if anything is."""
    done = subprocess.run([*sweep.words, "--resume"], capture_output=True, text=True)
    if done.returncode:
        return done.stderr
    if target.read_bytes() != sweep.content:
        return "other bytes"
    left = sorted(path.name for path in target.parent.iterdir() if path != target)
    return f"left: {', '.join(left)}" if left else ""


if __name__ == "__main__":
    sys.exit(main())
