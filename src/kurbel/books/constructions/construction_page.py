"""The constructions by their names on the command line, kurbel's own and those in a folder of the user's; and
the page of one: each length that it gives beside its true value, with its steps below."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kurbel.books.constructions.file import HOUSE, read_construction
from kurbel.books.constructions.formulas import Formula as Read
from kurbel.books.constructions.formulas import Values
from kurbel.books.constructions.model import Construction, Length, lettered
from kurbel.books.constructions.placed import ALONE, BesideDrive, PlacedDrive, beside_labels
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, ConstructionError
from kurbel.exact.kind import Kind, floats, settled
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.circle import Numeric
from kurbel.motion.notes import offset_notes
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_text
from kurbel.page.layouts import Folder
from kurbel.page.quantity import Column, Formula, Quantity, Words, entry, filled, for_ratio, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field, Value
from kurbel.reading.given import File, choose
from kurbel.reading.notation import plain

_NAME = r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*"
# Ensslin (1907) names these, too; no text that says their steps was found, so they are not drawn.
UNFOUND: Mapping[str, str] = {
    "mohr": "Mohr",
    "mehmke": "Mehmke",
    "bour-pröll": "Bour and Pröll",
    "bour-proell": "Bour and Pröll",
    "pröll": "Bour and Pröll",
    "proell": "Bour and Pröll",
    "bour": "Bour and Pröll",
}


def unfound(name: object) -> str:
    """Return the sentence for a construction that has no source, nothing for others."""
    author = UNFOUND.get(name.casefold()) if isinstance(name, str) else None
    if author is None:
        return ""
    return (
        f"the construction of {author} is not drawn, for no source that says its steps was found; klein,"
        " rittershaus and autenrieth give the same length"
    )


def construction_names(folder: Folder | None = None) -> tuple[str, ...]:
    """Return the names of kurbel's constructions, and of those in a folder of the user's.

    Raises ConstructionError for a folder that has none.
    """
    own = _names(HOUSE)
    if folder is None:
        return own
    if not os.fspath(folder):
        raise ConstructionError("the folder of constructions has no name; give one, such as figures")
    if not os.path.isdir(folder):
        raise ConstructionError(f"cannot read the constructions {folder}: there is no such folder")
    if not (theirs := _names(folder)):
        raise ConstructionError(f"{folder} has no constructions: no file in it ends in .toml")
    for name in theirs:
        if not re.fullmatch(_NAME, name):
            raise ConstructionError(
                f"{_file(folder, name)}: the file {name[:60]} names it; use letters, digits and -"
            )
    return tuple(dict.fromkeys((*own, *theirs)))


def _names(folder: Folder) -> tuple[str, ...]:
    try:
        files = sorted(name for name in os.listdir(folder) if name.endswith(".toml"))
    except OSError as error:
        raise ConstructionError(f"cannot read the constructions {folder}: {error.strerror}") from None
    return tuple(name.removesuffix(".toml") for name in files)


def _file(folder: Folder, name: str) -> Folder:
    file = os.path.join(str(folder), f"{name}.toml")
    return folder.named(file) if isinstance(folder, File) else file


def construction(name: str, folder: Folder | None = None, mechanism: str = "") -> Construction:
    """Return the construction of that name, as it is of a mechanism, by default the first for which it holds.

    `folder` is one of the user's, whose constructions stand beside kurbel's own and outdo those of their
    names. Raises ChoiceError where there is none of that name, ConstructionError with file and line for one
    that cannot be used.
    """
    if folder is not None and os.path.exists(_file(folder, name)) and name in construction_names(folder):
        return read_construction(_file(folder, name), name, os.path.abspath(folder), mechanism)
    if sentence := unfound(name):
        raise ChoiceError(sentence)
    return _own(choose(name, construction_names(folder), "construction"), mechanism)


@cache
def _own(name: str, mechanism: str) -> Construction:
    return read_construction(_file(HOUSE, name), name, None, mechanism)


DECIMALS = 5
WORDS: Mapping[str, Words] = {
    "length": words("Strecke|Length"),
    "all": words("Die Konstruktion ist genau|The construction is exact"),
    "why": words("{letters} ist genähert: {why}|{letters} is approximate: {why}"),
    "whys": words("{letters} sind genähert: {why}|{letters} are approximate: {why}"),
    "step": words("{number}. {text}|{number}. {text}"),
}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ConstructionRequest(Question):
    """What is asked for: a construction of a drive at a crank angle, or in the position of its book."""

    construction: Construction
    mechanism: Any
    drive: Any
    angle: Fraction | None
    beside: BesideDrive = ALONE

    @cached_property
    def ratios(self) -> tuple[Fraction, ...]:
        return (self.drive.crank.ratio,)

    @property
    def origin(self) -> Label:
        return self.construction.given.source[self.lang]

    @property
    def key(self) -> str:
        return self.label or self.construction.name

    def at(self, kind: Kind) -> PlacedDrive:
        if self.angle is not None:
            return PlacedDrive(self.drive, self.angle, kind, beside=self.beside)
        return PlacedDrive(self.drive, self._near, kind, self.construction.position, self.beside)

    @cached_property
    def _near(self) -> Fraction:
        """The angle of the position, to a float."""
        assert self.construction.position
        pin = PlacedDrive(self.drive, Fraction(0), floats(), self.construction.position).pin
        return Fraction(math.degrees(math.atan2(pin.y, pin.x)))

    @property
    def place(self) -> Label:
        """Where the crank stands, in words; of a beam engine that stands nowhere, its arm."""
        if not (self.construction.given.angle or self.construction.position):
            return f"$a = {plain(getattr(self.drive, 'arm', Fraction(0)))} r$"
        if self.angle is not None:
            return f"${self.construction.given.angle_symbol} = {angle_text(self.angle)}$"
        assert self.construction.position
        return self.construction.position.words[self.lang]

    def drawn(self, length: Length, kind: Kind) -> Numeric:
        """Return a length by the points of the construction."""
        return self._value(length.drawn, kind)

    def true(self, length: Length, kind: Kind) -> Numeric:
        """Return its true value by the kernel."""
        return self._value(length.true, kind)

    def _value(self, formula: Read, kind: Kind) -> Numeric:
        found: Numeric = formula.value(Values(self.at(kind), self.construction.formulas))
        return found


def _number(request: ConstructionRequest, column: Column, place: Place, times: int = 1) -> Value:
    length, key = request.construction.lengths[place["length"]], column.quantity.key
    told = column.quantity.formulas["exact"].kernel
    if column.quantity.decimals is None:
        return request.construction.overlined(told(request, length))
    if key == "error" and length.approximate is None:
        return Number(0, 0)
    found = settled(
        lambda kind: times * told(request, length, kind) * (180 / kind.pi if length.is_arc else 1),
        column.places,
        request.rounding,
    )
    return Number(found, column.places)


def _formula(request: ConstructionRequest, length: Length) -> Label:
    """Return the book's formula of a length, or that of the offset crank."""
    return (request.drive.crank.offset and length.offset_formula) or length.formula


def _error(request: ConstructionRequest, length: Length, kind: Kind) -> Numeric:
    return request.drawn(length, kind) - request.true(length, kind)


def _told(
    key: str, name: str, heading: str, kernel: Callable[..., object], decimals: int | None = None
) -> Quantity:
    """Return what is said of a length: a label, or a number on a kind of number."""
    return entry(key, name, "", "", decimals, {"exact": Formula(kernel)}, heading)


@cache
def registry() -> Mapping[str, Quantity]:
    """Return what is said of a length, by its key."""
    asked = ConstructionRequest
    found = (
        _told("symbol", "Bedeutung|Meaning", "bedeutet|stands for", lambda request, length: length.symbol),
        _told("formula", "Formel|Formula", "Formel|Formula", _formula),
        _told("drawn", "Länge der Zeichnung|Length drawn", "gezeichnet|drawn", asked.drawn, DECIMALS),
        _told("true", "wahrer Wert|True value", "wahr|true", asked.true, DECIMALS),
        _told("error", "Abweichung|Error", "Abweichung|error", _error, DECIMALS),
        _told("unit", "Einheit|Unit", "Einheit|unit", lambda request, length: length.unit),
    )
    return {one.key: one for one in found}


def _lengths(request: ConstructionRequest) -> ListAxis:
    field = Field("length", WORDS["length"][request.lang])
    lengths = request.construction.lengths
    return ListAxis(lengths, field, _written, _written)


def _written(length: Length) -> Label:
    return lettered(length.letters)


def _has_ratio(request: ConstructionRequest) -> bool:
    return "ratio" in request.mechanism.takes


def caption(request: ConstructionRequest) -> Label:
    """Return what the construction is of."""
    lang = request.lang
    ratio, symbol = request.drive.crank.ratio, request.construction.given.ratio_symbol
    parts = {
        "{construction}": request.construction.given.title[lang],
        "{for_ratio}": for_ratio(ratio, lang, symbol) if _has_ratio(request) else "",
        "{place}": request.place,
    }
    return filled(request.layout.caption[lang], parts.items())


def _notes(request: ConstructionRequest) -> Iterator[Label]:
    lang, shown = request.lang, request.construction
    for number, step in enumerate(shown.steps, 1):
        yield shown.overlined(WORDS["step"][lang].format(number=number, text=step.text[lang]))
    doubtful: dict[str, list[Label]] = {}
    for one in shown.lengths:
        if one.approximate is not None:
            doubtful.setdefault(one.approximate[lang], []).append(lettered(one.letters))
    for why, letters in doubtful.items():
        said = WORDS["why" if len(letters) == 1 else "whys"][lang]
        yield shown.overlined(said.format(letters=", ".join(letters), why=why))
    if not doubtful:
        yield WORDS["all"][lang]
    yield from _drive_notes(request)
    yield from beside_labels(request.beside, shown.given.takes, lang)
    for note in shown.given.notes:
        yield shown.overlined(note[lang])


def _drive_notes(request: ConstructionRequest) -> Iterator[Label]:
    """Yield what is said of the dead centres where they do not lie at 0 and 180°."""
    if isinstance(request.drive, Crank):
        yield from offset_notes((request.drive,), request.lang)
    elif not _has_ratio(request):
        yield from filter(None, [", ".join(request.mechanism.lengths(request.drive))])
    elif request.drive.at_end:
        from kurbel.linkage.arc_mechanism import MECHANISM

        yield MECHANISM.dead_centres(request.drive, request.lang)


SUBJECT = Subject(
    key="construction",
    layout="construction",
    command="construct",
    axes={"length": _lengths, "column": ColumnAxis},
    axis_keys=("length",),
    quantities=registry,
    number=_number,
    caption=caption,
    notes=_notes,
)
