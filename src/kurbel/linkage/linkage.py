"""A crank drive without a crosshead at a crank angle, on any kind of number, and as it is drawn to scale."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from kurbel.drive.at import At
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Place
from kurbel.page.quantity import Words

Point = tuple[float, float]


class Stand(NamedTuple):
    """A drive at a crank angle, in units of R from the shaft: its links by their names, cranks called so, and
    the pins between them. `chains` are the same lines from joint to joint, `letters` those of links, each at
    a share of its length, `lengths` are from x to x along the line of shafts.
    """

    links: Mapping[str, tuple[Point, Point]]
    pins: tuple[Point, ...]
    chains: tuple[tuple[Point, ...], ...]
    letters: tuple[tuple[str, str, float], ...] = ()
    lengths: tuple[tuple[float, float, str], ...] = ()


class Outline(NamedTuple):
    """What does not move: the shafts, about each of which a crank turns, and how far links reach to the left
    and to the right; `stand` is of the place of the crank pin."""

    title: Words
    shafts: tuple[Point, ...]
    left: float
    right: float
    stand: Callable[[Point], Stand]


class Linkage(ABC):
    """A crank drive without a crosshead: what moves, on any kind of number.

    A stroke is OUT (1) or RETURN (-1); everything on it counts from the dead centre where it begins and in
    its direction. The circle is that of the crank angle φ, on RETURN of φ less 180°.
    """

    __slots__ = ()

    crank: Any

    def of(self, crank: Crank) -> Linkage:
        """Return the drive with what else is known of its crank."""
        own: Any = self
        changed: Linkage = replace(own, crank=crank)
        return changed

    @property
    def stroke(self) -> Label:
        """The stroke as pages of conditions print it, nothing where no line holds it."""
        return "2 R"

    @abstractmethod
    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        """Return where the driven end is: its way, its velocity, the slants of rod and crank against it."""

    def at(self, stroke: int, circle: Circle[Any], numbers: Kind, method: str, of: str | None = None) -> At:
        """Return what kernel calls take. What quantities are `of`, where that is known, may choose formulas
        with few roots for them."""
        return At(circle, self, numbers, stroke, place=self.place(stroke, circle, numbers))

    def outline(self) -> Outline | None:
        """Return what it is seen as from its side, unless a drawing of its own knows."""
        return None
