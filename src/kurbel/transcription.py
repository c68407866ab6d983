"""A transcription of one's own: crank angles and printed values from a CSV file, collated with a quantity.

    phi;1:4;1:5
    30;0,981;0,966
    2°30';...

The first column is headed `phi`. The others are headed by the crank ratio or by a quantity's key, or by
anything where there is but one and quantity and ratio are given. Semicolons, tabs or commas part the columns;
a decimal comma is read where commas do not part. Empty fields are values that the book has not.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from kurbel.choices import choose
from kurbel.collation import Collated, motion_truth, right_or_verdict
from kurbel.csv_columns import decimal_marks, read_row, whole_head
from kurbel.csv_lines import Kind, place, said_lines, shown
from kurbel.digits import Digits, columns_in_balls, columns_in_floats, is_long
from kurbel.errors import KurbelError, NotationError, ProblemError, SourceError
from kurbel.notation import angle, ratio, ratio_text
from kurbel.printed_value import Printed, printed_value
from kurbel.problem import Crank
from kurbel.quantities import METHODS, registry
from kurbel.source import SourceCell

KIND = Kind("transcription", "angle", SourceError)


class Own:
    """What stands for a book's table where the values are one's own."""

    def __init__(self, name: str) -> None:
        self.key = "collation"
        self.title = {"de": f"Kollation von {name}", "en": f"Collation of {name}"}
        self.notes: dict[str, Sequence[str]] = {"de": [], "en": []}
        self.layout = ""
        self.book = self
        self.citation = {"de": "", "en": ""}


class _Column(NamedTuple):
    """A column of printed values: whose quantity and ratio it is."""

    head: str
    quantity: str
    ratio: Fraction


class _Point(NamedTuple):
    line: int
    angle: Fraction
    text: str
    printed: Printed


def collated_table(
    table: str | None,
    file: str | os.PathLike[str] | None,
    quantity: str | None,
    crank_ratio: str | None,
    method: str | None,
    folder: str | None,
) -> tuple[Any, tuple[Collated, ...]]:
    """Return a book's table, or what stands for one's own, with its collated values."""
    from kurbel.collation import Collation
    from kurbel.source import source_tables

    if file is not None:
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
    chosen = choose("exact" if method is None else method, METHODS, "method")
    columns, points = _read(path, quantity, crank_ratio)
    collated = [
        one
        for column, values in zip(columns, points, strict=True)
        for one in _collated(column, values, chosen)
    ]
    if not collated:
        raise SourceError(f"{shown(path)} has no printed value below its heads")
    return Own(Path(path).name), tuple(collated)


def _collated(column: _Column, points: Sequence[_Point], method: str) -> Iterator[Collated]:
    rights = _rights(column, points, method)
    for point, right in zip(points, rights, strict=True):
        cell = SourceCell(
            f"line_{point.line}",
            point.printed,
            column.quantity,
            {"ratio": ratio_text(column.ratio), "phi": point.text},
            method,
            None,
            None,
            "",
            point.line,
        )
        others = {
            other: (lambda other=other, point=point: motion_truth(
                column.quantity, other, column.ratio, point.angle).in_units(point.printed))
            for other in METHODS
            if other != method and other in registry()[column.quantity].formulas
        }  # fmt: skip
        yield right_or_verdict(cell, point.printed, right, others)


def _rights(column: _Column, points: Sequence[_Point], method: str) -> list[int]:
    """Return the true values in units of the last places printed, many of one kind at once."""
    found: dict[int, int] = {}
    quantity, crank = registry()[column.quantity], Crank(column.ratio)
    by_decimals: dict[int, list[int]] = {}
    for index, point in enumerate(points):
        if point.printed.form not in (",", "."):
            truth = motion_truth(column.quantity, method, column.ratio, point.angle)
            found[index] = truth.in_units(point.printed)
        else:
            by_decimals.setdefault(point.printed.decimals, []).append(index)
    for decimals, indices in by_decimals.items():
        digits, angles = [Digits(quantity, method, decimals)], [points[index].angle for index in indices]
        compute = columns_in_floats if is_long(digits, [crank], angles) else columns_in_balls
        (values,) = compute(digits, crank, angles, "half-away")
        found |= dict(zip(indices, map(int, values), strict=True))
    return [found[index] for index in range(len(points))]


def _read(
    path: str | os.PathLike[str], quantity: str | None, crank_ratio: str | None
) -> tuple[list[_Column], list[list[_Point]]]:
    name, head, columns, marks = shown(path), None, [], ""
    points: list[list[_Point]] = []
    seen: dict[Fraction, int] = {}
    for number, line in said_lines(path, KIND):
        try:
            if head is None:
                head = whole_head(line)
                columns = _columns([column.name for column in head.columns], quantity, crank_ratio)
                points = [[] for _ in columns]
                continue
            first, *texts = read_row(line, head)
            marks = decimal_marks(texts, marks)
            degrees = angle(first, "angle")
            if degrees in seen:
                raise NotationError(f"the angle {first} stands in line {seen[degrees]} already")
            seen[degrees] = number
            for values, text in zip(points, texts, strict=True):
                if text:
                    values.append(_Point(number, degrees, first, printed_value(text)))
        except KurbelError as error:
            raise SourceError(f"{place(name, number)}: {error}") from None
    if head is None:
        raise SourceError(f"{name} is empty; it starts with its heads, phi and a ratio or a quantity")
    return columns, points


def _columns(heads: Sequence[str], quantity: str | None, crank_ratio: str | None) -> list[_Column]:
    if heads[0].casefold() not in ("phi", "φ"):
        raise NotationError(f'the first head is "{heads[0][:40]}"; it must be phi, the crank angle')
    if len(heads) < 2:
        raise NotationError("there is no column of printed values beside phi")
    return [_column(head, len(heads) == 2, quantity, crank_ratio) for head in heads[1:]]


def _column(head: str, alone: bool, quantity: str | None, crank_ratio: str | None) -> _Column:
    """Return whose column it is: a head that is a ratio or a quantity goes before what was given."""
    own_ratio, own_quantity = _ratio(head), head if head in registry() else None
    if own_ratio is None and own_quantity is None and not alone:
        raise NotationError(f'the head "{head[:40]}" is neither a crank ratio nor a quantity, such as p')
    key, text = own_quantity or quantity, crank_ratio
    if key is None:
        raise ProblemError("what is printed is not known; add --quantity, for example --quantity p")
    if own_ratio is None and text is None:
        raise ProblemError("the crank ratio is not known; add --ratio, for example --ratio 1:5")
    known = choose(key, registry(), "quantity")
    value = ratio(text or "") if own_ratio is None else own_ratio
    if not registry()[known].available(Crank(value)):
        raise ProblemError(f"the quantity {known} has a unit, and no lengths are known; choose one without")
    return _Column(head, known, value)


def _ratio(head: str) -> Fraction | None:
    if ":" not in head:
        return None
    return ratio(head)
