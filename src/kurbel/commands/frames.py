"""The records of a table as columns of arrays and frames: numbers as printed, ratios and names as text."""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Iterator, Sized
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from kurbel.exact.numerals import Number, number_text
from kurbel.page.labels import plain
from kurbel.page.table import Field, Table, Value
from kurbel.reading.given import allowed_name

if TYPE_CHECKING:
    from types import ModuleType

    import numpy as np
    import pandas
    from numpy.typing import NDArray

    Column: TypeAlias = NDArray[np.float64] | NDArray[np.str_]


class Frame(NamedTuple):
    """A column: its key, whether it has numbers, its values with None for those that are missing, and what
    it means: name, symbol, unit and decimals as text."""

    key: str
    numeric: bool
    values: list[float | Decimal | str | None]
    about: dict[str, str]


def frames(table: Table, number: Callable[[Number], float | Decimal]) -> list[Frame]:
    """Return the columns; one that holds any text holds text only, numbers as printed with a point."""
    columns = list(zip(*table.records.rows, strict=True)) or [() for _ in table.records.fields]
    return [
        _frame(field, column, number) for field, column in zip(table.records.fields, columns, strict=True)
    ]


def _frame(field: Field, column: tuple[Value, ...], number: Callable[[Number], float | Decimal]) -> Frame:
    given = [value for value in column if value is not None]
    numeric = bool(given) and all(isinstance(value, Number) for value in given)
    about = {"name": field.name, "symbol": plain(field.symbol), "unit": field.unit, "method": field.method}
    if field.decimals is not None:
        about["decimals"] = str(field.decimals)
    values = [
        None if value is None else number(value) if numeric and isinstance(value, Number) else _text(value)
        for value in column
    ]
    return Frame(field.key, numeric, values, {name: text for name, text in about.items() if text})


def _text(value: Value) -> str:
    return number_text(value) if isinstance(value, Number) else plain(value or "")


def as_float(number: Number) -> float:
    """Return the float that is nearest to a printed number."""
    return float(Fraction(number.scaled, 10**number.decimals))


def as_decimal(number: Number) -> Decimal:
    """Return a printed number with its decimals."""
    return Decimal(number_text(number))


def count(table: Table) -> int:
    """Return how many records there are."""
    found = table.records.rows
    return len(found) if isinstance(found, Sized) else sum(1 for _ in found)


def rows(table: Table) -> Iterator[tuple[object, ...]]:
    """Yield the records as named tuples of floats and text."""
    made = frames(table, as_float)
    # Such keys as are no names of Python have their place as a name, _1.
    row = namedtuple("Row", [one.key for one in made], rename=True)  # type: ignore[misc]
    return map(row._make, zip(*(one.values for one in made), strict=True))


def column(table: Table, key: str) -> Column:
    """Return one column, by its key or another word for it. Raises ChoiceError."""
    made = {one.key: one for one in frames(table, as_float)}
    return _array(made[allowed_name(key, made, "column")])


def _array(frame: Frame) -> Column:
    import numpy as np

    if frame.numeric:
        return np.array([float("nan") if one is None else one for one in frame.values], dtype=np.float64)
    return np.array([one or "" for one in frame.values], dtype=np.str_)


def to_numpy(table: Table) -> NDArray[np.void]:
    """Return the records as a structured array, whose fields are their keys; missing numbers are NaN."""
    import numpy as np

    columns = {frame.key: _array(frame) for frame in frames(table, as_float)}
    kinds = [(key, column.dtype) for key, column in columns.items()]
    made = np.empty(len(next(iter(columns.values()))), dtype=kinds)
    for key, column in columns.items():
        made[key] = column
    return made


def to_pandas(table: Table, *, exact: bool = False) -> pandas.DataFrame:
    """Return the records as a pandas DataFrame; what their columns mean is in its `attrs`."""
    pandas = library("pandas")
    made = frames(table, as_decimal if exact else as_float)
    kinds = {True: object if exact else "float64", False: "str"}
    frame = pandas.DataFrame({one.key: pandas.Series(one.values, dtype=kinds[one.numeric]) for one in made})
    frame.attrs.update({one.key: one.about for one in made})
    return frame


def to_polars(table: Table, *, exact: bool = False) -> Any:
    """Return the records as a polars DataFrame."""
    polars = library("polars")
    made = frames(table, as_decimal if exact else as_float)
    kind = polars.Decimal if exact else polars.Float64
    return polars.DataFrame(
        {one.key: one.values for one in made},
        schema={one.key: kind if one.numeric else polars.String for one in made},
    )


def to_arrow(table: Table) -> Any:
    """Return an Arrow table of floats and text; what columns mean is the metadata of its fields."""
    arro3 = library("arro3.core", extra="arrow")
    kinds = {True: arro3.DataType.float64(), False: arro3.DataType.utf8()}
    made = frames(table, as_float)
    fields = [arro3.Field(one.key, kinds[one.numeric], nullable=True, metadata=one.about) for one in made]
    schema = arro3.Schema(fields, metadata={"table": table.key, "caption": plain(table.caption)})
    return arro3.Table.from_arrays(
        [arro3.Array(one.values, kinds[one.numeric]) for one in made], schema=schema
    )


def library(name: str, extra: str = "") -> ModuleType:
    """Import a library, or raise MissingExtraError with what installs it."""
    try:
        return import_module(name)
    except ImportError:
        from kurbel.reading.environment import missing_extra, missing_library

        distribution = name.partition(".")[0]
        sentence = f"this needs {distribution}"
        raise (missing_extra(sentence, extra) if extra else missing_library(sentence, distribution)) from None
