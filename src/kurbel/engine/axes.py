"""The axes of an engine's pages: expansion ratios, strokes and what a flywheel is to keep."""

from __future__ import annotations

import os
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from kurbel.engine.engine import Diagram, Steam
from kurbel.engine.quantities import SPANS
from kurbel.exact.numerals import Label, Number, finite_decimals, nearest
from kurbel.page.axes import Axis, ListAxis, Place, angle_decimals, angle_number
from kurbel.page.quantity import words
from kurbel.page.table import Field
from kurbel.reading.notation import plain, ratio_text

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest

CARD = words("Diagramm|Card")
EXPANSION = words("Expansionsverhältnis|Expansion ratio")
STROKE = words("Hub|Stroke")
TARGET = words("Ungleichförmigkeitsgrad, zulässiger|Degree of irregularity allowed")


class ExpansionAxis(Axis):
    """The expansion ratios ε, or the one indicator card, which stands in their place."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.steams))
        self.request, self.lang = request, request.lang
        self.key = "card" if request.carded else "epsilon"

    @cached_property
    def decimals(self) -> int | None:
        """How many decimals write every ε exactly, None if no number of them does, and of cards."""
        expansions = [steam.expansion for steam in self.request.steams if isinstance(steam, Steam)]
        return angle_decimals(expansions) if expansions else None

    def field(self) -> Field:
        if self.request.carded:
            return Field("card", CARD[self.lang])
        return Field("epsilon", EXPANSION[self.lang], "$ε$", "", self.decimals)

    def value(self, place: Place) -> Number | Label:
        steam = self.request.steams[place["expansion"]]
        if self.decimals is None or isinstance(steam, Diagram):
            return expansion_label(self.request, place["expansion"])
        return nearest(steam.expansion, self.decimals)

    stub = value

    def stub_heading(self) -> Label:
        if self.request.carded:
            return CARD[self.lang]
        return f"{EXPANSION[self.lang]} $ε$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (expansion_label(self.request, place["expansion"]),)

    def over_group(self, place: Place) -> Label:
        return named_expansion(self.request, place["expansion"])


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


def irregularity_label(irregularity: Fraction) -> Label:
    """Return δ as it is written: 1:100, 1:62.5, or 0.015 where the ratio has no end."""
    short = finite_decimals(1 / irregularity) is not None
    return f"${ratio_text(irregularity) if short else plain(irregularity)}$"


def expansion_label(request: EngineRequest, index: int) -> Label:
    """Return ε as pages print it: 2, 2.5 or, of no finite decimal, 7/3; of a card its name."""
    steam = request.steams[index]
    if isinstance(steam, Diagram):
        return os.path.basename(steam.card.name).replace("$", "\\$")
    shown = plain(steam.expansion)
    exact = f"{steam.expansion.numerator}/{steam.expansion.denominator}"
    return f"${shown if len(shown) <= 8 else exact}$"


def named_expansion(request: EngineRequest, index: int) -> Label:
    """Return ε with its letter; of a card its name."""
    label = expansion_label(request, index)
    return label if request.carded else f"$ε = {label.strip('$')}$"
