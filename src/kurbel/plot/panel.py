"""What is drawn of a page: panels of curves over one axis, and a force as a vector; and the ticks of axes at
round numbers, written with the decimal mark and the minus sign of print."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from math import ceil, floor
from typing import NamedTuple, TypeVar

import numpy as np

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, finite_decimals, nearest, number_text
from kurbel.page.axes import PHI
from kurbel.page.quantity import Quantity, enumerated, words
from kurbel.plot.place import Points
from kurbel.plot.style import LINES
from kurbel.reading.amounts import UNITS
from kurbel.reading.notation import about

# What drawings call the ends of the stroke.
DEAD_CENTRES = {
    "inner": words("innerer Totpunkt|inner dead centre"),
    "outer": words("äußerer Totpunkt|outer dead centre"),
}
Angle = TypeVar("Angle", float, Fraction)
MINUS = "−"
_ROUND = (Fraction(1), Fraction(2), Fraction(5, 2), Fraction(5), Fraction(10))
_ANGLE_STEPS = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360)
MOST_STEPS = 12
# The float 0.3 is below 3/10, and still has the tick 0,3.
_SLACK = 1e-9
# Powers of ten that numbers at an axis may have before a power is taken out of them.
_LARGEST, _SMALLEST = 4, -2
# The prefixes of the SI in steps of a thousand, and the units that have them at axes.
PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}
PREFIXED = ("N", "J", "W", "Pa", "m", "s")


class Ticks(NamedTuple):
    """Places of ticks and their numbers."""

    places: tuple[float, ...]
    texts: tuple[str, ...]


class HorizontalAxis(NamedTuple):
    """An axis from left to right: its name, and its ticks between two values with a decimal mark, at most so
    many steps of them."""

    label: Label
    ticks: Callable[[float, float, str, int], Ticks]


def value_ticks(low: float, high: float, step: Fraction, power: int, mark: str) -> Ticks:
    """Return ticks at the multiples of a step between two values, the numbers in units of 10**power."""
    shown = step / Fraction(10) ** power
    decimals = finite_decimals(shown) or 0
    numbers = range(math.ceil(low / step - _SLACK), math.floor(high / step + _SLACK) + 1)
    return Ticks(
        tuple(float(number * step) for number in numbers),
        tuple(number_text(nearest(number * shown, decimals), mark, MINUS) for number in numbers),
    )


def round_step(least: float) -> Fraction:
    """Return the least of 1, 2, 2½, 5 times a power of ten that is not below a number above 0."""
    power = Fraction(10) ** math.floor(math.log10(least))
    return next(number * power for number in _ROUND if number * power >= least * (1 - _SLACK))


def angle_ticks(low: float, high: float, mark: str, most: int = MOST_STEPS) -> Ticks:
    """Return ticks at angles that divide the turn, in so many steps at most: every 30° from 0° to 360°."""
    least = (high - low) / most
    if least > _ANGLE_STEPS[-1]:
        step = Fraction(_ANGLE_STEPS[-1] * math.ceil(least / _ANGLE_STEPS[-1]))
    elif least > _ANGLE_STEPS[0]:
        step = Fraction(next(step for step in _ANGLE_STEPS if step >= least))
    else:
        step = round_step(least)
    ticks = value_ticks(low, high, step, 0, mark)
    return Ticks(ticks.places, tuple(f"{text}°" for text in ticks.texts))


def over_angle(lang: str) -> HorizontalAxis:
    """Return the axis of the crank angle."""
    return HorizontalAxis(f"{PHI[lang]} $φ$", angle_ticks)


def plain_ticks(low: float, high: float, mark: str, most: int = MOST_STEPS) -> Ticks:
    """Return ticks at round numbers, in so many steps at most."""
    return value_ticks(low, high, round_step((high - low) / most), 0, mark)


def degrees(angle: float | Fraction, mark: str) -> str:
    """Return an angle in degrees with at most two decimals: "−30°", "22,5°"."""
    exact = nearest(Fraction(angle), 2)
    decimals = finite_decimals(Fraction(exact.scaled, 100)) or 0
    return f"{number_text(nearest(Fraction(angle), decimals), mark, MINUS)}°"


def power_of_thousand(values: Iterable[float]) -> int:
    """Return the power of ten, a multiple of 3, to be taken out of the numbers at an axis; mostly 0."""
    largest = max(map(abs, values), default=0.0)
    power = math.floor(math.log10(largest)) if largest else 0
    return 0 if _SMALLEST <= power < _LARGEST else 3 * (power // 3)


def axis_label(label: Label, unit: Label, power: int = 0) -> Label:
    """Return what is written at an axis: "Kolbenkraft $P$ in kN", "$p$ in $10^3$ m/s²"."""
    return " in ".join(filter(None, (label, measure(unit, power))))


def measure(unit: Label, power: int) -> Label:
    """Return a unit times a power of ten: of 10³ N kN, of 10³ mm m, else with the power, 10³ m/s²."""
    factor, named = prefixed(unit, power)
    return " ".join(filter(None, (f"${factor}$" if factor else "", named)))


def prefixed(unit: Label, power: int) -> tuple[str, Label]:
    """Return the same as a factor in a formula, 10^3, empty where a prefix says it, and a unit.

    Units that take a prefix, or have one, are those of `PREFIXED`, alone or before others: N m.
    """
    first, *others = unit.split(" ")
    base = first if first in PREFIXED else first[1:]
    powers = {f"{prefix}{base}": known for known, prefix in PREFIXES.items()}
    if base in PREFIXED and first in powers and powers[first] + power in PREFIXES:
        return "", " ".join((PREFIXES[powers[first] + power] + base, *others))
    return f"10^{power if power > 0 else f'({power})'}" if power else "", unit


def amount(number: str, unit: Label, power: int) -> tuple[str, Label]:
    """Return a number of such measures in a formula, 5 or 5 · 10^3, and the unit."""
    factor, named = prefixed(unit, power)
    return " · ".join(filter(None, (number, factor))), named


class Curve(NamedTuple):
    """Values at rising angles in degrees; a value that is no finite number is a gap in the line.

    Where an angle comes twice the value jumps, from the first to the second. A dotted one is a comparison.
    """

    label: Label
    angles: Sequence[float]
    values: Sequence[float]
    dotted: bool = False


class MarkedPoint(NamedTuple):
    """A point of a curve that is marked, by a dot or by an arrowhead that points a way, and what is written
    beside it."""

    angle: float
    value: float
    text: Label = ""
    way: tuple[float, float] | None = None


class Swing(NamedTuple):
    """The greatest and the least value of a curve, between which an arrow has this text."""

    least: float
    greatest: float
    text: Label


class Panel(NamedTuple):
    """Curves of one unit over one axis; the label names the axis, a single curve needs none of its own.

    With `areas` what the first curve encloses with the second is hatched, above it one way and below it the
    other. With a `scale` it is drawn to one: so many units of its values are as long as a unit of the axis.
    """

    curves: Sequence[Curve]
    label: Label
    unit: Label = ""
    areas: bool = False
    spots: Sequence[MarkedPoint] = ()
    swing: Swing | None = None
    scale: float | None = None

    @property
    def power(self) -> int:
        """The power of ten that is taken out of the numbers at the axis."""
        return power_of_curves(self.curves)


class Strokes(NamedTuple):
    """Dead centres in rising order, their names, and those of the strokes between them."""

    ends: Sequence[float]
    dead: Sequence[Label]
    names: Sequence[Label]


class PanelFrame(NamedTuple):
    """What stands around the panels: what is drawn in a few letters, the strokes, the axis below.

    Without an axis it is that of the crank angle.
    """

    said: Label = ""
    strokes: Strokes | None = None
    across: HorizontalAxis | None = None


NOTHING_AROUND = PanelFrame()


def again(place: Angle, cycle: int, first: Angle, last: Angle) -> Iterator[Angle]:
    """Yield a place as often as it comes again between two angles."""
    turns = range(ceil((first - place) / cycle), floor((last - place) / cycle) + 1)
    yield from (place + cycle * turn for turn in turns)


def named_again(
    angle: float, value: float, cycle: int, span: tuple[float, float], text: Label
) -> list[MarkedPoint]:
    """Return the spots of a place that comes again after a cycle, of which the first has the text."""
    places = again(angle, cycle, *span)
    return [MarkedPoint(place, value, "" if number else text) for number, place in enumerate(places)]


def strokes_between(
    begun: tuple[float, float], names: Sequence[Label], span: tuple[float, float], lang: str
) -> Strokes:
    """Return the strokes of which something is seen in a span; `begun` are the inner dead centre and, half a
    turn back, the outer one, the names those of the strokes that begin there."""
    numbers = range(floor((span[0] - max(begun)) / 180), ceil((span[1] - min(begun)) / 180) + 1)
    ends = [180 * number + begun[number % 2] for number in numbers]
    while ends[1] <= span[0]:
        numbers, ends = numbers[1:], ends[1:]
    while ends[-2] >= span[1]:
        numbers, ends = numbers[:-1], ends[:-1]
    dead = [DEAD_CENTRES["outer" if number % 2 else "inner"][lang] for number in numbers]
    return Strokes(ends, dead, [names[number % len(names)] for number in numbers[:-1]])


def power_of_curves(curves: Sequence[Curve]) -> int:
    """Return the power of ten, a multiple of 3, to be taken out of the numbers of curves."""
    values = np.concatenate([np.asarray(curve.values, float) for curve in curves])
    return power_of_thousand(values[np.isfinite(values)])


def check_count(count: int) -> None:
    """Raise ProblemError for a panel of more curves than can be told apart."""
    if count > len(LINES):
        raise ProblemError(f"a panel of {count} curves was asked for; at most {len(LINES)} can be told apart")


def check_panel(panel: Panel) -> None:
    """Raise ProblemError for a panel that cannot be drawn."""
    check_count(len(panel.curves))
    if not any(np.isfinite(curve.values).any() for curve in panel.curves):
        raise ProblemError(f'the panel "{panel.label[:40]}" has no finite value, so nothing can be drawn')


MARK_STEP = 30
# Of the force on the crank pin, across and up.
PIN_FORCE = ("tangential_force", "radial_force")


class Vector(NamedTuple):
    """The components of a force at rising angles in degrees; a value that is no finite number is a gap.

    Where an angle comes twice the force jumps, from the first of its values to the second.
    """

    angles: Sequence[float]
    across: Sequence[float]
    up: Sequence[float]


class PinForce(NamedTuple):
    """The force on a pin: the names of its components, across and up, their unit, and the strokes; `ways` are
    the directions of its axes, by themselves those of the crank."""

    vector: Vector
    names: tuple[Label, Label]
    unit: Label
    strokes: Strokes | None = None
    ways: tuple[Label, Label] | None = None

    @property
    def power(self) -> int:
        """The power of ten that is taken out of the numbers of its components."""
        numbers = np.asarray((self.vector.across, self.vector.up), float)
        return power_of_thousand(numbers[np.isfinite(numbers)])


class Piece(NamedTuple):
    """The heads of the vectors at rising angles, without a jump between them."""

    angles: Points
    path: Points

    def within(self, begin: float, end: float) -> Points:
        """Return the heads from an angle to another."""
        ends = [one for one in (begin, end) if self.angles[0] < one < self.angles[-1]]
        angles = np.union1d(self.angles, ends)
        angles = angles[(angles >= begin) & (angles <= end)]
        return np.stack([np.interp(angles, self.angles, component) for component in self.path.T], axis=1)

    def at(self, angle: float) -> Points:
        """Return the head at an angle; between two given ones, on the line between their heads."""
        return np.asarray([np.interp(angle, self.angles, component) for component in self.path.T])

    def marked(self) -> range:
        """Return the angles every 30° within it."""
        first, last = ceil(self.angles[0] / MARK_STEP), floor(self.angles[-1] / MARK_STEP)
        return range(MARK_STEP * first, MARK_STEP * last + 1, MARK_STEP)


def with_gaps(paths: Sequence[Points]) -> Points:
    gap = np.full((1, 2), np.nan)
    return np.concatenate([row for path in paths for row in (gap, path)][1:])


# Four points to each dot of a printer with 1200 dpi, over the width of a panel.
MOST_POINTS = 20_000


class Trace(NamedTuple):
    """A curve before it has a panel and a label; `telling` are the drive and the like, which tell it from the
    other curves of its quantity. A dotted one is a comparison. `named` returns its extremes, over a power of
    ten."""

    quantity: Quantity
    telling: tuple[Label, ...]
    angles: Sequence[float]
    values: Sequence[float]
    dotted: bool = False
    named: Callable[[int], Sequence[MarkedPoint]] | None = None


def axis_name(quantity: Quantity, lang: str) -> tuple[str, Label, Label]:
    """Return what an axis calls a quantity, Kolbenweg and $x/R$, and its unit; a share has none.

    The heading is that of a column without a unit that the axis can have: $x$ of $x$ in mm. A unit in letters
    is part of it: $F/Q$ of $F$ in $Q$, unless there are words beside them.
    """
    name, heading, unit = quantity.name[lang], quantity.heading[lang], quantity.unit[lang]
    worded = unit.startswith("$") and not unit.endswith("$")
    if ("/(" in unit or worded) and heading == f"{quantity.symbol} in {unit}":
        return name, quantity.symbol, unit
    if unit.startswith("$") and heading == f"{quantity.symbol} in {unit}":
        letter, letters = (f"({one})" if " " in one else one for one in (quantity.symbol[1:-1], unit[1:-1]))
        return name, f"${letter}/{letters}$", ""
    unit = quantity.plain_unit(lang)
    unit = UNITS[unit].heading(lang) if unit in UNITS else unit
    heading = heading.removesuffix(f" in {unit}")
    return name, heading, unit if heading == quantity.symbol else ""


def titled(name: str, heading: Label) -> Label:
    """Return what an axis is called; some headings begin with the name."""
    return heading if heading.startswith(name) else f"{name} {heading}"


def vector(
    quantities: Sequence[Quantity],
    lang: str,
    angles: Sequence[float],
    values: Sequence[Sequence[float]],
    strokes: Strokes,
) -> PinForce:
    """Return a force of two components, across and up, with their names and their unit."""
    across, up = (axis_name(quantity, lang) for quantity in quantities)
    names = f"{across[0]} {across[1]}", f"{up[0]} {up[1]}"
    return PinForce(Vector(angles, *values), names, across[2], strokes)


def panels_of(traces: Iterable[Trace], lang: str, apart: bool) -> list[Panel]:
    """Return a panel for each unit, if the quantities are to stand apart one for each of them."""
    groups: dict[tuple[str, str], list[Trace]] = {}
    for one in traces:
        name = one.quantity.name[lang] if apart else ""
        groups.setdefault((one.quantity.plain_unit(lang), name), []).append(one)
    return [_panel(group, lang) for group in groups.values()]


def _panel(traces: Sequence[Trace], lang: str) -> Panel:
    names, headings, units = zip(*(axis_name(one.quantity, lang) for one in traces), strict=True)
    alike = len({*zip(names, headings, strict=True)}) == 1
    label = titled(names[0], headings[0]) if alike else enumerated(names, lang)
    parts = [(heading, *one.telling) for heading, one in zip(headings, traces, strict=True)]
    # Only what is not the same of all tells one from the others.
    differing = [len(set(column)) > 1 for column in zip(*parts, strict=True)]
    labels = [", ".join(part for part, tells in zip(one, differing, strict=True) if tells) for one in parts]
    if len({*labels}) < len({(label, one.quantity.key) for label, one in zip(labels, traces, strict=True)}):
        # What is called alike in pages has its spanner above it.
        labels = [f"{one.quantity.symbol} {label}" for label, one in zip(labels, traces, strict=True)]
    curves = [
        Curve(text, one.angles, one.values, one.dotted) for text, one in zip(labels, traces, strict=True)
    ]
    solid = [one for one in traces if not one.dotted]
    spots = solid[0].named(power_of_curves(curves)) if len(solid) == 1 and solid[0].named else ()
    return Panel(curves, label, units[0], spots=spots)


def check_drawn(angles: Sequence[Fraction], count: int) -> None:
    """Raise ProblemError unless so many curves can be drawn over the angles, before they are computed."""
    check_count(count)
    if len(angles) > MOST_POINTS:
        raise ProblemError(
            f"curves of {len(angles)} points were asked for; at most {MOST_POINTS} can be drawn,"
            " so make the step larger"
        )
    if len(angles) < 2:
        raise ProblemError(f"the only crank angle is {about(angles[0])}°; a curve needs two")


def in_floats(angles: Sequence[Fraction]) -> list[float]:
    """Return exact angles as floats."""
    return [float(angle) for angle in angles]
