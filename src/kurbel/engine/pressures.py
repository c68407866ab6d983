"""The pressures on a piston, of steam or gas and what accelerates the masses, and their pages.

They stand over the share of the stroke, or over the crank angle, on any kind of number in bar, positive in
the direction of the stroke; a stroke counts from the dead centre where it begins. The masses m that go to and
fro with the acceleration p take the pressure q = m p/A of the piston's area A from that of the gas, and give
it back where p is negative. Source: Weisbach-Herrmann, § 151 (Beschleunigungsdruck; the seed ends there,
hence re-derived).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from math import floor, log10
from typing import Any, NamedTuple

from kurbel.drive.at import known
from kurbel.drive.crank import Crank, check_angles
from kurbel.drive.moved import Drive, Moved
from kurbel.engine.captions import within
from kurbel.engine.engine import Engine
from kurbel.engine.loads.words import engine_lines, load_text, words_of
from kurbel.engine.turn import angle_at, turn_of
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball, half_turn_circle
from kurbel.exact.kind import Kind, balls, floats, settled
from kurbel.exact.numerals import Label, Number, figure, nearest
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.notes import digits_text, moving_notes
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place, UnletteredAxis, angle_decimals
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, entry, enumerated, filled, for_ratio
from kurbel.page.subject import OVER_AXES, Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.notation import check_bounds

PRESSED = Texts("engine", "pressed")
MEANT = ("gas_pressure", "inertia_pressure", "left_pressure")

PASCALS = 10**5
OVER_STROKE, OVER_ANGLE = "pressures", "pressures over the angle"
GAS = Need(
    lambda question: question.pressed.pushed,
    words="a pressure on the piston; add what drives it, such as --eps 4 with --bore and --pressure",
)
MASSES = Need(
    lambda question: question.pressed.heavy, words="masses; add --reciprocating, --stroke, --speed and --bore"
)
BOTH = Need(
    lambda question: question.pressed.pushed and question.pressed.heavy,
    words="masses and a pressure on the piston; add --reciprocating, and what drives it, such as --eps 4",
)


class StrokePlace(NamedTuple):
    """A place on a stroke of the cycle: the share of it that the piston has gone, or its crank angle φ in
    half turns, less those of the strokes before."""

    stroke: int
    share: Fraction | None = None
    angle: Fraction | None = None


@dataclass(frozen=True, slots=True)
class PressureDrive:
    """A crank drive with its bore in metres, with moving masses or under the load of an engine, or both."""

    drive: Drive
    bore: Fraction | None = None
    engine: Engine | None = None

    def __post_init__(self) -> None:
        if self.engine is None and not self.heavy:
            raise ProblemError(
                "neither masses nor a pressure on the piston were given; add --reciprocating 300kg, or what"
                " drives the piston, such as --eps 4"
            )
        if not self.pushed and not self.heavy:
            raise ProblemError(
                "the pressure on the piston is not known in bar; add --bore and --pressure, or masses,"
                " --reciprocating 300kg"
            )
        check_bounds("the bore", self.bore, "be above 0", " m")

    @property
    def crank(self) -> Crank:
        return self.drive.crank

    @property
    def heavy(self) -> bool:
        """Whether masses go to and fro that are known."""
        return self.crank.moving is not None and self.bore is not None

    @property
    def pushed(self) -> bool:
        """Whether a pressure on the piston is known."""
        return self.engine is not None and self.engine.pressure is not None

    @property
    def mass(self) -> Fraction:
        """What goes to and fro in kg, the rod's share at its crosshead pin with it."""
        return Fraction(known(self.crank.moving).joined.crosshead)

    @property
    def cycle(self) -> int:
        """The strokes after which everything comes again."""
        engine = self.engine
        return 2 if engine is None else len(engine.steam.strokes(floats(), engine.double))

    def standing(self, half_turns: Fraction) -> StrokePlace:
        """Return where the crank stands at so many half turns of φ."""
        moved = self.drive.moved(floats(), "exact")
        since = half_turns % self.cycle
        for stroke in range(self.cycle, -1, -1):
            begun = stroke + (
                Fraction(0) if moved.regular else Fraction(float(moved.dead_centre(stroke % 2)))
            )
            if since >= begun:
                return StrokePlace(stroke % self.cycle, angle=since - stroke)
        # Before the first dead centre the last stroke is not over.
        return StrokePlace(self.cycle - 1, angle=since + 1)

    def share(self, where: StrokePlace, kind: Kind) -> Numeric:
        """Return the share of the stroke that the piston has gone."""
        if where.share is not None:
            return kind.of(where.share)
        moved = self.drive.moved(kind, "exact")
        return moved.path(where.stroke % 2, self._circle(moved, where, kind)) / moved.length

    def gas(self, where: StrokePlace, kind: Kind) -> Numeric:
        """Return the pressure on the piston's face less that on the other, in bar."""
        engine = known(self.engine)
        acting = engine.steam.strokes(kind, engine.double)[where.stroke]
        return acting.force(self.share(where, kind)) * kind.of(Fraction(known(engine.pressure)) / PASCALS)

    def masses(self, where: StrokePlace, kind: Kind) -> Numeric:
        """Return q = m p/A in bar."""
        moved, bore = self.drive.moved(kind, "exact"), known(self.bore)
        accelerated = moved.acceleration(where.stroke % 2, self._circle(moved, where, kind))
        per_area = kind.of(4 * self.mass / (bore * bore * PASCALS)) / kind.pi
        return accelerated * per_area * self.crank.pin_acceleration(kind)

    def left(self, where: StrokePlace, kind: Kind) -> Numeric:
        """Return what of the pressure the masses pass on, p - q."""
        return self.gas(where, kind) - self.masses(where, kind)

    def degrees(self, where: StrokePlace, kind: Kind) -> Numeric:
        """Return φ in degrees, over both strokes and all turns of the cycle."""
        moved = self.drive.moved(kind, "exact")
        return 180 * (self._angle(moved, where, kind) + where.stroke)

    def _circle(self, moved: Moved, where: StrokePlace, kind: Kind) -> Circle[Numeric]:
        if where.angle is not None:
            return kind.circle(180 * where.angle)
        return half_turn_circle(ball(self._angle(moved, where, kind)))

    def _angle(self, moved: Moved, where: StrokePlace, kind: Kind) -> Numeric:
        """Return the half turns of φ, less those of the strokes before."""
        if where.angle is not None:
            return kind.of(where.angle)
        way, share = where.stroke % 2, known(where.share)
        if share == 0:
            return kind.of(Fraction(0)) + moved.dead_centre(way)
        if share == 1:
            return kind.of(Fraction(1)) + moved.dead_centre(1 - way)
        return angle_at(moved, way, kind.of(share))


def is_carded(pressed: PressureDrive) -> bool:
    """Whether the pressure comes from an indicator card."""
    return pressed.engine is not None and pressed.engine.carded


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel call takes what is pressed, where, and the kind."""
    gas, masses = "Kolbendruck|Pressure on the piston", "Beschleunigungsdruck|Acceleration pressure"
    left = "verbleibender Druck|Remaining pressure"
    entries = (
        entry("crank_angle", "Kurbelwinkel|Crank angle", "$φ$", "°", 3, _of(PressureDrive.degrees)),
        entry("x_stroke", "Kolbenweg|Piston path", "$x$", "Hub|stroke", 4, _of(PressureDrive.share), "$x/S$"),
        entry("gas_pressure", gas, "$p$", "bar", 3, _of(PressureDrive.gas), needs=(GAS,)),
        entry("inertia_pressure", masses, "$q$", "bar", 3, _of(PressureDrive.masses), needs=(MASSES,)),
        entry("left_pressure", left, "$p - q$", "bar", 3, _of(PressureDrive.left), needs=(BOTH,)),
    )
    return {one.key: one._replace(spanners=(one.name,)) for one in entries}


def _of(kernel: Callable[..., Numeric]) -> Mapping[str, Formula]:
    return {"exact": Formula(kernel)}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PressuresRequest(Question):
    """What is asked for: the pressures in a cylinder at shares of its strokes, or at crank angles."""

    pressed: PressureDrive
    shares: Sequence[Fraction] = ()
    angles: Sequence[Fraction] = (Fraction(0),)

    no_column = "there is no column beside the axes; add one, such as inertia_pressure"

    def check(self) -> None:
        check_angles(self.angles)
        if self.layout.subject == OVER_STROKE and not self.shares:
            raise ProblemError("no share of the stroke was given; write them as '0;0.5;1' or 0..1:0.1")
        for share in self.shares:
            check_bounds("share of the stroke", share, "lie within 0..1")

    @property
    def ratios(self) -> list[Fraction]:
        return [self.pressed.crank.ratio]

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return ("exact",)

    def where(self, place: Place) -> StrokePlace:
        """Return the place on a stroke that an address of the page is about."""
        if "share" in place:
            return StrokePlace(place["stroke"], self.shares[place["share"]])
        return self.pressed.standing(self.angles[place["angle"]] / 180)

    @cached_property
    def turn(self) -> Any:
        """The turn of an indicator card, which knows what digits it supports."""
        return turn_of(known(self.pressed.engine), "exact")


def stroke_names(count: int, lang: str) -> list[str]:
    """Return what the strokes of a cycle are called."""
    names = [PRESSED["return" if stroke % 2 else "out"][lang] for stroke in range(count)]
    if count == 2:
        return names
    said = PRESSED["numbered"][lang]
    names = names if lang == "de" else [name.lower() for name in names]
    return [said.format(number=number, stroke=name) for number, name in enumerate(names, 1)]


def _stroke_axis(question: PressuresRequest) -> ListAxis:
    names = stroke_names(question.pressed.cycle, question.lang)
    field = Field("stroke", PRESSED["stroke"][question.lang], "", "", 0)
    return ListAxis(range(len(names)), field, lambda stroke: Number(stroke + 1, 0), names.__getitem__)


def _share_axis(question: PressuresRequest) -> ListAxis:
    decimals = angle_decimals(question.shares)

    def number(share: Fraction) -> Number | Label:
        return nearest(share, decimals) if decimals is not None else f"${share}$"

    field = Field("share", PRESSED["share"][question.lang], "$x/S$", "", decimals)
    return UnletteredAxis(question.shares, field, number, lambda share: f"$x/S = {figure(share)}$", "$x/S$")


def _number(question: PressuresRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number."""
    quantity, where, pressed = column.quantity, question.where(place), question.pressed
    kernel = quantity.formulas["exact"].kernel
    if is_carded(pressed) and not {GAS, BOTH}.isdisjoint(quantity.needs):
        return _measured(question, column, where)
    scaled = settled(lambda kind: times * kernel(pressed, where, kind), column.places, question.rounding)
    return Number(scaled, column.places)


def _measured(question: PressuresRequest, column: Column, where: StrokePlace) -> Number | None:
    """The number as far as the points of the card tell it, None if not one figure."""
    pressed, turn = question.pressed, question.turn
    share = float(pressed.share(where, floats()))
    own, *halves = (float(one.cylinder.strokes[where.stroke].force(share)) for one in (turn, *turn.coarser))
    apart = max(abs(own - half) for half in halves)
    bar = float(question.of_page("bar"))
    unit = bar * float(known(known(pressed.engine).pressure)) / PASCALS
    value = own * unit
    if BOTH in column.quantity.needs:
        value -= bar * float(pressed.masses(where, balls()))
    supported = min(column.places, floor(-log10(2 * max(apart, turn.force_apart) * unit)))
    return nearest(Fraction(value), supported, question.rounding) if supported >= 0 else None


def _caption(question: PressuresRequest) -> Label:
    lang = question.lang
    ratio = for_ratio(question.ratios[0], lang, question.layout.ratio_symbol)
    shown = {one.quantity.key: one.quantity.name[lang] for one in question.page_columns}
    # What is left is not named beside that of which it is left.
    names = [shown[key] for key in ("inertia_pressure", "gas_pressure") if key in shown] or shown.values()
    places = (("{quantities}", enumerated(names, lang)), ("{for_ratio}", ratio))
    return filled(question.layout.caption[lang], places)


def _notes(question: PressuresRequest) -> Iterator[Label]:
    lang, pressed = question.lang, question.pressed
    shown = {one.quantity.key for one in question.page_columns}
    said = [PRESSED[key][lang] for key in MEANT if not shown.isdisjoint((key, "left_pressure"))]
    yield "; ".join(filter(None, (", ".join(said), PRESSED["signs"][lang])))
    if not pressed.drive.moved(floats(), "exact").regular:
        inner = digits_text(lambda kind: 180 * pressed.drive.moved(kind, "exact").dead_centre(0), 3)
        yield PRESSED["slide"][lang].format(inner=inner)
    if pressed.engine is not None and getattr(pressed.engine.steam, "driven", False):
        yield PRESSED["driven"][lang]
    if pressed.engine is not None:
        load = pressed.engine.steam
        lines = [*engine_lines([load], pressed.engine, lang)]
        if words_of(load.name).captioned:
            lines = [load_text(load, lang), *(within(line, lang) for line in lines)]
        yield "; ".join(lines)
    if pressed.heavy:
        rod = PRESSED["rod"][lang] if known(pressed.crank.moving).rod is not None else ""
        bore = amount(known(pressed.bore), "mm")
        yield PRESSED["mass"][lang].format(mass=amount(pressed.mass, "kg"), rod=rod, bore=bore)
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
    drawn="kurbel.plot.over_path:over_stroke",
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
