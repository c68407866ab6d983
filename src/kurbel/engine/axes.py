"""The axes of an engine's pages: loads, strokes and what a flywheel is to keep; what is said of a load."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.load import CARD, COMPRESSOR, GAS, PUMP, STEAM
from kurbel.engine.quantities import SPANS
from kurbel.exact.numerals import Label, Number, exact_text, nearest
from kurbel.page.axes import Axis, ListAxis, Place, angle_decimals, angle_number, irregularity_label
from kurbel.page.quantity import Words, words
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.given import found_at
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from kurbel.engine.engine import Load
    from kurbel.engine.request import EngineRequest

STROKE = words("Hub|Stroke")
TARGET = words("Ungleichförmigkeitsgrad, zulässiger|Degree of irregularity allowed")


class LoadWords(NamedTuple):
    """What pages say of a kind of load, and what tells one from another of the same page.

    `key` is that of its field, `symbol` its letter, if it has one. `number` is what varies, None where that
    is no number, `label` how it is written. `machine` is what is driven by it or drives it, in the genitive,
    `several` what loads are called in sentences. `forces` says what Q is, `newtons` what it is of, and
    `lines` yields what there is to be said of the load; `layout` is that of its irregularity, `halved` tells
    that a single-acting one is called so, `captioned` that what tells it from others stands in captions,
    `tag` what stands for it in records where that is not what is written, `pressure` the end of
    a list of options that make newtons of the force.
    """

    key: str
    name: Words
    symbol: Label
    number: Callable[[Any], Fraction | None]
    label: Callable[[Any, str], Label]
    machine: Words
    several: str
    forces: Words
    newtons: Callable[[Any, Load], Label]
    lines: Callable[[Any, str], Iterator[Label]]
    layout: str = "delta-detail"
    halved: bool = True
    captioned: bool = True
    tag: Callable[[Any], Label] | None = None
    pressure: str = " and, but for a card, --pressure"


SAID: Mapping[str, str] = {
    STEAM: "kurbel.engine.axes:STEAM_WORDS",
    CARD: "kurbel.engine.axes:CARD_WORDS",
    COMPRESSOR: "kurbel.engine.loads.words:COMPRESSOR_WORDS",
    PUMP: "kurbel.engine.loads.words:PUMP_WORDS",
    GAS: "kurbel.engine.loads.words:GAS_WORDS",
}


@cache
def words_of(load: str) -> LoadWords:
    """Return what is said of a load, by its name."""
    found = found_at(SAID[load])
    assert isinstance(found, LoadWords)
    return found


class LoadAxis(Axis):
    """The loads: expansion ratios ε, pressure ratios Π, or the one card that stands in their place."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(len(request.steams))
        self.request, self.lang = request, request.lang
        self.words = request.words
        self.key = self.words.key

    @cached_property
    def decimals(self) -> int | None:
        """How many decimals write every number exactly, None if no number of them does, and of cards."""
        numbers = [self.words.number(load) for load in self.request.steams]
        known = [number for number in numbers if number is not None]
        return angle_decimals(known) if known else None

    def field(self) -> Field:
        return Field(self.key, self.words.name[self.lang], self.words.symbol, "", self.decimals)

    def value(self, place: Place) -> Number | Label:
        number = self.words.number(self.request.steams[place["expansion"]])
        if self.decimals is None or number is None:
            tag = self.words.tag
            return tag(self.request.steams[place["expansion"]]) if tag else self.heads(place)[0]
        return nearest(number, self.decimals)

    def stub(self, place: Place) -> Number | Label:
        return self.heads(place)[0] if self.words.tag else self.value(place)

    def stub_heading(self) -> Label:
        return " ".join(filter(None, (self.words.name[self.lang], self.words.symbol)))

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (load_label(self.request, place["expansion"]),)

    def over_group(self, place: Place) -> Label:
        return named_load(self.request, place["expansion"])


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


def load_text(load: Any, lang: str) -> Label:
    """Return a load with its letter, or its name: $ε = 4$, card.csv."""
    said = words_of(load.name)
    label, letter = said.label(load, lang), said.symbol.strip("$")
    return f"${letter} = {label.strip('$')}$" if letter else label


def load_label(request: EngineRequest, index: int) -> Label:
    """Return what tells a load from others as pages print it: a number or a name."""
    return request.words.label(request.steams[index], request.lang)


def named_load(request: EngineRequest, index: int) -> Label:
    """Return the same with its letter, if it has one."""
    label, letter = load_label(request, index), request.words.symbol.strip("$")
    return f"${letter} = {label.strip('$')}$" if letter else label


def number_label(number: Fraction) -> Label:
    """Return a number as pages print it: 2, 2.5 or, of no finite decimal, 7/3."""
    shown = plain(number)
    return f"${shown if len(shown) <= 8 else f'{number.numerator}/{number.denominator}'}$"


def millimetres(length: Fraction) -> Label:
    """Return a length as it stands in a formula."""
    return amount(length, "mm", exact_text)


def kilopascals(load: Load, times: Fraction = Fraction(1)) -> Label:
    """Return the pressure that Q is of, or a multiple of it, as it stands in a formula."""
    assert load.pressure is not None
    return amount(load.pressure * times, "kPa", exact_text)


def _steam_lines(request: EngineRequest, lang: str) -> Iterator[Label]:
    steam: Any = request.steams[0]
    if all(request.words.number(one) == 1 for one in request.steams):
        yield WORDS["uncut"][lang]
    elif steam.exponent == 1:
        yield WORDS["mariotte"][lang]
    else:
        yield WORDS["polytropic"][lang].format(exponent=exact_text(steam.exponent))
    if steam.clearance:
        yield WORDS["clearance"][lang].format(clearance=exact_text(steam.clearance))
    elif any(request.words.number(one) != 1 for one in request.steams):
        yield WORDS["unclear"][lang]
    if steam.back is not None:
        yield WORDS["back"][lang].format(back=f"{exact_text(steam.back)} Q" if steam.back else "0")
    else:
        yield best_back(steam, "R_b", "Q", lang)


def best_back(steam: Any, back: Label, full: Label, lang: str) -> Label:
    """Return what pages say of the back pressure that is taken where none is given, in these letters."""
    said = "best" if steam.exponent == 1 and not steam.clearance else "best_end"
    return WORDS[said][lang].format(back=back, full=full)


def engine_lines(request: EngineRequest, lang: str) -> Iterator[Label]:
    """Yield what there is to be said of an engine: of its load, its sides and its cranks."""
    yield from request.words.lines(request, lang)
    engine = request.first
    if request.words.halved:
        yield WORDS["double" if engine.double else "single"][lang]
    if len(engine.cranks) > 1:
        angles = ", ".join(f"${plain(angle)}°$" for angle in engine.cranks[1:])
        yield WORDS["cranks"][lang].format(angles=angles)


WORDS = {
    "single": words("einfachwirkend|single-acting"),
    "double": words("doppeltwirkend (sonst --single-acting)|double-acting (else --single-acting)"),
    "cranks": words(
        "Kurbeln um {angles} hinter der ersten, Zylinder gleich"
        "|cranks {angles} behind the first, cylinders alike"
    ),
    "card": words(
        "Druck aus dem Diagramm, monoton interpoliert; gedruckt sind nur so viele Stellen, wie seine"
        " Punkte tragen, für die übrigen vor dem Komma Nullen"
        "|pressure from the card, interpolated monotonically; only as many digits as its points support"
        " are printed, zeros for the others before the decimal mark"
    ),
    "mariotte": words("Expansion nach Mariotte (--exponent)|Expansion by Mariotte's law (--exponent)"),
    "polytropic": words(
        'Expansion nach $p V^n = "const"$, $n = {exponent}$|Expansion by $p V^n = "const"$, $n = {exponent}$'
    ),
    "uncut": words("Volldruck über den ganzen Hub|Full pressure over the whole stroke"),
    "clearance": words(
        "schädlicher Raum ${clearance}$ des Hubraumes|clearance ${clearance}$ of the swept volume"
    ),
    "unclear": words("ohne schädlichen Raum (--clearance)|no clearance (--clearance)"),
    "best": words(
        "Gegendruck ${back} = {full}/ε$, der vorteilhafteste (--back)"
        "|back pressure ${back} = {full}/ε$, the most favourable (--back)"
    ),
    "best_end": words(
        "Gegendruck gleich der Endspannung des Dampfes, der vorteilhafteste (--back)"
        "|back pressure equal to the steam's at the end of the stroke, the most favourable (--back)"
    ),
    "back": words("Gegendruck $R_b = {back}$|back pressure $R_b = {back}$"),
}
STEAM_WORDS = LoadWords(
    key="epsilon",
    name=words("Expansionsverhältnis|Expansion ratio"),
    symbol="$ε$",
    number=lambda steam: steam.expansion,
    label=lambda steam, lang: number_label(steam.expansion),
    machine=words("der Dampfmaschine|of the steam engine"),
    several="expansion ratios",
    forces=words(
        "$Q$ Dampfkraft auf den Kolben vor der Absperrung, $r$ Kurbelhalbmesser"
        "|$Q$ steam force on the piston before cut-off, $r$ crank radius"
    ),
    newtons=lambda steam, load: f"$Q = π/4 d^2 p$, $d = {millimetres(load.bore)}$, $p = {kilopascals(load)}$",
    lines=_steam_lines,
)
CARD_WORDS = LoadWords(
    key="card",
    name=words("Diagramm|Card"),
    symbol="",
    number=lambda diagram: None,
    label=lambda diagram, lang: os.path.basename(diagram.card.name).replace("$", "\\$"),
    machine=STEAM_WORDS.machine,
    several="cards",
    forces=words(
        "$Q$ größter Druck des Diagramms mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ greatest pressure of the card times piston area, $r$ crank radius"
    ),
    newtons=lambda diagram, load: f"$d = {millimetres(load.bore)}$",
    lines=lambda request, lang: iter([WORDS["card"][lang]]),
)
