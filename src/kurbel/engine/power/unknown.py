"""A number of a load by a power, a mean pressure or a delivery: cut-off, pressures, clearance.

What the load makes of the number, on jets, is multiplied by what is known; all places between bounds at which
that is 1 are enclosed by interval arithmetic (exact/search), so that none is missed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from flint import arb

from kurbel.engine.power.duty import FACTOR, MEAN, OPEN_PRESSURE, VARIABLES
from kurbel.engine.power.source import SoughtLoadNumber
from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.kind import balls
from kurbel.exact.real import Term
from kurbel.exact.search import Jet, Zero, isolate
from kurbel.kernel.circle import Numeric
from kurbel.page.quantity import Words, words

# Beyond the bounds, so that a number at one of them is found.
BEYOND = Fraction(1, 3 << 40)
# So many values tell how near they come where none does.
STEPS = 64


class Unknown(NamedTuple):
    """A number of a load: the options of the loads that have it, the name that the load has for it, the least
    and the greatest, the values of the option of which one makes a load to begin with, its letter, and what
    sentences say of the bounds."""

    loads: tuple[str, ...]
    name: str
    low: Fraction
    high: Fraction
    probes: tuple[Fraction, ...]
    symbol: str
    bounds: Words


_SHARE = (Fraction(0), Fraction(1))
UNKNOWNS: Mapping[str, Unknown] = {
    "eps": Unknown(
        ("eps",), "cut_off", Fraction(1, 1000), Fraction(1), 
        (Fraction(1001, 1000), *map(Fraction, (2, 4, 8, 1))), "$ε$",
        words("zwischen 1 und 1000|between 1 and 1000"),
    ),
    "pressure": Unknown(
        ("eps",), "back", *_SHARE, (Fraction(10**11),), "$p$",
        words("über dem Gegendruck|above the back pressure"),
    ),
    "back": Unknown(
        ("eps",), "back", *_SHARE, (Fraction(0),), "$p_b$",
        words("zwischen 0 und dem Dampfdruck|between 0 and the steam pressure"),
    ),
    "clearance": Unknown(
        ("eps", "pressure_ratio"), "clearance", *_SHARE, (Fraction(0), Fraction(1, 10), Fraction(1)),
        "$κ$",
        words("zwischen 0 und dem Hubraum|between 0 and the swept volume"),
    ),
    "pressure_ratio": Unknown(
        ("pressure_ratio",), "ratio", Fraction(1), Fraction(1000), (Fraction(1001, 1000),),
        "$Π$", words("zwischen 1 und 1000|between 1 and 1000"),
    ),
}  # fmt: skip
# What may be asked for, with what follows from products alone.
NAMES = (*UNKNOWNS, *(name for name in VARIABLES if name not in (*UNKNOWNS, FACTOR)), FACTOR)


class Search:
    """All numbers of a load between the bounds with which a relation is 1."""

    def __init__(self, load: Any, option: str, relation: Term, over: Fraction | None) -> None:
        self.given = load, option, relation, over
        self.load, self.option, self.over = load, option, over
        first = relation.powers.get(MEAN, next(iter(relation.powers.values())))
        self.known = relation.known ** (1 / first)
        self.powers = {name: power / first for name, power in relation.powers.items()}

    def __reduce__(self) -> tuple[object, ...]:
        # What was found is found again elsewhere.
        return type(self), self.given

    @cached_property
    def zeros(self) -> list[Zero]:
        """The numbers. Raises ProblemError where two cannot be told apart, NoRootError for none."""
        asked = UNKNOWNS[self.option]
        low, high = asked.low + (BEYOND if asked.low == 1 else -BEYOND), asked.high + BEYOND
        # Below it compression reaches more than there is.
        least = self.load.least(asked.name) if hasattr(self.load, "least") else Fraction(0)
        low = max(low, least) if least else low
        found = isolate(lambda at: ball(self._apart(at)), self._slope, low, high)
        # Where nothing is delivered any more nothing is done, and of both any multiple.
        found = [
            one for one in found if not any(ball(side).contains(0) for side in self._sides(one.place())[1:])
        ]
        if any(one.rising is None for one in found):
            raise ProblemError(
                f"whether one or two values of {self.option} do is not settled; alter what is given a little"
            )
        if not found:
            raise NoRootError(self._nowhere(asked, low, high))
        return found

    def _sides(self, number: Numeric) -> list[Numeric]:
        """Return what the load makes, and what it has to make."""
        kind, name = balls(), UNKNOWNS[self.option].name
        found = [self.known.on(kind), kind.of(Fraction(1))]
        for of, power in self.powers.items():
            if of == OPEN_PRESSURE:
                # The pressure is so many times the number below 1, which may be 0.
                found = [found[0] * kind.of(self.over or Fraction(1)), found[1] * number]
                continue
            made = (self.load.mean if of == MEAN else self.load.delivered)(kind, **{name: number})
            side, exponent = power < 0, abs(power)
            found[side] = found[side] * (made if exponent == 1 else made ** kind.exponent(exponent))
        return found

    def _apart(self, number: Any) -> Any:
        makes, has = self._sides(number)
        return makes - has

    def _slope(self, at: arb) -> arb:
        return arb(self._apart(Jet(at, arb(1), arb(0))).slope)

    def _nowhere(self, asked: Unknown, low: Fraction, high: Fraction) -> str:
        steps = (low + (high - low) * step / STEPS for step in range(1, STEPS))
        shares = [float(one / other) for one, other in (self._sides(arb(float(at))) for at in steps)]
        most = max(shares) < 1
        much, best = ("less, at most", max(shares)) if most else ("more, at least", min(shares))
        return (
            f"no {self.option} {asked.bounds['en']} does what is given: all make {much} {100 * best:.4g} % of"
            " it; check sizes and pressures"
        )


@dataclass(frozen=True)
class Root:
    """One of what a search finds, at the precision in force."""

    search: Search
    index: int

    def __call__(self) -> arb:
        return self.search.zeros[self.index].place()


def sought(load: Any, option: str, relation: Term, over: Fraction | None) -> list[SoughtLoadNumber]:
    """Return all numbers between the bounds with which the relation is 1. Raises ProblemError where two of
    them cannot be told apart, and NoRootError where there is none."""
    search = Search(load, option, relation, over)
    return [
        SoughtLoadNumber(option, UNKNOWNS[option].name, Root(search, at), over)
        for at in range(len(search.zeros))
    ]
