"""Drawings of what was asked for: each a figure, and a title for readers that do not see it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion import captions
from kurbel.motion.question import Request
from kurbel.page.quantity import for_ratio, words
from kurbel.plot.curves import motion_panels, pin_force
from kurbel.plot.mechanism import mechanism
from kurbel.plot.plotting import curves
from kurbel.plot.polar import Vector, polar
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kurbel.engine.request import EngineRequest
    from kurbel.linkage.arc import ArcCrank
    from kurbel.linkage.page import LinkageRequest

MOST_POSITIONS = 36
WORDS = {
    "drive": words("Kurbeltrieb|Crank drive"),
    "arc": words("Bogenschubkurbel|Arc crank"),
    "parallel": words("Parallelkurbel|Parallel crank"),
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


def motion_drawing(question: Request | LinkageRequest, mark: str) -> Drawing:
    """Return the curves of all columns over the crank angle."""
    return Drawing(curves(motion_panels(question), question.lang, mark), _title(question))


def polar_drawing(request: Request, mark: str) -> Drawing:
    """Return the polar diagram of the force on the crank pin of a request for `pin_force_keys`."""
    return _polar(pin_force(request), _title(request), request.lang, mark)


def engine_polar_drawing(request: EngineRequest, mark: str) -> Drawing:
    """Return the polar diagram of the force on the crank pin of an engine, for `plot_engine.PIN_FORCE`."""
    from kurbel.engine.captions import caption
    from kurbel.plot.engine import engine_pin_force

    return _polar(engine_pin_force(request), caption(request), request.lang, mark)


def _polar(force: tuple[Vector, tuple[Label, Label], Label], title: Label, lang: str, mark: str) -> Drawing:
    vector, (across, up), unit = force
    figure = polar(vector, across, up, unit, mark, POLAR_WAYS[lang])
    return Drawing(figure, f"{POLAR_TITLE[lang]}: {title}")


def engine_forces_drawing(request: EngineRequest, mark: str) -> Drawing:
    """Return the curves of an engine's forces over the crank angle."""
    from kurbel.engine.captions import caption
    from kurbel.plot.engine import force_panels

    return Drawing(curves(force_panels(request), request.lang, mark), caption(request))


def mechanism_drawing(crank: Crank, angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return the crank drive to scale at crank angles, the first one strong."""
    _check_positions(angles)
    figure = mechanism(float(crank.ratio), float(crank.offset), angles, lang, mark)
    return Drawing(figure, WORDS["drive"][lang] + for_ratio(crank.ratio, lang))


def arc_drawing(crank: ArcCrank, angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return the arc crank to scale, likewise."""
    from kurbel.plot.arc import arc_mechanism

    _check_positions(angles)
    rocker = f"$B = {plain(crank.rocker)} R$"
    title = f"{WORDS['arc'][lang]}{for_ratio(crank.crank.ratio, lang)}, {rocker}"
    return Drawing(arc_mechanism(crank, angles, lang, mark), title)


def parallel_drawing(angles: Sequence[Fraction], lang: str, mark: str) -> Drawing:
    """Return the parallel crank to scale, likewise."""
    from kurbel.plot.parallel import parallel_mechanism

    _check_positions(angles)
    return Drawing(parallel_mechanism(angles, mark), WORDS["parallel"][lang])


def _check_positions(angles: Sequence[Fraction]) -> None:
    if len(angles) > MOST_POSITIONS:
        raise ProblemError(
            f"a drawing of {len(angles)} crank angles was asked for;"
            f" at most {MOST_POSITIONS} can be told apart"
        )
    check_angles(angles)


def turning_drawing(request: EngineRequest, mark: str) -> Drawing:
    """Return the turning effort of the engines of a request for `plot_turning.COLUMNS`."""
    from kurbel.engine.captions import caption
    from kurbel.plot.turning import turning_panels

    return Drawing(curves(turning_panels(request), request.lang, mark), caption(request))


def _title(question: Request | LinkageRequest) -> Label:
    if isinstance(question, Request):
        return captions.caption(question, chosen=True)
    return question.subject.caption(question)
