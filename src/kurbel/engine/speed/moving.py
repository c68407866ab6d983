"""The work of steam and the energy of the moving masses at a crank angle, of all cylinders, with slopes.

In Q R; the energy is that at the mean speed, but for what never changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from kurbel.engine.cylinder import AnyTurn, Cylinder, Standing
from kurbel.engine.turn import Piece
from kurbel.exact.certify import ball
from kurbel.kernel.circle import Number


class Course(NamedTuple):
    """Of the work of the steam above its mean and of the masses' energy: the values."""

    work: Number
    energy: Number


class Slopes(NamedTuple):
    """Their slopes over the angle in radians, and the changes of these with the half turns."""

    force: Number
    torque: Number
    bend: Number
    curve: Number


def course_at(turn: AnyTurn, standing: Iterable[Standing]) -> Course:
    """Return the values where the cranks stand so, the work but for a constant."""
    return _course(turn.cylinders, standing)


def course_on(cylinders: Sequence[Cylinder], piece: Piece, place: Any) -> Course:
    """Return the same at a place of a piece, on the kind of number of the cylinders."""
    return _course(cylinders, _standing(piece, place))


def slopes_on(turn: AnyTurn, piece: Piece, place: Number) -> Slopes:
    """Return the slopes at a place of a piece, in balls."""
    force, torque, bend, curve = -turn.mean_force(), 0, 0, 0
    for part, stroke, angle in _standing(piece, place):
        one = turn.cylinders[part]
        light = one.still
        force, bend = force + light.power(stroke, angle), bend + light.slope(stroke, angle)
        # What the masses add to power and slope is the loss of their energy.
        torque = torque + light.power(stroke, angle) - one.power(stroke, angle)
        curve = curve + light.slope(stroke, angle) - one.slope(stroke, angle)
    return Slopes(force, torque, bend, curve)


def _standing(piece: Piece, place: Any) -> Iterable[Standing]:
    return [Standing(part, stroke, place - ball(begun)) for part, stroke, begun in piece.strokes]


def _course(cylinders: Sequence[Cylinder], standing: Iterable[Standing]) -> Course:
    work, energy = 0, 0
    for part, stroke, angle in standing:
        one = cylinders[part]
        work = work + one.still.energy(stroke, angle)
        energy = energy + kinetic_energy(one, stroke, angle)
    return Course(work, energy)


def kinetic_energy(one: Cylinder, stroke: int, angle: Any) -> Number:
    """Return that of a cylinder's masses at the mean speed."""
    if one.weights is None:
        return 0
    found = one.drive.kinetic_energy(stroke % 2, one.circle(angle), one.weights.masses)
    return found if one.unit is None else found * one.unit
