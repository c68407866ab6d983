"""Engines and a layout become a table of the harmonics of their tangential force.

One page has those of a cylinder and of the engine; the excitation has those of every cylinder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

from kurbel.balancing.harmonics import MOST_ORDERS, ORDER
from kurbel.engine.captions import caption
from kurbel.engine.cylinder import Member, members_of
from kurbel.engine.digits import ERROR, error_number
from kurbel.engine.engine_page import LoadAxis, errors_beside
from kurbel.engine.harmonics.fourier import Spectrum, spectrum_of
from kurbel.engine.harmonics.harmonic import SPEED, STAR, At, estimate, number_of, registry
from kurbel.engine.loads.steam import Steam
from kurbel.engine.notes import from_dead_centre, notes
from kurbel.engine.request import EngineRequest
from kurbel.engine.texts import HARMONICS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.page.axes import Axis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.quantity import Column
from kurbel.page.subject import Subject
from kurbel.page.table import Field, Note, Value
from kurbel.reading.notation import plain
from kurbel.reading.units import Speed

WHOLE = "all"
EXCITATION = "excitation"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class TorqueRequest(EngineRequest):
    """What is asked for: the harmonics of the tangential force up to an order."""

    last_order: int = 6
    speed: Speed | None = None

    def check(self) -> None:
        super().check()
        if self.layout.subject == EXCITATION and not self.columns:
            for column in self.layout.columns:
                if missing := self.missing(self.entry(column.quantity)):
                    raise ProblemError(missing)
        if not isinstance(self.last_order, int) or not 1 <= self.last_order <= MOST_ORDERS:
            raise ProblemError(
                f"orders up to {str(self.last_order)[:20]} were asked for; the last must be a whole number"
                f" from 1 to {MOST_ORDERS}"
            )

    @cached_property
    def orders(self) -> tuple[Fraction, ...]:
        """The orders, in cycles of two turns in steps of ½."""
        step = Fraction(2, self.turn(0, 0, (self.methods or ("exact",))[0]).cycle)
        return tuple(step * index for index in range(1, int(self.last_order / step) + 1))

    @cached_property
    def members(self) -> tuple[Member, ...]:
        """The cylinders that the page is about, one of those that are alike, and after them the engine."""
        every = members_of(self.first)
        if self.layout.subject == EXCITATION:
            return every
        if len(every) == 1:
            return (Member(0),)
        return (*(every[:1] if self.alike else every), Member(0))

    @property
    def alike(self) -> bool:
        return len(self.first.parts) == 1

    @cached_property
    def spectrum(self) -> Callable[[int, int, str], Spectrum]:
        """Return the harmonics of an engine by a method; the latest are kept."""
        return lru_cache(64)(lambda steam, drive, method: spectrum_of(self.turn(steam, drive, method)))

    def at(self, place: Place, method: str) -> At:
        spectrum = self.spectrum(place["expansion"], place["ratio"], method)
        return At(spectrum, self.members[place["cylinder"]], self.orders[place["order"]], self.speed)


def _number(request: TorqueRequest, column: Column, place: Place, times: int) -> Value:
    at = request.at(place, column.method)
    if not column.key.endswith(ERROR):
        return number_of(column, at, request.rounding)
    return error_number(estimate(column, at).error) if at.wave else None


def _beside(request: TorqueRequest, column: Column) -> tuple[Column, ...]:
    return () if {STAR, SPEED}.intersection(column.quantity.needs) else errors_beside(request, column)


class _OrderAxis(ListAxis):
    """The orders, whole ones or halves."""

    def __init__(self, request: TorqueRequest) -> None:
        name = ORDER[request.lang]
        self.decimals = max(int(order.denominator > 1) for order in request.orders)
        super().__init__(
            request.orders,
            Field("order", name, "$k$", "", self.decimals),
            lambda order: nearest(order, self.decimals),
            lambda order: f"$k = {plain(order)}$",
            f"{name} $k$",
        )

    def stub(self, place: Place) -> Number:
        return nearest(self._things[place["order"]], self.decimals)


def _member_axis(request: TorqueRequest) -> ListAxis:
    lang = request.lang

    def head(member: Member) -> Label:
        return (
            HARMONICS["one"][lang].format(number=member.number) if member.number else HARMONICS["whole"][lang]
        )

    return ListAxis(
        request.members,
        Field("cylinder", HARMONICS["member"][lang]),
        lambda member: Number(member.number, 0) if member.number else WHOLE,
        head,
    )


def _notes(request: TorqueRequest) -> Iterator[Label | Note]:
    lang = request.lang
    regular = from_dead_centre(request, (request.methods or ("exact",))[0])
    yield HARMONICS["sum"][lang].replace("{begin}", HARMONICS["dead_centre" if regular else "slide"][lang])
    if any(STAR in column.quantity.needs for column in request.page_columns):
        yield HARMONICS["star"][lang]
    yield from notes(request)
    yield HARMONICS["zero"][lang]


def _subject(key: str, layout: str, axes: Mapping[str, Callable[[Any], Axis]]) -> Subject:
    names = {"expansion": "epsilon"}
    return Subject(
        key=key,
        layout=layout,
        command="harmonics --quantity torque",
        axes={**axes, "column": ColumnAxis},
        axis_keys=tuple(names.get(name, name) for name in axes),
        quantities=registry,
        number=_number,
        caption=caption,
        notes=_notes,
        beside=_beside,
        listed=None if key != EXCITATION else tuple,
        letters=True,
        limits={"expansion": Steam},
    )


_AXES: Mapping[str, Callable[[Any], Axis]] = {
    "expansion": LoadAxis, "ratio": RatioAxis, "cylinder": _member_axis, "order": _OrderAxis,
}  # fmt: skip


TORQUE = _subject("torque", "torque-harmonics", _AXES)


EXCITING = _subject(EXCITATION, EXCITATION, _AXES)
