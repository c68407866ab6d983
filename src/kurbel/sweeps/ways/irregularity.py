"""δ of the steam engine over expansion ratio, crank ratio and back pressure, in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.drive.crank import Crank
from kurbel.engine.engine import LARGEST_EXPANSION, Steam
from kurbel.engine.irregularity import delta
from kurbel.engine.request import EngineRequest
from kurbel.page.subject import Question
from kurbel.sweeps.axes import Coordinates
from kurbel.sweeps.columns import BOUND
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.way import Asked, Floats, Places, Points, Rows

AXES = frozenset(("eps", "ratio", "back"))
KEY, SUBJECT = "delta", "irregularity"
# Of the work left, in units of what is taken from it: where less is left the single command decides.
NEAR = 1e-9
# By what share a float can be off where all work is left, and by what for the rounding of its inputs.
UNITS, ROUNDED = 4e-15, 3e-16


@dataclass(frozen=True)
class Irregularities:
    """Floats of `kurbel.delta`; what it would refuse is asked of the single command."""

    asked: Asked
    question: EngineRequest
    rows_at_once: int = 1 << 20
    in_threads: bool = True
    _known: dict[tuple[float, ...], str] = field(default_factory=dict, compare=False, repr=False)

    def rows(self, points: Points) -> Rows:
        told = self._inputs(points)
        eps, ratio, back = told["eps"], told["ratio"], told["back"]
        with np.errstate(divide="ignore", invalid="ignore"):
            taken = eps * (1 / eps if back is None else back)
            left = 1 + np.log(eps) - taken
            good = (eps >= 1) & (eps <= LARGEST_EXPANSION) & (ratio >= 0) & (ratio < 1)
            good &= left > NEAR * (1 + taken)
        if back is not None:
            good &= (back >= 0) & (back <= 1)
        values = {column.key: np.full(len(points), np.nan) for column in self.asked.own}
        if good.any():
            given = (eps[good], ratio[good], None if back is None else back[good])
            values[KEY][good] = delta(*given, method=self._method)
        if self.asked.plan.bounds:
            share = UNITS * (1 + (1 + taken[good]) / left[good]) + ROUNDED / np.sqrt(1 - ratio[good])
            values[f"{KEY}{BOUND}"][good] = share * values[KEY][good]
        return Rows(values, self._refused(points, np.flatnonzero(~good), told, values))

    def _refused(
        self, points: Points, rows: Places, told: Mapping[str, Any], values: Mapping[str, Floats]
    ) -> dict[int, str]:
        """Return why these rows were refused; what the single command does not refuse has its values."""
        one, reasons = Pointwise(self.asked), dict[int, str]()
        for row in rows.tolist():
            # The work does not depend on the ratio, as long as there is one.
            ratio = float(told["ratio"][row])
            key = (float(told["eps"][row]), *(() if told["back"] is None else (float(told["back"][row]),)))
            key += (-1.0,) if 0 <= ratio < 1 else (ratio,)
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
        told = self._coordinates.at(points)
        return {
            name: told[name] if name in told else None if one is None else np.full(len(points), float(one))
            for name, one in own.items()
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
    return plan.digits is None and one and single and _is_plain(question)


def _is_plain(question: EngineRequest) -> bool:
    steam, drive = question.steams[0], question.drives[0]
    usual = isinstance(steam, Steam) and steam == Steam(steam.expansion, steam.back)
    straight = question.mechanism.name == "straight" and drive.crank == Crank(drive.crank.ratio)
    return usual and straight and question.double and len(question.cranks) == 1
