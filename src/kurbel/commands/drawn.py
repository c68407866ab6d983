"""Pages and mechanisms as drawings, which may move with their printed numbers beside them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.commands.part import Origin, Values
from kurbel.commands.parts.drawing import Pictured
from kurbel.commands.shown import Drawing, mark_of
from kurbel.exact.numerals import Label
from kurbel.reading.given import found_at
from kurbel.reading.keywords import unknown

if TYPE_CHECKING:
    from kurbel.page.quantity import Column
    from kurbel.page.steps import Scene
    from kurbel.page.table import Value
    from kurbel.plot.animated import Shot, Staged
    from kurbel.plot.drawings import Drawing as Drawn

# So many quantities are read beside a drawing.
MOST_COLUMNS = 8


class Spoken(NamedTuple):
    """A quantity beside a drawing: its name, symbol and unit, and its printed numbers, degree by degree."""

    name: Label
    symbol: Label
    unit: Label
    values: tuple[Value, ...]


def drawing_of(question: Any, options: Pictured, decimal: str | None = None) -> Drawing:
    """Return what is asked for as a drawing: the columns of its page over their axis. Raises KurbelError."""
    from kurbel.plot.picture import drawn, picture

    mark, turn, wish = mark_of(question.lang, decimal), options.turn, options.wish
    found = picture(question, wish)
    shot = None if turn is None else shot_of(turn, found.question)
    made = drawn(found, mark, options.size, shot)
    page = None if shot is None else paged(made, question.lang, mark, spoken(found.question, found.columns))
    return Drawing.of(made, question.lang, mark, page)


def plotted(question: Any, options: Mapping[str, Any], decimal: str | None) -> Drawing:
    """Return the same by options in the words of Python. Raises KurbelError."""
    known = Pictured.options()
    for name in options:
        if name not in known:
            raise unknown("Table.plot", name, known, "kurbel forces --help drawing lists them")
    given = {name: known[name].taken(value) for name, value in options.items() if value is not None}
    values = {name: one.default for name, one in known.items()} | given
    return drawing_of(question, Pictured(Values(values, dict.fromkeys(given, Origin.TYPED))), decimal)


def shot_of(seconds: float, question: Any) -> Shot:
    """Return how the drawing of a question is to move, with the mechanism of a single drive."""
    from kurbel.plot.animated import Shot

    span = float(question.angles[-1] - question.angles[0])
    seconds *= max(1.0, span / 360)
    # A diagram of torques has no drive, and of several cranks none is that of the drawing.
    moving, first = question.moving, getattr(question, "first", None)
    several = (getattr(question, "ratios", ()), getattr(question, "cranks", ()), getattr(first, "parts", ()))
    alone = all(len(one) < 2 for one in several)
    if moving is None or not alone:
        return Shot(seconds)
    return Shot(seconds, partial(carrying, question, staged(moving[0], moving[1])))


def staged(name: str, drive: Any) -> Staged:
    """Return what a mechanism of this name looks like at crank angles."""
    from kurbel.drive.crank import Crank
    from kurbel.motion.mechanism import mechanism

    # What acts on a drive is nothing to its way.
    bare = drive.of(Crank(drive.crank.ratio, drive.crank.offset))
    return partial(found_at(mechanism(name).moving), bare)


def carrying(question: Any, show: Staged, *angles: Sequence[float]) -> Scene | None:
    """Return what moves with what a question shows of it besides."""
    found: Scene | None = question.carrying(show(*angles), show)
    return found


def spoken(question: Any, columns: Sequence[Column] = ()) -> tuple[Spoken, ...]:
    """Return the printed numbers of a question at whole degrees of its run; none of several drives. Their
    names and units may be those of other columns, one for each of its own."""
    from kurbel.page.build import shown_at
    from kurbel.page.quantity import named

    if any(axis.size > 1 for name, axis in question.axes.items() if name not in ("angle", "column")):
        return ()
    first, last = question.angles[0], question.angles[-1]
    angles = tuple(Fraction(angle) for angle in range(int(first), int(last) + 1))
    asked = replace(question, angles=angles)
    none = dict.fromkeys(asked.axes, 0)
    found = []
    for number, column in enumerate(asked.page_columns[:MOST_COLUMNS]):
        one = columns[number].quantity if columns else column.quantity
        places = ({**none, "angle": place, "column": number} for place in range(len(angles)))
        values = tuple(shown_at(asked, column, place) for place in places)
        unit = "" if one.minutes else one.unit[asked.lang]
        found.append(Spoken(named(one.name[asked.lang], asked.lang), one.symbol, unit, values))
    return tuple(found)


def paged(drawn: Drawn, lang: str, mark: str, numbers: tuple[Spoken, ...]) -> Callable[[str], str]:
    """Return what makes an HTML page of the SVG file of a drawing that moves, with numbers beside it."""

    def page(svg: str) -> str:
        from kurbel.formats.html.live import film_page

        return film_page(svg, drawn.title, lang, mark, numbers)

    return page
