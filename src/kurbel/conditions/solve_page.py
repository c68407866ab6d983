"""Conditions on crank drives and a layout become a table of the crank angles at which they hold."""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from itertools import groupby
from typing import Any

from kurbel.conditions.solve import MEASURES, Root, column_of, solve, target_of
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ProblemError
from kurbel.exact.course import ClosedForm, Target, closed_forms, form_text, is_at
from kurbel.exact.numerals import Label, Number, degrees_text, exact_text, finite_decimals
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import OUT, RETURN, STROKES, method_named, typed, unknown
from kurbel.motion.mechanism import mechanism
from kurbel.motion.motion_page import DriveQuestion
from kurbel.motion.motion_quantities import registry
from kurbel.page.axes import PHI, Axis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import AND, Column, Quantity, Words, bare, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.given import SHARE
from kurbel.reading.notation import ratio_text
from kurbel.reading.where import ANGLES, DEAD_CENTRE, EXTREMES, LEANING, MAX, MIN, MOST, Condition

# Of m/s².
_SQUARE = r'(?:²|\^2|\*\*2)"$'
WORDS: Mapping[str, Words] = {
    "for": words(" für | for "),
    MAX: words("${symbol}$ am größten|${symbol}$ greatest"),
    MIN: words("${symbol}$ am kleinsten|${symbol}$ least"),
    MOST: words("${symbol}$ dem Betrag nach am größten|${symbol}$ greatest in magnitude"),
    DEAD_CENTRE: words(
        "${symbol} = {value}$ des Wertes im Totpunkt|${symbol} = {value}$ of the value at the dead centre"
    ),
    "straight": words(
        "$φ$ vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt; {stroke}"
        "|$φ$ from the dead centre of the stroke, over the turn from the inner one; {stroke}"
    ),
    "oblique": words("$φ$ von der Schubrichtung an; {stroke}|$φ$ from the slide direction; {stroke}"),
    "length": words("$S$ Hub|$S$ stroke"),
    "extremes": words(
        "größte und kleinste Werte: eines jeden Hubes|greatest and least values: of each stroke"
    ),
    "form": words("$cos φ = {form}$, also {values}|$cos φ = {form}$, hence {values}"),
    "unusable": words("{values} unbrauchbar, jenseits $±1$|{values} unusable, beyond $±1$"),
    "condition": words("Bedingung|Condition"),
    "stroke": words("Hub|Stroke"),
}


def caption(request: SolveRequest) -> Label:
    """Return the layout's caption with the ratio and the condition, if there is only one, and the method."""
    lang, drives, conditions = request.lang, request.drives, request.conditions
    common = []
    if len(drives) == 1 and request.method != "infinite" and drives[0].has_rod:
        common.append(f"${request.layout.ratio_symbol} = {ratio_text(drives[0].ratio)}$")
    if len(conditions) == 1:
        common.append(condition_label(conditions[0], drives[0], lang))
    text = request.layout.caption[lang]
    text = text.replace("{common}", WORDS["for"][lang] + ", ".join(common) if common else "")
    return text.replace("{method}", method_named(request.method).caption[lang])


def condition_label(condition: Condition, drive: Drive, lang: str) -> Label:
    """Return the condition in letters: x/R = 1.1; p = 1/6 of the value at the dead centre."""
    shown = drive.columns[drive.column_of(condition.quantity)]
    symbol = shown.symbol.strip("$")
    if condition.kind in WORDS:
        leans = condition.kind == MAX and condition.quantity in LEANING
        said = WORDS[MOST if leans else condition.kind][lang]
        return said.format(symbol=symbol, value=exact_text(condition.value))
    if condition.quantity == SHARE:
        whole = finite_decimals(condition.value) is not None
        value = f"{exact_text(100 * condition.value)} %" if whole else exact_text(condition.value)
        return f"$x/S = {value}$"
    if condition.quantity in ANGLES:
        plain = finite_decimals(condition.value) is not None
        return f"${symbol} = {exact_text(condition.value) + '°' if plain else degrees_text(condition.value)}$"
    if condition.unit:
        unit = re.sub(_SQUARE, '"^2', f'"{condition.unit}"')
        return f"${symbol} = {exact_text(condition.value)} {unit}$"
    if condition.quantity in drive.pushed:
        return f"${symbol} = {amount(condition.value, shown.unit[lang], exact_text)}$"
    if condition.value:
        symbol = shown.heading[lang].strip("$")
    return f"${symbol} = {exact_text(condition.value)}$"


def notes(request: SolveRequest) -> Iterator[Label]:
    """Yield the lines below the table: angles, formulas, closed forms, lengths."""
    lang = request.lang
    yield counted(WORDS, request.drives, lang)
    if any(condition.kind in EXTREMES for condition in request.conditions):
        yield WORDS["extremes"][lang]
    yield from request.drives[0].formula_lines(request, list(_digits(request)))
    yield from _forms(request)
    yield from request.drives[0].closing_lines(request)


def counted(texts: Mapping[str, Words], drives: Sequence[Drive], lang: str) -> Label:
    """Return the line about where paths and angles count from, and how long the stroke is."""
    straight = all(one.is_straight for one in drives)
    strokes = {one.stroke if straight else "" for one in drives}
    said = f"$S = {strokes.pop()}$" if len(strokes) == 1 and all(strokes) else WORDS["length"][lang]
    return texts["straight" if straight else "oblique"][lang].format(stroke=said)


def _digits(request: SolveRequest) -> Iterator[Column]:
    """Yield what is shown and asked for, on both strokes."""
    drive = request.drives[0]
    asked = [drive.column_of(condition.quantity) for condition in request.conditions]
    for key in dict.fromkeys((*(column.key for column in request.page_columns), *asked)):
        if key in registry():
            for quantity in (registry()[key], registry()[key]._replace(stroke=RETURN)):
                yield bare(quantity, request.method, quantity.decimals)


def _forms(request: SolveRequest) -> Iterator[Label]:
    """Yield the closed forms of each ratio, condition and stroke that has some."""
    for (ratio, condition, stroke), roots in request.found.items():
        said = "; ".join(_said(roots, request.lang))
        if said:
            drive, asked = request.drives[ratio], request.conditions[condition]
            heads = [STROKES[stroke][request.lang]]
            if len(request.conditions) > 1:
                heads.insert(0, condition_label(asked, drive, request.lang))
            if len(request.drives) > 1:
                heads.insert(0, f"${request.layout.ratio_symbol} = {ratio_text(drive.ratio)}$")
            yield f"{', '.join(heads)}: {said}"


def _said(roots: Sequence[Root], lang: str) -> Iterator[Label]:
    drive, condition, stroke = roots[0].drive, roots[0].condition, roots[0].stroke
    if not drive.is_straight:
        return
    course = drive.course(condition.quantity, stroke)
    extreme = condition.kind in EXTREMES
    formula = course.formula_slope if extreme else course.formula
    if formula is None:
        return
    target = Target.rational(Fraction(0)) if extreme else target_of(drive, condition, stroke)
    forms = closed_forms(formula, target)
    usable = [form for form in forms if any(is_at(form, root.place) for root in roots)]
    forms = [form for form in forms if form in usable or (formula.is_rational and not form.is_usable)]
    if extreme:
        forms = [form for form in forms if form in usable or form.twin in usable]
    # Of a dead centre alone a closed form says nothing.
    if any(form.outside or abs(form.plain) != form.below for form in forms):
        yield from _lines(forms, usable, lang)


def _lines(forms: Sequence[ClosedForm], usable: Sequence[ClosedForm], lang: str) -> Iterator[Label]:
    """Yield cos φ as it is solved, then the values that no angle has."""
    for text, of_text in groupby(usable, key=lambda form: _text(form, forms)):
        values = AND[lang].join(f"${form_text(form)}$" for form in of_text)
        rational = text == values.strip("$")
        yield f"$cos φ = {text}$" if rational else WORDS["form"][lang].format(form=text, values=values)
    if others := [f"${form_text(form)}$" for form in forms if not form.is_usable]:
        yield WORDS["unusable"][lang].format(values=AND[lang].join(others))


def _text(form: ClosedForm, forms: Sequence[ClosedForm]) -> str:
    """(-5 ± sqrt(33))/4, with one sign where the twin is not among the forms."""
    if not form.outside:
        return form_text(form)
    sign = "±" if form.twin in forms else "+" if form.outside > 0 else "-"
    times = f"{abs(form.outside)} " if abs(form.outside) > 1 else ""
    plain = f"{form.plain} {sign} " if form.plain else sign if sign != "+" else ""
    above = f"{plain}{times}sqrt({form.radicand})"
    return above if form.below == 1 else f"({above})/{form.below}"


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
    return {TURN.key: TURN, **found}


def own_columns() -> Iterator[tuple[str, Quantity]]:
    """Yield what no other page has, with the command that prints it."""
    nothing = words("")
    for key in ("condition", "stroke"):
        yield "solve", Quantity(key, WORDS[key], "", nothing, None, {}, nothing)
    yield "solve", TURN


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RootsQuestion(Question):
    """What is asked for: the places at which something fulfils each of the conditions."""

    conditions: tuple[Condition, ...]

    axes_suffice = True

    @property
    @abstractmethod
    def method(self) -> str: ...

    @abstractmethod
    def each(self) -> Iterable[Sequence[Any]]:
        """Return what was found of each condition, wherever something was."""

    @abstractmethod
    def roots(self, place: Place) -> Sequence[Any]: ...

    @abstractmethod
    def angle(self, place: Place, share: int, decimals: int) -> Number:
        """Return φ at a place in parts of a degree."""

    @abstractmethod
    def in_letters(self, condition: Condition) -> Label:
        """Return a condition in letters."""

    @abstractmethod
    def column_of(self, condition: Condition) -> str:
        """Return the column that shows what a condition is about."""

    @abstractmethod
    def measured(self, condition: Condition) -> str:
        """Return the column that shows it in a unit, nothing if none does."""

    def __len__(self) -> int:
        return sum(map(len, self.each()))

    @cached_property
    def most(self) -> int:
        """The greatest number of places at which a condition holds."""
        return max(map(len, self.each()))

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        """The columns asked for, else the layout's and those of the conditions."""
        own = super().page_columns
        if self.columns:
            return own
        shown = {column.key for column in own}
        # Of what has a column in units the share of it has none on pages.
        asked = dict.fromkeys(
            map(self.column_of, (c for c in self.conditions if self.measured(c) not in shown))
        )
        return (*own, *(self.printed(LayoutColumn(key, key)) for key in asked if key not in shown))

    @property
    def degree_decimals(self) -> int:
        return DEGREE_DECIMALS if self.digits is None else self.digits


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SolveRequest(RootsQuestion, DriveQuestion):
    """What is asked for: where these drives, alike but for their ratios, fulfil the conditions."""

    drives: tuple[Drive, ...]

    no_column = "there is no column beside the angle; add one, such as phi_turn or x"

    def check(self) -> None:
        super().check()
        if not self.conditions:
            raise ProblemError('no condition was given; write one as --where p=0 or --where "s = 25%"')
        for condition in self.conditions:
            self._check(condition)

    @property
    def method(self) -> str:
        return self.drives[0].method

    def column_of(self, condition: Condition) -> str:
        return column_of(self.drives[0], condition)

    def measured(self, condition: Condition) -> str:
        return "" if self.data or condition.quantity not in MEASURES else MEASURES[condition.quantity].column

    def in_letters(self, condition: Condition) -> Label:
        return condition_label(condition, self.drives[0], self.lang)

    @cached_property
    def found(self) -> Mapping[tuple[int, int, int], Sequence[Root]]:
        """Return what was found by the places of ratio and condition, and the stroke."""
        found: dict[tuple[int, int, int], list[Root]] = {}
        for ratio, drive in enumerate(self.drives):
            for condition, asked in enumerate(self.conditions):
                for root in solve(drive, asked):
                    found.setdefault((ratio, condition, root.stroke), []).append(root)
        return found

    def each(self) -> Iterable[Sequence[Root]]:
        return self.found.values()

    def roots(self, place: Place) -> Sequence[Root]:
        return self.found.get((place["ratio"], place["condition"], tuple(STROKES)[place["stroke"]]), ())

    def angle(self, place: Place, share: int, decimals: int) -> Number:
        return self.roots(place)[place["root"]].angle(False, share, decimals, self.rounding)

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

    def _check(self, condition: Condition) -> None:
        quantity, known = condition.quantity, self.drives[0].columns
        if condition.unit and MEASURES[quantity].column not in known:
            options = " and ".join(registry()[MEASURES[quantity].column].options)
            raise ProblemError(f'condition "{condition}" is in {condition.unit} and needs {options}')
        if self.drives[0].column_of(quantity) not in known:
            raise ProblemError(f'method "{typed(self.method)}" has no formula for {quantity}; use exact')


def condition_axis(question: RootsQuestion) -> ListAxis:
    """The conditions in letters."""
    field = Field("condition", WORDS["condition"][question.lang])
    return ListAxis(question.conditions, field, str, question.in_letters)


def _stroke_axis(question: SolveRequest) -> ListAxis:
    """Outstroke and return stroke."""
    field = Field("stroke", WORDS["stroke"][question.lang])
    return ListAxis(
        tuple(STROKES), field, STROKE_KEYS.__getitem__, lambda one: STROKES[one][question.lang], ""
    )


class RootAxis(Axis):
    """The crank angles at which a condition holds, on pages in degrees and minutes."""

    key = "phi"
    found = True

    def __init__(self, question: RootsQuestion) -> None:
        super().__init__(question.most)
        self.question = question

    def field(self) -> Field:
        lang, symbol = self.question.lang, self.stub_heading()
        return Field("phi", PHI[lang], symbol, "°", self.question.degree_decimals, self.question.method)

    def value(self, place: Place) -> Number:
        return self.question.angle(place, 1, self.question.degree_decimals)

    def stub_heading(self) -> Label:
        return f"${self.question.layout.angle_symbol}$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"${degrees_text(Fraction(self.question.angle(place, 60, 0).scaled, 60))}$",)


def exists(question: Any, place: Place) -> bool:
    """Whether there is so much: not everywhere as much is found."""
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
        "condition": condition_axis,
        "stroke": _stroke_axis,
        "root": RootAxis,
        "column": ColumnAxis,
    },
    axis_keys=("ratio", "condition", "stroke", "phi"),
    own_first=False,
    quantities=quantities,
    number=_number,
    caption=caption,
    notes=notes,
    exists=exists,
    listed=own_columns,
)
