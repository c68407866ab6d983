"""A page in steps: its table for every step of a few sliders, what runs along one axis of it, what moves."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from math import prod
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kurbel.exact.numerals import Label

if TYPE_CHECKING:
    from kurbel.page.table import Table, Value

Point: TypeAlias = tuple[float, float]
# A place of a drawing in units of R from the shaft: one that stays, or those of a turn at equal steps of the
# crank angle, from φ = 0 on.
Joint: TypeAlias = tuple[Point, ...]
# So many quantities are read beside a drawing.
MOST_COLUMNS = 8


class Slider(NamedTuple):
    """What can be chosen: the key of its option, how it is called, its steps, and which is shown first."""

    key: str
    label: Label
    steps: tuple[Label, ...]
    start: int = 0


class Place(NamedTuple):
    """A place along the axis that a page runs through: how it is written, where it lies, and the row or the
    column of the table that says most of it, where one does."""

    label: Label
    at: float
    row: int | None = None
    column: int | None = None


class Cursor(NamedTuple):
    """The axis that a page runs through; `turn` is the length of its cycle in degrees where it is the crank
    angle, else 0, and `zero` what the page calls 0°. One place is shown first."""

    key: str
    label: Label
    unit: str
    places: tuple[Place, ...]
    turn: int = 0
    zero: float = 0.0
    start: int = 0


class Shown(NamedTuple):
    """A quantity that is shown at each place of the axis, in labels."""

    name: Label
    symbol: Label


class Line(NamedTuple):
    """What does not move: a chain line ("centre"), a circle of radius R ("circle"), an edge of the frame
    whose hatch lies to its left or right ("left", "right"), a dead centre ("dead"); a bearing that makes room
    for its crank ("bearing"), or whose ground is below, above or at the left ("below", "hung", "beside")."""

    kind: str
    points: tuple[Point, ...]


class Link(NamedTuple):
    """A bar between two joints; its kind tells cranks from others, its letter stands beside it."""

    kind: str
    start: Joint
    end: Joint
    letter: str = ""


class Scene(NamedTuple):
    """A mechanism that moves, between two corners: what is fixed, the links, the pins and the crossheads.

    `path` is where the way of the crosshead begins, and the height at which it is dimensioned.
    """

    low: Point
    high: Point
    fixed: tuple[Line, ...]
    links: tuple[Link, ...]
    pins: tuple[Joint, ...]
    heads: tuple[Joint, ...] = ()
    path: Point | None = None


class Step(NamedTuple):
    """The page of one step: its table, at each place of the axis the quantities, by them, with the unit of
    each, and what moves."""

    table: Table
    tracks: tuple[tuple[Value, ...], ...]
    units: tuple[Label, ...]
    scene: Scene | None


@dataclass(frozen=True)
class Steps:
    """The pages of all steps, those of the last slider beside each other; each is made as it is asked for."""

    sliders: tuple[Slider, ...]
    cursor: Cursor | None
    columns: tuple[Shown, ...]
    make: Callable[[], Iterable[Step]]

    def __reduce__(self) -> tuple[object, ...]:
        """Return how the same are made with all pages."""
        return type(self), (self.sliders, self.cursor, self.columns, partial(tuple, tuple(self)))

    def __iter__(self) -> Iterator[Step]:
        yield from self.make()

    def __len__(self) -> int:
        return prod(len(slider.steps) for slider in self.sliders)

    @property
    def start(self) -> int:
        """Which page is shown first."""
        place = 0
        for slider in self.sliders:
            place = place * len(slider.steps) + slider.start
        return place

    def named(self, change: Callable[[Table], Table]) -> Steps:
        """Return the same pages with something else changed on each."""
        return replace(self, make=lambda: (step._replace(table=change(step.table)) for step in self.make()))
