"""Crank ratios and a layout become a table of the harmonics of the piston's motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf

from kurbel.balance.harmonics import Harmonic, certified, printed_orders, rational, registry, series
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.harmonics import Term
from kurbel.motion.evaluation import METHODS
from kurbel.page import axes as page_axes
from kurbel.page import words as page_words
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.layouts import Layout
from kurbel.page.old_axes import RatioAxis
from kurbel.page.sheet import Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import ratio_text

KEYS = ("order", "ratio", "value")
ORDERS = 6
# A note has so many terms of each series, and series up to this order.
TERMS = 3
LAST_SERIES = 6
# The powers of λ that the formulas of a method keep.
POWERS: Mapping[str, float] = {"exact": inf, "series": 1, "infinite": 0}
EXACT_ZERO = Number(0, 0)
"""A value that is 0 by proof is printed as 0, one that is only small as 0.0000."""
MOTIONS: Mapping[str, Label] = {"x": "x/R", "c": "c/v", "p": "(p R)/v^2"}
WORDS: Mapping[str, Mapping[str, str]] = {
    "x": {"de": "Harmonische des Kolbenweges", "en": "Harmonics of the piston path"},
    "c": {"de": "Harmonische der Kolbengeschwindigkeit", "en": "Harmonics of the piston velocity"},
    "p": {"de": "Harmonische der Kolbenbeschleunigung", "en": "Harmonics of the piston acceleration"},
    "order": {"de": "Ordnung", "en": "Order"},
    "series": {"de": "Mit $λ = {ratio}$: ", "en": "With $λ = {ratio}$: "},
    "odd": {
        "de": "Ungerade Ordnungen über 1 sind 0",
        "en": "Odd orders above 1 are 0",
    },
}


@dataclass(frozen=True, kw_only=True)
class HarmonicsRequest(Sheet):
    """What is asked for: the harmonics up to an order of the path (x), velocity (c) or acceleration (p).

    `quantity` empty leaves it to the layout. By the method of the infinite rod all ratios are 1:∞.
    """

    ratios: tuple[Fraction, ...]
    quantity: str = ""
    last_order: int = ORDERS
    method: str = "exact"

    def __post_init__(self) -> None:
        super().__post_init__()
        printed_orders(self.harmonic, self.last_order)
        object.__setattr__(self, "ratios", checked_ratios(self.ratios, self.method))

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.orders) * len(self.ratios)

    @property
    def harmonic(self) -> Harmonic:
        return registry()[choose(self.quantity or self.layout.columns[0].quantity, registry(), "quantity")]

    @property
    def orders(self) -> tuple[int, ...]:
        return printed_orders(self.harmonic, self.last_order)

    @property
    def decimals(self) -> int:
        own = self.layout.columns[0].decimals
        assert own is not None
        return own if self.digits is None else self.digits


def checked_ratios(ratios: tuple[Fraction, ...], method: str) -> tuple[Fraction, ...]:
    """Return the ratios by the method; raise a KurbelError for one that no crank may have."""
    if not ratios:
        raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
    for ratio in ratios:
        Crank(ratio)
    return (Fraction(0),) if choose(method, METHODS, "method") == "infinite" else ratios


def harmonic_name(harmonic: Harmonic, lang: str) -> str:
    return f"{WORDS[harmonic.key][lang]} {harmonic.symbol.strip('$').replace('_k', 'ₖ')}"


def build_harmonics(request: HarmonicsRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    lang = request.lang
    name = WORDS[request.harmonic.key][lang]
    text = caption(request.layout, lang, request.ratios, request.method).replace("{quantity}", name)
    records = records_of(len(request), KEYS, _fields(request), lambda: _records(request))
    return table_of(request, text, _grid(request) if pages else None, records, _notes(request))


def caption(layout: Layout, lang: str, ratios: Sequence[Fraction], method: str) -> Label:
    """Return the layout's caption with the ratio, if there is only one, and the method."""
    ratio = page_words.for_ratio(ratios[0], lang, layout.ratio_symbol)
    shown = ratio if len(ratios) == 1 and method != "infinite" else ""
    text = layout.caption[lang].replace("{method}", METHODS[method].caption[lang])
    return text.replace("{for_ratio}", shown)


class OrderAxis(Axis):
    """The orders of harmonics."""

    def __init__(self, layout: Layout, orders: Sequence[int], lang: str) -> None:
        super().__init__(len(orders))
        self.layout = layout
        self.orders = orders
        self.lang = lang

    def stub_heading(self) -> Label:
        return self.layout.stub_heading("order", f"{WORDS['order'][self.lang]} $k$", self.lang)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"$k = {self.orders[place['order']]}$",)

    def stub(self, place: Place) -> Number:
        return Number(self.orders[place["order"]], 0)


class _HeadedRatioAxis(RatioAxis):
    """Crank ratios below the symbol of the harmonic."""

    def __init__(self, request: HarmonicsRequest) -> None:
        super().__init__(request.layout, request.ratios, request.lang)
        self.symbol = request.harmonic.symbol

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"{self.symbol}, ${self.layout.ratio_symbol}$", *super().heads(place))


def harmonic_number(
    harmonic: Harmonic, order: int, crank: Crank, decimals: int, method: str, rounding: str
) -> Number:
    """Return the printed coefficient."""
    if rational(harmonic, order, crank, method) == 0:
        return EXACT_ZERO
    return certified(harmonic, order, crank, decimals, method, rounding)


def order_field(lang: str) -> Field:
    return Field("order", WORDS["order"][lang], "$k$", "", 0)


def ratio_field(layout: Layout, lang: str) -> Field:
    return Field("ratio", page_axes.RATIO[lang], f"${layout.ratio_symbol}$")


def _number(request: HarmonicsRequest, order: int, ratio: Fraction) -> Number:
    crank = Crank(ratio)
    return harmonic_number(request.harmonic, order, crank, request.decimals, request.method, request.rounding)


def _grid(request: HarmonicsRequest) -> Grid:
    layout, orders = request.layout, request.orders
    axes = {"order": OrderAxis(layout, orders, request.lang), "ratio": _HeadedRatioAxis(request)}
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        return Cell(_number(request, orders[place["order"]], request.ratios[place["ratio"]]))

    return Grid(axes, cell)


def _records(request: HarmonicsRequest) -> Iterator[Mapping[str, Value]]:
    """One for each ratio and order."""
    for ratio in request.ratios:
        for order in request.orders:
            number = _number(request, order, ratio)
            yield {"order": Number(order, 0), "ratio": f"${ratio_text(ratio)}$", "value": number}


def _fields(request: HarmonicsRequest) -> Mapping[str, Field]:
    harmonic, lang = request.harmonic, request.lang
    name = WORDS[harmonic.key][lang]
    value = Field("value", name, harmonic.symbol, harmonic.unit, request.decimals, request.method)
    return {"order": order_field(lang), "ratio": ratio_field(request.layout, lang), "value": value}


def _notes(request: HarmonicsRequest) -> Iterator[Label]:
    yield _sum_formula(request.harmonic, request.method)
    yield from series_notes(request.harmonic, request.orders, request.method, request.layout, request.lang)
    if request.last_order > 1:
        yield WORDS["odd"][request.lang]


def series_notes(
    harmonic: Harmonic, orders: Sequence[int], method: str, layout: Layout, lang: str
) -> Iterator[Label]:
    """Yield the note that gives the coefficients by powers of λ, if the rod is finite."""
    if method == "infinite":
        return
    formulas = (series_formula(harmonic, order, method) for order in orders if order <= LAST_SERIES)
    ratio = layout.ratio_symbol.replace(":", "/")
    yield WORDS["series"][lang].replace("{ratio}", ratio) + "; ".join(f"${one}$" for one in formulas if one)


def _sum_formula(harmonic: Harmonic, method: str) -> Label:
    """(p R)/v² = B_1 cos φ + B_2 cos 2 φ + B_4 cos 4 φ + ..."""
    orders = [order for order in printed_orders(harmonic, 4) if _terms(harmonic, order, method)]
    parts = [f"{_letter(harmonic, order)}{_wave(harmonic, order)}" for order in orders]
    more = ["…"] if method == "exact" else []
    return f"${MOTIONS[harmonic.key]} = {' + '.join(parts + more)}$"


def _wave(harmonic: Harmonic, order: int) -> str:
    if not order:
        return ""
    return f" {harmonic.wave} φ" if order == 1 else f" {harmonic.wave} {order} φ"


def _letter(harmonic: Harmonic, order: int) -> str:
    return harmonic.symbol.strip("$").replace("_k", f"_{order}")


def series_formula(harmonic: Harmonic, order: int, method: str = "exact") -> str:
    """Return the coefficient by powers of λ: B_2 = λ + λ^3/4 + (15 λ^5)/128 + …; nothing if it is 0."""
    terms = _terms(harmonic, order, method)
    if not terms:
        return ""
    parts = [_term(term) for term in terms[:TERMS]] + ["+ …"] * (len(terms) > TERMS)
    return f"{_letter(harmonic, order)} = {' '.join(parts).removeprefix('+ ')}"


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
