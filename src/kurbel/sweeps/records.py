"""The general way: the command is asked at every combination, and its certified digits become floats."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.certify import BALLS
from kurbel.exact.numerals import MOST_DIGITS, Number
from kurbel.page.build import own_records
from kurbel.page.subject import Question
from kurbel.page.table import Field, Records, Value
from kurbel.sweeps.columns import MISSING, AnsweredPlan, Record, Rows, columns_from
from kurbel.sweeps.plan import Plan, Points

# Decimals of which a float is made; what is small has more.
DECIMALS = 30
# Figures that settle a float.
FIGURES = 10**20
# Of so many combinations, spread over the sweep, one at least must not be refused.
TRIED = 64
# Of so many of them, far from each other, it is known how many records they have.
COUNTED, MIXED = 8, 9


def records_at(plan: Plan, point: int, digits: int, keys: Sequence[str]) -> Records:
    """Return the records of the command at a point, with those of these keys that tell records apart
    elsewhere. Raises KurbelError."""
    question = plan.question(point, digits).for_data
    records = own_records(question)
    known = {*question.axis_keys, *question.named}
    if question.columns and {*keys} & known > {field.key for field in records.fields} & known:
        question = replace(question, columns=tuple(key for key in keys if key in known))
        return own_records(question)
    return records


class FirstAnswer(NamedTuple):
    """What a command answers at a combination: fields, records, and the keys of those fields that were asked
    for or tell the records apart."""

    fields: tuple[Field, ...]
    rows: list[Sequence[Value]]
    needed: list[str]


def first_of(plan: Plan) -> FirstAnswer:
    """Return what is answered at a combination, of some that are not refused the one with most records.

    Raises the error of the first one where all are refused.
    """
    refused: list[KurbelError] = []
    found: list[FirstAnswer] = []
    points = tried(plan)
    # Those first that lie far from each other, the first of all in front.
    for point in (point for start in range(MIXED) for point in points[start::MIXED]):
        try:
            question = plan.question(point, digits_of(plan)).for_data
            records = own_records(question)
            needed = [*question.columns, *question.apart]
            found.append(FirstAnswer(records.fields, [*records.rows], needed))
        except KurbelError as error:
            refused.append(error)
        if len(found) == COUNTED:
            break
    if not found:
        raise refused[0]
    return max(found, key=lambda one: len(one.rows))


def questions(plan: Plan, digits: int = DECIMALS, most: int = TRIED) -> Iterator[Question]:
    """Yield what is asked at some combinations that are not refused."""
    for point in tried(plan, most):
        with suppress(KurbelError):
            yield plan.question(point, digits).for_data


def tried(plan: Plan, most: int = TRIED) -> list[int]:
    """Return some combinations, spread over the sweep and closer at its beginning, the first one first."""
    count = len(plan)
    places = {count * place // most for place in range(min(most, count))} | {count - 1}
    places |= {1 << power for power in range(count.bit_length() - 1)}
    return [plan.point(place) for place in sorted(places)]


def rows_at(
    plan: Plan,
    point: int,
    fields: Sequence[Field],
    apart: Mapping[str, Sequence[Number | str | None]],
    count: int,
) -> list[Record | None]:
    """Return so many records of a combination by the keys of the fields, as `Number` or text, in the places
    of those that are told `apart` by these columns; None where it has no such record.

    Raises KurbelError where it is refused.
    """
    digits, keys = digits_of(plan), [one.key for one in fields]
    found = records_at(plan, point, digits, keys)
    rows, there = [*found.rows], [one.key for one in found.fields]
    if there != keys:
        raise ProblemError(
            f"columns are {', '.join(there)} here, and {', '.join(keys)} elsewhere in the sweep; choose"
            " some that are everywhere, with --columns"
        )
    if plan.digits is None and digits < MOST_DIGITS and is_small(rows):
        rows = [*records_at(plan, point, MOST_DIGITS, keys).rows]
    return _placed([dict(zip(keys, row, strict=True)) for row in rows], apart, count)


def _placed(
    records: Sequence[Record], apart: Mapping[str, Sequence[Number | str | None]], count: int
) -> list[Record | None]:
    """Return the records in the places of those elsewhere that are told apart in the same way."""
    if count == len(records) == 1:
        return [*records]
    found: list[Record | None] = [None] * count
    for record in records:
        own = {key: record[key] for key in apart}
        free = (
            place
            for place in range(count)
            if found[place] is None and all(apart[key][place] == own[key] for key in own)
        )
        place = next(free, None)
        if place is None:
            said = ", ".join(map(str, own.values())) or f"{len(records)} of them"
            raise ProblemError(
                f"there are more records here than elsewhere in the sweep, where there are {count}, without"
                f" one for {said}"
            )
        found[place] = record
    return found


def digits_of(plan: Plan) -> int:
    """Return with how many decimals the command is asked."""
    return DECIMALS if plan.digits is None else plan.digits


def is_small(rows: Sequence[Sequence[Value]]) -> bool:
    """Whether a number has too few figures to be a float."""
    return any(
        isinstance(one, Number) and one.decimals == DECIMALS and 0 < abs(one.scaled) < FIGURES
        for row in rows
        for one in row
    )


# Rows of a part that is computed in balls: about a second.
IN_BALLS = 1 << 9


@dataclass(frozen=True)
class Pointwise:
    """Every point is a question; a second of them at once, or less."""

    asked: AnsweredPlan
    rows_at_once: int = IN_BALLS
    in_threads: bool = False

    def rows(self, points: Points) -> Rows:
        # The precision of balls is that of the process, and other ways run in several threads.
        with BALLS:
            return self._rows(points)

    def _rows(self, points: Points) -> Rows:
        plan, fields, each = self.asked.plan, self.asked.fields, self.asked.each
        apart = self.asked.apart
        found: list[Record] = []
        reasons: dict[int, str] = {}
        last, answer, refused = -1, list[Record | None](), ""
        for row, (point, record) in enumerate(
            zip(points.places.tolist(), points.records.tolist(), strict=True)
        ):
            if point != last:
                last, refused = point, ""
                try:
                    answer = rows_at(plan, point, fields, apart, each)
                except KurbelError as error:
                    refused = str(error)
            one = None if refused else answer[record]
            if one is None:
                # A combination is refused once.
                reasons[row] = refused if refused and not record else MISSING
            # Also what is not there is told apart.
            found.append(one or {key: values[record] for key, values in apart.items()})
        return columns_from(self.asked, found, reasons)
