"""What drawings show of a steam engine: its turning effort over the crank angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import product
from math import ceil, floor
from typing import TYPE_CHECKING

from kurbel.engine_axes import expansion_label
from kurbel.engine_captions import inner
from kurbel.engine_quantities import Where
from kurbel.engine_request import EngineColumn, EngineRequest
from kurbel.notation import ratio_text
from kurbel.plot_curves import check_drawn, degrees
from kurbel.plotting import Curve, Panel
from kurbel.table import Label
from kurbel.turn import Turn, turn_of

if TYPE_CHECKING:
    from kurbel.card_turn import CardTurn

# The columns of a request for these panels.
COLUMNS = ("tangential", "mean_force", "energy")


def turning_panels(request: EngineRequest) -> list[Panel]:
    """Return a panel of the tangential force, of a single engine with its mean, and one of the excess energy.

    The request has the columns `COLUMNS`. The curves have the points of cut-off besides those at its angles.
    Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, len(request.steams) * len(request.drives))
    method = (request.methods or ("exact",))[0]
    places = product(range(len(request.steams)), range(len(request.drives)))
    turns = [(_label(request, *place), turn_of(request.engine(*place), method)) for place in places]
    effort, mean, energy = request.page_columns
    heading = _name(effort, request.lang)
    forces = [_curve(effort, label, turn, request.angles) for label, turn in turns]
    energies = [_curve(energy, label, turn, request.angles) for label, turn in turns]
    if len(turns) == 1:
        turn = turns[0][1]
        ends = (request.angles[0], request.angles[-1])
        level = Curve(mean.heading[0], degrees(ends), _values(mean, turn, ends))
        forces = [forces[0]._replace(label=effort.heading[0]), level]
        heading += f", {inner(_name(mean, request.lang), request.lang)}"
    return [Panel(forces, heading), Panel(energies, _name(energy, request.lang))]


def _label(request: EngineRequest, steam: int, drive: int) -> Label:
    """Return what tells an engine from the others."""
    parts = []
    if len(request.steams) > 1:
        label = expansion_label(request, steam)
        parts.append(label if request.carded else f"$ε = {label.strip('$')}$")
    if len(request.drives) > 1:
        parts.append(f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[drive])}$")
    return ", ".join(parts)


def _name(column: EngineColumn, lang: str) -> Label:
    return f"{column.quantity.name[lang]} {column.heading[0]}"


def _curve(column: EngineColumn, label: Label, turn: Turn | CardTurn, angles: Sequence[Fraction]) -> Curve:
    places = sorted({*angles, *_corners(turn, angles[0], angles[-1])})
    return Curve(label, degrees(places), _values(column, turn, places))


def _values(column: EngineColumn, turn: Turn | CardTurn, angles: Sequence[Fraction]) -> list[float]:
    return [float(column.quantity.value(turn, Where(half_turns=angle / 180))) for angle in angles]


def _corners(turn: Turn | CardTurn, first: Fraction, last: Fraction) -> Iterator[Fraction]:
    """Yield the angles of cut-off between two: a curve that leaves them out has no sharp tips."""
    if isinstance(turn, Turn):
        for start, stroke in product(turn.engine.cranks, (0, 1)):
            corner = start + 180 * (stroke + Fraction(float(turn.cut_off(stroke))))
            turns = range(ceil((first - corner) / 360), floor((last - corner) / 360) + 1)
            yield from (corner + 360 * turned for turned in turns)
