"""Crank drives by their geometry: where the pins are, and from that how everything moves.

Lengths are in crank radii. The shaft is at (0, 0), the crank pin A at φ from the slide direction, B the
driven end of the rod. A stroke's angle counts from 0° on the outstroke and from 180° on the return; the way
of B is positive in the direction of the stroke.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from kurbel.errors import ProblemError
from kurbel.verify import enclose
from kurbel.verify.jets import Jet, slope_of_angle, turning
from kurbel.verify.numbers import Number, degrees_of, number, pi
from kurbel.verify.plane import Arrow, circle_meets_circle, circle_meets_level
from kurbel.verify.value import Value
from kurbel.verify.zeros import zero

OUT, RETURN = 1, -1
# Slopes that a jet has.
ORDER = 3
SHAFT = Arrow(number(0), number(0))
METHODS = ("exact", "series", "infinite", "difference")


@dataclass(frozen=True)
class Drive:
    """A crank with a rod whose end B a slide guides at the level `offset`, or a rocker about a pivot."""

    ratio: Fraction
    offset: Fraction = Fraction(0)
    rocker: Fraction | None = None
    pivot: tuple[Fraction, Fraction] | None = None
    circuit: int = 1
    beam: bool = False
    parallel: bool = False
    radius: Fraction = Fraction(1)
    speed: Fraction = Fraction(1)
    turns: bool = False
    force: Fraction = Fraction(1)

    # Places.

    @property
    def rod(self) -> Number:
        return 1 / number(self.ratio)

    @property
    def right(self) -> int:
        """Whether B lies to the right of the way from A to the pivot, or, -1, to the left."""
        below = self.pivot is not None and self.pivot[1] < 0
        return -self.circuit if below else self.circuit

    @property
    def bearing(self) -> Arrow:
        """The pivot of the rocker."""
        if self.beam:
            return _beam_pivot(self, enclose.Working.bits)
        assert self.rocker is not None
        if self.pivot is None:
            return Arrow(self.rod, number(self.offset + self.rocker))
        return Arrow(*map(number, self.pivot))

    def pin(self, degrees: Fraction, order: int = ORDER, reach: Fraction = Fraction(0)) -> Arrow:
        return Arrow(*turning(degrees, order, reach))

    def driven(self, pin: Arrow) -> Arrow:
        """Where B is."""
        return self.reached(pin, self.rod)

    def placed(self, degrees: Fraction) -> tuple[Arrow, Arrow]:
        """A and B at an angle."""
        return _placed(self, degrees, enclose.Working.bits)

    def reached(self, centre: Arrow, reach: Number) -> Arrow:
        if self.rocker is None:
            return circle_meets_level(centre, reach, number(self.offset))
        return circle_meets_circle(centre, reach, self.bearing, number(self.rocker), self.right)

    def dead(self, stroke: int) -> Arrow:
        """Where B is at the dead centre from which a stroke begins: crank and rod in one line, L + 1 or L - 1
        from the shaft. Seen from the shaft it is on the same side of the pivot as from A, for A is on the
        line through B and the shaft, before B."""
        return _dead(self, stroke, enclose.Working.bits)

    def dead_degrees(self, stroke: int) -> Number:
        """The crank angle of that dead centre: A points to B on the outstroke, away from it on the return."""
        if not self.ratio:
            return number(0 if stroke == OUT else 180)
        inner = degrees_of(*self.dead(OUT))
        if stroke == OUT:
            return inner
        outer = degrees_of(*self.dead(RETURN).times(number(-1)))
        return outer if outer.low > inner.low else outer + 360

    def way(self, end: Arrow, stroke: int) -> Arrow:
        """The direction in which B goes on a stroke, of length 1."""
        if self.rocker is None:
            return Arrow(number(-stroke), number(0))
        arm = end.minus(self.bearing).times(1 / number(self.rocker))
        return arm.right().times(number(stroke * self.right))

    def moved(self, end: Arrow, stroke: int) -> Any:
        """The way of B along its path since the dead centre, a jet by φ: on a rocker the arc."""
        if self.rocker is None:
            return (self.dead(stroke).x - end.x) * stroke
        turned = self.turned(end, stroke)
        return turned * number(self.rocker)

    def turned(self, end: Arrow, stroke: int) -> Jet:
        """The rocker's turn since the dead centre in radians, positive in the direction of the stroke."""
        arm, before = end.minus(self.bearing), self.dead(stroke).minus(self.bearing)
        sense = number(-stroke * self.right)
        # The angle from the one arm to the other, which is less than half a turn.
        value = degrees_of(before.dot(arm.value()), before.cross(arm.value())) * pi() / 180
        return Jet([value, *_integrated(slope_of_angle(*arm))]) * sense

    @property
    def stroke(self) -> Number:
        if not self.ratio:
            return number(2)
        if self.rocker is None:
            return self.dead(OUT).x - self.dead(RETURN).x
        return self.swing * pi() / 180 * self.rocker

    @property
    def swing(self) -> Number:
        before, after = (self.dead(one).minus(self.bearing) for one in (OUT, RETURN))
        return abs(degrees_of(before.dot(after), before.cross(after)))

    @property
    def omega(self) -> Number:
        return number(self.speed) * (2 * pi() if self.turns else 1)

    # Values.

    def value(
        self,
        key: str,
        degrees: Fraction | int | str = 0,
        method: str = "exact",
        *,
        order: int = 1,
        stroke: str | int | None = None,
        point: tuple[Any, Any] | None = None,
    ) -> Value:
        """Return what kurbel's column of this key says at an angle in degrees.

        `x_return_mm` is `x`, on the return, in mm; `stroke="return"` says the same. With a `point` (share of
        the rod from B, beside it) keys are those of points.
        """
        name, returning, unit = parted(key)
        side = RETURN if returning or stroke in (RETURN, "return") else OUT
        if "-" in method:
            method, _, kept = method.partition("-")
            order = int(kept)
        if method not in METHODS:
            raise ProblemError(f'there is no method "{method}"')
        if method == "difference":
            options: dict[str, Any] = {"order": order, "stroke": side, "point": point}
            return self.value(key, degrees, **options) - self.value(key, degrees, "series", **options)
        if not self.ratio and not self.parallel:
            method = "infinite"
        if point is not None:
            of_point = (Fraction(point[0]), Fraction(point[1]))
            return Value(lambda: self._point(name, unit, Fraction(degrees), of_point))
        return Value(lambda: self._value(name, unit, side, Fraction(degrees), method, order))

    def _value(self, name: str, unit: str, stroke: int, degrees: Fraction, method: str, order: int) -> Number:
        angle = degrees if stroke == OUT else degrees + 180
        if self.parallel:
            found = _parallel(name, self.pin(angle))
        elif name in _OF_DRIVE:
            found = _OF_DRIVE[name](self)
        elif name == "time":
            found = (angle - self.dead_degrees(stroke)) * pi() / 180 / self.omega
        elif name in _FORCES:
            found = self._force(name, angle, stroke, method)
        elif method == "exact":
            found = self._moving(name, angle, stroke)
        else:
            found = _approximate(name, self, angle, stroke, order if method == "series" else 0)
        return found * self._unit(unit)

    def _moving(self, name: str, degrees: Fraction, stroke: int) -> Number:
        pin, end = self.placed(degrees)
        rod = pin.minus(end)
        if name in _SLOPES:
            of, slope = _SLOPES[name]
            if of == "rod":
                # Against the crank's sense, from the direction of the slide.
                turn = -slope_of_angle(*rod)
                return turn.value if slope == 1 else turn.slope()
            way = self.moved(end, stroke) if of == "path" else self.turned(end, stroke)
            found: Number = way.slope(slope) if slope else way.value
            return found
        rod, place = rod.value(), end.value()
        if name == "fd":
            return self.rod + rod.x
        if name in ("psi", "rod"):
            return degrees_of(-rod.x, rod.y)
        moved = self.dead(stroke).minus(place).times(number(stroke))
        if name == "turn":
            return self.turned(end, stroke).value * 180 / pi()
        if name == "rocker":
            # From where the rocker is square to the slide direction.
            arm = place.minus(self.bearing).right().times(number(-self.right))
            return degrees_of(arm.x, arm.y)
        if name == "slant":
            tangent = self.way(place, OUT)
            return -degrees_of(tangent.dot(rod), tangent.cross(rod))
        return moved.size() if name == "chord" else moved.x if name == "slide_path" else -moved.y

    def _force(self, name: str, degrees: Fraction, stroke: int, method: str) -> Number:
        """A force of 1 on B in the direction of the stroke, which rod and guide hold."""
        if method == "infinite":
            crank, line = self.pin(degrees).value(), Arrow(number(-1), number(0))
            way = Arrow(number(-stroke), number(0))
        else:
            crank, place = (one.value() for one in self.placed(degrees))
            line, way = crank.minus(place).times(number(self.ratio)), self.way(place, stroke)
        # Along the path the rod alone holds it.
        thrust = 1 / line.dot(way)
        on_pin = line.times(thrust)
        if name == "rod_force":
            return thrust * stroke
        if name == "guide_force":
            return on_pin.dot(way.right())
        return -on_pin.dot(crank) if name == "radial_force" else crank.cross(on_pin)

    def _point(self, name: str, unit: str, degrees: Fraction, point: tuple[Fraction, Fraction]) -> Number:
        share, beside = (number(one) for one in point)

        def at(pin: Arrow, end: Arrow) -> Arrow:
            rod = pin.minus(end)
            return end.plus(rod.times(share)).plus(rod.right().times(beside))

        place = at(*self.placed(degrees))
        dead = self.dead(OUT)
        before = at(dead.times(1 / (self.rod + 1)), dead)
        quantity, _, part = name.partition("_")
        order = {"path": 0, "velocity": 1, "acceleration": 2}[quantity]
        arrow = place.slope(order) if order else place.value().minus(Arrow(before.x, number(0)))
        if part == "direction":
            found = degrees_of(*arrow)
            return found if found.is_zero or found.sign() >= 0 else found + 360
        return {"along": -arrow.x, "across": arrow.y, "": arrow.size()}[part] * self._unit(unit)

    def _unit(self, unit: str) -> Number:
        radius, omega = number(self.radius), self.omega
        return {
            "": lambda: number(1),
            "stroke": lambda: 1 / self.stroke,
            "percent": lambda: 100 / self.stroke,
            "mm": lambda: 1000 * radius,
            "mps": lambda: radius * omega,
            "mps2": lambda: radius * omega * omega,
            "radps": lambda: omega,
            "radps2": lambda: omega * omega,
            "n": lambda: number(self.force),
            "nm": lambda: number(self.force) * radius,
        }[unit]()


def drive(
    ratio: Fraction | str = Fraction(0),
    offset: Fraction | str | int = 0,
    *,
    rocker: Fraction | str | int | None = None,
    pivot: tuple[Any, Any] | None = None,
    circuit: int = 1,
    beam: Fraction | str | int | None = None,
    parallel: bool = False,
    radius: Fraction | str | int = 1,
    speed: Fraction | str | int = 1,
    turns: bool = False,
    force: Fraction | str | int = 1,
) -> Drive:
    """Return a drive as users describe it: "1:5", an offset in crank radii, a rocker, the arm of a beam.

    `radius` is in m, `speed` in rad/s, or with `turns` in 1/s, and `force` in N.
    """
    if isinstance(ratio, str):
        crank, _, rod = ratio.partition(":")
        ratio = Fraction(crank) / Fraction(rod or 1)
    arm = beam if rocker is None else rocker
    found = Drive(
        Fraction(ratio),
        Fraction(offset),
        None if arm is None else Fraction(arm),
        None if pivot is None else (Fraction(pivot[0]), Fraction(pivot[1])),
        circuit,
        beam is not None,
        parallel,
        Fraction(radius),
        Fraction(speed),
        turns,
        Fraction(force),
    )
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


# What many columns ask for is kept, with the bits it was computed with.


@lru_cache(maxsize=64)
def _placed(drive: Drive, degrees: Fraction, bits: int) -> tuple[Arrow, Arrow]:
    pin = drive.pin(degrees)
    return pin, drive.driven(pin)


@lru_cache(maxsize=64)
def _dead(drive: Drive, stroke: int, bits: int) -> Arrow:
    return drive.reached(SHAFT, drive.rod + stroke)


@lru_cache(maxsize=64)
def _beam_pivot(drive: Drive, bits: int) -> Arrow:
    """The beam's end swings from q above to q below; the vertical through the shaft halves its sagitta.

    With s half the sagitta and the beam level at the height h, (h + q)² + s² = (L + 1)² and
    (h - q)² + s² = (L - 1)²: their difference is h q = L, their mean L²/q² + q² + s² = L² + 1.
    """
    assert drive.rocker is not None
    arm, rod = number(drive.rocker), drive.rod

    def half_sagitta(chord: Any) -> Any:
        return (arm - (arm * arm - chord * chord).root()) / 2

    def misses(chord: Jet) -> Jet:
        aside = half_sagitta(chord)
        return rod * rod / (chord * chord) + chord * chord + aside * aside - (rod * rod + 1)

    chord = zero(misses, Fraction(1))
    return Arrow(rod / chord, arm - half_sagitta(chord))


def _integrated(slope: Jet) -> list[Any]:
    return [one / k for k, one in enumerate(slope.terms, 1)]


def _approximate(name: str, drive: Drive, degrees: Fraction, stroke: int, order: int) -> Number:
    """The straight crank by powers of λ up to an order, 0 of an infinitely long rod.

    λ is the variable of a series whose coefficients are series in φ: nothing is expanded by hand.
    """
    pin = drive.pin(degrees)
    nothing = pin.x * 0

    def powers(*terms: Any) -> Jet:
        return Jet([*terms, *(nothing for _ in range(order + 1))][: order + 1])

    sine = powers(nothing, pin.y)
    cosine = (1 - sine * sine).root()
    # L (1 - cos ψ) = λ sin² φ/(1 + cos ψ) in crank radii.
    versine = sine * powers(pin.y) / (1 + cosine)
    ratio = number(drive.ratio)
    if name == "fd":
        return versine.at(ratio).value
    if name == "psi":
        return drive._moving(name, degrees, stroke) if order else number(0)
    of, slope = _SLOPES[name]
    if of == "rod":
        by_angle = [Jet([one.derived() for one in series.terms]) for series in (cosine, sine)]
        turn = ((cosine * by_angle[1] - sine * by_angle[0]) / (cosine * cosine + sine * sine)).at(ratio)
        return turn.value if slope == 1 else turn.slope()
    path = 1 - pin.x + versine.at(ratio)
    if stroke == RETURN:
        path = 2 - path
    found: Number = path.slope(slope) if slope else path.value
    return found


def _parallel(name: str, pin: Arrow) -> Number:
    """Every point of the coupling rod runs as the crank pin, on a circle of its own."""
    place, velocity, acceleration = pin.value(), pin.slope(1), pin.slope(2)
    return {
        "coupler_path": 1 - place.x,
        "coupler_velocity": -velocity.x,
        "coupler_acceleration": -acceleration.x,
        "coupler_rise": place.y,
        "coupler_rise_velocity": velocity.y,
        "coupler_rise_acceleration": acceleration.y,
        "rod_velocity": number(0),
        "rod_acceleration": number(0),
        # A force of 1 against x.
        "tangential_force": place.y,
        "radial_force": place.x,
        "torque": place.y,
    }[name]


def _transmission(drive: Drive) -> Number:
    """The least angle between the rod and the square to the slide, or the rocker.

    The rod leans most where A is farthest from the line of the slide. Between rod and rocker it is least at
    an extreme of the distance from A to the pivot, that is where the crank lies in the line of centres.
    """
    if drive.rocker is None:
        lean = (1 + abs(number(drive.offset))) * drive.ratio
        return degrees_of(lean, (1 - lean * lean).root())
    rod, rocker, apart = drive.rod, number(drive.rocker), drive.bearing.size()
    cosines = [
        abs((rod * rod + rocker * rocker - (apart + side) * (apart + side)) / (2 * rod * rocker))
        for side in (1, -1)
    ]
    most = _greater(*cosines)
    return degrees_of(most, (1 - most * most).root())


def _greater(one: Number, other: Number) -> Number:
    ahead = (one - other).sign()
    return one if ahead >= 0 else other


def _lead(drive: Drive) -> Number:
    return drive.dead_degrees(RETURN) - drive.dead_degrees(OUT) - 180


_OF_DRIVE: dict[str, Callable[[Drive], Number]] = {
    "phi_i": lambda drive: drive.dead_degrees(OUT),
    "phi_o": lambda drive: drive.dead_degrees(RETURN),
    "lead": _lead,
    "time_ratio": lambda drive: (180 + _lead(drive)) / (180 - _lead(drive)),
    "stroke": lambda drive: drive.stroke,
    "swing": lambda drive: drive.swing,
    "transmission": _transmission,
    "outstroke_time": lambda drive: (180 + _lead(drive)) * pi() / 180 / drive.omega,
    "return_time": lambda drive: (180 - _lead(drive)) * pi() / 180 / drive.omega,
    # The mean over a turn of two strokes.
    "v": lambda drive: number(1),
    "c_m": lambda drive: drive.stroke / pi(),
    "v_c_m": lambda drive: pi() / drive.stroke,
}
_FORCES = ("rod_force", "guide_force", "tangential_force", "radial_force", "torque")
# What is a slope of what.
_SLOPES = {
    "x": ("path", 0),
    "c": ("path", 1),
    "p": ("path", 2),
    "path": ("path", 0),
    "velocity": ("path", 1),
    "acceleration": ("path", 2),
    "turn_velocity": ("turn", 1),
    "turn_acceleration": ("turn", 2),
    "rod_velocity": ("rod", 1),
    "rod_acceleration": ("rod", 2),
}
_POINTS = [
    *(f"{one}_{part}" for one in ("path", "velocity", "acceleration") for part in ("along", "across")),
    *("velocity_direction", "acceleration_direction"),
]
_COUPLER = ("path", "velocity", "acceleration", "rise", "rise_velocity", "rise_acceleration")
_NAMES = (
    *_OF_DRIVE, *_FORCES, *_SLOPES, *_POINTS, *(f"coupler_{one}" for one in _COUPLER),
    *("time", "fd", "psi", "rod", "turn", "rocker", "slant", "chord", "slide_path", "rise"),
)  # fmt: skip
