"""Irregularity of the double-acting engine with one crank: extreme speeds and δ, for arrays.

Angles, paths and forces count as in half_tangent.py, work is in their units times r.

Two angles are enough. At any place of its stroke the piston of the outstroke has turned the crank by less
than that of the return stroke; as the excess work is a function of the place, less P times the angle, the
maximum is the outstroke's and the minimum the return stroke's. Work is stationary at the roots T, so that
1e-8 of T is as good as all digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, partial
from math import inf
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.kernel.half_tangent import (
    TWO_OVER_PI,
    ExactMotion,
    FirstOrderMotion,
    Floats,
    Load,
    Motion,
    Place,
    Relation,
    WeisbachRelation,
    work_left,
)
from kurbel.kernel.loops import compiled, written_formula
from kurbel.kernel.trace import Traced

# A step that changes T by this share leaves less than 1e-8 of it to be found.
SETTLED = 1e-4
# Ten are enough; within 1e-11 of the back pressure that stops the engine rounding never settles, nor matters.
MOST_STEPS = 60
# To a sixteenth of T or sixteen times T; where the slope is next to nothing, for λ near 1, steps go too far.
LONGEST_STEP = 0.6
# A third of T, where the force is no straight line.
SHORT_STEP = 0.1
# Of the first guess of T: nearer to nothing no search begins.
LEAST_SHARE = 1e-9


class Extremes(NamedTuple):
    """Where the speed is greatest, on the outstroke, and where it is least."""

    falling: Place
    rising: Place
    beyond: Floats
    """By how much T is greater than before the cut-off."""
    restless: Floats
    """Not above 0 where the greatest speed has settled."""


class Arithmetic(NamedTuple):
    """What computes: NumPy, operation by operation, or the same formulas in one loop over the engines."""

    extremes: Callable[[type[Motion], Floats, Load], Extremes]
    irregularity: Callable[..., Floats]


def extremes(kind: type[Motion], ratio: Floats, load: Load) -> Extremes:
    """Return where the speed is greatest and least, of nearly all engines settled."""
    motion = kind(ratio)
    least = motion.least(load.mean / load.net)
    balanced, before, beyond = _approach(motion, load)
    change, most = beyond - before, _bounded(motion, load, balanced + beyond)
    restless = change * change - (SETTLED * before) ** 2
    # Before the cut-off the greatest speed is where the velocity is that of the least one, so at the same
    # T; the force of steam that expands would be above P there.
    falling, rising = motion.place(np.maximum(most, least)), motion.place(least)
    return Extremes(falling, rising, most - least, restless)


def _approach(relation: Relation, load: Load) -> tuple[Floats, Floats, Floats]:
    """Return T where steam and back pressure balance, and T less that before and after the last step."""
    balanced = relation.balanced(load)
    before = beyond = _begun(relation, load, balanced)
    for _ in range(relation.steps):
        before, beyond = beyond, _nearer(relation, load, balanced, beyond)
    return balanced, before, beyond


def _begun(relation: Relation, load: Load, balanced: Floats) -> Floats:
    near = relation.near(load, balanced)
    if load.plain or isinstance(relation, WeisbachRelation):
        return near
    # Not before the cut-off, where the force of steam that expands may have other roots.
    return np.minimum(near, np.maximum(relation.at(load.expansion - 1) - balanced, LEAST_SHARE * near))


def _bounded(motion: Motion, load: Load, most: Floats) -> Floats:
    """Return T, but none before the cut-off where that could be another root."""
    return most if load.plain else np.minimum(most, motion.at(load.expansion - 1))


def greatest(relation: Relation, load: Load) -> Floats:
    """Return the one T at which the force of the expanding steam is its mean, on the way to the end."""
    balanced, before, beyond = _approach(relation, load)
    left = np.flatnonzero(~(abs(beyond - before) <= SETTLED * before))
    if left.size:
        few, forces = _few(type(relation), relation.ratio, load, left, beyond.shape)
        resting = np.broadcast_to(balanced, beyond.shape)[left]
        beyond[left] = _settled(partial(_nearer, few, forces, resting), beyond[left])
    return balanced + beyond


def _few(
    kind: Callable[[Floats], Any], ratio: Floats, load: Load, left: NDArray[np.int64], shape: tuple[int, ...]
) -> tuple[Any, Load]:
    """Return the relation and the forces of these engines alone."""

    def those(number: Any) -> Any:
        alike = number is None or isinstance(number, float)
        return number if alike else np.broadcast_to(number, shape)[left]

    return kind(those(ratio)), Load(*map(those, load))


def _settled(step: Callable[[Floats], Floats], beyond: Floats) -> Floats:
    """Return T - balanced at the roots of the few that need more steps: without back pressure, λ near 1."""
    moving = np.ones(beyond.shape, bool)
    for _ in range(MOST_STEPS):
        # Who has settled stays: no value may depend on those computed beside it.
        nearer = np.where(moving, step(beyond), beyond)
        moving &= abs(nearer - beyond) > SETTLED * beyond
        beyond = nearer
        if not moving.any():
            break
    return beyond


def _nearer(relation: Relation, load: Load, balanced: Floats, beyond: Floats) -> Floats:
    """Return T - balanced nearer to the root.

    Newton's step for ln(force/mean) on ln √(T - balanced), which is nearly straight. The logarithm is
    2(force - mean)/(force + mean), and e^-2x is (1 - x)/(1 + x), both exact to third order.
    """
    slope, above = _height(relation, load, balanced + beyond, beyond)
    step = np.minimum(np.maximum(above / slope, -LONGEST_STEP), LONGEST_STEP)
    if not load.plain:
        # With clearance, or where steam expands slowly, there is a greatest force, and a root beyond it.
        step = np.where(slope > 0, step, LONGEST_STEP)
    factor = (1 - step) / (1 + step)
    return beyond * (factor * factor)


def _later(motion: Motion, load: Load, tangent: Floats) -> Floats:
    """Return T nearer to where the force rises to its mean, from before it.

    Beyond the cut-off the force may fall at first, and beyond the root it falls again: steps are short.
    """
    slope, above = _height(motion, load, tangent, tangent)
    # Where the force falls, it is below its mean before the root and above it beyond.
    falling = np.copysign(inf, above)
    step = np.where(slope > 0, above / slope, falling)
    step = np.minimum(np.maximum(step, -SHORT_STEP), SHORT_STEP)
    factor = (1 - step) / (1 + step)
    return tangent * (factor * factor)


def _height(relation: Relation, load: Load, tangent: Floats, beyond: Floats) -> tuple[Floats, Floats]:
    """Return the slope of the force on ln √(T - balanced) and how far it is above its mean."""
    pull = relation.pull(tangent, load)
    slope = pull.growth * beyond * (pull.force + pull.mean)
    return slope, tangent * pull.margin * (pull.force - pull.mean)


def excess(share: Floats, angle: Floats, left: Floats, load: Load, expanding: Floats) -> Floats:
    """Return the excess work of the outstroke at a place, the steam expanding where that is above 0.

    Zero at the dead centres; `left` is the work left to the steam that expands. Source: Weisbach-Herrmann,
    § 150, with 1 + ln ε = πP/2 + b put in.
    """
    # Counted from the end of the stroke, the work has no large terms to cancel.
    expanded = load.back * share - left
    full = load.forgone - load.net * share
    return load.mean * angle + 2 * np.where(expanding > 0, expanded, full)


def deficit(share: Floats, angle: Floats, load: Load) -> Floats:
    """Return the excess work of the return stroke before the cut-off, with its sign changed."""
    return load.mean * angle - 2 * (load.net * share)


def irregularity(
    load: Load,
    expanding: Floats,
    share: Floats,
    angle: Floats,
    least_share: Floats,
    least_angle: Floats,
    left: Floats,
) -> Floats:
    """Return δ from the shares and angles of both places and the work that is left at the greatest speed."""
    gained = excess(share, angle, left, load, expanding)
    return (gained + deficit(least_share, least_angle, load)) / load.mean


def true_irregularity(kind: type[Motion], ratio: Floats, load: Load, by: Arithmetic) -> Floats:
    """Return δ, in units of P r/(m₁ v₁²), from the true extremes of the excess work of a motion."""
    falling, rising, beyond, restless = by.extremes(kind, ratio, load)
    left = work_left(falling.share, load)
    found = by.irregularity(load, beyond, falling.share, falling.angle, rising.share, rising.angle, left)
    rare = ~(restless <= 0)
    if not load.plain:
        rare |= rising.share * load.expansion > 1
    few = np.flatnonzero(rare)
    if few.size:
        found[few] = _rare(*_few(kind, ratio, load, few, found.shape))
    return found


def _rare(motion: Motion, load: Load) -> Floats:
    """Return δ of engines that want more steps, or have their least speed when the cut-off is over."""
    least = motion.least(load.mean / load.net)
    most = _bounded(motion, load, greatest(motion, load))
    falling, rising = motion.place(np.maximum(most, least)), motion.place(least)
    lacking = deficit(rising.share, rising.angle, load)
    late = np.flatnonzero(rising.share * load.expansion > 1)
    if late.size and not load.plain:
        few, forces = _few(type(motion), motion.ratio, load, late, least.shape)
        lacking[late] = _late_deficit(few, forces, least[late])
    gained = excess(falling.share, falling.angle, work_left(falling.share, load), load, most - least)
    return (gained + lacking) / load.mean


def _late_deficit(motion: Motion, load: Load, full: Floats) -> Floats:
    """Return the deficit of the return stroke where steam that expands has its mean force again.

    Full pressure would have it at T = full already.
    """
    # The return stroke begins where the volume is 1 - κ₁.
    back = load._replace(dead=np.ones_like(full), swept=-load.swept)
    place = motion.place(_settled(partial(_later, motion, back), full))
    rest = 1 - place.share
    done = load.mean / TWO_OVER_PI + load.back * rest - work_left(rest, load)
    return load.mean * place.angle - 2 * done


def weisbach(ratio: Floats, load: Load, _: Arithmetic) -> Floats:
    """Return δ for first-order kinematics at the angles of his equations, in units of P r/(m₁ v₁²)."""
    # No true maxima, hence either stroke's may be the greater one.
    velocity = load.mean / load.net
    motions = FirstOrderMotion(ratio), FirstOrderMotion(-ratio)
    least = motions[0].least(velocity)
    tops = _related(motions[0], least, load), _related(motions[1], motions[1].least(velocity), load)
    place = motions[0].place(least)
    return (np.maximum(*tops) + deficit(place.share, place.angle, load)) / load.mean


def _related(motion: FirstOrderMotion, falling: Floats, load: Load) -> Floats:
    """Return the excess work at his α₂, or before the cut-off at the falling root of his equation for α₁."""
    beyond = motion.admitted(falling) * load.expansion > 1
    chosen = np.where(beyond, greatest(WeisbachRelation(motion.ratio), load), falling)
    place = motion.place(chosen)
    left, expanding = work_left(place.share, load), motion.admitted(chosen) * load.expansion - 1
    return excess(place.share, place.angle, left, load, expanding)


BY_NUMPY = Arithmetic(extremes, irregularity)
METHODS: Mapping[str, Callable[[Floats, Load, Arithmetic], Floats]] = {
    "exact": partial(true_irregularity, ExactMotion),
    "series": partial(true_irregularity, FirstOrderMotion),
    "weisbach": weisbach,
}
"""δ in units of P r/(m₁ v₁²) from λ and the forces, by method and what computes it."""


Constants: TypeAlias = tuple[tuple[str, float], ...]

# What the extremes ask of a load, and what δ does.
FORCES = ("back", "net", "mean", "over", "dead", "swept", "bend")
WORK = ("back", "net", "mean", "forgone")


def extremes_in_loops(kind: type[Motion], ratio: Floats, load: Load) -> Extremes:
    """Return what `extremes` returns, to the bit."""
    if load.exponent is not None:
        # Powers are those of NumPy.
        return extremes(kind, ratio, load)
    # Without clearance nothing asks where the cut-off is.
    arrays, floats = _sorted(load, FORCES if load.plain else ("expansion", *FORCES))
    motion: Any = kind
    rows = _filled(_extremes_loop(motion, tuple(arrays), floats), 8, [ratio, *arrays.values()])
    return Extremes(Place(*rows[:3]), Place(*rows[3:6]), *rows[6:])


def irregularity_in_loops(load: Load, *given: Floats) -> Floats:
    """Return what `irregularity` returns, to the bit."""
    arrays, floats = _sorted(load, WORK)
    return _filled(_irregularity_loop(tuple(arrays), floats), 1, [*given, *arrays.values()])[0]


BY_LOOPS = Arithmetic(extremes_in_loops, irregularity_in_loops)


def _sorted(load: Load, names: Sequence[str]) -> tuple[dict[str, Floats], Constants]:
    given = {name: getattr(load, name) for name in names}
    arrays = {name: one for name, one in given.items() if not isinstance(one, float)}
    return arrays, tuple((name, one) for name, one in given.items() if isinstance(one, float))


def _filled(run: Callable[..., None], rows: int, given: Sequence[Floats]) -> list[Any]:
    size = max(one.size for one in given)
    arrays = [np.require(np.broadcast_to(one, size), np.float64, ("C", "A")) for one in given]
    filled = [np.empty(size) for _ in range(rows)]
    run(np.empty(0), *arrays, *filled)
    return filled


def _load(arrays: Sequence[str], floats: Constants, numbers: Sequence[Traced]) -> Load:
    unknown: dict[str, Any] = dict.fromkeys(Load._fields)
    return Load(**unknown | dict(floats) | dict(zip(arrays, numbers, strict=True)))


@lru_cache(maxsize=64)
def _extremes_loop(kind: Any, arrays: tuple[str, ...], floats: Constants) -> Callable[..., None]:
    def formula(ratio: Any, *more: Traced) -> list[object]:
        falling, rising, *rest = extremes(kind, ratio, _load(arrays, floats, more))
        return [*falling, *rising, *rest]

    return compiled(written_formula(formula, 1 + len(arrays)))


@lru_cache(maxsize=64)
def _irregularity_loop(arrays: tuple[str, ...], floats: Constants) -> Callable[..., None]:
    def formula(*numbers: Any) -> list[object]:
        return [irregularity(_load(arrays, floats, numbers[6:]), *numbers[:6])]

    return compiled(written_formula(formula, 6 + len(arrays)))
