"""One crank under its load: the force at its pin, the slope of that, and the work since its dead centre."""

from __future__ import annotations

from fractions import Fraction

from kurbel.verify.drives import Drive
from kurbel.verify.jets import Jet, slope_of_angle, turned_by
from kurbel.verify.loads import Load, hull
from kurbel.verify.numbers import Number, Undecided, number, pi, sine_cosine, spread
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow
from kurbel.verify.zeros import narrowed

STROKES = ("outstroke", "return")


class Crank:
    """Enclosures with the precision in force; angles are those of the crank itself."""

    def __init__(self, drive: Drive, load: Load, method: str) -> None:
        self.drive, self.strokes = drive, load()
        self.cycle = 180 * len(self.strokes)
        # Straight of infinite or first-order rods, whose way is a formula.
        self.flat = method == "series" or not drive.ratio
        self.inner = number(0) if self.flat else drive.dead_degrees(OUT)
        self.lead = number(180) if self.flat else drive.dead_degrees(RETURN) - self.inner
        self.size = number(2) if self.flat else drive.stroke
        self.whole = [stroke.work(number(1)) * self.size for stroke in self.strokes]
        self.total = sum(self.whole, number(0))

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

    def force(self, degrees: Fraction, true: bool, reach: Fraction = Fraction(0)) -> Number:
        """T at its own angle; `true` with the rod's true angle on the path by first order."""
        pin, found = self.pin(degrees, reach=reach), []
        for index, _ in self.on(self.since(degrees, False, reach)):
            sense = OUT if index % 2 == 0 else RETURN
            slope = self.speed(pin, sense).value
            if true and self.flat and self.drive.ratio:
                slope = self.drive.driven(pin).x.slope(1) * -sense
            found.append(self.strokes[index].force(self.way(pin, sense) / self.size) * slope)
        return hull(found)

    def push(self, degrees: Fraction, reach: Fraction = Fraction(0)) -> Number:
        """The force on the piston towards the shaft, at its own angle."""
        pin, found = self.pin(degrees, reach=reach), []
        for index, _ in self.on(self.since(degrees, False, reach)):
            sense = OUT if index % 2 == 0 else RETURN
            found.append(self.strokes[index].force(self.way(pin, sense) / self.size) * sense)
        return hull(found)

    def slope(self, degrees: Fraction, reach: Fraction) -> Number:
        """dT/dφ = F'(s) x'²/S + F x'' over a cell."""
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

    def work(self, degrees: Fraction, dead: bool = False) -> Number:
        """The work since its inner dead centre of the first cycle."""
        pin, found = self.pin(degrees, dead), []
        for index, turns in self.on(self.since(degrees, dead)):
            sense = OUT if index % 2 == 0 else RETURN
            part = self.strokes[index].work(self.way(pin, sense) / self.size) * self.size
            found.append(sum(self.whole[:index], self.total * turns) + part)
        return hull(found)

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


def _sign(one: Number) -> int | None:
    try:
        return one.sign()
    except Undecided:
        return None
