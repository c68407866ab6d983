"""The pressures on a piston on any kind of number: of steam or gas, and what accelerates the masses.

Pressures are in bar, positive in the direction of the stroke; a stroke counts from the dead centre where it
begins. The masses m that go to and fro with the acceleration p take the pressure q = m p/A of the piston's
area A from that of the gas, and give it back where p is negative. Source: Weisbach-Herrmann, § 151
(Beschleunigungsdruck; the seed ends there, hence re-derived).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank, known
from kurbel.drive.moved import Drive, Moved
from kurbel.engine.engine import Diagram, Engine
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.reading.notation import about

PASCALS = 10**5


class Where(NamedTuple):
    """A place on a stroke of the cycle: the share of it that the piston has gone, or its crank angle φ in
    half turns, less those of the strokes before."""

    stroke: int
    share: Fraction | None = None
    angle: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Pressed:
    """A crank drive with its bore in metres, with moving masses or under the load of an engine, or both."""

    drive: Drive
    bore: Fraction | None = None
    engine: Engine | None = None

    def __post_init__(self) -> None:
        if self.engine is None and not self.heavy:
            raise ProblemError(
                "neither masses nor a pressure on the piston were given; add --reciprocating 300kg, or what"
                " drives the piston, such as --eps 4"
            )
        if not self.pushed and not self.heavy:
            raise ProblemError(
                "the pressure on the piston is not known in bar; add --bore and --pressure, or masses,"
                " --reciprocating 300kg"
            )
        if self.bore is not None and self.bore <= 0:
            raise ProblemError(f"the bore is {about(self.bore)} m; it must be above 0")

    @property
    def crank(self) -> Crank:
        return self.drive.crank

    @property
    def heavy(self) -> bool:
        """Whether masses go to and fro that are known."""
        return self.crank.moving is not None and self.bore is not None

    @property
    def pushed(self) -> bool:
        """Whether a pressure on the piston is known."""
        return self.engine is not None and self.engine.pressure is not None

    @property
    def mass(self) -> Fraction:
        """What goes to and fro in kg, the rod's share at its crosshead pin with it."""
        return Fraction(known(self.crank.moving).joined.crosshead)

    @property
    def cycle(self) -> int:
        """The strokes after which everything comes again."""
        from kurbel.exact.kind import floats

        engine = self.engine
        return 2 if engine is None else len(engine.steam.strokes(floats(), engine.double))

    def standing(self, half_turns: Fraction) -> Where:
        """Return where the crank stands at so many half turns of φ."""
        from kurbel.exact.kind import floats

        moved = self.drive.moved(floats(), "exact")
        since = half_turns % self.cycle
        for stroke in range(self.cycle, -1, -1):
            begun = stroke + (
                Fraction(0) if moved.regular else Fraction(float(moved.dead_centre(stroke % 2)))
            )
            if since >= begun:
                return Where(stroke % self.cycle, angle=since - stroke)
        # Before the first dead centre the last stroke is not over.
        return Where(self.cycle - 1, angle=since + 1)

    def share(self, where: Where, kind: Kind) -> Any:
        """Return the share of the stroke that the piston has gone."""
        if where.share is not None:
            return kind.of(where.share)
        moved = self.drive.moved(kind, "exact")
        return moved.path(where.stroke % 2, self._circle(moved, where, kind)) / moved.length

    def gas(self, where: Where, kind: Kind) -> Any:
        """Return the pressure on the piston's face less that on the other, in bar."""
        engine = known(self.engine)
        acting = engine.steam.strokes(kind, engine.double)[where.stroke]
        return acting.force(self.share(where, kind)) * kind.of(Fraction(known(engine.pressure)) / PASCALS)

    def masses(self, where: Where, kind: Kind) -> Any:
        """Return q = m p/A in bar."""
        moved, bore = self.drive.moved(kind, "exact"), known(self.bore)
        accelerated = moved.acceleration(where.stroke % 2, self._circle(moved, where, kind))
        per_area = kind.of(4 * self.mass / (bore * bore * PASCALS)) / kind.pi
        return accelerated * per_area * self.crank.pin_acceleration(kind)

    def left(self, where: Where, kind: Kind) -> Any:
        """Return what of the pressure the masses pass on, p - q."""
        return self.gas(where, kind) - self.masses(where, kind)

    def degrees(self, where: Where, kind: Kind) -> Any:
        """Return φ in degrees, over both strokes and all turns of the cycle."""
        moved = self.drive.moved(kind, "exact")
        return 180 * (self._angle(moved, where, kind) + where.stroke)

    def _circle(self, moved: Moved, where: Where, kind: Kind) -> Any:
        if where.angle is not None:
            degrees = 180 * where.angle
            return kind.circle(float(degrees) if kind.of is float else degrees)
        from kurbel.exact.certify import half_turn_circle

        return half_turn_circle(self._angle(moved, where, kind))

    def _angle(self, moved: Moved, where: Where, kind: Kind) -> Any:
        """Return the half turns of φ, less those of the strokes before."""
        if where.angle is not None:
            return kind.of(where.angle)
        way, share = where.stroke % 2, known(where.share)
        if share == 0:
            return kind.of(Fraction(0)) + moved.dead_centre(way)
        if share == 1:
            return kind.of(Fraction(1)) + moved.dead_centre(1 - way)
        found = moved.angle_at(way, kind.of(share))
        return _searched(moved, way, kind.of(share)) if found is None else found


def _searched(moved: Moved, way: int, share: Any) -> Any:
    """Return the half turns at which the piston has gone the share, enclosed by interval Newton."""
    from flint import arb

    from kurbel.exact.certify import half_turn_circle
    from kurbel.exact.search import Zero

    def lacking(angle: Any) -> Any:
        return moved.path(way, half_turn_circle(angle)) / moved.length - share

    def speed(angle: Any) -> Any:
        return moved.velocity(way, half_turn_circle(angle)) / moved.length * arb.pi()

    begin, end = Fraction(float(moved.dead_centre(way))), Fraction(float(moved.dead_centre(1 - way)))
    return Zero(lacking, speed, begin, 1 + end).place()


def is_carded(pressed: Pressed) -> bool:
    """Whether the pressure comes from an indicator card."""
    return pressed.engine is not None and isinstance(pressed.engine.steam, Diagram)
