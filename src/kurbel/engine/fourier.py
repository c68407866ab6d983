"""The harmonics of a turn's tangential force, enclosed with proof or, of an indicator card, with an error.

T = P + Σ (a_k cos kφ + b_k sin kφ) over a cycle, with k = 1, 2, ... and over two turns ½, 1½, ... too;
forces in units of Q. Between the dead centres and the corners of a cylinder's force, T is analytic, and the
integrals of T e^(ikφ) are enclosed for all orders from T at the same places; cylinders alike differ by
e^(ikα), α the angle by which one follows the other.

These places are the nodes of Gauss's rule on panels of an interval. On [-1, 1] the rule of n >= 2 nodes is
off by at most 64/15 M ρ^(-2n)/(1 - ρ^(-2)), if the integrand is analytic and at most M within the ellipse of
foci ±1 and semi-axes (ρ ± 1/ρ)/2. Source: Trefethen, Approximation Theory and Approximation Practice, theorem
19.3.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import pairwise
from math import ceil, pi
from operator import itemgetter
from typing import TYPE_CHECKING, Any, NamedTuple

import flint
from flint import acb, arb

from kurbel.balancing.harmonics import MOST_ORDERS
from kurbel.engine.cylinder import AnyTurn, Cylinder
from kurbel.engine.speed.course import Span, spans
from kurbel.engine.turn import Turn
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import balls, floats
from kurbel.exact.search import interval
from kurbel.exact.taylor import ComplexNumber, continued, half_turn_circle
from kurbel.kernel.harmonics import Star

if TYPE_CHECKING:
    from kurbel.engine.card.force import CardTurn


# The ellipses that are tried around a panel, the ρ of each.
ELLIPSES = (Fraction(2), Fraction(3), Fraction(4), Fraction(6))
# A panel that takes more nodes a bit of the precision is parted.
NODES_A_BIT = Fraction(1, 2)
# Bits to which a function is bounded.
BOUND_BITS = 64
# A part of a wave that no proof tells from nothing with so many bits is taken for nothing.
NOTHING_BITS = 200
# To multiples of so many bits the force is computed.
BITS_STEP = 64
# Parts of a stroke, and of each part points, at which the energy of a card is summed.
PARTS = 480
POINTS = 4


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


class Wave(NamedTuple):
    """a_k and b_k of a harmonic, in balls or floats."""

    cosine: Any
    sine: Any

    def turned(self, star: Star) -> Wave:
        """Return the sum of such waves, the rays of a star behind this one."""
        kind = floats() if isinstance(self.cosine, float) else balls()
        x, y = star.point(kind.circle, kind.of)
        return Wave(self.cosine * x - self.sine * y, self.sine * x + self.cosine * y)

    def __add__(self, other: object) -> Wave:
        assert isinstance(other, Wave)
        return Wave(self.cosine + other.cosine, self.sine + other.sine)


def star_of(turn: AnyTurn, part: int, order: Fraction) -> Star:
    """Return the vectors e^(ikα) of a part's cranks: their sum is its star of this order."""
    rays = (Star.ray(order * 180 * start) for start in turn.engine.parts[part].starts)
    return sum(rays, Star())


class Spectrum(ABC):
    """The harmonics of a turn, on its kind of number."""

    def __init__(self, turn: AnyTurn) -> None:
        self.turn = turn

    @abstractmethod
    def cylinder(self, part: int, order: Fraction) -> Wave:
        """Return the harmonic of one cylinder of a part, φ counted from its own crank."""

    def engine(self, order: Fraction) -> Wave | None:
        """Return that of the whole engine, None where its cranks' star is proved to be nothing."""
        found = None
        for part in range(len(self.turn.engine.parts)):
            star = star_of(self.turn, part, order)
            if self.has(part, order) and not star.vanishes():
                wave = self.cylinder(part, order).turned(star)
                found = wave if found is None else found + wave
        return found

    def has(self, part: int, order: Fraction) -> bool:
        """Whether cylinders of the part have such an order: halves need a cycle of two turns."""
        return not order % Fraction(2, len(self.turn.cylinders[part].strokes))


class Balls(Spectrum):
    """The harmonics in balls."""

    def __init__(self, turn: Turn) -> None:
        super().__init__(turn)
        alone = [replace(part, cranks=(Fraction(0),), lag=Fraction(0)) for part in turn.engine.parts]
        self.alone = [Turn(one, turn.method) for one in alone]
        # Cylinders alike have one wave.
        self._first = [alone.index(one) for one in alone]
        self._wave = lru_cache(None)(self._enclosed)
        self._samples = lru_cache(None)(self._sampled)

    def cylinder(self, part: int, order: Fraction) -> Wave:
        # Columns of few decimals more or less have one precision.
        bits = -(-flint.ctx.prec // BITS_STEP) * BITS_STEP
        with at_bits(bits):
            return self._wave(self._first[part], order, bits)

    def _enclosed(self, part: int, order: Fraction, bits: int) -> Wave:
        assert order <= MOST_ORDERS
        parts = (samples.with_wave(order) for samples in self._samples(part, bits))
        cosines, sines = zip(*parts, strict=True)
        share = ball(Fraction(2, self.alone[part].cycle))
        return Wave(share * sum(cosines), share * sum(sines))

    def _sampled(self, part: int, bits: int) -> tuple[Samples, ...]:
        """Return the tangential force of one cylinder over the parts of its cycle, for all orders."""
        on_complex = self.turn.cylinders_on(continued(), half_turn_circle)[part]
        return tuple(
            self._smooth(span, part, on_complex) if span.smooth else self._gap(span, part)
            for span in spans(self.alone[part])
        )

    def _smooth(self, span: Span, part: int, on_complex: Cylinder) -> Samples:
        ((_, stroke, begun),) = span.pieces[0].strokes
        middle, cylinder = float((span.start + span.end) / 2), self.turn.cylinders[part]
        return sampled(
            lambda place: ball(cylinder.effort(stroke, place - ball(begun))),
            lambda place: on_complex.effort(stroke, ComplexNumber(place, middle) - begun).ball,
            span.start,
            span.end,
            Fraction(MOST_ORDERS),
        )

    def _gap(self, span: Span, part: int) -> Samples:
        """What so narrow a gap adds, with a dead centre or a corner in it."""
        over, cylinder = interval(span.start, span.end), self.turn.cylinders[part]
        # A piece of the next cycle has the same circle.
        efforts = (
            ball(cylinder.effort(stroke, over - ball(begun)))
            for piece in span.pieces
            for _, stroke, begun in piece.strokes
        )
        either = reduce(arb.union, efforts)
        return Samples((Sample(over, ball(span.end - span.start) * either),), flint.arb(0))


class Floats(Spectrum):
    """The harmonics of a card, in floats, from the energy of its curves.

    The power less P is the slope of the excess energy E, which comes again with each cycle: its integral with
    e^(ikφ) is -ik ∫ E e^(ikφ) dφ. What T is beyond the power, to first order, is integrated as it is.
    """

    def __init__(self, turn: CardTurn, parts: int = PARTS) -> None:
        super().__init__(turn)
        self.parts = parts
        self._energies = lru_cache(None)(self._energy)

    def cylinder(self, part: int, order: Fraction) -> Wave:
        import numpy as np

        places, weights, energies, beyond, cycle = self._energies(part)
        share, own = -float(order) * 2 / cycle * weights * energies, 2 / cycle * weights * beyond
        angles = float(order) * pi * places
        cosine, sine = np.cos(angles), np.sin(angles)
        # -i (cos + i sin) is sin - i cos.
        return Wave(
            float((own * cosine).sum() - (share * sine).sum()), float((own * sine + share * cosine).sum())
        )

    def _energy(self, part: int) -> tuple[Any, Any, Any, Any, int]:
        """Return places over a cycle in half turns, their weights, the energies there, what the tangential
        force is beyond the power, and the cycle."""
        import numpy as np

        cylinder = self.turn.cylinders[part]
        cycle, drive = len(cylinder.strokes), cylinder.drive
        begins = [stroke + float(drive.dead_centre(stroke % 2)) for stroke in range(cycle + 1)]
        abscissas, weights = np.polynomial.legendre.leggauss(POINTS)
        found: list[list[Any]] = [[], [], [], []]
        for stroke, (begin, end) in enumerate(pairwise(begins)):
            edges = np.linspace(begin, end, self.parts + 1)
            half = (edges[1] - edges[0]) / 2
            places = ((edges[:-1] + half)[:, None] + half * abscissas).ravel()
            found[0].append(places)
            found[1].append(np.tile(half * weights, self.parts))
            angles = places - stroke
            found[2].append(cylinder.energy(stroke, angles))
            found[3].append(cylinder.effort(stroke, angles) - cylinder.power(stroke, angles))
        places, weights, energies, beyond = (np.concatenate(one) for one in found)
        return places, weights, energies, beyond, cycle


def spectrum_of(turn: AnyTurn) -> Spectrum:
    """Return the harmonics of a turn."""
    if isinstance(turn, Turn):
        return Balls(turn)
    from kurbel.engine.card.force import CardTurn

    assert isinstance(turn, CardTurn)
    return Floats(turn)
