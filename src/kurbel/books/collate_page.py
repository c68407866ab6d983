"""A book's table and its collation become a page: as printed, with marks, and a critical apparatus below."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import count

from kurbel.books.collation import Collated
from kurbel.books.source import AXES, SourceCell, SourceTable
from kurbel.books.verdict import (
    ALL,
    DEVIATIONS,
    DIGIT,
    FOLLOWS,
    LAST_PLACE,
    OTHER_FORMULA,
    RIGHT,
    VERDICTS,
)
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, SourceError
from kurbel.exact.numerals import Label, Number
from kurbel.page import axes as page_axes
from kurbel.page.arrange import Axis, Grid, Place, check_size, panels
from kurbel.page.layouts import layout_of
from kurbel.page.old_axes import ColumnAxis
from kurbel.page.sheet import Heads, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Note, Panel, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import angle, number, plain, ratio, ratio_text

WORDS: Mapping[str, Mapping[str, str]] = {
    "place": {"de": "Stelle", "en": "Place"},
    "printed": {"de": "gedruckt", "en": "printed"},
    "recomputed": {"de": "neu berechnet", "en": "recomputed"},
    "difference": {"de": "Unterschied", "en": "difference"},
    "verdict": {"de": "Befund", "en": "verdict"},
    "detail": {"de": "Einzelheit", "en": "detail"},
    "quantity": {"de": "Größe", "en": "quantity"},
    "units": {
        "de": "Unterschied: gedruckter weniger neu berechneter Wert, in Einheiten der letzten Stelle",
        "en": "Difference: printed less recomputed value, in units of the last place",
    },
    "careful": {
        "de": "Ob Verfasser, Setzer oder Abschrift eine Abweichung verschuldet, zeigt der Vergleich nicht",
        "en": "Whether author, compositor or transcription caused a deviation the comparison does not show",
    },
    "summary": {"de": "{count} gedruckte Werte: {verdicts}", "en": "{count} printed values: {verdicts}"},
    "one": {"de": "{count} gedruckter Wert: {verdicts}", "en": "{count} printed value: {verdicts}"},
    "entry": {
        "de": "{place}: {printed}] {recomputed}, {difference}, {verdict}",
        "en": "{place}: {printed}] {recomputed}, {difference}, {verdict}",
    },
    "for": {"de": "{0} für {1}", "en": "{0} for {1}"},
    "too_many": {"de": "{0} zu viel", "en": "{0} too many"},
    "missing": {"de": "{0} fehlt", "en": "{0} missing"},
    "follows": {
        "de": "folgt aus den gedruckten Zwischenwerten",
        "en": "follows from the printed intermediate values",
    },
    "table": {"de": "Tafel", "en": "Table"},
    "outstroke": {"de": "Hingang", "en": "outstroke"},
    "return": {"de": "Rückgang", "en": "return"},
    "turn": {"de": "Umdrehung", "en": "turn"},
}
METHOD_NAMES: Mapping[str, Mapping[str, str]] = {
    "exact": {"de": "genau", "en": "exact"},
    "series": {"de": "erste Ordnung", "en": "first order"},
    "infinite": {"de": "unendliche Stange", "en": "infinite rod"},
    "weisbach": {"de": "Weisbach", "en": "Weisbach"},
    "approximate": {"de": "Näherung", "en": "approximate"},
}
KEYS = (
    "table", "place", "quantity", *AXES, "method", "printed", "recomputed", "difference", "verdict", "detail",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class CollateRequest(Sheet):
    """What is asked for: the collated cells of a table, all or those that deviate."""

    table: SourceTable
    collated: Sequence[Collated] = field(repr=False)
    only: str = ALL

    def __post_init__(self) -> None:
        super().__post_init__()
        for key in self.columns:
            choose(key, KEYS, "column")

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.shown)

    @cached_property
    def deviations(self) -> list[Collated]:
        return [one for one in self.collated if one.verdict.kind != RIGHT]

    @property
    def shown(self) -> Sequence[Collated]:
        return self.deviations if self.only == DEVIATIONS else self.collated


def build_collation(request: CollateRequest, pages: bool = True) -> Table:
    """Return the page with its apparatus; without `pages` only its records."""
    lang, table = request.lang, request.table
    names = request.columns or KEYS
    records = records_of(len(request), names, _fields(lang), lambda: _records(request))
    as_printed = bool(table.layout) and request.only == ALL
    marks = _marks(request) if as_printed else {}
    caption = request.layout.caption[lang].replace("{title}", table.title[lang])
    drawn = table_of(request, caption, None if as_printed or not pages else _grid(request), records, ())
    return replace(
        drawn,
        key=request.label or table.key or drawn.key,
        panels=_printed_page(request, marks) if as_printed and pages else drawn.panels,
        notes=tuple(_notes(request, marks)),
        source=table.book.citation[lang],
    )


def _marks(request: CollateRequest) -> Mapping[str, str]:
    """Return a letter for each place that deviates: a to z, then aa."""
    letters = (_letters(number) for number in count())
    return {one.cell.place: mark for one, mark in zip(request.deviations, letters, strict=False)}


def _letters(number: int) -> str:
    first, last = divmod(number, 26)
    return (_letters(first - 1) if first else "") + "abcdefghijklmnopqrstuvwxyz"[last]


def _printed_page(request: CollateRequest, marks: Mapping[str, str]) -> tuple[Panel, ...]:
    """The page in the book's layout, with the characters of the book."""
    from kurbel.motion.question import Request

    table = request.table
    try:
        page = layout_of(table.layout, ("motion",))
    except ChoiceError as error:
        raise SourceError(f"{table.book.path}: {error}") from None
    shown = {column.quantity for column in page.columns}
    by_place: dict[tuple[str, Fraction, Fraction], Collated] = {}
    for one in request.collated:
        where = _where(one.cell)
        if one.cell.quantity not in shown or where is None or where in by_place:
            raise SourceError(
                f"{table.at(one.cell)}: the layout {page.key} has no place for {one.cell.place};"
                " give the table another or none"
            )
        by_place[where] = one
    ratios = dict.fromkeys(place[1] for place in by_place)
    angles = list(dict.fromkeys(place[2] for place in by_place))
    cranks = tuple(Crank(each) for each in ratios)
    asked = Request(layout=page, cranks=cranks, angles=angles, lang=request.lang)
    columns = asked.page_columns

    def cell(place: Place) -> Cell:
        quantity = columns[place["column"]].quantity.key
        found = by_place.get((quantity, [*ratios][place["ratio"]], angles[place["angle"]]))
        if found is None:
            return Cell(None)
        mark = marks.get(found.cell.place)
        return Cell(_printed(found), (mark,) if mark else ())

    return panels(page, Grid(asked.axes, cell))


def _where(cell: SourceCell) -> tuple[str, Fraction, Fraction] | None:
    if not {"ratio", "phi"} <= {*cell.axes}:
        return None
    return cell.quantity, ratio(cell.axes["ratio"]), angle(cell.axes["phi"], "angle")


def _printed(one: Collated) -> Number | Label:
    plainly = one.printed.standing_for(one.printed.scaled) if one.printed.form in (",", ".") else ""
    if plainly == one.printed.text.replace("−", "-"):
        return Number(one.printed.scaled, one.printed.decimals)
    return _characters(one.printed.text)


def _characters(text: str) -> Label:
    """Characters as they stand, with the decimal point of labels."""
    return f"${text.replace(',', '.').replace('−', '-')}$" if "½" not in text else text.replace("'", "′")


class _PlaceAxis(Axis):
    """The places of the printed values."""

    def __init__(self, request: CollateRequest) -> None:
        super().__init__(len(request.shown))
        self.request = request

    def stub_heading(self) -> Label:
        return WORDS["place"][self.request.lang]

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (place_label(self.request.shown[place["place"]], self.request.lang),)


def _grid(request: CollateRequest) -> Grid:
    layout, lang = request.layout, request.lang
    keys = [column.key for column in layout.columns]
    heads = [Heads((), (WORDS[key][lang],)) for key in keys]
    axes: dict[str, Axis] = {"place": _PlaceAxis(request), "column": ColumnAxis(layout, heads, (), lang)}
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        one = request.shown[place["place"]]
        match keys[place["column"]]:
            case "printed":
                return Cell(_printed(one))
            case "recomputed":
                return Cell(_recomputed(one))
            case "difference":
                return Cell(Number(one.off, 0) if one.off else None)
        return Cell(verdict_text(one, request, lang))

    return Grid(axes, cell)


def _recomputed(one: Collated) -> Number | Label:
    if one.printed.form in (",", ".") and one.off is not None:
        return Number(one.printed.scaled - one.off, one.printed.decimals)
    return _characters(one.recomputed)


def place_label(one: Collated, lang: str, beside: SourceCell | None = None) -> Label:
    """Return where a value stands: "$x/R$, $R:L = 1:5$, 45°", without what the cell beside it shares."""
    cell, shared = one.cell, {} if beside is None else beside.axes
    parts = [cell.label or quantity_label(cell.quantity, lang)]
    for axis, text in cell.axes.items():
        if shared.get(axis) != text:
            parts.append(_axis_label(axis, text, lang))
    return ", ".join(parts)


def _axis_label(axis: str, text: str, lang: str) -> Label:
    match axis:
        case "ratio":
            return f"${ratio_text(ratio(text))}$"
        case "epsilon":
            return f"$ε = {plain(number(text, 'expansion ratio'))}$"
        case "arm":
            return f"$a = {plain(number(text, 'beam arm'))} r$"
        case "phi":
            return f"${plain(angle(text, 'angle'))}°$"
    return WORDS[text][lang]


def quantity_label(key: str, lang: str) -> Label:
    """Return how a quantity is written at the head of its column."""
    from kurbel.engine.quantities import engine_registry
    from kurbel.linkage.beam import registry as beam_registry
    from kurbel.motion.quantities import registry

    if key in registry():
        quantity = registry()[key]
        heading = quantity.heading[lang]
        return heading if "$" in heading else f"{quantity.symbol} {heading}"
    return engine_registry()[key].symbol if key in engine_registry() else beam_registry()[key].symbol


def verdict_text(one: Collated, request: CollateRequest, lang: str) -> Label:
    """Return the verdict with what it is about."""
    said = VERDICTS[one.verdict.kind][lang]
    detail = _detail(one, request, lang)
    return f"{said}: {detail}" if detail else said


def _detail(one: Collated, request: CollateRequest, lang: str) -> Label:
    found = one.verdict
    if not found.detail:
        return ""
    if found.kind == DIGIT:
        digit, sign = found.detail[0], found.detail[1]
        words = {":": "for", "+": "too_many", "-": "missing"}[sign]
        return WORDS[words][lang].format(digit, found.detail[2:])
    if found.kind == OTHER_FORMULA:
        return METHOD_NAMES[found.detail][lang]
    if (found.kind, found.detail) == (LAST_PLACE, FOLLOWS):
        return WORDS["follows"][lang]
    by_place = {each.cell.place: each for each in request.collated}
    return "; ".join(place_label(by_place[name], lang, one.cell) for name in found.detail.split(", "))


def _notes(request: CollateRequest, marks: Mapping[str, str]) -> Iterator[Note]:
    lang = request.lang
    for one in request.deviations if marks else ():
        text = WORDS["entry"][lang].format(
            place=place_label(one, lang),
            printed=f"${one.printed.text.replace(',', '.')}$",
            recomputed=f"${one.recomputed.replace(',', '.')}$",
            difference="–" if one.off is None else f"${one.off:+d}$",
            verdict=verdict_text(one, request, lang),
        )
        yield Note(text, marks[one.cell.place])
    counted = Counter(one.verdict.kind for one in request.collated)
    found = (f"{counted[kind]} {words[lang]}" for kind, words in VERDICTS.items() if counted[kind])
    words = WORDS["one" if len(request.collated) == 1 else "summary"][lang]
    yield Note(words.format(count=len(request.collated), verdicts=", ".join(found)))
    yield from (Note(note) for note in request.table.notes[lang])
    yield Note(WORDS["units"][lang])
    if request.deviations:
        yield Note(WORDS["careful"][lang])


def _fields(lang: str) -> Mapping[str, Field]:

    names = {key: words[lang] for key, words in WORDS.items()}
    names |= {"ratio": page_axes.RATIO[lang], "phi": page_axes.PHI[lang]}
    return {key: Field(key, names.get(key, key)) for key in KEYS}


def _records(request: CollateRequest) -> Iterator[Mapping[str, Value]]:
    for one in request.shown:
        cell = one.cell
        axes = {axis: cell.axes.get(axis) for axis in AXES}
        yield {
            "table": request.table.key,
            "place": cell.place,
            "quantity": cell.quantity or None,
            **axes,
            "method": cell.method if cell.quantity else None,
            "printed": one.printed.text,
            "recomputed": one.recomputed,
            "difference": None if one.off is None else Number(one.off, 0),
            "verdict": one.verdict.kind,
            "detail": one.verdict.detail or None,
        }
