"""The pages of turning-moment diagrams without an engine: over the crank angle, or at the ends of areas.

A kernel takes what is asked for, where, and the kind of number. Where is a crank angle in degrees; of areas
it is what of them lies above the mean line.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property

from kurbel.drive.at import known
from kurbel.drive.crank import check_angles
from kurbel.engine.diagram.excess import ExcessTorque, acceleration_line
from kurbel.engine.diagram.fluctuation import Areas, Fluctuation, Steady, outcome
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats, settled
from kurbel.exact.numerals import Label, Number, figure, figures
from kurbel.exact.real import Product
from kurbel.kernel.circle import Numeric
from kurbel.motion.notes import turns_label
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, entry, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount, digits, unit_of_page
from kurbel.reading.units import Speed

WORDS = Texts("engine.diagram", "diagram")

INERTIA = Need(lambda question: question.inertia is not None, ("--inertia",))
RUN = Need(lambda question: question.steady is not None, ("--inertia", "--speed"))
SCALE = Need(lambda question: not question.areas.measured, ("--area-scale",))
TORQUES, AREAS = "torques", "areas"
POINT = words("Punkt|Point")


# Key, name, symbol, unit, kernel and what it needs: of the energy, of torques with that, of areas with that.
_ENERGY: tuple[tuple[str, str, str, str, Callable[..., Numeric], *tuple[Need, ...]], ...] = (
    ("excess_energy", "Überschussarbeit|Excess energy", "$W$", "J",
     lambda asked, where, kind: asked.swinging.energy(where, kind)),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s",
     lambda asked, where, kind: asked.omega(where, kind), RUN),
    ("rpm", "Drehzahl|Speed", "$n$", '$"min"^(-1)$',
     lambda asked, where, kind: 30 * asked.omega(where, kind) / kind.pi, RUN),
)  # fmt: skip
_TORQUES = (
    ("torque", "Drehmoment|Torque", "$T$", "N m",
     lambda asked, where, kind: asked.excess.torque(asked.excess.drive, where, kind)),
    ("load_torque", "Lastmoment|Torque of the load", "$T_L$", "N m",
     lambda asked, where, kind: asked.excess.torque(asked.excess.load, where, kind)),
    ("excess_torque", "Überschuss|Excess torque", "$T - T_L$", "N m",
     lambda asked, where, kind: asked.excess.torque(asked.excess.excess, where, kind)),
    *_ENERGY,
    ("angular_acceleration", "Winkelbeschleunigung|Angular acceleration", "$α$", '$"rad"/"s"^2$',
     lambda asked, where, kind:
     asked.excess.torque(asked.excess.excess, where, kind) / kind.of(asked.inertia), INERTIA),
)  # fmt: skip
_AREAS = (
    ("level", "Fläche über der Mittellinie|Area above the mean line", "$A$", "",
     lambda asked, where, kind: kind.of(where), SCALE),
    *_ENERGY,
)  # fmt: skip


@cache
def torque_registry() -> Mapping[str, Quantity]:
    """Return what is known of torques at a crank angle, by its key."""
    return {row[0]: _entry(*row) for row in _TORQUES}


@cache
def areas_registry() -> Mapping[str, Quantity]:
    """Return what is known of areas at the points between them, by its key."""
    return {row[0]: _entry(*row) for row in _AREAS}


def _entry(
    key: str, name: str, symbol: Label, unit: Label, kernel: Callable[..., Numeric], *needs: Need
) -> Quantity:
    formulas = {"exact": Formula(kernel)}
    return entry(key, name, symbol, unit, None, formulas, spanners=(words(name),), needs=needs)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class DiagramRequest(Question, ABC):
    """What is asked for of a diagram, with the flywheel and its mean speed as far as they are known."""

    inertia: Fraction | None = None
    speed: Speed | None = None

    def __post_init__(self) -> None:
        if self.inertia is not None and self.inertia <= 0:
            raise ProblemError(f"the moment of inertia is {figure(self.inertia)} kg m²; it must be above 0")
        super().__post_init__()

    @property
    @abstractmethod
    def swinging(self) -> Fluctuation:
        """What has the swing."""

    @cached_property
    def swing(self) -> float:
        """About the swing of the energy in J, by which columns have their figures."""
        return float(self.swinging.swing(floats()))

    @cached_property
    def steady(self) -> Steady | None:
        """The flywheel in steady state, where it and its speed are known."""
        if self.inertia is None or self.speed is None:
            return None
        return Steady(self.swinging, self.inertia, self.speed)

    def omega(self, where: Fraction, kind: Kind) -> Numeric:
        """Return the angular velocity in 1/s."""
        return known(self.steady).at(self.swinging.energy(where, kind), kind)

    def flywheel(self) -> Iterator[Label]:
        """Yield the line about the flywheel and its speed."""
        lang = self.lang
        if self.inertia is None:
            yield from () if self.speed is None else (turns_label(self.speed),)
        elif self.speed is None:
            yield WORDS["mass"][lang].format(inertia=amount(self.inertia, "kg m²"))
        else:
            said = WORDS["run"][lang]
            yield said.format(inertia=amount(self.inertia, "kg m²"), speed=turns_label(self.speed))


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class TorquesRequest(DiagramRequest):
    """What is asked for of torques at crank angles."""

    excess: ExcessTorque
    angles: Sequence[Fraction] = (Fraction(0),)
    # What was not given and is the mean of the other, "load" or "drive"; and the cranks of one diagram.
    constant: str = ""
    cranks: Sequence[Fraction] = ()

    no_column = "there is no column beside the angle; add one, such as excess_energy"

    def check(self) -> None:
        check_angles(self.angles)

    @property
    def swinging(self) -> ExcessTorque:
        return self.excess


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class AreasRequest(DiagramRequest):
    """What is asked for of areas at the points between them."""

    areas: Areas

    no_column = "there is no column beside the points; add one, such as excess_energy"

    @property
    def swinging(self) -> Areas:
        return self.areas

    def missing(self, quantity: Quantity) -> str:
        if SCALE in quantity.needs and self.lacks(SCALE):
            return f"column {quantity.key} is of areas with a scale; these are energies, add --area-scale"
        return super().missing(quantity)


_SPEEDS = {"omega": 1.0, "rpm": 30 / math.pi}


def _most(question: DiagramRequest, key: str) -> float:
    """Return a bound of a quantity's magnitude, by which a column has its figures."""
    if key in _SPEEDS:
        return float(known(question.steady).mean(floats())) * _SPEEDS[key]
    if key == "excess_energy" or not isinstance(question, TorquesRequest):
        return question.swing
    excess = question.excess
    of_torque = {"torque": excess.drive, "load_torque": excess.load}
    most = excess.greatest_torque(of_torque.get(key, excess.excess))
    return most / float(known(question.inertia)) if key == "angular_acceleration" else most


def _number(question: TorquesRequest | AreasRequest, column: Column, place: Place, times: int) -> Number:
    """The printed number at a crank angle, or at a point between areas."""
    quantity, decimals = column.quantity, column.decimals
    if isinstance(question, TorquesRequest):
        where = question.angles[place["angle"]]
    else:
        where = question.areas.levels[place["point"]]
        if quantity.key == "level" and decimals is None:
            decimals = question.areas.level_decimals
    kernel = quantity.formulas["exact"].kernel
    decimals = figures(_most(question, quantity.key)) if decimals is None else decimals
    return Number(
        settled(lambda kind: times * kernel(question, where, kind), decimals, question.rounding), decimals
    )


def _point_axis(question: AreasRequest) -> ListAxis:
    field = Field("point", POINT[question.lang])
    return ListAxis(question.areas.letters, field, lambda letter: f"${letter}$", lambda letter: f"${letter}$")


def _caption(question: DiagramRequest) -> Label:
    return question.layout.caption[question.lang]


def _torque_notes(question: TorquesRequest) -> Iterator[Label]:
    lang, excess = question.lang, question.excess
    yield WORDS["signs"][lang]
    yield "; ".join(_taken(question))
    yield from question.flywheel()
    yield from outcome(excess, question.speed, question.steady, lang)
    if question.inertia is not None:
        yield from acceleration_line(excess, [Product.of(question.inertia)], question.rounding, lang)


def _taken(question: TorquesRequest) -> Iterator[Label]:
    lang, excess = question.lang, question.excess
    if question.constant:
        yield WORDS[question.constant][lang]
    if any(one.slope for torque in (excess.drive, excess.load) for one in torque.lines):
        yield WORDS["triangles" if excess.by_degree else "lines"][lang]
    if excess.excess.jumps:
        yield WORDS["jumps"][lang]
    if question.cranks:
        angles = "; ".join(f"${figure(one)}°$" for one in question.cranks)
        yield WORDS["cranks"][lang].format(angles=angles)
    one = excess.turns == 1
    yield WORDS["one_cycle"][lang] if one else WORDS["cycle"][lang].format(turns=excess.turns)


def _area_notes(question: AreasRequest) -> Iterator[Label]:
    lang, areas = question.lang, question.areas
    yield WORDS["area_signs"][lang]
    if not areas.measured:
        times, unit = unit_of_page("J")
        pi = " π" if areas.scale.of_pi else ""
        yield WORDS["scale"][lang].format(scale=f"{digits(areas.scale.energy, times)}{pi} {unit}")
    yield from question.flywheel()
    yield from outcome(areas, question.speed, question.steady, lang)


OF_TORQUES = Subject(
    key=TORQUES,
    layout="torques",
    command="turning --torque T",
    axes={"angle": AngleAxis, "column": ColumnAxis},
    axis_keys=("phi",),
    quantities=torque_registry,
    number=_number,
    caption=_caption,
    notes=_torque_notes,
    letters=True,
    drawn="kurbel.plot.diagrams:torques",
)


OF_AREAS = Subject(
    key=AREAS,
    layout="areas",
    command="turning --areas AREAS",
    axes={"point": _point_axis, "column": ColumnAxis},
    axis_keys=("point",),
    quantities=areas_registry,
    number=_number,
    caption=_caption,
    notes=_area_notes,
    letters=True,
)
