"""The forces in the crank drive of an engine, with the moving masses or without.

They are of a crank angle, in the frame of its stroke; kernel/forces.py and kernel/rod.py say the signs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter, methodcaller
from typing import Any, NamedTuple

from kurbel.kernel import forces
from kurbel.kernel.forces import Weight
from kurbel.kernel.moving import Masses, with_crank
from kurbel.kernel.rod import Loaded


class Weights(NamedTuple):
    """The moving masses of a cylinder in units of Q/(R ω²), in a kind of number.

    `masses` are those of rod and reciprocating parts together, `rotating` the crank's own at its pin.
    What they weigh, in Q and in the frame of the outstroke, is None where that does not count.
    """

    masses: Masses[Any]
    reciprocating: Any
    rotating: Any
    weight: Weight[Any] | None = None

    @property
    def still(self) -> Weights | None:
        """The same without inertia, None if nothing is left."""
        if self.weight is None:
            return None
        nothing = 0 * self.masses.pin
        return Weights(Masses(nothing, nothing, nothing, nothing), nothing, nothing, self.weight)

    @property
    def on_shaft(self) -> Masses[Any]:
        """The masses of which the force at the pin is that of the main bearing."""
        return with_crank(self.masses, self.rotating)


NOTHING = Weights(Masses(0, 0, 0, 0), 0, 0)


class CrankForce(NamedTuple):
    """A force of the crank drive: `bare` without masses, in the piston force, of circle, ratio and e/R or
    None; `on` the drive with its masses under a piston force, those `on_shaft` if it is the main bearing's.

    `framed` forces have a direction in the frame of the outstroke: away from its dead centre and towards the
    side of the crank pin. On the return stroke that is the other way round than along the stroke. Of a
    `magnitude` the direction is not said.
    """

    bare: Callable[[Any, Any, Any], Any]
    on: Callable[[Any], Any]
    framed: bool = False
    magnitude: bool = False
    on_shaft: bool = False

    def loaded(self, circle: Any, ratio: Any, weights: Weights, offset: Any, net: Any) -> Any:
        """Return the force in a straight or offset crank drive with these masses."""
        if self.on_shaft:
            return self.on(Loaded(circle, ratio, weights.on_shaft, offset, net))
        return self.on(Loaded(circle, ratio, weights.masses, offset, net, weights.reciprocating))


def _unit(circle: Any, ratio: Any, offset: Any) -> Any:
    return 1


def _none(circle: Any, ratio: Any, offset: Any) -> Any:
    return 0


def _across(drive: Loaded) -> Any:
    return -1 * drive.pin_force_across()


# Other drives know the same forces by these names.
_THRUST, _ROD, _GUIDE = attrgetter("piston_force"), methodcaller("rod_force"), methodcaller("guide_force")
_PIN, _CROSSHEAD = methodcaller("pin_force"), methodcaller("crosshead_pin_force")
_TORQUE, _RADIAL = methodcaller("torque"), methodcaller("radial_force")
_ALONG, _CROSSHEAD_LOAD = methodcaller("pin_force_along"), methodcaller("thrust")
_PIN_ROD, _INERTIA = methodcaller("pin_rod_force"), methodcaller("inertia_force")
CRANK_FORCES: Mapping[str, CrankForce] = {
    "piston_force": CrankForce(_unit, _THRUST, framed=True),
    "inertia_force": CrankForce(_none, _INERTIA, framed=True),
    "crosshead_load": CrankForce(_unit, _CROSSHEAD_LOAD, framed=True),
    "rod_force": CrankForce(forces.rod_force, _ROD, framed=True),
    "pin_rod_force": CrankForce(forces.rod_force, _PIN_ROD, framed=True),
    "guide_force": CrankForce(forces.guide_force, _GUIDE, framed=True),
    "crosshead_pin_force": CrankForce(forces.rod_force, _CROSSHEAD, magnitude=True),
    "crank_pin_force": CrankForce(forces.rod_force, _PIN, magnitude=True),
    "tangential_force": CrankForce(forces.tangential_force, _TORQUE),
    "radial_force": CrankForce(forces.radial_force, _RADIAL),
    "bearing_along": CrankForce(_unit, _ALONG, framed=True, on_shaft=True),
    "bearing_across": CrankForce(forces.guide_force, _across, framed=True, on_shaft=True),
    "bearing_force": CrankForce(forces.rod_force, _PIN, magnitude=True, on_shaft=True),
    "weight_force": CrankForce(_none, methodcaller("weight_force"), framed=True),
    "friction_force": CrankForce(_none, methodcaller("friction_force"), framed=True),
}
