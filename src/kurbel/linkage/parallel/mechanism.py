"""The parallel crank as a mechanism: what its pages are about, and its quantities."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NoReturn

from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.kernel.parallel import coupler
from kurbel.linkage.linkage import At
from kurbel.linkage.mechanism import LinkageMechanism
from kurbel.linkage.parallel.crank import CHANGE_POINTS, ParallelCrank
from kurbel.linkage.quantities import DECIMALS, force_entries, force_formula
from kurbel.linkage.question import linkage_subject, plain_notes
from kurbel.motion.quantities import spanned
from kurbel.page.quantity import AND, Formula, Quantity, words
from kurbel.reading.notation import plain

_ALONG, _ACROSS = (
    "längs der Wellenlinie|along the line of shafts",
    "quer zur Wellenlinie|square to the line of shafts",
)
_PATH, _SPEED, _GAIN = "Weg|Path", "Geschwindigkeit|Velocity", "Beschleunigung|Acceleration"
# Field of Coupler, direction, name, symbol, heading, value, unit.
_COUPLER = (
    ("path", _ALONG, _PATH, "x", "x/R", "1 - cos φ", "R"),
    ("velocity", _ALONG, _SPEED, "c_x", "c_x/v", "sin φ", "v"),
    ("acceleration", _ALONG, _GAIN, "p_x", "(p_x R)/v^2", "cos φ", "v²/R"),
    ("rise", _ACROSS, _PATH, "y", "y/R", "sin φ", "R"),
    ("rise_velocity", _ACROSS, _SPEED, "c_y", "c_y/v", "cos φ", "v"),
    ("rise_acceleration", _ACROSS, _GAIN, "p_y", "(p_y R)/v^2", "-sin φ", "v²/R"),
)


@cache
def parallel_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the parallel crank by its key."""
    forces = {
        "tangential_force": force_formula("tangential_force", "$T/F = sin φ$"),
        "radial_force": force_formula("radial_force", "$Z/F = cos φ$"),
    }
    return {one.key: one for one in (*_coupler_entries(), *force_entries(forces))}


def _coupler_entries() -> Iterator[Quantity]:
    for field, part, name, symbol, heading, printed, unit in _COUPLER:
        formula = Formula(_field(field), f"${heading} = {printed}$")
        one = spanned(
            f"coupler_{field}", name, f"${symbol}$", f"${heading}$", unit, DECIMALS, {"exact": formula}
        )
        yield one._replace(spanners=(words(part), *one.spanners), part=words(part))


def _field(name: str) -> Callable[[At], Any]:
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

    def drives(self, said: Described, ratios: Sequence[str]) -> tuple[ParallelCrank, ...]:
        return (ParallelCrank(said.radius, said.force),)

    def solved(self, drives: Sequence[Any], method: str | None) -> NoReturn:
        raise ProblemError(
            "the rod of the parallel crank moves as the piston with a rod of infinite length;"
            " use --method infinite"
        )

    def conditions(self) -> Mapping[str, Quantity]:
        return {}


MECHANISM = Parallel()
