"""What drawings show over the strokes of a piston: the pressures on it, that of the masses laid under the
indicator diagram, and the forces of an engine, the strokes of a cycle over one another.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import groupby
from math import cos, pi
from typing import TYPE_CHECKING

from kurbel.engine.captions import inner
from kurbel.engine.pressures import Pressed, PressuresRequest, Where, is_carded, stroke_names
from kurbel.engine.request import EngineRequest
from kurbel.engine.texts import PRESSED
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls, floats
from kurbel.kernel.circle import circle
from kurbel.plot.engine import around, course_of, lettered, turns_of
from kurbel.plot.over_path import STROKE
from kurbel.plot.panel import Around, Curve, Panel, Strokes, Trace, panels_of
from kurbel.plot.picture import Picture, Wish, asked_of, refuse
from kurbel.plot.sketch import DEAD_CENTRES
from kurbel.plot.ticks import Across, plain_ticks

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn

# So many steps of a stroke make its curves smooth; they are closer near the dead centres.
STEPS = 120


def over_stroke(request: PressuresRequest, wish: Wish) -> Picture:
    """Return what is drawn of the pressures: those of the page, over each stroke."""
    sentence = "pressures are drawn over the strokes; leave {} out"
    refuse(wish, infinite=sentence.format("--infinite"), over_path=sentence.format("--over-path"))
    keys = tuple(one.key for one in request.page_columns if one.quantity.plain_unit("en") != "°")
    if not keys:
        raise ProblemError("there is no pressure to draw; name one, such as --columns gas_pressure")
    asked = asked_of(request, columns=keys)
    return Picture(asked, pressure_panels(asked), Around(across=across_stroke(request.lang)))


def pressure_panels(request: PressuresRequest) -> list[Panel]:
    """Return a panel for each stroke, over the share of the outstroke: a return runs back over it.

    The request has the columns that are drawn.
    """
    names, lang = stroke_names(request.pressed.cycle, request.lang), request.lang
    columns, times = request.page_columns, float(request.of_page("bar"))
    # Their letters stand beside the curves.
    said = PRESSED["pressures"][lang] if len(columns) > 1 else inner(columns[0].quantity.name[lang], lang)
    panels = []
    for stroke, name in enumerate(names):
        places = [Where(stroke, share) for share in _shares(request.pressed, stroke)]
        # From left to right.
        places = places[::-1] if stroke % 2 else places
        across = [
            float(1 - one.share if stroke % 2 else one.share) for one in places if one.share is not None
        ]
        curves = [
            Curve(
                column.quantity.symbol,
                across,
                [times * _value(request.pressed, column.key, one) for one in places],
            )
            for column in columns
        ]
        panels.append(Panel(curves, f"{name}: {said}", columns[0].quantity.plain_unit(lang)))
    return panels


def across_stroke(lang: str) -> Across:
    """Return the axis of the share of the stroke."""
    return Across(f"{PRESSED['share'][lang]} $x/S$", plain_ticks)


def _shares(pressed: Pressed, stroke: int) -> list[Fraction]:
    """Return rising shares of a stroke, the corners of the force among them."""
    even = [Fraction(1 - cos(pi * step / STEPS)) / 2 for step in range(STEPS + 1)]
    corners: list[Fraction] = []
    if pressed.engine is not None:
        acting = pressed.engine.steam.strokes(floats(), pressed.engine.double)[stroke]
        # An indicator card has points in place of corners.
        corners = [Fraction(float(one)) for one in getattr(acting, "corners", ())]
    within = sorted({share for share in (*even, *corners) if 0 <= share <= 1})
    return [share for share, _ in groupby(within)]


def _value(pressed: Pressed, key: str, where: Where) -> float:
    carded = is_carded(pressed)
    masses = 0.0 if key == "gas_pressure" else float(pressed.masses(where, balls()))
    if key == "inertia_pressure":
        return masses
    kind: Kind = floats() if carded else balls()
    return float(pressed.gas(where, kind)) - masses


def force_panels_over_path(request: EngineRequest) -> list[Panel]:
    """Return the panels of forces over the share of the stroke of the first crank's piston."""
    turns = turns_of(request)
    traces = []
    for column in lettered(request):
        for label, turn in turns:
            course = course_of((column.quantity,), turn, request.angles)
            traces.append(Trace(column.quantity, (label,), _gone(turn, course.angles), course.values[0]))
    return panels_of(traces, request.lang, apart=len(turns) > 1)


def around_path(request: EngineRequest) -> Around:
    """Return what stands around them: what the engines have in common, the stroke, the axis."""
    dead = [DEAD_CENTRES[which][request.lang] for which in ("inner", "outer")]
    whole = Strokes((0.0, 1.0), dead, [STROKE[request.lang]])
    strokes = whole if request.angles[-1] - request.angles[0] >= 180 else None
    return around(request, strokes=False)._replace(strokes=strokes, across=across_stroke(request.lang))


def _gone(turn: AnyTurn, angles: Iterable[float]) -> list[float]:
    """Return how much of its stroke the piston has gone from the inner dead centre at angles in degrees."""
    moved = turn.cylinder.drive
    return [float(moved.path(0, circle(angle))) / float(moved.length) for angle in angles]
