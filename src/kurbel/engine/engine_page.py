"""The pages of engines and driven machines, their axes and the numbers on them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from kurbel.engine.captions import caption, load_label, named_load
from kurbel.engine.cylinder import WHOLE
from kurbel.engine.digits import ERROR, CellValue, printed
from kurbel.engine.engine_quantities import EXTREMES, SPANS, applies, engine_registry
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.notes import ERRORS, MAKES_DELTA, marks_delta, notes
from kurbel.engine.request import EngineRequest
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.motion.bulk import long_records
from kurbel.page.axes import (
    AngleAxis,
    Axis,
    ColumnAxis,
    ListAxis,
    Place,
    RatioAxis,
    angle_decimals,
    angle_number,
    irregularity_label,
)
from kurbel.page.quantity import Column, Of, Quantity, words
from kurbel.page.subject import OVER_AXES, Subject
from kurbel.page.table import Field

if TYPE_CHECKING:
    from kurbel.engine.power.power_page import PowerRequest

STROKE = words("Hub|Stroke")
TARGET = words("Ungleichförmigkeitsgrad, zulässiger|Degree of irregularity allowed")


class LoadAxis(Axis):
    """The loads: expansion ratios ε, pressure ratios Π, or the one card that stands in their place."""

    def __init__(self, request: EngineRequest | PowerRequest) -> None:
        super().__init__(len(request.steams))
        self.request, self.lang = request, request.lang
        self.words = request.words
        self.key = self.words.key

    @cached_property
    def decimals(self) -> int | None:
        """How many decimals write every number exactly, None if no number of them does, and of cards."""
        numbers = [self.words.number(load) for load in self.request.steams]
        known = [number for number in numbers if number is not None]
        return angle_decimals(known) if known else None

    def field(self) -> Field:
        return Field(self.key, self.words.name[self.lang], self.words.symbol, "", self.decimals)

    def value(self, place: Place) -> Number | Label:
        number = self.words.number(self.request.steams[place["expansion"]])
        if self.decimals is None or number is None:
            tag = self.words.tag
            return tag(self.request.steams[place["expansion"]]) if tag else self.heads(place)[0]
        return nearest(number, self.decimals)

    def stub(self, place: Place) -> Number | Label:
        return self.heads(place)[0] if self.words.tag else self.value(place)

    def stub_heading(self) -> Label:
        return " ".join(filter(None, (self.words.name[self.lang], self.words.symbol)))

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (load_label(self.request, place["expansion"]),)

    def over_group(self, place: Place) -> Label:
        return named_load(self.request, place["expansion"])


def stroke_axis(request: EngineRequest) -> ListAxis:
    """Outstroke, return stroke and the whole turn, as far as they have extremes of their own."""
    spans, lang = [SPANS[span] for span in request.spans], request.lang
    return ListAxis(spans, Field("stroke", STROKE[lang]), lambda one: one[0], lambda one: one[1][lang])


def target_axis(request: EngineRequest) -> ListAxis:
    """The degrees of irregularity that flywheels are to keep."""
    return ListAxis(
        [one.irregularity for one in request.flywheels],
        Field("target", TARGET[request.lang], "$δ$"),
        lambda target: angle_number(target, None),
        irregularity_label,
    )


def _number(request: EngineRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number at a place, None where the column says nothing of it."""
    where = request.where(place)
    if not applies(column.quantity, where):
        return None
    turns = [request.turn(place["expansion"], place["ratio"], one) for one in column.methods]
    return printed(CellValue(column, turns, where, times), request.rounding, request.carded)


def _marks(request: EngineRequest, column: Column, place: Place) -> tuple[str, ...]:
    """The mark of the extreme of a stroke that is the extreme of the turn."""
    quantity, stroke = column.quantity, request.where(place).stroke
    if quantity.of not in EXTREMES or quantity.minutes or stroke is WHOLE or not marks_delta(request):
        return ()
    turn = request.turn(place["expansion"], place["ratio"], column.methods[0])
    marked = stroke in (one.stroke for one in turn.peaks(EXTREMES[quantity.of]))
    return (MAKES_DELTA,) if marked and request.number(column, place) is not None else ()


def errors_beside(request: EngineRequest, column: Column) -> tuple[Column, ...]:
    """Of a card each value is followed by its error."""
    if not request.carded:
        return ()
    name = {lang: f"{ERRORS[lang]}: {own}" for lang, own in column.quantity.name.items()}
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
    of: tuple[Of, ...],
    drawn: str = OVER_AXES,
    **inner: Callable[[EngineRequest], Axis],
) -> Subject[EngineRequest]:
    """Return pages of quantities that are `of` one of these, with an inner axis or none."""
    return Subject(
        key=key,
        layout=layout,
        command=command,
        axes={"expansion": LoadAxis, "ratio": RatioAxis, **inner, "column": ColumnAxis},
        axis_keys=("epsilon", "ratio", *("phi" if name == "angle" else name for name in inner)),
        quantities=engine_registry,
        number=_number,
        caption=caption,
        notes=notes,
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


_OF_TURNS, _OF_CRANKS = (Of.TURN, *EXTREMES), (Of.CRANK, Of.ANGLE)


_OF_STROKES = (*_OF_TURNS, Of.STROKE)


IRREGULARITY = _subject("irregularity", "weisbach-150", "delta", _OF_TURNS)


STROKES = _subject("strokes", "delta-detail", "delta --detail", _OF_STROKES, stroke=stroke_axis)


COMPRESSOR = _subject("compressor", "compressor", "delta", _OF_TURNS)


PUMP = _subject("pump", "pump", "delta", _OF_STROKES, stroke=stroke_axis)


GAS_CYCLE = _subject("gas cycle", "gas-cycle", "delta", _OF_TURNS)


TURNING = _subject("turning", "turning", "turning", (Of.ANGLE, Of.TURN), _EFFORT, angle=AngleAxis)


CRANK_FORCES = _subject("crank forces", "engine-forces", "forces", _OF_CRANKS, _FORCES, angle=AngleAxis)


MACHINE = _subject("machine", "machine-forces", "forces", _OF_CRANKS, _FORCES, angle=AngleAxis)


FLYWHEEL = _subject("flywheel", "flywheel", "flywheel", (Of.FLYWHEEL,), _EFFORT, target=target_axis)


PAGES = (IRREGULARITY, STROKES, TURNING, CRANK_FORCES, MACHINE, FLYWHEEL)
