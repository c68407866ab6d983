"""Printed values against recomputed ones: the true value of each cell, other methods' values, the verdict.

A true value is rounded once to the last place that is printed, half away from zero; every digit is certified.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from kurbel.books.printed_value import Printed
from kurbel.books.source import SourceCell, SourceTable
from kurbel.books.truth import Truth, constant, formula_truth, kept, methods_of, quantity_truth
from kurbel.books.verdict import RIGHT, Evidence, Verdict, quotient_verdict, verdict
from kurbel.errors import KurbelError, SourceError
from kurbel.reading.notation import angle, number, ratio

# How the axes of a cell are read.
READERS: Mapping[str, Callable[[str], Fraction | str]] = {
    "ratio": ratio,
    "phi": lambda text: angle(text, "angle"),
    "epsilon": lambda text: number(text, "expansion ratio"),
    "arm": lambda text: number(text, "beam arm"),
    "stroke": str,
}


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
        printed = cell.printed
        assert printed is not None
        try:
            truth, others, way = self.truth(cell), others_of(cell), self._way(cell)
            return collate(cell, printed, truth, others, *way)
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
        return formula_truth(cell.formula, lambda name: self.truth(self._by_place[name]))

    def _way(self, cell: SourceCell) -> tuple[Truth | None, tuple[str, ...]]:
        """Return the value from what was printed before, and which of that is not right itself."""
        way = cell.way or cell.formula
        if way is None or not way.names:
            return None, ()
        printed = {name: self._by_place[name].printed for name in way.names}
        before = {name: one.value for name, one in printed.items() if one is not None}
        if len(before) < len(printed):
            return None, ()
        found = formula_truth(way, lambda name: constant(before[name]))
        slips = tuple(name for name in sorted(way.names) if self.collated(name).verdict.kind != RIGHT)
        return found, slips


def collate(
    cell: SourceCell,
    printed: Printed,
    truth: Truth,
    others: Mapping[str, Callable[[], Truth | None]],
    way: Truth | None = None,
    slips: tuple[str, ...] = (),
) -> Collated:
    """Return a printed value with its verdict, from its true value, those by other methods and of its way."""
    if not printed.exact:
        found = None if way is None else way.in_units(printed)
        return collated_units(cell, printed, truth.in_units(printed), others, found, slips)
    return Collated(cell, printed, *_collated_quotient(printed, truth, others, way, slips))


def collated_units(
    cell: SourceCell,
    printed: Printed,
    right: int,
    others: Mapping[str, Callable[[], Truth | None]],
    on_the_way: int | None = None,
    slips: tuple[str, ...] = (),
) -> Collated:
    """Return a value with a last place, which is so many units of it by rights, with its verdict."""

    def in_units(other: Callable[[], Truth | None]) -> Callable[[], int | None]:
        def units() -> int | None:
            found = other()
            return None if found is None else found.in_units(printed)

        return units

    by_others = {method: in_units(other) for method, other in others.items()}
    found = verdict(Evidence(printed, right, by_others, on_the_way, slips))
    return Collated(cell, printed, printed.standing_for(right), printed.scaled - right, found)


def _collated_quotient(
    printed: Printed,
    truth: Truth,
    others: Mapping[str, Callable[[], Truth | None]],
    way: Truth | None,
    slips: tuple[str, ...],
) -> tuple[str, int | None, Verdict]:
    """Return what a quotient should be, 0 where it is right, and the verdict.

    It has no last place, and is right only as the value itself.
    """
    value = printed.value
    if truth.equals(value):
        return printed.text, 0, Verdict(RIGHT)
    if truth.rational is not None:
        standing = str(truth.rational)
    else:
        decimals = Printed("", 0, Fraction(1, 10**6), ",")
        standing = decimals.standing_for(truth.in_units(decimals))
    found = quotient_verdict(
        printed.text,
        standing if truth.rational is not None else "",
        truth.equals(-value),
        [name for name, other in others.items() if (by := other()) is not None and by.equals(value)],
        way is not None and way.equals(value),
        slips,
    )
    return standing, None, found


def others_of(cell: SourceCell) -> Mapping[str, Callable[[], Truth | None]]:
    """Return what the cell is by the other methods, None where one has no formula for it."""
    if not cell.quantity:
        return {}

    def other(method: str) -> Callable[[], Truth | None]:
        def truth() -> Truth | None:
            try:
                return cell_truth(cell, method)
            except KurbelError:
                return None

        return truth

    return {method: other(method) for method in methods_of(cell.quantity) if method != cell.method}


def cell_truth(cell: SourceCell, method: str) -> Truth:
    """Return what the quantity of a cell is by a method."""
    return quantity_truth(
        cell.quantity, method, {axis: READERS[axis](text) for axis, text in cell.axes.items()}
    )
