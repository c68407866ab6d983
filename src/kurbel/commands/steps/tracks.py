"""What runs along a page: the crank angle over the turn, or the axis of its rows."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from kurbel.exact.numerals import Label, Number, number_text
from kurbel.motion.evaluation import RETURN
from kurbel.page.axes import AngleAxis, Axis
from kurbel.page.build import enlarged, shown_at
from kurbel.page.quantity import Column, Quantity, named
from kurbel.page.steps import Cursor, Place, Shown
from kurbel.page.subject import Question
from kurbel.page.table import Value
from kurbel.reading.amounts import printed_in

# In degrees, of the crank angle and of what is shown first.
STEP, FIRST, HALF = 5, 60, 180
# So many quantities are read beside a drawing.
MOST_COLUMNS = 8


# What stands at each place, by column.
Tracks = tuple[tuple[Value, ...], ...]


class Run(NamedTuple):
    """The axis by the name of a question's axes, what it is on pages, and the columns along it. `angles` are
    those at which a question is asked once more, nothing for one that has its axis itself."""

    axis: str
    cursor: Cursor
    keys: tuple[str, ...]
    columns: tuple[Shown, ...]
    angles: tuple[Fraction, ...] = ()

    def tracks(self, question: Question, along: Question | None) -> tuple[Tracks, tuple[Label, ...]]:
        """Return the values of each column at each place, of the page's question or that along the axis, and
        their units, which are those of the page."""
        asked = enlarged(question)
        if along is not None:
            asked = along if asked.units == along.units else replace(along, units=asked.units)
        columns = {column.key: column for column in asked.page_columns}
        axis = asked.axes[self.axis]
        places: Sequence[int] = range(axis.size)
        if along is not None and isinstance(axis, AngleAxis) and axis.layout.pairs:
            found = {angle: place for place, angle in enumerate(axis.angles)}
            places = [found[min(one % 360, -one % 360)] for one in self.angles]
        with printed_in(asked.units) if asked.units else nullcontext():
            tracks = tuple(
                tuple(_value(asked, columns[key], self.axis, place) for place in places) for key in self.keys
            )
        return tracks, tuple(_unit(columns[key].quantity, asked.lang) for key in self.keys)


def _value(question: Question, column: Column, axis: str, place: int) -> Value:
    rest = dict.fromkeys(question.axes, 0)
    return shown_at(question, column, {**rest, axis: place, "column": question.page_columns.index(column)})


def run_of(question: Question, over_angles: bool) -> Run | None:
    """Return what runs along the pages of a question, over the turn if it is asked for crank angles."""
    columns = _columns(question)
    if not columns or question.subject.grid:
        return None
    keys = tuple(column.key for column in columns)
    shown = tuple(map(_shown, columns, [question.lang] * len(columns)))
    axis = question.axes.get("angle")
    if over_angles and isinstance(axis, AngleAxis):
        turn = 720 if max(axis.all) > 360 else 360
        angles = tuple(Fraction(angle) for angle in range(0, turn + 1, STEP))
        return Run("angle", _turned(question, axis, angles, turn), keys, shown, angles)
    return _along(question, keys, shown)


def _columns(question: Question) -> list[Column]:
    """Return the columns that are read along an axis: of two strokes the one that goes through the turn."""
    return [one for one in question.page_columns if not _returns(one)][:MOST_COLUMNS]


def _shown(column: Column, lang: str) -> Shown:
    return Shown(named(column.quantity.name[lang], lang), column.quantity.symbol)


def _unit(quantity: Quantity, lang: str) -> Label:
    return "" if quantity.minutes else quantity.unit[lang]


def _turned(question: Question, axis: AngleAxis, angles: Sequence[Fraction], turn: int) -> Cursor:
    symbol, field = question.layout.angle_symbol, axis.field()
    rows = _rows(question, axis, turn)
    places = tuple(Place(f"${angle}$", float(angle), _nearest(rows, angle, turn)) for angle in angles)
    zero = float(question.zero)
    return Cursor("phi", f"{field.name} ${symbol}$", "°", places, turn, zero, angles.index(Fraction(FIRST)))


def _rows(question: Question, axis: AngleAxis, turn: int) -> list[tuple[Fraction, int]]:
    """Return for the angles of which a row says something that row, nothing where angles are no rows."""
    layout = question.layout
    others = [name for name in layout.down if name != "angle" and question.axes[name].size > 1]
    if others or "angle" not in layout.down:
        return []
    rows = [(angle, row) for row, angle in enumerate(axis.angles)]
    if layout.pairs:
        rows += [(360 - angle, row) for angle, row in rows]
    elif turn == 360 and max(axis.angles) <= HALF and any(map(_returns, question.page_columns)):
        # The return stroke stands beside the outstroke, in the rows of its angles less 180°.
        rows += [(angle + HALF, row) for angle, row in rows if angle]
    return rows


def _returns(column: Column) -> bool:
    return column.quantity.stroke == RETURN


def _nearest(rows: Sequence[tuple[Fraction, int]], angle: Fraction, turn: int) -> int | None:
    """Return the row whose angle is nearest, the earlier of two; the turn ends where it begins."""
    if not rows:
        return None
    near = min(rows, key=lambda one: (abs(one[0] - angle), one[0]))
    first = min(rows)
    return first[1] if first[0] + turn - angle < abs(near[0] - angle) else near[1]


def _along(question: Question, keys: tuple[str, ...], shown: tuple[Shown, ...]) -> Run | None:
    """Return the run along the one axis of a page with several places, nothing unless they are numbers."""
    axes = {
        name: axis
        for name, axis in question.axes.items()
        if isinstance(axis, Axis) and axis.size > 1 and name != "ratio"
    }
    if len(axes) != 1 or question.subject.whole:
        return None
    ((name, axis),) = axes.items()
    layout = question.layout
    in_rows = name in layout.down and (layout.down[-1] == name or "column" not in layout.down)
    values = [axis.value({**dict.fromkeys(question.axes, 0), name: place}) for place in range(axis.size)]
    numbers = [one for one in values if isinstance(one, Number)]
    if len(numbers) < len(values):
        return None
    places = tuple(
        Place(
            f"${number_text(one)}$",
            one.scaled / 10**one.decimals,
            place if in_rows else None,
            place if layout.across == (name,) and not layout.block else None,
        )
        for place, one in enumerate(numbers)
    )
    field = axis.field()
    heading = " ".join(filter(None, (field.name, field.symbol)))
    return Run(name, Cursor(field.key, heading, field.unit, places), keys, shown)
