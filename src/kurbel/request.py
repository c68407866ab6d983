"""What is asked for, with all choices made: layout, cranks, angles and the columns of the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.choices import choose
from kurbel.digits import Digits
from kurbel.errors import ProblemError
from kurbel.layouts import Layout, LayoutColumn
from kurbel.problem import Crank, check_angles
from kurbel.quantities import STROKES, Quantity, registry
from kurbel.table import Label

AXIS_KEYS = ("ratio", "phi")


@dataclass(frozen=True, slots=True)
class Request:
    """What is asked for. `method` and `digits` None leave both to the layout and the quantities."""

    layout: Layout
    cranks: tuple[Crank, ...]
    angles: Sequence[Fraction]
    method: str | None = None
    digits: int | None = None
    rounding: str = "half-away"
    lang: str = "de"
    columns: tuple[str, ...] = ()
    label: str = ""

    def __post_init__(self) -> None:
        check_angles(self.angles)
        if not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if self.method and self.layout.fixed:
            raise ProblemError(
                f"layout {self.layout.key} states its formulas in its heads and takes no method;"
                " use --layout kinematics to choose one"
            )


class PageColumn(NamedTuple):
    """A column of the page with all choices made."""

    key: str
    digits: Digits
    spanners: tuple[Label, ...]
    heading: tuple[Label, ...]


def column_keys(layout: Layout) -> tuple[str, ...]:
    """Return what --columns can choose from: a page whose heads state formulas has only its own columns."""
    own = tuple(column.key for column in layout.columns)
    return AXIS_KEYS + (own if layout.fixed else tuple(dict.fromkeys(own + tuple(registry()))))


def page_columns(request: Request) -> tuple[PageColumn, ...]:
    layout = request.layout
    if not request.columns:
        shown = [column for column in layout.columns if _available(registry()[column.quantity], request)]
        return tuple(_page_column(column, request) for column in shown)
    own = {column.key: column for column in layout.columns}
    keys = [choose(key, column_keys(layout), "column") for key in request.columns]
    chosen = [own.get(key) or LayoutColumn(key, key) for key in dict.fromkeys(keys) if key not in AXIS_KEYS]
    if not chosen:
        raise ProblemError("--columns names no quantity; add one, for example --columns phi,x,c,p")
    for column in chosen:
        _require(registry()[column.quantity], request)
    return tuple(_page_column(column, request) for column in chosen)


def _available(quantity: Quantity, request: Request) -> bool:
    return all(quantity.available(crank) for crank in request.cranks)


def _require(quantity: Quantity, request: Request) -> None:
    if not _available(quantity, request):
        options = "--stroke" if quantity.needs == "length" else "--stroke and --speed"
        raise ProblemError(f"column {quantity.key} is in {quantity.unit['en']} and needs {options}")


def _page_column(column: LayoutColumn, request: Request) -> PageColumn:
    quantity = registry()[column.quantity]
    decimals = request.digits if request.digits is not None else column.decimals
    digits = Digits(
        quantity,
        column.method or request.method or "exact",
        quantity.decimals if decimals is None else decimals,
    )
    spanners = (quantity.name, STROKES[quantity.stroke]) if column.spanners is None else column.spanners
    heading = ({request.lang: quantity.heading},) if column.heading is None else column.heading
    return PageColumn(
        column.key,
        digits,
        tuple(spanner[request.lang] for spanner in spanners),
        tuple(line[request.lang] for line in heading),
    )
