"""Integrals over an interval of one analytic function times many waves, in balls, each enclosed with a proof.

The function is computed once, at the nodes of Gauss's rule on panels of the interval; the integral with any
wave e^(iωx) is a sum over these nodes. On [-1, 1] the rule of n >= 2 nodes is off by at most
64/15 M ρ^(-2n)/(1 - ρ^(-2)), if the integrand is analytic and at most M within the ellipse of foci ±1 and
semi-axes (ρ ± 1/ρ)/2. Source: Trefethen, Approximation Theory and Approximation Practice, theorem 19.3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from math import ceil
from operator import itemgetter
from typing import NamedTuple

import flint
from flint import acb, arb

from kurbel.exact.certify import ball
from kurbel.exact.precision import at_bits
from kurbel.exact.search import interval

# The ellipses that are tried around a panel, the ρ of each.
ELLIPSES = (Fraction(2), Fraction(3), Fraction(4), Fraction(6))
# A panel that takes more nodes a bit of the precision is parted.
NODES_A_BIT = Fraction(1, 2)
# Bits to which a function is bounded.
BOUND_BITS = 64


class Sample(NamedTuple):
    """A place, and the function there times the weight of the place: both are balls."""

    place: arb
    value: arb


class Samples(NamedTuple):
    """A function over an interval, and by how much its integral with a wave may be off."""

    nodes: tuple[Sample, ...]
    error: arb

    def with_wave(self, half_turns: Fraction) -> tuple[arb, arb]:
        """Return the integrals of f(x) cos πkx and f(x) sin πkx, of k half turns."""
        cosine = sine = arb(0, self.error)
        rate = ball(half_turns)
        for place, value in self.nodes:
            own_sine, own_cosine = (rate * place).sin_cos_pi()
            cosine, sine = cosine + value * own_cosine, sine + value * own_sine
        return cosine, sine


def sampled(
    function: Callable[[arb], arb],
    beyond: Callable[[acb], acb],
    start: Fraction,
    end: Fraction,
    growth: Fraction,
) -> Samples:
    """Return the nodes of an interval, at the precision in force, for waves of up to `growth` half turns.

    `function` computes on real balls; `beyond` encloses it on complex ones, and is no finite number on
    those within which it is not analytic.
    """
    nodes: list[Sample] = []
    error = arb(0)
    todo = [(start, end)]
    while todo:
        low, high = todo.pop()
        middle, half = (low + high) / 2, (high - low) / 2
        rule = min(_rules(beyond, middle, half, growth), key=itemgetter(0), default=None)
        if rule is not None and rule[0] <= NODES_A_BIT * flint.ctx.prec:
            count, off = rule
            error += off
            nodes += (
                Sample(place, ball(half) * weight * function(place))
                for node, weight in _gauss(count, flint.ctx.prec)
                for place in [ball(middle) + ball(half) * node]
            )
        elif half > Fraction(1, 2**flint.ctx.prec):
            todo += [(low, middle), (middle, high)]
        else:
            over = interval(low, high)
            nodes.append(Sample(over, ball(2 * half) * function(over)))
    return Samples(tuple(nodes), error)


def _rules(
    beyond: Callable[[acb], acb], middle: Fraction, half: Fraction, growth: Fraction
) -> Iterator[tuple[int, arb]]:
    """Yield of each ellipse how many nodes err by less than the last bit, and a bound of their error."""
    bits = flint.ctx.prec
    with at_bits(BOUND_BITS):
        for ellipse in ELLIPSES:
            wide, high = half * (ellipse + 1 / ellipse) / 2, ball(half * (ellipse - 1 / ellipse) / 2).upper()
            most = abs(beyond(acb(interval(middle - wide, middle + wide), arb(0, high)))).upper()
            if not most.is_finite():
                continue
            waves = (ball(growth) * arb.pi() * high).exp()
            bound = ball(half * Fraction(64, 15) / (1 - 1 / ellipse**2)) * most * waves
            # One more, for of nothing there is no logarithm.
            needed = (bound * arb(2) ** bits + 1).log() / (2 * ball(ellipse).log())
            count = max(2, ceil(float(needed.upper())))
            yield count, (bound / ball(ellipse) ** (2 * count)).upper()


@lru_cache(maxsize=512)
def _gauss(count: int, bits: int) -> tuple[tuple[arb, arb], ...]:
    """Return the nodes and weights of Gauss's rule on [-1, 1]."""
    return tuple(arb.legendre_p_root(count, index, weight=True) for index in range(count))
