"""The axes of an engine's pages: expansion ratios, strokes and what a flywheel is to keep."""

from __future__ import annotations

from fractions import Fraction

from kurbel.arrange import Axis, Place
from kurbel.engine import Diagram
from kurbel.engine_quantities import SPANS
from kurbel.engine_request import EngineRequest
from kurbel.notation import plain, ratio_text
from kurbel.numerals import nearest
from kurbel.rows import angle_decimals
from kurbel.table import Label, Number

CARD = {"de": "Diagramm", "en": "Card"}
HEADING = {"de": "Expansionsverhältnis $ε$", "en": "Expansion ratio $ε$"}


class ExpansionAxis(Axis):
    """The expansion ratios ε, or the one indicator card."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.engines))
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
    """Return δ as it is written: 1:100, or 0.015 where that is shorter."""
    whole = (1 / irregularity).denominator == 1
    return f"${ratio_text(irregularity) if whole else plain(irregularity)}$"


def expansion_label(request: EngineRequest, index: int) -> Label:
    """Return ε as pages print it: 2, 2.5 or, of no finite decimal, 7/3; of a card its name."""
    engine = request.engines[index][0]
    if isinstance(engine.steam, Diagram):
        return engine.steam.card.name.replace("$", "\\$")
    return f"${expansion_text(engine.steam.expansion)}$"


def expansion_value(request: EngineRequest, index: int) -> Number | Label:
    """Return ε as a number with as many decimals as all of the page need, where there are such."""
    if request.carded:
        return expansion_label(request, index)
    decimals = expansion_decimals(request)
    expansion = request.engines[index][0].ideal.expansion
    return expansion_label(request, index) if decimals is None else nearest(expansion, decimals)


def expansion_decimals(request: EngineRequest) -> int | None:
    """Return how many decimals write every ε exactly, None if no number of them does."""
    if request.carded:
        return None
    return angle_decimals([row[0].ideal.expansion for row in request.engines])


def expansion_text(expansion: Fraction) -> str:
    shown = plain(expansion)
    return shown if len(shown) <= 8 else f"{expansion.numerator}/{expansion.denominator}"
