"""The Scotch yoke, whose crank pin runs in a slot square to the way of the yoke.

Units are R, the crank-pin velocity v and v²/R; φ counts from the inner dead centre. The yoke has moved
R (1 - cos φ), and the slot presses along its way. Exact but for what the circle rounded. Derived by us.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.drive.crank import RODLESS, Crank, DescribedDrive
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.linkage import Place
from kurbel.linkage.arc_quantities import headed_entry, sized_entry
from kurbel.linkage.linkage import (
    DECIMALS,
    Linkage,
    LinkageMechanism,
    LinkagePosition,
    Outline,
    Point,
    force_entries,
    force_formula,
    linkage_subject,
    plain_notes,
)
from kurbel.motion.entries import spanned
from kurbel.motion.evaluation import Needs
from kurbel.page.quantity import Formula, Quantity, words

# In units of R: half the slot, and the rod of the yoke.
SLOT, ROD = 1.15, 2.5
TITLE = words("Kreuzschubkurbel|Scotch yoke")


@dataclass(frozen=True, slots=True)
class Yoke(Linkage):
    """A Scotch yoke; of its crank radius, speed and the force on the yoke may be known."""

    crank: Crank = RODLESS

    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        nothing, (sine, cosine, way) = circle.sine * 0, (circle.sine, circle.cosine, circle.versine)
        return Place(way, way, nothing, nothing, nothing + 1, sine, cosine, sine)

    def dead_angle(self, stroke: int, kind: Kind) -> Numeric:
        """Return φ_i, or of the return φ_o - 180°, in degrees: 0."""
        return kind.of(Fraction(0))

    def lead(self, kind: Kind) -> Numeric:
        """Return by how many degrees the outstroke is longer than half a turn: 0."""
        return kind.of(Fraction(0))

    def way(self, kind: Kind) -> Numeric:
        """Return the stroke in units of R."""
        return kind.of(Fraction(2))

    def least_transmission(self, kind: Kind) -> Numeric:
        """Return the angle in degrees between the slot and the way of the yoke."""
        return kind.of(Fraction(90))

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
    forces = {
        "tangential_force": force_formula("tangential_force", "$T/F = sin φ$"),
        "radial_force": force_formula("radial_force", "$Z/F = cos φ$"),
    }
    return {one.key: one for one in (*_motion(), *force_entries(forces))}


def _motion() -> Iterator[Quantity]:
    path = Formula(lambda at: at.place.along, "$x/R = 1 - cos φ$")
    yield headed_entry("path", "Weg|Path", "x", "R", path, names=("path", "x"))
    yield spanned(
        "path_stroke", "Weg|Path", "$x$", "in Teilen des Hubes|in strokes", "Hub|stroke", DECIMALS,
        {"exact": path}, names=("s",), scale=lambda crank, numbers: numbers.of(Fraction(1, 2)),
    )  # fmt: skip
    yield sized_entry("path_mm", "Weg|Path", "x", "mm", path, Crank.millimetres, needs=Needs.LENGTH)
    for key, name, letter, formula in (
        (
            "velocity", "Geschwindigkeit|Velocity", "c",
            Formula(lambda at: at.place.velocity, "$c/v = sin φ$"),
        ),
        (
            "slot_velocity", "Gleitgeschwindigkeit im Schlitz|Rubbing velocity in the slot", "w",
            Formula(lambda at: at.place.cosine, "$w/v = cos φ$"),
        ),
    ):  # fmt: skip
        yield headed_entry(key, name, letter, "v", formula, names=(key, letter))
        yield sized_entry(f"{key}_mps", name, letter, "m/s", formula, Crank.pin_velocity)
    name, acceleration = (
        "Beschleunigung|Acceleration",
        Formula(lambda at: at.place.cosine, "$(p R)/v^2 = cos φ$"),
    )
    yield headed_entry(
        "acceleration", name, "p", "v²/R", acceleration, "$(p R)/v^2$", names=("acceleration", "p")
    )
    yield sized_entry("acceleration_mps2", name, "p", "m/s²", acceleration, Crank.pin_acceleration)


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
