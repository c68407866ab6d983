"""What drawings show of turning-moment diagrams: torques, the excess energy, the speed of a flywheel."""

from __future__ import annotations

from fractions import Fraction
from itertools import chain
from typing import Any

from kurbel.engine.diagram.diagram_page import TorquesRequest
from kurbel.engine.diagram.excess import ExcessTorque
from kurbel.engine.diagram.fluctuation import shown
from kurbel.engine.diagram.torque import Torque
from kurbel.engine.diagram.wheel_page import WheelRequest
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.run import Run, run_of
from kurbel.engine.speed.speed_page import speed_registry
from kurbel.exact.kind import Kind, floats
from kurbel.page.quantity import words
from kurbel.plot.drawings import DrawingWish, Picture, asked_of, drawing_layout, refuse, smooth
from kurbel.plot.engine import across_path, diagram_swing, over_path, turns_of
from kurbel.plot.pages import over_axes
from kurbel.plot.panel import Curve, Panel, again, amount, axis_name, check_drawn, in_floats, power_of_curves

# By the column that is drawn the letter of its mean, half the sum of the extremes.
MEANS = {"rpm": "$n_m$", "speed": "$v_m/v_1$"}
OF_MEAN = words(", Mittel |, mean ")


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
        curves.append(Curve(engine, in_floats(request.angles), values))
    if len(runs) == 1:
        (run,) = (run for _, run in runs)
        mean = float(run.extreme_speed(greatest=True) + run.extreme_speed(greatest=False)) / 2
        ends = in_floats([request.angles[0], request.angles[-1]])
        curves = [curves[0]._replace(label=heading), Curve(MEANS[key], ends, [_unity(run) * mean] * 2)]
        label += f"{OF_MEAN[request.lang]}{MEANS[key]}"
    return Panel(curves, label, unit)


def _unity(run: Run) -> float:
    """Return what is drawn for v₁."""
    if run.wheel.speed is None:
        return 1.0
    return float(30 * run.first_omega / run.turn.pi)


# What is drawn; the speed of a flywheel where that and its mean are known.
DRAWN, SPEED = ("torque", "load_torque", "excess_energy"), "rpm"
MEAN, ENERGY = "$T_m$", "excess_energy"
TORQUES = words("Drehmomente|Torques")


def torques(request: TorquesRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of a turning-moment diagram: unless columns are named the torques, hatched, the
    excess energy and, of a flywheel, its speed."""
    refuse(wish, infinite="--infinite is for the motion of a crank drive; leave it out")
    columns = request.columns or (DRAWN if request.steady is None else (*DRAWN, SPEED))
    asked = asked_of(request, columns=columns, angles=smooth(request.angles))
    if request.columns:
        found = over_axes(asked, wish._replace(over_path=False))
    else:
        found = Picture(asked, diagram_panels(asked))
    if not wish.over_path:
        return found
    beside = found.around._replace(across=across_path(request.lang))
    return found._replace(panels=over_path(found.panels), around=beside)


def sizing(request: WheelRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of a flywheel without an engine: the diagram that it evens out, else what is
    printed over the irregularities to keep."""
    excess = request.fluctuation
    if not isinstance(excess, ExcessTorque) or request.columns:
        return over_axes(request, wish)
    even = {name: not (one.waves.orders or one.jumps or any(line.slope for line in one.lines))
            for name, one in (("load", excess.load), ("drive", excess.drive))}  # fmt: skip
    asked = TorquesRequest(
        layout=drawing_layout("torques"),
        excess=excess,
        angles=(Fraction(0), excess.cycle),
        constant=next((name for name, flat in even.items() if flat), ""),
        lang=request.lang,
        units=request.units,
        caption=request.caption,
    )
    return torques(asked, wish)


def diagram_panels(request: TorquesRequest) -> list[Panel]:
    """Return a panel of both torques and, where both were given, their mean, one of the excess energy
    and, of a flywheel, one of its speed.

    The request has the columns `DRAWN`, and `SPEED` where it is known. The curves have the corners and jumps
    of the torques besides the angles. Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, 3)
    excess, lang = request.excess, request.lang
    drive, load, *others = (column.quantity for column in request.page_columns)
    both = [
        Curve(one.symbol, *_course(torque, request))
        for one, torque in ((drive, excess.drive), (load, excess.load))
    ]
    mean = f" = {_mean(request, drive.plain_unit(lang), power_of_curves(both))}$"
    if not request.constant:
        ends = in_floats([request.angles[0], request.angles[-1]])
        level = float(request.of_page("N m") * Fraction(float(excess.mean_torque(floats()))))
        both.append(Curve(f"{MEAN[:-1]}{mean}", ends, [level] * 2))
    else:
        flat = 1 if request.constant == "load" else 0
        both[flat] = both[flat]._replace(label=f"{both[flat].label[:-1]}{mean}")
    panels = [Panel(both, TORQUES[lang], drive.plain_unit(lang), areas=True)]
    places = _places(excess.excess, request)
    for one in others:
        name, heading, unit = axis_name(one, lang)
        kernel = one.formulas["exact"].kernel
        values = [float(kernel(request, place, floats())) for place in places]
        panels.append(Panel([Curve("", in_floats(places), values)], f"{name} {heading}", unit))
        if one.key == ENERGY:
            panels[-1] = diagram_swing(request, panels[-1])
    return panels


def _mean(request: TorquesRequest, unit: str, power: int) -> str:
    """Return the mean of the torques with its unit, as it stands in a formula."""
    excess, times = request.excess, request.of_page("N m") * Fraction(10) ** -power

    def torque(kind: Kind) -> Any:
        return excess.mean_torque(kind) * kind.of(times)

    number, named = amount(shown(torque), unit, power)
    return f'{number} "{named}"'


def _places(torque: Torque, request: TorquesRequest) -> list[Fraction]:
    """Return the angles with those at which the torque has corners."""
    first, last = request.angles[0], request.angles[-1]
    corners = (again(one.start, int(torque.cycle), first, last) for one in torque.lines)
    return sorted({*request.angles, *chain.from_iterable(corners)})


def _course(torque: Torque, request: TorquesRequest) -> tuple[list[float], list[float]]:
    """Return angles and values of a torque; at a jump both values, the first that before."""
    angles, values, kind, times = [], [], floats(), float(request.of_page("N m"))
    for place in _places(torque, request):
        drop = torque.jump(place)
        value = times * float(request.excess.torque(torque, place, kind))
        if drop and place > request.angles[0]:
            # No torque of triangles jumps, whose unit would be another.
            angles.append(place)
            values.append(value - times * float(drop))
        if not drop or place < request.angles[-1]:
            angles.append(place)
            values.append(value)
    return in_floats(angles), values
