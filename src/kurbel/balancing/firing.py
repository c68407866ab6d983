"""Firing orders: in which order the cylinders of an engine can fire, and which cranks an order needs.

A cylinder fires in its inner dead centre, of two strokes in each, of four in every second one. Angles are in
degrees; those of cranks and banks count as the shaft turns, see arrangement.py, those of firing from the
first cylinder's on. Derived by us.

An engine's cranks and a layout become a table of its firing orders; an order that of its cylinders.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from itertools import pairwise, permutations, product
from operator import attrgetter
from typing import Any, NamedTuple

from kurbel.balancing.arrangement import Arrangement, Cylinder, check_count, row
from kurbel.balancing.balance_page import WORDS as BALANCE
from kurbel.balancing.balance_page import angle_notes, arranged, engine_label, listed
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_number, angle_text
from kurbel.page.quantity import Column, Formula, Quantity, Texts, entry
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field, Value
from kurbel.reading.notation import about

TURN = 360
# By the strokes of a cycle the angle after which a cylinder fires again.
PERIODS: Mapping[int, int] = {4: 2 * TURN, 2: TURN}
# Of so many cylinders of four strokes all choices of the turn in which each fires are gone through.
MOST_CHOSEN = 14

Order = tuple[tuple[int, ...], ...]
"""Numbers of cylinders, from 1, one after the other; those that fire at once stand together."""


class Firing(NamedTuple):
    """An order, and the angles from the first firing at which its cylinders fire; then all begins anew."""

    order: Order
    angles: tuple[Fraction, ...]
    period: int

    @property
    def intervals(self) -> tuple[Fraction, ...]:
        """From each firing to the next, the last to the first of the next cycle."""
        return tuple(after - before for before, after in pairwise((*self.angles, Fraction(self.period))))

    @property
    def text(self) -> str:
        """The order as it is written: 1-3-4-2, or 1+4-2+3."""
        return "-".join("+".join(map(str, group)) for group in self.order)


def dead_centres(cylinders: Sequence[Cylinder]) -> tuple[Fraction, ...]:
    """Return the angles of the shaft within 0..360 at which the pistons are in their inner dead centre."""
    return tuple((one.bank - one.crank) % TURN for one in cylinders)


def firings(cylinders: Sequence[Cylinder], strokes: int) -> tuple[Firing, ...]:
    """Return the orders at equal intervals; where there is none, those whose longest interval is shortest.

    Of these the ones whose second longest is, and so on. The first cylinder fires first.
    """
    found = _choices(cylinders, strokes)
    least = min(map(_unevenness, found))
    return tuple(one for one in found if _unevenness(one) == least)


def fitting(cylinders: Sequence[Cylinder], strokes: int, order: Order) -> Firing:
    """Return the most even firing of the cylinders in an order; raise ProblemError if they have none."""
    check_order(order, len(cylinders))
    turned = _from_first(order)
    possible = _choices(cylinders, strokes)
    found = [one for one in possible if one.order == turned]
    if not found:
        best = min(possible, key=_unevenness)
        raise ProblemError(
            f"cylinders with these cranks cannot fire in the order {_text(order)}; they can in"
            f" {best.text}, or leave the cranks out to be told those of the order"
        )
    return min(found, key=_unevenness)


def cranks_of(
    order: Order, strokes: int, banks: Sequence[Fraction] = (), intervals: Sequence[Fraction] = ()
) -> tuple[Fraction, ...]:
    """Return the crank angles within 0..360 of cylinders that fire in an order, the first cylinder's 0.

    At equal intervals unless others are given, from each firing to the next.
    """
    count = sum(map(len, order))
    check_order(order, count)
    angles = _running(order, strokes, intervals)
    fired = {number: angle for group, angle in zip(order, angles, strict=True) for number in group}
    places = banks or [Fraction(0)] * count
    if len(places) != count:
        raise ProblemError(f"the number of banks is {len(places)}, and the order has {count} cylinders")
    return tuple(
        (bank - places[0] - fired[number] + fired[1]) % TURN for number, bank in enumerate(places, 1)
    )


def _running(order: Order, strokes: int, intervals: Sequence[Fraction]) -> list[Fraction]:
    """Return the angles of the firings, by these intervals or by equal ones."""
    period, count = PERIODS[strokes], len(order)
    steps = list(intervals) or [Fraction(period, count)] * count
    if len(steps) != count:
        raise ProblemError(f"{len(steps)} intervals were given, and the order {_text(order)} has {count}")
    if any(step <= 0 for step in steps) or sum(steps) != period:
        raise ProblemError(
            f"the intervals add up to {about(Fraction(sum(steps)))}°; each must be above 0, and their sum"
            f" {period}°, for a cylinder of {strokes} strokes fires once in {period // TURN} turns"
        )
    return [sum(steps[:index], Fraction(0)) for index in range(count)]


def check_strokes(strokes: int) -> None:
    """Raise ProblemError unless a cycle can have so many strokes."""
    if strokes not in PERIODS:
        raise ProblemError(
            f"a cycle of {str(strokes)[:20]} strokes was given; it has 4, of which one works, or 2"
        )


def read_order(given: object) -> Order:
    """Read a firing order: 1-3-4-2, or a list of these numbers; of cylinders that fire at once 1+4-2+3."""
    numbers = given if isinstance(given, Iterable) and not isinstance(given, str) else [given]
    text = "-".join(map(str, numbers))
    groups = [group.split("+") for group in re.split(r"[-–,;\s]+", text.strip())]
    if not all(re.fullmatch("[1-9][0-9]?", number) for group in groups for number in group):
        raise NotationError(
            f'firing order "{text[:40]}" is not understood; write the numbers of the cylinders as 1-3-4-2'
        )
    return tuple(tuple(map(int, group)) for group in groups)


def check_order(order: Order, cylinders: int) -> None:
    """Raise ProblemError unless the order has each of so many cylinders once."""
    check_count(cylinders)
    numbers = [number for group in order for number in group]
    if sorted(numbers) != [*range(1, cylinders + 1)]:
        raise ProblemError(
            f"firing order {_text(order)} must have each of the cylinders 1 to {cylinders} once, as 1-3-4-2"
        )


def _choices(cylinders: Sequence[Cylinder], strokes: int) -> list[Firing]:
    """Return the firings at equal intervals; where there is none, those of all choices of turns."""
    centres = dead_centres(cylinders)
    since = [(one - centres[0]) % TURN for one in centres]
    even = [_fired(angles, strokes) for angles in _evenly(since, PERIODS[strokes])]
    return even or [_fired(angles, strokes) for angles in _in_all_turns(since, PERIODS[strokes] // TURN)]


def _evenly(since: Sequence[Fraction], period: int) -> Iterator[list[Fraction]]:
    """Yield the angles at which cylinders fire at equal intervals, from those of their dead centres."""
    count = len(since)
    slots: dict[Fraction, list[Fraction]] = {}
    for slot in range(count):
        angle = Fraction(slot * period, count)
        slots.setdefault(angle % TURN, []).append(angle)
    if Counter(since) != {angle: len(free) for angle, free in slots.items()}:
        return
    # The first cylinder's slot is the first.
    for orders in product(*map(permutations, slots.values())):
        left = {angle: [*order] for angle, order in zip(slots, orders, strict=True)}
        angles = [left[angle].pop(0) for angle in since]
        if angles[0] == 0:
            yield angles


def _in_all_turns(since: Sequence[Fraction], turns: int) -> Iterator[list[Fraction]]:
    """Yield the angles at which cylinders fire, the first in the first turn, each other one in any."""
    count = len(since)
    if turns > 1 and count > MOST_CHOSEN:
        raise ProblemError(
            f"{count} cylinders cannot fire at equal intervals with these cranks; other firing orders are"
            f" looked for with at most {MOST_CHOSEN}"
        )
    for chosen in product((0,), *[range(turns)] * (count - 1)):
        yield [angle + TURN * turn for angle, turn in zip(since, chosen, strict=True)]


def _fired(angles: Sequence[Fraction], strokes: int) -> Firing:
    """Return the firing of cylinders at these angles."""
    groups: dict[Fraction, list[int]] = {}
    for number, angle in enumerate(angles, 1):
        groups.setdefault(angle, []).append(number)
    order = sorted(groups)
    return Firing(tuple(tuple(groups[angle]) for angle in order), tuple(order), PERIODS[strokes])


def _unevenness(firing: Firing) -> tuple[Fraction, ...]:
    return tuple(sorted(firing.intervals, reverse=True))


def _from_first(order: Order) -> Order:
    """Return the order as it runs from the first cylinder, the numbers that fire at once rising."""
    groups = [tuple(sorted(group)) for group in order]
    first = next(index for index, group in enumerate(groups) if 1 in group)
    return (*groups[first:], *groups[:first])


def _text(order: Order) -> str:
    return Firing(order, (), 0).text


WORDS = Texts("balancing", "firing")


class FiringCylinder(NamedTuple):
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


def _entry(key: str, name: str, heading: str, kernel: Callable[[Any], object], unit: str = "°") -> Quantity:
    return entry(key, name, "", unit, None, {"exact": Formula(kernel)}, heading)


def _intervals(firing: Firing) -> Label:
    return listed(angle_text(one) for one in firing.intervals)


@cache
def orders_registry() -> Mapping[str, Quantity]:
    """Return what is said of a firing order, by its key."""
    found = (
        _entry("firing_order", "Zündfolge|Firing order", "Zündfolge|Firing order", attrgetter("text"), ""),
        _entry("intervals", "Zündabstände|Firing intervals", "Abstände|Intervals", _intervals),
        _entry("shortest", "kleinster Zündabstand|Shortest firing interval", "kleinster in °|Shortest in °",
               lambda firing: min(firing.intervals)),
        _entry("longest", "größter Zündabstand|Longest firing interval", "größter in °|Longest in °",
               lambda firing: max(firing.intervals)),
    )  # fmt: skip
    return {one.key: one for one in found}


@cache
def cylinders_registry() -> Mapping[str, Quantity]:
    """Return what is said of a cylinder in a firing order, by its key."""
    return {
        key: _entry(key, name, heading, attrgetter(key))
        for key, name, heading in (
            ("crank", "Kurbelwinkel des Zylinders|Crank angle of the cylinder", "Kurbel in °|Crank in °"),
            ("follows", "Nachlauf der Kurbel hinter der ersten|Angle by which the crank follows the first",
             "Nachlauf in °|Follows by, in °"),
            ("bank", "Winkel der Zylinderachse|Angle of the cylinder's axis", "Achse in °|Axis in °"),
            ("fires_at", "Zündwinkel|Firing angle", "Zündwinkel in °|Fires at, in °"),
            ("interval", "Zündabstand zum nächsten|Firing interval to the next",
             "Abstand in °|Interval in °"),
        )
    }  # fmt: skip


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

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        engine = engine_label(self.engine, self.arrangement, self.lang)
        return {**super().caption_parts, "{engine}": engine, "{order}": self.firings[0].text}

    @cached_property
    def firings(self) -> tuple[Firing, ...]:
        """The orders that the page is about."""
        cylinders = self.arrangement.cylinders
        if self.order:
            return (fitting(cylinders, self.strokes, self.order),)
        return firings(cylinders, self.strokes)

    @cached_property
    def fired(self) -> list[FiringCylinder]:
        """The cylinders of the first order as they fire."""
        firing, cylinders = self.firings[0], self.arrangement.cylinders
        groups = zip(firing.order, firing.angles, firing.intervals, strict=True)
        return [
            _record(number, cylinders, firing, angle, interval)
            for group, angle, interval in groups
            for number in group
        ]


def _record(
    number: int, cylinders: Sequence[Cylinder], firing: Firing, angle: Fraction, interval: Fraction
) -> FiringCylinder:
    crank, bank = cylinders[number - 1].crank, cylinders[number - 1].bank
    follows = (angle - bank + cylinders[0].bank) % firing.period
    return FiringCylinder(number, crank, follows, bank, angle, interval)


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


def _shown(column: Column, about: Firing | FiringCylinder) -> Value:
    found = column.quantity.formulas["exact"].kernel(about)
    if not isinstance(found, Fraction):
        return str(found)
    if column.decimals is None:
        return angle_number(found, None)
    return nearest(found, column.decimals)


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
    notes=_notes,
)
