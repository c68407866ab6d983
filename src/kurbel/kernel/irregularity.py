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
from functools import cache, partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.kernel.circle import root
from kurbel.kernel.loops import compiled, written_formula

Floats: TypeAlias = NDArray[np.float64]

TWO_OVER_PI = 0.6366197723675814
# Steps for all engines; for a few in a thousand; where λ is within 1e-9 of 1 and the steam expands steeply.
STEPS, MORE_STEPS, MOST_STEPS = 4, 12, 200
# A last step of this share of τ leaves less than 1e-8 of it to be found.
SETTLED = 1e-4
# Of ln τ, halved: to a quarter of τ or four times τ.
LONGEST_STEP = 0.6
# A dead centre, nearly.
NEAR: Any = 1e-10


class Load(NamedTuple):
    """What acts on the piston: ε, the back pressure, the steam before the cut-off less that, the mean
    tangential force P, half the work that steam admitted to the end of a stroke would do beyond this, the
    volumes left at the inner dead centre and swept, and n of p V^n = const, None for 1 everywhere."""

    expansion: Floats
    back: Floats | float
    net: Floats
    mean: Floats
    forgone: Floats
    dead: Floats | float
    swept: Floats | float
    exponent: Floats | None = None


def load(
    expansion: Floats,
    back: Floats | None = None,
    clearance: Floats | float = 0.0,
    exponent: Floats | None = None,
) -> Load:
    """Return the forces for ε, the back pressure b = R/Q, the clearance κ as a share of the stroke and n.

    None for b is the best one, for n 1. Source: Weisbach-Herrmann, § 150, P = (2/π)(1 + ln ε - εb) Q/ε;
    clearance and exponent re-derived.
    """
    # The steam grows to 1 + growth times its volume at cut-off, the pressure falls from 1 + rise to 1.
    growth = (expansion - 1) / (1 + clearance * expansion)
    logarithm = np.log1p(growth)
    rise = growth if exponent is None else np.expm1(exponent * logarithm)
    gain = logarithm if exponent is None else exponent * risen(logarithm, exponent)
    whole = 1 + clearance
    # Nothing but b takes digits away: this is a sum of what vanishes where nothing expands.
    best, forgone = whole * gain - clearance * rise, whole * (rise - gain)
    loss = 1.0 if back is None else (1 + rise) * back
    net = rise if back is None else (1 + rise) * (1 - back)
    mean = TWO_OVER_PI * (best + (1 - loss))
    return Load(expansion, loss, net, mean, forgone, clearance / whole, 1 / whole, exponent)


def risen(logarithm: Floats, exponent: Floats) -> Floats:
    """Return the work (V^(1-n) - 1)/(n - 1) for -ln V, which is this itself for n = 1."""
    curve = (exponent - 1) * logarithm
    straight = curve == 0
    return logarithm * np.where(straight, 1.0, np.expm1(curve) / np.where(straight, 1.0, curve))


def work_left(share: Floats, rest: Floats, load: Load) -> Floats:
    """Return half the work of the steam that expands while the piston has a share of the stroke to go."""
    # By the share that the volume has still to grow both small and large ones keep their digits.
    logarithm = np.log1p(load.swept * share / (load.dead + load.swept * rest))
    return (logarithm if load.exponent is None else risen(logarithm, load.exponent)) / load.swept


class Place(NamedTuple):
    """Where the piston is: tan β/2, the shares of the stroke to the outer dead centre and to the inner one,
    the velocity, and by ln τ the slopes of its logarithm and of the share."""

    angle: Floats
    share: Floats
    rest: Floats
    velocity: Floats
    rise: Floats
    slope: Floats


def first_order(ratio: Floats, tangent: Floats) -> Place:
    """Return the place at τ = tan β/2 by first-order kinematics; -λ exchanges the strokes.

    Source: Weisbach-Herrmann, § 150, s = 1 - cos α ∓ ½ λ sin² α.
    """
    half = 1 / (1 + tangent * tangent)
    other = tangent * tangent * half
    rod, square = (1 - ratio) + 2 * ratio * other, 4 * (half * other)
    return Place(
        tangent,
        other * ((1 - ratio) + ratio * other),
        half * (1 + ratio * other),
        2 * tangent * half * rod,
        (half - other) + ratio * square / rod,
        square * rod / 2,
    )


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
    return Place(
        root(share * (1 + ratio * share) / (rest * (short + ratio * share))),
        share,
        rest,
        2 * tangent * half * rod,
        (half - other) + ratio * square * less,
        square * height * rod * less / 2,
    )


def expanding(_: Floats, __: Floats, place: Place, load: Load) -> tuple[Floats, Floats]:
    """Return the pressure of the expanding steam on the outstroke, and the slope of its logarithm on ln τ."""
    less = 1 / (load.dead + load.swept * place.rest)
    slope = load.swept * place.slope * less
    return (less, slope) if load.exponent is None else (less**load.exponent, load.exponent * slope)


def of_weisbach(ratio: Floats, tangent: Floats, place: Place, _: Load) -> tuple[Floats, Floats]:
    """Return what stands for this pressure in Weisbach's equation for cotg(α₂/2), and the slope.

    λ is in place of λ/(1 + λ cos²(α₂/2)). Source: Weisbach-Herrmann, § 150.
    """
    half = 1 / (1 + tangent * tangent)
    rod = 1 - ratio * half
    return 2 * tangent * rod / place.velocity, 1 + 2 * ratio * half * (1 - half) / rod - place.rise


Motion: TypeAlias = Callable[[Floats, Floats], Place]


class Kind(NamedTuple):
    """A motion, and the steam that expands in it."""

    place: Motion
    steam: Callable[[Floats, Floats, Place, Load], tuple[Floats, Floats]] = expanding


def extremes(kind: Kind, ratio: Floats, load: Load, steps: int = STEPS) -> Sequence[Floats]:
    """Return what is not above 0 where both extreme speeds have settled; τ, tan β/2 and both shares of the
    least one, on the return stroke before the cut-off; the last three of the greatest one, on the outstroke.
    """
    least, most, restless, change = _searched(kind, ratio, load, steps)
    rising = kind.place(ratio, least)[:3]
    # Before the cut-off the greatest speed is where the velocity is that of the least one, so at the same τ.
    is_expanding = rising[2] * load.expansion > 1
    most, change = np.where(is_expanding, most, least), np.where(is_expanding, change, restless)
    falling = kind.place(ratio, most)[:3]
    return [np.maximum(restless, change), least, *rising, *falling]


def _searched(kind: Kind, ratio: Floats, load: Load, steps: int) -> Sequence[Floats]:
    """Return τ of the least speed, that of the greatest one if the steam expands there, and what is not above
    0 where either has settled."""
    wanted = load.mean / load.net
    # Nearly, the velocity is 2τ √(τ² + (its slope)²).
    square = (kind.place(ratio, NEAR).velocity / (2 * NEAR)) ** 2
    least = wanted / root(2 * (square + root(square * square + wanted * wanted)))
    most = _farther(kind.place, ratio, np.maximum(least, NEAR), load)
    for _ in range(steps):
        # Both in turn: their operations do not wait for each other.
        before = least, most
        least = _nearer(least, kind.place(ratio, least), (1 / wanted, 0.0), 1.0, 0.0)
        place = kind.place(ratio, most)
        most = _nearer(most, place, kind.steam(ratio, most, place, load), load.mean, load.back)
        del place  # Six columns of no more use.
    return [
        least,
        most,
        *(np.abs(one - last) - SETTLED * last for one, last in zip((least, most), before, strict=True)),
    ]


def _farther(place: Motion, ratio: Floats, tangent: Floats, load: Load) -> Floats:
    """Return τ of the greatest speed, nearly, from one before it: z times this, at most to the cut-off."""
    at = place(ratio, tangent)
    share = at.share / at.rest
    rise = load.swept * share if load.exponent is None else load.exponent * load.swept * share
    # The velocity goes with z, the pressure is nearly 1 + z² rise, so that z³ + excess z = force. The cube
    # root is near the power 5/16.
    force, excess = load.mean / at.velocity / rise, (1 - load.back) / rise
    fourth = root(root(force))
    third = fourth * root(root(fourth))
    times = force / (third * third + np.maximum(excess, 0)) + root(np.maximum(-excess, 0))
    return tangent * np.maximum(np.minimum(times, root(load.expansion - 1) / root(share)), 1)


def _nearer(
    tangent: Floats,
    place: Place,
    steam: tuple[Floats, Floats | float],
    mean: Floats | float,
    back: Floats | float,
    is_late: bool = False,
) -> Floats:
    """Return τ nearer to where the force of the steam, a pressure and its slope, rises to its mean.

    Newton's step for the logarithm of pressure × velocity : (mean + back × velocity), which rises from τ = 0
    on. Of such a ratio r the logarithm is 2(r - 1)/(r + 1), and e^2x is (1 + x)/(1 - x), nearly.
    """
    pressure, slope = steam
    pull, against = pressure * place.velocity, mean + back * place.velocity
    rise, both = slope * against + place.rise * mean, pull + against
    # Where it falls, the root lies behind; but ahead of a return stroke that is below its mean.
    whole = both * np.maximum(rise, 1e-150)
    lowest = whole if is_late else both * rise
    step = np.minimum(np.maximum((pull - against) * against, -LONGEST_STEP * lowest), LONGEST_STEP * whole)
    return tangent * ((whole - step) / (whole + step))


Search: TypeAlias = Callable[[Kind, Floats, Load], Floats]


def by_numpy(kind: Kind, ratio: Floats, load: Load, steps: int = STEPS) -> Floats:
    """Return what `extremes` returns as rows."""
    return np.array(extremes(kind, ratio, load, steps))


def by_loops(kind: Kind, ratio: Floats, load: Load) -> Floats:
    """Return the rows by numba, with the same bits; powers are those of NumPy."""
    if load.exponent is not None:
        return by_numpy(kind, ratio, load)
    rows = np.empty((8, load.mean.size))
    given = (np.broadcast_to(one, load.mean.size) for one in (ratio, *load[:-1]))
    _loop(kind)(np.empty(0), *(np.require(one, np.float64, ("C", "A")) for one in given), *rows)
    return rows


@cache
def _loop(kind: Kind) -> Callable[..., None]:
    def formula(ratio: Any, *forces: Any) -> Sequence[Floats]:
        return extremes(kind, ratio, Load(*forces))

    return compiled(written_formula(formula, len(Load._fields)))


def excess(kind: Kind, search: Search, ratio: Floats, load: Load) -> tuple[Floats, Floats]:
    """Return the greatest excess work and the least one with its sign changed, in units of P r.

    Zero at the outer dead centre. Source: Weisbach-Herrmann, § 150, with 1 + ln ε = πP/2 + b put in.
    """
    rows = search(kind, ratio, load)
    for steps in (MORE_STEPS, MOST_STEPS):
        few = np.flatnonzero(~(rows[0] <= 0))
        if few.size:
            rows[:, few] = by_numpy(kind, *_few(few, ratio, load), steps)
    _, least, rising, admitted, _, falling, share, rest = rows
    # Counted from the end of the stroke, the work of the steam that expands has no large terms to cancel.
    expanded, full = load.back * share - work_left(share, rest, load), load.forgone - load.net * share
    gained, lacking = np.where(rest * load.expansion > 1, expanded, full), -load.net * admitted
    late = np.flatnonzero(admitted * load.expansion > 1)
    if late.size:
        rising[late], lacking[late] = _late(kind, least[late], *_few(late, ratio, load))
    return 2 * (np.arctan(falling) + gained / load.mean), 2 * (np.arctan(rising) + lacking / load.mean)


def _few(few: NDArray[np.int64], ratio: Floats, load: Load) -> tuple[Floats, Load]:
    """Return the ratios and the forces of these engines alone."""
    those: list[Any] = [
        one if one is None else np.broadcast_to(one, load.mean.shape)[few] for one in (ratio, *load)
    ]
    return those[0], Load(*those[1:])


def _late(kind: Kind, tangent: Floats, ratio: Floats, load: Load) -> tuple[Floats, Floats]:
    """Return tan β/2 and the deficit of work, halved, where the speed is least after the cut-off: the steam
    that expands has its mean force beyond the τ where full pressure would have it."""
    for _ in range(MOST_STEPS):
        place = kind.place(ratio, tangent)
        back = place._replace(share=place.rest, rest=place.share, slope=-place.slope)
        tangent = _nearer(tangent, place, expanding(ratio, tangent, back, load), load.mean, load.back, True)
    place = kind.place(ratio, tangent)
    left = work_left(place.rest, place.share, load) - load.back * place.rest
    return place.angle, left - load.mean / TWO_OVER_PI


def true_irregularity(place: Motion, search: Search, ratio: Floats, load: Load) -> Floats:
    """Return δ, in units of P r/(m₁ v₁²), from the true extremes of the excess work of a motion."""
    greatest, deficit = excess(Kind(place), search, ratio, load)
    return greatest + deficit


def weisbach(_: Search, ratio: Floats, load: Load) -> Floats:
    """Return δ for first-order kinematics at the angles of his equations, in units of P r/(m₁ v₁²)."""
    # No true maxima, hence the angles count in full, and either stroke's may be the greater one.
    kind, search = Kind(first_order, of_weisbach), partial(by_numpy, steps=MORE_STEPS)
    one, other = (excess(kind, search, rod, load) for rod in (ratio, -ratio))
    return np.maximum(one[0], other[0]) + one[1]


METHODS: Mapping[str, Callable[[Search, Floats, Load], Floats]] = {
    "exact": partial(true_irregularity, exact),
    "series": partial(true_irregularity, first_order),
    "weisbach": weisbach,
}
"""δ in units of P r/(m₁ v₁²), by method, from what searches the extremes, λ and the forces."""
