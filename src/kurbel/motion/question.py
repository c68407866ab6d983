"""What is asked for of straight or offset cranks, with all choices made."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.motion.digits import columns_in_balls, columns_in_floats, is_long, on_floats
from kurbel.motion.evaluation import needed
from kurbel.page.axes import angle_pairs
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Quantity
from kurbel.page.subject import Question


@dataclass(frozen=True, kw_only=True)
class AngleQuestion(Question, ABC):
    """What is asked for of drives at crank angles."""

    angles: Sequence[Fraction]

    @property
    @abstractmethod
    def ratios(self) -> list[Fraction]:
        """The ratios of the drives, where they have one."""

    @abstractmethod
    def curves(self, degrees: Any) -> list[list[list[float]]]:
        """Return the values of every column for every drive at an array of angles, in floats."""


@dataclass(frozen=True, kw_only=True)
class Request(AngleQuestion):
    """What is asked for of these cranks at these angles. `method` None leaves it to the layout.

    By the method of the infinite rod all ratios are 1:∞, but for a page that also has other formulas.
    """

    cranks: tuple[Crank, ...]
    method: str | None = None

    no_column = "--columns names no quantity; add one, for example --columns phi,x,c,p"

    def check(self) -> None:
        check_angles(self.angles)
        if not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if self.method and self.layout.fixed:
            raise ProblemError(
                f"layout {self.layout.key} states its formulas in its heads and takes no method;"
                " use --layout kinematics to choose one"
            )
        if any(crank.offset for crank in self.cranks):
            self._check_offset()
        if self.method == "infinite" and all(column.method is None for column in self.layout.columns):
            cranks = (replace(crank, ratio=Fraction(0)) for crank in self.cranks)
            object.__setattr__(self, "cranks", tuple(dict.fromkeys(cranks)))

    def _check_offset(self) -> None:
        if self.method not in (None, "exact"):
            raise ProblemError(
                f'method "{self.method}" has no formulas for an offset crank;'
                " use exact, or leave the offset out"
            )
        if any(column.method not in (None, "exact") for column in self.layout.columns):
            raise ProblemError(
                f"layout {self.layout.key} prints first-order formulas, which an offset crank does not have;"
                " use --layout kinematics or leave the offset out"
            )

    def too_long(self) -> str:
        return f"{len(self.cranks)} ratios at {len(self.angles)} angles make a table of {len(self)} rows"

    @property
    def ratios(self) -> list[Fraction]:
        return [crank.ratio for crank in self.cranks]

    def missing(self, quantity: Quantity) -> str:
        return needed(quantity, self.cranks)

    def chosen(self, keys: Sequence[str]) -> list[LayoutColumn]:
        # Beside foreign columns the layout's heads say too little, such as "Hingang" where all are paths.
        own, known = {column.key for column in self.layout.columns}, self.subject.quantities()
        if own >= set(keys):
            return super().chosen(keys)
        bare = {key: LayoutColumn(key, key) for key in known}
        return [bare.get(key) or super(Request, self).chosen([key])[0] for key in keys]

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (column.method or self.method or "exact",)

    @property
    def bulk(self) -> bool:
        """Whether so many cells are computed in arrays."""
        return is_long(self.page_columns, self.cranks, self.angles)

    @cached_property
    def values(self) -> list[Sequence[Any]]:
        """The scaled digits of the page by crank, column and angle."""
        compute = columns_in_floats if self.bulk else columns_in_balls
        angles = angle_pairs(self.angles) if self.layout.pairs else self.angles
        return [compute(self.page_columns, crank, angles, self.rounding) for crank in self.cranks]

    def curves(self, degrees: Any) -> list[list[list[float]]]:
        from kurbel.exact.bulk import evaluate

        found = [
            evaluate([on_floats(column, crank) for column in self.page_columns], degrees)
            for crank in self.cranks
        ]
        return [[one.tolist() for one in of_cranks] for of_cranks in zip(*found, strict=True)]
