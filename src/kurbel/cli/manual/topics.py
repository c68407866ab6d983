"""The topics in which the options of a command stand, with a line that shows each, and what people want."""

from __future__ import annotations

import os
import re
import shlex
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import click

from kurbel.cli.app import HELP_OPTIONS
from kurbel.cli.manual.command import TopicCommand, with_examples


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
SWEEPS_LAST = "zip sample only dry_run output format"
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
    return {name_of(one): one for one in params if isinstance(one, click.Option)}


def name_of(option: click.Option) -> str:
    """Return the name of an option; what click calls its own is another word in other versions."""
    return "help" if "--help" in option.opts else option.name or ""


def flag_of(option: click.Option) -> str:
    """Return an option as it is typed, in the long way if there is one."""
    return max(option.opts, key=len)


def is_sweep(command: click.Command) -> bool:
    return getattr(command, "swept", command.name == "sweep")


SWEEPS: Mapping[str, str] = {
    "table": "--ratio 1:3..8 --step 1 --columns x,c -o table.parquet",
    "forces": "--ratio 1:3..8 --step 15 --columns torque -o forces.csv",
    "inertia": "--ratio 1:3..8 --centre 0.5..0.7:0.1 --gyration 0.3 -o inertia.csv",
    "solve": "--ratio 1:3..8 --where c=max -o solve.csv",
    "delta": "--eps 1.5..10:0.1 --ratio 1:3..8 -o delta.parquet",
    "turning": "--eps 2..6 --step 15 -o turning.csv",
    "pressures": "--machine engine.toml --speed '60/min;120/min' -o pressures.csv",
    "power": "--machine engine.toml --speed 60..120/min:20 -o power.csv",
    "flywheel": "--power 50kW --speed 120/min --delta 1:100 --eps 2..6 -o flywheel.csv",
    "deadcentres": "--ratio 1:3..8 --offset 0..0.5:0.1 -o dead.csv",
    "harmonics": "--ratio 1:3..8 -o harmonics.csv",
    "balance": "--engine 'inline-3;inline-4' --ratio 1:3..6 -o balance.csv",
    "rotor": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --planes '0;200mm' -o rotor.csv",
    "locomotive": "--spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg --speed 4..5/s -o b.csv",
    "firing": "--engine 'inline-4;inline-6' -o firing.csv",
}
# What shows a topic, where the help of a command does not: behind what the command needs, and under a load.
TOPICAL: Mapping[str, str] = {
    "crank": "--stroke 600mm --rod 1500mm",
    "linkage": "--mechanism arc --ratio 1:5 --rocker 6",
    "angles": "--angle 0..90:15",
    "page": "--lang en",
    "drawing": "--width 85 -o drawing.svg",
    "output": "-o page.html",
    "wheel": "--flywheel 50",
    "work": "--power 50kW --inertia 1200kgm2 --speed 120/min",
}
LOADS: Mapping[str, str] = {
    "steam": "--eps 4 --back 10%",
    "compressor": "--pressure-ratio 4 --clearance 5%",
    "pump": "--pump single",
    "gas": "--compression 6 --peak-pressure 30",
    "piston": "--eps 4 --single-acting",
    "cylinders": "--eps 4 --cranks '0;90'",
    "masses": "--machine engine.toml --reciprocating 300kg",
    "friction": "--machine engine.toml --friction 500N",
}
LOADED: Mapping[str, str] = {
    "solve": "--where torque=max",
    "flywheel": "--power 50kW --speed 120/min --delta 1:100",
    "harmonics": "--quantity torque",
}
NEEDED: Mapping[str, str] = {
    "inertia": "--centre 0.6 --gyration 0.3",
    "solve": "--where c=max",
    "delta": "--eps 4",
    "turning": "--eps 4",
    "pressures": "--machine engine.toml",
    "power": "--machine engine.toml",
    "flywheel": "--power 50kW --speed 120/min --delta 1:100 --eps 4",
    "rotor": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120'",
    "locomotive": "--spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg",
    "collate": "roetscher-112",
    "example": "blau 33",
    "plot": "--positions 30 -o drive.svg",
    "construct": "blau-9",
}
# Whole, where a command shows a topic in its own way.
OWN: Mapping[str, str] = {
    "forces wheel": "--force 10kN --stroke 600mm --inertia '20 kg m²'",
    "solve drawing": "--ratio 1:3..8 --where c=max --width 85 -o greatest.svg",
    "delta drawing": "--eps 2..6 --width 85 -o delta.svg",
    "pressures steam": "--eps 4 --pressure 8bar --bore 300mm",
    "pressures compressor": "--pressure-ratio 4 --suction-pressure 1bar --bore 300mm",
    "pressures pump": "--pump single --suction-pressure=-0.3bar --delivery-pressure 6bar --bore 200mm",
    "pressures gas": "--compression 6 --peak-pressure 30 --suction-pressure 1bar --bore 200mm",
    "power pump": "--pump double --suction-pressure=-0.3bar --delivery-pressure 6bar --bore 200mm"
    " --stroke 400mm --speed 1/s",
    "power drawing": "--eps 2..6 --pressure 8bar --width 85 -o power.svg",
    "flywheel masses": "--delta 1:100 --machine engine.toml --reciprocating 300kg",
    "flywheel friction": "--delta 1:100 --machine engine.toml --friction 500N",
    "flywheel disc": "--swing 2kJ --speed 300/min --delta 1:60 --disc-diameter 1m --density 7800kg/m³",
    "deadcentres drawing": "--ratio 1:3..8 --offset 0.3 --width 85 -o dead.svg",
    "harmonics linkage": "--quantity torque --eps 4 --mechanism arc --ratio 1:5 --rocker 6",
    "rotor crank": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --machine engine.toml",
    "locomotive crank": "--machine engine.toml --spacing 0.7m --gauge 1.5m",
    "firing crank": "--machine engine.toml --cranks '0;90'",
    "example linkage": "weisbach 149 --beam 4",
    "example angles": "blau 31 --angle 60",
    "example piston": "uebung 12 --ratio 1:5 --force 10kN",
    "example steam": "weisbach 150 --eps 4",
    "construct linkage": "weisbach-149 --mechanism beam --beam 3",
    "construct steam": "radinger --eps 4",
    "construct masses": "ensslin-5 --centre 0.6 --gyration 0.3",
}
# The same of every sweep, behind its line.
SWEPT: Mapping[str, str] = {"combinations": "--bounds", "run": "--jobs 2", "output": "--dry-run"}


class Purpose(NamedTuple):
    """What one may have or want, by a name that is no command's: a sentence, lines with what each is, and
    pages to read."""

    name: str
    sentence: str
    lines: Sequence[tuple[str, str]]
    pages: str


@cache
def wants() -> Sequence[Purpose]:
    """Return what people have or want."""
    with open(os.path.join(os.path.dirname(__file__), "wants.toml"), "rb") as stream:
        found = tomllib.load(stream)
    return [
        Purpose(name, one["sentence"], with_examples(one["lines"])[1], one["pages"])
        for name, one in found.items()
    ]


def topical(command: click.Command, topic: str, options: Sequence[click.Option]) -> str:
    """Return what stands behind a command to show a topic, of these options; nothing if none does."""
    name = command.name or ""
    if is_sweep(command):
        return f"{SWEEPS[name]} {SWEPT[topic]}" if topic in SWEPT else ""
    if line := OWN.get(f"{name} {topic}") or _of_help(command, options):
        return line
    needed, shown = (LOADED, LOADS) if topic in LOADS else (NEEDED, TOPICAL)
    return f"{needed.get(name, '')} {shown[topic]}".strip() if topic in shown else ""


def _of_help(command: click.Command, options: Sequence[click.Option]) -> str:
    """Return the line of the help, or of what one may want, that has most of these options among its own."""
    flags = {flag for one in options for flag in one.opts}
    told = "\n".join((command.help or "", *(line for want in wants() for line, _ in want.lines)))
    lines = re.findall(rf"^ *kurbel {command.name} (.+)$", told, re.MULTILINE)

    def share(line: str) -> tuple[int, float]:
        typed = {word.partition("=")[0] for word in shlex.split(line) if re.match("--?[a-z]", word)}
        return len(typed & flags), len(typed & flags) / max(len(typed), 1)

    best = max(lines, key=share, default="")
    return best if share(best)[0] else ""
