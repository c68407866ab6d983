"""The beam engine as a mechanism, and what its pages are about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kurbel.drive.crank import Described, radii
from kurbel.errors import ProblemError
from kurbel.linkage.arc.mechanism import RockerMechanism
from kurbel.linkage.beam.captions import NAMES, SPEECH
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.beam.drive import BeamDrive, beam_columns
from kurbel.linkage.beam.quantities import beam_registry
from kurbel.linkage.question import linkage_subject
from kurbel.page.quantity import Quantity

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
