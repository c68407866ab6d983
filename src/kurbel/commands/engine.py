"""Engines and driven machines, and how evenly they turn."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, TypedDict, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.diagram.given import Diagram, foreign, is_diagram, needless
from kurbel.commands.engine_pages.layouts import has_wheel, layout_of_delta, layout_of_turning
from kurbel.commands.machines import (
    EXAMPLE,
    engine_of,
    is_heavy,
    needless_of_load,
    whole_cycle,
)
from kurbel.commands.old_motion import STEP, meant, of_other_mechanisms
from kurbel.commands.options import FLAG, Choice, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import (
    Exact,
    as_angle,
    as_angles,
    as_names,
)

if TYPE_CHECKING:
    from kurbel.drive.wheel import Wheel

# What a page without forces takes for the masses' sake alone.
ONLY_MASSES = ("stroke", "rod", "bore", "pressure")
WITH_MASSES = "with masses the power follows from pressure, bore, stroke and speed; leave --power out"
ORDER = (
    "ratio back exponent clearance card other_side single_acting cranks method reciprocating rod_mass centre"
    " gyration rod_file vertical slope gravity friction stroke crank true_stroke time_ratio rod"
    " bore pressure piston_rod tail_rod offset mechanism rocker pivot circuit beam rocker_inertia"
)
# Pages of an engine, and those of one with its flywheel.
DELTA = ("irregularity", "strokes", "evenness", "compressor", "pump", "gas cycle", "cylinders")
TURNING = ("turning", "speed")
WITH_WHEEL = ("speed", "evenness")


class Wheeled(TypedDict, total=False):
    """A flywheel, and what it turns against."""

    flywheel: Annotated[
        Exact | None,
        Option("Flywheel, for the speed over the turn: its number m₁v₁²/(P r), 50.", "M"),
    ]
    inertia: Annotated[
        Exact | None,
        Option(
            "The same by its moment of inertia: 1200kgm2. It needs --speed, and --power or the bore and the"
            " pressure.",
            "J", unit="kg m²",
        ),
    ]  # fmt: skip
    power: Annotated[
        Exact | None, Option("Power of the engine, for --inertia: 50kW, 68PS.", "POWER", unit="W")
    ]
    resistance: Annotated[
        str | None,
        Option(
            "Torque that the engine turns against: constant (default), or square of the speed.",
            kind=Choice("resistance", "kurbel.drive.wheel:RESISTANCES"),
        ),
    ]


class Turning(engines.Engine, Wheeled, total=False):
    """An engine with its flywheel."""


class AnyTurning(Turning, Diagram, total=False):
    """The same, or a diagram in place of the engine."""


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives."""
    return of_other_mechanisms(values, meant(values, layout=None), ("stroke", "speed", "method"))


def _of_wheel(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says nothing beside a flywheel or without one, and a flywheel of which nothing is asked."""
    given = [name for name in ("flywheel", "inertia") if values[name] is not None]
    # With the rod the stroke gives the ratio.
    both = ("stroke", "rod") if is_given(values["stroke"]) and is_given(values["rod"]) else ()
    only = tuple(name for name in ONLY_MASSES if name not in both)
    counted = "inertia" in given and not is_given(values["power"])
    sizes = () if counted else (*(() if given else ("speed",)), *only)
    refused = {**beside_wheel(values)}
    if any(values[name] is not None for name in sizes):
        from kurbel.commands.engine_pages.sizes import needless_sizes

        refused |= needless_sizes(values, sizes, partial(_page, values))
    if given and (instead := _without_wheel(values)):
        refused |= {name: f"--{name} says nothing on this page; {instead}" for name in given}
    return refused


def beside_wheel(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes a flywheel further, where there is none or none of that kind."""
    refused = {**needless_of_load(values)}
    if values["inertia"] is None:
        refused["power"] = "--power is for --inertia, whose flywheel is weighed against it; leave it out"
    if is_heavy(values):
        refused["power"] = WITH_MASSES
    if not has_wheel(values):
        refused["resistance"] = "--resistance is for a flywheel; add --flywheel or --inertia"
    return refused


def _page(values: Mapping[str, Any], names: Sequence[str]) -> Layout:
    """Return the layout of a page, of the turning effort or of the irregularity."""
    if "angle" in values:
        return layout_of(values["layout"] or layout_of_turning(values), TURNING, values["layouts"])
    return layout_of(values["layout"] or layout_of_delta(values, names), DELTA, values["layouts"])


def _without_wheel(values: Mapping[str, Any]) -> str:
    """Return how a flywheel would be used, where nothing that is asked for has to do with it."""
    from kurbel.engine.speed.quantities import of_runs

    if values.get("detail"):
        return "leave --detail or the flywheel out"
    layout, names = values["layout"], as_names(values["columns"], EXAMPLE)
    if (
        layout
        and layout_of(layout, ("turning", *DELTA, "speed"), values["layouts"]).subject not in WITH_WHEEL
    ):
        return f"leave --layout {layout} or the flywheel out"
    example = "speed" if "angle" in values else "delta_mean"
    return "" if not names or of_runs() & {*names} else f"add a column such as {example}"


@makes_table(foreign=_foreign, needless=_of_wheel, order=ORDER)
def delta_table(
    eps: option.Eps = None,
    *,
    speed: option.PlainSpeed = None,
    detail: Annotated[
        bool, Option("All that leads to δ: angles and speeds of both strokes.", kind=FLAG)
    ] = False,
    columns: Annotated[option.Names, option.columns_option("weisbach-150", "epsilon,delta,mean_force")] = (),
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option(*DELTA)] = None,
    **given: Unpack[Turning],
) -> Question:
    """Print the degree of irregularity δ of an engine or a driven machine: of steam over the expansion
    ratio ε, of a compressor over its pressure ratio, of a pump, of the cycle of a gas engine.

    \b
    kurbel delta --eps 2..6
    kurbel delta --pressure-ratio 2..6 --exponent 1.3 --clearance 4%
    kurbel delta --pump --cranks '0;90'
    kurbel delta --compression 5..8 --heat 10
    kurbel delta --eps 2 --detail
    kurbel delta --eps 2..6 --method exact --method series --method weisbach
    kurbel delta --eps 2..8 --ratio '1:4;1:5;1:∞' --back 0.1 -f latex -o anhang.tex
    kurbel delta --eps 4 --cranks '0;90' --detail
    kurbel delta --eps 2..6 --flywheel 50
    kurbel delta --eps 4 --inertia 3584.3kgm2 --power 50kW --speed 120/min
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.delta_table("2..4"), "csv"), end="")
    epsilon,ratio,delta
    2,1:5,1.282
    3,1:5,1.374
    4,1:5,1.423
    >>> page = kurbel.delta_table(pressure_ratio="2..4", columns="pressure_ratio,mean_force,delta")
    >>> print(kurbel.typeset(page, "csv"), end="")
    pressure_ratio,mean_force,delta
    2,-0.4413,1.282
    3,-0.6994,1.374
    4,-0.8825,1.423
    """
    names = as_names(columns, EXAMPLE)
    if detail and layout not in (None, "delta-detail"):
        raise ProblemError(f"--detail is layout delta-detail, and --layout names {layout}; leave one out")
    about = {**given, "eps": eps, "speed": speed}
    page = layout_of(layout or layout_of_delta({**about, "detail": detail}, names), DELTA, layouts)
    return engine_of(page, about, _asked(page), columns=names, wheel=_wheel(page, about))


def _asked(page: Layout) -> Any:
    """Return what a list of cylinders is asked as, None of another page."""
    if page.subject != "cylinders":
        return None
    from kurbel.engine.cylinders.page import CylindersRequest

    return CylindersRequest


@makes_table(foreign=foreign(_foreign), needless=needless(_of_wheel), order=ORDER)
def turning_table(
    eps: option.Eps = None,
    *,
    speed: option.PlainSpeed = None,
    angle: Annotated[
        option.Given | None,
        option.ANGLE._replace(
            help="Crank angles in degrees: 22.5, 2°30', lists '0;45;90', ranges 0..360:10."
        ),
    ] = None,
    step: Annotated[
        Exact | None,
        option.STEP._replace(help="Step of the angles through the whole turn; default 10."),
    ] = None,
    columns: Annotated[option.Names, option.columns_option("turning", "phi,tangential,energy")] = (),
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option(*TURNING, "torques", "areas")] = None,
    **given: Unpack[AnyTurning],
) -> Question:
    """Print the turning effort of an engine or a driven machine: tangential force and excess energy over the
    crank angle; without an engine a turning-moment diagram, by its torque or its areas.

    \b
    kurbel turning --eps 4 --ratio 1:5
    kurbel turning --pressure-ratio 3 --clearance 5%
    kurbel turning --eps 4 --cranks '0;90' --step 15
    kurbel turning --eps 4 --step 0.5 -f csv -o drehkraft.csv
    kurbel turning --eps 4 --flywheel 50 --columns phi,speed
    kurbel turning --torque '5000 + 1500 sin(3φ)' --load-torque '5000 + 600 sin φ'
    kurbel turning --torque '0:0; 60:90; 180:0; 360:0' --cranks '0;120;240'
    kurbel turning --areas '+52;-124;+92;-140;+85;-72;+107' --area-scale '500 N m; 6°'
    """
    if is_diagram(given) or layout in ("torques", "areas"):
        from kurbel.commands.diagram.page import diagram_asked

        pages = {"layouts": layouts, "layout": layout}
        return diagram_asked({**given, **pages, "speed": speed, "angle": angle, "step": step}, columns)
    page = layout_of(layout or layout_of_turning(given), TURNING, layouts)
    cycle = whole_cycle({**given, "eps": eps})
    if step is not None:
        if angle is not None:
            raise ProblemError(
                "--angle lists the angles and --step runs through the turn; use one or the other"
            )
        angles: Sequence[Fraction] = notation.progression(Fraction(0), cycle, as_angle(step, "step"))
    elif angle is None and cycle > 360:
        angles = notation.progression(Fraction(0), cycle, STEP)
    else:
        angles = as_angles(page.angles if angle is None else angle)
    about = {**given, "eps": eps, "speed": speed}
    names = as_names(columns, EXAMPLE)
    return engine_of(page, about, angles=angles, columns=names, wheel=_wheel(page, about))


def _wheel(page: Layout, given: Mapping[str, Any]) -> "Wheel | None":
    """Return the flywheel that options describe, of a page on which it says something."""
    if page.subject not in WITH_WHEEL:
        return None
    from kurbel.drive.wheel import given_wheel

    return given_wheel(given, is_heavy(given))
