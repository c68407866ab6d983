"""The list of an engine's cylinders: where each stands, how large it is, and its share in the work."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kurbel.engine.captions import caption
from kurbel.engine.cylinder import AnyTurn, Member, TurnPlace, members_of
from kurbel.engine.digits import CellValue, printed
from kurbel.engine.engine import Engine
from kurbel.engine.engine_page import errors_beside
from kurbel.engine.engine_quantities import ENGINE_METHODS, Needs
from kurbel.engine.loads.words import load_text
from kurbel.engine.notes import notes
from kurbel.engine.request import EngineRequest
from kurbel.engine.work import kilowatts
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, given
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import Axis, ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Of, Quantity, entry, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field, Note, Value

CYLINDER = words("Zylinder|Cylinder")
WHOLE = "all"
SUM = words("alle|all")
SHARES = words(
    "Anteile an der mittleren Tangentialkraft; negativ, wo die Welle den Kolben treibt"
    "|Shares of the mean tangential force; negative where the shaft drives the piston"
)


def _engine(turn: AnyTurn, row: Member) -> Engine | None:
    return None if row.part is None else turn.engine.parts[row.part]


def _mean(turn: AnyTurn, row: Member) -> Numeric:
    return turn.mean_force() if row.part is None else turn.cylinders[row.part].whole_mean


def _of_part(value: Callable[[Engine], object]) -> Callable[[AnyTurn, Member], object]:
    """Return what a cylinder has by itself, and all together have not."""

    def of(turn: AnyTurn, row: Member) -> object:
        part = _engine(turn, row)
        return None if part is None else value(part)

    return of


def _bore(part: Engine) -> Fraction | None:
    return None if part.load is None else 1000 * part.load.bore


def _stroke(part: Engine) -> Fraction | None:
    radius = part.crank.radius
    # Of other drives the stroke is no rational number of crank radii.
    straight = not part.crank.offset and type(part.drive) is type(part.crank)
    return 2000 * radius if radius is not None and straight else None


@cache
def registry() -> Mapping[str, Quantity]:
    """Return what is listed of a cylinder, by its key. A kernel takes the turn and the row."""
    rows: tuple[tuple[Any, ...], ...] = (
        ("lag", "Winkel hinter dem ersten Zylinder|Angle behind the first cylinder", "$α$", "°", None,
         lambda turn, row: None if row.part is None else 180 * row.start, {}),
        ("load", "Belastung|Load", "", "", None, None, {}),
        ("bore_mm", "Bohrung|Bore", "$d$", "mm", None, _of_part(_bore), {"needs": (Needs.LOAD,)}),
        ("stroke_mm", "Hub|Stroke", "$s$", "mm", None, _of_part(_stroke), {"needs": (Needs.TORQUE,)}),
        ("mean_share", "Anteil an der mittleren Tangentialkraft|Share of the mean tangential force", "", "%",
         2, _mean, {"scale": lambda turn: 100 / abs(turn.mean_force())}),
        ("mean_force", "mittlere Tangentialkraft|Mean tangential force", "$P$", "$Q$", 5, _mean, {}),
        ("mean_torque", "mittleres Drehmoment|Mean torque", "$P r$", "N m", 1, _mean,
         {"scale": AnyTurn.torque_unit, "needs": (Needs.TORQUE,)}),
        ("power", "Leistung|Power", "$N$", "kW", 3, _mean, {"scale": kilowatts, "needs": (Needs.POWER,)}),
    )  # fmt: skip
    return {row[0]: _entry(*row) for row in rows}


def _entry(
    key: str, name: str, symbol: Label, unit: Label, decimals: int | None, kernel: Any, rest: Any
) -> Quantity:
    formulas = dict.fromkeys(ENGINE_METHODS, Formula(kernel))
    heads = {"load": "Belastung|Load", "mean_share": "Anteil in %|Share in %"}
    return entry(key, name, symbol, unit, decimals, formulas, heads.get(key, ""), of=Of.CYLINDER, **rest)


class CylindersRequest(EngineRequest):
    """What is asked for: the cylinders of one engine."""

    def check(self) -> None:
        super().check()
        if len(self.steams) > 1 or len(self.drives) > 1:
            raise ProblemError("a list of cylinders is of one engine; give one load and one crank ratio")

    @cached_property
    def rows(self) -> tuple[Member, ...]:
        """The cylinders in their order, and all together if there are several."""
        every = members_of(self.first)
        return (*every, *([Member(0)] if len(every) > 1 else []))

    @property
    def alike(self) -> bool:
        """Whether the cylinders differ in nothing but their places."""
        return len({replace(part, lag=Fraction(0)) for part in self.first.parts}) == 1

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return ("cylinder",)


def _number(request: CylindersRequest, column: Column, place: Place, times: int) -> Value:
    row, quantity = request.rows[place["cylinder"]], column.quantity
    turn = request.turn(0, 0, column.method)
    if quantity.key == "load":
        part = _engine(turn, row)
        return None if part is None else load_text(part.steam, request.lang)
    if quantity.key == "mean_share" and column.key == quantity.key and request.alike:
        exact = Fraction(100, 1 if row.part is None else len(request.rows[:-1]) or 1)
        return given(exact if turn.mean_sign > 0 else -exact, column.decimals, request.rounding)
    kernel = quantity.formulas[column.method].kernel
    found = kernel(turn, row)
    if found is None:
        return None
    if isinstance(found, Fraction) and quantity.scale is None:
        return given(found, column.decimals, request.rounding)
    formula = Formula(lambda one, where: kernel(one, row))
    asked = CellValue(
        column._replace(quantity=quantity._replace(formulas={column.method: formula})), [turn], TurnPlace()
    )
    return printed(asked, request.rounding, request.carded)


def _beside(request: CylindersRequest, column: Column) -> tuple[Column, ...]:
    return errors_beside(request, column) if column.quantity.formulas["exact"].kernel is _mean else ()


def _row_axis(request: CylindersRequest) -> ListAxis:
    lang = request.lang
    return ListAxis(
        request.rows,
        Field("cylinder", CYLINDER[lang]),
        lambda row: Number(row.number, 0) if row.number else WHOLE,
        lambda row: f"${row.number}$" if row.number else SUM[lang],
    )


def _notes(request: CylindersRequest) -> Iterator[Label | Note]:
    if any(column.key == "mean_share" for column in request.page_columns):
        yield SHARES[request.lang]
    yield from notes(request)


_AXES: Mapping[str, Callable[[Any], Axis | ColumnAxis]] = {"cylinder": _row_axis, "column": ColumnAxis}


SUBJECT = Subject(
    key="cylinders",
    layout="cylinders",
    command="delta --layout cylinders",
    axes=_AXES,
    axis_keys=("cylinder",),
    quantities=registry,
    number=_number,
    caption=caption,
    notes=_notes,
    beside=_beside,
    letters=True,
)
