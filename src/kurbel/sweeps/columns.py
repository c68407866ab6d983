"""What a column of a sweep is, what stands in it, and the columns of a plan."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple

from kurbel.exact.numerals import Number
from kurbel.page.labels import plain
from kurbel.page.table import Field
from kurbel.sweeps.measures import measured
from kurbel.sweeps.plan import Plan

Kind = Literal["number", "decimal", "words"]
# What records call the axis of an option.
KEYS = {"eps": "epsilon", "angle": "phi"}
BOUND = "_bound"
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


def key_of(option: str) -> str:
    """Return the key of the column that has the values of an option."""
    return KEYS.get(option, option)


def columns_of(plan: Plan, fields: Sequence[Field], rows: Sequence[Sequence[Any]]) -> tuple[Column, ...]:
    """Return the columns of a plan whose command has these records at a point: what varies, what the command
    says, and of floats their bounds."""
    axes = {axis.option: axis for group in plan.groups for axis in group}
    own = {key_of(option) for option in axes}
    about = {field.key: field for field in fields}
    found = [_axis(plan, option, about.get(key_of(option))) for option in axes]
    for place, field in enumerate(fields):
        if field.key not in own:
            found += _of_records(plan, field, [row[place] for row in rows])
    return tuple(found)


def _axis(plan: Plan, option: str, field: Field | None) -> Column:
    parameter = plan.asking.parameters[plan.parameter(option)]
    values = next(axis.values for group in plan.groups for axis in group if axis.option == option)
    numbers = measured(parameter, values)
    name = field.name if field else parameter.option.help.partition(":")[0].partition(";")[0].rstrip(".")
    return Column(
        key_of(option),
        "words" if numbers is None else "number",
        plain(name) if field else name,
        plain(field.symbol) if field else "",
        numbers[2] if numbers else "",
        role="axis",
        option=option,
    )


def _of_records(plan: Plan, field: Field, found: Sequence[Any]) -> Iterator[Column]:
    known = [one for one in found if one is not None]
    numbers = all(isinstance(one, Number) for one in known) and bool(known or field.method)
    about = (plain(field.name), plain(field.symbol), field.unit)
    if not field.method:
        # What is the same everywhere says nothing, unless it is asked for; the rest tells the records of a
        # point apart.
        if len({str(one) for one in found}) > 1:
            yield Column(field.key, "number" if numbers else "words", *about, role="axis")
        elif field.key in plan.columns:
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
