"""A worked example becomes a table: a line of the working a row, its figures beside it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import prod

from kurbel.books.book_values import engine_turn
from kurbel.books.example import WORDS, Example, Part, WorkedPart, WorkingRow, exact_text, example
from kurbel.books.printed_value import PrintedValue
from kurbel.drive.crank import Crank, check_angles
from kurbel.drive.load import PistonForce
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.linkage.beam_engine import BeamEngine
from kurbel.page.axes import angle_text
from kurbel.page.layouts import LANGUAGES
from kurbel.page.table import (
    DITTO,
    Cell,
    Column,
    Field,
    Group,
    Note,
    Panel,
    Records,
    Row,
    Table,
    Value,
    Worded,
    check_label,
)
from kurbel.reading.given import choose
from kurbel.reading.notation import about, plain, ratio_text

MOST = 100
# Of the records.
KEYS = ("part", "line", "step", "symbol", "printed", "recomputed", "difference")
MARKS = "abcdefghijklmnoprstuvwxyz"
SYMBOLS = {"angle": "α", "beam": "a:r", "force": "F", "eps": "ε", "back": "R:Q"}
GIVEN_TEXTS: Mapping[str, Callable[[Fraction], str]] = {
    "ratio": ratio_text,
    "angle": angle_text,
    "beam": exact_text,
    "force": lambda value: f'{plain(value)} "N"',
    "eps": exact_text,
    "back": exact_text,
}
# What a page shows: the book's figures, those of other numbers, or letters alone.
PRINTED, OWN, LETTERS = "printed", "own", "letters"
# The columns of each, and the words over them.
COLUMNS: Mapping[str, tuple[tuple[str, str], ...]] = {
    PRINTED: (("symbol", "symbol"), ("printed", "printed"), ("recomputed", "recomputed")),
    OWN: (("symbol", "symbol"), ("recomputed", "computed")),
    LETTERS: (),
}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ExampleRequest(Worded):
    """What is asked for: an example, with numbers of one's own by option where they are given."""

    book: str
    number: str
    own: Mapping[str, Sequence[Fraction]]
    lang: str = "de"
    label: str = ""

    def __post_init__(self) -> None:
        choose(self.lang, LANGUAGES, "language")
        check_label(self.label)
        for name in self.own:
            if name not in self.example.page.takes:
                takes = ", ".join(self.example.page.takes)
                raise ProblemError(
                    f"example {self.book} {self.number} takes no {name} of your own; it takes {takes}"
                )
        count = prod(max(len(values), 1) for values in self.own.values())
        if count > MOST:
            raise ProblemError(f"that makes {count} examples; at most {MOST} are printed at once")
        for part in self.parts:
            _check(part.given)

    @cached_property
    def example(self) -> Example:
        return example(self.book, self.number)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The parts of the book, or those of one's own numbers; the book's where it has the same ones."""
        if not self.own:
            return self.example.parts
        return tuple(part for given in self._given() for part in self._parts(given))

    def _given(self) -> Iterator[dict[str, Fraction]]:
        """Yield the numbers in all combinations, the book's where there are none of one's own."""
        choices = {name: self.own.get(name) or self._known(name) for name in self.example.page.takes}
        names = [name for name, values in choices.items() if values]
        for values in product(*(choices[name] for name in names)):
            yield dict(zip(names, values, strict=True))

    def _known(self, name: str) -> tuple[Fraction, ...]:
        return tuple(dict.fromkeys(part.given[name] for part in self.example.parts if name in part.given))

    def _parts(self, given: Mapping[str, Fraction]) -> tuple[Part, ...]:
        """Return the parts that these numbers make: the book's own, or the way for other numbers."""
        same = tuple(part for part in self.example.parts if part.given == given)
        if same:
            return same
        if self.example.page.own.lines:
            return (Part("", given, self.example.page.own.lines, {}, {}),)
        return tuple(part._replace(given=given, printed={}) for part in self.example.parts)


def _check(given: Mapping[str, Fraction]) -> None:
    """Raise ProblemError for numbers that no crank may have or that the books' ways cannot take."""
    if "ratio" in given:
        Crank(given["ratio"])
        if not given["ratio"]:
            raise ProblemError("the worked examples are of a finite rod; give a ratio such as 1:5")
    if "angle" in given:
        check_angles([given["angle"]])
    if "beam" in given:
        BeamEngine(given["beam"], given["ratio"])
    if "eps" in given:
        _check_steam(given)
    if "force" in given:
        if "ratio" not in given:
            raise ProblemError("a force becomes newtons with a ratio only; add one, such as 1:5")
        Crank(given["ratio"], force=PistonForce(given["force"]))


def _check_steam(given: Mapping[str, Fraction]) -> None:
    """Raise ProblemError where the equation of § 150 for α₂ does not hold."""
    if given["eps"] <= 1:
        raise ProblemError("the way of § 150 is for expanding steam; give an expansion ratio above 1")
    turn = engine_turn(given["ratio"], given["eps"], given.get("back"), "weisbach")
    if not turn.expands_first:
        raise ProblemError(
            f"at ε = {about(given['eps'])} the speed is greatest before the cut-off, where the equation of"
            " § 150 for α₂ does not hold; give a larger expansion ratio"
        )


def build_example(request: ExampleRequest) -> Table:
    """Return the table of the example that was asked for."""
    lang, example = request.lang, request.example
    worked = [tuple(WorkedPart(example, part, lang).entries()) for part in request.parts]
    remarks = dict.fromkeys(entry.remark for part in worked for entry in part if entry.remark)
    marks = {remark: MARKS[place] for place, remark in enumerate(remarks)}
    kind = _kind(request, worked)
    # "neu berechnet" is wider than its figures.
    columns = [Column(key, tuple(WORDS[word][lang].split())) for key, word in COLUMNS[kind]]
    groups = tuple(
        Group(tuple(_row(entry, columns, marks) for entry in entries), _part_label(request, part))
        for part, entries in zip(request.parts, worked, strict=True)
    )
    page = Table(
        key=request.label or f"{request.book}-{request.number}",
        lang=lang,
        caption=_caption(request),
        panels=(Panel((Column("line", (WORDS["line"][lang],)),), tuple(columns), groups),),
        records=_records(request, worked),
        notes=tuple(_notes(request, marks, kind)),
        source=_source(request, kind),
        templates=(os.fspath(request.templates),) if request.templates else (),
    )
    return request.worded(page)


def _kind(request: ExampleRequest, worked: Sequence[Sequence[WorkingRow]]) -> str:
    if any(part.printed for part in request.parts):
        return PRINTED
    return OWN if any(entry.step for part in worked for entry in part) else LETTERS


def _row(entry: WorkingRow, columns: Sequence[Column], marks: Mapping[Label, str]) -> Row:
    notes = (marks[entry.remark],) if entry.remark else ()
    cells = {
        "symbol": Cell(entry.symbol),
        "printed": _cell(entry, entry.printed),
        "recomputed": _cell(entry, entry.recomputed, notes),
    }
    stub = Cell(entry.line if entry.begins else DITTO)
    return Row((stub,), tuple(cells[column.key] for column in columns))


def _cell(entry: WorkingRow, figure: PrintedValue | None, notes: tuple[str, ...] = ()) -> Cell:
    """Return the cell of a figure: blank in a line without a new one, missing where it is not printed."""
    if not entry.step:
        return Cell("")
    return Cell(None if figure is None else figure.cell(), notes)


def _varied(request: ExampleRequest) -> list[str]:
    """Return the options whose numbers differ between the parts."""
    numbers = {name: {part.given.get(name) for part in request.parts} for name in request.example.page.takes}
    return [name for name, values in numbers.items() if len(values) > 1]


def _given_text(example: Example, part: Part, names: Sequence[str]) -> Label:
    symbols = {**SYMBOLS, "ratio": example.source.given.ratio}
    return ", ".join(f"${symbols[name]} = {GIVEN_TEXTS[name](part.given[name])}$" for name in names)


def _part_label(request: ExampleRequest, part: Part) -> Label:
    title = part.title[request.lang] if part.title else ""
    text = ", ".join(filter(None, (title, _given_text(request.example, part, _varied(request)))))
    return f"{part.letter}) {text}".rstrip() if part.letter else text


def _caption(request: ExampleRequest) -> Label:
    example, lang = request.example, request.lang
    part, varied = request.parts[0], _varied(request)
    common = _given_text(example, part, [name for name in part.given if name not in varied])
    book = example.source.given
    head = f"{book.name}, {book.example[lang]} {example.number}: {example.page.title[lang]}"
    return f"{head}; {common}" if common else head


def _notes(request: ExampleRequest, marks: Mapping[Label, str], kind: str) -> Iterator[Note]:
    lang = request.lang
    for remark, mark in marks.items():
        yield Note(remark, mark)
    for note in request.example.page.notes:
        yield Note(note[lang])
    if kind == PRINTED:
        yield Note(WORDS["rounded_printed"][lang])
    if kind != LETTERS and not all(part.printed for part in request.parts):
        yield Note(WORDS["rounded_own"][lang])
    if any(line.added for part in request.parts for line in part.lines):
        yield Note(WORDS["added"][lang])


def _source(request: ExampleRequest, kind: str) -> Label:
    example, lang = request.example, request.lang
    book = example.source.given
    place = f"{book.citation[lang]}, {book.example[lang]}\u00a0{example.number}"
    return f"{place}; {WORDS[kind + '_source'][lang]}."


def _records(request: ExampleRequest, worked: Sequence[Sequence[WorkingRow]]) -> Records:
    lang = request.lang
    rows = [
        _record(part.letter or _part_label(request, part), entry)
        for part, entries in zip(request.parts, worked, strict=True)
        for entry in entries
    ]
    return Records(tuple(Field(key, WORDS[key][lang]) for key in KEYS), rows)


def _record(part: Label, entry: WorkingRow) -> tuple[Value, ...]:
    printed, recomputed = (None if one is None else one.cell() for one in (entry.printed, entry.recomputed))
    difference = None if entry.difference is None else Number(entry.difference, 0)
    return part, entry.line.strip(), entry.step, entry.symbol, printed, recomputed, difference
