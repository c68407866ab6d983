"""Conditions on the forces of an engine become a table of the crank angles at which they hold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, cast

from kurbel.conditions.loaded import ASKED, Loaded, measured
from kurbel.conditions.solve_page import WORDS as SOLVED
from kurbel.drive.at import CRANK_FORCES
from kurbel.engine.captions import about_engines
from kurbel.engine.engine_page import LoadAxis
from kurbel.engine.engine_quantities import engine_registry
from kurbel.engine.notes import from_dead_centre, notes
from kurbel.engine.request import EngineRequest
from kurbel.engine.segments import At
from kurbel.engine.turn import Turn, turn_ties
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, rounded
from kurbel.exact.numerals import Label, Number, degrees_text, exact_text, nearest
from kurbel.page.axes import PHI, Axis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, filled, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field, Note
from kurbel.reading.where import EXTREMES, VALUE, Condition

DEGREE_DECIMALS = 4
KEPT = 64
WORDS = {
    "extremes": words(
        "größte und kleinste Werte: der ganzen Umdrehung|greatest and least values: of the whole turn"
    ),
    "cylinder": words(
        "Kräfte und $φ$ des Zylinders {number}; Drehmoment und Überschuss aller"
        "|Forces and $φ$ of cylinder {number}; torque and excess of all"
    ),
    "angles": words(
        "$φ$ vom inneren Totpunkt der ersten Kurbel; im Totpunkt gelten auch die Werte davor"
        "|$φ$ from the inner dead centre of the first crank; at a dead centre values before it count, too"
    ),
    "angles_off": words(
        "$φ$ der ersten Kurbel von der Schubrichtung; im Totpunkt gelten auch die Werte davor"
        "|$φ$ of the first crank from the slide direction; at a dead centre values before it count, too"
    ),
}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LoadedRequest(EngineRequest):
    """What is asked for: where the forces of these engines fulfil the conditions."""

    conditions: tuple[Condition, ...] = ()

    axes_suffice = True

    def check(self) -> None:
        super().check()
        if not self.conditions:
            raise ProblemError(
                'no condition was given; write one as --where torque=max or --where "torque=0"'
            )
        if self.carded:
            raise ProblemError(
                "conditions under an indicator card are not solved: between its points nothing is proved;"
                " give ideal steam, such as --eps 4, or print the forces over the turn, kurbel forces --card"
            )
        for condition in self.conditions:
            column = _column_of(condition)
            if missing := self.missing(self.entry(column)):
                raise ProblemError(f'condition "{condition}" is in {condition.unit}: {missing}')

    def __len__(self) -> int:
        return sum(len(self.roots(place)) for place in self._places())

    def _places(self) -> Iterator[Place]:
        for expansion in range(len(self.steams)):
            for ratio in range(len(self.drives)):
                for condition in range(len(self.conditions)):
                    yield {"expansion": expansion, "ratio": ratio, "condition": condition}

    @cached_property
    def most(self) -> int:
        """The greatest number of places at which a condition holds."""
        return max(len(self.roots(place)) for place in self._places())

    @cached_property
    def loaded(self) -> Callable[[Any], Loaded]:
        return lru_cache(KEPT)(lambda turn: Loaded(cast("Turn", turn)))

    def at(self, place: Place) -> Loaded:
        """Return the forces of the engine at a place."""
        return self.loaded(self.turn(place["expansion"], place["ratio"], self.method))

    @property
    def method(self) -> str:
        return self.methods[0] if self.methods else "exact"

    def roots(self, place: Place) -> Sequence[At]:
        return self.at(place).places(self.conditions[place["condition"]])

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        """The columns asked for, else the layout's and those of the conditions."""
        own = super().page_columns
        if self.columns:
            return own
        shown = {column.key for column in own}
        asked = dict.fromkeys(
            _column_of(condition)
            for condition in self.conditions
            if ASKED[condition.quantity].measured not in shown
        )
        return (*own, *(self.printed(LayoutColumn(key, key)) for key in asked if key not in shown))

    def angle(self, place: Place, share: int, decimals: int) -> Number:
        """Return φ over the cycle in parts of a degree."""
        found = self.roots(place)[place["root"]].place
        if found.exact is not None:
            return nearest(share * 180 * found.exact, decimals, self.rounding)
        scaled = rounded(lambda: share * 180 * found.half_turns(), decimals, self.rounding, NEVER_TIES)
        return Number(scaled, decimals)


def _column_of(condition: Condition) -> str:
    """Return the column that shows what a condition is about, in its unit."""
    asked = ASKED[condition.quantity]
    return asked.measured if condition.unit else asked.column


class _RootAxis(Axis):
    """The crank angles at which a condition holds, on pages in degrees and minutes."""

    key = "phi"
    found = True

    def __init__(self, question: LoadedRequest) -> None:
        super().__init__(question.most)
        self.question = question

    @property
    def decimals(self) -> int:
        return DEGREE_DECIMALS if self.question.digits is None else self.question.digits

    def field(self) -> Field:
        return Field("phi", PHI[self.question.lang], "$φ$", "°", self.decimals, self.question.method)

    def value(self, place: Place) -> Number:
        return self.question.angle(place, 1, self.decimals)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"${degrees_text(Fraction(self.question.angle(place, 60, 0).scaled, 60))}$",)

    def stub_heading(self) -> Label:
        return "$φ$"


def _condition_axis(question: LoadedRequest) -> ListAxis:
    return ListAxis(
        question.conditions,
        Field("condition", SOLVED["condition"][question.lang]),
        str,
        lambda one: _condition_label(question, one),
    )


def _condition_label(question: LoadedRequest, condition: Condition) -> Label:
    """Return the condition in letters: T = 0.5 Q; M_d greatest."""
    shown = question.entry(_column_of(condition))
    symbol = shown.symbol.strip("$")
    if condition.kind in EXTREMES:
        return SOLVED[condition.kind][question.lang].format(symbol=symbol)
    unit = f'"{condition.unit}"' if condition.unit else shown.unit[question.lang].strip("$")
    value = exact_text(condition.value)
    return f"${symbol} = {value} {unit}$" if condition.value else f"${symbol} = 0$"


def _exists(question: LoadedRequest, place: Place) -> bool:
    return "root" not in place or place["root"] < len(question.roots(place))


def _number(question: LoadedRequest, column: Column, place: Place, times: int) -> Number:
    condition = question.conditions[place["condition"]]
    decimals, rounding = column.places, question.rounding
    if condition.kind == VALUE and column.key == _column_of(condition):
        value = measured(condition) if condition.unit else condition.value
        if question.units is not None:
            value *= question.units.times(question.entry(column.key).plain_unit("en"))
        return nearest(times * value, decimals, rounding)
    loaded, at = question.at(place), question.roots(place)[place["root"]]
    turn, key = loaded.turn, _bare(column.key)
    scale = column.quantity.scale or (lambda turn: 1)

    def found() -> Any:
        return times * at.value(loaded.quantity(key)) * scale(turn)

    ties: TieBits | None = NEVER_TIES
    if key in CRANK_FORCES and at.place.exact is not None:
        _, stroke, standing = at.segment.standing[0]
        angle = at.place.exact - at.segment.middle + standing
        ties = turn_ties(
            lambda on: times * on.cylinder.force(CRANK_FORCES[key], stroke, angle) * scale(on), [turn]
        )
    return Number(rounded(found, decimals, rounding, ties), decimals)


def _bare(column: str) -> str:
    """Return the column that shows the same in Q or Q r."""
    return "tangential" if column == "torque_nm" else column.removesuffix("_n")


def _caption(question: LoadedRequest) -> Label:
    one = len(question.conditions) == 1
    said = f", {_condition_label(question, question.conditions[0])}" if one else ""
    parts = {**about_engines(question, [question.method]), "{condition}": said}
    return filled(question.layout.caption[question.lang], parts.items())


def _notes(question: LoadedRequest) -> Iterator[Label | Note]:
    lang = question.lang
    regular = from_dead_centre(question, question.method)
    yield WORDS["angles" if regular else "angles_off"][lang]
    if question.assembly is not None:
        yield WORDS["cylinder"][lang].format(number=(*question.numbers, 1)[0])
    if any(condition.kind in EXTREMES for condition in question.conditions):
        yield WORDS["extremes"][lang]
    yield from notes(question)


SUBJECT = Subject(
    key="loaded roots",
    layout="solve-load",
    command="solve --eps 4",
    axes={
        "expansion": LoadAxis,
        "ratio": RatioAxis,
        "condition": _condition_axis,
        "root": _RootAxis,
        "column": ColumnAxis,
    },
    axis_keys=("epsilon", "ratio", "condition", "phi"),
    quantities=engine_registry,
    number=_number,
    caption=_caption,
    notes=_notes,
    of=("crank", "angle"),
    exists=_exists,
    letters=True,
    listed=tuple,
)
