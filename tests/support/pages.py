"""The default page of every layout, whatever it is about, the command that prints it, and its cells."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import pytest

import kurbel
from kurbel import make_engine_table, make_table
from kurbel.exact.numerals import Number, number_text
from kurbel.page.folders import LANGUAGES, layout_names
from kurbel.page.layouts import layout
from kurbel.page.table import DITTO, Panel, Table

Address = tuple[str, ...]

MACHINE = ("--stroke=600mm", "--speed=120/min", "--bore=300mm", "--pressure=800kPa")
ROD = ("--rod-mass=150kg", "--centre=0.6", "--gyration=0.3")
# By what a page is about: the command that prints it, with what it cannot do without.
COMMANDS: Mapping[str, tuple[str, ...]] = {
    "motion": ("table",),
    "irregularity": ("delta",),
    "strokes": ("delta",),
    "turning": ("turning",),
    "crank forces": ("forces", "--eps=4"),
    "machine": ("forces", "--eps=4", *MACHINE, "--reciprocating=300kg", *ROD, "--rotating=-40kg"),
    "flywheel": ("flywheel", "--power=50kW", "--speed=120/min", "--delta=1:50;1:100", "--radius=1.5m"),
    "dead centres": ("deadcentres",),
    "harmonics": ("harmonics",),
    "balance": ("balance",),
    "collation": ("collate", "roetscher-112"),
    "arc crank": ("table", "--mechanism=arc", "--rocker=6"),
    "parallel crank": ("table", "--mechanism=parallel"),
    "inertia": ("inertia", "--centre=0.65", "--gyration=0.35"),
    "inertia errors": ("inertia", "--centre=0.65", "--gyration=0.35"),
    "tangent": ("forces", "--at=tangent"),
    "roots": ("solve", "--where=p=0", "--where=s=25%", "--where=c=max"),
}


def about(*subjects: str) -> list[str]:
    """Return the layouts about these subjects."""
    return [name for name in layout_names() if layout(name).subject in subjects]


MOTION = about("motion")
ENGINES = about("irregularity", "strokes", "turning", "crank forces", "machine", "flywheel")
BEAMS = about("dead centres")
BALANCES = about("harmonics", "balance")
COLLATIONS = about("collation")
LINKAGES = about("arc crank", "parallel crank")
# What `kurbel table` prints.
DRIVES = about("motion", "arc crank", "parallel crank")
RODS = about("inertia", "inertia errors", "tangent")
SOLVED = about("roots")

each_layout = pytest.mark.parametrize(
    ("name", "lang"), [(name, lang) for name in layout_names() for lang in LANGUAGES]
)


def command(name: str) -> tuple[str, ...]:
    """Return the words that print the layout with its defaults."""
    return (*COMMANDS[layout(name).subject], f"--layout={name}")


def default_page(name: str, lang: str = "de", label: str = "") -> Table:
    """Make the page that `command` prints, from Python."""
    match layout(name).subject:
        case "motion":
            return kurbel.make_table(layout=name, lang=lang, label=label)
        case "dead centres":
            return kurbel.make_dead_centres_table(layout=name, lang=lang, label=label)
        case "harmonics":
            return kurbel.make_harmonics_table(layout=name, lang=lang, label=label)
        case "balance":
            return kurbel.make_balance_table(layout=name, lang=lang, label=label)
        case "collation":
            return kurbel.make_collation_table("roetscher-112", layout=name, lang=lang, label=label)
        case "arc crank":
            return kurbel.make_arc_table(6, layout=name, lang=lang, label=label)
        case "parallel crank":
            return kurbel.make_parallel_table(layout=name, lang=lang, label=label)
        case "tangent":
            return kurbel.make_tangent_table(layout=name, lang=lang, label=label)
        case "roots":
            where = ("p=0", "s=25%", "c=max")
            return kurbel.make_solve_table(where, layout=name, lang=lang, label=label)
        case "inertia" | "inertia errors":
            return kurbel.make_inertia_table(
                layout=name, centre=0.65, gyration="35%", lang=lang, label=label,
            )  # fmt: skip
        case "machine":
            return kurbel.make_engine_table(
                layout=name, lang=lang, label=label, stroke="0.6", speed=2, bore="0.3", pressure=800_000,
                reciprocating=300, rod_mass=150, centre="0.6", gyration="0.3", rotating=-40,
            )  # fmt: skip
        case "flywheel":
            return kurbel.make_engine_table(
                layout=name, power=50_000, speed=2, irregularities="1:50;1:100", radius=1.5,
                lang=lang, label=label,
            )  # fmt: skip
    return kurbel.make_engine_table(layout=name, lang=lang, label=label)


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


def all_pages() -> list[Table]:
    return [
        *(default_page(name, lang, f"{name}-{lang}") for name in layout_names() for lang in LANGUAGES),
        make_table(radius="0.3", speed=2, label="machine"),
        make_table(offset="0.1", lang="en", label="offset"),
        make_engine_table(methods="weisbach", label="weisbach"),
        make_engine_table(layout="delta-detail", ratios="1:4;1:5", cranks="0;90", label="cranks"),
        make_engine_table(layout="turning", expansions="2;4", angles="0..360:30", label="engines"),
        make_engine_table(back="0.1", exponent="1.13", clearance="0.05", double_acting=False, label="steam"),
    ]
