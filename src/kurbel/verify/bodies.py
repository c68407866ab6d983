"""Piston, rod and rocker as rigid bodies: their forces by Newton and Euler, as linear equations in SI units.

What moves is the drive of `drives`; accelerations are the slopes of its places.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from kurbel.errors import ProblemError
from kurbel.verify.drives import Drive
from kurbel.verify.enclose import Working
from kurbel.verify.jets import Jet, slope_of_angle
from kurbel.verify.numbers import Number, Undecided, number, sine_cosine
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value

# A force on B in N by the crank angle in degrees.
Force = Callable[[Fraction], Number]


@dataclass(frozen=True)
class Bodies:
    """What a drive moves, in kg, m and N.

    `centre` of the rod's mass from B and its radius of gyration are shares of its length, `rotating` is the
    crank's own mass reduced to its pin, `inertia` the moment of inertia of the rocker about its pivot. The
    slide rises by `slope` degrees in the crank's sense; without a slope nothing has weight. `force`, which
    may be a function of the crank angle, acts on B in the direction of the stroke, `friction` against it; the
    crank itself accelerates by `acceleration`.
    """

    drive: Drive
    reciprocating: Fraction = Fraction(0)
    rod_mass: Fraction = Fraction(0)
    centre: Fraction = Fraction(1, 2)
    gyration: Fraction = Fraction(0)
    rotating: Fraction = Fraction(0)
    inertia: Fraction = Fraction(0)
    slope: Fraction | None = None
    gravity: Fraction = Fraction(980665, 100000)
    force: Fraction | Force = Fraction(0)
    friction: Fraction = Fraction(0)
    acceleration: Fraction = Fraction(0)

    @property
    def weight(self) -> Arrow:
        """Of a kilogram."""
        if self.slope is None:
            return Arrow(number(0), number(0))
        sine, cosine = sine_cosine(self.slope)
        return Arrow(-sine, -cosine).times(number(self.gravity))

    def value(self, key: str, degrees: Fraction | int | str, *, stroke: str | int | None = None) -> Value:
        """Return what kurbel's column of this key says, `guide_force_n` or `torque_return_nm`."""
        side = RETURN if "_return" in key or stroke in (RETURN, "return") else OUT
        name, _, unit = key.replace("_return", "").rpartition("_")
        if unit not in ("n", "nm", "j") or name not in _FORCES:
            raise ProblemError(f'there is no force "{key}" to verify')
        return Value(lambda: _FORCES[name](self.at(Fraction(degrees), side)))

    def at(self, degrees: Fraction, stroke: int) -> At:
        return _at(self, degrees if stroke == OUT else degrees + 180, stroke, Working.bits)


@lru_cache(maxsize=64)
def _at(bodies: Bodies, degrees: Fraction, stroke: int, bits: int) -> At:
    """Kept for many columns, with the bits it was computed with."""
    return At(bodies, degrees, stroke)


class At:
    """The bodies where the crank is at an angle."""

    def __init__(self, bodies: Bodies, degrees: Fraction, stroke: int) -> None:
        self.bodies, self.drive, self.stroke, self.degrees = bodies, bodies.drive, stroke, degrees
        self.radius = number(self.drive.radius)
        pin, end = self.drive.placed(degrees)
        self.pin_jet, self.end_jet = pin, end
        self.centre_jet = end.plus(pin.minus(end).times(number(bodies.centre)))
        self.pin, self.end, self.centre = (self._long(one.value()) for one in (pin, end, self.centre_jet))
        self.crank = pin.value()
        self.line = pin.minus(end).value().times(number(self.drive.ratio))
        self.way = self.drive.way(end.value(), stroke)
        self.weight = bodies.weight
        self._solved: tuple[Arrow, Arrow, Arrow] | None = None

    def _long(self, one: Arrow) -> Arrow:
        return one.times(self.radius)

    def _by_time(self, first: Any, second: Any) -> Any:
        """x'' ω² + x' α of the slopes by the crank angle."""
        omega = self.drive.omega
        return second * (omega * omega) + first * number(self.bodies.acceleration)

    def accelerated(self, place: Arrow) -> Arrow:
        first, second = place.slope(1), place.slope(2)
        return self._long(Arrow(self._by_time(first.x, second.x), self._by_time(first.y, second.y)))

    def spun(self, line: Arrow) -> Number:
        """The angular acceleration of what has this direction."""
        slope: Jet = slope_of_angle(*line)
        found: Number = self._by_time(slope.value, slope.slope())
        return found

    @property
    def piston_force(self) -> Number:
        force = self.bodies.force
        return force(self.degrees) if callable(force) else number(force)

    @property
    def inertia_force(self) -> Number:
        return -self.accelerated(self.end_jet).dot(self.way) * self.bodies.reciprocating

    @property
    def weight_force(self) -> Number:
        return self.weight.dot(self.way) * self.bodies.reciprocating

    @property
    def friction_force(self) -> Number:
        if not self.bodies.friction:
            return number(0)
        forward = self.end_jet.slope(1).dot(self.way).sign()
        # At a dead centre it is that of the stroke which begins there.
        forward = forward or self.end_jet.slope(2).dot(self.way).sign()
        return number(-forward * self.bodies.friction)

    @property
    def forces(self) -> tuple[Arrow, Arrow, Arrow]:
        """The forces on the rod at A and at B, and that of the guide or the rocker on B."""
        if self._solved is None:
            self._solved = self._solve()
        return self._solved

    def _solve(self) -> tuple[Arrow, Arrow, Arrow]:
        bodies, one, none = self.bodies, number(1), number(0)
        to_pin, to_end = self.pin.minus(self.centre), self.end.minus(self.centre)
        rod = self.accelerated(self.centre_jet).minus(self.weight).times(number(bodies.rod_mass))
        long = number(bodies.gyration) * self.radius / self.drive.ratio
        couple = self.spun(self.pin_jet.minus(self.end_jet)) * long * long * bodies.rod_mass
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

    def _held(self) -> tuple[Number, Number, Number]:
        """A slide has no force along it; the rocker's own inertia takes the moment about its pivot."""
        if self.drive.rocker is None:
            return self.way.x, self.way.y, number(0)
        arm = self.end_jet.minus(self.drive.bearing)
        place = self._long(arm.value())
        return place.y, -place.x, self.spun(arm) * self.bodies.inertia

    @property
    def on_bearing(self) -> Arrow:
        """The force of the crank on the shaft's bearing: the rod's, and that of its own mass outwards."""
        omega = self.drive.omega
        outward = self.crank.times(number(self.bodies.rotating) * self.radius * omega * omega)
        across = Arrow(-self.crank.y, self.crank.x)
        backward = across.times(number(-self.bodies.acceleration * self.bodies.rotating) * self.radius)
        return outward.plus(backward).minus(self.forces[0])

    @property
    def kinetic_energy(self) -> Number:
        """Of the rod, of what goes with B and of the rocker."""
        found: Number = kinetic(self.bodies, self.pin_jet).value
        return found


def kinetic(bodies: Bodies, pin: Arrow) -> Jet:
    """The energy of motion, over the crank angle at the drive's speed."""
    drive, end = bodies.drive, bodies.drive.driven(pin)
    centre = end.plus(pin.minus(end).times(number(bodies.centre)))
    total = centre.derived().square() * bodies.rod_mass + end.derived().square() * bodies.reciprocating
    turn, long = slope_of_angle(*pin.minus(end)), number(bodies.gyration) / drive.ratio
    total = total + turn * turn * (long * long * bodies.rod_mass)
    radius, omega = number(drive.radius), drive.omega
    total = total * (radius * radius)
    if drive.rocker is not None:
        swung = slope_of_angle(*end.minus(drive.bearing))
        total = total + swung * swung * bodies.inertia
    found: Jet = total * (omega * omega / 2)
    return found


def stored(bodies: Bodies, pin: Arrow) -> Jet:
    """The energies of motion and of height."""
    found = kinetic(bodies, pin)
    if bodies.slope is None:
        return found
    end = bodies.drive.driven(pin)
    centre = end.plus(pin.minus(end).times(number(bodies.centre)))
    places = end.times(number(bodies.reciprocating)).plus(centre.times(number(bodies.rod_mass)))
    lifted = places.dot(bodies.weight) * number(bodies.drive.radius)
    return found - lifted


def solved(rows: list[list[Number]]) -> list[Number]:
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


def _towards(force: Arrow, direction: Arrow) -> Number:
    found: Number = force.dot(direction)
    return found


_FORCES: dict[str, Callable[[At], Number]] = {
    "piston_force": lambda at: at.piston_force,
    "inertia_force": lambda at: at.inertia_force,
    "weight_force": lambda at: at.weight_force,
    "friction_force": lambda at: at.friction_force,
    "crosshead_load": lambda at: _towards(at.forces[1], at.way),
    "guide_force": lambda at: _towards(at.forces[2], at.way.right()),
    "rod_force": lambda at: _towards(at.forces[1], at.line) * at.stroke,
    "crosshead_pin_force": lambda at: at.forces[1].size(),
    "crank_pin_force": lambda at: at.forces[0].size(),
    "tangential_force": lambda at: -at.crank.cross(at.forces[0]),
    "radial_force": lambda at: _towards(at.forces[0], at.crank),
    "torque": lambda at: -at.pin.cross(at.forces[0]),
    "bearing_along": lambda at: -at.on_bearing.x * at.stroke,
    "bearing_across": lambda at: at.on_bearing.y * at.stroke,
    "bearing_force": lambda at: at.on_bearing.size(),
    "kinetic_energy": lambda at: at.kinetic_energy,
}


def bodies(drive: Drive, **given: Any) -> Bodies:
    """Return the bodies of a drive; numbers are fractions or decimals as text, a force may be a function."""
    numbers: dict[str, Any] = {
        name: one if callable(one) else Fraction(one) for name, one in given.items() if one is not None
    }
    return Bodies(drive, **numbers)
