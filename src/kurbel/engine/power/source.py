"""What the mean pressure of a cylinder comes from: what acts on its piston, or that it is given.

A compound engine: the high-pressure cylinder before that in which the mean pressure counts.

Steam expands by Mariotte's law, without clearance, and without a fall of pressure between the cylinders. So
both do the work of the whole expansion ε in the low-pressure cylinder, p V₁ (1 + ln ε - b ε); the
high-pressure one has ln R of the bracket, for it expands R times and gives the steam away at p/R. Derived by
us; the strokes of both are alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

from flint import arb

from kurbel.drive.load import CARD, STEAM
from kurbel.engine.cylinder import TurnPlace
from kurbel.engine.digits import CellValue, Estimate, check_card, estimate
from kurbel.engine.engine import Engine
from kurbel.engine.engine_quantities import engine_registry
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.turn import turn_of
from kurbel.engine.work import ends, mean_pressure_of
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import figures, nearest
from kurbel.exact.place import fraction
from kurbel.exact.real import Product, Term, number
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.steam import logarithm
from kurbel.page.quantity import bare
from kurbel.reading.given import allowed_name, as_length, as_number, as_pressure
from kurbel.reading.notation import about

MOST_STROKES = 24
NEAR_BITS = 120
# What heads a column, so that all have as many decimals.
HEADS, DECIMALS = ("cut_off", "ratio"), 4


class SoughtLoadNumber(NamedTuple):
    """A number of a load that was asked for, by the name that the load has for it, and the option that has
    it; `place` encloses it at the precision in force. Of the steam pressure the number is the share that the
    back pressure in Pa, `over` it, is of that."""

    option: str
    name: str
    place: Callable[[], arb]
    over: Fraction | None = None

    @property
    def near(self) -> Fraction:
        """What the option is of the number, to as many figures as pages print, or decimals over a column."""
        with at_bits(NEAR_BITS):
            value = fraction(self.place().mid())
        value = (self.over or 1) / value if self.over or self.name == "cut_off" else value
        shown = nearest(value, DECIMALS if self.name in HEADS else figures(float(value)))
        return Fraction(shown.scaled, 10**shown.decimals)

    def number(self, kind: Kind) -> Numeric:
        """Return it on a kind of number."""
        return kind.enclosed(self.place)

    def on(self, kind: Kind) -> dict[str, Numeric]:
        """Return the same by its name."""
        return {self.name: self.number(kind)}


@dataclass(frozen=True)
class GivenPressure:
    """A mean pressure that is given, in so many working strokes of a cylinder in a turn."""

    name: ClassVar[str] = "mean pressure"
    driven: ClassVar[bool] = False
    carded: ClassVar[bool] = False

    sought: ClassVar[None] = None
    # That which is given.
    pressure: ClassVar[Fraction | None] = None

    strokes: Fraction

    def __post_init__(self) -> None:
        if not 0 < self.strokes <= MOST_STROKES:
            raise ProblemError(
                f"the working strokes of a turn are {about(self.strokes)}; they must be above 0 and at most"
                f" {MOST_STROKES}: 2 of a double-acting cylinder, 1/2 of one in four strokes"
            )

    @property
    def mean(self) -> Product:
        """The mean pressure in units of itself."""
        return Product.of(1)


@dataclass(frozen=True)
class ActingPressure:
    """What acts on the piston of an engine: its mean pressure counts in the pressure that Q is of. A number
    of it that is `sought` is near to that of the load of the engine."""

    engine: Engine
    sought: SoughtLoadNumber | None = None

    @property
    def load(self) -> Any:
        return self.engine.steam

    @property
    def name(self) -> str:
        return str(self.load.name)

    @property
    def carded(self) -> bool:
        return self.name == CARD

    @cached_property
    def driven(self) -> bool:
        """Whether the shaft drives the piston; of a card its work says so."""
        return self._turn.mean_sign < 0 if self.carded else bool(self.load.driven)

    @property
    def pressure(self) -> Fraction | None:
        """The pressure in Pa that Q is of, where the load has one of its own."""
        return Fraction(self.load.pressure) if self.carded else None

    @property
    def strokes(self) -> Fraction:
        """The working strokes of a cylinder in a turn."""
        return ends(self.engine)

    @property
    def steamed(self) -> bool:
        return self.name == STEAM

    @cached_property
    def mean(self) -> Product:
        """The mean pressure of an end that works, in units of the pressure that Q is of."""
        return Product.about(self._mean)

    def _mean(self, kind: Kind) -> Numeric:
        if self.carded:
            return kind.of(Fraction(float(self._estimate.value)))
        if self.sought is not None or getattr(self.load, "stages", 1) > 1:
            own: Numeric = self.load.mean(kind, **self.found(kind))
            return own
        mean = mean_pressure_of(self.engine, kind)
        return -mean if self.driven else mean

    @cached_property
    def steam_taken(self) -> Product:
        """The volume at admission of the steam that a stroke takes, as a share of the swept one.

        1/ε + κ - (1 - c + κ) (p_b/p)^(1/n): up to the cut-off steam fills the clearance as well, which still
        keeps what the exhaust left at the share c of the return stroke, by the law of the expansion. Derived
        by us.
        """
        steam = self.load
        if not steam.clearance and steam.plain and self.sought is None:
            return Product.of(1 / steam.expansion)
        return Product.about(self._steam_taken)

    def _steam_taken(self, kind: Kind) -> Numeric:
        steam = self.load.numbers(kind.of, kind.exponent)
        if self.sought is not None:
            steam = steam._replace(**self.sought.on(kind))
        taken: Numeric = steam.cut_off + steam.clearance - self.load.kept(steam, kind)
        return taken

    @cached_property
    def delivered(self) -> Product:
        """The volume that a stroke delivers, in the state of suction, as a share of the swept one."""
        return self.of_load("delivered")

    def of_load(self, name: str) -> Product:
        """Return what the load knows by a name, a number above 0."""
        return Product.about(lambda kind: getattr(self.load, name)(kind, **self.found(kind)))

    def found(self, kind: Kind) -> dict[str, Numeric]:
        """Return the number that was sought by its name, on a kind of number."""
        return {} if self.sought is None else self.sought.on(kind)

    def apart(self, value: Product) -> float:
        """Return how far a value may be off, as a share of it, for the points of a card tell no more."""
        powers = [power for one, power in value.enclosed if one is self.mean.enclosed[0][0]]
        if not self.carded or not powers:
            return 0.0
        # Of (1 + e)^k, but for k = 1, no more than twice k e is lost, for a card with a figure to it.
        times = 1.0 if powers[0] == 1 else 2 * abs(float(powers[0]))
        return times * self._estimate.error / abs(float(self._estimate.value))

    @cached_property
    def _estimate(self) -> Estimate:
        """The mean pressure of an indicator card, and how far it may be off."""
        quantity = engine_registry()["mean_pressure"]
        return estimate(CellValue(bare(quantity, "exact", None), (self._turn,), TurnPlace()))

    @cached_property
    def _turn(self) -> Any:
        turn = turn_of(self.engine, "exact")
        if self.carded:
            check_card(turn, "half-away")
        return turn


HALF = Fraction(1, 2)
# By what the high-pressure cylinder is known: equal works, equal loads on the pistons where their strokes
# begin, its bore, the pressure in the receiver, its own expansion.
WORK, LOAD, BORE, RECEIVER, EXPANSION = "work", "load", "bore", "receiver", "expansion"


class Compound(NamedTuple):
    """How the high-pressure cylinder is known, and the value in SI units."""

    way: str
    value: Fraction = Fraction(1)

    def check(self, steam: Steam) -> None:
        """Raise ProblemError for steam of which the works are not computed."""
        if steam.exponent != 1 or steam.clearance or not steam.plain:
            raise ProblemError(
                "--compound is of the hypothetical diagram, by Mariotte's law without clearance; leave"
                " --exponent, --clearance, --release, --cushion and --lead out"
            )

    def expansion(self, acting: ActingPressure, pressure: Term, bore: Term) -> Term:
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
        return Term(Product.about(lambda kind: kind.enclosed(lambda: _by_work(acting))))


def whole(acting: ActingPressure) -> Product:
    """Return the whole expansion ε."""
    if acting.sought is None:
        return Product.of(acting.load.expansion)
    return Product.about(lambda kind: _numbers(acting, kind)[0])


def work_of(compound: Compound | None, acting: ActingPressure, expansion: Term, high: bool) -> Term:
    """Return the share of a cylinder in the work, the high-pressure one or the other."""
    if compound is not None and compound.way == WORK:
        return number(HALF)

    def part(kind: Kind) -> Numeric:
        epsilon, lost = _numbers(acting, kind)
        found = logarithm(expansion.known.on(kind)) / (1 + logarithm(epsilon) - lost)
        return found if high else 1 - found

    return Term(Product.about(part), expansion.powers)


def _numbers(acting: ActingPressure, kind: Kind) -> tuple[Numeric, Numeric]:
    """Return ε and b ε on a kind of number."""
    steam = acting.load.numbers(kind.of, kind.exponent)._replace(**acting.found(kind))
    back = steam.cut_off if acting.load.back is None else steam.back
    return 1 / steam.cut_off, back / steam.cut_off


def _by_work(acting: ActingPressure) -> arb:
    """Return R of equal works: ln R = 1 + ln(ε/R) - b ε."""
    epsilon, lost = map(ball, _numbers(acting, balls()))
    return epsilon.sqrt() * ((1 - lost) / 2).exp()


def _by_load(epsilon: Numeric, lost: Numeric) -> Numeric:
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
