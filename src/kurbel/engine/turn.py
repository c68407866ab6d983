"""A cycle of the engine in ball arithmetic: all places where its speed is least or greatest, with proof.

Angles are half turns of the first crank's φ, from its inner dead centre on. Between two dead centres, of
whatever cranks, the excess of the tangential forces over their mean is one smooth formula but for the
corners of the forces; such a piece is where zeros are searched. Dead centres that no rational number of half
turns says are kept between two near ones, over which the excess is proved not to vanish.

The same cycle on numbers that know what they are made of, as exact/terms.py has them, tells ties: at a
rational angle forces are algebraic, and so are energies but for the logarithms of Mariotte's law; with the
mean force comes 1/π, with newtons π, and with the masses a power of it. Of the places at which the speed is
least or greatest no rational one is known: they are undecided, and so is what follows from them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache, cached_property, partial
from itertools import pairwise, product
from math import floor
from typing import NamedTuple, NoReturn, TypeAlias

import flint
from flint import arb

from kurbel.drive.moved import Moved
from kurbel.engine.cylinder import SIGNS, AnyTurn, CrankPosition, Cylinder, Peak, cranks_of
from kurbel.engine.engine import Assembly, Engine
from kurbel.engine.loads.ideal import Steam
from kurbel.errors import ProblemError
from kurbel.exact.certify import FLOAT_BITS, UndecidedError, at_bits, ball, ball_circle, half_turn_circle
from kurbel.exact.kind import Kind, balls
from kurbel.exact.search import EQUAL_BITS, ISOLATING_BITS, Function, Zero, greatest, interval, isolate
from kurbel.exact.terms import tie_bits
from kurbel.kernel import steam
from kurbel.kernel.circle import Circle, Numeric

# So near are the numbers between which a dead centre lies.
GAP_BITS = 100
# Half turns: an exact number of them, or a ball.
Angle: TypeAlias = Fraction | arb


class TurnPiece(NamedTuple):
    """What lies between two dead centres: of each crank its part of the engine, its stroke, and the half
    turns to take off for the angle in it."""

    start: Fraction
    end: Fraction
    strokes: tuple[tuple[int, int, Fraction], ...]
    # Cranks that stand alike are one, so many times.
    unlike: tuple[tuple[int, int, int, Fraction], ...]

    @property
    def stroke(self) -> int:
        """That of the first crank."""
        return self.strokes[0][1]


class Extremum(NamedTuple):
    """A place at which the speed is least or greatest."""

    piece: TurnPiece
    zero: Zero


class Turn(AnyTurn):
    """One cycle of an engine by a method, in balls."""

    def __init__(self, engine: Engine | Assembly, method: str) -> None:
        super().__init__(engine, method)
        self._cylinders: dict[int, tuple[Cylinder, ...]] = {}
        self._energies: dict[int, Numeric] = {}
        self._extremes = cache(self._choose)

    @property
    def cylinders(self) -> tuple[Cylinder, ...]:
        bits = flint.ctx.prec
        if bits not in self._cylinders:
            self._cylinders[bits] = self.cylinders_on(balls(), circle)
        return self._cylinders[bits]

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        """Whether the stroke has begun; at its dead centre it has."""
        for bits in (ISOLATING_BITS, EQUAL_BITS):
            with at_bits(bits):
                beyond = ball(since - stroke) - ball(self.cylinders[part].drive.dead_centre(stroke % 2))
            if not beyond.contains(0):
                return beyond > 0
        return True

    @cached_property
    def pieces(self) -> tuple[TurnPiece, ...]:
        return tuple(self._piece(low, high) for (_, low), (high, _) in pairwise(self._gaps))

    def _piece(self, low: Fraction, high: Fraction) -> TurnPiece:
        middle = (low + high) / 2
        standing = self.positions(middle)
        strokes = tuple((part, stroke, middle - angle) for part, stroke, angle in standing)
        unlike = tuple((count, *one) for one, count in Counter(strokes).items())
        return TurnPiece(low, high, strokes, unlike)

    @cached_property
    def _gaps(self) -> list[tuple[Fraction, Fraction]]:
        """The dead centres of all cranks over a cycle, each between two numbers or exactly."""
        first, *others = self._dead_centres()
        start, cycle = first[0], self.cycle
        last = first[0] + cycle, first[1] + cycle
        shifted = ((low - floor((low - start) / cycle) * cycle, high - low) for low, high in others)
        gaps = [first]
        for low, high in sorted([*((low, low + width) for low, width in shifted), last]):
            # Dead centres of two cranks that are one, or as good as one.
            if low <= gaps[-1][1]:
                low, high = gaps[-1][0], max(high, gaps[-1][1])
                gaps.pop()
            gaps.append((low, high))
        return gaps

    def _dead_centres(self) -> Iterator[tuple[Fraction, Fraction]]:
        for (part, start), stroke in product(cranks_of(self.engine), range(self.cycle)):
            begun = start + stroke
            if self.cylinders[part].drive.regular:
                yield begun, begun
            else:
                with at_bits(GAP_BITS):
                    yield _ends(ball(self.cylinders[part].drive.dead_centre(stroke % 2)), begun)

    def begun(self) -> list[CrankPosition]:
        dead = self.cylinder.drive.dead_centre(0)
        place = ball(dead) if dead else Fraction(0)
        return [
            CrankPosition(part, stroke, _since(place, begun))
            for part, stroke, begun in self.pieces[0].strokes
        ]

    def angle_of(self, part: int, stroke: int, share: Numeric) -> arb:
        """Return the half turns of φ, on the return less one, at which a piston has gone a share."""
        return angle_at(self.cylinders[part].drive, stroke % 2, share)

    def corners(self) -> Iterator[Fraction]:
        """Yield the half turns, as floats are, of all corners of the forces, over a cycle in any order."""
        for part, (one, cylinder) in enumerate(zip(self.engine.parts, self.cylinders, strict=True)):
            for stroke, acting in enumerate(cylinder.strokes):
                for share in acting.corners:
                    with at_bits(FLOAT_BITS):
                        corner = stroke + Fraction(float(self.angle_of(part, stroke, share)))
                    yield from (start + corner for start in one.starts)

    def cut_off(self, stroke: int) -> arb:
        """The crank angle at cut-off, in half turns from the dead centre of the stroke."""
        begin, end = _ends_of(self.cylinder.drive, stroke % 2)
        expansion = self.part.ideal.expansion
        if expansion == 1:
            # The stroke ends uncut, and rounding may put the sine above 1.
            return flint.arb(1) * (end - begin)
        return self.angle_of(0, stroke, ball(1 / expansion)) - begin

    def excess(self, piece: TurnPiece, place: Angle) -> arb:
        cylinders = self.cylinders
        total = sum(
            count * cylinders[part].power(stroke, _since(place, begun))
            for count, part, stroke, begun in piece.unlike
        )
        return ball(total - self.mean_force())

    def slope(self, piece: TurnPiece, place: Angle) -> arb:
        cylinders = self.cylinders
        total = sum(
            count * cylinders[part].slope(stroke, _since(place, begun))
            for count, part, stroke, begun in piece.unlike
        )
        return ball(total)

    def energy(self, piece: TurnPiece, place: Angle) -> arb:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        cylinders = self.cylinders
        since = sum(
            count * cylinders[part].energy(stroke, _since(place, begun))
            for count, part, stroke, begun in piece.unlike
        )
        return ball(since - self.energy_begun())

    def energy_begun(self) -> Numeric:
        bits = flint.ctx.prec
        if bits not in self._energies:
            self._energies[bits] = super().energy_begun()
        return self._energies[bits]

    @cached_property
    def extrema(self) -> tuple[Extremum, ...]:
        """Every stationary place of the speed over the cycle, in order."""
        for before, after in pairwise((self.pieces[-1], *self.pieces)):
            self._check_gap(before, after)
        return tuple(extremum for piece in self.pieces for extremum in self._stationary(piece))

    def _check_gap(self, before: TurnPiece, after: TurnPiece) -> None:
        """Raise ProblemError if the speed may turn so near to a dead centre that it is not told from it."""
        low, high = before.end, after.start
        if high < low:
            low -= self.cycle
        if low == high:
            return
        with at_bits(GAP_BITS):
            behind, beyond = interval(before.end, before.end + high - low), interval(low, high)
            if (self.excess(before, behind).union(self.excess(after, beyond))).contains(0):
                raise ProblemError("the speed turns in a dead centre; its extremes cannot be told apart")

    def _stationary(self, piece: TurnPiece) -> list[Extremum]:
        return stationary(piece, partial(self.excess, piece), partial(self.slope, piece))

    def peaks(self, greatest: bool, stroke: int | None = None) -> list[Peak]:
        return [
            Peak(one.zero.place(), self._energy_at(one), one.piece.stroke)
            for one in self._extremes(greatest, stroke)
        ]

    def _energy_at(self, extremum: Extremum) -> arb:
        return self.energy(extremum.piece, extremum.zero.place())

    def _choose(self, most: bool, stroke: int | None) -> list[Extremum]:
        """Return the extremum of greatest or least energy; several only if they cannot be told apart."""
        within = [one for one in self.extrema if stroke in (None, one.piece.stroke)]
        # The speed is greatest where the excess falls.
        turning = [one for one in within if one.zero.rising is not most]
        found = greatest(turning, self._energy_at, 1 if most else -1)
        if any(one.zero.rising is None for one in found):
            raise ProblemError("the speed rests where it should turn; its extremes cannot be told apart")
        return found


def turn_of(engine: Engine | Assembly, method: str) -> AnyTurn:
    """Return the engine's turn by a method: exact, series or weisbach; of an indicator card in floats."""
    if any(part.crank.moving is not None for part in engine.parts) and method == "weisbach":
        raise ProblemError('method "weisbach" has no formulas for the masses; use exact or series')
    if engine.carded:
        from kurbel.engine.card.force import CardTurn

        return CardTurn(engine, method)
    if method != "weisbach":
        return Turn(engine, method)
    if any(part.crank.effort is not None for part in engine.parts):
        raise ProblemError(
            'method "weisbach" has no equations for friction and piston rods; use exact or series'
        )
    ideal = engine.parts[0].steam
    if not getattr(ideal, "plain", True):
        raise ProblemError(
            'method "weisbach" has no equations for release, cushioning and lead; use exact or series'
        )
    if not engine.plain or not isinstance(ideal, Steam) or ideal.exponent != 1 or ideal.clearance:
        raise ProblemError(
            'method "weisbach" is for one double-acting crank, exponent 1 and no clearance, as in § 150;'
            " use exact or series"
            if isinstance(ideal, Steam)
            else 'method "weisbach" has equations for steam alone, those of § 150; use exact or series'
        )

    return WeisbachTurn(engine, method)


def angle_at(drive: Moved, way: int, share: Numeric) -> arb:
    """Return the half turns of φ, on the return less one, at which a piston has gone a share."""
    known = drive.angle_at(way, share)
    if known is not None:
        return ball(known)

    def lacking(angle: arb) -> arb:
        return ball(drive.path(way, circle(angle)) / drive.length - share)

    def speed(angle: arb) -> arb:
        return ball(drive.velocity(way, circle(angle)) / drive.length) * flint.arb.pi()

    (low, _), (_, high) = map(_ends, _ends_of(drive, way))
    return Zero(lacking, speed, low, high).place()


def _ends_of(drive: Moved, way: int) -> tuple[arb, arb]:
    """Return the half turns of φ, on the return less one, at which a stroke begins and ends."""
    return ball(drive.dead_centre(way)), 1 + ball(drive.dead_centre(1 - way))


def stationary(piece: TurnPiece, function: Function, slope: Function) -> list[Extremum]:
    return [Extremum(piece, zero) for zero in isolate(function, slope, piece.start, piece.end)]


def _ends(number: arb, begun: Fraction = Fraction(0)) -> tuple[Fraction, Fraction]:
    """Return two numbers between which a ball lies, from a beginning on."""
    low, high = (end.fmpq() for end in (number.lower(), number.upper()))
    return begun + Fraction(int(low.p), int(low.q)), begun + Fraction(int(high.p), int(high.q))


def _since(place: Angle, begun: Fraction) -> Angle:
    return place - begun if isinstance(place, Fraction) else place - ball(begun)


def circle(half_turns: Angle) -> Circle[arb]:
    """Return sine, cosine and versine of half turns, exact ones or a ball."""
    if isinstance(half_turns, Fraction):
        return ball_circle(180 * half_turns)
    return half_turn_circle(half_turns)


class WeisbachTurn(Turn):
    """A turn with the angles of Weisbach's own relations, for Mariotte's law and one double-acting crank.

    α₁ is the first zero of the first-order excess, as sin α₁ = P/(Q - R) ± ½λ sin 2α₁ says; α₂ comes from
    cot(α₂/2), or where the speed turns before the cut-off from the second zero. Where it turns shortly after
    the cut-off, his simplified cot(α₂/2) may place α₂ shortly before. Source: § 150.
    """

    def _stationary(self, piece: TurnPiece) -> list[Extremum]:
        zeros = super()._stationary(piece)
        if not self._turns_beyond_cut_off(piece):
            return zeros
        relation, slope = partial(self._relation, piece, 0), partial(self._relation, piece, 1)
        return [zeros[0], *stationary(piece, relation, slope)]

    @property
    def expands_first(self) -> bool:
        """Whether on both strokes the speed is greatest beyond the cut-off, where his cot(α₂/2) holds."""
        return all(map(self._turns_beyond_cut_off, self.pieces))

    def _turns_beyond_cut_off(self, piece: TurnPiece) -> bool:
        (_, stroke, begun) = piece.strokes[0]
        with at_bits(EQUAL_BITS):
            return self.excess(piece, self.cut_off(stroke) + ball(begun)) > 0

    def _relation(self, piece: TurnPiece, part: int, at: arb) -> arb:
        """His equation for α₂ as a function with that zero, or its slope over the half turns."""
        (_, stroke, begun) = piece.strokes[0]
        angle = at - ball(begun)
        acting = self.part.ideal.numbers(ball)
        loss = acting.back / acting.cut_off
        work = (acting.work(flint.arb(1)) - acting.back) / acting.cut_off
        ratio = ball(SIGNS[stroke] * self.engine.crank.ratio)
        half = (angle / 2).sin_cos_pi()
        relation = steam.weisbach_maximum(half, circle(angle), ratio, loss, work, flint.arb.pi())
        return ball(relation[part]) * (flint.arb.pi() if part else 1)


class ExactTurn(Turn):
    """A turn on a kind of number of its own, and at rational angles alone."""

    def __init__(self, turn: Turn, kind: Kind) -> None:
        super().__init__(turn.engine, turn.method)
        self.turn, self.kind = turn, kind
        self._own = self.cylinders_on(kind, self._circle)

    def _circle(self, half_turns: Angle) -> Circle[Numeric]:
        if not isinstance(half_turns, (int, Fraction)):
            raise UndecidedError
        return self.kind.circle(180 * half_turns)

    @property
    def cylinders(self) -> tuple[Cylinder, ...]:
        return self._own

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        return self.turn.has_reached(since, part, stroke)

    def peaks(self, greatest: bool, stroke: int | None = None) -> NoReturn:
        raise UndecidedError

    def at_speed(self, factor: Fraction) -> NoReturn:
        raise UndecidedError


def turn_ties(value: Callable[..., Numeric], turns: Sequence[AnyTurn]) -> Callable[[Fraction], float]:
    """Return how near a value of turns can come to a rounding boundary, as `certify.rounded` asks: of turns
    in balls, of which alone more than a ball is known."""

    def on(kind: Kind) -> Numeric:
        own = [ExactTurn(one, kind) for one in turns if isinstance(one, Turn)]
        if len(own) < len(turns):
            raise UndecidedError
        return value(*own)

    return lambda boundary: tie_bits(on, boundary)
