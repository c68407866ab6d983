"""What drawings show of the speed over the turn of an engine with a given flywheel."""

from __future__ import annotations

from fractions import Fraction

from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.quantities import speed_registry
from kurbel.engine.speed.run import AnyRun, run_of
from kurbel.page.quantity import words
from kurbel.plot.chart.model import Curve, Panel
from kurbel.plot.engine import turns_of
from kurbel.plot.panels import axis_name, degrees

# By the column that is drawn the letter of its mean, half the sum of the extremes.
MEANS = {"rpm": "$n_m$", "speed": "$v_m/v_1$"}
MEAN = words(", Mittel |, mean ")


def speed_panel(request: EngineRequest) -> Panel:
    """Return a panel of the speed with all engines in it, of a single one with its mean.

    It is in 1/min where the mean speed of the request's wheel is known, else in units of v₁. Raises
    ProblemError for too light a flywheel.
    """
    assert request.wheel is not None
    key = "speed" if request.wheel.speed is None else "rpm"
    name, heading, unit = axis_name(speed_registry()[key], request.lang)
    runs = [(label, run_of(turn, request.wheel)) for label, turn in turns_of(request)]
    label, curves = f"{name} {heading}", []
    for engine, run in runs:
        unity = _unity(run)
        values = [unity * float(run.speed(angle / 180)) for angle in map(Fraction, request.angles)]
        curves.append(Curve(engine, degrees(request.angles), values))
    if len(runs) == 1:
        (run,) = (run for _, run in runs)
        mean = float(run.extreme_speed(greatest=True) + run.extreme_speed(greatest=False)) / 2
        ends = degrees([request.angles[0], request.angles[-1]])
        curves = [curves[0]._replace(label=heading), Curve(MEANS[key], ends, [_unity(run) * mean] * 2)]
        label += f"{MEAN[request.lang]}{MEANS[key]}"
    return Panel(curves, label, unit)


def _unity(run: AnyRun) -> float:
    """Return what is drawn for v₁."""
    if run.wheel.speed is None:
        return 1.0
    return float(30 * run.first_omega / run.turn.pi)
