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
from kurbel.collation import Collated, collate, collated_units, motion_truth
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
        said = name.replace("$", r"\$").replace("[^", "[")
        self.title = {"de": f"Kollation von {said}", "en": f"Collation of {said}"}
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
    chosen = choose("exact" if method is None else method, METHODS, "method")
    asked = None if crank_ratio is None else ratio(crank_ratio)
    if asked is not None:
        Crank(asked)
    columns, points = _read(path, None if quantity is None else known_quantity(quantity), asked)
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
    for index, point in enumerate(points):
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
                column.quantity, other, column.ratio, point.angle))
            for other in METHODS
            if other != method and other in registry()[column.quantity].formulas
        }  # fmt: skip
        if index in rights:
            yield collated_units(cell, point.printed, rights[index], others)
        else:
            truth = motion_truth(column.quantity, method, column.ratio, point.angle)
            yield collate(cell, point.printed, truth, others)


def _rights(column: _Column, points: Sequence[_Point], method: str) -> dict[int, int]:
    """Return the true values of decimal fractions in units of their last places, many of one kind at once."""
    found: dict[int, int] = {}
    quantity, crank = registry()[column.quantity], Crank(column.ratio)
    by_decimals: dict[int, list[int]] = {}
    for index, point in enumerate(points):
        if point.printed.form in (",", "."):
            by_decimals.setdefault(point.printed.decimals, []).append(index)
    for decimals, indices in by_decimals.items():
        digits, angles = [Digits(quantity, method, decimals)], [points[index].angle for index in indices]
        compute = columns_in_floats if is_long(digits, [crank], angles) else columns_in_balls
        (values,) = compute(digits, crank, angles, "half-away")
        found |= dict(zip(indices, map(int, values), strict=True))
    return found


def _read(
    path: str | os.PathLike[str], quantity: str | None, crank_ratio: Fraction | None
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
        except ProblemError:
            raise
        except KurbelError as error:
            raise SourceError(f"{place(name, number)}: {error}") from None
    if head is None:
        raise SourceError(f"{name} is empty; it starts with its heads, phi and a ratio or a quantity")
    return columns, points


def known_quantity(key: str) -> str:
    """Return the key of a quantity that crank angle and ratio settle."""
    from kurbel.beam import registry as beam_registry
    from kurbel.engine_quantities import engine_registry

    if key in {*engine_registry(), *beam_registry()} - {*registry()}:
        raise ProblemError(f"the quantity {key} does not go by crank angles, as the values of --csv do")
    if key in registry() and not registry()[key].available(Crank(Fraction(1, 5))):
        raise ProblemError(f"the quantity {key} has a unit, and no lengths are known; choose one without")
    unitless = [name for name, one in registry().items() if one.available(Crank(Fraction(1, 5)))]
    return choose(key, unitless, "quantity")


def _columns(heads: Sequence[str], quantity: str | None, crank_ratio: Fraction | None) -> list[_Column]:
    if heads[0].casefold() not in ("phi", "φ"):
        raise NotationError(f'the first head is "{heads[0][:40]}"; it must be phi, the crank angle')
    if len(heads) < 2:
        raise NotationError("there is no column of printed values beside phi")
    columns = [_column(head, len(heads) == 2, quantity, crank_ratio) for head in heads[1:]]
    for column in columns:
        if [(one.quantity, one.ratio) for one in columns].count((column.quantity, column.ratio)) > 1:
            said = f"{column.quantity} at R:L = {ratio_text(column.ratio)}"
            raise NotationError(f"there are two columns of {said}")
    return columns


def _column(head: str, alone: bool, quantity: str | None, crank_ratio: Fraction | None) -> _Column:
    """Return whose column it is; what the head says must be what was given."""
    own_ratio = ratio(head) if ":" in head else None
    own_quantity = known_quantity(head) if head in registry() else None
    if own_ratio is None and own_quantity is None and not alone:
        raise NotationError(f'the head "{head[:40]}" is neither a crank ratio nor a quantity, such as p')
    key = own_quantity or quantity
    if key is None:
        raise ProblemError("what is printed is not known; add --quantity, for example --quantity p")
    if quantity not in (None, key):
        raise ProblemError(f"the file has a column headed {key}, and --quantity is {quantity}; leave one out")
    value = crank_ratio if own_ratio is None else own_ratio
    if value is None:
        raise ProblemError("the crank ratio is not known; add --ratio, for example --ratio 1:5")
    if crank_ratio not in (None, value):
        raise ProblemError(f"the file has a column headed {head}, and --ratio is another; leave one out")
    Crank(value)
    return _Column(head, key, value)
