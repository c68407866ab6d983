"""Where an excess torque is zero, each place enclosed with a proof: there the speed may be greatest or least.

Straight lines alone have their zeros at rational angles. With waves the zeros are isolated by intervals; one
at a rational angle is proved to be there. Where there are waves alone, e^(iφ) at a zero is an algebraic
number, whose separation bound settles ties of what is computed there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import lcm, log2

from flint import arb

from kurbel.drive.at import known
from kurbel.engine.diagram.fluctuation import Extreme
from kurbel.engine.diagram.torque import TURN, Line, Torque, Waves
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball, pi
from kurbel.exact.kind import Kind, balls, floats
from kurbel.exact.place import fraction
from kurbel.exact.search import ISOLATING_BITS, LEAST_WIDTH, Function, interval, isolate
from kurbel.exact.search import Zero as Root
from kurbel.exact.separation import Separation
from kurbel.exact.terms import algebraic
from kurbel.kernel.circle import Numeric

# A zero at a rational angle is sought with denominators up to these, the simplest first.
DENOMINATORS = (1, 12, 3600)
RECOGNISING_BITS = 128
# A part of the turn at which no zero lies by intent; where a search begins should not be one.
OFF = Fraction(7, 1009)
# Units of the search in degrees, each of which ends at 2^-32 of it. About a sevenfold zero 64 bits leave 0.2°
# open, a thousand steps of the second: what the first leaves open is looked at in steps of the second only
# where it is not longer than this many of its own.
UNITS = (2**26, 2**20)
MOST_OPEN = 4
# Of a torque, and of the cosines in it: half a second of them.
MOST_CALLS, MOST_COSINES = 100_000, 1_000_000
# Derivatives beyond this one are not asked whether they vanish.
MOST_MULTIPLE = 8


@dataclass(frozen=True, eq=False)
class Zero:
    """An angle in degrees: exactly, or within an interval of a line, found anew at each precision."""

    exact: Fraction | None
    line: int = 0
    root: Root | None = None
    excess: Torque | None = None
    unit: int = 1

    def degrees(self, kind: Kind) -> Numeric:
        """Return the angle; of balls and floats, where it is not exact."""
        if self.exact is not None:
            return kind.of(self.exact)
        return kind.enclosed(self._ball)

    def _ball(self) -> arb:
        return known(self.root).place() * self.unit

    @property
    def is_open(self) -> bool:
        """Whether it possibly is none, or several."""
        return self.exact is None and known(self.root).rising is None

    def shifted(self, shift: Fraction, cycle: Fraction) -> Extreme:
        """Return the place so many degrees behind it, within a cycle."""
        if self.exact is not None:
            exact = (self.exact + shift) % cycle
            return Extreme(degrees=lambda kind: kind.of(exact), exact=exact)
        # The search of a period begins a little behind 0°, and ends so far behind its end.
        behind = shift - cycle if known(self.root).low * self.unit + shift >= cycle else shift
        return Extreme(degrees=lambda kind: self.degrees(kind) + kind.of(behind))

    def bounded_cosine(self, order: Fraction, phase: Fraction, base: Fraction, key: Polynomial) -> Separation:
        """Return the bound of cos(kφ + α) here, by that of e^(iφ k₀) for the base order k₀."""
        power = int(order / base)
        ray = Separation(key.size, key.size, key.order, frozenset({(self, key.degree)})) ** power
        turned = Separation(1, 0, lcm(4, (phase / TURN).denominator))
        return (ray * turned + ray * turned) / 2


def waves_at(waves: Waves, zero: Zero, of: Waves, kind: Kind) -> Numeric:
    """Return waves at a zero, of such waves, if it is not exact, where no lines are beside them."""
    if zero.exact is not None:
        return waves.at(zero.exact, kind)

    def bound() -> Separation | None:
        if zero.excess is None or not is_plain(zero.excess):
            return None
        key, total = Polynomial.of(of), Separation.rational(0)
        for amplitude, order, phase in waves.parts:
            cosine = zero.bounded_cosine(order, phase, of.base, key)
            total += Separation.rational(amplitude) * cosine
        return total

    return algebraic(kind, lambda: waves.within(ball(zero.degrees(balls()))), bound)


@dataclass(frozen=True)
class Polynomial:
    """What is known of the polynomial that e^(iφ k₀) is a zero of: the bits of its coefficients, algebraic
    integers of a cyclotomic field of this order, and its degree."""

    size: float
    order: int
    degree: int

    @classmethod
    def of(cls, waves: Waves) -> Polynomial:
        scale = lcm(*(2 * amplitude.denominator for amplitude in waves.amplitudes.values()))
        total = sum(abs(amplitude) * scale for amplitude in waves.amplitudes.values())
        order = lcm(4, *((phase / TURN).denominator for _, phase in waves.amplitudes))
        # By Cauchy a zero times the first coefficient is at most twice the greatest of them.
        return cls(1 + log2(int(total)), order, 2 * int(max(waves.orders) / waves.base))


def functions(excess: Torque, number: int, unit: int) -> tuple[Function, Function]:
    """Return the excess on one of its lines, and its slope, as functions of an angle in units, a ball."""
    waves, line = excess.waves, excess.lines[number]
    slope_of = waves.slope

    def torque(units: arb) -> arb:
        degrees = units * unit
        behind = degrees - ball(line.start)
        return waves.within(degrees) + ball(line.first) + ball(line.slope) * behind

    def slope(units: arb) -> arb:
        per_degree = slope_of.within(units * unit) * pi() / 180 + ball(line.slope)
        return per_degree * unit

    return torque, slope


def is_plain(excess: Torque) -> bool:
    """Whether it is waves alone."""
    return not any(one.first or one.slope for one in excess.lines)


def zeros(excess: Torque) -> list[Zero]:
    """Return where the excess is zero, with all corners and jumps; of waves alone within their period."""
    if not excess.waves:
        return [Zero(place) for place in sorted(set(_straight(excess.lines)))]
    if is_plain(excess):
        period = TURN / excess.waves.base
        return _distinct(_on_line(excess, 0, period * OFF, period * (1 + OFF)))
    found = [Zero(one.start) for one in excess.lines]
    for number, one in enumerate(excess.lines):
        found += _on_line(excess, number, one.start, one.end)
    return _distinct(found)


def over_cycle(found: Iterable[Zero], excess: Torque, cycle: Fraction) -> tuple[Extreme, ...]:
    """Return the places of zeros over a cycle in order, those of waves alone in each of their periods."""
    period = TURN / excess.waves.base if is_plain(excess) else cycle
    shifts = [period * times for times in range(int(cycle / period))]
    return tuple(sorted((one.shifted(shift, cycle) for one in found for shift in shifts), key=_angle))


def _angle(extreme: Extreme) -> float:
    return float(known(extreme.degrees)(floats()))


def _straight(lines: Iterable[Line]) -> Iterator[Fraction]:
    for one in lines:
        yield one.start
        if one.slope:
            place = one.start - one.first / one.slope
            if one.start < place < one.end:
                yield place


def _distinct(found: Iterable[Zero]) -> list[Zero]:
    """Return the zeros, exact ones once."""
    return [*{id(one) if one.exact is None else one.exact: one for one in found}.values()]


def _on_line(
    excess: Torque, number: int, start: Fraction, end: Fraction, unit: int = UNITS[0]
) -> Iterator[Zero]:
    torque, slope = functions(excess, number, unit)
    counted = _counted(torque, len(excess.waves.amplitudes))
    for root in isolate(counted, slope, start / unit, end / unit):
        zero = Zero(None, number, root.of(torque, slope), excess, unit)
        exact = _recognised(zero)
        is_open = exact is None and root.rising is None and unit != UNITS[-1]
        if is_open and root.high - root.low <= MOST_OPEN * LEAST_WIDTH:
            yield from _on_line(excess, number, root.low * unit, root.high * unit, UNITS[-1])
        else:
            yield zero if exact is None else Zero(exact)


def _counted(torque: Function, waves: int) -> Function:
    """Return the function of so many waves, which refuses to be asked without end."""
    calls = iter(range(min(MOST_CALLS, MOST_COSINES // max(waves, 1))))

    def asked(units: arb) -> arb:
        if next(calls, None) is None:
            raise ProblemError(
                "the torque has too many places at which it is just its load; give a formula with smaller"
                " powers and orders"
            )
        return torque(units)

    return asked


def _recognised(zero: Zero) -> Fraction | None:
    """Return the rational angle at which a zero is proved to lie, alone within its interval."""
    with at_bits(RECOGNISING_BITS):
        found = ball(zero.degrees(balls()))
        middle = fraction(found.mid())
        near = dict.fromkeys(middle.limit_denominator(most) for most in DENOMINATORS)
        within = [place for place in near if found.contains(ball(place))]
    return next((place for place in within if _is_alone(zero, place)), None)


def _is_alone(zero: Zero, place: Fraction) -> bool:
    """Whether the excess is zero at an angle, and nowhere else in the zero's interval.

    A zero that the signs isolate is one; of another as many derivatives vanish here as before the first that
    vanishes nowhere in the interval.
    """
    excess = known(zero.excess)
    waves, line = excess.waves, excess.lines[zero.line]
    if not waves.vanishes(place, line.value(place)):
        return False
    root = known(zero.root)
    if root.rising is not None:
        return True
    with at_bits(ISOLATING_BITS):
        whole = interval(root.low, root.high)
        _, slope = functions(excess, zero.line, zero.unit)
        if not slope(whole).contains(0):
            return True
        if line.slope:
            return False
        for _ in range(MOST_MULTIPLE):
            waves = waves.slope
            if not waves.within(whole * zero.unit).contains(0):
                return True
            if not waves.vanishes(place):
                return False
    return False
