"""The topics in which the options of a command stand, and a line that shows each."""

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
# What shows a topic, behind what its command needs: under a load, and elsewhere.
TOPICAL: Mapping[str, str] = {
    "crank": "--stroke 600mm --rod 1500mm",
    "linkage": "--mechanism arc --ratio 1:5 --rocker 6",
    "angles": "--angle 0..90:15",
    "steam": "--eps 4 --back 10%",
    "compressor": "--pressure-ratio 4 --clearance 5%",
    "pump": "--pump single",
    "gas": "--compression 6 --peak-pressure 30",
    "piston": "--single-acting",
    "cylinders": "--cranks '0;90'",
    "masses": "--machine engine.toml --reciprocating 300kg",
    "friction": "--machine engine.toml --friction 500N",
    "work": "--power 50kW --inertia 1200kgm2 --speed 120/min",
    "wheel": "--flywheel 50",
    "diagram": "--torque '5000 + 1500 sin(3φ)'",
    "page": "--lang en --digits 3",
    "drawing": "--width 85 -o drawing.svg",
    "output": "-o page.html",
}
LOADS = ("steam", "compressor", "pump", "gas")
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
    "example": "blau 33",
    "plot": "--positions 30 -o drive.svg",
    "construct": "blau-9",
}
# Whole, where a command shows a topic in its own way.
OWN: Mapping[str, Mapping[str, str]] = {
    "table": {"question": "--ratio 1:5 --point 0.5"},
    "forces": {
        "cylinders": "--eps 4 --cranks '0;90'",
        "question": "--ratio 1:5 --at tangent",
        "piston": "--force 10kN --stroke 600mm",
        "friction": "--force 10kN --friction 500N",
        "wheel": "--force 10kN --stroke 600mm --inertia '20 kg m²'",
    },
    "inertia": {"masses": "--centre 0.6 --gyration 0.3"},
    "solve": {
        "drawing": "--ratio 1:3..8 --where c=max --width 85 -o greatest.svg",
        "question": "--ratio 1:5 --where 's = 25%'",
        "angles": "--unknown stroke --angle 60 --where x=200mm",
        "piston": "--eps 4 --single-acting --where torque=max",
        "cylinders": "--eps 4 --cranks '0;90' --where torque=max",
        "masses": "--machine engine.toml --reciprocating 300kg --where torque=max",
        "friction": "--machine engine.toml --friction 500N --where torque=max",
    },
    "delta": {"question": "--eps 4 --detail", "drawing": "--eps 2..6 --width 85 -o delta.svg"},
    "turning": {"diagram": "--torque '5000 + 1500 sin(3φ)'"},
    "pressures": {
        "steam": "--eps 4 --pressure 8bar --bore 300mm",
        "compressor": "--pressure-ratio 4 --suction-pressure 1bar --bore 300mm",
        "pump": "--pump single --suction-pressure=-0.3bar --delivery-pressure 6bar --bore 200mm",
        "gas": "--compression 6 --peak-pressure 30 --suction-pressure 1bar --bore 200mm",
    },
    "power": {
        "drawing": "--eps 2..6 --pressure 8bar --width 85 -o power.svg",
        "work": "--power 50kW --mean-pressure 3bar --working-strokes 2 --stroke 600mm --speed 120/min",
        "crank": "--machine engine.toml --speed 150/min",
        "steam": "--eps 4 --pressure 8bar --bore 300mm --stroke 600mm --speed 120/min",
        "compressor": "--pressure-ratio 4 --suction-pressure 1bar --bore 300mm --stroke 600mm --speed 2/s",
        "pump": "--pump double --suction-pressure=-0.3bar --delivery-pressure 6bar --bore 200mm"
        " --stroke 400mm --speed 1/s",
        "gas": "--compression 6 --peak-pressure 30 --suction-pressure 1bar --bore 200mm --stroke 300mm"
        " --speed 5/s",
        "piston": "--machine engine.toml --piston-rod 50mm",
        "cylinders": "--machine engine.toml --cylinders 2",
    },
    "flywheel": {
        "wheel": "--swing 5kJ --speed 300/min --delta ±1% --radius 1m",
        "rim": "--swing 56kJ --speed 120/min --delta 1:60 --rim-diameter 3m --density 7200kg/m³",
        "disc": "--swing 2kJ --speed 300/min --delta 1:60 --disc-diameter 1m --density 7800kg/m³",
        "press": "--work 10kJ --strokes 30/min --share 1/4 --speed 200..225/min --radius 0.5m",
        "work": "--power 300kW --speed 90/min --energy-fluctuation 0.1 --delta ±0.5% --radius 2m",
        "diagram": "--torque '5000 + 1500 sin(3φ)' --speed 300/min --inertia 200kgm2",
        "masses": "--delta 1:100 --machine engine.toml --reciprocating 300kg",
        "friction": "--delta 1:100 --machine engine.toml --friction 500N",
    },
    "deadcentres": {
        "question": "--beam 3 --exact",
        "drawing": "--ratio 1:3..8 --offset 0.3 --width 85 -o dead.svg",
    },
    "harmonics": {
        "question": "--ratio 1:5 --quantity x --orders 8",
        "linkage": "--quantity torque --eps 4 --mechanism arc --ratio 1:5 --rocker 6",
        "piston": "--quantity torque --eps 4 --single-acting",
        "cylinders": "--quantity torque --eps 4 --cranks '0;90'",
        "masses": "--quantity torque --machine engine.toml --reciprocating 300kg",
        "friction": "--quantity torque --machine engine.toml --friction 500N",
    },
    "balance": {
        "question": "--engine inline-6 --orders 6",
        "cylinders": "--engine v8-90",
        "masses": "--engine inline-4 --reciprocating 1kg --stroke 80mm --speed 50/s",
        "counterweights": "--engine inline-2-180 --reciprocating 1kg --stroke 80mm --speed 50/s --share 1/2",
        "angles": "--layout balance-angle --angle 0..90:15",
    },
    "rotor": {
        "crank": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --machine engine.toml",
        "masses": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120'",
        "counterweights": "--masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --planes '0;200mm'"
        " --balance-planes '50mm;150mm' --balance-radii 100mm",
    },
    "locomotive": {
        "crank": "--machine engine.toml --spacing 0.7m --gauge 1.5m",
        "counterweights": "--spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg --share 2/3",
        "masses": "--spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg",
        "axle": "--spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg",
    },
    "firing": {
        "crank": "--machine engine.toml --cranks '0;90'",
        "question": "--engine inline-6 --order 1-5-3-6-2-4",
        "cylinders": "--engine v8-90",
    },
    "collate": {
        "drawing": "roetscher-112 --width 85 -o deviations.svg",
        "question": "weisbach-150 --only deviations",
        "crank": "--csv scan.csv --quantity p --ratio 1:4 --method series",
        "page": "roetscher-112 --lang en",
        "output": "roetscher-112 -o page.html",
    },
    "example": {
        "crank": "blau 33 --ratio 1:4,5",
        "linkage": "weisbach 149 --beam 4",
        "angles": "blau 31 --angle 60",
        "piston": "uebung 12 --ratio 1:5 --force 10kN",
        "steam": "weisbach 150 --eps 4",
        "page": "blau 33 --lang en",
    },
    "plot": {
        "crank": "--positions 30 --stroke 600mm --rod 1500mm -o drive.svg",
        "linkage": "--positions 30 --mechanism arc --ratio 1:5 --rocker 6 -o drive.svg",
        "page": "--positions 30 --lang en -o drive.svg",
        "drawing": "--positions 30 --width 85 -o drive.svg",
        "output": "--positions 30 -o drive.pdf",
    },
    "construct": {
        "question": "blau-9 --ratio 1:4 --angle 50 --table",
        "linkage": "weisbach-149 --mechanism beam --beam 3",
        "angles": "blau-9 --angle 50",
        "steam": "radinger --eps 4",
        "masses": "ensslin-5 --centre 0.6 --gyration 0.3",
        "page": "blau-9 --lang en",
        "drawing": "blau-9 --width 85 -o fig9.svg",
        "output": "blau-9 -o fig9.html",
    },
}
# The same of every sweep, behind its line.
SWEPT: Mapping[str, str] = {"combinations": "--bounds", "run": "--jobs 2", "output": "--dry-run"}


def topical(command: click.Command, topic: str) -> str:
    """Return what stands behind a command to show a topic, nothing if none does."""
    if is_sweep(command):
        return f"{SWEEPS[command.name or '']} {SWEPT[topic]}" if topic in SWEPT else ""
    name = command.name or ""
    if whole := OWN.get(name, {}).get(topic):
        return whole
    needed = (LOADED if topic in LOADS else NEEDED).get(name, "")
    return f"{needed} {TOPICAL[topic]}".strip() if topic in TOPICAL else ""
