"""Forces in the crank drive: of a force on the piston, of the weight of its masses, and friction of its pins.

Every function takes the `Circle` of the crank angle, the crank ratio λ = R/L and, for an offset crank,
η = e/R (None is the straight crank), and returns a number of the circle's kind: a float, an array, a ball or
a separation bound. Forces are in units of the piston force F, torques in units of F R. Without masses and
friction; with the masses see kernel/rod.py.

F acts along the slide and counts away from the dead centre, in the direction in which the piston moves: a
positive force drives the crank on either stroke. A negative ratio, with a negative offset, is the return
stroke, as in kernel/kinematics.py. All signs are those of the stroke in question, that is of a frame that has
the shaft for its origin, X along the slide towards its dead centre and Y towards the side on which the crank
pin runs: on the return stroke both point the other way. With a positive ratio and 0 to 360° everything is in
the one frame of the outstroke. Valid where the kinematics are.

Weight is by the slope of the slide, the angle by which X rises from the horizon, counted in the sense in
which the crank turns: at 90° the cylinder stands above the shaft, at 0° it lies, and the crank pin passes
above the shaft on the outstroke; at 180° it passes below. A weight G then acts as -G sin α along X and -G cos
α along Y. On the return stroke, whose frame points the other way, both change their sign. Re-derived.

The friction of the pins is by their circles: a pin of radius r with the coefficient of friction μ = tan ρ
carries its force not through its centre but along a tangent of the circle of friction, with the radius r sin
ρ, so that the force opposes the turning of one part in the other. The line of thrust of a rod without mass
touches the circles at both of its pins and leans from the line of their centres by ε, sin ε = -(k_A + k_B)/L
for a thrust: at the crank pin rod and crank always turn against each other, at the crosshead pin the rod
turns back where cos φ < 0. The shaft bears what the crank pin does, and its circle takes another part. The
crank turns in the sense from X to Y, over the whole turn in the frame of the outstroke. Lengths are in R,
torques in units of force times R. Source: the textbooks of the theory of machines; re-derived.

The turning of the crank by the piston force: tangential force and energy of one crank, over one stroke.

Forces are in units of the piston force Q before cut-off, energy in units of Q R. A stroke is known by the
net pressure on its piston over the share travelled, and the work of that pressure.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Generic, NamedTuple

from kurbel.kernel import kinematics, steam
from kurbel.kernel.circle import Circle, Kind, Numeric, cosine_of, root
from kurbel.kernel.kinematics import rod_slant

if TYPE_CHECKING:
    from kurbel.kernel.law import Stroke


def rod_force(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the force along the rod, F/cos ψ, a thrust on the outstroke and a pull on the return stroke.

    Floats: at most 1.5 ulp from the true value for |λ| <= 1/3, 3 ulp for |λ| <= 0.99; of an offset crank as
    close as `kinematics.offset_path`. Source: exercise "Kräfte am Kurbeltrieb", eq. (3).
    """
    return 1 / rod_slant(circle, ratio, offset).cosine


def guide_force(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the force of the guide on the crosshead, F tan ψ, positive towards the side of the crank pin.

    The crosshead presses the other way. Negative on the return stroke of the straight crank: there the pin
    runs on the other side, so the crosshead of an engine that drives lies against one face on both strokes.
    Floats: at most 1.5 ulp from the true value for |λ| <= 1/3, 5 ulp for |λ| <= 0.99; of an offset crank as
    close as `kinematics.offset_path`. Source: exercise "Kräfte am Kurbeltrieb", eq. (6).
    """
    slant = rod_slant(circle, ratio, offset)
    # No zero is to have a sign, and a negative ratio gives it one.
    if offset is not None:
        return slant.sine / slant.cosine + 0
    # The quotient outright reaches 3.1 ulp; 1/cos ψ is 1 + (1 - cos ψ)/cos ψ.
    share = slant.sine * slant.sine / ((1 + slant.cosine) * slant.cosine)
    return slant.sine + (slant.sine * share + ratio * circle.sine_tail) + 0


def tangential_force(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the force across the crank at its pin, F sin(φ + ψ)/cos ψ, positive as the crank turns.

    In units of F R it is the torque on the shaft. It is the piston velocity over v, by the principle of
    virtual displacements. Source: Rötscher, Zusammenstellung 112.
    """
    return kinematics.piston_velocity(circle, ratio, offset)


def radial_force(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the force along the crank at its pin, F cos(φ + ψ)/cos ψ, positive towards the shaft.

    F presses the pin towards the shaft at the dead centre that the stroke leaves, and pulls it away at the
    one it reaches. Floats: at most 2 ulp of max(|value|, 1) from the true value for |λ| <= 1/3, 5 ulp for
    |λ| <= 0.99; of an offset crank as close as `kinematics.offset_path`. Re-derived, as cos φ - sin φ tan ψ.
    """
    slant = rod_slant(circle, ratio, offset)
    return circle.cosine - circle.sine * (slant.sine / slant.cosine)


def square_position(ratio: Numeric) -> Circle[Numeric]:
    """Return the crank angle at which the rod touches the crank circle, square to the crank: tan ψ = λ.

    Then φ + ψ = 90°, sin φ = cos ψ and cos φ = sin ψ. Straight crank.
    Source: exercise "Kräfte am Kurbeltrieb", eq. (1) and (4).
    """
    sine = 1 / square_rod_force(ratio)
    return Circle(sine, ratio * sine, 1 - ratio * sine)


def square_rod_force(ratio: Numeric) -> Numeric:
    """Return F √(λ² + 1), the rod force in the square position, where it is the tangential force too.

    In units of F R it is the torque; the guide force is F λ and the radial force 0.
    Source: exercise "Kräfte am Kurbeltrieb", eq. (5), (9) and (11).
    """
    return root(ratio * ratio + 1)


class Weight(NamedTuple, Generic[Kind]):
    """The weights that act at the crank pin and at the crosshead, that of the reciprocating parts among the
    latter, as forces; sin α and cos α of the slope, both negative on the return stroke."""

    pin: Kind
    crosshead: Kind
    reciprocating: Kind
    along: Kind
    across: Kind


def on_return(weight: Weight[Numeric]) -> Weight[Numeric]:
    """Return the same in the frame of the return stroke."""
    return weight._replace(along=-1 * weight.along, across=-1 * weight.across)


def pin_torque(weight: Weight[Numeric], circle: Circle[Numeric]) -> Numeric:
    """Return the torque of the weight at the crank pin, over R."""
    return weight.pin * (weight.along * circle.sine - weight.across * circle.cosine)


def torque_slope(weight: Weight[Numeric], circle: Circle[Numeric], acceleration: Numeric) -> Numeric:
    """Return the change with the angle in radians of the torque of all weights, from the piston's
    acceleration."""
    at_pin = weight.pin * (weight.along * circle.cosine + weight.across * circle.sine)
    return weight.crosshead * weight.along * acceleration + at_pin


def work(
    weight: Weight[Numeric], circle: Circle[Numeric], path: Numeric, length: Numeric, returning: bool
) -> Numeric:
    """Return the work that weight has done on the masses since any fixed place, over R.

    All is in the frame of the stroke, which is the return stroke or not; `length` is that of the stroke.
    """
    at_pin = weight.pin * (weight.along * circle.cosine + weight.across * circle.sine)
    # On the return `along` has the other sign, also of what the outstroke has done.
    gone = path - length if returning else path
    return weight.crosshead * weight.along * gone - at_pin


class Circles(NamedTuple, Generic[Kind]):
    """The radii of the circles of friction at crosshead pin, crank pin and shaft."""

    crosshead: Kind
    crank: Kind
    shaft: Kind


def net_torque(
    circle: Circle[Numeric],
    ratio: Numeric,
    offset: Numeric | None,
    thrust: Numeric,
    circles: Circles[Numeric],
) -> Numeric:
    """Return the torque on the shaft that a force on the rod's crosshead end along the slide makes, positive
    against X, less what the friction of the pins takes.

    Where the rod turns its swing round, that of the swing which begins there counts.
    """
    # The circle at the crosshead pin is touched on the other side as the rod swings back.
    swing = _chosen(circle.cosine, circles.crosshead, -circles.crosshead, circle.sine)
    lean = ratio * (circles.crank + swing)
    lost = circles.crank + circles.shaft
    pushed = _by_thrust(circle, ratio, offset, -lean, -lost)
    pulled = _by_thrust(circle, ratio, offset, lean, lost)
    return _chosen(thrust, thrust * pushed, thrust * pulled, 0 * thrust)


def _by_thrust(
    circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None, lean: Numeric, lost: Numeric
) -> Numeric:
    """Return (sin(φ + ψ + ε) + lost)/cos(ψ + ε), the torque of a unit thrust, from sin ε."""
    slant, upright = rod_slant(circle, ratio, offset), cosine_of(lean)
    sine = slant.sine * upright + slant.cosine * lean
    cosine = slant.cosine * upright - slant.sine * lean
    return circle.sine + (circle.cosine * sine + lost) / cosine


def _chosen(sign: Any, above: Any, below: Any, falling: Any) -> Numeric:
    """Return what belongs to a sign: at 0 to that which follows where `falling` is the slope downwards. A
    ball that holds 0 has both, and so has a separation bound."""
    if hasattr(sign, "shape"):
        import numpy as np

        return np.where((sign > 0) | ((sign == 0) & (falling <= 0)), above, below)
    if hasattr(sign, "union") and not hasattr(sign, "rad"):
        return above.union(below)
    if sign > 0:
        return above
    if sign < 0:
        return below
    if sign == 0 and (falling > 0 or falling <= 0):
        return below if falling > 0 else above
    return above.union(below)


# Of the circle, λ and, of an offset crank, e/R.
Formula = Callable[..., Numeric]


class Motion(NamedTuple):
    """The kinematics in force: piston path, velocity and acceleration, and of the straight crank 1 - cos φ at
    a path."""

    path: Formula
    velocity: Formula
    acceleration: Formula
    versine_at: Callable[[Numeric, Numeric], Numeric]


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
