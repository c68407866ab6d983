"""The default page of every layout, whatever it is about, the command that prints it, and its cells."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

import pytest

import kurbel
from kurbel.drive.mechanisms import SUBJECTS
from kurbel.exact.numerals import Number, number_text
from kurbel.page.layouts import LANGUAGES, layout, layout_names
from kurbel.page.table import DITTO, Panel, Table

Address = tuple[str, ...]

MACHINE = ("--stroke=600mm", "--speed=120/min", "--bore=300mm", "--pressure=800kPa")
MASSES = ("--masses=200;300;400;200kg", "--radii=80;70;60;80mm")
ANGLES = ("--angles=0;45;115;235",)
ROD = ("--rod-mass=150kg", "--centre=0.6", "--gyration=0.3")
STEAM = (
    "--pressure=8bar", "--back=1.1bar", "--clearance=8%", "--diagram-factor=0.8", "--efficiency=85%",
    "--speed=250/min", "--specific-volume=0.24 m3/kg",
)  # fmt: skip
# What prints a page about the motion of each linkage, in words, and as options.
SAMPLES = {subject: tuple(one.sample.split()) for subject, one in SUBJECTS.items()}
SAMPLED = {
    subject: {option[2:]: value for option, value in zip(words[1::2], words[2::2], strict=True)}
    for subject, words in SAMPLES.items()
}
# By what a page is about: the command that prints it, with what it cannot do without.
COMMANDS: Mapping[str, tuple[str, ...]] = {
    "motion": ("table",),
    "irregularity": ("delta",),
    "strokes": ("delta", "--eps=2"),
    "evenness": ("delta", "--flywheel=50"),
    "compressor": ("delta", "--pressure-ratio=2..6", "--clearance=4%", "--exponent=1.3"),
    "pump": ("delta", "--pump"),
    "gas cycle": ("delta", "--compression=5..8", "--heat=10"),
    "power": ("power", "--eps=2;3", "--power=75kW", "--stroke-bore=1.5", *STEAM),
    "turning": ("turning", "--eps=4"),
    "torques": ("turning", "--torque=5000 + 1500 sin(3φ)", "--inertia=500kgm2", "--speed=300/min"),
    "areas": ("turning", "--areas=+52;-124;+92;-140;+85;-72;+107", "--area-scale=500 N m; 6°"),
    "speed": ("turning", "--eps=4", "--flywheel=50", "--speed=120/min"),
    "crank forces": ("forces", "--eps=4"),
    "machine": ("forces", "--eps=4", *MACHINE, "--reciprocating=300kg", *ROD, "--rotating=-40kg"),
    "rod load": ("forces", "--eps=4"),
    "mass forces": ("forces", "--force=10kN", *MACHINE[:2], "--reciprocating=300kg"),
    "flywheel": (
        "flywheel",
        "--eps=4",
        "--power=50kW",
        "--speed=120/min",
        "--delta=1:50;1:100",
        "--radius=1.5m",
    ),
    "flywheel sizing": (
        "flywheel",
        "--swing=56kJ",
        "--speed=120/min",
        "--delta=1:60;1:80",
        "--rim-diameter=3m",
        "--density=7200kg/m³",
        "--rim-section=2:1",
        "--rim-share=92%",
        "--radius=1.5m",
    ),
    **dict.fromkeys(
        ("pressures", "pressures over the angle"), ("pressures", "--eps=4", *MACHINE, "--reciprocating=300kg")
    ),
    "dead centres": ("deadcentres",),
    "drive dead centres": ("deadcentres", "--mechanism=arc", "--rocker=6"),
    "harmonics": ("harmonics",),
    "cylinders": ("delta", "--eps=4", "--cranks=0;90", *MACHINE, "--reciprocating=300kg"),
    "torque": ("harmonics", "--quantity=torque", "--eps=4", "--cranks=0;90"),
    "excitation": ("harmonics", "--eps=4", "--cranks=0;90", *MACHINE),
    "balance": ("balance",),
    "locomotive": (
        "locomotive",
        "--spacing=0.7m",
        "--gauge=1.5m",
        "--stroke=60cm",
        "--reciprocating=300kg",
        "--speed=300/min",
        "--wheel=1.8m",
        "--wheel-load=30kN",
    ),
    "balance extremes": ("balance", "--engine=inline-3"),
    "balance at angles": ("balance", "--angle=0;60"),
    "rotor": ("rotor", *MASSES, *ANGLES, "--planes=0;300;700;1000mm", "--balance-planes=100;500mm"),
    "firing orders": ("firing",),
    "firing": ("firing", "--order=1-3-4-2"),
    "collation": ("collate", "roetscher-112"),
    "formulas": ("collate", "blau-equations"),
    **SAMPLES,
    "rod points": ("table", "--point=0.5"),
    "effort": (
        "forces",
        "--bore=300mm",
        "--piston-rod=50mm",
        "--head-pressure=1.5bar",
        "--stroke=600mm",
        "--speed=120/min",
        "--reciprocating=300kg",
        *ROD,
        "--friction=500N",
        "--slope=30",
    ),
    "coupled axles": ("forces", "--mechanism=parallel", "--axles=3"),
    "inertia": ("inertia", "--centre=0.65", "--gyration=0.35"),
    **dict.fromkeys(
        ("rod masses", "pin masses"),
        ("inertia", "--centre=325mm", "--gyration=175mm", "--rod=500mm", "--rod-mass=12kg"),
    ),
    "inertia errors": ("inertia", "--centre=0.65", "--gyration=0.35"),
    "rocker inertia": ("inertia", "--centre=0.65", "--gyration=0.35", "--mechanism=arc", "--rocker=6"),
    "tangent": ("forces", "--at=tangent"),
    "unknown": ("solve", "--unknown=ratio", "--angle=80", "--where=c=max"),
    "loaded roots": ("solve", "--eps=4", "--where=torque=max", "--where=tangential=0.5"),
    "roots": ("solve", "--where=p=0", "--where=s=25%", "--where=c=max"),
    "construction": ("construct", "blau-9", "--table"),
    **dict.fromkeys(("series errors", "successive"), ("table",)),
    "over path": ("table", "--layout=over-path"),
    "forces over path": ("forces", "--layout=forces-path"),
}


def about(*subjects: str) -> list[str]:
    """Return the layouts about these subjects."""
    return [name for name in layout_names() if layout(name).subject in subjects]


MOTION = about("motion")
ENGINES = about(
    "irregularity",
    "strokes",
    "evenness",
    "turning",
    "speed",
    "crank forces",
    "machine",
    "rod load",
    "flywheel",
)
POWERS = about("power")
BEAMS = about("dead centres", "drive dead centres")
BALANCES = about("harmonics", "balance")
TURNED = about("balance at angles", "balance extremes", "rotor", "locomotive")
COLLATIONS = about("collation", "formulas")
EFFORTS = about("effort")
LINKAGES = about(*SAMPLES, "coupled axles", "rod points")
# What `kurbel table` prints.
APPROXIMATED = about("series errors", "successive")
DRIVES = sorted((*about("motion", *SAMPLES, "rod points", "over path"), *APPROXIMATED))
PRESSED = about("pressures", "pressures over the angle")
RODS = about(
    "mass forces", "inertia", "inertia errors", "rod masses", "pin masses", "rocker inertia", "tangent"
)
SOLVED = about("roots")
CONSTRUCTED = about("construction")
OVER_PATH = about("over path", "forces over path")
SOLVED_LOADED = about("loaded roots", "unknown")

each_layout = pytest.mark.parametrize(
    ("name", "lang"), [(name, lang) for name in layout_names() for lang in LANGUAGES]
)


def command(name: str) -> tuple[str, ...]:
    """Return the words that print the layout with its defaults."""
    return (*COMMANDS[layout(name).subject], f"--layout={name}")


# The same for Python: the function, and what it cannot do without.
FUNCTIONS: Mapping[str, tuple[Callable[..., Table], Mapping[str, Any]]] = {
    "motion": (kurbel.table, {}),
    "irregularity": (kurbel.delta, {}),
    "strokes": (kurbel.delta, {"eps": 2}),
    "evenness": (kurbel.delta, {"flywheel": 50}),
    "compressor": (
        kurbel.delta, {"pressure_ratio": "2..6", "clearance": "4%", "exponent": "1.3"}
    ),
    "pump": (kurbel.delta, {"pump": "double"}),
    "gas cycle": (kurbel.delta, {"compression": "5..8", "heat": 10}),
    "power": (kurbel.power, {
        "eps": "2;3", "pressure": 800_000, "back": "1.1bar", "clearance": "8%", "power": 75_000,
        "diagram_factor": 0.8, "efficiency": "85%", "stroke_bore": 1.5, "speed": "250/min",
        "specific_volume": 0.24,
    }),
    "turning": (kurbel.turning, {"eps": 4}),
    "torques": (kurbel.turning, {"torque": "5000 + 1500 sin(3φ)", "inertia": 500, "speed": 5}),
    "areas": (kurbel.turning, {
        "areas": [52, -124, 92, -140, 85, -72, 107], "area_scale": "500 N m; 6°",
    }),
    "speed": (kurbel.turning, {"eps": 4, "flywheel": 50, "speed": 2}),
    "crank forces": (kurbel.forces, {"eps": 4}),
    "machine": (kurbel.forces, {
        "eps": 4, "stroke": 0.6, "speed": 2, "bore": 0.3, "pressure": 800_000, "reciprocating": 300,
        "rod_mass": 150, "centre": 0.6, "gyration": "0.3", "rotating": -40,
    }),
    "rod load": (kurbel.forces, {"eps": 4}),
    "flywheel": (kurbel.flywheel, {
        "eps": 4, "power": 50_000, "speed": 2, "delta": "1:50;1:100", "radius": "1.5m",
    }),
    "flywheel sizing": (kurbel.flywheel, {
        "swing": 56_000, "speed": 2, "delta": "1:60;1:80", "rim_diameter": 3, "density": 7200,
        "rim_section": "2:1", "rim_share": "92%", "radius": 1.5,
    }),
    **dict.fromkeys(("pressures", "pressures over the angle"), (kurbel.pressures, {
        "eps": 4, "stroke": 0.6, "speed": 2, "bore": 0.3, "pressure": 800_000, "reciprocating": 300,
    })),
    "dead centres": (kurbel.deadcentres, {}),
    "drive dead centres": (kurbel.deadcentres, {"mechanism": "arc", "rocker": 6}),
    "harmonics": (kurbel.harmonics, {}),
    "cylinders": (kurbel.delta, {
        "eps": 4, "cranks": "0;90", "stroke": 0.6, "speed": 2, "bore": 0.3, "pressure": 800_000,
        "reciprocating": 300,
    }),
    "torque": (kurbel.harmonics, {"quantity": "torque", "eps": 4, "cranks": [0, 90]}),
    "excitation": (kurbel.harmonics, {
        "eps": 4, "cranks": "0;90", "stroke": 0.6, "speed": 2, "bore": 0.3, "pressure": 800_000,
    }),
    "balance": (kurbel.balance, {}),
    "locomotive": (kurbel.locomotive, {
        "spacing": 0.7, "gauge": 1.5, "stroke": 0.6, "reciprocating": 300, "speed": 5, "wheel": 1.8,
        "wheel_load": 30_000,
    }),
    "balance extremes": (kurbel.balance, {"engine": "inline-3"}),
    "balance at angles": (kurbel.balance, {"angle": [0, 60]}),
    "rotor": (kurbel.rotor, {
        "masses": [200, 300, 400, 200], "radii": "80;70;60;80mm", "angles": [0, 45, 115, 235],
        "planes": "0;300;700;1000mm", "balance_planes": [0.1, 0.5],
    }),
    "firing orders": (kurbel.firing, {}),
    "firing": (kurbel.firing, {"order": "1-3-4-2"}),
    "collation": (kurbel.collate, {"table": "roetscher-112"}),
    "formulas": (kurbel.collate, {"table": "blau-equations"}),
    **{subject: (kurbel.table, options) for subject, options in SAMPLED.items()},
    "rod points": (kurbel.table, {"point": 0.5}),
    "effort": (kurbel.forces, {
        "bore": 0.3, "piston_rod": 0.05, "head_pressure": 150_000, "stroke": 0.6, "speed": 2,
        "reciprocating": 300, "rod_mass": 150, "centre": 0.6, "gyration": "0.3", "friction": 500,
        "slope": 30,
    }),
    "coupled axles": (kurbel.forces, {"mechanism": "parallel", "axles": 3}),
    **dict.fromkeys(
        ("rod masses", "pin masses"),
        (kurbel.inertia, {"centre": "325mm", "gyration": "175mm", "rod": 0.5, "rod_mass": 12}),
    ),
    **dict.fromkeys(
        ("inertia", "inertia errors"), (kurbel.inertia, {"centre": 0.65, "gyration": "35%"})
    ),
    "rocker inertia": (
        kurbel.inertia, {"centre": 0.65, "gyration": "35%", "mechanism": "arc", "rocker": 6}
    ),
    "tangent": (kurbel.forces, {"at": "tangent"}),
    "mass forces": (kurbel.forces, {
        "force": 10_000, "stroke": 0.6, "speed": 2, "reciprocating": 300,
    }),
    "unknown": (kurbel.solve, {"unknown": "ratio", "angle": 80, "where": "c=max"}),
    "loaded roots": (kurbel.solve, {"eps": 4, "where": ("torque=max", "tangential=0.5")}),
    "roots": (kurbel.solve, {"where": ("p=0", "s=25%", "c=max")}),
    "construction": (kurbel.construct, {"name": "blau-9"}),
    **dict.fromkeys(("series errors", "successive"), (kurbel.table, {})),
    "over path": (kurbel.table, {"layout": "over-path"}),
    "forces over path": (kurbel.forces, {"layout": "forces-path"}),
}  # fmt: skip


def page_of(name: str, **choices: Any) -> Table:
    """Make a page of the layout from Python, with what its function cannot do without."""
    function, needed = FUNCTIONS[layout(name).subject]
    return function(**{"layout": name, **needed, **choices})


@cache
def default_page(name: str, lang: str = "de", label: str = "") -> Table:
    """Make the page that `command` prints, from Python."""
    return page_of(name, lang=lang, label=label)


def shown(value: object) -> str:
    return number_text(value) if isinstance(value, Number) else str(value)


def cells(table: Table) -> dict[Address, str]:
    """Return the digits of every cell by its address; no two cells may share one.

    A cell's address is its group's label, its stub, its column's heads from the outermost to the innermost
    and, on a page that has them, the unit of its row, as labels are written in the layouts.
    """
    found: dict[Address, str] = {}
    for panel in table.panels:
        for address, digits in addressed(panel):
            assert address not in found, f"two cells stand under {address}"
            found[address] = digits
    return found


def addressed(panel: Panel) -> Iterator[tuple[Address, str]]:
    above: tuple[str, ...] = ()
    for group in panel.groups:
        for row in group.rows:
            stub = tuple(
                above[place] if cell.value is DITTO else shown(cell.value)
                for place, cell in enumerate(row.stub)
            )
            above = stub
            units = [
                shown(cell.value)
                for column, cell in zip(panel.columns, row.cells, strict=True)
                if column.key == "unit"
            ]
            for column, cell in zip(panel.columns, row.cells, strict=True):
                if column.key != "unit":
                    yield (group.label, *stub, *column.spanners, *column.heading, *units), shown(cell.value)


@cache
def all_pages() -> tuple[Table, ...]:
    return (
        *(default_page(name, lang, f"{name}-{lang}") for name in layout_names() for lang in LANGUAGES),
        kurbel.table(stroke="600mm", speed=2, label="machine"),
        kurbel.table(offset="0.1", lang="en", label="offset"),
        kurbel.delta(method="weisbach", label="weisbach"),
        kurbel.delta("4", layout="delta-detail", ratio="1:4;1:5", cranks="0;90", label="cranks"),
        kurbel.turning("2;4", angle="0..360:30", label="engines"),
        kurbel.delta(back="0.1", exponent="1.13", clearance=0.05, single_acting=True, label="steam"),
    )
