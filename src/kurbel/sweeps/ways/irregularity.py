"""δ of the steam engine over expansion ratio, crank ratio and back pressure, in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.engine.engine import Steam
from kurbel.engine.irregularity import enclosed
from kurbel.engine.long.irregularity import KEY, SUBJECT, plain_steam
from kurbel.engine.request import EngineRequest
from kurbel.exact.bulk import nearest
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.page.subject import Question
from kurbel.sweeps.axes import Coordinates
from kurbel.sweeps.columns import BOUND
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.way import Asked, Places, Points, Rows

AXES = frozenset(("eps", "ratio", "back", "clearance", "exponent"))
# What is left to the kernel's defaults where it is usual, and what the work left depends on.
FURTHER = ("clearance", "exponent")
KEYS = ("eps", "back", *FURTHER)


@dataclass(frozen=True)
class Irregularities:
    """Floats of `kurbel.compute_delta`; what it would refuse is asked of the single command."""

    asked: Asked
    question: EngineRequest
    rows_at_once: int = 1 << 20
    in_threads: bool = True
    _known: dict[tuple[float, ...], str] = field(default_factory=dict, compare=False, repr=False)

    def rows(self, points: Points) -> Rows:
        told = self._inputs(points)
        usual = [name for name in FURTHER if self._usual[name]]
        found, bounds = enclosed(told, self._method, usual)
        good = np.isfinite(bounds)
        digits = self.asked.plan.digits
        if digits is None:
            values = {KEY: found, f"{KEY}{BOUND}": bounds}
            own = {column.key: values[column.key] for column in self.asked.own}
            return Rows(own, self._refused(points, np.flatnonzero(~good), told, own))
        own = {KEY: np.full(len(points), None, object)}
        scaled, doubtful = nearest(found[good], digits, bounds[good], half_even=self._half_even)
        settled = np.flatnonzero(good)[~doubtful]
        own[KEY][settled] = scaled[~doubtful]
        left = np.setdiff1d(np.arange(len(points)), settled)
        reasons = self._refused(points, left, told, own)
        return Rows({KEY: own[KEY].tolist()}, reasons)

    @property
    def _half_even(self) -> bool:
        return self.asked.plan.given.get("rounding") == "half-even"

    def _refused(
        self, points: Points, rows: Places, told: Mapping[str, Any], values: Mapping[str, Any]
    ) -> dict[int, str]:
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

    def _inputs(self, points: Points) -> dict[str, Any]:
        steam, crank = self.question.steams[0], self.question.drives[0].crank
        assert isinstance(steam, Steam)
        own = {"eps": steam.expansion, "ratio": crank.ratio, "back": steam.back}
        own |= {"clearance": steam.clearance, "exponent": steam.exponent}
        told = self._coordinates.at(points)
        return {
            name: told[name] if name in told else None if one is None else np.full(len(points), float(one))
            for name, one in own.items()
        }

    @cached_property
    def _usual(self) -> Mapping[str, bool]:
        """Which options are nowhere other than they are where nothing is said of them."""
        steam, varied = self.question.steams[0], self.asked.plan.varied
        assert isinstance(steam, Steam)
        return {
            "clearance": steam.clearance == 0 and "clearance" not in varied,
            "exponent": steam.exponent == 1 and "exponent" not in varied,
        }

    @property
    def _method(self) -> str:
        return (self.question.methods or ("exact",))[0]

    @cached_property
    def _coordinates(self) -> Coordinates:
        return Coordinates(self.asked.plan)


def is_irregularity(plan: Plan, question: Question) -> bool:
    """Whether a plan varies nothing but ε, the ratio and the back pressure of the plain engine of which δ is
    asked."""
    own = {axis.option for group in plan.groups for axis in group}
    if not isinstance(question, EngineRequest) or question.subject.key != SUBJECT or not own <= AXES:
        return False
    columns = question.page_columns
    one = [column.quantity.key for column in columns] == [KEY] and len(columns[0].methods) == 1
    single = len(question.steams) == len(question.drives) == 1 and question.wheel is None
    few = plan.digits is None or plan.digits <= MOST_DECIMALS
    return few and one and single and plain_steam(question, columns[0].method) is not None
