"""The arc crank with its masses, as bodies on links closed by mpmath: Newton's equations, solved at once."""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from bodies import Body, Mass, Real, moment
from links import links, pointer
from mpmath import mp

from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.motion.evaluation import OUT


class Heavy(NamedTuple):
    """An arc crank of radius 1 that turns at speed 1: the rod's points of mass 1 together and its mass, one
    at the rocker's end, the rocker's moment of inertia over the square of its length, and the crank's own
    mass at its pin; the force on the rocker's end in the direction of the stroke."""

    crank: RockerCrank
    body: Body
    rod: Real
    reciprocating: Real
    rocker: Real
    rotating: Real
    force: Real

    def joint(self, phi: Real) -> Real:
        machine = links(self.crank)
        return machine.end(machine.angles(phi)[1])

    def point(self, phi: Real, mass: Mass) -> Real:
        pin, joint = pointer(phi), self.joint(phi)
        return pin + (mass.share + 1j * mass.aside) * (joint - pin)

    def acceleration(self, phi: Real, mass: Mass) -> Real:
        bent = mp.diff(self.joint, phi, 2)
        return -pointer(phi) + (mass.share + 1j * mass.aside) * (bent + pointer(phi))

    def energy(self, phi: Real) -> Real:
        """The kinetic energy of rod and rocker's end."""
        rod = mp.fsum(one.mass * abs(mp.diff(partial(self.point, mass=one), phi)) ** 2 for one in self.body)
        return (self.rod * rod + (self.reciprocating + self.rocker) * abs(mp.diff(self.joint, phi)) ** 2) / 2

    def newton(self, stroke: int, angle: Real) -> dict[str, Real]:
        """Solve the equations of motion of rod, joint and rocker at an angle from the stroke's 0°."""
        phi = angle + (0 if stroke == OUT else mp.pi)
        machine, pin, joint = links(self.crank), pointer(phi), self.joint(phi)
        arm = joint - machine.pivot
        way = -1j * machine.right * stroke * arm / machine.rocker
        pulls = [
            (self.rod * one.mass * self.acceleration(phi, one), self.point(phi, one) - pin)
            for one in self.body
        ]
        bent = mp.diff(self.joint, phi, 2)
        # Unknown are the forces of the crank pin and of the joint on the rod, and of the rocker on the joint.
        along = joint - pin
        rows = [[1, 0, 1, 0, 0, 0], [0, 1, 0, 1, 0, 0], [0, 0, -along.imag, along.real, 0, 0]]
        rows += [[0, 0, -1, 0, 1, 0], [0, 0, 0, -1, 0, 1], [0, 0, 0, 0, arm.imag, -arm.real]]
        total = mp.fsum(pull for pull, _ in pulls)
        turned = mp.fsum(moment(pair(at), pair(pull)) for pull, at in pulls)
        # J times the angular acceleration of the rocker is J/B² times the moment of its end's acceleration.
        right = [*pair(total), turned, *pair(self.reciprocating * bent - self.force * way)]
        right.append(self.rocker * moment(pair(arm), pair(bent)))
        found = mp.lu_solve(mp.matrix(rows), mp.matrix(right))
        on_pin, on_end, of_rocker = (mp.mpc(found[i], found[i + 1]) for i in (0, 2, 4))
        on_bearing = -on_pin + self.rotating * pin
        # The frame of the stroke: X against the way, Y to its right.
        across, line = -1j * way, (pin - joint) / machine.rod
        return {
            "guide_force": dot(of_rocker, across),
            "thrust": dot(on_end, way),
            "rod_force": stroke * dot(on_end, line),
            "crosshead_pin_force": abs(on_end),
            "pin_force": abs(on_pin),
            "pin_force_along": stroke * on_pin.real,
            "pin_force_across": stroke * on_pin.imag,
            "radial_force": dot(on_pin, pin),
            "torque": -moment(pair(pin), pair(on_pin)),
            "bearing_along": -stroke * on_bearing.real,
            "bearing_across": stroke * on_bearing.imag,
            "bearing_force": abs(on_bearing),
        }


def pair(number: Real) -> list[Real]:
    return [number.real, number.imag]


def dot(one: Real, other: Real) -> Real:
    return one.real * other.real + one.imag * other.imag
