"""Whether a tangential force or an excess energy can lie half-way between two printed numbers.

At a rational angle the tangential force is algebraic, and so is the energy, but for the logarithms of
Mariotte's law, and for the moving masses. The logarithms' sum is V₁ ln Z with an algebraic Z: where Z is 1
the energy is algebraic again, as at ε = 4, 90° and an infinite rod; elsewhere it is transcendental
(Lindemann) and equals no printed number. What the masses add is in units of Q an algebraic multiple of π or
of 1/π; where it is not zero, the whole is transcendental. Of roots of equations with π or logarithms no
rational one is known: quantities made of them, or with the factor π, have no rule here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial, wraps
from math import inf, lcm, log2
from typing import Any, NamedTuple

import flint

from kurbel.drive.crank import known
from kurbel.drive.crank_forces import NOTHING, CrankForce, Weights
from kurbel.drive.rod import Moving
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.turn import Turn
from kurbel.exact.certify import NEVER_TIES, TieBits, vanishes
from kurbel.exact.kind import Kind, balls, bounds
from kurbel.exact.separation import Separation
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.steam import Expansion
from kurbel.kernel.turning import Stroke

FIRST_BITS = 200


BOUNDS, _BALLS = bounds(), balls()


class Standing(NamedTuple):
    """Where a crank stands: its stroke and the half turns φ in it; weight -1 where W is zero."""

    stroke: int
    angle: Fraction
    weight: int


class Own(NamedTuple):
    """What acts beside the load: masses, and friction as a force in the direction of the stroke or None."""

    weights: Weights
    friction: Any


class On:
    """The terms of a turn's sums, each of a crank, on a kind of number."""

    def __init__(self, turn: Turn, kind: Kind) -> None:
        self.engine, self.kind = turn.part, kind
        self.strokes = _pressed(turn.part, kind)
        # With an infinite rod the exact formulas have roots of 1, which would count as roots.
        self.drive = turn.part.drive.moved(kind, turn.method if turn.part.crank.ratio else "series")

    def place(self, crank: Standing) -> tuple[int, Circle[Number]]:
        """The way of a crank, out or back, and the circle of its angle."""
        return crank.stroke % 2, self.kind.circle(180 * crank.angle)

    def share(self, crank: Standing) -> Number:
        """The share of the stroke travelled."""
        return self.drive.path(*self.place(crank)) / self.drive.length

    def lever(self, crank: Standing) -> Number:
        """The tangential force of a unit force on the piston."""
        lever = self.drive.lever if self.engine.crank.ratio else self.drive.velocity
        return lever(*self.place(crank))

    def net_pressure(self, crank: Standing) -> Number:
        return self.strokes[crank.stroke].force(self.share(crank))

    @property
    def steam(self) -> Expansion:
        """Ideal steam, as it is on the strokes that do not idle."""
        return self.engine.ideal.numbers(self.kind.of, self.kind.exponent)

    def beyond_cut_off(self, crank: Standing) -> Number:
        return self.share(crank) - self.kind.of(1 / self.engine.ideal.expansion)


def where_known(rule: Callable[..., TieBits]) -> Callable[..., TieBits | None]:
    """Return the rule of a turn, the last but one of its arguments, for cranks alike whose pistons have
    algebraic paths; of others a value on a boundary stays unsettled."""

    @wraps(rule)
    def ruled(*about: Any) -> TieBits | None:
        turn: Turn = about[-2]
        known = len(turn.engine.parts) == 1 and turn.cylinder.drive.algebraic
        return rule(*about) if known else NEVER_TIES

    return ruled


@where_known
def force_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the tangential force at an exact angle can come to a boundary."""
    cranks = cranks_at(turn, half_turns)

    def bits(boundary: Fraction) -> float:
        if not _without_masses(turn, lambda on, own: torque_of(on, cranks, own)):
            return inf
        on, total = On(turn, BOUNDS), Separation.rational(-boundary)
        for crank in cranks:
            if not _is_steam(turn) or _works(turn.part, crank):
                total += _pressure_bounds(turn, crank) * on.lever(crank)
        return float(total.bits())

    return bits


def scaled_ties(scale: Callable[[Turn], Fraction], turn: Turn, half_turns: Fraction) -> TieBits | None:
    """Return the same for so many times the tangential force."""
    bits, factor = force_ties(turn, half_turns), scale(turn)
    return bits and (lambda boundary: bits(boundary / factor) + max(0.0, -log2(factor)))


@where_known
def energy_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the excess energy at an exact angle can come to a boundary, inf if it equals none."""
    cranks = [*cranks_at(turn, half_turns), *cranks_at(turn, Fraction(0), -1)]

    def gain(on: On, own: Own) -> Any:
        return sum(crank.weight * _gained(on, crank, own) for crank in cranks)

    def bits(boundary: Fraction) -> float:
        # The mean works from a dead centre on, whose share of a turn is irrational unless it is regular; of
        # other loads the logarithms are not known.
        if not turn.cylinder.drive.regular or not _is_steam(turn):
            return inf
        # The masses have the energy that they had where W is zero, and all growths of volume with their
        # powers the product 1, or there is a transcendental part.
        if not _without_masses(turn, gain) or (
            _is_mariotte(turn) and not vanishes_on(turn, _growth_off_one(cranks))
        ):
            return inf
        return (_energy(turn, cranks) - Separation.rational(boundary)).bits()

    return bits


def _gained(on: On, crank: Standing, own: Own) -> Any:
    """The energy of the masses, of motion and of height, and what friction took beyond its mean."""
    weights, gained = own.weights, on.drive.kinetic_energy(*on.place(crank), own.weights.masses)
    if weights.weight is not None:
        gained = gained - on.drive.work_of_weight(*on.place(crank), weights.weight)
    if own.friction is not None:
        gone = on.share(crank) - on.kind.of(crank.angle)
        gained = gained - own.friction * on.drive.length * gone
    return gained


def back_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return how near the back pressure, a power of a fraction, can come to a boundary."""
    back = On(turn, BOUNDS).steam.back
    return lambda boundary: float((back - Separation.rational(boundary)).bits())


def crank_force_ties(force: CrankForce, turn: Turn, half_turns: Fraction) -> TieBits | None:
    """Return the same for a force of the first crank in Q."""
    _, stroke, angle = turn.first(half_turns)
    return limit_ties(force, stroke, turn, angle)


@where_known
def limit_ties(force: CrankForce, stroke: int, turn: Turn, angle: Fraction) -> TieBits:
    """Return the same for its limit in a stroke, of which a dead centre is the end or the beginning."""
    crank = Standing(stroke, angle, 1)

    def of_masses(on: On, own: Own) -> Any:
        return on.drive.force(force, *on.place(crank), own.weights, on.kind.of(Fraction(0)), own.friction)

    def bits(boundary: Fraction) -> float:
        if not _without_masses(turn, of_masses):
            return inf
        on = On(turn, BOUNDS)
        alone = _pressure_bounds(turn, crank) * on.drive.bare(force, *on.place(crank))
        return float((alone - Separation.rational(boundary)).bits())

    return bits


def torque_of(on: On, cranks: Sequence[Standing], own: Own) -> Any:
    masses, weight = own.weights.masses, own.weights.weight
    loaded = (
        on.drive.loaded(*on.place(crank), masses, on.kind.of(Fraction(0)), 0, weight, own.friction)
        for crank in cranks
    )
    return sum(one.torque() for one in loaded)


def _is_mariotte(turn: Turn) -> bool:
    return turn.part.ideal.exponent == 1


def _is_steam(turn: Turn) -> bool:
    """Whether ideal steam drives the piston on the whole area, of which more is known than of other loads."""
    effort = turn.part.crank.effort
    return isinstance(turn.part.steam, Steam) and (effort is None or effort.areas is None)


def _pressed(engine: Engine, kind: Kind) -> Sequence[Stroke]:
    """The strokes of the load without friction."""
    if engine.crank.effort is None:
        return engine.steam.strokes(kind, engine.double)
    from kurbel.engine.loads.effort import pressed

    return pressed(engine, kind)


def _works(engine: Engine, crank: Standing) -> bool:
    """Whether the stroke that the crank is in does not idle, of steam."""
    return engine.double or not crank.stroke


def _pressure_bounds(turn: Turn, crank: Standing) -> Separation:
    """The net pressure on the piston; a stroke that idles is bounded by that of full pressure."""
    on = On(turn, BOUNDS)
    if not _is_steam(turn):
        other: Separation = on.net_pressure(crank)
        return other
    # The power of a polytropic expansion has a high degree; at full pressure there is none.
    full = not _works(turn.part, crank) or _at_full_pressure(turn, crank)
    pressure: Separation = 1 - on.steam.back if full else on.net_pressure(crank)
    return pressure


def vanishes_on(turn: Turn, value: Callable[[On], Any]) -> bool:
    """Whether a sum of terms is zero for certain."""
    return vanishes(lambda: value(On(turn, _BALLS)), value(On(turn, BOUNDS)).bits())


def _without_masses(turn: Turn, part: Callable[[On, Own], Any]) -> bool:
    """Whether the masses have no part in a sum, neither by their inertia nor by their weight."""
    return all(vanishes_on(turn, partial(part_of, part, own)) for own in apart(turn))


def part_of(part: Callable[[On, Own], Any], own: Callable[[Kind], Own], on: On) -> Any:
    return part(on, own(on.kind)) + on.kind.of(Fraction(0))


def apart(turn: Turn) -> Iterator[Callable[[Kind], Own]]:
    """Yield the masses by their inertia and what else acts, weight and friction, where these have other
    powers of π, else both together: of turns a second inertia has π², of radians none."""
    crank, friction = turn.part.crank, Fraction(0)
    if crank.rubbed:
        friction = known(crank.effort).friction

    def own(moving: Moving | None, factor: Fraction, friction: Fraction, kind: Kind) -> Own:
        weights = NOTHING if moving is None else moving.weights(kind, kind.of(factor))
        return Own(weights, kind.of(-friction) if friction else None)

    moving, one, none = crank.moving, Fraction(1), Fraction(0)
    if moving is None:
        if friction:
            yield partial(own, None, none, friction)
    elif known(crank.speed).turns:
        yield partial(own, replace(moving, slope=None), one, none)
        if friction or moving.slope is not None:
            yield partial(own, moving, none, friction)
    else:
        yield partial(own, moving, known(crank.radius) * known(crank.speed).value ** 2, friction)


def without_steam(turn: Turn, crank: Standing) -> bool:
    """Whether no net pressure acts on the piston, for certain."""
    if _is_steam(turn) and not _works(turn.part, crank):
        return True
    return vanishes(lambda: On(turn, _BALLS).net_pressure(crank), float(_pressure_bounds(turn, crank).bits()))


def _at_full_pressure(turn: Turn, crank: Standing) -> bool:
    """Whether the steam is still admitted, or just cut off."""
    with flint.ctx.workprec(FIRST_BITS):
        past = On(turn, _BALLS).beyond_cut_off(crank)
    if not past.contains(0):
        return bool(past < 0)
    with flint.ctx.workprec(int(On(turn, BOUNDS).beyond_cut_off(crank).bits()) + FIRST_BITS):
        return bool(On(turn, _BALLS).beyond_cut_off(crank).contains(0))


def cranks_at(turn: Turn, half_turns: Fraction, weight: int = 1) -> list[Standing]:
    return [Standing(stroke, angle, weight) for _, stroke, angle in turn.positions(half_turns)]


def _energy(turn: Turn, cranks: Sequence[Standing]) -> Separation:
    """The energy without its logarithms."""
    on = On(turn, BOUNDS)
    work = on.steam.full_pressure_work if _is_mariotte(turn) else on.steam.work
    whole = work(Separation.rational(1))
    # The mean works π P in half a turn, which is half of what both strokes do.
    strokes = sum((_strokes(turn.part, crank) * crank.weight for crank in cranks), Fraction(0))
    total = whole * Separation.rational(strokes) if strokes else Separation.rational(0)
    for crank in cranks:
        if _works(turn.part, crank):
            total += 2 * crank.weight * work(on.share(crank))
    return total


def _strokes(engine: Engine, crank: Standing) -> Fraction:
    """How many times the work of a whole stroke was done before this one, less what the mean took."""
    return 2 * crank.stroke - (crank.angle + crank.stroke) * (2 if engine.double else 1)


def _growth_off_one(cranks: Sequence[Standing]) -> Callable[[On], Number]:
    """Return Z - 1, for Z the product of all growths of volume with their powers, which are made whole."""

    def off_one(on: On) -> Number:
        strokes = [_strokes(on.engine, crank) for crank in cranks]
        order = lcm(*(one.denominator for one in strokes))
        end = on.steam.growth(on.kind.of(Fraction(1)))
        total = on.kind.of(Fraction(1))
        for crank, before in zip(cranks, strokes, strict=True):
            total = total * end ** int(before * crank.weight * order)
            if _works(on.engine, crank):
                total = total * on.steam.growth(on.share(crank)) ** (2 * crank.weight * order)
        return total - 1

    return off_one
