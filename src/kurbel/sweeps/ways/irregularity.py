"""δ of the steam engine over expansion ratio, crank ratio and back pressure, in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.drive.crank import Crank
from kurbel.engine.engine import LARGEST_CLEARANCE, LARGEST_EXPANSION, LARGEST_EXPONENT, LEAST_CURVE, Steam
from kurbel.engine.irregularity import delta
from kurbel.engine.request import EngineRequest
from kurbel.exact.bulk import nearest
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.page.subject import Question
from kurbel.sweeps.axes import Coordinates
from kurbel.sweeps.columns import BOUND
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.way import Asked, Floats, Places, Points, Rows

AXES = frozenset(("eps", "ratio", "back", "clearance", "exponent"))
KEY, SUBJECT = "delta", "irregularity"
# Of the work left, in units of what is done and taken: where less is left the single command decides.
NEAR = 1e-9
# By what share a float can be off where all work is left, and by what for the rounding of its inputs.
UNITS, ROUNDED = 8e-15, 3e-16
# What is left to the kernel's defaults where it is usual, and what the work depends on.
FURTHER = ("clearance", "exponent")
KEYS = ("eps", "back", *FURTHER)


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
        with np.errstate(all="ignore"):
            done, taken, stretch = _work(told)
            good = _valid(told) & (done - taken > NEAR * (done + taken))
        found = self._found(told, good)
        with np.errstate(all="ignore"):
            share = (UNITS + ROUNDED * stretch) * (1 + (done + taken) / (done - taken))
            bounds = np.where(good, (share + ROUNDED / np.sqrt(1 - told["ratio"])) * found, np.nan)
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

    def _found(self, told: Mapping[str, Any], good: Any) -> Floats:
        """Return δ where it is good, elsewhere what is no number."""
        found = np.full(len(good), np.nan)
        if good.any():
            given: dict[str, Any] = {name: one if one is None else one[good] for name, one in told.items()}
            for name in FURTHER:
                if self._usual[name]:
                    given[name] = None
            found[good] = delta(**given, method=self._method)
        return found

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


def _work(told: Mapping[str, Any]) -> tuple[Floats, Floats, Floats]:
    """Return the mean pressures of the steam and against it, in units of that before cut-off, and by how much
    the rounding of the inputs counts in the first one."""
    clearance, exponent = told["clearance"], told["exponent"]
    cut = 1 / told["eps"] + clearance
    stretch = np.log((1 + clearance) / cut)
    bent = (1 - exponent) * stretch
    # Of n = 1 the integral of the power is the logarithm.
    curve = np.where(bent == 0, 1, np.expm1(bent) / np.where(bent == 0, 1, bent))
    done = 1 / told["eps"] + cut * stretch * curve
    best = np.exp(-exponent * stretch)
    return done, best if told["back"] is None else told["back"], exponent * stretch


def _valid(told: Mapping[str, Any]) -> Any:
    """Return where every input is one that the single command takes."""
    eps, ratio, clearance, exponent = (told[name] for name in ("eps", "ratio", "clearance", "exponent"))
    good = (eps >= 1) & (eps <= LARGEST_EXPANSION) & (ratio >= 0) & (ratio < 1)
    good &= (
        (clearance >= 0) & (clearance <= LARGEST_CLEARANCE) & (exponent > 0) & (exponent <= LARGEST_EXPONENT)
    )
    good &= (exponent == 1) | (np.abs(exponent - 1) > float(2 * LEAST_CURVE))
    return good if told["back"] is None else good & (told["back"] >= 0) & (told["back"] <= 1)


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
    return few and one and single and _is_plain(question)


def _is_plain(question: EngineRequest) -> bool:
    steam, drive = question.steams[0], question.drives[0]
    if not isinstance(steam, Steam):
        return False
    if question.methods == ("weisbach",) and (steam.clearance or steam.exponent != Fraction(1)):
        return False
    straight = question.mechanism.name == "straight" and drive.crank == Crank(drive.crank.ratio)
    return straight and question.double and len(question.cranks) == 1
