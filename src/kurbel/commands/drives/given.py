"""The options that describe a crank drive: which one it is, and its lengths."""

from collections.abc import Iterable
from os import PathLike
from typing import Annotated, TypedDict

from kurbel.commands.options import FILE, Choice, Option
from kurbel.drive import mechanisms
from kurbel.reading.given import Exact

STROKE = Option("2R: 600mm; of an offset crank, too, whose piston goes further.", "LENGTH", unit="m")
CRANK = Option("R, in place of --stroke: 300mm.", "LENGTH", unit="m")

Stroke = Annotated[Exact | None, STROKE]
Crank = Annotated[Exact | None, CRANK]
Rod = Annotated[
    Exact | None,
    Option("Rod length L, which with --stroke gives the ratio: 1500mm.", "LENGTH", unit="m"),
]

ANGLE, PATH = "angle", "path"
AXES = (ANGLE, PATH)
# What pages over the path are about.
OVER_PATH, FORCES_OVER_PATH = "over path", "forces over path"
# Of pages of approximations.
APPROXIMATE = ("series errors", "successive")


class OnMachine(TypedDict, total=False):
    """What a machine's file may say."""

    machine: Annotated[
        str | PathLike[str] | None,
        Option(
            "Machine in a TOML file: its crank, load, masses, flywheel; what is given beside it outdoes it.",
            "FILE", FILE, last=True,
        ),
    ]  # fmt: skip


class Slide(OnMachine, total=False):
    """A crank drive with a crosshead, beside its ratio."""

    offset: Annotated[
        Exact | None, Option("Offset crank: e as a share of R, or as a length with --stroke.", "E", unit="R")
    ]
    stroke: Stroke
    crank: Crank
    true_stroke: Annotated[
        Exact | None,
        Option(
            "Way of the piston, in place of --stroke; of an offset crank R follows from it, with --rod or"
            " --ratio: 600mm.",
            "LENGTH", unit="m",
        ),
    ]  # fmt: skip
    time_ratio: Annotated[
        Exact | None,
        Option(
            "With --true-stroke and --offset as a length: time of the outstroke over that of the return, from"
            " which R and L follow: 1.2.",
            "Q",
        ),
    ]  # fmt: skip
    rod: Rod


class Linked(Slide, total=False):
    """Any crank drive."""

    mechanism: Annotated[
        str | None,
        Option(mechanisms.described(), kind=Choice("mechanism", mechanisms.MECHANISMS)),
    ]
    rocker: Annotated[
        Exact | None,
        Option("Arc crank: length of the rocker in units of R, or a length with --crank.", "B", unit="R"),
    ]
    pivot: Annotated[
        str | tuple[Exact, Exact] | None,
        Option(
            "Arc crank: the rocker's pivot along and across the slide, in units of R or as lengths; default:"
            " as far as the rod is long, and B above the slide line. With 'D;0' angles count from the line of"
            " centres, as of a four-bar.",
            "D;H", unit="R",
        ),
    ]  # fmt: skip
    circuit: Annotated[
        Exact | None,
        Option(
            "Arc crank: 1 or -1, the two ways to assemble the links; default 1. Of a four-bar with its pivot"
            " at 'D;0' the open one is -1.",
            "WAY",
        ),
    ]  # fmt: skip


class AnyDrive(Linked, total=False):
    """Any crank drive, the beam engine among them."""

    beam: Annotated[
        Exact | None, Option("Beam engine: arm of the beam in units of R, or a length.", "A", unit="R")
    ]


class Over(TypedDict, total=False):
    """What a page runs over."""

    over: Annotated[
        str,
        Option(
            "What the page runs over: angle (default), or path, at equal shares of the stroke, both strokes"
            " beside each other; with --step 5% or --shares.",
            kind=Choice("axis", AXES), default=ANGLE,
        ),
    ]  # fmt: skip
    shares: Annotated[
        Exact | Iterable[Exact] | None,
        Option(
            "With --over path: shares of the stroke, 25%, lists '0;0.5;1', ranges; default 0..1:0.1.",
            "SHARES",
            many=True,
        ),
    ]  # fmt: skip
