"""The position of the exercise, rod square to crank: closed forms with the numbers beside them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, pi, rounded
from kurbel.exact.numerals import Label, Number, degrees_text
from kurbel.exact.separation import Separation
from kurbel.kernel.forces import square_position
from kurbel.motion.drive_notes import drive_notes, force_note
from kurbel.motion.evaluation import NEEDS, OUT, Numbers, is_known, is_transcendental, numbers_of_balls, value
from kurbel.motion.quantities import registry
from kurbel.page import axes as page_axes
from kurbel.page.arrange import Grid, Place, check_size
from kurbel.page.old_axes import ColumnAxis
from kurbel.page.quantity import Quantity
from kurbel.page.sheet import Heads, LetteredRatioAxis, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import ratio_text

AXIS_KEYS = ("ratio", "phi")
PHI = "phi"
# A page prints degrees and minutes, records degrees.
DEGREE_DECIMALS = 4
RIGHT_ANGLE = 90
# By the letter of the quantity: what it is in this position.
CLOSED_FORMS = {
    "φ": "arctan(L/R)",
    "ψ": "arctan(R/L)",
    "S": "F sqrt((R/L)^2 + 1)",
    "N": "(F R)/L",
    "T": "F sqrt((R/L)^2 + 1)",
    "Z": "0",
    "M_d": "F R sqrt((R/L)^2 + 1)",
}


@dataclass(frozen=True, kw_only=True)
class TangentRequest(Sheet):
    """What is asked for: forces of these straight cranks where the rod touches the crank circle."""

    cranks: tuple[Crank, ...]

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if any(crank.offset for crank in self.cranks):
            raise ProblemError(
                "the rod touches the crank circle at tan ψ = R/L with the straight crank only;"
                " leave the offset out"
            )
        for key in self.columns:
            quantity = registry().get(choose(key, tangent_column_keys(), "column"))
            if quantity is not None and not self._knows(key):
                options = " and ".join(NEEDS[quantity.needs])
                raise ProblemError(f"column {key} is in {quantity.plain_unit('en')} and needs {options}")

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.cranks)

    @property
    def shown(self) -> tuple[str, ...]:
        chosen = tuple(key for key in self.chosen(self._knows) if key != "ratio" and self._knows(key))
        if not chosen:
            raise ProblemError("there is no column beside the ratio; add one, such as rod_force")
        return chosen

    def _knows(self, key: str) -> bool:
        return key in AXIS_KEYS or all(is_known(registry()[key], crank) for crank in self.cranks)


def tangent_column_keys() -> tuple[str, ...]:
    """Return what --columns can choose from: the outstroke's; on the return stroke forces mirror these."""
    return (*AXIS_KEYS, *(key for key, quantity in registry().items() if quantity.stroke == OUT))


def build_tangent(request: TangentRequest, pages: bool = True) -> Table:
    """Return the sheet that was asked for; without `pages` only its records."""
    layout, lang = request.layout, request.lang
    notes = [*(note[lang] for note in layout.notes), *drive_notes(request.cranks, lang)]
    forces = dict.fromkeys(crank.force for crank in request.cranks if crank.force is not None)
    notes += [force_note(force) for force in forces]
    names = request.columns or ("ratio", *request.shown)
    records = records_of(len(request), names, _fields(request), lambda: _records(request))
    return table_of(request, layout.caption[lang], _grid(request) if pages else None, records, notes)


def _grid(request: TangentRequest) -> Grid:
    layout, lang, keys = request.layout, request.lang, request.shown
    ratios = [crank.ratio for crank in request.cranks]
    axes = {
        "ratio": LetteredRatioAxis(layout, ratios, lang),
        "column": ColumnAxis(layout, [Heads((), (_head(key, lang),)) for key in keys], ratios, lang),
    }
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        key, crank = keys[place["column"]], request.cranks[place["ratio"]]
        if not _is_arc(key):
            return Cell(_number(request, key, crank))
        minutes = _degrees(request, key, crank, 60, 0)
        return Cell(f"${degrees_text(Fraction(minutes.scaled, 60))}$")

    def unit(place: Place) -> Label:
        key = keys[place["column"]]
        return "" if _is_arc(key) else registry()[key].unit[lang]

    return Grid(axes, cell, unit)


def _head(key: str, lang: str) -> Label:
    """Name, letter and closed form: Führungsdruck N = F R/L."""
    symbol = "φ" if key == PHI else registry()[key].symbol.strip("$")
    form = f" = {CLOSED_FORMS[symbol]}" if symbol in CLOSED_FORMS else ""
    return f"{_name(key, lang)} ${symbol}{form}$"


def _name(key: str, lang: str) -> str:
    return page_axes.PHI[lang] if key == PHI else registry()[key].name[lang]


def _is_arc(key: str) -> bool:
    return key == PHI or registry()[key].is_arc


def _records(request: TangentRequest) -> Iterator[Mapping[str, Value]]:
    """One for each crank."""
    for crank in request.cranks:
        values: dict[str, Value] = {"ratio": f"${ratio_text(crank.ratio)}$"}
        for key in request.shown:
            is_arc, decimals = _is_arc(key), _decimals(request, key)
            values[key] = (
                _degrees(request, key, crank, 1, decimals) if is_arc else _number(request, key, crank)
            )
        yield values


def _fields(request: TangentRequest) -> Mapping[str, Field]:
    lang = request.lang
    fields = {
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${request.layout.ratio_symbol}$"),
        PHI: Field(PHI, _name(PHI, lang), "$φ$", "°", _decimals(request, PHI), "exact"),
    }
    return {key: _field(request, key) for key in request.shown if key != PHI} | fields


def _field(request: TangentRequest, key: str) -> Field:
    quantity, lang = registry()[key], request.lang
    unit = quantity.plain_unit(lang)
    return Field(key, _name(key, lang), quantity.symbol, unit, _decimals(request, key), "exact")


def _decimals(request: TangentRequest, key: str) -> int:
    return request.decimals_of(DEGREE_DECIMALS if _is_arc(key) else registry()[key].decimals or 0)


def _degrees(request: TangentRequest, key: str, crank: Crank, share: int, decimals: int) -> Number:
    """Return φ or ψ in parts of a degree.

    tan ψ is rational, so that ψ is no rational number of degrees but 0 (and 45, for λ = 1; Niven).
    """

    def parts() -> Any:
        slant = ball(crank.ratio).atan() * 180 / pi()
        return share * (RIGHT_ANGLE - slant if key == PHI else slant)

    return Number(rounded(parts, decimals, request.rounding, NEVER_TIES), decimals)


def _number(request: TangentRequest, key: str, crank: Crank) -> Number:
    quantity, decimals = registry()[key], _decimals(request, key)

    def tie_bits(boundary: Fraction) -> float:
        bound = _value(quantity, crank, Numbers(Separation.rational))
        return float((bound - Separation.rational(boundary)).bits())

    ties: TieBits | None = NEVER_TIES if is_transcendental(quantity, crank) else tie_bits
    scaled = rounded(lambda: _value(quantity, crank, numbers_of_balls()), decimals, request.rounding, ties)
    return Number(scaled, decimals)


def _value(quantity: Quantity, crank: Crank, numbers: Numbers) -> Any:
    return value(quantity, "exact", crank, square_position(numbers.of(crank.ratio)), numbers)
