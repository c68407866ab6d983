"""The straight crank by the formulas of first order, its masses among them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from kurbel.drive.moved import Slide
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.effort.weight import Weight
from kurbel.kernel.inertia import first_order
from kurbel.kernel.inertia.accelerations import WITH_ARM
from kurbel.kernel.rod import Loaded, Masses


class FirstOrderSlide(Slide):
    """The straight crank whose piston moves to first order, and whose torque is the slope of an energy."""

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
        return replace(found, by=WITH_ARM)

    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return first_order.kinetic_energy(circle, self.ratios[stroke], masses)

    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return first_order.torque_slope(circle, self.ratios[stroke], masses)
