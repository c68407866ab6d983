"""One crank under its load: the force at its pin, the slope of that, and the work since its dead centre."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from kurbel.verify.drives import Drive
from kurbel.verify.jets import Jet, hulled, turned_by
from kurbel.verify.loads import Load, Stroke
from kurbel.verify.numbers import Number, hull, number, sine_cosine
from kurbel.verify.places import OUT, RETURN
from kurbel.verify.plane import Arrow
from kurbel.verify.zeros import Place, between

STROKES = ("outstroke", "return")
# By Weisbach angles of his own belong to the motion of first order.
FIRST_ORDER = ("series", "weisbach")


class Crank:
    """Enclosures with the precision in force; angles are those of the crank itself."""

    def __init__(self, drive: Drive, load: Load, method: str) -> None:
        self.drive, self.strokes = drive, load()
        self.cycle = 180 * len(self.strokes)
        # Straight of infinite or first-order rods, whose way is a formula.
        self.flat = method in FIRST_ORDER or not drive.ratio
        self.inner = number(0) if self.flat else drive.dead_degrees(OUT)
        self.lead = number(180) if self.flat else drive.dead_degrees(RETURN) - self.inner
        self.size = number(2) if self.flat else drive.stroke
        self.whole = [stroke.work(number(1)) * self.size for stroke in self.strokes]
        self.total = sum(self.whole, number(0))

    def pin(self, at: Place, order: int = 1, dead: bool = False) -> Arrow:
        """The crank pin at an angle, or at one beyond the inner dead centre, with as many slopes."""
        if not dead or self.inner.is_zero:
            return self.drive.pin(at.degrees, order, at.reach)
        # At the dead centre it points to B.
        towards = self.drive.dead(OUT).times(1 / (self.drive.rod + 1))
        sine, cosine = sine_cosine(at.degrees)
        return Arrow(
            *turned_by(towards.y * cosine + towards.x * sine, towards.x * cosine - towards.y * sine, order)
        )

    def on(self, at: Place, dead: bool = False) -> Iterator[tuple[Stroke, int, Number]]:
        """The strokes on which an angle may be, their senses, and the work of all before them since the inner
        dead centre."""
        since = at.angle if dead else at.angle - self.inner
        turns = int(since.middle // self.cycle)
        since = since - turns * self.cycle
        for index in range(-1, len(self.strokes) + 1):
            begin, end = (self.lead * (one % 2) + 360 * (one // 2) for one in (index, index + 1))
            if (since - begin).side() != -1 and (since - end).side() in (-1, None):
                after, stroke = divmod(index, len(self.strokes))
                before = sum(self.whole[:stroke], self.total * (turns + after))
                yield self.strokes[stroke], RETURN if stroke % 2 else OUT, before

    def moved(self, pin: Arrow, sense: int) -> Jet:
        """x since the beginning of a stroke."""
        if not self.flat:
            return self.drive.moved(self.drive.driven(pin), sense)
        gone: Jet = 1 - pin.x + pin.y * pin.y * (self.drive.ratio / 2)
        return gone if sense == OUT else 2 - gone

    def share(self, pin: Arrow, sense: int) -> Number:
        return self.moved(pin, sense).value / self.size

    def _pressed(
        self, at: Place, moved: Jet, stroke: Stroke, sense: int, order: int, near: Number | None = None
    ) -> Jet:
        """F of the share of a stroke that is gone, with as many slopes."""
        share = moved * (1 / self.size)
        if at.reach:
            middle = self.share(self.pin(Place(at.degrees), 0), sense)
            share = Jet([middle + share.terms[1] * at.arc, *share.terms[1:]])
        return stroke.course(Jet(share.terms[: order + 1]), near)

    def course(self, at: Place, order: int, true: bool = False) -> Jet:
        """T at its own angle with as many slopes: F times dx/dφ; `true` with the rod's true angle on the path
        by first order."""
        pin, found = self.pin(at, order + 1), []
        for stroke, sense, _ in self.on(at):
            moved = self.moved(pin, sense)
            way = moved.derived()
            if true and self.flat and self.drive.ratio:
                way = self.drive.driven(pin).x.derived() * -sense
            found.append(self._pressed(at, moved, stroke, sense, order) * way)
        return hulled(found)

    def push(self, at: Place, order: int = 0, of: Place | None = None) -> Jet:
        """The force on the piston towards the shaft, at its own angle; of the stroke and of the piece of each
        pressure at another angle, if that is given."""
        pin, found = self.pin(at, order + 1), []
        for stroke, sense, _ in self.on(of or at):
            near = self.share(self.pin(of, 0), sense) if of else None
            found.append(self._pressed(at, self.moved(pin, sense), stroke, sense, order, near) * sense)
        return hulled(found)

    def work(self, at: Place, dead: bool = False) -> Number:
        """The work since its inner dead centre of the first cycle."""
        pin = self.pin(at, dead=dead)
        return hull(
            [
                before + stroke.work(self.share(pin, sense)) * self.size
                for stroke, sense, before in self.on(at, dead)
            ]
        )

    def begin(self, index: int) -> Number:
        """The angle at which a stroke of a cycle begins, or the next one of its end."""
        return self.inner + self.lead * (index % 2) + 360 * (index // 2)

    def corner(self, index: int, share: Number) -> Number:
        """The angle at which so much of a stroke is gone."""
        if share.rational == 1:
            return self.begin(index + 1)
        ends = (Fraction(float(self.begin(one))) for one in (index, index + 1))
        sense = RETURN if index % 2 else OUT
        return between(lambda at: self.share(self.pin(at), sense) - share, *ends).angle

    def cut_off(self, stroke: str) -> Number:
        """The angle from its dead centre at which a stroke's first pressure has its corner."""
        index = STROKES.index(stroke)
        return self.corner(index, self.strokes[index].sides[0][1].pieces[0][0]) - self.begin(index)

    @property
    def breaks(self) -> list[Number]:
        """Where the force on the piston is not smooth, in a cycle from its beginning to its end."""
        found = [self.begin(len(self.strokes))]
        for index, stroke in enumerate(self.strokes):
            ends = {float(end): end for _, one in stroke.sides for end, _ in one.pieces[:-1]}
            found += [self.begin(index), *(self.corner(index, end) for end in ends.values())]
        return sorted(found, key=float)

    def stage(self, first: bool) -> Number:
        """The work of the steam before the cut-off, or beyond it."""
        driving = self.strokes[0].sides[0][1]
        area, full = self.strokes[0].sides[0][0], driving.integral(driving.pieces[0][0])
        return (full if first else driving.integral(number(1)) - full) * area * self.size

    def back(self) -> Number:
        area, against = self.strokes[0].sides[1]
        return against.integral(number(1)) * -area * self.size
