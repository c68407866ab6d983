"""The page of every step: the command asks once for each, and everything on a page is what it answers; what
runs along it is the crank angle over the turn, or the axis of its rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from kurbel.commands.options import is_given
from kurbel.commands.part import Values
from kurbel.commands.sliders import (
    SliderOption,
    check_count,
    check_numbers,
    choices,
    steps,
    usual_cut_offs,
    usual_ratios,
)
from kurbel.commands.subject import Command
from kurbel.drive.crank import Crank
from kurbel.drive.load import STEAM
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.numerals import Label, Number, number_text
from kurbel.motion.evaluation import RETURN
from kurbel.motion.mechanism import mechanism
from kurbel.page.axes import AngleAxis, Axis
from kurbel.page.build import enlarged, shown_at
from kurbel.page.quantity import Column, letter
from kurbel.page.steps import MOST_COLUMNS, Cursor, Place, Scene, Shown, Step, Steps
from kurbel.page.subject import Question
from kurbel.page.table import Table, Value
from kurbel.reading.amounts import printed_in
from kurbel.reading.given import as_numbers, found_at

NOTHING = (
    "an interactive page needs something to choose, and here is nothing; give an option several values, for"
    " example --ratio 1:3..6, or leave --interactive out"
)
# In degrees, of the crank angle and of what is shown first.
STEP, FIRST, HALF = 5, 60, 180


def stepped(command: Command, values: Values) -> Table:
    """Return the page of the step that is shown first, with all steps if there is anything to choose.

    `values` are those of all options, which are settled here; a page is called by them.
    """
    with command.naming_places(values):
        command.settle(values)
        asking = _Asking(command, values, tuple(choices(command.options, values.values)))
        check_count(asking.choices)
        question = asking.first()
    found = (*asking.usual(question), *asking.choices)
    check_count(found)
    asking = replace(asking, choices=found)
    question = asking.first()
    if not isinstance(question, Question):
        # The pages of examples have no columns, and nothing runs along them.
        return command.built(question, values)
    check_numbers(len(question) * len(question.page_columns), found)
    run = asking.run(question)
    page = command.built(question, values)
    if not found and run is None:
        return page
    ratio = question.layout.ratio_symbol
    return replace(
        page,
        steps=Steps(
            tuple(one.slider(question.lang, ratio) for one in found),
            run.cursor if run else None,
            run.columns if run else (),
            partial(asking.pages, page, run),
        ),
    )


@dataclass(frozen=True)
class _Asking:
    """A command with the values of its options, some of which are chosen."""

    command: Command
    values: Values
    choices: tuple[SliderOption, ...]

    def question(self, chosen: Mapping[str, object]) -> Question:
        """Return what is asked for by these values."""
        question: Question = self.command.question(self.values.instead(chosen))
        return question

    def first(self) -> Question:
        """Return what is asked for at the step that is shown first."""
        return self.question({one.name: one.values[one.start] for one in self.choices})

    def usual(self, question: Question) -> Iterator[SliderOption]:
        """Yield what can be chosen where nothing is said of it: the crank ratio, and of steam ε."""
        said = {name for name, value in self.values.values.items() if is_given(value)}
        ratios = [ratio for ratio in getattr(question, "ratios", ()) if ratio]
        if "ratio" in self.command.options and ratios and said.isdisjoint(("ratio", "rod")):
            yield usual_ratios(ratios, self.turns)
        steams = [one.name for one in getattr(question, "steams", ())]
        if "angle" in self.command.options and "eps" not in said and steams and {*steams} == {STEAM}:
            yield usual_cut_offs(as_numbers(question.layout.expansions, "expansion ratio"))

    def turns(self, ratio: Fraction) -> bool:
        """Whether the drive turns with a ratio at every step."""
        try:
            for chosen, _ in steps(self.choices):
                self.question({**chosen, "ratio": ratio})
        except ProblemError:
            return False
        return True

    def run(self, question: Question) -> Run | None:
        """Return what runs along the page, nothing for one of no crank drive, or without numbers along it."""
        return run_of(question, "angle" in self.command.options) if "ratio" in self.command.options else None

    def pages(self, first: Table, run: Run | None) -> Iterator[Step]:
        """Yield the page of every step, called as the first. Raises KurbelError, which names the step."""
        scenes: dict[object, Scene | None] = {}
        for chosen, said in steps(self.choices):
            try:
                yield self.page(chosen, first, run, scenes)
            except KurbelError as error:
                raise type(error)(f"{error}; this is of the step {said}") from None

    def page(
        self, chosen: Mapping[str, object], first: Table, run: Run | None, scenes: dict[object, Scene | None]
    ) -> Step:
        question = self.question(chosen)
        table = self.command.built(question, self.values.instead(chosen))
        table = replace(table, key=first.key, variant=first.variant)
        tracks, units = run.tracks(question, self.along(chosen, run)) if run else ((), ())
        return Step(table, tracks, units, _scene(question, scenes))

    def along(self, chosen: Mapping[str, object], run: Run) -> Question | None:
        """Return the same question at the angles that a page runs through, where it runs through these."""
        if not run.angles:
            return None
        whole = {**dict.fromkeys(("from", "to", "step")), "angle": run.angles, "columns": run.keys}
        known = self.command.options
        return self.question({**chosen, **{name: one for name, one in whole.items() if name in known}})


def _scene(question: Question, scenes: dict[object, Scene | None]) -> Scene | None:
    """Return what moves, once for drives that move alike."""
    if question.moving is None:
        return None
    name, drive = question.moving
    # What acts on a drive is nothing to its way.
    bare = drive.of(Crank(drive.crank.ratio, drive.crank.offset))
    if bare not in scenes:
        scenes[bare] = found_at(mechanism(name).moving)(bare)
    return question.carrying(scenes[bare])


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
        return tracks, tuple(columns[key].quantity.unit_beside(asked.lang) for key in self.keys)


def _value(question: Question, column: Column, axis: str, place: int) -> Value:
    rest = dict.fromkeys(question.axes, 0)
    return shown_at(question, column, {**rest, axis: place, "column": question.page_columns.index(column)})


def run_of(question: Question, over_angles: bool) -> Run | None:
    """Return what runs along the pages of a question, over the turn if it is asked for crank angles."""
    # Of two strokes the one that goes through the turn.
    columns = [one for one in question.page_columns if not _returns(one)][:MOST_COLUMNS]
    if not columns or question.subject.grid:
        return None
    keys = tuple(column.key for column in columns)
    letters = (letter(column.quantity, question.lang) for column in columns)
    shown = tuple(Shown(one.name, one.symbol) for one in letters)
    axis = question.axes.get("angle")
    if over_angles and isinstance(axis, AngleAxis):
        turn = 720 if max(axis.all) > 360 else 360
        angles = tuple(Fraction(angle) for angle in range(0, turn + 1, STEP))
        return Run("angle", _turned(question, axis, angles, turn), keys, shown, angles)
    return _along(question, keys, shown)


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
    in_rows = layout.down[-1:] == (name,)
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
