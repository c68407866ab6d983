"""The forces in the crank drive of an engine, with the moving masses or without.

They are of a crank angle, in the frame of its stroke; kernel/forces.py and kernel/rod.py say the signs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from kurbel.kernel import forces, rod
from kurbel.kernel.rod import Masses, with_crank


class Weights(NamedTuple):
    """The moving masses of a cylinder in units of Q/(R ω²), in a kind of number.

    `masses` are those of rod and reciprocating parts together, `rotating` the crank's own at its pin.
    """

    masses: Masses[Any]
    reciprocating: Any
    rotating: Any

    @property
    def on_shaft(self) -> Masses[Any]:
        """The masses of which the force at the pin is that of the main bearing."""
        return with_crank(self.masses, self.rotating)


class CrankForce(NamedTuple):
    """A force of the crank drive: `bare` without masses, in the piston force, of circle and ratio; `loaded`
    of circle, ratio, weights and piston force.

    `framed` forces have a direction in the frame of the outstroke: away from its dead centre and towards the
    side of the crank pin. On the return stroke that is the other way round than along the stroke. Of a
    `magnitude` the direction is not said.
    """

    bare: Callable[[Any, Any], Any]
    loaded: Callable[[Any, Any, Weights, Any], Any]
    framed: bool = False
    magnitude: bool = False

    def of(self, circle: Any, ratio: Any, weights: Weights | None, net: Any) -> Any:
        """Return the force that a net pressure on the piston calls up, in the frame of the stroke."""
        if weights is not None:
            return self.loaded(circle, ratio, weights, net)
        force = net * self.bare(circle, ratio)
        return abs(force) if self.magnitude else force


CRANK_FORCES: Mapping[str, CrankForce] = {
    "piston_force": CrankForce(lambda circle, ratio: 1, lambda circle, ratio, one, net: net, framed=True),
    "rod_force": CrankForce(
        forces.rod_force,
        lambda circle, ratio, one, net: rod.rod_force(
            circle, ratio, one.masses, one.reciprocating, None, net
        ),
        framed=True,
    ),
    "guide_force": CrankForce(
        forces.guide_force,
        lambda circle, ratio, one, net: rod.guide_force(circle, ratio, one.masses, None, net),
        framed=True,
    ),
    "crosshead_pin_force": CrankForce(
        forces.rod_force,
        lambda circle, ratio, one, net: rod.crosshead_pin_force(
            circle, ratio, one.masses, one.reciprocating, None, net
        ),
        magnitude=True,
    ),
    "crank_pin_force": CrankForce(
        forces.rod_force,
        lambda circle, ratio, one, net: rod.pin_force(circle, ratio, one.masses, None, net),
        magnitude=True,
    ),
    "crank_force": CrankForce(
        forces.tangential_force,
        lambda circle, ratio, one, net: rod.torque(circle, ratio, one.masses, None, net),
    ),
    "radial_force": CrankForce(
        forces.radial_force,
        lambda circle, ratio, one, net: rod.radial_force(circle, ratio, one.masses, None, net),
    ),
    "bearing_force": CrankForce(
        forces.rod_force,
        lambda circle, ratio, one, net: rod.pin_force(circle, ratio, one.on_shaft, None, net),
        magnitude=True,
    ),
    "bearing_along": CrankForce(
        lambda circle, ratio: 1,
        lambda circle, ratio, one, net: rod.pin_force_along(circle, ratio, one.on_shaft, None, net),
        framed=True,
    ),
    "bearing_across": CrankForce(
        forces.guide_force,
        lambda circle, ratio, one, net: 0 - rod.pin_force_across(circle, ratio, one.on_shaft, None, net),
        framed=True,
    ),
}
