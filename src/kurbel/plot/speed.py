"""What drawings show of the speed over the turn of an engine with a given flywheel."""

from __future__ import annotations

from fractions import Fraction

from kurbel.drive.wheel import Wheel
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.quantities import speed_registry
from kurbel.engine.speed.run import run_of
from kurbel.plot.engine import turns_of
from kurbel.plot.panels import degrees
from kurbel.plot.plotting import Curve, Panel


def speed_panel(request: EngineRequest, wheel: Wheel) -> Panel:
    """Return a panel of v/v₁, with all engines in it. Raises ProblemError for too light a flywheel."""
    speed = speed_registry()["speed"]
    curves = []
    for label, turn in turns_of(request):
        run = run_of(turn, wheel)
        values = [float(run.speed(Fraction(angle) / 180)) for angle in request.angles]
        curves.append(Curve(label, degrees(request.angles), values))
    return Panel(curves, f"{speed.name[request.lang]} {speed.symbol}")
