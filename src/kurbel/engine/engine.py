"""The engine that a table is about, checked once: a crank drive under a load, or several on one shaft.

A rod lessens the area of its side: that of the crank, a tail rod that of the cover. Friction is against the
motion on every stroke. Forces are in units of Q, that of the pressure on the area of the bore.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.drive.at import Weights, known
from kurbel.drive.crank import Crank
from kurbel.drive.load import CARD
from kurbel.drive.load import Load as Acting
from kurbel.drive.moved import Drive
from kurbel.engine.loads.ideal import LEAST_WORK, Steam
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Numeric
from kurbel.kernel.law import Stroke
from kurbel.reading.notation import about, check_bounds

if TYPE_CHECKING:
    from kurbel.engine.card.card import Diagram

# Nearer to 1 the piston of the exact motion stands still but for an instant.
LARGEST_RATIO = 1 - Fraction(1, 10**12)
MOST_CRANKS = 24
HIGHEST = 10**12


@dataclass(frozen=True, slots=True)
class Load:
    """What makes newtons of Q: the bore in metres and the steam pressure before cut-off in pascals. An
    indicator card has its pressures itself.
    """

    bore: Fraction
    pressure: Fraction | None = None

    def __post_init__(self) -> None:
        check_bounds("the bore", self.bore, "be above 0", " m")
        check_bounds("the pressure", self.pressure, "be above 0 and at most 10^12 Pa", " Pa")


@dataclass(frozen=True, slots=True)
class Engine:
    """A crank drive under a load on its piston, double-acting or not, on one crank or several.

    `cranks` are the angles in degrees by which each crank follows the first; all have cylinders alike. A
    double-acting cylinder works on both strokes; of another the load says what its return stroke does. `lag`
    are the degrees by which the first crank follows that of an engine which this one is a part of.
    """

    drive: Drive
    steam: Acting
    double: bool = True
    cranks: tuple[Fraction, ...] = (Fraction(0),)
    load: Load | None = None
    lag: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if (measured := self.diagram) is not None:
            object.__setattr__(self, "steam", measured.on(self.drive))
        self._check_load()
        if self.crank.ratio > LARGEST_RATIO:
            raise ProblemError("crank ratio R:L is nearer to 1 than 10^-12; no engine is built so")
        check_count(len(self.cranks))
        if self.crank.effort is not None:
            self._check_effort()
        if self.cranks[0] != 0:
            raise ProblemError(
                f"the first crank is at {about(self.cranks[0])}°; angles count from the first crank,"
                " write them as '0;90'"
            )

    @property
    def crank(self) -> Crank:
        """What is known of the crank."""
        return self.drive.crank

    @property
    def parts(self) -> tuple[Engine, ...]:
        """The engines whose cylinders are alike."""
        return (self,)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """The half turns by which the cranks follow the first of the whole engine."""
        return tuple((self.lag + crank) / 180 for crank in self.cranks)

    def at_speed(self, factor: Fraction) -> Engine:
        """Return the engine at so many times its speed, that of its masses."""
        crank = self.crank
        speed = known(crank.speed)
        faster = replace(crank, speed=replace(speed, value=speed.value * factor))
        return replace(self, drive=self.drive.of(faster))

    @property
    def pressure(self) -> Fraction | None:
        """The pressure in Pa that Q is of, None where it is not known."""
        if (measured := self.diagram) is not None:
            return Fraction(measured.pressure)
        return None if self.load is None else self.load.pressure

    def strokes(self, kind: Kind) -> Sequence[Stroke]:
        """Return the strokes of the load on the piston as it is, with its rods and its friction."""
        strokes, effort = self.steam.strokes(kind, self.double), self.crank.effort
        if effort is None:
            return strokes
        friction, sides = self.friction(kind), None
        if effort.areas is not None:
            sides = kind.of(effort.areas.head), kind.of(effort.areas.crank)
        # What is behind the piston on the outstroke is before it on the return.
        return tuple(
            one._replace(areas=sides if number % 2 == 0 or sides is None else sides[::-1], friction=friction)
            for number, one in enumerate(strokes)
        )

    def friction(self, kind: Kind) -> Numeric | None:
        """Return the friction of piston and crosshead in Q, None where there is none."""
        if not self.crank.has_friction:
            return None
        force = known(self.crank.effort).friction
        return kind.of(4 * force / (known(self.load).bore ** 2 * known(self.pressure))) / kind.pi

    def weights(self, kind: Kind) -> Weights | None:
        """Return the masses in units of Q/(R ω²), in a kind of number."""
        crank, pressure = self.crank, self.pressure
        if crank.moving is None or pressure is None:
            return None
        speed, square = known(crank.speed), known(self.load).bore ** 2
        # Q = π/4 d² p; ω has the factor 2π where it counts turns.
        scale = 4 * known(crank.radius) * speed.value**2 / (square * pressure)
        turned = kind.of(4 * scale) * kind.pi if speed.turns else kind.of(scale) / kind.pi
        newton: Numeric = 1
        if crank.moving.slope is not None:
            newton = kind.of(4 / (square * pressure)) / kind.pi
        return crank.moving.weights(kind, turned, newton)

    def _check_load(self) -> None:
        if self.load is None:
            if self.crank.moving is not None:
                raise ProblemError(
                    "masses need the bore to be weighed against the steam; add it, for example --bore 300mm"
                )
        elif self.carded and self.load.pressure is not None:
            raise ProblemError("the indicator card has its own pressures; leave the steam pressure out")
        elif not self.carded and self.load.pressure is None:
            raise ProblemError("the bore makes newtons of the steam only with its pressure; add that")

    def _check_effort(self) -> None:
        """Raise ProblemError for rods or friction that the engine cannot have."""
        effort = known(self.crank.effort)
        if effort.friction and (self.load is None or self.pressure is None):
            raise ProblemError(
                "friction needs the bore and the pressure to be weighed against the load; add these, for"
                " example --bore 300mm --pressure 8bar"
            )
        if effort.areas is not None and (self.steam.name not in ("steam", "card") or not self.double):
            raise ProblemError(
                "--piston-rod and --tail-rod are for double-acting cylinders under steam or an indicator"
                " card; leave them out"
            )
        rubbed = self.strokes(floats())
        left = sum(float(one.work(1.0)) for one in rubbed)
        work = sum(float(one._replace(friction=None).work(1.0)) for one in rubbed)
        if work > 0 and left < LEAST_WORK:
            raise ProblemError(
                f"the friction of {float(effort.friction):g} N takes all that the load gives; no engine runs"
                " so"
            )

    @property
    def carded(self) -> bool:
        """Whether the piston force comes from an indicator card."""
        return self.steam.name == CARD

    @property
    def diagram(self) -> Diagram | None:
        """That card, None where there is none."""
        if not self.carded:
            return None
        from kurbel.engine.card.card import Diagram

        assert isinstance(self.steam, Diagram)
        return self.steam

    @property
    def ideal(self) -> Steam:
        """The steam of an engine that has no indicator card."""
        assert isinstance(self.steam, Steam)
        return self.steam

    @property
    def plain(self) -> bool:
        """Whether it has one crank and is double-acting, as the book's."""
        return self.double and len(self.cranks) == 1


def check_count(cranks: int) -> None:
    """Raise ProblemError unless an engine can have so many cranks."""
    if not 1 <= cranks <= MOST_CRANKS:
        raise ProblemError(f"the engine has {cranks} cranks; 1 to {MOST_CRANKS} are allowed")


@dataclass(frozen=True, slots=True)
class Assembly:
    """An engine made of parts, each of cylinders that are alike; a part follows the first by its `lag`.

    Forces are in the first part's Q, lengths in its R. All have a bore, a pressure and a stroke, by which
    their forces and torques compare, and one speed if they have masses. Valid for a first part without lag.
    """

    parts: tuple[Engine, ...]

    def __post_init__(self) -> None:
        if not self.parts:
            raise ProblemError("no cylinder was given; an engine has one or more")
        check_count(len(self.cranks))
        if self.parts[0].lag:
            raise ProblemError("the first cylinder's crank is at 0°; angles count from it")
        if len(self.parts) == 1:
            return
        for number, part in enumerate(self.parts, 1):
            if part.pressure is None or part.load is None or part.crank.radius is None:
                raise ProblemError(
                    f"cylinder {number} needs its bore, its pressure and its stroke to be compared with the"
                    " others"
                )
        speeds = {part.crank.speed for part in self.parts if part.crank.moving is not None}
        if len(speeds) > 1:
            raise ProblemError("the cylinders have masses at unlike speeds; one shaft has one speed")

    def at_speed(self, factor: Fraction) -> Assembly:
        """Return the engine at so many times its speed, that of its masses."""
        parts = (part if part.crank.moving is None else part.at_speed(factor) for part in self.parts)
        return Assembly(tuple(parts))

    @property
    def crank(self) -> Crank:
        """That of the first part, whose Q and R are the units."""
        return self.parts[0].crank

    @property
    def cranks(self) -> tuple[Fraction, ...]:
        """The angles in degrees by which all cranks follow the first."""
        return tuple(180 * start for part in self.parts for start in part.starts)

    @property
    def carded(self) -> bool:
        """Whether any piston force comes from an indicator card."""
        return any(part.carded for part in self.parts)

    @property
    def plain(self) -> bool:
        return len(self.parts) == 1 and self.parts[0].plain
