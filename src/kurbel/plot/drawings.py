"""What is drawn of a question, its panels or a force as a vector, made by what its subject names; and the
drawing: a figure, and a title for readers that do not see it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.exact.certify import FLOAT_BITS, at_bits
from kurbel.exact.numerals import Label
from kurbel.linkage.linkage import Linkage
from kurbel.linkage.rocker import RockerCrank
from kurbel.motion import captions
from kurbel.motion.motion_page import Request
from kurbel.page.axes import PHI
from kurbel.page.layouts import Layout, layout
from kurbel.page.quantity import Column, for_ratio, words
from kurbel.page.subject import Question
from kurbel.plot.animated import FilmSettings, curves_film, polar_film
from kurbel.plot.film import Film
from kurbel.plot.panel import NOTHING_AROUND, Panel, PanelFrame, PinForce, axis_label, degrees
from kurbel.plot.plotting import curves
from kurbel.plot.polar import polar
from kurbel.plot.stage import RodPointPath
from kurbel.plot.standing import LinksStanding, RockerStanding, SlideStanding, StandingDrawing
from kurbel.plot.style import USUAL, Size
from kurbel.reading import notation
from kurbel.reading.given import found_at
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Asked = TypeVar("Asked", bound=Question)
# The crank ratio in all drawings.
RATIO = "R:L"
# So many steps of the range make a curve smooth, half degrees over the turn; over many turns a wider step
# than this shows.
STEPS, WIDEST = 720, Fraction(5)
MOST_PANELS = 4
# Units by which a column is that of another one, which is a share.
KNOWN = ("_mm", "_mps", "_mps2", "_n", "_nm")


class DrawingWish(NamedTuple):
    """How a page is drawn, if not in its usual way: as a polar diagram, over the path, beside the rod of
    infinite length."""

    polar: bool = False
    over_path: bool = False
    infinite: bool = False


class Picture(NamedTuple):
    """What is drawn: of which question, over smooth angles, its panels or a force, and what is around them.

    `columns` have the names of the question's in the letters of drawings. The title is by itself that of the
    page.
    """

    question: Question
    panels: Sequence[Panel] = ()
    around: PanelFrame = NOTHING_AROUND
    force: PinForce | None = None
    columns: Sequence[Column] = ()
    title: Label = ""


def picture(question: Question, wish: DrawingWish) -> Picture:
    """Return what is drawn of a question. Raises ProblemError for what has no such drawing."""
    with at_bits(FLOAT_BITS):
        found: Picture = found_at(question.subject.drawn)(question, wish)
    if len(found.panels) > MOST_PANELS:
        names = "; ".join(panel.label.partition(" $")[0] for panel in found.panels)
        raise ProblemError(
            f"{len(found.panels)} panels are too many for a drawing, which has at most {MOST_PANELS}:"
            f" {names[:200]}; choose some by --columns"
        )
    if wish.polar and found.force is None:
        raise ProblemError(
            "--polar is for the force on the crank pin and for the free forces of an engine, of kurbel forces"
            " and kurbel balance; leave it out"
        )
    return found


def drawn(found: Picture, mark: str, size: Size, run: FilmSettings | None = None) -> Drawing:
    """Return the drawing of a picture; with a shot it is run through."""
    if found.force is not None:
        made = polar_drawing(found.question, found.force, mark, size, run)
    else:
        made = curves_drawing(found.question, found.panels, mark, found.around, size, run)
    title = found.question.caption or found.title
    return made._replace(title=title) if title else made


def refuse(wish: DrawingWish, **sentences: str) -> None:
    """Raise ProblemError for a wish that what is drawn cannot fulfil, each with its sentence."""
    for name, sentence in sentences.items():
        if getattr(wish, name):
            raise ProblemError(sentence)


def check_one(count: int, what: str) -> None:
    """Raise ProblemError where a polar diagram would be of several."""
    if count > 1:
        raise ProblemError(f"--polar draws one crank drive, and {count} {what} were given; choose one")


def drawing_layout(name: str) -> Layout:
    """Return the layout of that name with the letters of all drawings."""
    return lettered_as_drawings(layout(name))


def lettered_as_drawings(page: Layout) -> Layout:
    """Return a layout with the crank ratio as in all drawings, whatever its book has."""
    return Layout(**{**vars(page), "ratio_symbol": RATIO})


def asked_of(question: Asked, **changes: Any) -> Asked:
    """Return the question as it is drawn, with the letters of all drawings; angles count from φ = 0."""
    page = lettered_as_drawings(question.layout)
    return replace(question, **{"layout": page, "zero": Fraction(0), "digits": None, **changes})


def smooth(angles: Sequence[Fraction], steps: int = STEPS) -> Sequence[Fraction]:
    """Return the angles with others between the first and the last, close enough for smooth curves."""
    if len(angles) > steps:
        return angles
    first, last = min(angles), max(angles)
    step = min((last - first) / steps or WIDEST, WIDEST)
    return sorted({*notation.progression(first, last, step), *angles})


def columns_of(question: Question) -> tuple[Column, ...]:
    """Return the columns that are drawn: those of the page, and unless they were named, a quantity once, in
    its unit."""
    columns = question.page_columns
    if question.columns:
        return columns
    keys = {column.key for column in columns}
    return tuple(one for one in columns if not any(one.key + unit in keys for unit in KNOWN))


MOST_POSITIONS = 36
WORDS = {
    "drive": words("Kurbeltrieb|Crank drive"),
    "offset drive": words("Geschränkter Kurbeltrieb|Offset crank drive"),
    "path": words(
        ", Bahn des Punktes {points} der Schubstange|, path of the point {points} of the connecting rod"
    ),
    "paths": words(
        ", Bahnen der Punkte {points} der Schubstange|, paths of the points {points} of the connecting rod"
    ),
}
# The diagram turns with the crank.
POLAR_TITLE = words(
    "Polardiagramm der Kraft am Kurbelzapfen im Achsenkreuz der Kurbel"
    "|Polar diagram of the force on the crank pin, in the frame of the crank"
)
# The directions of its axes, across and up.
POLAR_WAYS = {"de": ("im Drehsinn", "zur Welle"), "en": ("as the crank turns", "towards the shaft")}


class Drawing(NamedTuple):
    """A figure, its title, and what it shows in words; how it moves, if it does."""

    figure: Figure
    title: Label
    about: Label = ""
    film: Film | None = None


def curves_drawing(
    question: Question,
    panels: Sequence[Panel],
    mark: str,
    around: PanelFrame = NOTHING_AROUND,
    size: Size = USUAL,
    shot: FilmSettings | None = None,
) -> Drawing:
    """Return the curves of what was asked for over the crank angle, or over another axis; with a shot they
    are run through."""
    title, about = _title(question), "; ".join(_about(panels))
    if shot is None:
        return Drawing(curves(panels, question.lang, mark, around, size), title, about)
    chart, film = curves_film(panels, question.lang, mark, shot, around, size)
    return Drawing(chart.figure, title, about, film)


def _about(panels: Sequence[Panel]) -> Iterator[Label]:
    """Yield what each panel shows: its axis, what its curves are called, and what is named in it."""
    for panel in panels:
        labels = [curve.label for curve in panel.curves if curve.label]
        named = [spot.text for spot in panel.spots if spot.text]
        swing = [panel.swing.text] if panel.swing else []
        told = ", ".join((*labels, *swing, *named))
        yield ": ".join(filter(None, (axis_label(panel.label, panel.unit, panel.power), told)))


def polar_drawing(
    question: Question, force: PinForce, mark: str, size: Size = USUAL, shot: FilmSettings | None = None
) -> Drawing:
    """Return the polar diagram of the force on the crank pin, of which names and unit are given; with a shot
    a dot runs along it."""
    across, up = (axis_label(name, force.unit, force.power) for name in force.names)
    figure = polar(force, mark, force.ways or POLAR_WAYS[question.lang], size)
    about = "; ".join((across, up, *(force.strokes.names if force.strokes else ())))
    title = f"{POLAR_TITLE[question.lang]}: {_title(question)}"
    if shot is None:
        return Drawing(figure, title, about)
    return Drawing(figure, title, about, polar_film(figure, force, shot.seconds))


def _title(question: Question) -> Label:
    if isinstance(question, Request):
        return captions.caption(question, chosen=True)
    return question.subject.caption(question)


def crank_standing(crank: Crank, lang: str) -> tuple[StandingDrawing, Label]:
    """Return what draws the crank drive to scale, and its title."""
    kind = WORDS["offset drive" if crank.offset else "drive"][lang]
    offset = f", $e = {plain(crank.offset)} R$" if crank.offset else ""
    title = kind + for_ratio(crank.ratio, lang) + offset
    return SlideStanding(float(crank.ratio), float(crank.offset)), title


def arc_standing(crank: RockerCrank, lang: str) -> tuple[StandingDrawing, Label]:
    """Return the same of the arc crank."""
    rocker = f"${crank.letter} = {plain(crank.rocker)} R$"
    title = f"{crank.noun[lang]}{for_ratio(crank.crank.ratio, lang)}, {rocker}"
    return RockerStanding(crank), title


def links_standing(drive: Linkage, lang: str) -> tuple[StandingDrawing, Label]:
    """Return the same of a drive by its outline."""
    outline = drive.outline()
    assert outline is not None
    ratio = for_ratio(drive.crank.ratio, lang) if drive.crank.ratio else ""
    return LinksStanding(outline), outline.title[lang] + ratio


def standing_drawing(
    standing: StandingDrawing,
    title: Label,
    angles: Sequence[Fraction],
    lang: str,
    mark: str,
    size: Size = USUAL,
    paths: Sequence[RodPointPath] = (),
) -> Drawing:
    """Return a mechanism to scale at crank angles, the first one strong."""
    if len(angles) > MOST_POSITIONS:
        raise ProblemError(
            f"a drawing of {len(angles)} crank angles was asked for;"
            f" at most {MOST_POSITIONS} can be told apart"
        )
    check_angles(angles)
    figure = standing.drawn(angles, lang, mark, size, paths)
    at = "; ".join(degrees(angle, mark) for angle in angles)
    return Drawing(figure, title + _of_paths(paths, lang), f"{PHI[lang]} {at}")


def _of_paths(paths: Sequence[RodPointPath], lang: str) -> Label:
    """Return what the title says of the paths of points of the rod."""
    if not paths:
        return ""
    points = "; ".join(one.label for one in paths)
    return WORDS["path" if len(paths) == 1 else "paths"][lang].format(points=points)
