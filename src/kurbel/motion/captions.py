"""What pages about motion say, in both languages: caption, formulas, signs, what is known of the drive."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from kurbel.drive.at import gain
from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label, figure
from kurbel.kernel.series import slope_term, terms_of, versine_term
from kurbel.motion.evaluation import (
    DIFFERENCE,
    LOADED,
    OFFSET,
    OUT,
    REACH,
    RETURN,
    ROD_MODELS,
    STROKES,
    TURN,
    method_named,
)
from kurbel.motion.notes import digits_text, drive_notes, force_notes, loaded_notes
from kurbel.page.layouts import Layout
from kurbel.page.quantity import AND, Column, Quantity, Texts, enumerated, filled, for_ratio

if TYPE_CHECKING:
    from kurbel.motion.motion_page import AngleQuestion, Request


class FormulaContext(Protocol):
    """What formulas are printed for: cranks, on a page with its letters and its language."""

    @property
    def cranks(self) -> tuple[Crank, ...]: ...
    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...


# Below the formulas of a method; {ψ} as in motion/motion_quantities.py.
SYMBOLS = {
    "exact": "$sin ψ = {ψ}λ sin {angle}$, $λ = {ratio}$",
    "series": "$λ = {ratio}$",
    "infinite": "",
    **dict.fromkeys(REACH, "$λ = {ratio}$"),
    "offset": "$sin ψ = λ (sin {angle} - e/R)$, $λ = {ratio}$",
}
# What differs between the strokes in printed formulas, as motion/entries.py and motion_quantities.py say.
_SIGNED = ("{±}", "{sign}", "{turned}", "{ψ}", "{guide}", "{slant}")
# For columns that the layout's own caption does not know.
PLAIN_CAPTION = "{quantities}{for_ratio}; {method}"
WORDS = Texts("motion", "captions")


def caption(question: Request, chosen: bool | None = None) -> Label:
    """Return the layout's caption with its quantities, the ratio, if there is only one, and the methods.

    A page whose columns the user chose has a caption of its own, for the layout's may speak of others; so it
    has for drawings.
    """
    layout, lang, columns = question.layout, question.lang, question.page_columns
    methods = dict.fromkeys(method for column in columns for method in _methods_of(column.method))
    folded = question.method == "infinite" and not question.cranks[0].ratio
    one = len({*question.ratios}) == 1 and not folded
    # What is called that of a stroke does not fit a page of whole turns.
    of_stroke = question.whole_turns and STROKES[OUT][lang] in layout.caption[lang]
    own = of_stroke or _is_chosen(question) if chosen is None else chosen
    parts = {
        "{quantities}": enumerated((column.quantity.name[lang] for column in columns), lang),
        "{for_ratio}": for_ratio(question.cranks[0].ratio, lang, layout.ratio_symbol) if one else "",
        "{method}": AND[lang].join(method_named(key).caption[lang] for key in methods),
    }
    return filled(PLAIN_CAPTION if own else layout.caption[lang], parts.items())


def _is_chosen(question: Request) -> bool:
    """Whether the layout's caption does not fit the columns that were chosen."""
    shown = {column.key for column in question.page_columns}
    own = {column.key for column in question.layout.columns}
    # All forces of the rod are what the caption of a page about them speaks of.
    own |= {key for key, quantity in question.subject.quantities().items() if quantity.model}
    # A fixed page's caption names its formulas, all of them.
    return bool(question.columns) and (not shown <= own or (question.layout.fixed and shown < own))


def notes(question: Request) -> Iterator[Label]:
    """Yield the lines below the table: its own, the formulas, the machine, the offset."""
    layout, lang, columns = question.layout, question.lang, question.page_columns
    if any(column.method == DIFFERENCE for column in columns):
        yield WORDS["difference"][lang]
    if layout.formulas:
        yield from formula_lines(question, columns)
    if said := dict.fromkeys(one.quantity.direction[lang] for one in columns if one.quantity.direction):
        yield "; ".join(said)
        yield from direction_notes(question, columns)
    sizes = drive_notes(question.cranks, lang)
    yield from sizes
    first_order = any(one.method in ("series", DIFFERENCE) for one in columns)
    if first_order or any(crank.acceleration for crank in question.cranks):
        yield from acceleration_lines(question, columns)
    yield from force_notes(question.cranks, lang)
    for crank in question.cranks[:1]:
        yield from loaded_notes(crank, layout.ratio_symbol, lang, sizes)


def direction_notes(question: AngleQuestion, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield the line about columns of the outstroke at angles of the return."""
    by_stroke = any(one.stroke == RETURN for one in question.subject.quantities().values())
    directed = any(one.quantity.stroke == OUT and one.quantity.direction for one in columns)
    if by_stroke and directed and question.whole_turns:
        yield WORDS["outward"][question.lang]


def formula_lines(page: FormulaContext, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield the formulas of the columns, each once, and what their signs mean."""
    finite = [crank for crank in page.cranks if crank.ratio]
    offset = any(crank.offset for crank in finite)
    if any(crank.loaded for crank in page.cranks):
        # What the masses add has no formula that a line holds.
        columns = [column for column in columns if LOADED not in column.quantity.formulas]
    if not columns:
        return
    strokes, sign = strokes_of(columns)
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
        name = f"{method_named(method).caption[page.lang]}: " if len(methods) > 1 else ""
        yield name + signed(line, page, sign, (method, "$ψ$") in shown)
    if RETURN in strokes and offset:
        yield signed(WORDS["offset_return"][page.lang], page, sign, False)
    elif sign == "±" and any(_has_signs(_printed(one, method)) for (method, _), one in shown.items()):
        yield WORDS["signs"][page.lang]


def strokes_of(columns: Sequence[Column]) -> tuple[set[int], str]:
    """Return the strokes of the columns, and the sign that formulas of these have."""
    strokes = {column.quantity.stroke for column in columns} - {TURN}
    return strokes, "±" if len(strokes) > 1 else "+" if strokes == {OUT} else "-"


def _printed(quantity: Quantity, key: str) -> Label:
    found = quantity.formulas.get(key)
    if found and key in REACH:
        return with_terms(found.printed, REACH[key])
    return found.printed if found else ""


def _has_signs(formula: Label) -> bool:
    """Whether the strokes differ in the formula; of what states none, in those that it follows from."""
    return not formula or any(place in formula for place in _SIGNED)


def _methods_of(method: str) -> tuple[str, ...]:
    return ("exact", "series") if method == DIFFERENCE else (method,)


def signed(line: Label, page: FormulaContext, sign: str, rod_angle: bool) -> Label:
    # A rod angle with a sign of its own needs none in the formulas that have it.
    signed = f"{sign} " if sign != "+" else ""
    parts = {
        "{±}": sign,
        "{sign}": signed,
        "{turned}": {"+": "-", "-": "", "±": "∓ "}[sign],
        "{ψ}": signed if rod_angle else "",
        "{guide}": "" if rod_angle else signed,
        "{slant}": "+" if rod_angle else sign,
        "{angle}": page.layout.angle_symbol,
        "{ratio}": page.layout.ratio_symbol.replace(":", "/"),
    }
    return filled(line, parts.items())


def acceleration_lines(page: Request, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield what pages say of how masses and cranks are accelerated, if not exactly and evenly."""
    lang, crank = page.lang, page.cranks[0]
    heavy = [one for one in columns if LOADED in one.quantity.formulas or one.quantity.model in ROD_MODELS]
    if any(one.method in ("series", DIFFERENCE) for one in heavy) and (crank.moving or crank.rod):
        yield signed(WORDS["first_order"][lang], page, strokes_of(columns)[1], False)
    if not crank.acceleration:
        return
    share = digits_text(lambda kind: gain(crank, kind), 4)
    said = [WORDS["crank"][lang].format(given=figure(crank.acceleration), share=share)]
    formulated = ("common_acceleration", "turning_acceleration") if page.layout.formulas else ()
    for key in ("p", "rod_acceleration", *formulated, "torque"):
        named = ("tangential_force", "torque", "inertia_torque") if key == "torque" else (key,)
        if any(_stem(column.quantity.key) in named for column in columns):
            said.append(signed(WORDS[key][lang], page, "+", False))
    yield "; ".join(said)


def _stem(key: str) -> str:
    for part in ("_mps2", "_radps2", "_nm", "_n", "_return", "_two_mass", "_railway"):
        key = key.removesuffix(part)
    return key


# So many terms are printed whole.
WHOLE = 3


def with_terms(line: Label, order: int) -> Label:
    """Return the line of a formula with the terms of its series up to λ to this power."""
    return filled(line, ((f"{{{name}}}", terms(order)) for name, terms in TERMS.items()))


def _path(order: int) -> str:
    """Return such as 1/2 λ sin² φ + 1/8 λ³ sin⁴ φ."""
    return _sum(order, lambda term: f"{_share(versine_term(term))}{_power(term)} {_sine(2 * term)}")


def _velocity(order: int) -> str:
    """1 + 1/2 λ² sin² φ: what λ sin φ cos φ is multiplied with, and also λ cos φ of the rod."""

    def one(term: int) -> str:
        return "1" if term == 1 else f"{_share(slope_term(term))}{_even(term)} {_sine(2 * term - 2)}"

    return _sum(order, one)


def _acceleration(order: int) -> str:
    """Return such as λ cos 2φ + 1/2 λ³ sin² φ (4 cos² φ - 1)."""

    def one(term: int) -> str:
        if term == 1:
            return "λ cos 2 {angle}"
        bracket = f"({2 * term} cos^2 {{angle}} - 1)"
        return f"{_share(slope_term(term))}{_power(term)} {_sine(2 * term - 2)} {bracket}"

    return _sum(order, one)


def _rod_acceleration(order: int) -> str:
    """1 - 1/2 λ² (3 cos² φ - 1): what -λ sin φ is multiplied with."""

    def one(term: int) -> str:
        if term == 1:
            return "1"
        sine = f" {_sine(2 * term - 4)}" if term > 2 else ""
        bracket = f"({2 * term - 1} cos^2 {{angle}} - 1)"
        return f"{_share(slope_term(term))}{_even(term)}{sine} {bracket}"

    return _sum(order, one, " - ")


def _sum(order: int, term: Callable[[int], str], sign: str = " + ") -> str:
    count = terms_of(order)
    shown = range(1, count + 1) if count <= WHOLE else (1, 2, count)
    parts = [term(one) for one in shown]
    if count > WHOLE:
        parts.insert(2, "…")
    return sign.join(parts)


def _share(coefficient: tuple[int, int]) -> str:
    above, below = coefficient
    return f"{above}/{below} "


def _power(term: int) -> str:
    return "λ" if term == 1 else f"λ^{2 * term - 1}"


def _even(term: int) -> str:
    return f"λ^{2 * term - 2}"


def _sine(power: int) -> str:
    exponent = str(power) if power < 10 else f"({power})"
    return f"sin^{exponent} {{angle}}"


# By their places in printed formulas.
TERMS: Mapping[str, Callable[[int], str]] = {
    "path": _path,
    "velocity": _velocity,
    "acceleration": _acceleration,
    "rod_acceleration": _rod_acceleration,
}
