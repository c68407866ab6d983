"""Rötscher's GF = CF²/(2 L - GF), step by step, in units of the crank radius R.

C lies on a circle of radius L about K; G and F are where the circle and the perpendicular from C meet the
slide line. The exact GF is L (1 - cos ψ), `kernel.kinematics.rod_versine`. From GF = 0 the steps rise to it:
the step keeps GF and 2 L - GF, and the distances from these are in a ratio that each step makes q times as
large, q = GF/(2 L - GF) = tan² ½ψ. So the k-th is GF (1 - q^k)/(1 - q^(k+1)), and

    0 < GF - GF_k < q^k GF, and each step leaves less than q of the distance.

Source of the equation: Rötscher, at the end of Ermittlung der Kolbenwege; the rest re-derived.
"""

from __future__ import annotations

from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.kinematics import rod_cosine, rod_versine


def after(circle: Circle[Number], ratio: Number, steps: int) -> Number:
    """Return GF after so many steps from GF = 0; the first is CF²/2 L, the books' first order of fd."""
    across = ratio * circle.sine * circle.sine
    found: Number = 0
    for _ in range(steps):
        found = across / (2 - ratio * found)
    return found


def shrinking(circle: Circle[Number], ratio: Number) -> Number:
    """Return q = tan² ½ψ."""
    half = ratio * circle.sine / (1 + rod_cosine(circle, ratio))
    return half * half


def closed(circle: Circle[Number], ratio: Number, steps: int) -> Number:
    """Return the same as `after`, in one formula for any number of steps."""
    share = shrinking(circle, ratio) ** steps
    return rod_versine(circle, ratio) * (1 - share) / (1 - share * shrinking(circle, ratio))
