"""The crank drive by Newton and Euler: a piston, a rod, and the pins between them, as linear equations.

The x axis points along the slide from the shaft to the cylinder, y to the side on which the crank pin runs on
the outstroke. Accelerations are numerical derivatives of the places of the bodies.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from mpmath import asin, cos, diff, lu_solve, matrix, mpf, radians, sin, sqrt

Motion = Callable[[mpf], mpf]
ZERO = mpf(0)


@dataclass(frozen=True)
class Drive:
    """Lengths in m, speed in rad/s, masses in kg; centre of mass and gyration of the rod in m.

    `slope` is the angle in degrees by which x rises in the sense of rotation.
    """

    crank: mpf
    rod: mpf
    speed: mpf
    piston: mpf = ZERO
    rod_mass: mpf = ZERO
    centre: mpf = ZERO
    gyration: mpf = ZERO
    slope: mpf = ZERO
    gravity: mpf = ZERO

    def lean(self, phi: mpf) -> mpf:
        return asin(self.crank * sin(phi) / self.rod)

    def crosshead(self, phi: mpf) -> mpf:
        return self.crank * cos(phi) + self.rod * cos(self.lean(phi))

    def acceleration(self, place: Motion, phi: mpf) -> mpf:
        """The second derivative with respect to time, the crank turning evenly."""
        return diff(place, phi, 2) * self.speed**2

    def forces(self, angle: mpf, force: mpf | int, acceleration: mpf | None = None) -> dict[str, mpf]:
        """What the bodies exert on each other at a crank angle in degrees, under a force on the piston.

        `acceleration` is that of the piston along x, where it is not to be the true one.
        """
        phi = radians(angle)
        psi = self.lean(phi)
        share = self.centre / self.rod
        if acceleration is None:
            acceleration = self.acceleration(self.crosshead, phi)
        pull_x, pull_y = (-self.gravity * turn(radians(self.slope)) for turn in (sin, cos))
        # The rod's centre of mass from its crosshead pin.
        towards_a = matrix([-cos(psi), sin(psi)])

        def centre_x(at: mpf) -> mpf:
            return self.crosshead(at) - self.centre * cos(self.lean(at))

        def centre_y(at: mpf) -> mpf:
            return share * self.crank * sin(at)

        rod_x = self.rod_mass * (self.acceleration(centre_x, phi) - pull_x)
        rod_y = self.rod_mass * (self.acceleration(centre_y, phi) - pull_y)
        # The rod's direction from A to B is at −ψ.
        turning = -self.rod_mass * self.gyration**2 * self.acceleration(self.lean, phi)
        to_b = -self.centre * towards_a
        to_a = (self.rod - self.centre) * towards_a
        # Unknown: force of the crank pin on the rod, of the piston on the rod, of the guide on the piston.
        left = matrix(
            [
                [1, 0, 1, 0, 0],
                [0, 1, 0, 1, 0],
                [-to_a[1], to_a[0], -to_b[1], to_b[0], 0],
                [0, 0, -1, 0, 0],
                [0, 0, 0, -1, 1],
            ]
        )
        piston_x = self.piston * (acceleration - pull_x) + force
        right = matrix([rod_x, rod_y, turning, piston_x, -self.piston * pull_y])
        ax, ay, bx, by, guide = lu_solve(left, right)
        tangential = ax * sin(phi) - ay * cos(phi)
        return {
            "rod_force_n": -bx * cos(psi) + by * sin(psi),
            "guide_force_n": guide,
            "crank_pin_force_n": sqrt(ax**2 + ay**2),
            "tangential_force_n": tangential,
            "radial_force_n": ax * cos(phi) + ay * sin(phi),
            "torque_nm": tangential * self.crank,
        }
