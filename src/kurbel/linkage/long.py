"""Long columns of crank drives without a crosshead: all crank angles in floats with bounds."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from kurbel.exact.enclosures.functions import ENCLOSURES
from kurbel.motion.evaluation import value
from kurbel.motion.long.columns import LongColumns
from kurbel.motion.long.places import Places
from kurbel.page.axes import Place
from kurbel.page.quantity import Column


class LinkageColumns(LongColumns):
    """The columns of a question about drives alike but for their ratios."""

    def starts(self) -> Iterator[Fraction]:
        yield Fraction(0)

    def drives(self) -> Iterator[Any]:
        yield from self.question.drives

    def value(self, one: Column, place: Place, places: Places) -> Any:
        drive = self.question.drives[place.get("ratio", 0)]
        return value(one.quantity, "exact", drive, places.angle.circle, ENCLOSURES)
