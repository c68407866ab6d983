"""What a drawing of curves is made of: curves, panels, and what is named in them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.plot.style import LINES
from kurbel.plot.ticks import Across, power_of_thousand


class Curve(NamedTuple):
    """Values at rising angles in degrees; a value that is no finite number is a gap in the line.

    Where an angle comes twice the value jumps, from the first to the second. A dotted one is a comparison.
    """

    label: Label
    angles: Sequence[float]
    values: Sequence[float]
    dotted: bool = False


class Spot(NamedTuple):
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
    spots: Sequence[Spot] = ()
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


class Around(NamedTuple):
    """What stands around the panels: what is drawn in a few letters, the strokes, the axis below.

    Without an axis it is that of the crank angle.
    """

    said: Label = ""
    strokes: Strokes | None = None
    across: Across | None = None


NOTHING_AROUND = Around()


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
