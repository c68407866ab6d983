"""The kinds of drawings of `kurbel plot`: the options that each takes, and what they ask for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import click
from click.core import ParameterSource

from kurbel.cli.engine import engine_conditions, engines_of
from kurbel.cli.linkage import arc_cranks
from kurbel.cli.masses import MASSES, is_heavy, load_of
from kurbel.cli.mechanism import MECHANISMS, chosen_mechanism
from kurbel.cli.options import typed
from kurbel.cli.table import cranks_of, ends_of_run
from kurbel.errors import ProblemError
from kurbel.reading import notation

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.engine.request import EngineRequest
    from kurbel.linkage.page import LinkageRequest
    from kurbel.motion.question import Request
    from kurbel.page.layouts import Layout
    from kurbel.plot.drawings import Drawing

# The page whose quantities can be drawn, and those of an engine's forces without masses and with them.
LAYOUT = "kinematics"
ENGINE_LAYOUT, MACHINE_LAYOUT = "engine-forces", "machine-forces"
# So many steps of the range make a curve smooth, half degrees over the turn; over many turns a wider step
# than this shows.
STEPS, WIDEST = 720, Fraction(5)


class Kind(NamedTuple):
    """A kind of drawing: what a message calls it, the options that it takes, and what draws it."""

    name: str
    takes: frozenset[str]
    draw: Callable[[Mapping[str, Any], str], Drawing]


def kind_of(options: Mapping[str, Any]) -> Kind:
    """Return what is to be drawn; raise ProblemError for options that say nothing about it."""
    flags = [name for name in KINDS if options[name]]
    if len(flags) > 1:
        raise ProblemError(f"--{flags[0]} and --{flags[1]} are two drawings; leave one out")
    flag = flags[0] if flags else ""
    kind = OF_STEAM[flag] if flag in OF_STEAM and _driven_by_steam(options) else KINDS.get(flag, MOTION)
    for name in options:
        if name not in SHARED | kind.takes and typed(name):
            raise ProblemError(_refusal(name, kind, flag))
    return kind


def of_kind(options: Mapping[str, Any], kind: Kind) -> dict[str, Any]:
    """Return the options without what the environment or the machine says of other kinds."""
    return {
        name: value if name in SHARED | kind.takes else () if isinstance(value, tuple) else None
        for name, value in options.items()
    }


def _driven_by_steam(options: Mapping[str, Any]) -> bool:
    """Whether steam drives the piston, and no constant force that outdoes the steam of the machine."""
    return engine_conditions(options) and (not typed("force") or any(map(typed, STEAM)))


def _refusal(name: str, kind: Kind, flag: str) -> str:
    option = f"--{name.replace('_', '-')}"
    if flag in OF_STEAM and kind is not OF_STEAM[flag] and name in OF_ENGINES & OF_STEAM[flag].takes:
        return f"{option} is for the steam of an engine; add --eps or --card"
    if name in OF_ENGINES and flag in ("", "positions"):
        return f"{option} describes a steam engine; --forces, --polar and --turning draw one"
    return f"{option} says nothing about {kind.name}; leave it out"


def _motion(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.curves import motion_keys
    from kurbel.plot.drawings import linkage_drawing, motion_drawing

    name, options = _mechanism(options)
    if name in LINKAGES:
        return linkage_drawing(_linkage_request(name, options), mark)
    return motion_drawing(_request(options, _cranks(options), motion_keys), mark)


def _forces(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.curves import force_keys
    from kurbel.plot.drawings import motion_drawing

    options = _sliding(options)
    return motion_drawing(_request(options, _cranks(options), force_keys), mark)


def _polar(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.curves import pin_force_keys
    from kurbel.plot.drawings import polar_drawing

    options = _sliding(options)
    crank = _only(_cranks(options), "polar", "ratios")
    return polar_drawing(_request(options, (crank,), pin_force_keys), mark)


def _positions(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.page.layouts import layout
    from kurbel.plot.drawings import arc_drawing, mechanism_drawing, parallel_drawing

    name, options = _mechanism(options)
    angles, lang = notation.angles(options["positions"]), options["lang"]
    if name == "parallel":
        return parallel_drawing(angles, lang, mark)
    if name == "arc":
        arcs = arc_cranks(layout(options["layout"]), options)
        return arc_drawing(_only(arcs, "positions", "ratios"), angles, lang, mark)
    return mechanism_drawing(_only(_cranks(options), "positions", "ratios"), angles, lang, mark)


def _mechanism(options: Mapping[str, Any]) -> tuple[str, dict[str, Any]]:
    """Return which crank drive is to be drawn, and the options without those of others."""
    name, kept = chosen_mechanism({**options, "layout": None})
    if name in LINKAGES and typed("force"):
        raise ProblemError(f"--force says nothing about the {name} crank; leave it out")
    return name, kept


def _sliding(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options of a crank drive with a crosshead, the only one whose forces are known."""
    if options["mechanism"] not in LINKAGES:
        return _mechanism(options)[1]
    if typed("mechanism"):
        raise ProblemError(
            f"the forces of the {options['mechanism']} crank are not computed; leave --mechanism out"
        )
    return _mechanism({**options, "mechanism": None})[1]


def _linkage_request(name: str, options: Mapping[str, Any]) -> LinkageRequest:
    from kurbel.linkage.page import LinkageRequest
    from kurbel.page.layouts import layout
    from kurbel.plot.linkage import ARC_MOTION

    page = layout(options["layout"])
    columns = notation.names(options["columns"], "columns", "path,velocity")
    return LinkageRequest(
        layout=page,
        angles=_angles(options),
        cranks=arc_cranks(page, options) if name == "arc" else (),
        lang=options["lang"],
        columns=columns or (ARC_MOTION if name == "arc" else ()),
    )


def _engine_forces(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.drawings import engine_forces_drawing
    from kurbel.plot.engine import FORCES

    return engine_forces_drawing(_force_request(options, FORCES), mark)


def _engine_polar(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.drawings import engine_polar_drawing
    from kurbel.plot.engine import PIN_FORCE

    request = _force_request(options, PIN_FORCE)
    _only(request.steams, "polar", "cards" if request.carded else "expansion ratios")
    _only(request.drives, "polar", "ratios")
    return engine_polar_drawing(request, mark)


def _turning(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot.drawings import turning_drawing
    from kurbel.plot.turning import COLUMNS

    return turning_drawing(_engine_request(options, "turning", COLUMNS), mark)


def _request(
    options: Mapping[str, Any], cranks: tuple[Crank, ...], keys: Callable[[Crank], tuple[str, ...]]
) -> Request:
    """Return the request for the columns named, or for those that a crank has by itself."""
    from kurbel.motion.question import Request

    return Request(
        layout=_page(),
        cranks=cranks,
        angles=_angles(options),
        method=options["method"],
        lang=options["lang"],
        columns=notation.names(options["columns"], "columns", "x,c,p") or keys(cranks[0]),
    )


def _force_request(options: Mapping[str, Any], keys: tuple[str, ...]) -> EngineRequest:
    """Return the request for the forces named, or for these, in newtons where the load is known."""
    from kurbel.plot.engine import known_forces

    named = notation.names(options["columns"], "columns", "piston_force,tangential_force")
    columns = named or known_forces(keys, newtons=load_of(options) is not None)
    return _engine_request(options, MACHINE_LAYOUT if is_heavy(options) else ENGINE_LAYOUT, columns)


def _engine_request(options: Mapping[str, Any], name: str, columns: tuple[str, ...]) -> EngineRequest:
    from kurbel.engine.request import EngineRequest
    from kurbel.page.layouts import layout

    if options["method"] == "infinite":
        raise ProblemError("--method infinite is for the motion alone; of engines write --ratio 1:∞")
    if notation.number(_offset_of_machine() or "0", "offset"):
        raise ProblemError(
            "the machine has an offset crank, and engines are drawn with a straight one; leave its offset out"
        )
    page = layout(name)
    return EngineRequest(
        layout=page,
        **engines_of(page, options),
        methods=(options["method"],) if options["method"] else (),
        angles=_angles(options),
        lang=options["lang"],
        columns=columns,
        load=load_of(options),
    )


def _offset_of_machine() -> str | None:
    """Return the offset that --machine gives: no engine may be drawn without it."""
    context = click.get_current_context()
    from_file = context.get_parameter_source("offset") is ParameterSource.DEFAULT_MAP
    return context.params["offset"] if from_file else None


def _page() -> Layout:
    from kurbel.page.layouts import layout_of

    return layout_of(LAYOUT, ("motion",))


def _cranks(options: Mapping[str, Any]) -> tuple[Crank, ...]:
    if options["force"] is None:
        return cranks_of(_page(), options)
    from kurbel.reading.units import force

    return cranks_of(_page(), options, force(options["force"]))


def _only(given: Sequence[Any], flag: str, what: str) -> Any:
    if len(given) > 1:
        raise ProblemError(f"--{flag} draws one crank drive, and {len(given)} {what} were given; choose one")
    return given[0]


def _angles(options: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the angles of --from, --to and --step, by themselves close enough for smooth curves."""
    first, last = ends_of_run(options["from"], options["to"])
    if options["step"] is None:
        return notation.progression(first, last, min((last - first) / STEPS or WIDEST, WIDEST))
    return notation.progression(first, last, notation.angle(options["step"], "step"))


# The crank drives without a crosshead.
LINKAGES = tuple(name for name, one in MECHANISMS.items() if one.subject != "motion")
_RUN = frozenset(("from", "to", "step", "method"))
_LENGTHS = frozenset(("mechanism", "rocker", "pivot", "offset", "stroke", "rod"))
# The options of a steam engine: what shows that there is one, and what goes with it.
STEAM = ("eps", "back", "exponent", "clearance", "card", "other_side", "single_acting")
OF_ENGINES = frozenset((*STEAM, "cranks", "bore", "pressure", *MASSES))
_ENGINE = (_RUN | OF_ENGINES | {"stroke", "rod", "speed"}) - {"cranks"}
MOTION = Kind("the motion", _RUN | _LENGTHS | {"columns", "speed", "force"}, _motion)
KINDS = {
    "positions": Kind("the mechanism", _LENGTHS, _positions),
    "forces": Kind("the forces", _RUN | _LENGTHS | {"columns", "force"}, _forces),
    "polar": Kind("the polar diagram", _RUN | _LENGTHS | {"force"}, _polar),
    "turning": Kind("the turning effort", _ENGINE | {"cranks"}, _turning),
}
# The same where steam drives the piston; the forces are those of the first crank.
OF_STEAM = {
    "forces": Kind("the forces of an engine", _ENGINE | {"columns"}, _engine_forces),
    "polar": Kind("the polar diagram of an engine", _ENGINE, _engine_polar),
}
# The options of all kinds.
SHARED = frozenset((*KINDS, "ratio", "format", "output", "lang", "decimal"))
