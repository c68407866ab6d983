"""A turn under a load: tangential force, mean, energy, and where the speed is least and greatest.

Angles are degrees of the first crank from the slide direction, as on the drives. Forces are in Q, lengths in
R, energies in Q R. What is proved, and how:

- The tangential force of one crank is T = F dx/dφ by virtual work, F the net force at the share of the stroke
  and x the way of B; that of several is their sum at φ less each one's angle. Both factors are enclosed.
- The work of a stroke up to a share s is S ∫F ds with the closed antiderivatives of `loads`, S the stroke in
  R; the mean P is the work of the cycle over its angle. Nothing is integrated by quadrature.
- Masses at constant speed take the slope of their energy: T - (E + U)', W - (E + U - E₀ - U₀), P as it was.
- W is stationary where T = P. T is Lipschitz (dx/dφ vanishes where F leaps), so T(X) lies in
  T(m) + T'(X)(X - m) with T'(X) the hull over corners. Cells of a partition of the cycle are halved until
  either this excludes P, or T' has one sign there and the ends tell whether T meets P once or never: no
  place is missed. Newton's interval then narrows each as far as asked.
- Cranks that come again when all are turned by an angle make a turn that comes again after it, of which one
  period is looked at; of alike places the first counts.
- The least and the greatest W are those of these places; a value is the hull of all that may be it.

Nothing is known here of indicator cards, friction, a speed that changes within the turn, and the angles by
Weisbach's own relations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import Any

from kurbel.errors import ProblemError
from kurbel.verify import enclose
from kurbel.verify.bodies import Bodies, stored
from kurbel.verify.drives import ORDER, OUT, RETURN, Drive
from kurbel.verify.jets import Jet, slope_of_angle, turned_by
from kurbel.verify.loads import Load, disc, hull
from kurbel.verify.numbers import Number, Undecided, number, pi, sine_cosine, spread
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value

# What an enclosure too wide for a cell raises.
TOO_WIDE = (Undecided, ZeroDivisionError, OverflowError, ValueError)
# Where cells begin, away from what machines are given by, cells of a turn, and the least half of one, in
# degrees.
START, COUNT, LEAST = Fraction(-13, 89), 48, Fraction(1, 2**40)
STROKES = ("outstroke", "return")
ZERO = Fraction(0)


@dataclass(frozen=True)
class Meeting:
    """A cell in which T meets P exactly once; the speed is least where T rises."""

    middle: Fraction
    half: Fraction
    rising: bool


@dataclass(frozen=True)
class Turn:
    """A drive under a load on each crank; with bodies and what Q is in N, their masses too."""

    drive: Drive
    load: Load
    cranks: tuple[Fraction, ...] = (Fraction(0),)
    method: str = "exact"
    bodies: Bodies | None = None
    bore: Fraction = Fraction(1)
    pressure: Fraction = Fraction(1)
    _kept: dict[Any, Any] = field(default_factory=dict, compare=False, repr=False)

    def value(self, key: str, degrees: Fraction | int | str = 0, *, stroke: str = "turn") -> Value:
        """Return what kurbel's column of this key says: `tangential` at an angle, `delta` of the cycle,
        `alpha_min` of it or of a stroke ("outstroke", "return"), whose angles count from its dead centre."""
        angle = Fraction(degrees)
        if key in _AT:
            return Value(lambda: _AT[key](self.known, angle))
        if key in _OF:
            return Value(lambda: _OF[key](self.known))
        if key not in _EXTREMES or stroke not in ("turn", *STROKES):
            raise ProblemError(f'there is no quantity "{key}" of a {stroke} to verify')
        return Value(lambda: _EXTREMES[key](self.known, stroke))

    def stationary(self, rising: bool | None = None) -> list[Value]:
        """Return the angles from the slide direction at which the speed is least, greatest, or either."""
        kept = [one for one in self.meetings if rising in (None, one.rising)]
        return [Value(partial(self._angle, one)) for one in kept]

    def _angle(self, one: Meeting) -> Number:
        return self.known.narrowed(one)[0]

    @property
    def known(self) -> Known:
        """What is known with the working bits."""
        bits = enclose.Working.bits
        if bits not in self._kept:
            self._kept[bits] = Known(self)
        found: Known = self._kept[bits]
        return found

    @property
    def meetings(self) -> list[Meeting]:
        if "meetings" not in self._kept:
            found: list[Meeting] = Value(lambda: number(0)).decided(lambda _: list(self.known.told_apart()))
            self._kept["meetings"] = sorted(found, key=lambda one: one.middle)
        kept: list[Meeting] = self._kept["meetings"]
        return kept


class Known:
    """Enclosures with the precision in force."""

    def __init__(self, turn: Turn) -> None:
        self.turn, self.drive = turn, turn.drive
        self.strokes = turn.load()
        self.cycle = 180 * len(self.strokes)
        self.period = repeated(turn.cranks, self.cycle)
        # Straight of infinite or first-order rods, whose way is a formula.
        self.flat = turn.method == "series" or not turn.drive.ratio
        self.inner = number(0) if self.flat else self.drive.dead_degrees(OUT)
        self.lead = number(180) if self.flat else self.drive.dead_degrees(RETURN) - self.inner
        self.size = number(2) if self.flat else self.drive.stroke
        self.whole = [stroke.work(number(1)) * self.size for stroke in self.strokes]
        self.total = sum(self.whole, number(0))
        self.mean = self.total * len(turn.cranks) / (pi() * self.cycle / 180)
        self.first = self._begun()
        self._excess: dict[Fraction, Number] = {}
        self._narrow: dict[Meeting, tuple[Number, Number]] = {}

    # One crank.

    def pin(
        self, degrees: Fraction, dead: bool = False, reach: Fraction = Fraction(0), order: int = 1
    ) -> Arrow:
        """The crank pin at an angle, or at one beyond the inner dead centre, with as many slopes."""
        if not dead or self.inner.is_zero:
            return self.drive.pin(degrees, order, reach)
        # At the dead centre it points to B.
        towards = self.drive.dead(OUT).times(1 / (self.drive.rod + 1))
        sine, cosine = sine_cosine(degrees)
        return Arrow(
            *turned_by(towards.y * cosine + towards.x * sine, towards.x * cosine - towards.y * sine, order)
        )

    def on(self, since: Number) -> list[tuple[int, int]]:
        """The strokes on which an angle since the inner dead centre may be, and the cycles before them."""
        turns = int((since.low + since.high) / 2 // self.cycle)
        since = since - turns * self.cycle
        found = []
        for index in range(-1, len(self.strokes) + 1):
            begin, end = (self.lead * (one % 2) + 360 * (one // 2) for one in (index, index + 1))
            if _sign(since - begin) in (0, 1, None) and _sign(since - end) in (-1, None):
                after, stroke = divmod(index, len(self.strokes))
                found.append((stroke, turns + after))
        return found

    def since(self, degrees: Fraction, dead: bool, reach: Fraction = Fraction(0)) -> Number:
        """Degrees from the inner dead centre."""
        angle = number(degrees) if not reach else spread(degrees - reach, degrees + reach)
        return angle if dead else angle - self.inner

    def speed(self, pin: Arrow, sense: int) -> Jet:
        """dx/dφ on a stroke."""
        if self.flat:
            lift = pin.y * pin.y * (self.drive.ratio / 2) - pin.x
            return lift.derived() * number(sense)
        end = self.drive.driven(pin)
        if self.drive.rocker is None:
            return end.x.derived() * number(-sense)
        return slope_of_angle(*end.minus(self.drive.bearing)) * number(
            -sense * self.drive.right * self.drive.rocker
        )

    def way(self, pin: Arrow, sense: int) -> Number:
        """x since the beginning of a stroke."""
        if self.flat:
            here = pin.value()
            gone = 1 - here.x + here.y * here.y * (self.drive.ratio / 2)
            return gone if sense == OUT else 2 - gone
        end = self.drive.driven(pin)
        if self.drive.rocker is None:
            return (self.drive.dead(sense).x - end.x.value) * sense
        found: Number = self.drive.moved(end, sense).value
        return found

    def one_force(self, degrees: Fraction, true: bool) -> Number:
        """T of one crank at its own angle; `true` with the rod's true angle on the path by first order."""
        pin, found = self.pin(degrees), []
        for index, _ in self.on(self.since(degrees, False)):
            sense = OUT if index % 2 == 0 else RETURN
            slope = self.speed(pin, sense).value
            if true and self.flat and self.drive.ratio:
                slope = self.drive.driven(pin).x.slope(1) * -sense
            found.append(self.strokes[index].force(self.way(pin, sense) / self.size) * slope)
        return hull(found)

    def one_slope(self, degrees: Fraction, reach: Fraction) -> Number:
        """dT/dφ = F'(s) x'²/S + F x'' of one crank over a cell."""
        point, wide, found = self.pin(degrees), self.pin(degrees, reach=reach, order=2), []
        arc = pi() / 180 * spread(-reach, reach)
        for index, _ in self.on(self.since(degrees, False, reach)):
            sense = OUT if index % 2 == 0 else RETURN
            speed = self.speed(wide, sense)
            share = (self.way(point, sense) + speed.value * arc) / self.size
            share = spread(max(share.low, Fraction(0)), max(min(share.high, Fraction(1)), Fraction(0)))
            stroke = self.strokes[index]
            changed = stroke.slope(share) * speed.value * speed.value / self.size
            found.append(changed + stroke.force(share) * speed.slope())
        return hull(found)

    def one_work(self, degrees: Fraction, dead: bool = False) -> Number:
        """The work of one crank since its inner dead centre of the first cycle."""
        pin, found = self.pin(degrees, dead), []
        for index, turns in self.on(self.since(degrees, dead)):
            sense = OUT if index % 2 == 0 else RETURN
            part = self.strokes[index].work(self.way(pin, sense) / self.size) * self.size
            found.append(sum(self.whole[:index], self.total * turns) + part)
        return hull(found)

    def masses(self, degrees: Fraction, dead: bool = False, reach: Fraction = Fraction(0)) -> Jet:
        """The energy of all masses in Q R."""
        bodies = self.turn.bodies
        assert bodies is not None
        unit = disc(self.turn.bore) * self.turn.pressure * self.drive.radius
        pins = (self.pin(degrees - crank, dead, reach, ORDER) for crank in self.turn.cranks)
        first, *rest = (stored(bodies, pin) * (1 / unit) for pin in pins)
        return sum(rest, first)

    # All cranks.

    def force(self, degrees: Fraction, true: bool = False) -> Number:
        total = sum((self.one_force(degrees - one, true) for one in self.turn.cranks), number(0))
        return total - self.masses(degrees).slope() if self.turn.bodies else total

    def slope(self, degrees: Fraction, reach: Fraction) -> Number:
        total = sum((self.one_slope(degrees - one, reach) for one in self.turn.cranks), number(0))
        return total - self.masses(degrees, reach=reach).slope(2) if self.turn.bodies else total

    def excess(self, degrees: Fraction) -> Number:
        if degrees not in self._excess:
            self._excess[degrees] = self.force(degrees) - self.mean
        return self._excess[degrees]

    def _begun(self) -> Number:
        """What is taken from the works so that they count from the first crank's inner dead centre."""
        nothing = [one for one in self.turn.cranks if one]
        total = sum((self.one_work(-one, True) for one in nothing), number(0))
        return total - self.masses(Fraction(0), True).value if self.turn.bodies else total

    def energy(self, degrees: Fraction) -> Number:
        """W since that dead centre."""
        done = sum((self.one_work(degrees - one) for one in self.turn.cranks), number(0))
        if self.turn.bodies:
            done = done - self.masses(degrees).value
        return done - self.first - self.mean * self.since(degrees, False) * pi() / 180

    # Where the speed is least and greatest.

    def told_apart(self) -> Iterator[Meeting]:
        """All places of a period at which T meets P, each in a cell of its own."""
        count = max(self.period * COUNT // 360, 1)
        half = self.period / count / 2
        cells = [(START + half * (2 * index + 1), half) for index in range(count)]
        while cells:
            middle, half = cells.pop()
            try:
                slope = self.slope(middle, half)
                reached = self.excess(middle) + slope * spread(-half, half) * pi() / 180
                if ZERO not in reached:
                    continue
                if ZERO not in slope:
                    before, after = (self.excess(middle + side * half).sign() for side in (-1, 1))
                    if before != after:
                        yield Meeting(middle, half, after > 0)
                    continue
            except TOO_WIDE:
                pass
            if half < LEAST:
                raise Undecided("a place at which the speed is stationary")
            cells += [(middle + side * half / 2, half / 2) for side in (-1, 1)]

    def narrowed(self, one: Meeting) -> tuple[Number, Number]:
        """The angle of a place from the slide direction, and the energy there."""
        if one not in self._narrow:
            point, reach = narrowed(self.excess, self.slope, one.middle, one.half)
            around = spread(-reach, reach) * pi() / 180
            off = (self.excess(point) + self.slope(point, reach) * around) * around
            self._narrow[one] = spread(point - reach, point + reach), self.energy(point) + off
        return self._narrow[one]

    def extremes(self, stroke: str, greatest: bool) -> list[tuple[Number, Number]]:
        """Those that may be the greatest or the least: angles from the span's dead centre, energies."""
        found = []
        for one in self.turn.meetings:
            if one.rising == greatest:
                continue
            angle, energy = self.narrowed(one)
            since = angle - self.inner
            since = since - int((since.low + since.high) / 2 // self.period) * self.period
            if stroke != "turn":
                late = (since - self.lead).sign() > 0
                if late != (stroke == "return"):
                    continue
                since = since - self.lead if late else since
            found.append((since, energy if greatest else -energy))
        if not found:
            raise ProblemError(f"on the {stroke} the speed has no such extreme to verify")
        best = max(energy.low for _, energy in found)
        return [(since, energy) for since, energy in found if energy.high >= best]

    def extreme_angle(self, stroke: str, greatest: bool) -> Number:
        found = self.extremes(stroke, greatest)
        if len(found) > 1:
            raise Undecided("which place has the extreme")
        return found[0][0]

    def extreme_energy(self, stroke: str, greatest: bool) -> Number:
        """The greatest of several numbers is between the greatest ends."""
        energies = [energy for _, energy in self.extremes(stroke, greatest)]
        best = spread(max(one.low for one in energies), max(one.high for one in energies))
        return best if greatest else -best

    def delta(self) -> Number:
        swing = self.extreme_energy("turn", True) - self.extreme_energy("turn", False)
        return swing / abs(self.mean)

    def cut_off(self, stroke: str) -> Number:
        """The angle from its dead centre at which a stroke's first pressure has its corner."""
        index = STROKES.index(stroke)
        sense, begin = (OUT, RETURN)[index], self.inner + self.lead * index
        share = self.strokes[index].sides[0][1].pieces[0][0]
        if share.rational == 1:
            return self.lead if sense == OUT else 360 - self.lead

        def short(degrees: Fraction) -> Number:
            return self.way(self.pin(degrees), sense) - share * self.size

        low, high = Fraction(float(begin)), Fraction(float(self.inner + (self.lead, number(360))[index]))
        for _ in range(30):
            middle = (low + high) / 2
            low, high = (low, middle) if float(short(middle)) > 0 else (middle, high)

        def speed(degrees: Fraction, reach: Fraction) -> Number:
            found: Number = self.speed(self.pin(degrees, reach=reach), sense).value
            return found

        point, reach = narrowed(short, speed, (low + high) / 2, Fraction(1, 1000))
        return spread(point - reach, point + reach) - begin

    def stage(self, first: bool) -> Number:
        """The work of the steam before the cut-off, or beyond it."""
        driving = self.strokes[0].sides[0][1]
        area, full = self.strokes[0].sides[0][0], driving.integral(driving.pieces[0][0])
        return (full if first else driving.integral(number(1)) - full) * area * self.size

    def back(self) -> Number:
        area, against = self.strokes[0].sides[1]
        return against.integral(number(1)) * -area * self.size


def narrowed(
    function: Callable[[Fraction], Number],
    slope: Callable[[Fraction, Fraction], Number],
    middle: Fraction,
    half: Fraction,
) -> tuple[Fraction, Fraction]:
    """Return a point and a reach about it, in degrees, that hold the one zero of a cell.

    Newton's steps within the cell find a point m; m - f(m)/f'(X) within X = m ± ε proves a zero in X.
    """
    bits, point, arc = enclose.Working.bits, middle, 180 / pi()
    low, high = middle - half, middle + half
    for _ in range(80):
        step = function(point) / slope(point, Fraction(1, 2**bits)) * arc
        moved = point - (step.low + step.high) / 2
        moved = Fraction(round(min(max(moved, low), high) * 2**bits), 2**bits)
        near, point = abs(moved - point) < Fraction(1, 2 ** (bits - 24)), moved
        if near:
            break
    for widening in range(bits - 24, 8, -8):
        reach = Fraction(1, 2**widening)
        try:
            off = function(point) / slope(point, reach) * arc
        except TOO_WIDE:
            continue
        bound = max(abs(off.low), abs(off.high))
        if bound < reach and low <= point - reach and point + reach <= high:
            return point, Fraction(int(bound * 2 ** (2 * bits)) + 1, 2 ** (2 * bits))
    raise Undecided("a zero")


def repeated(cranks: tuple[Fraction, ...], cycle: int) -> Fraction:
    """The least angle by which all cranks may be turned to stand as before."""
    stood = sorted(one % cycle for one in cranks)
    turned = (stood[-1] - one for one in stood[:-1])
    alike = [by for by in turned if by and sorted((one + by) % cycle for one in stood) == stood]
    return min(alike, default=Fraction(cycle))


def _sign(one: Number) -> int | None:
    try:
        return one.sign()
    except Undecided:
        return None


_AT: dict[str, Callable[[Known, Fraction], Number]] = {
    # The work over the angle: by first order T is that of the true rod.
    "power": lambda known, at: known.force(at),
    "tangential": lambda known, at: known.force(at, True),
    "tangential_excess": lambda known, at: known.force(at, True) - known.mean,
    "energy": lambda known, at: known.energy(at),
}
_OF: dict[str, Callable[[Known], Number]] = {
    "mean_force": lambda known: known.mean,
    "delta": lambda known: known.delta(),
    "full_pressure_work": lambda known: known.stage(True),
    "expansion_work": lambda known: known.stage(False),
    "back_work": lambda known: known.back(),
}
_EXTREMES: dict[str, Callable[[Known, str], Number]] = {
    "alpha_cutoff": lambda known, stroke: known.cut_off(stroke),
    "alpha_min": lambda known, stroke: known.extreme_angle(stroke, False),
    "alpha_max": lambda known, stroke: known.extreme_angle(stroke, True),
    "v_min": lambda known, stroke: known.extreme_energy(stroke, False),
    "v_max": lambda known, stroke: known.extreme_energy(stroke, True),
}


def turn(
    drive: Drive,
    load: Load,
    *,
    cranks: tuple[Any, ...] = (0,),
    method: str = "exact",
    bodies: Bodies | None = None,
    bore: Any = 1,
    pressure: Any = 1,
) -> Turn:
    """Return a drive under a load; `bore` in m and the pressure of Q in Pa weigh the bodies of each crank."""
    if method not in ("exact", "series") or (method == "series" and (drive.offset or drive.rocker)):
        raise ProblemError(f'no turn by the method "{method}" can be verified')
    angles = tuple(Fraction(one) for one in cranks)
    return Turn(drive, load, angles, method, bodies, Fraction(bore), Fraction(pressure))
