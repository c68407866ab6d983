"""Irregularity δ of the double-acting engine with one crank, for arrays: extreme speeds and the work between.

All counts from the outer dead centre: the crank angle β, forward on the return stroke and backward on the
outstroke, and the share of the stroke. Unknown is τ, the tangent of half an angle: a step to a root takes
+ - * / and a square root. Forces are in units of the pressure of the steam at the end of the stroke, Q/ε for
Mariotte's law without clearance, volumes in units of that at the end, work in units of this force times r.

Two angles are enough. At any place of its stroke the piston of the outstroke has turned the crank by less
than that of the return stroke; as the excess work is a function of the place, less P times the angle, the
maximum is the outstroke's and the minimum the return stroke's. Work is stationary at both, so that 1e-8 of τ
is as good as all digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.kernel.circle import root
from kurbel.kernel.loops import rows_of

Floats: TypeAlias = NDArray[np.float64]

TWO_OVER_PI = 0.6366197723675814
# Steps for all engines, four times as many for a few in a thousand, and so on; the most are for λ within 1e-9
# of 1 where the steam expands steeply.
STEPS, MOST_STEPS = 4, 256
# A last step of this share of τ leaves less than 1e-8 of it to be found.
SETTLED = 1e-4
# Of ln τ, halved: to a quarter of τ or four times τ.
LONGEST_STEP = 0.6
# A dead centre, nearly.
NEAR: Any = 1e-10


class Engine(NamedTuple):
    """λ, ε, the back pressure, the steam before the cut-off less that, the mean tangential force P, half the
    work that steam admitted to the end of a stroke would do beyond this, the volumes left at the inner dead
    centre and swept, and n of p V^n = const, None for 1 everywhere."""

    ratio: Floats
    expansion: Floats
    back: Floats | float
    net: Floats
    mean: Floats
    forgone: Floats
    dead: Floats | float
    swept: Floats | float
    exponent: Floats | None = None


def engine(
    eps: Floats,
    ratio: Floats,
    back: Floats | None = None,
    clearance: Floats | float = 0.0,
    exponent: Floats | None = None,
) -> Engine:
    """Return the engine of ε, λ, the back pressure b = R/Q, the clearance κ as a share of the stroke and n.

    None for b is the best one, for n 1. Source: Weisbach-Herrmann, § 150, P = (2/π)(1 + ln ε - εb) Q/ε;
    clearance and exponent re-derived.
    """
    # The steam grows to 1 + growth times its volume at cut-off, the pressure falls from 1 + rise to 1.
    growth = (eps - 1) / (1 + clearance * eps)
    rise = gain = logarithm = np.log1p(growth)
    if exponent is None or np.all(exponent == 1):
        rise, exponent = growth, None
    else:
        # Engines of n = 1 have the same bits among others.
        rise = np.where(exponent == 1, growth, np.expm1(exponent * logarithm))
        gain = exponent * risen(logarithm, exponent)
    whole = 1 + clearance
    # Nothing but b takes digits away: this is a sum of what vanishes where nothing expands.
    best, forgone = whole * gain - clearance * rise, whole * (rise - gain)
    loss = 1.0 if back is None else (1 + rise) * back
    net = rise if back is None else (1 + rise) * (1 - back)
    mean = TWO_OVER_PI * (best + (1 - loss))
    return Engine(ratio, eps, loss, net, mean, forgone, clearance / whole, 1 / whole, exponent)


def risen(logarithm: Floats, exponent: Floats) -> Floats:
    """Return the work (V^(1-n) - 1)/(n - 1) for -ln V, which is this itself for n = 1."""
    curve = (exponent - 1) * logarithm
    straight = curve == 0
    return logarithm * np.where(straight, 1.0, np.expm1(curve) / np.where(straight, 1.0, curve))


def work_left(share: Floats, rest: Floats, of: Engine) -> Floats:
    """Return half the work of the steam that expands while the piston has a share of the stroke to go."""
    # By the share that the volume has still to grow both small and large ones keep their digits.
    logarithm = np.log1p(of.swept * share / (of.dead + of.swept * rest))
    return (logarithm if of.exponent is None else risen(logarithm, of.exponent)) / of.swept


class Place(NamedTuple):
    """Where the piston is: tan β/2, the shares of the stroke to the outer dead centre and to the inner one,
    the velocity, and the share that the steam of the outstroke fills; by ln τ the slope of the velocity's
    logarithm, and how much this share falls."""

    angle: Floats
    share: Floats
    rest: Floats
    velocity: Floats
    rise: Floats
    filled: Floats
    fall: Floats


def first_order(ratio: Floats, tangent: Floats) -> Place:
    """Return the place at τ = tan β/2 by first-order kinematics; -λ exchanges the strokes.

    Source: Weisbach-Herrmann, § 150, s = 1 - cos α ∓ ½ λ sin² α.
    """
    half = 1 / (1 + tangent * tangent)
    other = tangent * tangent * half
    rod, square = (1 - ratio) + 2 * ratio * other, 4 * (half * other)
    share, rest = other * ((1 - ratio) + ratio * other), half * (1 + ratio * other)
    velocity, rise = 2 * tangent * half * rod, (half - other) + ratio * square / rod
    return Place(tangent, share, rest, velocity, rise, rest, square * rod / 2)


def of_weisbach(ratio: Floats, tangent: Floats) -> Place:
    """Return this place with the share filled that stands in Weisbach's equation for cotg(α₂/2).

    λ is in place of λ/(1 + λ cos²(α₂/2)). Source: Weisbach-Herrmann, § 150.
    """
    place, half = first_order(ratio, tangent), 1 / (1 + tangent * tangent)
    rod = 1 - ratio * half
    filled = place.velocity / (2 * tangent * rod)
    fall = filled * (1 + 2 * ratio * half * (1 - half) / rod - place.rise)
    return place._replace(filled=filled, fall=fall)


def exact(ratio: Floats, tangent: Floats) -> Place:
    """Return the place at τ = tan θ/2, cos θ = cos β/cos ψ.

    Re-derived: in θ the velocity is sin θ √((1 - λ cos θ)/(1 + λ cos θ)), and nothing is steep where λ is
    near 1. tan² β/2 is by the law of cosines.
    """
    half = 1 / (1 + tangent * tangent)
    other = tangent * tangent * half
    short, height = 1 - ratio, root((1 - ratio) * (1 + ratio))
    far, close = short + 2 * ratio * half, short + 2 * ratio * other
    less, square, slope = 1 / (far * close), 4 * (half * other), height / (1 + ratio)
    rod = close * root(less)
    share, rest = 2 * other * slope / (far * (slope + rod)), 2 * half / (far * (1 + slope * rod))
    angle = root(share * (1 + ratio * share) / (rest * (short + ratio * share)))
    velocity, rise = 2 * tangent * half * rod, (half - other) + ratio * square * less
    return Place(angle, share, rest, velocity, rise, rest, square * height * rod * less / 2)


Motion: TypeAlias = Callable[[Floats, Floats], Place]
Steam: TypeAlias = Callable[[Place, Engine], tuple[Floats | float, Floats | float]]


def expanding(place: Place, of: Engine) -> tuple[Floats, Floats]:
    """Return the pressure of the expanding steam on the outstroke, and the slope of its logarithm on ln τ."""
    less = 1 / (of.dead + of.swept * place.filled)
    slope = of.swept * place.fall * less
    return (less, slope) if of.exponent is None else (less**of.exponent, of.exponent * slope)


def returning(place: Place, of: Engine) -> tuple[Floats, Floats]:
    """Return both of the steam that expands on the return stroke."""
    return expanding(place._replace(filled=place.share, fall=-place.fall), of)


def nearer(tangent: Floats, motion: Motion, steam: Steam, of: Engine) -> Floats:
    """Return τ nearer to where the force of the steam rises to its mean.

    Newton's step for the logarithm of pressure × velocity : (mean + back × velocity), which rises from τ = 0
    on. Of such a ratio r the logarithm is 2(r - 1)/(r + 1), and e^2x is (1 + x)/(1 - x), nearly.
    """
    place = motion(of.ratio, tangent)
    pressure, slope = steam(place, of)
    pull, against = pressure * place.velocity, of.mean + of.back * place.velocity
    rise, both = slope * against + place.rise * of.mean, pull + against
    # Where it falls, the root lies behind; but ahead of a return stroke that is below its mean.
    whole = both * np.maximum(rise, 1e-150)
    lowest = whole if steam is returning else both * rise
    step = np.minimum(np.maximum((pull - against) * against, -LONGEST_STEP * lowest), LONGEST_STEP * whole)
    return tangent * ((whole - step) / (whole + step))


def settled(tangent: Floats, motion: Motion, steam: Steam, of: Engine, steps: int) -> tuple[Floats, Floats]:
    """Return τ after so many steps, and what is not above 0 where it has settled."""
    before = tangent
    for _ in range(steps):
        before, tangent = tangent, nearer(tangent, motion, steam, of)
    return tangent, np.abs(tangent - before) - SETTLED * before


def farther(tangent: Floats, motion: Motion, of: Engine) -> Floats:
    """Return τ of the greatest speed, nearly, from one before it: z times this, at most to the cut-off."""
    place = motion(of.ratio, tangent)
    share = place.share / place.rest
    rise = of.swept * share
    # The velocity goes with z, the pressure is nearly 1 + z² rise, so that z³ + excess z = force. The cube
    # root is near the power 5/16.
    force, excess = of.mean / place.velocity / rise, (1 - of.back) / rise
    fourth = root(root(force))
    third = fourth * root(root(fourth))
    times = force / (third * third + np.maximum(excess, 0)) + root(np.maximum(-excess, 0))
    return tangent * np.maximum(np.minimum(times, root(of.expansion - 1) / root(share)), 1)


def extremes(motion: Motion, of: Engine, steps: int = STEPS) -> Sequence[Floats]:
    """Return what is not above 0 where both extreme speeds have settled; τ, tan β/2 and both shares of the
    least one, on the return stroke before the cut-off; the last three of the greatest one, on the outstroke.
    """
    wanted = of.mean / of.net
    # Nearly, the velocity is 2τ √(τ² + (its slope)²).
    square = (motion(of.ratio, NEAR).velocity / (2 * NEAR)) ** 2
    least = wanted / root(2 * (square + root(square * square + wanted * wanted)))
    most = farther(np.maximum(least, NEAR), motion, of)
    # Before the cut-off all pressures stay as they are, here in units of P, and a step less is enough.
    unit: Any = 1.0
    free = of._replace(mean=unit, back=0.0)
    least, restless = settled(least, motion, lambda *_: (unit / wanted, 0.0), free, steps - 1)
    most, change = settled(most, motion, expanding, of, steps)
    if motion is of_weisbach:
        # His angle is no true extreme, near which the work would not change: all its digits count.
        most = nearer(most, motion, expanding, of)
    rising = motion(of.ratio, least)[:3]
    # Before the cut-off the greatest speed is where the velocity is that of the least one, so at the same τ.
    is_expanding = rising[2] * of.expansion > 1
    most, change = np.where(is_expanding, most, least), np.where(is_expanding, change, restless)
    return [np.maximum(restless, change), least, *rising, *motion(of.ratio, most)[:3]]


def rows(motion: Motion, of: Engine, fast: bool = False, steps: int = STEPS) -> Floats:
    """Return what `extremes` returns as rows, by numba if `fast`, with the same bits; powers are NumPy's."""
    if fast and of.exponent is None:
        found = _loop(motion)(*np.broadcast_arrays(*of[:-1]))
    else:
        found = np.array(extremes(motion, of, steps))
    few = np.flatnonzero(~(found[0] <= 0))
    if few.size and steps < MOST_STEPS:
        found[:, few] = rows(motion, _those(of, few), steps=4 * steps)
    return found


@cache
def _loop(motion: Motion) -> Callable[..., Floats]:
    return rows_of(lambda *numbers: extremes(motion, Engine(*numbers)), len(Engine._fields) - 1)


def _those(of: Engine, few: NDArray[np.int64]) -> Engine:
    """Return these engines alone."""
    those: Any = [one if one is None else np.broadcast_to(one, of.mean.shape)[few] for one in of]
    return Engine(*those)


def excess(motion: Motion, of: Engine, fast: bool) -> tuple[Floats, Floats]:
    """Return the greatest excess work and the least one with its sign changed, in units of P r.

    Zero at the outer dead centre. Source: Weisbach-Herrmann, § 150, with 1 + ln ε = πP/2 + b put in.
    """
    _, least, rising, passed, _, falling, share, rest = rows(motion, of, fast)
    # Counted from the end of the stroke, the work of the steam that expands has no large terms to cancel.
    expanded, full = of.back * share - work_left(share, rest, of), of.forgone - of.net * share
    gained, lacking = np.where(rest * of.expansion > 1, expanded, full), -of.net * passed
    # Where steam admitted so long would have its mean force, that which expands has it later.
    late = np.flatnonzero(passed * of.expansion > 1)
    if late.size:
        few = _those(of, late)
        place = motion(few.ratio, settled(least[late], motion, returning, few, MOST_STEPS)[0])
        rising[late], left = place.angle, work_left(place.rest, place.share, few) - few.back * place.rest
        lacking[late] = left - few.mean / TWO_OVER_PI
    return 2 * (np.arctan(falling) + gained / of.mean), 2 * (np.arctan(rising) + lacking / of.mean)


def irregularity(motion: Motion, of: Engine, fast: bool = False) -> Floats:
    """Return δ in units of P r/(m₁ v₁²), by numba if `fast`."""
    greatest, deficit = excess(motion, of, fast)
    if motion is of_weisbach:
        # No true maxima, hence the angles count in full, and either stroke's may be the greater one.
        greatest = np.maximum(greatest, excess(motion, of._replace(ratio=-of.ratio), fast)[0])
    return greatest + deficit


METHODS: Mapping[str, Motion] = {"exact": exact, "series": first_order, "weisbach": of_weisbach}
