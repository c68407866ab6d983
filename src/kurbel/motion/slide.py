"""The straight or offset crank as conditions see it: what can be asked of it, also with masses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, half_turn_circle, rounded
from kurbel.exact.course import Course
from kurbel.exact.jet import Jet
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Label
from kurbel.exact.place import Place
from kurbel.exact.terms import vanishes
from kurbel.kernel import kinematics
from kurbel.motion.captions import Formulated, drive_notes, formula_lines
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import LOADED, OUT, typed, value
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Column, Formula, Quantity, multiplied, words
from kurbel.reading.where import SHARE

# What is zero at dead centres where all acts along the slide.
TURNING = ("torque_nm", "tangential_force_n")


class SlideDrive(Drive):
    """The straight or offset crank."""

    def __init__(self, crank: Crank, method: str = "exact") -> None:
        super().__init__(crank, slide_columns())
        self.method = method

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.crank, self.method)

    @property
    def is_straight(self) -> bool:
        return not (self.crank.offset and self.crank.ratio)

    def at_dead_centre(self, stroke: int) -> Fraction | None:
        # p = 1 ± λ by every formula.
        return 1 + stroke * self.ratio if self.is_straight else None

    def digits(
        self,
        column: str,
        stroke: int,
        place: Place,
        decimals: int,
        rounding: str,
        times: Fraction = Fraction(1),
    ) -> int:
        # No ball tells which way a piston goes that rests: friction is that of the stroke which begins there.
        way = self._way_from(stroke, place) if self.crank.rubbed and place.degrees is None else None
        if way is None:
            return super().digits(column, stroke, place, decimals, rounding, times)
        quantity = multiplied(self.entries[column]._replace(stroke=stroke), times)

        def at() -> Any:
            circle = half_turn_circle(place.half_turns())
            return value(quantity, self.method, self.crank, circle, balls(), way=way)

        return rounded(at, decimals, rounding, NEVER_TIES)

    def _way_from(self, stroke: int, place: Place) -> int | None:
        """Return which way the piston goes from a dead centre of the stroke, None of another place."""
        course = self.course(SHARE, stroke)
        return {course.begin: 1, course.end: -1}.get(place)

    def jet(self, quantity: Quantity) -> Jet | None:
        """Return the quantity with its slopes; what masses add to a force has no rational numbers in it."""
        return None if self._is_loaded(quantity) else super().jet(quantity)

    @property
    def _is_pushed_alone(self) -> bool:
        """Whether all that acts does so on the piston, along the slide."""
        moving = self.crank.moving
        return self.crank.effort is None and (moving is None or moving.rod is None)

    def _is_loaded(self, quantity: Quantity) -> bool:
        return self.crank.loaded and LOADED in quantity.formulas

    def _course(self, quantity: str, stroke: int) -> Course:
        one = self.asked(quantity, stroke)
        if not self._is_loaded(one):
            return super()._course(quantity, stroke)
        # In a dead centre what acts on the piston has no torque; across that of the straight crank nothing
        # acts, and balls know it.
        return self.by_balls(one, stroke, *(TURNING if self._is_pushed_alone else ()))

    def asked(self, quantity: str, stroke: int) -> Quantity:
        """Return what a condition is about: of the rod angle its sine."""
        found = super().asked(quantity, stroke)
        if quantity != "psi":
            return found
        sine = Formula(lambda at: kinematics.rod_sine(at.circle, at.ratio, at.offset or 0))
        return found._replace(formulas=dict.fromkeys(found.formulas, sine), unit=words(""))

    def unclosed(self, quantity: Quantity, course: Course) -> Course:
        # A stroke √a - √b with an irrational root is irrational.
        ends = (Fraction(0), Fraction(1) if quantity.key == "x_stroke" else None)

        def is_exactly(half_turns: Fraction, wanted: Fraction) -> bool:
            def apart(kind: Kind) -> Any:
                return self.value(quantity, kind.circle(180 * half_turns), kind) - kind.of(wanted)

            return vanishes(apart)

        return replace(course, ends=ends, is_exactly=is_exactly)

    def ends(self, stroke: int) -> tuple[Place, Place]:
        if self.is_straight:
            return super().ends(stroke)
        angle = self.crank.dead_angle
        angles = (lambda: angle(stroke, balls()) / 180, lambda: 1 + angle(-stroke, balls()) / 180)
        return self.rests(self.asked("c", stroke), angles)

    def formula_lines(self, question: Formulated, columns: Sequence[Column]) -> Iterator[Label]:
        return formula_lines(question, columns)

    def closing_lines(self, question: Formulated) -> Iterable[Label]:
        return drive_notes(question.cranks, question.lang)


@cache
def slide_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place of the straight or offset crank."""
    return {key: one for key, one in registry().items() if one.stroke == OUT}


def slide_drives(cranks: Sequence[Crank], method: str) -> tuple[SlideDrive, ...]:
    """Return the drives of these cranks by a method; that of the infinite rod makes all ratios 1:∞."""
    if method != "exact" and any(crank.offset for crank in cranks):
        raise ProblemError(
            f'method "{typed(method)}" has no formulas for an offset crank;'
            " use exact, or leave the offset out"
        )
    if method == "infinite":
        cranks = tuple(dict.fromkeys(replace(crank, ratio=Fraction(0)) for crank in cranks))
    return tuple(SlideDrive(crank, method) for crank in cranks)
