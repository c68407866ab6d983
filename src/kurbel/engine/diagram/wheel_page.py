"""The pages of flywheels without an engine: a column for each irregularity that is to be kept."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kurbel.engine.diagram.excess import ExcessTorque, acceleration_line
from kurbel.engine.diagram.fluctuation import Extreme, Fluctuation, place_text
from kurbel.engine.diagram.relations import ACCELERATION, SHOWN, registry
from kurbel.engine.diagram.sizing import LIMIT, ONE_TURN, RIM_ALONE, SizedFlywheel
from kurbel.exact.numerals import Label, Number, figure, finite_decimals, number_text
from kurbel.exact.real import Product, Real
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_number, irregularity_label
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Quantity, Texts, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import unit_of_page
from kurbel.reading.notation import plain

OF_WHEELS = Texts("engine.diagram", "of_wheels")
SOURCES = Texts("engine.diagram", "sources")

ANGLE_DECIMALS = 2
# More places of one speed are left out.
MOST_ANGLES = 8
# A longer fraction is written as a decimal.
LONGEST = 9
TARGET = words("Ungleichförmigkeitsgrad, zulässiger|Degree of irregularity allowed")
VALUE = words("Wert|Value")


def caption(question: WheelRequest) -> Label:
    text = question.layout.caption[question.lang]
    if question.engine:
        return text.replace("{flywheel}", question.engine[0])
    return text.replace("{flywheel}", SOURCES[question.known_from][question.lang])


def notes(question: WheelRequest) -> Iterator[Label]:
    """Yield the lines below the table: its formulas, what was taken, where the speed is greatest."""
    lang, wheel = question.lang, question.wheels[0]
    if "delta" in wheel.figures and "rim_mass" in wheel.figures and "omega" not in wheel.figures:
        swing = "$ΔW$" if wheel.figures["rim_share"].value.rational == 1 else "$J_R/J ΔW$"
        yield OF_WHEELS["rim_speeds"][lang].replace("{swing}", swing)
    elif "delta" in wheel.figures:
        # Masses that move have an energy of their own, which varies.
        exactly = "" if question.engine else OF_WHEELS["exactly"][lang]
        yield OF_WHEELS["speeds"][lang].replace("{exactly}", exactly)
    if question.fluctuation is not None:
        yield from _places(question, question.fluctuation)
        yield from _accelerated(question)
        if question.angle is not None:
            yield OF_WHEELS["at angle"][lang].format(angle=figure(question.angle))
    if question.known_from in ("fluctuation", "torque") and "turns" in wheel.figures:
        yield _cycle(question)
    if question.press is not None:
        yield _press(*question.press, lang)
    if "run_up_time" in wheel.figures:
        yield OF_WHEELS["run_up"][lang]
    if "mass" in wheel.figures and "disc_diameter" not in wheel.figures:
        yield OF_WHEELS["mass"][lang]
    yield from _rim(question)
    yield from question.engine[1:]


def _cycle(question: WheelRequest) -> Label:
    """Return how long the cycle is whose work is W."""
    lang, turns = question.lang, question.wheels[0].figures["turns"].value
    said = OF_WHEELS["turn"] if turns.rational == 1 else OF_WHEELS["turns"]
    number = number_text(turns.number(None, question.rounding))
    usual = " (--turns)" if ONE_TURN in question.wheels[0].taken else ""
    return OF_WHEELS["cycle"][lang].format(turns=said[lang].format(turns=number)) + usual


def _press(working: Product | None, rest: Product, lang: str) -> Label:
    """Return what the motor gives while the press works."""
    if working is None:
        return OF_WHEELS["blow"][lang]
    return OF_WHEELS["press"][lang].format(share=_fraction(working), rest=_fraction(rest))


def _rim(question: WheelRequest) -> Iterator[Label]:
    lang, wheel = question.lang, question.wheels[0]
    said = [OF_WHEELS[key][lang] for key in (LIMIT, RIM_ALONE) if key in wheel.taken]
    turning = "omega" in wheel.figures
    formulas = [OF_WHEELS["stress"][lang]] if "rim_speed" in wheel.figures and turning else []
    formulas += [OF_WHEELS["rim"][lang]] if "rim_mass" in wheel.figures and turning else []
    if formulas:
        yield ", ".join(formulas)
    if "disc_diameter" in wheel.figures:
        yield OF_WHEELS["disc"][lang]
    if "disc_stress" in wheel.figures:
        poisson = wheel.figures["disc_bulge"].value.base * 8 - 3
        yield OF_WHEELS["disc_stress"][lang].format(poisson=figure(poisson))
    if "density" in wheel.figures:
        times, unit = unit_of_page("kg/m³")
        density = wheel.figures["density"].value * Product.of(times)
        number = number_text(density.number(None, question.rounding))
        said.insert(0, OF_WHEELS["density"][lang].format(density=number, unit=unit))
    if said:
        yield "; ".join(said)


def _places(question: WheelRequest, fluctuation: Fluctuation) -> Iterator[Label]:
    """Yield where the speed is greatest and where least."""
    high, low = (fluctuation.extremes(greatest=greatest) for greatest in (True, False))
    names = {"high": _listed(high, question), "low": _listed(low, question)}
    yield OF_WHEELS["places"][question.lang].format(**names)
    if high[0].letter:
        yield OF_WHEELS["letters"][question.lang]


def _accelerated(question: WheelRequest) -> Iterator[Label]:
    """Yield the greatest and the least angular acceleration, where torques are known."""
    inertias = [wheel.figures["inertia"].value for wheel in question.wheels if "inertia" in wheel.figures]
    if isinstance(question.fluctuation, ExcessTorque) and inertias:
        yield from acceleration_line(question.fluctuation, inertias, question.rounding, question.lang)


def _listed(places: Sequence[Extreme], question: WheelRequest) -> Label:
    first, *others = (place_text(one, ANGLE_DECIMALS, question.rounding) for one in places[:MOST_ANGLES])
    begun = f"${first}$" if places[0].letter else f"$φ = {first}$"
    more = ["..."] if len(places) > MOST_ANGLES else []
    return ", ".join([begun, *(f"${one}$" for one in others), *more])


def _fraction(product: Product) -> str:
    """Return a share as it stands in a formula: 0.25, 1/3, or to five figures."""
    value = product.rational
    if value is None or len(str(value)) > LONGEST:
        return number_text(product.number(None, "half-away"))
    return plain(value) if finite_decimals(value) is not None else f"{value.numerator}/{value.denominator}"


OF_RUN_UP = ("run_up_energy", "slip_energy")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class WheelRequest(Question):
    """What is asked for: flywheels by what is given, one for each of the irregularities to keep.

    Without any of these there is one flywheel. `known_from` says what the swing is known from; `fluctuation`
    is the diagram, if it is one, and `press` the share of its cycle in which a press works, None of a blow,
    with the rest. `engine` are the caption and the lines of an engine, of which the swing is. `angle` is
    where on the diagram the angular acceleration is asked for, in degrees.
    """

    wheels: tuple[SizedFlywheel, ...]
    targets: tuple[Fraction, ...] = ()
    known_from: str = ""
    fluctuation: Fluctuation | None = None
    press: tuple[Product | None, Product] | None = None
    engine: tuple[Label, ...] = ()
    angle: Fraction | None = None

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return super().axis_keys if self.targets else ()

    def missing(self, quantity: Quantity) -> str:
        options = ", ".join(quantity.options) if any(map(self.lacks, quantity.needs)) else ""
        sentence = f"column {quantity.key} does not follow from what is given; add what it needs of {options}"
        return options and sentence

    def shows(self, column: LayoutColumn) -> bool:
        # Where its turns are known, the speed says how many cycles there are.
        turns = self.wheels[0].figures.get("turns")
        by_turns = turns is not None and turns.options in ((), ("--turns",), ("the torque",))
        # The energy is that of any flywheel, and stands where one runs up.
        idle = OF_RUN_UP if "run_up_time" not in self.wheels[0].figures else ()
        return super().shows(column) and column.key not in (*idle, *(("strokes",) if by_turns else ()))


def _target_axis(question: WheelRequest) -> ListAxis:
    """The irregularities to keep, or the one flywheel."""
    field = Field("target", TARGET[question.lang], "$δ$")
    if not question.targets:
        return ListAxis([None], field, lambda one: None, lambda one: VALUE[question.lang], "")
    return ListAxis(
        question.targets,
        field,
        lambda target: angle_number(target, None),
        lambda target: f"$δ = {irregularity_label(target).strip('$')}$",
        "",
    )


def _number(question: WheelRequest, column: Column, place: Place, times: int) -> Number | None:
    quantity, figures = column.quantity, question.wheels[place["target"]].figures
    if quantity.key == ACCELERATION:
        return _acceleration(question, column, figures["inertia"].value).number(
            column.decimals, question.rounding
        )
    sized = figures.get(SHOWN[quantity.key].figure)
    if sized is None:
        return None
    # In other units than its own the quantity's is a multiple.
    shown: Product = quantity.formulas["exact"].kernel(sized.value)
    return shown.number(column.decimals, question.rounding, times)


def _acceleration(question: WheelRequest, column: Column, inertia: Product) -> Real:
    """Return α in rad/s² at the angle, of a diagram over the crank angle."""
    excess, angle = question.fluctuation, question.angle
    assert isinstance(excess, ExcessTorque) and angle is not None
    kernel = column.quantity.formulas["exact"].kernel
    return Real(lambda kind: kernel(lambda kind: excess.torque(excess.excess, angle, kind), inertia, kind))


SUBJECT = Subject(
    key="flywheel sizing",
    layout="flywheel-sizing",
    command="flywheel --layout flywheel-sizing",
    axes={"target": _target_axis, "column": ColumnAxis},
    axis_keys=("target",),
    quantities=registry,
    number=_number,
    caption=caption,
    notes=notes,
    letters=True,
    drawn="kurbel.plot.diagrams:sizing",
)
