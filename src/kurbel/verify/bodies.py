"""Piston, rod and rocker as rigid bodies: their forces by Newton and Euler, as linear equations in SI units.

What moves is the drive of `drives`; accelerations are the slopes of its places.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import Any

from kurbel.errors import ProblemError
from kurbel.verify.drives import Degrees, Drive, place_of, typed
from kurbel.verify.enclose import by_bits
from kurbel.verify.jets import Jet, slope_of, slope_of_angle
from kurbel.verify.numbers import Number, Undecided, largest, number, sine_cosine
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value
from kurbel.verify.zeros import Place

# A force on B in N about a crank angle.
Force = Callable[[Place], Jet | Number]


@dataclass(frozen=True)
class Bodies:
    """What a drive moves, in kg, m and N.

    `centre` of the rod's mass from B and its radius of gyration, or the square of that, are in lengths of the
    rod, `rotating` is the crank's own mass reduced to its pin, `inertia` the moment of inertia of the rocker
    about its pivot. The slide rises by `slope` degrees in the crank's sense; without a slope nothing has
    weight. `force` acts on B in the direction of the stroke, or is a function of the place, towards the
    shaft; `friction` acts against the motion; the crank itself accelerates by `acceleration`. `pins` are the
    diameters of crosshead pin, crank pin and shaft, which have the coefficient `pin_friction`.
    """

    drive: Drive
    reciprocating: Fraction = Fraction(0)
    rod_mass: Fraction = Fraction(0)
    centre: Fraction = Fraction(1, 2)
    gyration: Fraction = Fraction(0)
    gyration_square: Fraction | None = None
    rotating: Fraction = Fraction(0)
    inertia: Fraction = Fraction(0)
    slope: Fraction | None = None
    gravity: Fraction = Fraction(980665, 100000)
    force: Fraction | Force = Fraction(0)
    friction: Fraction = Fraction(0)
    acceleration: Fraction = Fraction(0)
    pin_friction: Fraction = Fraction(0)
    pins: tuple[Fraction, ...] = (Fraction(0),) * 3

    @property
    def spread(self) -> Fraction:
        """The square of the radius of gyration, in squares of the rod's length."""
        return self.gyration**2 if self.gyration_square is None else self.gyration_square

    @property
    def weight(self) -> Arrow:
        """Of a kilogram."""
        if self.slope is None:
            return Arrow(number(0), number(0))
        sine, cosine = sine_cosine(self.slope)
        return Arrow(-sine, -cosine).times(number(self.gravity))

    def rod_centre(self, pin: Arrow, end: Arrow) -> Arrow:
        """The centre of the rod's mass."""
        return end.plus(pin.minus(end).times(number(self.centre)))

    def knows(self, key: str) -> bool:
        name, _, unit = key.replace("_return", "").rpartition("_")
        return unit in ("n", "nm", "j") and name in _FORCES

    def value(self, key: str, degrees: Degrees, *, stroke: str | int | None = None) -> Value:
        """Return what kurbel's column of this key says, `guide_force_n` or `torque_return_nm`."""
        if not self.knows(key):
            raise ProblemError(f'there is no force "{key}" to verify')
        name, side = key.replace("_return", "").rpartition("_")[0], OUT
        if "_return" in key or stroke in (RETURN, "return"):
            side = RETURN
        return Value(lambda: self.at(name, place_of(degrees), side))

    def at(self, name: str, place: Place, stroke: int = OUT, more: int = 0) -> Number:
        """A force about an angle, or one of its slopes by that in radians."""
        turned = place if stroke == OUT else place.turned(Fraction(180))
        return slope_of(_FORCES[name](self._placed(turned, stroke, more)), more)

    @by_bits
    def _placed(self, place: Place, stroke: int, more: int) -> At:
        return At(self, place, stroke, more)


class At:
    """The bodies where the crank is at an angle, their forces with `more` slopes."""

    def __init__(self, bodies: Bodies, place: Place, stroke: int, more: int) -> None:
        self.bodies, self.drive, self.stroke, self.place = bodies, bodies.drive, stroke, place
        self.radius = number(self.drive.radius)
        self.pin_jet, self.end_jet = self.drive.placed(place, 2 + more)
        self.centre_jet = bodies.rod_centre(self.pin_jet, self.end_jet)
        self.crank, end, centre = (
            Arrow(*(Jet(one.terms[: more + 1]) for one in each))
            for each in (self.pin_jet, self.end_jet, self.centre_jet)
        )
        self.pin, self.end, self.centre = (one.times(self.radius) for one in (self.crank, end, centre))
        self.line = self.crank.minus(end).times(number(self.drive.ratio))
        self.way = self.drive.way(end, stroke)
        self.weight = bodies.weight

    def _by_time(self, first: Jet) -> Jet:
        """x'' ω² + x' α of the slope by the crank angle."""
        omega = self.drive.omega
        return first.derived() * (omega * omega) + first * number(self.bodies.acceleration)

    def accelerated(self, place: Arrow) -> Arrow:
        first = place.derived()
        return Arrow(self._by_time(first.x), self._by_time(first.y)).times(self.radius)

    def spun(self, line: Arrow) -> Jet:
        """The angular acceleration of what has this direction."""
        return self._by_time(slope_of_angle(*line))

    @property
    def piston_force(self) -> Jet | Number:
        force = self.bodies.force
        return force(self.place) * self.stroke if callable(force) else number(force)

    @property
    def friction_force(self) -> Number:
        if not self.bodies.friction:
            return number(0)
        slopes = self.end_jet.derived().x.value, self.end_jet.derived().y.value
        way = self.way.value() if isinstance(self.way.x, Jet) else self.way
        forward = way.dot(Arrow(*slopes)).sign()
        # At a dead centre it is that of the stroke which begins there.
        forward = forward or self.end_jet.slope(2).dot(way).sign()
        return number(-forward * self.bodies.friction)

    @cached_property
    def rod_inertia(self) -> Arrow:
        """What moves the centre of mass of the rod."""
        return self.accelerated(self.centre_jet).times(number(self.bodies.rod_mass))

    @cached_property
    def rod_couple(self) -> Jet:
        """What turns the rod about it."""
        long, turned = self.radius / self.drive.ratio, self.spun(self.pin_jet.minus(self.end_jet))
        return turned * (long * long * (self.bodies.spread * self.bodies.rod_mass))

    @cached_property
    def forces(self) -> tuple[Arrow, Arrow, Arrow]:
        """The forces on the rod at A and at B, and that of the guide or the rocker on B."""
        bodies, one, none = self.bodies, number(1), number(0)
        to_pin, to_end = self.pin.minus(self.centre), self.end.minus(self.centre)
        rod = self.rod_inertia.minus(self.weight.times(number(bodies.rod_mass)))
        couple = self.rod_couple
        pushed = self.way.times(self.piston_force + self.friction_force)
        end = self.accelerated(self.end_jet).minus(self.weight).times(number(bodies.reciprocating))
        end = end.minus(pushed)
        rows = [
            # The rod: Newton along and across, Euler about its centre of mass.
            [one, none, one, none, none, none, rod.x],
            [none, one, none, one, none, none, rod.y],
            [-to_pin.y, to_pin.x, -to_end.y, to_end.x, none, none, couple],
            # What goes with B: it feels the rod's force turned round, and the guide.
            [none, none, -one, none, one, none, end.x],
            [none, none, none, -one, none, one, end.y],
            [none, none, none, none, *self._held()],
        ]
        pin_x, pin_y, end_x, end_y, guide_x, guide_y = solved(rows)
        return Arrow(pin_x, pin_y), Arrow(end_x, end_y), Arrow(guide_x, guide_y)

    def _held(self) -> tuple[Any, Any, Any]:
        """A slide has no force along it; the rocker's own inertia takes the moment about its pivot."""
        if self.drive.rocker is None:
            return self.way.x, self.way.y, number(0)
        arm = self.end_jet.minus(self.drive.bearing)
        place = self.end.minus(self.drive.bearing.times(self.radius))
        return place.y, -place.x, self.spun(arm) * number(self.bodies.inertia)

    @property
    def net_torque(self) -> Jet | Number:
        """The torque less the friction of the pins: the least that a line leaves which touches the circles of
        friction d/2 sin ρ, tan ρ = μ, of both pins of the rod, on either side, less |S| that of the shaft."""
        push, long = self.forces[1].dot(self.way), self.radius / self.drive.ratio
        slip = number(self.bodies.pin_friction)
        at_end, at_pin, at_shaft = (
            slip / (1 + slip * slip).root() * Fraction(one) / 2 for one in self.bodies.pins
        )
        found = []
        for low, high in product((1, -1), repeat=2):
            # It leans by the angle whose sine is the difference of its distances from both over L.
            lean = (at_pin * high - at_end * low) / long
            along = self.line.times((1 - lean * lean).root()).minus(self.line.right().times(lean))
            thrust = push / along.dot(self.way)
            moment = (self.end.minus(along.right().times(at_end * low))).cross(along) * thrust
            found.append(abs(thrust.value) * at_shaft - moment.value)
        return -largest(found)

    @property
    def on_bearing(self) -> Arrow:
        """The force of the crank on the shaft's bearing: the rod's, and that of its own mass outwards."""
        omega = self.drive.omega
        outward = self.crank.times(number(self.bodies.rotating) * self.radius * omega * omega)
        across = Arrow(-self.crank.y, self.crank.x)
        backward = across.times(number(-self.bodies.acceleration * self.bodies.rotating) * self.radius)
        return outward.plus(backward).minus(self.forces[0])


def energies(bodies: Bodies, pin: Arrow) -> tuple[Jet, Jet]:
    """Those of motion, over the crank angle at the drive's speed, and of height."""
    drive, end = bodies.drive, bodies.drive.driven(pin)
    centre = bodies.rod_centre(pin, end)
    total = centre.derived().square() * bodies.rod_mass + end.derived().square() * bodies.reciprocating
    turn, long = slope_of_angle(*pin.minus(end)), 1 / number(drive.ratio)
    total = total + turn * turn * (long * long * (bodies.spread * bodies.rod_mass))
    radius, omega = number(drive.radius), drive.omega
    total = total * (radius * radius)
    if drive.rocker is not None:
        swung = slope_of_angle(*end.minus(drive.bearing))
        total = total + swung * swung * bodies.inertia
    places = end.times(number(bodies.reciprocating)).plus(centre.times(number(bodies.rod_mass)))
    return total * (omega * omega / 2), places.dot(bodies.weight) * -radius


def solved(rows: list[list[Any]]) -> list[Any]:
    """Solve linear equations by elimination; the largest pivot is taken, which must not hold zero."""
    rows, size = [list(row) for row in rows], len(rows)
    for column in range(size):
        best = max(range(column, size), key=lambda row: abs(float(rows[row][column])))
        rows[column], rows[best] = rows[best], rows[column]
        pivot = rows[column]
        if not float(pivot[column]):
            raise Undecided("a pivot")
        for row in range(size):
            if row != column and not rows[row][column].is_zero:
                factor = rows[row][column] / pivot[column]
                rows[row] = [a - factor * b for a, b in zip(rows[row], pivot, strict=True)]
                rows[row][column] = number(0)
    return [rows[row][size] / rows[row][row] for row in range(size)]


_FORCES: dict[str, Callable[[At], Any]] = {
    "piston_force": lambda at: at.piston_force,
    "inertia_force": lambda at: -at.accelerated(at.end_jet).dot(at.way) * number(at.bodies.reciprocating),
    "weight_force": lambda at: at.weight.dot(at.way) * number(at.bodies.reciprocating),
    "friction_force": lambda at: at.friction_force,
    "crosshead_load": lambda at: at.forces[1].dot(at.way),
    "guide_force": lambda at: at.forces[2].dot(at.way.right()),
    "rod_force": lambda at: at.forces[1].dot(at.line) * at.stroke,
    "crosshead_pin_force": lambda at: at.forces[1].size(),
    "crank_pin_force": lambda at: at.forces[0].size(),
    "pin_x": lambda at: at.forces[0].x,
    "pin_y": lambda at: at.forces[0].y,
    "tangential_force": lambda at: -at.crank.cross(at.forces[0]),
    "radial_force": lambda at: at.forces[0].dot(at.crank),
    "torque": lambda at: -at.pin.cross(at.forces[0]),
    "bearing_along": lambda at: -at.on_bearing.x * at.stroke,
    "bearing_across": lambda at: at.on_bearing.y * at.stroke,
    "bearing_force": lambda at: at.on_bearing.size(),
    # Of the rod alone: its inertia force, and how far that passes by its centre, in its lengths.
    "rod_inertia": lambda at: at.rod_inertia.size(),
    "rod_arm": lambda at: abs(at.rod_couple.value) / (at.rod_inertia.size() * at.radius) * at.drive.ratio,
    # Of the rod, of what goes with B and of the rocker.
    "kinetic_energy": lambda at: energies(at.bodies, at.pin_jet)[0],
    "net_torque": lambda at: at.net_torque,
}


def bodies(drive: Drive, **given: Any) -> Bodies:
    """Return the bodies of a drive; numbers are fractions or decimals as text, a force may be a function."""
    return Bodies(drive, **typed(given))
