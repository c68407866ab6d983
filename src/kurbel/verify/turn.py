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
  place is missed. The sign of T - P then narrows each as far as asked.
- Cranks that come again when all are turned by an angle make a turn that comes again after it, of which one
  period is looked at; of alike places the first counts.
- The least and the greatest W are those of these places; a value is the hull of all that may be it.

By Weisbach the motion is that of first order, and the greatest speed where his cot ½α says, if it is beyond
the cut-off. Nothing is known here of a speed that changes within the turn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial, reduce

from kurbel.errors import ProblemError
from kurbel.verify.bodies import Bodies, energies
from kurbel.verify.crank import FIRST_ORDER, STROKES, Crank
from kurbel.verify.drives import Degrees, Drive, place_of, typed
from kurbel.verify.enclose import by_bits
from kurbel.verify.harmonics import Piece, pieces, wave
from kurbel.verify.jets import Jet
from kurbel.verify.loads import Load, disc
from kurbel.verify.numbers import Number, Undecided, largest, number, pi, sine_cosine
from kurbel.verify.places import OUT
from kurbel.verify.plane import Arrow
from kurbel.verify.value import Value
from kurbel.verify.zeros import Crossing, Place, around, between, told_apart

# Where cells begin, away from what machines are given by, and cells of a turn.
START, COUNT = Fraction(-13, 89), 48
ZERO = Fraction(0)


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

    def value(self, key: str, degrees: Degrees = 0, *, stroke: str = "turn") -> Value:
        """Return what kurbel's column of this key says: `tangential` at an angle, `delta` of the cycle,
        `alpha_min` of it or of a stroke ("outstroke", "return"), whose angles count from its dead centre."""
        if key in _AT:
            return Value(lambda: _AT[key](self.known, place_of(degrees)))
        if key in _OF:
            return Value(lambda: _OF[key](self.known))
        if key not in _EXTREMES or stroke not in ("turn", *STROKES):
            raise ProblemError(f'there is no quantity "{key}" of a {stroke} to verify')
        return Value(lambda: _EXTREMES[key](self.known, stroke))

    def stationary(self, rising: bool | None = None) -> list[Value]:
        """Return the angles from the slide direction at which the speed is least, greatest, or either."""
        kept = [one for one in self.meetings if rising in (None, one.rising)]
        return [Value(partial(self._angle, one)) for one in kept]

    def _angle(self, one: Crossing) -> Number:
        return self.known.narrowed(one)[0]

    @property
    @by_bits
    def known(self) -> Known:
        """What is known with the working bits."""
        return Known(self)

    @cached_property
    def meetings(self) -> list[Crossing]:
        return sorted(Value(lambda: number(0)).decided(lambda _: list(self.known.told_apart())))


class Known:
    """Enclosures with the precision in force."""

    def __init__(self, turn: Turn) -> None:
        self.turn, self.drive = turn, turn.drive
        self.crank = Crank(turn.drive, turn.load, turn.method)
        self.period = repeated(turn.cranks, self.crank.cycle)
        self.mean = self.crank.total * len(turn.cranks) / (pi() * self.crank.cycle / 180)
        self.first = self._begun()

    def masses(self, at: Place, order: int = 2, dead: bool = False) -> Jet:
        """The energy of the masses of a crank in Q R, at its own angle."""
        if self.turn.bodies is None:
            return Jet([number(0)] * (order + 1))
        moved, risen = energies(self.turn.bodies, self.crank.pin(at, order + 1, dead), at)
        return (moved + risen) * (1 / self.unit)

    @property
    def unit(self) -> Number:
        """What Q R is in N m."""
        return disc(self.turn.bore) * self.turn.pressure * self.drive.radius

    def effort(self, at: Place, order: int, true: bool) -> Jet:
        """The turning force of the masses of a crank: what their energy loses; `true` that of a series with
        the rod's true angle."""
        if true and self.turn.method == "series" and self.turn.bodies is not None:
            return self.turn.bodies.course("torque", at, OUT, order) * (1 / self.unit)
        return -self.masses(at, order + 1).derived()

    def force(self, at: Place, order: int = 0, true: bool = False) -> Number:
        """T of all cranks, or a slope of it over a cell."""
        own = (at.turned(-one) for one in self.turn.cranks)
        parts = (self.crank.course(one, order, true) + self.effort(one, order, true) for one in own)
        return sum((one.slope(order) for one in parts), number(0))

    @by_bits
    def excess(self, at: Place) -> Number:
        return self.force(at) - self.mean

    def _begun(self) -> Number:
        """What is taken from the works so that they count from the first crank's inner dead centre."""
        own = (Place(-one) for one in self.turn.cranks)
        works = (
            (self.crank.work(one, True) if one.degrees else ZERO) - self.masses(one, 1, True).value
            for one in own
        )
        return sum(works, number(0))

    def energy(self, near: Place) -> Number:
        """W since that dead centre."""
        at = Place(near.degrees)
        own = (at.turned(-one) for one in self.turn.cranks)
        done = sum((self.crank.work(one) - self.masses(one, 1).value for one in own), number(0))
        whole = done - self.first - self.mean * (at.angle - self.crank.inner) * pi() / 180
        return whole + (self.excess(at) + self.force(near, 1) * near.arc) * near.arc if near.reach else whole

    @cached_property
    def _series(self) -> list[Piece]:
        """T of one crank with its masses, by its own angle."""

        def course(at: Place, order: int) -> Jet:
            return self.crank.course(at, order, true=True) + self.effort(at, order, true=True)

        return list(pieces(course, self.crank.breaks))

    @by_bits
    def harmonic(self, order: Fraction, cranks: tuple[Fraction, ...]) -> Arrow:
        """a and b of T = P + Σ (a cos kφ + b sin kφ), of some of the cranks."""
        one = wave(self._series, order).rotated(star(cranks, order))
        return one.times(360 / (pi() * self.crank.cycle))

    # Where the speed is least and greatest.

    def told_apart(self) -> Iterator[Crossing]:
        """All places of a period at which T meets P, each in a cell of its own; the speed is least where T
        rises."""
        half = self.period / 2
        cells = Place(START + half, half).parts(int(max(self.period * COUNT // 360, 1)))
        return told_apart(lambda at, more: self.force(at, 1) if more else self.excess(at), cells)

    @by_bits
    def narrowed(self, one: Crossing) -> tuple[Number, Number]:
        """The angle of a place from the slide direction, and the energy there."""
        at = between(self.excess, *one.cell.ends)
        if self.turn.method == "weisbach" and not one.rising:
            at = self._of_cotangent(int(at.degrees // 180)) or at
        return at.angle, self.energy(at)

    def _of_cotangent(self, index: int) -> Place | None:
        """Where on a stroke cot ½α = (1 + ln ε - ε b)/(π (1 ± λ sin² ½α - ε b sin² ½α (1 ∓ λ cos α))), upper
        signs on the return, if that is beyond the cut-off (Weisbach-Herrmann, § 150)."""
        (_, driving), (_, against) = self.crank.strokes[index % 2].sides
        begin, epsilon = Fraction(180 * index), 1 / driving.pieces[0][0]
        if self.excess(around(self.crank.cut_off(STROKES[index % 2]) + begin)).sign() < 0:
            return None
        lost, ratio = epsilon * against.value(number(0)), self.drive.ratio * (-1) ** index

        def missed(at: Place) -> Number:
            sine, cosine = sine_cosine(at.degrees / 2, at.reach / 2)
            square = sine * sine
            lever = 1 + (1 - 2 * square) * ratio
            return (1 + epsilon.log() - lost) * sine - pi() * cosine * (
                1 - square * ratio - lost * square * lever
            )

        return between(missed, ZERO, Fraction(180)).turned(begin)

    def extremes(self, stroke: str, greatest: bool) -> list[tuple[Number, Number]]:
        """Those that may be the greatest or the least: angles from the span's dead centre, energies."""
        found = []
        for one in self.turn.meetings:
            if one.rising == greatest:
                continue
            angle, energy = self.narrowed(one)
            since = angle - self.crank.inner
            since = since - int(since.middle // self.period) * self.period
            if stroke != "turn":
                late = (since - self.crank.lead).sign() > 0
                if late != (stroke == "return"):
                    continue
                since = since - self.crank.lead if late else since
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
        best = largest([energy for _, energy in self.extremes(stroke, greatest)])
        return best if greatest else -best

    def delta(self) -> Number:
        swing = self.extreme_energy("turn", True) - self.extreme_energy("turn", False)
        return swing / abs(self.mean)


def star(cranks: tuple[Fraction, ...], order: Fraction) -> Arrow:
    """The sum of rays at k times the angles of the cranks."""
    rays = (sine_cosine(order * one)[::-1] for one in cranks)
    return reduce(Arrow.plus, (Arrow(*one) for one in rays))


def repeated(cranks: tuple[Fraction, ...], cycle: int) -> Fraction:
    """The least angle by which all cranks may be turned to stand as before."""
    stood = sorted(one % cycle for one in cranks)
    turned = (stood[-1] - one for one in stood[:-1])
    alike = [by for by in turned if by and sorted((one + by) % cycle for one in stood) == stood]
    return min(alike, default=Fraction(cycle))


@dataclass(frozen=True)
class Running:
    """A flywheel on a turn: v/v₁ = √(1 + 2 W/(m₁ v₁²)), of the energy of the wheel alone.

    `times` is m₁ v₁² in P R; or J, the mean ½(ω_max + ω_min) = ω and the power N are given. P R is N/ω, the
    energies are a and b above that of v₁, ω_max² - ω_min² = 2 (a - b)/J, and by this and their sum both are
    known, by either v₁.
    """

    turn: Turn
    number: Fraction | None = None
    inertia: Fraction = Fraction(0)
    power: Fraction = Fraction(0)

    @property
    def times(self) -> Number:
        if self.number is not None:
            return number(self.number)
        if self.turn.method == "weisbach":
            raise ProblemError("a flywheel's number by Weisbach is not computed a second time")
        omega, mean = self.turn.drive.omega, abs(self.turn.known.mean)
        top, bottom = (self.turn.known.extreme_energy("turn", one) / mean for one in (True, False))
        unit = self.power / omega / self.inertia
        highest = omega + (top - bottom) * unit / (2 * omega)
        return highest * highest / unit - top * 2

    def speed(self, energy: Number) -> Number:
        gained = energy / (self.times * abs(self.turn.known.mean))
        return 1 + gained if self.turn.method == "weisbach" else (1 + 2 * gained).root()

    def extreme(self, greatest: bool) -> Number:
        return self.speed(self.turn.known.extreme_energy("turn", greatest))


_AT: dict[str, Callable[[Known, Place], Number]] = {
    # The work over the angle: by first order T is that of the true rod.
    "power": lambda known, at: known.force(at),
    # Of the first crank, towards the shaft.
    "piston_force": lambda known, at: known.crank.push(at).value,
    "tangential": lambda known, at: known.force(at, true=True),
    "tangential_excess": lambda known, at: known.force(at, true=True) - known.mean,
    "energy": lambda known, at: known.energy(at),
}
_OF: dict[str, Callable[[Known], Number]] = {
    "mean_force": lambda known: known.mean,
    "delta": lambda known: known.delta(),
    "full_pressure_work": lambda known: known.crank.stage(True),
    "expansion_work": lambda known: known.crank.stage(False),
    "back_work": lambda known: known.crank.back(),
}
_EXTREMES: dict[str, Callable[[Known, str], Number]] = {
    "alpha_cutoff": lambda known, stroke: known.crank.cut_off(stroke),
    "alpha_min": lambda known, stroke: known.extreme_angle(stroke, False),
    "alpha_max": lambda known, stroke: known.extreme_angle(stroke, True),
    "v_min": lambda known, stroke: known.extreme_energy(stroke, False),
    "v_max": lambda known, stroke: known.extreme_energy(stroke, True),
}


def turn(drive: Drive, load: Load, *, method: str, **given: object) -> Turn:
    """Return a drive under a load; `bore` in m and the pressure of Q in Pa weigh the bodies of each crank."""
    if method not in ("exact", *FIRST_ORDER) or (method != "exact" and (drive.offset or drive.rocker)):
        raise ProblemError(f'no turn by the method "{method}" can be verified')
    return Turn(drive, load, method=method, **typed(given))
