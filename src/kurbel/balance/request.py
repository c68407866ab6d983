"""What is asked for of an engine's balance, with all choices made: its cylinders, orders and columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.balance.arrangement import Arrangement, Cylinder, check_count, row, usual
from kurbel.balance.harmonics import printed_orders
from kurbel.balance.harmonics import registry as harmonics_registry
from kurbel.balance.harmonics_page import checked_ratios
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.page.sheet import Sheet
from kurbel.reading.choices import choose

DEFAULT_ENGINE = "inline-4"
ORDERS = 2
DECIMALS = 4
RESIDUALS = ("force", "moment")
AXIS_KEYS = ("ratio", "residual", "order")


class BalanceColumn(NamedTuple):
    """An entry of the registry: a factor or a length of `balance.LENGTHS`, and its heads."""

    key: str
    name: Mapping[str, str]
    unit: str
    spanner: Mapping[str, Label]
    head: Mapping[str, Label]

    @property
    def symbol(self) -> Label:
        """The letter, of a number that has one."""
        return "" if self.spanner["de"] else self.head["de"]


@cache
def balance_registry() -> Mapping[str, BalanceColumn]:
    """Return every column by its key."""
    rows = (
        (
            "factor",
            "Harmonische der Kolbenbeschleunigung|Harmonic of the piston acceleration",
            "|",
            "$B_k$|$B_k$",
        ),
        (
            "along",
            "Amplitude längs der Bezugslinie|Amplitude along the line of reference",
            "Amplitude|Amplitude",
            "längs|along",
        ),
        (
            "across",
            "Amplitude quer zur Bezugslinie|Amplitude across the line of reference",
            "Amplitude|Amplitude",
            "quer|across",
        ),
        (
            "forward",
            "vorwärts umlaufender Teil|Part turning forward",
            "Umlaufend|Turning",
            "vorwärts|forward",
        ),
        (
            "backward",
            "rückwärts umlaufender Teil|Part turning backward",
            "Umlaufend|Turning",
            "rückwärts|backward",
        ),
        ("greatest", "größter Betrag|Greatest magnitude", "Betrag|Magnitude", "größter|greatest"),
        ("least", "kleinster Betrag|Least magnitude", "Betrag|Magnitude", "kleinster|least"),
    )
    return {
        key: BalanceColumn(
            key, _localised(name), "" if key == "factor" else "m R ω²", *map(_localised, heads)
        )
        for key, name, *heads in rows
    }


def _localised(text: str) -> Mapping[str, str]:
    return dict(zip(("de", "en"), text.split("|"), strict=True))


@dataclass(frozen=True, kw_only=True)
class BalanceRequest(Sheet):
    """What is asked for: the forces and moments of an arrangement with several crank ratios.

    `engine` is its name, empty where the cranks were given one by one. By the method of the infinite rod
    all ratios are 1:∞.
    """

    arrangement: Arrangement
    ratios: tuple[Fraction, ...]
    engine: str = ""
    last_order: int = ORDERS
    method: str = "exact"

    def __post_init__(self) -> None:
        super().__post_init__()
        printed_orders(harmonics_registry()["p"], self.last_order)
        for key in self.columns:
            choose(key, balance_column_keys(), "column")
        if self.columns and not self.page_columns:
            raise ProblemError("there is no column beside the axes; add one, such as along")
        object.__setattr__(self, "ratios", checked_ratios(self.ratios, self.method))

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.ratios) * len(RESIDUALS) * len(self.orders)

    @property
    def orders(self) -> tuple[int, ...]:
        return printed_orders(harmonics_registry()["p"], self.last_order)

    @property
    def decimals(self) -> int:
        return self.decimals_of(DECIMALS)

    @property
    def page_columns(self) -> tuple[BalanceColumn, ...]:
        return tuple(balance_registry()[key] for key in self.chosen() if key not in AXIS_KEYS)


def balance_column_keys() -> tuple[str, ...]:
    """Return what --columns can choose from."""
    return (*AXIS_KEYS, *balance_registry())


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
    evenly = row(cranks, banks or [0] * len(cranks), share)
    return "", replace(evenly, cylinders=_placed(evenly, positions)) if positions else evenly


def _placed(arrangement: Arrangement, positions: Sequence[Fraction]) -> tuple[Cylinder, ...]:
    """Return the cylinders at these positions, counted from the middle between the outermost."""
    middle = (min(positions) + max(positions)) / 2
    pairs = zip(arrangement.cylinders, positions, strict=True)
    return tuple(cylinder._replace(position=position - middle) for cylinder, position in pairs)
