"""Rotating masses and a layout become a table of what they leave and of what balances them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple

from kurbel.balancing.rotor import Line, PlacedMass, Places, Rotor, lines, solved
from kurbel.balancing.vector import Vector, omega
from kurbel.drive.at import known
from kurbel.exact.numerals import Label, Number, given
from kurbel.exact.real import Real
from kurbel.motion.notes import turns_label
from kurbel.page.axes import ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, entry
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.notation import ratio_text
from kurbel.reading.units import Speed

ANGLE_DECIMALS = 2
# What planes and a speed tell.
_PLANES = Need(lambda question: not question.planar, ("--planes",))
_SPEED = Need(lambda question: question.speed is not None, ("--speed",))
_COUPLES = ("couple", "second_couple", "left_couple")
WORDS = Texts("balancing", "rotor")


class At(NamedTuple):
    """A line of the page, and the speed of the shaft."""

    line: Line
    speed: Speed | None


def _field(name: str, times: int = 1, power: int = 0) -> Callable[[At], Real | None]:
    """Return what a line has, times a power of ω."""

    def kernel(at: At) -> Real | None:
        found: Real | None = getattr(at.line, name)
        for _ in range(power if found else 0):
            found = known(found) * omega(known(at.speed))
        return found and found * times

    return kernel


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the columns by their keys."""
    rows = (
        ("mass_kg", "Masse|Mass", "$m$", "kg", _field("mass"), ()),
        ("radius_mm", "Halbmesser des Schwerpunkts|Radius of the centre of mass", "$r$", "mm",
         _field("radius", 1000), ()),
        ("angle", "Winkel|Angle", "$α$", "°", lambda at: at.line.angle, ()),
        ("plane_mm", "Lage der Ebene|Position of the plane", "$z$", "mm", _field("plane", 1000), (_PLANES,)),
        ("unbalance_kgm", "Unwucht|Unbalance", "$m r$", "kg m", _field("unbalance"), ()),
        ("moment_kgm2", "Moment der Unwucht|Moment of the unbalance", "$m r l$", "kg m²", _field("moment"),
         (_PLANES,)),
        ("unbalance_n", "Fliehkraft|Centrifugal force", "$m r ω^2$", "N", _field("unbalance", power=2),
         (_SPEED,)),
        ("moment_nm", "Moment der Fliehkraft|Moment of the centrifugal force", "$m r l ω^2$", "N m",
         _field("moment", power=2), (_PLANES, _SPEED)),
    )  # fmt: skip
    return {
        key: entry(
            key, name, symbol, unit, ANGLE_DECIMALS if unit == "°" else None, {"exact": Formula(kernel)},
            needs=needs,
        )
        for key, name, symbol, unit, kernel, needs in rows
    }  # fmt: skip


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RotorRequest(Question):
    """What is asked for: the lines of the masses of a shaft; `planar` where their planes are not known."""

    rotor: Rotor
    places: Places
    speed: Speed | None = None
    planar: bool = False

    no_column = "there is no column beside the axes; add one, such as unbalance_kgm"

    def check(self) -> None:
        _ = self.lines

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        what = "left"
        if self.places.balance:
            what = "balanced"
        elif any(None in one for one in self.rotor.masses):
            what = "complete" if _is_complete(self) else "static"
        return {**super().caption_parts, "{what}": WORDS[f"what_{what}"][self.lang]}

    @cached_property
    def solutions(self) -> tuple[tuple[PlacedMass, ...], ...]:
        return solved(self.rotor.masses)

    @cached_property
    def lines(self) -> tuple[tuple[Line, ...], ...]:
        """The lines of every solution."""
        hidden = _COUPLES if self.planar else ()
        every = (lines(self.rotor, solution, self.places) for solution in self.solutions)
        return tuple(tuple(one for one in found if one.key not in hidden) for found in every)


def number_of(question: Question, column: Column, at: Any) -> Number | None:
    """Return a value, a direction, or an angle as it was given where it has no more decimals than others."""
    own = question.subject.quantities()[column.quantity.key]
    found, rounding = own.formulas["exact"].kernel(at), question.rounding
    if isinstance(found, Fraction):
        exact = given(found, None, rounding)
        return exact if exact.decimals <= column.places else given(found, column.decimals, rounding)
    if isinstance(found, Vector):
        return found.number(column.places, rounding)
    if found is None:
        return None
    value: Real = found * question.of_page(own.unit["en"])
    return value.number(column.decimals, rounding)


def _number(question: RotorRequest, column: Column, place: Place, times: int) -> Number | None:
    return number_of(question, column, At(question.lines[place["solution"]][place["line"]], question.speed))


def _solution_axis(question: RotorRequest) -> ListAxis:
    """The ways in which the masses can stand."""
    name = WORDS["solution"][question.lang]
    return ListAxis(
        range(1, len(question.solutions) + 1),
        Field("solution", name, "", "", 0),
        lambda number: Number(number, 0),
        lambda number: f"{name} {number}",
    )


def _line_axis(question: RotorRequest) -> ListAxis:
    """Masses, balancing masses, bearings and sums, of which every solution has the same."""
    return ListAxis(
        question.lines[0],
        Field("line", WORDS["line"][question.lang]),
        lambda line: f"{line.key}_{line.number}" if line.number else line.key,
        lambda line: WORDS[line.key][question.lang].format(number=line.number),
    )


def _is_complete(question: RotorRequest) -> bool:
    """Whether neither a force nor a couple is left."""
    couples = [line.moment for line in question.lines[0] if line.key == "couple"]
    return bool(couples) and known(couples[-1]).rational == 0


def _notes(question: RotorRequest) -> Iterator[Label]:
    lang, about = question.lang, question.rotor.about
    planes = ""
    if not question.planar:
        planes = WORDS["planes"][lang].format(about=f"$z = {amount(about, 'mm')}$")
    yield WORDS["angles"][lang] + planes
    if question.rotor.ratio is not None:
        yield WORDS["second"][lang].format(ratio=ratio_text(question.rotor.ratio))
    if question.speed is not None:
        yield WORDS["speed"][lang].format(speed=turns_label(question.speed))
    yield WORDS["zero"][lang]


SUBJECT = Subject(
    key="rotor",
    layout="rotor",
    command="rotor",
    axes={"solution": _solution_axis, "line": _line_axis, "column": ColumnAxis},
    axis_keys=("solution", "line"),
    own_first=False,
    quantities=quantities,
    number=_number,
    notes=_notes,
)
