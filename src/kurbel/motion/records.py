"""The records over crank angles: a chunk of angles at a time, in long columns where these are worth it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.exact.numerals import Number
from kurbel.motion.bulk import has_arrays
from kurbel.page.axes import angle_decimals, angle_number, shifted
from kurbel.page.build import Rows, records_of
from kurbel.page.subject import Question
from kurbel.page.table import Records, Value
from kurbel.reading.given import found_at

# So many angles are computed at a time.
CHUNK = 1 << 15


def worthwhile(question: Question, columns: str) -> Any:
    """Return the long columns of a question, by the place of their class; None where there is no NumPy or
    floats would settle too few digits."""
    if not has_arrays():
        return None
    found = found_at(columns)(question)
    return found if found.is_worth() else None


def long_records(question: Any) -> Records:
    """Return the records over the crank angle, in chunks where long columns are worth it."""
    records = records_of(question)
    if question.long is None:
        return records
    from kurbel.motion.long import LongRows

    return records._replace(rows=LongRows(question, [field.key for field in records.fields]))


class Chunk(NamedTuple):
    """Records that differ in their angle alone: what stands for the other axes, the angles, the scaled digits
    of the columns, and how many of these are decimals, each by its key."""

    others: Mapping[str, Value]
    angles: Sequence[Fraction]
    scaled: Mapping[str, Any]
    decimals: Mapping[str, int]


class RecordRows(Rows):
    """The records of a question over crank angles, the innermost axis, a chunk of angles at a time."""

    question: Any

    def __init__(self, question: Any, keys: Sequence[str]) -> None:
        super().__init__(question, {}, {column.key: column for column in question.page_columns}, keys)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        zero, of_angles = self.question.zero, angle_decimals(self.counted)
        for others, angles, scaled, decimals in self.chunks():
            for row, angle in enumerate(angles):
                axes = {**others, "phi": angle_number(angle - zero, of_angles)}
                yield tuple(
                    axes[key] if key in axes else scaled_number(scaled[key][row], decimals[key])
                    for key in self.keys
                )

    @property
    def bulk(self) -> bool:
        """Whether they are computed in arrays."""
        return bool(self.question.bulk)

    @property
    def counted(self) -> Sequence[Fraction]:
        """The angles as the page counts them."""
        return shifted(self.question.angles, -self.question.zero)

    @property
    def stub_values(self) -> Sequence[Value]:
        """All that stands for places of the other axes."""
        axis = self.question.axes["ratio"]
        return [axis.value({"ratio": place}) for place in range(axis.count)]

    def chunks(self) -> Iterator[Chunk]:
        """Yield the records in their order, ratio by ratio."""
        question = self.question
        decimals = {key: column.places for key, column in self.columns.items()}
        # What fits one chunk is computed once for the page and for all its records.
        kept = len(question) <= CHUNK and not question.layout.pairs
        for number, crank in enumerate(question.cranks):
            axis = question.axes["ratio"]
            ratio: Mapping[str, Value] = {axis.key: axis.value({"ratio": number})}
            for start in range(0, len(question.angles), CHUNK):
                part = question.angles[start : start + CHUNK]
                values = question.values[number] if kept else question.scaled(crank, part)
                yield Chunk(ratio, part, dict(zip(self.columns, values, strict=True)), decimals)


def scaled_number(scaled: int | None, decimals: int, times: int = 1) -> Number | None:
    """Return scaled digits as a number, None where there is none."""
    return None if scaled is None else Number(int(scaled) * times, decimals)
