"""Whether a force or a torque in newtons can lie half-way between two printed numbers.

In newtons the share of the load has the factor π, and that of inertia π² where the speed counts turns; weight
and friction have none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from math import inf
from typing import Any

from kurbel.drive.crank import known
from kurbel.drive.crank_forces import CrankForce
from kurbel.engine.ties import (
    BOUNDS,
    On,
    Own,
    Standing,
    apart,
    cranks_at,
    part_of,
    torque_of,
    vanishes_on,
    where_known,
    without_steam,
)
from kurbel.engine.turn import Turn
from kurbel.exact.certify import TieBits
from kurbel.exact.separation import Separation


@where_known
def newton_ties(force: CrankForce, turn: Turn, half_turns: Fraction) -> TieBits:
    """Return the same in newtons: the steam's share has the factor π, that of inertia π² or none."""
    crank = cranks_at(turn, half_turns)[0]

    def acting(on: On, own: Own) -> Any:
        none = on.kind.of(Fraction(0))
        return on.drive.force(force, *on.place(crank), own.weights, none, own.friction) + none

    return _weighed_ties(turn, [crank], lambda on, crank: on.drive.bare(force, *on.place(crank)), acting)


@where_known
def torque_ties(turn: Turn, half_turns: Fraction) -> TieBits:
    """Return the same of the torque of all cranks in newton metres."""
    cranks, radius = cranks_at(turn, half_turns), known(turn.part.crank.radius)

    def acting(on: On, own: Own) -> Any:
        return on.kind.of(radius) * torque_of(on, cranks, own)

    return _weighed_ties(turn, cranks, On.lever, acting)


def _weighed_ties(
    turn: Turn,
    cranks: Sequence[Standing],
    lever: Callable[[On, Standing], Any],
    acting: Callable[[On, Own], Any],
) -> TieBits:
    """Return the ties of what is rational only where the steam, which acts by its lever, has no part in it,
    and inertia by turns a second has none."""

    def bits(boundary: Fraction) -> float:
        drive, parts = turn.part.crank, [*apart(turn)]
        if drive.moving is not None and known(drive.speed).turns:
            by_inertia = parts.pop(0)
            if not vanishes_on(turn, partial(part_of, acting, by_inertia)):
                return inf
        if not parts or not all(_without_lever(turn, crank, lever) for crank in cranks):
            return inf
        return float((acting(On(turn, BOUNDS), parts[0](BOUNDS)) - Separation.rational(boundary)).bits())

    return bits


def _without_lever(turn: Turn, crank: Standing, lever: Callable[[On, Standing], Any]) -> bool:
    """Whether the steam has no part in a force, for certain: it does not act, or has no lever there."""
    none = Fraction(0)
    return without_steam(turn, crank) or vanishes_on(turn, lambda on: lever(on, crank) + on.kind.of(none))
