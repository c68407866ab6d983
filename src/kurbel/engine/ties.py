"""Whether a tangential force or an excess energy can lie half-way between two printed numbers.

At a rational angle the tangential force is algebraic, and so is the energy, but for the logarithms of
Mariotte's law, and for the moving masses. The logarithms' sum is V₁ ln Z with an algebraic Z: where Z is 1
the energy is algebraic again, as at ε = 4, 90° and an infinite rod; elsewhere it is transcendental
(Lindemann) and equals no printed number. What the masses add is in units of Q an algebraic multiple of π or
of 1/π; where it is not zero, the whole is transcendental. Of roots of equations with π or logarithms no
rational one is known: quantities made of them, or with the factor π, have no rule here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from math import inf, lcm
from typing import Any, NamedTuple

import flint

from kurbel.drive.crank_forces import CrankForce
from kurbel.engine.cylinder import MOTIONS, SIGNS
from kurbel.engine.engine import Engine
from kurbel.engine.turn import Turn, at_bits
from kurbel.exact.certify import MOST_TIE_BITS, TieBits, vanishes
from kurbel.exact.kind import Kind, balls, bounds
from kurbel.exact.separation import Separation
from kurbel.kernel import steam, turning
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.rod import Loaded, kinetic_energy

FIRST_BITS = 200


_BOUNDS, _BALLS = bounds(), balls()


class _Crank(NamedTuple):
    """Where a crank stands: its stroke and the half turns since that began; weight -1 where W is zero."""

    stroke: int
    angle: Fraction
    weight: int


def force_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the tangential force at an exact angle can come to a boundary."""

    def bits(boundary: Fraction) -> float:
        engine = turn.engine
        if not _balanced(turn, half_turns):
            return inf
        acting = engine.ideal.numbers(_BOUNDS.of, _BOUNDS.exponent)
        total = Separation.rational(-boundary)
        for crank in _cranks(turn, half_turns):
            if engine.double or not crank.stroke:
                share, velocity = _share_and_velocity(turn, crank, _BOUNDS)
                # The power of a polytropic expansion has a high degree; at full pressure there is none.
                full = _at_full_pressure(turn, crank)
                pressure = 1 - acting.back if full else steam.net_pressure(share, acting)
                total += pressure * velocity
        return float(total.bits())

    return bits


def energy_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the excess energy at an exact angle can come to a boundary, inf if it equals none."""
    cranks = [*_cranks(turn, half_turns), *_cranks(turn, Fraction(0), -1)]
    mariotte = turn.engine.ideal.exponent == 1

    def bits(boundary: Fraction) -> float:
        if not _same_motion(turn, cranks) or (mariotte and not _logarithms_vanish(turn, cranks)):
            return inf
        work = steam.full_pressure_work if mariotte else steam.net_work
        return (_energy(turn, cranks, work) - Separation.rational(boundary)).bits()

    return bits


def back_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the back pressure, a power of a fraction, can come to a boundary."""
    back = turn.engine.ideal.numbers(_BOUNDS.of, _BOUNDS.exponent).back
    return lambda boundary: float((back - Separation.rational(boundary)).bits())


def crank_force_ties(force: CrankForce, turn: Turn, half_turns: Fraction) -> TieBits:
    """Return the same for a force of the first crank in Q."""
    crank = next(_cranks(turn, half_turns))

    def bits(boundary: Fraction) -> float:
        if not _weightless(turn, crank, force):
            return inf
        circle, ratio = _place(turn, crank, _BOUNDS)
        alone = _pressure_bounds(turn, crank) * force.bare(circle, ratio, None)
        return float((alone - Separation.rational(boundary)).bits())

    return bits


def newton_ties(force: CrankForce, turn: Turn, half_turns: Fraction) -> TieBits:
    """Return the same in newtons: the steam's share has the factor π, that of the masses π² or none."""
    crank = next(_cranks(turn, half_turns))

    def bits(boundary: Fraction) -> float:
        drive = turn.engine.crank
        if drive.moving is None or not _without_steam(turn, crank):
            return inf
        assert drive.speed is not None
        assert drive.radius is not None
        if drive.speed.turns:
            return inf
        weights = drive.moving.weights(_BOUNDS.of, _BOUNDS.of(drive.radius * drive.speed.value**2))
        circle, ratio = _place(turn, crank, _BOUNDS)
        alone = force.loaded(circle, ratio, weights, None, Separation.rational(0))
        return float((alone - Separation.rational(boundary)).bits())

    return bits


def _pressure_bounds(turn: Turn, crank: _Crank) -> Separation:
    """The net pressure on the piston; a stroke that idles is bounded by that of full pressure."""
    acting = turn.engine.ideal.numbers(_BOUNDS.of, _BOUNDS.exponent)
    if (crank.stroke and not turn.engine.double) or _at_full_pressure(turn, crank):
        full: Separation = 1 - acting.back
        return full
    beyond: Separation = steam.net_pressure(_share_and_velocity(turn, crank, _BOUNDS)[0], acting)
    return beyond


def _place(turn: Turn, crank: _Crank, kind: Kind) -> tuple[Circle[Number], Number]:
    """The circle of the crank's angle and the ratio with the sign of its stroke."""
    ratio = SIGNS[crank.stroke] * turn.engine.crank.ratio
    return kind.circle(180 * crank.angle), kind.of(ratio)


def _zero(value: Callable[[Kind], Any]) -> bool:
    """Whether a sum of what the masses do, in kg, is zero for certain."""
    return vanishes(lambda: value(_BALLS), value(_BOUNDS).bits())


def _weightless(turn: Turn, crank: _Crank, force: CrankForce) -> bool:
    """Whether the masses have no part in the force."""
    moving = turn.engine.crank.moving
    if moving is None:
        return True

    def part(kind: Kind) -> Any:
        one = kind.of(Fraction(1))
        circle, ratio = _place(turn, crank, kind)
        return force.loaded(circle, ratio, moving.weights(kind.of, one), None, kind.of(Fraction(0)))

    return _zero(part)


def _balanced(turn: Turn, half_turns: Fraction) -> bool:
    """Whether the masses of all cranks together have no torque."""
    moving = turn.engine.crank.moving
    if moving is None:
        return True

    def torque(kind: Kind) -> Any:
        masses = moving.weights(kind.of, kind.of(Fraction(1))).masses
        return sum(
            (Loaded(*_place(turn, crank, kind), masses).torque() for crank in _cranks(turn, half_turns)),
            kind.of(Fraction(0)),
        )

    return _zero(torque)


def _same_motion(turn: Turn, cranks: Iterable[_Crank]) -> bool:
    """Whether the masses have the kinetic energy that they had where W is zero."""
    moving = turn.engine.crank.moving
    if moving is None:
        return True

    def gain(kind: Kind) -> Any:
        masses = moving.weights(kind.of, kind.of(Fraction(1))).masses
        return sum(
            (crank.weight * kinetic_energy(*_place(turn, crank, kind), masses) for crank in cranks),
            kind.of(Fraction(0)),
        )

    return _zero(gain)


def _without_steam(turn: Turn, crank: _Crank) -> bool:
    """Whether no net pressure acts on the piston, for certain."""
    if crank.stroke and not turn.engine.double:
        return True

    def net() -> Number:
        share = _share_and_velocity(turn, crank, _BALLS)[0]
        return steam.net_pressure(share, turn.engine.ideal.numbers(_BALLS.of, _BALLS.exponent))

    return vanishes(net, float(_pressure_bounds(turn, crank).bits()))


def _at_full_pressure(turn: Turn, crank: _Crank) -> bool:
    """Whether the steam is still admitted, or just cut off."""

    def beyond(kind: Kind) -> Number:
        return _share_and_velocity(turn, crank, kind)[0] - kind.of(1 / turn.engine.ideal.expansion)

    past = at_bits(FIRST_BITS, lambda: beyond(_BALLS))
    if not past.contains(0):
        return bool(past < 0)
    needed = int(beyond(_BOUNDS).bits()) + FIRST_BITS
    return bool(at_bits(needed, lambda: beyond(_BALLS)).contains(0))


def _cranks(turn: Turn, half_turns: Fraction, weight: int = 1) -> Iterator[_Crank]:
    for stroke, angle in turn.engine.positions(half_turns):
        yield _Crank(stroke, angle, weight)


def _share_and_velocity(turn: Turn, crank: _Crank, kind: Kind) -> tuple[Number, Number]:
    # With an infinite rod the exact formulas have roots of 1, which would count as roots.
    motion = MOTIONS[turn.method] if turn.engine.crank.ratio else turning.FIRST_ORDER
    circle, ratio = kind.circle(180 * crank.angle), kind.of(SIGNS[crank.stroke] * turn.engine.crank.ratio)
    return motion.path(circle, ratio) / 2, motion.velocity(circle, ratio)


def _energy(turn: Turn, cranks: list[_Crank], work: Callable[[Number, Any], Number]) -> Separation:
    engine = turn.engine
    acting = engine.ideal.numbers(_BOUNDS.of, _BOUNDS.exponent)
    whole = work(Separation.rational(1), acting)
    # The mean works π P in half a turn, which is half of what both strokes do.
    strokes = sum((_strokes(engine, crank) * crank.weight for crank in cranks), Fraction(0))
    total = whole * Separation.rational(strokes) if strokes else Separation.rational(0)
    for crank in cranks:
        if engine.double or not crank.stroke:
            total += 2 * crank.weight * work(_share_and_velocity(turn, crank, _BOUNDS)[0], acting)
    return total


def _strokes(engine: Engine, crank: _Crank) -> Fraction:
    """How many times the work of a whole stroke was done before this one, less what the mean took."""
    return 2 * crank.stroke - (crank.angle + crank.stroke) * (2 if engine.double else 1)


def _logarithms_vanish(turn: Turn, cranks: list[_Crank]) -> bool:
    """Whether Z, the product of all growths of volume with their powers, is 1 for certain."""

    def off_one(kind: Kind, order: int) -> Number:
        return _product(turn, cranks, kind, order) - 1

    order = lcm(*(_strokes(turn.engine, crank).denominator for crank in cranks))
    if not at_bits(FIRST_BITS, lambda: off_one(_BALLS, order)).contains(0):
        return False
    bound = off_one(_BOUNDS, order).bits()
    needed = int(bound) + FIRST_BITS
    while needed < MOST_TIE_BITS:
        left = at_bits(needed, lambda: off_one(_BALLS, order))
        if not left.contains(0):
            return False
        if left.rad() * 2 < flint.arb(2) ** -int(bound + 1):
            return True
        needed *= 2
    return False


def _product(turn: Turn, cranks: list[_Crank], kind: Kind, order: int) -> Number:
    """Z to the power that makes all exponents whole."""
    engine = turn.engine
    acting = engine.ideal.numbers(kind.of, kind.exponent)
    end = steam.growth(kind.of(Fraction(1)), acting)
    total = kind.of(Fraction(1))
    for crank in cranks:
        total = total * end ** int(_strokes(engine, crank) * crank.weight * order)
        if engine.double or not crank.stroke:
            share = _share_and_velocity(turn, crank, kind)[0]
            total = total * steam.growth(share, acting) ** (2 * crank.weight * order)
    return total
