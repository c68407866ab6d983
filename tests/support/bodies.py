"""The rod as a body of point masses whose positions mpmath differentiates."""

from __future__ import annotations

from typing import Any, NamedTuple

from hypothesis import settings
from mpmath import mp

from kurbel.kernel import rod as kernel
from kurbel.kernel.circle import Circle
from kurbel.kernel.rod import Masses

# mpmath has no types.
Real = Any


class Drive(NamedTuple):
    """Crank of radius 1 and speed 1 with the shaft at the origin, in the frame of the outstroke."""

    ratio: Real
    offset: Real

    def pin(self, time: Real) -> Real:
        return mp.matrix([mp.cos(time), mp.sin(time)])

    def rod(self, time: Real) -> Real:
        """From crank pin to crosshead pin."""
        across = self.offset - mp.sin(time)
        return mp.matrix([mp.sqrt(self.ratio**-2 - across**2), across])

    def place(self, time: Real, share: Real, aside: Real = 0) -> Real:
        """Where a point of the rod is, at a share of its length from the crank pin and so much beside it."""
        line = self.rod(time)
        return self.pin(time) + share * line + aside * mp.matrix([-line[1], line[0]])

    def acceleration(self, time: Real, share: Real, aside: Real = 0) -> Real:
        return mp.matrix([mp.diff(lambda at, i=i: self.place(at, share, aside)[i], time, 2) for i in (0, 1)])


class Mass(NamedTuple):
    """A point mass at a share of the rod's length from the crank pin, and beside the rod."""

    share: Real
    mass: Real
    aside: Real = 0


Body = list[Mass]


def moment(arm: Real, force: Real) -> Real:
    return arm[0] * force[1] - arm[1] * force[0]


def inertia(drive: Drive, body: Body, time: Real) -> tuple[Real, Real]:
    """Return the sum of mass times acceleration, and that of its moments about the crank pin."""
    force, total = mp.matrix([0, 0]), mp.mpf(0)
    for point in body:
        pull = point.mass * drive.acceleration(time, point.share, point.aside)
        force += pull
        total += moment(drive.place(time, point.share, point.aside) - drive.pin(time), pull)
    return force, total


def reactions(drive: Drive, body: Body, time: Real, piston: Real = 0) -> dict[str, Real]:
    """Solve Newton's equations of the body for the forces of guide and pin; a force -piston acts at B."""
    force, total = inertia(drive, body, time)
    arm = drive.rod(time)
    guide = (total - moment(arm, mp.matrix([-piston, 0]))) / arm[0]
    pin = force - mp.matrix([-piston, guide])
    return {
        "guide": guide,
        "along": pin[0],
        "across": pin[1],
        "pin": mp.norm(pin),
        "torque": -moment(drive.pin(time), pin),
    }


def fields(drive: Drive, time: Real) -> dict[str, list[Real]]:
    """The acceleration at A and at B in each of Ensslin's parts, taken apart by geometry."""
    of_b = drive.acceleration(time, 1)
    replaced = drive.acceleration(time, 0) - of_b
    line = drive.rod(time) * drive.ratio
    stretching = (replaced.T * line)[0] * line
    nothing = mp.matrix([0, 0])
    return {
        "common": [of_b, of_b],
        "turning": [replaced - stretching, nothing],
        "stretching": [stretching, nothing],
    }


def pulled(body: Body, drive: Drive, time: Real, ends: list[Real]) -> tuple[Real, Real]:
    """The force and its moment about B that a body asks for, accelerated as its ends say."""
    arm = drive.rod(time)
    slope = ends[0] - ends[1]
    pulls = [(p.share - 1, p.mass * (ends[1] + (1 - p.share) * slope)) for p in body]
    force = sum((pull for _, pull in pulls), mp.matrix([0, 0]))
    return force, sum(moment(place * arm, pull) for place, pull in pulls)


def energy(drive: Drive, body: Body, time: Real) -> Real:
    velocities = (
        [mp.diff(lambda at, p=p, i=i: drive.place(at, p.share, p.aside)[i], time) for i in (0, 1)]
        for p in body
    )
    return sum(p.mass * (x * x + y * y) / 2 for p, (x, y) in zip(body, velocities, strict=True))


def of_body(body: Body) -> Masses[Real]:
    """Return what the kernel makes of the centre and the gyration of a body of mass 1."""
    centre = sum(p.mass * p.share for p in body)
    return kernel.rod_masses(centre, sum(p.mass * ((p.share - centre) ** 2 + p.aside**2) for p in body))


def point_on_circle(time: Real) -> Circle[Real]:
    return Circle(mp.sin(time), mp.cos(time), 1 - mp.cos(time))


few = settings(max_examples=15, deadline=None)


def spread(centre: Real, gyration_square: Real) -> Body:
    """A body of mass 1 with this centre and gyration: a pair about the centre, and a third in it."""
    reach = mp.sqrt(gyration_square / mp.mpf("0.8"))
    pair = [Mass(centre + side * reach, mp.mpf("0.4")) for side in (1, -1)]
    return [*pair, Mass(centre, mp.mpf("0.2"))]
