"""The harmonics of the piston's motion, and what engines leave unbalanced."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.balance.arrangement import usual
from kurbel.balance.harmonics import HARMONICS, MOST_ORDERS
from kurbel.commands import parameters as option
from kurbel.commands.machines import MASSES, is_heavy, weighed
from kurbel.commands.motion import ratios_of, sheet_of
from kurbel.commands.options import Choice, Count, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.motion.mechanism import mechanism
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_crank_angles, as_length, as_names, as_places, as_share

if TYPE_CHECKING:
    from kurbel.balance.newtons import Weighed

Ratios = Annotated[
    option.Given | None,
    option.RATIO._replace(help="Crank ratio: 1:5; lists 1:4;1:5 and ranges 1:3..6:0.5."),
]
Orders = Annotated[
    int,
    Option(
        f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out.",
        "N",
        Count("orders", 1, MOST_ORDERS),
    ),
]
Method = Annotated[
    str,
    option.METHOD._replace(help="exact, series (first order in λ) or infinite (rod of infinite length)."),
]

Engine = Annotated[
    str | None,
    Option(
        "inline-1, inline-2-180, inline-2-360, inline-3 to inline-6, v2-90, v6-90, v8-90, v12-60,"
        " boxer-2, boxer-4; default: inline-4, with masses inline-1.",
        kind=Choice("engine", usual),
    ),
]
CylinderCranks = Annotated[
    option.Given | None,
    Option("Another engine: the crank of every cylinder, 0;180;180;0.", "ANGLES", unit="degrees"),
]
Banks = Annotated[
    option.Given | None,
    Option(
        "Directions of its cylinders, counted as the cranks: -45;45; default 0.", "ANGLES", unit="degrees"
    ),
]


@makes_table()
def harmonics_table(
    ratio: Ratios = None,
    *,
    quantity: Annotated[
        str | None,
        Option("x (path), c (velocity) or p (acceleration, default).", kind=Choice("quantity", HARMONICS)),
    ] = None,
    orders: Orders = 6,
    method: Method = "exact",
    layouts: option.Layouts = None,
    layout: Annotated[str, option.layout_option("harmonics")] = "harmonics",
    **sheet: Unpack[option.Sheet],
) -> Question:
    """Print the harmonics of the piston's motion: coefficients of cos φ, cos 2φ, cos 4φ, ...

    \b
    kurbel harmonics --ratio 1:5
    kurbel harmonics --ratio '1:4;1:5' --quantity x --orders 10 --digits 12
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.harmonics_table("1:5", orders=4), "csv"), end="")
    order,ratio,value
    1,1:5,1.000000
    2,1:5,0.202038
    4,1:5,-0.002062
    """
    from kurbel.balance.harmonics_page import HarmonicsRequest

    page = layout_of(layout, ("harmonics",), layouts)
    return HarmonicsRequest(
        layout=page,
        ratios=ratios_of(page, ratio),
        quantity=quantity or "",
        last_order=orders,
        method=method,
        **sheet,
    )


NEWTONS = ("stroke", "speed")


class Heavy(option.MovingRod, option.Sheet, total=False):
    """The masses of each cylinder, with what makes forces of them."""

    reciprocating: Annotated[
        Exact | None,
        Option(
            "Mass of piston and crosshead of a cylinder: 2kg. Masses need --stroke and --speed.", "MASS",
            unit="kg",
        ),
    ]  # fmt: skip
    stroke: option.Stroke
    speed: Annotated[Exact | None, option.SPEED._replace(help="Speed, for the masses: 120/min, 12.5rad/s.")]
    spacing: Annotated[
        Exact | None,
        Option("Unit of the positions, for moments in N m: 100mm.", "LENGTH", unit="m"),
    ]
    layouts: option.Layouts


def _weightless(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not is_heavy(values):
        why = "is for moving masses; add --reciprocating or a rod, --rod-mass"
        return {name: f"--{name} {why}" for name in (*NEWTONS, "spacing")}
    if missing := [f"--{name}" for name in NEWTONS if not is_given(values[name])]:
        why = f"needs {' and '.join(missing)} to become a force"
        return {name: f"--{name.replace('_', '-')} {why}" for name in MASSES if name in values}
    return {}


def _weighed(page: Layout, given: Mapping[str, Any]) -> "Weighed | None":
    """Return what makes newtons, None where a machine or the environment does not say enough."""
    from kurbel.balance.newtons import Weighed

    if not is_heavy(given) or not all(is_given(given[name]) for name in NEWTONS):
        return None
    cranks = Described(given["ratio"], given["stroke"]).cranks(page.ratios)
    crank, *_ = weighed(mechanism("straight"), cranks, given)
    spacing = given["spacing"]
    return Weighed(crank, None if spacing is None else as_length(spacing, "spacing"))


@makes_table(
    needless=_weightless,
    order="cranks positions banks share ratio orders method reciprocating rod_mass centre gyration rod_file"
    " stroke speed spacing columns",
)
def balance_table(
    engine: Engine = None,
    *,
    cranks: CylinderCranks = None,
    positions: Annotated[
        option.Given | None,
        Option(
            "Where its cylinders lie along the shaft: 0;1;2;3, which is the default.",
            "NUMBERS",
            unit="a unit of your own",
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
    columns: Annotated[option.Names, option.columns_option("balance", "order,along,forward")] = (),
    layout: Annotated[str, option.layout_option("balance")] = "balance",
    **given: Unpack[Heavy],
) -> Question:
    """Print the free forces and moments of an engine by orders.

    In units of m R ω²; with masses, --stroke and --speed in newtons, moments with --spacing in N m.

    \b
    kurbel balance --engine inline-4 --ratio 1:4
    kurbel balance --engine v2-90 --share 0.5 --orders 6
    kurbel balance --cranks '0;0;90;90' --positions '0;0;1;1' --banks '-45;45;-45;45'
    kurbel balance --reciprocating 2kg --stroke 90mm --speed 3000/min --spacing 100mm
    kurbel balance --engine inline-1 --machine engine.toml
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
    from kurbel.balance.page import BalanceRequest, arranged

    page = layout_of(layout, ("balance",), given["layouts"])
    weights = _weighed(page, {**given, "ratio": ratio})
    # Masses are those of one cylinder, and a machine that says no more has one.
    alone = weights is not None and engine is None and cranks is None
    name, arrangement = arranged(
        "inline-1" if alone else engine,
        () if cranks is None else as_crank_angles(cranks),
        () if positions is None else as_places(positions, "position"),
        () if banks is None else as_crank_angles(banks),
        as_share(share),
    )
    return BalanceRequest(
        layout=page,
        arrangement=arrangement,
        ratios=ratios_of(page, ratio),
        engine=name,
        last_order=orders,
        method=method,
        columns=as_names(columns, "order,along"),
        weighed=weights,
        **sheet_of(given),
    )


@makes_table(machine=False)
def firing_table(
    engine: Engine = None,
    *,
    cranks: CylinderCranks = None,
    banks: Banks = None,
    order: Annotated[
        str | None,
        Option("Firing order whose cranks are sought, or of these cranks: 1-3-4-2.", "ORDER"),
    ] = None,
    intervals: Annotated[
        option.Given | None,
        Option(
            "With --order: the angles from each firing to the next, 315;405; default: equal ones.",
            "ANGLES",
            unit="degrees",
        ),
    ] = None,
    strokes: Annotated[
        int, Option("Strokes of a cycle: 4 (default) or 2.", "N", Count("number of strokes", 2, 4))
    ] = 4,
    columns: Annotated[
        option.Names, option.columns_option("firing-orders", "number,firing_order,longest")
    ] = (),
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option("firing orders", "firing")] = None,
    **sheet: Unpack[option.Sheet],
) -> Question:
    """Print the firing orders that an engine's cranks allow; with --order the cranks that it needs.

    \b
    kurbel firing --cranks '0;180;180;0'
    kurbel firing --engine v8-90
    kurbel firing --order 1-5-3-6-2-4
    kurbel firing --order 1-2 --banks '0;45' --intervals '405;315'
    \f
    >>> import kurbel
    >>> page = kurbel.firing_table(cranks="0;180;180;0", columns="firing_order")
    >>> print(kurbel.typeset(page, "csv"), end="")
    firing_order
    1-2-4-3
    1-3-4-2
    """
    from kurbel.balance.firing import read_order
    from kurbel.balance.firing_page import FiringRequest, asked

    page = layout_of(layout or ("firing" if order else "firing-orders"), ("firing orders", "firing"), layouts)
    sought = () if order is None else read_order(order)
    name, arrangement = asked(
        engine,
        () if cranks is None else as_crank_angles(cranks),
        () if banks is None else as_crank_angles(banks),
        sought,
        strokes,
        () if intervals is None else as_crank_angles(intervals),
    )
    return FiringRequest(
        layout=page,
        arrangement=arrangement,
        strokes=strokes,
        order=sought,
        engine=name,
        columns=as_names(columns, "firing_order" if order is None else "crank,fires_at"),
        **sheet,
    )
