"""The topics of a command's help, and what `-h` shows first: the one place that says where an option stands.

A topic has no command's name, for both are behind `kurbel help`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeGuard

import click


class Topic(NamedTuple):
    """What belongs together: its name and its title, the names of its options, the most used first, and
    those of other topics that go with them.

    What another command has elsewhere by the same name has its command before it: "locomotive.stroke"; what
    sweeps have elsewhere, "sweep".
    """

    name: str
    title: str
    options: str
    also: str = ""


TOPICS = (
    Topic(
        "question",
        "What is asked",
        "plot.positions point where unknown quantity orders order intervals"
        " at of detail exact csv only strict sources table steps constructions",
    ),
    Topic(
        "crank",
        "The crank",
        "ratio stroke rod speed machine method table.order solve.order offset crank true_stroke"
        " time_ratio acceleration",
        "mechanism",
    ),
    Topic(
        "linkage",
        "Other crank drives",
        "mechanism rocker pivot circuit beam axles driven",
        "ratio crank offset",
    ),
    Topic("angles", "The crank angles", "angle step from to zero over shares"),
    Topic(
        "steam",
        "Steam",
        "eps pressure back card clearance exponent",
        "bore single_acting other_side cranks power",
    ),
    Topic(
        "compressor",
        "A compressor",
        "pressure_ratio suction_pressure suction_loss delivery_loss",
        "bore clearance exponent single_acting other_side",
    ),
    Topic("pump", "A pump", "pump delivery_pressure small_area", "suction_pressure bore"),
    Topic(
        "gas",
        "A gas engine",
        "compression cycle peak_pressure heat cut_off expansion_exponent exhaust_pressure two_stroke",
        "suction_pressure exponent bore cylinder",
    ),
    Topic(
        "piston",
        "The piston",
        "force bore single_acting other_side head_pressure crank_pressure pressure_difference piston_rod"
        " tail_rod",
        "pressure friction",
    ),
    Topic(
        "cylinders",
        "Several cylinders",
        "engine cranks positions banks cylinder cylinders spacing about firing.strokes",
        "of",
    ),
    Topic(
        "masses",
        "Masses and weight",
        "reciprocating rod_mass centre gyration rod_file pendulum pendulum_from rotating revolving"
        " rocker_inertia vertical slope gravity masses radii angles planes bearings rotor.about"
        " rotor.speed",
        "stroke speed",
    ),
    Topic(
        "counterweights",
        "What balances",
        "share balance_planes balance_radii balance_radius revolving_share",
        "revolving",
    ),
    Topic(
        "axle",
        "The axle and its wheels",
        "locomotive.cranks locomotive.spacing locomotive.positions gauge locomotive.stroke locomotive.crank"
        " locomotive.speed velocity wheel wheel_load hammer_blow locomotive.axles",
    ),
    Topic("friction", "Friction", "friction pin_friction crosshead_pin crank_pin shaft", "bore"),
    Topic(
        "work",
        "Power and work",
        "power mean_pressure working_strokes brake_power efficiency stroke_bore piston_speed diagram_factor"
        " specific_volume steam_density",
        "bore stroke speed cylinders",
    ),
    Topic(
        "wheel",
        "The flywheel",
        "delta flywheel inertia resistance mass radius swing energy_fluctuation greatest_speed least_speed",
        "power speed rim_diameter disc_diameter",
    ),
    Topic(
        "rim",
        "Its rim",
        "rim_diameter rim_speed rim_section rim_breadth rim_thickness density hoop_stress rim_share",
        "delta swing",
    ),
    Topic("disc", "A disc for a wheel", "disc_diameter disc_thickness", "density inertia"),
    Topic(
        "press",
        "A press",
        "work flywheel.strokes flywheel.share duration hole shear_energy shear_strength",
        "power efficiency speed radius",
    ),
    Topic(
        "diagram",
        "A diagram without an engine",
        "torque torque_file triangles areas area_scale load_torque load_torque_file turns",
        "speed inertia delta",
    ),
    Topic("combinations", "The combinations", "zip_ sweep.only sample seed bounds sweep.strict"),
    Topic("run", "The run", "scheduler jobs resume restart"),
    Topic(
        "page",
        "The page",
        "lang layout columns units decimal digits rounding caption note source label layouts templates",
    ),
    Topic("drawing", "The drawing", "width height polar over_path infinite text animate seconds", "output"),
    Topic(
        "output",
        "The output",
        "output format interactive standalone longtable siunitx plain excel dry_run help",
    ),
)
# Of each command the ten or fifteen options that one needs first; the topic of the first one leads its help.
FIRST: Mapping[str, str] = {
    "table": "ratio stroke rod speed machine mechanism offset method angle step to over point columns digits",
    "forces": "ratio stroke rod speed machine force eps bore pressure reciprocating friction angle step"
    " columns",
    "inertia": "ratio stroke rod speed machine rod_mass centre gyration rod_file angle step columns digits",
    "solve": "where unknown ratio stroke rod speed machine force eps bore pressure angle columns digits",
    "delta": "eps back bore pressure card ratio machine pressure_ratio compression cranks power flywheel"
    " detail",
    "turning": "eps back bore pressure card ratio stroke machine torque areas cranks power step columns",
    "pressures": "eps bore pressure card ratio stroke rod speed machine reciprocating shares columns",
    "power": "power mean_pressure eps pressure card bore stroke speed machine cylinders efficiency"
    " brake_power digits",
    "flywheel": "delta power speed swing inertia mass radius eps ratio machine torque areas work"
    " rim_diameter density",
    "deadcentres": "exact ratio stroke rod speed machine mechanism offset rocker beam columns digits",
    "harmonics": "ratio quantity orders machine eps bore pressure stroke speed reciprocating cranks columns"
    " digits",
    "balance": "engine cranks positions spacing orders ratio stroke rod speed machine reciprocating"
    " revolving columns",
    "rotor": "masses radii angles planes bearings speed balance_planes balance_radii columns digits",
    "locomotive": "reciprocating share gauge spacing cranks stroke revolving speed wheel_load wheel columns",
    "firing": "engine cranks strokes order intervals columns",
    "collate": "quantity csv ratio method only strict sources columns",
    "example": "ratio angle force eps back",
    "plot": "positions point animate ratio stroke rod offset mechanism rocker machine seconds width",
    "construct": "table point ratio angle offset machine steps width",
}
# Of every command behind its own, of sweeps their own before.
LAST = "lang output format"
SWEEPS_LAST = "zip_ sample only dry_run output format"
# Where the beginning of what an option says is too little, or too much, for `-h`.
SHORTER: Mapping[str, str] = {
    "machine": "A machine in TOML; what is typed outdoes it",
    "mechanism": "straight (default), offset, arc, parallel, beam",
    "method": "exact (default), series or infinite",
    "angle": "Crank angles in degrees: '0;45;90', 0..180:10",
    "over": "What the page runs over: angle or path",
    "point": "Points of the rod, from the crosshead pin: 0.5",
    "shares": "Shares of the stroke: '0;25%;50%'",
    "back": "Back pressure as a share: 10%",
    "card": "Indicator card, a CSV file",
    "engine": "inline-4, v8-90, boxer-4 and others",
    "revolving": "Mass that turns with each crank at its radius",
    "columns": "Columns and their order; kurbel quantities has all",
    "format": "text, html, latex, csv, svg",
    **dict.fromkeys(("firing.format", "rotor.format", "example.format"), "text, html, latex, csv, xlsx"),
    "sweep.format": "parquet, arrow, csv, netcdf or zarr",
    "sweep.output": "File to write: sweep.parquet",
    "locomotive.share": "Shares of them that are balanced",
    "firing.intervals": "With --order: firing intervals",
    "plot.point": "Paths of points of the rod: 0.5",
    "plot.format": "svg, png, pdf or pgf; html or gif of what moves",
    "construct.point": "A point of the rod: 0.5",
    "construct.format": "svg, png, pdf, html drawn; text, csv and others",
}
# What layouts choose by themselves.
DEFAULTS: Mapping[str, str] = {
    "ratio": "1:5",
    **dict.fromkeys(("collate.ratio", "example.ratio", "deadcentres.exact", "revolving"), ""),
}


def topics_of(command: click.Command) -> Iterator[tuple[Topic, Sequence[click.Option]]]:
    """Yield the topics of a command with their options, that of its first option first."""
    options = options_of(command)
    first = FIRST.get(command.name or "", "").partition(" ")[0]
    found = []
    for topic in TOPICS:
        listed = [options[name] for name in _names(topic, command) if name in options]
        if listed:
            found.append((topic, listed))
    yield from sorted(found, key=lambda pair: options.get(first) not in pair[1])


def first_of(command: click.Command) -> Sequence[click.Option]:
    """Return what one needs first."""
    options = options_of(command)
    names = f"{FIRST[command.name or '']} {SWEEPS_LAST if is_sweep(command) else LAST}".split()
    return [options[name] for name in names if name in options]


def options_of(command: click.Command) -> Mapping[str, click.Option]:
    """Return the options of a command by their names."""
    params = command.get_params(click.Context(command))
    return {name_of(one): one for one in params if _is_option(one)}


def name_of(option: click.Option) -> str:
    """Return the name of an option; what click calls its own is another word in other versions."""
    return "help" if "--help" in option.opts else option.name or ""


def flag_of(option: click.Option) -> str:
    """Return an option as it is typed, in the long way if there is one."""
    return max(option.opts, key=len)


def _is_option(one: click.Parameter) -> TypeGuard[click.Option]:
    return isinstance(one, click.Option)


def _names(topic: Topic, command: click.Command) -> Iterator[str]:
    """Yield the names of the options that the command has in the topic."""
    from kurbel.cli.tables import TableCommand

    owners = {command.name, "sweep" if is_sweep(command) else command.name}
    listed = {one for other in TOPICS if other is not topic for one in other.options.split()}
    for name in topic.options.split():
        owner, _, own = name.rpartition(".")
        if owner in owners or (not owner and not any(f"{one}.{name}" in listed for one in owners)):
            yield own
    # What is named nowhere stands in the topic of its part.
    declared = command.made_by.options.values() if isinstance(command, TableCommand) else ()
    named = {name.rpartition(".")[2] for one in TOPICS for name in one.options.split()}
    yield from (
        one.name
        for one in declared
        if one.name not in named and one.home is not None and one.home.topic == topic.name
    )


def is_sweep(command: click.Command) -> bool:
    return getattr(command, "swept", command.name == "sweep")
