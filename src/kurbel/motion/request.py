"""What is asked for, with all choices made: layout, cranks, angles and the columns of the page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.digits import Digits
from kurbel.motion.quantities import NEEDS, Quantity, registry
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.sheet import check_label, check_rounding
from kurbel.reading.choices import choose
from kurbel.reading.notation import MOST_ROWS

AXIS_KEYS = ("ratio", "phi")


@dataclass(frozen=True, slots=True)
class Request:
    """What is asked for. `method` and `digits` None leave both to the layout and the quantities.

    By the method of the infinite rod all ratios are 1:∞, but for a page that also has other formulas.
    """

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
        check_rounding(self.digits, self.rounding)
        if len(self) > MOST_ROWS:
            raise ProblemError(
                f"{len(self.cranks)} ratios at {len(self.angles)} angles make a table of {len(self)} rows;"
                " at most 10^9 are allowed"
            )
        if self.method and self.layout.fixed:
            raise ProblemError(
                f"layout {self.layout.key} states its formulas in its heads and takes no method;"
                " use --layout kinematics to choose one"
            )
        if any(crank.offset for crank in self.cranks):
            self._check_offset()
        check_label(self.label)
        if self.method == "infinite" and all(column.method is None for column in self.layout.columns):
            cranks = (replace(crank, ratio=Fraction(0)) for crank in self.cranks)
            object.__setattr__(self, "cranks", tuple(dict.fromkeys(cranks)))

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.cranks) * len(self.angles)

    def _check_offset(self) -> None:
        if self.method not in (None, "exact"):
            raise ProblemError(
                f'method "{self.method}" has no formulas for an offset crank;'
                " use exact, or leave the offset out"
            )
        if any(column.method not in (None, "exact") for column in self.layout.columns):
            raise ProblemError(
                f"layout {self.layout.key} prints first-order formulas, which an offset crank does not have;"
                " use --layout kinematics or leave the offset out"
            )


class PageColumn(NamedTuple):
    """A column of the page with all choices made."""

    key: str
    digits: Digits
    spanners: tuple[Label, ...]
    heading: tuple[Label, ...]


def quantities_of(layout: Layout) -> Mapping[str, Quantity]:
    """Return every quantity that the layout's columns can show: those of the rod on pages about it only."""
    if layout.subject != "inertia":
        return registry()
    from kurbel.motion.inertia import inertia_registry

    return {**registry(), **inertia_registry()}


def column_keys(layout: Layout) -> tuple[str, ...]:
    """Return what --columns can choose from: a page whose heads state formulas has only its own columns."""
    own = tuple(column.key for column in layout.columns)
    return AXIS_KEYS + (own if layout.fixed else tuple(dict.fromkeys(own + tuple(quantities_of(layout)))))


def page_columns(request: Request) -> tuple[PageColumn, ...]:
    layout, known = request.layout, quantities_of(request.layout)
    if not request.columns:
        shown = [column for column in layout.columns if _available(known[column.quantity], request)]
        shown = [one for one in shown if not one.unless or not _available(known[one.unless], request)]
        return tuple(_page_column(column, request) for column in shown)
    own = {column.key: column for column in layout.columns}
    keys = [choose(key, column_keys(layout), "column") for key in request.columns]
    keys = [key for key in dict.fromkeys(keys) if key not in AXIS_KEYS]
    # Beside foreign columns the layout's heads say too little, such as "Hingang" where all are paths.
    foreign = not own.keys() >= set(keys)
    chosen = [
        LayoutColumn(key, key) if foreign and key in known else own.get(key) or LayoutColumn(key, key)
        for key in keys
    ]
    if not chosen:
        raise ProblemError("--columns names no quantity; add one, for example --columns phi,x,c,p")
    for column in chosen:
        _require(known[column.quantity], request)
    return tuple(_page_column(column, request) for column in chosen)


def _available(quantity: Quantity, request: Request) -> bool:
    return all(quantity.available(crank) for crank in request.cranks)


def _require(quantity: Quantity, request: Request) -> None:
    if not _available(quantity, request):
        options = " and ".join(NEEDS[quantity.needs])
        raise ProblemError(f"column {quantity.key} is in {quantity.unit['en']} and needs {options}")


def _page_column(column: LayoutColumn, request: Request) -> PageColumn:
    quantity, lang = quantities_of(request.layout)[column.quantity], request.lang
    decimals = request.digits if request.digits is not None else column.decimals
    digits = Digits(
        quantity,
        column.method or request.method or "exact",
        quantity.decimals if decimals is None else decimals,
    )
    heads = [quantity.name, quantity.part, quantity.heading]
    if quantity.model:
        # One force by several models stands under its letter.
        heads = [quantity.name, quantity.heading, quantity.part]
    spanners = heads[:2] if column.spanners is None else column.spanners
    heading = heads[2:] if column.heading is None else column.heading
    return PageColumn(
        column.key,
        digits,
        tuple(spanner[lang] for spanner in spanners),
        tuple(line[lang] for line in heading),
    )
