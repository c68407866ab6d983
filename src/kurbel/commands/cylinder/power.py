"""The power of a cylinder, and the sizes that a power asks for."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import RODS, Rods
from kurbel.commands.cylinder.needless import needless
from kurbel.commands.loads import OWN, pressures_of
from kurbel.commands.machines import steams_of
from kurbel.commands.old_motion import sheet_of
from kurbel.commands.options import Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.drive.load import CARD, PUMP
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import (
    Exact,
    as_crank_angles,
    as_density,
    as_length,
    as_names,
    as_number,
    as_power,
    as_pressure,
    as_ratios,
    as_share,
    as_specific_volume,
    as_speed,
    as_velocity,
)

if TYPE_CHECKING:
    from kurbel.engine.engine import Engine
    from kurbel.engine.power.duty import Duty
    from kurbel.engine.power.source import Acting, GivenPressure

NEEDED = (
    "the power needs what acts on the piston: --eps with --pressure, --mean-pressure with --working-strokes,"
    " --card, --pressure-ratio, --pump or --compression"
)


class Powered(option.OnMachine, engines.Cylinder, Rods, option.Sheet, total=False):
    """A cylinder, what acts in it, and the power it is to have."""

    cranks: option.Cranks
    crank: option.Crank
    layouts: option.Layouts


@makes_table(
    needless=needless,
    order="mean_pressure working_strokes pressure back exponent clearance single_acting card ratio"
    " bore piston_rod tail_rod stroke crank speed power brake_power stroke_bore piston_speed cylinders"
    " diagram_factor efficiency specific_volume steam_density",
)
def power_table(
    eps: option.Eps = None,
    *,
    mean_pressure: Annotated[
        Exact | None,
        Option(
            "The mean effective pressure itself, with --working-strokes: 5bar; '3.5bar;3.2bar' of the ends at"
            " the cover and at the crank.",
            "PRESSURE",
            unit="Pa",
        ),
    ] = None,
    working_strokes: Annotated[
        Exact | None,
        Option(
            "With --mean-pressure: working strokes of a cylinder in a turn: 2 of a double-acting one, 1, or"
            " 0.5 of four strokes.",
            "NUMBER",
        ),
    ] = None,
    ratio: Annotated[
        option.Given | None,
        option.RATIO._replace(help="Crank ratio, for a card over the crank angle: 1:5."),
    ] = None,
    stroke: Annotated[Exact | None, Option("Stroke of the piston: 450mm.", "LENGTH", unit="m")] = None,
    speed: option.PlainSpeed = None,
    power: Annotated[
        Exact | None,
        Option("Indicated power, to find the sizes or the speed: 75kW, 100PS.", "POWER", unit="W"),
    ] = None,
    brake_power: Annotated[
        Exact | None, Option("In its place the power at the shaft, with --efficiency.", "POWER", unit="W")
    ] = None,
    stroke_bore: Annotated[
        Exact | None, Option("Stroke over bore, where sizes are to be found: 1.5.", "RATIO")
    ] = None,
    piston_speed: Annotated[
        Exact | None,
        Option("Mean piston speed in place of the stroke or the speed: 3m/s.", "VELOCITY", unit="m/s"),
    ] = None,
    cylinders: Annotated[Exact | None, Option("Number of cylinders alike; default 1.", "NUMBER")] = None,
    diagram_factor: Annotated[
        Exact | None,
        Option(
            "Area of the real card in that of the ideal one: 0.8, or ? to find it from a power; default 1,"
            " the ideal card.",
            "SHARE",
        ),
    ] = None,
    efficiency: Annotated[
        Exact | None, Option("Mechanical efficiency, for the power at the shaft: 85%.", "SHARE")
    ] = None,
    specific_volume: Annotated[
        Exact | None,
        Option("Of the steam before cut-off, for the steam taken: '0.24 m3/kg'.", "VOLUME", unit="m³/kg"),
    ] = None,
    steam_density: Annotated[
        Exact | None, Option("In its place the density: '4.16 kg/m3'.", "DENSITY", unit="kg/m³")
    ] = None,
    columns: Annotated[option.Names, option.columns_option("power", "mean_pressure,indicated_power")] = (),
    layout: Annotated[str, option.layout_option("power")] = "power",
    **given: Unpack[Powered],
) -> Question:
    """Print the mean effective pressure and the power of an engine, a compressor or a pump, or the bore,
    stroke or speed that a power asks for, and the steam taken.

    \b
    kurbel power --eps 3 --pressure 8bar --back 1.1bar --clearance 8% --diagram-factor 0.8
    kurbel power --eps 3 --pressure 8bar --back 1.1bar --bore 300mm --stroke 450mm --speed 200/min
    kurbel power --eps 3 --pressure 8bar --back 1.1bar --power 75kW --stroke-bore 1.5 --speed 250/min
    kurbel power --mean-pressure 5bar --working-strokes 2 --bore 300mm --stroke 450mm --speed 200/min
    kurbel power --compression 6 --heat 10 --suction-pressure 1bar --cylinders 4 --power 30kW \
--stroke-bore 1 --speed 3000/min
    \f
    >>> import kurbel
    >>> page = kurbel.power_table("1", pressure=5e5, back=0.2, bore=0.2, stroke=0.3, speed=2,
    ...                           columns="mean_pressure,indicated_power")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mean_pressure,indicated_power
    4.0000,15.080
    """
    from kurbel.engine.power.page import PowerRequest

    page = layout_of(layout, ("power",), given["layouts"])
    about = {**given, "eps": eps, "mean_pressure": mean_pressure, "working_strokes": working_strokes}
    sizes = {"bore": given["bore"], "stroke": stroke}
    duty = _duty(
        about,
        **{name: None if value is None else as_length(value, name) for name, value in sizes.items()},
        speed=None if speed is None else as_speed(speed),
        power=None if power is None else as_power(power),
        brake_power=None if brake_power is None else as_power(brake_power),
        stroke_bore=None if stroke_bore is None else as_share(stroke_bore, "stroke over bore"),
        piston_speed=None if piston_speed is None else as_velocity(piston_speed, "piston speed"),
        cylinders=_count(cylinders, given["cranks"]),
        **_rods(about),
        factor_asked=diagram_factor == "?",
        diagram_factor=Fraction(1)
        if diagram_factor in (None, "?")
        else as_share(diagram_factor, "diagram factor"),
        efficiency=None if efficiency is None else as_share(efficiency, "efficiency"),
        specific_volume=_volume(specific_volume, steam_density),
    )
    return PowerRequest(
        layout=page,
        sources=_sources(page, about, ratio, duty),
        duty=duty,
        columns=as_names(columns, "mean_pressure,indicated_power"),
        **sheet_of(given),
    )


def _rods(given: Mapping[str, Any]) -> dict[str, Fraction | None]:
    """Return the diameters of the piston's rods in metres, None where there is none."""
    found = {name: given[name] for name in RODS}
    return {
        name: None if rod is None else as_length(rod, name.replace("_", " ")) for name, rod in found.items()
    }


def _count(cylinders: Exact | None, cranks: Any) -> int:
    """Return how many cylinders there are, one for each crank where these are given."""
    of_cranks = len(as_crank_angles(cranks)) if is_given(cranks) else None
    if cylinders is None:
        return of_cranks or 1
    number = as_number(cylinders, "cylinders")
    if number.denominator != 1:
        raise ProblemError(f"the number of cylinders is {cylinders}; it must be a whole number")
    if of_cranks not in (None, number):
        raise ProblemError(f"--cylinders is {number}, and --cranks has {of_cranks} of them; leave one out")
    return int(number)


def _volume(volume: Exact | None, density: Exact | None) -> Fraction | None:
    if density is None:
        return None if volume is None else _positive(as_specific_volume(volume, "specific volume"))
    if volume is not None:
        raise ProblemError("--specific-volume and --steam-density say the same; leave one out")
    return 1 / _positive(as_density(density, "steam density"))


def _positive(value: Fraction) -> Fraction:
    if value <= 0:
        raise ProblemError("the specific volume and the density of steam must be above 0")
    return value


def _duty(given: Mapping[str, Any], **own: Any) -> "Duty":
    """Return what is given, with the pressure that mean pressures count in."""
    from kurbel.engine.power.duty import Duty

    if given["mean_pressure"] is not None:
        ends = given["mean_pressure"]
        parts = ends.split(";") if isinstance(ends, str) else [ends]
        if len(parts) > 2:
            raise ProblemError(f"{len(parts)} mean pressures were given; a piston has two ends")
        return Duty(ends=tuple(_above_zero(one, "mean pressure") for one in parts), **own)
    name = pressures_of(given)[0] if _is_other(given) else "pressure"
    pressure = None if given[name] is None else as_pressure(given[name], name.replace("_", " "))
    if name == "delivery_pressure" and pressure is not None and given["suction_pressure"] is not None:
        pressure -= as_pressure(given["suction_pressure"], "suction pressure")
    if pressure is not None and pressure <= 0:
        raise ProblemError(f"--{name.replace('_', '-')} is {given[name]}; it must be above 0")
    return Duty(pressure=pressure, pressure_option=f"--{name.replace('_', '-')}", **own)


def _above_zero(pressure: Exact, what: str) -> Fraction:
    found = as_pressure(pressure, what)
    if found <= 0:
        raise ProblemError(f"the {what} is {str(pressure)[:40]}; it must be above 0")
    return found


def _is_other(given: Mapping[str, Any]) -> bool:
    return any(is_given(given[key]) for key in OWN if key not in ("eps", "card"))


def _sources(
    page: Layout, given: Mapping[str, Any], ratio: option.Given | None, duty: "Duty"
) -> Sequence["Acting | GivenPressure"]:
    """Return where the mean pressures come from."""
    from kurbel.engine.power.source import Acting, GivenPressure

    named = [f"--{key.replace('_', '-')}" for key in OWN if is_given(given[key])]
    if given["mean_pressure"] is not None:
        if named:
            raise ProblemError(f"{named[0]} and --mean-pressure are two mean pressures; leave one out")
        if given["working_strokes"] is None:
            raise ProblemError(
                "--mean-pressure needs the working strokes of a turn; add --working-strokes: 2 of a"
                " double-acting cylinder, 1 of a single-acting one, 0.5 of one in four strokes"
            )
        return [GivenPressure(as_number(given["working_strokes"], "working strokes"))]
    if not named:
        raise ProblemError(NEEDED)
    loads = steams_of(given, page)
    double = getattr(loads[0], "double", not given["single_acting"])
    return [Acting(_engine(load, double, ratio, duty)) for load in loads]


def _engine(load: Any, double: bool, ratio: option.Given | None, duty: "Duty") -> "Engine":
    """Return an engine on which the load acts; of work alone the crank ratio says nothing."""
    from kurbel.drive.crank import Crank
    from kurbel.engine.engine import Engine, Load

    if load.name == CARD and ratio is None and hasattr(load.card, "angles"):
        raise ProblemError("a card over the crank angle needs the crank ratio; add --ratio, such as 1:5")
    ratios = (Fraction(0),) if ratio is None else as_ratios(ratio)
    if len(ratios) != 1:
        raise ProblemError(f"{len(ratios)} crank ratios were given; a card was taken from an engine of one")
    size = None
    if load.name == PUMP and duty.bore is not None and duty.pressure is not None:
        size = Load(duty.bore, duty.pressure)
    return Engine(Crank(ratios[0]), load, double, load=size)
