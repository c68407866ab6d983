"""Kinematics of any point of the rod, from those of its two ends.

A point stands at the share s of the way from the driven end B of the rod to its crank pin A, and t rod
lengths beside it, on the side of the crank pin during the outstroke. The rod is rigid: every vector of the
point is 1 - s times that of B, s times that of A, and t times that from B to A turned by a quarter, whatever
guides B. So no quantity of a point has roots or quotients of its own.

Vectors are along the slide direction, positive away from the inner dead centre as the piston path, and across
it, positive towards the side of the crank pin during the outstroke. Along, a path counts from where the point
is at the inner dead centre of the drive, across from the slide direction through the shaft. Units are R, the
crank-pin velocity v and v²/R. Numbers are floats, arrays, balls or separation bounds. Re-derived.
"""

from __future__ import annotations

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Numeric, cosine_of
from kurbel.kernel.kinematics import dead_centre_sine, rod_cosine, rod_sine
from kurbel.kernel.linkage import Arc, Place
from kurbel.kernel.linkage import acceleration as acceleration_of
from kurbel.kernel.rod import Vector


class End(NamedTuple, Generic[Kind]):
    """Path, velocity and acceleration of an end of the rod."""

    path: Vector[Kind]
    velocity: Vector[Kind]
    acceleration: Vector[Kind]


class Rod(NamedTuple, Generic[Kind]):
    """The ends of a rod at a crank angle, the driven end B and the crank pin A."""

    driven: End[Kind]
    pin: End[Kind]


class Reach(NamedTuple, Generic[Kind]):
    """How far A lies from B along the slide direction, and across it at the inner dead centre."""

    along: Kind
    across_at_rest: Kind


class Point(NamedTuple, Generic[Kind]):
    """A point at the share s of the rod from B to A, and t rod lengths beside it; None is on its axis."""

    share: Kind
    beside: Kind | None = None


def path(rod: Rod[Numeric], point: Point[Numeric], reach: Reach[Numeric] | None) -> Vector[Numeric]:
    """Return the path of the point, in units of R. The reach is asked for beside the axis alone."""
    on_axis = _between(rod.driven.path, rod.pin.path, point.share)
    if point.beside is None or reach is None:
        return on_axis
    lift = rod.pin.path.across - rod.driven.path.across - reach.across_at_rest
    return Vector(on_axis.along - point.beside * lift, on_axis.across + point.beside * reach.along)


def velocity(rod: Rod[Numeric], point: Point[Numeric]) -> Vector[Numeric]:
    """Return the velocity of the point, in units of v."""
    return _moved(rod.driven.velocity, rod.pin.velocity, point)


def acceleration(rod: Rod[Numeric], point: Point[Numeric]) -> Vector[Numeric]:
    """Return the acceleration of the point of a drive that turns evenly, in units of v²/R."""
    return _moved(rod.driven.acceleration, rod.pin.acceleration, point)


def _moved(driven: Vector[Numeric], pin: Vector[Numeric], point: Point[Numeric]) -> Vector[Numeric]:
    on_axis, beside = _between(driven, pin, point.share), point.beside
    if beside is None:
        return on_axis
    return Vector(
        on_axis.along - beside * (pin.across - driven.across),
        on_axis.across + beside * (pin.along - driven.along),
    )


def _between(driven: Vector[Numeric], pin: Vector[Numeric], share: Numeric) -> Vector[Numeric]:
    # driven + s (pin - driven) would not be the pin itself at s = 1. No zero is to have a sign.
    rest = 1 - share
    return Vector(
        rest * driven.along + share * pin.along + 0,
        rest * driven.across + share * pin.across + 0,
    )


def crank_pin(circle: Circle[Numeric], path: Numeric) -> End[Numeric]:
    """Return the crank pin, by its path along the slide direction from the dead centre."""
    sine, cosine = circle.sine, circle.cosine
    return End(Vector(path, sine), Vector(sine, cosine), Vector(cosine, -sine))


def slide_rod(
    circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None, motion: tuple[Numeric, Numeric, Numeric]
) -> Rod[Numeric]:
    """Return the rod of a drive with a crosshead, by its path, velocity and acceleration; without an offset,
    None, the dead centre is φ = 0."""
    nothing = circle.sine * 0
    path, velocity, acceleration = (Vector(one, nothing) for one in motion)
    if offset is None:
        return Rod(End(path, velocity, acceleration), crank_pin(circle, circle.versine))
    dead_sine = dead_centre_sine(ratio, offset)
    dead_versine = dead_sine * dead_sine / (1 + cosine_of(dead_sine))
    raised = path._replace(across=nothing + offset)
    return Rod(End(raised, velocity, acceleration), crank_pin(circle, circle.versine - dead_versine))


def slide_reach(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Reach[Numeric]:
    """Return the reach of such a rod, L cos ψ, of a length that is not infinite."""
    if offset is None:
        return Reach(rod_cosine(circle, ratio) / ratio, circle.sine * 0)
    lean = cosine_of(rod_sine(circle, ratio, offset))
    # The rod is in line with the crank at the dead centre.
    return Reach(lean / ratio, -dead_centre_sine(ratio, offset) / ratio)


def first_order_reach(circle: Circle[Numeric], ratio: Numeric) -> Reach[Numeric]:
    """Return the reach of a straight rod to first order in λ, L - ½ λ R sin² φ."""
    return Reach(1 / ratio - ratio * circle.sine * circle.sine / 2, circle.sine * 0)


def rocker_rod(
    circle: Circle[Numeric], place: Place[Numeric], arc: Arc[Numeric], height: Numeric, path: Numeric
) -> Rod[Numeric]:
    """Return the rod of a drive whose rod moves a rocker.

    `height` is the offset η of the rocker's arc, `path` that of its end along the slide direction.
    """
    turn = arc_direction(circle, place)
    # The end is drawn to the pivot by βc².
    velocity, draught = place.velocity, arc.curvature * place.velocity * place.velocity
    driven = End(
        Vector(path, height + (1 - turn.along) / arc.curvature),
        Vector(velocity * turn.along, -velocity * turn.across),
        _turned(Vector(acceleration_of(place, arc), draught), turn),
    )
    return Rod(driven, crank_pin(circle, arc.cosine - circle.cosine))


def rocker_reach(circle: Circle[Numeric], place: Place[Numeric], arc: Arc[Numeric]) -> Reach[Numeric]:
    """Return the reach of such a rod, of a length that is not infinite."""
    along = _turned(Vector(place.slant_cosine, place.slant), arc_direction(circle, place)).along
    return Reach(along / arc.ratio, -arc.sine / arc.ratio)


def arc_direction(circle: Circle[Numeric], place: Place[Numeric]) -> Vector[Numeric]:
    """Return cosine and sine of the direction of the arc from that of the slide, as the crank turns."""
    return Vector(
        circle.cosine * place.cosine + circle.sine * place.sine,
        circle.sine * place.cosine - circle.cosine * place.sine,
    )


def _turned(vector: Vector[Numeric], turn: Vector[Numeric]) -> Vector[Numeric]:
    """Return what is along the arc and towards its pivot as it is along the slide direction and across it."""
    return Vector(
        vector.along * turn.along + vector.across * turn.across,
        vector.across * turn.along - vector.along * turn.across,
    )
