"""The rows of a sweep: its columns, and their values part by part, in any process and in any order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pkgutil import resolve_name
from typing import Any, Literal, NamedTuple

import numpy as np

from kurbel.commands.subject import Asking
from kurbel.errors import KurbelError
from kurbel.exact.numerals import Number
from kurbel.page.build import records_of
from kurbel.page.subject import Question
from kurbel.page.table import Field, Records
from kurbel.sweeps.plan import Plan

# To so many decimals a value of the order of one is its nearest float.
DECIMALS = 30
# Rows of a command that is asked for every point: some seconds.
ROWS_AT_ONCE = 4096
Kind = Literal["number", "decimal", "text"]


class Column(NamedTuple):
    """A column of a sweep: its key, what it is, and what files say of it.

    A "number" is a float, a "decimal" has so many `decimals`, each of them certified. `role` tells what it
    is: what varies, what the command says, or how far a float may lie from the true value.
    """

    key: str
    kind: Kind
    name: str = ""
    symbol: str = ""
    unit: str = ""
    formula: str = ""
    source: str = ""
    decimals: int | None = None
    role: Literal["axis", "value", "bound"] = "value"


class Part(NamedTuple):
    """Rows of a sweep, in order.

    `values` has by key of a column: of numbers an array of floats, NaN where there is nothing; of decimals
    whole numbers of the last place, of texts texts, in lists with None there. `reasons` tell of the rows that
    were refused why, by their place in the part.
    """

    rows: int
    values: Mapping[str, Any]
    reasons: Mapping[int, str]


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
        return len(self._first)

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """The columns: what varies, and what the command says."""
        own = {axis.option for group in self.plan.groups for axis in group}
        known = {field.key for field in self._fields}
        axes = [Column(key, "text", role="axis") for key in sorted(own - known)]
        return (*axes, *(self._column(field) for field in self._fields))

    def part(self, start: int, stop: int) -> Part:
        """Return the rows from one to another; raise no KurbelError for points that are refused."""
        found: list[Mapping[str, Any]] = []
        reasons: dict[int, str] = {}
        for row in range(start, stop):
            point, record = divmod(row, self.each)
            try:
                found.append(self._record(point, record))
            except KurbelError as error:
                reasons[len(found)] = str(error)
                found.append(self.plan.at(point))
        values = {
            column.key: _values(column, [row.get(column.key) for row in found]) for column in self.columns
        }
        return Part(len(found), values, reasons)

    def _record(self, point: int, record: int) -> Mapping[str, Any]:
        asked = self.plan.at(point)
        rows = list(_records(self._question(point)).rows)
        return {**asked, **dict(zip([field.key for field in self._fields], rows[record], strict=True))}

    def _question(self, point: int) -> Question:
        function: Asking[..., Question] = resolve_name(self.plan.command)
        digits = DECIMALS if self.plan.digits is None else self.plan.digits
        return function.question(**{**self.plan.given, **self.plan.at(point), "digits": digits})

    @cached_property
    def _first(self) -> Sequence[Any]:
        return list(_records(self._question(0)).rows)

    @cached_property
    def _fields(self) -> tuple[Field, ...]:
        return _records(self._question(0)).fields

    def _column(self, field: Field) -> Column:
        kind: Kind = "text" if field.decimals is None else "number"
        return Column(field.key, kind, field.name, field.symbol, field.unit, decimals=field.decimals)


def _records(question: Question) -> Records:
    return question.subject.rows(question) if question.subject.rows else records_of(question)


def _values(column: Column, found: Sequence[Any]) -> Any:
    if column.kind == "text":
        return [None if one is None else str(one) for one in found]
    if column.kind == "decimal":
        return [one.scaled if isinstance(one, Number) else None for one in found]
    return np.array([one.scaled / 10**one.decimals if isinstance(one, Number) else np.nan for one in found])
