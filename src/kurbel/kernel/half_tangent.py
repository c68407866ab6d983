"""The double-acting engine's two strokes, for arrays: their motion, and the force of the steam that expands.

Forces are in units of the pressure of the steam at the end of the stroke, Q/ε for Mariotte's law without
clearance. The volume counts in units of that at the end of the stroke, 1 - κ₁ σ/2 at the path σ from the
outer dead centre, κ₁ = 1/(1 + κ).

All counts from the outer dead centre. β is the crank angle from there, forward on the return stroke and
backward on the outstroke, and σ the piston path from there, in units of r.

The unknown is T = τ², where τ is the tangent of half an angle: with it, a step to the root takes + - * / and
two square roots.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.kernel.circle import root

Floats: TypeAlias = NDArray[np.float64]

TWO_OVER_PI = 0.6366197723675814


class Load(NamedTuple):
    """What acts on the piston of an engine."""

    expansion: Floats
    """ε: the cut-off comes after the share 1/ε of the stroke."""
    back: Floats | float
    net: Floats
    """Steam less back pressure before the cut-off."""
    mean: Floats
    """P, the mean tangential force."""
    forgone: Floats
    """Half the work in a stroke that steam admitted to its end would do beyond this."""
    over: Floats | float
    """u/(1 - u) at the share u from the end where the steam has expanded to the back pressure; 0 if never."""
    dead: Floats | float = 0.0
    """1 - κ₁, the volume that is left at the inner dead centre."""
    swept: Floats | float = 1.0
    """κ₁; on the return stroke, which begins at the outer dead centre, -κ₁ with 1 for `dead`."""
    bend: Floats | float = 1.0
    """By how much slower than without clearance, by Mariotte's law, the pressure falls where it is b."""
    exponent: Floats | None = None
    """n of p V^n = const, None for 1 everywhere."""

    @property
    def plain(self) -> bool:
        """Whether there is no clearance and the steam expands by Mariotte's law."""
        return self.exponent is None and isinstance(self.swept, float)


def load(
    expansion: Floats,
    back: Floats | None = None,
    clearance: Floats | None = None,
    exponent: Floats | None = None,
) -> Load:
    """Return the forces for ε, the back pressure b = R/Q, the clearance κ as a share of the stroke and n.

    None for b is the best one, for κ 0, for n 1. Source: Weisbach-Herrmann, § 150, P = (2/π)(1 + ln ε - εb)
    Q/ε; clearance and exponent re-derived.
    """
    if clearance is None and exponent is None:
        logarithm = np.log(expansion)
        forgone = (expansion - 1) - logarithm
        if back is None:
            return Load(expansion, 1.0, expansion - 1, TWO_OVER_PI * logarithm, forgone, 0.0)
        loss = expansion * back
        mean = TWO_OVER_PI * (logarithm + (1 - loss))
        return Load(expansion, loss, expansion * (1 - back), mean, forgone, np.maximum(loss - 1, 0))
    return _expanding(expansion, back, 0.0 if clearance is None else clearance, exponent)


def _expanding(
    expansion: Floats, back: Floats | None, clearance: Floats | float, exponent: Floats | None
) -> Load:
    # The steam grows to 1 + growth times its volume at cut-off, the pressure falls from 1 + rise to 1.
    growth = (expansion - 1) / (1 + clearance * expansion)
    logarithm = np.log1p(growth)
    rise = growth if exponent is None else np.expm1(exponent * logarithm)
    gain = logarithm if exponent is None else exponent * risen(logarithm, exponent)
    whole = 1 + clearance
    swept, dead = 1 / whole, clearance / whole
    best, forgone = whole * gain - clearance * rise, whole * (rise - gain)
    # Nothing but b takes digits away: this is a sum of what vanishes where nothing expands.
    loss = 1.0 if back is None else (1 + rise) * back
    net = rise if back is None else (1 + rise) * (1 - back)
    mean = TWO_OVER_PI * (best + (1 - loss))
    above = np.maximum(loss, 1)
    share = whole * ((above - 1) / above if exponent is None else -np.expm1(-np.log(above) / exponent))
    over = share / (1 - share)
    bend = _bend(above, over, swept, exponent)
    return Load(expansion, loss, net, mean, forgone, over, dead, swept, bend, exponent)


def _bend(above: Floats, over: Floats, swept: Floats | float, exponent: Floats | None) -> Floats:
    cube = ((1 + over) / above) ** 3
    if exponent is None:
        return cube / swept
    return cube * above ** (1 - 1 / exponent) / (exponent * swept)


def risen(logarithm: Floats, exponent: Floats) -> Floats:
    """Return the work (V^(1-n) - 1)/(n - 1) for -ln V, which is this itself for n = 1."""
    curve = (exponent - 1) * logarithm
    straight = curve == 0
    return logarithm * np.where(straight, 1.0, np.expm1(curve) / np.where(straight, 1.0, curve))


def work_left(share: Floats, load: Load) -> Floats:
    """Return half the work of the expanding steam from a share, from the outer dead centre, to that end."""
    if load.plain:
        return -np.log1p(-share)
    logarithm = -np.log1p(-load.swept * share)
    if load.exponent is not None:
        logarithm = risen(logarithm, load.exponent)
    return logarithm / load.swept


def raised(volume: Floats, whole: Floats | float, exponent: Floats | None) -> Floats:
    """Return w (V/w)^n, which is V for Mariotte's law."""
    return volume if exponent is None else whole * (volume / whole) ** exponent


def curved(volume: Floats, exponent: Floats | None) -> Floats:
    """Return n V, the volume itself for Mariotte's law."""
    return volume if exponent is None else exponent * volume


# The bits of a float64 above the lowest 32, shifted, are nearly its logarithm: a third of them, and what two
# thirds of the exponent's bias are, give its cube root within 4 %.
UPPER, THIRD, BIAS = 32, 1431655766, 715094163


class Place(NamedTuple):
    """A place by its crank angle β from the outer dead centre, as coordinates, and the share σ/2."""

    across: Floats
    along: Floats
    share: Floats

    @property
    def angle(self) -> Floats:
        return np.arctan2(self.across, self.along)


class Pull(NamedTuple):
    """Tangential force against its mean at one T, both multiplied by the same positive number.

    growth is the slope of ln(force/mean) on ln τ, times margin, which has the sign of the force.
    """

    force: Floats
    mean: Floats
    growth: Floats
    margin: Floats


class ExactMotion:
    """Exact kinematics for one λ or an array, with T = tan²(θ/2), cos θ = cos β/cos ψ.

    Re-derived: in θ the velocity of the return stroke is sin θ √((1 - λ cos θ)/(1 + λ cos θ)), and nothing
    is steep where λ is near 1.
    """

    steps = 3

    def __init__(self, ratio: Floats) -> None:
        self.ratio = ratio
        self.twice = 2 * ratio
        self.short = 1 - ratio
        self.long = 1 + ratio
        self.height = root(self.short * self.long)
        self.slope = self.height / self.long

    def least(self, velocity: Floats) -> Floats:
        """Return T where the return stroke has this velocity while it speeds up, 0 <= c <= 2/π."""
        # It is 4T(1 - λ + (1 + λ)T) = c²(1 + T)²(1 + λ + (1 - λ)T), which has one root below 1. Without the
        # T³ it gives τ to 0.3 %; two of Newton's steps leave 3e-11.
        square = velocity * velocity
        constant = square * self.long
        linear = 4 * self.short - square * (2 * self.long + self.short)
        leading = 4 * self.long - square * (self.long + 2 * self.short)
        tangent = 2 * constant / (linear + root(linear * linear + 4 * leading * constant))
        for _ in range(2):
            secant = 1 + tangent
            long, short = self.long * tangent, self.short * tangent + self.long
            above = 4 * tangent * (self.short + long) - square * (secant * secant) * short
            slope = 4 * (self.short + 2 * long) - square * secant * (2 * short + self.short * secant)
            tangent = tangent - above / slope
        return tangent

    def balanced(self, load: Load) -> Floats:
        """Return T where the steam has expanded to the back pressure; 0 if it never does."""
        return self.at(load.over)

    def at(self, over: Floats | float) -> Floats:
        """Return T at the share u from the outer dead centre, given as u/(1 - u)."""
        # From the law of cosines, T = σ/s (1 + λ)(1 - λ + ½λσ)/((1 - λ)(1 + ½λσ)).
        bend = self.ratio * (over / (1 + over))
        return over * self.long * (self.short + bend) / (self.short * (1 + bend))

    def near(self, load: Load, balanced: Floats) -> Floats:
        """Return T - balanced at the greatest speed, nearly: τ to 20 % for the best back pressure."""
        half = load.mean / 2
        spare = np.maximum(0, half - np.maximum(0, 1 - load.back))
        large = half + spare * (1 / self.height - 1)
        return _steady(large, load) + _cubic(half * load.back * load.bend * self.long / self.slope, balanced)

    def pull(self, tangent: Floats, load: Load) -> Pull:
        """Return the tangential force (2/s - b) c of the expanding steam on the outstroke, against P."""
        secant = 1 + tangent
        half = 1 / secant
        other = tangent * half
        far, close = self.short + self.twice * half, self.short + self.twice * other
        square = far * close
        height = root(square)
        # Of all divisions that by 1 + T is left: numerators alone are computed.
        whole = far + self.slope * height
        force = root(tangent) * height
        fall = other * whole * (self.height * height + self.short * close)
        rise = (half - other) * square + 2 * (self.twice * (half * other))
        share = 2 * half
        if load.plain:
            margin = whole - load.back * share
            return Pull(force * margin, load.mean * far, rise * margin + fall, margin * square)
        share = load.swept * share
        volume = load.dead * whole + share
        steam = raised(volume, whole, load.exponent)
        margin = whole - load.back * steam
        weight = margin * volume
        growth = rise * weight + fall * curved(share, load.exponent)
        mean = load.mean * far * (steam * secant) / 2
        return Pull(force * margin, mean, growth, weight * square)

    def place(self, tangent: Floats) -> Place:
        """Return the place at a T."""
        half = 1 / (1 + tangent)
        other = tangent * half
        far, close = self.short + self.twice * half, self.short + self.twice * other
        share = 2 * other * self.slope / (far * self.slope + root(far * close))
        return Place(2 * root(tangent), (1 - tangent) * self.height, share)


class FirstOrderMotion:
    """First-order kinematics for one λ or an array, with T = tan²(β/2); -λ exchanges the strokes.

    Source: Weisbach-Herrmann, § 150, s = 1 - cos α ∓ ½ λ sin² α.
    """

    steps = 4

    def __init__(self, ratio: Floats) -> None:
        self.ratio = ratio
        self.short = 1 - ratio
        self.long = 1 + ratio

    def least(self, velocity: Floats) -> Floats:
        """Return T where the return stroke has this velocity while it speeds up, 0 <= c <= 2/π."""
        # It is τ(1 - λ + (1 + λ)T) = ½c(1 + T)². The start lies within a third; five of Newton's steps
        # leave 1e-8.
        half = velocity / 2
        tangent = half * (1 + velocity) / (self.short + near_cube_root(self.long * half * half))
        for _ in range(5):
            square = tangent * tangent
            secant, long = 1 + square, self.long * square
            above = tangent * (self.short + long) - half * (secant * secant)
            tangent = tangent - above / (self.short + 3 * long - 4 * half * (tangent * secant))
        return tangent * tangent

    def balanced(self, load: Load) -> Floats:
        """Return T where the steam has expanded to the back pressure; 0 if it never does."""
        return self.at(load.over)

    def at(self, over: Floats | float) -> Floats:
        """Return T at the share u from the outer dead centre, given as u/(1 - u)."""
        # sin² β/2 from the share u, and cos² β/2 from 1 - u.
        most = 1 / (1 + over)
        rest = over * most
        bend = root(self.short * self.short + 4 * self.ratio * rest)
        return rest * (self.long + bend) / ((self.short + bend) * most)

    def near(self, load: Load, balanced: Floats) -> Floats:
        """Return T - balanced at the greatest speed, nearly."""
        half = load.mean / 2
        small = half * load.back * load.bend
        guess = near_cube_root(small) + balanced
        part = self.ratio * guess / (1 + guess)
        small = small / ((self.short + part) * (self.short + 2 * part))
        return _steady(half, load) + _cubic(small, balanced)

    def pull(self, tangent: Floats, load: Load) -> Pull:
        """Return the tangential force (2/s - b) c of the expanding steam on the outstroke, against P."""
        half = 1 / (1 + tangent)
        other = tangent * half
        twice = 2 * self.ratio
        velocity, path = self.short + twice * other, 1 + self.ratio * other
        share, bend, force = half * path, twice * (half * other), 2 * root(tangent) * velocity
        rise, fall = (half - other) + 2 * bend / velocity, 2 * other - bend / path
        if load.plain:
            margin = 1 - load.back * share
            return Pull(force * margin, load.mean * path, rise * margin + fall, margin)
        share = load.swept * share
        volume = load.dead + share
        steam = raised(volume, 1, load.exponent)
        margin = 1 - load.back * steam
        weight = margin * volume
        growth = rise * weight + fall * curved(share, load.exponent)
        return Pull(force * margin, load.mean * (steam * (1 + tangent)), growth, weight)

    def place(self, tangent: Floats) -> Place:
        """Return the place at a T."""
        other = tangent / (1 + tangent)
        return Place(2 * root(tangent), 1 - tangent, other * (self.short + self.ratio * other))

    def admitted(self, tangent: Floats) -> Floats:
        """Return the share 1 - σ/2 of the outstroke."""
        half = 1 / (1 + tangent)
        return half * (1 + self.ratio * (tangent * half))


class WeisbachRelation:
    """Weisbach's equation for cotg(α₂/2), with λ in place of λ/(1 + λ cos²(α₂/2)); T = tan²(β/2).

    For the outstroke; -λ is the return stroke. Source: Weisbach-Herrmann, § 150.
    """

    steps = 4

    def __init__(self, ratio: Floats) -> None:
        self.ratio = ratio
        self.long = 1 + ratio

    def balanced(self, load: Load) -> Floats:
        """Return T where his bracket 1 - λu - bu(1 + λ - 2λu), u = sin²(α₂/2), is zero; 0 if it never is."""
        linear = self.ratio + load.back * self.long
        span = linear * linear - 8 * self.ratio * load.back
        half = 2 / np.maximum(2, linear + root(np.maximum(0, span)))
        return np.where(span < 0, 0.0, 1 / half - 1)

    def near(self, load: Load, balanced: Floats) -> Floats:
        """Return T - balanced at α₂, nearly."""
        half = 1 / (1 + balanced)
        slope = half * half * (self.ratio + load.back * (self.long - 4 * self.ratio * half))
        mean = load.mean / 2
        return mean * mean + _cubic(mean / np.maximum(slope, 0.1), balanced)

    def pull(self, tangent: Floats, load: Load) -> Pull:
        """Return his bracket times τ against the rest of the equation."""
        half = 1 / (1 + tangent)
        rod = self.ratio * half
        margin = 1 - rod - load.back * half * (self.long - 2 * rod)
        bend = 2 * half * (tangent * half) * (self.ratio + load.back * (self.long - 4 * rod))
        return Pull(root(tangent) * margin, load.mean / 2, margin + bend, margin)


Motion: TypeAlias = ExactMotion | FirstOrderMotion
Relation: TypeAlias = Motion | WeisbachRelation


def _steady(root_of: Floats, load: Load) -> Floats:
    """Return T, nearly, where there is no back pressure, from what is √T for Mariotte's law."""
    square = root_of * root_of
    if load.exponent is None:
        return square
    # Far from the end the force is as T^(n - ½), near it as T^½.
    return np.where(square > 1, square ** (1 / np.maximum(1, 2 * load.exponent - 1)), square)


def _cubic(small: Floats, balanced: Floats) -> Floats:
    """Return Z with Z √(balanced + Z) = small, τ to 20 %."""
    third = near_cube_root(small)
    # The last term keeps 0/0 away where there is no back pressure.
    return small / root(balanced + third * third + 1e-300)


def near_cube_root(number: Floats) -> Floats:
    """Return the cube root of numbers above 0 within 4 %, of 0 next to nothing: a start, in few steps."""
    bits = number.view(np.int64) >> UPPER
    return ((((bits * THIRD) >> UPPER) + BIAS) << UPPER).view(np.float64)
