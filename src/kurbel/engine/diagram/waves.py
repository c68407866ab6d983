"""Sums of waves a cos(kφ + α) with rational a, k and α in degrees: what sines of φ and their products are.

Such a sum stays one when it is added, multiplied, turned, differentiated or integrated, so that a torque in
sines has its mean, its energy and its slope in closed form. Angles are in degrees.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd, lcm
from typing import Any, TypeAlias

import flint

from kurbel.exact.certify import MOST_BITS, ball, vanishes
from kurbel.exact.kind import Kind, balls, bounds
from kurbel.exact.separation import plus, times
from kurbel.kernel.circle import Numeric
from kurbel.reading.given import Given

# Of a wave its order k and its phase α, at least 0° and below 180°, of a constant at most 90°.
Wave: TypeAlias = tuple[Fraction, Fraction]
# Cosines that are rational numbers; no other angles of the first quarter have one (Niven).
_COSINES = {0: Fraction(1), 60: Fraction(1, 2), 90: Fraction(0)}
HALF_TURN, QUARTER = Fraction(180), Fraction(90)


@dataclass(frozen=True)
class Waves(Given):
    """A sum of waves by their amplitudes, each of which is not zero."""

    amplitudes: Mapping[Wave, Fraction]

    @classmethod
    def of(cls, parts: Iterable[tuple[Fraction, Fraction, Fraction]]) -> Waves:
        """Return the sum of waves of these amplitudes, orders and phases."""
        found: dict[Wave, Fraction] = {}
        for amplitude, order, phase in parts:
            wave, own = _normal(amplitude, order, phase)
            found[wave] = plus(found.get(wave, Fraction(0)), own)
        return cls({wave: found[wave] for wave in sorted(found) if found[wave]})

    @classmethod
    def constant(cls, value: Fraction) -> Waves:
        return cls.of([(value, Fraction(0), Fraction(0))])

    @classmethod
    def cosine(cls, order: Fraction, phase: Fraction) -> Waves:
        """Return cos(kφ + α)."""
        return cls.of([(Fraction(1), order, phase)])

    @property
    def parts(self) -> Iterable[tuple[Fraction, Fraction, Fraction]]:
        """The amplitude, the order and the phase of each wave."""
        return ((amplitude, *wave) for wave, amplitude in self.amplitudes.items())

    def __bool__(self) -> bool:
        return bool(self.amplitudes)

    def __add__(self, other: Waves) -> Waves:
        return Waves.of((*self.parts, *other.parts))

    def __sub__(self, other: Waves) -> Waves:
        return self + other.times(Fraction(-1))

    def __mul__(self, other: Waves) -> Waves:
        # cos A cos B = ½ cos(A + B) + ½ cos(A - B)
        return Waves.of(
            (times(a, b) / 2, k + sign * order, phase + sign * turned)
            for a, k, phase in self.parts
            for b, order, turned in other.parts
            for sign in (1, -1)
        )

    def times(self, factor: Fraction) -> Waves:
        return Waves.of((times(factor, amplitude), *wave) for wave, amplitude in self.amplitudes.items())

    def turned(self, degrees: Fraction) -> Waves:
        """Return the same behind by an angle: what it was at φ it is at φ + angle."""
        return Waves.of((a, order, phase - order * degrees) for a, order, phase in self.parts)

    @cached_property
    def level(self) -> Waves:
        """The constant part."""
        return Waves({wave: a for wave, a in self.amplitudes.items() if not wave[0]})

    @cached_property
    def rational(self) -> Fraction | None:
        """The sum where it is one rational number, None where it is not."""
        if not self.amplitudes:
            return Fraction(0)
        return self.amplitudes.get((Fraction(0), Fraction(0))) if len(self.amplitudes) == 1 else None

    @cached_property
    def orders(self) -> tuple[Fraction, ...]:
        """The orders above 0, each once."""
        return tuple(dict.fromkeys(order for order, _ in self.amplitudes if order))

    @property
    def base(self) -> Fraction:
        """The greatest order of which all are multiples; 0 of a constant."""
        if not self.orders:
            return Fraction(0)
        above = gcd(*(order.numerator for order in self.orders))
        return Fraction(above, lcm(*(order.denominator for order in self.orders)))

    @cached_property
    def slope(self) -> Waves:
        """The slope over the angle in radians."""
        return Waves.of((a * order, order, phase + QUARTER) for a, order, phase in self.parts)

    @cached_property
    def integral(self) -> Waves:
        """What has the sum without its constant part as its slope over the angle in radians."""
        return Waves.of((a / order, order, phase - QUARTER) for a, order, phase in self.parts if order)

    def placed(self, degrees: Fraction) -> Waves:
        """Return the sum at a crank angle as one of constants, of which equal ones are one."""
        return Waves.of((a, Fraction(0), order * degrees + phase) for a, order, phase in self.parts)

    def at(self, degrees: Fraction, kind: Kind) -> Any:
        """Return the sum at a crank angle, on a kind of number."""
        total = kind.of(Fraction(0))
        for amplitude, _, phase in self.placed(degrees).parts:
            own = kind.of(amplitude)
            total = total + (own * _cosine(phase, kind) if phase else own)
        return total

    def within(self, degrees: Any) -> Any:
        """Return the sum at an angle that is a ball."""
        total, half_turns = flint.arb(0), degrees / 180
        for amplitude, order, phase in self._balls(flint.ctx.prec):
            total += amplitude * (order * half_turns + phase).cos_pi()
        return total

    def _balls(self, precision: int) -> list[tuple[Numeric, Numeric, Numeric]]:
        """Return the waves as balls, phases in half turns; made once for each precision."""
        if precision not in self._enclosed:
            self._enclosed[precision] = [
                (ball(amplitude), ball(order), ball(phase / 180)) for amplitude, order, phase in self.parts
            ]
        return self._enclosed[precision]

    @cached_property
    def _enclosed(self) -> dict[int, list[tuple[Numeric, Numeric, Numeric]]]:
        return {}

    def vanishes(self, degrees: Fraction, level: Fraction = Fraction(0)) -> bool:
        """Whether the sum and a number beside it are 0 at a crank angle, proved within MOST_BITS."""
        if not self.placed(degrees) + Waves.constant(level):
            return True

        def value(kind: Kind) -> Any:
            return self.at(degrees, kind) + kind.of(level)

        bits = float(value(bounds()).bits())
        return bits < MOST_BITS and vanishes(lambda: value(balls()), bits)


def _normal(amplitude: Fraction, order: Fraction, phase: Fraction) -> tuple[Wave, Fraction]:
    """Return the wave with an order and a phase that are not negative, and its amplitude."""
    if order < 0:
        order, phase = -order, -phase
    phase %= 360
    if phase >= HALF_TURN:
        amplitude, phase = -amplitude, phase - HALF_TURN
    if not order and phase > QUARTER:
        amplitude, phase = -amplitude, HALF_TURN - phase
    if not order and phase in _COSINES:
        amplitude, phase = amplitude * _COSINES[int(phase)], Fraction(0)
    return (order, phase), amplitude


def _cosine(degrees: Fraction, kind: Kind) -> Numeric:
    return kind.circle(float(degrees) if kind.of is float else degrees).cosine
