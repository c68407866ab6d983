"""What drawings show of a crank drive: curves over the crank angle, and the force on the crank pin."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.captions import enumerated
from kurbel.digits import Digits, on_floats
from kurbel.errors import ProblemError
from kurbel.notation import about, ratio_text
from kurbel.plot_polar import Vector
from kurbel.plotting import Curve, Panel, check_count
from kurbel.problem import Crank
from kurbel.quantities import STROKES, Quantity, registry
from kurbel.request import Request, page_columns
from kurbel.table import Label

# Four points to each dot of a printer with 1200 dpi, over the width of a panel.
MOST_POINTS = 20_000
# What is drawn unless columns are named: the quantity and, where lengths, speed or force are known, the same
# in their units.
MOTION = (("x", "x_mm"), ("c", "c_mps"), ("p", "p_mps2"))
FORCES = (
    ("rod_force", "rod_force_n"),
    ("guide_force", "guide_force_n"),
    ("tangential_force", "tangential_force_n"),
    ("radial_force", "radial_force_n"),
    ("torque", "torque_nm"),
)
# Across and up in the polar diagram.
PIN_FORCE = FORCES[2:4]


class _Drawn(NamedTuple):
    """A curve before it has a label."""

    column: Digits
    crank: Crank
    values: list[float]

    @property
    def quantity(self) -> Quantity:
        return self.column.quantity


def motion_keys(crank: Crank) -> tuple[str, ...]:
    """Return what is drawn of a crank by itself: path, velocity and acceleration, or the forces of one."""
    return _in_known_units(FORCES if crank.force else MOTION, crank)


def pin_force_keys(crank: Crank) -> tuple[str, ...]:
    """Return the components of the force on the crank pin, in newtons where the piston force is known."""
    return _in_known_units(PIN_FORCE, crank)


def _in_known_units(pairs: Sequence[tuple[str, str]], crank: Crank) -> tuple[str, ...]:
    return tuple(known if registry()[known].available(crank) else share for share, known in pairs)


def motion_panels(request: Request) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one ratio, a panel for each unit.

    The values are those of `kurbel.compute`. Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, len(request.cranks))
    lang, angles = request.lang, degrees(request.angles)
    groups: dict[tuple[str, ...], list[_Drawn]] = {}
    for one in _drawn(request, angles):
        own = (one.quantity.name[lang],) if len(request.cranks) > 1 else ()
        groups.setdefault((one.quantity.unit[lang], *own), []).append(one)
    return [_panel(drawn, angles, lang) for drawn in groups.values()]


def pin_force(request: Request) -> tuple[Vector, tuple[Label, Label], Label]:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has the columns `pin_force_keys`. The piston force is one and the same over the whole turn.
    """
    check_drawn(request.angles, 1)
    angles = degrees(request.angles)
    across, up = _drawn(request, angles)
    names = [axis_name(one.quantity, request.lang) for one in (across, up)]
    return Vector(angles, across.values, up.values), (names[0][0], names[1][0]), names[0][1]


def axis_name(quantity: Quantity, lang: str) -> tuple[Label, Label]:
    """Return what an axis calls a quantity, "Kolbenweg $x/R$", and its unit; a share has none."""
    heading = _heading(quantity, lang)
    return f"{quantity.name[lang]} {heading}", quantity.unit[lang] if heading == quantity.symbol else ""


def _heading(quantity: Quantity, lang: str) -> Label:
    """Return the heading of a column without a unit that the axis can have: $x/R$, but $x$ of $x$ in mm."""
    return quantity.heading[lang].removesuffix(f" in {quantity.unit[lang]}")


def degrees(angles: Sequence[Fraction]) -> list[float]:
    """Return exact angles as floats."""
    return [float(angle) for angle in angles]


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


def _drawn(request: Request, angles: Sequence[float]) -> list[_Drawn]:
    """Return every quantity of every crank, in the order of quantities."""
    import numpy as np

    from kurbel.bulk import evaluate

    columns = [column.digits for column in page_columns(request)]
    degrees = np.asarray(angles)
    rows = [evaluate([on_floats(column, crank) for column in columns], degrees) for crank in request.cranks]
    return [
        _Drawn(column, crank, row[number].tolist())
        for number, column in enumerate(columns)
        for crank, row in zip(request.cranks, rows, strict=True)
    ]


def _panel(drawn: Sequence[_Drawn], angles: Sequence[float], lang: str) -> Panel:
    label, unit = axis_name(drawn[0].quantity, lang)
    if len({one.quantity.name[lang] for one in drawn}) > 1:
        label = enumerated((one.column.quantity.name[lang] for one in drawn), lang)
    parts = [_parts(one, lang) for one in drawn]
    # Only what is not the same of all tells one from the others.
    telling = [len(set(column)) > 1 for column in zip(*parts, strict=True)]
    labels = (", ".join(part for part, tells in zip(one, telling, strict=True) if tells) for one in parts)
    curves = [Curve(text, angles, one.values) for text, one in zip(labels, drawn, strict=True)]
    return Panel(curves, label, unit)


def _parts(one: _Drawn, lang: str) -> tuple[Label, ...]:
    stroke = STROKES[one.quantity.stroke][lang]
    return _heading(one.quantity, lang), f"$R:L = {ratio_text(one.crank.ratio)}$", stroke
