"""The arc crank, checked once, and its motion with certified digits; see kernel/linkage.py.

The motion of the parallel crank, `certified_coupler`, depends on no length.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

from kurbel.drive.crank import LONGEST_ROD, Crank
from kurbel.errors import ProblemError
from kurbel.kernel import linkage
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Arc, Place
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.reading.notation import about

# Lengths in a message are multiples of 1/_STEPS R, rounded so that a length changed by as much will do.
_STEPS = 10**6

CHANGE_POINTS = (Fraction(0), Fraction(180))
"""The angles from the line of shafts at which a parallel crank may fold into the antiparallel crank."""


@dataclass(frozen=True, slots=True)
class ArcCrank:
    """An arc crank: the rod of the crank drive moves a rocker of length B, in units of R as all lengths here.

    The pivot lies `distance` from the shaft along the slide direction, from which φ counts, and `height` to
    the side on which the crank pin is during the outstroke, negative to the other. Left out, the distance is
    L, so that the rocker stands square to the slide near mid-stroke, and the height e + B, so that the arc
    touches the slide line of the offset e: as the rocker grows this becomes the straight or offset crank.
    A pivot at height 0 lets φ count from the line of shaft and pivot. Of the two ways to assemble the links,
    circuit 1 has the rod's end on the side of the slide: seen from the crank pin to the right of the pivot,
    for a negative height to its left. Circuit -1 is the other one.

    Valid for R + max(L, B, G) < the sum of the other two of L, B and the distance G of shaft and pivot: the
    crank turns, the rocker swings, and the links never lie in line. λ = 0, the infinite rod, needs the
    default distance.
    """

    crank: Crank
    rocker: Fraction
    distance: Fraction | None = None
    height: Fraction | None = None
    circuit: int = 1

    def __post_init__(self) -> None:
        if self.circuit not in (1, -1):
            raise ProblemError(
                f"circuit is {self.circuit}; it must be 1 or -1, the two ways to assemble the links"
            )
        if self.height is not None and self.crank.offset:
            raise ProblemError(
                f"offset e = {about(self.crank.offset)} R and a height of the pivot were both given;"
                " give one, for the height is e + B"
            )
        self._check_rocker()
        if self.crank.ratio:
            self._check_pivot()
        elif self.distance is not None:
            raise ProblemError(
                f"the pivot is {about(self.distance)} R from the shaft, but the rod is infinite;"
                " leave the distance out, or give the rod a length"
            )

    @property
    def shift(self) -> Fraction:
        """σ, the distance less the rod length L."""
        return Fraction(0) if self.distance is None else self.distance - 1 / self.crank.ratio

    @property
    def curvature(self) -> Fraction:
        """β = R/B, negative with the pivot on the left of the end's way from the inner dead centre."""
        side = -1 if self.pivot_height < 0 else 1
        return self.circuit * side / self.rocker

    @property
    def offset(self) -> Fraction:
        """η, where the arc comes nearest to the slide direction or, on circuit -1, farthest from it."""
        return self.pivot_height - 1 / self.curvature

    @property
    def pivot_height(self) -> Fraction:
        return self.crank.offset + self.rocker if self.height is None else self.height

    def _check_rocker(self) -> None:
        if self.rocker <= 1:
            raise ProblemError(
                f"rocker length B is {about(self.rocker)} R; it must be longer than the crank radius R,"
                " or the crank cannot turn while the rocker swings"
            )
        lengths = self.rocker, self.distance or Fraction(0), self.height or Fraction(0)
        if max(map(abs, lengths)) > LONGEST_ROD:
            raise ProblemError(
                f"the rocker or its pivot is beyond {LONGEST_ROD} R; take the straight crank for it"
            )

    def _check_pivot(self) -> None:
        rod = 1 / self.crank.ratio
        distance = rod if self.distance is None else self.distance
        if distance <= 0:
            raise ProblemError(
                f"the pivot's distance is {about(distance)} R; it must be above 0, counted along the slide"
                " direction from the shaft towards the rod's end"
            )
        square = distance * distance + self.pivot_height * self.pivot_height
        _check_ground(square, rod, self.rocker)


def _check_ground(square: Fraction, rod: Fraction, rocker: Fraction) -> None:
    """Raise ProblemError unless the square of G lets the crank turn: R + |L - B| < G < L + B - R."""
    ground = isqrt(int(square * _STEPS * _STEPS))
    pivot = f"the pivot is G = {_length(ground)} R from the shaft"
    links = f"for L = {about(rod)} R and B = {about(rocker)} R"
    far, near = rod + rocker - 1, 1 + abs(rod - rocker)
    if square >= far * far:
        change = _length(ground + 1 - int(far * _STEPS))
        raise ProblemError(
            f"{pivot}, too far {links}; the crank turns with G below L + B - R = {about(far)} R or, the pivot"
            f" left in place, with a rod or rocker longer by {change} R"
        )
    if square <= 1:
        raise ProblemError(
            f"{pivot}; it must be farther than the crank radius R, and {links} farther than"
            f" R + |L - B| = {about(near)} R, or the rocker is carried round"
        )
    if square <= near * near:
        longer, shorter = ("rod", "rocker") if rod < rocker else ("rocker", "rod")
        change = _length(int(near * _STEPS) + 2 - ground)
        raise ProblemError(
            f"{pivot}, too near {links}; the crank turns with G above R + |L - B| = {about(near)} R or, the"
            f" pivot left in place, with the {longer} longer or the {shorter} shorter by {change} R"
        )


def _length(steps: int) -> str:
    return about(Fraction(steps, _STEPS))


class Kind(NamedTuple):
    """A kind of number: of a rational number, of an angle in degrees, its arcsine in degrees and its π.

    Separation bounds have neither arcs nor π.
    """

    of: Callable[[Fraction], Any]
    circle: Callable[[Fraction], Circle[Any]]
    arc: Any = None
    pi: Any = None


def balls() -> Kind:
    """Return balls at the precision in force."""
    from kurbel.exact import certify

    return Kind(certify.ball, certify.ball_circle, certify.ball_degrees, certify.pi())


def floats() -> Kind:
    """Return floats, or arrays of them, whose circles are those of floats in degrees."""
    import numpy as np

    from kurbel.kernel.circle import circle

    return Kind(float, circle, lambda sine: np.degrees(np.arcsin(sine)), np.pi)


def bounds() -> Kind:
    """Return separation bounds."""
    from kurbel.exact.separation import Separation, circle_separation

    return Kind(Separation.rational, lambda degrees: Circle(*circle_separation(degrees)))


def dead_centre(crank: ArcCrank, stroke: int, kind: Kind) -> Arc[Any]:
    """Return the arc crank where the stroke begins, at the inner dead centre (OUT) or the outer (RETURN)."""
    numbers = crank.crank.ratio, crank.curvature, crank.offset, crank.shift
    return linkage.arc(*(kind.of(stroke * number) for number in numbers))


def dead_angle(crank: ArcCrank, stroke: int, kind: Kind) -> Any:
    """Return φ_i, or for RETURN φ_o - 180°, in degrees within ±180°."""
    arc = dead_centre(crank, stroke, kind)
    return 2 * kind.arc(linkage.half_sine(arc.sine, arc.cosine))


def swing(crank: ArcCrank, kind: Kind) -> Any:
    """Return the rocker's swing in degrees; its way along the arc is `arc_stroke`."""
    inner, outer = (dead_centre(crank, stroke, kind) for stroke in (OUT, RETURN))
    return abs(2 * kind.arc(linkage.swing_half_sine(inner, outer)))


def arc_stroke(crank: ArcCrank, kind: Kind) -> Any:
    """Return the way of the rod's end along its arc between the dead centres, in units of R."""
    return swing(crank, kind) * kind.pi / 180 * kind.of(crank.rocker)


def lead(crank: ArcCrank, kind: Kind) -> Any:
    """Return Δ in degrees, by which the crank turns more than 180° during the outstroke."""
    inner, outer = (dead_centre(crank, stroke, kind) for stroke in (OUT, RETURN))
    return 2 * kind.arc(linkage.lead_half_sine(inner, outer))


def time_ratio(crank: ArcCrank, kind: Kind) -> Any:
    """Return the time of the outstroke over that of the return stroke."""
    more = lead(crank, kind)
    return (180 + more) / (180 - more)


def least_transmission(crank: ArcCrank, kind: Kind) -> Any:
    """Return the least angle between the lines of rod and rocker during a turn, in degrees."""
    numbers = crank.crank.ratio, crank.curvature, crank.offset, crank.shift
    return 90 - kind.arc(linkage.steepest_slant(*map(kind.of, numbers)))


Formula = Callable[[Place[Any], Arc[Any], Kind], Any]


class Motion(NamedTuple):
    """What the arc crank does at a crank angle: its unit and formula.

    `arc` if that takes an arcsine; `by_rocker` if it is divided by the rocker length.
    """

    unit: str
    formula: Formula
    arc: bool = False
    by_rocker: bool = False


def _path(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return _turned(place, arc, kind) * kind.pi / 180 / arc.curvature


def _turned(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return 2 * kind.arc(linkage.path_half_sine(place, arc))


def _rocker(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return 2 * kind.arc(linkage.rocker_half_sine(arc)) - _turned(place, arc, kind)


def _turn(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return abs(_turned(place, arc, kind))


def _slant(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return kind.arc(place.slant)


def _rod(place: Place[Any], arc: Arc[Any], kind: Kind) -> Any:
    return _slant(place, arc, kind) - _rocker(place, arc, kind)


def _algebraic(formula: Callable[[Place[Any], Arc[Any]], Any]) -> Formula:
    return lambda place, arc, kind: formula(place, arc)


MOTIONS: Mapping[str, Motion] = {
    "path": Motion("R", _path, arc=True),
    "chord": Motion("R", _algebraic(linkage.chord)),
    "slide_path": Motion("R", _algebraic(linkage.slide_path)),
    "rise": Motion("R", _algebraic(linkage.rise)),
    "velocity": Motion("v", _algebraic(linkage.velocity)),
    "acceleration": Motion("v²/R", _algebraic(linkage.acceleration)),
    "turn": Motion("°", _turn, arc=True),
    "turn_velocity": Motion("ω", _algebraic(linkage.velocity), by_rocker=True),
    "turn_acceleration": Motion("ω²", _algebraic(linkage.acceleration), by_rocker=True),
    "rocker": Motion("°", _rocker, arc=True),
    "rod": Motion("°", _rod, arc=True),
    "rod_velocity": Motion("ω", _algebraic(linkage.rod_velocity)),
    "rod_acceleration": Motion("ω²", _algebraic(linkage.rod_acceleration)),
    "slant": Motion("°", _slant, arc=True),
}


def value(key: str, crank: ArcCrank, stroke: int, circle: Circle[Any], kind: Kind) -> Any:
    """Return the quantity where the crank stands at φ, for RETURN at 180° + φ; the circle is that of φ.

    path, chord, turn, slide_path, rise, velocity and acceleration count from the dead centre where the stroke
    begins and are positive away from it, rise towards the side of the crank pin during the stroke. rocker is
    θ from the position square to the slide direction, in the crank's sense; slant is ψ, the angle of the rod
    from the arc's tangent, rod its angle from the slide direction, both positive as ψ of the straight crank.
    """
    arc = dead_centre(crank, stroke, kind)
    place = linkage.place(linkage.from_dead_centre(circle, arc), arc)
    found = MOTIONS[key].formula(place, arc, kind)
    return found / kind.of(crank.rocker) if MOTIONS[key].by_rocker else found


def certified(
    key: str, crank: ArcCrank, stroke: int, angle: Fraction, decimals: int, rounding: str = "half-away"
) -> int:
    """Return the quantity times 10**decimals at an exact angle in degrees, rounded correctly.

    The path is an arc with an algebraic sine, hence transcendental or zero (Lindemann). sin ψ is
    p + q cos φ + r sin φ with rational p, q, r and q² + r² < 1; where ψ is a rational number of degrees that
    is one of 0, ±30°, ±45° and ±60° (Conway and Jones, Acta Arithmetica 30, 1976, theorem 7). Rocker and rod
    angles on a boundary are not excluded; `certify.rounded` then raises ProblemError.
    """
    from kurbel.exact import certify

    def as_ball() -> Any:
        kind = balls()
        return value(key, crank, stroke, kind.circle(angle), kind)

    def tie_bits(boundary: Fraction) -> float:
        kind = bounds()
        bound = direct_value(key, crank, stroke, kind.circle(angle), kind)
        return float((bound - kind.of(boundary)).bits())

    ties = certify.NEVER_TIES if MOTIONS[key].arc else tie_bits
    return certify.rounded(as_ball, decimals, rounding, ties)


def certified_coupler(key: str, angle: Fraction, decimals: int, rounding: str = "half-away") -> int:
    """Return the field of the kernel's Coupler times 10**decimals at an exact angle, rounded correctly."""
    from kurbel.exact import certify

    def motion(kind: Kind) -> Any:
        return getattr(linkage.coupler(kind.circle(angle)), key)

    def tie_bits(boundary: Fraction) -> float:
        kind = bounds()
        return float((motion(kind) - kind.of(boundary)).bits())

    return certify.rounded(lambda: motion(balls()), decimals, rounding, tie_bits)


def direct_value(key: str, crank: ArcCrank, stroke: int, circle: Circle[Any], kind: Kind) -> Any:
    """Return what `value` does, of the algebraic quantities, by formulas with small separation bounds.

    The kernel's formulas shun differences, at the price of so many quotients that their bounds reach a
    million bits. Here the rocker's angle θ comes first, with rational coefficients settled beforehand and one
    root each for the dead centre and the place: some thousand bits, but no digits for floats to rely on.
    """
    turn = _direct_turn(crank, stroke, circle, kind.of)
    return _direct(key, crank, stroke, turn, _dead_turn(crank, stroke, kind.of), kind)


def direct_motion(key: str, crank: ArcCrank, stroke: int, circle: Circle[Any], kind: Kind) -> Any:
    """Return the same of velocities and accelerations, which do not depend on the dead centre: one root."""
    return _direct(key, crank, stroke, _direct_turn(crank, stroke, circle, kind.of), None, kind)


class _Turn(NamedTuple):
    """sin θ and cos θ of the rocker, sin ψ and cos ψ of the rod against the arc, and the crank's circle."""

    sine: Any
    cosine: Any
    slant: Any
    slant_cosine: Any
    circle: Circle[Any]


def _direct(
    key: str, crank: ArcCrank, stroke: int, turn: _Turn, dead: tuple[Any, Any] | None, kind: Kind
) -> Any:
    # With θ = 0 at the dead centre the slide direction is its tangent, in which along and across are.
    curvature = kind.of(stroke * crank.curvature)
    nothing, circle = kind.of(Fraction(0)), turn.circle
    along, rise = nothing, nothing
    if dead is not None:
        along, rise = (dead[0] - turn.sine) / curvature, (dead[1] - turn.cosine) / curvature
    across = circle.sine * turn.cosine - circle.cosine * turn.sine
    facing = circle.cosine * turn.cosine + circle.sine * turn.sine
    velocity = across + facing * turn.slant / turn.slant_cosine
    place = Place(nothing, along, rise, turn.slant, turn.slant_cosine, across, facing, velocity)
    arc = Arc(kind.of(stroke * crank.crank.ratio), curvature, *5 * [nothing])
    found = MOTIONS[key].formula(place, arc, kind)
    return found / kind.of(crank.rocker) if MOTIONS[key].by_rocker else found


def _direct_turn(crank: ArcCrank, stroke: int, circle: Circle[Any], of: Callable[[Fraction], Any]) -> _Turn:
    ratio, curvature, offset, shift = (
        stroke * number for number in (crank.crank.ratio, crank.curvature, crank.offset, crank.shift)
    )
    level, up = _pivot(crank, stroke)
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
    return _Turn(sine, cosine, slant, slant_cosine, circle)


def _dead_turn(crank: ArcCrank, stroke: int, of: Callable[[Fraction], Any]) -> tuple[Any, Any]:
    """Return sin θ and cos θ at the dead centre."""
    ratio, curvature, offset, shift = (
        stroke * number for number in (crank.crank.ratio, crank.curvature, crank.offset, crank.shift)
    )
    level, up = _pivot(crank, stroke)
    gap = 1 - shift + ratio * (1 - shift**2 - offset**2) / 2
    dead = curvature * gap - ratio * offset
    return _rocker_turn(
        of(curvature * dead - ratio),
        of(curvature) * of((1 + ratio) ** 2 - dead**2) ** 0.5,
        of(level),
        of(up),
        of(level**2 + up**2),
    )


def _pivot(crank: ArcCrank, stroke: int) -> tuple[Fraction, Fraction]:
    """Return the pivot seen from the shaft, along and across the slide direction, times λβ."""
    ratio, curvature = stroke * crank.crank.ratio, stroke * crank.curvature
    return curvature * (1 + ratio * stroke * crank.shift), ratio * (1 + curvature * stroke * crank.offset)


def _rocker_turn(along: Any, across: Any, level: Any, up: Any, square: Any) -> tuple[Any, Any]:
    """Return sin θ and cos θ from the rod's end in the frame of pin and pivot, all times λβ.

    `level` and `up` lead from the pin to the pivot, `square` is the square of this distance.
    """
    return (along * level + across * up) / square, (across * level - along * up) / square
