"""A book's table and its collation become a page: as printed, with marks, and a critical apparatus below."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cached_property
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
from kurbel.page.axes import PHI, RATIO, ColumnAxis, Grid, PageAxis, Place
from kurbel.page.build import grid_of
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.quantity import Column, Formula, Quantity, Words, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Cell, Field, Note, Records, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import angle, number, plain, ratio, ratio_text

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
    "outstroke": words("Hingang|outstroke"),
    "return": words("Rückgang|return"),
    "turn": words("Umdrehung|turn"),
}
METHOD_NAMES: Mapping[str, Mapping[str, str]] = {
    "exact": words("genau|exact"),
    "series": words("erste Ordnung|first order"),
    "infinite": words("unendliche Stange|infinite rod"),
    "weisbach": words("Weisbach"),
    "approximate": words("Näherung|approximate"),
}
KEYS = (
    "table", "place", "quantity", *AXES, "method", "printed", "recomputed", "difference", "verdict", "detail",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class CollateRequest(Question):
    """What is asked for: the collated cells of a table, all or those that deviate."""

    table: SourceTable
    collated: Sequence[Collated] = field(repr=False)
    only: str = ALL

    def __len__(self) -> int:
        return len(self.shown)

    @cached_property
    def deviations(self) -> list[Collated]:
        return [one for one in self.collated if one.verdict.kind != RIGHT]

    @property
    def shown(self) -> Sequence[Collated]:
        return self.deviations if self.only == DEVIATIONS else self.collated

    @property
    def as_printed(self) -> bool:
        """Whether the page is the book's."""
        return bool(self.table.layout) and self.only == ALL

    @cached_property
    def marks(self) -> Mapping[str, str]:
        """A letter for each place of the book's page that deviates: a to z, then aa."""
        letters = (_letters(number) for number in count()) if self.as_printed else iter(())
        return {one.cell.place: mark for one, mark in zip(self.deviations, letters, strict=False)}

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        for key in self.columns:
            choose(key, KEYS, "column")
        return tuple(map(self.column, self.layout.columns))

    @property
    def key(self) -> str:
        return self.label or self.table.key or self.layout.key

    @property
    def source(self) -> Label:
        return self.table.book.citation[self.lang]


def _letters(number: int) -> str:
    first, last = divmod(number, 26)
    return (_letters(first - 1) if first else "") + "abcdefghijklmnopqrstuvwxyz"[last]


def _printed_page(request: CollateRequest) -> tuple[Layout, Grid]:
    """The page in the book's layout, with the characters of the book."""
    from kurbel.motion.question import Request

    table = request.table
    try:
        page = layout_of(table.layout, ("motion",))
    except ChoiceError as error:
        raise table.book.file.error(("tables", table.name, "layout"), error) from None
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
        mark = request.marks.get(found.cell.place)
        return Cell(_printed(found), (mark,) if mark else ())

    return page, Grid(asked.axes, asked.lang, cell)


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


class _PlaceAxis(PageAxis):
    """The places of the printed values."""

    def __init__(self, request: CollateRequest) -> None:
        super().__init__(len(request.shown))
        self.request = request

    def stub_heading(self) -> Label:
        return WORDS["place"][self.request.lang]

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (place_label(self.request.shown[place["place"]], self.request.lang),)


def _shown(request: CollateRequest, column: Column, place: Place, times: int) -> Value:
    one = request.shown[place["place"]]
    shown: Value = column.quantity.formulas[""].kernel(one, request)
    return shown


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what stands beside a place, each of what was collated there."""
    shown = {
        "printed": lambda one, request: _printed(one),
        "recomputed": lambda one, request: _recomputed(one),
        "difference": lambda one, request: Number(one.off, 0) if one.off else None,
        "verdict": lambda one, request: verdict_text(one, request, request.lang),
    }
    return {
        key: Quantity(key, WORDS[key], "", words(""), None, {"": Formula(kernel)}, WORDS[key])
        for key, kernel in shown.items()
    }


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


def _notes(request: CollateRequest) -> Iterator[Note]:
    lang, marks = request.lang, request.marks
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
    said = WORDS["one" if len(request.collated) == 1 else "summary"][lang]
    yield Note(said.format(count=len(request.collated), verdicts=", ".join(found)))
    yield from (Note(note) for note in request.table.notes[lang])
    yield Note(WORDS["units"][lang])
    if request.deviations:
        yield Note(WORDS["careful"][lang])


def _records(request: CollateRequest) -> Records:
    keys, lang = request.columns or KEYS, request.lang
    names = {key: texts[lang] for key, texts in WORDS.items()} | {"ratio": RATIO[lang], "phi": PHI[lang]}
    return Records(tuple(Field(key, names.get(key, key)) for key in keys), _Rows(request, keys))


class _Rows:
    """The records: one for each place that is shown."""

    def __init__(self, request: CollateRequest, keys: Sequence[str]) -> None:
        self.request, self.keys = request, keys

    def __len__(self) -> int:
        return len(self.request)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        for one in self.request.shown:
            record = _record(self.request, one)
            yield tuple(record[key] for key in self.keys)


def _record(request: CollateRequest, one: Collated) -> Mapping[str, Value]:
    cell = one.cell
    return {
        "table": request.table.key,
        "place": cell.place,
        "quantity": cell.quantity or None,
        **{axis: cell.axes.get(axis) for axis in AXES},
        "method": cell.method if cell.quantity else None,
        "printed": one.printed.text,
        "recomputed": one.recomputed,
        "difference": None if one.off is None else Number(one.off, 0),
        "verdict": one.verdict.kind,
        "detail": one.verdict.detail or None,
    }


def _grid(request: CollateRequest) -> tuple[Layout, Grid]:
    return _printed_page(request) if request.as_printed else (request.layout, grid_of(request))


def _caption(request: CollateRequest) -> Label:
    return request.layout.caption[request.lang].replace("{title}", request.table.title[request.lang])


SUBJECT = Subject(
    key="collation",
    layout="collation",
    command="collate",
    sample="collate roetscher-112",
    axes={"place": _PlaceAxis, "column": ColumnAxis},
    axis_keys=KEYS,
    own_first=False,
    quantities=quantities,
    number=_shown,
    caption=_caption,
    notes=_notes,
    grid=_grid,
    rows=_records,
)
