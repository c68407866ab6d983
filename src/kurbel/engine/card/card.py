"""The indicator card of a steam engine, checked once: the pressures in one end of the cylinder."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from kurbel.errors import CardError
from kurbel.reading.csv_file import place

# Nearer points are one point: a pressure that jumps is no function of the position.
LEAST_STEP = 1e-9
LARGEST_PRESSURE = 1e12
# Forces are counted in the greatest p_forward.
LEAST_ADMISSION = 1.0


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
        for index, position in enumerate(self.positions):
            if not 0 <= position <= 1:
                raise CardError(
                    f"{self._place(index)}: position {position:.10g} is outside 0..1;"
                    " it is a share of the stroke, write percent as position [%]"
                )
        self._check_order()
        self._check_ends()
        self._check_pressures()

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

    def _check_order(self) -> None:
        for index, (before, after) in enumerate(pairwise(self.positions), 1):
            if after < before:
                raise CardError(
                    f"{self._place(index)}: position {after:.10g} comes after {before:.10g}, but positions"
                    " must rise; give a closed curve, out and back, as p_forward and p_return side by side"
                )
            if after - before < LEAST_STEP:
                raise CardError(
                    f"{self._place(index)}: position {after:.10g} is repeated; a card has one p_forward and"
                    " one p_return a position, so a sudden change needs two positions close together"
                )

    def _check_ends(self) -> None:
        if not self.positions or (self.positions[0], self.positions[-1]) != (0, 1):
            covered = f"{self.positions[0]:.10g}..{self.positions[-1]:.10g}" if self.positions else "nothing"
            raise CardError(
                f"{self.name}: the positions cover {covered}; they must cover 0..1, the whole stroke"
            )

    def _check_pressures(self) -> None:
        for what, column in (("p_forward", self.forward), ("p_return", self.back)):
            for index, pressure in enumerate(column):
                if not abs(pressure) <= LARGEST_PRESSURE:
                    raise CardError(
                        f"{self._place(index)}: {what} is {pressure:.6g} Pa; no card goes beyond 10^12 Pa"
                    )
        if self.admission < LEAST_ADMISSION:
            raise CardError(
                f"{self.name}: the greatest p_forward is {self.admission:.6g} Pa; it must be at least 1 Pa,"
                " for forces are counted in it; give pressures below the atmosphere as those above vacuum"
            )

    def _place(self, index: int) -> str:
        return place(self.name, self.lines[index] if self.lines else None)
