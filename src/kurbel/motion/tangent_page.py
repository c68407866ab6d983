"""The position of the exercise, rod square to crank: closed forms with the numbers beside them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, Kind, TieBits, ball, balls, bounds, pi, rounded
from kurbel.exact.numerals import Label, Number
from kurbel.exact.separation import Separation
from kurbel.kernel.forces import square_position
from kurbel.motion.drive_notes import drive_notes, force_notes
from kurbel.motion.evaluation import (
    OUT,
    TANGENT,
    is_transcendental,
    needed,
    value,
)
from kurbel.motion.quantities import registry
from kurbel.page.axes import PHI, ColumnAxis, LetteredRatioAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity
from kurbel.page.subject import Question, Subject

DEGREE_DECIMALS = 4
RIGHT_ANGLE = 90


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what the sheet can show: the outstroke's; on the return stroke forces mirror these."""
    phi = registry()["psi"]._replace(
        key="phi", name=PHI, symbol="$φ$", formulas={TANGENT: Formula(_crank_angle, "arctan(L/R)")}
    )
    own = (one for one in registry().values() if one.stroke == OUT)
    return {one.key: _headed(one) for one in (phi, *own)}


def _crank_angle(slant: Any) -> Any:
    return RIGHT_ANGLE - slant


def _headed(quantity: Quantity) -> Quantity:
    """Return the entry under its name, letter and closed form: Führungsdruck N = F R/L."""
    letter, closed = quantity.symbol.strip("$"), quantity.formulas.get(TANGENT)
    form = f" = {closed.printed}" if closed else ""
    return quantity._replace(
        heading={lang: f"{name} ${letter}{form}$" for lang, name in quantity.name.items()},
        spanners=(),
        part=None,
        minutes=quantity.is_arc,
        decimals=DEGREE_DECIMALS if quantity.is_arc else quantity.decimals,
    )


@dataclass(frozen=True, kw_only=True)
class TangentRequest(Question):
    """What is asked for: forces of these straight cranks where the rod touches the crank circle."""

    cranks: tuple[Crank, ...]

    no_column = "there is no column beside the ratio; add one, such as rod_force"

    def check(self) -> None:
        if not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if any(crank.offset for crank in self.cranks):
            raise ProblemError(
                "the rod touches the crank circle at tan ψ = R/L with the straight crank only;"
                " leave the offset out"
            )

    @property
    def ratios(self) -> list[Fraction]:
        return [crank.ratio for crank in self.cranks]

    def missing(self, quantity: Quantity) -> str:
        return needed(quantity, self.cranks)


def _notes(question: TangentRequest) -> Iterator[Label]:
    yield from (note[question.lang] for note in question.layout.notes)
    yield from drive_notes(question.cranks, question.lang)
    yield from force_notes(question.cranks, question.lang)


def _number(question: TangentRequest, column: Column, place: Place, times: int) -> Number:
    quantity, crank = column.quantity, question.cranks[place["ratio"]]

    def as_ball() -> Any:
        if not quantity.is_arc:
            return _value(quantity, crank, balls())
        # tan ψ is rational, so that ψ is no rational number of degrees but 0 (and 45, for λ = 1; Niven).
        return times * quantity.formulas[TANGENT].kernel(ball(crank.ratio).atan() * 180 / pi())

    def tie_bits(boundary: Fraction) -> float:
        bound = _value(quantity, crank, bounds())
        return float((bound - Separation.rational(boundary)).bits())

    ties: TieBits | None = NEVER_TIES if is_transcendental(quantity, crank) else tie_bits
    return Number(rounded(as_ball, column.places, question.rounding, ties), column.places)


def _value(quantity: Quantity, crank: Crank, numbers: Kind) -> Any:
    return value(quantity, "exact", crank, square_position(numbers.of(crank.ratio)), numbers)


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
    caption=lambda question: question.layout.caption[question.lang],
    notes=_notes,
)
