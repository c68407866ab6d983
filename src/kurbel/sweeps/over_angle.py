"""Over the crank angle: one question for each combination of the other options, with all of its angles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import isfinite, prod
from typing import Any

import numpy as np

from kurbel.drive.crank import largest
from kurbel.engine.request import EngineRequest
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.numerals import MOST_DIGITS, Number
from kurbel.motion.bulk import float_angles, float_bound, greatest_value
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.motion.motion_page import AngleQuestion, Request
from kurbel.page.axes import AngleAxis, shifted
from kurbel.page.build import own_records
from kurbel.page.quantity import Column, Of
from kurbel.page.subject import Question
from kurbel.page.table import Records
from kurbel.reading.notation import Progression
from kurbel.sweeps.columns import BOUND, AnsweredPlan, Cells, Record, Rows, columns_from
from kurbel.sweeps.plan import Floats, Places, Plan, Points
from kurbel.sweeps.records import DECIMALS, IN_BALLS, Pointwise, digits_of, is_small

# Questions of a part, and its rows at the most: some seconds, and some tens of megabytes.
QUESTIONS, ROWS = 2048, 1 << 20
# Rows of certified digits.
CERTIFIED_ROWS = 4096
# What is one number of a turn is the same at each angle; the others are of the angle.
OF_TURN, OF_ANGLE = (Of.TURN,), (Of.ANGLE, Of.CRANK)


@dataclass(frozen=True)
class OverAngle:
    """Floats in arrays, where these are proved or no bounds are asked for."""

    asked: AnsweredPlan
    in_threads: bool = False

    @property
    def rows_at_once(self) -> int:
        return min(ROWS, max(CERTIFIED_ROWS, QUESTIONS * self.size))

    @cached_property
    def size(self) -> int:
        """How many angles there are."""
        return len(self.angles)

    @cached_property
    def group(self) -> int:
        """Which group of options is that of the crank angle."""
        groups = self.asked.plan.groups
        return next(place for place, group in enumerate(groups) if group[0].option == "angle")

    @cached_property
    def angles(self) -> Sequence[Fraction]:
        return self.asked.plan.groups[self.group][0].values

    @cached_property
    def after(self) -> int:
        """How many rows an angle has in turn."""
        return prod(self.asked.plan.sizes[self.group + 1 :])

    def rows(self, points: Points) -> Rows:
        values = {column.key: np.full(len(points), np.nan) for column in self.asked.own}
        reasons: dict[int, str] = {}
        for point, rows, places in self._runs(points):
            # What is refused has no values, and its sentence is that of the single command.
            with suppress(KurbelError):
                for key, found in self._floats(point, self._angles(places)).items():
                    if key in values:
                        values[key][rows] = found
        of_values = [values[column.key] for column in self.asked.own if column.role == "value"]
        odd = ~np.logical_and.reduce([np.isfinite(found) for found in of_values])
        if odd.any():
            self.single(points, np.flatnonzero(odd), values, reasons)
        return Rows(values, reasons)

    def _runs(self, points: Points) -> Iterator[tuple[int, slice | Places, slice | Places]]:
        """Yield each combination of the other options by its first point, with its rows and its angles."""
        size, after = self.size, self.after
        if points.first is not None and after == 1:
            start, stop = points.first, points.first + len(points)
            for other in range(start // size, -(-stop // size)):
                low, high = max(start, other * size), min(stop, (other + 1) * size)
                angles = slice(low - other * size, high - other * size)
                yield other * size, slice(low - start, high - start), angles
            return
        before, within = np.divmod(points.places, size * after)
        places, behind = np.divmod(within, after)
        others = before * size * after + behind
        order = np.argsort(others, kind="stable")
        ends = np.flatnonzero(np.diff(others[order])) + 1
        for rows in np.split(order, ends):
            yield int(others[rows[0]]), rows, places[rows]

    def _angles(self, places: slice | Places) -> Sequence[Fraction]:
        if isinstance(places, slice):
            return self.angles[places]
        return tuple(self.angles[place] for place in places.tolist())

    def _floats(self, point: int, angles: Sequence[Fraction]) -> Cells:
        question = question_at(self.asked.plan, point, angles)
        if not has_arrays(self.asked.plan, question):
            raise ProblemError("there are no floats of this")
        degrees = float_angles(shifted(angles, question.zero))
        found: dict[str, Floats | float] = {}
        for column, values in zip(question.page_columns, _curves(question, degrees), strict=True):
            found[column.key] = values
            if self.asked.plan.bounds and isinstance(question, Request):
                found[f"{column.key}{BOUND}"] = float_bound(column, question.cranks[0], self._reach)
        return found

    @cached_property
    def _reach(self) -> float:
        # Angles of the page may count from elsewhere.
        return float(largest(self.angles)) + 360

    def single(self, points: Points, rows: Places, values: Cells, reasons: dict[int, str]) -> None:
        """Ask the single command for these rows: why it refuses them, and what is not known of them."""
        one = Pointwise(self.asked)
        known: dict[int, str] = {}
        for row in rows.tolist():
            point = int(points.places[row])
            other = self._other(point)
            if other in known:
                reasons[row] = known[other]
                continue
            found = one.rows(Points(points.places[row : row + 1], points.records[row : row + 1]))
            for key, value in found.values.items():
                values[key][row] = value[0]
            if 0 in found.reasons:
                reasons[row] = found.reasons[0]
                if self._everywhere(other, found.reasons[0]):
                    known[other] = found.reasons[0]

    def _other(self, point: int) -> int:
        """Return the first point with the same other options."""
        before, within = divmod(point, self.size * self.after)
        return before * self.size * self.after + within % self.after

    def _everywhere(self, other: int, reason: str) -> bool:
        """Whether a combination is refused with the same sentence at its first, middle and last angle."""
        for place in (0, self.size // 2, self.size - 1):
            point = other + place * self.after
            try:
                question_at(self.asked.plan, point, (self.angles[place],))
            except KurbelError as error:
                if str(error) != reason:
                    return False
            else:
                return False
        return True


def question_at(plan: Plan, point: int, angles: Sequence[Fraction], digits: int = DECIMALS) -> Any:
    """Return what the command asks at a point with other angles. Raises KurbelError."""
    ends = list(dict.fromkeys((min(angles[0], angles[-1]), max(angles[0], angles[-1]))))
    if not isinstance(angles, Progression):
        ends = list(dict.fromkeys((min(angles), max(angles))))
    return plan.question(point, digits, angle=ends).for_data


def _curves(question: Question, degrees: Floats) -> list[Floats | float]:
    if isinstance(question, AngleQuestion):
        return [of_drives[0] for of_drives in question.curves(degrees)]
    from kurbel.engine.arrays import at_angles

    assert isinstance(question, EngineRequest)
    method = (question.methods or ("exact",))[0]
    found: list[Floats | float] = []
    for column in question.page_columns:
        if column.quantity.of in OF_ANGLE:
            found.append(at_angles(question, column.quantity, method, degrees)[0])
        else:
            number = question.number(column, {"expansion": 0, "ratio": 0, "angle": 0})
            found.append(number.scaled / 10**number.decimals if isinstance(number, Number) else np.nan)
    return found


def has_arrays(plan: Plan, question: Question) -> bool:
    """Whether floats over the angle are there for all columns of a question, and good enough for the plan."""
    if plan.digits is not None or not is_over_angle(question):
        return False
    columns = question.page_columns
    if isinstance(question, Request):
        crank = question.cranks[0]
        smooth = not (crank.has_friction or crank.pinned)
        smooth = smooth and all(isfinite(greatest_value(one, crank)) for one in columns)
        return len(question.cranks) == 1 and smooth and not any(_is_difference(one) for one in columns)
    if plan.bounds:
        return False
    if isinstance(question, AngleQuestion):
        return len(question.ratios) <= 1
    if isinstance(question, EngineRequest):
        one = len(question.steams) == len(question.drives) == 1 and not question.carded
        each = all(one.quantity.of in (*OF_TURN, *OF_ANGLE) and not _is_difference(one) for one in columns)
        return one and question.wheel is None and each
    return False


def _is_difference(column: Column) -> bool:
    return len(column.methods) > 1


# Rows of which floats settle most digits: some seconds.
IN_FLOATS = 1 << 17


class CertifiedOverAngle(OverAngle):
    """The records of the command at all angles at once, which has floats for long runs of few digits."""

    @property
    def rows_at_once(self) -> int:
        digits = self.asked.plan.digits
        return IN_BALLS if digits is None or digits > MOST_DECIMALS else IN_FLOATS

    def rows(self, points: Points) -> Rows:
        found: list[Record | None] = [None] * len(points)
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

    def _records(self, point: int, angles: Sequence[Fraction]) -> Sequence[Record]:
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


def _records(plan: Plan, point: int, angles: Sequence[Fraction], digits: int) -> Records:
    question = question_at(plan, point, angles, digits)
    return own_records(replace(question, angles=shifted(angles, question.zero)))


def is_over_angle(question: Question) -> bool:
    """Whether a question is asked at crank angles, which may be others."""
    return any(isinstance(one, AngleAxis) for one in question.axes.values())
