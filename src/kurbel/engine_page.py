"""Engines and a layout become a table: its grid for the page, its records for programs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

from kurbel import engine_captions
from kurbel.arrange import Grid, Place, check_size, panels
from kurbel.axes import AngleAxis, ColumnAxis, RatioAxis
from kurbel.engine_axes import ExpansionAxis, StrokeAxis, TargetAxis, expansion_value, irregularity_label
from kurbel.engine_digits import estimated, settled
from kurbel.engine_quantities import SPANS, WHOLE, Where
from kurbel.engine_request import EngineColumn, EngineRequest
from kurbel.layouts import SUBJECTS
from kurbel.notation import ratio_text
from kurbel.numerals import degrees_text
from kurbel.rows import angle_decimals, angle_number
from kurbel.table import Cell, Field, Label, Note, Number, Records, Table, Value
from kurbel.turn import Turn, turn_of

if TYPE_CHECKING:
    from kurbel.card_turn import CardTurn

# The mark of the two extremes that make δ.
MAKES_DELTA = "a"


def build_engine(request: EngineRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    solved = _Solved(request)
    return Table(
        key=request.label or request.layout.key,
        layout=request.layout.key,
        lang=request.lang,
        caption=engine_captions.caption(request),
        panels=panels(request.layout, _grid(solved)) if pages else (),
        records=Records(_fields(request), _Rows(solved)),
        notes=tuple(_notes(solved)),
        source=request.layout.source[request.lang],
    )


@dataclass(frozen=True)
class _Solved:
    """A request with the turns of its engines, each solved once."""

    request: EngineRequest
    turns: dict[tuple[int, int, str], Turn | CardTurn] = field(default_factory=dict)

    def turn(self, expansion: int, ratio: int, method: str) -> Turn | CardTurn:
        key = (expansion, ratio, method)
        if key not in self.turns:
            self.turns[key] = turn_of(self.request.engines[expansion][ratio], method)
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
        if self.request.carded:
            return estimated(column, turns, where, unit)  # type: ignore[arg-type]
        return settled(column, turns, where, self.request.rounding, unit)  # type: ignore[arg-type]

    def makes_delta(self, column: EngineColumn, place: Place) -> bool:
        """Whether this is the extreme of a stroke that is the extreme of the turn."""
        stroke = self.where(place).stroke
        if column.quantity.key not in ("v_min", "v_max") or stroke is WHOLE:
            return False
        turn = self.turn(place["expansion"], place["ratio"], column.methods[0])
        return stroke in turn.extreme_strokes(column.quantity.key == "v_max")


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
    return Cell(solved.number(column, place), (MAKES_DELTA,) if solved.makes_delta(column, place) else ())


def _notes(solved: _Solved) -> Iterator[Note]:
    request = solved.request
    if request.layout.subject == "strokes" and request.first.plain:
        yield Note(engine_captions.WORDS["makes_delta"][request.lang], MAKES_DELTA)
    for line in engine_captions.notes(request):
        yield Note(line)
    if request.layout.subject == "turning":
        yield from (Note(line) for line in _mean_forces(solved))


def _mean_forces(solved: _Solved) -> Iterator[Label]:
    """P of each engine, from which the excess of the page is counted."""
    from kurbel.engine_quantities import engine_registry

    request = solved.request
    quantity = engine_registry()["mean_force"]
    column = EngineColumn("mean_force", quantity, request.methods or ("exact",), quantity.decimals, (), ())
    for expansion, ratio in product(range(len(request.engines)), range(len(request.ratios))):
        number = solved.number(column, {"expansion": expansion, "ratio": ratio})
        if number is not None:
            yield engine_captions.mean_force(request, expansion, ratio, number)


def _fields(request: EngineRequest) -> tuple[Field, ...]:
    axes = engine_captions.axis_fields(request, angle_decimals(request.angles))
    columns = {
        column.key: Field(
            column.key,
            column.quantity.name[request.lang],
            column.quantity.symbol,
            engine_captions.unit_text(column.quantity.unit),
            column.decimals,
            " - ".join(column.methods),
        )
        for column in request.page_columns
    }
    return tuple(axes.get(key) or columns[key] for key in _names(request))


def _names(request: EngineRequest) -> tuple[str, ...]:
    own = tuple(column.key for column in request.page_columns)
    return request.columns or (*request.axis_keys, *own)


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
        for place in self._places():
            axes = self._axes(place)
            yield tuple(
                axes[name] if name in axes else self.solved.number(columns[name], place) for name in names
            )

    def _places(self) -> Iterator[Place]:
        request = self.solved.request
        sizes = {
            "expansion": len(request.engines),
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
            axes["phi"] = angle_number(request.angles[place["angle"]], angle_decimals(request.angles))
        if "target" in place:
            axes["delta"] = irregularity_label(request.flywheels[place["target"]].irregularity)
        return axes
