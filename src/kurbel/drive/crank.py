"""The crank drive that a table is about, checked once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.errors import ProblemError
from kurbel.reading.notation import Progression, about, ratio_text
from kurbel.reading.units import Speed

if TYPE_CHECKING:
    from kurbel.drive.moving import Moving
    from kurbel.drive.rod import Rod

LONGEST_ROD = 10**9
LARGEST_ANGLE = 10**6
LARGEST_FORCE = 10**12


@dataclass(frozen=True, slots=True)
class Crank:
    """A crank drive: ratio λ = R/L, offset e/R, crank radius R in metres, speed, piston force in
    newtons, connecting rod and moving masses where they are known.

    Valid for 0 <= λ < 1 and |e| < L − R; λ = 0 is the infinite rod.
    """

    ratio: Fraction
    offset: Fraction = Fraction(0)
    radius: Fraction | None = None
    speed: Speed | None = None
    force: Fraction | None = None
    rod: Rod | None = None
    moving: Moving | None = None

    @property
    def rod_length(self) -> Fraction | None:
        """L in metres, None if it is not known or infinite."""
        return self.radius / self.ratio if self.radius is not None and self.ratio else None

    def __post_init__(self) -> None:
        _check_ratio(self.ratio)
        if abs(self.offset) > LONGEST_ROD:
            raise ProblemError(f"offset e is above {LONGEST_ROD} R; no crank turns so far from its slide")
        if self.ratio and abs(self.offset) >= 1 / self.ratio - 1:
            raise ProblemError(
                f"offset e = {about(self.offset)} R is too large for R:L = {ratio_text(self.ratio)};"
                f" the crank turns only if |e| < L - R = {about(1 / self.ratio - 1)} R"
            )
        if self.force is not None and not 0 < self.force <= LARGEST_FORCE:
            raise ProblemError(
                f"the piston force is {about(self.force)} N; it must be above 0 and at most 10^12"
            )
        if self.radius is not None and self.radius <= 0:
            raise ProblemError(f"the crank radius is {about(self.radius)} m; it must be above 0")
        if self.speed is not None and self.radius is None and self.moving is None:
            raise ProblemError("a speed needs a length to give m/s; add --stroke, for example --stroke 600mm")
        if self.moving is not None and (self.radius is None or self.speed is None):
            raise ProblemError(
                "masses need the stroke and the speed to become forces; add these, for example --stroke 600mm"
                " --speed 120/min"
            )


def check_angles(angles: Sequence[Fraction]) -> None:
    """Raise ProblemError unless there are angles and all lie within a million degrees of zero."""
    if not angles:
        raise ProblemError("no angle was given; write them as --angle 0;45;90 or --from 0 --to 180 --step 10")
    # A progression has its ends for its extremes, and may be too long to be looked at whole.
    for angle in (angles[0], angles[-1]) if isinstance(angles, Progression) else angles:
        if abs(angle) > LARGEST_ANGLE:
            raise ProblemError(f"an angle is beyond {LARGEST_ANGLE}°; give it within one turn, 0..360")


def _check_ratio(ratio: Fraction) -> None:
    if ratio < 0:
        raise ProblemError(
            f"crank ratio R:L is {about(ratio)}; it must not be negative, for both are lengths"
        )
    if ratio >= 1:
        raise ProblemError(
            f"crank ratio R:L is {about(ratio)}; it must be below 1,"
            " or the rod is too short to pass the dead centre"
        )
    if 0 < ratio < Fraction(1, LONGEST_ROD):
        raise ProblemError(
            f"crank ratio R:L is below 1:{LONGEST_ROD}; no rod is that long,"
            " write 1:∞ or 1:inf for an infinite one"
        )
