"""The time since the dead centre, ∫ dφ/ω, enclosed with proof in balls.

Times are in half turns of a crank that turns at v₁ all the while.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from kurbel.engine.speed.integral import Integral
from kurbel.engine.turn import Turn
from kurbel.kernel.circle import Number

if TYPE_CHECKING:
    from kurbel.engine.speed.run import AnyRun


class Clock:
    """The time over the cycle of a run in balls."""

    def __init__(self, run: AnyRun, turn: Turn) -> None:
        self.run, self.turn = run, turn
        self._courses: dict[int, Integral] = {}

    def time(self, half_turns: Fraction) -> Number:
        """Return the time at any angle; before the dead centre it is negative."""
        course, start = self._course, self.turn.pieces[0].start
        before, rest = divmod(half_turns - start, self.turn.cycle)
        time = course.before + course.to(start + rest)
        return time + int(before) * course.whole if before else time

    @property
    def _course(self) -> Integral:
        bits = flint.ctx.prec
        if bits not in self._courses:
            speed = self.run.speed_on
            self._courses[bits] = Integral(
                self.turn, lambda cylinders, piece, place: 1 / speed(cylinders, piece, place)
            )
        return self._courses[bits]
