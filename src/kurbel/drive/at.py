"""A place of any crank drive, on any kind of number: how the crank turns, what acts there, and its forces.

They are of a crank angle, in the frame of its stroke; kernel/forces.py and kernel/rod.py say the signs.

Friction has the direction of the stroke that the piston is in; at a dead centre, of that which begins there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from operator import attrgetter, methodcaller
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls
from kurbel.kernel import forces, kinematics
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.kernel.forces import Weight, on_return
from kurbel.kernel.forces import net_torque as pin_torque
from kurbel.kernel.moving import Accelerations, Masses, with_crank
from kurbel.kernel.rod import LoadedCrank
from kurbel.reading.given import as_angular_acceleration

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.reading.units import Speed


Part = TypeVar("Part")


def known(part: Part | None) -> Part:
    """Return what must be known where it is asked for."""
    assert part is not None
    return part


def framed(weight: Weight[Numeric] | None, stroke: int) -> Weight[Numeric] | None:
    """Return weights in the frame of the stroke."""
    return on_return(weight) if stroke and weight is not None else weight


# The angles within ±90° of a rational number of degrees that have a rational sine (Niven).
_RATIONAL: Mapping[object, Fraction] = {
    Fraction(0): Fraction(0),
    Fraction(1, 2): Fraction(30),
    Fraction(-1, 2): Fraction(-30),
}


def angular_velocity(crank: Crank, numbers: Kind) -> Numeric:
    """Return ω in rad/s."""
    speed = known(crank.speed)
    omega = numbers.of(2 * speed.value if speed.turns else speed.value)
    return omega * numbers.pi if speed.turns else omega


def rubbing(pin: str, crank: Crank, numbers: Kind) -> Numeric:
    """Return in m/s how fast the surface of a pin rubs in what turns with ω in it: d/2 ω."""
    diameter: Fraction = known(getattr(known(crank.diameters), pin))
    return angular_velocity(crank, numbers) * numbers.of(diameter / 2)


def turns_a_minute(crank: Crank, numbers: Kind) -> Numeric:
    """Return n in 1/min."""
    speed = known(crank.speed)
    return numbers.of(60 * speed.value) if speed.turns else numbers.of(30 * speed.value) / numbers.pi


def angular_square(crank: Crank, numbers: Kind) -> Numeric:
    """Return ω² in 1/s²."""
    omega = angular_velocity(crank, numbers)
    return omega * omega


def gain(crank: Crank, numbers: Kind) -> Numeric:
    """Return α/ω²: so much of a velocity adds to an acceleration, in units of the even crank's."""
    return numbers.of(crank.acceleration) / angular_square(crank, numbers)


def begun(crank: Crank, stroke: int) -> Fraction | None:
    """Return the dead centre where a stroke begins as `Crank.dead_angle` does, exactly; None if it is
    irrational."""
    return _RATIONAL.get(kinematics.dead_centre_sine(stroke * crank.ratio, stroke * crank.offset))


def turned(crank: Crank, stroke: int, degrees: Numeric, numbers: Kind) -> Numeric:
    """Return by how much of a turn the crank, at φ of the stroke in degrees, is beyond where that begins."""
    exact = begun(crank, stroke)
    first = crank.dead_angle(stroke, numbers) if exact is None else numbers.of(exact)
    return (degrees - first) / 360


def turn_time(crank: Crank, numbers: Kind) -> Numeric:
    """Return the time of an even turn in seconds."""
    speed = known(crank.speed)
    time = numbers.of((1 if speed.turns else 2) / speed.value)
    return time if speed.turns else time * numbers.pi


def acceleration_of(given: object, speed: Speed | None) -> Fraction:
    """Return α in rad/s². Raises ProblemError without a speed."""
    if speed is None:
        raise ProblemError(
            "--acceleration is that of the crank at the speed it has; add that, for example --speed 120/min"
        )
    return as_angular_acceleration(given, "acceleration")


class Weights(NamedTuple):
    """The moving masses of a cylinder in units of Q/(R ω²), in a kind of number.

    `masses` are those of rod and reciprocating parts together, `rotating` the crank's own at its pin.
    What they weigh, in Q and in the frame of the outstroke, is None where that does not count.
    """

    masses: Masses[Numeric]
    reciprocating: Numeric
    rotating: Numeric
    weight: Weight[Numeric] | None = None

    @property
    def still(self) -> Weights | None:
        """The same without inertia, None if nothing is left."""
        if self.weight is None:
            return None
        nothing = 0 * self.masses.pin
        return Weights(Masses(nothing, nothing, nothing, nothing), nothing, nothing, self.weight)

    @property
    def on_shaft(self) -> Masses[Numeric]:
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

    bare: Callable[[Circle[Numeric], Numeric, Numeric | None], Numeric]
    on: Callable[[LoadedCrank], Numeric]
    framed: bool = False
    magnitude: bool = False
    on_shaft: bool = False


def _unit(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
    return 1


def _none(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
    return 0


def _across(drive: LoadedCrank) -> Numeric:
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


FIRST_BITS = 64
RETURN = -1


@dataclass(eq=False)
class At:
    """A place of a drive, which a kernel call takes: the circle of its crank angle, the kind of number, the
    stroke, OUT (1) or RETURN (-1).

    Of the straight or offset crank λ and e/R (None without an offset) with the sign of the stroke; whether
    what is accelerated is so to first order; whether the piston moves in the direction of the stroke, if that
    is known for certain. Of other drives where the driven end stands, and the dead centre of one on an arc.
    """

    circle: Circle[Numeric]
    drive: Any
    numbers: Kind
    stroke: int = 1
    ratio: Any = None
    offset: Any = None
    first_order: bool = False
    way: int | None = None
    degrees: Any = None
    place: Any = None
    arc: Any = None

    @property
    def crank(self) -> Crank:
        found: Crank = self.drive.crank
        return found

    @cached_property
    def gain(self) -> Numeric | None:
        """α/ω² of a crank that is itself accelerated, else None."""
        return gain(self.crank, self.numbers) if self.crank.acceleration else None

    @cached_property
    def by(self) -> Accelerations[Numeric]:
        """How the masses are accelerated."""
        return Accelerations(self.gain, self.first_order)

    @cached_property
    def loaded(self) -> LoadedCrank:
        """The drive with its masses under the force at this place, in newtons."""
        return self._under_force(self._weights.masses, self._weights.reciprocating)

    @cached_property
    def on_shaft(self) -> LoadedCrank:
        """The same with the masses of which the force at the pin is that of the main bearing."""
        return self._under_force(self._weights.on_shaft, 0)

    @cached_property
    def _weights(self) -> Weights:
        moving = self.crank.moving
        if moving is None:
            return NOTHING
        return moving.weights(self.numbers, self.crank.pin_acceleration(self.numbers))

    def bearing(self, masses: Masses[Numeric]) -> LoadedCrank:
        """Return the drive with these masses alone, in any unit of them."""
        if self.arc is not None:
            return self._on_arc(masses, 0, 0)
        return LoadedCrank(self.circle, self.ratio, masses, self.offset, by=self.by)

    def _on_arc(self, masses: Masses[Numeric], net: Numeric, reciprocating: Numeric) -> LoadedCrank:
        under: Callable[..., LoadedCrank] = self.drive.under
        return under(self.circle, self.place, self.arc, masses, net, reciprocating)

    def _under_force(self, masses: Masses[Numeric], reciprocating: Numeric) -> LoadedCrank:
        crank = self.crank
        net = self.acting(self.numbers.of(crank.force.first if crank.force else Fraction(0)))
        if self.arc is not None:
            return self._on_arc(masses, net, reciprocating)
        drive, friction = (self.circle, self.ratio, masses, self.offset), None
        if crank.effort is not None:
            net, friction = net + self.pressed(), self.rubbing()
        own = framed(self._weights.weight, self.stroke == RETURN)
        return LoadedCrank(*drive, net, reciprocating, self.by, weight=own, friction=friction)

    @property
    def share(self) -> Numeric:
        """The share of the stroke that the piston has gone."""
        path = kinematics.piston_path(self.circle, self.ratio, self.offset)
        return path / (2 if self.offset is None else kinematics.stroke(self.ratio, self.offset))

    def acting(self, force: Numeric) -> Numeric:
        """Return what the first piston force calls up, as the force at this place does."""
        factor = self.crank.force.relative(self) if self.crank.force else None
        return force if factor is None else force * factor

    def pressed(self) -> Numeric:
        """Return the force of the pressures in newtons, in the direction of the stroke, 0 without them."""
        effort = self.crank.effort
        # On the return stroke the cover lies the other way.
        return self.stroke * effort.pressures.force(self.numbers) if effort and effort.pressures else 0

    def rubbing(self) -> Numeric | None:
        """Return the friction in newtons, in the direction of the stroke, None where there is none."""
        effort = self.crank.effort
        if effort is None or not effort.friction:
            return None
        return self.numbers.of(effort.friction) * (self._way() if self.way is None else self.way) * -1

    def _way(self) -> Numeric:
        """Return 1 where the piston moves in the direction of the stroke, -1 where against it, of any kind of
        number: a float in a dead centre goes where it is drawn to, a ball about one holds both."""
        velocity: Any = forces.tangential_force(self.circle, self.ratio, self.offset)
        if hasattr(velocity, "union"):
            if hasattr(velocity, "rad") and not velocity.contains(0):
                return 1 if velocity > 0 else -1
            both: Numeric = (0 * velocity - 1).union(0 * velocity + 1)
            return both
        import numpy as np

        drawn: Any = self.by.piston(self.circle, self.ratio, self.offset)
        towards = np.where(velocity == 0, drawn, velocity)
        return np.where(towards < 0, -1.0, 1.0)

    def shaft_torque(self) -> Numeric:
        """Return what accelerates the shaft, M - P/ω over R, in newtons; M less the friction of pins that
        have some."""
        crank, effort = self.crank, known(self.crank.effort)
        torque = self.loaded.torque() if effort.pins is None else self.net_torque()
        if not (power := known(effort.shaft).power):
            return torque
        return torque - self.numbers.of(power / known(crank.radius)) / known(crank.speed).omega(self.numbers)

    def reverses(self) -> Numeric:
        """Return what is above 0 where inertia opposes all other forces at the crosshead pin, in N²."""
        inertia = self.loaded.inertia_force()
        return inertia * (inertia - self.loaded.thrust())

    def reversal(self) -> Numeric:
        """Return the speed at which the load on the crosshead pin reverses here, in that of the crank.

        √((F_m - F_B)/F_m): of all that acts along the slide the inertia force alone grows, with ω².
        """
        return root(self.reverses()) / abs(self.loaded.inertia_force())

    def net_torque(self) -> Numeric:
        """Return the torque on the shaft less what the friction of the pins takes, over R, in newtons."""
        crank = self.crank
        pins, radius = known(known(crank.effort).pins), known(crank.radius)
        circle, ratio, offset, thrust = self.circle, self.ratio, self.offset, self.loaded.thrust()
        if self.stroke == RETURN:
            # The circles of friction are those of the whole turn.
            circle = Circle(-1 * circle.sine, -1 * circle.cosine, 2 - circle.versine)
            ratio, thrust, offset = -1 * ratio, -1 * thrust, None if offset is None else -1 * offset
        return pin_torque(circle, ratio, offset, thrust, pins.circles(self.numbers, radius))


def way_at(crank: Crank, stroke: int, angle: Fraction) -> int:
    """Return whether the piston moves in the direction of a stroke, 1, or against it, -1, at an angle that
    counts from where the stroke begins."""
    if not crank.offset:
        return 1 if angle % 360 < 180 else -1

    def velocity(kind: Kind) -> Numeric:
        return kinematics.piston_velocity(kind.circle(angle), *_numbers(crank, stroke, kind))

    def acceleration(kind: Kind) -> Numeric:
        return kinematics.piston_acceleration(kind.circle(angle), *_numbers(crank, stroke, kind))

    return sign_of(velocity) or sign_of(acceleration)


def sign_of(value: Callable[[Kind], Numeric]) -> int:
    """Return 1, 0 or -1, the sign of a number on any kind, by proof."""
    from kurbel.exact.certify import at_bits, ball
    from kurbel.exact.terms import vanishes

    if vanishes(value):
        return 0
    bits = FIRST_BITS
    while True:
        with at_bits(bits):
            found = ball(value(balls()))
        if not found.contains(0):
            return 1 if found > 0 else -1
        bits *= 2


def _numbers(crank: Crank, stroke: int, kind: Kind) -> tuple[Numeric, Numeric]:
    return kind.of(stroke * crank.ratio), kind.of(stroke * crank.offset)
