"""The pages of flywheels without an engine: a column for each irregularity that is to be kept."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.engine.diagram.fluctuation import Fluctuation
from kurbel.engine.diagram.wheel.captions import caption, notes
from kurbel.engine.diagram.wheel.quantities import NEEDS, SHOWN, registry
from kurbel.engine.diagram.wheel.sizing import Sizing
from kurbel.exact.numerals import Label, Number
from kurbel.exact.product import Product
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_number, irregularity_label
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Quantity, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field

TARGET = words("Ungleichförmigkeitsgrad, zulässiger|Degree of irregularity allowed")
VALUE = words("Wert|Value")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class WheelRequest(Question):
    """What is asked for: flywheels by what is given, one for each of the irregularities to keep.

    Without any of these there is one flywheel. `known_from` says what the swing is known from; `fluctuation`
    is the diagram, if it is one, and `press` the share of its cycle in which a press works, None of a blow,
    with the rest. `engine` are the caption and the lines of an engine, of which the swing is.
    """

    wheels: tuple[Sizing, ...]
    targets: tuple[Fraction, ...] = ()
    known_from: str = ""
    fluctuation: Fluctuation | None = None
    press: tuple[Product | None, Product] | None = None
    engine: tuple[Label, ...] = ()

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return super().axis_keys if self.targets else ()

    def missing(self, quantity: Quantity) -> str:
        if self.wheels[0].knows(quantity.key):
            return ""
        options = ", ".join(NEEDS[quantity.needs])
        return f"column {quantity.key} does not follow from what is given; add what it needs of {options}"

    def shows(self, column: LayoutColumn) -> bool:
        # Where its turns are known, the speed says how many cycles there are.
        turns = self.wheels[0].figures.get("turns")
        by_turns = turns is not None and turns.options in ((), ("--turns",), ("the torque",))
        return super().shows(column) and (column.key != "strokes" or not by_turns)


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
    quantity = column.quantity
    known = question.wheels[place["target"]].figures.get(SHOWN[quantity.key].figure)
    if known is None:
        return None
    # In other units than its own the quantity's is a multiple.
    shown: Product = quantity.formulas["exact"].kernel(known.value)
    return shown.number(column.decimals, question.rounding, times)


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
    options=NEEDS,
    drawn="kurbel.plot.diagrams:sizing",
)
