"""A transcription of one's own: printed values from a CSV file, collated with a quantity.

    phi;1:4;1:5
    30;0,981;0,966
    2°30';...

The first column is headed `phi`, `epsilon` for quantities of the steam engine, or `arm` for those of the beam
engine. The others are headed by the crank ratio or by a quantity's key, or by
anything where there is but one and quantity and ratio are given. Semicolons, tabs or commas part the columns;
a decimal comma is read where commas do not part. Empty fields are values that the book has not.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from kurbel.books.book_values import AXES, FAMILIES, keys_by, methods_of
from kurbel.books.collation import CollatedValue, Collation, cell_truth, collate, collated_units
from kurbel.books.printed_value import PrintedValue, printed_value
from kurbel.books.source import SourceCell, SourceTable, all_tables
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, KurbelError, NotationError, ProblemError, SourceError
from kurbel.motion.bulk import columns_in_floats, is_long
from kurbel.motion.evaluation import METHODS, columns_in_balls, is_known
from kurbel.motion.motion_quantities import registry
from kurbel.page.quantity import bare, words
from kurbel.reading.csv_file import Head, Kind, place, read_rows, shown, whole_head
from kurbel.reading.given import allowed_name, choose
from kurbel.reading.names import otherwise
from kurbel.reading.notation import ratio, ratio_text

_METHODS = (*METHODS, "weisbach", "approximate")
KIND = Kind("transcription", "angle", SourceError)


class OwnTable:
    """What stands for a book's table where the values are one's own."""

    def __init__(self, name: str) -> None:
        self.key = "collation"
        said = name.replace("$", r"\$").replace("[^", "[")
        self.title = {"de": f"Kollation von {said}", "en": f"Collation of {said}"}
        self.notes: dict[str, Sequence[str]] = {"de": [], "en": []}
        self.layout = ""
        self.book = self
        self.citation = words("")


class _Column(NamedTuple):
    """A column of printed values: whose quantity and ratio it is."""

    quantity: str
    ratio: Fraction


# The heads of a first column, by the axis that it has.
_HEADS = {"phi": ("phi", "φ"), "epsilon": ("epsilon", "eps", "ε"), "arm": ("arm", "beam", "a:r")}


class _Point(NamedTuple):
    line: int
    at: Fraction
    text: str
    printed: PrintedValue


def collated_table(
    table: str | None,
    file: str | os.PathLike[str] | None,
    quantity: str | None,
    crank_ratio: str | None,
    method: str | None,
    folder: str | os.PathLike[str] | None,
) -> tuple[Any, tuple[Any, ...]]:
    """Return a book's table, or what stands for one's own, with its collated values or formulas."""
    if file is not None:
        if folder is not None:
            raise ProblemError("--sources is for tables of books, and --csv is your own; leave one out")
        return collated_file(file, quantity, crank_ratio, method)
    if not (quantity is None and crank_ratio is None and method is None):
        raise ProblemError(
            "quantity, ratio and method are for your own transcription, --csv; a book's table has its own"
        )
    tables = all_tables(folder)
    if table is None:
        raise ProblemError(f"name a table, such as roetscher-112, or --csv; kurbel has {', '.join(tables)}")
    found = tables[allowed_name(table, tables, "table")]
    return found, tuple(Collation(found) if isinstance(found, SourceTable) else found.collated())


def collated_file(
    path: str | os.PathLike[str], quantity: str | None, crank_ratio: str | None, method: str | None
) -> tuple[OwnTable, tuple[CollatedValue, ...]]:
    """Return what stands for the table, and its collated values in the order of the file's columns."""
    chosen = choose("exact" if method is None else method, _METHODS, "method")
    asked = None if crank_ratio is None else ratio(crank_ratio)
    if asked is not None:
        Crank(asked)
    read = _Read(None if quantity is None else known_quantity(quantity), asked)
    starts = "it starts with its heads, phi and a ratio or a quantity"
    for _ in read_rows(path, KIND, read.head, read.row, starts, slice(1, None), ChoiceError):
        pass
    for column in read.columns:
        choose(chosen, methods_of(column.quantity), "method")
    collated: list[CollatedValue] = []
    for column, values in zip(read.columns, read.points, strict=True):
        collated += _collated(path, read.axis, column, values, chosen)
    if not collated:
        raise SourceError(f"{shown(path)} has no printed value below its heads")
    return OwnTable(Path(path).name), tuple(collated)


def _collated(
    path: str | os.PathLike[str], axis: str, column: _Column, points: Sequence[_Point], method: str
) -> Iterator[CollatedValue]:
    rights = _rights(column, points, method) if axis == "phi" else {}
    for index, point in enumerate(points):
        at = {"ratio": ratio_text(column.ratio), axis: point.text}
        cell = SourceCell(f"line_{point.line}", point.printed, column.quantity, at, method, point.line)
        try:
            if index in rights:
                yield collated_units(cell, rights[index])
            else:
                yield collate(cell, cell_truth(cell, method))
        except KurbelError as error:
            raise SourceError(f"{place(shown(path), point.line)}: {error}") from None


def _rights(column: _Column, points: Sequence[_Point], method: str) -> dict[int, int]:
    """Return the true values of decimal fractions in units of their last places, many of one kind at once."""
    found: dict[int, int] = {}
    quantity, crank = registry()[column.quantity], Crank(column.ratio)
    by_decimals: dict[int, list[int]] = {}
    for index, point in enumerate(points):
        if point.printed.form in (",", "."):
            by_decimals.setdefault(point.printed.decimals, []).append(index)
    for decimals, indices in by_decimals.items():
        digits, angles = [bare(quantity, method, decimals)], [points[index].at for index in indices]
        compute = columns_in_floats if is_long(digits, [crank], angles) else columns_in_balls
        (values,) = compute(digits, crank, angles, "half-away")
        found |= dict(zip(indices, map(int, values), strict=True))
    return found


class _Read:
    """The file as it is read: its axis and its columns, each with its points."""

    def __init__(self, quantity: str | None, crank_ratio: Fraction | None) -> None:
        self.quantity = quantity
        self.crank_ratio = crank_ratio
        self.points: list[list[_Point]] = []
        self.seen: dict[Fraction, int] = {}

    def head(self, line: str) -> Head:
        head = whole_head(line)
        names = [column.name for column in head.columns]
        self.axis = _axis(names[0])
        if len(names) < 2:
            raise NotationError(f"there is no column of printed values beside {names[0]}")
        self.columns = [self._column(name, len(names) == 2) for name in names[1:]]
        for column in self.columns:
            if self.columns.count(column) > 1:
                said = f"{column.quantity} at R:L = {ratio_text(column.ratio)}"
                raise NotationError(f"there are two columns of {said}")
        self.points = [[] for _ in self.columns]
        return head

    def _column(self, head: str, alone: bool) -> _Column:
        """Return whose column it is; what the head says must be what was given."""
        axis, quantity, crank_ratio = self.axis, self.quantity, self.crank_ratio
        own_ratio = ratio(head) if ":" in head else None
        own_quantity = self._own_quantity(head)
        if own_ratio is None and own_quantity is None and not alone:
            raise NotationError(f'the head "{head[:40]}" is neither a crank ratio nor a quantity, such as p')
        key = own_quantity or quantity
        if key is None:
            raise ProblemError("what is printed is not known; add --quantity, for example --quantity p")
        if key not in keys_by(axis):
            raise ProblemError(f"the quantity {key} does not go by {AXES[axis].name}s, as the file does")
        if quantity not in (None, key):
            raise ProblemError(
                f"the file has a column headed {key}, and --quantity is {quantity}; leave one out"
            )
        value = crank_ratio if own_ratio is None else own_ratio
        if value is None:
            raise ProblemError("the crank ratio is not known; add --ratio, for example --ratio 1:5")
        if crank_ratio not in (None, value):
            raise ProblemError(f"the file has a column headed {head}, and --ratio is another; leave one out")
        Crank(value)
        return _Column(key, value)

    def _own_quantity(self, head: str) -> str | None:
        """Return the quantity that a head names, by any word for it where none was given."""
        keys = (*registry(), *keys_by(self.axis))
        if head in keys:
            return known_quantity(head)
        found = otherwise(head, keys) if self.quantity is None else None
        return known_quantity(found) if found else None

    def row(self, texts: list[str], head: Head, line: int) -> None:
        first, *others = texts
        at = AXES[self.axis].read(first)
        if at in self.seen:
            raise NotationError(f"the {AXES[self.axis].name} {first} stands in line {self.seen[at]} already")
        self.seen[at] = line
        for values, text in zip(self.points, others, strict=True):
            if text:
                values.append(_Point(line, at, first, printed_value(text)))


def known_quantity(key: str) -> str:
    """Return the key of a quantity that its axis and the ratio settle."""
    if key in registry() and not is_known(registry()[key], Crank(Fraction(1, 5))):
        raise ProblemError(f"the quantity {key} has a unit, and no lengths are known; choose one without")
    return allowed_name(key, dict.fromkeys(name for axis in FAMILIES for name in keys_by(axis)), "quantity")


def _axis(head: str) -> str:
    for axis, heads in _HEADS.items():
        if head.casefold() in heads:
            return axis
    raise NotationError(
        f'the first head is "{head[:40]}"; it must be phi, the crank angle, epsilon, the expansion ratio,'
        " or arm, that of the beam"
    )
