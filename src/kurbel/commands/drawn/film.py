"""Drawings that move: what options say of them, and the printed numbers beside them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypedDict

from kurbel.commands.drawn.size import page_size
from kurbel.commands.options import FLAG, Option
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.reading.given import Exact, as_number, found_at

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing
    from kurbel.motion.mechanism import Mechanism
    from kurbel.motion.page import AngleQuestion
    from kurbel.motion.points.point import Point
    from kurbel.page.quantity import Column
    from kurbel.page.steps import Scene
    from kurbel.page.table import Value
    from kurbel.plot.chart.model import Around, Panel
    from kurbel.plot.chart.vector import PinForce
    from kurbel.plot.drawings import Drawing as Drawn
    from kurbel.plot.film.curves import Shot
    from kurbel.plot.film.mechanism import Staged

# In seconds, of a turn.
USUAL, LEAST, MOST = 6, 1, 120
# So many quantities are read beside a drawing.
MOST_COLUMNS = 8


class Filmed(TypedDict, total=False):
    """Whether a drawing moves, and how fast."""

    animate: Annotated[
        bool,
        Option(
            "Let the drawing move through its turn: -o turn.html (with a slider), turn.svg or turn.gif.",
            kind=FLAG, default=False, last=True,
        ),
    ]  # fmt: skip
    seconds: Annotated[
        Exact | None,
        Option(
            f"Seconds that a turn of a drawing takes which moves, {LEAST} to {MOST}; default {USUAL}.",
            "SECONDS", unit="seconds", last=True,
        ),
    ]  # fmt: skip


class Spoken(NamedTuple):
    """A quantity beside a drawing: its name, symbol and unit, and its printed numbers, degree by degree."""

    name: Label
    symbol: Label
    unit: Label
    values: "tuple[Value, ...]"


def still(values: Mapping[str, Any]) -> dict[str, str]:
    """Return the sentence that refuses the speed of a drawing that stands still."""
    if values.get("animate"):
        over = "--animate runs through the crank angle, and --over path is another axis; leave one out"
        return {"over": over} if values.get("over") == "path" else {}
    return {"seconds": "--seconds is for drawings that move; add --animate, or leave it out"}


def seconds_of(given: Mapping[str, Any]) -> float:
    """Return how long a turn takes. Raises ProblemError beyond the limits."""
    if given["seconds"] is None:
        return USUAL
    found = float(as_number(given["seconds"], "seconds"))
    if not LEAST <= found <= MOST:
        raise ProblemError(
            f"a turn of {found:.6g} seconds was asked for; a drawing that moves takes {LEAST} to {MOST} of"
            " them for each"
        )
    return found


def staged(name: str, drive: Any) -> "Staged":
    """Return what a mechanism of this name looks like at crank angles."""
    from kurbel.drive.crank import Crank
    from kurbel.motion.mechanism import mechanism

    # What acts on a drive is nothing to its way.
    bare = drive.of(Crank(drive.crank.ratio, drive.crank.offset))
    return partial(found_at(mechanism(name).moving), bare)


def shot_of(given: Mapping[str, Any], question: Any) -> "Shot | None":
    """Return how the drawing of a question is to move, with the mechanism of a single drive; nothing for one
    that stands still."""
    if not given["animate"]:
        return None
    from kurbel.plot.film.curves import Shot

    span = float(question.angles[-1] - question.angles[0])
    seconds = seconds_of(given) * max(1.0, span / 360)
    # A diagram of torques has no drive, and of several cranks none is that of the drawing.
    moving, first = getattr(question, "moving", None), getattr(question, "first", None)
    several = (getattr(question, "ratios", ()), getattr(question, "cranks", ()), getattr(first, "parts", ()))
    alone = all(len(one) < 2 for one in several)
    if moving is None or not alone:
        return Shot(seconds)
    return Shot(seconds, partial(_carrying, question, staged(moving[0], moving[1])))


def _carrying(question: Any, show: "Staged", *angles: Sequence[float]) -> "Scene | None":
    """Return what moves with what a question shows of it besides."""
    found: Scene | None = question.carrying(show(*angles), show)
    return found


def spoken(question: "AngleQuestion", columns: Sequence["Column"] = ()) -> tuple[Spoken, ...]:
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


def paged(drawn: "Drawn", lang: str, mark: str, numbers: tuple[Spoken, ...]) -> Callable[[str], str]:
    """Return what makes an HTML page of the SVG file of a drawing that moves, with numbers beside it."""

    def page(svg: str) -> str:
        from kurbel.formats.html.live.film import film_page

        return film_page(svg, drawn.title, lang, mark, numbers)

    return page


def curves_of(
    question: Any,
    panels: Sequence["Panel"],
    around: "Around",
    given: Mapping[str, Any],
    columns: Sequence["Column"] = (),
) -> "Drawing":
    """Return the curves of a question, which are run through if that is asked for; its numbers may have the
    names of other columns."""
    from kurbel.commands.shown import Drawing, mark_of
    from kurbel.plot.drawings import curves_drawing

    lang, mark = given["lang"], mark_of(given["lang"], given["decimal"])
    shot = shot_of(given, question)
    drawn = curves_drawing(question, panels, mark, around, page_size(given), shot)
    return Drawing.of(
        drawn, lang, mark, paged(drawn, lang, mark, spoken(question, columns)) if shot else None
    )


def polar_of(question: Any, force: "PinForce", given: Mapping[str, Any]) -> "Drawing":
    """Return the polar diagram of a force, which is run through if that is asked for."""
    from kurbel.commands.shown import Drawing, mark_of
    from kurbel.plot.drawings import polar_drawing

    lang, mark = given["lang"], mark_of(given["lang"], given["decimal"])
    shot = shot_of(given, question)
    drawn = polar_drawing(question, force, mark, page_size(given), shot)
    return Drawing.of(drawn, lang, mark, paged(drawn, lang, mark, spoken(question)) if shot else None)


def moving_mechanism(
    chosen: "Mechanism",
    drive: Any,
    angles: Sequence[Fraction],
    given: Mapping[str, Any],
    drawn: "Drawn",
    points: "Sequence[Point]" = (),
) -> "Drawing":
    """Return a mechanism that moves in place of the drawing in which it stands still, with points of its
    rod."""
    from kurbel.commands.shown import Drawing, mark_of
    from kurbel.plot.film.mechanism import mechanism_film

    lang, mark = given["lang"], mark_of(given["lang"], given["decimal"])
    question = replace(_asked_beside(chosen, drive, lang, points), units=given["units"])
    show = partial(_carrying, question, staged(chosen.name, drive))
    made = mechanism_film(show, angles, mark, seconds_of(given), page_size(given))
    # A drive that was drawn has a scene.
    assert made is not None
    found = drawn._replace(figure=made[0], film=made[1])
    return Drawing.of(found, lang, mark, paged(found, lang, mark, spoken(question)))


def _asked_beside(chosen: "Mechanism", drive: Any, lang: str, points: "Sequence[Point]") -> "AngleQuestion":
    """Return what is told beside a mechanism: the motion of the driven end, or of points of the rod."""
    from kurbel.page.layouts import layout
    from kurbel.plot.curves import motion_keys

    turn = (Fraction(0), Fraction(360))
    if points:
        from kurbel.commands.points.asked import usual_columns
        from kurbel.motion.points.page import SUBJECT, PointsRequest

        return PointsRequest(
            mechanism=chosen, drives=(drive,), points=tuple(points), layout=layout(SUBJECT.layout),
            angles=turn, lang=lang, columns=usual_columns(chosen.crank(drive)),
        )  # fmt: skip
    keys = motion_keys(chosen, chosen.crank(drive))
    return chosen.question((drive,), None, layout=layout(chosen.layout), angles=turn, lang=lang, columns=keys)
