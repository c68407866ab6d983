"""The turning of the crank by the piston force: tangential force and energy of one crank, over one stroke.

Forces are in units of the piston force Q before cut-off, energy in units of Q R. A stroke is known by the
net pressure on its piston over the share travelled, and the work of that pressure.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from kurbel.kernel import kinematics, steam
from kurbel.kernel.circle import Numeric, root

# Of the circle, λ and, of an offset crank, e/R.
Formula = Callable[..., Numeric]


class Stroke(Protocol):
    """The net pressure on the piston and its work, over the share of the stroke travelled.

    `corners` are the shares at which the force has one, `slope` its change with the share.
    """

    @property
    def corners(self) -> Sequence[Numeric]: ...

    def force(self, share: Numeric) -> Numeric: ...

    def work(self, share: Numeric) -> Numeric: ...

    def slope(self, share: Numeric) -> Numeric: ...


class Motion(NamedTuple):
    """The kinematics in force: piston path, velocity and acceleration, and 1 - cos φ at a path, None where no
    formula has it."""

    path: Formula
    velocity: Formula
    acceleration: Formula
    versine_at: Callable[[Numeric, Numeric], Numeric] | None = None


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
OFFSET = Motion(kinematics.offset_path, kinematics.offset_velocity, kinematics.offset_acceleration)


def mean_force(strokes: Sequence[Stroke], pi: Numeric, length: Numeric) -> Numeric:
    """Return the constant tangential force that does the work of all strokes of a cycle, two or four.

    `length` is that of the stroke in R. Source: Weisbach-Herrmann, § 150 (P π r for one stroke).
    """
    work = sum(one.work(1) for one in strokes)
    if len(strokes) == length == 2:
        return work / pi
    return work * length / (len(strokes) * pi)


def energy_swing(irregularity: Numeric, mean_torque: Numeric) -> Numeric:
    """Return ΔW = k P R in joules from k, the δ in units of P r/(m₁ v₁²), and P R in N m."""
    return irregularity * mean_torque


def moment_of_inertia(swing: Numeric, irregularity: Numeric, speed: Numeric) -> Numeric:
    """Return J = ΔW/(δ ω²) in kg m² that keeps (v_max - v_min)/v at δ; ΔW in J, ω in 1/s.

    First order in δ: the exact energy swing of a flywheel between ω(1 ± δ/2) is the same.
    Source: Weisbach-Herrmann, § 150, with m₁ r² = J.
    """
    return swing / (irregularity * speed * speed)


def root_speed(excess: Numeric, number: Numeric) -> Numeric:
    """Return v/v₁ = √(1 + 2 w/M), from ½ m₁ (v² - v₁²) = W; no number where the flywheel comes to rest.

    v₁ is the speed at the inner dead centre of the first crank. The excess w = W/(P r) is the work of the
    turning effort above its mean since then, in units of the mean torque; the number M = m₁ v₁²/(P r) is that
    of the flywheel, m₁ = J/r². Of a driven machine P is its magnitude.
    Source: Weisbach-Herrmann, § 150 (v = √(v₁² + 2 L/m₁)).
    """
    return root(1 + 2 * excess / number)


def first_order_speed(excess: Numeric, number: Numeric) -> Numeric:
    """Return v/v₁ = 1 + w/M, the root law to first order. Source: Weisbach-Herrmann, § 150."""
    return 1 + excess / number


def irregularity_of_mean(greatest: Numeric, least: Numeric) -> Numeric:
    """Return δ = (v_max - v_min)/v_m from the extreme speeds, v_m = ½ (v_max + v_min)."""
    return 2 * (greatest - least) / (greatest + least)


def number_of_mean(at_mean: Numeric, greatest: Numeric, least: Numeric) -> Numeric:
    """Return M of a flywheel that turns at a mean speed v_m = ½ (v_max + v_min), by the root law.

    `at_mean` is m₁ v_m²/(P r), above half the energy swing; `greatest` and `least` are the extremes of the
    excess. From v_max² - v_min² = 2 (w_max - w_min) and v_max + v_min = 2, in v_m. Re-derived.
    """
    swing = greatest - least
    fastest = 1 + swing / (2 * at_mean)
    return at_mean * fastest * fastest - 2 * greatest


def first_number_of_mean(at_mean: Numeric, greatest: Numeric, least: Numeric) -> Numeric:
    """Return the same where the speed is that of first order. Re-derived."""
    start = (1 + root(1 - 2 * (greatest + least) / at_mean)) / 2
    return at_mean * start * start
