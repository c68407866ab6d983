"""A sweep with parts of few rows, of which many are done in a moment; other processes find it by its name."""

from __future__ import annotations

import os
import signal
from fractions import Fraction
from pathlib import Path

from kurbel.reading.notation import Progression
from kurbel.sweeps.plan import Axis, Plan
from kurbel.sweeps.rows import Part, Sweep

# Where a file of this name lies, a part ends its process; the file is gone before.
KILLS = "kills"
DEADLY = 10


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


def plan_of(count: int, step: Fraction = Fraction(1)) -> Plan:
    """Return a plan of three times so many rows, of which the first three are refused."""
    expansions = Axis("eps", Progression(Fraction(1), step, count))
    return Plan(
        "kurbel.commands.engine:delta_table", {}, ((expansions,), (Axis("ratio", ("1:4", "1:5", "1:6")),))
    )
