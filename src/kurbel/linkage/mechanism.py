"""What crank drives without a crosshead have in common for commands and conditions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, ClassVar

from kurbel.drive.load import FORCE
from kurbel.exact.numerals import Label
from kurbel.linkage.linkage import Linkage
from kurbel.linkage.question import LinkageRequest
from kurbel.motion.captions import size_notes, turns_label
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import OUT
from kurbel.motion.mechanism import FORCES, Mechanism
from kurbel.page.layouts import layout
from kurbel.page.quantity import Quantity
from kurbel.page.subject import subject


class LinkageDrive(Drive):
    """A drive with dead centres at 0° and 180°, and the layout whose page speaks of it.

    It has a rod if its pages are of ratios.
    """

    def __init__(self, drive: Linkage, page: str) -> None:
        super().__init__(drive, self.columns_of(page))
        self.page = page
        self.has_rod = "ratio" in subject(layout(page).subject).axes

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.drive, self.page)

    @staticmethod
    def columns_of(page: str) -> Mapping[str, Quantity]:
        """Return the outstroke's quantities of such pages, which stand for either stroke."""
        known = subject(layout(page).subject).quantities()
        return {key: one for key, one in known.items() if one.stroke == OUT}

    @property
    def stroke(self) -> Label:
        own: Label = self.drive.stroke
        return own

    def closing_lines(self, question: Any) -> Iterator[Label]:
        """Yield what pages of the drive say of it, on both strokes."""
        page = layout(self.page)
        drives = tuple(one.drive for one in question.drives)
        known = subject(page.subject).quantities()
        keys = [column.key for column in question.page_columns if column.key in known]
        both = (each for key in keys or ["path"] for each in (key, f"{key}_return") if each in known)
        request = LinkageRequest(
            layout=page, angles=(Fraction(0),), drives=drives, columns=tuple(both), lang=question.lang
        )
        for said in request.subject.notes(request):
            assert isinstance(said, str)
            yield said


class LinkageMechanism(Mechanism):
    """A crank drive whose pages are of its own subject, under no load or a constant force."""

    loads: ClassVar[tuple[str, ...]] = (FORCE,)
    forces = FORCES
    drawing = "kurbel.plot.drawings:links_drawing"
    moving = "kurbel.plot.moving:links_scene"
    examples: ClassVar[Mapping[str, str]] = {
        "table": "phi,path,rocker",
        "forces": "phi,tangential_force",
        "plot": "path,velocity",
        "plot forces": "rod_force,guide_force",
    }

    def question(self, drives: Sequence[Linkage], method: str | None = None, **asked: Any) -> LinkageRequest:
        return LinkageRequest(drives=tuple(drives), **asked)

    def rod_notes(self, drives: Sequence[Linkage], lang: str) -> Iterable[Label]:
        yield from size_notes(one.crank for one in drives)
        if (speed := drives[0].crank.speed) is not None:
            yield turns_label(speed)

    def solved(self, drives: Sequence[Linkage], method: str | None) -> tuple[Drive, ...]:
        return tuple(LinkageDrive(one, self.layout) for one in drives)

    def conditions(self) -> Mapping[str, Quantity]:
        return LinkageDrive.columns_of(self.layout)
