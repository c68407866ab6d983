"""Long columns of points of the rod: all crank angles in floats with bounds."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from kurbel.exact.enclosures.functions import ENCLOSURES
from kurbel.motion.long.columns import LongColumns
from kurbel.motion.long.places import Places
from kurbel.motion.points.quantities import DIRECTION
from kurbel.page.axes import Place
from kurbel.page.quantity import Column


class PointColumns(LongColumns):
    """The columns of a question about points of the rod; directions have none."""

    def starts(self) -> Iterator[Fraction]:
        yield Fraction(0)

    def drives(self) -> Iterator[Any]:
        yield from self.question.drives

    def value(self, one: Column, place: Place, places: Places) -> Any:
        if one.quantity.of == DIRECTION:
            return NotImplemented
        return self.question.moved(place).value(one.quantity, places.angle.circle, ENCLOSURES)
