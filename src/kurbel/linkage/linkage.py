"""A crank drive without a crosshead at a crank angle, on any kind of number, and as it is drawn to scale."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Place
from kurbel.motion.evaluation import LOADED
from kurbel.page.quantity import Quantity, Words


class At(NamedTuple):
    """What a kernel call takes: where a drive stands, the drive, the kind of number and the circle of the
    crank angle; of the arc crank also its dead centre."""

    place: Place[Any]
    drive: Any
    kind: Kind
    circle: Any
    arc: Any = None


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

    def at(self, stroke: int, circle: Circle[Any], kind: Kind) -> At:
        """Return what the kernel calls of its quantities take."""
        return At(self.place(stroke, circle, kind), self, kind, circle)

    def outline(self) -> Outline | None:
        """Return what it is seen as from its side, unless a drawing of its own knows."""
        return None

    def direct(self, quantity: Quantity, circle: Circle[Any], kind: Kind) -> At:
        """Return the same, for an algebraic quantity, by formulas with small separation bounds."""
        return self.at(quantity.stroke, circle, kind)


def value(quantity: Quantity, drive: Linkage, circle: Circle[Any], kind: Kind, direct: bool = False) -> Any:
    """Return the quantity where the crank stands at φ, on RETURN at 180° + φ; the circle is that of φ.

    `direct` gives an algebraic quantity a small separation bound.
    """
    at = drive.direct(quantity, circle, kind) if direct else drive.at(quantity.stroke, circle, kind)
    heavy = drive.crank.moving is not None and LOADED in quantity.formulas
    found = quantity.formulas[LOADED if heavy else "exact"].kernel(at)
    return found * quantity.scale(drive.crank, kind) if quantity.scale else found


def certified(
    quantity: Quantity, drive: Linkage, angle: Fraction, decimals: int, rounding: str = "half-away"
) -> int:
    """Return the quantity times 10**decimals at an exact angle in degrees, rounded correctly.

    The path is an arc with an algebraic sine, hence transcendental or zero (Lindemann). sin ψ is
    p + q cos φ + r sin φ with rational p, q, r and q² + r² < 1; where ψ is a rational number of degrees that
    is one of 0, ±30°, ±45° and ±60° (Conway and Jones, Acta Arithmetica 30, 1976, theorem 7). Rocker and rod
    angles on a boundary are not excluded; `certify.rounded` then raises ProblemError.
    """

    def at(kind: Kind) -> Any:
        return value(quantity, drive, kind.circle(angle), kind, direct=kind.bounded)

    return settled(at, decimals, rounding)
