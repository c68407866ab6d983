"""Printed values against recomputed ones: the true value of each cell, other methods' values, the verdict.

A true value is rounded once to the last place that is printed, half away from zero; every digit is certified.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.certify import NEVER_TIES, TieBits, ball, ball_circle, ball_degrees, rounded
from kurbel.choices import choose
from kurbel.errors import KurbelError, NotationError, SourceError
from kurbel.expression import Expression, Kind
from kurbel.kernel.circle import Circle
from kurbel.notation import angle, number, ratio
from kurbel.printed_value import Printed
from kurbel.separation import Separation, circle_separation
from kurbel.source import SourceCell, SourceTable
from kurbel.verdict import RIGHT, Evidence, Verdict, verdict

if TYPE_CHECKING:
    from flint import arb

BALLS = Kind(ball, ball_circle, lambda value: value.log(), lambda value: 90 - ball_degrees(value))
BOUNDS = Kind(Separation.rational, lambda degrees: Circle(*circle_separation(degrees)))


class Truth(NamedTuple):
    """What a cell is: its ball at the precision in force, and its separation bound, None without one."""

    value: Callable[[], arb]
    bound: Callable[[], Separation] | None = None

    def in_units(self, printed: Printed) -> int:
        """Return how many units of the printed value's last place it is, rounded."""
        unit = printed.unit

        def tie_bits(boundary: Fraction) -> float:
            assert self.bound is not None
            return float((self.bound() - Separation.rational(boundary * unit)).bits())

        ties: TieBits | None = NEVER_TIES if self.bound is None else tie_bits
        return rounded(lambda: self.value() / ball(unit), 0, "half-away", ties)


class Collated(NamedTuple):
    """A printed value with what it should be, by how many units of the last place it is off, and why."""

    cell: SourceCell
    printed: Printed
    recomputed: str
    off: int
    verdict: Verdict


class Collation:
    """A table of a book with its values recomputed, each once."""

    def __init__(self, table: SourceTable) -> None:
        self.table = table
        self._by_place = {cell.place: cell for cell in table.cells}
        self._done: dict[str, Collated] = {}

    def __iter__(self) -> Iterator[Collated]:
        for cell in self.table.cells:
            if cell.printed is not None:
                yield self.collated(cell.place)

    def collated(self, name: str) -> Collated:
        """Return the cell of this place with its verdict."""
        if name not in self._done:
            self._done[name] = self._collate(self._by_place[name])
        return self._done[name]

    def _collate(self, cell: SourceCell) -> Collated:
        printed = cell.printed
        assert printed is not None
        try:
            right = self._right(cell, printed)
            evidence = Evidence(printed, right, self._others(cell, printed), *self._way(cell, printed))
            recomputed, off = printed.standing_for(right), printed.scaled - right
            return Collated(cell, printed, recomputed, off, verdict(evidence))
        except NotationError as error:
            raise SourceError(f"{self.table.at(cell)}: {error}") from None

    def _right(self, cell: SourceCell, printed: Printed) -> int:
        truth = self.truth(cell)
        if not printed.exact:
            return truth.in_units(printed)
        # A quotient is right if it is the value itself, which for a rational one a bound tells.
        difference = Truth(lambda: truth.value() - ball(printed.value), truth.bound)
        finer = printed._replace(unit=printed.unit / 10**12)
        off = difference.in_units(finer)
        return printed.scaled if off == 0 else printed.scaled + (1 if off > 0 else -1)

    def truth(self, cell: SourceCell, method: str = "") -> Truth:
        """Return what the cell is, by the book's method or by another."""
        if cell.quantity:
            return quantity_truth(cell, method or cell.method)
        assert cell.formula is not None
        return self._of(cell.formula, lambda name: self.truth(self._by_place[name]))

    def _of(self, formula: Expression, cells: Callable[[str], Truth]) -> Truth:
        named = [cells(name) for name in formula.names]

        def bound(name: str) -> Separation:
            found = cells(name).bound
            assert found is not None
            return found()

        algebraic = not formula.transcendental and all(one.bound is not None for one in named)
        return Truth(
            lambda: formula.value(BALLS, lambda name: cells(name).value()),
            (lambda: formula.value(BOUNDS, bound)) if algebraic else None,
        )

    def _others(self, cell: SourceCell, printed: Printed) -> Mapping[str, Callable[[], int]]:
        """Return the values by the other methods, as far as they have formulas."""
        if not cell.quantity:
            return {}

        def other(method: str) -> Callable[[], int]:
            def value() -> int:
                try:
                    return self.truth(cell, method).in_units(printed)
                except KurbelError:
                    # This method has no formula here, so that it explains nothing.
                    return printed.scaled + 1

            return value

        return {method: other(method) for method in methods_of(cell.quantity) if method != cell.method}

    def _way(self, cell: SourceCell, printed: Printed) -> tuple[int | None, tuple[str, ...]]:
        """Return the value from what was printed before, and which of that is not right itself."""
        way = cell.way or cell.formula
        if way is None or not way.names:
            return None, ()
        before = {name: self._by_place[name].printed for name in way.names}
        if any(one is None for one in before.values()):
            return None, ()
        found = self._of(way, lambda name: _constant(before[name])).in_units(printed)
        slips = tuple(name for name in sorted(way.names) if self.collated(name).verdict.kind != RIGHT)
        return found, slips


def right_or_verdict(
    cell: SourceCell, printed: Printed, right: int, others: Mapping[str, Callable[[], int]]
) -> Collated:
    """Return a value of which nothing but the true one and those by other methods is known."""
    found = Verdict(RIGHT) if printed.scaled == right else verdict(Evidence(printed, right, others))
    return Collated(cell, printed, printed.standing_for(right), printed.scaled - right, found)


def _constant(printed: Printed | None) -> Truth:
    assert printed is not None
    value = printed.value
    return Truth(lambda: ball(value), lambda: Separation.rational(value))


# Quantities -----------------------------------------------------------------------------------------------


def methods_of(quantity: str) -> tuple[str, ...]:
    """Return the methods by which a quantity can be recomputed."""
    from kurbel.beam import registry as beam_registry
    from kurbel.engine_quantities import engine_registry
    from kurbel.quantities import METHODS

    if quantity in beam_registry():
        return ("exact", "approximate")
    return ("exact", "series", "weisbach") if quantity in engine_registry() else tuple(METHODS)


def quantity_truth(cell: SourceCell, method: str) -> Truth:
    """Return a quantity of the motion, of an engine or of a beam engine at the place of the cell."""
    from kurbel.beam import registry as beam_registry
    from kurbel.engine_quantities import engine_registry
    from kurbel.quantities import registry

    axes = cell.axes
    if "epsilon" in axes:
        choose(cell.quantity, engine_registry(), "quantity")
        return _engine_truth(cell, method)
    if "arm" in axes:
        choose(cell.quantity, beam_registry(), "quantity")
        return _beam_truth(cell, method)
    choose(cell.quantity, registry(), "quantity")
    for axis in ("ratio", "phi"):
        if axis not in axes:
            raise NotationError(f"{cell.place} has no {axis}, which the quantity {cell.quantity} needs")
    return motion_truth(cell.quantity, method, ratio(axes["ratio"]), angle(axes["phi"], "angle"))


def motion_truth(key: str, method: str, crank_ratio: Fraction, degrees: Fraction) -> Truth:
    """Return a quantity of the piston's motion at a crank angle."""
    from kurbel.problem import Crank
    from kurbel.quantities import METHODS, Numbers, numbers_of_balls, registry, value

    quantity, crank = registry()[key], Crank(crank_ratio)
    choose(method, METHODS, "method")
    if not quantity.available(crank):
        raise NotationError(f"the quantity {key} has a unit, and no lengths are known; choose one without")

    def run(circle: Any, numbers: Numbers) -> Any:
        return value(quantity, method, crank, circle, numbers)

    # A method without a formula is told here, before anything is computed.
    quantity.formula(method, crank, numbers_of_balls())
    bound = None
    if not quantity.transcendental(crank):
        circle = Circle(*circle_separation(degrees))
        bound = cache(lambda: run(circle, Numbers(Separation.rational)))
    return Truth(lambda: run(ball_circle(degrees), numbers_of_balls()), bound)


def _engine_truth(cell: SourceCell, method: str) -> Truth:
    from kurbel.engine_quantities import SPANS, Where, engine_registry

    quantity, spans = engine_registry()[cell.quantity], {name: span for span, (name, _) in SPANS.items()}
    stroke = spans[choose(cell.axes.get("stroke", "turn"), spans, "stroke")]
    turn = _turn(cell.axes["epsilon"], cell.axes.get("ratio", ""), method)
    where = Where(stroke)
    if not quantity.applies(where):
        raise NotationError(f"{cell.quantity} is no quantity of {cell.axes.get('stroke', 'turn')}")

    def value() -> Any:
        found = quantity.value(turn, where)
        return ball(found) if isinstance(found, Fraction) else found

    return Truth(value)


@cache
def _turn(epsilon: str, crank_ratio: str, method: str) -> Any:
    from kurbel.engine import Engine, Steam
    from kurbel.engine_request import ENGINE_METHODS
    from kurbel.problem import Crank
    from kurbel.turn import turn_of

    choose(method, ENGINE_METHODS, "method")
    return turn_of(Engine(Crank(ratio(crank_ratio)), Steam(number(epsilon, "expansion ratio"))), method)


def _beam_truth(cell: SourceCell, method: str) -> Truth:
    from kurbel.beam import MINUTES, BeamEngine, registry

    quantity = registry()[cell.quantity]
    choose(method, ("exact", "approximate"), "method")
    engine = BeamEngine(number(cell.axes["arm"], "beam arm"), ratio(cell.axes.get("ratio", "")))
    share = Fraction(1, 60) if quantity.unit == MINUTES else Fraction(1)
    return Truth(lambda: quantity.value(engine, method == "exact") * ball(share))
