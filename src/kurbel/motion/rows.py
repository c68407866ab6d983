"""The records of a request, for programs: computed as they are asked for, never held all at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Number
from kurbel.motion import captions
from kurbel.motion.digits import Digits, columns_in_balls, columns_in_floats, is_long
from kurbel.motion.request import AXIS_KEYS, PageColumn, Request
from kurbel.page.angles import angle_decimals, angle_number
from kurbel.page.table import Field, Value
from kurbel.reading.notation import ratio_text

CHUNK = 1 << 15


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
