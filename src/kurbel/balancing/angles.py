"""The free forces and moments of an engine at angles of the shaft, of each order and of all, and their page.

Of all orders it is the sum over the cylinders of their piston accelerations, by the exact formula: cos θ,
whose sum is the first order, and a rest that is the same at θ, -θ and θ + 180°.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kurbel.balancing.arrangement import IN_NEWTONS, WEIGH, Residual, factor
from kurbel.balancing.balance_page import (
    DECIMALS,
    RESIDUALS,
    SUBJECT,
    BalanceRequest,
    balance_notes,
    in_newtons,
    number_in,
)
from kurbel.balancing.harmonics import OrderAxis
from kurbel.balancing.vector import Point, Vector
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, Number
from kurbel.exact.real import EXACT_ZERO, Real
from kurbel.kernel.circle import Numeric
from kurbel.kernel.harmonics import Star
from kurbel.kernel.kinematics import piston_acceleration
from kurbel.page.axes import AngleAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity, Words, entry, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field


def of_order(residual: Residual, order: int, angle: Fraction) -> Vector:
    """Return the vector of an order at an angle in degrees, in units of m R ω² |B_k|."""
    forward = residual.forward.turned(order * angle)
    return Vector(forward + residual.backward.turned(-order * angle))


def of_all(question: BalanceRequest, residual: str, crank: Crank, angle: Fraction) -> Vector:
    """Return the vector of all orders at an angle in degrees, in units of m R ω².

    Exact for every crank ratio 0 <= λ < 1; by other methods the sum of the orders that the page has.
    """
    residuals, method = question.residuals, question.method
    if method != "exact":
        total = Vector()
        for order in question.orders:
            share = known(factor(order, crank, method).rational)
            total += of_order(residuals[residual, order], order, angle) * share
        return total
    groups: dict[Fraction, Star] = {}
    for cylinder in question.placed.cylinders:
        turned = (angle + cylinder.crank - cylinder.bank) % 180
        folded = min(turned, 180 - turned)
        ray = Star.ray(cylinder.bank, cylinder.mass * WEIGH[residual](cylinder))
        groups[folded] = groups.get(folded, Star()) + ray
    rest: list[tuple[Point, Fraction]] = [
        (_even(folded, star, crank.ratio), Fraction(1))
        for folded, star in sorted(groups.items())
        if crank.ratio and not star.vanishes()
    ]
    return Vector(of_order(residuals[residual, 1], 1, angle).star, tuple(rest))


def _even(angle: Fraction, star: Star, ratio: Fraction) -> Point:
    """Return a star times the piston acceleration less cos θ at an angle."""

    def point(kind: Kind) -> tuple[Numeric, Numeric]:
        circle = kind.circle(angle)
        size = piston_acceleration(circle, kind.of(ratio)) - circle.cosine
        x, y = star.point(kind.circle, kind.of)
        return size * x, size * y

    return point


MOST_ANGLES = 10_000
DIRECTION_DECIMALS = 2
ALL = "all"
WORDS: Mapping[str, Words] = {
    ALL: words("alle|all"),
    "sum": words("Summe|sum"),
    "shaft": words(
        "$φ$ Drehwinkel der Welle; bei $φ = 0$ stehen die Kurbeln wie angegeben"
        "|$φ$ angle of the shaft; at $φ = 0$ the cranks stand as given"
    ),
}
# By the key of a column: what it prints of a vector beside its direction.
PRINTED: Mapping[str, Callable[[Vector], Real]] = {
    "along": lambda vector: vector.component(0),
    "across": lambda vector: vector.component(1),
    "magnitude": Vector.length,
}


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the columns by their keys."""
    rows = (
        ("along", "längs der Bezugslinie|along the line of reference", "längs|along"),
        ("across", "quer zur Bezugslinie|across the line of reference", "quer|across"),
        ("magnitude", "Betrag|Magnitude", "Betrag|magnitude"),
    )
    found = []
    for key, name, head in rows:
        formulas = {"exact": Formula(PRINTED[key])}
        own = entry(key, name, "", "m R ω²", DECIMALS, formulas, head)
        found += [own, in_newtons(own)]
    formulas = {"exact": Formula(Vector.number)}
    found.append(entry("direction", "Richtung|Direction", "", "°", DIRECTION_DECIMALS, formulas,
                       "Richtung in °|direction in °"))  # fmt: skip
    return {one.key: one for one in found}


class LinesRequest(BalanceRequest):
    """What is asked for of the orders, and of all of them together."""

    @property
    def lines(self) -> tuple[int | None, ...]:
        """The orders, and None for all of them."""
        return (*self.orders, None)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class AngleRequest(LinesRequest):
    """What is asked for: the forces and moments of an arrangement at angles of the shaft, by orders and
    all together."""

    angles: Sequence[Fraction]

    no_column = "there is no column beside the axes; add one, such as along"

    def check(self) -> None:
        super().check()
        if not 1 <= len(self.angles) <= MOST_ANGLES:
            raise ProblemError(f"{len(self.angles)} angles were given; 1 to {MOST_ANGLES} are allowed")

    @property
    def in_own_units(self) -> bool:
        return any(one.key in PRINTED for one in self.page_columns)

    @cached_property
    def vector(self) -> Callable[[str, int | None, int, int], tuple[Vector, Real]]:
        """Return the vector of a residual, of an order or all, at a ratio and an angle, each found once."""
        return cache(self._vector)

    def _vector(self, key: str, order: int | None, ratio: int, at: int) -> tuple[Vector, Real]:
        """Return the vector with what makes units of m R ω² of it; of no order, of all."""
        crank, angle = Crank(self.ratios[ratio]), self.angles[at]
        if order is not None:
            return of_order(self.residuals[key, order], order, angle), factor(order, crank, self.method)
        return of_all(self, key, crank, angle), Real.of(1)


class LineAxis(OrderAxis):
    """The orders, and below them all together."""

    def __init__(self, question: Any) -> None:
        super().__init__(question)
        self.orders: Sequence[int | None] = question.lines
        self.size = self.count = len(question.lines)
        self.key_of_all = ALL if question.method == "exact" else "sum"
        self.all = WORDS[self.key_of_all][question.lang]

    def value(self, place: Place) -> Number | Label:
        order = self.orders[place["order"]]
        return self.key_of_all if order is None else Number(order, 0)

    def stub(self, place: Place) -> Number | Label:
        order = self.orders[place["order"]]
        return self.all if order is None else Number(order, 0)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return super().heads(place) if self.orders[place["order"]] is not None else (self.all,)

    def field(self) -> Field:
        return super().field()._replace(decimals=None)


def _number(question: AngleRequest, column: Column, place: Place, times: int) -> Number | None:
    key, order = RESIDUALS[place["residual"]], question.lines[place["order"]]
    vector, scale = question.vector(key, order, place["ratio"], place["angle"])
    if scale.rational == 0:
        return None if column.key == "direction" else EXACT_ZERO
    if column.key == "direction":
        return vector.number(column.places, question.rounding)
    value = PRINTED[column.key.removesuffix(IN_NEWTONS)](vector) * scale
    if question.unit(column.quantity, key) is None and not vector.vanishes():
        return None
    return number_in(question, column, key, value)


def angle_notes(question: LinesRequest) -> Iterator[Label]:
    yield WORDS["shaft"][question.lang]
    yield from balance_notes(question)


_BALANCED: Subject[AngleRequest] = SUBJECT
AT_ANGLES = _BALANCED._replace(
    key="balance at angles",
    layout="balance-angle",
    command="balance --angle 30",
    axes={
        "ratio": SUBJECT.axes["ratio"],
        "residual": SUBJECT.axes["residual"],
        "angle": AngleAxis,
        "order": LineAxis,
        "column": SUBJECT.axes["column"],
    },
    axis_keys=("ratio", "residual", "phi", "order"),
    quantities=quantities,
    number=_number,
    notes=angle_notes,
)
