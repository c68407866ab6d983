"""What the pages of turning-moment diagrams can show: torques, the energy, and the speed of a flywheel.

A kernel takes what is asked for, where, and the kind of number. Where is a crank angle in degrees; of areas
it is what of them lies above the mean line.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, Protocol

from kurbel.drive.crank import known
from kurbel.engine.diagram.areas import Areas
from kurbel.engine.diagram.excess import Excess
from kurbel.engine.diagram.steady import Steady
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Formula, Quantity, entry, words

INERTIA, RUN, SCALE = "inertia", "run", "scale"


class OfTorques(Protocol):
    """What is asked of torques: their excess, and the flywheel as far as it is known."""

    @property
    def excess(self) -> Excess: ...
    @property
    def inertia(self) -> Fraction | None: ...
    @property
    def steady(self) -> Steady | None: ...


class OfAreas(Protocol):
    """The same of areas."""

    @property
    def areas(self) -> Areas: ...
    @property
    def steady(self) -> Steady | None: ...


@cache
def torque_registry() -> Mapping[str, Quantity]:
    """Return what is known of torques at a crank angle, by its key."""
    return {one.key: one for one in _of_torques()}


@cache
def areas_registry() -> Mapping[str, Quantity]:
    """Return what is known of areas at the points between them, by its key."""
    return {one.key: one for one in _of_areas()}


def _entry(
    key: str, name: str, symbol: Label, unit: Label, kernel: Callable[..., Any], **rest: Any
) -> Quantity:
    return entry(key, name, symbol, unit, None, {"exact": Formula(kernel)}, spanners=(words(name),), **rest)


def _of_torques() -> Iterator[Quantity]:
    yield _entry("torque", "Drehmoment|Torque", "$T$", "N m", _torque)
    yield _entry("load_torque", "Lastmoment|Torque of the load", "$T_L$", "N m", _load)
    yield _entry("excess_torque", "Überschuss|Excess torque", "$T - T_L$", "N m", _excess)
    yield _entry("excess_energy", "Überschussarbeit|Excess energy", "$W$", "J", _energy)
    yield from _speeds(lambda asked, where, kind: known(asked.steady).at(_energy(asked, where, kind), kind))
    yield _entry(
        "angular_acceleration", "Winkelbeschleunigung|Angular acceleration", "$α$", '$"rad"/"s"^2$',
        lambda asked, where, kind: _excess(asked, where, kind) / kind.of(known(asked.inertia)), needs=INERTIA,
    )  # fmt: skip


def _of_areas() -> Iterator[Quantity]:
    name = "Fläche über der Mittellinie|Area above the mean line"
    yield _entry("level", name, "$A$", "", lambda asked, where, kind: kind.of(where), needs=SCALE)
    yield _entry("excess_energy", "Überschussarbeit|Excess energy", "$W$", "J", _energy_of_area)
    yield from _speeds(
        lambda asked, where, kind: known(asked.steady).at(_energy_of_area(asked, where, kind), kind)
    )


def _speeds(omega: Callable[..., Any]) -> Iterator[Quantity]:
    name = "Winkelgeschwindigkeit|Angular velocity"
    yield _entry("omega", name, "$ω$", "rad/s", omega, needs=RUN)
    yield _entry(
        "rpm", "Drehzahl|Speed", "$n$", '$"min"^(-1)$',
        lambda asked, where, kind: 30 * omega(asked, where, kind) / kind.pi, needs=RUN,
    )  # fmt: skip


def _torque(asked: OfTorques, where: Fraction, kind: Kind) -> Any:
    return asked.excess.torque(asked.excess.drive, where, kind)


def _load(asked: OfTorques, where: Fraction, kind: Kind) -> Any:
    return asked.excess.torque(asked.excess.load, where, kind)


def _excess(asked: OfTorques, where: Fraction, kind: Kind) -> Any:
    return asked.excess.torque(asked.excess.excess, where, kind)


def _energy(asked: OfTorques, where: Fraction, kind: Kind) -> Any:
    return asked.excess.energy(where, kind)


def _energy_of_area(asked: OfAreas, where: Fraction, kind: Kind) -> Any:
    return asked.areas.energy(where, kind)
