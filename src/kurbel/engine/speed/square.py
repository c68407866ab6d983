"""The speed over the turn against a torque that goes with the square of the speed, in steady state.

With h = ½ J ω²/(P r) and τ = T/P, the equation of motion h' = τ - a h is linear in h; P is the mean torque,
for over a turn a h has the mean 1. With the excess work w, whose slope is τ - 1, its one periodic solution is
h = 1/a + w + y, where y = e^(-aθ) (y₀ - a V), V the integral of w e^(aθ) over the angle θ since the dead
centre and y₀ = -a V(Θ)/(e^(aΘ) - 1), of a cycle Θ. At every angle h falls as a grows: so does the number of
the flywheel, 2 h at the dead centre, and the mean speed. Interval Newton encloses the one a. Re-derived.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial, reduce
from typing import TYPE_CHECKING, Any

import flint
from flint import acb

from kurbel.drive.wheel import Wheel
from kurbel.engine.cylinder import Cylinder
from kurbel.engine.speed.integral import Integral
from kurbel.engine.speed.run import AnyRun, energy_before, energy_on
from kurbel.engine.speed.samples import first_decay
from kurbel.engine.turn import Extremum, Piece, Turn, place, stationary
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.continued import Continued
from kurbel.exact.place import fraction
from kurbel.exact.roots import ISOLATING_BITS, Root, interval, refined
from kurbel.kernel.circle import Number, root
from kurbel.kernel.steam import larger, smaller

if TYPE_CHECKING:
    from kurbel.engine.speed.lagging_clock import LaggingClock

# How far around its first value a is looked for, as a share of it, and so many times sixteen times as far.
NEAR, FARTHER = Fraction(1, 2**16), 3


class Decay:
    """The periodic solution of an a, a ball at the precision in force."""

    def __init__(self, turn: Turn, rate: Number) -> None:
        self.turn, self.rate, self.mean = turn, rate, turn.mean_force()
        self.first = turn.pieces[0].start
        self.before = before = energy_before(turn)

        def weighted(cylinders: Sequence[Cylinder], piece: Piece, at: Any) -> Any:
            return (energy_on(cylinders, piece, at) - before) / self.mean * self._lag(at).exp()

        self.lagged = Integral(turn, weighted)
        # That integral's growth with a.
        self.grown = Integral(turn, lambda *at: weighted(*at) * (at[2] - ball(self.first)) * flint.arb.pi())
        cycle = turn.cycle * flint.arb.pi()
        whole, more = self.lagged.whole * flint.arb.pi(), self.grown.whole * flint.arb.pi()
        power = (rate * cycle).exp()
        self.start = -rate * whole / (power - 1)
        self.start_growth = (
            -(whole + rate * more) / (power - 1) + rate * whole * cycle * power / (power - 1) ** 2
        )

    def _lag(self, at: Any) -> Any:
        """a θ at a place."""
        return (at - ball(self.first)) * (self.rate * flint.arb.pi())

    @property
    def at_dead_centre(self) -> Number:
        """h at the dead centre."""
        return 1 / self.rate + self._begun(self.start)

    @property
    def at_dead_centre_growth(self) -> Number:
        """How that grows with a."""
        return -1 / (self.rate * self.rate) + self._begun(self.start_growth)

    def _begun(self, value: Number) -> Number:
        """A value at the dead centre, of which that is known where the first piece begins."""
        gap = ball(self.lagged.gap) * flint.arb.pi() * self.rate
        return value + flint.arb(0, (2 * gap * (abs(value) + 1)).upper())

    def level(self, piece: Piece, at: Number) -> Number:
        """Return h at a place."""
        return 1 / self.rate + self.offset(piece, at)

    def continued(self, piece: Piece, place: Continued, about: Fraction) -> acb:
        """Return h on a complex ball around a place."""
        work = (energy_on(self.lagged.cylinders, piece, place) - self.before) / self.mean
        lag = self._lag(place)
        weighted = (work * lag.exp()).ball
        away = place.ball - acb(ball(about))
        lagged = (acb(self.lagged.to(about)) + away * weighted) * acb.pi()
        left = acb(self.start) - acb(self.rate) * lagged
        level: acb = acb(1 / self.rate) + work.ball + left * (-lag.ball).exp()
        return level

    def offset(self, piece: Piece, at: Number) -> Number:
        """Return w + y at a place."""
        return self.turn.energy(piece, at) / self.mean + self._left(piece, at) * (-self._lag(at)).exp()

    def growth(self, piece: Piece, at: Number) -> Number:
        """Return how h grows with a at a place."""
        angle = (at - ball(self.first)) * flint.arb.pi()
        grown = self._to(self.grown, piece, at, angle)
        left = self.start_growth - self._to(self.lagged, piece, at) - self.rate * grown
        left -= angle * self._left(piece, at)
        return -1 / (self.rate * self.rate) + left * (-self._lag(at)).exp()

    def _left(self, piece: Piece, at: Number) -> Number:
        """y₀ - a V at a place."""
        return self.start - self.rate * self._to(self.lagged, piece, at)

    def _to(self, integral: Integral, piece: Piece, at: Number, times: Number = 1) -> Number:
        """An integral over the angle up to a place, about whose middle it changes as its integrand says."""
        middle = at.mid()
        change = self.turn.energy(piece, at) / self.mean * self._lag(at).exp() * times
        whole = integral.to(max(fraction(middle), self.first)) + (at - middle) * change
        return whole * flint.arb.pi()


class SquareRun(AnyRun):
    """A turn against the square of the speed, in balls."""

    turn: Turn

    def __init__(self, turn: Turn, wheel: Wheel) -> None:
        super().__init__(turn, wheel)
        self._decays: dict[int, Decay] = {}
        self._clocks: dict[int, LaggingClock] = {}
        self._root = self._isolated()

    @property
    def decay(self) -> Decay:
        """The solution of the true a."""
        bits = flint.ctx.prec
        if bits not in self._decays:
            rate = refined(self._beyond, self._slope, self._root)
            self._root = Root(fraction(rate.lower()), fraction(rate.upper()), True)
            self._decays[bits] = Decay(self.turn, rate)
        return self._decays[bits]

    @property
    def number(self) -> Number:
        return 2 * self.decay.at_dead_centre

    def speed(self, half_turns: Fraction) -> Number:
        first = self.turn.pieces[0].start
        place = (half_turns - first) % self.turn.cycle + first
        piece = next(one for one in reversed(self.turn.pieces) if one.start <= place)
        return self._relative(self.decay.offset(piece, ball(place)))

    def speed_on(self, cylinders: Sequence[Cylinder], piece: Piece, place: Number) -> Number:
        return self._relative(self.decay.offset(piece, place))

    def turned(self, half_turns: Fraction) -> Number:
        from kurbel.engine.speed.lagging_clock import LaggingClock

        bits, decay = flint.ctx.prec, self.decay
        if bits not in self._clocks:
            self._clocks[bits] = LaggingClock(decay)
        return self._clocks[bits].time(half_turns) * root(decay.at_dead_centre)

    def extreme_place(self, greatest: bool) -> Number:
        return self._extremes(self.decay, greatest)[0][0]

    def extreme_speed(self, greatest: bool) -> Number:
        return self._relative(self._extreme(self.decay, greatest))

    def _relative(self, offset: Number) -> Number:
        """v/v₁ where w + y is such."""
        return root((1 / self.decay.rate + offset) / self.decay.at_dead_centre)

    def _isolated(self) -> Root:
        """Return two numbers between which a lies, for certain, and know the extremes between them."""
        start = first_decay(self)
        width = start * NEAR
        for _ in range(FARTHER):
            with flint.ctx.workprec(ISOLATING_BITS):
                decay = Decay(self.turn, interval(start - width, start + width))
                self._found = tuple(self._stationary(decay))
                ends = [self._beyond(ball(end)) for end in (start - width, start + width)]
            if ends[0] < 0 and ends[1] > 0:
                return Root(start - width, start + width, True)
            width *= 16
        raise ProblemError("the speed at the dead centre is not settled; give slightly other numbers")

    def _stationary(self, decay: Decay) -> Iterator[Extremum]:
        """Yield where the speed is least or greatest, for any a of a ball."""
        for piece in self.turn.pieces:
            yield from stationary(
                piece, partial(self._change, decay, piece), partial(self._bend, decay, piece)
            )

    def _change(self, decay: Decay, piece: Piece, at: Number) -> Number:
        """The slope of h over the angle, τ - a h."""
        return self.turn.excess(piece, at) / decay.mean - decay.rate * decay.offset(piece, at)

    def _bend(self, decay: Decay, piece: Piece, at: Number) -> Number:
        """The change of that with the half turns."""
        falling = decay.rate * flint.arb.pi() * self._change(decay, piece, at)
        return self.turn.slope(piece, at) / decay.mean - falling

    def _extremes(self, decay: Decay, greatest: bool) -> list[tuple[Number, Piece, Number]]:
        """Return the places where h may be greatest or least, their pieces, and w + y there."""
        sign, found = 1 if greatest else -1, []
        for one in self._found:
            if one.root.rising is not greatest:
                functions = (partial(each, decay, one.piece) for each in (self._change, self._bend))
                at = place(Extremum(one.piece, one.root, *functions))
                found.append((at, one.piece, decay.offset(one.piece, at)))
        return [one for one in found if not any(sign * one[2] < sign * other for _, _, other in found)]

    def _extreme(self, decay: Decay, greatest: bool) -> Number:
        return reduce(larger if greatest else smaller, (one for _, _, one in self._extremes(decay, greatest)))

    def _beyond(self, rate: Number) -> Number:
        """What is zero at the true a and rises with it."""
        decay = Decay(self.turn, rate)
        if self.wheel.number is not None:
            return self.turn.of(self.wheel.number) / 2 - decay.at_dead_centre
        ends = (root(1 / rate + self._extreme(decay, greatest)) for greatest in (True, False))
        return 1 - sum(ends) / root(2 * self.at_mean)

    def _slope(self, rate: Number) -> Number:
        """How that grows with a; the places of the extremes move, which does not matter."""
        decay = Decay(self.turn, rate)
        if self.wheel.number is not None:
            return -decay.at_dead_centre_growth
        total = flint.arb(0)
        for greatest in (True, False):
            growths = [
                decay.growth(piece, at) / (2 * root(1 / rate + offset))
                for at, piece, offset in self._extremes(decay, greatest)
            ]
            total -= reduce(lambda one, other: one.union(other), growths)
        return total / root(2 * self.at_mean)
