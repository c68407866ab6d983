"""What options describe of the forces on piston and crosshead: pressures on both sides, rods, friction."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands.options import Option
from kurbel.errors import ProblemError
from kurbel.reading.given import Exact, as_force, as_length, as_pressure, as_share

if TYPE_CHECKING:
    from kurbel.drive.effort import Areas, Effort, Pins, Pressures

RUBBING = ("friction",)
RODS = ("piston_rod", "tail_rod")
SIDES = ("head_pressure", "crank_pressure")
DIFFERENCE = "pressure_difference"
PRESSING = (*SIDES, DIFFERENCE)
PINS = ("crosshead_pin", "crank_pin", "shaft")
PINNED = ("pin_friction", *PINS)


class Rubbing(TypedDict, total=False):
    """What acts against the motion of piston and crosshead."""

    friction: Annotated[
        Exact | None,
        Option("Friction of piston and crosshead, against their motion: 500N.", "FORCE", unit="N"),
    ]


class Rods(TypedDict, total=False):
    """The rods of the piston, which lessen its areas."""

    piston_rod: Annotated[
        Exact | None,
        Option(
            "Diameter of the piston rod, which lessens the area on the side of the crank: 50mm.", "LENGTH",
            unit="m",
        ),
    ]  # fmt: skip
    tail_rod: Annotated[
        Exact | None,
        Option("The same of a rod through the cover, on the other side: 40mm.", "LENGTH", unit="m"),
    ]


class Pressing(TypedDict, total=False):
    """The pressures on both sides of the piston."""

    head_pressure: Annotated[
        Exact | None,
        Option(
            "With --bore: pressure on the piston's side of the cover, above the surroundings: 0.3bar. It acts"
            " as long as the crank turns; without --crank-pressure none is on the other side.",
            "PRESSURE", unit="Pa",
        ),
    ]  # fmt: skip
    crank_pressure: Annotated[
        Exact | None,
        Option(
            "The same on the side of the crank, on the area less that of the --piston-rod: 1.5kPa.",
            "PRESSURE", unit="Pa",
        ),
    ]  # fmt: skip
    pressure_difference: Annotated[
        Exact | None,
        Option(
            "In place of both: by how much the pressure of the cover's side is higher, on the full area:"
            " 2.5bar; -2.5bar where it is lower.",
            "PRESSURE", unit="Pa",
        ),
    ]  # fmt: skip


class Pinned(TypedDict, total=False):
    """The friction of the pins, by their circles of friction."""

    pin_friction: Annotated[
        Exact | None,
        Option(
            "Coefficient of friction of the pins, for the torque less their friction: 0.06. A pin without a"
            " diameter has none.",
            "μ",
        ),
    ]
    crosshead_pin: Annotated[
        Exact | None,
        Option("With --pin-friction: diameter of the crosshead pin: 80mm.", "LENGTH", unit="m"),
    ]
    crank_pin: Annotated[Exact | None, Option("The same of the crank pin: 120mm.", "LENGTH", unit="m")]
    shaft: Annotated[Exact | None, Option("The same of the shaft: 140mm.", "LENGTH", unit="m")]


def rubbed(chosen: Any, drives: Sequence[Any], given: Mapping[str, Any]) -> list[Any]:
    """Return drives with what acts on piston and crosshead beside a given force."""
    found = effort_of(given)
    if found is None:
        return list(drives)
    if found.pins is not None:
        for drive in drives:
            crank = chosen.crank(drive)
            if crank.radius is None:
                raise ProblemError("--pin-friction needs the size of the crank; add --stroke")
            if crank.moving is not None and crank.moving.rod is not None:
                raise ProblemError(
                    "--pin-friction is of a rod without mass, whose line of thrust is one; leave the rod's"
                    " mass out"
                )
            found.pins.check(crank.radius, crank.ratio)
    return _with(chosen, drives, found)


def on_engine(chosen: Any, drives: Sequence[Any], given: Mapping[str, Any]) -> list[Any]:
    """Return the drives of an engine with its rods and its friction."""
    friction, rods = given.get("friction"), [name for name in RODS if given.get(name) is not None]
    if friction is None and not rods:
        return list(drives)
    from kurbel.drive.effort import Effort

    if given["bore"] is None:
        name = "friction" if friction is not None else rods[0]
        raise ProblemError(f"{_flag(name)} is weighed against the load by the bore; add --bore")
    force = Fraction(0) if friction is None else as_force(friction, "friction")
    return _with(chosen, drives, Effort(None, force, areas_of(given) if rods else None))


def _with(chosen: Any, drives: Sequence[Any], effort: "Effort") -> list[Any]:
    if not chosen.crosshead:
        raise ProblemError(
            f"{chosen.title} with friction or pressures on its piston is not computed; leave out what gives"
            " these, or add --mechanism straight"
        )
    return [drive.of(replace(chosen.crank(drive), effort=effort)) for drive in drives]


def effort_of(given: Mapping[str, Any]) -> "Effort | None":
    """Return the pressures and the friction that are given, None without any."""
    friction = given.get("friction")
    pressures = _pressures(given)
    pins = _pins(given)
    if friction is None and pressures is None and pins is None:
        return None
    from kurbel.drive.effort import Effort

    force = Fraction(0) if friction is None else as_force(friction, "friction")
    return Effort(pressures, force, pins=pins)


def _pins(given: Mapping[str, Any]) -> "Pins | None":
    if given.get("pin_friction") is None:
        return None
    from kurbel.drive.effort import Pins

    diameters = (
        Fraction(0) if given.get(name) is None else as_length(given[name], _words(name)) for name in PINS
    )
    return Pins(as_share(given["pin_friction"], "pin friction"), *diameters)


def _pressures(given: Mapping[str, Any]) -> "Pressures | None":
    known = {name: as_pressure(given[name], _words(name)) for name in PRESSING if given.get(name) is not None}
    if not known:
        return None
    from kurbel.drive.effort import Pressures

    if DIFFERENCE in known:
        return Pressures(areas_of(given), known[DIFFERENCE], Fraction(0), difference=True)
    head, crank = (known.get(name, Fraction(0)) for name in SIDES)
    return Pressures(areas_of(given), head, crank)


def areas_of(given: Mapping[str, Any]) -> "Areas":
    """Return the areas of the piston."""
    from kurbel.drive.effort import Areas

    rods = (given.get(name) for name in RODS)
    diameters = (
        Fraction(0) if one is None else as_length(one, _words(name))
        for name, one in zip(RODS, rods, strict=True)
    )
    return Areas(as_length(given["bore"], "bore"), *diameters)


def needless_of_pressures(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse pressures without an area, and what contradicts them, where no engine's load acts."""
    pressed = [name for name in PRESSING if values.get(name) is not None]
    if not pressed:
        bare = "lessens the area on which a pressure acts; add --head-pressure or --crank-pressure"
        return {name: f"{_flag(name)} {bare}" for name in RODS}
    first = _flag(pressed[0])
    refused = {"force": f"--force and {first} are two forces on one piston; leave one out"}
    if values.get("bore") is None:
        refused[pressed[0]] = f"{first} needs the area on which it acts; add --bore, for example --bore 300mm"
    if DIFFERENCE in pressed:
        both = f"and {_flag(DIFFERENCE)} are given for the same pressures; leave one out"
        refused |= {name: f"{_flag(name)} {both}" for name in SIDES}
        whole = f"does not lessen the full area on which {_flag(DIFFERENCE)} acts; give --head-pressure and"
        refused |= {name: f"{_flag(name)} {whole} --crank-pressure in its place" for name in RODS}
    return refused


def needless_beside_load(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse pressures beside the load of an engine, and the friction of pins."""
    why = "does not go with the load of an engine, which has its own pressures; leave one of the two out"
    pins = "is for a given force or pressures; the turn of an engine with it is not computed"
    refused = {name: f"{_flag(name)} {why}" for name in PRESSING}
    return refused | {name: f"{_flag(name)} {pins}" for name in PINNED}


def needless_of_pins(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse diameters without friction, friction without one, and masses of which the circles are not."""
    if values.get("pin_friction") is None:
        why = "is for the friction of the pins; add --pin-friction, for example --pin-friction 0.06"
        return {name: f"{_flag(name)} {why}" for name in PINS}
    if all(values.get(name) is None for name in PINS):
        names = ", ".join(map(_flag, PINS))
        return {"pin_friction": f"--pin-friction needs the diameter of a pin; add one of {names}"}
    why = "does not go with --pin-friction, whose line of thrust is that of a rod without mass; leave one out"
    return {name: f"{_flag(name)} {why}" for name in ("rod_mass", "rod_file", "rotating")}


def _flag(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _words(name: str) -> str:
    return name.replace("_", " ")
