"""The piston at a rocker's end over the strokes: what an engine asks of a crank that moves a rocker."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kurbel.drive.moved import Moved
from kurbel.kernel import linkage, rocker
from kurbel.kernel.linkage import Place
from kurbel.motion.evaluation import OUT, RETURN

if TYPE_CHECKING:
    from kurbel.exact.kind import Kind
    from kurbel.kernel.circle import Circle, Number
    from kurbel.kernel.effort.weight import Weight
    from kurbel.kernel.rocker import LoadedRocker
    from kurbel.kernel.rod import Masses
    from kurbel.linkage.arc.rocker import RockerCrank

STROKES = (OUT, RETURN)


class MovedRocker(Moved):
    """A crank that moves a rocker, under a piston whose way is that of the rocker's end along its arc."""

    # The path is an arc.

    def __init__(self, drive: RockerCrank, kind: Kind) -> None:
        self.drive, self.kind = drive, kind
        self.arcs = [drive.dead_centre(stroke, kind) for stroke in STROKES]
        self.length = drive.arc_stroke(kind)
        self._dead_angles = [drive.dead_angle(stroke, kind) / 180 for stroke in STROKES]
        self._last: tuple[int, Any, Place[Any]] | None = None

    def dead_centre(self, stroke: int) -> Number:
        return self._dead_angles[stroke]

    def path(self, stroke: int, circle: Circle[Any]) -> Number:
        arc = self.arcs[stroke]
        turned = 2 * self.kind.arc(linkage.path_half_sine(self._place(stroke, circle), arc))
        return turned * self.kind.pi / 180 / arc.curvature

    def velocity(self, stroke: int, circle: Circle[Any]) -> Number:
        return self._place(stroke, circle).velocity

    def acceleration(self, stroke: int, circle: Circle[Any]) -> Number:
        return linkage.acceleration(self._place(stroke, circle), self.arcs[stroke])

    def loaded(
        self,
        stroke: int,
        circle: Circle[Any],
        masses: Masses[Any],
        net: Number,
        reciprocating: Number = 0,
        weight: Weight[Any] | None = None,
        friction: Number | None = None,
    ) -> LoadedRocker:
        # Refused where they are given: what a rocker weighs is not known.
        assert weight is None
        assert friction is None
        place = self._place(stroke, circle)
        return self.drive.under(circle, place, self.arcs[stroke], masses, net, reciprocating)

    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return rocker.kinetic_energy(self._place(stroke, circle), masses)

    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return rocker.torque_slope(self._place(stroke, circle), self.arcs[stroke], masses)

    def _place(self, stroke: int, circle: Circle[Any]) -> Place[Any]:
        """Return where the rocker's end stands; a turn asks several things of one angle."""
        if self._last is None or self._last[0] != stroke or self._last[1] is not circle:
            arc = self.arcs[stroke]
            self._last = (stroke, circle, linkage.place(linkage.from_dead_centre(circle, arc), arc))
        return self._last[2]
