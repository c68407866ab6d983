"""The forces in the crank drive of an engine, with the moving masses or without.

They are of a crank angle, in the frame of its stroke; kernel/forces.py and kernel/rod.py say the signs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from kurbel.kernel import forces
from kurbel.kernel.rod import Loaded, Masses, with_crank


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
    """A force of the crank drive: `bare` without masses, in the piston force, of circle, ratio and e/R or
    None; `loaded` of circle, ratio, weights, e/R or None and piston force.

    `framed` forces have a direction in the frame of the outstroke: away from its dead centre and towards the
    side of the crank pin. On the return stroke that is the other way round than along the stroke. Of a
    `magnitude` the direction is not said.
    """

    bare: Callable[[Any, Any, Any], Any]
    loaded: Callable[[Any, Any, Weights, Any, Any], Any]
    framed: bool = False
    magnitude: bool = False

    def of(self, circle: Any, ratio: Any, weights: Weights | None, net: Any) -> Any:
        """Return the force that a net pressure on the piston calls up in a straight crank drive."""
        if weights is not None:
            return self.loaded(circle, ratio, weights, None, net)
        force = net * self.bare(circle, ratio, None)
        return abs(force) if self.magnitude else force


def _of_rod(force: Callable[[Loaded], Any]) -> Callable[..., Any]:
    return lambda circle, ratio, one, e, net: force(
        Loaded(circle, ratio, one.masses, e, net, one.reciprocating)
    )


def _on_shaft(force: Callable[[Loaded], Any], sign: int = 1) -> Callable[..., Any]:
    return lambda circle, ratio, one, e, net: sign * force(Loaded(circle, ratio, one.on_shaft, e, net))


def _unit(circle: Any, ratio: Any, offset: Any) -> Any:
    return 1


CRANK_FORCES: Mapping[str, CrankForce] = {
    "piston_force": CrankForce(_unit, lambda circle, ratio, one, e, net: net, framed=True),
    "rod_force": CrankForce(forces.rod_force, _of_rod(Loaded.rod_force), framed=True),
    "guide_force": CrankForce(forces.guide_force, _of_rod(Loaded.guide_force), framed=True),
    "crosshead_pin_force": CrankForce(forces.rod_force, _of_rod(Loaded.crosshead_pin_force), magnitude=True),
    "crank_pin_force": CrankForce(forces.rod_force, _of_rod(Loaded.pin_force), magnitude=True),
    "tangential_force": CrankForce(forces.tangential_force, _of_rod(Loaded.torque)),
    "radial_force": CrankForce(forces.radial_force, _of_rod(Loaded.radial_force)),
    "bearing_along": CrankForce(_unit, _on_shaft(Loaded.pin_force_along), framed=True),
    "bearing_across": CrankForce(forces.guide_force, _on_shaft(Loaded.pin_force_across, -1), framed=True),
    "bearing_force": CrankForce(forces.rod_force, _on_shaft(Loaded.pin_force), magnitude=True),
}
