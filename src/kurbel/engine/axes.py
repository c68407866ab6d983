"""The axes of an engine's pages: expansion ratios, strokes and what a flywheel is to keep."""

from __future__ import annotations

import os
from fractions import Fraction

from kurbel.engine.engine import Diagram
from kurbel.engine.quantities import SPANS
from kurbel.engine.request import EngineRequest
from kurbel.exact.numerals import Label, Number, finite_decimals, nearest
from kurbel.page.arrange import Axis, Place
from kurbel.reading.notation import plain, ratio_text

CARD = {"de": "Diagramm", "en": "Card"}
HEADING = {"de": "Expansionsverhältnis $ε$", "en": "Expansion ratio $ε$"}


class ExpansionAxis(Axis):
    """The expansion ratios ε, or the one indicator card."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.steams))
        self.request = request

    def stub_heading(self) -> Label:
        layout, lang = self.request.layout, self.request.lang
        if self.request.carded:
            return CARD[lang]
        return layout.stub_heading("expansion", HEADING[lang], lang)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (expansion_label(self.request, place["expansion"]),)

    def stub(self, place: Place) -> Number | Label:
        return expansion_value(self.request, place["expansion"])

    def over_group(self, place: Place) -> Label:
        label = self.heads(place)[0]
        return label if self.request.carded else f"$ε = {label.strip('$')}$"


class StrokeAxis(Axis):
    """Outstroke, return stroke and the whole turn, as far as they have extremes of their own."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.spans))
        self.request = request

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (SPANS[self.request.spans[place["stroke"]]][1][self.request.lang],)


class TargetAxis(Axis):
    """The degrees of irregularity that flywheels are to keep."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.flywheels))
        self.request = request

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (irregularity_label(self.request.flywheels[place["target"]].irregularity),)


def irregularity_label(irregularity: Fraction) -> Label:
    """Return δ as it is written: 1:100, 1:62.5, or 0.015 where the ratio has no end."""
    short = finite_decimals(1 / irregularity) is not None
    return f"${ratio_text(irregularity) if short else plain(irregularity)}$"


def expansion_label(request: EngineRequest, index: int) -> Label:
    """Return ε as pages print it: 2, 2.5 or, of no finite decimal, 7/3; of a card its name."""
    steam = request.steams[index]
    if isinstance(steam, Diagram):
        return os.path.basename(steam.card.name).replace("$", "\\$")
    return f"${expansion_text(steam.expansion)}$"


def expansion_value(request: EngineRequest, index: int) -> Number | Label:
    """Return ε as a number with as many decimals as all of the page need, where there are such."""
    steam, decimals = request.steams[index], request.expansion_decimals
    if decimals is None or isinstance(steam, Diagram):
        return expansion_label(request, index)
    return nearest(steam.expansion, decimals)


def expansion_text(expansion: Fraction) -> str:
    shown = plain(expansion)
    return shown if len(shown) <= 8 else f"{expansion.numerator}/{expansion.denominator}"
