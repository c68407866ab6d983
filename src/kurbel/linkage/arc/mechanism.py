"""The arc crank as a mechanism, and what its pages are about."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, ClassVar

from kurbel.drive.crank import Crank, Described, radii
from kurbel.drive.load import CARD, COMPRESSOR, FORCE, GAS, MASSES, PUMP, STEAM
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import Label
from kurbel.linkage.arc.captions import SPEECH, Speech
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.arc.drive import ArcDrive, arc_columns
from kurbel.linkage.arc.names import NAMES, headed, named
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.mechanism import LinkageMechanism
from kurbel.linkage.question import linkage_subject
from kurbel.motion.captions import moving_notes
from kurbel.page.quantity import Column, Quantity
from kurbel.reading.given import as_number

SUBJECT = linkage_subject(
    "arc crank",
    layout="arc",
    command="table --mechanism arc",
    quantities=arc_registry,
    caption=SPEECH.caption,
    notes=SPEECH.notes,
    ratios=True,
)


class RockerMechanism(LinkageMechanism):
    """A crank that moves a rocker: what pages say of it, and what they call its parts."""

    loads = (FORCE, MASSES, STEAM, CARD, COMPRESSOR, PUMP, GAS)
    motion = (("path", "path"), ("velocity", "velocity"), ("acceleration", "acceleration"))
    drawing = "kurbel.plot.drawings:arc_drawing"
    moving = "kurbel.plot.moving:rocker_scene"
    rod = "kurbel.linkage.arc.rocker:rod"
    speech: ClassVar[Speech]
    names: ClassVar[Mapping[str, str]]

    def loaded_notes(self, drives: Sequence[Any], lang: str) -> Sequence[Label]:
        return self.speech.engine_notes(drives, lang)

    def rod_notes(self, drives: Sequence[Any], lang: str) -> Iterable[Label]:
        yield from super().rod_notes(drives, lang)
        yield from (self.speech.dead_centres(one, lang) for one in drives)

    def masses_notes(
        self, crank: Crank, ratio_symbol: str, lang: str, shown: Collection[str] = ()
    ) -> Iterable[Label]:
        yield from moving_notes(crank, ratio_symbol, lang, self.speech.words)
        yield from self.speech.held(crank, shown, lang)

    def named(self, quantity: Quantity) -> Quantity:
        return named(quantity, self.names)

    def headed(self, column: Column) -> Column:
        return headed(column, self.names)


class Arc(RockerMechanism):
    name = "arc"
    title = ArcCrank.title
    layout = "arc"
    forces_layout = "forces-arc"
    takes = (
        "ratio",
        "stroke",
        "rod",
        "speed",
        "offset",
        "rocker",
        "pivot",
        "circuit",
        "rocker_inertia",
        "method",
    )
    speech = SPEECH
    names = NAMES

    def lacking(self, said: Described) -> str:
        if said.rocker is not None:
            return ""
        return "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6"

    def drives(self, said: Described, ratios: Sequence[str]) -> tuple[ArcCrank, ...]:
        if said.method not in (None, "exact"):
            raise ProblemError(
                f'method "{said.method}" has no formulas for the arc crank; use exact,'
                " with --ratio 1:∞ for the infinite rod"
            )
        return tuple(_arc(said, crank) for crank in said._replace(offset=None).cranks(ratios))

    def solved(self, drives: Sequence[Any], method: str | None) -> tuple[ArcDrive, ...]:
        return tuple(map(ArcDrive, drives))

    def conditions(self) -> Mapping[str, Quantity]:
        return arc_columns()


def _arc(said: Described, crank: Crank) -> ArcCrank:
    assert said.rocker is not None
    rocker, places = radii(said.rocker, "rocker", crank.radius), _pivot(said, crank.radius)
    if said.offset is not None:
        crank = replace(crank, offset=radii(said.offset, "offset", crank.radius))
    # Without a place the pivot has none of its own.
    distance, height = places or (None, None)
    circuit = 1 if said.circuit is None else as_number(said.circuit, "circuit")
    return ArcCrank(crank, rocker, distance, height, circuit)


def _pivot(said: Described, radius: Fraction | None) -> tuple[Fraction, Fraction] | tuple[()]:
    """D and H from "5;6" or a pair."""
    given = said.pivot
    if given is None:
        return ()
    parts = given.split(";") if isinstance(given, str) else given
    if not isinstance(parts, Sequence) or len(parts) != 2:
        raise NotationError(
            f'pivot "{str(given)[:40]}" is not a place; write its distance from the shaft along and across'
            " the slide in units of R as 'D;H', for example '5;6'"
        )
    distance, height = (radii(part, "pivot", radius) for part in parts)
    return distance, height


MECHANISM = Arc()
