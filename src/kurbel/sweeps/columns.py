"""What a column of a sweep is, what stands in it, and the columns of a plan."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple

from kurbel.exact.numerals import Number
from kurbel.page.labels import plain
from kurbel.page.table import Field
from kurbel.sweeps.measures import into, measured
from kurbel.sweeps.plan import Axis, Plan

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


class Part(NamedTuple):
    """Rows of a sweep, in order.

    `values` has by key of a column: of numbers an array of floats, NaN where there is nothing; of decimals
    whole numbers of the last place, of texts texts, in lists with None there. `reasons` tell of the rows that
    were refused why, by their place in the part.
    """

    rows: int
    values: Mapping[str, Any]
    reasons: Mapping[int, str]

    @property
    def refused(self) -> Mapping[int, str]:
        """Why combinations were refused, by their first rows."""
        return {row: reason for row, reason in self.reasons.items() if reason != MISSING}


def key_of(option: str) -> str:
    """Return the key of the column that has the values of an option."""
    return KEYS.get(option, option)


def columns_of(
    plan: Plan, fields: Sequence[Field], rows: Sequence[Sequence[Any]], apart: Collection[str]
) -> tuple[Column, ...]:
    """Return the columns of a plan whose command has these records at a point, told apart by these keys: what
    varies, what the command says, and of floats their bounds."""
    axes = {axis.option: axis for group in plan.groups for axis in group}
    about = {field.key: field for field in fields}
    found = [_axis(plan, axis, about.get(key_of(option))) for option, axis in axes.items()]
    own = {column.key for column in found}
    for place, field in enumerate(fields):
        if field.key not in own:
            needed = field.key in plan.columns or field.key in apart
            found += _of_records(plan, field, [row[place] for row in rows], needed)
    return tuple(found)


def _axis(plan: Plan, axis: Axis, field: Field | None) -> Column:
    """Return the column of an axis, in the unit of the command's own column of it."""
    parameter = plan.asking.parameters[plan.parameter(axis.option)]
    key, numbers = key_of(axis.option), measured(parameter, axis.values)
    unit = numbers[2] if numbers else ""
    other = field and (into(unit, plain(field.unit)) is None if numbers else field.method and parameter.whole)
    if field is None or other:
        name = parameter.help.partition(":")[0].partition(";")[0].rstrip(".")
        symbol, key = "", f"{key}{BESIDE}" if other else key
    else:
        name, symbol, unit = plain(field.name), plain(field.symbol), plain(field.unit) if numbers else ""
    kind: Kind = "words" if numbers is None else "number"
    return Column(key, kind, name, symbol, unit, role="axis", option=axis.option)


def _of_records(plan: Plan, field: Field, found: Sequence[Any], needed: bool) -> Iterator[Column]:
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
