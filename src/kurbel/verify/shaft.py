"""Masses on a shaft: what turns with it and what goes to and fro in its cylinders, as sums of vectors.

A vector lies in the plane across the shaft, angles count as the shaft turns. What turns pulls along its
radius. A force B cos k(φ + a - b) of order k in the direction b of a cylinder whose crank stands at a is half
a vector at b + k (φ + a - b) and half one at b - k (φ + a - b): the first turns forward, the second back.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import reduce
from typing import NamedTuple

from kurbel.verify.numbers import Number, number, sine_cosine
from kurbel.verify.plane import Arrow


class PlanarVector(NamedTuple):
    """A vector in a plane across the shaft, at a place along it."""

    arrow: Arrow
    place: Number


class Slide(NamedTuple):
    """A cylinder: the angles of its crank and of its slide, its place along the shaft, what goes to and fro
    and what turns with the crank."""

    crank: Fraction
    bank: Fraction
    place: Fraction
    moved: Fraction
    turned: Fraction


def ray(size: Number | Fraction, degrees: Fraction) -> Arrow:
    sine, cosine = sine_cosine(degrees)
    return Arrow(cosine, sine).times(number(size))


def together(arrows: Iterable[Arrow]) -> Arrow:
    return reduce(Arrow.plus, arrows, Arrow(number(0), number(0)))


def moment(pulls: Sequence[PlanarVector], about: Number | Fraction = Fraction(0)) -> Arrow:
    """In the direction of the forces of the couple."""
    return together([one.arrow.times(one.place - about) for one in pulls])


def held(pulls: Sequence[PlanarVector], planes: Sequence[Fraction]) -> tuple[Arrow, ...]:
    """Vectors in two planes with the sum and the moment of all, or the sum in one plane."""
    whole = together([one.arrow for one in pulls])
    if len(planes) == 1:
        return (whole,)
    far = moment(pulls, planes[0]).times(1 / number(planes[1] - planes[0]))
    return whole.minus(far), far


def parts(slides: Sequence[Slide], order: int, harmonic: Number, share: Fraction) -> tuple[Arrow, Arrow]:
    """What turns forward by kφ and what turns back, at φ = 0, in the unit of the masses; counterweights turn
    opposite the cranks with a share of what goes to and fro."""
    forward, back = (
        together([ray(one.moved, one.bank + sense * order * (one.crank - one.bank)) for one in slides]).times(
            harmonic / 2
        )
        for sense in (1, -1)
    )
    if order == 1:
        forward = forward.plus(together([ray(one.turned - share * one.moved, one.crank) for one in slides]))
    return forward, back
