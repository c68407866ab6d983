"""Correctly rounded digits: kernel formulas in ball arithmetic, with a proof for every digit.

A ball holds the true value for certain. When it lies between two rounding boundaries the digit is settled;
when it touches one, the precision is doubled; when it has shrunk below the separation bound of the
formula (separation.py) and still touches, the value lies on the boundary: a tie.

flint has one precision for the process: of several threads one computes at a time. Python's own lock lets one
thread into flint at once, too, so that none waits who would not wait anyway.
"""

from __future__ import annotations

import copyreg
import os
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import inf
from threading import RLock
from typing import TypeVar

import flint
from flint import arb

from kurbel.errors import ProblemError
from kurbel.exact.kind import FoundAngle
from kurbel.exact.numerals import MOST_FIGURES
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.kinematics import rod_sine

Kept = TypeVar("Kept")

# A page has up to 50 decimals, and no product of formulas here loses more than a few bits.
GUARD_BITS = 40
# No value is so near to a boundary by chance, and a root to so many bits takes a second.
MOST_BITS = 20_000
# A proof that a value is a tie may need more; beyond these it takes minutes.
MOST_TIE_BITS = 200_000
_ENDLESS = flint.arb(10) ** MOST_FIGURES


def _pickled(found: arb) -> tuple[Callable[..., arb], tuple[object, ...]]:
    """Return how a finite ball is made anew, with no bit lost."""
    parts = (found.mid().man_exp(), found.rad().man_exp())
    return _unpickled, tuple((int(bits), int(power)) for bits, power in parts)


def _unpickled(middle: tuple[int, int], radius: tuple[int, int]) -> arb:
    return arb(middle, radius)


copyreg.pickle(arb, _pickled)


class UndecidedError(Exception):
    """A number is not known by its balls, or not as a sum of algebraic terms."""


def ball(value: Numeric) -> arb:
    """Return the ball around a rational number, or of one that is found, at the precision in force; what a
    formula gave of balls is one. Raises UndecidedError for other kinds of number."""
    if isinstance(value, arb):
        return value
    if isinstance(value, int):
        return flint.arb(value)
    if isinstance(value, FoundAngle):
        return value.enclosed()
    if not isinstance(value, Fraction):
        raise UndecidedError
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def ball_circle(degrees: Fraction) -> Circle[arb]:
    """Return sine, cosine and versine of an exact angle in degrees, at the precision in force."""
    return _ball_circle(degrees, flint.ctx.prec)


@lru_cache(maxsize=512)
def _ball_circle(degrees: Fraction, precision: int) -> Circle[arb]:
    half_turns = degrees / 180
    if isinstance(half_turns, FoundAngle):
        return half_turn_circle(half_turns.enclosed())
    turn = flint.fmpq(half_turns.numerator, half_turns.denominator)
    sine, cosine = flint.arb.sin_cos_pi_fmpq(turn)
    return Circle(sine, cosine, 2 * flint.arb.sin_pi_fmpq(turn / 2) ** 2)


def half_turn_circle(half_turns: arb) -> Circle[arb]:
    """Return the same of half turns, a ball."""
    half = (half_turns / 2).sin_pi()
    # Of a ball about exactly 0, flint's square is no number.
    return Circle(*half_turns.sin_cos_pi(), 2 * half * half)


def ball_degrees(sine: arb) -> arb:
    """Return the angle in degrees, within -90..90, that has this sine."""
    return sine.asin() * 180 / flint.arb.pi()


def rod_angle(circle: Circle[arb], ratio: arb, offset: arb | None) -> arb:
    """Return the rod angle ψ in degrees. Source: Rötscher, eq. (285)."""
    return ball_degrees(ball(rod_sine(circle, ratio, 0 if offset is None else offset)))


TieBits = Callable[[Fraction], float]
NEVER_TIES = None
"""For arcs and multiples of π: no value of theirs is a rational number other than zero or a whole degree."""


def rounded(value: Callable[[], Numeric], decimals: int, rounding: str, tie_bits: TieBits | None) -> int:
    """Return the true value times 10**decimals, rounded to the nearest integer.

    `value` computes a ball at the precision in force. `tie_bits` takes a boundary, an odd multiple of half
    a unit in the last place, and returns b such that the value equals the boundary or is at
    least 2**-b away from it, or inf if it cannot equal it. NEVER_TIES claims that for all boundaries; a
    value that comes nearer to one than 2**-MOST_BITS all the same raises ProblemError.
    """
    unit = 10**decimals
    precision = GUARD_BITS + (10 * decimals) // 3
    known: dict[int, float] = {}
    while True:
        precision *= 2
        with at_bits(precision):
            scaled = ball(value()) * unit
            magnitude = abs(scaled)
            if magnitude > _ENDLESS:
                raise ProblemError(f"a value has more than {MOST_FIGURES} figures, which are not printed")
            raised = magnitude + flint.arb(0.5)
            nearest = raised.floor().unique_fmpz()
            # A ball that touches a boundary from above, such as the exact 1.25, is settled for half away.
            if nearest is not None and (rounding == "half-away" or not raised.contains_integer()):
                return _signed(int(nearest), scaled)
            above = (2 * magnitude + flint.arb(0.5)).floor().unique_fmpz()
            if above is None and precision <= MOST_TIE_BITS:
                continue
            if above is None:
                raise ProblemError("a value is not settled: it grows beyond all bounds")
            odd = int(above)
            if odd not in known:
                known[odd] = inf if tie_bits is None else tie_bits(Fraction(odd, 2 * unit))
            bits = known[odd]
            if precision > (MOST_BITS if bits == inf else MOST_TIE_BITS):
                raise ProblemError(
                    f"a digit is not settled by {precision // 2} bits: the value may lie half-way between"
                    " two printed ones; ask for another number of digits"
                )
            if precision > bits and scaled.rad() * 2 < unit * flint.arb(2) ** -int(bits + 1):
                return _signed(_half(odd, rounding), scaled)


def vanishes(value: Callable[[], arb], bits: float) -> bool:
    """Return whether a value that is zero, or at least 2**-bits in magnitude, is zero for certain.

    A value that is not told from zero within MOST_TIE_BITS is not taken for it.
    """
    precision = GUARD_BITS
    while precision < MOST_TIE_BITS:
        precision *= 2
        with at_bits(precision):
            near = value()
            if not near.contains(0):
                return False
            if near == 0 or (precision > bits and abs(near).upper() < flint.arb(2) ** -int(bits + 1)):
                return True
            if bits >= MOST_TIE_BITS:
                return False
    return False


def _half(odd: int, rounding: str) -> int:
    away = (odd + 1) // 2
    return away - away % 2 if rounding == "half-even" else away


def _signed(magnitude: int, scaled: arb) -> int:
    return -magnitude if scaled < 0 else magnitude


def kept(value: Callable[[], Kept], step: int = 1) -> Callable[[], Kept]:
    """Return what gives the same balls at the precision in force, computed once for each precision.

    `step` rounds the precision up to its multiples.
    """
    balls: dict[int, Kept] = {}

    def at() -> Kept:
        precision = -(-flint.ctx.prec // step) * step
        if precision not in balls:
            with at_bits(precision):
                balls[precision] = value()
        return balls[precision]

    return at


def pi() -> arb:
    """Return π at the precision in force."""
    return flint.arb.pi()


BALLS = RLock()
# Those of floats, for what becomes one.
FLOAT_BITS = 53
if hasattr(os, "register_at_fork"):
    # A process that begins while another thread computes would wait for that thread, which it has not.
    os.register_at_fork(before=BALLS.acquire, after_in_parent=BALLS.release, after_in_child=BALLS.release)


class at_bits:
    """Within it balls have so many bits, and no other thread has others.

    An iterator that yields within it is to be run to its end, or left, in one thread.
    """

    __slots__ = ("_before", "_bits")

    def __init__(self, bits: int) -> None:
        self._bits = bits

    def __enter__(self) -> None:
        BALLS.acquire()
        self._before = flint.ctx.prec
        flint.ctx.prec = self._bits

    def __exit__(self, *_: object) -> None:
        flint.ctx.prec = self._before
        BALLS.release()
