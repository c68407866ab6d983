"""What drawings show of a crank drive: curves over the crank angle, and the force on the crank pin."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label
from kurbel.motion.digits import on_floats
from kurbel.motion.evaluation import STROKES, is_known
from kurbel.motion.quantities import registry
from kurbel.motion.question import Request
from kurbel.page.quantity import Column, Quantity
from kurbel.plot.panels import Trace, check_drawn, degrees, panels_of
from kurbel.plot.plotting import Panel
from kurbel.plot.polar import Vector
from kurbel.reading.notation import ratio_text

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

    column: Column
    crank: Crank
    values: list[float]

    @property
    def quantity(self) -> Quantity:
        return self.column.quantity


def motion_keys(crank: Crank) -> tuple[str, ...]:
    """Return what is drawn of a crank by itself: path, velocity and acceleration, or the forces of one."""
    return _in_known_units(FORCES if crank.force else MOTION, crank)


def force_keys(crank: Crank) -> tuple[str, ...]:
    """Return the forces in the crank drive; the torque is one of its own only in newton metres."""
    keys = _in_known_units(FORCES, crank)
    return keys if crank.force else keys[:-1]


def pin_force_keys(crank: Crank) -> tuple[str, ...]:
    """Return the components of the force on the crank pin, in newtons where the piston force is known."""
    return _in_known_units(PIN_FORCE, crank)


def _in_known_units(pairs: Sequence[tuple[str, str]], crank: Crank) -> tuple[str, ...]:
    return tuple(known if is_known(registry()[known], crank) else share for share, known in pairs)


def motion_panels(request: Request) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one ratio, a panel for each unit.

    The values are those of `kurbel.compute`. Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, len(request.cranks))
    angles = degrees(request.angles)
    traces = (_trace(one, angles, request.lang) for one in _drawn(request, angles))
    return panels_of(traces, request.lang, apart=len(request.cranks) > 1)


def _trace(one: _Drawn, angles: Sequence[float], lang: str) -> Trace:
    quantity = one.quantity
    return Trace(
        quantity.name[lang],
        _heading(quantity, lang),
        quantity.plain_unit(lang),
        axis_name(quantity, lang)[1],
        (ratio_label(one.crank.ratio), STROKES[quantity.stroke][lang]),
        angles,
        one.values,
    )


def ratio_label(ratio: Fraction) -> Label:
    return f"$R:L = {ratio_text(ratio)}$"


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
    return f"{quantity.name[lang]} {heading}", quantity.plain_unit(lang) if heading == quantity.symbol else ""


def _heading(quantity: Quantity, lang: str) -> Label:
    """Return the heading of a column without a unit that the axis can have: $x/R$, but $x$ of $x$ in mm."""
    return quantity.heading[lang].removesuffix(f" in {quantity.plain_unit(lang)}")


def _drawn(request: Request, angles: Sequence[float]) -> list[_Drawn]:
    """Return every quantity of every crank, in the order of quantities."""
    import numpy as np

    from kurbel.exact.bulk import evaluate

    columns = request.page_columns
    degrees = np.asarray(angles)
    rows = [evaluate([on_floats(column, crank) for column in columns], degrees) for crank in request.cranks]
    return [
        _Drawn(column, crank, row[number].tolist())
        for number, column in enumerate(columns)
        for crank, row in zip(request.cranks, rows, strict=True)
    ]
