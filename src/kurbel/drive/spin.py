"""How the crank turns at a moment: its angular velocity, and its angular acceleration if it has one."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank import known
from kurbel.errors import ProblemError
from kurbel.kernel import kinematics
from kurbel.reading.given import as_angular_acceleration

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.exact.kind import Kind
    from kurbel.reading.units import Speed

# The angles within ±90° of a rational number of degrees that have a rational sine (Niven).
_RATIONAL = {Fraction(0): Fraction(0), Fraction(1, 2): Fraction(30), Fraction(-1, 2): Fraction(-30)}


def angular_velocity(crank: Crank, numbers: Kind) -> Any:
    """Return ω in rad/s."""
    speed = known(crank.speed)
    omega = numbers.of(2 * speed.value if speed.turns else speed.value)
    return omega * numbers.pi if speed.turns else omega


def angular_square(crank: Crank, numbers: Kind) -> Any:
    """Return ω² in 1/s²."""
    omega = angular_velocity(crank, numbers)
    return omega * omega


def gain(crank: Crank, numbers: Kind) -> Any:
    """Return α/ω²: so much of a velocity adds to an acceleration, in units of the even crank's."""
    return numbers.of(crank.acceleration) / angular_square(crank, numbers)


def begun(crank: Crank, stroke: int) -> Fraction | None:
    """Return the dead centre where a stroke begins as `Crank.dead_angle` does, exactly; None if it is
    irrational."""
    sine = kinematics.dead_centre_sine(stroke * crank.ratio, stroke * crank.offset)
    return _RATIONAL.get(sine)


def turned(crank: Crank, stroke: int, degrees: Any, numbers: Kind) -> Any:
    """Return by how much of a turn the crank, at φ of the stroke in degrees, is beyond where that begins."""
    exact = begun(crank, stroke)
    first = crank.dead_angle(stroke, numbers) if exact is None else numbers.of(exact)
    return (degrees - first) / 360


def turn_time(crank: Crank, numbers: Kind) -> Any:
    """Return the time of an even turn in seconds."""
    speed = known(crank.speed)
    time = numbers.of((1 if speed.turns else 2) / speed.value)
    return time if speed.turns else time * numbers.pi


def acceleration_of(given: object, speed: Speed | None) -> Fraction:
    """Return α in rad/s². Raises ProblemError without a speed."""
    if speed is None:
        raise ProblemError(
            "--acceleration is that of the crank at the speed it has; add that, for example --speed 120/min"
        )
    return as_angular_acceleration(given, "acceleration")
