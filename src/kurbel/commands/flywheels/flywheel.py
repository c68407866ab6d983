"""The flywheel that keeps an engine even, and that of a problem without an engine."""

from collections.abc import Mapping
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import RODS, RUBBING
from kurbel.commands.diagram.given import Diagram, is_diagram
from kurbel.commands.engine import ORDER
from kurbel.commands.flywheels.options import Body, Press, Rim, Swing, Wheel
from kurbel.commands.loads import OWN
from kurbel.commands.machines import (
    EXAMPLE,
    engine_of,
    has_back_pressure,
    is_heavy,
    lone_lengths,
    needless_of_load,
    of_load,
)
from kurbel.commands.old_motion import meant, of_other_mechanisms, sheet_of
from kurbel.commands.options import Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_irregularities, as_length, as_names, as_power, as_speed

ENGINE, SIZING = "flywheel", "flywheel sizing"
WITH_MASSES = "with masses the power follows from pressure, bore, stroke and speed; leave --power out"
# What an engine's flywheel is not given by, and of this what says nothing by itself.
_OWN = tuple(name for group in (Diagram, Swing, Press, Body, Rim) for name in group.__annotations__)
_FURTHER = ("turns", "area_scale")


class Flywheel(engines.Engine, Wheel, total=False):
    """The flywheel of an engine, or one without."""


def _is_engine(values: Mapping[str, Any]) -> bool:
    """Whether the flywheel is that of an engine, which what acts on its pistons or the layout says."""
    if any(is_given(values[name]) for name in (*OWN, "cylinder")):
        return True
    layout = values["layout"]
    return bool(layout) and layout_of(layout, (ENGINE, SIZING), values["layouts"]).subject == ENGINE


def _of_others(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives, or an engine that there is not, or a flywheel without one."""
    if _is_engine(values):
        why = "is of a flywheel without an engine, and one is described; leave one of the two out"
        # An engine's flywheel has a rim as others.
        own = {name: f"--{name.replace('_', '-')} {why}" for name in _OWN if name not in Rim.__annotations__}
        return own | dict(
            of_other_mechanisms(values, meant(values, layout=None), ("stroke", "speed", "method"))
        )
    if not any(is_given(values[name]) for name in _OWN if name not in _FURTHER):
        return {}
    why = "is of an engine, and none is described; add --eps, --card or another load, or leave it out"
    kept = {
        *option.OnMachine.__annotations__,
        *option.Sheet.__annotations__,
        *(("cranks",) if is_diagram(values) else ()),
    }
    names = (name.rstrip("_") for name in engines.Engine.__annotations__ if name not in kept)
    return {name: f"--{name.replace('_', '-')} {why}" for name in names}


def _of_nothing(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what tells no figure of a flywheel without an engine."""
    refused = {}
    cyclic = ("energy_fluctuation", "work", "hole", "power", "strokes", "share")
    if not (
        is_diagram(values) or any(is_given(values[one]) for one in cyclic) or is_given(values["columns"])
    ):
        refused["turns"] = (
            "--turns is of the cycle of a diagram or of a work; add --torque, --work or --power, or leave it"
            " out"
        )
    pressing = any(is_given(values[one]) for one in ("work", "hole", "energy_fluctuation"))
    turning = is_diagram(values) and not is_given(values["areas"])
    if not (is_given(values["power"]) or pressing or turning):
        refused["efficiency"] = (
            "--efficiency is that between a motor and its press; add --power, or --work and --strokes, or"
            " leave it out"
        )
    return refused


def _power_of_steam(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not _is_engine(values):
        return _of_nothing(values)
    light = needless_of_load(values)
    if is_heavy(values):
        return {"power": WITH_MASSES, **light}
    if is_given(values["cylinder"]):
        return {"power": "the power of unlike cylinders follows from their sizes; leave --power out"}
    return {**_of_given_power(values), **light} if is_given(values["power"]) else light


def _of_given_power(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse the sizes of which the power is made, where that is given and nothing else needs them."""
    why = "is for the power of the engine, which --power gives; leave one of the two out"
    counted = any(is_given(values[name]) for name in (*RUBBING, *RODS))
    sizes = () if counted else of_load(values)[:1] if has_back_pressure(values) else of_load(values)
    refused = {name: f"--{name.replace('_', '-')} {why}" for name in sizes}
    if not is_given(values["rod"]):
        refused["stroke"] = f"--stroke {why}"
    return {**lone_lengths(values), **refused}


@makes_table(foreign=_of_others, needless=_power_of_steam, order=f"{ORDER} {' '.join(_OWN)}")
def flywheel_table(
    eps: option.Eps = None,
    *,
    power: Annotated[
        Exact | None,
        Option(
            "Power of the engine: 50kW, 68PS; left out, it follows from pressure, bore, stroke and speed.",
            "POWER",
            unit="W",
        ),
    ] = None,
    speed: Annotated[
        Exact | None,
        option.SPEED._replace(help="Speed: 120/min, 12.5rad/s; without an engine also 200..225/min."),
    ] = None,
    delta: Annotated[
        option.Given | None,
        Option("Degree of irregularity to keep: 1:100, 0.01, ±0.5%; lists '1:50;1:100'.", "δ", many=True),
    ] = None,
    radius: Annotated[
        Exact | None,
        Option(
            "Radius at which the mass of the rim is wanted, or the radius of gyration: 1.5m.",
            "LENGTH",
            unit="m",
        ),
    ] = None,
    columns: Annotated[option.Names, option.columns_option("flywheel", "target,swing,inertia")] = (),
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option(ENGINE, SIZING)] = None,
    **given: Unpack[Flywheel],
) -> Question:
    """Print the flywheel that keeps an engine or a driven machine even: energy swing, moment of inertia,
    mass.

    Without an engine what is given of swing, speed, irregularity, flywheel and rim finds the rest.

    \b
    kurbel flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4 --ratio 1:5
    kurbel flywheel --power 50kW --speed 120/min --delta '1:50;1:100' --eps 4 --radius 1.5m
    kurbel flywheel --swing 5kJ --speed 300/min --delta ±1% --radius 1m
    kurbel flywheel --swing 56kJ --speed 120/min --mass 6.5t --radius 1.8m
    kurbel flywheel --power 300kW --speed 90/min --energy-fluctuation 0.1 --delta ±0.5% --radius 2m
    kurbel flywheel --torque '5000 + 1500 sin(3φ)' --speed 300/min --inertia 200kgm2
    kurbel flywheel --areas '+52;-124;+72' --area-scale '500 N m; 6°' --speed 600/min --delta ±1.5%
    kurbel flywheel --power 3kW --work 10kJ --duration 1s --greatest-speed 300/min --mass 150kg --radius 0.6m
    kurbel flywheel --work 10kJ --strokes 30/min --share 1/4 --speed 200..225/min --radius 0.5m
    kurbel flywheel --swing 56kJ --speed 120/min --delta 1:60 --rim-diameter 3m --density 7200kg/m³
    \f
    >>> import kurbel
    >>> page = kurbel.flywheel_table(swing=5000, speed="300/min", delta="±1%", columns="delta,inertia")
    >>> print(kurbel.typeset(page, "csv"), end="")
    delta,inertia
    0.02,253.30
    """
    about = {**given, "eps": eps, "speed": speed, "power": power, "delta": delta, "radius": radius}
    about |= {"columns": as_names(columns, EXAMPLE), "layout": layout, "layouts": layouts}
    if _is_engine(about):
        return _of_engine(about)
    from kurbel.commands.flywheels.sizing import wheels_of

    return wheels_of(about, layout_of(layout or "flywheel-sizing", (SIZING,), layouts), sheet_of(given))


def _of_engine(about: Mapping[str, Any]) -> Question:
    """Return the page of an engine's flywheel, with a rim that of its sizes."""
    from kurbel.drive.flywheel import Flywheel as Task

    power, size = about["power"], about["radius"]
    heavy = is_heavy(about) or is_given(about["cylinder"])
    for name, example in (("speed", "120/min"), ("delta", "1:100")):
        if about[name] is None:
            raise ProblemError(
                f"the flywheel of an engine needs --{name}; add it, for example --{name} {example}"
            )
    if power is None and not heavy:
        _check_power(about)
    # Else it follows from the load, against which masses are weighed.
    watts = None if power is None or heavy else as_power(power)
    turns, radius = as_speed(about["speed"]), None if size is None else as_length(size, "radius")
    wheels = tuple(Task(watts, turns, each, radius) for each in as_irregularities(about["delta"]))
    if any(is_given(about[name]) for name in Rim.__annotations__):
        from kurbel.commands.flywheels.rim import rims_of

        page = layout_of(about["layout"] or "flywheel-sizing", (SIZING,), about["layouts"])
        engine = engine_of(layout_of(ENGINE, (ENGINE,)), about, flywheels=wheels)
        return rims_of(engine, about, page, sheet_of(about))
    page = layout_of(about["layout"] or ENGINE, (ENGINE,), about["layouts"])
    return engine_of(page, about, flywheels=wheels, columns=about["columns"])


def _check_power(about: Mapping[str, Any]) -> None:
    """Raise ProblemError where nothing tells the power of the engine."""
    sized = is_given(about["stroke"]) or is_given(about["rod"])
    missing = [name for name in of_load(about) if about[name] is None]
    if not sized or missing:
        *first, last = (f"--{one.replace('_', '-')}" for one in (*([] if sized else ["stroke"]), *missing))
        sizes = f"{', '.join(first)} and {last}" if first else last
        raise ProblemError(
            f"a flywheel needs the power of the engine; add --power, for example --power 50kW, or {sizes},"
            " from which it follows"
        )
