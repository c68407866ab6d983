"""Printed values against recomputed ones: the true value of each cell, other methods' values, the verdict.

A true value is rounded once to the last place that is printed, half away from zero; every digit is certified.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from kurbel.books.printed_value import Printed, Units
from kurbel.books.quantities import AXES, methods_of, quantity_truth
from kurbel.books.source import SourceCell, SourceTable
from kurbel.books.truth import Truth, formula_truth, kept
from kurbel.books.verdict import ROUNDINGS, Evidence, Verdict, verdict
from kurbel.errors import KurbelError, SourceError


class Collated(NamedTuple):
    """A printed value with what it should be, by how many units of the last place it is off, and why.

    `off` is None for a quotient that is not right, which has no last place.
    """

    cell: SourceCell
    printed: Printed
    recomputed: str
    off: int | None
    verdict: Verdict


class Collation:
    """A table of a book with its values recomputed, each once."""

    def __init__(self, table: SourceTable) -> None:
        self.table = table
        self._by_place = {cell.place: cell for cell in table.cells}
        self._done: dict[str, Collated] = {}
        self._truths: dict[str, Truth] = {}

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
        try:
            return collate(cell, self.truth(cell), *self._way(cell))
        except KurbelError as error:
            if isinstance(error, SourceError):
                raise
            raise SourceError(f"{self.table.at(cell)}: {cell.place}: {error}") from None

    def truth(self, cell: SourceCell) -> Truth:
        """Return what the cell is, by the book's method."""
        if cell.place not in self._truths:
            self._truths[cell.place] = kept(self._truth(cell))
        return self._truths[cell.place]

    def _truth(self, cell: SourceCell) -> Truth:
        if cell.quantity:
            return cell_truth(cell, cell.method)
        assert cell.formula is not None
        return formula_truth(cell.formula, self._truth_at)

    def _truth_at(self, place: str) -> Truth:
        return self.truth(self._by_place[place])

    def _way(self, cell: SourceCell) -> tuple[Truth | None, tuple[str, ...]]:
        """Return the value from what was printed before, and what of that is neither right nor rounded."""
        way = cell.way or cell.formula
        if way is None or not way.names:
            return None, ()
        printed = {name: self._by_place[name].printed for name in way.names}
        before = {name: one.value for name, one in printed.items() if one is not None}
        if len(before) < len(printed):
            return None, ()
        slips = (name for name in sorted(way.names) if self.collated(name).verdict.kind not in ROUNDINGS)
        return formula_truth(way.with_numbers(before), self._truth_at), tuple(slips)


def collate(
    cell: SourceCell, truth: Truth, way: Truth | None = None, slips: tuple[str, ...] = ()
) -> Collated:
    """Return a printed value with its verdict, from its true value and that of its way."""
    printed = cell.printed
    assert printed is not None
    right, on_the_way = truth.in_units(printed), way and way.in_units(printed)
    shown = ""
    if printed.exact and truth.rational is None and right != printed.scaled:
        shown = truth.written_as(Printed("", 0, Fraction(1, 10**6), ",")).text
    coarser = printed.coarser()
    return collated_units(cell, right, on_the_way, slips, shown, lambda: truth.in_units(coarser))


def collated_units(
    cell: SourceCell,
    right: Units | None,
    on_the_way: Units | None = None,
    slips: tuple[str, ...] = (),
    shown: str = "",
    coarsely: Callable[[], Units | None] | None = None,
) -> Collated:
    """Return a value that is so many units of its last place by rights, with its verdict.

    `shown` is what it should be where no quotient is known to be, `coarsely` the value in the coarser place.
    """
    printed = cell.printed
    assert printed is not None
    methods = methods_of(cell.quantity) if cell.quantity else ()
    others = {
        method: partial(_units_by, cell, method, printed) for method in methods if method != cell.method
    }
    coarsely = coarsely or partial(_units_by, cell, cell.method, printed.coarser())
    found = verdict(Evidence(printed, right, others, on_the_way, slips, coarsely))
    in_places = right is not None and (not printed.exact or right == printed.scaled)
    off = int(printed.scaled - right) if right is not None and in_places else None
    return Collated(cell, printed, shown or printed.standing_for(right or 0), off, found)


def _units_by(cell: SourceCell, method: str, like: Printed) -> Units | None:
    """Return what the cell is by a method in the unit of `like`, None where that has no formula for it."""
    try:
        truth = cell_truth(cell, method)
    except KurbelError:
        return None
    return truth.in_units(like)


def cell_truth(cell: SourceCell, method: str) -> Truth:
    """Return what the quantity of a cell is by a method."""
    at = {axis: AXES[axis].read(text) for axis, text in cell.axes.items()}
    return quantity_truth(cell.quantity, method, at)
