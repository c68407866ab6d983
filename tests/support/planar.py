"""A crank drive as two rigid bodies in a plane, rod and crosshead, by Newton's and Euler's equations.

All is in SI units and in the frame of the outstroke: X from the shaft along the slide to the cylinder, Y to
the side of the crank pin on the outstroke. mpmath differentiates the positions of the links; five equations
give the forces at both pins and the guide. Nothing of kurbel's.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any

from mpmath import mp

# mpmath has no types.
Real = Any


@dataclass(frozen=True)
class Drive:
    """A crank R, a rod L, the slide at e; the rod's mass, its centre from the crosshead pin and its radius of
    gyration in lengths; the slope in degrees, and what pushes the piston towards the shaft."""

    radius: float
    rod: float
    offset: float
    omega: float
    reciprocating: float
    mass: float
    centre: float
    gyration: float
    slope: float | None = None
    gravity: float = 9.80665
    force: float = 0.0
    friction: float = 0.0
    rotating: float = 0.0

    def pin(self, angle: Real) -> Real:
        return mp.matrix([self.radius * mp.cos(angle), self.radius * mp.sin(angle)])

    def crosshead(self, angle: Real) -> Real:
        across = self.offset - self.radius * mp.sin(angle)
        reach = mp.sqrt(mp.mpf(self.rod) ** 2 - across**2)
        return mp.matrix([self.radius * mp.cos(angle) + reach, self.offset])

    def centre_of_rod(self, angle: Real) -> Real:
        return self.crosshead(angle) + self.centre * (self.pin(angle) - self.crosshead(angle))

    def direction(self, angle: Real) -> Real:
        """The angle of the rod from the slide, from crank pin to crosshead pin."""
        line = self.crosshead(angle) - self.pin(angle)
        return mp.atan2(line[1], line[0])

    def second(self, motion: Any, angle: Real) -> Real:
        """The second derivative by time of what moves with the crank."""
        return self.omega**2 * mp.diff(motion, angle, 2)

    @property
    def gravitation(self) -> tuple[Real, Real]:
        if self.slope is None:
            return mp.mpf(0), mp.mpf(0)
        steep = mp.radians(self.slope)
        return -self.gravity * mp.sin(steep), -self.gravity * mp.cos(steep)

    def rubbing(self, angle: Real) -> Real:
        """The friction on the crosshead along X."""
        return -self.friction * mp.sign(mp.diff(lambda at: self.crosshead(at)[0], angle))

    def forces(self, degrees: float) -> dict[str, float]:
        """Return the forces by the keys of kurbel's columns, all in the frame of the outstroke."""
        angle = mp.radians(degrees)
        falling, sideways = self.gravitation
        head = self.second(lambda at: self.crosshead(at)[0], angle)
        middle = [self.second(lambda at, i=i: self.centre_of_rod(at)[i], angle) for i in (0, 1)]
        spin = self.second(self.direction, angle)
        to_pin = self.pin(angle) - self.centre_of_rod(angle)
        to_head = self.crosshead(angle) - self.centre_of_rod(angle)
        # Unknown: the forces on the rod at the crank pin and at the crosshead, and that of the guide.
        equations = mp.matrix([
            [1, 0, 1, 0, 0],
            [0, 1, 0, 1, 0],
            [-to_pin[1], to_pin[0], -to_head[1], to_head[0], 0],
            [0, 0, -1, 0, 0],
            [0, 0, 0, -1, 1],
        ])  # fmt: skip
        turned = self.mass * (self.gyration * self.rod) ** 2 * spin
        known = mp.matrix([
            self.mass * (middle[0] - falling), self.mass * (middle[1] - sideways), turned,
            self.reciprocating * (head - falling) + self.force - self.rubbing(angle),
            -self.reciprocating * sideways,
        ])  # fmt: skip
        pin_x, pin_y, head_x, head_y, guide = mp.lu_solve(equations, known)
        place = self.pin(angle)
        line = (self.crosshead(angle) - place) / self.rod
        crank = self.rotating * self.radius * self.omega**2
        found = {
            "piston_force_n": self.force,
            "inertia_force_n": self.reciprocating * head,
            "weight_force_n": -self.reciprocating * falling,
            "friction_force_n": -self.rubbing(angle),
            "crosshead_load_n": -head_x,
            "guide_force_n": guide,
            "rod_force_n": -(head_x * line[0] + head_y * line[1]),
            "crosshead_pin_force_n": mp.hypot(head_x, head_y),
            "crank_pin_force_n": mp.hypot(pin_x, pin_y),
            "torque_nm": place[1] * pin_x - place[0] * pin_y,
            "radial_force_n": (place[0] * pin_x + place[1] * pin_y) / self.radius,
            "bearing_along_n": -(crank * mp.cos(angle) - pin_x),
            "bearing_across_n": crank * mp.sin(angle) - pin_y,
        }
        return {key: float(value) for key, value in found.items()}

    def energy(self, angle: Real) -> Real:
        """The energy of motion and of height."""
        falling, sideways = self.gravitation
        velocities = [self.omega * mp.diff(lambda at, i=i: self.centre_of_rod(at)[i], angle) for i in (0, 1)]
        head = self.omega * mp.diff(lambda at: self.crosshead(at)[0], angle)
        spin = self.omega * mp.diff(self.direction, angle)
        middle = self.centre_of_rod(angle)
        moving = self.mass * (sum(one**2 for one in velocities) + (self.gyration * self.rod * spin) ** 2)
        height = self.mass * (falling * middle[0] + sideways * middle[1])
        height += self.reciprocating * falling * self.crosshead(angle)[0]
        return (moving + self.reciprocating * head**2) / 2 - height

    @property
    def options(self) -> dict[str, Any]:
        """The same as kurbel is told it."""
        given: dict[str, Any] = {
            "stroke": f"{2000 * self.radius:.1f}mm", "rod": f"{1000 * self.rod:.1f}mm",
            "speed": f"{self.omega}rad/s", "reciprocating": f"{self.reciprocating}kg",
            "rod_mass": f"{self.mass}kg", "centre": str(self.centre), "gyration": str(self.gyration),
            "rotating": f"{self.rotating}kg",
        }  # fmt: skip
        if self.offset:
            given["offset"] = f"{1000 * self.offset:.1f}mm"
        if self.slope is not None:
            given |= {"slope": str(self.slope), "gravity": str(self.gravity)}
        return given


def drawn(seed: int) -> Drive:
    """Return a random drive, its numbers as they are typed."""
    chance = random.Random(seed)

    def number(low: float, high: float, places: int = 2) -> float:
        return round(chance.uniform(low, high), places)

    radius = number(0.1, 0.4)
    rod = round(radius * number(2.5, 5), 2)
    offset = chance.choice([0.0, number(-0.3, 0.3) * radius])
    return Drive(
        radius, rod, round(offset, 3), number(5, 30), number(50, 400, 0), number(40, 200, 0),
        number(0.3, 0.8), number(0.2, 0.4), number(-180, 180, 0), number(9.7, 9.9),
        rotating=number(-50, 80, 0),
    )  # fmt: skip
