"""The radius of gyration of a rod from the time in which it swings about one of its pins."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from kurbel.drive.rod import CROSSHEAD, Rod, Swing
from kurbel.drive.slope import GREATEST_GRAVITY, STANDARD_GRAVITY
from kurbel.errors import ProblemError
from kurbel.reading.notation import about

# Of π², far beyond the 50 decimals that are printed at most.
BITS = 600


def given_swing(time: Fraction | None, pin: str | None, gravity: Fraction | None) -> Swing:
    """Return the swing that is described. Raises ProblemError where the time or the pin is missing."""
    if time is None:
        raise ProblemError(
            "--pendulum-from is for --pendulum, the time of a full swing; add it, such as 1.8s"
        )
    if pin is None:
        raise ProblemError(
            "--pendulum needs the pin about which the rod swung; add --pendulum-from crosshead"
        )
    if gravity is not None and not 0 < gravity <= GREATEST_GRAVITY:
        raise ProblemError(f"gravity is {about(gravity)} m/s²; it must be above 0 and at most 1000")
    return Swing(time, pin, STANDARD_GRAVITY if gravity is None else gravity)


def swung_rod(
    swing: Swing, centre: Fraction | None, length: Fraction | None, mass: Fraction | None = None
) -> Rod:
    """Return the rod with its centre of mass a/L from the crosshead pin, of so many metres between its pins.

    k² = g d T²/(4 π²) - d², d the distance of the centre of mass from the pin about which it swings, T the
    time of a small swing to and fro. Valid for d > 0 and where k² is above 0.
    """
    if centre is None:
        raise ProblemError("--pendulum needs the centre of mass, about which k is taken; add --centre")
    if length is None:
        raise ProblemError("--pendulum needs the length of the rod; add --stroke and one --ratio, or --rod")
    distance = (centre if swing.pin == CROSSHEAD else 1 - centre) * length
    if distance <= 0:
        raise ProblemError(f"the rod does not swing about the {swing.pin} pin, where its centre of mass is")
    square = swing.gravity * distance * swing.time**2 / 4 * _per_pi_square() - distance**2
    if square <= 0:
        shortest = 2 * (float(distance / swing.gravity) * float(1 / _per_pi_square())) ** 0.5
        raise ProblemError(
            f"a swing of {about(swing.time)} s is too short: with all its mass {about(distance)} m from the"
            f" pin the rod would take {shortest:.4g} s; the time is that of a full swing, to and fro"
        )
    return Rod(1 - centre, square / length**2, mass, swing)


def _per_pi_square() -> Fraction:
    """Return 1/π² to so many bits."""
    import flint

    with flint.ctx.workprec(BITS):
        near: Any = (1 / flint.arb.pi() ** 2).mid()
        mantissa, exponent = near.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
