"""What the load of an engine does to a piston with rods and friction, as strokes like those of the load.

A rod lessens the area of its side: that of the crank, a tail rod that of the cover. Friction is against the
motion on every stroke. Forces are in units of Q, that of the pressure on the area of the bore.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import known
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Number
from kurbel.kernel.turning import Stroke

if TYPE_CHECKING:
    from kurbel.engine.engine import Engine

# Below this share of Q nothing is left of a load that works.
LEAST_WORK = 1e-9


class Scaled(NamedTuple):
    """A stroke on a share of the area, with a force that does not change; a `share` of None is the whole."""

    stroke: Any
    area: Number | None
    push: Number

    @property
    def corners(self) -> Sequence[Number]:
        found: Sequence[Number] = self.stroke.corners
        return found

    def force(self, share: Number) -> Number:
        return self._scaled(self.stroke.force(share)) + self.push

    def work(self, share: Number) -> Number:
        return self._scaled(self.stroke.work(share)) + self.push * share

    def slope(self, share: Number) -> Number:
        return self._scaled(self.stroke.slope(share))

    def _scaled(self, value: Number) -> Number:
        return value if self.area is None else self.area * value


def rubbed(engine: Engine, kind: Kind) -> Sequence[Stroke]:
    """Return the strokes with the rods' areas and with friction."""
    found, friction = pressed(engine, kind), friction_of(engine, kind)
    return found if friction is None else tuple(Scaled(one, None, -friction) for one in found)


def pressed(engine: Engine, kind: Kind) -> Sequence[Stroke]:
    """Return the strokes with the rods' areas alone."""
    strokes, areas = engine.steam.strokes(kind, engine.double), known(engine.crank.effort).areas
    if areas is None or areas.head == areas.crank == 1:
        return strokes
    if engine.carded:
        from kurbel.engine.card.force import on_areas

        cards: Sequence[Any] = strokes
        return tuple(
            on_areas(one, float(behind), float(before))
            for one, (behind, before) in zip(cards, _sides(areas), strict=True)
        )
    # Steam presses on the side behind the piston, the back pressure on the other.
    back = engine.ideal.numbers(kind.of, kind.exponent).back
    return tuple(
        Scaled(one, kind.of(behind), back * kind.of(behind - before))
        for one, (behind, before) in zip(strokes, _sides(areas), strict=True)
    )


def _sides(areas: Any) -> tuple[tuple[Fraction, Fraction], tuple[Fraction, Fraction]]:
    """The areas behind the piston and before it, on the outstroke and on the return."""
    return (areas.head, areas.crank), (areas.crank, areas.head)


def friction_of(engine: Engine, kind: Kind) -> Number | None:
    """Return the friction in Q, None where there is none."""
    if not engine.crank.rubbed:
        return None
    assert engine.load is not None
    assert engine.pressure is not None
    force = known(engine.crank.effort).friction
    return kind.of(4 * force / (engine.load.bore**2 * engine.pressure)) / kind.pi


def check(engine: Engine) -> None:
    """Raise ProblemError for rods or friction that the engine cannot have."""
    effort = known(engine.crank.effort)
    if effort.friction and (engine.load is None or engine.pressure is None):
        raise ProblemError(
            "friction needs the bore and the pressure to be weighed against the load; add these, for example"
            " --bore 300mm --pressure 8bar"
        )
    if effort.areas is not None and (engine.steam.name not in ("steam", "card") or not engine.double):
        raise ProblemError(
            "--piston-rod and --tail-rod are for double-acting cylinders under steam or an indicator card;"
            " leave them out"
        )
    work, left = (
        sum(float(one.work(1.0)) for one in strokes(engine, floats())) for strokes in (pressed, rubbed)
    )
    if work > 0 and left < LEAST_WORK:
        raise ProblemError(
            f"the friction of {float(effort.friction):g} N takes all that the load gives; no engine runs so"
        )
