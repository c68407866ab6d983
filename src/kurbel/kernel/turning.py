"""The turning of the crank by the piston force: tangential force and energy of one crank, over one stroke.

Forces are in units of the piston force Q before cut-off, energy in units of Q R. A stroke is known by the
net pressure on its piston over the share travelled, and the work of that pressure.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from kurbel.kernel import kinematics, steam
from kurbel.kernel.circle import Circle, Number

Formula = Callable[[Circle[Number], Number], Number]


class Stroke(Protocol):
    """The net pressure on the piston and its work, over the share of the stroke travelled.

    `corners` are the shares at which the force has one. All but those of a card know their `slope`.
    """

    @property
    def corners(self) -> Sequence[Number]: ...

    def force(self, share: Number) -> Number: ...

    def work(self, share: Number) -> Number: ...


class Motion(NamedTuple):
    """The kinematics in force: piston path, velocity and acceleration, and 1 - cos φ at a path."""

    path: Formula
    velocity: Formula
    acceleration: Formula
    versine_at: Callable[[Number, Number], Number]


EXACT = Motion(
    kinematics.piston_path,
    kinematics.piston_velocity,
    kinematics.piston_acceleration,
    steam.crank_versine,
)
FIRST_ORDER = Motion(
    kinematics.piston_path_first_order,
    kinematics.piston_velocity_first_order,
    kinematics.piston_acceleration_first_order,
    steam.crank_versine_first_order,
)


def mean_force(strokes: Sequence[Stroke], pi: Number, length: Number = 2) -> Number:
    """Return the constant tangential force that does the work of all strokes of a cycle, two or four.

    `length` is that of the stroke in R. Source: Weisbach-Herrmann, § 150 (P π r for one stroke).
    """
    work = sum(one.work(1) for one in strokes)
    if len(strokes) == length == 2:
        return work / pi
    return work * length / (len(strokes) * pi)


def energy_swing(irregularity: Number, mean_torque: Number) -> Number:
    """Return ΔW = k P R in joules from k, the δ in units of P r/(m₁ v₁²), and P R in N m."""
    return irregularity * mean_torque


def moment_of_inertia(swing: Number, irregularity: Number, speed: Number) -> Number:
    """Return J = ΔW/(δ ω²) in kg m² that keeps (v_max - v_min)/v at δ; ΔW in J, ω in 1/s.

    First order in δ: the exact energy swing of a flywheel between ω(1 ± δ/2) is the same.
    Source: Weisbach-Herrmann, § 150, with m₁ r² = J.
    """
    return swing / (irregularity * speed * speed)
