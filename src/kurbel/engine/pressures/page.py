"""The pages of the pressures on a piston: over the share of the stroke, or over the crank angle."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from math import floor, log10
from typing import Any

from kurbel.drive.crank import check_angles, known
from kurbel.drive.load import figure
from kurbel.engine.pressures.pressed import PASCALS, Pressed, Where, is_carded
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats, settled
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.motion.captions import digits_text, moving_notes
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place, angle_decimals
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Formula, Quantity, Words, entry, filled, for_ratio, words
from kurbel.page.subject import OVER_AXES, Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.notation import about

OVER_STROKE, OVER_ANGLE = "pressures", "pressures over the angle"
GAS, MASSES, BOTH = "gas", "masses", "both"
UNKNOWN: Mapping[str, str] = {
    GAS: "a pressure on the piston; add what drives it, such as --eps 4 with --bore and --pressure",
    MASSES: "masses; add --reciprocating, --stroke, --speed and --bore",
    BOTH: "masses and a pressure on the piston; add --reciprocating, and what drives it, such as --eps 4",
}
WORDS: Mapping[str, Words] = {
    "slide": words(
        "$φ$ von der Schubrichtung, der innere Totpunkt bei $φ_i = {inner}°$"
        "|$φ$ from the slide direction, the inner dead centre at $φ_i = {inner}°$"
    ),
    "out": words("Hingang|Outstroke"),
    "return": words("Rückgang|Return"),
    "numbered": words("{number}. Hub, {stroke}|Stroke {number}, {stroke}"),
    "pressures": words("Drücke|pressures"),
    "driven": words(
        "Arbeitsmaschine: die Welle treibt den Kolben, ein negatives $p$ hemmt ihn"
        "|driven machine: the shaft drives the piston, a negative $p$ resists it"
    ),
    "stroke": words("Hub|Stroke"),
    "share": words("Kolbenweg in Teilen des Hubes|Piston path in strokes"),
    "signs": words(
        "$p$ Überdruck auf den Kolben, $q = m a/A$ Beschleunigungsdruck der hin- und hergehenden Masse $m$"
        " bei der Beschleunigung $a$ auf die Kolbenfläche $A$, $p - q$ bleibt für das Gestänge; positiv in"
        " der Richtung des Hubes"
        "|$p$ pressure on the piston less that on its other face, $q = m a/A$ what the reciprocating mass $m$"
        " takes of it for the acceleration $a$, over the piston area $A$, $p - q$ what is left for the rod;"
        " positive in the direction of the stroke"
    ),
    "mass": words("$m = {mass}${rod}, $d = {bore}$|$m = {mass}${rod}, $d = {bore}$"),
    "rod": words(
        " mit dem Teil der Schubstange am Kreuzkopfzapfen| with the rod's share at the crosshead pin"
    ),
}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel call takes what is pressed, where, and the kind."""
    gas, masses = "Kolbendruck|Pressure on the piston", "Beschleunigungsdruck|Acceleration pressure"
    left = "verbleibender Druck|Remaining pressure"
    entries = (
        entry("crank_angle", "Kurbelwinkel|Crank angle", "$φ$", "°", 3, _of(Pressed.degrees)),
        entry("x_stroke", "Kolbenweg|Piston path", "$x$", "Hub|stroke", 4, _of(Pressed.share), "$x/S$"),
        entry("gas_pressure", gas, "$p$", "bar", 3, _of(Pressed.gas), needs=GAS),
        entry("inertia_pressure", masses, "$q$", "bar", 3, _of(Pressed.masses), needs=MASSES),
        entry("left_pressure", left, "$p - q$", "bar", 3, _of(Pressed.left), needs=BOTH),
    )
    return {one.key: one._replace(spanners=(one.name,)) for one in entries}


def _of(kernel: Callable[..., Any]) -> Mapping[str, Formula]:
    return {"exact": Formula(kernel)}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PressuresRequest(Question):
    """What is asked for: the pressures in a cylinder at shares of its strokes, or at crank angles."""

    pressed: Pressed
    shares: Sequence[Fraction] = ()
    angles: Sequence[Fraction] = (Fraction(0),)

    no_column = "there is no column beside the axes; add one, such as inertia_pressure"

    def check(self) -> None:
        check_angles(self.angles)
        if self.layout.subject == OVER_STROKE and not self.shares:
            raise ProblemError("no share of the stroke was given; write them as '0;0.5;1' or 0..1:0.1")
        for share in self.shares:
            if not 0 <= share <= 1:
                raise ProblemError(f"share of the stroke is {about(share)}; it must lie within 0..1")

    @property
    def ratios(self) -> list[Fraction]:
        return [self.pressed.crank.ratio]

    def missing(self, quantity: Quantity) -> str:
        gas, masses = not self.pressed.pushed, not self.pressed.heavy
        lacks = {GAS: gas, MASSES: masses, BOTH: gas or masses}
        if not lacks.get(quantity.needs):
            return ""
        return f"column {quantity.key} needs {UNKNOWN[quantity.needs]}"

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return ("exact",)

    def where(self, place: Place) -> Where:
        """Return the place on a stroke that an address of the page is about."""
        if "share" in place:
            return Where(place["stroke"], self.shares[place["share"]])
        return self.pressed.standing(self.angles[place["angle"]] / 180)

    @cached_property
    def turn(self) -> Any:
        """The turn of an indicator card, which knows what digits it supports."""
        from kurbel.engine.turn import turn_of

        return turn_of(known(self.pressed.engine), "exact")


def stroke_names(count: int, lang: str) -> list[str]:
    """Return what the strokes of a cycle are called."""
    names = [WORDS["return" if stroke % 2 else "out"][lang] for stroke in range(count)]
    if count == 2:
        return names
    said = WORDS["numbered"][lang]
    names = names if lang == "de" else [name.lower() for name in names]
    return [said.format(number=number, stroke=name) for number, name in enumerate(names, 1)]


def _stroke_axis(question: PressuresRequest) -> ListAxis:
    names = stroke_names(question.pressed.cycle, question.lang)
    field = Field("stroke", WORDS["stroke"][question.lang], "", "", 0)
    return ListAxis(range(len(names)), field, lambda stroke: Number(stroke + 1, 0), names.__getitem__)


class _ShareAxis(ListAxis):
    """Shares of the stroke, in the stub without their letters."""

    def stub(self, place: Place) -> Number | Label:
        found = self.value(place)
        assert isinstance(found, Number | str)
        return found


def _share_axis(question: PressuresRequest) -> ListAxis:
    decimals = angle_decimals(question.shares)

    def number(share: Fraction) -> Number | Label:
        return nearest(share, decimals) if decimals is not None else f"${share}$"

    field = Field("share", WORDS["share"][question.lang], "$x/S$", "", decimals)
    return _ShareAxis(question.shares, field, number, lambda share: f"$x/S = {figure(share)}$", "$x/S$")


def _number(question: PressuresRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number."""
    quantity, where, pressed = column.quantity, question.where(place), question.pressed
    kernel = quantity.formulas["exact"].kernel
    if is_carded(pressed) and quantity.needs in (GAS, BOTH):
        return _measured(question, column, where)
    scaled = settled(lambda kind: times * kernel(pressed, where, kind), column.places, question.rounding)
    return Number(scaled, column.places)


def _measured(question: PressuresRequest, column: Column, where: Where) -> Number | None:
    """The number as far as the points of the card tell it, None if not one figure."""
    pressed, turn = question.pressed, question.turn
    share = float(pressed.share(where, floats()))
    own, *halves = (float(one.cylinder.strokes[where.stroke].force(share)) for one in (turn, *turn.coarser))
    apart = max(abs(own - half) for half in halves)
    unit = float(known(known(pressed.engine).pressure)) / PASCALS
    value = own * unit
    if column.quantity.needs == BOTH:
        from kurbel.exact.kind import balls

        value -= float(pressed.masses(where, balls()))
    supported = min(column.places, floor(-log10(2 * max(apart, turn.force_apart) * unit)))
    return nearest(Fraction(value), supported, question.rounding) if supported >= 0 else None


def _caption(question: PressuresRequest) -> Label:
    ratio = for_ratio(question.ratios[0], question.lang, question.layout.ratio_symbol)
    return filled(question.layout.caption[question.lang], [("{for_ratio}", ratio)])


def _notes(question: PressuresRequest) -> Iterator[Label]:
    lang, pressed = question.lang, question.pressed
    yield from (note[lang] for note in question.layout.notes)
    yield WORDS["signs"][lang]
    if not pressed.drive.moved(floats(), "exact").regular:
        inner = digits_text(lambda kind: 180 * pressed.drive.moved(kind, "exact").dead_centre(0), 3)
        yield WORDS["slide"][lang].format(inner=inner)
    if pressed.engine is not None and getattr(pressed.engine.steam, "driven", False):
        yield WORDS["driven"][lang]
    if pressed.engine is not None:
        from kurbel.engine.axes import engine_lines, load_text
        from kurbel.engine.cylinders.words import Alone, within

        alone: Any = Alone(pressed.engine)
        lines = [*engine_lines(alone, lang)]
        if alone.words.captioned:
            lines = [load_text(pressed.engine.steam, lang), *(within(line, lang) for line in lines)]
        yield "; ".join(lines)
    if pressed.heavy:
        rod = WORDS["rod"][lang] if known(pressed.crank.moving).rod is not None else ""
        bore = amount(known(pressed.bore), "mm")
        yield WORDS["mass"][lang].format(mass=amount(pressed.mass, "kg"), rod=rod, bore=bore)
        yield from moving_notes(pressed.crank, question.layout.ratio_symbol, lang)


PRESSURES = Subject(
    key=OVER_STROKE,
    layout="pressures",
    command="pressures",
    axes={"stroke": _stroke_axis, "share": _share_axis, "column": ColumnAxis},
    axis_keys=("stroke", "share"),
    quantities=registry,
    number=_number,
    caption=_caption,
    notes=_notes,
    letters=True,
    drawn="kurbel.plot.strokes:over_stroke",
)
PRESSURES_OVER_ANGLE = PRESSURES._replace(
    key=OVER_ANGLE,
    layout="pressures-turn",
    command="pressures --layout pressures-turn",
    axes={"angle": AngleAxis, "column": ColumnAxis},
    axis_keys=("phi",),
    listed=tuple,
    drawn=OVER_AXES,
)
