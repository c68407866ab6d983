"""The topics of a command's help in their order, and what `-h` shows first.

In which topic an option stands, its declaration says, or its part.

A topic has no command's name, for both are behind `kurbel help`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeGuard

import click

from kurbel.cli.app import HELP_OPTIONS

if TYPE_CHECKING:
    from kurbel.cli.manual.command import TopicCommand


class Topic(NamedTuple):
    """What belongs together: its name, its title, the names of the options that stand before its others, for
    they are more used or one after another, and options of other topics that go with it, beside those that
    the section of its name in a machine's file has."""

    name: str
    title: str
    leading: str = ""
    also: str = ""


TOPICS = (
    Topic("question", "What is asked", "positions point where unknown quantity table steps"),
    Topic("crank", "The crank", "ratio stroke rod speed machine method order offset"),
    Topic("linkage", "Other crank drives", "mechanism rocker pivot circuit", "ratio stroke offset"),
    Topic("angles", "The crank angles", "angle step"),
    Topic("steam", "Steam", "eps pressure back card clearance", "cranks power"),
    Topic("compressor", "A compressor", "pressure_ratio suction_pressure"),
    Topic("pump", "A pump", "pump delivery_pressure"),
    Topic("gas", "A gas engine", also="cylinder"),
    Topic("piston", "The piston", "force bore single_acting", "pressure friction"),
    Topic("cylinders", "Several cylinders", "engine cranks positions banks", "of"),
    Topic(
        "masses",
        "Masses and weight",
        "reciprocating rod_mass centre gyration rod_file pendulum pendulum_from rod_inertia",
        "stroke speed",
    ),
    Topic("counterweights", "What balances", also="revolving"),
    Topic("axle", "The axle and its wheels"),
    Topic("friction", "Friction", also="bore"),
    Topic("work", "Power and work", "power mean_pressure working_strokes", "bore stroke speed cylinders"),
    Topic(
        "wheel",
        "The flywheel",
        "delta flywheel inertia mass radius",
        "power speed rim_diameter disc_diameter",
    ),
    Topic("rim", "Its rim", also="delta swing"),
    Topic("disc", "A disc for a wheel", also="density inertia"),
    Topic("press", "A press", also="power efficiency speed radius"),
    Topic(
        "diagram",
        "A diagram without an engine",
        "torque torque_file triangles areas area_scale",
        "speed inertia delta",
    ),
    Topic("combinations", "The combinations"),
    Topic("run", "The run"),
    Topic("page", "The page", "lang layout columns units decimal digits rounding"),
    Topic("drawing", "The drawing", "width height", "output"),
    Topic("output", "The output", "output format"),
)
# So many options are shown in short, with those behind the command's own.
MOST = 15
# Of every command behind its own, of sweeps their own before.
LAST = "lang output format"
SWEEPS_LAST = "zip_ sample only dry_run output format"
# Where the beginning of what an option says is too little, or too much, for `-h`.
SHORTER: Mapping[str, str] = {
    "machine": "A machine in TOML; what is typed outdoes it",
    "mechanism": "straight (default), offset, arc, beam, yoke, slotted",
    "method": "exact (default), series or infinite",
    "angle": "Crank angles in degrees: '0;45;90', 0..180:10",
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
    first = getattr(command, "in_short", "").partition(" ")[0]
    found = []
    for topic in TOPICS:
        # What click has of its own is about the output.
        names = [name for name, one in options.items() if getattr(one, "topic", "output") == topic.name]
        leading = [name for name in topic.leading.split() if name in names]
        if names:
            found.append((topic, [options[name] for name in dict.fromkeys((*leading, *names))]))
    yield from sorted(found, key=lambda pair: options.get(first) not in pair[1])


def first_of(command: TopicCommand) -> Sequence[click.Option]:
    """Return what one needs first, at most fifteen."""
    options = options_of(command)
    own, last = (
        [options[name] for name in names.split() if name in options]
        for names in (command.in_short, SWEEPS_LAST if is_sweep(command) else LAST)
    )
    return [*own[: MOST - len(last)], *last]


def options_of(command: click.Command) -> Mapping[str, click.Option]:
    """Return the options of a command by their names."""
    # Of `-h, --help` click keeps what the first context has.
    params = command.get_params(click.Context(command, help_option_names=HELP_OPTIONS))
    return {name_of(one): one for one in params if _is_option(one)}


def name_of(option: click.Option) -> str:
    """Return the name of an option; what click calls its own is another word in other versions."""
    return "help" if "--help" in option.opts else option.name or ""


def flag_of(option: click.Option) -> str:
    """Return an option as it is typed, in the long way if there is one."""
    return max(option.opts, key=len)


def _is_option(one: click.Parameter) -> TypeGuard[click.Option]:
    return isinstance(one, click.Option)


def is_sweep(command: click.Command) -> bool:
    return getattr(command, "swept", command.name == "sweep")
