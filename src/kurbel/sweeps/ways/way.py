"""What every way of computing rows is given, and what it gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from kurbel.exact.numerals import Number
from kurbel.page.table import Field
from kurbel.sweeps.columns import BOUND, Column
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.records import double_of, text_of

Floats = NDArray[np.float64]
Places = NDArray[np.int64]


class Rows(NamedTuple):
    """Rows in order: the values of the columns that are no options, and why some rows were refused."""

    values: Mapping[str, Any]
    reasons: dict[int, str]


class Points(NamedTuple):
    """Rows by their points, and which record of its point each is; points that follow each other have a
    `first` one."""

    places: Places
    records: Places
    first: int | None = None

    def __len__(self) -> int:
        return len(self.places)


class Way(Protocol):
    """A way of computing rows: how many at once, and whether in several threads at a time."""

    @property
    def rows_at_once(self) -> int: ...
    @property
    def in_threads(self) -> bool: ...
    def rows(self, points: Points) -> Rows:
        """Return the rows of these points."""


@dataclass(frozen=True)
class Asked:
    """A plan with what the command answers at one of its points: the fields of its records, their number,
    and what tells them apart, by its keys."""

    plan: Plan
    fields: tuple[Field, ...]
    each: int
    columns: tuple[Column, ...]
    apart: Mapping[str, Sequence[Any]]

    @property
    def own(self) -> list[Column]:
        """The columns that are no options."""
        return [column for column in self.columns if not column.option]


def columns_from(asked: Asked, found: Sequence[Mapping[str, Any]], reasons: dict[int, str]) -> Rows:
    """Return rows from records by the keys of the fields; one that was refused is empty."""
    # Of an indicator card a number has as many decimals as are known; of others what is exact has few.
    told = reasons if asked.plan.carded else None
    values = {column.key: _values(column, found, told) for column in asked.own}
    return Rows(values, reasons)


def _values(column: Column, rows: Sequence[Mapping[str, Any]], reasons: dict[int, str] | None) -> Any:
    if column.kind == "words":
        return [text_of(row.get(column.key)) for row in rows]
    if column.kind == "decimal":
        return [_decimal(column, row.get(column.key), place, reasons) for place, row in enumerate(rows)]
    bound = column.role == "bound"
    numbers = [row.get(column.key.removesuffix(BOUND) if bound else column.key) for row in rows]
    return np.array(
        [double_of(one)[bound] if isinstance(one, Number) else np.nan for one in numbers], np.float64
    )


def _decimal(column: Column, number: Any, place: int, reasons: dict[int, str] | None) -> int | None:
    if not isinstance(number, Number) or column.decimals is None:
        return None
    scaled: int = number.scaled * 10 ** (column.decimals - number.decimals)
    if number.decimals == column.decimals or reasons is None:
        return scaled
    said = f"the card tells {number.decimals} decimals of {column.key}, and {column.decimals} were asked for"
    reasons.setdefault(place, said)
    return None
