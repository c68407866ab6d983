"""The page of a number other than the crank angle for which a condition holds at one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from typing import Any, Protocol

from kurbel.conditions.unknown import UNKNOWNS
from kurbel.exact.certify import NEVER_TIES, at_bits, ball, rounded
from kurbel.exact.numerals import Label, Number, figures
from kurbel.page.axes import Axis, ColumnAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field

NEAR_BITS = 120
WORDS = {
    "number": words("Lösung|Solution"),
    "all": words(
        "alle Werte über 0, bei denen die Bedingung gilt|all values above 0 with which the condition holds"
    ),
    "ratio": words(
        "alle Kurbelverhältnisse unter {greatest}, bei denen die Bedingung gilt"
        "|all crank ratios below {greatest} with which the condition holds"
    ),
}

# What stands for an unknown in a German sentence, where it is not "die".
_WHICH = {"pressure": "den", "stroke": "den", "ratio": "das"}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every unknown by its key; L/R stands beside R/L."""
    found = {}
    for key, one in UNKNOWNS.items():
        heading = f"{one.symbol} in {one.unit}" if one.unit else one.symbol
        formulas = {"exact": Formula(partial(_in_unit, one.size))}
        found[key] = Quantity(key, one.name, one.symbol, words(one.unit), None, formulas, words(heading))
        found[key] = found[key]._replace(spanners=(one.name,))
    rod = words("Stangenverhältnis|Rod ratio")
    formulas = {"exact": Formula(lambda found: 1 / found)}
    found["rod_ratio"] = Quantity(
        "rod_ratio", rod, "$L/R$", words(""), None, formulas, words("$L/R$"), spanners=(rod,)
    )
    return found


def _in_unit(size: Fraction, found: Any) -> Any:
    return found / ball(size)


class Unknown(Protocol):
    """A number and the condition by which it is found, at an angle: its values in SI units, at the precision
    in force, the labels of condition and angle, and what else there is to say."""

    place: Any

    @property
    def found(self) -> Sequence[Callable[[], Any]]: ...

    def label(self, lang: str) -> Label: ...

    def lines(self, lang: str) -> Sequence[Label]: ...


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class UnknownRequest(Question):
    """What is asked for: all values of an unknown, which `asked` finds."""

    unknown: str
    asked: Unknown

    no_column = "there is no column beside the number; add one, such as speed"
    undrawn = "of several angles, --angle 0..90:15, kurbel sweep solve with -o found.csv makes a file to draw"

    def missing(self, quantity: Quantity) -> str:
        own = (self.unknown, "rod_ratio") if self.unknown == "ratio" else (self.unknown,)
        if quantity.key in own:
            return ""
        return f"column {quantity.key} is not asked for; leave it out, or write --unknown {quantity.key}"

    def value(self, index: int, column: Column) -> Any:
        """Return a value in the unit of a column, at the precision in force."""
        return column.quantity.formulas["exact"].kernel(self.asked.found[index]())


class _RootAxis(Axis):
    """The values, numbered."""

    key = "solution"

    def __init__(self, question: UnknownRequest) -> None:
        super().__init__(len(question.asked.found))
        self.lang = question.lang

    def field(self) -> Field:
        return Field("solution", WORDS["number"][self.lang], "", "", 0)

    def value(self, place: Place) -> Number:
        return Number(place["root"] + 1, 0)

    def stub(self, place: Place) -> Number:
        return self.value(place)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (str(place["root"] + 1),)


def _number(question: UnknownRequest, column: Column, place: Place, times: int) -> Number:
    index, decimals = place["root"], column.decimals
    if decimals is None:
        with at_bits(NEAR_BITS):
            decimals = figures(float(question.value(index, column).mid()))
    scaled = rounded(lambda: times * question.value(index, column), decimals, question.rounding, NEVER_TIES)
    return Number(scaled, decimals)


def _caption(question: UnknownRequest) -> Label:
    name = UNKNOWNS[question.unknown].name[question.lang]
    text = question.layout.caption[question.lang]
    for place, said in (
        ("{unknown}", name),
        ("{which}", _WHICH.get(question.unknown, "die")),
        ("{condition}", question.asked.label(question.lang)),
        ("{angle}", question.asked.place.label(question.lang)),
    ):
        text = text.replace(place, said)
    return text


def _notes(question: UnknownRequest) -> Iterator[Label]:
    yield from (note[question.lang] for note in question.layout.notes)
    yield from question.asked.lines(question.lang)


SUBJECT = Subject(
    key="unknown",
    layout="solve-unknown",
    command="solve --unknown speed",
    axes={"root": _RootAxis, "column": ColumnAxis},
    axis_keys=("solution",),
    quantities=registry,
    number=_number,
    caption=_caption,
    notes=_notes,
    letters=True,
)
