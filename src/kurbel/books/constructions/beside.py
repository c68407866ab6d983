"""What a construction may take beside its drive: a point of the rod, the rod's masses, the steam."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from kurbel.drive.rod import Rod
    from kurbel.engine.engine import Steam


# Of the rod, in its lengths, where they are not given: its centre of mass from B and its radius of gyration.
CENTRE, GYRATION = Fraction(65, 100), Fraction(35, 100)


class Beside(NamedTuple):
    """The share of the rod from the crosshead pin at which a point of it lies, the rod and the steam, where
    they are given."""

    point: Fraction = Fraction(1, 2)
    rod: Rod | None = None
    steam: Steam | None = None


ALONE = Beside()
