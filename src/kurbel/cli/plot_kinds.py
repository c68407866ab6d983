"""The kinds of drawings of `kurbel plot`: the options that each takes, and what they ask for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel import notation
from kurbel.cli.engine import engines_of
from kurbel.cli.options import typed
from kurbel.cli.table import cranks_of, ends_of_run
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.layouts import Layout
    from kurbel.plot_drawings import Drawing
    from kurbel.problem import Crank
    from kurbel.request import Request

# The page whose quantities can be drawn.
LAYOUT = "kinematics"
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
    flags = [name for name in KINDS if options.get(name)]
    if len(flags) > 1:
        raise ProblemError(f"--{flags[0]} and --{flags[1]} are two drawings; leave one out")
    kind = KINDS[flags[0]] if flags else MOTION
    for name in options:
        if name not in SHARED | kind.takes and typed(name):
            option = f"--{name.replace('_', '-')}"
            if name in OF_ENGINES:
                raise ProblemError(f"{option} describes a steam engine; --turning draws its turning effort")
            raise ProblemError(f"{option} says nothing about {kind.name}; leave it out")
    return kind


def of_kind(options: Mapping[str, Any], kind: Kind) -> dict[str, Any]:
    """Return the options without what the environment says of other kinds."""
    return {
        name: value if name in SHARED | kind.takes else () if isinstance(value, tuple) else None
        for name, value in options.items()
    }


def _motion(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot_curves import motion_keys
    from kurbel.plot_drawings import motion_drawing

    return motion_drawing(_request(options, _cranks(options), motion_keys), mark)


def _polar(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot_curves import pin_force_keys
    from kurbel.plot_drawings import polar_drawing

    crank = _only(_cranks(options), "polar")
    return polar_drawing(_request(options, (crank,), pin_force_keys), mark)


def _positions(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.plot_drawings import mechanism_drawing

    crank = _only(_cranks(options), "positions")
    return mechanism_drawing(crank, notation.angles(options["positions"]), options["lang"], mark)


def _turning(options: Mapping[str, Any], mark: str) -> Drawing:
    from kurbel.engine_request import EngineRequest
    from kurbel.layouts import layout_of
    from kurbel.plot_drawings import turning_drawing
    from kurbel.plot_turning import COLUMNS

    method = options["method"]
    if method == "infinite":
        raise ProblemError("--method infinite is for the motion alone; of engines write --ratio 1:∞")
    page = layout_of("turning", ("turning",))
    request = EngineRequest(
        layout=page,
        **engines_of(page, options),
        methods=(method,) if method else (),
        angles=_angles(options),
        lang=options["lang"],
        columns=COLUMNS,
    )
    return turning_drawing(request, mark)


def _request(
    options: Mapping[str, Any], cranks: tuple[Crank, ...], keys: Callable[[Crank], tuple[str, ...]]
) -> Request:
    """Return the request for the columns named, or for those that a crank has by itself."""
    from kurbel.request import Request

    return Request(
        layout=_page(),
        cranks=cranks,
        angles=_angles(options),
        method=options["method"],
        lang=options["lang"],
        columns=notation.names(options["columns"], "columns", "x,c,p") or keys(cranks[0]),
    )


def _page() -> Layout:
    from kurbel.layouts import layout_of

    return layout_of(LAYOUT, ("motion",))


def _cranks(options: Mapping[str, Any]) -> tuple[Crank, ...]:
    if options["force"] is None:
        return cranks_of(_page(), options)
    from kurbel.units import force

    return cranks_of(_page(), options, force(options["force"]))


def _only(cranks: Sequence[Crank], flag: str) -> Crank:
    if len(cranks) > 1:
        raise ProblemError(f"--{flag} draws one crank drive, and {len(cranks)} ratios were given; choose one")
    return cranks[0]


def _angles(options: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the angles of --from, --to and --step, by themselves close enough for smooth curves."""
    first, last = ends_of_run(options["from"], options["to"])
    if options["step"] is None:
        return notation.progression(first, last, min((last - first) / STEPS or WIDEST, WIDEST))
    return notation.progression(first, last, notation.angle(options["step"], "step"))


# The options of all kinds.
SHARED = frozenset(("positions", "polar", "turning", "ratio", "format", "output", "lang", "decimal"))
_RUN = frozenset(("from", "to", "step", "method"))
_LENGTHS = frozenset(("offset", "stroke", "rod"))
OF_ENGINES = frozenset(
    ("eps", "back", "exponent", "clearance", "card", "other_side", "single_acting", "cranks")
)
MOTION = Kind("the motion", _RUN | _LENGTHS | {"columns", "speed", "force"}, _motion)
KINDS = {
    "positions": Kind("the mechanism", _LENGTHS, _positions),
    "polar": Kind("the polar diagram", _RUN | _LENGTHS | {"force"}, _polar),
    "turning": Kind("the turning effort", _RUN | OF_ENGINES, _turning),
}
