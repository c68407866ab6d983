"""The pressures on the piston of one cylinder: a table of them, and a drawing."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.drawn.size import Sized, page_size
from kurbel.commands.loads import FURTHER, OWN, PARTS, astray, uncounted
from kurbel.commands.machines import STEAM, engine_of, for_masses, is_heavy, lone_lengths, weighed
from kurbel.commands.old_motion import described, of_other_mechanisms, sheet_of
from kurbel.commands.options import is_given
from kurbel.commands.plots import AxisUnits, DrawnSpeed, LabelLang
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws
from kurbel.drive.load import MASSES
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import uncomputed
from kurbel.page.layouts import Layout
from kurbel.page.layouts import layout as layout_named
from kurbel.reading.given import as_length

if TYPE_CHECKING:
    from kurbel.engine.pressures.pressed import Pressed

# The layouts over the stroke and over the crank angle, and what they are about.
PRESSURES, PRESSURES_ABOUT = ("pressures", "pressures-turn"), ("pressures", "pressures over the angle")
# The options that name a load.
LOADS = tuple(OWN)


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives."""
    return of_other_mechanisms({**values, "layout": None}, shared=("stroke", "speed"))


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says nothing of the masses or of the load, where there are none."""
    refused = {**for_masses("speed")(values), **({} if is_heavy(values) else lone_lengths(values))}
    if any(is_given(values[name]) for name in LOADS):
        return {**refused, **uncounted(values)}
    of_steam = ("pressure", *(name for name in STEAM if name not in FURTHER))
    steam = {
        name: f"--{name.replace('_', '-')} is for the steam of an engine; add --eps or --card"
        for name in of_steam
    }
    return {**refused, **steam, **{name: astray(name) for name in PARTS}}


class DrawnPiston(engines.Cylinder, engines.MovingRod, option.AnyDrive, Sized, total=False):
    """The pressures on a piston, as they are drawn."""

    ratio: option.Ratios
    speed: DrawnSpeed
    reciprocating: option.Reciprocating
    lang: LabelLang
    units: AxisUnits
    decimal: option.Decimal


@draws(foreign=_foreign, needless=_needless)
def plot_pressures(eps: option.Eps = None, **given: Unpack[DrawnPiston]) -> Drawing:
    """Draw the acceleration pressure under the indicator diagram, over the stroke: what the masses take of
    the pressure on the piston, and what is left."""
    from kurbel.commands.plots import page_of
    from kurbel.engine.pressures.page import PressuresRequest, registry
    from kurbel.plot.chart.model import Around
    from kurbel.plot.drawings import curves_drawing
    from kurbel.plot.pressures import across_stroke, pressure_panels

    mark, lang, page = mark_of(given["lang"], given["decimal"]), given["lang"], page_of("pressures")
    pressed = pressed_of(page, {**given, "eps": eps})
    asked = PressuresRequest(layout=page, pressed=pressed, shares=(Fraction(0),), **sheet_of(given))
    drawn = tuple(key for key, one in registry().items() if one.needs and not asked.missing(one))
    question = replace(asked, columns=drawn)
    around = Around(across=across_stroke(lang))
    drawing = curves_drawing(question, pressure_panels(question), mark, around, page_size(given))
    return Drawing.of(drawing, lang, mark)


def pressed_of(page: Layout, given: Mapping[str, Any]) -> "Pressed":
    """Return the one cylinder that options describe, with its masses, its load or both."""
    from kurbel.engine.pressures.pressed import Pressed

    bore = None if given["bore"] is None else as_length(given["bore"], "bore")
    if any(is_given(given.get(name)) for name in LOADS):
        about = engine_of(layout_named("engine-forces"), {**given, "method": ()})
        _check_one(about.steams, "loads")
        _check_one(about.drives, "crank ratios")
        return Pressed(about.drives[0], bore, about.first.parts[0])
    chosen, said = described({**given, "speed": None, "method": None, "force": None, "layout": None})
    chosen.check(said)
    if sentence := uncomputed(chosen, MASSES):
        raise ProblemError(sentence)
    drives = weighed(chosen, chosen.drives(said, page.ratios), given, "bore")
    _check_one(drives, "crank ratios")
    return Pressed(drives[0], bore)


def _check_one(given: Sequence[Any], what: str) -> None:
    if len(given) != 1:
        raise ProblemError(
            f"pressures are those of one cylinder, and {len(given)} {what} were given; give one"
        )
