"""A number other than the crank angle for which a condition holds at one, each with proof.

A force at an angle is a polynomial of the piston force, the pressure, a mass or the speed, of degree 1 in
itself or in its square, and so is a velocity; the torque is one of degree 2 in the stroke. A few values of
the formula therefore tell it for all. The crank ratio enters with roots: there all zeros of the formula are
enclosed by interval arithmetic (exact/search).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

import flint
from flint import arb

from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.jet import Jet
from kurbel.exact.search import isolate
from kurbel.page.quantity import Words, words

# At which a formula is evaluated to find its polynomial, in times of the probe of an unknown.
PROBES = (Fraction(1), Fraction(2), Fraction(3), Fraction(5, 2))
# So many bits must decide whether a coefficient is zero.
DECIDING_BITS = 512


class Unknown(NamedTuple):
    """What can be asked for beside the angle: its name, letter, unit on pages and that in SI units, a value
    with which every drive and engine is one, the power of it in which forces are of degree 1, and the
    option that says what drives."""

    name: Words
    symbol: str
    unit: str
    size: Fraction
    probe: Fraction
    power: int = 1


UNKNOWNS = {
    "speed": Unknown(
        words("Drehzahl|Speed"), "$n$", '$"min"^(-1)$', Fraction(1, 60), Fraction(1), 2
    ),
    "force": Unknown(words("Kolbenkraft|Piston force"), "$F$", "N", Fraction(1), Fraction(1000)),
    # Above every back pressure.
    "pressure": Unknown(
        words("Dampfdruck|Steam pressure"), "$p$", "bar", Fraction(10**5), Fraction(10**10)
    ),
    "bore": Unknown(words("Bohrung|Bore"), "$d$", "mm", Fraction(1, 1000), Fraction(1), 2),
    "reciprocating": Unknown(
        words("hin- und hergehende Masse|Reciprocating mass"), "$m$", "kg", Fraction(1), Fraction(100)
    ),
    "rod_mass": Unknown(words("Masse der Stange|Mass of the rod"), "$M$", "kg", Fraction(1), Fraction(100)),
    "stroke": Unknown(words("Hub, 2 R|Stroke, 2 R"), "$2 R$", "mm", Fraction(1, 1000), Fraction(1)),
    "ratio": Unknown(words("Kurbelverhältnis|Crank ratio"), "$R/L$", "", Fraction(1), Fraction(1, 4)),
}  # fmt: skip


@dataclass(frozen=True)
class Polynomial:
    """A formula as a polynomial of a power of the unknown.

    `value` evaluates it at an exact value of the unknown, at the precision in force; where it is the
    magnitude of a force, which is a square root of a polynomial, its `square` is taken.
    """

    value: Callable[[Fraction], arb]
    target: Callable[[], arb]
    probe: Fraction
    power: int
    degree: int
    square: bool = False

    def coefficients(self) -> list[arb]:
        """Return the coefficients of the polynomial less the target, from the constant one on.

        By divided differences; one more value is compared with them.
        """
        count = (2 if self.square else 1) * self.degree + 1
        nodes = [self.probe * factor for factor in PROBES]
        places = [ball(node**self.power) for node in nodes]
        values = [self._at(node) for node in nodes]
        table, found = values[:count], []
        for order in range(count):
            found.append(table[0])
            table = [
                (table[at + 1] - table[at]) / (places[at + 1 + order] - places[at])
                for at in range(len(table) - 1)
            ]
        polynomial = [arb(0)]
        for order in reversed(range(count)):
            # Newton's form, by Horner: times (t - t_k), plus the difference of this order.
            shifted = [arb(0), *polynomial]
            polynomial = [
                one - places[order] * other for one, other in zip(shifted, [*polynomial, arb(0)], strict=True)
            ]
            polynomial[0] += found[order]
        polynomial = polynomial[:count]
        checked = sum((one * places[-1] ** power for power, one in enumerate(polynomial)), arb(0))
        if not (checked - values[-1]).contains(0):
            raise ProblemError("this unknown enters otherwise than by a square at most; ask for another one")
        polynomial[0] -= self.target() ** 2 if self.square else self.target()
        return polynomial

    def _at(self, node: Fraction) -> arb:
        value = self.value(node)
        return value**2 if self.square else value

    def roots(self) -> list[Callable[[], arb]]:
        """Return all positive values of the unknown with which the value is the target, in order."""
        with at_bits(DECIDING_BITS):
            exact = self._real()
            count = len(exact)
            order = sorted(range(count), key=lambda index: float(exact[index].mid()))
        return [_chosen(self, index) for index in order if exact[index] > 0]

    def _real(self) -> list[arb]:
        """Return the real zeros over the power of the unknown, in the order of the formula."""
        constant, *others = self.coefficients()
        # So many bits tell a coefficient from zero that is not zero by the sizes of the drive.
        while others and others[-1].contains(0):
            others.pop()
        if not others:
            raise ProblemError("the condition does not depend on what is asked for; ask for another unknown")
        if len(others) == 1:
            return [-constant / others[0]]
        linear, square = others
        below = linear * linear - 4 * square * constant
        if below < 0:
            return []
        if below.contains(0):
            raise ProblemError(
                "whether the condition is just reached is not settled; alter its value a little"
            )
        root = below.sqrt()
        return [(-linear + sign * root) / (2 * square) for sign in (-1, 1)]


def _chosen(polynomial: Polynomial, index: int) -> Callable[[], arb]:
    def root() -> arb:
        with at_bits(max(flint.ctx.prec, DECIDING_BITS)):
            found = polynomial._real()[index]
            return found if polynomial.power == 1 else found.root(polynomial.power)

    return root


def of_ratio(formula: Callable[[Any], Any], target: Callable[[], arb], greatest: Fraction) -> list[Any]:
    """Return all crank ratios above 0 and up to the greatest with which a formula, that takes numbers or jets
    over the ratio, has the target; each to be refined at the precision in force."""

    def function(ratio: arb) -> arb:
        found: arb = formula(ratio) - target()
        return found

    def slope(ratio: arb) -> arb:
        found: arb = formula(Jet(ratio, arb(1), arb(0))).slope
        return arb(found)

    least = greatest / 2**20
    found = []
    for zero in isolate(function, slope, least, greatest):
        if zero.rising is None:
            raise ProblemError("the condition holds at more ratios than can be told apart; alter its value")
        found.append(zero.place)
    return found


def nowhere(unknown: str, condition: str) -> NoRootError:
    """Return the error for a condition that no value of the unknown fulfils."""
    name = unknown.replace("_", " ")
    return NoRootError(f"{condition} is reached with no {name} above 0 at this angle; check signs and sizes")
