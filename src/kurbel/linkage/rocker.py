"""A crank whose rod moves a rocker, and what it does between its dead centres; see kernel/linkage.py.

Where an arc crank stands, by formulas with small separation bounds.

The kernel's formulas of the arc crank shun differences, at the price of so many quotients that their bounds
reach a million bits. Here the rocker's angle θ comes first, with rational coefficients settled beforehand and
one root each for the dead centre, if it counts from there, and the place: some thousand bits, but no digits
for floats to rely on.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import ClassVar, TypeAlias

from kurbel.drive.at import At, known
from kurbel.drive.crank import Crank
from kurbel.drive.moved import Moved
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel import linkage
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.coupler import Reach, Rod, rocker_reach, rocker_rod
from kurbel.kernel.forces import Weight
from kurbel.kernel.linkage import Arc, Place
from kurbel.kernel.moving import Masses
from kurbel.kernel.rocker import LoadedRocker
from kurbel.linkage.linkage import Linkage
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.quantity import Of, Words


class RockerCrank(Linkage):
    """A crank drive whose rod moves a rocker of this length in units of R."""

    __slots__ = ()

    # The mechanism that it is one of, what sentences and drawings call it, and the letter of the rocker.
    mechanism: ClassVar[str]
    title: ClassVar[str]
    noun: ClassVar[Words]
    letter: ClassVar[str] = "B"
    # Whether what the piston moves hangs at the rod's end, and not at another arm of the rocker.
    at_end: ClassVar[bool] = True
    crank: Crank
    rocker: Fraction

    @abstractmethod
    def figures(self, stroke: int, kind: Kind) -> tuple[Numeric, Numeric, Numeric, Numeric]:
        """Return λ, β, η and σ with the sign of the stroke, on a kind of number."""

    @property
    @abstractmethod
    def curvature(self) -> Fraction:
        """β = R/B, negative with the pivot on the left of the end's way from the inner dead centre."""

    def dead_centre(self, stroke: int, kind: Kind) -> Arc[Numeric]:
        """Return it where the stroke begins, at the inner dead centre (OUT) or the outer (RETURN)."""
        return linkage.arc(*self.figures(stroke, kind))

    def dead_angle(self, stroke: int, kind: Kind) -> Numeric:
        """Return φ_i, or for RETURN φ_o - 180°, in degrees within ±180°."""
        arc = self.dead_centre(stroke, kind)
        return 2 * kind.arc(linkage.half_sine(arc.sine, arc.cosine))

    def swing(self, kind: Kind) -> Numeric:
        """Return the rocker's swing in degrees; its way along the arc is `way`."""
        return abs(2 * kind.arc(linkage.swing_half_sine(*self._dead_centres(kind))))

    def way(self, kind: Kind) -> Numeric:
        """Return the way of the rod's end along its arc between the dead centres, in units of R."""
        return self.swing(kind) * kind.pi / 180 * kind.of(self.rocker)

    def lead(self, kind: Kind) -> Numeric:
        """Return Δ in degrees, by which the crank turns more than 180° during the outstroke."""
        return 2 * kind.arc(linkage.lead_half_sine(*self._dead_centres(kind)))

    def least_transmission(self, kind: Kind) -> Numeric:
        """Return the least angle between the lines of rod and rocker during a turn, in degrees."""
        return 90 - kind.arc(linkage.steepest_slant(*self.figures(OUT, kind)))

    def _dead_centres(self, kind: Kind) -> tuple[Arc[Numeric], Arc[Numeric]]:
        return self.dead_centre(OUT, kind), self.dead_centre(RETURN, kind)

    def place(self, stroke: int, circle: Circle[Numeric], kind: Kind) -> Place[Numeric]:
        """Return where the rod's end stands on its arc."""
        arc = self.dead_centre(stroke, kind)
        return linkage.place(linkage.from_dead_centre(circle, arc), arc)

    def at(self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None) -> At:
        """Return the same, with the dead centre.

        path, chord, turn, slide_path, rise, velocity and acceleration count from the dead centre where the
        stroke begins and are positive away from it, rise towards the side of the crank pin during the stroke.
        rocker is θ from the position square to the slide direction, in the crank's sense; slant is ψ, the
        angle of the rod from the arc's tangent, rod its angle from the slide direction, both positive as ψ of
        the straight crank.
        """
        arc = self.dead_centre(stroke, numbers)
        place = linkage.place(linkage.from_dead_centre(circle, arc), arc)
        return At(circle, self, numbers, stroke, place=place, arc=arc)

    def moved(self, kind: Kind, method: str) -> MovedRocker:
        """Return the drive as a turn of an engine asks it."""
        if method != "exact":
            raise ProblemError(f'method "{method}" has no formulas for {self.title}; use exact')
        return MovedRocker(self, kind)

    def of(self, crank: Crank) -> RockerCrank:
        """Return the drive with what else is known of its crank; its masses then know the rocker's length."""
        if crank.moving is not None:
            moving = replace(crank.moving, arm=self.rocker * known(crank.radius))
            crank = replace(crank, moving=moving)
        changed = super().of(crank)
        assert isinstance(changed, RockerCrank)
        return changed

    def under(
        self,
        circle: Circle[Numeric],
        place: Place[Numeric],
        arc: Arc[Numeric],
        masses: Masses[Numeric],
        net: Numeric,
        own: Numeric,
    ) -> LoadedRocker:
        """Return the drive with its masses, of which `own` is the reciprocating one, under a piston force."""
        if not self.at_end:
            # The other arm bears what draws it to the pivot.
            masses = masses._replace(crosshead=masses.crosshead - own, rocker=masses.rocker + own)
            own = 0
        return LoadedRocker(circle, arc.ratio, masses, None, net, own, place=place, arc=arc)


class MovedRocker(Moved):
    """A crank that moves a rocker, under a piston whose way is that of the rocker's end along its arc."""

    def __init__(self, drive: RockerCrank, kind: Kind) -> None:
        self.drive, self.kind = drive, kind
        self.arcs = [drive.dead_centre(stroke, kind) for stroke in (OUT, RETURN)]
        self.length = drive.way(kind)
        self._dead_angles = [drive.dead_angle(stroke, kind) / 180 for stroke in (OUT, RETURN)]
        self._last: tuple[int, Circle[Numeric], Place[Numeric]] | None = None

    def dead_centre(self, stroke: int) -> Numeric:
        return self._dead_angles[stroke]

    def path(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        arc = self.arcs[stroke]
        turned = 2 * self.kind.arc(linkage.path_half_sine(self._place(stroke, circle), arc))
        return turned * self.kind.pi / 180 / arc.curvature

    def velocity(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        return self._place(stroke, circle).velocity

    def acceleration(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        return linkage.acceleration(self._place(stroke, circle), self.arcs[stroke])

    def loaded(
        self,
        stroke: int,
        circle: Circle[Numeric],
        masses: Masses[Numeric],
        net: Numeric,
        reciprocating: Numeric,
        weight: Weight[Numeric] | None,
        friction: Numeric | None,
    ) -> LoadedRocker:
        # Refused where they are given: what a rocker weighs is not known.
        assert weight is None
        assert friction is None
        place = self._place(stroke, circle)
        return self.drive.under(circle, place, self.arcs[stroke], masses, net, reciprocating)

    def _place(self, stroke: int, circle: Circle[Numeric]) -> Place[Numeric]:
        """Return where the rocker's end stands; a turn asks several things of one angle."""
        if self._last is None or self._last[0] != stroke or self._last[1] is not circle:
            arc = self.arcs[stroke]
            self._last = (stroke, circle, linkage.place(linkage.from_dead_centre(circle, arc), arc))
        return self._last[2]


def rod(
    drive: RockerCrank, method: str, circle: Circle[Numeric], kind: Kind, beside: bool
) -> tuple[Rod[Numeric], Reach[Numeric] | None]:
    """Return the ends of the rod at a crank angle, and its reach if points beside its axis are asked for."""
    at = drive.at(OUT, circle, kind, "exact", Of.STROKE)
    place, arc = at.place, at.arc
    height = drive.figures(OUT, kind)[2]
    ends = rocker_rod(circle, place, arc, height, linkage.slide_path(place, arc))
    return ends, rocker_reach(circle, place, arc) if beside else None


# λ, β, η and σ with the sign of the stroke.
Numbers: TypeAlias = tuple[Fraction, Fraction, Fraction, Fraction]


def direct(
    numbers: Numbers, circle: Circle[Numeric], of_stroke: bool, kind: Kind
) -> tuple[Place[Numeric], Arc[Numeric]]:
    """Return where the drive stands, its way from the dead centre only if that is wanted."""
    sine, cosine, slant, slant_cosine = _turn(numbers, circle, kind.of)
    ratio, curvature = map(kind.of, numbers[:2])
    nothing = kind.of(Fraction(0))
    # With θ = 0 at the dead centre the slide direction is its tangent, in which along and across are.
    along, rise = nothing, nothing
    dead_crank = (nothing, nothing)
    if of_stroke:
        dead, dead_crank = _dead_turn(numbers, kind.of)
        along, rise = (dead[0] - sine) / curvature, (dead[1] - cosine) / curvature
    across = circle.sine * cosine - circle.cosine * sine
    facing = circle.cosine * cosine + circle.sine * sine
    velocity = across + facing * slant / slant_cosine
    place = Place(nothing, along, rise, slant, slant_cosine, across, facing, velocity)
    return place, Arc(ratio, curvature, nothing, nothing, nothing, *dead_crank)


def _turn(
    numbers: Numbers, circle: Circle[Numeric], of: Callable[[Fraction], Numeric]
) -> tuple[Numeric, Numeric, Numeric, Numeric]:
    """Return sin θ and cos θ of the rocker, sin ψ and cos ψ of the rod against the arc."""
    ratio, curvature, offset, shift = numbers
    level, up = _pivot(numbers)
    mean = curvature * shift + ratio * offset + ratio * curvature * (1 + shift**2 + offset**2) / 2
    slant = of(level) * circle.cosine + of(up) * circle.sine - of(mean)
    slant_cosine = (1 - slant * slant) ** 0.5
    both = ratio * curvature
    sine, cosine = _rocker_turn(
        of(curvature) * slant - of(ratio),
        of(curvature) * slant_cosine,
        of(level) - of(both) * circle.cosine,
        of(up) - of(both) * circle.sine,
        of(level**2 + up**2 + both**2) - of(2 * both) * (of(level) * circle.cosine + of(up) * circle.sine),
    )
    return sine, cosine, slant, slant_cosine


def _dead_turn(
    numbers: Numbers, of: Callable[[Fraction], Numeric]
) -> tuple[tuple[Numeric, Numeric], tuple[Numeric, Numeric]]:
    """Return sine and cosine of θ at the dead centre, and those of the crank angle there."""
    ratio, curvature, offset, shift = numbers
    level, up = _pivot(numbers)
    gap = 1 - shift + ratio * (1 - shift**2 - offset**2) / 2
    dead = curvature * gap - ratio * offset
    root = of((1 + ratio) ** 2 - dead**2) ** 0.5
    sine, cosine = _rocker_turn(
        of(curvature * dead - ratio),
        of(curvature) * root,
        of(level),
        of(up),
        of(level**2 + up**2),
    )
    # The rod, at sin ψ = dead/(1 + λ) against the arc, is in line with the crank.
    whole, slant = of(1 + ratio), of(dead)
    crank = (sine * root - cosine * slant) / whole, (cosine * root + sine * slant) / whole
    return (sine, cosine), crank


def _pivot(numbers: Numbers) -> tuple[Fraction, Fraction]:
    """Return the pivot seen from the shaft, along and across the slide direction, times λβ."""
    ratio, curvature, offset, shift = numbers
    return curvature * (1 + ratio * shift), ratio * (1 + curvature * offset)


def _rocker_turn(
    along: Numeric, across: Numeric, level: Numeric, up: Numeric, square: Numeric
) -> tuple[Numeric, Numeric]:
    """Return sin θ and cos θ from the rod's end in the frame of pin and pivot, all times λβ.

    `level` and `up` lead from the pin to the pivot, `square` is the square of this distance.
    """
    return (along * level + across * up) / square, (across * level - along * up) / square
