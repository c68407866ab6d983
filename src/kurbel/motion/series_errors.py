"""The greatest errors of the series over the turn, order by order, enclosed with proof, and their page.

Of order n the error of x is the sum of all terms that are left out, each a positive coefficient a_k times
λ^(2k-1) sin^(2k) φ with 2k - 1 > n. It grows with u = sin² φ and is greatest at 90°.

The error of p is the sum of b_k λ^(2k-1) u^(k-1) (2k - 1 - 2k u) with b_k = 2k a_k. No term exceeds its
magnitude at 90°, where u is 1 and the bracket -1: the greatest other one, at u = (1 - 1/k)(1 - 1/2k), is
u^(k-1) (2k - 1)/k in their place, for k >= 2 at most 3/4. So p, too, errs most at 90°.

By powers of u the first coefficient of that sum is positive and all others are negative, for that of u^k is a
multiple of (2k + 1) b_(k+1) λ² - 2k b_k, and b_(k+1) is b_k (2k - 1)/2k. Hence the error of p has one zero
between 0° and 90°, from positive to negative, and there that of c, whose slope it is, is greatest.

All three have the same magnitude at 180° - φ, 180° + φ and 360° - φ, and on the return stroke. Re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple

from kurbel.exact.certify import at_bits, ball, half_turn_circle
from kurbel.exact.kind import Kind, balls, floats, settled
from kurbel.exact.numerals import Label, Number, figures, nearest
from kurbel.exact.search import Zero, ball_jets, slopes
from kurbel.kernel import kinematics, series
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.series import terms_of, versine_term
from kurbel.motion.entries import in_units
from kurbel.motion.motion_page import CrankQuestion
from kurbel.motion.notes import drive_notes
from kurbel.page.axes import ColumnAxis, Place, RatioAxis, UnletteredAxis
from kurbel.page.quantity import Column, Formula, Quantity, Texts, entry, filled, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field

QUARTER = Fraction(90)
# The exact formula and that of an order, by their quantities.
FORMULAS: Mapping[str, tuple[Callable[..., Numeric], Callable[..., Numeric]]] = {
    "x": (kinematics.piston_path, series.piston_path),
    "c": (kinematics.piston_velocity, series.piston_velocity),
    "p": (kinematics.piston_acceleration, series.piston_acceleration),
}
# A rough value is known to so many bits, and found with at most so many.
ROUGH_BITS, MOST_ROUGH_BITS = 40, 1 << 16


@dataclass(frozen=True)
class Greatest:
    """The greatest errors of one order, of a finite rod."""

    ratio: Fraction
    order: int

    def value(self, key: str, kind: Kind) -> Numeric:
        """Return the greatest |series - exact| of x, c or p in units of R, v, v²/R; of c on balls alone."""
        circle = half_turn_circle(self.zero.place()) if key == "c" else kind.circle(QUARTER)
        error = self._error(key, circle, kind)
        # The series of p is above at 90°, those of x and c are below.
        return -error if key == "p" else error

    @cached_property
    def zero(self) -> Zero:
        """Where the velocity errs most, in half turns."""
        slope, _ = slopes(lambda half_turns: self._error("p", ball_jets(half_turns), balls()))
        return Zero(
            lambda half_turns: ball(self._error("p", half_turn_circle(half_turns), balls())),
            slope,
            Fraction(0),
            Fraction(1, 2),
            rising=False,
        )

    def rough(self, key: str) -> float:
        """Return the value as a float, however small it is."""
        bits = 2 * ROUGH_BITS
        while bits < MOST_ROUGH_BITS:
            with at_bits(bits):
                found = ball(self.value(key, balls()))
                if found.rel_accuracy_bits() >= ROUGH_BITS:
                    break
            bits *= 2
        return float(found.mid())

    def _error(self, key: str, circle: Circle[Any], kind: Kind) -> Numeric:
        exact, series = FORMULAS[key]
        ratio = kind.of(self.ratio)
        return exact(circle, ratio) - series(circle, ratio, self.order)


ORDERS = (1, 3, 5, 7, 9)
DEGREE_DECIMALS = 4
WORDS = Texts("motion", "series_errors")


class ErringQuantity(NamedTuple):
    """What errs: its letter, name and unit."""

    letter: str
    name: str
    unit: str


ERRING = (
    ErringQuantity("x", "Kolbenweg|Piston path", "R"),
    ErringQuantity("c", "Kolbengeschwindigkeit|Piston velocity", "v"),
    ErringQuantity("p", "Kolbenbeschleunigung|Piston acceleration", "v²/R"),
)
_ERROR = ("{}: größter Fehler", "{}: greatest error")
_AT = ("{}: größter Fehler bei φ", "{}: greatest error at φ")


@cache
def error_columns() -> Mapping[str, Quantity]:
    """Return the greatest errors of path, velocity and acceleration, and where they are, by their keys."""
    return {one.key: one for erring in ERRING for one in _entries(erring)}


def _entries(one: ErringQuantity) -> Iterator[Quantity]:
    formulas, heads = {"exact": Formula(_of(one.letter))}, (words(one.name),)
    key, error = f"error_{one.letter}", _named(one, _ERROR)
    for own in in_units(key, error, one.letter, one.unit, formulas):
        yield own._replace(decimals=None, spanners=heads)
    where = {"exact": Formula(_where(one.letter))}
    yield entry(
        f"{key}_phi", _named(one, _AT), "$φ$", "°", DEGREE_DECIMALS, where, "bei $φ$|at $φ$", spanners=heads,
        minutes=True,
    )  # fmt: skip


def _named(one: ErringQuantity, said: tuple[str, str]) -> str:
    """Return what is said of it, "German|English"."""
    return "|".join(text.format(name) for text, name in zip(said, one.name.split("|"), strict=True))


def _of(letter: str) -> Callable[..., Numeric]:
    return lambda greatest, kind: greatest.value(letter, kind)


def _where(letter: str) -> Callable[..., Numeric]:
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


def _order_axis(question: SeriesErrorsRequest) -> UnletteredAxis:
    """The highest powers of λ."""
    name = WORDS["order"][question.lang]
    return UnletteredAxis(
        question.orders,
        Field("order", name, "$n$", "", 0),
        lambda order: Number(order, 0),
        lambda order: f"$n = {order}$",
        f"{name} $n$",
    )


def _number(question: SeriesErrorsRequest, column: Column, place: Place, times: int) -> Number | None:
    crank, quantity = question.cranks[place["ratio"]], column.quantity
    greatest, rounding = question.greatest(place["ratio"], place["order"]), question.rounding
    if quantity.minutes:
        return _angle(greatest, column, times, rounding)
    if not crank.ratio:
        return Number(0, column.decimals or 0)
    kernel = quantity.formulas["exact"].kernel

    def value(kind: Kind) -> Numeric:
        found: Numeric = kernel(greatest, kind) * times
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


def _notes(question: SeriesErrorsRequest) -> Iterator[Label]:
    layout, lang = question.layout, question.lang
    yield WORDS["over"][lang]
    terms = ", ".join(f"$n = {order}$: ${_left_out(order)}$" for order in question.orders)
    parts = {"{terms}": terms, "{ratio}": layout.ratio_symbol.replace(":", "/")}
    yield filled(WORDS["left"][lang], parts.items())
    yield from drive_notes(question.cranks, lang)


def _left_out(order: int) -> str:
    """Return the first term that a series leaves out, such as 1/8 λ³ sin⁴ φ."""
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
    notes=_notes,
)
