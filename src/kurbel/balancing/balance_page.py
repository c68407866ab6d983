"""What pages say of engines and of what they leave unbalanced."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property

from kurbel.balancing.arrangement import (
    IN_NEWTONS,
    LENGTHS,
    WEIGH,
    Arrangement,
    CrankWithMasses,
    Cylinder,
    Residual,
    check_count,
    factor,
    residual,
    row,
    usual,
)
from kurbel.balancing.harmonics import HARMONICS, OrderAxis, OrdersRequest, certified, series_notes
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, exact_text
from kurbel.exact.real import EXACT_ZERO, Real
from kurbel.page.axes import ColumnAxis, ListAxis, Place, RatioAxis, angle_text
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, Words, entry, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import BOTH, amount, unit_of_page
from kurbel.reading.given import choose

UNITS: Mapping[str, Label] = {"force": "$m R ω^2$", "moment": "$m R ω^2 a$"}
ENGINES: Mapping[str, tuple[str, str]] = {
    "inline-1": ("Einzylindermotor", "single cylinder"),
    "inline-2-180": ("Zweizylinder-Reihenmotor, Kurbeln gegenläufig", "inline twin, cranks opposite"),
    "inline-2-360": ("Zweizylinder-Reihenmotor, Kurbeln gleichläufig", "inline twin, cranks alike"),
    "inline-3": ("Dreizylinder-Reihenmotor", "inline three"),
    "inline-4": ("Vierzylinder-Reihenmotor", "inline four"),
    "inline-5": ("Fünfzylinder-Reihenmotor", "inline five"),
    "inline-6": ("Sechszylinder-Reihenmotor", "inline six"),
    "v2-90": ("V2-Motor von 90°", "90° V twin"),
    "v6-90": ("V6-Motor von 90°", "90° V6"),
    "v8-90": ("V8-Motor von 90°", "90° V8"),
    "v12-60": ("V12-Motor von 60°", "60° V12"),
    "boxer-2": ("Zweizylinder-Boxermotor", "flat twin"),
    "boxer-4": ("Vierzylinder-Boxermotor", "flat four"),
}
WORDS = Texts("balancing", "balance")


DEFAULT_ENGINE = "inline-4"
DECIMALS, NEWTON_DECIMALS = 4, 1
WEIGHED = Need(lambda question: question.weighed is not None, ("--reciprocating", "--stroke", "--speed"))
RESIDUALS = tuple(WEIGH)
FACTOR = "factor"
# Key, name, spanner and head of the lengths of `balance.LENGTHS`.
_LENGTHS = (
    (
        "along", "Amplitude längs der Bezugslinie|Amplitude along the line of reference",
        "Amplitude", "längs|along",
    ),
    (
        "across", "Amplitude quer zur Bezugslinie|Amplitude across the line of reference",
        "Amplitude", "quer|across",
    ),
    ("forward", "vorwärts umlaufender Teil|Part turning forward", "Umlaufend|Turning", "vorwärts|forward"),
    (
        "backward", "rückwärts umlaufender Teil|Part turning backward",
        "Umlaufend|Turning", "rückwärts|backward",
    ),
    ("greatest", "größter Betrag|Greatest magnitude", "Betrag|Magnitude", "größter|greatest"),
    ("least", "kleinster Betrag|Least magnitude", "Betrag|Magnitude", "kleinster|least"),
)  # fmt: skip


@cache
def balance_registry() -> Mapping[str, Quantity]:
    """Return every column by its key: the harmonic's factor, and the lengths of force or moment."""
    name = "Harmonische der Kolbenbeschleunigung|Harmonic of the piston acceleration"
    entries = [entry(FACTOR, name, "$B_k$", "", DECIMALS, {"exact": Formula(HARMONICS["p"].value)})]
    for key, name, spanner, head in _LENGTHS:
        formulas = {"exact": Formula(LENGTHS[key])}
        own = entry(key, name, "", "m R ω²", DECIMALS, formulas, head, spanners=(words(spanner),))
        entries += [own, in_newtons(own)]
    return {one.key: one for one in entries}


def in_newtons(own: Quantity) -> Quantity:
    """Return a length of a residual in newtons or newton metres: so its head says, or what stands above."""

    def told(head: Words) -> Words:
        return {lang: f"{text} in {BOTH}" for lang, text in head.items()}

    spanners = tuple(map(told, own.spanners))
    heading = own.heading if spanners else told(own.heading)
    return own._replace(
        key=own.key + IN_NEWTONS, unit=words(BOTH), decimals=NEWTON_DECIMALS, heading=heading,
        spanners=spanners, needs=(WEIGHED,),
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class BalanceRequest(OrdersRequest):
    """What is asked for: the forces and moments of an arrangement with several crank ratios.

    `engine` is its name, empty where the cranks were given one by one; `weighed` makes newtons where masses,
    size and speed are known. Moments are `about` a position as it was given, by itself the middle, and
    positions are in `metres` where they were given as lengths.
    """

    arrangement: Arrangement
    engine: str = ""
    weighed: CrankWithMasses | None = None
    about: Fraction | None = None
    metres: bool = False

    no_column = "there is no column beside the axes; add one, such as along"

    def missing(self, quantity: Quantity) -> str:
        in_newtons = quantity.key + IN_NEWTONS
        if self.weighed is not None and self.weighed.each and in_newtons in self.subject.quantities():
            return f"column {quantity.key} is in units of m R ω², but masses are not alike; take {in_newtons}"
        *first, last = WEIGHED.options
        said = f"column {quantity.key} is in N and N m and needs {', '.join(first)} and {last}"
        return said if any(map(self.lacks, quantity.needs)) else ""

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        engine = engine_label(self.engine, self.arrangement, self.lang)
        return {**super().caption_parts, "{engine}": engine}

    @property
    def in_own_units(self) -> bool:
        """Whether a column is in units of m R ω²."""
        return any(one.key != FACTOR and not one.quantity.needs for one in self.page_columns)

    @property
    def in_newtons(self) -> CrankWithMasses:
        """The masses, whose forces are in the unit of the page."""
        weighed = known(self.weighed)
        spacing = 1 / self.of_page("m") if self.metres else weighed.spacing
        return replace(weighed, units=self.units, spacing=spacing)

    @cached_property
    def placed(self) -> Arrangement:
        """The arrangement, whose positions are in the page's unit of length where they are lengths."""
        if not self.metres or self.units is None:
            return self.arrangement
        times = self.of_page("m")
        cylinders = (one._replace(position=times * one.position) for one in self.arrangement.cylinders)
        return replace(self.arrangement, cylinders=tuple(cylinders))

    @cached_property
    def residuals(self) -> Mapping[tuple[str, int], Residual]:
        """The forces and moments of all orders, each found once."""
        return {(key, order): residual(self.placed, key, order) for key in RESIDUALS for order in self.orders}

    def unit(self, quantity: Quantity, key: str) -> Real | None:
        """Return the unit m R ω² of a residual in that of a quantity, None where it is not known."""
        if not quantity.needs or self.weighed is None:
            return Real.of(1)
        return self.in_newtons.scale(key) if self.weighed.knows(key) else None


def arranged(
    engine: str | None,
    cranks: Sequence[Fraction],
    positions: Sequence[Fraction],
    banks: Sequence[Fraction],
    share: Fraction,
    about: Fraction | None = None,
) -> tuple[str, Arrangement]:
    """Return an engine's name and its cylinders, or no name and those of the cranks, about their middle or
    a position.

    Without either it is the default engine. Positions default to places a unit apart and banks to 0.
    """
    if not cranks:
        if positions or banks:
            raise ProblemError(
                "positions and banks are those of the cylinders in --cranks; give these, for example"
                " --cranks '0;180;180;0'"
            )
        name = choose(DEFAULT_ENGINE if engine is None else engine, usual(), "engine")
        return name, replace(usual()[name], share=share)
    if engine is not None:
        raise ProblemError("--engine has its cranks and --cranks gives others; leave one of the two out")
    check_count(len(cranks))
    for what, given in (("positions", positions), ("banks", banks)):
        if given and len(given) != len(cranks):
            raise ProblemError(
                f"the number of {what} is {len(given)} and that of cranks {len(cranks)};"
                " every cylinder needs one of each"
            )
    evenly = row(cranks, banks, share)
    return "", replace(evenly, cylinders=_placed(evenly, positions, about)) if positions else evenly


def _placed(
    arrangement: Arrangement, positions: Sequence[Fraction], about: Fraction | None
) -> tuple[Cylinder, ...]:
    """Return the cylinders at these positions, counted from one, by itself the middle of the outermost."""
    middle = (min(positions) + max(positions)) / 2 if about is None else about
    pairs = zip(arrangement.cylinders, positions, strict=True)
    return tuple(cylinder._replace(position=position - middle) for cylinder, position in pairs)


def _residual_axis(question: BalanceRequest) -> ListAxis:
    """Forces and moments, with their units where the heads have none."""
    lang = question.lang

    def head(key: str) -> Label:
        name = WORDS[key][lang]
        return WORDS["in"][lang].format(residual=name, unit=UNITS[key]) if question.in_own_units else name

    return ListAxis(RESIDUALS, Field("residual", WORDS["residual"][lang]), str, head)


def _number(question: BalanceRequest, column: Column, place: Place, times: int) -> Number | None:
    key, order = RESIDUALS[place["residual"]], question.orders[place["order"]]
    crank, method = Crank(question.ratios[place["ratio"]]), question.method
    if column.key == FACTOR:
        return certified(HARMONICS["p"], order, crank, column.places, method, question.rounding)
    length = LENGTHS[column.key.removesuffix(IN_NEWTONS)](question.residuals[key, order])
    return number_in(question, column, key, length * factor(order, crank, method))


def number_in(question: BalanceRequest, column: Column, key: str, value: Real) -> Number | None:
    """Return a number of a residual in the unit of its column, None where that is not known."""
    unit = question.unit(column.quantity, key)
    if value.rational == 0:
        return EXACT_ZERO
    return None if unit is None else (value * unit).number(column.places, question.rounding)


def engine_label(name: str, arrangement: Arrangement, lang: str) -> Label:
    """Return what an engine is called by its name, or how many cylinders it has."""
    if name:
        return dict(zip(("de", "en"), ENGINES[name], strict=True))[lang]
    return WORDS["cylinders"][lang].format(count=len(arrangement.cylinders))


def balance_notes(request: BalanceRequest) -> Iterator[Label]:
    lang, cylinders = request.lang, request.arrangement.cylinders
    yield from angle_notes(request.arrangement, lang)
    if len(cylinders) > 1:
        if request.metres:
            lengths = (amount(one.position, "mm") for one in cylinders)
            yield WORDS["lengths"][lang] + listed(lengths)
        else:
            yield WORDS["positions"][lang] + listed(exact_text(one.position) for one in cylinders)
    yield WORDS["angles"][lang]
    revolving = request.weighed is not None and request.weighed.revolving
    yield WORDS["symbols"][lang] + ("" if revolving else WORDS["balanced"][lang])
    spacing = "length" if request.metres else "spacing" if request.engine else "unit"
    yield WORDS[spacing][lang].format(unit=unit_of_page("m")[1]) + _about(request)
    if request.weighed is not None:
        yield from request.weighed.notes(
            request.arrangement, request.layout.ratio_symbol, lang, request.metres
        )
    if request.arrangement.share:
        yield WORDS["share"][lang].format(share=f"${exact_text(request.arrangement.share)}$")
    yield WORDS["zero"][lang]
    yield from series_notes(request)


def _about(request: BalanceRequest) -> Label:
    if request.about is None:
        return WORDS["middle"][request.lang]
    position = f"${amount(request.about, 'mm') if request.metres else exact_text(request.about) + ' a'}$"
    return WORDS["about"][request.lang].format(position=position)


def angle_notes(arrangement: Arrangement, lang: str) -> Iterator[Label]:
    """Yield the angles of the cranks and, where there are several banks, of these."""
    cylinders = arrangement.cylinders
    yield WORDS["cranks"][lang] + listed(angle_text(one.crank) for one in cylinders)
    if any(one.bank for one in cylinders):
        yield WORDS["banks"][lang] + listed(angle_text(one.bank) for one in cylinders)


def listed(values: Iterable[str]) -> Label:
    """Return values in a row: $0°$; $180°$."""
    return "; ".join(f"${value}$" for value in values)


SUBJECT = Subject(
    key="balance",
    layout="balance",
    command="balance",
    axes={"ratio": RatioAxis, "residual": _residual_axis, "order": OrderAxis, "column": ColumnAxis},
    axis_keys=("ratio", "residual", "order"),
    own_first=False,
    quantities=balance_registry,
    number=_number,
    notes=balance_notes,
    drawn="kurbel.plot.pages:unbalanced",
)
