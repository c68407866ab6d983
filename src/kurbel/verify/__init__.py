"""A second arithmetic: drives, bodies and turns from their geometry, enclosed by mpmath's intervals.

Nothing here knows kurbel's formulas, balls or tables. Places of pins follow from circles and lines, whatever
moves from their Taylor series, forces by Newton and Euler or from virtual work, works from closed
antiderivatives, and every number is an enclosure with a proof, or exact.
"""

from __future__ import annotations

from importlib.util import find_spec

if find_spec("mpmath") is None:  # pragma: no cover
    from kurbel.reading.environment import missing_extra

    raise missing_extra("a second computation needs mpmath", "verify")

from kurbel.verify.bodies import Bodies, bodies
from kurbel.verify.drives import Drive, drive
from kurbel.verify.loads import Load, card, compressor, gas, pump, steam
from kurbel.verify.numbers import Number, Undecided
from kurbel.verify.slotted import SlottedLever
from kurbel.verify.turn import Turn, turn
from kurbel.verify.value import CONFIRMED, UNDECIDED, WRONG, Value

__all__ = [
    "CONFIRMED", "UNDECIDED", "WRONG", "Bodies", "Drive", "Load", "Number", "SlottedLever", "Turn",
    "Undecided", "Value", "bodies", "card", "compressor", "drive", "gas", "pump", "steam", "turn",
]  # fmt: skip
