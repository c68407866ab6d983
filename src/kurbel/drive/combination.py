"""What moves and what acts on it: which drives are computed under which loads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Place
from kurbel.kernel.turning import Stroke

STRAIGHT, OFFSET, ARC, PARALLEL, BEAM = "straight", "offset", "arc", "parallel", "beam"
NOTHING, FORCE, MASSES, STEAM, CARD = "nothing", "force", "masses", "steam", "card"


class Drive(Protocol):
    """What moves, on any kind of number.

    A stroke is OUT (1) or RETURN (-1); everything on it counts from the dead centre where it begins and in
    its direction. The circle is that of the crank angle φ, on RETURN of φ less 180°.
    """

    @property
    def name(self) -> str:
        """What it is: a key of DRIVES."""
        ...

    @property
    def crank(self) -> Crank:
        """The crank that turns in it, with the radius and the force where these are known."""
        ...

    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        """Return where the driven end is: its way, its velocity, the slants of rod and crank against it."""
        ...


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


DRIVES: Mapping[str, str] = {
    STRAIGHT: "the straight crank",
    OFFSET: "the offset crank",
    ARC: "the arc crank",
    PARALLEL: "the parallel crank",
    BEAM: "the beam engine",
}
LOADS: Mapping[str, str] = {
    FORCE: "a constant force",
    MASSES: "moving masses",
    STEAM: "steam",
    CARD: "an indicator card",
}
COMPUTED: Mapping[str, Sequence[str]] = {
    STRAIGHT: (FORCE, MASSES, STEAM, CARD),
    OFFSET: (FORCE, MASSES),
    ARC: (FORCE,),
    PARALLEL: (FORCE,),
    BEAM: (),
}


def uncomputed(drive: str, load: str) -> str:
    """Return the sentence that refuses a drive under a load, nothing where it is computed."""
    if load in COMPUTED[drive] or load == NOTHING:
        return ""
    known = [LOADS[one] for one in COMPUTED[drive]] or ["no load"]
    takers = [DRIVES[one] for one, loads in COMPUTED.items() if load in loads]
    return (
        f"{DRIVES[drive]} under {LOADS[load]} is not computed;"
        f" {LOADS[load]} can act on {' or '.join(takers)}, and {DRIVES[drive]} takes {' or '.join(known)}"
    )


def check(drive: str, load: str) -> None:
    """Raise ProblemError for a drive under a load that is not computed."""
    if sentence := uncomputed(drive, load):
        raise ProblemError(sentence)
