"""The options of an engine: what acts in its cylinders, and the masses of its rods."""

from collections.abc import Iterable
from typing import Annotated, TypedDict

from kurbel.commands.cylinder.effort import Rods, Rubbing
from kurbel.commands.cylinder.given import Cylinders
from kurbel.commands.cylinder.slope import Lying
from kurbel.commands.loads import Loads
from kurbel.commands.options import FILE, FLAG, Choice, Option
from kurbel.commands.parameters import (
    BACK,
    RATIO,
    AnyDrive,
    Cranks,
    Given,
    Names,
    Path,
    Reciprocating,
    RockerInertia,
    Sheet,
)
from kurbel.reading.given import Exact


class Cylinder(Loads, total=False):
    """What acts in a cylinder, beside the expansion ratio of its steam."""

    back: Annotated[Exact | None, BACK]
    exponent: Annotated[
        Exact | None, Option("n of p Vⁿ = const.; default 1, Mariotte's law, of gas engines 1.4.", "N")
    ]
    clearance: Annotated[Exact | None, Option("Clearance as a share of the swept volume: 0.05, 5%.", "C")]
    card: Annotated[
        Path | Iterable[Path] | None,
        Option(
            "Indicator card: CSV with position, p_forward [bar], p_return [bar], or angle, p [bar].",
            "FILE",
            FILE,
            many=True,
        ),
    ]
    other_side: Annotated[
        Exact | None,
        Option(
            "With --single-acting and --card or --pressure-ratio: pressure on the piston's other face, 1bar.",
            "PRESSURE",
            unit="Pa",
        ),
    ]
    single_acting: Annotated[
        bool,
        Option(
            "One end works: steam on the outstroke only, and on the return both faces have the"
            " back pressure; a compressor sucks on the outstroke and delivers on the return.",
            kind=FLAG,
            default=False,
        ),
    ]
    bore: Annotated[Exact | None, Option("Bore of the cylinder: 300mm.", "LENGTH", unit="m")]
    pressure: Annotated[
        Exact | None,
        Option("Steam pressure before cut-off: 8bar; an indicator card has its own.", "PRESSURE", unit="Pa"),
    ]


class Steam(Cylinder, total=False):
    """The same in the cylinders of so many cranks."""

    cranks: Cranks
    cylinder: Cylinders


class MovingRod(TypedDict, total=False):
    """The masses of a connecting rod."""

    rod_mass: Annotated[Exact | None, Option("Mass of the connecting rod: 150kg.", "MASS", unit="kg")]
    centre: Annotated[
        Exact | None,
        Option(
            "Centre of mass of the rod from the crosshead pin, in rod lengths: 0.6, 60%; or a length, where"
            " that of the rod is known.",
            "A", unit="rod lengths",
        ),
    ]  # fmt: skip
    gyration: Annotated[
        Exact | None,
        Option(
            "Radius of gyration about the centre of mass, in rod lengths: 0.3; or a length.", "K",
            unit="rod lengths",
        ),
    ]  # fmt: skip
    pendulum: Annotated[
        Exact | None,
        Option(
            "In place of --gyration the time of a full swing, to and fro, about the pin that --pendulum-from"
            " names: 1.8s.",
            "TIME", unit="s",
        ),
    ]  # fmt: skip
    pendulum_from: Annotated[
        str | None,
        Option(
            "The pin about which the rod swung: crosshead or crank.",
            kind=Choice("pin", "kurbel.drive.rod:PINS"),
        ),
    ]
    rod_file: Annotated[
        Path | None,
        Option(
            "The rod's masses from a CSV file in place of these: from, to, mass or position, mass, counted"
            " from the crank pin.",
            "FILE", FILE,
        ),
    ]  # fmt: skip


class Engine(Steam, MovingRod, Lying, Rods, Rubbing, AnyDrive, Sheet, total=False):
    """An engine: its crank drive, its load, its masses and its cranks."""

    ratio: Annotated[
        Given | None,
        RATIO._replace(help="Crank ratio: 1:5, 1:4,5; lists and ranges 1:3..6; 1:∞ is the infinite rod."),
    ]
    method: Annotated[
        Names | None,
        Option(
            "exact (default), series (first order) or weisbach (his equations of § 150).",
            kind=Choice("method", "kurbel.engine.quantities:ENGINE_METHODS"), many=True, default=(),
        ),
    ]  # fmt: skip
    reciprocating: Reciprocating
    rocker_inertia: RockerInertia
