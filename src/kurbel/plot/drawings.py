"""Drawings of what was asked for: each a figure, and a title for readers that do not see it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion import captions
from kurbel.motion.page import Request
from kurbel.page.quantity import for_ratio, words
from kurbel.page.subject import Question
from kurbel.plot.mechanism import mechanism
from kurbel.plot.plotting import Panel, curves
from kurbel.plot.polar import Vector, polar
from kurbel.plot.ticks import Across
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kurbel.linkage.arc.rocker import RockerCrank
    from kurbel.linkage.linkage import Linkage

MOST_POSITIONS = 36
WORDS = {
    "drive": words("Kurbeltrieb|Crank drive"),
}
# The diagram turns with the crank.
POLAR_TITLE = words(
    "Polardiagramm der Kraft am Kurbelzapfen im Achsenkreuz der Kurbel"
    "|Polar diagram of the force on the crank pin, in the frame of the crank"
)
# The directions of its axes, across and up.
POLAR_WAYS = {"de": ("im Drehsinn", "zur Welle"), "en": ("as the crank turns", "towards the shaft")}


class Drawing(NamedTuple):
    figure: Figure
    title: Label


def curves_drawing(
    question: Question, panels: Sequence[Panel], mark: str, across: Across | None = None
) -> Drawing:
    """Return the curves of what was asked for over the crank angle, or over another axis."""
    return Drawing(curves(panels, question.lang, mark, across), _title(question))


def polar_drawing(question: Question, force: tuple[Vector, tuple[Label, Label], Label], mark: str) -> Drawing:
    """Return the polar diagram of the force on the crank pin, of which names and unit are given."""
    vector, (across, up), unit = force
    figure = polar(vector, across, up, unit, mark, POLAR_WAYS[question.lang])
    return Drawing(figure, f"{POLAR_TITLE[question.lang]}: {_title(question)}")


def _title(question: Question) -> Label:
    if isinstance(question, Request):
        return captions.caption(question, chosen=True)
    return question.subject.caption(question)


def mechanism_drawing(crank: Crank, angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return the crank drive to scale at crank angles, the first one strong."""
    _check_positions(angles)
    figure = mechanism(float(crank.ratio), float(crank.offset), angles, lang, mark)
    return Drawing(figure, WORDS["drive"][lang] + for_ratio(crank.ratio, lang))


def arc_drawing(crank: RockerCrank, angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return the arc crank to scale, likewise."""
    from kurbel.plot.arc import arc_mechanism

    _check_positions(angles)
    rocker = f"${crank.letter} = {plain(crank.rocker)} R$"
    title = f"{crank.noun[lang]}{for_ratio(crank.crank.ratio, lang)}, {rocker}"
    return Drawing(arc_mechanism(crank, angles, lang, mark), title)


def links_drawing(drive: Linkage, angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return a drive to scale by its outline, likewise."""
    from kurbel.plot.links import outlined

    _check_positions(angles)
    outline = drive.outline()
    assert outline is not None
    ratio = for_ratio(drive.crank.ratio, lang) if drive.crank.ratio else ""
    return Drawing(outlined(outline, angles, mark), outline.title[lang] + ratio)


def _check_positions(angles: Sequence[Fraction]) -> None:
    if len(angles) > MOST_POSITIONS:
        raise ProblemError(
            f"a drawing of {len(angles)} crank angles was asked for;"
            f" at most {MOST_POSITIONS} can be told apart"
        )
    check_angles(angles)
