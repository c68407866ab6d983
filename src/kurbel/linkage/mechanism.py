"""What crank drives without a crosshead have in common for commands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from kurbel.drive.load import FORCE
from kurbel.linkage.drive import LinkageDrive
from kurbel.linkage.linkage import Linkage
from kurbel.linkage.question import LinkageRequest
from kurbel.motion.evaluation import OUT
from kurbel.motion.mechanism import FORCES, Mechanism
from kurbel.page.quantity import Quantity
from kurbel.page.subject import subject

if TYPE_CHECKING:
    from kurbel.motion.drives import Drive


class LinkageMechanism(Mechanism):
    """A crank drive whose pages are of its own subject, under no load or a constant force."""

    loads = (FORCE,)
    forces = FORCES
    drawing = "kurbel.plot.drawings:links_drawing"
    examples: ClassVar[Mapping[str, str]] = {
        "table": "phi,path,rocker",
        "forces": "phi,tangential_force",
        "plot": "path,velocity",
        "plot forces": "rod_force,guide_force",
    }

    def question(self, drives: Sequence[Linkage], method: str | None = None, **asked: Any) -> LinkageRequest:
        return LinkageRequest(drives=tuple(drives), **asked)

    def solved(self, drives: Sequence[Linkage], method: str | None) -> tuple[Drive, ...]:
        return tuple(LinkageDrive(one, self.conditions(), self.layout) for one in drives)

    def conditions(self) -> Mapping[str, Quantity]:
        return {key: one for key, one in subject(self.subject).quantities().items() if one.stroke == OUT}
