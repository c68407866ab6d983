"""What a page says of a printed value: its characters, where it stands, what it should be, the verdict."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from kurbel.books.collation import Collated, cell_truth
from kurbel.books.quantities import AXES, methods_of, quantity_label
from kurbel.books.source import SourceCell
from kurbel.books.verdict import COARSER, DIGIT, FOLLOWS, LAST_PLACE, OTHER_FORMULA, VERDICTS
from kurbel.exact.numerals import Label, Number
from kurbel.page.quantity import Words, words
from kurbel.reading.given import choose

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


def printed_cell(one: Collated) -> Number | Label:
    """Return the printed value for a table: a number where it is set as numbers are."""
    plainly = one.printed.standing_for(one.printed.scaled) if one.printed.form in (",", ".") else ""
    if plainly == one.printed.text.replace("−", "-"):
        return Number(one.printed.scaled, one.printed.decimals)
    return _characters(one.printed.text)


def _characters(text: str) -> Label:
    """Characters as they stand, with the decimal point of labels."""
    return f"${text.replace(',', '.').replace('−', '-')}$" if "½" not in text else text.replace("'", "′")


def recomputed_cell(one: Collated) -> Number | Label:
    """Return what should be printed, in the same way."""
    if one.printed.form in (",", ".") and one.off is not None:
        return Number(one.printed.scaled - one.off, one.printed.decimals)
    return _characters(one.recomputed)


def place_label(one: Collated, lang: str, beside: SourceCell | None = None) -> Label:
    """Return where a value stands: "$x/R$, $R:L = 1:5$, 45°", without what the cell beside it shares."""
    cell, shared = one.cell, {} if beside is None else beside.axes
    parts = [cell.label or quantity_label(cell.quantity, lang)]
    for axis, text in cell.axes.items():
        if shared.get(axis) != text:
            parts.append(AXES[axis].said(AXES[axis].read(text), lang))
    return ", ".join(parts)


def filled_note(note: Label, collated: Iterable[Collated]) -> Label:
    """Return a note with its values: {place method} is what would be printed at a place by another method.

    Raises ChoiceError for a place or a method that is not there.
    """
    by_place = {one.cell.place: one for one in collated if one.cell.quantity}

    def value(match: re.Match[str]) -> Label:
        one = by_place[choose(match[1], by_place, "place with a quantity")]
        method = choose(match[2], methods_of(one.cell.quantity), "method")
        return _characters(cell_truth(one.cell, method).written_as(one.printed).text)

    return _VALUE.sub(value, note)


def verdict_text(one: Collated, collated: Iterable[Collated], lang: str) -> Label:
    """Return the verdict with what it is about."""
    said = VERDICTS[one.verdict.kind][lang]
    detail = _detail(one, collated, lang)
    return f"{said}: {detail}" if detail else said


def _detail(one: Collated, collated: Iterable[Collated], lang: str) -> Label:
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
