"""The forces of an engine over its piston's path: the strokes of a cycle over one another."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from kurbel.engine.request import EngineRequest
from kurbel.kernel.circle import circle
from kurbel.plot.chart.model import Around, Panel, Strokes
from kurbel.plot.engine import around, course_of, lettered, turns_of
from kurbel.plot.over.path import STROKE
from kurbel.plot.panels import Trace, panels_of
from kurbel.plot.pressures import across_stroke
from kurbel.plot.sketch import DEAD_CENTRES

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn


def force_panels_over_path(request: EngineRequest) -> list[Panel]:
    """Return the panels of forces over the share of the stroke of the first crank's piston."""
    turns = turns_of(request)
    traces = []
    for column in lettered(request):
        for label, turn in turns:
            course = course_of((column.quantity,), turn, request.angles)
            traces.append(Trace(column.quantity, (label,), _shares(turn, course.angles), course.values[0]))
    return panels_of(traces, request.lang, apart=len(turns) > 1)


def around_path(request: EngineRequest) -> Around:
    """Return what stands around them: what the engines have in common, the stroke, the axis."""
    dead = [DEAD_CENTRES[which][request.lang] for which in ("inner", "outer")]
    whole = Strokes((0.0, 1.0), dead, [STROKE[request.lang]])
    strokes = whole if request.angles[-1] - request.angles[0] >= 180 else None
    return around(request)._replace(strokes=strokes, across=across_stroke(request.lang))


def _shares(turn: AnyTurn, angles: Iterable[float]) -> list[float]:
    """Return how much of its stroke the piston has gone from the inner dead centre at angles in degrees."""
    moved = turn.cylinder.drive
    return [float(moved.path(0, circle(angle))) / float(moved.length) for angle in angles]
