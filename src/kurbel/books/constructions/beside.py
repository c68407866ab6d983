"""What a construction may take beside its drive: a point of the rod, the rod's masses, the steam."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.exact.numerals import Label, exact_text
from kurbel.page.quantity import Words, words

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
# The options.
TAKEN = ("point", "centre", "gyration", "eps", "back")
WORDS: Mapping[str, Words] = {
    "point": words("$D$ liegt um $x = {x} l$ von $B$|$D$ lies $x = {x} l$ from $B$"),
    "constant": words("Die Kolbenkraft ist überall $P = Q$|The piston force is $P = Q$ throughout"),
    "steam": words(
        "Dampf mit dem Expansionsverhältnis $ε = {eps}$ und dem Gegendruck $R_b = {back}$; $Q$ vor der"
        " Absperrung"
        "|Steam with the expansion ratio $ε = {eps}$ and the back pressure $R_b = {back}$; $Q$ before cut-off"
    ),
}


def said_of(beside: Beside, takes: Collection[str], lang: str) -> Iterator[Label]:
    """Yield what pages say of what stands beside the drive."""
    if "point" in takes:
        yield WORDS["point"][lang].format(x=exact_text(beside.point))
    if "eps" in takes and beside.steam is None:
        yield WORDS["constant"][lang]
    elif beside.steam is not None:
        back, ratio = beside.steam.back, exact_text(beside.steam.expansion)
        said = "Q/ε" if back is None else f"{exact_text(back)} Q" if back else "0"
        yield WORDS["steam"][lang].format(eps=ratio, back=said)
