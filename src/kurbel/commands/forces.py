"""What a piston force, the steam of an engine or the moving rod calls up in rod, guide and crank pin."""

from collections.abc import Mapping
from typing import Annotated, Any, Unpack

from kurbel.commands import loads
from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import (
    PINNED,
    PRESSING,
    RODS,
    RUBBING,
    Pinned,
    Pressing,
    Rods,
    Rubbing,
    needless_beside_load,
    needless_of_pins,
    needless_of_pressures,
    rubbed,
)
from kurbel.commands.cylinder.given import Of
from kurbel.commands.cylinder.slope import LYING, Lying
from kurbel.commands.drives.given import FORCES_OVER_PATH, OVER_PATH
from kurbel.commands.loads import NAMES, OWN, PARTS
from kurbel.commands.machines import (
    MASSES,
    STEAM,
    check_whole,
    engine_of,
    for_masses,
    is_heavy,
    needless_of_load,
    over_cycle,
    unsized,
    weighed,
    weightless,
)
from kurbel.commands.old_motion import (
    angles_of,
    is_over_path,
    meant,
    needless_over,
    of_other_mechanisms,
    over_strokes,
    sheet_of,
)
from kurbel.commands.options import Choice, LayoutName, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.drive import load
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import LINKAGES, SUBJECTS
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism, mechanism, uncomputed
from kurbel.page.layouts import layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_names

ROD_LOAD = "rod load"
OF_DRIVES = ("motion", "effort", "mass forces")
OF_ENGINES = ("crank forces", "machine", ROD_LOAD)
POSITIONS = ("tangent",)
COUPLED = "coupled axles"
EFFORT = "forces-effort"
PARTED = (*PRESSING, *RUBBING, *PINNED)
AXLES = ("axles", "driven")
# How masses move.
MOVING = ("speed", "acceleration", "method")
_LOADS = {
    **dict.fromkeys((*STEAM, "bore", "pressure", "cranks"), load.STEAM),
    "card": load.CARD,
    **{key: OWN[key][0] for key in NAMES},
    **dict.fromkeys(MASSES, load.MASSES),
}


def _mechanism(values: Mapping[str, Any]) -> Mechanism:
    """Return which crank drive is meant; layouts tell it that are about the arc or the parallel crank."""
    name = values["layout"]
    if _is_coupled(values) and not values["mechanism"]:
        return mechanism("parallel")
    subject = layout(name, values["layouts"]).subject if name else ""
    return meant(values, layout=name if subject in SUBJECTS else None)


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives, and the loads and positions that theirs do not have."""
    chosen = _mechanism(values)
    refused = of_other_mechanisms(values, chosen, ("stroke", "speed") if is_heavy(values) else ("stroke",))
    if is_over_path(values):
        from kurbel.commands.over.path import not_shares

        refused |= not_shares(values)
    if chosen.name != "parallel":
        refused |= _refused(AXLES, f"does not belong to {chosen.title}; it is for --mechanism parallel")
    if not chosen.crosshead:
        loads = {name: one for name, one in _LOADS.items() if is_given(values.get(name))}
        refused |= {name: said for name, one in loads.items() if (said := uncomputed(chosen, one))}
        refused["at"] = f"--at does not belong to {chosen.title}; it is for --mechanism straight"
    return refused


def _is_coupled(values: Mapping[str, Any]) -> bool:
    return bool(values["layout"]) and layout(values["layout"], values["layouts"]).subject == COUPLED


def _about(values: Mapping[str, Any]) -> str:
    """Return which of the three cases is meant: tangent, engine or piston."""
    subject = layout(values["layout"], values["layouts"]).subject if values["layout"] else ""
    if values["at"] is not None or subject == "tangent":
        return "tangent"
    return "engine" if loads.named(values) and subject not in OF_DRIVES else "piston"


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    if is_over_path(values):
        from kurbel.commands.over.loaded import check_piston

        check_piston(_about(values), values)
    lone = {} if is_given(values["axles"]) else _refused(("driven",), "is for coupled axles; add --axles 3")
    if not loads.named(values):
        lone |= _refused(("of",), "names one of several cylinders; add each as --cylinder, or leave it out")
    return {**lone, **needless_over(values), **_of_case(values)}


def _of_case(values: Mapping[str, Any]) -> Mapping[str, str]:
    match _about(values):
        case "tangent":
            angles = "does not go with --at tangent, a position with an angle of its own; leave it out"
            force = "does not go with --at tangent, a position under one piston force, --force; leave it out"
            return _refused(("angle", "from", "to", "step"), angles) | _refused(
                (*STEAM, *MASSES, *LYING, *PARTED, *RODS, "bore", "pressure", *MOVING, "cranks"), force
            )
        case "engine":
            which = "steam" if is_given(values["eps"]) or is_given(values["card"]) else "load"
            keys = "--eps or --card" if which == "steam" else f"--{loads.named(values)[0].replace('_', '-')}"
            own = _refused(("force",), f"does not go with the {which} of an engine, {keys}; leave it out")
            even = "does not go with the load of an engine, whose crank turns evenly; leave it out"
            return {
                **own,
                **_refused(("acceleration",), even),
                **for_masses("speed")(values),
                **needless_of_load(values),
                **needless_beside_load(values),
                **unsized(values, which),
            }
    unasked = _refused(
        tuple(loads.named(values)), f"says nothing on layout {values['layout']}; leave one out"
    )
    pressed = any(is_given(values[name]) for name in PRESSING)
    of_steam = ("pressure", "cranks", *STEAM) if pressed else ("bore", "pressure", "cranks", *STEAM)
    steam = _refused(of_steam, "is for the steam of an engine; add --eps or --card")
    lone = {**for_masses(*MOVING)(values), **weightless(values), **needless_of_pressures(values)}
    lone |= needless_of_pins(values)
    if not (pressed or is_heavy(values) or is_given(values["force"])):
        lone |= _refused(
            (*RUBBING, "pin_friction"), "lessens a force; add --force, --head-pressure or masses"
        )
    further = {**steam, **{name: loads.astray(name) for name in PARTS}, **lone}
    # First, lest an option of the load asks for one.
    return {**unasked, **further, **unasked}


def _has_parts(values: Mapping[str, Any]) -> bool:
    """Whether more than a force and masses makes the effort on the piston."""
    stands = is_heavy(values) and any(is_given(values[name]) for name in LYING)
    return stands or any(is_given(values[name]) for name in PARTED)


def _refused(names: tuple[str, ...], why: str) -> dict[str, str]:
    return {name: f"--{name.replace('_', '-')} {why}" for name in names}


class Forces(
    option.Run, option.Over, option.AnyDrive, engines.Steam, engines.MovingRod, Lying, Pressing, Rods,
    Rubbing, Pinned, option.Sheet, total=False,
):  # fmt: skip
    """A crank drive and all that can act on it."""

    force: option.Force
    axles: Annotated[
        option.Given | None,
        Option(
            "Parallel crank: so many coupled axles alike, 3, or the weights on them, by which they share the"
            " effort: '14;15;14'.",
            "WEIGHTS",
        ),
    ]
    driven: Annotated[
        Exact | None, Option("With --axles: which of them the force F drives; default 1, the first.", "N")
    ]
    eps: option.Eps
    of: Of
    reciprocating: option.Reciprocating
    rotating: option.Rotating
    rocker_inertia: option.RockerInertia
    layouts: option.Layouts


@makes_table(
    foreign=_foreign,
    needless=_needless,
    order="angle from_ to step zero over shares columns offset stroke crank true_stroke"
    " time_ratio rod mechanism rocker pivot circuit beam axles"
    " driven force at eps back exponent clearance card other_side single_acting cranks bore pressure"
    " reciprocating rod_mass centre gyration rod_file rotating rocker_inertia vertical slope gravity"
    " head_pressure crank_pressure pressure_difference piston_rod tail_rod friction pin_friction"
    " crosshead_pin crank_pin shaft speed acceleration"
    " method",
)
def forces_table(
    ratio: option.Ratios = None,
    *,
    columns: Annotated[
        option.Names, option.columns_over_angle("forces", "phi,rod_force,guide_force,torque")
    ] = (),
    at: Annotated[
        str | None,
        Option(
            "tangent: a sheet of the position in which the rod touches the crank circle, with closed forms.",
            kind=Choice("position", POSITIONS),
        ),
    ] = None,
    speed: Annotated[
        Exact | None, option.SPEED._replace(help="Speed, for the masses: 120/min, 12.5rad/s.")
    ] = None,
    acceleration: option.Acceleration = None,
    method: Annotated[str | None, option.FIRST_ORDER] = None,
    layout: Annotated[
        str | None,
        Option(
            "Page layout; default: forces, with weight, friction or pressures forces-effort;"
            " with --eps or --card engine-forces, with masses machine-forces,"
            " and rod-load for extremes and reversal of the rod's load;"
            f" of the {' or '.join(LINKAGES)} crank {', '.join(f'forces-{name}' for name in LINKAGES)}.",
            kind=LayoutName(
                (*OF_DRIVES, *OF_ENGINES, "tangent", *SUBJECTS, COUPLED, FORCES_OVER_PATH, OVER_PATH)
            ),
        ),
    ] = None,
    **given: Unpack[Forces],
) -> Question:
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    Per unit piston force, under a force of so many newtons and with moving masses, or over the turn of a
    steam engine.

    \b
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --force 10kN --stroke 600mm
    kurbel forces --ratio 1:5 --at tangent
    kurbel forces --mechanism arc --ratio 1:5 --rocker 6
    kurbel forces --mechanism parallel --axles '14;15;14' --driven 2
    kurbel forces --eps 4 --bore 300mm --pressure 8bar
    kurbel forces --pressure-ratio 4 --bore 300mm --suction-pressure 1bar
    kurbel forces --eps 4 --layout rod-load
    kurbel forces --machine engine.toml
    \f
    >>> import kurbel
    >>> page = kurbel.forces_table("3:4", at="tangent", columns="phi,rod_force,guide_force")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,rod_force,guide_force
    53.1301,1.2500,0.7500
    >>> page = kurbel.forces_table("1:5", mechanism="arc", rocker=6, angle=90, columns="rod_force,torque")
    >>> print(kurbel.typeset(page, "csv"), end="")
    rod_force,torque
    1.0172,0.9967
    """
    layouts, sheet = given["layouts"], sheet_of(given)
    own = {"ratio": ratio, "at": at, "speed": speed, "layout": layout}
    all_given = {**given, **own, "acceleration": acceleration, "method": method}
    about, chosen = _about(all_given), _mechanism(all_given)
    # A speed alone makes no force.
    said = Described.of(given, ratio=ratio, method=method)
    chosen.check(said)
    if about == "tangent" and chosen.crosshead:
        from kurbel.motion.tangent_page import TangentRequest

        page = layout_of(layout or "forces-tangent", ("tangent",), layouts)
        names = as_names(columns, "phi,rod_force")
        return TangentRequest(layout=page, cranks=said.cranks(page.ratios), columns=names, **sheet)
    if chosen.name == "parallel" and (is_given(given["axles"]) or _is_coupled(all_given)):
        from kurbel.linkage.coupled import CoupledRequest, axles_of

        page = layout_of(layout or "forces-coupled", (COUPLED,), layouts)
        return CoupledRequest(
            layout=page,
            drives=tuple(chosen.drives(said, page.ratios)),
            axles=axles_of(given["axles"], given["driven"]),
            angles=angles_of(page, given),
            columns=as_names(columns, chosen.examples["forces"]),
            **sheet,
        )
    if about == "engine":
        name = layout or ("machine-forces" if is_heavy(given) else "engine-forces")
        page = layout_of(name, OF_ENGINES, layouts)
        if method == "infinite":
            raise ProblemError("--method infinite is not one of engines; write --ratio 1:∞")
        about_turn = {**all_given, "method": () if method is None else (method,)}
        if page.subject == ROD_LOAD:
            check_whole(page, given)
            return engine_of(page, about_turn, columns=as_names(columns, "thrust,reversal_angle"))
        names = as_names(columns, "epsilon,delta")
        return engine_of(page, about_turn, angles=angles_of(page, over_cycle(given)), columns=names)
    if is_over_path(all_given):
        from kurbel.commands.over.loaded import loaded_path

        page = layout_of(layout or "forces-path", (FORCES_OVER_PATH, OVER_PATH), layouts)
        return loaded_path(chosen, said, page, {**all_given, "columns": columns})
    name = layout or (EFFORT if chosen.crosshead and _has_parts(all_given) else chosen.forces_layout)
    page = layout_of(name, (*OF_DRIVES, *OF_ENGINES) if chosen.crosshead else (chosen.subject,), layouts)
    if page.subject in OF_ENGINES:
        raise ProblemError(f"layout {name} is of a steam engine; add --eps or --card")
    drives = weighed(chosen, chosen.drives(said, page.ratios), all_given)
    question = chosen.question(
        rubbed(chosen, drives, all_given),
        method,
        layout=page,
        angles=angles_of(page, given),
        columns=as_names(columns, chosen.examples["forces"]),
        **sheet,
    )
    return over_strokes(question, given)
