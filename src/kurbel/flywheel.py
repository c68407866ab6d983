"""The task that a flywheel has: at which power and speed, and how even the turning is to be."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.notation import about
from kurbel.problem import Speed


@dataclass(frozen=True, slots=True)
class Flywheel:
    """Power in watts, speed, the degree of irregularity δ = (v_max - v_min)/v to keep, and the radius in
    metres at which a mass is wanted, if one is."""

    power: Fraction
    speed: Speed
    irregularity: Fraction
    radius: Fraction | None = None

    def __post_init__(self) -> None:
        if self.power <= 0:
            raise ProblemError(f"the power is {about(self.power)} W; it must be above 0")
        if not 0 < self.irregularity < 2:
            raise ProblemError(
                f"degree of irregularity δ is {about(self.irregularity)}; it must be above 0 and below 2,"
                " at which the flywheel would come to rest in every turn"
            )
        if self.radius is not None and self.radius <= 0:
            raise ProblemError(f"the radius of the flywheel is {about(self.radius)} m; it must be above 0")
