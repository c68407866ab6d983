"""A sweep with parts of few rows, of which many are done in a moment; other processes find it by its name."""

from __future__ import annotations

import os
import signal
from decimal import Decimal
from pathlib import Path
from typing import Any

from kurbel.commands.part import Origin, Values
from kurbel.sweeps import run as runs
from kurbel.sweeps.asked import planned
from kurbel.sweeps.columns import Part
from kurbel.sweeps.rows import Sweep as Sweep

run, Running, StoppedError = runs.run, runs.SweepRunner, runs.StoppedError
# Where a file of this name lies, a part ends its process; the file is gone before.
KILLS = "kills"
DEADLY = 10
DELTA = "kurbel.commands.engine:delta"


class SmallParts(Sweep):
    """The sweep as it is, but for the size of its parts."""

    @property
    def rows_at_once(self) -> int:
        return 2

    @property
    def in_threads(self) -> bool:
        return False

    def computed(self, start: int, stop: int) -> Part:
        if start == DEADLY * self.rows_at_once and Path(KILLS).exists():
            Path(KILLS).unlink()
            os.kill(os.getpid(), signal.SIGKILL)
        return super().computed(start, stop)


class InThreads(SmallParts):
    """The same in threads, which balls allow one after the other."""

    @property
    def in_threads(self) -> bool:
        return True


def plan_of(count: int, step: str = "1") -> Any:
    """Return a plan of three times so many rows, of which the first three are refused."""
    last = 1 + (count - 1) * Decimal(step)
    return _planned(eps=[f"1..{last}:{step}"], ratio=["1:4;1:5;1:6"])


def small(**options: Any) -> SmallParts:
    """Return the sweep of δ over these options, as they are typed."""
    return SmallParts(_planned(**options))


def _planned(**options: Any) -> Any:
    return planned(DELTA, Values(options, dict.fromkeys(options, Origin.TYPED)))
