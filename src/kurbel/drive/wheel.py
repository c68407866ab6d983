"""A flywheel that is given, from which the speed over the turn follows, and the task that one has."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.reading.notation import about, check_bounds
from kurbel.reading.units import Speed

# No engine is beyond these, and figures beyond them do not fit a page.
LEAST, MOST = Fraction(1, 10**9), Fraction(10**12)
CONSTANT, SQUARE = "constant", "square"
RESISTANCES = (CONSTANT, SQUARE)


@dataclass(frozen=True, slots=True)
class Wheel:
    """A flywheel, by its `number` M = m₁ v₁²/(P r) or its moment of inertia in kg m², one of which is given.

    `speed` is the mean one, ½ (ω_max + ω_min), and `power` in watts makes the mean torque with it; None
    where they are not known. Against a `resistance` that is not constant it is as the square of the speed.
    """

    number: Fraction | None = None
    inertia: Fraction | None = None
    speed: Speed | None = None
    power: Fraction | None = None
    resistance: str = CONSTANT

    def __post_init__(self) -> None:
        if self.number is not None:
            _check("the number of the flywheel, m₁v₁²/(P r),", self.number)
        if self.inertia is not None:
            _check("the moment of inertia", self.inertia, " kg m²")
        if self.power is not None:
            _check("the power", self.power, " W")

    @property
    def letter(self) -> str:
        """What sentences call what it is given by."""
        return "m₁v₁²/(P r)" if self.inertia is None else "J"

    @property
    def unit(self) -> str:
        return "" if self.inertia is None else " kg m²"

    @property
    def named(self) -> str:
        """What sentences call it."""
        if self.inertia is not None:
            return f"the flywheel of J = {about(self.inertia)} kg m²"
        assert self.number is not None
        return f"the flywheel of m₁v₁²/(P r) = {about(self.number)}"


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
            _check("the power", self.power, " W")
        _check("the speed", self.speed.value, " 1/s")
        check_irregularity(self.irregularity)
        if self.radius is not None:
            _check("the radius of the flywheel", self.radius, " m")


def check_irregularity(irregularity: Fraction) -> None:
    """Raise ProblemError for a degree of irregularity that no flywheel can keep."""
    check_bounds(
        "degree of irregularity δ", irregularity,
        "be at least 10^-9 and below 2, at which the flywheel would come to rest in every turn",
    )  # fmt: skip


def _check(what: str, value: Fraction, unit: str = "") -> None:
    if not LEAST <= value <= MOST:
        raise ProblemError(f"{what} is {about(value)}{unit}; it must lie within 10^-9 and 10^12{unit}")
