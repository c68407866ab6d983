"""What drawings show of a steam engine: its turning effort over the crank angle."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

from kurbel.engine.captions import inner
from kurbel.engine.request import EngineRequest
from kurbel.engine.turn import turn_of
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Column
from kurbel.plot.engine import course_of, engine_label
from kurbel.plot.panels import check_drawn, degrees
from kurbel.plot.plotting import Curve, Panel

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn

# The columns of a request for these panels.
COLUMNS = ("tangential", "mean_force", "energy")


def turning_panels(request: EngineRequest) -> list[Panel]:
    """Return a panel of the tangential force, of a single engine with its mean, and one of the excess energy.

    The request has the columns `COLUMNS`. The curves have the dead centres and the points of cut-off besides
    those at its angles. Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, len(request.steams) * len(request.drives))
    method = (request.methods or ("exact",))[0]
    places = product(range(len(request.steams)), range(len(request.drives)))
    turns = [(engine_label(request, *place), turn_of(request.engine(*place), method)) for place in places]
    effort, mean, energy = request.page_columns
    heading = _name(effort, request.lang)
    forces = [_curve(effort, label, turn, request) for label, turn in turns]
    energies = [_curve(energy, label, turn, request) for label, turn in turns]
    if len(turns) == 1:
        level = float(turns[0][1].mean_force())
        ends: list[Fraction] = [request.angles[0], request.angles[-1]]
        forces = [
            forces[0]._replace(label=effort.heading[0]), Curve(mean.heading[0], degrees(ends), [level] * 2)
        ]  # fmt: skip
        heading += f", {inner(_name(mean, request.lang), request.lang)}"
    return [Panel(forces, heading), Panel(energies, _name(energy, request.lang))]


def _name(column: Column, lang: str) -> Label:
    return f"{column.quantity.name[lang]} {column.heading[0]}"


def _curve(column: Column, label: Label, turn: AnyTurn, request: EngineRequest) -> Curve:
    course = course_of((column.quantity,), turn, request.angles)
    return Curve(label, course.angles, course.values[0])
