"""The straight and the offset crank as mechanisms: the crank drives with a crosshead."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from kurbel.drive.crank import Crank
from kurbel.drive.described import Described
from kurbel.drive.load import CARD, FORCE, MASSES, STEAM
from kurbel.motion.mechanism import Mechanism

if TYPE_CHECKING:
    from kurbel.motion.drives import SlideDrive
    from kurbel.motion.question import Request
    from kurbel.page.quantity import Quantity

MOTION = (("x", "x_mm"), ("c", "c_mps"), ("p", "p_mps2"))
FORCES = (
    ("rod_force", "rod_force_n"),
    ("guide_force", "guide_force_n"),
    ("tangential_force", "tangential_force_n"),
    ("radial_force", "radial_force_n"),
    ("torque", "torque_nm"),
)


class StraightCrank(Mechanism):
    name = "straight"
    title = "the straight crank"
    layout = "kinematics"
    forces_layout = "forces"
    takes: ClassVar[tuple[str, ...]] = ("ratio", "stroke", "rod", "speed", "method")
    loads: ClassVar[tuple[str, ...]] = (FORCE, MASSES, STEAM, CARD)
    motion = MOTION
    forces = FORCES
    examples: ClassVar[Mapping[str, str]] = {
        "table": "phi,x,c,p",
        "forces": "phi,x,c,p",
        "plot": "x,c,p",
        "plot forces": "x,c,p",
    }
    drawing = "kurbel.plot.drawings:mechanism_drawing"
    crosshead = True

    def drives(self, said: Described, ratios: Sequence[str]) -> tuple[Crank, ...]:
        return said.cranks(ratios)

    def crank(self, drive: Crank) -> Crank:
        return drive

    def question(self, drives: Sequence[Crank], method: str | None = None, **asked: Any) -> Request:
        from kurbel.motion.question import Request

        return Request(cranks=tuple(drives), method=method, **asked)

    def solved(self, drives: Sequence[Crank], method: str | None) -> tuple[SlideDrive, ...]:
        from kurbel.motion.drives import slide_drives

        return slide_drives(drives, method or "exact")

    def conditions(self) -> Mapping[str, Quantity]:
        from kurbel.motion.drives import slide_columns

        return slide_columns()


class OffsetCrank(StraightCrank):
    name = "offset"
    title = "the offset crank"
    takes = (*StraightCrank.takes, "offset")
    loads = (FORCE, MASSES)

    def lacking(self, said: Described) -> str:
        if said.offset is not None:
            return ""
        return "the offset crank needs the offset e; add --offset, for example --offset 0.5"


STRAIGHT, OFFSET = StraightCrank(), OffsetCrank()
