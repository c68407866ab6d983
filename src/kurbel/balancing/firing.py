"""Firing orders: in which order the cylinders of an engine can fire, and which cranks an order needs.

A cylinder fires in its inner dead centre, of two strokes in each, of four in every second one. Angles are in
degrees; those of cranks and banks count as the shaft turns, see arrangement.py, those of firing from the
first cylinder's on. Derived by us.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise, permutations, product
from typing import NamedTuple

from kurbel.balancing.arrangement import Cylinder, check_count
from kurbel.errors import NotationError, ProblemError
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
