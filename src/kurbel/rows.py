"""The records of a request, for programs: computed as they are asked for, never held all at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel import captions
from kurbel.digits import Digits, columns_in_balls, columns_in_floats, is_long
from kurbel.notation import Progression, ratio_text
from kurbel.numerals import finite_decimals, nearest
from kurbel.problem import Crank
from kurbel.request import AXIS_KEYS, PageColumn, Request
from kurbel.table import Field, Number, Value

CHUNK = 1 << 15
# An angle that is no finite decimal, such as 0°20', is given to programs to this many places.
ANGLE_DECIMALS = 15
MOST_ANGLE_DECIMALS = 50


@dataclass(frozen=True, slots=True)
class RecordRows:
    """The records of a request: one for each ratio and angle, computed as they are asked for."""

    request: Request
    columns: tuple[PageColumn, ...]

    def names(self) -> tuple[str, ...]:
        return self.request.columns or (*AXIS_KEYS, *(column.key for column in self.columns))

    def fields(self) -> tuple[Field, ...]:
        axes = captions.axis_fields(self.request, angle_decimals(self.request.angles))
        return tuple(axes.get(key) or self._field(key) for key in self.names())

    def __len__(self) -> int:
        return len(self.request.cranks) * len(self.request.angles)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        decimals = {column.key: column.digits.decimals for column in self.columns}
        of_angles = angle_decimals(self.request.angles)
        for crank, angles, values in self.chunks():
            ratio = f"${ratio_text(crank.ratio)}$"
            for row, angle in enumerate(angles):
                axes: dict[str, Value] = {"ratio": ratio, "phi": angle_number(angle, of_angles)}
                yield tuple(
                    axes[key] if key in axes else Number(int(values[key][row]), decimals[key])
                    for key in self.names()
                )

    def bulk(self) -> bool:
        """Whether the chunks come as arrays."""
        return is_long(self._digits(), self.request.cranks, self.request.angles)

    def chunks(self) -> Iterator[tuple[Crank, Sequence[Fraction], Mapping[str, Any]]]:
        """Yield ratio by ratio and chunk by chunk the scaled digits of every column by its key."""
        compute = columns_in_floats if self.bulk() else columns_in_balls
        angles = self.request.angles
        for crank in self.request.cranks:
            for start in range(0, len(angles), CHUNK):
                part = angles[start : start + CHUNK]
                values = compute(self._digits(), crank, part, self.request.rounding)
                yield crank, part, {column.key: one for column, one in zip(self.columns, values, strict=True)}

    def _digits(self) -> list[Digits]:
        return [column.digits for column in self.columns]

    def _field(self, key: str) -> Field:
        column = next(column for column in self.columns if column.key == key)
        quantity = column.digits.quantity
        return Field(
            key,
            captions.quantity_name(quantity, self.request.lang),
            quantity.symbol,
            quantity.unit[self.request.lang],
            column.digits.decimals,
            column.digits.method,
        )


def angle_decimals(angles: Sequence[Fraction]) -> int | None:
    """Return how many decimals write every angle exactly, or None if no number up to 50 of them does."""
    ends = (angles.start, angles.step) if isinstance(angles, Progression) else angles
    counts = [_decimals(angle) for angle in ends]
    known = [count for count in counts if count is not None]
    return max(known) if len(known) == len(counts) else None


def angle_number(angle: Fraction, decimals: int | None) -> Number:
    """Return the angle to the decimals of its column, or to its own where the column has no common ones."""
    if decimals is None:
        decimals = _decimals(angle)
    return nearest(angle, ANGLE_DECIMALS if decimals is None else decimals)


def _decimals(angle: Fraction) -> int | None:
    count = finite_decimals(angle)
    return None if count is None or count > MOST_ANGLE_DECIMALS else count
