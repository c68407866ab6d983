"""The task that a flywheel has: at which power and speed, and how even the turning is to be."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.reading.notation import about
from kurbel.reading.units import Speed

# No engine is beyond these, and figures beyond them do not fit a page.
LEAST, MOST = Fraction(1, 10**9), Fraction(10**12)


@dataclass(frozen=True, slots=True)
class Flywheel:
    """Power in watts, None where it follows from the steam, speed, the degree of irregularity
    δ = (v_max - v_min)/v to keep, and the radius in metres at which a mass is wanted, if one is."""

    power: Fraction | None
    speed: Speed
    irregularity: Fraction
    radius: Fraction | None = None

    def __post_init__(self) -> None:
        if self.power is not None:
            _check("the power", self.power, "W")
        _check("the speed", self.speed.value, "1/s")
        check_irregularity(self.irregularity)
        if self.radius is not None:
            _check("the radius of the flywheel", self.radius, "m")


def check_irregularity(irregularity: Fraction) -> None:
    """Raise ProblemError for a degree of irregularity that no flywheel can keep."""
    if not LEAST <= irregularity < 2:
        raise ProblemError(
            f"degree of irregularity δ is {about(irregularity)}; it must be at least 10^-9 and below"
            " 2, at which the flywheel would come to rest in every turn"
        )


def _check(what: str, value: Fraction, unit: str) -> None:
    if not LEAST <= value <= MOST:
        raise ProblemError(f"{what} is {about(value)} {unit}; it must lie within 10^-9 and 10^12 {unit}")
