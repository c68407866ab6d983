"""A construction as data: points, the steps that draw them, and the lengths that are read off."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

from kurbel.books.constructions.beside import ALONE, Beside
from kurbel.books.constructions.geometry import Point, distance
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import root
from kurbel.page.quantity import Words

# A letter with what belongs to it: d', C_1, C_0'.
_LETTER = re.compile(r"[^\W\d_](?:_?\d+)?'*")
# Letters one after the other with a space between, and a formula in a label.
_BESIDE = re.compile(rf"(?<![\w(]){_LETTER.pattern}(?: {_LETTER.pattern})+(?![\w(])")
_FORMULA = re.compile(r"\$[^$]+\$")
# The points of a construction by their letters, as the book writes them: "C", "d'".
Points: TypeAlias = Mapping[str, Point]

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


class Measure(NamedTuple):
    """The dimension of a length: where it lies (level 0), or on a row below (-1, -2) or above (1, 2) all that
    is drawn. One that is not `written` has its line alone."""

    letters: str
    level: int = 0
    look: str = RESULT
    written: bool = True


Element: TypeAlias = Line | Arrow | Arc | Circle | RightAngle | Angle | Curve | Text | Scale | Measure


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
    where the construction is exact. An arc is in radians here and printed in degrees. An offset crank has
    the `offset_formula`, if that is another.
    """

    letters: str
    ends: tuple[str, str]
    symbol: Label
    formula: Label
    drawn: Callable[[Points], Any]
    true: Callable[[Placed], Any]
    unit: str = "$R$"
    approximate: Words | None = None
    is_arc: bool = False
    offset_formula: Label = ""


class Position(NamedTuple):
    """A position of the straight crank that no angle in degrees says: its place on the circle by λ, and in
    words."""

    circle: Callable[[Any], Any]
    said: Words


@dataclass(frozen=True)
class Placed:
    """A drive, a Crank or one that has its crank, at a crank angle φ in degrees, on a kind of number. Of a
    Crank φ counts from the slide direction, as of the straight one from the inner dead centre.

    A `position` gives the place on the circle of what no angle in degrees says; the angle is then near it.
    Lengths are in units of R, from the shaft O: across towards the crosshead, up on the side of the crank pin
    on the outstroke.
    """

    drive: Any
    angle: Fraction
    kind: Kind
    position: Position | None = None
    beside: Beside = ALONE

    @cached_property
    def circle(self) -> Any:
        return self.position.circle(self.ratio) if self.position else self.kind.circle(self.angle)

    @cached_property
    def ratio(self) -> Any:
        """λ."""
        return self.kind.of(self.drive.crank.ratio)

    @cached_property
    def rod(self) -> Any:
        """L."""
        return self.kind.of(1 / self.drive.crank.ratio)

    @cached_property
    def offset(self) -> Any:
        """e."""
        return self.kind.of(self.drive.crank.offset)

    def number(self, value: Fraction | int) -> Any:
        return self.kind.of(Fraction(value))

    @cached_property
    def shaft(self) -> Point:
        return Point(self.number(0), self.number(0))

    @cached_property
    def pin(self) -> Point:
        return Point(self.circle.cosine, self.circle.sine)

    @cached_property
    def crosshead(self) -> Point:
        return self.crosshead_of(self.pin)

    def crosshead_of(self, pin: Point) -> Point:
        """Return where the crosshead stands while the crank pin is there."""
        side = pin.y - self.offset
        return Point(pin.x + root(self.rod * self.rod - side * side), self.offset)


class Construction(NamedTuple):
    """A construction: its name on the command line, its title and book, the mechanisms for which it holds
    and the sentence that refuses others, its points, steps and lengths. `refused` says of a drive and an
    angle why the construction fails there, nothing where it holds.

    A `mirrored` one is drawn with the crosshead on the left, as its book has it. Where no angle is given
    `angle` is drawn, or of a straight crank the `position`; `angle_symbol` is the crank angle's. `scales` are
    the units that are drawn longer or shorter than R, in R. Without `angle` and `position` it is of no crank
    angle. `takes` are the options that it takes beside the drive, `usual` what its book has of the drive,
    `curves` its curves, in floats. `variants` are the construction where its steps are others, by mechanism.
    """

    name: str
    title: Words
    source: Words
    points: Callable[[Placed], Points]
    steps: Sequence[Step]
    lengths: Sequence[Length]
    holds: tuple[str, ...] = ("straight",)
    refusal: str = ""
    refused: Callable[[Crank, Fraction], str] = lambda drive, angle: ""
    mirrored: bool = False
    angle: str = "50"
    angle_symbol: Label = "$α$"
    ratio_symbol: str = "R:L"
    notes: Sequence[Words] = ()
    position: Position | None = None
    scales: Mapping[str, Fraction] = MappingProxyType({})
    takes: tuple[str, ...] = ()
    usual: Mapping[str, str] = MappingProxyType({})
    curves: Callable[[Placed], Mapping[str, Sequence[Point]]] | None = None
    variants: Mapping[str, Construction] = MappingProxyType({})

    def __reduce__(self) -> tuple[Any, ...]:
        return _named, (self.name, next((key for key, one in _variants(self.name) if one is self), ""))

    def of(self, mechanism: str) -> Construction:
        """Return the construction as it is of a mechanism for which it holds."""
        return self.variants.get(mechanism, self)

    def said(self, label: Label) -> Label:
        """Return a label in which two letters of points beside each other are the length between them."""
        return overlined(label, (letter.rstrip("*") for step in self.steps for letter in step.points))


def _variants(name: str) -> Iterable[tuple[str, Construction]]:
    from kurbel.books.constructions.registry import construction

    return construction(name).variants.items()


def _named(name: str, mechanism: str) -> Construction:
    from kurbel.books.constructions.registry import construction

    return construction(name).of(mechanism)


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


def along(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures from one point to another along the slide, positive towards the shaft."""
    return lambda points: points[start].x - points[end].x


def between(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures the length between two points."""
    return lambda points: distance(points[start], points[end])
