"""Harmonics: of the straight crank's motion by the powers of sin² φ of its rod, of a torque by its series.

    cos ψ = √(1 - λ² sin² φ) = Σ C(½, j) (-λ² sin² φ)^j,
    sin^2j φ = ... + 2 (-1)^m C(2j, j - m)/4^j cos 2mφ + ...

No C(½, j) and no share of a cosine in a power is above 1, so what follows the power N is at most
λ^(2N + 2)/(1 - λ²). Of x = 1 - cos φ + (1 - cos ψ)/λ the acceleration has -k² times the share of cos kφ.

About the middle of a cell of half width h a torque is f(u) = Σ f_j u^j + f_n(U) u^n, j < n, with f_n(U) the
coefficient over the whole cell. Over the cell u^j of an odd j leaves nothing, of an even one 2 h^(j+1)/(j+1),
and the last term, n even, that times f_n(U). Cells on which it leaves too much are halved; corners lie
between cells, or in one as narrow as they are known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import pairwise
from math import comb
from typing import NamedTuple

from kurbel.verify.enclose import WorkingPrecision
from kurbel.verify.jets import Jet, turning
from kurbel.verify.numbers import Number, Undecided, number, spread
from kurbel.verify.plane import Arrow
from kurbel.verify.zeros import TOO_WIDE, Place, around

# Cells begin no wider than so many degrees, and there are at most so many.
WIDEST, MOST = 8, 2000


class Piece(NamedTuple):
    """A cell, and the series about its middle and over the whole of it."""

    cell: Place
    about: Jet
    over: Jet


def of_acceleration(ratio: Fraction, order: int) -> Number:
    """B_k of p = Σ B_k cos kφ."""
    if order % 2 or not ratio:
        return number(int(order == 1))
    m, square = order // 2, ratio * ratio
    least, total, binomial, power = (
        Fraction(1, 2**WorkingPrecision.bits),
        Fraction(0),
        Fraction(1),
        Fraction(1),
    )
    j = 0
    while j <= m or power / (1 - square) > least:
        if j >= m:
            total += binomial * power * (-1) ** j * Fraction(2 * (-1) ** m * comb(2 * j, j - m), 4**j)
        binomial *= (Fraction(1, 2) - j) / (j + 1)
        power *= square
        j += 1
    rest = power / (1 - square)
    return spread(total - rest, total + rest) * Fraction(order**2) / ratio


def pieces(course: Callable[[Place, int], Jet], breaks: Sequence[Number]) -> Iterator[Piece]:
    """The series of a torque from the first of its breaks to the last, between which it is smooth."""
    for one in breaks[1:]:
        if one.exact is None:
            yield Piece(around(one), course(around(one), 0), course(around(one), 0))
    cells, order, tried = list[Place](), WorkingPrecision.bits // 16 * 2, 0
    for begin, end in pairwise(breaks):
        reach = (end.low - begin.high) / 2
        cells += Place(begin.high + reach, reach).parts(int(2 * reach // WIDEST) + 1)
    while cells and tried < MOST:
        cell, tried = cells.pop(), tried + 1
        with suppress(*TOO_WIDE):
            over = course(cell, order)
            if abs(over.terms[order] * cell.half.power(Fraction(order))).high < Fraction(
                1, 2 ** (WorkingPrecision.bits // 3)
            ):
                yield Piece(cell, course(Place(cell.degrees), order), over)
                continue
        cells += cell.parts()
    if cells:
        raise Undecided("a harmonic")


def wave(found: Sequence[Piece], k: Fraction) -> Arrow:
    """∫ T cos kφ dφ and ∫ T sin kφ dφ."""
    total = Arrow(number(0), number(0))
    for cell, about, over in found:
        n, half = len(over.terms) - 1, cell.half
        whole = [2 * half.power(Fraction(j + 1)) / (j + 1) for j in range(n + 1)]
        near, far = (
            [
                Jet([a * k**j for j, a in enumerate(one.terms)])
                for one in turning(k * cell.degrees, n, k * reach)
            ]
            for reach in (Fraction(0), cell.reach)
        )
        parts = []
        for middle, within in zip(near, far, strict=True):
            terms = (*(about * middle).terms[:n], (over * within).terms[n])
            parts.append(sum((terms[j] * whole[j] for j in range(0, n + 1, 2)), number(0)))
        total = total.plus(Arrow(*parts))
    return total
