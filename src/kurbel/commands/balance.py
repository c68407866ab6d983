"""What engines leave unbalanced."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.balance.harmonics import MOST_ORDERS
from kurbel.commands import parameters as option
from kurbel.commands.balancing.masses import (
    Revolving,
    check_known,
    needless_of_revolving,
    position_of,
    positions_of,
    reciprocating_of,
    unlike,
)
from kurbel.commands.cylinder import engines
from kurbel.commands.firing import Arranged
from kurbel.commands.machines import MASSES, is_heavy, weighed
from kurbel.commands.old_motion import ratios_of, sheet_of
from kurbel.commands.options import Count, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import mechanism
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_angles, as_crank_angles, as_length, as_names, as_share

if TYPE_CHECKING:
    from kurbel.balance.newtons import Weighed

Ratios = Annotated[
    option.Given | None,
    option.RATIO._replace(help="Crank ratio: 1:5; lists '1:4;1:5' and ranges 1:3..6:0.5."),
]
Orders = Annotated[
    int,
    Option(
        f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out.",
        "N",
        Count("orders", 1, MOST_ORDERS, "does not say up to which one"),
    ),
]
Method = Annotated[
    str,
    option.METHOD._replace(help="exact, series (first order in λ) or infinite (rod of infinite length)."),
]

Engine = Annotated[str | None, Arranged.engine]
CylinderCranks = Annotated[option.Given | None, Arranged.cranks.but(read=None)]
Banks = Annotated[option.Given | None, Arranged.banks.but(read=None)]
NEWTONS = ("stroke", "speed")
AT_ANGLES = "balance at angles"
EXTREMES = "balance extremes"
SUBJECTS = ("balance", AT_ANGLES, EXTREMES)


class Heavy(option.OnMachine, engines.MovingRod, Revolving, option.Sheet, total=False):
    """The masses of each cylinder, with what makes forces of them."""

    reciprocating: Annotated[
        option.Given | None,
        Option(
            "Mass of piston and crosshead of a cylinder: 2kg; or of each: '2;2.5kg'. Masses need --stroke and"
            " --speed.", "MASSES", unit="kg",
        ),
    ]  # fmt: skip
    stroke: option.Stroke
    crank: option.Crank
    rod: option.Rod
    speed: Annotated[Exact | None, option.SPEED._replace(help="Speed, for the masses: 120/min, 12.5rad/s.")]
    spacing: Annotated[
        Exact | None,
        Option("Unit of the positions, for moments in N m: 100mm.", "LENGTH", unit="m"),
    ]
    layouts: option.Layouts


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    found = {"about": "--about is a position; give these, --positions"}
    if is_given(values["positions"]):
        found = {}
    return {**found, **_weightless(values), **needless_of_revolving(values)}


def _weightless(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not is_heavy(values):
        why = "is for moving masses; add --reciprocating or a rod, --rod-mass"
        # With the rod the stroke gives the ratio.
        sized = ("speed", "spacing") if is_given(values["rod"]) else (*NEWTONS, "spacing")
        return {**{name: f"--{name} {why}" for name in sized}, **_strokeless(values)}
    if missing := [f"--{name}" for name in NEWTONS if not is_given(values[name])]:
        why = f"needs {' and '.join(missing)} to become a force"
        return {name: f"--{name.replace('_', '-')} {why}" for name in MASSES if name in values}
    return {}


def _strokeless(values: Mapping[str, Any]) -> Mapping[str, str]:
    known = is_given(values["stroke"])
    return {} if known else {"rod": "--rod gives the ratio with the length of the crank; add --stroke"}


def _ratios(page: Layout, given: Mapping[str, Any]) -> tuple[Fraction, ...]:
    """Return the crank ratios, as given or of stroke and rod, or the layout's own."""
    if given["rod"] is None:
        return ratios_of(page, given["ratio"])
    return tuple(one.ratio for one in _described(given).cranks(page.ratios))


def _described(given: Mapping[str, Any]) -> Described:
    return Described(given["ratio"], given["stroke"], given["rod"])


def _weighed(page: Layout, given: Mapping[str, Any], in_metres: bool) -> "Weighed | None":
    """Return what makes newtons, None where a machine or the environment does not say enough."""
    from kurbel.balance.newtons import Weighed

    if not is_heavy(given) or not all(is_given(given[name]) for name in NEWTONS):
        return None
    cranks = _described(given).cranks(page.ratios)
    masses = reciprocating_of(given)
    first = masses[0] if masses else None
    crank, *_ = weighed(mechanism("straight"), cranks, {**given, "reciprocating": first})
    spacing = given["spacing"]
    if in_metres and spacing is not None:
        raise ProblemError("the positions are lengths, and --spacing gives their unit; leave one out")
    unit = Fraction(1) if in_metres else None if spacing is None else as_length(spacing, "spacing")
    return Weighed(crank, unit, **unlike(crank, masses, given))


@makes_table(
    needless=_needless,
    order="cranks positions about banks share angle ratio orders method reciprocating rod_mass centre"
    " gyration rod_file revolving revolving_share balance_radius stroke crank rod speed spacing columns",
)
def balance_table(
    engine: Engine = None,
    *,
    cranks: CylinderCranks = None,
    positions: Annotated[
        option.Given | None,
        Option(
            "Where its cylinders lie along the shaft: '0;1;2;3', which is the default, or '0;400;800mm'.",
            "NUMBERS",
            unit="a unit of your own",
        ),
    ] = None,
    about: Annotated[
        Exact | None,
        Option(
            "Position about which moments are taken: 1, 400mm; default: the middle.",
            "NUMBER",
            unit="that of the positions",
        ),
    ] = None,
    banks: Banks = None,
    share: Annotated[
        Exact,
        Option("Share of each reciprocating mass that counterweights balance: 0.5, 50%.", "SHARE"),
    ] = "0",
    ratio: Ratios = None,
    orders: Orders = 2,
    method: Method = "exact",
    angle: Annotated[
        option.Given | None,
        option.ANGLE._replace(help="Angles of the shaft at which forces are printed: 30, '0;30', 0..180:10."),
    ] = None,
    columns: Annotated[option.Names, option.columns_option("balance", "order,along,forward")] = (),
    layout: Annotated[str | None, option.layout_option(*SUBJECTS)] = None,
    **given: Unpack[Heavy],
) -> Question:
    """Print the free forces and moments of an engine by orders.

    In units of m R ω²; with masses, --stroke and --speed in newtons, moments with --spacing or positions in
    millimetres in N m. With --angle at angles of the shaft, by orders and together; layout
    balance-greatest has the greatest over the turn.

    \b
    kurbel balance --engine inline-4 --ratio 1:4
    kurbel balance --engine v2-90 --share 0.5 --orders 6
    kurbel balance --cranks '0;0;90;90' --positions '0;0;1;1' --banks '-45;45;-45;45'
    kurbel balance --reciprocating 2kg --stroke 90mm --speed 3000/min --spacing 100mm
    kurbel balance --engine inline-1 --machine engine.toml
    kurbel balance --engine v2-90 --angle '0;30' --method series
    kurbel balance --cranks '0;90' --positions '0;40cm' --reciprocating '3;2kg' --stroke 20cm --speed 9/s
    \f
    >>> import kurbel
    >>> page = kurbel.balance_table("inline-4", ratio="1:5", columns="residual,order,along,across")
    >>> print(kurbel.typeset(page, "csv"), end="")
    residual,order,along,across
    force,1,0,0
    force,2,0.8082,0
    moment,1,0,0
    moment,2,0,0
    """
    from kurbel.balance.page import arranged

    page = layout_of(layout or ("balance" if angle is None else "balance-angle"), SUBJECTS, given["layouts"])
    if angle is not None and page.subject != AT_ANGLES:
        raise ProblemError(f"layout {page.key} is of the whole turn; leave --angle out")
    check_known({**given, "cranks": cranks, "positions": positions})
    places, in_metres = positions_of(positions)
    drive = {**given, "ratio": ratio}
    weights = _weighed(page, drive, in_metres)
    centre = None if about is None else position_of(about, in_metres)
    # Masses are those of one cylinder, and a machine that says no more has one.
    alone = weights is not None and engine is None and cranks is None
    name, arrangement = arranged(
        "inline-1" if alone else engine,
        () if cranks is None else as_crank_angles(cranks),
        places,
        () if banks is None else as_crank_angles(banks),
        as_share(share),
        centre,
    )
    asked: dict[str, Any] = {}
    request: type[Any]
    if page.subject == AT_ANGLES:
        from kurbel.balance.angles.page import AngleRequest

        request = AngleRequest
        asked["angles"] = as_angles(page.angles if angle is None else angle)
    elif page.subject == EXTREMES:
        from kurbel.balance.angles.extremes import ExtremesRequest

        request = ExtremesRequest
    else:
        from kurbel.balance.page import BalanceRequest

        request = BalanceRequest
    return request(
        layout=page,
        **asked,
        about=centre,
        metres=in_metres,
        arrangement=arrangement if weights is None else weights.on(arrangement),
        ratios=_ratios(page, drive),
        engine=name,
        last_order=orders,
        method=method,
        columns=as_names(columns, "order,along"),
        weighed=weights,
        **sheet_of(given),
    )
