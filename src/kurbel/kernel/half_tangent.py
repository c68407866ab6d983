"""The motion of the double-acting engine's two strokes and the force of its expanding steam, for arrays.

All counts from the outer dead centre. β is the crank angle from there, forward on the return stroke and
backward on the outstroke, and σ the piston path from there, in units of r. Forces are in units of Q/ε, so
that the back pressure b is εb here.

The unknown is T = τ², where τ is the tangent of half an angle: with it, a step to the root takes + - * / and
two square roots.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np

from kurbel.kernel.circle import Number, root

TWO_OVER_PI = 0.6366197723675814


class Load(NamedTuple):
    """The forces of an engine in units of Q/ε, the force of the steam at the end of the stroke."""

    expansion: Number
    back: Number
    net: Number
    """Steam less back pressure before the cut-off, ε(1 - b)."""
    mean: Number
    """P, the mean tangential force."""
    forgone: Number
    """ε - 1 - ln ε, half the work in a stroke that steam admitted to its end would do beyond this."""


class Place(NamedTuple):
    """Crank angle β and piston path from the outer dead centre, the path as a share of the stroke."""

    angle: Number
    share: Number


class Pull(NamedTuple):
    """Tangential force against its mean at one T, both multiplied by the same positive number.

    growth is the slope of ln(force/mean) on ln τ, times margin, which has the sign of the force.
    """

    force: Number
    mean: Number
    growth: Number
    margin: Number


def load(expansion: Number, back: Number = None) -> Load:
    """Return the forces for the expansion ratio ε and the back pressure b = R/Q, None for the best, 1/ε.

    P = (2/π)(1 + ln ε - εb). Source: Weisbach-Herrmann, § 150.
    """
    logarithm = np.log(expansion)
    forgone = (expansion - 1) - logarithm
    if back is None:
        return Load(expansion, 1.0, expansion - 1, TWO_OVER_PI * logarithm, forgone)
    loss = expansion * back
    mean = TWO_OVER_PI * (logarithm + (1 - loss))
    return Load(expansion, loss, expansion * (1 - back), mean, forgone)


class ExactMotion:
    """Exact kinematics for one λ or an array, with T = tan²(θ/2), cos θ = cos β/cos ψ.

    Re-derived: in θ the velocity of the return stroke is sin θ √((1 - λ cos θ)/(1 + λ cos θ)), and nothing
    is steep where λ is near 1.
    """

    steps = 3

    def __init__(self, ratio: Number) -> None:
        self.ratio = ratio
        self.short = 1 - ratio
        self.long = 1 + ratio
        self.height = root(self.short * self.long)
        self.slope = self.height / self.long

    def least(self, velocity: Number) -> Number:
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

    def balanced(self, back: Number) -> Number:
        """Return T where the steam has expanded to the back pressure, s = 2/b; 0 if it never does."""
        # From the law of cosines, T = σ/s (1 + λ)(1 - λ + ½λσ)/((1 - λ)(1 + ½λσ)).
        over = np.maximum(back - 1, 0)
        bend = self.ratio * (over / (1 + over))
        return over * self.long * (self.short + bend) / (self.short * (1 + bend))

    def near(self, load: Load, balanced: Number) -> Number:
        """Return T - balanced at the greatest speed, nearly: τ to 20 % for the best back pressure."""
        half = load.mean / 2
        spare = np.maximum(0, half - np.maximum(0, 1 - load.back))
        large = half + spare * (1 / self.height - 1)
        return large * large + _cubic(half * load.back * self.long / self.slope, balanced)

    def pull(self, tangent: Number, load: Load) -> Pull:
        """Return the tangential force (2/s - b) c of the expanding steam on the outstroke, against P."""
        half = 1 / (1 + tangent)
        other = tangent * half
        twice = 2 * self.ratio
        far, close = self.short + twice * half, self.short + twice * other
        square = far * close
        height = root(square)
        path = 1 / (far + self.slope * height)
        margin = 1 - 2 * load.back * (half * path)
        part = other / square
        growth = ((half - other) + 2 * twice * (half * part)) * margin
        growth = growth + part * (self.height * height + self.short * close)
        return Pull(root(tangent) * height * margin, load.mean * (far * path), growth, margin)

    def place(self, tangent: Number) -> Place:
        """Return β and σ/2."""
        half = 1 / (1 + tangent)
        other = tangent * half
        twice = 2 * self.ratio
        far, close = self.short + twice * half, self.short + twice * other
        share = 2 * other / (far + root(far * close) / self.slope)
        return Place(np.arctan2(2 * root(tangent), (1 - tangent) * self.height), share)


class FirstOrderMotion:
    """First-order kinematics for one λ or an array, with T = tan²(β/2); -λ exchanges the strokes.

    Source: Weisbach-Herrmann, § 150, s = 1 - cos α ∓ ½ λ sin² α.
    """

    steps = 4

    def __init__(self, ratio: Number) -> None:
        self.ratio = ratio
        self.short = 1 - ratio
        self.long = 1 + ratio

    def least(self, velocity: Number) -> Number:
        """Return T where the return stroke has this velocity while it speeds up, 0 <= c <= 2/π."""
        # It is τ(1 - λ + (1 + λ)T) = ½c(1 + T)². The start lies within a third; five of Newton's steps
        # leave 1e-8.
        half = velocity / 2
        tangent = half * (1 + velocity) / (self.short + np.cbrt(self.long * half * half))
        for _ in range(5):
            square = tangent * tangent
            secant, long = 1 + square, self.long * square
            above = tangent * (self.short + long) - half * (secant * secant)
            tangent = tangent - above / (self.short + 3 * long - 4 * half * (tangent * secant))
        return tangent * tangent

    def balanced(self, back: Number) -> Number:
        """Return T where the steam has expanded to the back pressure, s = 2/b; 0 if it never does."""
        over = np.maximum(back - 1, 0)
        rest = over / (1 + over)
        part = 2 * rest / (self.short + root(self.short * self.short + 4 * self.ratio * rest))
        return part / (1 - part)

    def near(self, load: Load, balanced: Number) -> Number:
        """Return T - balanced at the greatest speed, nearly."""
        half = load.mean / 2
        small = half * load.back
        guess = np.cbrt(small) + balanced
        part = self.ratio * guess / (1 + guess)
        small = small / ((self.short + part) * (self.short + 2 * part))
        return half * half + _cubic(small, balanced)

    def pull(self, tangent: Number, load: Load) -> Pull:
        """Return the tangential force (2/s - b) c of the expanding steam on the outstroke, against P."""
        half = 1 / (1 + tangent)
        other = tangent * half
        twice = 2 * self.ratio
        velocity, path = self.short + twice * other, 1 + self.ratio * other
        margin = 1 - load.back * (half * path)
        bend = twice * (half * other)
        growth = ((half - other) + 2 * bend / velocity) * margin + (2 * other - bend / path)
        return Pull(2 * root(tangent) * velocity * margin, load.mean * path, growth, margin)

    def place(self, tangent: Number) -> Place:
        """Return β and σ/2."""
        other = tangent / (1 + tangent)
        return Place(2 * np.arctan(root(tangent)), other * (self.short + self.ratio * other))

    def admitted(self, tangent: Number) -> Number:
        """Return the share 1 - σ/2 of the outstroke."""
        half = 1 / (1 + tangent)
        return half * (1 + self.ratio * (tangent * half))


class WeisbachRelation:
    """Weisbach's equation for cotg(α₂/2), with λ in place of λ/(1 + λ cos²(α₂/2)); T = tan²(β/2).

    For the outstroke; -λ is the return stroke. Source: Weisbach-Herrmann, § 150.
    """

    steps = 4

    def __init__(self, ratio: Number) -> None:
        self.ratio = ratio
        self.long = 1 + ratio

    def balanced(self, back: Number) -> Number:
        """Return T where his bracket 1 - λu - bu(1 + λ - 2λu), u = sin²(α₂/2), is zero; 0 if it never is."""
        linear = self.ratio + back * self.long
        span = linear * linear - 8 * self.ratio * back
        half = 2 / np.maximum(2, linear + root(np.maximum(0, span)))
        return np.where(span < 0, 0.0, 1 / half - 1)

    def near(self, load: Load, balanced: Number) -> Number:
        """Return T - balanced at α₂, nearly."""
        half = 1 / (1 + balanced)
        slope = half * half * (self.ratio + load.back * (self.long - 4 * self.ratio * half))
        mean = load.mean / 2
        return mean * mean + _cubic(mean / np.maximum(slope, 0.1), balanced)

    def pull(self, tangent: Number, load: Load) -> Pull:
        """Return his bracket times τ against the rest of the equation."""
        half = 1 / (1 + tangent)
        rod = self.ratio * half
        margin = 1 - rod - load.back * half * (self.long - 2 * rod)
        bend = 2 * half * (tangent * half) * (self.ratio + load.back * (self.long - 4 * rod))
        return Pull(root(tangent) * margin, load.mean / 2, margin + bend, margin)


Motion: TypeAlias = ExactMotion | FirstOrderMotion
Relation: TypeAlias = Motion | WeisbachRelation


def _cubic(small: Number, balanced: Number) -> Number:
    """Return Z with Z √(balanced + Z) = small, τ to 20 %."""
    third = np.cbrt(small)
    # The last term keeps 0/0 away where there is no back pressure.
    return small / root(balanced + third * third + 1e-300)
