"""The Scotch yoke, whose crank pin runs in a slot square to the way of the yoke.

Units are R, the crank-pin velocity v and v²/R; φ counts from the inner dead centre. The yoke has moved
R (1 - cos φ), and the slot presses along its way. Exact but for what the circle rounded. Derived by us.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from kurbel.drive.crank import RODLESS, Crank, DescribedDrive
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.linkage import Place, coupler_place
from kurbel.linkage.linkage import (
    Linkage,
    LinkageMechanism,
    LinkagePosition,
    Outline,
    Point,
    in_strokes,
    linkage_subject,
    plain_notes,
    sine_forces,
)
from kurbel.motion.entries import headed, in_units, measured
from kurbel.page.quantity import Formula, Quantity, words

# In units of R: half the slot, and the rod of the yoke.
SLOT, ROD = 1.15, 2.5
TITLE = words("Kreuzschubkurbel|Scotch yoke")


@dataclass(frozen=True, slots=True)
class Yoke(Linkage):
    """A Scotch yoke; of its crank radius, speed and the force on the yoke may be known."""

    crank: Crank = RODLESS

    def place(self, stroke: int, circle: Circle[Numeric], kind: Kind) -> Place[Numeric]:
        return coupler_place(circle)

    def outline(self) -> Outline:
        return Outline(TITLE, ((0, 0),), -1, 1 + ROD, _stand)


def _stand(pin: Point) -> LinkagePosition:
    x, shaft = pin[0], (0.0, 0.0)
    slot, rod = ((x, -SLOT), (x, SLOT)), ((x, 0.0), (x + ROD, 0.0))
    links = {"crank": (shaft, pin), "slot": slot, "rod": rod}
    return LinkagePosition(links, (pin,), ((shaft, pin), slot, rod), lengths=((1 + ROD, x + ROD, "$x$"),))


@cache
def yoke_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the Scotch yoke by its key."""
    return {one.key: one for one in (*_motion(), *sine_forces())}


def _motion() -> Iterator[Quantity]:
    path = headed(
        "path", "Weg|Path", "x", "R", Formula(lambda at: at.place.along, "$x/R = 1 - cos φ$"),
        names=("path", "x"),
    )  # fmt: skip
    yield from (path, in_strokes(path), measured(path))
    for key, name, letter, unit, formula in (
        (
            "velocity", "Geschwindigkeit|Velocity", "c", "v",
            Formula(lambda at: at.place.velocity, "$c/v = sin φ$"),
        ),
        (
            "slot_velocity", "Gleitgeschwindigkeit im Schlitz|Rubbing velocity in the slot", "w", "v",
            Formula(lambda at: at.place.cosine, "$w/v = cos φ$"),
        ),
        (
            "acceleration", "Beschleunigung|Acceleration", "p", "v²/R",
            Formula(lambda at: at.place.cosine, "$(p R)/v^2 = cos φ$"),
        ),
    ):  # fmt: skip
        yield from in_units(key, name, letter, unit, formula, names=(key, letter))


SUBJECT = linkage_subject(
    "Scotch yoke",
    layout="yoke",
    command="table --mechanism yoke",
    quantities=yoke_registry,
    notes=plain_notes(
        words("$F$ auf die Schleife, in der Richtung des Hingangs|$F$ on the yoke, as it moves outwards"),
        words("$x$ vom inneren Totpunkt, Hub $2 R$|$x$ from the inner dead centre, stroke $2 R$"),
    ),
)


class ScotchYoke(LinkageMechanism):
    name = "yoke"
    title = "the Scotch yoke"
    layout = "yoke"
    forces_layout = "forces-yoke"
    heavy = False
    takes = ("stroke", "speed")
    motion = (("path", "path"), ("velocity", "velocity"), ("acceleration", "acceleration"))

    def lengths(self, drive: Yoke) -> Iterator[Label]:
        """Yield what was given of its lengths beside R: nothing."""
        yield from ()

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[Yoke, ...]:
        return (Yoke(said.rodless),)


MECHANISM = ScotchYoke()
