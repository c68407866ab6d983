"""The page of the greatest errors of the series over the turn, order by order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.exact.kind import floats, settled
from kurbel.exact.numerals import Label, Number, figures, nearest
from kurbel.kernel.series import terms_of, versine_term
from kurbel.motion.captions import drive_notes
from kurbel.motion.evaluation import NEEDS
from kurbel.motion.page import CrankQuestion
from kurbel.motion.series.errors import QUARTER, Greatest
from kurbel.page.axes import ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Formula, Quantity, entry, filled, for_ratio, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field

ORDERS = (1, 3, 5, 7, 9)
DEGREE_DECIMALS = 4
WORDS = {
    "order": words("Ordnung|Order"),
    "over": words(
        "größter Betrag des Unterschieds von genauem Wert und Reihe bis $λ^n$ über die ganze Umdrehung, auf"
        " beiden Hüben gleich; ebenso bei $180° - φ$, $180° + φ$ und $360° - φ$"
        "|greatest magnitude of exact value less series up to $λ^n$ over the whole turn, the same on both"
        " strokes; also at $180° - φ$, $180° + φ$ and $360° - φ$"
    ),
    "left": words(
        "Erstes weggelassenes Glied von $x/R$: {terms}, $λ = {ratio}$"
        "|First term of $x/R$ that is left out: {terms}, $λ = {ratio}$"
    ),
}


class Erring(NamedTuple):
    """What errs: its letter, name, share and unit, and the same in a unit of its own, with its scale."""

    letter: str
    name: str
    share: str
    of: str
    unit: str
    ending: str
    needs: str
    scale: Callable[[Crank, Any], Any]


ERRING = (
    Erring("x", "Kolbenweg|Piston path", "x/R", "R", "mm", "mm", "length", Crank.millimetres),
    Erring(
        "c", "Kolbengeschwindigkeit|Piston velocity", "c/v", "v", "m/s", "mps", "speed", Crank.pin_velocity
    ),
    Erring(
        "p", "Kolbenbeschleunigung|Piston acceleration", "(p R)/v^2", "v^2/R", "m/s²", "mps2", "speed",
        Crank.pin_acceleration,
    ),
)  # fmt: skip
_ERROR = ("{}: größter Fehler", "{}: greatest error")
_AT = ("{}: größter Fehler bei φ", "{}: greatest error at φ")


@cache
def error_columns() -> Mapping[str, Quantity]:
    """Return the greatest errors of path, velocity and acceleration, and where they are, by their keys."""
    return {one.key: one for erring in ERRING for one in _entries(erring)}


def _entries(one: Erring) -> Iterator[Quantity]:
    symbol, formulas, heads = f"${one.letter}$", {"exact": Formula(_of(one.letter))}, (words(one.name),)
    key, error = f"error_{one.letter}", _named(one, _ERROR)
    yield entry(key, error, symbol, f"${one.of}$", None, formulas, f"${one.share}$", spanners=heads)
    yield entry(
        f"{key}_{one.ending}", error, symbol, one.unit, None, formulas, spanners=heads, scale=one.scale,
        needs=one.needs,
    )  # fmt: skip
    where = {"exact": Formula(_where(one.letter))}
    yield entry(
        f"{key}_phi", _named(one, _AT), "$φ$", "°", DEGREE_DECIMALS, where, "bei $φ$|at $φ$", spanners=heads,
        minutes=True,
    )  # fmt: skip


def _named(one: Erring, said: tuple[str, str]) -> str:
    """Return what is said of it, "German|English"."""
    return "|".join(text.format(name) for text, name in zip(said, one.name.split("|"), strict=True))


def _of(letter: str) -> Callable[..., Any]:
    return lambda greatest, kind: greatest.value(letter, kind)


def _where(letter: str) -> Callable[..., Any]:
    """Return where an error is greatest: at 90° exactly, or a ball in degrees."""
    return lambda greatest: 180 * greatest.zero.place() if letter == "c" else QUARTER


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SeriesErrorsRequest(CrankQuestion):
    """What is asked for: the greatest errors of these orders, of straight cranks."""

    orders: tuple[int, ...] = ORDERS

    no_column = "there is no column beside the axes; add one, such as error_x"

    @cached_property
    def greatest(self) -> Callable[[int, int], Greatest]:
        """Find where the errors of a ratio and an order are greatest, each once."""
        return cache(lambda ratio, order: Greatest(self.ratios[ratio], self.orders[order]))


def _order_axis(question: SeriesErrorsRequest) -> ListAxis:
    name = WORDS["order"][question.lang]
    return OrderAxis(
        question.orders,
        Field("order", name, "$n$", "", 0),
        lambda order: Number(order, 0),
        lambda order: f"$n = {order}$",
        f"{name} $n$",
    )


class OrderAxis(ListAxis):
    """The highest powers of λ."""

    def stub(self, place: Place) -> Number:
        return Number(self._things[place["order"]], 0)


def _number(question: SeriesErrorsRequest, column: Column, place: Place, times: int) -> Number | None:
    crank, quantity = question.cranks[place["ratio"]], column.quantity
    greatest, rounding = question.greatest(place["ratio"], place["order"]), question.rounding
    if quantity.minutes:
        return _angle(greatest, column, times, rounding)
    if not crank.ratio:
        return Number(0, column.decimals or 0)
    kernel = quantity.formulas["exact"].kernel

    def value(kind: Any) -> Any:
        found = kernel(greatest, kind) * times
        return found * quantity.scale(crank, kind) if quantity.scale else found

    letter = quantity.key.split("_")[1]
    decimals = column.decimals
    if decimals is None:
        scale = float(quantity.scale(crank, floats())) if quantity.scale else 1.0
        decimals = figures(greatest.rough(letter) * scale * times)
    return Number(settled(value, decimals, rounding), decimals)


def _angle(greatest: Greatest, column: Column, times: int, rounding: str) -> Number | None:
    if not greatest.ratio:
        return None
    kernel = column.quantity.formulas["exact"].kernel
    if column.quantity.key != "error_c_phi":
        return nearest(kernel(greatest) * times, column.places, rounding)
    return Number(settled(lambda _: times * kernel(greatest), column.places, rounding), column.places)


def _caption(question: SeriesErrorsRequest) -> Label:
    ratios, lang = question.ratios, question.lang
    ratio = for_ratio(ratios[0], lang, question.layout.ratio_symbol) if len(ratios) == 1 else ""
    return question.layout.caption[lang].replace("{for_ratio}", ratio)


def _notes(question: SeriesErrorsRequest) -> Iterator[Label]:
    layout, lang = question.layout, question.lang
    yield from (note[lang] for note in layout.notes)
    yield WORDS["over"][lang]
    terms = ", ".join(f"$n = {order}$: ${_left_out(order)}$" for order in question.orders)
    parts = {"{terms}": terms, "{ratio}": layout.ratio_symbol.replace(":", "/")}
    yield filled(WORDS["left"][lang], parts.items())
    yield from drive_notes(question.cranks, lang)


def _left_out(order: int) -> str:
    """1/8 λ³ sin⁴ φ"""
    term = terms_of(order) + 1
    above, below = versine_term(term)
    return f"{above}/{below} λ^({2 * term - 1}) sin^({2 * term}) φ"


SUBJECT = Subject(
    key="series errors",
    layout="series-errors",
    command="table --layout series-errors",
    axes={"ratio": RatioAxis, "order": _order_axis, "column": ColumnAxis},
    axis_keys=("ratio", "order"),
    own_first=False,
    quantities=error_columns,
    number=_number,
    caption=_caption,
    notes=_notes,
    options=NEEDS,
)
