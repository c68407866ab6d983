"""Irregularity of the double-acting engine with one crank: forces, extreme speeds and δ, for arrays.

Angles, paths and forces count as in half_tangent.py, work is in units of (Q/ε) r.

Two angles are enough. At any place of its stroke the piston of the outstroke has turned the crank by less
than that of the return stroke; as the excess work is a function of the place, less P times the angle, the
maximum is the outstroke's and the minimum the return stroke's. Work is stationary at the roots T, so that
1e-8 of T is as good as all digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from kurbel.kernel.circle import Number
from kurbel.kernel.half_tangent import (
    ExactMotion,
    FirstOrderMotion,
    Load,
    Motion,
    Place,
    Relation,
    WeisbachRelation,
)

# A step that changes T by this share leaves less than 1e-8 of it to be found.
SETTLED = 1e-4
# Ten are enough; within 1e-11 of the back pressure that stops the engine rounding never settles, nor matters.
MOST_STEPS = 20
# To a sixteenth of T or sixteen times T; where the slope is next to nothing, for λ near 1, steps go too far.
LONGEST_STEP = 0.6


def greatest(kind: type[Relation], ratio: Number, load: Load) -> Number:
    """Return the one T at which the force of the expanding steam is its mean."""
    relation = kind(ratio)
    balanced = relation.balanced(load.back)
    beyond = relation.near(load, balanced)
    for _ in range(kind.steps):
        before, beyond = beyond, _nearer(relation, load, balanced, beyond)
    left = ~(abs(beyond - before) <= SETTLED * before)
    if left.any():
        few_ratios, few_balanced, *few_forces = (
            np.broadcast_to(number, left.shape)[left] for number in (ratio, balanced, *load)
        )
        beyond[left] = _settled(kind(few_ratios), Load(*few_forces), few_balanced, beyond[left])
    return balanced + beyond


def _settled(relation: Relation, load: Load, balanced: Number, beyond: Number) -> Number:
    """Return T - balanced at the roots of the few that need more steps: without back pressure, λ near 1."""
    moving = np.ones(beyond.shape, bool)
    for _ in range(MOST_STEPS):
        # Who has settled stays: no value may depend on those computed beside it.
        nearer = np.where(moving, _nearer(relation, load, balanced, beyond), beyond)
        moving &= abs(nearer - beyond) > SETTLED * beyond
        beyond = nearer
        if not moving.any():
            break
    return beyond


def _nearer(relation: Relation, load: Load, balanced: Number, beyond: Number) -> Number:
    """Return T - balanced nearer to the root.

    Newton's step for ln(force/mean) on ln √(T - balanced), which is nearly straight. The logarithm is
    2(force - mean)/(force + mean), and e^-2x is (1 - x)/(1 + x), both exact to third order.
    """
    tangent = balanced + beyond
    pull = relation.pull(tangent, load)
    slope = pull.growth * beyond * (pull.force + pull.mean)
    above = tangent * pull.margin * (pull.force - pull.mean)
    step = np.clip(above / slope, -LONGEST_STEP, LONGEST_STEP)
    factor = (1 - step) / (1 + step)
    return beyond * (factor * factor)


def excess(place: Place, load: Load, expanding: Number) -> Number:
    """Return the excess work of the outstroke at a place, with the steam expanding or before the cut-off.

    Zero at the dead centres. Source: Weisbach-Herrmann, § 150, with 1 + ln ε = πP/2 + b put in.
    """
    # Counted from the end of the stroke, the work has no large terms to cancel.
    expanded = np.log1p(-place.share) + load.back * place.share
    full = load.forgone - load.net * place.share
    return load.mean * place.angle + 2 * np.where(expanding, expanded, full)


def deficit(place: Place, load: Load) -> Number:
    """Return the excess work of the return stroke before the cut-off, with its sign changed."""
    return load.mean * place.angle - 2 * (load.net * place.share)


def true_irregularity(kind: type[Motion], ratio: Number, load: Load) -> Number:
    """Return δ, in units of P r/(m₁ v₁²), from the true extremes of the excess work of a motion."""
    motion = kind(ratio)
    least = motion.least(load.mean / load.net)
    most = greatest(kind, ratio, load)
    # Before the cut-off the greatest speed is where the velocity is that of the least one, so at the same
    # T; the force of steam that expands would be above P there.
    place = motion.place(np.maximum(most, least))
    return (excess(place, load, most > least) + deficit(motion.place(least), load)) / load.mean


def weisbach(ratio: Number, load: Load) -> Number:
    """Return δ for first-order kinematics at the angles of his equations, in units of P r/(m₁ v₁²)."""
    # No true maxima, hence either stroke's may be the greater one.
    velocity = load.mean / load.net
    motions = FirstOrderMotion(ratio), FirstOrderMotion(-ratio)
    least = motions[0].least(velocity)
    tops = _related(motions[0], least, load), _related(motions[1], motions[1].least(velocity), load)
    return (np.maximum(*tops) + deficit(motions[0].place(least), load)) / load.mean


def _related(motion: FirstOrderMotion, falling: Number, load: Load) -> Number:
    """Return the excess work at his α₂, or before the cut-off at the falling root of his equation for α₁."""
    beyond = motion.admitted(falling) * load.expansion > 1
    chosen = np.where(beyond, greatest(WeisbachRelation, motion.ratio, load), falling)
    return excess(motion.place(chosen), load, motion.admitted(chosen) * load.expansion > 1)


METHODS: Mapping[str, Callable[[Number, Load], Number]] = {
    "exact": partial(true_irregularity, ExactMotion),
    "series": partial(true_irregularity, FirstOrderMotion),
    "weisbach": weisbach,
}
"""δ in units of P r/(m₁ v₁²) from λ and the forces, by method."""
