"""The crank angles at which path, velocity, acceleration and the like fulfil a condition."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import PRESSING, RODS, RUBBING, Pressing, Rods, Rubbing
from kurbel.commands.cylinder.given import Of
from kurbel.commands.cylinder.slope import LYING, Lying
from kurbel.commands.loads import OWN
from kurbel.commands.machines import (
    MASSES,
    STEAM,
    engine_of,
    for_masses,
    is_heavy,
    needless_of_load,
    unsized,
    weighed,
    weightless,
)
from kurbel.commands.old_motion import described, meant, method_of, of_other_mechanisms, sheet_of, some
from kurbel.commands.options import Choice, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.errors import NotationError, ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_names

# What conditions on the motion are about, of any crank drive.
OF_MOTION = (
    *("x", "s", "fd", "c", "p", "psi", "ψ", "path", "velocity", "acceleration", "rocker", "θ"),
    *("rod_velocity", "rod_acceleration", "turn_velocity", "turn_acceleration"),
)
_UNLOADED = "is for conditions on the forces of an engine; add its load, such as --eps 4"
_UNASKED = "is for conditions on the forces of an engine, such as torque=max; leave it out"


def _of_drives(values: Mapping[str, Any]) -> Mapping[str, str]:
    # No layout tells the mechanism. Forces have newtons on every drive.
    shared = ("stroke", "speed") if _is_of_engine(values) else ()
    return of_other_mechanisms(values, meant(values, layout=None), shared)


def _texts(where: Any) -> list[Any]:
    """Return the conditions as they are written."""
    return [where] if isinstance(where, str) or not isinstance(where, Iterable) else list(where)


def _is_loaded(values: Mapping[str, Any]) -> bool:
    """Whether there is the load of an engine."""
    return any(is_given(values.get(name)) for name in (*OWN, "cylinder"))


def _is_of_engine(values: Mapping[str, Any]) -> bool:
    """Whether conditions are about the forces under that, or nothing says what they are about."""
    where = values["where"]
    # What runs only once is left to run.
    texts = [] if isinstance(where, Iterator) else _texts(where)
    named = {str(text).partition("=")[0].strip() for text in texts}
    return _is_loaded(values) and (not texts or not named <= {*OF_MOTION})


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    if values["unknown"] is not None:
        from kurbel.commands.unknown.ratio import needless_of_motion, needless_of_ratio

        if values["unknown"] == "ratio":
            return needless_of_ratio(values, _texts(values["where"]))
        # What a force needs, its own page says.
        return {} if _is_loaded(values) or _is_of_forces(values) else needless_of_motion()
    pressed = (
        "is for --unknown, such as --unknown bore --angle 30, and for kurbel forces; conditions on angles are"
        " under the load of an engine, such as --eps 4"
    )
    return {
        "angle": "--angle is for --unknown; conditions find the angles themselves",
        **{name: f"--{name.replace('_', '-')} {pressed}" for name in PRESSING},
        **_of_angles(values),
    }


def _of_angles(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says nothing where angles are asked for."""
    if _is_of_engine(values):
        bare = {
            "force": "--force does not go with the load of an engine; leave it out",
            "order": "--order is of a series of the motion, and the condition is on forces; leave it out",
        }
        return {**bare, **for_masses("speed")(values), **needless_of_load(values), **unsized(values)}
    why = _UNASKED if _is_loaded(values) else _UNLOADED
    names = (*STEAM, *RODS, *RUBBING, "bore", "pressure", "cranks", "cylinder", "of")
    refused = {name: f"--{name.replace('_', '-')} {why}" for name in names}
    if _is_loaded(values) or not _is_of_forces(values):
        unasked = (
            why if _is_loaded(values) else "is for conditions on forces, such as torque=max; leave it out"
        )
        return {**refused, **{name: f"--{name.replace('_', '-')} {unasked}" for name in (*MASSES, *LYING)}}
    return {**refused, **weightless(values)}


def _is_of_forces(values: Mapping[str, Any]) -> bool:
    """Whether a condition is about the forces of the drive."""
    where = values["where"]
    texts = [] if isinstance(where, Iterator) else _texts(where)
    return any(str(text).partition("=")[0].strip() not in OF_MOTION for text in texts)


class Drives(
    option.AnyDrive,
    engines.Steam,
    engines.MovingRod,
    Lying,
    Pressing,
    Rods,
    Rubbing,
    option.Sheet,
    total=False,
):
    """Crank drives of which conditions are asked, under a force or the load of an engine."""

    ratio: option.Ratios
    method: option.Method
    order: option.Order
    speed: option.Speed
    force: option.Force
    eps: option.Eps
    of: Of
    reciprocating: option.Reciprocating
    rotating: option.Rotating
    rocker_inertia: option.RockerInertia
    layouts: option.Layouts


@makes_table(
    foreign=_of_drives,
    needless=_needless,
    order="ratio columns offset stroke crank true_stroke"
    " time_ratio rod method order speed mechanism rocker pivot circuit beam force"
    " eps back exponent clearance card other_side single_acting cranks bore pressure"
    " reciprocating rod_mass centre gyration rod_file rotating rocker_inertia vertical slope"
    " gravity",
)
def solve_table(
    where: Annotated[
        str | Iterable[str],
        Option(
            'Condition: p=0, s=25% (share of the stroke), x=1.1, "x = 200 mm", "c = 3 m/s", c=max, p=min,'
            ' "p = 1/6 of dead centre", psi=5; of an engine torque=max, tangential=0.5, "rod_force = 10 kN";'
            " repeated for several.",
            "CONDITION",
            many=True,
        ),
    ] = (),
    *,
    columns: Annotated[
        option.Names,
        option.columns_option(
            "solve", "stroke,phi,phi_turn,x,c,p", ". Pages keep the stroke and φ at the left."
        ),
    ] = (),
    unknown: Annotated[
        str | None,
        Option(
            "What is asked for in place of the angle: speed, force, pressure, bore, reciprocating, rod_mass,"
            " stroke or ratio; with --angle and one condition.",
            kind=Choice("unknown", "kurbel.solve.unknown:UNKNOWNS"),
        ),
    ] = None,
    angle: Annotated[
        Exact | None,
        Option(
            "With --unknown the crank angle at which the condition holds: 30, or c=max, where a quantity of"
            " the motion is greatest on the outstroke.",
            "ANGLE",
            unit="degrees",
        ),
    ] = None,
    layout: Annotated[str | None, option.layout_option("roots", "loaded roots", "unknown")] = None,
    **given: Unpack[Drives],
) -> Question:
    """Print all crank angles of the turn at which a condition holds, on both strokes.

    Path, velocity and acceleration count on either stroke from the dead centre where it begins, in its
    direction; max and min are those of each stroke, and psi=max is where the rod leans furthest to either
    side. Forces of an engine, by --eps and the like, count over the whole turn. --unknown asks for another
    number than the angle, with which a condition holds at one.

    \b
    kurbel solve --ratio 1:5 --method series --where p=0
    kurbel solve --ratio '1:4;1:5' --where s=25% --where c=max
    kurbel solve --stroke 600mm --rod 1500mm --speed 120/min --where "c = 3 m/s"
    kurbel solve --ratio 1:5 --mechanism arc --rocker 6 --where acceleration=0
    kurbel solve --eps 4 --where torque=max --where tangential=0.5
    kurbel solve --machine engine.toml --unknown speed --angle 30 --where crosshead_load=0
    kurbel solve --unknown ratio --angle 80 --where c=max
    \f
    >>> import kurbel
    >>> page = kurbel.solve_table("p = 0", ratio="1:5", method="series", columns="stroke,phi,x")
    >>> print(kurbel.typeset(page, "csv"), end="")
    stroke,phi,x
    outstroke,79.2724,0.9104
    return,100.7276,1.0896
    """
    from kurbel.solve.page import SolveRequest
    from kurbel.solve.solve import read_on

    texts = _texts(where)
    if not all(isinstance(text, str) for text in texts):
        raise NotationError('a condition is text, such as "p = 0"')
    if unknown is not None:
        from kurbel.commands.unknown.command import unknown_of

        return unknown_of(unknown, angle, texts, columns, layout, given)
    if _is_of_engine({**given, "where": texts}):
        return _of_engine(layout, texts, columns, given)
    page = layout_of(layout or "solve", ("roots",), given["layouts"])
    # A speed alone makes no force.
    chosen, said = described(given)
    drives = some(chosen.drives(said, page.ratios))
    if _is_of_forces({"where": texts}):
        drives = _moving(chosen, drives, given)
    drives = chosen.solved(drives, method_of(given))
    return SolveRequest(
        layout=page,
        drives=drives,
        conditions=tuple(dict.fromkeys(read_on(drives[0], text) for text in texts)),
        columns=as_names(columns, "stroke,phi,x"),
        **sheet_of(given),
    )


def _moving(chosen: Any, drives: Any, given: Mapping[str, Any]) -> Any:
    """Return the drives with their masses, where conditions on their forces are solved."""
    if not is_heavy(given):
        return drives
    if not chosen.crosshead:
        raise ProblemError(
            f"conditions on the forces of moving masses are not solved for {chosen.title}; print them over"
            " the turn, kurbel forces"
        )
    if given["method"] not in (None, "exact"):
        raise ProblemError(
            f'method "{given["method"]}" has no conditions on the forces of moving masses; use exact'
        )
    return weighed(chosen, drives, given)


def _of_engine(
    layout: str | None, texts: Iterable[str], columns: option.Names, given: Mapping[str, Any]
) -> Question:
    """Return what is asked of the forces of an engine."""
    from kurbel.reading.where import read_condition
    from kurbel.solve.load_page import LoadedRequest
    from kurbel.solve.loaded import MEASURED, NAMES

    page = layout_of(layout or "solve-load", ("loaded roots",), given["layouts"])
    read = (
        read_condition(text, NAMES, MEASURED, "torque and the forces of the crank drive") for text in texts
    )
    return engine_of(
        page,
        given,
        LoadedRequest,
        conditions=tuple(dict.fromkeys(read)),
        columns=as_names(columns, "phi,torque"),
    )
