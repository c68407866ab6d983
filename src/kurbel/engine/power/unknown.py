"""A number of a load by a power, a mean pressure or a delivery: cut-off, pressures, clearance.

What the load makes of the number, on jets, is multiplied by what is known; all places between bounds at which
that is 1 are enclosed by interval arithmetic (exact/search), so that none is missed.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from kurbel.engine.power.duty import FACTOR, MEAN, OPEN_PRESSURE, VARIABLES
from kurbel.engine.power.source import Sought
from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.jet import Jet
from kurbel.exact.kind import balls
from kurbel.exact.real import Term
from kurbel.exact.search import isolate
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


def sought(load: Any, option: str, relation: Term, over: Fraction | None) -> list[Sought]:
    """Return all numbers between the bounds with which the relation is 1. Raises ProblemError where two of
    them cannot be told apart, and NoRootError where there is none."""
    asked = UNKNOWNS[option]
    first = relation.powers.get(MEAN, next(iter(relation.powers.values())))
    known = relation.known ** (1 / first)

    def sides(number: Any) -> list[Any]:
        """Return what the load makes, and what it has to make."""
        kind = balls()
        found = [known.on(kind), kind.of(Fraction(1))]
        for name, power in relation.powers.items():
            if name == OPEN_PRESSURE:
                # The pressure is so many times the number below 1, which may be 0.
                found = [found[0] * kind.of(over or Fraction(1)), found[1] * number]
                continue
            made = (load.mean if name == MEAN else load.delivered)(kind, **{asked.name: number})
            side, exponent = power / first < 0, abs(power / first)
            found[side] = found[side] * (made if exponent == 1 else made ** kind.exponent(exponent))
        return found

    def apart(number: Any) -> Any:
        makes, has = sides(number)
        return makes - has

    def slope(at: arb) -> arb:
        return arb(apart(Jet(at, arb(1), arb(0))).slope)

    low, high = asked.low + (BEYOND if asked.low == 1 else -BEYOND), asked.high + BEYOND
    zeros = isolate(lambda at: arb(apart(at)), slope, low, high)
    # Where nothing is delivered any more nothing is done, and of both any multiple.
    zeros = [one for one in zeros if not any(part.contains(0) for part in sides(one.place())[1:])]
    if any(one.rising is None for one in zeros):
        raise ProblemError(
            f"whether one or two values of {option} do is not settled; alter what is given a little"
        )
    if not zeros:
        steps = (low + (high - low) * step / STEPS for step in range(1, STEPS))
        shares = [float(one / other) for one, other in (sides(arb(float(at))) for at in steps)]
        most = max(shares) < 1
        much, best = ("less, at most", max(shares)) if most else ("more, at least", min(shares))
        raise NoRootError(
            f"no {option} {asked.bounds['en']} does what is given: all make {much} {100 * best:.4g} % of it;"
            " check sizes and pressures"
        )
    return [Sought(option, asked.name, one.place, over) for one in zeros]
