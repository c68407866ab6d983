"""The position of the exercise, rod square to crank: closed forms with the numbers beside them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.circle import Numeric
from kurbel.kernel.forces import square_position
from kurbel.motion.evaluation import OUT, TANGENT, value
from kurbel.motion.motion_page import CrankQuestion
from kurbel.motion.motion_quantities import registry
from kurbel.motion.notes import drive_notes, force_notes
from kurbel.page.axes import PHI, ColumnAxis, LetteredRatioAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity
from kurbel.page.subject import Subject

DEGREE_DECIMALS = 4
RIGHT_ANGLE = 90


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what the sheet can show: the outstroke's; on the return stroke forces mirror these."""
    angle = Formula(lambda slant: RIGHT_ANGLE - slant, "arctan(L/R)")
    phi = registry()["psi"]._replace(key="phi", name=PHI, symbol="$φ$", formulas={TANGENT: angle})
    own = (one for one in registry().values() if one.stroke == OUT)
    return {one.key: _headed(one) for one in (phi, *own)}


def _headed(quantity: Quantity) -> Quantity:
    """Return the entry under its name, letter and closed form: Führungsdruck N = F R/L."""
    letter, closed = quantity.symbol.strip("$"), quantity.formulas.get(TANGENT)
    form = f" = {closed.printed}" if closed else ""
    return quantity._replace(
        heading={lang: f"{name} ${letter}{form}$" for lang, name in quantity.name.items()},
        spanners=(),
        part=None,
        minutes=quantity.in_degrees,
        decimals=DEGREE_DECIMALS if quantity.in_degrees else quantity.decimals,
    )


class TangentRequest(CrankQuestion):
    """What is asked for: forces of these straight cranks where the rod touches the crank circle."""

    no_column = "there is no column beside the ratio; add one, such as rod_force"

    def check(self) -> None:
        super().check()
        if any(crank.offset for crank in self.cranks):
            raise ProblemError(
                "the rod touches the crank circle at tan ψ = R/L with the straight crank only;"
                " leave the offset out"
            )


def _notes(question: TangentRequest) -> Iterator[Label]:
    yield from drive_notes(question.cranks, question.lang)
    yield from force_notes(question.cranks, question.lang)


def _number(question: TangentRequest, column: Column, place: Place, times: int) -> Number:
    quantity, crank = column.quantity, question.cranks[place["ratio"]]

    def at(kind: Kind) -> Numeric:
        if not quantity.in_degrees:
            return value(quantity, "exact", crank, square_position(kind.of(crank.ratio)), kind)
        # tan ψ is rational, so that ψ is no rational number of degrees but 0 (and 45, for λ = 1; Niven).
        return ball(times * quantity.formulas[TANGENT].kernel(ball(crank.ratio).atan() * 180 / kind.pi))

    scaled = settled(at, column.places, question.rounding)
    return Number(scaled, column.places)


SUBJECT = Subject(
    key="tangent",
    layout="forces-tangent",
    command="forces --at tangent",
    axes={"ratio": LetteredRatioAxis, "column": ColumnAxis},
    axis_keys=("ratio",),
    own_first=False,
    quantities=quantities,
    listed=tuple,
    number=_number,
    notes=_notes,
)
