"""The rows of a sweep: its columns, and their values part by part, in any process and in any order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import KurbelError
from kurbel.exact.numerals import Number
from kurbel.page.table import Field
from kurbel.sweeps.axes import coordinates
from kurbel.sweeps.columns import BOUND, columns_of
from kurbel.sweeps.columns import Column as Column
from kurbel.sweeps.columns import Part as Part
from kurbel.sweeps.general import double_of, first_of, rows_at, text_of
from kurbel.sweeps.plan import Plan

# Rows of a command that is asked for every point: some seconds.
ROWS_AT_ONCE = 4096


@dataclass(frozen=True)
class Sweep:
    """A plan with its columns; it goes to other processes. Rows are counted from 0 to its length."""

    plan: Plan

    def __len__(self) -> int:
        return len(self.plan) * self.each

    @property
    def shape(self) -> tuple[int, ...]:
        """The sizes of the groups of the plan, and of the records of a point, if there are several."""
        return (*self.plan.sizes, *((self.each,) if self.each > 1 else ()))

    @property
    def rows_at_once(self) -> int:
        """How many rows make a part. It depends on the plan alone: a part is what a file has of it."""
        return ROWS_AT_ONCE

    @property
    def in_threads(self) -> bool:
        """Whether parts can be computed in several threads of a process at once; balls cannot."""
        return False

    @cached_property
    def each(self) -> int:
        """How many records a point has."""
        return len(self._first[1])

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """The columns: what varies, what the command says and, on request, how far floats may be off."""
        return columns_of(self.plan, *self._first)

    def part(self, start: int, stop: int) -> Part:
        """Return the rows from one to another; raise no KurbelError for points that are refused."""
        found: list[Mapping[str, Any]] = []
        reasons: dict[int, str] = {}
        points = range(start // self.each, -(-stop // self.each))
        for point in points:
            begins = point * self.each
            within = range(max(start, begins) - begins, min(stop, begins + self.each) - begins)
            try:
                rows = rows_at(self.plan, self.plan.at(point), self._fields, self.each)
            except KurbelError as error:
                reasons |= {len(found) + place: str(error) for place, _ in enumerate(within)}
                rows = [{}] * self.each
            found += [rows[record] for record in within]
        axes = coordinates(self.plan, np.arange(start, stop) // self.each)
        values = {
            column.key: axes[column.option] if column.option else _values(column, found)
            for column in self.columns
        }
        return Part(len(found), values, reasons)

    @cached_property
    def _first(self) -> tuple[tuple[Field, ...], Sequence[Any]]:
        return first_of(self.plan)

    @property
    def _fields(self) -> tuple[Field, ...]:
        return self._first[0]


def _values(column: Column, rows: Sequence[Mapping[str, Any]]) -> Any:
    if column.kind == "text":
        return [text_of(row.get(column.key)) for row in rows]
    if column.kind == "decimal":
        return [*_decimals(column, rows)]
    return np.array([*_floats(column, rows)], np.float64)


def _decimals(column: Column, rows: Sequence[Mapping[str, Any]]) -> Iterator[int | None]:
    assert column.decimals is not None
    for row in rows:
        number = row.get(column.key)
        # What is exact may have fewer decimals.
        yield (
            number.scaled * 10 ** (column.decimals - number.decimals) if isinstance(number, Number) else None
        )


def _floats(column: Column, rows: Sequence[Mapping[str, Any]]) -> Iterator[float]:
    bound = column.role == "bound"
    key = column.key.removesuffix(BOUND) if bound else column.key
    for row in rows:
        number = row.get(key)
        yield double_of(number)[bound] if isinstance(number, Number) else np.nan


Floats = NDArray[np.float64]
