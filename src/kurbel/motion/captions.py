"""What a page about motion says of itself: caption, formulas, signs, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label
from kurbel.motion.drive_notes import drive_notes, force_notes, moving_notes
from kurbel.motion.evaluation import DIFFERENCE, LOADED, METHODS, OFFSET, OUT, RETURN
from kurbel.page.quantity import AND, Column, Quantity, enumerated, filled, for_ratio, words

if TYPE_CHECKING:
    from kurbel.motion.page import Request
    from kurbel.page.layouts import Layout


class Formulated(Protocol):
    """What formulas are printed for: cranks, on a page with its letters and its language."""

    @property
    def cranks(self) -> tuple[Crank, ...]: ...
    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...


# Below the formulas of a method; {ψ} as in motion/quantities.py.
SYMBOLS = {
    "exact": "$sin ψ = {ψ}λ sin {angle}$, $λ = {ratio}$",
    "series": "$λ = {ratio}$",
    "infinite": "",
    "offset": "$sin ψ = λ (sin {angle} - e/R)$, $λ = {ratio}$",
}
# For columns that the layout's own caption does not know.
PLAIN_CAPTION = "{quantities}{for_ratio}; {method}"
WORDS: Mapping[str, Mapping[str, str]] = {
    "difference": words(
        "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet."
        "|Difference: exact value less first order, taken before rounding."
    ),
    "signs": words(
        "oberes Zeichen: Hingang, unteres Zeichen: Rückgang|upper sign: outstroke, lower sign: return stroke"
    ),
    "offset_return": words(
        "Rückgang bei $180° + {angle}$, vom äußeren Totpunkt und in Richtung des Rückgangs gerechnet"
        "|Return at $180° + {angle}$, counted from the outer dead centre in the direction of the return"
    ),
}


def caption(question: Request, chosen: bool | None = None) -> Label:
    """Return the layout's caption with its quantities, the ratio, if there is only one, and the methods.

    A page whose columns the user chose has a caption of its own, for the layout's may speak of others; so it
    has for drawings.
    """
    layout, lang, columns = question.layout, question.lang, question.page_columns
    methods = dict.fromkeys(method for column in columns for method in _methods_of(column.method))
    folded = question.method == "infinite" and not question.cranks[0].ratio
    one = len(question.cranks) == 1 and not folded
    own = _is_chosen(question) if chosen is None else chosen
    parts = {
        "{quantities}": enumerated((column.quantity.name[lang] for column in columns), lang),
        "{for_ratio}": for_ratio(question.cranks[0].ratio, lang, layout.ratio_symbol) if one else "",
        "{method}": AND[lang].join(METHODS[key].caption[lang] for key in methods),
    }
    return filled(PLAIN_CAPTION if own else layout.caption[lang], parts.items())


def _is_chosen(question: Request) -> bool:
    """Whether the layout's caption does not fit the columns that were chosen."""
    shown = {column.key for column in question.page_columns}
    own = {column.key for column in question.layout.columns}
    # All forces of the rod are what the caption of a page about them speaks of.
    own |= {key for key, quantity in question.subject.quantities().items() if quantity.of}
    # A fixed page's caption names its formulas, all of them.
    return bool(question.columns) and (not shown <= own or (question.layout.fixed and shown < own))


def notes(question: Request) -> Iterator[Label]:
    """Yield the lines below the table: its own, the formulas, the machine, the offset."""
    layout, lang, columns = question.layout, question.lang, question.page_columns
    yield from (note[lang] for note in layout.notes)
    if any(column.method == DIFFERENCE for column in columns):
        yield WORDS["difference"][lang]
    if layout.formulas:
        yield from formula_lines(question, columns)
    if said := dict.fromkeys(one.quantity.direction[lang] for one in columns if one.quantity.direction):
        yield "; ".join(said)
    yield from drive_notes(question.cranks, lang)
    yield from force_notes(question.cranks, lang)
    for crank in question.cranks[:1]:
        if crank.moving is not None:
            yield from moving_notes(crank, layout.ratio_symbol, lang)


def formula_lines(page: Formulated, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield the formulas of the columns, each once, and what their signs mean."""
    finite = [crank for crank in page.cranks if crank.ratio]
    offset = any(crank.offset for crank in finite)
    if any(crank.moving for crank in page.cranks):
        # What the masses add has no formula that a line holds.
        columns = [column for column in columns if LOADED not in column.quantity.formulas]
    if not columns:
        return
    strokes = {column.quantity.stroke for column in columns}
    sign = "±" if len(strokes) > 1 else "+" if strokes == {OUT} else "-"
    shown = {
        # Where no rod is finite, the formulas that divide by λ say nothing.
        (method if finite else "infinite", column.quantity.symbol): column.quantity
        for column in columns
        for method in _methods_of(column.method)
    }
    methods = dict.fromkeys(method for method, _ in shown)
    for method in methods:
        key = OFFSET if offset else method
        formulas = [_printed(quantity, key) for (one, _), quantity in shown.items() if one == method]
        line = ", ".join(part for part in (*formulas, SYMBOLS[key]) if part)
        name = f"{METHODS[method].caption[page.lang]}: " if len(methods) > 1 else ""
        yield name + _signed(line, page, sign, (method, "$ψ$") in shown)
    if RETURN in strokes and offset:
        yield _signed(WORDS["offset_return"][page.lang], page, sign, False)
    elif sign == "±" and any(_has_signs(_printed(one, method)) for (method, _), one in shown.items()):
        yield WORDS["signs"][page.lang]


def _printed(quantity: Quantity, key: str) -> Label:
    found = quantity.formulas.get(key)
    return found.printed if found else ""


def _has_signs(formula: Label) -> bool:
    """Whether the strokes differ in the formula; of what states none, in those that it follows from."""
    return not formula or any(place in formula for place in ("{±}", "{ψ}", "{guide}", "{slant}"))


def _methods_of(method: str) -> tuple[str, ...]:
    return ("exact", "series") if method == DIFFERENCE else (method,)


def _signed(line: Label, page: Formulated, sign: str, rod_angle: bool) -> Label:
    # A rod angle with a sign of its own needs none in the formulas that have it.
    signed = f"{sign} " if sign != "+" else ""
    parts = {
        "{±}": sign,
        "{ψ}": signed if rod_angle else "",
        "{guide}": "" if rod_angle else signed,
        "{slant}": "+" if rod_angle else sign,
        "{angle}": page.layout.angle_symbol,
        "{ratio}": page.layout.ratio_symbol.replace(":", "/"),
    }
    return filled(line, parts.items())
