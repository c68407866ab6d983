"""What drawings show of a steam engine: its forces and turning effort over the turn, how the excess energy
swings over a cycle, and the force on the pin.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import product
from math import radians
from typing import TYPE_CHECKING, NamedTuple

from kurbel.engine.captions import common, inner, named_load
from kurbel.engine.cylinder import TurnPlace
from kurbel.engine.diagram.fluctuation import place_text, shown
from kurbel.engine.digits import CellValue, estimated, settled
from kurbel.engine.engine_quantities import ENGINE_METHODS, EXTREMES, engine_registry, value
from kurbel.engine.pressures import stroke_names
from kurbel.engine.request import EngineRequest
from kurbel.engine.turn import Turn, turn_of
from kurbel.exact.kind import Kind, floats
from kurbel.exact.numerals import Label, Number, degrees_text, number_text
from kurbel.kernel.circle import Numeric
from kurbel.page.quantity import Column, Formula, Of, Quantity, bare, entry
from kurbel.plot.drawings import (
    DrawingWish,
    Picture,
    asked_of,
    check_one,
    columns_of,
    drawing_layout,
    refuse,
    smooth,
)
from kurbel.plot.panel import (
    PIN_FORCE,
    Curve,
    HorizontalAxis,
    MarkedPoint,
    Panel,
    PanelFrame,
    PinForce,
    Strokes,
    Swing,
    Trace,
    again,
    amount,
    check_drawn,
    in_floats,
    named_again,
    panels_of,
    plain_ticks,
    strokes_between,
    vector,
)
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn
    from kurbel.engine.diagram.diagram_page import TorquesRequest


class Swinging(NamedTuple):
    """The swing with its ends as they are drawn; none of part of a cycle that lacks one of them."""

    spots: list[MarkedPoint]
    swing: Swing | None


def engine_swing(turn: AnyTurn, energy: Column, request: EngineRequest) -> Swinging:
    """Return the swing of an engine's excess energy, a column of the request, as a share of its unit."""

    def number(of: Of, value: Callable[[AnyTurn], Numeric], decimals: int | None, unit: int = 1) -> str:
        formulas = dict.fromkeys(ENGINE_METHODS, Formula(lambda turn, where: value(turn)))
        asked = entry("energy_swing", "", "", "", decimals, formulas, of=of, minutes=of in EXTREMES)
        column = bare(asked, turn.method, decimals)
        settle = estimated if request.carded else settled
        found = settle(CellValue(column, (turn,), TurnPlace(), unit), request.rounding)
        # A card may leave no figure, and a swing is never 0.
        return _text(found, unit) if found is not None and (found.scaled or of in EXTREMES) else ""

    spots: list[MarkedPoint] = []
    cycle, span = 180 * turn.cycle, _span(request)
    for of, greatest in EXTREMES.items():
        peaks = turn.peaks(greatest)
        level = float(turn.extreme(greatest).energy)
        for peak in peaks:
            text = number(of, partial(_degrees, peak.place), 0, 60)
            spots.extend(named_again(180 * float(peak.place), level, cycle, span, text))

    def swing(turn: AnyTurn) -> Numeric:
        return turn.extreme(greatest=True).energy - turn.extreme(greatest=False).energy

    # Of W/(Q r) that is (ΔW)/(Q r).
    letter, _, unit = energy.heading[0][1:-1].partition("/")
    said, found = f"(Δ{letter})/{unit}", number(Of.TURN, swing, energy.decimals)
    return _swinging(spots, f"${said} = {found}$" if found else f"${said}$")


def diagram_swing(request: TorquesRequest, panel: Panel) -> Panel:
    """Return the panel of the excess energy of a diagram with its swing."""
    excess, power, times = request.excess, panel.power, request.of_page("J")
    spots: list[MarkedPoint] = []
    span = _span(request)

    def swing(kind: Kind) -> Numeric:
        return excess.swing(kind) * kind.of(times * Fraction(10) ** -power)

    for greatest in EXTREMES.values():
        level = float(times) * float(excess.extreme_energy(floats(), greatest=greatest))
        for one in excess.extremes(greatest=greatest):
            assert one.degrees is not None
            angle = float(one.degrees(floats()))
            text = f"${place_text(one).removesuffix('°')}$°"
            spots.extend(named_again(angle, level, int(excess.cycle), span, text))
    number, unit = amount(shown(swing), panel.unit, power)
    found = _swinging(spots, f'$ΔW = {number} "{unit}"$')
    return panel._replace(spots=found.spots, swing=found.swing)


def _degrees(half_turns: Numeric, turn: AnyTurn) -> Numeric:
    return 180 * half_turns


def _text(number: Number, unit: int) -> Label:
    """Return a number, of minutes in degrees."""
    if unit == 1:
        return number_text(number)
    return (
        degrees_text(Fraction(number.scaled, unit)) if number.scaled % unit else f"{number.scaled // unit}°"
    )


def _swinging(spots: list[MarkedPoint], text: Label) -> Swinging:
    levels = {one.value for one in spots}
    if len(levels) < len(EXTREMES):
        return Swinging(spots, None)
    return Swinging(spots, Swing(min(levels), max(levels), text))


INFINITE = "--infinite is for the motion alone; of engines write --ratio 1:∞"
# The columns of a request for the turning effort.
TURNING = ("tangential", "mean_force", "energy")
# The crank radius where a formula has it as r.
_RADIUS = re.compile(r"(?<![A-Za-z_])r(?![A-Za-z])")
# Half turns before a dead centre at which a force still has the value from which it jumps there.
BEFORE = Fraction(1, 10**12)
# A jump of so small a share of the greatest value is none.
NO_JUMP = 1e-9


class Course(NamedTuple):
    """Values of quantities at rising angles in degrees; an angle comes twice where one of them jumps."""

    angles: list[float]
    values: list[list[float]]


def forces(request: EngineRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of the forces of an engine, those of the first crank: the columns of the page."""
    refuse(wish, infinite=INFINITE)
    if wish.polar:
        check_one(len(request.steams), request.words.several)
        check_one(len(request.drives), "crank ratios")
        newtons = "_n" if request.knows("piston_force_n") else ""
        keys = tuple(f"{key}{newtons}" for key in PIN_FORCE)
        asked = asked_of(request, columns=keys, angles=smooth(request.angles))
        return Picture(asked, force=engine_pin_force(asked))
    keys = tuple(one.key for one in columns_of(request))
    asked = asked_of(request, columns=keys, angles=smooth(request.angles))
    if wish.over_path:
        from kurbel.plot.over_path import around_path, force_panels_over_path

        return Picture(asked, force_panels_over_path(asked), around_path(asked))
    return Picture(asked, force_panels(asked), around(asked, strokes=True), columns=lettered(asked))


def effort(request: EngineRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of the turning effort: unless columns are named its mean and the excess energy,
    hatched, and with a flywheel the speed."""
    refuse(wish, infinite=INFINITE)
    if request.columns and "angle" in request.axes:
        found = forces(request, wish._replace(over_path=False))
        panels, beside = found.panels, around(request, strokes=False)
    else:
        whole = Fraction(0), Fraction(180 * request.turn(0, 0, "exact").cycle)
        turn = request.angles if "angle" in request.axes else whole
        asked = asked_of(request, layout=drawing_layout("turning"), columns=TURNING, angles=smooth(turn))
        panels, beside = turning_panels(asked), around(asked, strokes=False)
        found = Picture(asked, columns=lettered(asked))
        if asked.wheel is not None:
            from kurbel.plot.diagrams import speed_panel

            known = "speed" if asked.wheel.speed is None else "rpm"
            asked = replace(asked, layout=drawing_layout("speed"), columns=(*TURNING, known))
            panels, found = [*panels, speed_panel(asked)], Picture(asked, columns=lettered(asked))
    if wish.over_path:
        panels, beside = over_path(panels), beside._replace(across=across_path(request.lang))
    return found._replace(panels=panels, around=beside)


def lettered(request: EngineRequest) -> list[Column]:
    """Return the columns of a request in the letters of all drawings: the crank radius is R."""
    columns = []
    for one in request.page_columns:
        quantity = one.quantity
        heading, unit = (
            {lang: _RADIUS.sub("R", label) for lang, label in words.items()}
            for words in (quantity.heading, quantity.unit)
        )
        own = quantity._replace(heading=heading, unit=unit)
        above = tuple(_RADIUS.sub("R", label) for label in one.heading)
        columns.append(one._replace(quantity=own, heading=above))
    return columns


def force_panels(request: EngineRequest) -> list[Panel]:
    """Return a panel for each force, with all engines in it; of one engine, a panel for each unit.

    The curves have the dead centres and the points of cut-off besides the angles of the request. Raises
    ProblemError for one angle, or more than can be drawn.
    """
    turns = turns_of(request)
    traces = (
        Trace(column.quantity, (label,), *_course(column, turn, request))
        for column in lettered(request)
        for label, turn in turns
    )
    return panels_of(traces, request.lang, apart=len(turns) > 1)


def turning_panels(request: EngineRequest) -> list[Panel]:
    """Return a panel of the tangential force, of a single engine with its mean, and one of the excess energy,
    of a single one with its swing.

    The request has the columns `TURNING`. The curves have the dead centres and the points of cut-off besides
    those at its angles. Raises ProblemError for one angle, or more than can be drawn.
    """
    turns, lang = turns_of(request), request.lang
    effort, mean, energy = columns = lettered(request)
    forces, energies = (
        [Curve(label, *_course(column, turn, request)) for label, turn in turns]
        for column in (effort, energy)
    )
    force, level, excess = (f"{one.quantity.name[lang]} {one.heading[0]}" for one in columns)
    if len(turns) > 1:
        return [Panel(forces, force), Panel(energies, excess)]
    ends = in_floats([request.angles[0], request.angles[-1]])
    number = request.number(mean, {"expansion": 0, "ratio": 0, "angle": 0})
    said = (
        f"{mean.heading[0][:-1]} = {number_text(number)}$" if isinstance(number, Number) else mean.heading[0]
    )
    line = Curve(said, ends, [float(turns[0][1].mean_force())] * 2)
    forces = [forces[0]._replace(label=effort.heading[0]), line]
    swinging = engine_swing(turns[0][1], energy, request)
    return [
        Panel(forces, f"{force}, {inner(level, lang)}", areas=True),
        Panel(energies, excess, spots=swinging.spots, swing=swinging.swing),
    ]


def over_path(panels: Sequence[Panel]) -> list[Panel]:
    """Return panels over the path s/R of the crank pin, the developed crank circle, in place of the angle."""
    return [
        one._replace(
            curves=[
                curve._replace(angles=[radians(angle) for angle in curve.angles]) for curve in one.curves
            ],
            spots=[spot._replace(angle=radians(spot.angle)) for spot in one.spots],
        )
        for one in panels
    ]


def around(request: EngineRequest, strokes: bool) -> PanelFrame:
    """Return what the engines have in common: expansion or the like, and the crank ratio; of a single one
    also the strokes of its first cylinder."""
    turns = turns_of(request) if strokes else []
    return PanelFrame(", ".join(common(request)), _strokes(turns[0][1], request) if len(turns) == 1 else None)


def across_path(lang: str) -> HorizontalAxis:
    """Return the axis of that path, in the letters of all drawings."""
    return HorizontalAxis(f"{engine_registry()['pin_path'].name[lang]} $s/R$", plain_ticks)


def engine_pin_force(request: EngineRequest) -> PinForce:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has one engine and the columns of `PIN_FORCE`.
    """
    ((_, turn),) = turns_of(request)
    quantities = [column.quantity for column in request.page_columns]
    course, strokes = course_of(quantities, turn, request.angles), _strokes(turn, request)
    return vector(quantities, request.lang, *course, strokes)


def _strokes(turn: AnyTurn, request: EngineRequest) -> Strokes:
    """Return the strokes of the first cylinder, from the one in which the angles begin to that in which they
    end."""
    drive, names = turn.cylinder.drive, stroke_names(turn.cycle, request.lang)
    begun = 180 * float(drive.dead_centre(0)), 180 * float(drive.dead_centre(1))
    return strokes_between(begun, names, _span(request), request.lang)


def _span(request: EngineRequest | TorquesRequest) -> tuple[float, float]:
    return float(request.angles[0]), float(request.angles[-1])


def turns_of(request: EngineRequest) -> list[tuple[Label, AnyTurn]]:
    """Return the engines, each with what tells it from the others."""
    places = [*product(range(len(request.steams)), range(len(request.drives)))]
    check_drawn(request.angles, len(places))
    method = (request.methods or ("exact",))[0]
    return [(engine_label(request, *place), turn_of(request.engine(*place), method)) for place in places]


def _course(column: Column, turn: AnyTurn, request: EngineRequest) -> tuple[list[float], list[float]]:
    angles, (values,) = course_of((column.quantity,), turn, request.angles)
    return angles, values


def engine_label(request: EngineRequest, steam: int, drive: int) -> Label:
    """Return what tells an engine from the others."""
    parts = []
    if len(request.steams) > 1:
        parts.append(named_load(request, steam))
    if len(request.drives) > 1:
        parts.append(f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[drive])}$")
    return ", ".join(parts)


def course_of(quantities: Sequence[Quantity], turn: AnyTurn, angles: Sequence[Fraction]) -> Course:
    """Return quantities at the angles, and at the dead centres and the points of cut-off between them.

    At a dead centre the steam changes sides: there the first values are those before, the second those after.
    """
    first, last = angles[0], angles[-1]
    dead = set(_dead_centres(turn, first, last))
    # A cut-off comes from floats: where one is at 60°, it and the angle 60 are one place.
    near = {round(float(place), 9): place for place in (*_cut_offs(turn, first, last), *angles, *dead)}
    places = [near[place] for place in sorted(near)]
    after = {place: _values(quantities, turn, place / 180) for place in places}
    most = [max(map(abs, column)) for column in zip(*after.values(), strict=True)]
    rows: list[tuple[Fraction, list[float]]] = []
    for place in places:
        before = _values(quantities, turn, place / 180 - BEFORE) if place in dead else after[place]
        jumps = _jumps(before, after[place], most)
        if jumps and place > first:
            rows.append((place, before))
        if not jumps or place < last:
            rows.append((place, after[place]))
    values = zip(*(row for _, row in rows), strict=True)
    return Course(in_floats([angle for angle, _ in rows]), [list(column) for column in values])


def _jumps(before: Sequence[float], after: Sequence[float], most: Sequence[float]) -> bool:
    parts = zip(before, after, most, strict=True)
    return any(abs(later - earlier) > NO_JUMP * greatest for earlier, later, greatest in parts)


def _values(quantities: Sequence[Quantity], turn: AnyTurn, half_turns: Fraction) -> list[float]:
    return [float(value(quantity, turn, TurnPlace(half_turns=half_turns))) for quantity in quantities]


def _dead_centres(turn: AnyTurn, first: Fraction, last: Fraction) -> Iterator[Fraction]:
    """Yield the dead centres of all cranks between two angles."""
    for place in turn.dead_centres():
        yield from again(180 * place, 180 * turn.cycle, first, last)


def _cut_offs(turn: AnyTurn, first: Fraction, last: Fraction) -> Iterator[Fraction]:
    """Yield the angles of cut-off between two: a curve that leaves them out has no sharp tips."""
    if isinstance(turn, Turn):
        for place in turn.corners():
            yield from again(180 * place, 180 * turn.cycle, first, last)
