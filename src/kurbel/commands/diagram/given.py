"""Torques, loads and areas of turning-moment diagrams, as options describe them."""

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands.options import FILE, Option, is_given
from kurbel.commands.parameters import Sheet
from kurbel.commands.subject import Refusals
from kurbel.errors import ProblemError
from kurbel.reading.given import (
    Exact,
    as_crank_angles,
    as_energy,
    as_fraction,
    as_power,
    as_share,
    as_speed,
)

if TYPE_CHECKING:
    from kurbel.engine.diagram.areas import Areas
    from kurbel.engine.diagram.excess import Excess
    from kurbel.engine.diagram.fluctuation import Fluctuation
    from kurbel.engine.diagram.torque import Torque

MOST_TURNS = 100
DRIVES, LOADS = ("torque", "torque_file", "triangles"), ("load_torque", "load_torque_file")
# The options that describe a diagram, each by itself.
DIAGRAMS = (*DRIVES, *LOADS, "areas")
# What else says something on their pages.
BESIDE = ("speed", "inertia", "cranks", "angle", "step", "columns", "layouts", "layout")


class Diagram(TypedDict, total=False):
    """A turning-moment diagram that no engine makes."""

    torque: Annotated[
        str | None,
        Option(
            "Diagram without an engine: torque over the crank angle, as a formula, '5000 + 1500 sin(3φ)', or"
            " points, '0:0; 60:90; 180:0' or 'every 30°: 0; 45; 90', which straight lines join.",
            "T", unit="N m",
        ),
    ]  # fmt: skip
    torque_file: Annotated[
        str | PathLike[str] | None,
        Option("The same from a CSV file with the columns angle and torque [N m].", "FILE", FILE),
    ]
    triangles: Annotated[
        str | Iterable[Exact] | None,
        Option(
            "Diagram of triangles alike in width, as of the strokes of a gas engine, by their areas from the"
            " line of no torque: '-350;-1400;+3550;-500', with --turns and --area-scale, or --power and"
            " --speed.",
            "AREAS",
        ),
    ]  # fmt: skip
    load_torque: Annotated[
        str | None,
        Option(
            "Torque of the load, a formula or points; default: the mean of the drive. Alone, the drive has"
            " its mean.",
            "T", unit="N m",
        ),
    ]  # fmt: skip
    load_torque_file: Annotated[str | PathLike[str] | None, Option("The same from a CSV file.", "FILE", FILE)]
    turns: Annotated[
        Exact | None,
        Option(
            "Turns after which a diagram comes again: 1, 2, 1/3; default: as its formula, or to its last"
            " point.",
            "N",
        ),
    ]  # fmt: skip
    areas: Annotated[
        str | Iterable[Exact] | None,
        Option(
            "Diagram by the areas between it and its mean line, in order, those above positive:"
            " '+52;-124;+72'.",
            "AREAS",
        ),
    ]  # fmt: skip
    area_scale: Annotated[
        str | None,
        Option(
            "What a unit of these areas stands for: 52.36J, or the units of torque and angle, '500 N m; 6°'.",
            "SCALE",
        ),
    ]  # fmt: skip


def is_diagram(given: Mapping[str, Any]) -> bool:
    """Whether options describe a diagram."""
    return any(is_given(given.get(name)) for name in DIAGRAMS)


def foreign(others: Refusals, *further: str) -> Refusals:
    """Return what refuses the options of engines beside a diagram, and without one what `others` does.

    `further` are names of options that say something of diagrams, too.
    """

    def refusals(values: Mapping[str, Any]) -> Mapping[str, str]:
        if not is_diagram(values):
            return others(values)
        own = {*Diagram.__annotations__, *Sheet.__annotations__, *BESIDE, *further}
        if is_given(values["triangles"]):
            own.add("power")
        named = next(name for name in DIAGRAMS if is_given(values.get(name)))
        flag = named.replace("_", "-")
        return {
            name: f"--{name.replace('_', '-')} describes an engine, and --{flag} a diagram without one; leave"
            " one of them out"
            for name in values
            if name not in own
        }

    return refusals


def needless(others: Refusals) -> Refusals:
    """Return what refuses the options that describe a diagram further where there is none of that kind, and
    without one what `others` does."""

    def refusals(values: Mapping[str, Any]) -> Mapping[str, str]:
        refused = {} if is_diagram(values) else {**others(values)}
        if not is_diagram(values):
            refused["turns"] = "--turns is for a diagram without an engine; add --torque, or leave it out"
        if is_given(values["triangles"]) and _is_scaled(values):
            refused["power"] = "--power gives the scale of triangles, and these have one; leave it out"
        if is_given(values["areas"]):
            refused["turns"] = (
                "--turns is of a diagram over the crank angle, and --areas have none; leave it out"
            )
        if not (is_given(values["areas"]) or is_given(values["triangles"])):
            refused["area_scale"] = "--area-scale is for --areas or --triangles; add these, or leave it out"
        return refused

    return refusals


def fluctuation_of(given: Mapping[str, Any]) -> "Fluctuation":
    """Return how the energy varies by the diagram that options describe. Raises KurbelError."""
    return areas_of(given) if is_given(given["areas"]) else excess_of(given)


def areas_of(given: Mapping[str, Any]) -> "Areas":
    """Return the areas of a diagram. Raises KurbelError."""
    from kurbel.engine.diagram.areas import given_areas

    for name in (*DRIVES, *LOADS, "cranks"):
        if is_given(given.get(name)):
            raise ProblemError(
                f"--areas is a whole diagram, and --{name.replace('_', '-')} says of another one; leave one"
                " out"
            )
    if not is_given(given["areas"]):
        raise ProblemError("no areas were given; add --areas '+52;-124;+72' with --area-scale 52.36J")
    return given_areas(_texts(given["areas"]), given["area_scale"], turns_of(given))


def _texts(areas: str | Iterable[Any]) -> list[str]:
    return [areas] if isinstance(areas, str) else [str(one) for one in areas]


def excess_of(given: Mapping[str, Any]) -> "Excess":
    """Return the excess of the drive's torque over that of the load. Raises KurbelError."""
    from kurbel.engine.diagram.excess import Excess

    turns, by_degree = turns_of(given), is_given(given["triangles"])
    drive, load = (
        _torque(given, names, turns, what)
        for names, what in ((DRIVES, "torque"), (LOADS, "torque of the load"))
    )
    if is_given(given.get("cranks")):
        if drive is None:
            raise ProblemError("--cranks are those of the drive; add its --torque, or leave them out")
        drive = drive.superposed(as_crank_angles(given["cranks"]))
    return Excess.between(drive, load, by_degree)


def turns_of(given: Mapping[str, Any]) -> Fraction | None:
    """Return the turns of a cycle, None where they were not given."""
    if given.get("turns") is None:
        return None
    turns = as_fraction(given["turns"])
    if not 0 < turns <= MOST_TURNS:
        raise ProblemError(f"a cycle of {turns} turns was given; it must be above 0 and at most {MOST_TURNS}")
    return turns


def _torque(
    given: Mapping[str, Any], names: tuple[str, ...], turns: Fraction | None, what: str
) -> "Torque | None":
    own = [name for name in names if is_given(given.get(name))]
    if len(own) > 1:
        flags = " and ".join(f"--{name.replace('_', '-')}" for name in own)
        raise ProblemError(f"{flags} give the {what} twice; leave one out")
    text, file = (given.get(name) for name in names[:2])
    if own == ["triangles"]:
        return _triangles(given, turns)
    if file is not None:
        from kurbel.engine.diagram.points import read_points, torque_through

        return torque_through(read_points(file), turns, what)
    if text is None:
        return None
    if str(text).lower().endswith(".csv"):
        flag = names[0].replace("_", "-")
        raise ProblemError(f"--{flag} {str(text)[:40]} is a file; name it as --{flag}-file")
    if ":" in str(text):
        from kurbel.engine.diagram.points import points_of, torque_through

        return torque_through(points_of(str(text), what), turns, what)
    from kurbel.engine.diagram.formula import torque_of
    from kurbel.engine.diagram.torque import Torque, own_cycle

    waves = torque_of(str(text), what)
    return Torque.of(waves, own_cycle(waves, turns, what))


def _triangles(given: Mapping[str, Any], turns: Fraction | None) -> "Torque":
    from kurbel.engine.diagram.areas import scaled_areas
    from kurbel.engine.diagram.points import triangles

    for name in LOADS:
        if is_given(given[name]):
            raise ProblemError(
                f"--triangles are against a constant load, and --{name.replace('_', '-')} gives another;"
                " leave one out, or write the triangles as points of --torque"
            )
    if turns is None:
        raise ProblemError("--triangles need the turns of their cycle; add --turns 2 for four strokes")
    if not _is_scaled(given):
        return triangles([*_by_work(given, turns)], turns)
    areas, scale, _ = scaled_areas(_texts(given["triangles"]), given["area_scale"], "triangles")
    if scale.of_pi:
        raise ProblemError(
            "--triangles need the energy of a unit of area, --area-scale 3J; a torque and an angle in degrees"
            " would make one with π, write the angle in rad"
        )
    return triangles([area * scale.energy for area in areas], turns)


def _is_scaled(given: Mapping[str, Any]) -> bool:
    """Whether triangles have a scale, or their areas a unit."""
    return given["area_scale"] is not None or any(map(str.isalpha, "".join(_texts(given["triangles"]))))


def _by_work(given: Mapping[str, Any], turns: Fraction) -> Iterator[Fraction]:
    """Yield the areas of triangles in J, of which all together are the work of the cycle."""
    from kurbel.reading.notation import about, each_number

    areas = each_number(_texts(given["triangles"]), "area")
    total, work = sum(areas, Fraction(0)), _work(given, turns)
    if total <= 0:
        raise ProblemError(
            f"the triangles sum to {about(total)}; they are the work of a cycle and must sum to more than 0"
        )
    cranks = len(as_crank_angles(given["cranks"])) if is_given(given.get("cranks")) else 1
    yield from (area * work / total / cranks for area in areas)


def _work(given: Mapping[str, Any], turns: Fraction) -> Fraction:
    """Return the work of a cycle in J, given or by power and speed."""
    if given.get("work") is not None:
        return as_energy(given["work"], "work of a cycle")
    if given["power"] is None or given["speed"] is None:
        raise ProblemError(
            "the triangles have no scale; add the energy of a unit of area, --area-scale 3J, or --power and"
            " --speed, which give the work of the cycle, or write their unit: '-350J;+3550J'"
        )
    if ".." in str(given["speed"]):
        raise ProblemError(
            f"the work of a cycle needs the mean speed, and {str(given['speed'])[:40]} is a range; write it"
            " as --speed 300/min with --delta"
        )
    speed = as_speed(given["speed"])
    if not speed.turns:
        raise ProblemError(
            f"the speed {given['speed']} makes a scale of the triangles with π; write it in turns, as 300/min"
        )
    share = 1 if given.get("efficiency") is None else as_share(given["efficiency"], "efficiency")
    return as_power(given["power"]) * share * turns / speed.value
