"""A compound engine: the high-pressure cylinder before that in which the mean pressure counts.

Steam expands by Mariotte's law, without clearance, and without a fall of pressure between the cylinders. So
both do the work of the whole expansion ε in the low-pressure cylinder, p V₁ (1 + ln ε - b ε); the
high-pressure one has ln R of the bracket, for it expands R times and gives the steam away at p/R. Derived by
us; the strokes of both are alike.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.engine.power.source import Acting
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.kind import Kind, balls
from kurbel.exact.real import Product, Term, number
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.steam import logarithm
from kurbel.reading.given import allowed_name, as_length, as_number, as_pressure

HALF = Fraction(1, 2)
# By what the high-pressure cylinder is known: equal works, equal loads on the pistons where their strokes
# begin, its bore, the pressure in the receiver, its own expansion.
WORK, LOAD, BORE, RECEIVER, EXPANSION = "work", "load", "bore", "receiver", "expansion"


class Compound(NamedTuple):
    """How the high-pressure cylinder is known, and the value in SI units."""

    way: str
    value: Fraction = Fraction(1)

    def check(self, steam: Any) -> None:
        """Raise ProblemError for steam of which the works are not computed."""
        if steam.exponent != 1 or steam.clearance or not steam.plain:
            raise ProblemError(
                "--compound is of the hypothetical diagram, by Mariotte's law without clearance; leave"
                " --exponent, --clearance, --release, --cushion and --lead out"
            )

    def expansion(self, acting: Acting, pressure: Term, bore: Term) -> Term:
        """Return how many times the steam expands in the high-pressure cylinder, R, of the pressure in Pa and
        the low-pressure bore in metres."""
        if self.way == EXPANSION:
            return number(self.value)
        if self.way == RECEIVER:
            return pressure / number(self.value)
        if self.way == BORE:
            return Term(whole(acting)) * (number(self.value) / bore) ** Fraction(2)
        if self.way == LOAD:
            return Term(Product.about(lambda kind: _by_load(*_numbers(acting, kind))))
        steam = acting.load
        if acting.sought is None and steam.back in (None, 1 / steam.expansion):
            return Term(whole(acting) ** HALF)
        return Term(Product.about(lambda kind: kind.enclosed(lambda: _by_work(*_numbers(acting, balls())))))


def whole(acting: Acting) -> Product:
    """Return the whole expansion ε."""
    if acting.sought is None:
        return Product.of(acting.load.expansion)
    return Product.about(lambda kind: _numbers(acting, kind)[0])


def work_of(compound: Compound | None, acting: Acting, expansion: Term, high: bool) -> Term:
    """Return the share of a cylinder in the work, the high-pressure one or the other."""
    if compound is not None and compound.way == WORK:
        return number(HALF)

    def part(kind: Kind) -> Any:
        epsilon, lost = _numbers(acting, kind)
        found = logarithm(expansion.known.on(kind)) / (1 + logarithm(epsilon) - lost)
        return found if high else 1 - found

    return Term(Product.about(part), expansion.powers)


def _numbers(acting: Acting, kind: Kind) -> tuple[Numeric, Numeric]:
    """Return ε and b ε on a kind of number."""
    steam = acting.load.numbers(kind.of, kind.exponent)._replace(**acting.found(kind))
    back = steam.cut_off if acting.load.back is None else steam.back
    return 1 / steam.cut_off, back / steam.cut_off


def _by_work(epsilon: Any, lost: Any) -> Any:
    """Return R of equal works: ln R = 1 + ln(ε/R) - b ε."""
    return epsilon.sqrt() * ((1 - lost) / 2).exp()


def _by_load(epsilon: Numeric, lost: Any) -> Numeric:
    """Return R of equal loads: (1 - 1/R) A_h = (1/R - b) A_l, with A_l/A_h = ε/R."""
    return (1 - lost + root((1 - lost) * (1 - lost) + 4 * epsilon)) / 2


def as_compound(given: object, what: str) -> Compound:
    """Read how the high-pressure cylinder is known: work, load, 250mm, 2.4bar, 2.5. Raises KurbelError."""
    from kurbel.reading.units import is_measure

    if not isinstance(given, str) or (any(map(str.isdigit, given)) and not is_measure(given)):
        return _above_zero(EXPANSION, given, as_number)
    if not any(map(str.isdigit, given)):
        return Compound(allowed_name(given, (WORK, LOAD), "way of sharing between the cylinders"))
    try:
        return _above_zero(BORE, given, as_length)
    except NotationError:
        return _above_zero(RECEIVER, given, as_pressure)


def _above_zero(way: str, given: object, read: Callable[..., Fraction]) -> Compound:
    value = read(given, "pressure of the receiver" if way == RECEIVER else f"high-pressure {way}")
    if value <= 0:
        raise ProblemError(f"--compound is {given}; it must be above 0")
    return Compound(way, value)
