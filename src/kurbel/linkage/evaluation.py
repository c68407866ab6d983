"""Quantities of the arc crank and the parallel crank at a crank angle, on any kind of number, and their
certified digits; see kernel/linkage.py."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

from kurbel.exact.kind import Kind, balls, bounds
from kurbel.kernel import linkage
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Arc, Place
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.parallel import ParallelCrank
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.quantity import Quantity

Linkage: TypeAlias = ArcCrank | ParallelCrank

# What quantities are of that count from the dead centre where the stroke begins.
STROKE = "stroke"


class At(NamedTuple):
    """What a kernel call takes: where a drive stands, the drive and the kind of number; of the arc crank also
    its dead centre, of the parallel crank the circle of its crank angle."""

    place: Place[Any]
    drive: Linkage
    kind: Kind
    arc: Any = None
    circle: Any = None


def dead_angle(crank: ArcCrank, stroke: int, kind: Kind) -> Any:
    """Return φ_i, or for RETURN φ_o - 180°, in degrees within ±180°."""
    arc = crank.dead_centre(stroke, kind)
    return 2 * kind.arc(linkage.half_sine(arc.sine, arc.cosine))


def swing(crank: ArcCrank, kind: Kind) -> Any:
    """Return the rocker's swing in degrees; its way along the arc is `arc_stroke`."""
    inner, outer = (crank.dead_centre(stroke, kind) for stroke in (OUT, RETURN))
    return abs(2 * kind.arc(linkage.swing_half_sine(inner, outer)))


def arc_stroke(crank: ArcCrank, kind: Kind) -> Any:
    """Return the way of the rod's end along its arc between the dead centres, in units of R."""
    return swing(crank, kind) * kind.pi / 180 * kind.of(crank.rocker)


def lead(crank: ArcCrank, kind: Kind) -> Any:
    """Return Δ in degrees, by which the crank turns more than 180° during the outstroke."""
    inner, outer = (crank.dead_centre(stroke, kind) for stroke in (OUT, RETURN))
    return 2 * kind.arc(linkage.lead_half_sine(inner, outer))


def time_ratio(crank: ArcCrank, kind: Kind) -> Any:
    """Return the time of the outstroke over that of the return stroke."""
    more = lead(crank, kind)
    return (180 + more) / (180 - more)


def least_transmission(crank: ArcCrank, kind: Kind) -> Any:
    """Return the least angle between the lines of rod and rocker during a turn, in degrees."""
    numbers = crank.crank.ratio, crank.curvature, crank.offset, crank.shift
    return 90 - kind.arc(linkage.steepest_slant(*map(kind.of, numbers)))


def value(quantity: Quantity, drive: Linkage, circle: Circle[Any], kind: Kind) -> Any:
    """Return the quantity where the crank stands at φ, on RETURN at 180° + φ; the circle is that of φ.

    path, chord, turn, slide_path, rise, velocity and acceleration count from the dead centre where the stroke
    begins and are positive away from it, rise towards the side of the crank pin during the stroke. rocker is
    θ from the position square to the slide direction, in the crank's sense; slant is ψ, the angle of the rod
    from the arc's tangent, rod its angle from the slide direction, both positive as ψ of the straight crank.
    The motion of the parallel crank depends on no length.
    """
    stroke = quantity.stroke
    if isinstance(drive, ParallelCrank):
        return _scaled(quantity, At(drive.place(stroke, circle, kind), drive, kind, circle=circle))
    arc = drive.dead_centre(stroke, kind)
    return _scaled(quantity, At(drive.place(stroke, circle, kind), drive, kind, arc))


def _scaled(quantity: Quantity, at: At) -> Any:
    found = quantity.formulas["exact"].kernel(at)
    return found * quantity.scale(at.drive.crank, at.kind) if quantity.scale else found


def certified(
    quantity: Quantity, drive: Linkage, angle: Fraction, decimals: int, rounding: str = "half-away"
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
        return value(quantity, drive, kind.circle(angle), kind)

    def tie_bits(boundary: Fraction) -> float:
        kind = bounds()
        bound = direct_value(quantity, drive, kind.circle(angle), kind)
        return float((bound - kind.of(boundary)).bits())

    return certify.rounded(as_ball, decimals, rounding, certify.NEVER_TIES if quantity.is_arc else tie_bits)


def direct_value(quantity: Quantity, drive: Linkage, circle: Circle[Any], kind: Kind) -> Any:
    """Return what `value` does, of the algebraic quantities, by formulas with small separation bounds.

    The kernel's formulas of the arc crank shun differences, at the price of so many quotients that their
    bounds reach a million bits. Here the rocker's angle θ comes first, with rational coefficients settled
    beforehand and one root each for the dead centre, if it counts from there, and the place: some thousand
    bits, but no digits for floats to rely on.
    """
    if isinstance(drive, ParallelCrank):
        return value(quantity, drive, circle, kind)
    dead = _dead_turn(drive, quantity.stroke, kind.of) if quantity.of == STROKE else None
    return _direct(quantity, drive, circle, dead, kind)


class _Turn(NamedTuple):
    """sin θ and cos θ of the rocker, sin ψ and cos ψ of the rod against the arc."""

    sine: Any
    cosine: Any
    slant: Any
    slant_cosine: Any


def _direct(
    quantity: Quantity, crank: ArcCrank, circle: Circle[Any], dead: tuple[Any, Any] | None, kind: Kind
) -> Any:
    # With θ = 0 at the dead centre the slide direction is its tangent, in which along and across are.
    turn = _direct_turn(crank, quantity.stroke, circle, kind.of)
    curvature = kind.of(quantity.stroke * crank.curvature)
    nothing = kind.of(Fraction(0))
    along, rise = nothing, nothing
    if dead is not None:
        along, rise = (dead[0] - turn.sine) / curvature, (dead[1] - turn.cosine) / curvature
    across = circle.sine * turn.cosine - circle.cosine * turn.sine
    facing = circle.cosine * turn.cosine + circle.sine * turn.sine
    velocity = across + facing * turn.slant / turn.slant_cosine
    place = Place(nothing, along, rise, turn.slant, turn.slant_cosine, across, facing, velocity)
    arc = Arc(kind.of(quantity.stroke * crank.crank.ratio), curvature, *5 * [nothing])
    return _scaled(quantity, At(place, crank, kind, arc))


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
    return _Turn(sine, cosine, slant, slant_cosine)


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
