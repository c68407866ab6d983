"""The pages of steam engines: how evenly they turn, and what forces act in them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from kurbel.engine import captions
from kurbel.engine.axes import LoadAxis, stroke_axis, target_axis
from kurbel.engine.digits import Asked, error_number, estimate, estimated, settled
from kurbel.engine.engine import Steam
from kurbel.engine.quantities import EXTREMES, WHOLE, applies, engine_registry
from kurbel.engine.request import EngineRequest
from kurbel.exact.numerals import Number
from kurbel.motion.page import long_records
from kurbel.page.axes import AngleAxis, Axis, ColumnAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Quantity
from kurbel.page.subject import OVER_AXES, Subject

# What the key of a value of a card has in addition for its error.
ERROR = "_error"


def _number(request: EngineRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number at a place, None where the column says nothing of it."""
    where = request.where(place)
    if not applies(column.quantity, where):
        return None
    turns = [request.turn(place["expansion"], place["ratio"], one) for one in column.methods]
    asked = Asked(column, turns, where, times)
    if column.key.endswith(ERROR):
        return error_number(estimate(asked).error)
    return estimated(asked, request.rounding) if request.carded else settled(asked, request.rounding)


def _marks(request: EngineRequest, column: Column, place: Place) -> tuple[str, ...]:
    """The mark of the extreme of a stroke that is the extreme of the turn."""
    quantity, stroke = column.quantity, request.where(place).stroke
    if (
        quantity.of not in EXTREMES
        or quantity.minutes
        or stroke is WHOLE
        or not captions.marks_delta(request)
    ):
        return ()
    turn = request.turn(place["expansion"], place["ratio"], column.methods[0])
    marked = stroke in (one.stroke for one in turn.peaks(EXTREMES[quantity.of]))
    return (captions.MAKES_DELTA,) if marked and request.number(column, place) is not None else ()


def errors_beside(request: EngineRequest, column: Column) -> tuple[Column, ...]:
    """Of a card each value is followed by its error."""
    if not request.carded:
        return ()
    name = {lang: f"{captions.ERRORS[lang]}: {own}" for lang, own in column.quantity.name.items()}
    return (
        column._replace(key=column.key + ERROR, quantity=column.quantity._replace(name=name), decimals=None),
    )


def _listed() -> Iterator[tuple[str, Quantity]]:
    """Yield the quantities of all these pages in their order, each with the first command that prints it."""
    for one in engine_registry().values():
        yield next(page.command for page in PAGES if one.of in page.of), one


def _subject(
    key: str,
    layout: str,
    command: str,
    of: tuple[str, ...],
    drawn: str = OVER_AXES,
    **inner: Callable[[Any], Axis],
) -> Subject:
    """Return pages of quantities that are `of` one of these, with an inner axis or none."""
    return Subject(
        key=key,
        layout=layout,
        command=command,
        axes={"expansion": LoadAxis, "ratio": RatioAxis, **inner, "column": ColumnAxis},
        axis_keys=("epsilon", "ratio", *("phi" if name == "angle" else name for name in inner)),
        quantities=engine_registry,
        number=_number,
        caption=captions.caption,
        notes=captions.notes,
        of=of,
        marks=_marks,
        beside=errors_beside,
        listed=_listed if key == "irregularity" else tuple,
        rows=long_records if "angle" in inner else None,
        letters=True,
        limits={"expansion": Steam},
        drawn=drawn,
    )


_EFFORT, _FORCES = "kurbel.plot.engine:effort", "kurbel.plot.engine:forces"
_OF_TURNS, _OF_CRANKS = ("turn", *EXTREMES), ("crank", "angle")
_OF_STROKES = (*_OF_TURNS, "stroke")
IRREGULARITY = _subject("irregularity", "weisbach-150", "delta", _OF_TURNS)
STROKES = _subject("strokes", "delta-detail", "delta --detail", _OF_STROKES, stroke=stroke_axis)
COMPRESSOR = _subject("compressor", "compressor", "delta", _OF_TURNS)
PUMP = _subject("pump", "pump", "delta", _OF_STROKES, stroke=stroke_axis)
GAS_CYCLE = _subject("gas cycle", "gas-cycle", "delta", _OF_TURNS)
TURNING = _subject("turning", "turning", "turning", ("angle", "turn"), _EFFORT, angle=AngleAxis)
CRANK_FORCES = _subject("crank forces", "engine-forces", "forces", _OF_CRANKS, _FORCES, angle=AngleAxis)
MACHINE = _subject("machine", "machine-forces", "forces", _OF_CRANKS, _FORCES, angle=AngleAxis)
FLYWHEEL = _subject("flywheel", "flywheel", "flywheel", ("flywheel",), _EFFORT, target=target_axis)
PAGES = (IRREGULARITY, STROKES, TURNING, CRANK_FORCES, MACHINE, FLYWHEEL)
