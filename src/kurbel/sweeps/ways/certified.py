"""Certified digits over the crank angle: one question for each combination of the other options."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.numerals import MOST_DIGITS
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.page.axes import AngleAxis, shifted
from kurbel.page.subject import Question
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.over_angle import OverAngle, question_at
from kurbel.sweeps.ways.pointwise import BALLS, IN_BALLS
from kurbel.sweeps.ways.records import digits_of, is_small, records_of_question
from kurbel.sweeps.ways.way import Points, Rows, columns_from

# Rows of which floats settle most digits: some seconds.
IN_FLOATS = 1 << 17


@dataclass(frozen=True)
class CertifiedOverAngle(OverAngle):
    """The records of the command at all angles at once, which has floats for long runs of few digits."""

    @property
    def rows_at_once(self) -> int:
        digits = self.asked.plan.digits
        return IN_BALLS if digits is None or digits > MOST_DECIMALS else IN_FLOATS

    def rows(self, points: Points) -> Rows:
        found: list[Mapping[str, Any] | None] = [None] * len(points)
        with BALLS:
            for point, rows, places in self._runs(points):
                # What is refused is asked point by point, for its sentences.
                with suppress(KurbelError):
                    records = self._records(point, self._angles(places))
                    for row, record in zip(np.arange(len(points))[rows].tolist(), records, strict=True):
                        found[row] = record
        left = np.array([row for row, one in enumerate(found) if one is None], np.int64)
        told = columns_from(self.asked, [one or {} for one in found], {})
        if len(left):
            self.single(points, left, told.values, told.reasons)
        return told

    def _records(self, point: int, angles: Sequence[Fraction]) -> Sequence[Mapping[str, Any]]:
        plan, keys = self.asked.plan, [one.key for one in self.asked.fields]
        found = _records(plan, point, angles, digits_of(plan))
        rows = [*found.rows]
        if plan.digits is None and is_small(rows):
            rows = [*_records(plan, point, angles, MOST_DIGITS).rows]
        # Several angles tell records apart, of which each point has one.
        there = [one.key for one in found.fields]
        if [key for key in there if key in keys] != keys:
            raise ProblemError("the records are others than elsewhere in the sweep")
        return [dict(zip(there, row, strict=True)) for row in rows]


def _records(plan: Plan, point: int, angles: Sequence[Fraction], digits: int) -> Any:
    question = question_at(plan, point, angles, digits)
    return records_of_question(replace(question, angles=shifted(angles, question.zero)))


def is_over_angle(question: Question) -> bool:
    """Whether a question is asked at crank angles, which may be others."""
    return any(isinstance(one, AngleAxis) for one in question.axes.values())
