"""The beam engine as a mechanism, and what its pages are about.

Conditions see it as an arc crank whose formulas no polynomial with rational numbers has.

Where a quantity rises and falls is therefore proved by balls: all zeros of its slope are enclosed
(`roots.isolate`), and a value that is just reached stays unsettled.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from kurbel.drive.crank import Described, radii
from kurbel.errors import ProblemError
from kurbel.exact.course import Course
from kurbel.exact.place import Place
from kurbel.linkage.arc.drive import ArcDrive, with_share
from kurbel.linkage.arc.mechanism import RockerMechanism
from kurbel.linkage.arc.names import named
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.beam.captions import NAMES, SPEECH
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.question import linkage_subject
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Quantity

# What is zero at the dead centres.
AT_REST = ("velocity", "tangential_force", "torque")


@cache
def beam_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place: the outstroke's quantities, which stand for either stroke."""
    return with_share({key: one for key, one in beam_registry().items() if one.stroke == OUT})


class BeamDrive(ArcDrive):
    """The beam engine."""

    def __init__(self, crank: BeamCrank, page: str = "beam") -> None:
        super().__init__(crank, page)

    @staticmethod
    def columns_of(page: str) -> Mapping[str, Quantity]:
        return beam_columns()

    def is_free(self, quantity: Quantity) -> bool:
        return False

    def ends(self, stroke: int) -> tuple[Place, Place]:
        begin, end = (Place(angle, self.centre) for angle in self._dead_angles(stroke))
        return begin, end

    def _course(self, quantity: str, stroke: int) -> Course:
        one = self.asked(quantity, stroke)
        if one.rises:
            return super()._course(quantity, stroke)
        return self.by_balls(one, stroke, *AT_REST)


# Of the way of the rod's end, which no piston has.
OF_END = ("chord", "slide_path", "rise")


@cache
def beam_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the beam engine by its key, the return stroke's beside the outstroke's."""
    return {
        key: named(one, NAMES)
        for key, one in arc_registry().items()
        if key.removesuffix("_return") not in OF_END
    }


SUBJECT = linkage_subject(
    "beam engine",
    layout="beam",
    command="table --mechanism beam",
    quantities=beam_registry,
    caption=SPEECH.caption,
    notes=SPEECH.notes,
    ratios=True,
)


class Beam(RockerMechanism):
    name = "beam"
    title = BeamCrank.title
    layout = "beam"
    forces_layout = "forces-beam"
    takes = ("ratio", "stroke", "rod", "speed", "beam", "rocker_inertia", "method")
    speech = SPEECH
    names = NAMES

    def lacking(self, said: Described) -> str:
        if said.beam is not None:
            return ""
        return "the beam engine needs the arm of its beam; add --beam, for example --beam 3"

    def drives(self, said: Described, ratios: Sequence[str]) -> tuple[BeamCrank, ...]:
        if said.method not in (None, "exact"):
            raise ProblemError(
                f'method "{said.method}" has no formulas for the beam engine; use exact,'
                " with --ratio 1:∞ for the infinite rod"
            )
        assert said.beam is not None
        return tuple(
            BeamCrank(crank, radii(said.beam, "beam", crank.radius)) for crank in said.cranks(ratios)
        )

    def solved(self, drives: Sequence[Any], method: str | None) -> tuple[BeamDrive, ...]:
        return tuple(map(BeamDrive, drives))

    def conditions(self) -> Mapping[str, Quantity]:
        return beam_columns()


MECHANISM = Beam()
