"""The straight crank by the formulas of first order, its masses among them.

The first order is that of the motion: path, velocity and acceleration of the piston, the turning of the rod.
Works and energies are those of this motion. Forces pass through the drive at the exact angle of the rod, as
under one force on the piston, so that those of a place compose; the tangential force then differs from the
slope of the work as the exact velocity does from that of first order.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from kurbel.drive.moved import Slide, framed
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.effort.weight import Weight
from kurbel.kernel.forces import tangential_force
from kurbel.kernel.inertia import first_order
from kurbel.kernel.inertia.accelerations import OF_FIRST_ORDER
from kurbel.kernel.rod import Loaded, Masses


class FirstOrderSlide(Slide):
    """The straight crank whose piston and rod move to first order."""

    def loaded(
        self,
        stroke: int,
        circle: Circle[Any],
        masses: Masses[Any],
        net: Number,
        reciprocating: Number = 0,
        weight: Weight[Any] | None = None,
        friction: Number | None = None,
    ) -> Loaded:
        found = super().loaded(stroke, circle, masses, net, reciprocating, weight, friction)
        return replace(found, by=OF_FIRST_ORDER)

    def lever(self, stroke: int, circle: Circle[Any]) -> Number:
        return tangential_force(circle, self.ratios[stroke])

    def power(
        self, stroke: int, circle: Circle[Any], masses: Masses[Any], weight: Weight[Any] | None
    ) -> Number:
        return first_order.power(circle, self.ratios[stroke], masses, framed(weight, stroke))

    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return first_order.kinetic_energy(circle, self.ratios[stroke], masses)

    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return first_order.torque_slope(circle, self.ratios[stroke], masses)
