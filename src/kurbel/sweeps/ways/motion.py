"""The motion of the straight crank over its ratio and the crank angle, both as arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.drive.crank import LARGEST_ANGLE, Crank, largest
from kurbel.kernel.fast.worth import of_all
from kurbel.motion.arrays import motion
from kurbel.motion.bulk import float_bound
from kurbel.motion.page import MOTION, Request
from kurbel.page.subject import Question
from kurbel.sweeps.axes import Coordinates
from kurbel.sweeps.columns import BOUND
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.way import Asked, Floats, Points, Rows

AXES = frozenset(("ratio", "angle"))
# Columns of so few rows stay near the processor, which saves a quarter of the time; of a long sweep the parts
# are to be fewer.
FEW, MANY, LONG = 1 << 18, 1 << 20, 1 << 32


@dataclass(frozen=True)
class Motion:
    """Floats of a kernel that takes arrays of both."""

    asked: Asked
    question: Request
    in_threads: bool = True

    @property
    def rows_at_once(self) -> int:
        return FEW if len(self.asked.plan) <= LONG else MANY

    def rows(self, points: Points) -> Rows:
        told = self._coordinates.at(points)
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

    def _values(self, degrees: Floats, ratios: Floats) -> Mapping[str, Any]:
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
        axes = {axis.option: axis.values for group in self.asked.plan.groups for axis in group}
        return float(largest(axes.get("angle", self.question.angles)))

    @cached_property
    def _coordinates(self) -> Coordinates:
        return Coordinates(self.asked.plan)


def is_motion(plan: Plan, question: Question) -> bool:
    """Whether a plan varies nothing but the ratio and the angle of a straight crank, of which nothing else
    need be known."""
    own = {axis.option for group in plan.groups for axis in group}
    if not isinstance(question, Request) or question.subject is not MOTION or not own <= AXES:
        return False
    columns, crank = question.page_columns, question.cranks[0]
    plain = all(not one.quantity.needs and one.methods == columns[0].methods for one in columns)
    bare = crank == Crank(crank.ratio) and len(question.cranks) == 1
    single = "angle" in own or len(question.angles) == 1
    return (
        plan.digits is None
        and plain
        and bare
        and single
        and len(columns[0].methods) == 1
        and not question.zero
    )
