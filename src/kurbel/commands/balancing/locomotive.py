"""Locomotives: what their wheels and their frames bear of what goes to and fro."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.balancing.measures import as_measures
from kurbel.commands.balancing.rotor import Paper
from kurbel.commands.old_motion import sheet_of
from kurbel.commands.options import Count, Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import (
    Exact,
    as_crank_angles,
    as_force,
    as_length,
    as_names,
    as_shares,
    as_speed,
    as_velocity,
)

if TYPE_CHECKING:
    from kurbel.balance.locomotives.locomotive import Crank

SHARES = "0;1/2;2/3;1"


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    found = {}
    if is_given(values["positions"]):
        found["spacing"] = "--positions has the places of the cylinders; leave --spacing out"
    if is_given(values["speed"]):
        found["velocity"] = "--speed is that of the axle and --velocity that of the train; leave one out"
    return found


@makes_table(
    foreign=_foreign,
    order="cranks spacing positions gauge stroke crank reciprocating revolving share axles balance_radius"
    " speed velocity wheel wheel_load hammer_blow",
)
def locomotive_table(
    *,
    cranks: Annotated[
        option.Given, Option("Angles of the cranks: '0;90', or '0;120;240'.", "ANGLES", unit="degrees")
    ] = "0;90",
    spacing: Annotated[
        Exact | None,
        Option("Distance of the centre lines of neighbouring cylinders: 0.7m.", "LENGTH", unit="m"),
    ] = None,
    positions: Annotated[
        option.Given | None,
        Option("Their places from the middle in place of that: '-0.4;0.4m'.", "LENGTHS", unit="m"),
    ] = None,
    gauge: Annotated[Exact, Option("Distance of the planes of the wheels: 1.5m.", "LENGTH", unit="m")],
    stroke: option.Stroke = None,
    crank: option.Crank = None,
    reciprocating: Annotated[
        option.Given,
        Option("Mass that goes to and fro in a cylinder: 300kg, or each.", "MASSES", unit="kg"),
    ],
    revolving: Annotated[
        option.Given | None,
        Option("Mass that turns with a crank at its radius: 160kg, or each.", "MASSES", unit="kg"),
    ] = None,
    axles: Annotated[
        int,
        Option("Coupled axles that balance equal parts of the share, 1 to 12.", "N", Count("axles", 1, 12)),
    ] = 1,
    share: Annotated[
        option.Given,
        Option("Shares of the reciprocating masses that are balanced: 2/3, '0.5;0.6'.", "SHARES"),
    ] = SHARES,
    balance_radius: Annotated[
        Exact | None, Option("Radius of the balancing masses: 600mm.", "LENGTH", unit="m")
    ] = None,
    speed: Annotated[Exact | None, option.SPEED._replace(help="Speed of the axle: 300/min, 31rad/s.")] = None,
    velocity: Annotated[
        Exact | None,
        Option("Speed of the train in its place, with --wheel: 96km/h.", "SPEED", unit="m/s"),
    ] = None,
    wheel: Annotated[Exact | None, Option("Diameter of the wheels: 1.8m.", "LENGTH", unit="m")] = None,
    wheel_load: Annotated[Exact | None, Option("Load of a wheel at rest: 30kN.", "FORCE", unit="N")] = None,
    hammer_blow: Annotated[
        Exact | None, Option("Hammer blow that is allowed: 40kN; default: the load.", "FORCE", unit="N")
    ] = None,
    columns: Annotated[option.Names, option.columns_option("locomotive", "share,blow_left_n,sway_nm")] = (),
    layout: Annotated[str, option.layout_option("locomotive")] = "locomotive",
    **given: Unpack[Paper],
) -> Question:
    """Print balancing masses in the wheels, hammer blow, swaying couple and variation of tractive force.

    By the share of the reciprocating masses that is balanced; with --wheel-load the speed at which wheels
    lift, and the largest share.

    \b
    kurbel locomotive --spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg --speed 300/min
    kurbel locomotive --spacing 2m --gauge 1.5m --crank 30cm --reciprocating 240kg --share 2/3
    \f
    >>> import kurbel
    >>> page = kurbel.locomotive_table(
    ...     spacing=0.6, gauge=1.5, stroke=0.6, reciprocating=300, speed=5, share="2/3",
    ...     columns="pull_n,sway_nm",
    ... )
    >>> print(kurbel.typeset(page, "csv"), end="")
    pull_n,sway_nm
    41873,12562
    """
    from kurbel.balance.locomotives.locomotive import Locomotive, Run
    from kurbel.balance.locomotives.page import LocomotiveRequest

    if velocity is not None and wheel is None:
        raise ProblemError("--velocity needs the diameter of the wheels to turn the axle; add --wheel 1.8m")
    return LocomotiveRequest(
        layout=layout_of(layout, ("locomotive",), given["layouts"]),
        engine=Locomotive(
            _cranks(cranks, spacing, positions, reciprocating, revolving),
            _radius(stroke),
            as_length(gauge, "gauge"),
            axles,
        ),
        run=Run(
            speed=None if speed is None else as_speed(speed),
            velocity=None if velocity is None else as_velocity(velocity, "velocity"),
            wheel=None if wheel is None else as_length(wheel, "wheel"),
            load=None if wheel_load is None else as_force(wheel_load, "wheel load"),
            limit=None if hammer_blow is None else as_force(hammer_blow, "hammer blow"),
            radius=None if balance_radius is None else as_length(balance_radius, "balance radius"),
        ),
        shares=tuple(as_shares(share)),
        columns=as_names(columns, "share,blow_left_n"),
        **sheet_of(given),
    )


def _radius(stroke: Exact | None) -> Fraction:
    if stroke is None:
        raise ProblemError("the masses turn at the radius of the crank; add --stroke 600mm or --crank 300mm")
    return as_length(stroke, "stroke") / 2


def _cranks(
    angles: Any, spacing: Any, positions: Any, reciprocating: Any, revolving: Any
) -> "tuple[Crank, ...]":
    from kurbel.balance.locomotives.locomotive import Crank

    read = as_crank_angles(angles)
    count = len(read)
    if positions is not None:
        places = as_measures(positions, "displacement", "position")
    elif spacing is not None:
        distance = as_length(spacing, "spacing")
        places = tuple(distance * Fraction(2 * number - count + 1, 2) for number in range(count))
    else:
        raise ProblemError(
            "couples need the places of the cylinders; add their distance, --spacing 0.7m, or --positions"
        )
    moved = _of_each(as_measures(reciprocating, "mass", "reciprocating mass"), count)
    turned = (Fraction(0),) * count
    if revolving is not None:
        turned = _of_each(as_measures(revolving, "mass", "revolving mass"), count)
    for what, values in (
        ("positions", places),
        ("reciprocating masses", moved),
        ("revolving masses", turned),
    ):
        if len(values) != count:
            raise ProblemError(
                f"the number of {what} is {len(values)} and that of cranks {count}; give one of each"
            )
    return tuple(map(Crank, read, places, moved, turned))


def _of_each(masses: tuple[Fraction, ...], count: int) -> tuple[Fraction, ...]:
    return masses * count if len(masses) == 1 else masses
