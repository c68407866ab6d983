"""Drawings of what was asked for: each a figure, and a title for readers that do not see it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion import captions
from kurbel.motion.page import Request
from kurbel.page.axes import PHI
from kurbel.page.quantity import for_ratio, words
from kurbel.page.subject import Question
from kurbel.plot.panel import NOTHING_AROUND, Around, Panel, PinForce
from kurbel.plot.plotting import curves
from kurbel.plot.polar import polar
from kurbel.plot.rod_paths import Coupled
from kurbel.plot.style import USUAL, Size
from kurbel.plot.ticks import axis_label, degrees
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kurbel.linkage.arc.rocker import RockerCrank
    from kurbel.linkage.linkage import Linkage
    from kurbel.plot.animated import Shot
    from kurbel.plot.film import Film
    from kurbel.plot.standing import Standing

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
    around: Around = NOTHING_AROUND,
    size: Size = USUAL,
    shot: Shot | None = None,
) -> Drawing:
    """Return the curves of what was asked for over the crank angle, or over another axis; with a shot they
    are run through."""
    title, about = _title(question), "; ".join(_about(panels))
    if shot is None:
        return Drawing(curves(panels, question.lang, mark, around, size), title, about)
    from kurbel.plot.animated import curves_film

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
    question: Question, force: PinForce, mark: str, size: Size = USUAL, shot: Shot | None = None
) -> Drawing:
    """Return the polar diagram of the force on the crank pin, of which names and unit are given; with a shot
    a dot runs along it."""
    across, up = (axis_label(name, force.unit, force.power) for name in force.names)
    figure = polar(force, mark, force.ways or POLAR_WAYS[question.lang], size)
    about = "; ".join((across, up, *(force.strokes.names if force.strokes else ())))
    title = f"{POLAR_TITLE[question.lang]}: {_title(question)}"
    if shot is None:
        return Drawing(figure, title, about)
    from kurbel.plot.animated import polar_film

    return Drawing(figure, title, about, polar_film(figure, force, shot.seconds))


def _title(question: Question) -> Label:
    if isinstance(question, Request):
        return captions.caption(question, chosen=True)
    return question.subject.caption(question)


def mechanism_drawing(crank: Crank, angles: Sequence[Fraction], lang: str, *look: Any) -> Drawing:
    """Return the crank drive to scale at crank angles, the first one strong."""
    from kurbel.plot.standing import SlideStanding

    kind = WORDS["offset drive" if crank.offset else "drive"][lang]
    offset = f", $e = {plain(crank.offset)} R$" if crank.offset else ""
    title = kind + for_ratio(crank.ratio, lang) + offset
    return _standing(SlideStanding(float(crank.ratio), float(crank.offset)), title, angles, lang, *look)


def arc_drawing(crank: RockerCrank, angles: Sequence[Fraction], lang: str, *look: Any) -> Drawing:
    """Return the arc crank to scale, likewise."""
    from kurbel.plot.standing import RockerStanding

    rocker = f"${crank.letter} = {plain(crank.rocker)} R$"
    title = f"{crank.noun[lang]}{for_ratio(crank.crank.ratio, lang)}, {rocker}"
    return _standing(RockerStanding(crank), title, angles, lang, *look)


def links_drawing(drive: Linkage, angles: Sequence[Fraction], lang: str, *look: Any) -> Drawing:
    """Return a drive to scale by its outline, likewise."""
    from kurbel.plot.standing import LinksStanding

    outline = drive.outline()
    assert outline is not None
    ratio = for_ratio(drive.crank.ratio, lang) if drive.crank.ratio else ""
    return _standing(LinksStanding(outline), outline.title[lang] + ratio, angles, lang, *look)


def _standing(
    standing: Standing,
    title: Label,
    angles: Sequence[Fraction],
    lang: str,
    mark: str,
    size: Size = USUAL,
    paths: Sequence[Coupled] = (),
) -> Drawing:
    if len(angles) > MOST_POSITIONS:
        raise ProblemError(
            f"a drawing of {len(angles)} crank angles was asked for;"
            f" at most {MOST_POSITIONS} can be told apart"
        )
    check_angles(angles)
    figure = standing.drawn(angles, lang, mark, size, paths)
    at = "; ".join(degrees(angle, mark) for angle in angles)
    return Drawing(figure, title + _of_paths(paths, lang), f"{PHI[lang]} {at}")


def _of_paths(paths: Sequence[Coupled], lang: str) -> Label:
    """Return what the title says of the paths of points of the rod."""
    if not paths:
        return ""
    points = "; ".join(one.label for one in paths)
    return WORDS["path" if len(paths) == 1 else "paths"][lang].format(points=points)
