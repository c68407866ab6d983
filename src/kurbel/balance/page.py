"""An engine's cylinders and a layout become a table of its free forces and moments."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from kurbel.balance.arrangement import LENGTHS, Residual, certified_length, factor, force, moment
from kurbel.balance.harmonics import registry as harmonics_registry
from kurbel.balance.harmonics_page import (
    EXACT_ZERO,
    OrderAxis,
    caption,
    harmonic_number,
    order_field,
    ratio_field,
    series_notes,
)
from kurbel.balance.request import RESIDUALS, BalanceColumn, BalanceRequest
from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label, Number, degrees_text, finite_decimals
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.old_axes import ColumnAxis, RatioAxis
from kurbel.page.sheet import Heads, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.notation import plain, ratio_text

UNITS: Mapping[str, Label] = {"force": "$m R ω^2$", "moment": "$m R ω^2 a$"}
ENGINES: Mapping[str, tuple[str, str]] = {
    "inline-1": ("Einzylindermotor", "single cylinder"),
    "inline-2-180": ("Zweizylinder-Reihenmotor, Kurbeln gegenläufig", "inline twin, cranks opposite"),
    "inline-2-360": ("Zweizylinder-Reihenmotor, Kurbeln gleichläufig", "inline twin, cranks alike"),
    "inline-3": ("Dreizylinder-Reihenmotor", "inline three"),
    "inline-4": ("Vierzylinder-Reihenmotor", "inline four"),
    "inline-5": ("Fünfzylinder-Reihenmotor", "inline five"),
    "inline-6": ("Sechszylinder-Reihenmotor", "inline six"),
    "v2-90": ("V2-Motor von 90°", "90° V twin"),
    "v6-90": ("V6-Motor von 90°", "90° V6"),
    "v8-90": ("V8-Motor von 90°", "90° V8"),
    "v12-60": ("V12-Motor von 60°", "60° V12"),
    "boxer-2": ("Zweizylinder-Boxermotor", "flat twin"),
    "boxer-4": ("Vierzylinder-Boxermotor", "flat four"),
}
WORDS: Mapping[str, Mapping[str, str]] = {
    "force": {"de": "Kräfte", "en": "Forces"},
    "moment": {"de": "Momente", "en": "Moments"},
    "in": {"de": "{residual} in {unit}", "en": "{residual} in {unit}"},
    "residual": {"de": "Kraft oder Moment", "en": "Force or moment"},
    "cylinders": {"de": "{count} Zylinder", "en": "{count} cylinders"},
    "cranks": {"de": "Kurbeln: ", "en": "Cranks: "},
    "banks": {"de": "Zylinderachsen: ", "en": "Axes of the cylinders: "},
    "positions": {"de": "Lagen in $a$: ", "en": "Positions in $a$: "},
    "symbols": {
        "de": "$m$ hin- und hergehende Masse eines Zylinders, $R$ Kurbelhalbmesser, $ω$"
        " Winkelgeschwindigkeit; die umlaufenden Massen gelten als ausgeglichen",
        "en": "$m$ reciprocating mass of a cylinder, $R$ crank radius, $ω$ angular velocity; rotating masses"
        " are taken as balanced",
    },
    "share": {
        "de": "Gegengewichte, der Kurbel gegenüber umlaufend, gleichen von jeder Masse $m$ den Teil"
        " {share} aus",
        "en": "Counterweights, turning opposite the crank, balance the share {share} of every mass $m$",
    },
    "spacing": {"de": "$a$ Abstand benachbarter Kurbeln", "en": "$a$ distance of neighbouring cranks"},
    "unit": {"de": "$a$ Längeneinheit der Lagen", "en": "$a$ unit of length of the positions"},
    "middle": {
        "de": "; Momente um die Mitte, in der Richtung der Kräfte des Paares",
        "en": "; moments about the middle, in the direction of the forces of the couple",
    },
    "angles": {
        "de": "Winkel zählen im Drehsinn von der Bezugslinie, der Zylinderachse oder beim V der Mittellinie",
        "en": "Angles count in the sense of rotation from the line of reference, the cylinder axis or of a V"
        " the middle line",
    },
    "zero": {
        "de": "Beträge enthalten den Faktor $B_k$; 0 ohne Dezimalen ist genau 0",
        "en": "Magnitudes include the factor $B_k$; 0 without decimals is exactly 0",
    },
}


@dataclass(frozen=True)
class _Solved:
    """A request with its residuals, each found once."""

    request: BalanceRequest

    @cached_property
    def residuals(self) -> Mapping[tuple[str, int], Residual]:
        found = {"force": force, "moment": moment}
        arrangement, orders = self.request.arrangement, self.request.orders
        return {(key, order): found[key](arrangement, order) for key in RESIDUALS for order in orders}

    def number(self, column: BalanceColumn, key: str, order: int, ratio: Fraction) -> Number:
        method, decimals, rounding = self.request.method, self.request.decimals, self.request.rounding
        crank = Crank(ratio)
        if column.key == "factor":
            return harmonic_number(harmonics_registry()["p"], order, crank, decimals, method, rounding)
        length, residual, scale = (
            LENGTHS[column.key],
            self.residuals[key, order],
            factor(order, crank, method),
        )
        if scale == 0 or length.vanishes(residual):
            return EXACT_ZERO
        return certified_length(length, residual, decimals, scale, rounding)


class _ResidualAxis(Axis):
    """Forces and moments, with their units."""

    def __init__(self, lang: str) -> None:
        super().__init__(len(RESIDUALS))
        self.lang = lang

    def heads(self, place: Place) -> tuple[Label, ...]:
        key = RESIDUALS[place["residual"]]
        return (WORDS["in"][self.lang].format(residual=WORDS[key][self.lang], unit=UNITS[key]),)


def build_balance(request: BalanceRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    solved = _Solved(request)
    text = caption(request.layout, request.lang, request.ratios, request.method)
    text = text.replace("{engine}", _engine(request))
    names = request.columns or ("ratio", "residual", "order", *(one.key for one in request.page_columns))
    records = records_of(len(request), names, _fields(request), lambda: _records(solved))
    return table_of(request, text, _grid(solved) if pages else None, records, _notes(request))


def _heads(column: BalanceColumn, lang: str) -> Heads:
    return Heads((column.spanner[lang],) if column.spanner[lang] else (), (column.head[lang],))


def _engine(request: BalanceRequest) -> Label:
    if request.engine:
        return dict(zip(("de", "en"), ENGINES[request.engine], strict=True))[request.lang]
    return WORDS["cylinders"][request.lang].format(count=len(request.arrangement.cylinders))


def _grid(solved: _Solved) -> Grid:
    request = solved.request
    layout, lang, columns = request.layout, request.lang, request.page_columns
    axes = {
        "ratio": RatioAxis(layout, request.ratios, lang),
        "residual": _ResidualAxis(lang),
        "order": OrderAxis(layout, request.orders, lang),
        "column": ColumnAxis(layout, [_heads(column, lang) for column in columns], request.ratios, lang),
    }
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        key, order = RESIDUALS[place["residual"]], request.orders[place["order"]]
        return Cell(solved.number(columns[place["column"]], key, order, request.ratios[place["ratio"]]))

    return Grid(axes, cell)


def _records(solved: _Solved) -> Iterator[Mapping[str, Value]]:
    """One for each ratio, force or moment, and order."""
    request = solved.request
    for ratio in request.ratios:
        for key, order in solved.residuals:
            axes: dict[str, Value] = {
                "ratio": f"${ratio_text(ratio)}$", "residual": key, "order": Number(order, 0)
            }  # fmt: skip
            yield axes | {one.key: solved.number(one, key, order, ratio) for one in request.page_columns}


def _fields(request: BalanceRequest) -> Mapping[str, Field]:
    lang = request.lang
    fields = {
        "ratio": ratio_field(request.layout, lang),
        "residual": Field("residual", WORDS["residual"][lang]),
        "order": order_field(lang),
    }
    for one in request.page_columns:
        fields[one.key] = Field(
            one.key, one.name[lang], one.symbol, one.unit, request.decimals, request.method
        )
    return fields


def _notes(request: BalanceRequest) -> Iterator[Label]:
    lang, cylinders = request.lang, request.arrangement.cylinders
    yield WORDS["cranks"][lang] + _list(_degrees(one.crank) for one in cylinders)
    if any(one.bank for one in cylinders):
        yield WORDS["banks"][lang] + _list(_degrees(one.bank) for one in cylinders)
    if len(cylinders) > 1:
        yield WORDS["positions"][lang] + _list(_exact(one.position) for one in cylinders)
    yield WORDS["angles"][lang]
    yield WORDS["symbols"][lang]
    spacing = "spacing" if request.engine else "unit"
    yield WORDS[spacing][lang] + WORDS["middle"][lang]
    if request.arrangement.share:
        yield WORDS["share"][lang].format(share=f"${_exact(request.arrangement.share)}$")
    yield WORDS["zero"][lang]
    yield from series_notes(harmonics_registry()["p"], request.orders, request.method, request.layout, lang)


def _list(values: Iterable[str]) -> Label:
    return "; ".join(f"${value}$" for value in values)


def _degrees(angle: Fraction) -> str:
    return degrees_text(angle) if finite_decimals(angle) is None else f"{plain(angle)}°"


def _exact(value: Fraction) -> str:
    if finite_decimals(value) is not None:
        return plain(value)
    return f"{value.numerator}/{value.denominator}"
