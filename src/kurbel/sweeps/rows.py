"""The rows of a sweep: which way they are computed, part by part, in any process and in any order.

Two ways go in arrays over several options: of the motion of the straight crank, and of δ of a steam engine.
"""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.drive.crank import LARGEST_ANGLE, Crank, largest
from kurbel.engine.arrays import KEY, SUBJECT, plain_steam
from kurbel.engine.irregularity import enclosed_delta
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.request import EngineRequest
from kurbel.errors import FailedError
from kurbel.exact.bulk import nearest
from kurbel.exact.certify import BALLS
from kurbel.kernel.loops import of_all
from kurbel.motion.bulk import float_bound
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.motion.long import motion
from kurbel.motion.motion_page import MOTION, Request
from kurbel.page.subject import Question
from kurbel.sweeps.columns import BOUND, GIVEN, AnsweredPlan, Cells, Column, Part, Rows, Way, columns_of
from kurbel.sweeps.coordinates import Coordinates
from kurbel.sweeps.hands import check_wanted
from kurbel.sweeps.over_angle import CertifiedOverAngle, OverAngle, has_arrays, is_over_angle
from kurbel.sweeps.plan import Floats, Places, Plan, Points
from kurbel.sweeps.records import FirstAnswer, Pointwise, first_of, questions

OF_MOTION = frozenset(("ratio", "angle"))
# Columns of so few rows stay near the processor, which saves a quarter of the time; of a long sweep the parts
# are to be fewer.
FEW, MANY, LONG = 1 << 18, 1 << 20, 1 << 32


@dataclass(frozen=True)
class Motion:
    """Floats of a kernel that takes arrays of both."""

    asked: AnsweredPlan
    question: Request
    in_threads: bool = True

    @property
    def rows_at_once(self) -> int:
        return FEW if len(self.asked.plan) <= LONG else MANY

    def rows(self, points: Points) -> Rows:
        told = self.asked.coordinates.at(points)
        ratios = told.get("ratio", np.full(len(points), float(self.question.cranks[0].ratio)))
        degrees = told.get("angle", np.full(len(points), float(self.question.angles[0])))
        good = (ratios >= 0) & (ratios < 1) & (np.abs(degrees) <= LARGEST_ANGLE)
        if good.all():
            return Rows(self._values(degrees, ratios), {})
        values = {column.key: np.full(len(points), np.nan) for column in self.asked.own}
        for key, found in self._values(degrees[good], ratios[good]).items():
            values[key][good] = found
        bad = np.flatnonzero(~good)
        refused = Pointwise(self.asked).rows(Points(points.places[bad], points.records[bad]))
        return Rows(values, {int(bad[place]): why for place, why in refused.reasons.items()})

    def _values(self, degrees: Floats, ratios: Floats) -> Cells:
        columns = self.question.page_columns
        keys, fast = [one.quantity.key for one in columns], of_all(len(self.asked.plan) * len(columns))
        found = motion(keys, degrees, ratios, columns[0].method, fast=fast)
        values = {one.key: array for one, array in zip(columns, found, strict=True)}
        if self.asked.plan.bounds:
            for one in columns:
                values[f"{one.key}{BOUND}"] = self._bounds(one, ratios)
        return values

    def _bounds(self, column: Any, ratios: Floats) -> Floats:
        known, places = np.unique(ratios, return_inverse=True)
        bounds = [float_bound(column, Crank(Fraction(ratio)), self._reach) for ratio in known.tolist()]
        return np.array(bounds)[places]

    @cached_property
    def _reach(self) -> float:
        axis = self.asked.plan.axes.get("angle")
        return float(largest(axis.values if axis else self.question.angles))


def is_motion(plan: Plan, question: Question) -> bool:
    """Whether a plan varies nothing but the ratio and the angle of a straight crank, of which nothing else
    need be known."""
    if (
        not isinstance(question, Request)
        or question.subject is not MOTION
        or not plan.axes.keys() <= OF_MOTION
    ):
        return False
    columns, crank = question.page_columns, question.cranks[0]
    plain = all(not one.quantity.needs and one.methods == columns[0].methods for one in columns)
    bare = crank == Crank(crank.ratio) and len(question.cranks) == 1
    single = "angle" in plan.axes or len(question.angles) == 1
    return (
        plan.digits is None
        and plain
        and bare
        and single
        and len(columns[0].methods) == 1
        and not question.zero
    )


OF_DELTA = frozenset(("eps", "ratio", "back", "clearance", "exponent"))
# What the work left depends on.
KEYS = ("eps", "back", "clearance", "exponent")


@dataclass(frozen=True)
class Irregularities:
    """Floats of `kurbel.compute_delta`; what it would refuse is asked of the single command."""

    asked: AnsweredPlan
    question: EngineRequest
    rows_at_once: int = 1 << 20
    in_threads: bool = True
    _known: dict[tuple[float, ...], str] = field(default_factory=dict, compare=False, repr=False)

    def rows(self, points: Points) -> Rows:
        told = self._inputs(points)
        found, bounds = enclosed_delta(told, (self.question.methods or ("exact",))[0])
        good = np.isfinite(bounds)
        digits = self.asked.plan.digits
        if digits is None:
            values = {KEY: found, f"{KEY}{BOUND}": bounds}
            own = {column.key: values[column.key] for column in self.asked.own}
            return Rows(own, self._refused(points, np.flatnonzero(~good), told, own))
        own, half_even = {KEY: np.full(len(points), None, object)}, self.question.rounding == "half-even"
        scaled, doubtful = nearest(found[good], digits, bounds[good], half_even=half_even)
        settled = np.flatnonzero(good)[~doubtful]
        own[KEY][settled] = scaled[~doubtful]
        left = np.setdiff1d(np.arange(len(points)), settled)
        reasons = self._refused(points, left, told, own)
        return Rows({KEY: own[KEY].tolist()}, reasons)

    def _refused(self, points: Points, rows: Places, told: Cells, values: Cells) -> dict[int, str]:
        """Return why these rows were refused; what the single command does not refuse has its values."""
        one, reasons = Pointwise(self.asked), dict[int, str]()
        for row in rows.tolist():
            # The work does not depend on the ratio, as long as there is one.
            ratio = float(told["ratio"][row])
            key: tuple[float, ...] = (-1.0,) if 0 <= ratio < 1 else (ratio,)
            key += tuple(float(told[name][row]) for name in KEYS if told[name] is not None)
            if key in self._known:
                reasons[row] = self._known[key]
                continue
            found = one.rows(Points(points.places[row : row + 1], points.records[row : row + 1]))
            if 0 in found.reasons:
                reasons[row] = self._known[key] = found.reasons[0]
            for name, array in found.values.items():
                values[name][row] = array[0]
        return reasons

    def _inputs(self, points: Points) -> Cells:
        steam, crank = self.question.steams[0], self.question.drives[0].crank
        assert isinstance(steam, Steam)
        own = {"eps": steam.expansion, "ratio": crank.ratio, "back": steam.back}
        own |= {"clearance": steam.clearance, "exponent": steam.exponent}
        told = self.asked.coordinates.at(points)
        return {
            name: told[name] if name in told else None if one is None else np.full(len(points), float(one))
            for name, one in own.items()
        }


def is_irregularity(plan: Plan, question: Question) -> bool:
    """Whether a plan varies nothing but ε, the ratio and the back pressure of the plain engine of which δ is
    asked."""
    if (
        not isinstance(question, EngineRequest)
        or question.subject.key != SUBJECT
        or not plan.axes.keys() <= OF_DELTA
    ):
        return False
    columns = question.page_columns
    one = [column.quantity.key for column in columns] == [KEY] and len(columns[0].methods) == 1
    single = len(question.steams) == len(question.drives) == 1 and question.wheel is None
    few = plan.digits is None or plan.digits <= MOST_DECIMALS
    return few and one and single and plain_steam(question, columns[0].method) is not None


def way_of(asked: AnsweredPlan) -> Way:
    """Return how the rows of a plan are computed."""
    plan, found = asked.plan, [*questions(asked.plan)]
    if plan.held or any(column.role == GIVEN for column in asked.columns):
        # It stands in the records alone.
        return Pointwise(asked)
    if asked.each == 1 and is_motion(plan, found[0]):
        assert isinstance(found[0], Request)
        return Motion(asked, found[0])
    if asked.each == 1 and all(is_irregularity(plan, one) for one in found):
        assert isinstance(found[0], EngineRequest)
        return Irregularities(asked, found[0])
    alone = any(len(group) == 1 and group[0].option == "angle" for group in plan.groups)
    if asked.each == 1 and alone and all(has_arrays(plan, one) for one in found):
        return OverAngle(asked)
    if asked.each == 1 and alone and all(map(is_over_angle, found)):
        return CertifiedOverAngle(asked)
    return Pointwise(asked)


@dataclass(frozen=True)
class Sweep:
    """A plan with its columns; it goes to other processes. Rows are counted from 0 to its length."""

    plan: Plan

    def __len__(self) -> int:
        return len(self.plan) * self.each

    @property
    def shape(self) -> tuple[int, ...]:
        """The sizes of the groups of the plan, or how many points of it are left, and of the records of a
        point, if there are several."""
        sizes = self.plan.sizes if self.plan.kept is None else (len(self.plan),)
        return (*sizes, *((self.each,) if self.each > 1 else ()))

    @property
    def rows_at_once(self) -> int:
        """How many rows make a part. It depends on the plan alone: a part is what a file has of it."""
        return self._way.rows_at_once

    @property
    def in_threads(self) -> bool:
        """Whether parts can be computed in several threads of a process at once; balls cannot."""
        return self._way.in_threads

    @cached_property
    def each(self) -> int:
        """How many records a point has."""
        return len(self._first.rows)

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """The columns: what varies, what the command says and, on request, how far floats may be off."""
        return columns_of(self.plan, *self._first)

    def part(self, start: int, stop: int) -> Part:
        """Return the rows from one to another; raise no KurbelError for points that are refused, unless the
        plan is strict."""
        found = self.computed(start, stop)
        return found._replace(values={**self.varied(start, stop), **found.values})

    def computed(self, start: int, stop: int) -> Part:
        """Return rows without the options that vary, in whatever thread this is."""
        check_wanted()
        points = self._points(start, stop)
        with nullcontext() if self.in_threads else BALLS:
            found = self._way.rows(points)
        values = {column.key: found.values[column.key] for column in self.columns if not column.option}
        part = Part(stop - start, values, found.reasons)
        if self.plan.strict and part.refused:
            row = min(part.refused)
            said = self.plan.in_words(int(points.places[row]))
            raise FailedError(f"{part.refused[row]}; this is of {said}, and --strict ends there")
        return part

    def varied(self, start: int, stop: int) -> Cells:
        """Return the values of the options that vary, by the keys of their columns."""
        axes = self._coordinates.at(self._points(start, stop))
        return {column.key: axes[column.option] for column in self.columns if column.option}

    def in_words(self, row: int) -> str:
        """Return the combination of a row in the words of the command line."""
        return self.plan.in_words(int(self._points(row, row + 1).places[0]))

    def _points(self, start: int, stop: int) -> Points:
        rows, kept = np.arange(start, stop), self.plan.kept
        places, records = (rows, np.zeros_like(rows)) if self.each == 1 else np.divmod(rows, self.each)
        if kept is not None:
            return Points(kept.points(places), records)
        return Points(places, records, start if self.each == 1 else None)

    @cached_property
    def _coordinates(self) -> Coordinates:
        return Coordinates(self.plan, {one.option: one.unit for one in self.columns if one.option})

    @cached_property
    def _way(self) -> Way:
        fields, rows, _ = self._first
        keys = {column.key for column in self.columns if column.role == "axis" and not column.option}
        apart = {
            field.key: [row[place] for row in rows] for place, field in enumerate(fields) if field.key in keys
        }
        return way_of(AnsweredPlan(self.plan, fields, self.each, self.columns, apart))

    @cached_property
    def _first(self) -> FirstAnswer:
        return first_of(self.plan)
