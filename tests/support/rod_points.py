"""Points of a rod as pins and links carry them: positions closed in mpmath, and slopes taken by it.

The shaft is at 0, the crank pin at φ from the slide direction; positions are complex numbers in units of R.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from links import links, pointer, real
from mpmath import mp

from kurbel.drive.crank import Crank
from kurbel.linkage.arc.rocker import RockerCrank

# mpmath has no types.
Real = Any


def driven_end(drive: Crank | RockerCrank) -> Callable[[Real], Real]:
    """Return where the driven end of the rod is at a crank angle in radians."""
    if isinstance(drive, Crank):
        rod, aside = 1 / real(drive.ratio), real(drive.offset)

        def crosshead(phi: Real) -> Real:
            pin = pointer(phi)
            return mp.mpc(pin.real + mp.sqrt(rod**2 - (pin.imag - aside) ** 2), aside)

        return crosshead
    closed = links(drive)
    return lambda phi: closed.end(closed.angles(phi)[1])


def dead_centre(drive: Crank | RockerCrank) -> Real:
    """Return the crank angle of the inner dead centre in radians."""
    if isinstance(drive, Crank):
        return mp.asin(real(drive.offset) / (1 / real(drive.ratio) + 1))
    return links(drive).inner[0]


def position(drive: Crank | RockerCrank, share: Fraction, beside: Fraction) -> Callable[[Real], Real]:
    """Return where a point of the rod is at a crank angle in radians."""
    driven = driven_end(drive)

    def at(phi: Real) -> Real:
        start, rod = driven(phi), pointer(phi) - driven(phi)
        # Seen from B towards A, which lies against the slide direction, the upper side is at the right.
        return start + rod * (real(share) - 1j * real(beside))

    return at


def values(
    drive: Crank | RockerCrank, share: Fraction, beside: Fraction, degrees: Fraction
) -> dict[str, Real]:
    """Return what pages say of the point at an angle, in units of R, v and v²/R."""
    at, phi = position(drive, share, beside), mp.radians(real(degrees))
    moved = [at(phi) - at(dead_centre(drive)).real, mp.diff(at, phi), mp.diff(at, phi, 2)]
    found: dict[str, Real] = {}
    for key, one in zip(("path", "velocity", "acceleration"), moved, strict=True):
        found |= {f"{key}_along": -one.real, f"{key}_across": one.imag}
    for key, one in zip(("velocity", "acceleration"), moved[1:], strict=True):
        found |= {key: abs(one), f"{key}_direction": mp.degrees(mp.arg(one)) % 360}
    return found
