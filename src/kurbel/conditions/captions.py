"""What a page of solved conditions says of itself: conditions, angles, closed forms, in both languages."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from typing import TYPE_CHECKING

from kurbel.conditions.solve import Root, target_of
from kurbel.exact.course import ClosedForm, Target, closed_forms, form_text, is_at
from kurbel.exact.numerals import Label, degrees_text, exact_text, finite_decimals
from kurbel.motion.captions import loaded_notes
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import RETURN, STROKES, method_named
from kurbel.motion.quantities import registry
from kurbel.page.quantity import AND, Column, Words, bare, words
from kurbel.reading.amounts import amount
from kurbel.reading.notation import ratio_text
from kurbel.reading.where import ANGLES, DEAD_CENTRE, LEANING, MAX, MIN, SHARE, Condition

if TYPE_CHECKING:
    from kurbel.conditions.page import SolveRequest

# Of m/s².
_SQUARE = r'(?:²|\^2|\*\*2)"$'
WORDS: Mapping[str, Words] = {
    "for": words(" für | for "),
    MAX: words("${symbol}$ am größten|${symbol}$ greatest"),
    "leaning": words("${symbol}$ dem Betrag nach am größten|${symbol}$ greatest in magnitude"),
    MIN: words("${symbol}$ am kleinsten|${symbol}$ least"),
    DEAD_CENTRE: words(
        "${symbol} = {value}$ des Wertes im Totpunkt|${symbol} = {value}$ of the value at the dead centre"
    ),
    "straight": words(
        "$φ$ vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt; {stroke}"
        "|$φ$ from the dead centre of the stroke, over the turn from the inner one; {stroke}"
    ),
    "oblique": words("$φ$ von der Schubrichtung an; {stroke}|$φ$ from the slide direction; {stroke}"),
    "length": words("$S$ Hub|$S$ stroke"),
    "extremes": words(
        "größte und kleinste Werte: eines jeden Hubes|greatest and least values: of each stroke"
    ),
    "form": words("$cos φ = {form}$, also {values}|$cos φ = {form}$, hence {values}"),
    "unusable": words("{values} unbrauchbar, jenseits $±1$|{values} unusable, beyond $±1$"),
    "condition": words("Bedingung|Condition"),
    "stroke": words("Hub|Stroke"),
    "path_stroke": words("Weg auf dem Bogen in Teilen des Hubes|Path along the arc in strokes"),
}


def caption(request: SolveRequest) -> Label:
    """Return the layout's caption with the ratio and the condition, if there is only one, and the method."""
    lang, drives, conditions = request.lang, request.drives, request.conditions
    common = []
    if len(drives) == 1 and request.method != "infinite" and drives[0].has_rod:
        common.append(f"${request.layout.ratio_symbol} = {ratio_text(drives[0].ratio)}$")
    if len(conditions) == 1:
        common.append(condition_label(conditions[0], drives[0], lang))
    text = request.layout.caption[lang]
    text = text.replace("{common}", WORDS["for"][lang] + ", ".join(common) if common else "")
    return text.replace("{method}", method_named(request.method).caption[lang])


def condition_label(condition: Condition, drive: Drive, lang: str) -> Label:
    """Return the condition in letters: x/R = 1.1; p = 1/6 of the value at the dead centre."""
    shown = drive.columns[drive.column_of(condition.quantity)]
    symbol = shown.symbol.strip("$")
    if condition.kind in WORDS:
        leans = condition.kind == MAX and condition.quantity in LEANING
        said = WORDS["leaning" if leans else condition.kind][lang]
        return said.format(symbol=symbol, value=exact_text(condition.value))
    if condition.quantity == SHARE:
        whole = finite_decimals(condition.value) is not None
        value = f"{exact_text(100 * condition.value)} %" if whole else exact_text(condition.value)
        return f"$x/S = {value}$"
    if condition.quantity in ANGLES:
        plain = finite_decimals(condition.value) is not None
        return f"${symbol} = {exact_text(condition.value) + '°' if plain else degrees_text(condition.value)}$"
    if condition.unit:
        unit = re.sub(_SQUARE, '"^2', f'"{condition.unit}"')
        return f"${symbol} = {exact_text(condition.value)} {unit}$"
    if condition.quantity in drive.pushed:
        return f"${symbol} = {amount(condition.value, shown.unit[lang], exact_text)}$"
    if condition.value:
        symbol = shown.heading[lang].strip("$")
    return f"${symbol} = {exact_text(condition.value)}$"


def notes(request: SolveRequest) -> Iterator[Label]:
    """Yield the lines below the table: angles, formulas, closed forms, lengths."""
    lang = request.lang
    straight = all(one.is_straight for one in request.drives)
    strokes = {one.stroke if straight else "" for one in request.drives}
    said = f"$S = {strokes.pop()}$" if len(strokes) == 1 and all(strokes) else WORDS["length"][lang]
    yield WORDS["straight" if straight else "oblique"][lang].format(stroke=said)
    if any(condition.kind in (MAX, MIN) for condition in request.conditions):
        yield WORDS["extremes"][lang]
    yield from request.drives[0].formula_lines(request, list(_digits(request)))
    yield from _forms(request)
    crank = request.drives[0].crank
    if crank.force is not None:
        yield crank.force.note(lang)
    if getattr(crank, "loaded", False):
        yield from loaded_notes(crank, request.layout.ratio_symbol, lang)
    yield from request.drives[0].closing_lines(request)


def _digits(request: SolveRequest) -> Iterator[Column]:
    """Yield what is shown and asked for, on both strokes."""
    drive = request.drives[0]
    asked = [drive.column_of(condition.quantity) for condition in request.conditions]
    for key in dict.fromkeys((*(column.key for column in request.page_columns), *asked)):
        if key in registry():
            for quantity in (registry()[key], registry()[key]._replace(stroke=RETURN)):
                yield bare(quantity, request.method, quantity.decimals)


def _forms(request: SolveRequest) -> Iterator[Label]:
    """Yield the closed forms of each ratio, condition and stroke that has some."""
    for (ratio, condition, stroke), roots in request.found.items():
        said = "; ".join(_said(roots, request.lang))
        if said:
            drive, asked = request.drives[ratio], request.conditions[condition]
            heads = [STROKES[stroke][request.lang]]
            if len(request.conditions) > 1:
                heads.insert(0, condition_label(asked, drive, request.lang))
            if len(request.drives) > 1:
                heads.insert(0, f"${request.layout.ratio_symbol} = {ratio_text(drive.ratio)}$")
            yield f"{', '.join(heads)}: {said}"


def _said(roots: Sequence[Root], lang: str) -> Iterator[Label]:
    drive, condition, stroke = roots[0].drive, roots[0].condition, roots[0].stroke
    if not drive.is_straight:
        return
    course = drive.course(condition.quantity, stroke)
    extreme = condition.kind in (MAX, MIN)
    formula = course.formula_slope if extreme else course.formula
    if formula is None:
        return
    target = Target.rational(Fraction(0)) if extreme else target_of(drive, condition, stroke)
    forms = closed_forms(formula, target)
    usable = [form for form in forms if any(is_at(form, root.place) for root in roots)]
    forms = [form for form in forms if form in usable or (formula.is_rational and not form.is_usable)]
    if extreme:
        forms = [form for form in forms if form in usable or form.twin in usable]
    # Of a dead centre alone a closed form says nothing.
    if any(form.outside or abs(form.plain) != form.below for form in forms):
        yield from _lines(forms, usable, lang)


def _lines(forms: Sequence[ClosedForm], usable: Sequence[ClosedForm], lang: str) -> Iterator[Label]:
    """Yield cos φ as it is solved, then the values that no angle has."""
    for text, of_text in groupby(usable, key=lambda form: _text(form, forms)):
        values = AND[lang].join(f"${form_text(form)}$" for form in of_text)
        rational = text == values.strip("$")
        yield f"$cos φ = {text}$" if rational else WORDS["form"][lang].format(form=text, values=values)
    if others := [f"${form_text(form)}$" for form in forms if not form.is_usable]:
        yield WORDS["unusable"][lang].format(values=AND[lang].join(others))


def _text(form: ClosedForm, forms: Sequence[ClosedForm]) -> str:
    """(-5 ± sqrt(33))/4, with one sign where the twin is not among the forms."""
    if not form.outside:
        return form_text(form)
    sign = "±" if form.twin in forms else "+" if form.outside > 0 else "-"
    times = f"{abs(form.outside)} " if abs(form.outside) > 1 else ""
    plain = f"{form.plain} {sign} " if form.plain else sign if sign != "+" else ""
    above = f"{plain}{times}sqrt({form.radicand})"
    return above if form.below == 1 else f"({above})/{form.below}"
