"""A sweep with parts of few rows, of which many are done in a moment; workers find it on their path."""

from __future__ import annotations

from kurbel.sweeps.plan import Axis, Plan
from kurbel.sweeps.rows import Sweep


class SmallParts(Sweep):
    """The sweep as it is, but for the size of its parts."""

    @property
    def rows_at_once(self) -> int:
        return 5


def small_parts(count: int) -> SmallParts:
    """Return a sweep of three times so many rows."""
    ratios = Axis("ratio", ["1:4", "1:5", "1:6"])
    return SmallParts(
        Plan("kurbel.commands.engine:delta_table", {}, ((Axis("eps", range(2, 2 + count)),), (ratios,)))
    )
