"""Kinematics of the parallel crank (Parallelkurbel): equal cranks, the rod as long as the shafts are apart.

The second crank turns with the first, angle for angle, the rod stays parallel to the line of the shafts, and
all its points move on circles of radius R, as the crank pin does. Units are R, the crank-pin velocity v and
v²/R; φ counts from the line of shafts. Numbers are floats, arrays, balls or separation bounds.

Rötscher names the drive (Abb. 1045) without formulas; all are re-derived here.
"""

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Number
from kurbel.kernel.linkage import Place


class Coupler(NamedTuple, Generic[Kind]):
    """The motion of any point of the rod, in units of R, v and v²/R.

    `path` is the way along the line of shafts from φ = 0, positive as the piston path, `rise` that square to
    it; velocities and accelerations are theirs.
    """

    path: Kind
    rise: Kind
    velocity: Kind
    rise_velocity: Kind
    acceleration: Kind
    rise_acceleration: Kind


def coupler(circle: Circle[Number]) -> Coupler[Number]:
    """Return the motion of the rod of a parallel crank.

    The piston's motion with an infinite rod, and that square to it; for the return stroke likewise. Exact but
    for what the circle rounded. The angle between rod and crank is φ itself: at 0° and 180° all four links
    lie in line, and the second crank may turn back (antiparallel crank) unless a further pair prevents it.
    """
    return Coupler(circle.versine, circle.sine, circle.sine, circle.cosine, circle.cosine, -circle.sine)


def coupler_place(circle: Circle[Number]) -> Place[Number]:
    """Return where the rod of a parallel crank stands, whose way is along the line of shafts.

    The forces that one force F along this line calls up at a crank are those of any place: F sin φ across it
    and F cos φ along it.
    """
    nothing = circle.sine * 0
    sine, cosine, versine = circle.sine, circle.cosine, circle.versine
    return Place(versine, versine, sine, nothing, nothing + 1, sine, cosine, sine)
