"""What drawings show of a crank drive: curves over the crank angle, and the force on the crank pin."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from kurbel.drive.crank import Crank
from kurbel.exact.kind import floats
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import circle
from kurbel.linkage.page import LinkageRequest
from kurbel.motion.digits import on_floats
from kurbel.motion.evaluation import STROKES, is_known
from kurbel.motion.quantities import registry
from kurbel.motion.question import Request
from kurbel.plot.panels import check_drawn, degrees, panels_of, trace, vector
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
# What is drawn of the arc crank unless columns are named.
ARC_MOTION = ("path", "velocity", "acceleration")


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


def motion_panels(question: Request | LinkageRequest) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one drive, a panel for each unit.

    The values are those of `kurbel.compute`. Raises ProblemError for one angle, or more than can be drawn.
    """
    lang, angles, ratios = question.lang, degrees(question.angles), question.ratios
    check_drawn(question.angles, max(len(ratios), 1))
    values = _of_cranks if isinstance(question, Request) else _of_linkages
    traces = []
    for column, of_drives in zip(question.page_columns, values(question, angles), strict=True):
        one = column.quantity
        for drive, drawn in enumerate(of_drives):
            stroke = STROKES[one.stroke][lang]
            told = (f"$R:L = {ratio_text(ratios[drive])}$", stroke) if ratios else ()
            traces.append(trace(one, lang, told, angles, drawn))
    return panels_of(traces, lang, apart=len(ratios) > 1)


def pin_force(request: Request) -> tuple[Vector, tuple[Label, Label], Label]:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has the columns `pin_force_keys`. The piston force is one and the same over the whole turn.
    """
    check_drawn(request.angles, 1)
    angles = degrees(request.angles)
    values = [of_crank for (of_crank,) in _of_cranks(request, angles)]
    return vector([column.quantity for column in request.page_columns], request.lang, angles, values)


def _of_cranks(request: Any, angles: Sequence[float]) -> list[list[list[float]]]:
    """Return the values of every column for every crank."""
    from kurbel.exact.bulk import evaluate

    columns, at = request.page_columns, np.asarray(angles)
    found = [evaluate([on_floats(column, crank) for column in columns], at) for crank in request.cranks]
    return [[one.tolist() for one in of_cranks] for of_cranks in zip(*found, strict=True)]


def _of_linkages(request: Any, angles: Sequence[float]) -> list[list[list[float]]]:
    """Return the same for every arc crank, or for the parallel crank."""
    from kurbel.linkage.evaluation import value

    at, kind = circle(np.asarray(angles)), floats()
    return [
        [value(column.quantity, drive, at, kind).tolist() for drive in request.drives]
        for column in request.page_columns
    ]
