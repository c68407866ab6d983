"""A turn of the engine in ball arithmetic: all places where its speed is least or greatest, with proof.

Angles are half turns from the inner dead centre of the first crank, 0 to 2. Between two dead centres, of
whatever cranks, the excess of the tangential forces over their mean is one smooth formula but for the
cut-offs; such a piece is where zeros are searched.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property, partial, reduce
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeAlias

import flint

from kurbel.drive.crank_forces import CrankForce, Weights
from kurbel.engine.engine import Engine
from kurbel.engine.quantities import Peak
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball, ball_circle
from kurbel.exact.roots import ISOLATING_BITS, Function, Root, isolate, refined
from kurbel.kernel import inertia, steam, turning
from kurbel.kernel.circle import Circle
from kurbel.kernel.kinds import Number, larger, smaller
from kurbel.kernel.rod import Loaded
from kurbel.kernel.turning import Motion, Stroke
from kurbel.motion.evaluation import OUT, RETURN

if TYPE_CHECKING:
    from kurbel.engine.card_turn import CardTurn

CUT_OFF = {
    "exact": steam.crank_versine,
    "series": steam.crank_versine_first_order,
    "weisbach": steam.crank_versine_first_order,
}
MOTIONS = {"exact": turning.EXACT, "series": turning.FIRST_ORDER, "weisbach": turning.FIRST_ORDER}
# Two speeds that agree to so many bits are taken for equal, as on the two strokes of the infinite rod.
EQUAL_BITS = 200


class BallStroke(Stroke, Protocol):
    """A stroke that also knows the change of its force with the share."""

    def slope(self, share: Number) -> Number: ...


class SteamStroke(NamedTuple):
    """The net pressure of steam over the share of a stroke, in balls."""

    steam: steam.Expansion[Number]

    def force(self, share: Number) -> Number:
        return steam.net_pressure(share, self.steam)

    def work(self, share: Number) -> Number:
        return steam.net_work(share, self.steam)

    def slope(self, share: Number) -> Number:
        """The change of the force with the share; over the cut-off a ball that holds both sides."""
        if share < self.steam.cut_off:
            return flint.arb(0)
        beyond = steam.expansion_slope(share, self.steam)
        return beyond if share > self.steam.cut_off else beyond.union(flint.arb(0))


class IdleStroke(NamedTuple):
    """A stroke on which no net pressure acts."""

    def force(self, share: Number) -> Number:
        return flint.arb(0)

    def work(self, share: Number) -> Number:
        return flint.arb(0)

    def slope(self, share: Number) -> Number:
        return flint.arb(0)


class Cylinder(NamedTuple):
    """A crank and what drives it, in balls of one precision."""

    ratio: Number
    motion: Motion
    strokes: tuple[BallStroke, BallStroke]
    mean: Number
    weights: Weights | None = None

    def excess(self, stroke: int, angle: Angle) -> Number:
        """The tangential force less its mean, at half turns from the dead centre of the stroke."""
        force = turning.tangential_force(
            self.strokes[stroke], self.motion, circle(angle), self.ratio * SIGNS[stroke]
        )
        if self.weights is not None:
            force += Loaded(circle(angle), self.ratio * SIGNS[stroke], self.weights.masses).torque()
        return force - self.mean

    def slope(self, stroke: int, angle: Angle) -> Number:
        """The change of the excess with the half turns."""
        at, ratio = circle(angle), self.ratio * SIGNS[stroke]
        share, velocity = self.motion.path(at, ratio) / 2, self.motion.velocity(at, ratio)
        acting = self.strokes[stroke]
        change = acting.slope(share) * velocity * velocity / 2
        total = change + acting.force(share) * self.motion.acceleration(at, ratio)
        if self.weights is not None:
            total += inertia.torque_slope(at, ratio, self.weights.masses)
        return total * flint.arb.pi()

    def energy(self, stroke: int, angle: Angle) -> Number:
        """The work of the excess since the inner dead centre."""
        work = turning.work_done(self.strokes[stroke], self.motion, circle(angle), self.ratio * SIGNS[stroke])
        before = 2 * self.strokes[0].work(flint.arb(1)) if stroke else flint.arb(0)
        if self.weights is not None:
            work -= inertia.kinetic_energy(circle(angle), self.ratio * SIGNS[stroke], self.weights.masses)
        turned = ball(angle + stroke) if isinstance(angle, Fraction) else angle + stroke
        return before + work - self.mean * turned * flint.arb.pi()


SIGNS = (OUT, RETURN)


# Half turns: an exact number of them, or a ball.
Angle: TypeAlias = Fraction | Number


class Piece(NamedTuple):
    """What lies between two dead centres: each crank's stroke, and where that stroke began."""

    start: Fraction
    end: Fraction
    strokes: tuple[tuple[int, Fraction], ...]


class Extremum(NamedTuple):
    """A place at which the speed is least or greatest: a zero of a function of which the slope is known."""

    piece: Piece
    root: Root
    function: Function
    slope: Function


class Turn:
    """One turn of an engine by a method: exact or series kinematics."""

    def __init__(self, engine: Engine, method: str) -> None:
        self.engine = engine
        self.method = method
        self._cylinders: dict[int, Cylinder] = {}
        self._chosen: dict[tuple[bool, int | None], tuple[Extremum, ...]] = {}

    @property
    def cylinder(self) -> Cylinder:
        """The cylinders' common formulas, at the precision in force."""
        bits = flint.ctx.prec
        if bits not in self._cylinders:
            self._cylinders[bits] = _cylinder(self.engine, MOTIONS[self.method])
        return self._cylinders[bits]

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        starts = [crank / 180 % 2 for crank in self.engine.cranks]
        ends = sorted({Fraction(0), Fraction(2), *starts, *((start + 1) % 2 for start in starts)})
        return tuple(_piece(starts, low, high) for low, high in pairwise(ends))

    def cut_off(self, stroke: int) -> Number:
        """The crank angle at cut-off, in half turns from the dead centre of the stroke."""
        expansion = self.engine.ideal.expansion
        if expansion == 1:
            # The stroke ends uncut, and rounding may put the sine above 1.
            return flint.arb(1)
        versine = CUT_OFF[self.method](ball(2 / expansion), self.cylinder.ratio * SIGNS[stroke])
        return 2 * steam.half_angle_sine(versine).asin() / flint.arb.pi()

    @property
    def pi(self) -> Number:
        return flint.arb.pi()

    def of(self, value: Fraction) -> Number:
        return ball(value)

    def force_unit(self) -> Number:
        """The steam force Q in newtons."""
        load = self.engine.load
        assert load is not None
        assert load.pressure is not None
        return ball(load.pressure * load.bore**2 / 4) * flint.arb.pi()

    def radius(self) -> Number:
        """The crank radius in metres."""
        assert self.engine.crank.radius is not None
        return ball(self.engine.crank.radius)

    def back(self) -> Number:
        """The back pressure R_b/Q."""
        return self.engine.ideal.numbers(ball).back

    def mean_force(self) -> Number:
        """P/Q, the mean tangential force of all cranks together."""
        return self.cylinder.mean * len(self.engine.cranks)

    def excess(self, piece: Piece, place: Angle) -> Number:
        cylinder = self.cylinder
        return _total(cylinder.excess(stroke, _since(place, begun)) for stroke, begun in piece.strokes)

    def slope(self, piece: Piece, place: Angle) -> Number:
        cylinder = self.cylinder
        return _total(cylinder.slope(stroke, _since(place, begun)) for stroke, begun in piece.strokes)

    def energy(self, piece: Piece, place: Angle) -> Number:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        cylinder = self.cylinder
        first = self.pieces[0].strokes
        return _total(
            cylinder.energy(stroke, _since(place, begun)) - cylinder.energy(at_zero, -zero)
            for (stroke, begun), (at_zero, zero) in zip(piece.strokes, first, strict=True)
        )

    def tangential_force(self, half_turns: Fraction) -> Number:
        """The tangential force T/Q of all cranks at an exact angle, in any turn."""
        return self.excess(self._piece(half_turns % 2), half_turns % 2) + self.mean_force()

    def crank_force(self, force: CrankForce, half_turns: Fraction) -> Number:
        """A force of the first crank at an exact angle, in Q."""
        stroke, angle = next(self.engine.positions(half_turns))
        cylinder = self.cylinder
        at, ratio = circle(angle), cylinder.ratio * SIGNS[stroke]
        net = cylinder.strokes[stroke].force(cylinder.motion.path(at, ratio) / 2)
        return force.of(at, ratio, cylinder.weights, net) * (SIGNS[stroke] if force.framed else 1)

    def energy_at(self, half_turns: Fraction) -> Number:
        """The excess work W/(Q R) since the first crank's inner dead centre, at an exact angle."""
        return self.energy(self._piece(half_turns % 2), half_turns % 2)

    def _piece(self, half_turns: Fraction) -> Piece:
        return next(piece for piece in self.pieces if half_turns < piece.end)

    @cached_property
    def extrema(self) -> tuple[Extremum, ...]:
        """Every stationary place of the speed over the turn, in order."""
        return tuple(extremum for piece in self.pieces for extremum in self._stationary(piece))

    def _stationary(self, piece: Piece) -> Iterator[Extremum]:
        yield from _zeros(piece, partial(self.excess, piece), partial(self.slope, piece))

    def extreme(self, greatest: bool, stroke: int | None = None) -> Peak:
        """Return where in the turn, or in a stroke of the one crank, the speed is least or greatest.

        The place is in half turns from the beginning of the turn or of the stroke.
        """
        chosen = self._extremes(greatest, stroke)
        energies = [self.energy(one.piece, place(one)) for one in chosen]
        return Peak(place(chosen[0]) - (stroke or 0), reduce(larger if greatest else smaller, energies))

    def extreme_strokes(self, greatest: bool) -> frozenset[int]:
        """Return the strokes of the one crank in which the turn's least or greatest speed lies."""
        return frozenset(int(one.piece.start) for one in self._extremes(greatest, None))

    def irregularity(self) -> Number:
        """Return δ in units of P R/(m₁ v₁²)."""
        swing = self.extreme(greatest=True).energy - self.extreme(greatest=False).energy
        return swing / self.mean_force()

    def _extremes(self, greatest: bool, stroke: int | None) -> tuple[Extremum, ...]:
        if (greatest, stroke) not in self._chosen:
            self._chosen[greatest, stroke] = self._choose(greatest, stroke)
        return self._chosen[greatest, stroke]

    def _choose(self, greatest: bool, stroke: int | None) -> tuple[Extremum, ...]:
        within = [one for one in self.extrema if stroke is None or one.piece.start == stroke]
        if greatest:
            return self._lowest([one for one in within if one.root.rising is not True], -1)
        return self._lowest([one for one in within if one.root.rising is not False], 1)

    def _lowest(self, extrema: Sequence[Extremum], sign: int) -> tuple[Extremum, ...]:
        """Return the extremum with the lowest energy; several only if theirs cannot be told apart."""
        left = tuple(extrema)
        for bits in (ISOLATING_BITS, EQUAL_BITS):
            if len(left) > 1:
                energies = [sign * at_bits(bits, partial(self._energy_of, one)) for one in left]
                left = tuple(
                    one
                    for one, energy in zip(left, energies, strict=True)
                    if not any(other < energy for other in energies)
                )
        if any(one.root.rising is None for one in left):
            raise ProblemError("the speed rests where it should turn; its extremes cannot be told apart")
        return left

    def _energy_of(self, extremum: Extremum) -> Number:
        return self.energy(extremum.piece, place(extremum))


class WeisbachTurn(Turn):
    """A turn with the angles of Weisbach's own relations, for Mariotte's law and one double-acting crank.

    α₁ is the first zero of the first-order excess, as sin α₁ = P/(Q - R) ± ½λ sin 2α₁ says; α₂ comes from
    cot(α₂/2), or where the speed turns before the cut-off from the second zero. Where it turns shortly after
    the cut-off, his simplified cot(α₂/2) may place α₂ shortly before. Source: § 150.
    """

    def _stationary(self, piece: Piece) -> Iterator[Extremum]:
        zeros = list(super()._stationary(piece))
        if not self._turns_beyond_cut_off(piece):
            yield from zeros
            return
        yield zeros[0]
        relation, slope = partial(self._relation, piece, 0), partial(self._relation, piece, 1)
        yield from _zeros(piece, relation, slope)

    @property
    def expands_first(self) -> bool:
        """Whether on both strokes the speed is greatest beyond the cut-off, where his cot(α₂/2) holds."""
        return all(map(self._turns_beyond_cut_off, self.pieces))

    def _turns_beyond_cut_off(self, piece: Piece) -> bool:
        (stroke, begun) = piece.strokes[0]
        return bool(at_bits(EQUAL_BITS, lambda: self.excess(piece, self.cut_off(stroke) + ball(begun))) > 0)

    def _relation(self, piece: Piece, part: int, at: Number) -> Number:
        """His equation for α₂ as a function with that zero, or its slope over the half turns."""
        (stroke, begun) = piece.strokes[0]
        angle = at - ball(begun)
        acting = self.engine.ideal.numbers(ball)
        loss = acting.back / acting.cut_off
        work = steam.net_work(flint.arb(1), acting) / acting.cut_off
        ratio = self.cylinder.ratio * SIGNS[stroke]
        half = (angle / 2).sin_cos_pi()
        relation = steam.weisbach_maximum(half, circle(angle), ratio, loss, work, flint.arb.pi())
        return relation[part] * (flint.arb.pi() if part else 1)


def turn_of(engine: Engine, method: str) -> Turn | CardTurn:
    """Return the engine's turn by a method: exact, series or weisbach; of an indicator card in floats."""
    if engine.crank.moving is not None and method != "exact":
        raise ProblemError(f'method "{method}" has no formulas for the masses; use exact')
    if engine.carded:
        from kurbel.engine.card_turn import CardTurn

        return CardTurn(engine, method)
    if method != "weisbach":
        return Turn(engine, method)
    if not engine.plain or engine.ideal.exponent != 1 or engine.ideal.clearance:
        raise ProblemError(
            'method "weisbach" is for one double-acting crank, exponent 1 and no clearance, as in § 150;'
            " use exact or series"
        )
    return WeisbachTurn(engine, method)


def place(extremum: Extremum) -> Number:
    """Return where the extremum lies, in half turns, as narrow as the precision in force allows."""
    return refined(extremum.function, extremum.slope, extremum.root)


def at_bits(bits: int, value: Callable[[], Number]) -> Number:
    """Return the value computed at a precision of its own."""
    before = flint.ctx.prec
    try:
        flint.ctx.prec = bits
        return value()
    finally:
        flint.ctx.prec = before


def _zeros(piece: Piece, function: Function, slope: Function) -> Iterator[Extremum]:
    for root in isolate(function, slope, piece.start, piece.end):
        yield Extremum(piece, root, function, slope)


def _since(place: Angle, begun: Fraction) -> Angle:
    return place - begun if isinstance(place, Fraction) else place - ball(begun)


def circle(half_turns: Angle) -> Circle[Number]:
    """Return sine, cosine and versine of half turns, exact ones or a ball."""
    if isinstance(half_turns, Fraction):
        return ball_circle(180 * half_turns)
    sine, cosine = half_turns.sin_cos_pi()
    return Circle(sine, cosine, 2 * (half_turns / 2).sin_pi() ** 2)


def _cylinder(engine: Engine, motion: Motion) -> Cylinder:
    acting = SteamStroke(engine.ideal.numbers(ball))
    strokes: tuple[BallStroke, BallStroke] = (acting, acting if engine.double else IdleStroke())
    pressure = None if engine.load is None else engine.load.pressure
    weights = None if pressure is None else engine.weights(ball, flint.arb.pi(), pressure)
    mean = turning.mean_force(strokes, flint.arb.pi())
    return Cylinder(ball(engine.crank.ratio), motion, strokes, mean, weights)


def _piece(starts: Sequence[Fraction], low: Fraction, high: Fraction) -> Piece:
    strokes = []
    for start in starts:
        stroke = int((low - start) % 2)
        strokes.append((stroke, low - (low - start) % 1))
    return Piece(low, high, tuple(strokes))


def _total(values: Iterator[Number]) -> Number:
    return sum(values, flint.arb(0))
