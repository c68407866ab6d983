"""The slotted lever: where crank pin, lever and ram are, and what a force on the ram does, by statics."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.verify.drives import FORCES, OF_DRIVE, Drive, PinForces
from kurbel.verify.jets import Jet, direction, slope_of_angle
from kurbel.verify.numbers import Number, arccosine, degrees_of, heading, largest, number
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow, circle_meets_level
from kurbel.verify.zeros import Place


@dataclass(frozen=True, kw_only=True)
class SlottedLever(Drive):
    """Lengths in crank radii: the pivot below the shaft, the arm of the lever, the rod of the ram, None of an
    infinite one, the ram's line so high above the pivot, and on which side of the lever the ram is."""

    pivot_below: Fraction
    arm: Fraction
    ram_rod: Fraction | None = None
    height: Fraction = Fraction(0)

    @property
    def foot(self) -> Arrow:
        return Arrow(number(0), number(-self.pivot_below))

    def ram(self, end: Arrow) -> Arrow:
        """Where the ram is, by the end of the lever's arm: ahead of it towards smaller x, or behind it."""
        if self.ram_rod is None:
            return end
        mirrored = Arrow(end.x * -self.circuit, end.y)
        found = circle_meets_level(mirrored, number(self.ram_rod), self.foot.y + number(self.height))
        return Arrow(found.x * -self.circuit, found.y)

    def dead_arm(self, stroke: int) -> Arrow:
        """The direction of the lever where a stroke begins: on the outstroke the ram is there at greatest x.

        A lever that swings is square to the crank there, one that is carried round in line with the rod.
        """
        if self.pivot_below > 1:
            sine = 1 / number(self.pivot_below)
            return Arrow(sine * stroke, (1 - sine * sine).root())
        if self.ram_rod is None:
            return Arrow(number(stroke), number(0))
        ahead = self.circuit == -stroke
        reach = number(self.ram_rod) + number(self.arm) * (1 if ahead else -1)
        level = number(self.height) / reach
        along = (1 - level * level).root()
        # The rod points to where the ram is from the lever; folded, the lever points the other way.
        side = -self.circuit
        return Arrow(along * side, level) if ahead else Arrow(along * -side, -level)

    def dead_pin(self, stroke: int) -> Arrow:
        """Where the crank pin is there, on the lever's line and the crank's circle."""
        arm, foot = self.dead_arm(stroke), self.foot
        nearest = -arm.dot(foot)
        if self.pivot_below > 1:
            return foot.plus(arm.times(nearest))
        return foot.plus(arm.times(nearest + (1 - (foot.square() - nearest * nearest)).root()))

    def dead_degrees(self, stroke: int) -> Number:
        pin = self.dead_pin(stroke)
        return degrees_of(*pin) if stroke == OUT else heading(*pin)

    def end(self, lever: Arrow) -> Arrow:
        """Where the arm's end is, by the direction of the lever."""
        return self.foot.plus(lever.times(number(self.arm)))

    def driven(self, pin: Arrow) -> Arrow:
        along = pin.minus(self.foot)
        return self.ram(self.end(along.times(1 / along.size())))

    def dead(self, stroke: int) -> Arrow:
        return self.ram(self.end(self.dead_arm(stroke)))

    @property
    def stroke(self) -> Number:
        return self.dead(OUT).x - self.dead(RETURN).x

    @property
    def swing(self) -> Number:
        if self.pivot_below < 1:
            return number(360)
        return 2 * abs(degrees_of(*reversed(self.dead_arm(OUT))))

    def course(
        self, name: str, place: Place, stroke: int, method: str, order: int, more: int
    ) -> Jet | Number:
        if method != "exact":
            raise ProblemError("a slotted lever is verified by exact formulas alone")
        if name in OF_DRIVE:
            return OF_DRIVE[name](self)
        if name in FORCES:
            return self.held(place, stroke, method, more).force(name)
        if name in ("path", "velocity", "acceleration"):
            return self.moving(name, place, stroke, more)
        pin = self.pin(place.degrees, 2 + more, place.reach)
        along = pin.minus(self.foot)
        reach, turning = along.size(), slope_of_angle(*along)
        # Against the sense of the crank, as a crank's rod on its outstroke.
        end = self.end(along.times(1 / reach))
        swung = -slope_of_angle(*end.minus(self.ram(end))) if self.ram_rod else 0 * turning
        known: dict[str, Callable[[], Jet]] = {
            "rod_velocity": lambda: swung,
            "rod_acceleration": swung.derived,
            "lever": lambda: direction(along.y, -along.x),
            "lever_velocity": lambda: turning,
            "lever_acceleration": turning.derived,
            "block_velocity": reach.derived,
            # The pin's acceleration square to the lever is that of the lever there, and that of Coriolis.
            "coriolis": lambda: along.cross(pin.derived().derived()) / reach - reach * turning.derived(),
        }
        return known[name]()

    def held(self, place: Place, stroke: int, method: str, more: int) -> PinForces:
        """What a force of 1 on the ram in the direction of the stroke does, by statics.

        The lever turns freely about its pivot: what the rod does there the block takes, square to the lever.
        """
        pin = self.pin(place.degrees, more, place.reach)
        along = pin.minus(self.foot)
        reach, push = along.size(), number(-stroke)
        end = self.end(along.times(1 / reach))
        ram = self.ram(end)
        # Of what acts on the ram nothing is left: the guide holds what the rod does across the slide.
        rise = 0 * pin.x if self.ram_rod is None else (end.y - ram.y) / (end.x - ram.x) * push
        on_end = Arrow(0 * pin.x + push, rise)
        block = end.minus(self.foot).cross(on_end) / reach
        on_pin = Arrow(-along.y, along.x).times(block / reach)
        # With the lever upright a push on the block in the direction of the stroke.
        return PinForces(pin, on_pin, on_end.size(), rise, block * stroke)

    @property
    def transmission(self) -> Number:
        """The rod leans most where the arm's end is highest or lowest: upright, or at an end of its swing."""
        if self.ram_rod is None:
            return number(90)
        turned = self.dead_arm(OUT).y if self.pivot_below > 1 else number(-1)
        leans = [abs(number(self.height) - number(self.arm) * one) for one in (number(1), turned)]
        return arccosine(largest(leans) / number(self.ram_rod))
