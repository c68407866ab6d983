"""Where the pins of a drive are, and how its driven end moves.

Lengths are in crank radii. The shaft is at (0, 0), the crank pin A at φ from the slide direction, B the
driven end of the rod. A stroke's angle counts from 0° on the outstroke and from 180° on the return; the way
of B is positive in the direction of the stroke.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.verify.enclose import by_bits
from kurbel.verify.jets import Jet, angle_of, slope_of_angle, turning
from kurbel.verify.numbers import Number, degrees_of, number, pi
from kurbel.verify.plane import Arrow, circle_meets_circle, circle_meets_level
from kurbel.verify.zeros import Place, between

OUT, RETURN = 1, -1
# Slopes that a jet has.
ORDER = 3
SHAFT = Arrow(number(0), number(0))


@dataclass(frozen=True)
class Places:
    """A crank with a rod whose end B a slide guides at the level `offset`, or a rocker about a pivot."""

    ratio: Fraction
    offset: Fraction = Fraction(0)
    rocker: Fraction | None = None
    pivot: tuple[Fraction, Fraction] | None = None
    circuit: int = 1
    beam: bool = False

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
            return self._beam_pivot()
        assert self.rocker is not None
        if self.pivot is None:
            return Arrow(self.rod, number(self.offset + self.rocker))
        return Arrow(*map(number, self.pivot))

    def pin(self, degrees: Fraction, order: int = ORDER, reach: Fraction = Fraction(0)) -> Arrow:
        return Arrow(*turning(degrees, order, reach))

    def driven(self, pin: Arrow) -> Arrow:
        """Where B is."""
        return self.reached(pin, self.rod)

    @by_bits
    def placed(self, place: Place, order: int = ORDER) -> tuple[Arrow, Arrow]:
        """A and B at an angle, with so many slopes."""
        pin = self.pin(place.degrees, order, place.reach)
        return pin, self.driven(pin)

    def reached(self, centre: Arrow, reach: Number) -> Arrow:
        if self.rocker is None:
            return circle_meets_level(centre, reach, number(self.offset))
        return circle_meets_circle(centre, reach, self.bearing, number(self.rocker), self.right)

    @by_bits
    def dead(self, stroke: int) -> Arrow:
        """Where B is at the dead centre from which a stroke begins: crank and rod in one line, L + 1 or L - 1
        from the shaft. Seen from the shaft it is on the same side of the pivot as from A, for A is on the
        line through B and the shaft, before B."""
        return self.reached(SHAFT, self.rod + stroke)

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

    def moved(self, end: Arrow, stroke: int) -> Jet:
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
        if len(arm.x.terms) == 1:
            return Jet([value * sense])
        return angle_of(value, slope_of_angle(*arm)) * sense

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

    @by_bits
    def _beam_pivot(self) -> Arrow:
        """The beam's end swings from q above to q below; the vertical through the shaft halves its sagitta.

        With s half the sagitta and the beam level at the height h, (h + q)² + s² = (L + 1)² and
        (h - q)² + s² = (L - 1)²: their difference is h q = L, their mean L²/q² + q² + s² = L² + 1. The lesser
        q is between 1, where s² is left, and √L, where the first two are least.
        """
        assert self.rocker is not None
        arm, rod = number(self.rocker), self.rod

        def half_sagitta(chord: Number) -> Number:
            return (arm - (arm * arm - chord * chord).root()) / 2

        def misses(at: Place) -> Number:
            chord, aside = at.angle, half_sagitta(at.angle)
            return rod * rod / (chord * chord) + chord * chord + aside * aside - (rod * rod + 1)

        chord = between(misses, Fraction(1), min(self.rocker, rod.root().middle)).angle
        return Arrow(rod / chord, arm - half_sagitta(chord))
