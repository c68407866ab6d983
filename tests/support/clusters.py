"""A Dask cluster on the loopback address: a scheduler and workers, processes that end with the test."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from places import ROOT
from programs import Programs, wait_until


class Cluster:
    """A scheduler, whose workers run in a folder."""

    def __init__(self, programs: Programs, folder: Path) -> None:
        self.folder = folder
        self.workers: list[subprocess.Popen[bytes]] = []
        self._programs = programs
        file = folder / "scheduler.json"
        words = ("scheduler", "--host=127.0.0.1", "--port=0", "--no-dashboard", f"--scheduler-file={file}")
        self.scheduler = self._start(*words)
        # It is written at once, for a client may wait for it, too.
        wait_until(lambda: file.exists() and file.stat().st_size > 0)
        self.address: str = json.loads(file.read_text())["address"]
        self.file = str(file)

    def work(self, path: str = "") -> None:
        """Start a worker, which finds modules of tests and, before all others, what lies in a path."""
        words = ("--host=127.0.0.1", "--nthreads=1", "--no-nanny", "--no-dashboard", "--memory-limit=0")
        self.workers.append(self._start("worker", self.address, *words, path=path))

    def _start(self, *words: str, path: str = "") -> subprocess.Popen[bytes]:
        paths = os.pathsep.join([*filter(None, [path]), str(ROOT / "tests" / "support")])
        return self._programs.start(
            *(sys.executable, "-m", "dask", *words),
            cwd=self.folder,
            env={**os.environ, "PYTHONPATH": paths},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
