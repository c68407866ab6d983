"""The records of a question about motion, for programs: computed in chunks, never held all at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Number
from kurbel.motion.digits import columns_in_balls, columns_in_floats
from kurbel.motion.question import Request
from kurbel.page.axes import angle_decimals, angle_number
from kurbel.page.build import Rows, records_of
from kurbel.page.table import Records, Value
from kurbel.reading.notation import ratio_text

CHUNK = 1 << 15


def motion_records(question: Request) -> Records:
    """Return one record for each ratio and angle."""
    fields = records_of(question).fields
    return Records(fields, RecordRows(question, [field.key for field in fields]))


class RecordRows(Rows):
    """The records of a question about motion, a chunk of angles at a time."""

    question: Request

    def __init__(self, question: Request, keys: Sequence[str]) -> None:
        super().__init__(question, {}, {column.key: column for column in question.page_columns}, keys)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        of_angles = angle_decimals(self.question.angles)
        for crank, angles, values in self.chunks():
            ratio = f"${ratio_text(crank.ratio)}$"
            for row, angle in enumerate(angles):
                axes: dict[str, Value] = {"ratio": ratio, "phi": angle_number(angle, of_angles)}
                yield tuple(
                    axes[key] if key in axes else Number(int(values[key][row]), self.columns[key].places)
                    for key in self.keys
                )

    def chunks(self) -> Iterator[tuple[Crank, Sequence[Fraction], Mapping[str, Any]]]:
        """Yield ratio by ratio and chunk by chunk the scaled digits of every column by its key."""
        question, columns = self.question, self.question.page_columns
        compute = columns_in_floats if question.bulk else columns_in_balls
        for crank in question.cranks:
            for start in range(0, len(question.angles), CHUNK):
                part = question.angles[start : start + CHUNK]
                values = compute(columns, crank, part, question.rounding)
                yield crank, part, {column.key: one for column, one in zip(columns, values, strict=True)}
