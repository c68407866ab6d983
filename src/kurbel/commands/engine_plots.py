"""Drawings of a steam engine: the forces in its crank drive, and its turning effort."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import Rods, Rubbing
from kurbel.commands.cylinder.given import Cylinders, Of
from kurbel.commands.cylinder.slope import Lying
from kurbel.commands.diagram.given import Diagram, foreign, is_diagram, needless
from kurbel.commands.drawn.film import Filmed, curves_of, polar_of, still
from kurbel.commands.drawn.size import Sized
from kurbel.commands.drives.given import PATH
from kurbel.commands.engine import Wheeled, beside_wheel
from kurbel.commands.engine_pages.layouts import has_wheel
from kurbel.commands.machines import (
    engine_of,
    for_masses,
    is_heavy,
    load_of,
    needless_of_load,
    over_cycle,
    unsized,
)
from kurbel.commands.old_motion import of_other_mechanisms
from kurbel.commands.plots import (
    AxisUnits,
    CurveStep,
    DrawnColumns,
    DrawnSpeed,
    LabelLang,
    Over,
    curve_angles,
    only,
    page_of,
)
from kurbel.commands.shown import Drawing
from kurbel.commands.subject import draws
from kurbel.errors import ProblemError
from kurbel.reading.given import as_names

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest

# The pages whose forces can be drawn, without masses and with them.
ENGINE_LAYOUT, MACHINE_LAYOUT = "engine-forces", "machine-forces"


class Drawn(
    engines.Cylinder, engines.MovingRod, Lying, Rods, Rubbing, option.AnyDrive, Sized, Filmed, total=False
):
    """An engine, as it is drawn."""

    cylinder: Cylinders
    ratio: option.Ratios
    method: option.Method
    from_: option.From
    to: option.To
    step: CurveStep
    speed: DrawnSpeed
    reciprocating: option.Reciprocating
    rotating: option.Rotating
    rocker_inertia: option.RockerInertia
    lang: LabelLang
    units: AxisUnits
    decimal: option.Decimal


class DrawnOver(Over, Drawn, total=False):
    """The same, over the crank angle or the piston's path."""


class DrawnTurning(Over, Drawn, Wheeled, Diagram, total=False):
    """An engine with its flywheel, or a diagram in place of the engine."""


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives."""
    return {**of_other_mechanisms(values, shared=("stroke", "speed", "method")), **still(values)}


def _alone(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse sizes, a speed and pressures that nothing on the drawing is counted in."""
    return {**unsized(values), **for_masses("speed")(values), **needless_of_load(values)}


@draws(foreign=_foreign, needless=_alone)
def plot_engine_forces(
    eps: option.Eps = None, *, of: Of = None, columns: DrawnColumns = (), **given: Unpack[DrawnOver]
) -> Drawing:
    """Draw the forces in the crank drive of a steam engine, those of the first crank."""
    from kurbel.plot.engine import FORCES, around, force_panels, lettered

    question = _force_question({**given, "eps": eps, "of": of}, FORCES, columns)
    if given["over"] == PATH:
        from kurbel.plot.over.engine import around_path, force_panels_over_path

        panels, beside = force_panels_over_path(question), around_path(question)
        return curves_of(question, panels, beside, given)
    beside = around(question, strokes=True)
    return curves_of(question, force_panels(question), beside, given, lettered(question))


@draws(foreign=_foreign, needless=_alone)
def plot_engine_polar(eps: option.Eps = None, *, of: Of = None, **given: Unpack[Drawn]) -> Drawing:
    """Draw the polar diagram of the force on the crank pin of a steam engine."""
    from kurbel.plot.engine import PIN_FORCE, engine_pin_force

    question = _force_question({**given, "eps": eps, "of": of}, PIN_FORCE)
    only(question.steams, "polar", question.words.several)
    only(question.drives, "polar", "ratios")
    return polar_of(question, engine_pin_force(question), given)


# What says something of diagrams without an engine, too.
_OF_DIAGRAMS = ("from", "to", "over", "units", "decimal", *Sized.__annotations__, *Filmed.__annotations__)


def _beside_wheel(values: Mapping[str, Any]) -> Mapping[str, str]:
    return {**({} if has_wheel(values) else _alone(values)), **beside_wheel(values)}


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    return {**needless(_beside_wheel)(values), **still(values)}


@draws(foreign=foreign(_foreign, *_OF_DIAGRAMS), needless=_needless)
def plot_turning(
    eps: option.Eps = None,
    *,
    cranks: option.Cranks = None,
    **given: Unpack[DrawnTurning],
) -> Drawing:
    """Draw the turning effort of a steam engine: tangential force, its mean and the excess energy, with a
    flywheel the speed as well. Without an engine, draw a turning-moment diagram and its load.
    """
    from kurbel.plot.chart.model import NOTHING_AROUND
    from kurbel.plot.engine import TURNING, across_path, around, lettered, over_path, turning_panels

    lang, over = given["lang"], given["over"]
    about, wheel = {**given, "eps": eps, "cranks": cranks}, None
    if is_diagram(given):
        from kurbel.commands.diagram.page import diagram_drawn
        from kurbel.plot.diagrams.torques import diagram_panels

        asked = diagram_drawn(about)
        panels, beside = diagram_panels(asked), NOTHING_AROUND
        if over == PATH:
            panels, beside = over_path(panels), beside._replace(across=across_path(lang))
        return curves_of(asked, panels, beside, given)
    if has_wheel(given):
        from kurbel.drive.wheel import given_wheel

        wheel = given_wheel(given, is_heavy(given))
    question = _question("turning", about, TURNING, wheel=wheel)
    panels, beside = turning_panels(question), around(question)
    if wheel is not None:
        from kurbel.plot.speed import speed_panel

        shown = "speed" if wheel.speed is None else "rpm"
        question = _question("speed", about, (*TURNING, shown), wheel=wheel)
        panels.append(speed_panel(question))
    if over == PATH:
        panels, beside = over_path(panels), beside._replace(across=across_path(lang))
    return curves_of(question, panels, beside, given, lettered(question))


def _force_question(
    given: Mapping[str, Any], keys: tuple[str, ...], columns: option.Names = ()
) -> "EngineRequest":
    """Return what is asked for of the forces named, or of these, in newtons where the load is known."""
    from kurbel.plot.engine import known_forces

    names = as_names(columns, "piston_force,tangential_force")
    newtons = load_of(given) is not None
    layout = MACHINE_LAYOUT if is_heavy(given) else ENGINE_LAYOUT
    return _question(layout, given, names or known_forces(keys, newtons))


def _question(
    layout: str, given: Mapping[str, Any], columns: tuple[str, ...], **rest: Any
) -> "EngineRequest":
    angles, method = curve_angles(over_cycle(given)), given["method"]
    if method == "infinite":
        raise ProblemError("--method infinite is for the motion alone; of engines write --ratio 1:∞")
    about = {**given, "method": method and (method,)}
    return engine_of(page_of(layout), about, angles=angles, columns=columns, **rest)
