"""A worked example becomes a table: line by line, each new figure as printed and as it is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product

from kurbel.choices import choose
from kurbel.errors import ProblemError
from kurbel.example_figures import Figure
from kurbel.example_source import Example, Part, example
from kurbel.example_words import WORDS
from kurbel.example_working import Entry, Working, angle_text
from kurbel.layouts import LANGUAGES
from kurbel.notation import ratio_text
from kurbel.problem import Crank, check_angles
from kurbel.request import check_label
from kurbel.table import (
    DITTO,
    Cell,
    Column,
    Field,
    Group,
    Label,
    Note,
    Number,
    Panel,
    Records,
    Row,
    Table,
    Value,
)

KEYS = ("part", "line", "step", "symbol", "printed", "recomputed", "difference")
MARKS = "abcdefghijklmnoprstuvwxyz"


@dataclass(frozen=True, kw_only=True)
class ExampleRequest:
    """What is asked for: an example, with numbers of one's own by option where they are given."""

    source: str
    number: str
    own: Mapping[str, Sequence[Fraction]]
    lang: str = "de"
    label: str = ""

    def __post_init__(self) -> None:
        choose(self.lang, LANGUAGES, "language")
        check_label(self.label)
        for name in self.own:
            if name not in self.example.takes:
                takes = ", ".join(self.example.takes)
                raise ProblemError(
                    f"example {self.source} {self.number} takes no {name} of your own; it takes {takes}"
                )
        for part in self.parts:
            _check(part.given)

    @cached_property
    def example(self) -> Example:
        return example(self.source, self.number)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The parts of the book, or those of one's own numbers; the book's where it has the same ones."""
        known = self.example.parts
        if not self.own:
            return known
        choices = [
            self.own.get(name) or dict.fromkeys(part.given[name] for part in known)
            for name in self.example.takes
        ]
        given = (dict(zip(self.example.takes, values, strict=True)) for values in product(*choices))
        return tuple(self._part(numbers) for numbers in given)

    def _part(self, given: Mapping[str, Fraction]) -> Part:
        same = (part for part in self.example.parts if part.given == given)
        return next(same, Part("", given, self.example.own, {}, {}))


def _check(given: Mapping[str, Fraction]) -> None:
    """Raise ProblemError for numbers that no crank may have or that the books' ways cannot take."""
    if "ratio" in given:
        Crank(given["ratio"])
        if not given["ratio"]:
            raise ProblemError("the worked examples divide by R:L; give a finite rod, such as 1:5")
    if "angle" in given:
        check_angles([given["angle"]])


GIVEN_TEXTS = {
    "ratio": lambda value: f"R:L = {ratio_text(value)}",
    "angle": lambda value: f"α = {angle_text(value)}",
}


def build_example(request: ExampleRequest) -> Table:
    """Return the table of the example that was asked for."""
    lang, example = request.lang, request.example
    worked = [tuple(Working(example, part, lang).entries()) for part in request.parts]
    remarks = dict.fromkeys(entry.remark for part in worked for entry in part if entry.remark)
    marks = {remark: MARKS[place] for place, remark in enumerate(remarks)}
    is_printed = any(part.printed for part in request.parts)
    columns = _columns(worked, is_printed, lang)
    groups = tuple(
        Group(tuple(_row(entry, columns, marks) for entry in entries), _part_label(request, part))
        for part, entries in zip(request.parts, worked, strict=True)
    )
    return Table(
        key=request.label or f"{request.source}-{request.number}",
        lang=lang,
        caption=_caption(request),
        panels=(Panel((Column("line", (WORDS["line"][lang],)),), columns, groups),),
        records=_records(request, worked),
        notes=tuple(_notes(request, marks, is_printed)),
        source=_source(request, is_printed),
    )


def _columns(worked: Sequence[Sequence[Entry]], is_printed: bool, lang: str) -> tuple[Column, ...]:
    recomputed = WORDS["recomputed" if is_printed else "computed"][lang]
    keys = {
        "symbol": (WORDS["symbol"][lang],),
        "printed": (WORDS["printed"][lang],),
        "recomputed": tuple(recomputed.split()),
    }
    if not is_printed:
        del keys["printed"]
    return tuple(Column(key, heading) for key, heading in keys.items())


def _row(entry: Entry, columns: Sequence[Column], marks: Mapping[Label, str]) -> Row:
    notes = (marks[entry.remark],) if entry.remark else ()
    cells = {
        "symbol": Cell(entry.symbol),
        "printed": _cell(entry, entry.printed),
        "recomputed": _cell(entry, entry.recomputed, notes),
    }
    stub = Cell(entry.line if entry.begins else DITTO)
    return Row((stub,), tuple(cells[column.key] for column in columns))


def _cell(entry: Entry, figure: Figure | None, notes: tuple[str, ...] = ()) -> Cell:
    """Return the cell of a figure: blank in a line without a new one, missing where it is not printed."""
    if not entry.step:
        return Cell("")
    return Cell(None if figure is None else figure.cell(), notes)


def _varied(request: ExampleRequest) -> list[str]:
    """Return the options whose numbers differ between the parts."""
    return [name for name in request.example.takes if len({part.given[name] for part in request.parts}) > 1]


def _given_text(part: Part, names: Sequence[str]) -> Label:
    return ", ".join(f"${GIVEN_TEXTS[name](part.given[name])}$" for name in names)


def _part_label(request: ExampleRequest, part: Part) -> Label:
    text = _given_text(part, _varied(request))
    return f"{part.letter}) {text}".strip() if part.letter else text


def _caption(request: ExampleRequest) -> Label:
    example, lang = request.example, request.lang
    varied = _varied(request)
    common = _given_text(request.parts[0], [name for name in example.takes if name not in varied])
    head = f"{example.source.name}, {example.source.example[lang]} {example.number}: {example.title[lang]}"
    return f"{head}; {common}" if common else head


def _notes(request: ExampleRequest, marks: Mapping[Label, str], is_printed: bool) -> Iterator[Note]:
    lang = request.lang
    for remark, mark in marks.items():
        yield Note(remark, mark)
    for note in request.example.notes:
        yield Note(note[lang])
    yield Note(WORDS["rounded_printed" if is_printed else "rounded_own"][lang])
    if any(line.added for part in request.parts for line in part.lines):
        yield Note(WORDS["added"][lang])


def _source(request: ExampleRequest, is_printed: bool) -> Label:
    example, lang = request.example, request.lang
    what = WORDS["anew" if is_printed else "own"][lang]
    return f"{example.source.citation[lang]}, {example.source.example[lang]} {example.number}; {what}."


def _records(request: ExampleRequest, worked: Sequence[Sequence[Entry]]) -> Records:
    lang = request.lang
    rows = [
        _record(part.letter or _part_label(request, part), entry)
        for part, entries in zip(request.parts, worked, strict=True)
        for entry in entries
    ]
    return Records(tuple(Field(key, WORDS[key][lang]) for key in KEYS), rows)


def _record(part: Label, entry: Entry) -> tuple[Value, ...]:
    printed, recomputed = (None if one is None else one.cell() for one in (entry.printed, entry.recomputed))
    difference = None if entry.difference is None else Number(entry.difference, 0)
    return part, entry.line.strip(), entry.step, entry.symbol, printed, recomputed, difference
