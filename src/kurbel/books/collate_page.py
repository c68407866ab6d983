"""A book's table and its collation become a page: as printed, with marks, and a critical apparatus below."""

from __future__ import annotations

from abc import abstractmethod
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cached_property
from itertools import count
from typing import Any, ClassVar

from kurbel.books.collation import (
    WORDS,
    CollatedValue,
    filled_note,
    place_label,
    printed_cell,
    recomputed_cell,
    verdict_text,
)
from kurbel.books.printed_value import ALL, DEVIATIONS, RIGHT, VERDICTS, tone_of
from kurbel.books.source import AXIS_KEYS, SourceCell, SourceTable
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, SourceError
from kurbel.exact.numerals import Label, Number
from kurbel.page.axes import PHI, RATIO, ColumnAxis, Grid, PageAxis, Place
from kurbel.page.build import own_grid
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.quantity import Column, Formula, Quantity, Words, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Cell, Field, Note, Records, Value
from kurbel.reading.given import choose
from kurbel.reading.notation import angle, ratio

KEYS = (
    "table", "place", "quantity", *AXIS_KEYS, "method",
    "printed", "recomputed", "difference", "verdict", "detail",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class BookQuestion(Question):
    """What is asked for of a book's table: what was found at its places, at all or where it deviates."""

    # The columns of the records, and the words over them.
    keys: ClassVar[tuple[str, ...]]
    words: ClassVar[Mapping[str, Words]]
    table: Any
    collated: Sequence[object]
    only: str = ALL

    def __len__(self) -> int:
        return len(self.shown)

    @cached_property
    @abstractmethod
    def deviations(self) -> Sequence[Any]:
        """What is not as it should be."""

    @abstractmethod
    def record(self, one: Any) -> Mapping[str, Value]:
        """Return what the records have of one place."""

    @property
    def shown(self) -> Sequence[Any]:
        return self.deviations if self.only == DEVIATIONS else self.collated

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        for key in self.columns:
            choose(key, self.keys, "column")
        return tuple(map(self.column, self.layout.columns))

    @property
    def key(self) -> str:
        return str(self.label or self.table.key or self.layout.key)

    @property
    def origin(self) -> Label:
        return str(self.table.book.citation[self.lang])

    def records(self) -> Records:
        """Return the columns that were asked for, else all; the place tells rows apart."""
        asked = self.columns
        keys = (*("place",) * ("place" not in asked), *asked) if asked else self.keys
        rows = [[record[key] for key in keys] for record in map(self.record, self.shown)]
        names = (self.words[key][self.lang] if key in self.words else key for key in keys)
        return Records(tuple(map(Field, keys, names)), rows)


def kernels(words_of: Mapping[str, Words], **shown: Callable[..., object]) -> Mapping[str, Quantity]:
    """Return what stands beside a place, each by what it is made of."""
    return {
        key: Quantity(key, words_of[key], "", words(""), None, {"": Formula(kernel)}, words_of[key])
        for key, kernel in shown.items()
    }


def titled(request: BookQuestion) -> Label:
    return request.layout.caption[request.lang].replace("{title}", request.table.title[request.lang])


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class CollateRequest(BookQuestion):
    """What is asked for: the collated cells of a table, all or those that deviate."""

    keys = KEYS
    words: ClassVar[Mapping[str, Words]] = {**WORDS, "ratio": RATIO, "phi": PHI}
    table: SourceTable
    collated: Sequence[CollatedValue] = field(repr=False)

    @cached_property
    def deviations(self) -> list[CollatedValue]:
        return [one for one in self.collated if one.verdict.kind != RIGHT]

    @property
    def as_printed(self) -> bool:
        """Whether the page is the book's."""
        return bool(self.table.layout) and self.only == ALL

    @cached_property
    def marks(self) -> Mapping[str, str]:
        """A letter for each place of the book's page that deviates: a to z, then aa."""
        letters = (_letters(number) for number in count()) if self.as_printed else iter(())
        return {one.cell.place: mark for one, mark in zip(self.deviations, letters, strict=False)}

    def record(self, one: CollatedValue) -> Mapping[str, Value]:
        cell = one.cell
        return {
            "table": self.table.key,
            "place": cell.place,
            "quantity": cell.quantity or None,
            **{axis: cell.axes.get(axis) for axis in AXIS_KEYS},
            "method": cell.method if cell.quantity else None,
            "printed": one.printed.text,
            "recomputed": one.recomputed,
            "difference": None if one.off is None else Number(one.off, 0),
            "verdict": one.verdict.kind,
            "detail": one.verdict.detail or None,
        }


def _letters(number: int) -> str:
    first, last = divmod(number, 26)
    return (_letters(first - 1) if first else "") + "abcdefghijklmnopqrstuvwxyz"[last]


def _printed_page(request: CollateRequest) -> tuple[Layout, Grid]:
    """The page in the book's layout, with the characters of the book."""
    from kurbel.motion.motion_page import Request

    table = request.table
    try:
        page = layout_of(table.layout, ("motion",))
    except ChoiceError as error:
        raise table.book.file.error(("tables", table.name, "layout"), error) from None
    shown = {column.quantity for column in page.columns}
    by_place: dict[tuple[str, Fraction, Fraction], CollatedValue] = {}
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
    asked = Request(layout=page, drives=cranks, angles=angles, lang=request.lang)
    columns = asked.page_columns

    def cell(place: Place) -> Cell:
        quantity = columns[place["column"]].quantity.key
        found = by_place.get((quantity, [*ratios][place["ratio"]], angles[place["angle"]]))
        if found is None:
            return Cell(None)
        mark = request.marks.get(found.cell.place)
        tone = tone_of(found.verdict.kind) if mark else ""
        return Cell(printed_cell(found), (mark,) if mark else (), tone)

    return page, Grid(asked.axes, asked.lang, cell)


def _where(cell: SourceCell) -> tuple[str, Fraction, Fraction] | None:
    if not {"ratio", "phi"} <= {*cell.axes}:
        return None
    return cell.quantity, ratio(cell.axes["ratio"]), angle(cell.axes["phi"], "angle")


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
    return kernels(
        WORDS,
        printed=lambda one, request: printed_cell(one),
        recomputed=lambda one, request: recomputed_cell(one),
        difference=lambda one, request: Number(one.off, 0) if one.off else None,
        verdict=lambda one, request: verdict_text(one, request.collated, request.lang),
    )


def _notes(request: CollateRequest) -> Iterator[Note]:
    lang, marks = request.lang, request.marks
    for one in request.deviations if marks else ():
        text = WORDS["entry"][lang].format(
            place=place_label(one, lang),
            printed=f"${one.printed.text.replace(',', '.')}$",
            recomputed=f"${one.recomputed.replace(',', '.')}$",
            difference="–" if one.off is None else f"${one.off:+d}$",
            verdict=verdict_text(one, request.collated, lang),
        )
        yield Note(text, marks[one.cell.place])
    counted = Counter(one.verdict.kind for one in request.collated)
    found = (f"{counted[kind]} {words[lang]}" for kind, words in VERDICTS.items() if counted[kind])
    said = WORDS["one" if len(request.collated) == 1 else "summary"][lang]
    yield Note(said.format(count=len(request.collated), verdicts=", ".join(found)))
    for note in request.table.notes[lang]:
        yield Note(_filled(request, note))
    yield Note(WORDS["units"][lang])
    if request.deviations:
        yield Note(WORDS["careful"][lang])


def _filled(request: CollateRequest, note: Label) -> Label:
    try:
        return filled_note(note, request.collated)
    except ChoiceError as error:
        table = request.table
        raise table.book.file.error(("tables", table.name, "notes", request.lang), error) from None


SUBJECT = Subject(
    key="collation",
    layout="collation",
    command="collate",
    axes={"place": _PlaceAxis, "column": ColumnAxis},
    axis_keys=KEYS,
    own_first=False,
    quantities=quantities,
    listed=tuple,
    number=_shown,
    tone=lambda request, column, place: (
        tone_of(request.shown[place["place"]].verdict.kind) if column.quantity.key == "verdict" else ""
    ),
    caption=titled,
    notes=_notes,
    grid=lambda request: _printed_page(request) if request.as_printed else own_grid(request),
    rows=CollateRequest.records,
    drawn="kurbel.plot.pages:deviations",
)
