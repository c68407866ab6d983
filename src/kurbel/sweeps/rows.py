"""The rows of a sweep: which way they are computed, part by part, in any process and in any order."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kurbel.engine.request import EngineRequest
from kurbel.errors import FailedError
from kurbel.exact.certify import BALLS
from kurbel.motion.motion_page import Request
from kurbel.sweeps.arrays import Irregularities, Motion, is_irregularity, is_motion
from kurbel.sweeps.columns import GIVEN, Asked, Cells, Column, Part, Way, columns_of
from kurbel.sweeps.coordinates import Coordinates
from kurbel.sweeps.hands import check_wanted
from kurbel.sweeps.over_angle import CertifiedOverAngle, OverAngle, has_arrays, is_over_angle
from kurbel.sweeps.plan import Plan, Points
from kurbel.sweeps.records import First, Pointwise, first_of, questions


def way_of(asked: Asked) -> Way:
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
        return way_of(Asked(self.plan, fields, self.each, self.columns, apart))

    @cached_property
    def _first(self) -> First:
        return first_of(self.plan)
