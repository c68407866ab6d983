"""The pages of the arc crank and of the parallel crank over the crank angle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kurbel.drive.crank import check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number
from kurbel.linkage import captions
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.evaluation import Linkage, certified
from kurbel.linkage.parallel import ParallelCrank
from kurbel.linkage.quantities import arc_registry, page_command, parallel_registry
from kurbel.motion.evaluation import NEEDS, needed
from kurbel.page.axes import AngleAxis, ColumnAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Quantity
from kurbel.page.subject import Question, Subject


@dataclass(frozen=True, kw_only=True)
class LinkageRequest(Question):
    """What is asked for: the arc cranks, alike but for their ratios, or none for the parallel crank, which
    may have a size and a force."""

    angles: Sequence[Fraction]
    cranks: tuple[ArcCrank, ...] = ()
    parallel: ParallelCrank | None = None

    def check(self) -> None:
        check_angles(self.angles)
        if "ratio" in self.axis_keys and not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")

    def too_long(self) -> str:
        return f"the table has {len(self)} rows"

    @property
    def ratios(self) -> list[Fraction]:
        return [crank.crank.ratio for crank in self.cranks]

    @property
    def drives(self) -> tuple[Linkage, ...]:
        return self.cranks or (self.parallel or ParallelCrank(),)

    def missing(self, quantity: Quantity) -> str:
        return needed(quantity, [drive.crank for drive in self.drives])


def _number(question: LinkageRequest, column: Column, place: Place, times: int) -> Number:
    drive, angle = question.drives[place.get("ratio", 0)], question.angles[place["angle"]]
    scaled = certified(column.quantity, drive, angle, column.places, question.rounding)
    return Number(scaled * times, column.places)


def _listed(mechanism: str, quantities: Mapping[str, Quantity]) -> Iterator[tuple[str, Quantity]]:
    return ((f"{page_command(one)} --mechanism {mechanism}", one) for one in quantities.values())


ARC = Subject(
    key="arc crank",
    layout="arc",
    command="table --mechanism arc",
    sample="table --mechanism arc --rocker 6",
    axes={"ratio": RatioAxis, "angle": AngleAxis, "column": ColumnAxis},
    axis_keys=("ratio", "phi"),
    quantities=arc_registry,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    listed=lambda: _listed("arc", arc_registry()),
    options=NEEDS,
)
PARALLEL = Subject(
    key="parallel crank",
    layout="parallel",
    command="table --mechanism parallel",
    axes={"angle": AngleAxis, "column": ColumnAxis},
    axis_keys=("phi",),
    quantities=parallel_registry,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    listed=lambda: _listed("parallel", parallel_registry()),
    options=NEEDS,
)
