"""An engine's cranks and a layout become a table of its firing orders; an order that of its cylinders."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple

from kurbel.balancing.arrangement import Arrangement, Cylinder, check_count, row
from kurbel.balancing.balance_page import WORDS as BALANCE
from kurbel.balancing.balance_page import angle_notes, arranged, engine_label, listed
from kurbel.balancing.firing import PERIODS, TURN, Firing, Order, check_strokes, cranks_of, firings, fitting
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_number, angle_text
from kurbel.page.quantity import Column, Formula, Quantity, Words, entry, filled, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field, Value

WORDS: Mapping[str, Words] = {
    "order": words("Zündfolge|Firing order"),
    "number": words("Nr.|No."),
    "cylinder": words("Zylinder|Cylinder"),
    "strokes": words(
        "Viertakt: jeder Zylinder zündet in zwei Umdrehungen einmal"
        "|four strokes: each cylinder fires once in two turns"
    ),
    "two_strokes": words(
        "Zweitakt: jeder Zylinder zündet in jeder Umdrehung|two strokes: each cylinder fires in each turn"
    ),
    "even": words("Zündabstand ${angle}$, überall gleich|Firing interval ${angle}$ throughout"),
    "uneven": words(
        "Bei gleichen Abständen zündet der Motor in keiner Folge; gezeigt sind die Folgen, deren größter"
        " Abstand am kleinsten ist"
        "|The engine has no order at equal intervals; shown are those whose longest interval is shortest"
    ),
    "numbers": words(
        "Zylinder in der Reihenfolge ihrer Kurbeln gezählt; + verbindet, die zugleich zünden"
        "|Cylinders are numbered in the order of their cranks; + joins those that fire at once"
    ),
    "zero": words(
        "Zündwinkel zählen vom inneren Totpunkt, in dem der erste Zylinder zündet"
        "|Firing angles count from the inner dead centre in which the first cylinder fires"
    ),
    "sense": words(
        "Kurbeln zählen hier wie bei balance im Drehsinn; --cranks von delta, turning und harmonics und angle"
        " eines Zylinders sagen dagegen, um wie viel eine Kurbel der ersten folgt{follows}"
        "|Cranks count here and in balance in the sense of rotation; --cranks of delta, turning and harmonics"
        " and the angle of a cylinder say by how much a crank follows the first{follows}"
    ),
    "follows": words(
        ": so zählt die Spalte Nachlauf, über das ganze Arbeitsspiel"
        "|: so does the column beside them, over the whole cycle"
    ),
}


class Fired(NamedTuple):
    """A cylinder in a firing order: its number and angles, and when it fires.

    Its crank `follows` that of the first cylinder by an angle within the cycle: cylinders whose cranks follow
    so, as those of engines with loads do, fire in the order.
    """

    number: int
    crank: Fraction
    follows: Fraction
    bank: Fraction
    fires_at: Fraction
    interval: Fraction


def _angle(key: str, name: str, heading: str, kernel: Callable[[Any], Any]) -> Quantity:
    return entry(key, name, "", "°", None, {"exact": Formula(kernel)}, heading)


def _intervals(firing: Firing) -> Label:
    return listed(angle_text(one) for one in firing.intervals)


@cache
def orders_registry() -> Mapping[str, Quantity]:
    """Return what is said of a firing order, by its key."""
    text = {"exact": Formula(lambda firing: firing.text)}
    found = (
        entry("firing_order", "Zündfolge|Firing order", "", "", None, text, "Zündfolge|Firing order"),
        _angle("intervals", "Zündabstände|Firing intervals", "Abstände|Intervals", _intervals),
        _angle(
            "shortest", "kleinster Zündabstand|Shortest firing interval", "kleinster in °|Shortest in °",
            lambda firing: min(firing.intervals),
        ),
        _angle(
            "longest", "größter Zündabstand|Longest firing interval", "größter in °|Longest in °",
            lambda firing: max(firing.intervals),
        ),
    )  # fmt: skip
    return {one.key: one for one in found}


@cache
def cylinders_registry() -> Mapping[str, Quantity]:
    """Return what is said of a cylinder in a firing order, by its key."""
    found = (
        _angle(
            "crank", "Kurbelwinkel des Zylinders|Crank angle of the cylinder", "Kurbel in °|Crank in °",
            lambda fired: fired.crank,
        ),
        _angle(
            "follows", "Nachlauf der Kurbel hinter der ersten|Angle by which the crank follows the first",
            "Nachlauf in °|Follows by, in °", lambda fired: fired.follows,
        ),
        _angle(
            "bank", "Winkel der Zylinderachse|Angle of the cylinder's axis", "Achse in °|Axis in °",
            lambda fired: fired.bank,
        ),
        _angle(
            "fires_at", "Zündwinkel|Firing angle", "Zündwinkel in °|Fires at, in °",
            lambda fired: fired.fires_at,
        ),
        _angle(
            "interval", "Zündabstand zum nächsten|Firing interval to the next",
            "Abstand in °|Interval in °", lambda fired: fired.interval,
        ),
    )  # fmt: skip
    return {one.key: one for one in found}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FiringRequest(Question):
    """What is asked for: the firing orders of an engine or, of one order, when its cylinders fire.

    `engine` is its name, empty where the cranks were given one by one or follow from the order.
    """

    arrangement: Arrangement
    strokes: int = 4
    order: Order = ()
    engine: str = ""

    no_column = "there is no column beside the axes; add one, such as intervals or fires_at"

    def check(self) -> None:
        # The cranks may have no such order.
        assert self.firings

    @cached_property
    def firings(self) -> tuple[Firing, ...]:
        """The orders that the page is about."""
        cylinders = self.arrangement.cylinders
        if self.order:
            return (fitting(cylinders, self.strokes, self.order),)
        return firings(cylinders, self.strokes)

    @cached_property
    def fired(self) -> list[Fired]:
        """The cylinders of the first order as they fire."""
        firing, cylinders = self.firings[0], self.arrangement.cylinders
        groups = zip(firing.order, firing.angles, firing.intervals, strict=True)
        return [
            _fired(number, cylinders, firing, angle, interval)
            for group, angle, interval in groups
            for number in group
        ]


def _fired(
    number: int, cylinders: Sequence[Cylinder], firing: Firing, angle: Fraction, interval: Fraction
) -> Fired:
    crank, bank = cylinders[number - 1].crank, cylinders[number - 1].bank
    follows = (angle - bank + cylinders[0].bank) % firing.period
    return Fired(number, crank, follows, bank, angle, interval)


def asked(
    engine: str | None,
    cranks: Sequence[Fraction],
    banks: Sequence[Fraction],
    order: Order,
    strokes: int,
    intervals: Sequence[Fraction],
) -> tuple[str, Arrangement]:
    """Return an engine's name and its cylinders, those of the cranks, or those that the order needs."""
    check_strokes(strokes)
    if intervals and (cranks or engine is not None or not order):
        raise ProblemError(
            "intervals are those of a firing order whose cranks are sought; give --order and no cranks"
        )
    if cranks or engine is not None or not order:
        return arranged(engine, cranks, (), banks, Fraction(0))
    check_count(sum(map(len, order)))
    return "", row(cranks_of(order, strokes, banks, intervals), banks)


def _orders_axis(question: FiringRequest) -> ListAxis:
    lang = question.lang
    field = Field("number", WORDS["number"][lang], "", "", 0)
    numbers = range(1, len(question.firings) + 1)
    return ListAxis(numbers, field, lambda one: Number(one, 0), lambda one: f"${one}$")


def _cylinder_axis(question: FiringRequest) -> ListAxis:
    field = Field("cylinder", WORDS["cylinder"][question.lang], "", "", 0)
    return ListAxis(question.fired, field, lambda one: Number(one.number, 0), lambda one: f"${one.number}$")


def _of_order(question: FiringRequest, column: Column, place: Place, times: int) -> Value:
    return _shown(column, question.firings[place["number"]])


def _of_cylinder(question: FiringRequest, column: Column, place: Place, times: int) -> Value:
    return _shown(column, question.fired[place["cylinder"]])


def _shown(column: Column, about: Firing | Fired) -> Value:
    found = column.quantity.formulas["exact"].kernel(about)
    if not isinstance(found, Fraction):
        return str(found)
    if column.decimals is None:
        return angle_number(found, None)
    return nearest(found, column.decimals)


def _caption(question: FiringRequest) -> Label:
    engine = engine_label(question.engine, question.arrangement, question.lang)
    parts = {"{engine}": engine, "{order}": question.firings[0].text}
    return filled(question.layout.caption[question.lang], parts.items())


def _notes(question: FiringRequest) -> Iterator[Label]:
    lang, firing = question.lang, question.firings[0]
    if not question.order:
        yield from angle_notes(question.arrangement, lang)
    if len(set(firing.intervals)) == 1:
        yield WORDS["even"][lang].format(angle=angle_text(firing.intervals[0]))
    elif question.strokes == 4 and not question.order:
        yield WORDS["uneven"][lang]
    yield WORDS["numbers"][lang]
    yield WORDS["strokes" if PERIODS[question.strokes] > TURN else "two_strokes"][lang]
    if question.order:
        yield WORDS["zero"][lang]
    yield BALANCE["angles"][lang]
    shown = {column.key for column in question.page_columns}
    yield WORDS["sense"][lang].format(follows=WORDS["follows"][lang] if "follows" in shown else "")


ORDERS = Subject(
    key="firing orders",
    layout="firing-orders",
    command="firing",
    axes={"number": _orders_axis, "column": ColumnAxis},
    axis_keys=("number",),
    quantities=orders_registry,
    number=_of_order,
    caption=_caption,
    notes=_notes,
)
FIRING = Subject(
    key="firing",
    layout="firing",
    command="firing --order 1-3-4-2",
    axes={"cylinder": _cylinder_axis, "column": ColumnAxis},
    axis_keys=("cylinder",),
    quantities=cylinders_registry,
    number=_of_cylinder,
    caption=_caption,
    notes=_notes,
)
