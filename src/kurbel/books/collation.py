"""Printed values against recomputed ones: the true value of each cell, other methods' values, the verdict.

A true value is rounded once to the last place that is printed, half away from zero; every digit is certified.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from kurbel.books.book_values import (
    AXES,
    TrueValue,
    formula_truth,
    kept,
    methods_of,
    quantity_label,
    quantity_truth,
)
from kurbel.books.printed_value import (
    COARSER,
    DIGIT,
    FOLLOWS,
    LAST_PLACE,
    OTHER_FORMULA,
    ROUNDINGS,
    VERDICTS,
    Evidence,
    PrintedValue,
    Units,
    Verdict,
    verdict,
)
from kurbel.books.source import SourceCell, SourceTable
from kurbel.drive.at import known
from kurbel.errors import KurbelError, SourceError
from kurbel.exact.numerals import Label, Number
from kurbel.page.quantity import Words, words
from kurbel.reading.given import choose


class CollatedValue(NamedTuple):
    """A printed value with what it should be, by how many units of the last place it is off, and why.

    `off` is None for a quotient that is not right, which has no last place.
    """

    cell: SourceCell
    printed: PrintedValue
    recomputed: str
    off: int | None
    verdict: Verdict


class Collation:
    """A table of a book with its values recomputed, each once."""

    def __init__(self, table: SourceTable) -> None:
        self.table = table
        self._by_place = {cell.place: cell for cell in table.cells}
        self._done: dict[str, CollatedValue] = {}
        self._truths: dict[str, TrueValue] = {}

    def __iter__(self) -> Iterator[CollatedValue]:
        for cell in self.table.cells:
            if cell.printed is not None:
                yield self.collated(cell.place)

    def collated(self, name: str) -> CollatedValue:
        """Return the cell of this place with its verdict."""
        if name not in self._done:
            self._done[name] = self._collate(self._by_place[name])
        return self._done[name]

    def _collate(self, cell: SourceCell) -> CollatedValue:
        try:
            return collate(cell, self.truth(cell), *self._way(cell))
        except KurbelError as error:
            if isinstance(error, SourceError):
                raise
            raise SourceError(f"{self.table.at(cell)}: {cell.place}: {error}") from None

    def truth(self, cell: SourceCell) -> TrueValue:
        """Return what the cell is, by the book's method."""
        if cell.place not in self._truths:
            self._truths[cell.place] = kept(self._truth(cell))
        return self._truths[cell.place]

    def _truth(self, cell: SourceCell) -> TrueValue:
        if cell.quantity:
            return cell_truth(cell, cell.method)
        return formula_truth(known(cell.formula), self._truth_at)

    def _truth_at(self, place: str) -> TrueValue:
        return self.truth(self._by_place[place])

    def _way(self, cell: SourceCell) -> tuple[TrueValue | None, tuple[str, ...]]:
        """Return the value from what was printed before, and what of that is neither right nor rounded."""
        way = cell.way or cell.formula
        if way is None or not way.names:
            return None, ()
        printed = {name: self._by_place[name].printed for name in way.names}
        before = {name: one.value for name, one in printed.items() if one is not None}
        if len(before) < len(printed):
            return None, ()
        slips = (name for name in sorted(way.names) if self.collated(name).verdict.kind not in ROUNDINGS)
        return formula_truth(way.with_numbers(before), self._truth_at), tuple(slips)


def collate(
    cell: SourceCell, truth: TrueValue, way: TrueValue | None = None, slips: tuple[str, ...] = ()
) -> CollatedValue:
    """Return a printed value with its verdict, from its true value and that of its way."""
    printed = known(cell.printed)
    right, on_the_way = truth.in_units(printed), way and way.in_units(printed)
    shown = ""
    if printed.exact and truth.rational is None and right != printed.scaled:
        shown = truth.written_as(PrintedValue("", 0, Fraction(1, 10**6), ",")).text
    coarser = printed.coarser()
    return collated_units(cell, right, on_the_way, slips, shown, lambda: truth.in_units(coarser))


def collated_units(
    cell: SourceCell,
    right: Units | None,
    on_the_way: Units | None = None,
    slips: tuple[str, ...] = (),
    shown: str = "",
    coarsely: Callable[[], Units | None] | None = None,
) -> CollatedValue:
    """Return a value that is so many units of its last place by rights, with its verdict.

    `shown` is what it should be where no quotient is known to be, `coarsely` the value in the coarser place.
    """
    printed = known(cell.printed)
    methods = methods_of(cell.quantity) if cell.quantity else ()
    others = {
        method: partial(_units_by, cell, method, printed) for method in methods if method != cell.method
    }
    coarsely = coarsely or partial(_units_by, cell, cell.method, printed.coarser())
    found = verdict(Evidence(printed, right, others, on_the_way, slips, coarsely))
    in_places = right is not None and (not printed.exact or right == printed.scaled)
    off = int(printed.scaled - right) if right is not None and in_places else None
    return CollatedValue(cell, printed, shown or printed.standing_for(right or 0), off, found)


def _units_by(cell: SourceCell, method: str, like: PrintedValue) -> Units | None:
    """Return what the cell is by a method in the unit of `like`, None where that has no formula for it."""
    try:
        truth = cell_truth(cell, method)
    except KurbelError:
        return None
    return truth.in_units(like)


def cell_truth(cell: SourceCell, method: str) -> TrueValue:
    """Return what the quantity of a cell is by a method."""
    at = {axis: AXES[axis].read(text) for axis, text in cell.axes.items()}
    return quantity_truth(cell.quantity, method, at)


WORDS: Mapping[str, Words] = {
    "place": words("Stelle|Place"),
    "printed": words("gedruckt|printed"),
    "recomputed": words("neu berechnet|recomputed"),
    "difference": words("Unterschied|difference"),
    "verdict": words("Befund|verdict"),
    "detail": words("Einzelheit|detail"),
    "quantity": words("Größe|quantity"),
    "units": words(
        "Unterschied: gedruckter weniger neu berechneter Wert, in Einheiten der letzten Stelle"
        "|Difference: printed less recomputed value, in units of the last place"
    ),
    "careful": words(
        "Ob Verfasser, Setzer oder Abschrift eine Abweichung verschuldet, zeigt der Vergleich nicht"
        "|Whether author, compositor or transcription caused a deviation the comparison does not show"
    ),
    "summary": words("{count} gedruckte Werte: {verdicts}|{count} printed values: {verdicts}"),
    "one": words("{count} gedruckter Wert: {verdicts}|{count} printed value: {verdicts}"),
    "entry": words("{place}: {printed}] {recomputed}, {difference}, {verdict}"),
    "for": words("{0} für {1}|{0} for {1}"),
    "too_many": words("{0} zu viel|{0} too many"),
    "missing": words("{0} fehlt|{0} missing"),
    "follows": words("folgt aus den gedruckten Zwischenwerten|follows from the printed intermediate values"),
    "table": words("Tafel|Table"),
}
# Of a note: {alpha_max series}.
_VALUE = re.compile(r"\{(\w+) (\w+)\}")
METHOD_NAMES: Mapping[str, Mapping[str, str]] = {
    "exact": words("genau|exact"),
    "series": words("erste Ordnung|first order"),
    "infinite": words("unendliche Stange|infinite rod"),
    "weisbach": words("Weisbach"),
    "approximate": words("Näherung|approximate"),
}


def printed_cell(one: CollatedValue) -> Number | Label:
    """Return the printed value for a table: a number where it is set as numbers are."""
    plainly = one.printed.standing_for(one.printed.scaled) if one.printed.form in (",", ".") else ""
    if plainly == one.printed.text.replace("−", "-"):
        return Number(one.printed.scaled, one.printed.decimals)
    return _characters(one.printed.text)


def _characters(text: str) -> Label:
    """Characters as they stand, with the decimal point of labels."""
    return f"${text.replace(',', '.').replace('−', '-')}$" if "½" not in text else text.replace("'", "′")


def recomputed_cell(one: CollatedValue) -> Number | Label:
    """Return what should be printed, in the same way."""
    if one.printed.form in (",", ".") and one.off is not None:
        return Number(one.printed.scaled - one.off, one.printed.decimals)
    return _characters(one.recomputed)


def place_label(one: CollatedValue, lang: str, beside: SourceCell | None = None) -> Label:
    """Return where a value stands: "$x/R$, $R:L = 1:5$, 45°", without what the cell beside it shares."""
    cell, shared = one.cell, {} if beside is None else beside.axes
    parts = [cell.label or quantity_label(cell.quantity, lang)]
    for axis, text in cell.axes.items():
        if shared.get(axis) != text:
            parts.append(AXES[axis].said(AXES[axis].read(text), lang))
    return ", ".join(parts)


def filled_note(note: Label, collated: Iterable[CollatedValue]) -> Label:
    """Return a note with its values: {place method} is what would be printed at a place by another method.

    Raises ChoiceError for a place or a method that is not there.
    """
    by_place = {one.cell.place: one for one in collated if one.cell.quantity}

    def value(match: re.Match[str]) -> Label:
        one = by_place[choose(match[1], by_place, "place with a quantity")]
        method = choose(match[2], methods_of(one.cell.quantity), "method")
        return _characters(cell_truth(one.cell, method).written_as(one.printed).text)

    return _VALUE.sub(value, note)


def verdict_text(one: CollatedValue, collated: Iterable[CollatedValue], lang: str) -> Label:
    """Return the verdict with what it is about."""
    said = VERDICTS[one.verdict.kind][lang]
    detail = _detail(one, collated, lang)
    return f"{said}: {detail}" if detail else said


def _detail(one: CollatedValue, collated: Iterable[CollatedValue], lang: str) -> Label:
    found = one.verdict
    if not found.detail:
        return ""
    if found.kind == DIGIT:
        digit, sign = found.detail[0], found.detail[1]
        words = {":": "for", "+": "too_many", "-": "missing"}[sign]
        return WORDS[words][lang].format(digit, found.detail[2:])
    if found.kind == OTHER_FORMULA:
        return METHOD_NAMES[found.detail][lang]
    if found.kind == COARSER:
        return _characters(found.detail.removeprefix("0°"))
    if (found.kind, found.detail) == (LAST_PLACE, FOLLOWS):
        return WORDS["follows"][lang]
    by_place = {each.cell.place: each for each in collated}
    return "; ".join(place_label(by_place[name], lang, one.cell) for name in found.detail.split(", "))
