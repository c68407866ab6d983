"""Which curves share a panel, and what tells them from each other there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Quantity, enumerated
from kurbel.plot.chart.model import Curve, Panel, Spot, Strokes, check_count, power_of_curves
from kurbel.plot.chart.vector import PinForce, Vector
from kurbel.reading.amounts import UNITS
from kurbel.reading.notation import about

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
    named: Callable[[int], Sequence[Spot]] | None = None


def axis_name(quantity: Quantity, lang: str) -> tuple[str, Label, Label]:
    """Return what an axis calls a quantity, Kolbenweg and $x/R$, and its unit; a share has none.

    The heading is that of a column without a unit that the axis can have: $x$ of $x$ in mm. A unit in letters
    is part of it: $F/Q$ of $F$ in $Q$.
    """
    name, heading, unit = quantity.name[lang], quantity.heading[lang], quantity.unit[lang]
    if "/(" in unit and heading == f"{quantity.symbol} in {unit}":
        return name, quantity.symbol, unit
    if unit.startswith("$") and heading == f"{quantity.symbol} in {unit}":
        letter, letters = (f"({one})" if " " in one else one for one in (quantity.symbol[1:-1], unit[1:-1]))
        return name, f"${letter}/{letters}$", ""
    unit = quantity.plain_unit(lang)
    unit = UNITS[unit].said(lang) if unit in UNITS else unit
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


def degrees(angles: Sequence[Fraction]) -> list[float]:
    """Return exact angles as floats."""
    return [float(angle) for angle in angles]
