"""δ of very many steam engines: floats with bounds first, and balls for the doubtful ones."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Steam
from kurbel.engine.irregularity import enclosed
from kurbel.engine.request import EngineRequest
from kurbel.exact.bulk import nearest
from kurbel.exact.numerals import Number
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.page.axes import Place
from kurbel.page.quantity import Column

KEY, SUBJECT = "delta", "irregularity"


class Irregularities:
    """The column δ of a question about all engines of some expansion and crank ratios."""

    def __init__(self, request: EngineRequest) -> None:
        self.request = request
        self._digits = lru_cache(8)(self._nearest)

    def is_worth(self) -> bool:
        """Whether all are plain engines, of which floats have a bound."""
        return self.request.subject.key == SUBJECT and plain_steam(self.request, "exact") is not None

    def number(self, column: Column, place: Place) -> Number | None:
        """Return the number of an engine, None where balls must settle it."""
        few = column.decimals is not None and column.decimals <= MOST_DECIMALS
        if column.quantity.key != KEY or len(column.methods) > 1 or column.least or not few:
            return None
        scaled, doubtful = self._digits(column.method, column.places)
        engine = place["expansion"] * len(self.request.drives) + place["ratio"]
        return None if doubtful[engine] else Number(int(scaled[engine]), column.places)

    def _nearest(self, method: str, decimals: int) -> tuple[Any, Any]:
        steams, ratios = self.request.steams, [float(one) for one in self.request.ratios]
        steam = plain_steam(self.request, method)
        if steam is None:
            every = len(steams) * len(ratios)
            return np.zeros(every, np.int64), np.ones(every, bool)

        def over(name: str) -> Any:
            return np.repeat([float(getattr(one, name)) for one in steams], len(ratios))

        given = {"eps": over("expansion"), "ratio": np.tile(ratios, len(steams))}
        given |= {"clearance": over("clearance"), "exponent": over("exponent")}
        given["back"] = None if steam.back is None else over("back")
        usual = [name for name, plain in (("clearance", 0), ("exponent", 1)) if getattr(steam, name) == plain]
        found, bounds = enclosed(given, method, usual)
        return nearest(found, decimals, bounds, half_even=self.request.rounding == "half-even")


def plain_steam(request: EngineRequest, method: str) -> Steam | None:
    """Return the first steam of plain engines, straight and double-acting with one crank and no masses; None
    of others, of those that the method does not have, and where more than ε differs from one steam to the
    next."""
    first, *others = request.steams
    if not isinstance(first, Steam) or request.mechanism.name != "straight":
        return None
    if not request.double or len(request.cranks) != 1 or request.assembly is not None:
        return None
    if any(drive.crank != Crank(drive.crank.ratio) for drive in request.drives):
        return None
    if method == "weisbach" and (first.clearance or first.exponent != 1):
        return None
    kept = first.back, first.exponent, first.clearance
    alike = all(isinstance(one, Steam) and (one.back, one.exponent, one.clearance) == kept for one in others)
    return first if alike else None
