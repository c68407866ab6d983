"""The general way: the command is asked at every combination, and its certified digits become floats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf, nextafter, ulp
from typing import Any

from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.numerals import MOST_DIGITS, Number
from kurbel.page.build import records_of
from kurbel.page.labels import plain
from kurbel.page.subject import Question
from kurbel.page.table import Field, Records
from kurbel.sweeps.plan import Plan

# Decimals of which a float is made; what is small has more.
DECIMALS = 30
# Figures that settle a float.
FIGURES = 10**20
# Of so many combinations, spread over the sweep, one at least must not be refused.
TRIED = 64


def records_at(plan: Plan, values: Mapping[str, Any], digits: int) -> Records:
    """Return the records of the command with these values. Raises KurbelError."""
    question: Question = plan.question(values, digits).for_data
    return question.subject.rows(question) if question.subject.rows else records_of(question)


def first_of(plan: Plan) -> tuple[tuple[Field, ...], list[Sequence[Any]]]:
    """Return the fields and the records of the first combination that is not refused.

    Raises the error of the first one where all are that were tried.
    """
    refused: list[KurbelError] = []
    for point in tried(plan):
        try:
            found = records_at(plan, plan.at(point), _digits(plan))
            return found.fields, [*found.rows]
        except KurbelError as error:
            refused.append(error)
    raise refused[0]


def tried(plan: Plan, most: int = TRIED) -> list[int]:
    """Return some combinations, spread over the sweep, the first one first."""
    count = len(plan)
    places = sorted({count * place // most for place in range(min(most, count))} | {count - 1})
    return [plan.point(place) for place in places]


def rows_at(
    plan: Plan, values: Mapping[str, Any], fields: Sequence[Field], count: int
) -> list[dict[str, Any]]:
    """Return so many records of a combination by the keys of the fields, as `Number` or text.

    Raises KurbelError where it is refused.
    """
    digits = _digits(plan)
    found = records_at(plan, values, digits)
    rows = [*found.rows]
    if [one.key for one in found.fields] != [one.key for one in fields] or len(rows) != count:
        raise ProblemError(
            f"the command answers with {len(rows)} records of {', '.join(one.key for one in found.fields)}"
            f" here, and with {count} of {', '.join(one.key for one in fields)} elsewhere in the sweep"
        )
    if plan.digits is None and digits < MOST_DIGITS and _is_small(rows):
        rows = [*records_at(plan, values, MOST_DIGITS).rows]
    return [dict(zip([one.key for one in fields], row, strict=True)) for row in rows]


def _digits(plan: Plan) -> int:
    return DECIMALS if plan.digits is None else plan.digits


def _is_small(rows: Sequence[Sequence[Any]]) -> bool:
    return any(
        isinstance(one, Number) and one.decimals == DECIMALS and 0 < abs(one.scaled) < FIGURES
        for row in rows
        for one in row
    )


def text_of(value: Any) -> str | None:
    """Return what is no number as text."""
    return plain(value) if isinstance(value, str) else None


def double_of(number: Number) -> tuple[float, float]:
    """Return the float nearest to a certified number, and how far from the true value it may lie."""
    scale = 10**number.decimals
    # Python divides whole numbers with one rounding.
    value = number.scaled / scale
    numerator, denominator = value.as_integer_ratio()
    exact = abs(numerator * scale - number.scaled * denominator) / (denominator * scale)
    return value, nextafter(exact + 0.5 / scale, inf) if number.scaled or number.decimals else ulp(0.0)
