"""Crank drives: what a column of kurbel's says of them at a crank angle, in its unit.

Where the pins are is known from `places`; everything else is its slope, or a force along its lines.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.errors import ProblemError
from kurbel.verify.jets import Jet, direction, slope_of, slope_of_angle
from kurbel.verify.numbers import Number, arccosine, heading, largest, number, pi
from kurbel.verify.places import OUT, RETURN, Places
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value
from kurbel.verify.zeros import Place

METHODS = ("exact", "series", "infinite", "difference")
# An angle, or what finds one with the working bits.
Degrees = Fraction | int | str | Callable[[], Place]


def place_of(degrees: Degrees) -> Place:
    return degrees() if callable(degrees) else Place(Fraction(degrees))


def typed(given: Mapping[str, object]) -> dict[str, Any]:
    """Return numbers as fractions, which may be decimals as text, without what is None."""

    def exact(one: object) -> object:
        if isinstance(one, tuple):
            return tuple(map(exact, one))
        return Fraction(one) if isinstance(one, str | int | Fraction) else one

    return {name: exact(one) for name, one in given.items() if one is not None}


class PinForces(NamedTuple):
    """The crank pin, the force on it, that in the rod, and what guide and sliding block hold."""

    pin: Arrow
    on_pin: Arrow
    rod_force: Jet | Number
    guide_force: Jet | Number
    block_force: Jet | Number = number(0)

    def force(self, name: str) -> Jet | Number:
        if name in self._fields:
            return getattr(self, name)
        return -self.on_pin.dot(self.pin) if name == "radial_force" else self.pin.cross(self.on_pin)


@dataclass(frozen=True)
class Drive(Places):
    """A drive of a size at a speed, a force on B, or two parallel cranks with a rod that couples them."""

    parallel: bool = False
    radius: Fraction = Fraction(1)
    speed: Fraction = Fraction(1)
    turns: bool = False
    force: Fraction = Fraction(1)

    @property
    def omega(self) -> Number:
        return number(self.speed) * (2 * pi() if self.turns else 1)

    @property
    def rod_length(self) -> Fraction | None:
        """In m, None of an infinite rod."""
        return self.radius / self.ratio if self.ratio else None

    def value(
        self,
        key: str,
        degrees: Degrees = 0,
        method: str = "exact",
        *,
        order: int = 1,
        stroke: str | int | None = None,
        point: tuple[Fraction | str, Fraction | str] | None = None,
    ) -> Value:
        """Return what kurbel's column of this key says at an angle in degrees, or at a place found anew.

        `x_return_mm` is `x`, on the return, in mm; `stroke="return"` says the same. With a `point` (share of
        the rod from B, beside it) keys are those of points.
        """
        if method == "difference":
            exact, series = (
                self.value(key, degrees, one, order=order, stroke=stroke, point=point) for one in METHODS[:2]
            )
            return exact - series
        how = self.over(key, method, order=order, back=stroke in (RETURN, "return"), point=point)
        return Value(lambda: how.value(place_of(degrees)))

    def over(
        self,
        key: str,
        method: str = "exact",
        *,
        order: int = 1,
        back: bool = False,
        point: tuple[Fraction | str, Fraction | str] | None = None,
    ) -> Course:
        """Return the column over the crank angle; `series-3` is the series of third order."""
        method, _, kept = method.partition("-")
        if method not in METHODS[:3]:
            raise ProblemError(f'there is no method "{method}"')
        of_point = None if point is None else (Fraction(point[0]), Fraction(point[1]))
        parted(key)
        return Course(self, key, method, int(kept or order), back, of_point)

    def course(
        self, name: str, place: Place, stroke: int, method: str, order: int, more: int
    ) -> Jet | Number:
        """A quantity about an angle of the turn, with `more` slopes where it has any."""
        if not self.ratio and not self.parallel:
            method = "infinite"
        if self.parallel:
            if name in FORCES:
                return self.held(place, OUT, "infinite", more).force(name)
            return _parallel(name, self.pin(place.degrees, 2 + more, place.reach))
        if name in OF_DRIVE:
            return OF_DRIVE[name](self)
        if name == "slot_velocity":
            # The pin's way in the slot of a Scotch yoke, which moves as a piston with an infinite rod.
            return self.pin(place.degrees, 1 + more, place.reach).y.derived()
        if name == "time":
            return (place.angle - self.dead_degrees(stroke)) * pi() / 180 / self.omega
        if name in FORCES:
            return self.held(place, stroke, method, more).force(name)
        if method == "exact" or (name == "psi" and method == "series"):
            return self.moving(name, place, stroke, more)
        return approximate(name, self, place, stroke, order if method == "series" else 0, more)

    def moving(self, name: str, place: Place, stroke: int, more: int) -> Jet:
        of, slope = _SLOPES.get(name, (name, 0))
        pin, end = self.placed(place, slope + more)
        rod = pin.minus(end)
        if of == "rod" and slope:
            # Against the crank's sense, from the direction of the slide.
            return -slope_of_angle(*rod).derived(slope - 1)
        if of in ("path", "turn") and name != "turn":
            way = self.moved(end, stroke) if of == "path" else self.turned(end, stroke)
            return way.derived(slope)
        if name == "rod_along":
            return end.derived().dot(rod) / rod.size() * stroke
        if name == "slowest_point":
            # Where the velocity, which changes evenly along the rod, is square to its change.
            change = rod.derived()
            return -end.derived().dot(change) / change.square()
        if name == "fd":
            return self.rod + rod.x
        if name in ("psi", "rod"):
            return direction(-rod.x, rod.y)
        if name == "turn":
            return self.turned(end, stroke) * 180 / pi()
        if name == "rocker":
            # From where the rocker is square to the slide direction.
            return direction(*end.minus(self.bearing).right().times(number(-self.right)))
        if name == "slant":
            tangent = self.way(end, OUT)
            return -direction(tangent.dot(rod), tangent.cross(rod))
        moved = self.dead(stroke).minus(end).times(number(stroke))
        return moved.size() if name == "chord" else moved.x if name == "slide_path" else -moved.y

    def held(self, place: Place, stroke: int, method: str, more: int) -> PinForces:
        """What a force of 1 on B in the direction of the stroke does, which rod and guide hold."""
        if method == "infinite":
            crank, line = self.pin(place.degrees, more, place.reach), Arrow(number(-1), number(0))
            way = Arrow(number(-stroke), number(0))
        else:
            crank, end = self.placed(place, more)
            line, way = crank.minus(end).times(number(self.ratio)), self.way(end, stroke)
        # Along the path the rod alone holds it.
        thrust: Jet | Number = 1 / line.dot(way)
        on_pin = line.times(thrust)
        return PinForces(crank, on_pin, thrust * number(stroke), on_pin.dot(way.right()))

    @property
    def transmission(self) -> Number:
        """The least angle between the rod and the square to the slide, or the rocker.

        The rod leans most where A is farthest from the line of the slide. Between rod and rocker it is least
        at an extreme of the distance from A to the pivot: where the crank lies in the line of centres.
        """
        if self.rocker is None:
            return arccosine((1 + abs(number(self.offset))) * self.ratio)
        rod, rocker, apart = self.rod, number(self.rocker), self.bearing.size()
        squares = ((apart + side) * (apart + side) for side in (1, -1))
        cosines = [abs((rod * rod + rocker * rocker - one) / (2 * rod * rocker)) for one in squares]
        return arccosine(largest(cosines))

    def point(self, name: str, place: Place, point: tuple[Fraction, Fraction]) -> Jet | Number:
        """The motion of a point at a share of the rod from B and beside it."""
        share, beside = (number(one) for one in point)

        def at(pin: Arrow, end: Arrow) -> Arrow:
            rod = pin.minus(end)
            return end.plus(rod.times(share)).plus(rod.right().times(beside))

        moved = at(*self.placed(place))
        dead = self.dead(OUT)
        before = at(dead.times(1 / (self.rod + 1)), dead)
        quantity, _, part = name.partition("_")
        order = _ORDERS[quantity]
        arrow = moved.slope(order) if order else moved.value().minus(Arrow(before.x, number(0)))
        if part == "direction":
            return heading(*arrow)
        return {"along": -arrow.x, "across": arrow.y, "": arrow.size()}[part]

    def unit(self, unit: str) -> Number:
        radius, omega = number(self.radius), self.omega
        known: dict[str, Callable[[], Number]] = {
            "": lambda: number(1),
            # As books print it, before which R ω² stands.
            "bracket": lambda: number(1),
            "stroke": lambda: 1 / self.stroke,
            "percent": lambda: 100 / self.stroke,
            "mm": lambda: 1000 * radius,
            "mps": lambda: radius * omega,
            "mps2": lambda: radius * omega * omega,
            "radps": lambda: omega,
            "radps2": lambda: omega * omega,
            "n": lambda: number(self.force),
            "nm": lambda: number(self.force) * radius,
        }
        if unit not in known:
            raise ProblemError(f'there is no unit "{unit}" to verify')
        return known[unit]()


@dataclass(frozen=True)
class Course:
    """A column over the crank angle: a quantity on a stroke, by a method, in a unit."""

    drive: Drive
    key: str
    method: str = "exact"
    order: int = 1
    back: bool = False
    point: tuple[Fraction, Fraction] | None = None

    def value(self, place: Place, more: int = 0) -> Number:
        """The value about an angle, or one of its slopes by that in radians."""
        name, returning, unit = parted(self.key)
        stroke = RETURN if returning or self.back else OUT
        if self.point is not None:
            found = self.drive.point(name, place, self.point)
        else:
            turned = place if stroke == OUT else place.turned(Fraction(180))
            found = self.drive.course(name, turned, stroke, self.method, self.order, more)
        return slope_of(found, more) * self.drive.unit(unit)


def drive(ratio: Fraction | str = Fraction(0), offset: Fraction | str | int = 0, **given: object) -> Drive:
    """Return a drive as users describe it: "1:5", an offset in crank radii, a `rocker` about a `pivot` (x, y)
    or of the other `circuit`, the arm of a `beam`, or `parallel` cranks.

    `radius` is in m, `speed` in rad/s, or with `turns` in 1/s, and `force` in N.
    """
    if isinstance(ratio, str):
        crank, _, rod = ratio.partition(":")
        ratio = Fraction(crank) / Fraction(rod or 1)
    numbers = typed(given)
    if (arm := numbers.pop("beam", None)) is not None:
        numbers = {"rocker": arm, **numbers, "beam": True}
    found = Drive(ratio, Fraction(offset), **numbers)
    if found.rocker is not None and not found.ratio:
        raise ProblemError("an infinite rod that a rocker guides is not to be verified")
    if found.rocker is None and found.ratio and abs(found.offset) >= 1 / found.ratio - 1:
        raise ProblemError("this crank does not turn: the offset is not less than L - R")
    return found


def parted(key: str) -> tuple[str, bool, str]:
    """Return the quantity, whether it is of the return stroke, and the unit: x, True, mm of x_return_mm."""
    known = [one for one in _NAMES if f"{key}_".startswith(f"{one}_")]
    if not known:
        raise ProblemError(f'there is no quantity "{key}" to verify')
    name = max(known, key=len)
    rest = key.removeprefix(name).split("_")[1:]
    returning = rest[:1] == ["return"]
    return name, returning, "_".join(rest[returning:])


def approximate(name: str, drive: Drive, place: Place, stroke: int, order: int, more: int) -> Jet | Number:
    """The straight crank by powers of λ up to an order, 0 of an infinitely long rod.

    λ is the variable of a series whose coefficients are series in φ: nothing is expanded by hand.
    """
    of, slope = _SLOPES.get(name, (name, 0))
    pin = drive.pin(place.degrees, slope + more, place.reach)
    nothing = pin.x * 0

    def powers(*terms: Jet) -> Jet:
        return Jet([*terms, *(nothing for _ in range(order + 1))][: order + 1])

    sine = powers(nothing, pin.y)
    cosine = (1 - sine * sine).root()
    # L (1 - cos ψ) = λ sin² φ/(1 + cos ψ) in crank radii.
    versine = sine * powers(pin.y) / (1 + cosine)
    ratio = number(drive.ratio)
    if name == "psi":
        return nothing
    if name not in (*_SLOPES, "fd"):
        raise ProblemError(f'there is no series of "{name}" to verify')
    found: Jet = versine.at(ratio)
    if of == "rod":
        by_angle = [Jet([one.derived() for one in series.terms]) for series in (cosine, sine)]
        turn = ((cosine * by_angle[1] - sine * by_angle[0]) / (cosine * cosine + sine * sine)).at(ratio)
        found = turn.derived(slope - 1)
    elif name != "fd":
        found = 1 - pin.x + found
        found = (2 - found if stroke == RETURN else found).derived(slope)
    return found


def _parallel(name: str, pin: Arrow) -> Jet | Number:
    """Every point of the coupling rod runs as the crank pin, on a circle of its own; it does not turn."""
    part, _, quantity = name.rpartition("_")
    if part == "rod":
        return number(0)
    order = _ORDERS.get(quantity, 0)
    if not part.startswith("coupler"):
        raise ProblemError(f'there is no "{name}" of parallel cranks to verify')
    return (pin.y if "rise" in name else 1 - pin.x).derived(order)


def _lead(drive: Drive) -> Number:
    return drive.dead_degrees(RETURN) - drive.dead_degrees(OUT) - 180


OF_DRIVE: dict[str, Callable[[Drive], Number]] = {
    "phi_i": lambda drive: drive.dead_degrees(OUT),
    "phi_o": lambda drive: drive.dead_degrees(RETURN),
    "lead": _lead,
    "time_ratio": lambda drive: (180 + _lead(drive)) / (180 - _lead(drive)),
    "stroke": lambda drive: drive.stroke,
    "swing": lambda drive: drive.swing,
    "transmission": lambda drive: drive.transmission,
    "outstroke_time": lambda drive: (180 + _lead(drive)) * pi() / 180 / drive.omega,
    "return_time": lambda drive: (180 - _lead(drive)) * pi() / 180 / drive.omega,
    # The mean over a turn of two strokes.
    "v": lambda drive: number(1),
    "c_m": lambda drive: drive.stroke / pi(),
    "v_c_m": lambda drive: pi() / drive.stroke,
}
# Of a slotted lever and a Scotch yoke alone.
_SLOTTED = (
    "lever", "lever_velocity", "lever_acceleration", "block_velocity", "coriolis", "slot_velocity",
)  # fmt: skip
FORCES = ("rod_force", "guide_force", "block_force", "tangential_force", "radial_force", "torque")
_ORDERS = {"path": 0, "velocity": 1, "acceleration": 2}
# What is a slope of what.
_SLOPES = {
    **{name: ("path", order) for names in ("xcp", _ORDERS) for order, name in enumerate(names)},
    **{
        f"{of}_{name}": (of, _ORDERS[name]) for of in ("turn", "rod") for name in ("velocity", "acceleration")
    },
    **{name: (name, 1) for name in ("rod_along", "slowest_point")},
}
_POINTS = [
    *(f"{one}_{part}" for one in _ORDERS for part in ("along", "across")),
    *("velocity_direction", "acceleration_direction"),
]
_COUPLER = (*_ORDERS, "rise", "rise_velocity", "rise_acceleration")
_NAMES = (
    *OF_DRIVE, *FORCES, *_SLOPES, *_SLOTTED, *_POINTS, *(f"coupler_{one}" for one in _COUPLER),
    *("time", "fd", "psi", "rod", "turn", "rocker", "slant", "chord", "slide_path", "rise"),
)  # fmt: skip
