"""The masses that options describe and the steam that drives them: what makes an engine of a crank drive."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, Any

from kurbel.commands import loads
from kurbel.commands.cylinder.effort import RODS, RUBBING
from kurbel.commands.cylinder.engines import MovingRod
from kurbel.commands.cylinder.slope import LYING, check_crosshead, slope_of
from kurbel.commands.loads import FURTHER
from kurbel.commands.old_motion import FULL_TURN, described, meant, sheet_of
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Run
from kurbel.drive.spin import acceleration_of
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism, uncomputed
from kurbel.page.layouts import Layout
from kurbel.reading.given import (
    as_crank_angles,
    as_duration,
    as_expansions,
    as_gravity,
    as_inertia,
    as_length,
    as_mass,
    as_number,
    as_pressure,
    as_share,
    as_share_or_length,
    as_share_or_pressure,
    as_signed_mass,
    as_speed,
)

if TYPE_CHECKING:
    from kurbel.drive.load import Load as Acting
    from kurbel.drive.rod import Rod
    from kurbel.engine.engine import Diagram, Load
    from kurbel.engine.request import EngineRequest

# The options, by their names, that describe the steam and the masses.
STEAM = ("eps", "back", "exponent", "clearance", "card", "other_side", "single_acting", *FURTHER)
MASSES = ("reciprocating", *MovingRod.__annotations__, "rotating", "rocker_inertia")
EXAMPLE = "epsilon,delta"
_UNKNOWN = "that of the rod is not known; add --stroke and one --ratio, or give a share of the rod's length"


def _read(reader: Callable[..., Fraction], value: Any, *about: Any) -> Fraction | None:
    return None if value is None else reader(value, *about)


def rod_of(given: Mapping[str, Any], length: Fraction | None) -> Rod:
    """Return the connecting rod between pins so far apart, in metres, if that is known."""
    from kurbel.drive.rod_file import given_rod

    centre = _read(as_share_or_length, given["centre"], "centre of mass", length, _UNKNOWN)
    if given.get("pendulum") is not None or given.get("pendulum_from") is not None:
        return _swung(given, centre, length)
    return given_rod(
        centre,
        _read(as_share_or_length, given["gyration"], "radius of gyration", length, _UNKNOWN),
        given["rod_file"],
        _read(as_mass, given["rod_mass"], "rod mass"),
        length,
    )


def _swung(given: Mapping[str, Any], centre: Fraction | None, length: Fraction | None) -> Rod:
    """Return the rod whose radius of gyration its time of swing tells."""
    from kurbel.drive.rod_file import given_swing, swung_rod

    for name in ("gyration", "rod_file"):
        if is_given(given[name]):
            raise ProblemError(f"--{name.replace('_', '-')} and --pendulum say the same; leave one out")
    swing = given_swing(
        _read(as_duration, given["pendulum"], "time of a swing"),
        given["pendulum_from"],
        _read(as_gravity, given.get("gravity")),
    )
    return swung_rod(swing, centre, length, _read(as_mass, given["rod_mass"], "rod mass"))


def weighed(chosen: Mechanism, drives: Sequence[Any], given: Mapping[str, Any], *beside: str) -> list[Any]:
    """Return the drives with the masses given, and the speed that makes forces of them.

    `beside` are the names of further options that every mass needs.
    """
    if not is_heavy(given):
        return list(drives)
    cranks = [chosen.crank(drive) for drive in drives]
    missing = [f"--{name.replace('_', '-')}" for name in ("speed", *beside) if given[name] is None]
    if any(crank.radius is None for crank in cranks):
        missing.insert(0, "--stroke")
    if missing:
        first = next(name for name in MASSES if given.get(name) is not None)
        raise ProblemError(f"--{first.replace('_', '-')} needs {', '.join(missing)} to become a force")
    from kurbel.drive.rod import Moving

    # One rod for all ratios has a length of its own only if there is one ratio.
    length = cranks[0].rod_length if len(cranks) == 1 else None
    moving = Moving(
        _read(as_mass, given["reciprocating"], "reciprocating mass") or Fraction(0),
        rod_of(given, length) if any(given[name] is not None for name in MovingRod.__annotations__) else None,
        _read(as_signed_mass, given.get("rotating"), "rotating mass") or Fraction(0),
        _read(as_inertia, given.get("rocker_inertia"), "rocker inertia") or Fraction(0),
        slope=slope_of(given),
    )
    check_crosshead(chosen, moving.slope)
    speed = as_speed(given["speed"])
    about: dict[str, Any] = {"speed": speed, "moving": moving}
    if given.get("acceleration") is not None:
        about["acceleration"] = acceleration_of(given["acceleration"], speed)
    return [drive.of(replace(crank, **about)) for drive, crank in zip(drives, cranks, strict=True)]


def is_heavy(values: Mapping[str, Any]) -> bool:
    """Whether any mass is among the options, or among the entries of cylinders."""
    given = (values, *(values.get("cylinder") or ()))
    return any(one.get(name) is not None for one in given for name in MASSES)


def for_masses(*names: str) -> Callable[[Mapping[str, Any]], Mapping[str, str]]:
    """Return what refuses these options where there are no masses."""

    def refusals(values: Mapping[str, Any]) -> Mapping[str, str]:
        # Unlike cylinders are compared by their sizes.
        if is_heavy(values) or is_given(values.get("cylinder")):
            return {}
        return {
            name: f"--{name} is for moving masses; add --reciprocating or a rod, --rod-mass"
            for name in names
            if name != "pressure" or not has_back_pressure(values)
        }

    return refusals


def has_back_pressure(values: Mapping[str, Any]) -> bool:
    """Whether the back pressure is given as a pressure, which counts in that of the steam."""
    back = values.get("back")
    if not isinstance(back, str):
        return False
    from kurbel.reading.units import is_measure

    return is_measure(back)


def lone_lengths(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse the length of stroke or rod on a page without lengths, which both together give a ratio."""
    if is_given(values["stroke"]) == is_given(values["rod"]):
        return {}
    # Another length is compared with the crank.
    if any(re.search("[a-z]", str(values.get(name) or "")) for name in ("offset", "rocker", "pivot", "beam")):
        return {}
    return {
        name: f"--{name} gives the ratio with --{other}; add that, or leave --{name} out"
        for name, other in (("stroke", "rod"), ("rod", "stroke"))
    }


def unsized(values: Mapping[str, Any], what: str = "load") -> Mapping[str, str]:
    """Refuse a length that makes neither newton metres of a load nor a ratio."""
    if is_heavy(values) or is_given(values.get("cylinder")) or values["bore"] is not None:
        return {}
    refused = {**lone_lengths(values)}
    if "stroke" in refused:
        refused["stroke"] = f"--stroke makes newton metres of the {what} only with --bore; add that"
    return refused


def needless_of_load(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says something of a weight or of pressures, where nothing has or counts in one."""
    if not (is_given(values["card"]) or _is_other(values)):
        return weightless(values)
    return {**weightless(values), **loads.uncounted(values)}


def weightless(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says something of a weight where nothing has one."""
    if not any(is_given(values.get(name)) for name in LYING):
        return {}
    from kurbel.commands.cylinder.slope import needless_of_slope

    return needless_of_slope(values, is_heavy(values) or is_given(values.get("cylinder")))


def steams_of(given: Mapping[str, Any], page: Layout) -> Sequence[Acting]:
    """Return the indicator cards, or the ideal ones of all expansion ratios, or other loads."""
    from kurbel.engine.engine import Steam

    if _is_other(given):
        return loads.loads_of(given)
    if not is_given(given["card"]):
        if given["other_side"] is not None:
            raise ProblemError("--other-side is for --card; of an ideal card --back is the pressure there")
        back = _read(as_share_or_pressure, given["back"], "back pressure", given["pressure"])
        exponent = as_number(1 if given["exponent"] is None else given["exponent"], "exponent")
        clearance = as_share(0 if given["clearance"] is None else given["clearance"], "clearance")
        if given["eps"] is None and not page.expansions:
            raise ProblemError(
                "what acts on the piston is not known; add the expansion ratio of its steam, --eps 4, or"
                " --card, --pressure-ratio, --pump or --compression"
            )
        values = as_expansions(page.expansions if given["eps"] is None else given["eps"])
        return [Steam(expansion, back, exponent, clearance) for expansion in values]
    return cards_of(given)


def cards_of(given: Mapping[str, Any]) -> Sequence[Diagram]:
    """Return the indicator cards, none if there are none."""
    if not is_given(given["card"]):
        return ()
    from kurbel.engine.card.file import read_card
    from kurbel.engine.engine import Diagram

    for name in ("eps", "back", "exponent", "clearance"):
        if is_given(given.get(name)):
            raise ProblemError(
                f"--{name} describes an ideal card, and --card gives a measured one; leave one out"
            )
    if given["other_side"] is not None and not given["single_acting"]:
        raise ProblemError("--other-side is for --single-acting; double-acting, the other end works as well")
    pressure = _read(as_pressure, given["other_side"], "other side")
    other = None if pressure is None else float(pressure)
    files = [given["card"]] if isinstance(given["card"], str | PathLike) else given["card"]
    return [Diagram(read_card(file), other) for file in files]


def load_of(given: Mapping[str, Any]) -> Load | None:
    """Return what makes newtons of the force on the piston, None if it is not known."""
    if _is_other(given):
        return loads.load_of(given)
    if given["bore"] is None and (is_given(given["card"]) or given["pressure"] is None):
        return None
    if given["bore"] is None and has_back_pressure(given):
        return None
    if missing := [name for name in of_load(given) if given[name] is None]:
        raise ProblemError(f"newtons need the bore and the steam pressure; add --{missing[0]}")
    from kurbel.engine.engine import Load

    return Load(as_length(given["bore"], "bore"), _read(as_pressure, given["pressure"], "pressure"))


def of_load(given: Mapping[str, Any]) -> tuple[str, ...]:
    """Return what makes newtons of the load, against which masses are weighed."""
    if _is_other(given):
        return ("bore", *loads.pressures_of(given))
    return ("bore",) if is_given(given["card"]) else ("bore", "pressure")


def _is_other(given: Mapping[str, Any]) -> bool:
    """Whether something else than steam and cards acts on the piston."""
    return any(is_given(given.get(name)) for name in FURTHER)


def layout_of_load(given: Mapping[str, Any]) -> str:
    """Return the layout of the irregularity under such a load, nothing for steam and cards."""
    if is_given(given.get("cylinder")):
        return "delta-detail"
    return loads.layout_of_load(given) if _is_other(given) else ""


def _turning(chosen: Mechanism, drive: Any, speed: Any) -> Any:
    """Return a drive that turns at a speed."""
    return drive.of(replace(chosen.crank(drive), speed=as_speed(speed)))


def whole_cycle(given: Mapping[str, Any]) -> Fraction:
    """Return the degrees after which everything comes again."""
    if is_given(given.get("cylinder")):
        from kurbel.commands.cylinder import several

        return several.whole_cycle(given)
    if _is_other(given):
        return loads.whole_cycle(given)
    strokes = max((load.strokes_of_cycle for load in cards_of(given)), default=2)
    return FULL_TURN * strokes / 2


def over_cycle(given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the options of a run of angles, by themselves over the whole cycle where it is longer than a
    turn."""
    last = whole_cycle(given)
    run = given["to"] is None and given.get("angle") is None and last > FULL_TURN
    return {**given, "to": last} if run else given


def described_engines(page: Layout, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the loads, drives and sizes of the engines that options describe, as a request takes them."""
    # A speed alone makes no force, and the methods are an engine's own.
    known = {name: value for name, value in given.items() if name not in ("speed", "method", "force")}
    chosen, said = described({**known, "layout": None})
    steams = steams_of(given, page)
    if sentence := uncomputed(chosen, steams[0].name) if steams else "":
        raise ProblemError(sentence)
    speed = given.get("speed")
    drives = weighed(chosen, chosen.drives(said, page.ratios), given, *of_load(given))
    if any(given.get(name) is not None for name in (*RUBBING, *RODS)):
        from kurbel.commands.cylinder.effort import on_engine

        drives = on_engine(chosen, drives, given)
    sized = bool(drives) and chosen.crank(drives[0]).radius is not None
    if speed is not None and sized and not is_heavy(given):
        drives = [_turning(chosen, drive, speed) for drive in drives]
    return {
        "steams": steams,
        "drives": drives,
        "mechanism": chosen,
        "double": getattr(steams[0], "double", not given["single_acting"]) if steams else True,
        "load": load_of(given),
    }


def engine_of(
    page: Layout, given: Mapping[str, Any], asked: type[EngineRequest] | None = None, **rest: Any
) -> EngineRequest:
    """Return what is asked for of the engines that options describe: with their masses, under their steam."""
    from kurbel.engine.request import EngineRequest

    cranks, methods = given.get("cranks"), given["method"] or ()
    if is_given(given.get("cylinder")):
        from kurbel.commands.cylinder.several import assembly_of, seen_from

        assembly = assembly_of(page, given)
        numbers: tuple[int, ...] = ()
        if given.get("of") is not None:
            assembly, numbers = seen_from(assembly, given["of"])
        first, own = assembly.first, given["cylinder"][numbers[0] - 1 if numbers else 0]
        about: dict[str, Any] = {
            "mechanism": meant({**given, **own, "layout": None}),
            "steams": [first.steam], "drives": [first.drive], "double": first.double, "load": first.load,
            "assembly": assembly, "cranks": assembly.cranks, "numbers": numbers,
        }  # fmt: skip
    elif given.get("of") is not None:
        raise ProblemError("--of names one of several cylinders; add each as --cylinder, or leave it out")
    else:
        about = {
            **described_engines(page, given), "cranks": as_crank_angles("0" if cranks is None else cranks)
        }  # fmt: skip
    return (asked or EngineRequest)(
        layout=loads.on_page(page) if _is_other(given) or "assembly" in about else page,
        methods=tuple(dict.fromkeys((methods,) if isinstance(methods, str) else methods)),
        **about,
        **sheet_of(given),
        **rest,
    )


def check_whole(page: Layout, given: Mapping[str, Any]) -> None:
    """Raise ProblemError where crank angles are given to a page of the whole turn."""
    for name in Run.__annotations__:
        if is_given(given[name]):
            raise ProblemError(f"layout {page.key} is of the whole turn; leave --{name.rstrip('_')} out")
