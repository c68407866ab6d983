"""Engines and a layout become a table: its grid for the page, its records for programs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

from kurbel.engine import captions as engine_captions
from kurbel.engine.axes import ExpansionAxis, StrokeAxis, TargetAxis, expansion_value
from kurbel.engine.digits import Estimate, error_number, estimate, estimated, settled
from kurbel.engine.engine import Diagram
from kurbel.engine.quantities import AT_ANGLE, SPANS, WHOLE, Where
from kurbel.engine.request import EngineColumn, EngineRequest
from kurbel.engine.turn import Turn, turn_of
from kurbel.errors import CardError
from kurbel.exact.numerals import Label, Number, degrees_text
from kurbel.page.angles import angle_number
from kurbel.page.arrange import Grid, Place, check_size
from kurbel.page.layouts import SUBJECTS
from kurbel.page.old_axes import AngleAxis, ColumnAxis, RatioAxis
from kurbel.page.sheet import table_of
from kurbel.page.table import Cell, Field, Note, Records, Table, Value
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.engine.card_turn import CardTurn

# The mark of the two extremes that make δ.
MAKES_DELTA = "a"
# What the key of a value has in addition for its error.
ERROR = "_error"


def build_engine(request: EngineRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    solved = _Solved(request)
    if request.carded:
        _check_cards(solved)
    grid = _grid(solved) if pages else None
    records = Records(_fields(request), _Rows(solved))
    return table_of(request, engine_captions.caption(request), grid, records, _notes(solved))


@dataclass(frozen=True)
class _Solved:
    """A request with the turns of its engines, each solved once."""

    request: EngineRequest
    turns: dict[tuple[int, int, str], Turn | CardTurn] = field(default_factory=dict)

    def turn(self, expansion: int, ratio: int, method: str) -> Turn | CardTurn:
        key = (expansion, ratio, method)
        if key not in self.turns:
            self.turns[key] = turn_of(self.request.engine(expansion, ratio), method)
        return self.turns[key]

    def where(self, place: Place) -> Where:
        request = self.request
        return Where(
            request.spans[place["stroke"]] if "stroke" in place else WHOLE,
            request.angles[place["angle"]] / 180 if "angle" in place else Fraction(0),
            request.flywheels[place["target"]] if "target" in place else None,
        )

    def number(self, column: EngineColumn, place: Place, unit: int = 1) -> Number | None:
        """The printed number at a place, None where the column says nothing of it."""
        where = self.where(place)
        if not column.quantity.applies(where):
            return None
        turns = tuple(self.turn(place["expansion"], place["ratio"], method) for method in column.methods)
        # The turns of a request are all in balls, or all of cards.
        settle: Callable[..., Number | None] = estimated if self.request.carded else settled
        return settle(column, turns, where, self.request.rounding, unit)

    def error(self, column: EngineColumn, place: Place) -> float | None:
        """How far the number at a place may be off, of an indicator card; None where there is none."""
        where = self.where(place)
        if not column.quantity.applies(where):
            return None
        turns = [self.turn(place["expansion"], place["ratio"], method) for method in column.methods]
        # Errors are asked of cards alone, and the turns of cards are all of cards.
        judge: Callable[..., Estimate] = estimate
        return judge(column, turns, where).error

    def makes_delta(self, column: EngineColumn, place: Place) -> bool:
        """Whether this is the extreme of a stroke that is the extreme of the turn."""
        stroke = self.where(place).stroke
        greatest = column.quantity.greatest
        if greatest is None or column.quantity.arc or stroke is WHOLE:
            return False
        turn = self.turn(place["expansion"], place["ratio"], column.methods[0])
        return stroke in turn.extreme_strokes(greatest)


def _check_cards(solved: _Solved) -> None:
    """Raise CardError for a card that supports not one figure of the mean force."""
    mean = solved.request.mean_column
    for index, steam in enumerate(solved.request.steams):
        assert isinstance(steam, Diagram)
        if solved.number(mean, {"expansion": index, "ratio": 0}) is None:
            raise CardError(
                f"{steam.card.name}: the points are too few or scatter too much for one figure of the mean"
                " force; give a smoother card, or look for a mistyped pressure"
            )


def _grid(solved: _Solved) -> Grid:
    request = solved.request
    layout, lang, columns = request.layout, request.lang, request.page_columns
    axes = {
        "expansion": ExpansionAxis(request),
        "ratio": RatioAxis(layout, request.ratios, lang),
        "stroke": StrokeAxis(request),
        "angle": AngleAxis(layout, request.angles, lang),
        "target": TargetAxis(request),
        "column": ColumnAxis(layout, columns, request.ratios, lang),
    }
    axes = {name: axes[name] for name in SUBJECTS[layout.subject]}
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        return _cell(solved, columns[place["column"]], place)

    def unit(place: Place) -> Label:
        quantity = columns[place["column"]].quantity
        return "" if quantity.arc else quantity.unit

    return Grid(axes, cell, unit if layout.unit else None)


def _cell(solved: _Solved, column: EngineColumn, place: Place) -> Cell:
    if column.quantity.arc:
        minutes = solved.number(column._replace(decimals=0), place, 60)
        if minutes is not None:
            return Cell(f"${degrees_text(Fraction(minutes.scaled, 60))}$")
        degrees = solved.number(column._replace(decimals=0), place)
        return Cell(None if degrees is None else f"${degrees.scaled}°$")
    number = solved.number(column, place)
    marked = number is not None and solved.makes_delta(column, place)
    return Cell(number, (MAKES_DELTA,) if marked else ())


def _notes(solved: _Solved) -> Iterator[Note]:
    request = solved.request
    peaks = any(one.quantity.greatest is not None and not one.quantity.arc for one in request.page_columns)
    if peaks and len(request.spans) > 1 and request.layout.subject == "strokes":
        yield Note(engine_captions.WORDS["makes_delta"][request.lang], MAKES_DELTA)
    for line in engine_captions.notes(request):
        yield Note(line)
    if request.carded:
        yield from (Note(line) for line in _errors(solved))


def _errors(solved: _Solved) -> Iterator[Label]:
    """The errors of what is printed of whole turns, a line for each card and ratio."""
    request = solved.request
    target = {"target": 0} if request.flywheels else {}
    stroke = {"stroke": len(request.spans) - 1} if request.layout.subject == "strokes" else {}
    for expansion, ratio in product(range(len(request.steams)), range(len(request.ratios))):
        place = {"expansion": expansion, "ratio": ratio, **target, **stroke}
        errors = [
            (column.quantity, error_number(error))
            for column in request.page_columns
            if column.quantity.scope not in AT_ANGLE and not column.quantity.arc
            for error in [solved.error(column, place)]
            if error
        ]
        if errors:
            yield engine_captions.errors(request, expansion, ratio, errors)


def _fields(request: EngineRequest) -> tuple[Field, ...]:
    axes = engine_captions.axis_fields(request)
    fields = axes | {column.key: engine_captions.field(request, column) for column in request.page_columns}
    for column in request.page_columns:
        fields[column.key + ERROR] = engine_captions.error_field(request, column)
    return tuple(fields[key] for key in _names(request))


def _names(request: EngineRequest) -> tuple[str, ...]:
    own = tuple(column.key for column in request.page_columns)
    names = request.columns or (*request.axis_keys, *own)
    if not request.carded:
        return names
    # Of a card each value is followed by its error.
    return tuple(each for name in names for each in ((name, name + ERROR) if name in own else (name,)))


@dataclass(frozen=True)
class _Rows:
    """The records: one for each engine and stroke, angle or flywheel, computed as they are asked for."""

    solved: _Solved

    def __len__(self) -> int:
        return len(self.solved.request)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        request = self.solved.request
        names = _names(request)
        columns = {column.key: column for column in request.page_columns}
        engine = None
        for place in self._places():
            if engine != (place["expansion"], place["ratio"]):
                engine = (place["expansion"], place["ratio"])
                self.solved.turns.clear()
            axes = self._axes(place)
            yield tuple(axes[name] if name in axes else self._value(columns, name, place) for name in names)

    def _value(self, columns: Mapping[str, EngineColumn], name: str, place: Place) -> Value:
        if name in columns:
            return self.solved.number(columns[name], place)
        error = self.solved.error(columns[name.removesuffix(ERROR)], place)
        return None if error is None else error_number(error)

    def _places(self) -> Iterator[Place]:
        request = self.solved.request
        sizes = {
            "expansion": len(request.steams),
            "ratio": len(request.ratios),
            "stroke": len(request.spans),
            "angle": len(request.angles),
            "target": len(request.flywheels),
        }
        names = [name for name in SUBJECTS[request.layout.subject] if name != "column"]
        for indices in product(*(range(sizes[name]) for name in names)):
            yield dict(zip(names, indices, strict=True))

    def _axes(self, place: Place) -> dict[str, Value]:
        request = self.solved.request
        axes: dict[str, Value] = {
            request.axis_keys[0]: expansion_value(request, place["expansion"]),
            "ratio": f"${ratio_text(request.ratios[place['ratio']])}$",
        }
        if "stroke" in place:
            axes["stroke"] = SPANS[request.spans[place["stroke"]]][0]
        if "angle" in place:
            axes["phi"] = angle_number(request.angles[place["angle"]], request.angle_decimals)
        if "target" in place:
            axes["target"] = angle_number(request.flywheels[place["target"]].irregularity, None)
        return axes
