"""The indicator card, checked once: the pressures in one end of the cylinder, and what acts by them.

They stand over the positions of the piston, out and back, or over a whole cycle of two strokes or four: by
the share of each stroke, or by the crank angle. The cycle begins with the expansion, in the inner dead centre
in which the cylinder fires.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, ClassVar, TypeAlias

from kurbel.drive.load import CARD
from kurbel.drive.moved import Drive, Moved
from kurbel.errors import CardError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import circle
from kurbel.kernel.law import Stroke
from kurbel.reading.csv_file import place

# Nearer points are one point: a pressure that jumps is no function of the position.
LEAST_STEP = 1e-9
LARGEST_PRESSURE = 1e12
# Forces are counted in the greatest p_forward.
LEAST_ADMISSION = 1.0
Course: TypeAlias = tuple[Sequence[float], Sequence[float]]
"""The shares of a stroke, rising from 0 to 1 as the piston travels, and the pressures in Pa there."""
# Degrees of a cycle, of two strokes or four.
CYCLES = (360.0, 720.0)
# A gap before the cycle begins anew may be so many times the widest within.
WIDEST = 1.5
# By so many points beyond its ends a cycle is continued, as the curve is by corners.
BEYOND = 8


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


@dataclass(frozen=True, slots=True)
class CycleCard:
    """The pressures in Pa in one end of a cylinder on each stroke of its cycle, in the order of the strokes.

    `name` says where they stand, for messages; `resolution` in Pa is the unit of the last place to which they
    are written. Of pressures over the crank angle it is also known of `which`, on `drive`.
    """

    strokes: tuple[Course, ...]
    name: str = "the card"
    resolution: float = 0.0
    which: AngleCard | None = None
    drive: Drive | None = None

    def __post_init__(self) -> None:
        check_admission("pressure", self.admission, self.name)

    @property
    def strokes_of_cycle(self) -> int:
        return len(self.strokes)

    @property
    def admission(self) -> float:
        """The greatest pressure in Pa, which the forces are counted in."""
        return max(max(pressures) for _, pressures in self.strokes)

    def courses(self) -> tuple[Course, ...]:
        """Return the shares of each stroke as the piston travels, with the pressures there."""
        return self.strokes

    def halves(self) -> tuple[CycleCard, CycleCard]:
        """Return the card of the even and that of the odd points, both with the ends of each stroke."""
        if self.which is not None and self.drive is not None:
            # The pressure in a dead centre between two angles is then that between farther ones.
            first, second = (half.on(self.drive) for half in self.which.halves())
            return first, second
        even, odd = (tuple(_every_second(one, first) for one in self.strokes) for first in (0, 1))
        return CycleCard(even, self.name, self.resolution), CycleCard(odd, self.name, self.resolution)

    def on(self, drive: Drive) -> CycleCard:
        """Return the card as it is on a drive: shares are those of any."""
        return self


def _every_second(course: Course, first: int) -> Course:
    last = len(course[0]) - 1
    kept = sorted({0, last, *range(first, last, 2)})
    shares, pressures = (tuple(column[index] for index in kept) for column in course)
    return shares, pressures


# Over the piston path, of one cycle of two strokes or of four.
PistonCard = Card | CycleCard


@dataclass(frozen=True, slots=True)
class AngleCard:
    """Pressures in Pa at rising crank angles φ in degrees, over a cycle of one turn or two.

    φ counts from the dead centre of a straight crank, as everywhere; on another drive the strokes begin where
    its own dead centres lie. Where the last angle is not the first one of the next cycle, that follows.
    """

    angles: tuple[float, ...]
    pressures: tuple[float, ...]
    name: str = "the card"
    lines: tuple[int, ...] = ()
    resolution: float = 0.0

    def __post_init__(self) -> None:
        for index, (before, after) in enumerate(pairwise(self.angles), 1):
            if after - before < LEAST_STEP:
                raise CardError(
                    f"{point(index, self.name, self.lines)}: angle {after:.10g}° comes after {before:.10g}°;"
                    " angles must rise, by at least 10^-9°"
                )
        check_pressures("p", self.pressures, self.name, self.lines)
        check_admission("p", self.admission, self.name)
        if not self.cycle:
            raise CardError(
                f"{self.name}: the angles cover {self.angles[0]:.10g}°..{self.angles[-1]:.10g}°; they must"
                " cover one turn, 360°, or the two turns of four strokes, 720°"
            )

    @property
    def cycle(self) -> float:
        """The degrees of the cycle that the angles cover, 0 if they cover none."""
        span = self.angles[-1] - self.angles[0]
        widest = max(after - before for before, after in pairwise(self.angles))
        return next((one for one in CYCLES if 0 <= one - span <= WIDEST * widest), 0.0)

    @property
    def strokes_of_cycle(self) -> int:
        return int(self.cycle / 180)

    @property
    def admission(self) -> float:
        """The greatest pressure in Pa."""
        return max(self.pressures)

    def halves(self) -> tuple[AngleCard, AngleCard]:
        """Return the card of every second angle, from the first and from the second on."""
        even, odd = (self._from(first) for first in (0, 1))
        return even, odd

    def _from(self, first: int) -> AngleCard:
        second = slice(first, None, 2)
        lines = self.lines[second]
        return AngleCard(self.angles[second], self.pressures[second], self.name, lines, self.resolution)

    def on(self, drive: Drive) -> CycleCard:
        """Return the card by the shares of the strokes that the piston of a drive has gone at the angles.

        Between two angles the pressure in a dead centre follows the curve through those about it.
        """
        courses = tuple(self._courses(drive.moved(floats(), "exact")))
        return CycleCard(courses, self.name, self.resolution, self, drive)

    def _courses(self, drive: Moved) -> Iterator[Course]:
        import numpy as np

        from kurbel.engine.card.force import curve

        angles, pressures = self._continued()
        through = curve(angles, pressures).pressure
        for stroke in range(int(self.cycle / 180)):
            begin, end = (180 * (one + float(drive.dead_centre(one % 2))) for one in (stroke, stroke + 1))
            # All angles lie within a cycle of the first; the stroke may begin before that.
            shift = self.cycle * np.ceil((angles[BEYOND] - begin) / self.cycle)
            within = angles[(angles > begin + shift) & (angles < end + shift)]
            path = np.asarray(
                drive.path(stroke % 2, circle(within - shift - 180.0 * stroke)) / float(drive.length)
            )
            apart = np.diff(path, prepend=0.0) > LEAST_STEP
            kept = apart & (path < 1 - LEAST_STEP)
            shares = (0.0, *path[kept].tolist(), 1.0)
            numbers = through(np.concatenate([[begin + shift], within[kept], [end + shift]]))
            yield shares, tuple(np.asarray(numbers).tolist())

    def _continued(self) -> tuple[Any, Any]:
        """Return angles and pressures over a cycle and as long again, with some points before it."""
        import numpy as np

        angles, pressures = np.array(self.angles), np.array(self.pressures)
        if angles[-1] - angles[0] > self.cycle - LEAST_STEP:
            angles, pressures = angles[:-1], pressures[:-1]
        times = [angles - self.cycle, angles, angles + self.cycle, angles + 2 * self.cycle]
        whole = np.concatenate(times), np.concatenate([pressures] * 4)
        kept = slice(len(angles) - BEYOND, 3 * len(angles) + BEYOND)
        return whole[0][kept], whole[1][kept]


@dataclass(frozen=True, slots=True)
class Diagram:
    """An indicator card in place of the ideal one, and the pressure in Pa on a single-acting piston's other
    face. Q is of the pressure `unit` in Pa, None the card's own greatest."""

    name: ClassVar[str] = CARD
    # Its work tells.
    driven: ClassVar[bool] = False

    card: PistonCard | AngleCard
    other_side: float | None = None
    unit: float | None = None

    @property
    def pressure(self) -> float:
        """The pressure in Pa that Q is of."""
        return self.card.admission if self.unit is None else self.unit

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, ...]:
        """Return the force of the strokes of a cycle, two or four, on floats or arrays."""
        from kurbel.engine.card.force import card_strokes

        return card_strokes(self.measured, double, self.other_side, self.pressure)

    @property
    def measured(self) -> PistonCard:
        """The card by the shares of the strokes, as the one of an engine is."""
        assert not isinstance(self.card, AngleCard)
        return self.card

    @property
    def strokes_of_cycle(self) -> int:
        """How many strokes a cycle has."""
        return self.card.strokes_of_cycle

    def on(self, drive: Drive) -> Diagram:
        """Return the diagram by the shares of the strokes that the drive's piston has gone."""
        return replace(self, card=self.card.on(drive))

    def halves(self) -> Iterator[Diagram]:
        """Yield the cards that have every second point of this one, in the same Q."""
        for card in self.measured.halves():
            yield Diagram(card, self.other_side, self.pressure)
