"""What can act on a crank drive: the loads by their names, and what is asked of one that acts on a piston."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from kurbel.exact.certify import Kind
from kurbel.kernel.turning import Stroke

FORCE, MASSES, STEAM, CARD = "force", "masses", "steam", "card"
LOADS: Mapping[str, str] = {
    FORCE: "a constant force",
    MASSES: "moving masses",
    STEAM: "steam",
    CARD: "an indicator card",
}


class Load(Protocol):
    """What acts on the piston, on any kind of number: nothing is asked of it but its force at a share of the
    stroke, and the work that it has done there.
    """

    @property
    def name(self) -> str:
        """What it is: a key of LOADS."""
        ...

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return the outstroke and the return; on that a cylinder that is not `double` idles."""
        ...
