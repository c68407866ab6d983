"""Bounds that the numbers of several loads share, each with its sentence."""

from __future__ import annotations

from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.reading.notation import about

LARGEST_RATIO = 10**6
LARGEST_EXPONENT = 10
LARGEST_CLEARANCE = 10
LARGEST_LOSS = 10
# The work is a quotient by n - 1.
LEAST_CURVE = Fraction(1, 10**6)
# Below this share of Q times the stroke nothing is done, and δ, counted in it, grows beyond all bounds.
LEAST_WORK = 1e-9


def check_exponent(exponent: Fraction, what: str) -> None:
    """Raise ProblemError unless p V^n = const can have it."""
    if not 0 < exponent <= LARGEST_EXPONENT:
        raise ProblemError(
            f"{what} is {about(exponent)}; it must be above 0 and at most {LARGEST_EXPONENT},"
            " for the pressure rises as the volume shrinks"
        )
    if 0 < abs(exponent - 1) < LEAST_CURVE:
        raise ProblemError(
            f"{what} is {about(exponent)}, nearer to 1 than 10^-6; write 1, Mariotte's law,"
            " whose results have the same six figures"
        )


def check_clearance(clearance: Fraction) -> None:
    """Raise ProblemError unless a cylinder can have it."""
    if not 0 <= clearance <= LARGEST_CLEARANCE:
        raise ProblemError(
            f"clearance is {about(clearance)}; it must lie within 0..{LARGEST_CLEARANCE},"
            " for it is a share of the volume swept in a stroke"
        )
