"""The axes of pages, such as crank ratios, crank angles and columns, and the grid that they span."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from kurbel.errors import ProblemError
from kurbel.exact.kind import FoundAngle
from kurbel.exact.numerals import Label, Number, degrees_text, finite_decimals, nearest, number_text
from kurbel.page.quantity import words
from kurbel.page.table import Cell, Ditto, Field, Value
from kurbel.reading.notation import Progression, plain, ratio_text

if TYPE_CHECKING:
    from kurbel.page.subject import Question

Thing = TypeVar("Thing")
RATIO = words("Kurbelverhältnis R:L|Crank ratio R:L")
PHI = words("Kurbelwinkel|Crank angle")
# An angle that is no finite decimal, such as 0°20', is given to programs to this many places.
ANGLE_DECIMALS = 15
# One at which a condition holds, as pages of conditions have it.
FOUND_DECIMALS = 4
MOST_ANGLE_DECIMALS = 50

# A place on a page: the index on each axis by the axis' name.
Place: TypeAlias = Mapping[str, int]


class PageAxis(ABC):
    """What varies along a page: its places, and how each is written as a head, in the stub, over a group.

    A page has `size` places of it, records `count`.
    """

    # How many lines of the heads stay in the heading when the others span several columns.
    lines = 1

    def __init__(self, size: int, count: int | None = None) -> None:
        self.size = size
        self.count = size if count is None else count

    def stub_heading(self) -> Label:
        """The heading of its column in the stub, unless the layout has another."""
        return ""

    @abstractmethod
    def heads(self, place: Place) -> tuple[Label, ...]:
        """The heads above a column, outermost first."""

    def stub(self, place: Place) -> Number | Label | Ditto:
        return self.heads(place)[-1]

    def over_group(self, place: Place) -> Label:
        return self.heads(place)[0]


class Axis(PageAxis):
    """An axis that is a field of records, under its key; its places may be `found`, not asked for."""

    key: str
    found = False

    @property
    def tells_apart(self) -> bool:
        """Whether records may differ in it."""
        return self.found or self.count > 1

    @abstractmethod
    def field(self) -> Field:
        """What it is in records."""

    @abstractmethod
    def value(self, place: Place) -> Value:
        """What stands for a place in records."""

    def stub_heading(self) -> Label:
        return self.field().name


class ListAxis(Axis):
    """An axis of things in a list, under one key on pages and in records.

    `value` is what stands for a thing in records, `head` how it is written above a column, `heading` what
    heads their column, where that is not the name of the field.
    """

    def __init__(
        self,
        things: Sequence[Thing],
        field: Field,
        value: Callable[[Thing], Value],
        head: Callable[[Thing], Label],
        heading: Label | None = None,
    ) -> None:
        super().__init__(len(things))
        self.key, self.heading = field.key, field.name if heading is None else heading
        self.things: Sequence[object] = things
        self._field = field
        self._value: Callable[[int], Value] = lambda index: value(things[index])
        self._head: Callable[[int], Label] = lambda index: head(things[index])

    def field(self) -> Field:
        return self._field

    def value(self, place: Place) -> Value:
        return self._value(place[self.key])

    def stub_heading(self) -> Label:
        return self.heading

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self._head(place[self.key]),)


class UnletteredAxis(ListAxis):
    """The same, in the stub as in records, without the letters of the heads."""

    def stub(self, place: Place) -> Number | Label:
        found = self.value(place)
        assert isinstance(found, Number | str)
        return found


@dataclass
class Grid:
    """The axes of a page by their names, and what stands at a place, in a language.

    `unit` gives a last column with the unit of each row, where the quantities run down; `exists` leaves out
    places of which there are fewer than the axes' sizes say.
    """

    axes: Mapping[str, PageAxis]
    lang: str
    cell: Callable[[Place], Cell]
    unit: Callable[[Place], Label] | None = None
    exists: Callable[[Place], bool] = lambda place: True

    def places(self, names: Sequence[str]) -> list[Place]:
        return [*places({name: self.axes[name].size for name in names}, self.exists)]


def places(sizes: Mapping[str, int], exists: Callable[[Place], bool]) -> Iterator[Place]:
    """Yield the places on axes of these sizes, as far as there is something."""
    for indices in product(*map(range, sizes.values())):
        place = dict(zip(sizes, indices, strict=True))
        if exists(place):
            yield place


class RatioAxis(Axis):
    """The crank ratios R:L."""

    key = "ratio"

    def __init__(self, question: Any) -> None:
        super().__init__(len(question.ratios))
        self.layout, self.lang, self.ratios = question.layout, question.lang, question.ratios

    def field(self) -> Field:
        return Field("ratio", RATIO[self.lang], f"${self.layout.ratio_symbol}$")

    def value(self, place: Place) -> Label:
        return f"${ratio_text(self.ratios[place['ratio']])}$"

    def stub_heading(self) -> Label:
        return f"${self.layout.ratio_symbol}$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.value(place),)

    def over_group(self, place: Place) -> Label:
        return f"${self.layout.ratio_symbol} = {ratio_text(self.ratios[place['ratio']])}$"


class LetteredRatioAxis(RatioAxis):
    """Crank ratios with their letters, for heads that stand alone."""

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.over_group(place),)


class AngleAxis(Axis):
    """Crank angles in degrees; in pairs an angle stands over its mirror image, in records each for itself."""

    key = "phi"

    def __init__(self, question: Any) -> None:
        self.layout, self.lang = question.layout, question.lang
        if self.layout.pairs and question.zero:
            raise ProblemError(
                f"layout {self.layout.key} sets an angle over its mirror image, which counts from φ = 0;"
                " leave --zero out"
            )
        self.all = shifted(question.angles, -question.zero)
        self.angles = angle_pairs(self.all) if self.layout.pairs else self.all
        self.lines = 2 if self.layout.pairs else 1
        super().__init__(len(self.angles), len(self.all))

    @cached_property
    def decimals(self) -> int | None:
        """How many decimals write every angle exactly, None if no number of them does."""
        return angle_decimals(self.all)

    def field(self) -> Field:
        symbol = f"${self.layout.angle_symbol}$"
        return Field("phi", PHI[self.lang], symbol, "°", self.decimals, method_of(self.all))

    def value(self, place: Place) -> Number:
        return angle_number(self.all[place["angle"]], self.decimals)

    def stub_heading(self) -> Label:
        return f"${self.layout.angle_symbol}$" + (" in °" if self.decimals is not None else "")

    def heads(self, place: Place) -> tuple[Label, ...]:
        angle = self.angles[place["angle"]]
        return (
            (_angle_label(angle), _angle_label(360 - angle)) if self.layout.pairs else (_angle_label(angle),)
        )

    def stub(self, place: Place) -> Number | Label:
        angle = self.angles[place["angle"]]
        return f"${degrees_text(angle)}$" if self.decimals is None else angle_number(angle, self.decimals)


class ColumnAxis(PageAxis):
    """The columns with their heads, in which the ratio of the row may stand."""

    def __init__(self, question: Question) -> None:
        super().__init__(len(question.page_columns))
        self.layout, self.lang, self.columns = question.layout, question.lang, question.page_columns
        self.ratios: Sequence[Fraction] = getattr(question, "ratios", ())

    def heads(self, place: Place) -> tuple[Label, ...]:
        column = self.columns[place["column"]]
        labels = column.spanners + column.heading
        if "ratio" in self.layout.across:
            # The ratios stand below without their letters: "Hingang, R:L" over 1:4, 1:5.
            ratio = f"${self.layout.ratio_symbol}$"
            return (*labels[:-1], ", ".join((*labels[-1:], ratio)))
        return self._with_ratio(labels, place)

    def stub(self, place: Place) -> Label:
        return self._with_ratio(self.columns[place["column"]].heading, place)[-1]

    over_group = stub

    def _with_ratio(self, labels: tuple[Label, ...], place: Place) -> tuple[Label, ...]:
        if "ratio" not in place or not self.ratios:
            return labels
        return tuple(with_ratio(label, self.ratios[place["ratio"]]) for label in labels)


def angle_pairs(angles: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Return each pair of angles once, by the one up to 180°: 200° stands in the pair of 160°."""
    within = (angle % 360 for angle in angles)
    return tuple(dict.fromkeys(min(angle, 360 - angle) for angle in within))


def with_ratio(label: Label, ratio: Fraction) -> Label:
    """Put the ratio as a fraction where the label has {ratio}: 1/4.5."""
    return label.replace("{ratio}", ratio_text(ratio).replace(":", "/") if ratio else "0")


def shifted(angles: Sequence[Fraction], by: Fraction) -> Sequence[Fraction]:
    """Return each angle plus another one."""
    if not by:
        return angles
    if isinstance(angles, Progression):
        return Progression(angles.start + by, angles.step, angles.size)
    return tuple(angle + by for angle in angles)


def angle_text(angle: Fraction) -> str:
    """Return an angle for a formula: 45°, 22.5°, 0°20'."""
    if isinstance(angle, FoundAngle):
        return f"{number_text(angle_number(angle, None))}°"
    return degrees_text(angle) if finite_decimals(angle) is None else f"{plain(angle)}°"


def irregularity_label(irregularity: Fraction) -> Label:
    """Return δ as it is written: 1:100, 1:62.5, or 0.015 where the ratio has no end."""
    short = finite_decimals(1 / irregularity) is not None
    return f"${ratio_text(irregularity) if short else plain(irregularity)}$"


def _angle_label(angle: Fraction) -> Label:
    if isinstance(angle, FoundAngle):
        return f"${number_text(angle_number(angle, None))}$"
    return f"${plain(angle) if finite_decimals(angle) is not None else degrees_text(angle)}$"


def angle_decimals(angles: Sequence[Fraction]) -> int | None:
    """Return how many decimals write every angle exactly, or None if no number up to 50 of them does."""
    ends = (angles.start, angles.step) if isinstance(angles, Progression) else angles
    counts = [_decimals(angle) for angle in ends]
    known = [count for count in counts if count is not None]
    return max(known) if len(known) == len(counts) else None


def method_of(angles: Sequence[Fraction]) -> str:
    """Return by which formulas angles are computed at which something holds; those that are given are not."""
    given = isinstance(angles, Progression) or not any(isinstance(one, FoundAngle) for one in angles)
    return "" if given else "exact"


def angle_number(angle: Fraction, decimals: int | None) -> Number:
    """Return the angle to the decimals of its column, or to its own where the column has no common ones."""
    if decimals is None:
        decimals = _decimals(angle)
    if isinstance(angle, FoundAngle):
        places = FOUND_DECIMALS if decimals is None else decimals
        return Number(angle.rounded(places), places)
    return nearest(angle, ANGLE_DECIMALS if decimals is None else decimals)


def _decimals(angle: Fraction) -> int | None:
    if isinstance(angle, FoundAngle):
        return FOUND_DECIMALS
    count = finite_decimals(angle)
    return None if count is None or count > MOST_ANGLE_DECIMALS else count
