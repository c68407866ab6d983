"""What a column of a sweep is and what stands in it: the columns of a plan, and rows of values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, nextafter, ulp
from typing import Any, Literal, NamedTuple, Protocol, TypeAlias

import numpy as np

from kurbel.exact.numerals import Number
from kurbel.page.labels import plain
from kurbel.page.table import Field, Value
from kurbel.sweeps.coordinates import Coordinates, into, measured
from kurbel.sweeps.plan import Axis, Cell, Plan, Points

Kind = Literal["number", "decimal", "words"]
# What records call the axis of an option.
KEYS = {"eps": "epsilon", "angle": "phi"}
BOUND = "_bound"
# Behind the key of an axis whose key another column of the command has.
BESIDE = "_given"
# Why a row is empty that belongs to no record: its combination is refused, or has fewer of them than others.
MISSING = "there is no such record of this combination"
# What is no number of the command, and the same at all records of a point.
GIVEN: Literal["given"] = "given"


class Column(NamedTuple):
    """A column of a sweep: its key, what it is, and what files say of it.

    A "number" is a float, a "decimal" has so many `decimals`, each of them certified. `role` tells what it
    is: what varies, what the command says, or how far a float may lie from the true value. An axis is that of
    an `option`, or of several records of a point.
    """

    key: str
    kind: Kind
    name: str = ""
    symbol: str = ""
    unit: str = ""
    formula: str = ""
    source: str = ""
    decimals: int | None = None
    role: Literal["axis", "value", "bound", "given"] = "value"
    option: str = ""


# A record of the command by the keys of its fields, and arrays or lists of values by the keys of columns.
Record: TypeAlias = Mapping[str, "Number | str | None"]
Cells: TypeAlias = Mapping[str, Any]


class Part(NamedTuple):
    """Rows of a sweep, in order.

    `values` has by key of a column: of numbers an array of floats, NaN where there is nothing; of decimals
    whole numbers of the last place, of texts texts, in lists with None there. `reasons` tell of the rows that
    were refused why, by their place in the part.
    """

    rows: int
    values: Cells
    reasons: Mapping[int, str]

    @property
    def refused(self) -> Mapping[int, str]:
        """Why combinations were refused, by their first rows."""
        return {row: reason for row, reason in self.reasons.items() if reason != MISSING}


def key_of(option: str) -> str:
    """Return the key of the column that has the values of an option."""
    return KEYS.get(option, option)


def columns_of(
    plan: Plan, fields: Sequence[Field], rows: Sequence[Sequence[Value]], needed: Collection[str]
) -> tuple[Column, ...]:
    """Return the columns of a plan whose command has these records at a point: what varies, what the command
    says, and of floats their bounds. These keys are `needed` though they may be the same everywhere."""
    about = {field.key: field for field in fields}
    found = [_axis(plan, axis, about.get(key_of(option))) for option, axis in plan.axes.items()]
    own = {column.key for column in found}
    for place, field in enumerate(fields):
        if field.key not in own:
            found += _of_records(plan, field, [row[place] for row in rows], field.key in needed)
    return tuple(found)


def _axis(plan: Plan, axis: Axis, field: Field | None) -> Column:
    """Return the column of an axis, in the unit of the command's own column of it."""
    option = plan.asking.options[axis.option]
    key, numbers = key_of(axis.option), measured(option, axis.values)
    unit = numbers[2] if numbers else ""
    other = field and (into(unit, plain(field.unit)) is None if numbers else field.method and option.whole)
    if field is None or other:
        name = option.help.partition(":")[0].partition(";")[0].rstrip(".")
        symbol, key = "", f"{key}{BESIDE}" if other else key
    else:
        name, symbol, unit = plain(field.name), plain(field.symbol), plain(field.unit) if numbers else ""
    kind: Kind = "words" if numbers is None else "number"
    return Column(key, kind, name, symbol, unit, role="axis", option=axis.option)


def _of_records(plan: Plan, field: Field, found: Sequence[Value], needed: bool) -> Iterator[Column]:
    known = [one for one in found if one is not None]
    numbers = all(isinstance(one, Number) for one in known) and bool(known or field.method)
    about = (plain(field.name), plain(field.symbol), field.unit)
    if not field.method:
        # What is the same everywhere says nothing, unless it is needed; the rest tells the records of a point
        # apart.
        if len({str(one) for one in found}) > 1:
            yield Column(field.key, "number" if numbers else "words", *about, role="axis")
        elif needed:
            yield Column(field.key, "number" if numbers else "words", *about, role=GIVEN)
        return
    if not numbers:
        yield Column(field.key, "words", *about)
        return
    if plan.digits is not None:
        yield Column(field.key, "decimal", *about, decimals=plan.digits)
        return
    yield Column(field.key, "number", *about)
    if plan.bounds:
        yield Column(f"{field.key}{BOUND}", "number", *about, role="bound")


class Rows(NamedTuple):
    """Rows in order: the values of the columns that are no options, and why some rows were refused."""

    values: Cells
    reasons: dict[int, str]


class Way(Protocol):
    """A way of computing rows: how many at once, and whether in several threads at a time."""

    @property
    def rows_at_once(self) -> int: ...
    @property
    def in_threads(self) -> bool: ...
    def rows(self, points: Points) -> Rows:
        """Return the rows of these points."""


@dataclass(frozen=True)
class AnsweredPlan:
    """A plan with what the command answers at one of its points: the fields of its records, their number,
    and what tells them apart, by its keys."""

    plan: Plan
    fields: tuple[Field, ...]
    each: int
    columns: tuple[Column, ...]
    apart: Mapping[str, Sequence[Value]]

    @cached_property
    def coordinates(self) -> Coordinates:
        """The values of what varies, in units of the SI."""
        return Coordinates(self.plan)

    @property
    def own(self) -> list[Column]:
        """The columns that are no options."""
        return [column for column in self.columns if not column.option]


def columns_from(asked: AnsweredPlan, found: Sequence[Record], reasons: dict[int, str]) -> Rows:
    """Return rows from records by the keys of the fields; one that was refused is empty."""
    # Of an indicator card a number has as many decimals as are known; of others what is exact has few.
    told = reasons if asked.plan.carded else None
    values = {column.key: _values(column, found, told) for column in asked.own}
    return Rows(values, reasons)


def _values(column: Column, rows: Sequence[Record], reasons: dict[int, str] | None) -> Cell:
    if column.kind == "words":
        texts = (row.get(column.key) for row in rows)
        return [plain(one) if isinstance(one, str) else None for one in texts]
    if column.kind == "decimal":
        return [_decimal(column, row.get(column.key), place, reasons) for place, row in enumerate(rows)]
    bound = column.role == "bound"
    numbers = [row.get(column.key.removesuffix(BOUND) if bound else column.key) for row in rows]
    return np.array(
        [double_of(one)[bound] if isinstance(one, Number) else np.nan for one in numbers], np.float64
    )


def _decimal(column: Column, number: object, place: int, reasons: dict[int, str] | None) -> int | None:
    if not isinstance(number, Number) or column.decimals is None:
        return None
    scaled: int = number.scaled * 10 ** (column.decimals - number.decimals)
    if number.decimals == column.decimals or reasons is None:
        return scaled
    said = f"the card tells {number.decimals} decimals of {column.key}, and {column.decimals} were asked for"
    reasons.setdefault(place, said)
    return None


def double_of(number: Number) -> tuple[float, float]:
    """Return the float nearest to a certified number, and how far from the true value it may lie."""
    scale = 10**number.decimals
    # Python divides whole numbers with one rounding.
    value = number.scaled / scale
    numerator, denominator = value.as_integer_ratio()
    exact = abs(numerator * scale - number.scaled * denominator) / (denominator * scale)
    return value, nextafter(exact + 0.5 / scale, inf) if number.scaled or number.decimals else ulp(0.0)
