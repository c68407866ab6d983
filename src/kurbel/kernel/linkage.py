"""Kinematics of the arc crank (Bogenschubkurbel), whose rod moves a rocker.

The arc crank is the crank drive with its slide line bent to the arc of a rocker of length B. Its numbers
are the crank ratio λ = R/L, the curvature β = R/B of the arc, the offset η and the shift σ: where the rocker
stands square to the slide direction, its end is η R off the line through the shaft and L + σR away from the
shaft along it. β > 0 puts the pivot on the side of the crank pin during the outstroke, β < 0 on the other;
β = 0 is the offset crank of kinematics.py, whatever the shift. Seen from the pivot at (L + σR, ηR + B), the
sign of β is the circuit: both signs with η = h/R - 1/β belong to one pivot (L + σR, h) and to the two ways to
assemble the same four links.

Units are R, the crank-pin velocity v and v²/R, angular velocities ω and ω². The crank angle φ counts from the
slide direction, χ from the inner dead centre, where rod and crank are in line and the rod's end is farthest
from the shaft; paths count from there. All four numbers negative are the return stroke: φ is then counted
from 180° and χ from the outer dead centre, and paths, velocities and accelerations are positive away from it.

Numbers are floats, arrays, balls or separation bounds. Everything here is algebraic in the sine and cosine
of the crank angle; an angle is returned as the sine of its half, of which the caller takes the arc. Valid
where the crank turns and the rocker swings, R + max(L, B, G) < the sum of the other two of L, B and the
distance G of shaft and pivot, and for L + σR > 0.

Floats, with χ taken from φ: at most 12 ulp of max(|value|, 1) from the true value while `steepest_slant` is
at most 0.7, 60 ulp while it is at most 0.95, for |η| and |σ| up to 12.

Rötscher names the drive (Abb. 1043) without formulas; all are re-derived here.

Kinematics of the parallel crank (Parallelkurbel): equal cranks, the rod as long as the shafts are apart.

The second crank turns with the first, angle for angle, the rod stays parallel to the line of the shafts, and
all its points move on circles of radius R, as the crank pin does. Units are R, the crank-pin velocity v and
v²/R; φ counts from the line of shafts. Numbers are floats, arrays, balls or separation bounds.

Rötscher names the drive (Abb. 1045) without formulas; all are re-derived here.
"""

from __future__ import annotations

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Numeric, cosine_of, root


class Arc(NamedTuple, Generic[Kind]):
    """An arc crank at its inner dead centre, or for negative numbers at the outer one.

    ψ is there `slant`, the angle of the rod from the tangent of the arc; `sine` and `cosine` are those of
    the dead centre's crank angle φ_i (φ_o - 180°); `half` is (2/β) tan ½θ of the rocker's angle θ.
    """

    ratio: Kind
    curvature: Kind
    slant: Kind
    slant_cosine: Kind
    half: Kind
    sine: Kind
    cosine: Kind


class Place(NamedTuple, Generic[Kind]):
    """An arc crank at a crank angle, all of one kind of number.

    `half` is (2/β) tan ½ϑ of the angle ϑ by which the rocker has turned from the dead centre; `along` and
    `across` are the way of the rod's end along the tangent of the dead centre and square to it, towards the
    pivot for β > 0; `slant` and `slant_cosine` belong to ψ, the angle of the rod from the arc's tangent;
    `sine` and `cosine` to the crank angle counted from this tangent.
    """

    half: Kind
    along: Kind
    across: Kind
    slant: Kind
    slant_cosine: Kind
    sine: Kind
    cosine: Kind
    velocity: Kind


def arc(ratio: Numeric, curvature: Numeric, offset: Numeric, shift: Numeric) -> Arc[Numeric]:
    """Return the arc crank at its dead centre, from λ, β, η and σ.

    The rod's end is there at the distance L + R from the shaft, for negative numbers L - R.
    """
    # Half of (L + R)² less the squared distance of the arc's touching point, times λ: as a difference of
    # two squares of lengths it would lose the digits of λ.
    gap = 1 - shift + ratio * ((1 - shift) * (1 + shift) - offset * offset) / 2
    slant = (curvature * gap - ratio * offset) / (1 + ratio)
    slant_cosine = cosine_of(slant)
    half = 2 * gap / (1 + ratio * shift + (1 + ratio) * slant_cosine)
    rocker_sine, rocker_cosine = _turn(curvature * half / 2)
    sine = rocker_sine * slant_cosine - rocker_cosine * slant
    cosine = rocker_cosine * slant_cosine + rocker_sine * slant
    return Arc(ratio, curvature, slant, slant_cosine, half, sine, cosine)


def from_dead_centre(circle: Circle[Numeric], arc: Arc[Numeric]) -> Circle[Numeric]:
    """Return the circle of χ = φ - φ_i from that of φ."""
    sine = circle.sine * arc.cosine - circle.cosine * arc.sine
    cosine = circle.cosine * arc.cosine + circle.sine * arc.sine
    # 1 - cos χ would lose half the digits of the path beside the dead centre.
    along, across = circle.cosine - arc.cosine, circle.sine - arc.sine
    return Circle(sine, cosine, (along * along + across * across) / 2)


def place(circle: Circle[Numeric], arc: Arc[Numeric]) -> Place[Numeric]:
    """Return where the drive stands at the crank angle χ from the dead centre."""
    ratio, curvature = arc.ratio, arc.curvature
    reach = 1 + ratio * circle.versine
    side = ratio * circle.sine
    gap = (1 + ratio) * circle.versine
    slant = arc.slant * reach + arc.slant_cosine * side - curvature * gap
    slant_cosine = cosine_of(slant)
    # The rod closes the triangle for two positions of its end on the arc: the roots of a quadratic equation
    # without constant term at the dead centre. This form of the nearer one has no 1/β and no difference.
    half = 2 * gap / (arc.slant_cosine * reach - arc.slant * side + slant_cosine)
    tangent = curvature * half / 2
    turn_sine, turn_cosine = _turn(tangent)
    along = half / (1 + tangent * tangent)
    across = tangent * along
    sine = arc.slant_cosine * circle.sine - arc.slant * circle.cosine
    cosine = arc.slant_cosine * circle.cosine + arc.slant * circle.sine
    # sin φ + cos φ tan ψ at the tangent would not vanish at the dead centre.
    pull = (1 + ratio) * circle.sine - ratio * (along * sine + across * cosine)
    return Place(
        half,
        along,
        across,
        slant,
        slant_cosine,
        sine * turn_cosine + cosine * turn_sine,
        cosine * turn_cosine - sine * turn_sine,
        pull / slant_cosine,
    )


def path_half_sine(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return sin ½ϑ of the angle by which the rocker has turned; the path along the arc is ϑ/β.

    ϑ has the sign of β: the rocker turns against the crank's sense for β > 0.
    """
    return _sine_of(arc.curvature * place.half / 2)


def chord(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the straight distance of the rod's end from its dead position, in units of R."""
    return root(place.along * place.along + place.across * place.across)


def slide_path(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the path of the rod's end as seen along the slide direction, in units of R."""
    sine, cosine = _turn(arc.curvature * arc.half / 2)
    return place.along * cosine + place.across * sine


def rise(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return how far the rod's end has moved square to the slide direction, in units of R.

    Positive towards the side on which the crank pin is during the outstroke; on the return stroke, towards
    the other side.
    """
    sine, cosine = _turn(arc.curvature * arc.half / 2)
    return place.across * cosine - place.along * sine


def rocker_half_sine(arc: Arc[Numeric]) -> Numeric:
    """Return sin ½θ of the rocker's angle at the dead centre, θ = 0 standing square to the slide direction.

    θ is positive in the sense in which the crank turns; elsewhere it is less by ϑ, on both strokes.
    """
    return _sine_of(arc.curvature * arc.half / 2)


def swing_half_sine(inner: Arc[Numeric], outer: Arc[Numeric]) -> Numeric:
    """Return the sine of half the swing; the stroke along the arc is the swing over β, whose sign it has."""
    curvature = inner.curvature
    half = (inner.half + outer.half) / (1 - curvature * curvature * inner.half * outer.half / 4)
    return _sine_of(curvature * half / 2)


def lead_half_sine(inner: Arc[Numeric], outer: Arc[Numeric]) -> Numeric:
    """Return sin ½Δ of the angle by which the outstroke takes more than half a turn, within ±180°.

    The strokes take times in the ratio (180° + Δ) : (180° - Δ).
    """
    sine = outer.sine * inner.cosine - outer.cosine * inner.sine
    return half_sine(sine, outer.cosine * inner.cosine + outer.sine * inner.sine)


def half_sine(sine: Numeric, cosine: Numeric) -> Numeric:
    """Return the sine of half the angle within ±180° that has this sine and cosine."""
    return sine / root(2 * (1 + cosine))


def velocity(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the velocity c of the rod's end along the arc, in units of v; that of ϑ is βc, in ω.

    It is sin ζ/cos ψ with the angle ζ between crank and rod.
    """
    return place.velocity


def acceleration(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the acceleration p of the rod's end along the arc, in units of v²/R; that of ϑ is βp, in ω².

    Towards the pivot it is βc². With the crank angle from the tangent for φ, it is that of the offset crank
    less βc² tan ψ.
    """
    w, turned = place.slant_cosine, place.cosine / place.slant_cosine
    bent = place.sine + arc.curvature * place.velocity * place.velocity
    return place.cosine + (arc.ratio * turned * turned / w - bent * (place.slant / w))


def rod_velocity(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the angular velocity of the rod, λ cos φ/cos ψ with φ from the tangent, in units of ω.

    Of ψ - θ, the rod's angle from the slide direction, which is positive as ψ of the straight crank.
    """
    return arc.ratio * place.cosine / place.slant_cosine


def rod_acceleration(place: Place[Numeric], arc: Arc[Numeric]) -> Numeric:
    """Return the angular acceleration of the rod, in units of ω²."""
    across = place.velocity * (1 + arc.curvature * place.velocity)
    return arc.ratio * (acceleration(place, arc) * place.slant - place.slant_cosine * across)


def rod_force(place: Place[Numeric]) -> Numeric:
    """Return the force along the rod, F/cos ψ, a thrust on the outstroke and a pull on the return stroke.

    F is the unit: it acts on the rod's end along the arc, in the direction of the stroke. Neither masses nor
    friction. Floats: as close as the velocity. Re-derived, as all forces here.
    """
    return 1 / place.slant_cosine


def rocker_force(place: Place[Numeric]) -> Numeric:
    """Return the force along the rocker, F tan ψ, of the rocker on the rod's end.

    Positive towards the side on which the crank pin is during the stroke: towards the pivot, a pull of the
    rocker, for β > 0. It is the guide force of the straight crank. Floats: as close as the velocity.
    """
    # No zero is to have a sign.
    return place.slant / place.slant_cosine + 0


def tangential_force(place: Place[Numeric]) -> Numeric:
    """Return the force across the crank at its pin in units of F, positive as the crank turns.

    In units of F R it is the torque. It is the velocity over v, by the principle of virtual displacements.
    """
    return place.velocity


def radial_force(place: Place[Numeric]) -> Numeric:
    """Return the force along the crank at its pin in units of F, positive towards the shaft.

    It is cos(ζ + ψ)/cos ψ with the crank angle ζ from the arc's tangent. Floats: as close as the velocity.
    """
    return place.cosine - place.sine * (place.slant / place.slant_cosine)


def steepest_slant(ratio: Numeric, curvature: Numeric, offset: Numeric, shift: Numeric) -> Numeric:
    """Return the largest |sin ψ| of the turn, which is cos μ of the least transmission angle μ.

    The crank turns while it is below 1. Crank and ground link are then in line.
    """
    # By the law of cosines sin ψ is linear in the squared distance of pin and pivot, which lies between
    # (G - R)² and (G + R)²: this and the next line are its mean and half its range.
    mean = curvature * shift + ratio * offset + ratio * curvature * (1 + shift * shift + offset * offset) / 2
    along, up = curvature * (1 + ratio * shift), ratio * (1 + curvature * offset)
    return abs(mean) + root(along * along + up * up)


def _sine_of(tangent: Numeric) -> Numeric:
    return tangent / root(1 + tangent * tangent)


def _turn(tangent: Numeric) -> tuple[Numeric, Numeric]:
    """Return sine and cosine of an angle from the tangent of its half."""
    scale = 1 + tangent * tangent
    return 2 * tangent / scale, (1 - tangent) * (1 + tangent) / scale


def coupler_place(circle: Circle[Numeric]) -> Place[Numeric]:
    """Return where any point of the rod of a parallel crank stands, whose way is along the line of shafts.

    The piston's motion with an infinite rod, as of a Scotch yoke, and that square to it; for the return
    stroke likewise. Exact but for what the circle rounded. The angle between rod and crank is φ itself: at 0°
    and 180° all four links lie in line, and the second crank may turn back (antiparallel crank) unless a
    further pair prevents it. The forces that one force F along this line calls up at a crank are those of any
    place: F sin φ across it and F cos φ along it.
    """
    nothing = circle.sine * 0
    sine, cosine, versine = circle.sine, circle.cosine, circle.versine
    return Place(versine, versine, sine, nothing, nothing + 1, sine, cosine, sine)
