"""The general way: the command is asked at every combination, and its certified digits become floats."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from threading import Lock
from typing import Any

from kurbel.errors import KurbelError
from kurbel.sweeps.columns import MISSING
from kurbel.sweeps.ways.records import rows_at
from kurbel.sweeps.ways.way import Asked, Points, Rows, columns_from

BALLS = Lock()
# Rows of a part that is computed in balls: about a second.
IN_BALLS = 1 << 9


@dataclass(frozen=True)
class Pointwise:
    """Every point is a question; a second of them at once, or less."""

    asked: Asked
    rows_at_once: int = IN_BALLS
    in_threads: bool = False

    def rows(self, points: Points) -> Rows:
        # The precision of balls is that of the process, and other ways run in several threads.
        with BALLS:
            return self._rows(points)

    def _rows(self, points: Points) -> Rows:
        plan, fields, each = self.asked.plan, self.asked.fields, self.asked.each
        apart = self.asked.apart
        found: list[Mapping[str, Any]] = []
        reasons: dict[int, str] = {}
        last, answer, refused = -1, list[dict[str, Any] | None](), ""
        for row, (point, record) in enumerate(
            zip(points.places.tolist(), points.records.tolist(), strict=True)
        ):
            if point != last:
                last, refused = point, ""
                try:
                    answer = rows_at(plan, plan.at(point), fields, apart, each)
                except KurbelError as error:
                    refused = str(error)
            one = None if refused else answer[record]
            if one is None:
                # A combination is refused once.
                reasons[row] = refused if refused and not record else MISSING
            # Also what is not there is told apart.
            found.append(one or {key: values[record] for key, values in apart.items()})
        return columns_from(self.asked, found, reasons)
