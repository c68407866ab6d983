"""An engine's cylinders and a layout become a table of the greatest free forces and moments, and of where."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, partial
from math import inf
from typing import Any

from kurbel.balancing.angles import WORDS, LineAxis, of_all, of_order
from kurbel.balancing.arrangement import LENGTHS, Residual, certified_length, factor
from kurbel.balancing.balance_page import (
    RESIDUALS,
    SUBJECT,
    BalanceRequest,
    balance_notes,
    balance_registry,
)
from kurbel.balancing.greatest import Curve, Greatest, greatest, left, slides_of
from kurbel.balancing.newtons import IN_NEWTONS
from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.exact.certify import NEVER_TIES, rounded
from kurbel.exact.kind import balls
from kurbel.exact.numerals import Label, Number
from kurbel.exact.real import EXACT_ZERO, Real
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, Formula, Quantity, entry
from kurbel.reading.amounts import BOTH

GREATEST, PLACE = "greatest", "greatest_phi"
PLACE_DECIMALS = 2
# Of a place that may be a whole part of a degree, so many of them.
FINEST = 8
NEAR = 1e-9


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the columns by their keys."""
    own = balance_registry()
    # The heads of the pages by orders stand under a spanner.
    headed = {
        key: own[key]._replace(spanners=(), heading=own[key].name if key == GREATEST else _in_newtons(own))
        for key in (GREATEST, GREATEST + IN_NEWTONS)
    }
    name = "größter Betrag bei φ|Greatest magnitude at φ"
    head = "bei $φ$ in °|at $φ$ in °"
    place = entry(PLACE, name, "", "°", PLACE_DECIMALS, {"exact": Formula(LENGTHS[GREATEST].value)}, head)
    return {**headed, PLACE: place}


def _in_newtons(own: Mapping[str, Quantity]) -> Mapping[str, str]:
    return {lang: f"{name} in {BOTH}" for lang, name in own[GREATEST].name.items()}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ExtremesRequest(BalanceRequest):
    """What is asked for: the greatest forces and moments of an arrangement over the turn, by orders and
    all together."""

    no_column = "there is no column beside the axes; add one, such as greatest"

    @property
    def in_own_units(self) -> bool:
        return any(one.quantity.key == GREATEST for one in self.page_columns)

    @property
    def lines(self) -> tuple[int | None, ...]:
        """The orders, and None for all of them."""
        return (*self.orders, None)

    @cached_property
    def curve(self) -> Any:
        """Return the curve of all orders together of a residual at a ratio, each found once."""
        return cache(self._curve)

    def _curve(self, key: str, ratio: int) -> Curve:
        crank = Crank(self.ratios[ratio])
        exact = self.method == "exact" and bool(crank.ratio)
        orders = (1,) if exact else self.orders
        scales = {one: factor(one, crank, self.method) for one in orders}
        waves = left(
            [
                (one, self.residuals[key, one], partial(_on_balls, scale))
                for one, scale in scales.items()
                if scale.rational != 0
            ]
        )
        return Curve(waves, slides_of(self.placed, key) if exact else (), crank.ratio)

    @cached_property
    def greatest(self) -> Any:
        return cache(lambda key, ratio: greatest(self.curve(key, ratio)))


def _on_balls(scale: Real) -> Any:
    return scale.on(balls())


def _number(question: ExtremesRequest, column: Column, place: Place, times: int) -> Number | None:
    key, order, ratio = RESIDUALS[place["residual"]], question.lines[place["order"]], place["ratio"]
    scale = Real.of(1)
    if column.quantity.needs and question.weighed is not None:
        if not question.weighed.knows(key):
            return None
        scale = question.in_newtons.scale(key)
    if order is None:
        curve = question.curve(key, ratio)
        if not (curve.waves or curve.slides):
            return None if column.quantity.key == PLACE else EXACT_ZERO
        if curve.slides or len(curve.waves) > 1:
            return _of_all(question, column, key, ratio, scale)
        order = curve.waves[0].order
    return _of_order(question, column, question.residuals[key, order], (key, order, ratio))


def _of_order(
    question: ExtremesRequest, column: Column, residual: Residual, where: tuple[str, int, int]
) -> Number | None:
    key, order, ratio = where
    scale = factor(order, Crank(question.ratios[ratio]), question.method)
    if column.quantity.key == PLACE:
        # The two vectors meet where k φ + arg f = arg b - k φ.
        meeting = Vector(residual.backward * residual.forward.mirrored())
        return None if scale.rational == 0 else meeting.number(column.places, question.rounding, 2 * order)
    if scale.rational == 0 or LENGTHS[GREATEST].vanishes(residual):
        return EXACT_ZERO
    if column.quantity.needs and question.weighed is not None:
        scale *= question.in_newtons.scale(key)
    return certified_length(LENGTHS[GREATEST], residual, column.places, scale, question.rounding)


def _of_all(question: ExtremesRequest, column: Column, key: str, ratio: int, scale: Real) -> Number:
    found: Greatest = question.greatest(key, ratio)
    if column.quantity.key == PLACE:
        return Number(
            rounded(lambda: _degrees(found), column.places, question.rounding, NEVER_TIES), column.places
        )

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if _is_reached(question, (key, ratio), found, boundary / known(scale.rational)) else inf

    ties = NEVER_TIES if scale.rational is None else tie_bits
    value = rounded(lambda: scale.on(balls()) * found.length(), column.places, question.rounding, ties)
    return Number(value, column.places)


def _degrees(found: Greatest) -> Any:
    degrees = found.place() * 180
    return degrees - 360 if degrees.mid() > 360 - NEAR else degrees


def _is_reached(question: ExtremesRequest, where: tuple[str, int], found: Greatest, length: Fraction) -> bool:
    """Whether the length is reached exactly at the part of a degree at which the greatest one is.

    The greatest is then not below it, and rounds as it does.
    """
    key, ratio = where
    angle = Fraction(round(float(_degrees(found).mid()) * FINEST), FINEST)
    crank = Crank(question.ratios[ratio])
    if question.method == "exact":
        vector = of_all(question.placed, key, question.residuals[key, 1], crank, angle)
    else:
        vector = Vector()
        for order in question.orders:
            share = known(factor(order, crank, question.method).rational)
            vector += of_order(question.residuals[key, order], order, angle) * share
    return (vector.square() - length**2).vanishes()


def _notes(question: ExtremesRequest) -> Iterator[Label]:
    yield WORDS["shaft"][question.lang]
    yield from balance_notes(question)


EXTREMES = SUBJECT._replace(
    key="balance extremes",
    layout="balance-greatest",
    command="balance --layout balance-greatest",
    axes={**SUBJECT.axes, "order": LineAxis},
    quantities=quantities,
    number=_number,
    notes=_notes,
    listed=lambda: (("balance --layout balance-greatest", quantities()[PLACE]),),
)
