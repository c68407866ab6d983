"""The parallel crank: two equal cranks, joined by a rod as long as their shafts are apart."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, NoReturn

from kurbel.drive.at import At
from kurbel.drive.crank import RODLESS, Crank, Described
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.coupler import Rod, crank_pin
from kurbel.kernel.linkage import Place, coupler, coupler_place
from kurbel.linkage.linkage import (
    DECIMALS,
    Linkage,
    LinkageMechanism,
    Outline,
    Point,
    Stand,
    force_entries,
    force_formula,
    linkage_subject,
    plain_notes,
)
from kurbel.motion.entries import spanned
from kurbel.page.quantity import AND, Formula, Quantity, words
from kurbel.reading.notation import plain

CHANGE_POINTS = (Fraction(0), Fraction(180))
"""The angles from the line of shafts at which a parallel crank may fold into the antiparallel crank."""
# In units of R. The motion is the same whatever the distance of the shafts; this one parts the circles.
SHAFTS = 3.0
TITLE = words("Parallelkurbel|Parallel crank")


@dataclass(frozen=True, slots=True)
class ParallelCrank(Linkage):
    """A parallel crank; its motion in units of R is that of a crank with an infinite rod, square to it too.

    The radius R in metres and the force of the rod on a crank in newtons may be known. The motion depends on
    no length.
    """

    crank: Crank = RODLESS

    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        """Return where any point of the rod stands, which moves alike on both strokes."""
        return coupler_place(circle)

    def outline(self) -> Outline:
        return Outline(TITLE, ((0, 0), (SHAFTS, 0)), -1, SHAFTS + 1, _stand)


def _stand(pin: Point) -> Stand:
    shaft, other, second = (0.0, 0.0), (SHAFTS, 0.0), (pin[0] + SHAFTS, pin[1])
    return Stand(
        {"crank": (shaft, pin), "second_crank": (other, second), "rod": (pin, second)},
        (pin, second),
        ((shaft, pin, second, other),),
        (("second_crank", "$R$", 0.68), ("rod", "$L$", 0.5)),
        ((0, SHAFTS, "$L$"),),
    )


_ALONG = "längs der Wellenlinie|along the line of shafts"
_ACROSS = "quer zur Wellenlinie|square to the line of shafts"
_PATH, _SPEED, _GAIN = "Weg|Path", "Geschwindigkeit|Velocity", "Beschleunigung|Acceleration"
# Field of Coupler, direction, name, symbol, heading, value, unit.
_COUPLER = (
    ("path", _ALONG, _PATH, "x", "x/R", "1 - cos φ", "$R$"),
    ("velocity", _ALONG, _SPEED, "c_x", "c_x/v", "sin φ", "$v$"),
    ("acceleration", _ALONG, _GAIN, "p_x", "(p_x R)/v^2", "cos φ", "$v^2/R$"),
    ("rise", _ACROSS, _PATH, "y", "y/R", "sin φ", "$R$"),
    ("rise_velocity", _ACROSS, _SPEED, "c_y", "c_y/v", "cos φ", "$v$"),
    ("rise_acceleration", _ACROSS, _GAIN, "p_y", "(p_y R)/v^2", "-sin φ", "$v^2/R$"),
)


@cache
def parallel_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the parallel crank by its key."""
    forces = {
        "tangential_force": force_formula("tangential_force", "$T/F = sin φ$"),
        "radial_force": force_formula("radial_force", "$Z/F = cos φ$"),
    }
    return {one.key: one for one in (*_coupler_entries(), *_rod_entries(), *force_entries(forces))}


def _coupler_entries() -> Iterator[Quantity]:
    for field, part, name, symbol, heading, printed, unit in _COUPLER:
        formula = Formula(_field(field), f"${heading} = {printed}$")
        one = spanned(
            f"coupler_{field}", name, f"${symbol}$", f"${heading}$", unit, DECIMALS, {"exact": formula}
        )
        yield one._replace(spanners=(words(part), *one.spanners), part=words(part))


def _rod_entries() -> Iterator[Quantity]:
    """Yield the turning of the rod, which stays parallel to the line of shafts."""
    for key, name, letter, unit in (
        ("rod_velocity", "Winkelgeschwindigkeit|Angular velocity", "ω_L", "ω"),
        ("rod_acceleration", "Winkelbeschleunigung|Angular acceleration", "ε_L", "ω²"),
    ):
        none = Formula(lambda at: at.numbers.of(Fraction(0)), f"${letter} = 0$")
        head = f"${letter}/{unit.replace('²', '^2')}$"
        yield spanned(key, name, f"${letter}$", head, unit, DECIMALS, {"exact": none})


def _field(name: str) -> Callable[[At], Numeric]:
    return lambda at: getattr(coupler(at.circle), name)


_POINTS = tuple(f"${plain(angle)}°$" for angle in CHANGE_POINTS)
SUBJECT = linkage_subject(
    "parallel crank",
    layout="parallel",
    command="table --mechanism parallel",
    quantities=parallel_registry,
    notes=plain_notes(
        words(
            "$F$ von der Koppel auf den Kurbelzapfen, längs der Wellenlinie, positiv wie der Weg beim Hingang"
            "|$F$ of the coupling rod on the crank pin, along the line of shafts, positive as the path of the"
            " outstroke"
        ),
        words(
            "Jeder Punkt der Koppel läuft auf einem Kreis vom Halbmesser $R$; $y$ ist zur Seite des"
            " Kurbelzapfens beim Hingang gerechnet"
            "|Every point of the coupling rod moves on a circle of radius $R$; $y$ counts to the side of the"
            " crank pin during the outstroke"
        ),
        words(
            f"Bei {AND['de'].join(_POINTS)} liegen alle Glieder in einer Linie; dort kann die zweite Kurbel"
            " umschlagen (Antiparallelkurbel)"
            f"|At {AND['en'].join(_POINTS)} all links lie in line; there the second crank may turn back"
            " (antiparallel crank)"
        ),
    ),
)


class Parallel(LinkageMechanism):
    name = "parallel"
    title = "the parallel crank"
    layout = "parallel"
    forces_layout = "forces-parallel"
    heavy = False
    rod = "kurbel.linkage.parallel:rod_ends"

    def drives(self, said: Described, ratios: Sequence[str]) -> tuple[ParallelCrank, ...]:
        return (ParallelCrank(said.rodless),)

    def solved(self, drives: Sequence[Any], method: str | None) -> NoReturn:
        raise ProblemError(
            "the rod of the parallel crank moves as the piston with a rod of infinite length;"
            " leave --mechanism out and use --method infinite"
        )

    def conditions(self) -> Mapping[str, Quantity]:
        return {}


def rod_ends(
    drive: ParallelCrank, method: str, circle: Any, kind: Kind, beside: bool
) -> tuple[Rod[Numeric], None]:
    """Return the ends of the rod, which move alike, as all its points."""
    end = crank_pin(circle, circle.versine)
    return Rod(end, end), None


MECHANISM = Parallel()
