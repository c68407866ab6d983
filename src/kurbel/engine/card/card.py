"""The indicator card of a steam engine, checked once: the pressures in one end of the cylinder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

from kurbel.errors import CardError
from kurbel.reading.csv_file import place

if TYPE_CHECKING:
    from kurbel.drive.moved import Drive

# Nearer points are one point: a pressure that jumps is no function of the position.
LEAST_STEP = 1e-9
LARGEST_PRESSURE = 1e12
# Forces are counted in the greatest p_forward.
LEAST_ADMISSION = 1.0

Course: TypeAlias = tuple[Sequence[float], Sequence[float]]
"""The shares of a stroke, rising from 0 to 1 as the piston travels, and the pressures in Pa there."""


@dataclass(frozen=True, slots=True)
class Card:
    """Pressures in Pa at rising positions 0 to 1, on the way from the dead centre of this end and back to it.

    `name` and `lines` say where the points stand, for messages; `resolution` in Pa is the unit of the last
    place to which the pressures are written. Valid for pressures within ±10^12 Pa, may they be above vacuum
    or above the atmosphere, of which the greatest p_forward is at least 1 Pa.
    """

    positions: tuple[float, ...]
    forward: tuple[float, ...]
    back: tuple[float, ...]
    name: str = "the card"
    lines: tuple[int, ...] = ()
    resolution: float = 0.0

    def __post_init__(self) -> None:
        check_positions(self.positions, self.name, self.lines)
        for what, column in (("p_forward", self.forward), ("p_return", self.back)):
            check_pressures(what, column, self.name, self.lines)
        check_admission("p_forward", self.admission, self.name)

    @property
    def strokes_of_cycle(self) -> int:
        return 2

    @property
    def admission(self) -> float:
        """The greatest p_forward in Pa, which the forces are counted in."""
        return max(self.forward)

    def halves(self) -> tuple[Card, Card]:
        """Return the card of its even and that of its odd points, both with both ends."""
        last = len(self.positions) - 1
        return self._only({0, last, *range(0, last, 2)}), self._only({0, last, *range(1, last, 2)})

    def _only(self, points: set[int]) -> Card:
        kept = sorted(points)
        columns = (self.positions, self.forward, self.back)
        positions, forward, back = (tuple(column[index] for index in kept) for column in columns)
        lines = tuple(self.lines[index] for index in kept if self.lines)
        return Card(positions, forward, back, self.name, lines, self.resolution)

    def on(self, drive: Drive) -> Card:
        """Return the card as it is on a drive: positions are those of any."""
        return self

    def courses(self) -> tuple[Course, Course]:
        """Return the shares of each stroke as the piston travels, with the pressures there."""
        # The end that exhausts comes back: its positions run from 1 to 0.
        coming = tuple(1 - position for position in reversed(self.positions))
        return (self.positions, self.forward), (coming, self.back[::-1])


def check_positions(positions: Sequence[float], name: str, lines: Sequence[int]) -> None:
    """Raise CardError unless the positions rise from 0 to 1."""
    for index, position in enumerate(positions):
        if not 0 <= position <= 1:
            raise CardError(
                f"{point(index, name, lines)}: position {position:.10g} is outside 0..1;"
                " it is a share of the stroke, write percent as position [%]"
            )
    for index, (before, after) in enumerate(pairwise(positions), 1):
        if after < before:
            raise CardError(
                f"{point(index, name, lines)}: position {after:.10g} comes after {before:.10g}, but positions"
                " must rise; give a closed curve, out and back, as p_forward and p_return side by side"
            )
        if after - before < LEAST_STEP:
            raise CardError(
                f"{point(index, name, lines)}: position {after:.10g} is repeated; a card has one p_forward"
                " and one p_return a position, so a sudden change needs two positions close together"
            )
    if not positions or (positions[0], positions[-1]) != (0, 1):
        covered = f"{positions[0]:.10g}..{positions[-1]:.10g}" if positions else "nothing"
        raise CardError(f"{name}: the positions cover {covered}; they must cover 0..1, the whole stroke")


def check_pressures(what: str, column: Sequence[float], name: str, lines: Sequence[int]) -> None:
    """Raise CardError for a pressure beyond all cards."""
    for index, pressure in enumerate(column):
        if not abs(pressure) <= LARGEST_PRESSURE:
            raise CardError(
                f"{point(index, name, lines)}: {what} is {pressure:.6g} Pa; no card goes beyond 10^12 Pa"
            )


def check_admission(what: str, greatest: float, name: str) -> None:
    """Raise CardError unless forces can be counted in the greatest pressure."""
    if greatest < LEAST_ADMISSION:
        raise CardError(
            f"{name}: the greatest {what} is {greatest:.6g} Pa; it must be at least 1 Pa,"
            " for forces are counted in it; give pressures below the atmosphere as those above vacuum"
        )


def point(index: int, name: str, lines: Sequence[int]) -> str:
    """Return where a point stands, for the start of a sentence."""
    return place(name, lines[index] if lines else None)
