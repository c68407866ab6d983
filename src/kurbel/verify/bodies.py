"""Piston, rod and rocker as rigid bodies: their forces by Newton and Euler in SI units.

What moves is the drive of `drives`; accelerations are the slopes of its places. A part of the rod at the
share x of the way from B to A is accelerated by a_B + x (a_A - a_B), so forces and energies know of the rod
its mass and the first and second moment of that about B, as sums over x, and are linear in these. By a
series B and the rod's turn are accelerated to first order, λ sin φ in the place of ψ; the rod stands at its
true angle.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import product

from kurbel.errors import ProblemError
from kurbel.verify.drives import Degrees, Drive, approximate, place_of, typed
from kurbel.verify.enclose import by_bits
from kurbel.verify.jets import Jet, slope_of, slope_of_angle
from kurbel.verify.numbers import Number, largest, number, pi, sine_cosine
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value
from kurbel.verify.zeros import Place

# A force on B in N about a crank angle.
Force = Callable[[Place], Jet | Number]
# The mass of a rod and the moments of that, or what tells them with the working bits.
Rod = tuple[Fraction, ...] | Callable[[], Sequence[Number]]


@dataclass(frozen=True)
class Bodies:
    """What a drive moves, in kg, m and N.

    `rod` has the rod's mass and the moments of that, in lengths of the rod, `rotating` is the crank's own
    mass reduced to its pin, `inertia` the moment of inertia of the rocker about its pivot. The slide rises by
    `slope` degrees in the crank's sense; without a slope nothing has weight. `force` acts on B in the
    direction of the stroke, or is a function of the place, towards the shaft; `friction` acts against the
    motion; the crank itself accelerates by `acceleration`. `pins` are the diameters of crosshead pin, crank
    pin and shaft, which have the coefficient `pin_friction`.
    """

    drive: Drive
    reciprocating: Fraction = Fraction(0)
    rod: Rod = (Fraction(0),) * 3
    rotating: Fraction = Fraction(0)
    inertia: Fraction = Fraction(0)
    slope: Fraction | None = None
    gravity: Fraction = Fraction(980665, 100000)
    force: Fraction | Force = Fraction(0)
    friction: Fraction = Fraction(0)
    acceleration: Fraction = Fraction(0)
    pin_friction: Fraction = Fraction(0)
    pins: tuple[Fraction, ...] = (Fraction(0),) * 3
    method: str = "exact"

    @property
    def moments(self) -> Sequence[Number]:
        return self.rod() if callable(self.rod) else [number(one) for one in self.rod]

    @property
    def weight(self) -> Arrow:
        """Of a kilogram."""
        if self.slope is None:
            return Arrow(number(0), number(0))
        sine, cosine = sine_cosine(self.slope)
        return Arrow(-sine, -cosine).times(number(self.gravity))

    def knows(self, key: str) -> bool:
        name, _, unit = key.replace("_return", "").rpartition("_")
        return unit in ("n", "nm", "j", "mps2", "speed") and name in _FORCES

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
        return slope_of(self.course(name, place, stroke, more), more)

    def course(self, name: str, place: Place, stroke: int = OUT, more: int = 0) -> Jet:
        turned = place if stroke == OUT else place.turned(Fraction(180))
        found = _FORCES[name](self._placed(turned, stroke, more))
        return found if isinstance(found, Jet) else Jet([found, *(number(0) for _ in range(more))])

    @by_bits
    def _placed(self, place: Place, stroke: int, more: int) -> At:
        return At(self, place, stroke, more)


class At:
    """The bodies where the crank is at an angle, their forces with `more` slopes."""

    def __init__(self, bodies: Bodies, place: Place, stroke: int, more: int) -> None:
        self.bodies, self.drive, self.stroke, self.place = bodies, bodies.drive, stroke, place
        self.radius = number(self.drive.radius)
        self.pin_jet, self.end_jet = self.drive.placed(place, 2 + more)
        self.crank, end = (
            Arrow(*(Jet(one.terms[: more + 1]) for one in each)) for each in (self.pin_jet, self.end_jet)
        )
        self.pin, self.end = self.crank.times(self.radius), end.times(self.radius)
        self.line = self.crank.minus(end).times(number(self.drive.ratio))
        if bodies.method == "infinite":
            self.line = Arrow(self.crank.x * 0 - 1, self.crank.x * 0)
        self.way = self.drive.way(end, stroke)
        self.weight = bodies.weight

    @property
    def end_moved(self) -> Arrow:
        """How B moves, from anywhere."""
        return moved_end(self.bodies, self.end_jet, self.place)

    def _by_time(self, first: Jet) -> Jet:
        """x'' ω² + x' α of the slope by the crank angle."""
        omega = self.drive.omega
        return first.derived() * (omega * omega) + first * number(self.bodies.acceleration)

    def accelerated(self, place: Arrow) -> Arrow:
        first = place.derived()
        return Arrow(self._by_time(first.x), self._by_time(first.y)).times(self.radius)

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
    def turned(self) -> Arrow:
        """How A is accelerated against B."""
        return self.turning.plus(self.stretching)

    @cached_property
    def turning(self) -> Arrow:
        """The part of that square to the rod, by the slope of its angular velocity."""
        if self.bodies.method == "exact":
            across, square = self.line.right(), self.line.square()
            whole = self.accelerated(self.pin_jet.minus(self.end_jet))
            return across.times(whole.dot(across) / square)
        return self.line.right().times(self._by_time(self.pin_jet.y.derived()) * self.radius)

    @cached_property
    def stretching(self) -> Arrow:
        """The part along the rod, by the square of that velocity."""
        if self.bodies.method == "exact":
            return self.accelerated(self.pin_jet.minus(self.end_jet)).minus(self.turning)
        slope, ratio = self.pin_jet.y.derived(), int(self.bodies.method == "series") * self.drive.ratio
        omega = self.drive.omega
        return self.line.times(slope * slope * (omega * omega) * (self.radius * -ratio))

    @cached_property
    def rod_inertia(self) -> Arrow:
        """What moves the centre of mass of the rod."""
        mass, first, _ = self.bodies.moments
        end, pin = self.accelerated(self.end_moved), self.accelerated(self.pin_jet)
        return end.times(mass - first).plus(pin.times(first))

    @property
    def rod_arm(self) -> Number:
        """How far that passes by the centre, in lengths of the rod: by the couple that turns the rod."""
        mass, first, second = self.bodies.moments
        found: Number = abs((self.line.cross(self.turned) / self.rod_inertia.size()).value)
        return found * (second - first * first / mass)

    @cached_property
    def forces(self) -> tuple[Arrow, Arrow, Arrow]:
        """The forces on the rod at A and at B, and that of the guide or the rocker on B.

        What goes with B takes that at B along the way; across it follows from the moment about B. Two masses
        at A and B have the rod's mass and first moment; of the second they lack what the rod's turn takes.
        """
        mass, first, second = self.bodies.moments
        end, pin = (self.accelerated(one).minus(self.weight) for one in (self.end_moved, self.pin_jet))
        whole = end.times(mass - first).plus(pin.times(first))
        moment = pin.times(first).plus(self.turned.times(second - first))
        taken, pushed = end.times(number(self.bodies.reciprocating)), self.piston_force + self.friction_force
        along = self.way.times(pushed + self._held - taken.dot(self.way))
        square = self.line.cross(whole.minus(moment).minus(along)) / self.line.dot(self.way)
        on_end = along.minus(self.way.right().times(square))
        return whole.minus(on_end), on_end, taken.plus(on_end).minus(self.way.times(pushed))

    @property
    def _held(self) -> Jet | Number:
        """What the guide has along the way: a slide nothing, a rocker what its own inertia takes."""
        if self.drive.rocker is None:
            return number(0)
        arm = self.end_jet.minus(self.drive.bearing)
        turn = number(self.stroke * self.drive.right) / (self.radius * self.drive.rocker)
        return self._by_time(slope_of_angle(*arm)) * turn * self.bodies.inertia

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


def moved_end(bodies: Bodies, end: Arrow, place: Place) -> Arrow:
    """How B moves by the method, from anywhere, if it is exactly at its end."""
    if bodies.method == "exact":
        return end
    series = int(bodies.method == "series")
    path = approximate("x", bodies.drive, place, OUT, series, len(end.x.terms) - 1)
    return Arrow(-path, path * 0)


def energies(bodies: Bodies, pin: Arrow, place: Place) -> tuple[Jet, Jet]:
    """Those of motion, over the crank angle at the drive's speed, and of height.

    The rod is two masses at A and B, and what it lacks of a second moment turns as it does.
    """
    drive, whole = bodies.drive, bodies.drive.driven(pin)
    end, (mass, first, second) = moved_end(bodies, whole, place), bodies.moments
    spun = pin.minus(whole).derived().square() if bodies.method == "exact" else pin.x * pin.x
    total = end.derived().square() * (mass + bodies.reciprocating - first) + spun * (second - first)
    radius, omega = number(drive.radius), drive.omega
    total = (total + pin.derived().square() * first) * (radius * radius)
    if drive.rocker is not None:
        swung = slope_of_angle(*end.minus(drive.bearing))
        total = total + swung * swung * bodies.inertia
    places = end.times(mass + bodies.reciprocating - first).plus(pin.times(first))
    return total * (omega * omega / 2), places.dot(bodies.weight) * -radius


def _of_arrow(name: str, part: str, at: At) -> Jet | Number:
    arrow = at.turned if name == "replaced" else at.accelerated(at.pin_jet if name == "pin" else at.end_moved)
    known = {"_along": -arrow.x, "_across": -arrow.y}
    # What B has along its slide has a sign.
    return arrow.size() if not part and name != "common" else known[part or "_along"]


_FORCES: dict[str, Callable[[At], Jet | Number]] = {
    "piston_force": lambda at: at.piston_force,
    "inertia_force": lambda at: -at.accelerated(at.end_moved).dot(at.way) * number(at.bodies.reciprocating),
    "weight_force": lambda at: at.weight.dot(at.way) * number(at.bodies.reciprocating),
    "friction_force": lambda at: at.friction_force,
    "crosshead_load": lambda at: at.forces[1].dot(at.way),
    "guide_force": lambda at: at.forces[2].dot(at.way.right()),
    "rod_force": lambda at: at.forces[1].dot(at.line) * at.stroke,
    "pin_rod_force": lambda at: -at.forces[0].dot(at.line) * at.stroke,
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
    # In 1/min, the speed at which the inertia force, which grows with its square, is what the others are.
    "reversing": lambda at: (
        (1 - _FORCES["crosshead_load"](at) / _FORCES["inertia_force"](at)).root()
        * (30 * at.drive.omega / pi())
    ),
    # How A and B are accelerated, and A against B: towards the shaft and against the crank pin's side, and by
    # its parts, square to the rod with that and along it towards B.
    **{
        f"{name}_acceleration{part}": partial(_of_arrow, name, part)
        for name in ("pin", "common", "replaced")
        for part in ("", "_along", "_across")
    },
    "turning_acceleration": lambda at: -at.turning.dot(at.line.right()),
    "stretching_acceleration": lambda at: -at.stretching.dot(at.line),
    # Of the rod alone: its inertia force, and how far that passes by its centre, in its lengths.
    "rod_inertia": lambda at: at.rod_inertia.size(),
    "rod_arm": lambda at: at.rod_arm,
    # Of the rod, of what goes with B and of the rocker.
    "kinetic_energy": lambda at: energies(at.bodies, at.pin_jet, at.place)[0],
    "net_torque": lambda at: at.net_torque,
}


def lying(sections: Sequence[tuple[Fraction, Fraction, Fraction]]) -> tuple[Number, Number, Number]:
    """The mass, the centre and the k² of a rod of masses that are spread evenly from one place to another, in
    lengths of the rod from B: of x² the mean is (a² + a b + b²)/3."""
    mass = sum((one for *_, one in sections), Fraction(0))
    first = sum((one * (a + b) / 2 for a, b, one in sections), Fraction(0))
    second = sum((one * (a * a + a * b + b * b) / 3 for a, b, one in sections), Fraction(0))
    return number(mass), number(first / mass), number(second / mass - (first / mass) ** 2)


def swung(
    swings: Sequence[tuple[Number, Fraction]], gravity: Fraction, centre: Fraction | None
) -> tuple[Number, Number]:
    """The centre of a rod and its k², by the times in which it swings to and fro about places, in lengths of
    the rod: (T/2π)² g d = d² + k², d from the place to the centre. Of two on both sides of the centre the
    difference, l₁ d₁ - l₂ d₂ = d₁² - d₂² with d₁ + d₂ = D, is linear in d₁."""
    (place, time), *others = sorted(swings, key=lambda one: float(one[0]))
    length = gravity * (time * time) / (4 * pi() * pi())
    if not others:
        at = number(centre or 0)
    else:
        apart = others[0][0] - place
        other = gravity * (others[0][1] * others[0][1]) / (4 * pi() * pi())
        at = place + apart * (other - apart) / (length + other - 2 * apart)
    away = abs(at - place)
    return at, away * (length - away)


def bodies(drive: Drive, **given: object) -> Bodies:
    """Return the bodies of a drive; numbers are fractions or decimals as text, a force may be a function.

    A rod may be described by `rod_mass`, the `centre` of its mass from B, or its middle, and its radius of
    `gyration`, both in lengths of the rod.
    """
    numbers = typed(given)
    mass, centre, gyration = (
        numbers.pop(name, Fraction(other))
        for name, other in (("rod_mass", 0), ("centre", "1/2"), ("gyration", 0))
    )
    return Bodies(drive, **{"rod": (mass, mass * centre, mass * (centre**2 + gyration**2)), **numbers})
