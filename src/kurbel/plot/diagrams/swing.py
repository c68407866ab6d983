"""How the excess energy swings over a cycle: by how much, and where it is greatest and least."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from math import ceil, floor
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.engine.diagram.captions import place_text, shown
from kurbel.engine.digits import Asked, estimated, settled
from kurbel.engine.quantities import ENGINE_METHODS, Where
from kurbel.exact.kind import Kind, floats
from kurbel.exact.numerals import Label, Number, degrees_text, number_text
from kurbel.page.quantity import Column, Formula, bare, entry
from kurbel.plot.chart.model import Panel, Spot, Swing
from kurbel.plot.ticks import amount

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn
    from kurbel.engine.diagram.page import TorquesRequest
    from kurbel.engine.request import EngineRequest

# Which end of the swing is the greatest, as engines name what is of it.
ENDS = {"least": False, "greatest": True}


class Swinging(NamedTuple):
    """The swing with its ends as they are drawn; none of part of a cycle that lacks one of them."""

    spots: list[Spot]
    swing: Swing | None


def engine_swing(turn: AnyTurn, energy: Column, request: EngineRequest) -> Swinging:
    """Return the swing of an engine's excess energy, a column of the request, as a share of its unit."""

    def number(of: str, value: Callable[[AnyTurn], Any], decimals: int | None, unit: int = 1) -> str:
        formulas = dict.fromkeys(ENGINE_METHODS, Formula(lambda turn, where: value(turn)))
        asked = entry("energy_swing", "", "", "", decimals, formulas, of=of, minutes=of in ENDS)
        column = bare(asked, turn.method, decimals)
        settle = estimated if request.carded else settled
        found = settle(Asked(column, (turn,), Where(), unit), request.rounding)
        # A card may leave no figure, and a swing is never 0.
        return _text(found, unit) if found is not None and (found.scaled or of in ENDS) else ""

    spots: list[Spot] = []
    cycle = 180 * turn.cycle
    for of, greatest in ENDS.items():
        peaks = turn.peaks(greatest)
        level = float(turn.extreme(greatest).energy)
        for peak in peaks:
            text = number(of, partial(_degrees, peak.place), 0, 60)
            spots.extend(_turned(180 * float(peak.place), level, text, cycle, request.angles))
    # Of W/(Q r) that is (ΔW)/(Q r).
    letter, _, unit = energy.heading[0][1:-1].partition("/")
    said, found = f"(Δ{letter})/{unit}", number("turn", _swing, energy.decimals)
    return _swinging(spots, f"${said} = {found}$" if found else f"${said}$")


def diagram_swing(request: TorquesRequest, panel: Panel) -> Panel:
    """Return the panel of the excess energy of a diagram with its swing."""
    excess, power, times = request.excess, panel.power, request.of_page("J")
    spots: list[Spot] = []

    def swing(kind: Kind) -> Any:
        return excess.swing(kind) * kind.of(times * Fraction(10) ** -power)

    for greatest in ENDS.values():
        level = float(times) * float(excess.extreme_energy(floats(), greatest=greatest))
        for one in excess.extremes(greatest=greatest):
            assert one.degrees is not None
            angle = float(one.degrees(floats()))
            text = f"${place_text(one).removesuffix('°')}$°"
            spots.extend(_turned(angle, level, text, int(excess.cycle), request.angles))
    number, unit = amount(shown(swing), panel.unit, power)
    found = _swinging(spots, f'$ΔW = {number} "{unit}"$')
    return panel._replace(spots=found.spots, swing=found.swing)


def _degrees(half_turns: Any, turn: AnyTurn) -> Any:
    return 180 * half_turns


def _swing(turn: AnyTurn) -> Any:
    return turn.extreme(greatest=True).energy - turn.extreme(greatest=False).energy


def _text(number: Number, unit: int) -> Label:
    """Return a number, of minutes in degrees."""
    if unit == 1:
        return number_text(number)
    return (
        degrees_text(Fraction(number.scaled, unit)) if number.scaled % unit else f"{number.scaled // unit}°"
    )


def _turned(angle: float, level: float, text: Label, cycle: int, angles: Any) -> Iterator[Spot]:
    """Yield a place as often as it comes again in the drawn angles; the first within a cycle has its text."""
    first, last = float(angles[0]), float(angles[-1])
    turns = range(ceil((first - angle) / cycle), floor((last - angle) / cycle) + 1)
    for turn in turns:
        yield Spot(angle + turn * cycle, level, "" if turn else text)


def _swinging(spots: list[Spot], text: Label) -> Swinging:
    levels = {one.value for one in spots}
    if len(levels) < len(ENDS):
        return Swinging(spots, None)
    return Swinging(spots, Swing(min(levels), max(levels), text))
