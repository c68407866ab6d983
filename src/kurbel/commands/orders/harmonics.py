"""The harmonics of the piston's motion and of the tangential force that turns the crank."""

from collections.abc import Mapping
from typing import Annotated, Any, Unpack

from kurbel.balance.harmonics import HARMONICS, MOST_ORDERS
from kurbel.commands import parameters as option
from kurbel.commands.balance import BalanceOptions
from kurbel.commands.cylinder import engines
from kurbel.commands.cylinder.effort import Rods, Rubbing
from kurbel.commands.cylinder.slope import Lying
from kurbel.commands.machines import engine_of, for_masses, lone_lengths, needless_of_load, unsized
from kurbel.commands.old_motion import meant, of_other_mechanisms, sheet_of
from kurbel.commands.options import Choice, Count, Option, is_given
from kurbel.commands.subject import SPELLED, makes_table
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_names, as_speed

TORQUE = "torque"
OF_TORQUE = ("torque", "excitation")


class Driven(
    engines.Steam, engines.MovingRod, Lying, Rods, Rubbing, option.AnyDrive, option.Sheet, total=False
):
    """What makes an engine of a crank ratio."""

    eps: option.Eps
    reciprocating: option.Reciprocating
    rocker_inertia: option.RockerInertia
    speed: Annotated[
        Exact | None, option.SPEED._replace(help="Speed, for frequencies and masses: 120/min, 12.5rad/s.")
    ]
    layouts: option.Layouts


# What the motion has, too.
_SHARED = (
    *option.OnMachine.__annotations__,
    *option.Sheet.__annotations__,
    "layouts",
    "stroke",
    *SPELLED,
    "rod",
    "offset",
)


def _of_torque(values: Mapping[str, Any]) -> bool:
    """Whether the torque is meant, by its name or by a layout."""
    if values["quantity"] or not values["layout"]:
        return bool(values["quantity"] == TORQUE)
    return layout(values["layout"], values["layouts"]).subject in OF_TORQUE


def _foreign(values: Mapping[str, Any]) -> Mapping[str, str]:
    if _of_torque(values):
        return of_other_mechanisms(values, meant(values, layout=None), ("stroke", "speed", "method"))
    names = (*(name for name in Driven.__annotations__ if name not in _SHARED), "columns")
    return {
        name: f"--{name.replace('_', '-')} is for the harmonics of the torque; add --quantity torque"
        for name in names
    }


def _needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not _of_torque(values):
        return lone_lengths(values)
    refused = {**needless_of_load(values), **unsized(values)}
    if not (values["layout"] or is_given(values["columns"])):
        refused |= for_masses("speed")(values)
    return refused


@makes_table(foreign=_foreign, needless=_needless, order="quantity orders method")
def harmonics_table(
    ratio: Annotated[option.Given | None, BalanceOptions.ratio] = None,
    *,
    quantity: Annotated[
        str | None,
        Option(
            "x (path), c (velocity), p (acceleration, default), or torque, of an engine.",
            kind=Choice("quantity", (*HARMONICS, TORQUE)),
        ),
    ] = None,
    orders: Annotated[
        int,
        Option(
            f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out of the motion.",
            "N",
            Count("orders", 1, MOST_ORDERS, "does not say up to which one"),
        ),
    ] = 6,
    method: Annotated[str, BalanceOptions.method] = "exact",
    columns: Annotated[option.Names, option.columns_option("torque-harmonics", "order,amplitude,phase")] = (),
    layout: Annotated[str | None, option.layout_option("harmonics", *OF_TORQUE)] = None,
    **given: Unpack[Driven],
) -> Question:
    """Print the harmonics of the piston's motion, coefficients of cos φ, cos 2φ, ..., or those of the torque.

    \b
    kurbel harmonics --ratio 1:5
    kurbel harmonics --ratio '1:4;1:5' --quantity x --orders 10 --digits 12
    kurbel harmonics --quantity torque --eps 4 --cranks '0;90'
    kurbel harmonics --layout excitation --machine engine.toml -f csv -o excitation.csv
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.harmonics_table("1:5", orders=4), "csv"), end="")
    order,ratio,value
    1,1:5,1.000000
    2,1:5,0.202038
    4,1:5,-0.002062
    """
    if _of_torque({"quantity": quantity, "layout": layout, "layouts": given["layouts"]}):
        page = layout_of(layout or "torque-harmonics", OF_TORQUE, given["layouts"])
        return _torque(page, {**given, "ratio": ratio}, method, orders, as_names(columns, "order,amplitude"))
    from kurbel.balance.harmonics_page import HarmonicsRequest

    if is_given(given["offset"]):
        raise ProblemError(
            "the crank is offset; harmonics of the motion are known for the straight crank, without --offset"
        )
    page = layout_of(layout or "harmonics", ("harmonics",), given["layouts"])
    return HarmonicsRequest(
        layout=page,
        ratios=tuple(
            crank.ratio for crank in Described(ratio, given["stroke"], given["rod"]).cranks(page.ratios)
        ),
        quantity=quantity or "",
        last_order=orders,
        method=method,
        **sheet_of(given),
    )


def _torque(
    page: Any, given: Mapping[str, Any], method: str, orders: int, columns: tuple[str, ...]
) -> Question:
    from kurbel.engine.harmonics.page import TorqueRequest

    if method == "infinite":
        raise ProblemError("the torque of an infinite rod is that of --ratio 1:∞; leave --method out")
    speed = given["speed"]
    return engine_of(
        page,
        {**given, "method": method},
        TorqueRequest,
        columns=columns,
        last_order=orders,
        speed=None if speed is None else as_speed(speed),
    )
