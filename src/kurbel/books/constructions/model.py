"""A construction as data: points, the steps that draw them, and the lengths that are read off."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Annotated, Any, ClassVar, NamedTuple, TypeAlias

from kurbel.books.constructions.formula_names import POINT
from kurbel.books.constructions.formulas import Formula, Values
from kurbel.books.constructions.placed import PlacedDrive, Point, Position
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.page.layouts import Head
from kurbel.page.quantity import Words
from kurbel.reading.toml_file import about, within

# A letter with what belongs to it: d', C_1, C_0'.
_LETTER = re.compile(r"[^\W\d_](?:_?\d+)?'*")
# Letters one after the other with a space between, and a formula in a label.
_BESIDE = re.compile(rf"(?<![\w(]){_LETTER.pattern}(?: {_LETTER.pattern})+(?![\w(])")
_FORMULA = re.compile(r"\$[^$]+\$")
DEGREES = "°"
Texts = tuple[str, ...]

# What a line is: a link of the drive, one that is given, one that is drawn to find another, a centre line,
# a hidden one, the result.
LINK, GIVEN, AID, CENTRE, HIDDEN, RESULT = "link", "given", "aid", "centre", "hidden", "result"


class Line(NamedTuple):
    """A straight line between two points; with `beyond` it is drawn so much longer, in mm, at both ends. Its
    symbol stands beside it, if it has one."""

    start: str
    end: str
    look: str = AID
    beyond: float = 0.0
    symbol: Label = ""


class Arrow(NamedTuple):
    """A vector, with its symbol beside it."""

    start: str
    end: str
    symbol: Label = ""
    look: str = RESULT


class Arc(NamedTuple):
    """An arc of a circle about a point from one point to another, the shorter way; drawn further by so many
    mm at both ends."""

    centre: str
    start: str
    end: str
    look: str = AID
    beyond: float = 3.0


class Circle(NamedTuple):
    """A whole circle about a point through another."""

    centre: str
    through: str
    look: str = AID


class RightAngle(NamedTuple):
    """The mark of a right angle at a corner between the ways to two points."""

    corner: str
    one: str
    other: str


class Angle(NamedTuple):
    """An angle at a corner between the ways to two points, with its symbol.

    It is the smaller one, or with a `sense` that from the first way to the other as the crank turns (1) or
    against it (-1), with an arrow at its end. `at` is the share of the shorter way at which its arc lies,
    however small the angle is.
    """

    corner: str
    one: str
    other: str
    symbol: Label
    sense: int = 0
    at: float | None = None


class Curve(NamedTuple):
    """A line through many points, one of the curves of the construction by its name."""

    name: str
    look: str = AID


class Text(NamedTuple):
    """A text beside a point that has no letter."""

    at: str
    text: Label


class Scale(NamedTuple):
    """A line that is as long as its symbol, to tell the scale."""

    start: str
    end: str
    symbol: Label


class Dimension(NamedTuple):
    """The dimension of a length: where it lies (level 0), or on a row below (-1, -2) or above (1, 2) all that
    is drawn. One that is not `written` has its line alone."""

    letters: str
    level: int = 0
    look: str = RESULT
    written: bool = True


Element: TypeAlias = Line | Arrow | Arc | Circle | RightAngle | Angle | Curve | Text | Scale | Dimension


class Step(NamedTuple):
    """A step: what is done, in a sentence, the lines that it draws, and the points that have their letters
    from here on."""

    text: Words
    drawn: Sequence[Element] = ()
    points: Sequence[str] = ()


class Length(NamedTuple):
    """A length that is read off the drawing, by the letters of its ends, "ad".

    `symbol` is what it stands for and `formula` how the book computes it, labels. `drawn` is the number by
    the points and `true` that by the kernel, both in `unit`. `approximate` tells why they differ, nothing
    where the construction is exact. An offset crank has the `offset_formula`, if that is another.
    """

    letters: str
    ends: tuple[str, str]
    symbol: Label
    formula: Label
    drawn: Formula
    true: Formula
    unit: str
    approximate: Words | None = None
    offset_formula: Label = ""

    @property
    def is_arc(self) -> bool:
        """Whether it is an arc, in radians and printed in degrees."""
        return self.unit == DEGREES


class Points(NamedTuple):
    """A curve through points: those of a formula, at so many equal steps of a number from one to another.

    Over the `turn` the number is the crank angle, at which the drive then stands. Of those the places alone
    count where a number is the `same` as at the angle that is drawn; `down_to` closes the line to an area
    above a height.
    """

    at: Formula
    turn: bool
    start: Fraction
    end: Fraction
    steps: int
    same: Formula | None = None
    down_to: Formula | None = None


class FailureRule(NamedTuple):
    """Where a construction has no points, and the sentence that says so."""

    where: Formula
    why: str


@dataclass(frozen=True, kw_only=True)
class StepFile:
    """A step."""

    NOUN: ClassVar[str] = "key of a step"

    de: Annotated[str, about("what is done, in German", example="Lot von $C$ auf $O A$")]
    en: Annotated[str, about("what is done, in English", example="Perpendicular from $C$ to $O A$")]
    draw: Annotated[str, about('what is drawn, parted by semicolons: "line C F; square F C O"')] = ""
    points: Annotated[str, about("points that have their letters from here on")] = ""


@dataclass(frozen=True, kw_only=True)
class LengthFile:
    """A length that is read off."""

    NOUN: ClassVar[str] = "key of a length"

    ends: Annotated[str, about("the points between which it lies", example="C F")]
    true: Annotated[str, about("the number that it is to be", example="sine")]
    drawn: Annotated[str, about("how it is measured, from `first` to `last`; default: their distance")] = (
        "distance(first, last)"
    )
    letters: Annotated[str, about("what it is called; default: its ends")] = ""
    symbol: Annotated[str, about("what it stands for")] = ""
    formula: Annotated[str, about("how the book computes it")] = ""
    offset_formula: Annotated[str, about("that of the offset crank, if it is another")] = ""
    unit: Annotated[str, about("its unit; default: $R$")] = "$R$"
    approximate: Annotated[Head | None, about("why it is not exact")] = None


@dataclass(frozen=True, kw_only=True)
class CurveFile:
    """A curve."""

    NOUN: ClassVar[str] = "key of a curve"

    at: Annotated[str, about("its points, by the number t", example="(t, t^2)")]
    start: Annotated[str, about("the first t; without it t is the crank angle, over the turn")] = ""
    end: Annotated[str, about("the last t")] = "360"
    steps: Annotated[Annotated[int, within(1, 1000)], about("into how many parts it goes")] = 360
    same: Annotated[str, about("a number that is to be as at the angle drawn")] = ""
    down_to: Annotated[str, about("the height above which it encloses an area")] = ""


@dataclass(frozen=True, kw_only=True)
class FailsFile:
    """Where there are no points."""

    where: Annotated[str, about("a comparison", example="sine == 0")]
    why: Annotated[str, about("the sentence that says so", example="at a dead centre there is no triangle")]


@dataclass(frozen=True, kw_only=True)
class PositionFile:
    """A position of the straight crank that no angle says."""

    pin: Annotated[str, about("where the crank pin is, by ratio and rod", example="(0, 1)")]
    de: Annotated[str, about("the position in German", example="die Kurbel steht senkrecht")]
    en: Annotated[str, about("the position in English", example="the crank stands upright")]


@dataclass(frozen=True, kw_only=True)
class ConstructionFile:
    """A construction as a file says it."""

    NOUN: ClassVar[str] = "key of a construction"

    title: Annotated[Head, about("its title", example="Kolbenweg nach mir|Piston path, after me")]
    points: Annotated[str, about("the points, NAME = FORMULA on a line each", example="C = pin")]
    given: Annotated[str, about("formulas before those that are shared")] = ""
    steps: Annotated[tuple[StepFile, ...], about("the steps", example=[{"de": "Kurbel", "en": "Crank"}])]
    lengths: Annotated[
        tuple[LengthFile, ...], about("lengths read off", example=[{"ends": "C F", "true": "sine"}])
    ]
    source: Annotated[Head, about("the book")] = field(default_factory=lambda: Head(Head.texts("")))
    holds: Annotated[Texts, about("the mechanisms for which it holds; default: straight")] = ("straight",)
    refusal: Annotated[str, about("the sentence that refuses others")] = ""
    fails: Annotated[tuple[FailsFile, ...], about("where it has no points")] = ()
    mirrored: Annotated[bool, about("whether the crosshead is on the left")] = False
    angle: Annotated[str, about('crank angle where none is given; "" for none')] = "50"
    angle_symbol: Annotated[str, about("letter of the crank angle")] = "φ"
    ratio_symbol: Annotated[str, about("letters of the crank ratio")] = "R:L"
    notes: Annotated[tuple[Head, ...], about("lines below the table")] = ()
    position: Annotated[PositionFile | None, about("what is drawn where no angle is given")] = None
    scales: Annotated[dict[str, str], about("units, and how long they are drawn, in R")] = field(
        default_factory=dict
    )
    curves: Annotated[dict[str, CurveFile], about("curves by their names")] = field(default_factory=dict)
    takes: Annotated[Texts, about("options that it takes beside the drive")] = ()
    usual: Annotated[dict[str, str], about("what its book has of the drive")] = field(default_factory=dict)


class Construction(NamedTuple):
    """A construction of one mechanism: what its file says of it, as `given`, and what is made of that.

    `formulas` has the points and, by names that begin with _, what they are found by. `position` is what is
    drawn of a straight crank where no angle is given. `scales` are the units that are drawn longer or shorter
    than R, in R. `folder` is the user's own in which the file lies.
    """

    name: str
    mechanism: str
    given: ConstructionFile
    formulas: Mapping[str, Formula]
    steps: Sequence[Step]
    lengths: Sequence[Length]
    curves: Mapping[str, Points]
    fails: Sequence[FailureRule]
    position: Position | None
    scales: Mapping[str, Fraction]
    folder: Any = None

    def __reduce__(self) -> tuple[object, ...]:
        return _named, (self.name, self.folder, self.mechanism)

    def of(self, mechanism: str) -> Construction:
        """Return the construction as it is of a mechanism for which it holds."""
        return self if mechanism == self.mechanism else _named(self.name, self.folder, mechanism)

    def overlined(self, label: Label) -> Label:
        """Return a label in which two letters of points beside each other are the length between them."""
        return overlined(label, (letter.rstrip("*") for step in self.steps for letter in step.points))

    def fault(self, at: PlacedDrive) -> str:
        """Return the sentence that says why the construction has no points there, in floats; nothing where it
        has."""
        values = Values(at, self.formulas)
        for one in self.fails:
            if one.where.value(values):
                return one.why
        lengths = {length.letters: length.drawn for length in self.lengths}
        true = {f"true {length.letters}": length.true for length in self.lengths}
        for name, formula in {**self.formulas, **lengths, **true}.items():
            if not _is_there(formula, values):
                return self._missing(name)
        return ""

    def _missing(self, name: str) -> str:
        return (
            f"construction {self.name} has no {name} here: its formula divides by zero, or takes the root of"
            " a negative number; take another angle or other lengths"
        )

    def points(self, at: PlacedDrive) -> Mapping[str, Point]:
        """Return the points by their letters, as the book writes them: "C", "d'"."""
        values = Values(at, self.formulas)
        return {name: values[name] for name in self.formulas if not name.startswith("_")}

    def curve(self, name: str, at: PlacedDrive) -> list[Point]:
        """Return the points of one of its curves, in floats."""
        curve, here = self.curves[name], Values(at, self.formulas)
        numbers = (
            curve.start + (curve.end - curve.start) * Fraction(n, curve.steps) for n in range(curve.steps + 1)
        )
        places = [
            Values(replace(at, angle=number % 360) if curve.turn else at, self.formulas, t=float(number))
            for number in numbers
        ]
        if not all(_is_there(curve.at, place) for place in places):
            raise ProblemError(self._missing(f"curve {name}"))
        if same := curve.same:
            places = [place for place in places if same.value(place) == same.value(here)]
        found = [curve.at.value(place) for place in places]
        if curve.down_to is None:
            return found
        found.sort()
        low = curve.down_to.value(here)
        first, last = Point(found[0].x, low), Point(found[-1].x, low)
        return [first, *found, last, first]


def _is_there(formula: Formula, values: Values) -> bool:
    """Return whether the formula has a value in floats."""
    try:
        found = formula.value(values)
        return all(map(math.isfinite, found if formula.gives == POINT else (found,)))
    except (ArithmeticError, ValueError):
        return False


def _named(name: str, folder: Any, mechanism: str) -> Construction:
    from kurbel.books.constructions.construction_page import construction

    return construction(name, folder, mechanism)


def lettered(letters: str) -> Label:
    """Return the letters of points as a formula: "ad'" is the length $overline(a d')$, "C" is $C$."""
    found = _LETTER.findall(letters)
    return f"$overline({' '.join(found)})$" if len(found) == 2 else f"${' '.join(found)}$"


def overlined(label: Label, points: Iterable[str]) -> Label:
    """Return a label in whose formulas two letters of points beside each other are a length, with a bar.

    "$a d = x$" becomes "$overline(a d) = x$". More than two letters, as of a triangle, stay as they are.
    """
    known = frozenset(points)

    def length(found: re.Match[str]) -> str:
        letters = found[0].split()
        return f"overline({found[0]})" if len(letters) == 2 and known.issuperset(letters) else found[0]

    def formula(found: re.Match[str]) -> str:
        return found[0] if "overline" in found[0] else _BESIDE.sub(length, found[0])

    return _FORMULA.sub(formula, label)
