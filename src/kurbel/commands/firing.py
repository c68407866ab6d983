"""The firing orders of engines."""

from collections.abc import Sequence
from fractions import Fraction

from kurbel.balancing.arrangement import usual
from kurbel.commands.options import Choice, Count, Option, alone, measure, word
from kurbel.commands.part import CommandOptions, Part
from kurbel.commands.parts.sheet import Layouts, Plain, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.page.subject import Question
from kurbel.reading.given import as_crank_angles


class Arranged(Part):
    """An engine with several cranks."""

    engine = word(
        "inline-1, inline-2-180, inline-2-360, inline-3 to inline-6, v2-90, v6-90, v8-90, v12-60,"
        " boxer-2, boxer-4; default: inline-4, with masses inline-1.",
        kind=Choice("engine", usual),
    )
    cranks: Option[Sequence[Fraction]] = Option(
        "Another engine: the crank of every cylinder, '0;180;180;0'.", "ANGLES", unit="degrees",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip
    banks: Option[Sequence[Fraction]] = Option(
        "Directions of its cylinders, counted as the cranks: '-45;45'; default 0.", "ANGLES", unit="degrees",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip


class FiringOptions(Arranged, Layouts, Plain, CommandOptions):
    """Print the firing orders that an engine's cranks allow; with --order the cranks that it needs.

    \b
    kurbel firing --cranks '0;180;180;0'
    kurbel firing --engine v8-90
    kurbel firing --order 1-5-3-6-2-4
    kurbel firing --order 1-2 --banks '0;45' --intervals '405;315'
    \f
    >>> import kurbel
    >>> page = kurbel.firing(cranks="0;180;180;0", columns="firing_order")
    >>> print(kurbel.typeset(page, "csv"), end="")
    number,firing_order
    1,1-2-4-3
    2,1-3-4-2
    """

    unnamed = "engine"
    sequence = "cranks banks order intervals strokes columns"

    order = word("Firing order whose cranks are sought, or of these cranks: 1-3-4-2.", "ORDER", whole=True)
    intervals = measure(
        alone(as_crank_angles),
        "With --order: the angles from each firing to the next, '315;405'; default: equal ones.", "ANGLES",
        unit="degrees", whole=True,
    )  # fmt: skip
    strokes: Option[int] = Option(
        "Strokes of a cycle: 4 (default) or 2.", "N", Count("number of strokes", 2, 4), default=4
    )
    columns = columns_option("firing-orders", "number,firing_order,longest")
    layout = layout_option("firing orders", "firing")

    def question(self) -> Question:
        from kurbel.balancing.firing import read_order
        from kurbel.balancing.firing_page import FiringRequest, asked

        order, strokes = self.order, self.strokes
        sought = () if order is None else read_order(order)
        page = self.page("firing" if order else "firing-orders", "firing orders", "firing")
        name, arrangement = asked(
            self.engine, self.cranks or (), self.banks or (), sought, strokes, self.intervals or ()
        )
        return FiringRequest(
            layout=page,
            arrangement=arrangement,
            strokes=strokes,
            order=sought,
            engine=name,
            columns=self.names("firing_order" if order is None else "crank,fires_at"),
            **self.printed(),
        )


firing = function(FiringOptions, "firing")
