"""Where a free force or moment is greatest over the turn, with proof: its square with its slopes, in balls.

Angles are in half turns. What is proved to vanish does not stand in it, so that it is no difference of what
is much greater.

Its square is greatest where it has no slope and bends downwards: all such places are enclosed, but for those
in parts of the turn over which it is proved to be below what it reaches elsewhere.

An engine's cylinders and a layout become a table of the greatest free forces and moments, and of where.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, lru_cache, partial
from math import acosh, ceil, inf, log
from typing import NamedTuple

import flint
from flint import arb, arb_series

from kurbel.balancing.angles import LineAxis, LinesRequest, angle_notes, of_all
from kurbel.balancing.arrangement import LENGTHS, WEIGH, Arrangement, Residual, factor
from kurbel.balancing.balance_page import (
    RESIDUALS,
    SUBJECT,
    balance_registry,
    in_newtons,
    number_in,
)
from kurbel.balancing.harmonics import HARMONICS
from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact import search
from kurbel.exact.certify import NEVER_TIES, at_bits, ball, ball_circle, rounded
from kurbel.exact.kind import balls
from kurbel.exact.numerals import Number
from kurbel.exact.real import EXACT_ZERO, Real
from kurbel.exact.search import SHARP_BITS, Summit, Zero, isolate
from kurbel.kernel.harmonics import Star
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, Formula, Quantity, entry
from kurbel.page.subject import Subject

# The value, its slope and half its second slope.
TERMS = 3


class Wave(NamedTuple):
    """An order that is left: two vectors at φ = 0, without the harmonic's factor, which is on balls."""

    order: int
    residual: Residual
    factor: Callable[[], arb]


class Slide(NamedTuple):
    """Cylinders that have the same angle between pin and slide, in degrees: their vectors together."""

    turned: Fraction
    star: Star


class Parts(NamedTuple):
    """The vectors of an order on balls, times its factor, as what cos and sin of its angle are times."""

    order: int
    of_cosine: tuple[arb, arb]
    of_sine: tuple[arb, arb]


@dataclass(frozen=True)
class Curve:
    """The orders that are left, and of an exact sum of all orders what the slides add to the first."""

    waves: tuple[Wave, ...]
    slides: tuple[Slide, ...] = ()
    ratio: Fraction = Fraction(0)

    def square(self, half_turns: arb) -> arb_series:
        """Return |V|² and its slopes at an angle, or enclosures of them over a ball of angles."""
        parts, tail = _parts(self, flint.ctx.prec)
        x, y = arb_series(tail, TERMS), arb_series(tail, TERMS)
        for part in parts:
            turn = arb_series([half_turns * part.order, part.order], TERMS)
            sine, cosine = turn.sin_cos_pi()
            x = x + cosine * part.of_cosine[0] + sine * part.of_sine[0]
            y = y + cosine * part.of_cosine[1] + sine * part.of_sine[1]
        return x * x + y * y


@lru_cache(maxsize=64)
def _parts(curve: Curve, bits: int) -> tuple[tuple[Parts, ...], list[arb]]:
    """Return the orders on balls of so many bits, and what those that are left out can come to."""
    waves = [*curve.waves]
    if not curve.slides:
        return tuple(map(_on_balls, waves)), [flint.arb(0)] * TERMS
    width = _width(curve.ratio)
    last = 2 * ceil((bits + 16) * log(2) / (2 * width))
    for order in range(2, last + 1, 2):
        forward, backward = (
            sum((one.star.turned(sign * order * one.turned) for one in curve.slides), Star()) * Fraction(1, 2)
            for sign in (1, -1)
        )
        if not (forward.vanishes() and backward.vanishes()):
            waves.append(Wave(order, Residual(forward, backward), _harmonic(order, curve.ratio)))
    return tuple(map(_on_balls, waves)), _tail(curve, last, width)


def _harmonic(order: int, ratio: Fraction) -> Callable[[], arb]:
    return lambda: ball(HARMONICS["p"].value(order, ball(ratio)))


def _on_balls(wave: Wave) -> Parts:
    size = wave.factor()
    f_x, f_y = map(ball, wave.residual.forward.point(ball_circle, ball))
    b_x, b_y = map(ball, wave.residual.backward.point(ball_circle, ball))
    return Parts(
        wave.order,
        ((f_x + b_x) * size, (f_y + b_y) * size),
        ((b_y - f_y) * size, (f_x - b_x) * size),
    )


def _width(ratio: Fraction) -> float:
    """Return a width of the strip about the real angles in which the piston acceleration is analytic.

    It is so up to arcosh(1/λ), where λ sin θ = 1; a part of that bounds it well.
    """
    return 0.8 * acosh(1 / float(ratio))


def _tail(curve: Curve, last: int, width: float) -> list[arb]:
    """Return balls about 0 that enclose what the orders above the last add to x or y, and to the slopes.

    With θ = u + i w it is |sin θ| <= cosh w and |cos 2θ| <= cosh 2w, and |B_k| is at most twice the bound of
    the even part there times exp(-k w) (Cauchy). Re-derived.
    """
    w, ratio = flint.arb(width), ball(curve.ratio)
    square = (ratio * w.cosh()) ** 2
    bound = ratio * ((2 * w).cosh() + square * w.cosh() ** 2) / (1 - square) ** flint.arb(1.5)
    lengths = Fraction(sum(abs(length) for one in curve.slides for _, length in one.star.rays))
    first, decay = last + 2, (-2 * w).exp()
    # Two more orders j times have at most (1 + j)² of what the first has by its slopes.
    all_orders = 2 * bound * ball(lengths) * (-first * w).exp() * 2 / (1 - decay) ** 3
    slope = flint.arb.pi() * first
    sizes = (all_orders, all_orders * slope, all_orders * slope * slope / 2)
    return [flint.arb(0).union(size).union(-size) for size in sizes]


def slides_of(arrangement: Arrangement, residual: str) -> tuple[Slide, ...]:
    """Return the cylinders of an arrangement by their angles between pin and slide.

    What they add to the first order has a period of half a turn; what vanishes of it is left out.
    """
    stars: dict[Fraction, Star] = {}
    for one in arrangement.cylinders:
        turned = (one.crank - one.bank) % 180
        ray = Star.ray(one.bank, one.mass * WEIGH[residual](one))
        stars[turned] = stars.get(turned, Star()) + ray
    return tuple(Slide(turned, star) for turned, star in sorted(stars.items()) if not star.vanishes())


def left(residuals: Sequence[tuple[int, Residual, Callable[[], arb]]]) -> tuple[Wave, ...]:
    """Return the orders that do not vanish."""
    return tuple(
        Wave(order, residual, factor)
        for order, residual, factor in residuals
        if not (residual.forward.vanishes() and residual.backward.vanishes())
    )


# No part of the turn ends at an angle at which an engine is greatest.
START = Fraction(1_234_567, 10**8)
PARTS = 48
MOST_PARTS = 6_000
# So many angles are asked for again while a part of the turn is looked at.
KEPT = 8


class Greatest(NamedTuple):
    """The zero of the slope at which it is greatest, the first where there are several alike."""

    curve: Curve
    zero: Zero

    def place(self) -> arb:
        """Return the angle in half turns, at the precision in force."""
        return self.zero.place()

    def length(self) -> arb:
        return self.curve.square(self.place())[0].sqrt()


class _Squares:
    """The square over half turns with its slopes."""

    def __init__(self, curve: Curve) -> None:
        self._at = lru_cache(KEPT)(lambda place, bits: curve.square(arb(*place)))

    def _term(self, half_turns: arb, order: int) -> arb:
        return self._at((half_turns.mid().man_exp(), half_turns.rad().man_exp()), flint.ctx.prec)[order]

    def value(self, half_turns: arb) -> arb:
        """Return the square, over an interval as narrow as the mean-value form is."""
        middle = half_turns.mid()
        away = self.slope(half_turns) * (half_turns - middle)
        return self._term(half_turns, 0).intersection(self._term(middle, 0) + away)

    def slope(self, half_turns: arb) -> arb:
        return self._term(half_turns, 1)

    def bend(self, half_turns: arb) -> arb:
        return 2 * self._term(half_turns, 2)


def greatest(curve: Curve) -> Greatest:
    """Return the greatest value of a curve that does not vanish and is no circle.

    Raises ProblemError where it is not found within MOST_PARTS parts.
    """
    squares = _Squares(curve)
    summit, parts = Summit(squares.value), iter(range(MOST_PARTS))

    def concerns(part: arb) -> bool:
        if next(parts, None) is None:
            raise _not_found()
        return summit.concerns(part)

    with at_bits(SHARP_BITS):
        for part in range(PARTS):
            summit.reach(ball(START + Fraction(2 * part + 1, PARTS)))
    found = isolate(squares.slope, squares.bend, START, START + 2, concerns, SHARP_BITS)
    if any(zero.rising is None for zero in found):
        raise _not_found()
    tops = [Greatest(curve, zero) for zero in found if not zero.rising]
    return min(search.greatest(tops, Greatest.length), key=_degrees)


def _degrees(one: Greatest) -> float:
    return float(one.place().mid()) * 180 % 360


def _not_found() -> ProblemError:
    return ProblemError(
        "the greatest of all orders together is not found: it is too small beside the forces of the"
        " cylinders, or nearly the same all around; take --method series, or look at the orders"
    )


GREATEST, PLACE = "greatest", "greatest_phi"
PLACE_DECIMALS = 2
# Of a place that may be a whole part of a degree, so many of them.
FINEST = 8
NEAR = 1e-9


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the columns by their keys."""
    # The heads of the pages by orders stand under a spanner.
    whole = balance_registry()[GREATEST]
    own = whole._replace(spanners=(), heading=whole.name)
    name = "größter Betrag bei φ|Greatest magnitude at φ"
    head = "bei $φ$ in °|at $φ$ in °"
    place = entry(PLACE, name, "", "°", PLACE_DECIMALS, {"exact": Formula(LENGTHS[GREATEST])}, head)
    return {one.key: one for one in (own, in_newtons(own), place)}


class ExtremesRequest(LinesRequest):
    """What is asked for: the greatest forces and moments of an arrangement over the turn, by orders and
    all together."""

    no_column = "there is no column beside the axes; add one, such as greatest"

    @property
    def in_own_units(self) -> bool:
        return any(one.quantity.key == GREATEST for one in self.page_columns)

    @cached_property
    def curve(self) -> Callable[[str, int], Curve]:
        """Return the curve of all orders together of a residual at a ratio, each found once."""
        return cache(self._curve)

    def _curve(self, key: str, ratio: int) -> Curve:
        crank = Crank(self.ratios[ratio])
        exact = self.method == "exact" and bool(crank.ratio)
        orders = (1,) if exact else self.orders
        scales = {one: factor(one, crank, self.method) for one in orders}
        waves = left(
            [
                (one, self.residuals[key, one], partial(_scaled, scale))
                for one, scale in scales.items()
                if scale.rational != 0
            ]
        )
        return Curve(waves, slides_of(self.placed, key) if exact else (), crank.ratio)

    @cached_property
    def greatest(self) -> Callable[[str, int], Greatest]:
        return cache(lambda key, ratio: greatest(self.curve(key, ratio)))


def _scaled(scale: Real) -> arb:
    return ball(scale.on(balls()))


def _number(question: ExtremesRequest, column: Column, place: Place, times: int) -> Number | None:
    key, order, ratio = RESIDUALS[place["residual"]], question.lines[place["order"]], place["ratio"]
    unit = question.unit(column.quantity, key)
    if unit is None:
        return None
    if order is None:
        curve = question.curve(key, ratio)
        if not (curve.waves or curve.slides):
            return None if column.quantity.key == PLACE else EXACT_ZERO
        if curve.slides or len(curve.waves) > 1:
            return _of_all(question, column, key, ratio, unit)
        order = curve.waves[0].order
    scale = factor(order, Crank(question.ratios[ratio]), question.method)
    residual = question.residuals[key, order]
    if column.quantity.key == PLACE:
        # The two vectors meet where k φ + arg f = arg b - k φ.
        meeting = Vector(residual.backward * residual.forward.mirrored())
        return None if scale.rational == 0 else meeting.number(column.places, question.rounding, 2 * order)
    return number_in(question, column, key, LENGTHS[GREATEST](residual) * scale)


def _of_all(question: ExtremesRequest, column: Column, key: str, ratio: int, scale: Real) -> Number:
    found = question.greatest(key, ratio)

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if _is_reached(question, (key, ratio), found, boundary / known(scale.rational)) else inf

    ties = NEVER_TIES if scale.rational is None or column.quantity.key == PLACE else tie_bits

    def value() -> arb:
        if column.quantity.key == PLACE:
            return _printed_degrees(found)
        return ball(scale.on(balls())) * found.length()

    return Number(rounded(value, column.places, question.rounding, ties), column.places)


def _printed_degrees(found: Greatest) -> arb:
    degrees = found.place() * 180
    return degrees - 360 if degrees.mid() > 360 - NEAR else degrees


def _is_reached(question: ExtremesRequest, where: tuple[str, int], found: Greatest, length: Fraction) -> bool:
    """Whether the length is reached exactly at the part of a degree at which the greatest one is.

    The greatest is then not below it, and rounds as it does.
    """
    key, ratio = where
    angle = Fraction(round(float(_printed_degrees(found).mid()) * FINEST), FINEST)
    crank = Crank(question.ratios[ratio])
    return (of_all(question, key, crank, angle).square() - length**2).vanishes()


_BALANCED: Subject[ExtremesRequest] = SUBJECT
EXTREMES = _BALANCED._replace(
    key="balance extremes",
    layout="balance-greatest",
    command="balance --layout balance-greatest",
    axes={**SUBJECT.axes, "order": LineAxis},
    quantities=quantities,
    number=_number,
    notes=angle_notes,
    listed=lambda: (("balance --layout balance-greatest", quantities()[PLACE]),),
)
