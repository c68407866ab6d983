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
from collections.abc import Callable, Collection, Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from kurbel.books.collation import Collated, cell_truth, collate, collated_units, others_of
from kurbel.books.printed_value import Printed, printed_value
from kurbel.books.source import SourceCell
from kurbel.books.truth import methods_of
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, KurbelError, NotationError, ProblemError, SourceError
from kurbel.motion.digits import columns_in_balls, columns_in_floats, is_long
from kurbel.motion.evaluation import METHODS, is_known
from kurbel.motion.quantities import registry
from kurbel.page.quantity import bare, words
from kurbel.reading.choices import choose
from kurbel.reading.csv_columns import Head, read_rows, whole_head
from kurbel.reading.csv_lines import Kind, place, shown
from kurbel.reading.notation import angle, number, ratio, ratio_text

_METHODS = (*METHODS, "weisbach", "approximate")
KIND = Kind("transcription", "angle", SourceError)


class Own:
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

    head: str
    quantity: str
    ratio: Fraction


class _Axis(NamedTuple):
    """What the first column counts: its heads, what a value is called and how it is read, its quantities."""

    key: str
    heads: tuple[str, ...]
    name: str
    read: Callable[[str], Fraction]
    quantities: Callable[[], Collection[str]]


def _of_motion() -> Collection[str]:
    return [name for name, one in registry().items() if is_known(one, Crank(Fraction(1, 5)))]


def _of_engines() -> Collection[str]:
    from kurbel.engine.quantities import engine_registry

    return engine_registry()


def _of_beams() -> Collection[str]:
    from kurbel.linkage.beam import registry as beam_registry

    return beam_registry()


_AXES = (
    _Axis("phi", ("phi", "φ"), "angle", lambda text: angle(text, "angle"), _of_motion),
    _Axis("epsilon", ("epsilon", "eps", "ε"), "expansion ratio",
          lambda text: number(text, "expansion ratio"), _of_engines),
    _Axis("arm", ("arm", "beam", "a:r"), "beam arm", lambda text: number(text, "beam arm"), _of_beams),
)  # fmt: skip


class _Point(NamedTuple):
    line: int
    at: Fraction
    text: str
    printed: Printed


def collated_table(
    table: str | None,
    file: str | os.PathLike[str] | None,
    quantity: str | None,
    crank_ratio: str | None,
    method: str | None,
    folder: str | os.PathLike[str] | None,
) -> tuple[Any, tuple[Collated, ...]]:
    """Return a book's table, or what stands for one's own, with its collated values."""
    from kurbel.books.collation import Collation
    from kurbel.books.source import source_tables

    if file is not None:
        if folder is not None:
            raise ProblemError("--sources is for tables of books, and --csv is your own; leave one out")
        return collated_file(file, quantity, crank_ratio, method)
    if not (quantity is None and crank_ratio is None and method is None):
        raise ProblemError(
            "quantity, ratio and method are for your own transcription, --csv; a book's table has its own"
        )
    tables = source_tables(folder)
    if table is None:
        raise ProblemError(f"name a table, such as roetscher-112, or --csv; kurbel has {', '.join(tables)}")
    found = tables[choose(table, tables, "table")]
    return found, tuple(Collation(found))


def collated_file(
    path: str | os.PathLike[str], quantity: str | None, crank_ratio: str | None, method: str | None
) -> tuple[Any, tuple[Collated, ...]]:
    """Return what stands for the table, and its collated values in the order of the file's columns."""
    chosen = choose("exact" if method is None else method, _METHODS, "method")
    asked = None if crank_ratio is None else ratio(crank_ratio)
    if asked is not None:
        Crank(asked)
    axis, columns, points = _read(path, None if quantity is None else known_quantity(quantity), asked)
    for column in columns:
        choose(chosen, methods_of(column.quantity), "method")
    collated: list[Collated] = []
    for column, values in zip(columns, points, strict=True):
        collated += _collated(path, axis, column, values, chosen)
    if not collated:
        raise SourceError(f"{shown(path)} has no printed value below its heads")
    return Own(Path(path).name), tuple(collated)


def _collated(
    path: str | os.PathLike[str], axis: _Axis, column: _Column, points: Sequence[_Point], method: str
) -> Iterator[Collated]:
    rights = _rights(column, points, method) if axis.key == "phi" else {}
    for index, point in enumerate(points):
        cell = SourceCell(
            f"line_{point.line}",
            point.printed,
            column.quantity,
            {"ratio": ratio_text(column.ratio), axis.key: point.text},
            method,
            None,
            None,
            "",
            point.line,
        )
        try:
            if index in rights:
                wrong = rights[index] != point.printed.scaled
                yield collated_units(cell, point.printed, rights[index], others_of(cell) if wrong else {})
            else:
                yield collate(cell, point.printed, cell_truth(cell, method), others_of(cell))
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
        self.columns = _columns(self.axis, names, self.quantity, self.crank_ratio)
        self.points = [[] for _ in self.columns]
        return head

    def row(self, texts: list[str], head: Head, line: int) -> None:
        first, *others = texts
        at = self.axis.read(first)
        if at in self.seen:
            raise NotationError(f"the {self.axis.name} {first} stands in line {self.seen[at]} already")
        self.seen[at] = line
        for values, text in zip(self.points, others, strict=True):
            if text:
                values.append(_Point(line, at, first, printed_value(text)))


def _read(
    path: str | os.PathLike[str], quantity: str | None, crank_ratio: Fraction | None
) -> tuple[_Axis, list[_Column], list[list[_Point]]]:
    read, starts = _Read(quantity, crank_ratio), "it starts with its heads, phi and a ratio or a quantity"
    for _ in read_rows(path, KIND, read.head, read.row, starts, slice(1, None), ChoiceError):
        pass
    return read.axis, read.columns, read.points


def known_quantity(key: str) -> str:
    """Return the key of a quantity that its axis and the ratio settle."""
    if key in registry() and not is_known(registry()[key], Crank(Fraction(1, 5))):
        raise ProblemError(f"the quantity {key} has a unit, and no lengths are known; choose one without")
    return choose(key, [name for axis in _AXES for name in axis.quantities()], "quantity")


def _axis(head: str) -> _Axis:
    for axis in _AXES:
        if head.casefold() in axis.heads:
            return axis
    raise NotationError(
        f'the first head is "{head[:40]}"; it must be phi, the crank angle, epsilon, the expansion ratio,'
        " or arm, that of the beam"
    )


def _columns(
    axis: _Axis, heads: Sequence[str], quantity: str | None, crank_ratio: Fraction | None
) -> list[_Column]:
    if len(heads) < 2:
        raise NotationError(f"there is no column of printed values beside {heads[0]}")
    columns = [_column(axis, head, len(heads) == 2, quantity, crank_ratio) for head in heads[1:]]
    for column in columns:
        if [(one.quantity, one.ratio) for one in columns].count((column.quantity, column.ratio)) > 1:
            said = f"{column.quantity} at R:L = {ratio_text(column.ratio)}"
            raise NotationError(f"there are two columns of {said}")
    return columns


def _column(
    axis: _Axis, head: str, alone: bool, quantity: str | None, crank_ratio: Fraction | None
) -> _Column:
    """Return whose column it is; what the head says must be what was given."""
    own_ratio = ratio(head) if ":" in head else None
    own_quantity = known_quantity(head) if head in (*registry(), *axis.quantities()) else None
    if own_ratio is None and own_quantity is None and not alone:
        raise NotationError(f'the head "{head[:40]}" is neither a crank ratio nor a quantity, such as p')
    key = own_quantity or quantity
    if key is None:
        raise ProblemError("what is printed is not known; add --quantity, for example --quantity p")
    if key not in axis.quantities():
        raise ProblemError(f"the quantity {key} does not go by {axis.name}s, as the file does")
    if quantity not in (None, key):
        raise ProblemError(f"the file has a column headed {key}, and --quantity is {quantity}; leave one out")
    value = crank_ratio if own_ratio is None else own_ratio
    if value is None:
        raise ProblemError("the crank ratio is not known; add --ratio, for example --ratio 1:5")
    if crank_ratio not in (None, value):
        raise ProblemError(f"the file has a column headed {head}, and --ratio is another; leave one out")
    Crank(value)
    return _Column(head, key, value)
