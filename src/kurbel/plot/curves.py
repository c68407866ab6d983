"""What drawings show of a crank drive: curves over the crank angle, and the force on the crank pin."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label
from kurbel.motion.evaluation import STROKES, is_known
from kurbel.motion.mechanism import Mechanism
from kurbel.motion.page import AngleQuestion
from kurbel.page.subject import subject
from kurbel.plot.panels import Trace, check_drawn, degrees, panels_of, vector
from kurbel.plot.plotting import Panel
from kurbel.plot.polar import Vector
from kurbel.reading.notation import ratio_text

# Across and up in the polar diagram.
PIN_FORCE = ("tangential_force", "radial_force")


def motion_keys(chosen: Mechanism, crank: Crank) -> tuple[str, ...]:
    """Return what is drawn of a drive by itself: its motion, or the forces that a known one calls up."""
    return _known_keys(chosen, chosen.forces if crank.force else chosen.motion, crank)


def force_keys(chosen: Mechanism, crank: Crank) -> tuple[str, ...]:
    """Return the forces in the drive; the torque is one of its own only in newton metres."""
    return _known_keys(chosen, chosen.forces if crank.force else chosen.forces[:-1], crank)


def pin_force_keys(chosen: Mechanism, crank: Crank) -> tuple[str, ...]:
    """Return the components of the force on the crank pin, in newtons where the piston force is known."""
    return _known_keys(chosen, [one for one in chosen.forces if one[0] in PIN_FORCE], crank)


def _known_keys(chosen: Mechanism, pairs: Sequence[tuple[str, str]], crank: Crank) -> tuple[str, ...]:
    """Return of each pair the one in a known unit, as far as the drive has these quantities."""
    own = subject(chosen.subject).quantities()
    return tuple(known if is_known(own[known], crank) else share for share, known in pairs if share in own)


def motion_panels(question: AngleQuestion) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one drive, a panel for each unit.

    The values are those of `kurbel.compute`. Raises ProblemError for one angle, or more than can be drawn.
    """
    lang, angles, ratios = question.lang, degrees(question.angles), question.ratios
    check_drawn(question.angles, max(len(ratios), 1))
    traces = []
    for column, of_drives in zip(question.page_columns, question.curves(np.asarray(angles)), strict=True):
        one = column.quantity
        for drive, drawn in enumerate(of_drives):
            stroke = STROKES[one.stroke][lang] if one.stroke in STROKES else ""
            told = (f"$R:L = {ratio_text(ratios[drive])}$", stroke) if ratios else ()
            traces.append(Trace(one, told, angles, drawn.tolist()))
    return panels_of(traces, lang, apart=len(ratios) > 1)


def pin_force(request: AngleQuestion) -> tuple[Vector, tuple[Label, Label], Label]:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has the columns `pin_force_keys`. The piston force is one and the same over the whole turn.
    """
    check_drawn(request.angles, 1)
    angles = degrees(request.angles)
    values = [of_crank.tolist() for (of_crank,) in request.curves(np.asarray(angles))]
    return vector([column.quantity for column in request.page_columns], request.lang, angles, values)
