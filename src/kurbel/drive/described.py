"""A crank drive as it was described, in the words of the options, and the straight or offset crank of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.reading import notation, units
from kurbel.reading.given import Exact, as_fraction, as_length, as_number, as_ratios, as_speed


class Described(NamedTuple):
    """What was said of a crank drive, None where nothing was: its options as they were given, in the order
    in which one too many is refused; the force in newtons."""

    ratio: Exact | Iterable[Exact] | None = None
    stroke: Exact | None = None
    rod: Exact | None = None
    speed: Exact | None = None
    method: str | None = None
    offset: Exact | None = None
    rocker: Exact | None = None
    pivot: str | tuple[Exact, Exact] | None = None
    force: Fraction | None = None

    def ratios(self, default: Sequence[str]) -> tuple[Fraction, ...]:
        """Return the crank ratios, or those of a layout."""
        return as_ratios(default if self.ratio is None else self.ratio)

    @property
    def radius(self) -> Fraction | None:
        """R in metres of 2R."""
        return None if self.stroke is None else as_length(self.stroke, "stroke") / 2

    def cranks(self, default: Sequence[str]) -> tuple[Crank, ...]:
        """Return the straight or offset cranks, of a layout's ratios if nothing gives one."""
        if self.ratio is not None and self.stroke is not None and self.rod is not None:
            raise ProblemError("--stroke and --rod already give the ratio; leave --ratio out")
        if self.method == "infinite" and self.rod is not None and self.stroke is None:
            raise ProblemError("--rod gives the rod a length, but --method infinite takes none; use --stroke")
        radius = self.radius
        length = None if self.rod is None else as_length(self.rod, "rod")
        if length is not None and length <= 0:
            raise ProblemError(f"the length of the rod is {notation.about(length)} m; it must be above 0")
        if radius is not None and length is not None:
            values: Sequence[Fraction] = (radius / length,)
        else:
            values = self.ratios(default)
            if length is not None and 0 in values:
                raise ProblemError(
                    "--rod gives the rod a length, but ratio 1:∞ asks for an infinite one; leave one out"
                )
        turns = None if self.speed is None else as_speed(self.speed)
        return tuple(
            Crank(value, self._offset(size), size, turns, self.force)
            for value in values
            for size in [length * value if length is not None and radius is None else radius]
        )

    def _offset(self, radius: Fraction | None) -> Fraction:
        """e/R from a share of R or a length, which may be negative."""
        value = self.offset
        if value is None:
            return Fraction(0)
        if not isinstance(value, str):
            return as_fraction(value)
        share = value.strip().removesuffix("R")
        if not units.is_measure(share):
            return notation.number(share, "offset")
        displacement = units.displacement(value, "offset")
        if radius is None:
            raise NotationError(
                f'offset "{value[:40]}" is a length, but no length of the crank is known;'
                " add --stroke or give e as a share of R"
            )
        return displacement / radius


def radii(value: Exact, what: str) -> Fraction:
    """Return a length in units of R: 6, 6R."""
    if not isinstance(value, str):
        return as_fraction(value)
    share = value.strip().removesuffix("R")
    if units.is_measure(share):
        raise NotationError(
            f'{what} "{value[:40]}" has a unit; lengths of the arc crank are in units of R, for example 6'
        )
    return as_number(share, what)
