"""The page of Rötscher's GF, each step a column, and how many steps it takes until the digits stand.

How many of Rötscher's steps it takes until the printed digits of GF stand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import floor

from kurbel.drive.at import At
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls, settled
from kurbel.exact.numerals import Label, Number
from kurbel.exact.terms import vanishes
from kurbel.kernel import kinematics, series
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.motion_page import MOTION, Digits, Request
from kurbel.motion.notes import drive_notes
from kurbel.page.axes import Place
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Formula, Quantity, Texts, entry, filled
from kurbel.page.subject import Subject

# Of a first guess, which exact digits put right, and so many of them are sure.
_BITS, _SURE_BITS = 128, 40


def steps_to(crank: Crank, angle: Fraction, decimals: int, rounding: str) -> int | None:
    """Return after how many steps GF in units of R has the digits of the exact value, and keeps them.

    None where it never has: the exact value lies half-way between two printed ones and is rounded up, and
    all steps lie below it. As the steps rise, digits that are reached stay.
    """
    wanted = settled(lambda kind: kinematics.rod_versine(*_at(crank, angle, kind)), decimals, rounding)
    lowest = Fraction(2 * wanted - 1, 2 * 10**decimals)
    if wanted == 0:
        return 0
    if _is_exactly(crank, angle, lowest):
        return None

    def stands(steps: int) -> bool:
        found = settled(lambda kind: series.closed(*_at(crank, angle, kind), steps), decimals, rounding)
        return found == wanted

    steps = _guess(crank, angle, lowest)
    while not stands(steps):
        steps += 1
    return steps


def _at(crank: Crank, angle: Fraction, kind: Kind) -> tuple[Circle[Numeric], Numeric]:
    return kind.circle(angle), kind.of(crank.ratio)


def _is_exactly(crank: Crank, angle: Fraction, value: Fraction) -> bool:
    """Whether GF is exactly a number, proved by the separation bound."""

    def difference(kind: Kind) -> Numeric:
        return kinematics.rod_versine(*_at(crank, angle, kind)) - kind.of(value)

    return vanishes(difference)


def _guess(crank: Crank, angle: Fraction, lowest: Fraction) -> int:
    """Return how many steps reach a number below GF, or one too few: (GF - g)/(2 L - GF - g) is q^(k+1)."""
    precision = _BITS
    while True:
        with at_bits(precision):
            kind = balls()
            circle, ratio = _at(crank, angle, kind)
            whole, share = kinematics.rod_versine(circle, ratio), ball(series.shrinking(circle, ratio))
            left = ball((whole - kind.of(lowest)) / (whole / share - kind.of(lowest)))
            if left.rel_accuracy_bits() > _SURE_BITS:
                return max(1, floor(float((left.log() / share.log()).mid())) - 1)
        precision *= 2


MOST_STEPS = 9
DECIMALS = 6
EXACT, COUNT = "gf", "gf_steps"
FORMULA = "$overline(G F)_(k+1) = overline(C F)^2/(2 L - overline(G F)_k)$"
WORDS = Texts("motion", "chord")
_NAME = "GF nach Schritt {0}|GF after step {0}"


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the steps, the exact length and the number of steps, by their keys."""
    each = range(1, MOST_STEPS + 1)
    found = [_length(f"gf_{k}", _NAME.format(k), f"$overline(G F)_{k}$", _after(k)) for k in each]
    found.append(_length(EXACT, "GF, genau|GF, exact", "$overline(G F)$", _exactly))
    steps, head = (
        "Schritte, bis die Stellen von GF stehen|Steps until the places of GF stand",
        "Schritte|Steps",
    )
    found.append(entry(COUNT, steps, "", "", 0, {"exact": Formula(_nothing)}, head))
    return {one.key: one for one in found}


def _length(key: str, name: str, symbol: Label, kernel: Callable[[At], Numeric]) -> Quantity:
    head = f"{symbol[:-1]}/R$"
    return entry(key, name, symbol, "$R$", DECIMALS, {"exact": Formula(kernel)}, head)


def _after(steps: int) -> Callable[[At], Numeric]:
    return lambda at: series.after(at.circle, at.ratio, steps)


def _exactly(at: At) -> Numeric:
    return kinematics.rod_versine(at.circle, at.ratio)


def _nothing(at: At) -> Numeric:
    # Sweeps then take the digits of the page.
    raise ProblemError(f"column {COUNT} counts steps to decimals, which floats have not")


class ChordRequest(Request):
    """What is asked for of the steps to GF, of straight cranks at crank angles."""

    no_column = "--columns names no quantity; add one, for example --columns phi,gf_1,gf_2,gf"

    @property
    def counted_places(self) -> int:
        """The decimals whose steps are counted."""
        return DECIMALS if self.digits is None else self.digits

    def decimals(self, column: LayoutColumn, quantity: Quantity) -> int | None:
        return 0 if quantity.key == COUNT else super().decimals(column, quantity)

    def scaled(self, crank: Crank, angles: Sequence[Fraction]) -> Sequence[Digits]:
        lengths = [column for column in self.page_columns if column.quantity.key != COUNT]
        found = iter(self.digits_of(lengths, crank, angles) if lengths else ())
        places, rounding = self.counted_places, self.rounding
        return [
            [steps_to(crank, angle, places, rounding) for angle in angles]
            if column.quantity.key == COUNT
            else next(found)
            for column in self.page_columns
        ]


def _number(question: ChordRequest, column: Column, place: Place, times: int) -> Number | None:
    # Records have no place on the axis of columns.
    index = [one.key for one in question.page_columns].index(column.key)
    scaled = question.values[place["ratio"]][index][place["angle"]]
    return None if scaled is None else Number(int(scaled) * times, column.places)


def _notes(question: ChordRequest) -> Iterator[Label]:
    layout, lang = question.layout, question.lang
    parts = {
        "{formula}": FORMULA,
        "{angle}": layout.angle_symbol,
        "{ratio}": layout.ratio_symbol.replace(":", "/"),
        "{count}": str(question.counted_places),
    }
    if layout.formulas:
        yield filled(WORDS["formula"][lang], parts.items())
        yield WORDS["bound"][lang]
    places = [place for place, one in enumerate(question.page_columns) if one.quantity.key == COUNT]
    if places:
        yield filled(WORDS["steps"][lang], parts.items())
    if any(None in columns[place] for columns in question.values for place in places):
        yield WORDS["never"][lang]
    yield from drive_notes(question.cranks, lang)


_OF_MOTION: Subject[ChordRequest] = MOTION
SUBJECT = _OF_MOTION._replace(
    key="successive",
    layout="roetscher-gf",
    command="table --layout roetscher-gf",
    quantities=quantities,
    number=_number,
    notes=_notes,
    rows=None,
    listed=None,
)
