"""Conditions on crank drives and a layout become a table of the crank angles at which they hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property

from kurbel.conditions import captions
from kurbel.conditions.solve import MEASURES, Root, column_of, solve
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, degrees_text
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import NEEDS, OUT, RETURN, STROKES, typed, unknown
from kurbel.motion.mechanism import mechanism
from kurbel.motion.page import DriveQuestion
from kurbel.motion.quantities import registry
from kurbel.page.axes import PHI, Axis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Quantity, words
from kurbel.page.subject import Subject, subject
from kurbel.page.table import Field
from kurbel.reading.where import Condition

# What stands for a stroke in records.
STROKE_KEYS = {OUT: "outstroke", RETURN: "return"}
DEGREE_DECIMALS = 4
TURN = Quantity(
    key="phi_turn",
    name=words("Kurbelwinkel in der Umdrehung|Crank angle over the turn"),
    symbol="$φ$",
    unit=words("°"),
    decimals=DEGREE_DECIMALS,
    formulas={},
    heading=words(""),
    minutes=True,
)


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what pages can show of all drives; everything counts from the dead centre of its stroke."""
    found = {key: one for name in MECHANISMS for key, one in mechanism(name).conditions().items()}
    return {TURN.key: TURN, **{key: one for key, one in found.items() if key not in _own()}, **_own()}


@cache
def _own() -> Mapping[str, Quantity]:
    """Return what pages of the mechanisms themselves do not show."""
    return {
        key: one
        for name in MECHANISMS
        for key, one in mechanism(name).conditions().items()
        if key not in subject(mechanism(name).subject).quantities()
    }


def own_columns() -> Iterator[tuple[str, Quantity]]:
    """Yield what no other page has, with the command that prints it."""
    nothing, own = words(""), _own()
    named = {key: captions.WORDS[key] for key in ("condition", "stroke")}
    for key, name in (named | {key: captions.WORDS.get(key, one.name) for key, one in own.items()}).items():
        yield "solve", Quantity(key, name, "", nothing, None, {}, nothing)
        if key == "stroke":
            yield "solve", TURN


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SolveRequest(DriveQuestion):
    """What is asked for: where these drives, alike but for their ratios, fulfil the conditions."""

    drives: tuple[Drive, ...]
    conditions: tuple[Condition, ...]

    no_column = "there is no column beside the angle; add one, such as phi_turn or x"
    axes_suffice = True

    def check(self) -> None:
        super().check()
        if not self.conditions:
            raise ProblemError('no condition was given; write one as --where p=0 or --where "s = 25%"')
        for condition in self.conditions:
            self._check(condition)

    def __len__(self) -> int:
        return sum(map(len, self.found.values()))

    @property
    def method(self) -> str:
        return self.drives[0].method

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        """The columns asked for, else the layout's and those of the conditions."""
        own = super().page_columns
        if self.columns:
            return own
        shown = {column.key for column in own}
        # Of what has a column in units the share of it has none on pages.
        sized = {key for key, one in MEASURES.items() if one.column in shown and not self.data}
        asked = dict.fromkeys(
            column_of(self.drives[0], one) for one in self.conditions if one.quantity not in sized
        )
        return (*own, *(self.printed(LayoutColumn(key, key)) for key in asked if key not in shown))

    @cached_property
    def found(self) -> Mapping[tuple[int, int, int], Sequence[Root]]:
        """Return what was found by the places of ratio and condition, and the stroke."""
        found: dict[tuple[int, int, int], list[Root]] = {}
        for ratio, drive in enumerate(self.drives):
            for condition, asked in enumerate(self.conditions):
                for root in solve(drive, asked):
                    found.setdefault((ratio, condition, root.stroke), []).append(root)
        return found

    def roots(self, place: Place) -> Sequence[Root]:
        return self.found.get((place["ratio"], place["condition"], tuple(STROKES)[place["stroke"]]), ())

    def knows(self, key: str) -> bool:
        # As of any page, but without asking every mechanism for its quantities.
        return key == TURN.key or key in self.drives[0].columns

    def entry(self, key: str) -> Quantity:
        known = TURN if key == TURN.key else self.drives[0].columns.get(key) or super().entry(key)
        return known._replace(part=None, spanners=())

    def missing(self, quantity: Quantity) -> str:
        if self.knows(quantity.key):
            return ""
        if not quantity.needs:
            return f"column {quantity.key} belongs to another mechanism or method; leave it out"
        return unknown(quantity)

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method,)

    def field(self, column: Column) -> Field:
        own = super().field(column)
        return own._replace(symbol=f"${self.layout.angle_symbol}$") if column.key == TURN.key else own

    @property
    def degree_decimals(self) -> int:
        return DEGREE_DECIMALS if self.digits is None else self.digits

    def _check(self, condition: Condition) -> None:
        quantity, known = condition.quantity, self.drives[0].columns
        if condition.unit and MEASURES[quantity].column not in known:
            options = " and ".join(NEEDS[registry()[MEASURES[quantity].column].needs])
            raise ProblemError(f'condition "{condition}" is in {condition.unit} and needs {options}')
        if self.drives[0].column_of(quantity) not in known:
            raise ProblemError(f'method "{typed(self.method)}" has no formula for {quantity}; use exact')


def _condition_axis(question: SolveRequest) -> ListAxis:
    """The conditions in letters."""
    return ListAxis(
        question.conditions,
        Field("condition", captions.WORDS["condition"][question.lang]),
        str,
        lambda one: captions.condition_label(one, question.drives[0], question.lang),
    )


def _stroke_axis(question: SolveRequest) -> ListAxis:
    """Outstroke and return stroke."""
    field = Field("stroke", captions.WORDS["stroke"][question.lang])
    return ListAxis(
        tuple(STROKES), field, STROKE_KEYS.__getitem__, lambda one: STROKES[one][question.lang], ""
    )


class _RootAxis(Axis):
    """The crank angles on a stroke, on pages in degrees and minutes."""

    key = "phi"
    found = True

    def __init__(self, question: SolveRequest) -> None:
        super().__init__(max(map(len, question.found.values())))
        self.question = question

    def field(self) -> Field:
        lang, symbol = self.question.lang, self.stub_heading()
        return Field("phi", PHI[lang], symbol, "°", self.question.degree_decimals, self.question.method)

    def value(self, place: Place) -> Number:
        return self._angle(place, 1, self.question.degree_decimals)

    def stub_heading(self) -> Label:
        return f"${self.question.layout.angle_symbol}$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"${degrees_text(Fraction(self._angle(place, 60, 0).scaled, 60))}$",)

    def _angle(self, place: Place, share: int, decimals: int) -> Number:
        return self.question.roots(place)[place["root"]].angle(False, share, decimals, self.question.rounding)


def _exists(question: SolveRequest, place: Place) -> bool:
    """Whether there are so many roots: not every stroke has as many."""
    return "root" not in place or place["root"] < len(question.roots(place))


def _number(question: SolveRequest, column: Column, place: Place, times: int) -> Number:
    root = question.roots(place)[place["root"]]
    if column.key == TURN.key:
        return root.angle(True, times, column.places, question.rounding)
    units, own = question.units, question.entry(column.key).plain_unit("en")
    parts = Fraction(1) if units is None else units.times(own)
    return root.number(column.key, column.places, question.rounding, parts)


SUBJECT = Subject(
    key="roots",
    layout="solve",
    command="solve",
    axes={
        "ratio": RatioAxis,
        "condition": _condition_axis,
        "stroke": _stroke_axis,
        "root": _RootAxis,
        "column": ColumnAxis,
    },
    axis_keys=("ratio", "condition", "stroke", "phi"),
    own_first=False,
    quantities=quantities,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    exists=_exists,
    listed=own_columns,
)
