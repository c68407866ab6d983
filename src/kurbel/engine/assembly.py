"""An engine of unlike cylinders on one shaft, checked once."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.engine.engine import Engine, check_count
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.drive.load import Load as Acting
    from kurbel.drive.moved import Drive
    from kurbel.engine.engine import Load


@dataclass(frozen=True, slots=True)
class Assembly:
    """An engine made of parts, each of cylinders that are alike; a part follows the first by its `lag`.

    Forces are in the first part's Q, lengths in its R. All have a bore, a pressure and a stroke, by which
    their forces and torques compare, and one speed if they have masses. Valid for a first part without lag.
    """

    parts: tuple[Engine, ...]

    def __post_init__(self) -> None:
        if not self.parts:
            raise ProblemError("no cylinder was given; an engine has one or more")
        check_count(len(self.cranks))
        if self.parts[0].lag:
            raise ProblemError("the first cylinder's crank is at 0°; angles count from it")
        if len(self.parts) == 1:
            return
        for number, part in enumerate(self.parts, 1):
            if part.pressure is None or part.load is None or part.crank.radius is None:
                raise ProblemError(
                    f"cylinder {number} needs its bore, its pressure and its stroke to be compared with the"
                    " others"
                )
        speeds = {part.crank.speed for part in self.parts if part.crank.moving is not None}
        if len(speeds) > 1:
            raise ProblemError("the cylinders have masses at unlike speeds; one shaft has one speed")

    @property
    def first(self) -> Engine:
        """The part whose Q and R are the units."""
        return self.parts[0]

    def at_speed(self, factor: Fraction) -> Assembly:
        """Return the engine at so many times its speed, that of its masses."""
        parts = (part if part.crank.moving is None else part.at_speed(factor) for part in self.parts)
        return Assembly(tuple(parts))

    @property
    def drive(self) -> Drive:
        return self.first.drive

    @property
    def crank(self) -> Crank:
        return self.first.crank

    @property
    def steam(self) -> Acting:
        return self.first.steam

    @property
    def load(self) -> Load | None:
        return self.first.load

    @property
    def double(self) -> bool:
        return self.first.double

    @property
    def pressure(self) -> Fraction | None:
        return self.first.pressure

    @property
    def cranks(self) -> tuple[Fraction, ...]:
        """The angles in degrees by which all cranks follow the first."""
        return tuple(180 * start for part in self.parts for start in part.starts)

    @property
    def carded(self) -> bool:
        """Whether any piston force comes from an indicator card."""
        return any(part.carded for part in self.parts)

    @property
    def plain(self) -> bool:
        return len(self.parts) == 1 and self.first.plain
