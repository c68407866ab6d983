"""A turn of the engine in ball arithmetic: all places where its speed is least or greatest, with proof.

Angles are half turns from the inner dead centre of the first crank, 0 to 2. Between two dead centres, of
whatever cranks, the excess of the tangential forces over their mean is one smooth formula but for the
cut-offs; such a piece is where zeros are searched.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache, cached_property, partial
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import flint

from kurbel.engine.cylinder import SIGNS, AnyTurn, Cylinder, Peak
from kurbel.engine.engine import Engine
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball, ball_circle, half_turn_circle
from kurbel.exact.kind import balls
from kurbel.exact.roots import ISOLATING_BITS, Function, Root, isolate, refined
from kurbel.kernel import steam
from kurbel.kernel.circle import Circle, Number, root

# Two speeds that agree to so many bits are taken for equal, as on the two strokes of the infinite rod.
EQUAL_BITS = 200


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


class Turn(AnyTurn):
    """One turn of an engine by a method, in balls."""

    def __init__(self, engine: Engine, method: str) -> None:
        super().__init__(engine, method)
        self._cylinders: dict[int, Cylinder] = {}
        self._extremes = cache(self._choose)

    @property
    def cylinder(self) -> Cylinder:
        bits = flint.ctx.prec
        if bits not in self._cylinders:
            self._cylinders[bits] = self.cylinder_on(balls(), circle)
        return self._cylinders[bits]

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        starts = [crank / 180 % 2 for crank in self.engine.cranks]
        ends = sorted({Fraction(0), Fraction(2), *starts, *((start + 1) % 2 for start in starts)})
        return tuple(
            Piece(low, high, tuple((int((low - start) % 2), low - (low - start) % 1) for start in starts))
            for low, high in pairwise(ends)
        )

    def cut_off(self, stroke: int) -> Number:
        """The crank angle at cut-off, in half turns from the dead centre of the stroke."""
        expansion = self.engine.ideal.expansion
        if expansion == 1:
            # The stroke ends uncut, and rounding may put the sine above 1.
            return flint.arb(1)
        cylinder = self.cylinder
        versine = cylinder.motion.versine_at(ball(2 / expansion), cylinder.ratio * SIGNS[stroke])
        return 2 * root(versine / 2).asin() / flint.arb.pi()

    def back(self) -> Number:
        """The back pressure R_b/Q."""
        return self.engine.ideal.numbers(ball).back

    def excess(self, piece: Piece, place: Angle) -> Number:
        effort = self.cylinder.effort
        total = sum(effort(stroke, _since(place, begun)) for stroke, begun in piece.strokes)
        return total - self.mean_force()

    def slope(self, piece: Piece, place: Angle) -> Number:
        slope = self.cylinder.slope
        return sum(slope(stroke, _since(place, begun)) for stroke, begun in piece.strokes)

    def energy(self, piece: Piece, place: Angle) -> Number:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        energy, first = self.cylinder.energy, self.pieces[0].strokes
        return sum(
            energy(stroke, _since(place, begun)) - energy(at_zero, -zero)
            for (stroke, begun), (at_zero, zero) in zip(piece.strokes, first, strict=True)
        )

    @cached_property
    def extrema(self) -> tuple[Extremum, ...]:
        """Every stationary place of the speed over the turn, in order."""
        return tuple(extremum for piece in self.pieces for extremum in self._stationary(piece))

    def _stationary(self, piece: Piece) -> list[Extremum]:
        return _zeros(piece, partial(self.excess, piece), partial(self.slope, piece))

    def peaks(self, greatest: bool, stroke: int | None = None) -> list[Peak]:
        found = [(one, place(one)) for one in self._extremes(greatest, stroke)]
        return [Peak(at, self.energy(one.piece, at), int(one.piece.start)) for one, at in found]

    def _choose(self, greatest: bool, stroke: int | None) -> list[Extremum]:
        """Return the extremum of greatest or least energy; several only if they cannot be told apart."""
        within = [one for one in self.extrema if stroke in (None, one.piece.start)]
        # The speed is greatest where the excess falls.
        left = [one for one in within if one.root.rising is not greatest]
        sign = -1 if greatest else 1
        for bits in (ISOLATING_BITS, EQUAL_BITS):
            if len(left) > 1:
                with flint.ctx.workprec(bits):
                    energies = [sign * self.energy(one.piece, place(one)) for one in left]
                found = zip(left, energies, strict=True)
                left = [one for one, energy in found if not any(other < energy for other in energies)]
        if any(one.root.rising is None for one in left):
            raise ProblemError("the speed rests where it should turn; its extremes cannot be told apart")
        return left


class WeisbachTurn(Turn):
    """A turn with the angles of Weisbach's own relations, for Mariotte's law and one double-acting crank.

    α₁ is the first zero of the first-order excess, as sin α₁ = P/(Q - R) ± ½λ sin 2α₁ says; α₂ comes from
    cot(α₂/2), or where the speed turns before the cut-off from the second zero. Where it turns shortly after
    the cut-off, his simplified cot(α₂/2) may place α₂ shortly before. Source: § 150.
    """

    def _stationary(self, piece: Piece) -> list[Extremum]:
        zeros = super()._stationary(piece)
        if not self._turns_beyond_cut_off(piece):
            return zeros
        relation, slope = partial(self._relation, piece, 0), partial(self._relation, piece, 1)
        return [zeros[0], *_zeros(piece, relation, slope)]

    @property
    def expands_first(self) -> bool:
        """Whether on both strokes the speed is greatest beyond the cut-off, where his cot(α₂/2) holds."""
        return all(map(self._turns_beyond_cut_off, self.pieces))

    def _turns_beyond_cut_off(self, piece: Piece) -> bool:
        (stroke, begun) = piece.strokes[0]
        with flint.ctx.workprec(EQUAL_BITS):
            return bool(self.excess(piece, self.cut_off(stroke) + ball(begun)) > 0)

    def _relation(self, piece: Piece, part: int, at: Number) -> Number:
        """His equation for α₂ as a function with that zero, or its slope over the half turns."""
        (stroke, begun) = piece.strokes[0]
        angle = at - ball(begun)
        acting = self.engine.ideal.numbers(ball)
        loss = acting.back / acting.cut_off
        work = acting.work(flint.arb(1)) / acting.cut_off
        ratio = self.cylinder.ratio * SIGNS[stroke]
        half = (angle / 2).sin_cos_pi()
        relation = steam.weisbach_maximum(half, circle(angle), ratio, loss, work, flint.arb.pi())
        return relation[part] * (flint.arb.pi() if part else 1)


def turn_of(engine: Engine, method: str) -> AnyTurn:
    """Return the engine's turn by a method: exact, series or weisbach; of an indicator card in floats."""
    if engine.crank.moving is not None and method != "exact":
        raise ProblemError(f'method "{method}" has no formulas for the masses; use exact')
    if engine.carded:
        from kurbel.engine.card.turn import CardTurn

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


def _zeros(piece: Piece, function: Function, slope: Function) -> list[Extremum]:
    found = isolate(function, slope, piece.start, piece.end)
    return [Extremum(piece, zero, function, slope) for zero in found]


def _since(place: Angle, begun: Fraction) -> Angle:
    return place - begun if isinstance(place, Fraction) else place - ball(begun)


def circle(half_turns: Angle) -> Circle[Number]:
    """Return sine, cosine and versine of half turns, exact ones or a ball."""
    if isinstance(half_turns, Fraction):
        return ball_circle(180 * half_turns)
    return half_turn_circle(half_turns)
