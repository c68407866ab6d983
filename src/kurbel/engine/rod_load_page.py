"""The page of the rod's load over a turn: its extremes and its reversal, at both ends of the rod."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from kurbel.drive.at import CRANK_FORCES
from kurbel.engine.captions import about_engines
from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.digits import ERROR, FLOAT_ERROR, error_number, supported
from kurbel.engine.engine_page import LoadAxis, errors_beside
from kurbel.engine.notes import notes
from kurbel.engine.request import EngineRequest
from kurbel.engine.rod_load import ENDS, SLIDE, RodLoad, end_entry, rod_quantities, sign_of
from kurbel.engine.turn import Turn, turn_ties
from kurbel.exact.certify import NEVER_TIES, TieBits, rounded
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Of, Texts, filled
from kurbel.page.subject import Subject
from kurbel.page.table import Field, Note

if TYPE_CHECKING:
    from kurbel.engine.card.force import CardTurn
    from kurbel.engine.rod_load_card import CardRodLoad

ROD_LOAD = Texts("engine", "rod_load")


KEPT_LOADS = 96
_REVERSAL = "reversal"


@lru_cache(KEPT_LOADS)
def rod_load(turn: AnyTurn, end: str) -> RodLoad | CardRodLoad:
    """Return the load of the rod at an end, one of ENDS, over a turn."""
    force = CRANK_FORCES[ENDS[end][0]]
    if turn.engine.carded:
        from kurbel.engine.rod_load_card import CardRodLoad

        return CardRodLoad(cast("CardTurn", turn), force)
    return RodLoad(cast("Turn", turn), force)


def _end_axis(request: EngineRequest) -> ListAxis:
    lang = request.lang
    return ListAxis(
        [*ENDS],
        Field("end", ROD_LOAD["end"][lang]),
        lambda end: end,
        lambda end: request.mechanism.named(end_entry(end)).name[lang],
    )


def _number(request: EngineRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number at a place, None where there is none, as no pull of a load that only thrusts."""
    turn = request.turn(place["expansion"], place["ratio"], column.method)
    asked = _Asked(column, rod_load(turn, [*ENDS][place["end"]]), times, request.rounding)
    if asked.value() is None:
        return None
    if not request.carded:
        return _settled(asked)
    if column.key.endswith(ERROR):
        return error_number(_error(asked))
    return _estimated(asked)


class _Asked(NamedTuple):
    """A column's value times `unit` of a load."""

    column: Column
    load: Any
    unit: int
    rounding: str

    @property
    def kernel(self) -> Callable[..., Numeric | None]:
        return self.column.quantity.formulas[self.column.method].kernel

    @property
    def scale(self) -> Numeric:
        """What makes the quantity's unit of the kernel's."""
        scale = self.column.quantity.scale
        return self.unit * (scale(self.load.turn) if scale else 1)

    def value(self) -> Any:
        found = self.kernel(self.load)
        return None if found is None else self.scale * found


def _settled(asked: _Asked) -> Number:
    """Return the value, rounded correctly."""
    quantity, decimals, load = asked.column.quantity, asked.column.places, asked.load
    found = asked.value()
    if isinstance(found, Fraction):
        return nearest(found, decimals, asked.rounding)
    ties: TieBits | None = NEVER_TIES
    if quantity.of is Of.FORCE:
        at = load.extreme(sign_of(quantity))
        if at.place.exact is not None:
            stroke, angle = at.segment.stroke, at.place.exact - at.segment.stroke
            scale = quantity.scale or (lambda turn: 1)
            ties = turn_ties(
                lambda turn: asked.unit * scale(turn) * turn.cylinder.force(load.force, stroke, angle),
                [load.turn],
            )
    return Number(rounded(asked.value, decimals, asked.rounding, ties), decimals)


def _error(asked: _Asked) -> float:
    """Return how far a value of a card may be off."""
    quantity, load = asked.column.quantity, asked.load
    if quantity.of is Of.FORCE:
        allowed = load.force_error(sign_of(quantity))
    elif quantity.of is Of.PLACE:
        allowed = 180 * load.place_error(sign_of(quantity))
    elif quantity.of is Of.SHARE:
        allowed = load.share_error()
    else:
        allowed = 180 * load.zero_error()
    error: float = float(abs(asked.scale)) * load.error(asked.kernel, allowed)
    return error + FLOAT_ERROR * (abs(float(asked.value())) + 1)


def _estimated(asked: _Asked) -> Number | None:
    """Return the same to as many decimals as the card supports, None if not one figure."""
    best, error, column = asked.value(), _error(asked), asked.column
    if error > abs(best) > 0:
        return None
    return supported(best, error, column.places, asked.rounding, column.quantity.minutes)


def _caption(request: EngineRequest) -> Label:
    """Return the layout's caption, whatever the columns: their names stand beside them."""
    methods = dict.fromkeys(column.method for column in request.page_columns)
    return filled(request.layout.caption[request.lang], about_engines(request, methods).items())


def _notes(request: EngineRequest) -> Iterator[Label | Note]:
    lang, columns = request.lang, request.page_columns
    shown = [column.quantity for column in columns]
    if any(one.of in (Of.FORCE, Of.PLACE) for one in shown):
        yield ROD_LOAD["directions"][lang]
    heavy = request.first.crank.moving is not None
    slide = request.mechanism.named(end_entry("slide")).direction or SLIDE
    yield slide[lang] + (ROD_LOAD["masses"][lang] if heavy else "")
    if sum(len(part.starts) for part in request.first.parts) > 1:
        yield ROD_LOAD["first"][lang]
    yield from notes(request)
    if any(one.key.startswith(_REVERSAL) for one in shown):
        yield ROD_LOAD["reversal"][lang]


SUBJECT = Subject(
    key="rod load",
    layout="rod-load",
    command="forces --eps 4 --layout rod-load",
    axes={"expansion": LoadAxis, "ratio": RatioAxis, "end": _end_axis, "column": ColumnAxis},
    axis_keys=("epsilon", "ratio", "end"),
    quantities=rod_quantities,
    number=_number,
    caption=_caption,
    notes=_notes,
    beside=errors_beside,
)
