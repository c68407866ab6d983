"""What is asked for of an engine's balance, with all choices made: its cylinders, orders and columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property

from kurbel.balance.arrangement import (
    LENGTHS,
    Arrangement,
    Cylinder,
    Residual,
    check_count,
    force,
    moment,
    row,
    usual,
)
from kurbel.balance.harmonics import HARMONICS
from kurbel.balance.harmonics_page import OrdersRequest
from kurbel.errors import ProblemError
from kurbel.page.quantity import Formula, Quantity, words
from kurbel.reading.given import choose

DEFAULT_ENGINE = "inline-4"
DECIMALS = 4
RESIDUALS = ("force", "moment")
FACTOR = "factor"
# Key, name, spanner and head of the lengths of `balance.LENGTHS`.
_LENGTHS = (
    (
        "along", "Amplitude längs der Bezugslinie|Amplitude along the line of reference",
        "Amplitude", "längs|along",
    ),
    (
        "across", "Amplitude quer zur Bezugslinie|Amplitude across the line of reference",
        "Amplitude", "quer|across",
    ),
    ("forward", "vorwärts umlaufender Teil|Part turning forward", "Umlaufend|Turning", "vorwärts|forward"),
    (
        "backward", "rückwärts umlaufender Teil|Part turning backward",
        "Umlaufend|Turning", "rückwärts|backward",
    ),
    ("greatest", "größter Betrag|Greatest magnitude", "Betrag|Magnitude", "größter|greatest"),
    ("least", "kleinster Betrag|Least magnitude", "Betrag|Magnitude", "kleinster|least"),
)  # fmt: skip


@cache
def balance_registry() -> Mapping[str, Quantity]:
    """Return every column by its key: the harmonic's factor, and the lengths of force or moment."""
    factor = Quantity(
        key=FACTOR,
        name=words("Harmonische der Kolbenbeschleunigung|Harmonic of the piston acceleration"),
        symbol="$B_k$",
        unit=words(""),
        decimals=DECIMALS,
        formulas={"exact": Formula(HARMONICS["p"].value)},
        heading=words("$B_k$"),
    )
    lengths = {
        key: Quantity(
            key=key,
            name=words(name),
            symbol="",
            unit=words("m R ω²"),
            decimals=DECIMALS,
            formulas={"exact": Formula(LENGTHS[key].value)},
            heading=words(head),
            spanners=(words(spanner),),
        )
        for key, name, spanner, head in _LENGTHS
    }
    return {FACTOR: factor} | lengths


@dataclass(frozen=True, kw_only=True)
class BalanceRequest(OrdersRequest):
    """What is asked for: the forces and moments of an arrangement with several crank ratios.

    `engine` is its name, empty where the cranks were given one by one.
    """

    arrangement: Arrangement
    engine: str = ""

    no_column = "there is no column beside the axes; add one, such as along"

    @cached_property
    def residuals(self) -> Mapping[tuple[str, int], Residual]:
        """The forces and moments of all orders, each found once."""
        found = {"force": force, "moment": moment}
        return {
            (key, order): found[key](self.arrangement, order) for key in RESIDUALS for order in self.orders
        }


def arranged(
    engine: str | None,
    cranks: Sequence[Fraction],
    positions: Sequence[Fraction],
    banks: Sequence[Fraction],
    share: Fraction,
) -> tuple[str, Arrangement]:
    """Return an engine's name and its cylinders, or no name and those of the cranks, about their middle.

    Without either it is the default engine. Positions default to places a unit apart and banks to 0.
    """
    if not cranks:
        if positions or banks:
            raise ProblemError(
                "positions and banks are those of the cylinders in --cranks; give these, for example"
                " --cranks '0;180;180;0'"
            )
        name = choose(DEFAULT_ENGINE if engine is None else engine, usual(), "engine")
        return name, replace(usual()[name], share=share)
    if engine is not None:
        raise ProblemError("--engine has its cranks and --cranks gives others; leave one of the two out")
    check_count(len(cranks))
    for what, given in (("positions", positions), ("banks", banks)):
        if given and len(given) != len(cranks):
            raise ProblemError(
                f"the number of {what} is {len(given)} and that of cranks {len(cranks)};"
                " every cylinder needs one of each"
            )
    evenly = row(cranks, banks, share)
    return "", replace(evenly, cylinders=_placed(evenly, positions)) if positions else evenly


def _placed(arrangement: Arrangement, positions: Sequence[Fraction]) -> tuple[Cylinder, ...]:
    """Return the cylinders at these positions, counted from the middle between the outermost."""
    middle = (min(positions) + max(positions)) / 2
    pairs = zip(arrangement.cylinders, positions, strict=True)
    return tuple(cylinder._replace(position=position - middle) for cylinder, position in pairs)
