"""The combined load of the rod, of pressure and masses together, over the cycle of an engine.

It counts positive as a thrust, which presses the rod, and negative as a pull; angles are half turns of the
first crank's φ. At a dead centre, where the pressure changes sides, both limits count. Pages have its
extremes, where they lie, and its reversal: a kernel takes the load of one end of the rod and returns a number
of its kind, None where there is none.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, cached_property, reduce
from itertools import groupby
from typing import NamedTuple

from flint import arb

from kurbel.drive.at import CrankForce
from kurbel.engine.cylinder import AnyTurn, cranks_of
from kurbel.engine.engine_quantities import Needs, engine_registry, row
from kurbel.engine.segments import At, Part, Segment, extreme_value, extremes, parts, segments
from kurbel.engine.turn import Turn
from kurbel.exact.certify import at_bits
from kurbel.exact.numerals import Label
from kurbel.exact.search import Jet, jet_of
from kurbel.kernel.circle import Numeric
from kurbel.kernel.steam import larger, smaller
from kurbel.page.quantity import Of, Quantity, Words, words

THRUST, PULL = SIGNS = (1, -1)
# Of a greatest load with fewer bits the sign is not said.
SIGN_BITS = 64
DEGREE_DECIMALS = 3
SPAN_DECIMALS = 2
# The forces of CRANK_FORCES that are the load at a place of the rod, and what pages call the places.
ENDS: Mapping[str, tuple[str, Words]] = {
    "slide": ("crosshead_load", words("Kreuzkopfzapfen|Crosshead pin")),
    "crosshead": ("rod_force", words("Stange am Kreuzkopf|Rod at the crosshead")),
    "crank": ("pin_rod_force", words("Stange an der Kurbel|Rod at the crank")),
}
SLIDE = words("am Kreuzkopfzapfen: längs der Führung|at the crosshead pin: along the slide")


class Span(NamedTuple):
    """Over how many half turns the load has a sign: 1, -1, or 0 where there is none."""

    sign: int
    length: Numeric


class AnyRodLoad(ABC):
    """The load at one end of the rod over a cycle, in balls or, of an indicator card, in floats."""

    @abstractmethod
    def greatest(self, sign: int) -> Numeric | None:
        """Return the greatest thrust or, as a positive number, pull in Q; None where there is none."""

    @abstractmethod
    def degrees(self, sign: int) -> Numeric | None:
        """Return where that is, as an angle φ, the first such place; None where there is none."""

    @property
    @abstractmethod
    def spans(self) -> Sequence[Span]:
        """The spans of the cycle between changes of the sign, in order."""

    def angle(self, sign: int) -> Numeric:
        """Return over how many half turns of the cycle the load is a thrust or a pull."""
        return sum((span.length for span in self.spans if span.sign == sign), self.spans[0].length * 0)

    def unbroken(self, sign: int) -> Numeric:
        """Return the same of the longest part of the cycle without another sign in it."""
        runs = [
            Span(key, sum(span.length for span in run))
            for key, run in groupby(self.spans, lambda span: span.sign)
        ]
        if len(runs) > 1 and runs[0].sign == runs[-1].sign:
            # The cycle goes on where it began.
            runs[0] = Span(runs[0].sign, runs[0].length + runs.pop().length)
        return reduce(larger, (run.length for run in runs if run.sign == sign), runs[0].length * 0)

    def reversal(self, unbroken: bool = False) -> Numeric:
        """Return over how many half turns the load has the sign that it has for less of the cycle."""
        return smaller(*map(self.unbroken if unbroken else self.angle, SIGNS))

    def reversed_share(self) -> Numeric:
        """Return the lesser of greatest thrust and greatest pull as a share of the other."""
        thrust, pull = map(self.greatest, SIGNS)
        if thrust is None or pull is None:
            return Fraction(0)
        return smaller(thrust, pull) / larger(thrust, pull)


class RodLoad(AnyRodLoad):
    """The load in balls, with all of its extremes and zeros."""

    def __init__(self, turn: Turn, force: CrankForce) -> None:
        self.turn, self.force = turn, force

    @cached_property
    def segments(self) -> list[Segment]:
        return segments(self.turn, [cranks_of(self.turn.engine)[0]], len(self.turn.cylinder.strokes))

    def quantity(self, segment: Segment, half_turns: arb) -> Jet:
        """Return the load with its slopes at a place of a segment."""
        crank = next(segment.cranks(half_turns))
        return jet_of(crank.cylinder.force(self.force, crank.stroke, crank.angle))

    @cached_property
    def _greatest(self) -> dict[int, Sequence[At]]:
        found = {sign: extremes(self.segments, self.quantity, sign) for sign in SIGNS}
        return {sign: places for sign, places in found.items() if self._is_loaded(places, sign)}

    def _is_loaded(self, places: Sequence[At], sign: int) -> bool:
        with at_bits(SIGN_BITS):
            return bool(sign * extreme_value(places, self.quantity, sign) > 0)

    def extreme(self, sign: int) -> At | None:
        """Return where thrust or pull is greatest, the first such place; None where there is none."""
        return self._greatest[sign][0] if sign in self._greatest else None

    def degrees(self, sign: int) -> arb | Fraction | None:
        found = self.extreme(sign)
        if found is None:
            return None
        return 180 * found.place.half_turns() if found.place.exact is None else 180 * found.place.exact

    def greatest(self, sign: int) -> arb | None:
        found = self._greatest.get(sign)
        return None if found is None else sign * extreme_value(found, self.quantity, sign)

    @cached_property
    def _parts(self) -> tuple[Part, ...]:
        return tuple(part for segment in self.segments for part in parts(segment, self.quantity))

    @property
    def spans(self) -> list[Span]:
        return [Span(part.sign, part.end.half_turns() - part.start.half_turns()) for part in self._parts]


def end_entry(end: str) -> Quantity:
    """Return the load at a place, which other drives name otherwise, by the name of the place."""
    force, name = ENDS[end]
    return engine_registry()[force]._replace(name=name, direction=SLIDE)


class _Sign(NamedTuple):
    sign: int
    key: str
    name: str
    symbol: Label


_SIGNS = (
    _Sign(THRUST, "thrust", "Druck|thrust", '$S_"max"$'),
    _Sign(PULL, "pull", "Zug|pull", '$-S_"min"$'),
)


def sign_of(quantity: Quantity) -> int:
    """Return the sign of the extreme that a quantity is of."""
    return next(one.sign for one in _SIGNS if one.key in quantity.key)


@cache
def rod_quantities() -> Mapping[str, Quantity]:
    """Return every quantity of the rod's load by its key."""
    return {one.key: one for one in (*_extremes(), *_spans())}


def _extremes() -> Iterator[Quantity]:
    for sign, key, name, symbol in _SIGNS:
        de, en = name.split("|")
        title = f"größter {de}|Greatest {en}"
        force = row(key, title, symbol, "$Q$", Of.FORCE, 4, lambda load, sign=sign: load.greatest(sign))
        yield force
        yield force._replace(
            key=f"{key}_n", unit=words("N"), decimals=1, heading=words(f"{symbol} in N"),
            scale=AnyTurn.force_unit, needs=(Needs.LOAD,),
        )  # fmt: skip
        yield row(
            f"phi_{key}", f"größter {de} bei|Greatest {en} at", "$φ$", "°", Of.PLACE, DEGREE_DECIMALS,
            lambda load, sign=sign: load.degrees(sign), minutes=True,
        )  # fmt: skip


def _spans() -> Iterator[Quantity]:
    for sign, key, name, _ in _SIGNS:
        de, en = name.split("|")
        yield row(
            f"{key}_angle", f"{de} über|{en[:1].upper()}{en[1:]} over", "", "°", Of.SPAN, SPAN_DECIMALS,
            lambda load, sign=sign: 180 * load.angle(sign),
        )  # fmt: skip
    yield row(
        "reversal_angle", "Richtungswechsel über|Reversal over", "", "°", Of.SPAN, SPAN_DECIMALS,
        lambda load: 180 * load.reversal(),
    )  # fmt: skip
    yield row(
        "reversal_unbroken", "davon am Stück|longest unbroken", "", "°", Of.SPAN, SPAN_DECIMALS,
        lambda load: 180 * load.reversal(unbroken=True),
    )  # fmt: skip
    yield row(
        "reversal_share", "Gegenlast, Anteil der größten|Reversed load, share of the greatest", "", "%",
        Of.SHARE, SPAN_DECIMALS, lambda load: 100 * load.reversed_share(),
    )  # fmt: skip
