"""The worked examples of the books: sources/<book>/<number>.toml has their lines and the steps in them.

A step is a formula of given numbers and other steps, or a quantity of kurbel's by the method of the book. Its
printed value stands in the table of the same number, sources/<book>/<number>.csv: at the place that the
part's `printed` names, else at that of the step's own name. Lines are templates: {path} is a figure of a
step, {-path} the same with the other sign before it.

{half}       a step, or an exact number: 0.125, 1/9
{+c} {-c}    sign and amount: + 0.707; {-c} turns the sign
{(c)}        in parentheses if it is negative or a fraction
"""

from __future__ import annotations

import operator
import os
import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from msgspec import Struct

from kurbel.books.book_values import Expression, TrueValue, formula_truth, kept, quantity_truth
from kurbel.books.printed_value import PrintedValue, printed_value
from kurbel.books.source import SOURCE, Book, SourceTable
from kurbel.drive.at import known
from kurbel.exact.numerals import Label, finite_decimals, nearest, number_text
from kurbel.page.axes import angle_text
from kurbel.page.layouts import Notes, Words
from kurbel.page.quantity import words
from kurbel.reading.given import allowed_name, choose
from kurbel.reading.notation import number, ratio
from kurbel.reading.toml_file import Fault, TomlFile

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sources")


class Line(NamedTuple):
    """A line of the working, with places {step} for its figures.

    `added` tells that the book does not have it, `when` is the condition under which it is needed, such as
    "ratio >= 5/7". A line with what the given numbers do not settle is left out.
    """

    line: Label
    added: bool = False
    when: str = ""


class Lines(tuple[Line, ...]):
    """Lines, in a file texts or tables with line, added and when."""

    @classmethod
    def read(cls, given: Any, _: str) -> Lines:
        try:
            return cls(Line(**({"line": one} if isinstance(one, str) else one)) for one in given)
        except TypeError:
            raise Fault("a list of texts, or of tables with line, added and when") from None


class Step(Struct, frozen=True, forbid_unknown_fields=True):
    """A number of the working: its symbol, a formula or a quantity, perhaps that of a stroke.

    `form` is how it is written where no printed value says so.
    """

    NOUN: ClassVar[str] = "key of a step"

    symbol: Label
    form: str
    formula: str = ""
    quantity: str = ""
    stroke: str = ""


class Part(NamedTuple):
    """A part of an example as the book has it: its numbers, its lines and the printed values of its steps.

    `title` heads the part; `remarks` say of a step what its difference from print is.
    """

    letter: str
    given: Mapping[str, Fraction]
    lines: tuple[Line, ...]
    printed: Mapping[str, PrintedValue]
    remarks: Mapping[str, Words]
    title: Words | None = None


class PartFile(Struct, frozen=True, forbid_unknown_fields=True):
    """A part as the file has it: the numbers that are given are text, and `printed` are places of values."""

    NOUN: ClassVar[str] = "key of a part"

    lines: Lines
    letter: str = ""
    title: Words | None = None
    printed: dict[str, str] | None = None
    remarks: dict[str, Words] = {}
    ratio: str | None = None
    angle: str | None = None
    beam: str | None = None
    eps: str | None = None


class OwnFile(Struct, frozen=True, forbid_unknown_fields=True):
    lines: Lines = Lines()


class ExampleFile(Struct, frozen=True, forbid_unknown_fields=True):
    """What the file says: the steps, and the exact numbers that follow from given ones.

    `takes` names the options that replace the numbers, `own` has the lines for these; without lines the
    book's serve.
    """

    NOUN: ClassVar[str] = "key of an example"

    title: Words
    takes: tuple[str, ...]
    part: tuple[PartFile, ...]
    notes: Notes = Notes()
    numbers: dict[str, str] = {}
    steps: dict[str, Step] = {}
    own: OwnFile = OwnFile()


class Example(NamedTuple):
    """A worked example of a book: what its file says, and its parts. `method` is that of its quantities."""

    source: Book
    number: str
    page: ExampleFile
    method: str
    parts: tuple[Part, ...]


@cache
def source_keys() -> tuple[str, ...]:
    return tuple(sorted(key for key in os.listdir(FOLDER) if numbers_of(key)))


@cache
def numbers_of(key: str) -> tuple[str, ...]:
    """Return the numbers of the examples of a source, in order."""
    names = (os.path.splitext(name) for name in os.listdir(os.path.join(FOLDER, key)))
    return tuple(sorted((stem for stem, suffix in names if suffix == ".toml" and stem != "source"), key=int))


@cache
def source(key: str) -> Book:
    """Return the book of that key; an unknown one is answered with the nearest and the list."""
    return Book(Path(FOLDER, allowed_name(key, source_keys(), "source")))


@cache
def example(key: str, number: str) -> Example:
    """Return an example; an unknown one is answered with the nearest and the list."""
    key = allowed_name(key, source_keys(), "source")
    book = source(key)
    name = choose(number, numbers_of(key), f"example of {key}")
    page = TomlFile(os.path.join(FOLDER, key, f"{name}.toml"), SOURCE).read(ExampleFile)
    table = next((one for one in book.tables if one.name == number), None)
    parts = tuple(_part(table, page.takes, part) for part in page.part)
    return Example(book, number, page, table.method if table else "", parts)


def _part(table: SourceTable | None, takes: tuple[str, ...], part: PartFile) -> Part:
    given = {name: getattr(part, name, None) for name in takes}
    numbers = {name: READERS[name](text) for name, text in given.items() if text is not None}
    found = {cell.place: cell.printed for cell in table.cells if cell.printed} if table else {}
    if part.printed is not None:
        found = {step: found[place] for step, place in part.printed.items()}
    return Part(part.letter, numbers, part.lines, found, part.remarks, part.title)


READERS = {"ratio": ratio, "angle": number, "beam": number, "eps": number}


WORDS: Mapping[str, Mapping[str, str]] = {
    "part": words("Teil|Part"),
    "step": words("Schritt|Step"),
    "difference": words(
        "neu berechnet weniger gedruckt, in Einheiten der letzten Stelle"
        "|recomputed less printed, in units of the last place"
    ),
    "line": words("Rechnung|Working"),
    "symbol": words("Größe|Quantity"),
    "printed": words("gedruckt|printed"),
    "recomputed": words("neu berechnet|recomputed"),
    "computed": words("berechnet|computed"),
    "unusable": words("unbrauchbar|unusable"),
    "and": words("und|and"),
    "printed_source": words("neu berechnet|computed anew"),
    "own_source": words("mit anderen Zahlen|with other numbers"),
    "letters_source": words("neu gesetzt|set anew"),
    "differs": words("weicht ab|differs"),
    "unit": words("weicht um 1 Einheit der letzten Stelle ab|differs by 1 unit of the last place"),
    "units": words(
        "weicht um {units} Einheiten der letzten Stelle ab|differs by {units} units of the last place"
    ),
    "arc": words("weicht um {arc} ab|differs by {arc}"),
    "added": words("[ ] steht nicht im Buch|[ ] is not in the book"),
    "rounded_printed": words(
        "Rechnung mit den gedruckten Zahlen; neu berechnet ist der wahre Wert der Größe, einmal auf die "
        "gedruckten Stellen gerundet"
        "|working with the printed figures; recomputed is the true value of the quantity, rounded once to "
        "the printed places"
    ),
    "rounded_own": words(
        "jede Zahl ist der wahre Wert ihrer Größe, einmal gerundet; aus gerundeten Zahlen einer Zeile kann "
        "eine andere letzte Stelle folgen"
        "|every figure is the true value of its quantity, rounded once; from the rounded figures of a line "
        "another last place may follow"
    ),
}
_PLACE = re.compile(r"\{(?P<sign>[+-]?)(?P<open>\(?)(?P<name>\w+)\)?\}")
# An exact number with more decimals is written as a fraction.
MOST_DECIMALS = 4
INDENT = "\u00a0\u00a0"
CONTINUED = ("$=", "$- ")


class WorkingRow(NamedTuple):
    """A row: the line of the working, and the step that it introduces, if it does."""

    line: Label
    begins: bool
    step: str = ""
    symbol: Label = ""
    printed: PrintedValue | None = None
    recomputed: PrintedValue | None = None
    remark: Label = ""

    @property
    def difference(self) -> int | None:
        """Recomputed less printed in units of the last place; None without one."""
        if self.printed is None or self.recomputed is None or self.printed.exact:
            return None
        return self.recomputed.scaled - self.printed.scaled


# The axes of kurbel's quantities, by the options that give them.
AXES = {"ratio": "ratio", "eps": "epsilon", "back": "back", "beam": "arm"}
_CONDITION = re.compile(r"(?P<left>.+?) (?P<sign><=|>=|!=|<|>|=) (?P<right>.+)")
_SIGNS: Mapping[str, Callable[[Fraction, Fraction], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "=": operator.eq,
    "!=": operator.ne,
}  # fmt: skip


class WorkedPart:
    """A part worked out: its lines with their figures."""

    def __init__(self, example: Example, part: Part, lang: str) -> None:
        self.example = example
        self.part = part
        self.lang = lang
        self.numbers = dict(part.given)
        for name, text in example.page.numbers.items():
            if not (one := self._formula(text)).names:
                self.numbers.setdefault(name, one.fraction())
        steps = example.page.steps.items()
        self.formulas = {name: self._formula(step.formula) for name, step in steps if step.formula}
        self.truths: dict[str, TrueValue] = {}

    def _formula(self, text: str) -> Expression:
        return Expression(text, self.numbers)

    def entries(self) -> Iterator[WorkingRow]:
        shown: set[str] = set()
        for line in self.part.lines:
            names = [*dict.fromkeys(match["name"] for match in _PLACE.finditer(line.line))]
            if not all(map(self._is_settled, names)) or (line.when and not self._holds(line.when)):
                continue
            new = [name for name in names if name in self.example.page.steps and name not in shown]
            shown.update(new)
            text = self._line(line)
            yield self._entry(text, new[0]) if new else WorkingRow(text, True)
            for name in new[1:]:
                yield self._entry(text, name)._replace(begins=False)

    def _is_settled(self, name: str) -> bool:
        """Whether the given numbers settle what a place in a line names."""
        if name in self.formulas:
            return all(map(self._is_settled, self.formulas[name].names))
        return name in self.example.page.steps or name in self.numbers or name in WORDS

    def _holds(self, condition: str) -> bool:
        match = known(_CONDITION.fullmatch(condition))
        left, right = (self._formula(match[side]).fraction() for side in ("left", "right"))
        return _SIGNS[match["sign"]](left, right)

    def _entry(self, text: Label, name: str) -> WorkingRow:
        symbol = f"${filled(self.example.page.steps[name].symbol, self._figure)}$"
        value, printed = self._value(name), self.part.printed.get(name)
        remark = "" if printed is None or printed.value == value.value else self._remark(name, printed, value)
        return WorkingRow(text, True, name, symbol, printed, value, remark)

    def _value(self, name: str) -> PrintedValue:
        """Return the true value of a step in the form in which it is printed."""
        return self._truth(name).written_as(
            self.part.printed.get(name) or printed_value(self.example.page.steps[name].form)
        )

    def _truth(self, name: str) -> TrueValue:
        if name not in self.truths:
            step = self.example.page.steps[name]
            if step.formula:
                truth = formula_truth(self.formulas[name], self._truth)
            else:
                at = {AXES[one]: value for one, value in self.part.given.items()}
                stroke = {"stroke": step.stroke} if step.stroke else {}
                truth = quantity_truth(step.quantity, self.example.method, at | stroke)
            self.truths[name] = kept(truth)
        return self.truths[name]

    def _line(self, line: Line) -> Label:
        text = filled(line.line, self._figure)
        text = f"[{text}]" if line.added else text
        return INDENT + text if text.startswith(CONTINUED) else text

    def _figure(self, name: str) -> str:
        if name in self.example.page.steps:
            return (self.part.printed.get(name) or self._value(name)).in_formula()
        if name == "angle":
            return angle_text(self.part.given[name])
        if name in WORDS:
            return WORDS[name][self.lang]
        return exact_text(self.numbers[name])

    def _remark(self, name: str, printed: PrintedValue, value: PrintedValue) -> Label:
        if name in self.part.remarks:
            return self.part.remarks[name][self.lang]
        if printed.exact:
            return WORDS["differs"][self.lang]
        apart = abs(value.scaled - printed.scaled)
        if printed.form not in (",", "."):
            # Without its degrees of zero: 4'.
            small = str(printed.with_units(apart).cell())
            return WORDS["arc"][self.lang].format(arc=small.replace("$0°", "$").removeprefix("0°"))
        return WORDS["unit" if apart == 1 else "units"][self.lang].format(units=apart)


def filled(text: Label, figure_of: Callable[[str], str]) -> Label:
    """Return the line with its figures; `figure_of` returns the text of a name."""

    def place(match: re.Match[str]) -> str:
        shown = figure_of(match["name"])
        negative = shown.startswith("-")
        amount = shown.removeprefix("-")
        if match["sign"]:
            return f"{'+' if negative == (match['sign'] == '-') else '-'} {amount}"
        return f"({shown})" if match["open"] and (negative or "/" in shown) else shown

    return _PLACE.sub(place, text)


def exact_text(value: Fraction) -> str:
    """Return an exact number for a formula: 5, 0.125, -5/12."""
    decimals = finite_decimals(value)
    if decimals is None or decimals > MOST_DECIMALS:
        return str(value)
    return number_text(nearest(value, decimals))
