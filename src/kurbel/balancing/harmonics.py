"""Harmonics of the piston's path (A_k), velocity (C_k) and acceleration (B_k): certified, and their page.

The sums are x = Σ A_k cos kφ, c = Σ C_k sin kφ, p = Σ B_k cos kφ of the straight crank; see
kernel/harmonics.py.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
from math import inf
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.exact.real import Real
from kurbel.kernel import harmonics
from kurbel.kernel.circle import Numeric
from kurbel.kernel.harmonics import Term
from kurbel.motion.evaluation import METHODS
from kurbel.page.axes import Place, RatioAxis, UnletteredAxis
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Formula, Quantity, entry, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.given import choose

MOST_ORDERS = 100


class Harmonic(NamedTuple):
    """The harmonics of a motion, the path's after so many slopes; `wave` is cos or sin."""

    key: str
    letter: str
    slopes: int
    wave: str = "cos"

    def factor(self, order: int) -> int:
        """Return C_k/A_k or B_k/A_k."""
        return harmonics.slope_factor(order, self.slopes)

    def value(self, order: int, ratio: Numeric) -> Numeric:
        """Return the coefficient of the exact motion for λ, a float, an array or a ball (not around 0)."""
        # -k times 0.0 is -0.0, and 0 more is not.
        return 0 + self.factor(order) * harmonics.path_coefficient(order, ratio)


HARMONICS: Mapping[str, Harmonic] = {
    "x": Harmonic("x", "A", 0),
    "c": Harmonic("c", "C", 1, "sin"),
    "p": Harmonic("p", "B", 2),
}
"""The harmonics by the key of the quantity that they add up to."""


def series(harmonic: Harmonic, order: int, terms: int) -> tuple[Term, ...]:
    """Return the first terms of the coefficient by powers of λ, exact: B_2 = λ + λ³/4 + 15 λ⁵/128 + ...

    Fewer where there are no more; none of an odd order above 1.
    """
    factor = harmonic.factor(order)
    shares = harmonics.path_series(order, terms) if factor else ()
    return tuple(Term(power, factor * coefficient) for power, coefficient in shares)


def rational(harmonic: Harmonic, order: int, crank: Crank, method: str = "exact") -> Fraction | None:
    """Return the coefficient if it is a rational number, else None.

    By the first-order formulas (`series`) every one is; by the exact ones those that are the same for all
    rods, and all of an infinite rod.
    """
    if method == "exact" and crank.ratio and harmonic.factor(order) and order % 2 == 0:
        return None
    ratio = Fraction(0) if method == "infinite" else crank.ratio
    terms = series(harmonic, order, 2)
    return sum((one.coefficient * ratio**one.power for one in terms if one.power <= 1), Fraction(0))


def real(harmonic: Harmonic, order: int, crank: Crank, method: str = "exact") -> Real:
    """Return the coefficient in its unit.

    No value lies on a rounding boundary, other than those of `rational`: for 0 < λ < 1 the rest are
    transcendental. π A_2m is a K(λ) + b E(λ) with rational a and b: for m = 1 by its integral, then by the
    recurrence (2m + 3) A_2m+2 + (2m - 3) A_2m-2 = 4m (1 - 2/λ²) A_2m, in which -4 E(λ)/πλ stands for A_0;
    A_0 itself is 1 + (1 - 2 E(λ)/π)/λ. K is half a period of an elliptic curve with rational invariants, E
    a sum of rational multiples of a period and a quasi-period; with π they are linearly independent over the
    algebraic numbers, be there complex multiplication or not (Masser, Elliptic Functions and Transcendence,
    1975, chapters II and III). An algebraic A_2m would relate them unless a = b = 0, but the terms of its
    power series have one sign.
    """
    check_straight(crank)
    exact = rational(harmonic, order, crank, method)
    if exact is not None:
        return Real.of(exact)
    return Real.transcendental(lambda kind: harmonic.value(order, kind.of(crank.ratio)))


def certified(
    harmonic: Harmonic,
    order: int,
    crank: Crank,
    decimals: int,
    method: str = "exact",
    rounding: str = "half-away",
) -> Number:
    """Return the coefficient, correctly rounded to so many decimals."""
    return real(harmonic, order, crank, method).number(decimals, rounding)


def printed_orders(harmonic: Harmonic, last: int) -> tuple[int, ...]:
    """Return the orders up to the last but those that are 0 for all rods: 0 of the path, then 1, 2, 4, ..."""
    orders = (0, 1, *range(2, last + 1, 2))
    return tuple(order for order in orders if harmonic.factor(order))


def check_straight(crank: Crank) -> None:
    """Raise ProblemError if the crank is offset."""
    if crank.offset:
        raise ProblemError(
            "the crank is offset; harmonics are known for the straight crank, without --offset"
        )


DECIMALS = 6
# A note has so many terms of each series, and series up to this order.
TERMS = 3
LAST_SERIES = 6
# The powers of λ that the formulas of a method keep.
POWERS: Mapping[str, float] = {"exact": inf, "series": 1, "infinite": 0}
ORDER = words("Ordnung|Order")
SERIES = words("Mit $λ = {ratio}$: |With $λ = {ratio}$: ")
ODD = words("Ungerade Ordnungen über 1 sind 0|Odd orders above 1 are 0")


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the coefficients by the key of the quantity that they add up to, which stands before the sum."""
    rows = (
        ("x", "Harmonische des Kolbenweges|Harmonics of the piston path", "$R$", "x/R"),
        ("c", "Harmonische der Kolbengeschwindigkeit|Harmonics of the piston velocity", "$v$", "c/v"),
        (
            "p", "Harmonische der Kolbenbeschleunigung|Harmonics of the piston acceleration",
            "$v^2/R$", "(p R)/v^2",
        ),
    )  # fmt: skip
    found = {}
    for key, name, unit, printed in rows:
        letter, formulas = f"${HARMONICS[key].letter}_k$", {"exact": Formula(HARMONICS[key].value, printed)}
        found[key] = entry(key, name, letter, unit, DECIMALS, formulas, letter)
    return found


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class OrdersRequest(Question):
    """A question about the harmonics up to an order, of one of the quantities that they add up to.

    By the method of the infinite rod all ratios are 1:∞.
    """

    ratios: tuple[Fraction, ...]
    last_order: int
    method: str

    def check(self) -> None:
        object.__setattr__(self, "ratios", _checked_ratios(self.ratios, self.method))

    @property
    def harmonic(self) -> Harmonic:
        return HARMONICS["p"]

    @property
    def orders(self) -> tuple[int, ...]:
        return printed_orders(self.harmonic, self.last_order)

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method,)

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        return {**super().caption_parts, "{method}": METHODS[self.method].caption[self.lang]}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class HarmonicsRequest(OrdersRequest):
    """What is asked for: the harmonics of the path (x), velocity (c) or acceleration (p).

    `quantity` empty leaves it to the layout.
    """

    quantity: str = ""

    @property
    def harmonic(self) -> Harmonic:
        return HARMONICS[choose(self.quantity or self.layout.columns[0].quantity, HARMONICS, "quantity")]

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        return (self.column(replace(self.layout.columns[0], quantity=self.harmonic.key)),)

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        return {**super().caption_parts, "{quantity}": self.page_columns[0].quantity.name[self.lang]}


def _checked_ratios(ratios: tuple[Fraction, ...], method: str) -> tuple[Fraction, ...]:
    """Return the ratios by the method; raise a KurbelError for one that no crank may have."""
    if not ratios:
        raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
    for ratio in ratios:
        Crank(ratio)
    return (Fraction(0),) if choose(method, METHODS, "method") == "infinite" else ratios


class OrderAxis(UnletteredAxis):
    """The orders of harmonics."""

    def __init__(self, question: Any) -> None:
        name = ORDER[question.lang]
        super().__init__(
            question.orders,
            Field("order", name, "$k$", "", 0),
            lambda order: Number(order, 0),
            lambda order: f"$k = {order}$",
            f"{name} $k$",
        )


class _HeadedRatioAxis(RatioAxis):
    """Crank ratios below the symbol of the harmonic."""

    def __init__(self, question: HarmonicsRequest) -> None:
        super().__init__(question)
        self.symbol: Label = question.page_columns[0].quantity.symbol

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"{self.symbol}, ${self.layout.ratio_symbol}$", *super().heads(place))


def _number(question: HarmonicsRequest, column: Column, place: Place, times: int) -> Number:
    order, crank = question.orders[place["order"]], Crank(question.ratios[place["ratio"]])
    return certified(question.harmonic, order, crank, column.places, question.method, question.rounding)


def _notes(question: HarmonicsRequest) -> Iterator[Label]:
    yield _sum_formula(question.harmonic, question.method)
    yield from series_notes(question)
    if question.last_order > 1:
        yield ODD[question.lang]


def series_notes(question: OrdersRequest) -> Iterator[Label]:
    """Yield the note that gives the coefficients by powers of λ, if the rod is finite."""
    if question.method == "infinite":
        return
    orders = (order for order in question.orders if order <= LAST_SERIES)
    formulas = (series_formula(question.harmonic, order, question.method) for order in orders)
    ratio = question.layout.ratio_symbol.replace(":", "/")
    yield SERIES[question.lang].replace("{ratio}", ratio) + "; ".join(f"${one}$" for one in formulas if one)


def _sum_formula(harmonic: Harmonic, method: str) -> Label:
    """(p R)/v² = B_1 cos φ + B_2 cos 2 φ + B_4 cos 4 φ + ..."""
    orders = [order for order in printed_orders(harmonic, 4) if _terms(harmonic, order, method)]
    parts = [f"{harmonic.letter}_{order}{_wave(harmonic, order)}" for order in orders]
    more = ["…"] if method == "exact" else []
    return f"${quantities()[harmonic.key].formulas['exact'].printed} = {' + '.join(parts + more)}$"


def _wave(harmonic: Harmonic, order: int) -> str:
    if not order:
        return ""
    return f" {harmonic.wave} φ" if order == 1 else f" {harmonic.wave} {order} φ"


def series_formula(harmonic: Harmonic, order: int, method: str = "exact") -> str:
    """Return the coefficient by powers of λ: B_2 = λ + λ^3/4 + (15 λ^5)/128 + …; nothing if it is 0."""
    terms = _terms(harmonic, order, method)
    if not terms:
        return ""
    parts = [_term(term) for term in terms[:TERMS]] + ["+ …"] * (len(terms) > TERMS)
    return f"{harmonic.letter}_{order} = {' '.join(parts).removeprefix('+ ')}"


def _terms(harmonic: Harmonic, order: int, method: str) -> list[Term]:
    return [term for term in series(harmonic, order, TERMS + 1) if term.power <= POWERS[method]]


def _term(term: Term) -> str:
    top, bottom = abs(term.coefficient.numerator), term.coefficient.denominator
    power = f"λ^{term.power}" if term.power > 1 else "λ" * term.power
    number = "" if top == 1 and power else str(top)
    product = " ".join(filter(None, (number, power)))
    if bottom > 1:
        product = f"({product})/{bottom}" if " " in product else f"{product}/{bottom}"
    return f"{'-' if term.coefficient < 0 else '+'} {product}"


def _listed() -> Iterator[tuple[str, Quantity]]:
    for key, one in quantities().items():
        yield f"harmonics --quantity {key}", one._replace(key="value")


SUBJECT = Subject(
    key="harmonics",
    layout="harmonics",
    command="harmonics",
    axes={"ratio": _HeadedRatioAxis, "order": OrderAxis},
    axis_keys=("order", "ratio"),
    quantities=quantities,
    listed=_listed,
    letters=True,
    number=_number,
    notes=_notes,
)
