"""What drawings show of a crank drive: curves over the crank angle, and the force on the crank pin."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from kurbel.drive.crank import Crank, ends
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import STROKES, is_known
from kurbel.motion.mechanism import STRAIGHT, Mechanism, mechanism
from kurbel.motion.page import AngleQuestion
from kurbel.page.subject import subject
from kurbel.plot.chart.extremes import spots, strokes_of
from kurbel.plot.chart.model import Around, Panel, Spot
from kurbel.plot.chart.vector import PinForce
from kurbel.plot.panels import Trace, check_drawn, degrees, panels_of, vector
from kurbel.plot.picture import Picture, Wish, asked_of, check_one, columns_of, smooth
from kurbel.reading.given import as_angles
from kurbel.reading.notation import plain, ratio_text

# Across and up in the polar diagram.
PIN_FORCE = ("tangential_force", "radial_force")


def motion_keys(chosen: Mechanism, crank: Crank) -> tuple[str, ...]:
    """Return what is drawn of a drive by itself: its motion, or the forces that a known one calls up."""
    return _known_keys(chosen, chosen.forces if crank.force else chosen.motion, crank)


def pin_force_keys(chosen: Mechanism, crank: Crank) -> tuple[str, ...]:
    """Return the components of the force on the crank pin, in newtons where the piston force is known."""
    return _known_keys(chosen, [one for one in chosen.forces if one[0] in PIN_FORCE], crank)


def _known_keys(chosen: Mechanism, pairs: Sequence[tuple[str, str]], crank: Crank) -> tuple[str, ...]:
    """Return of each pair the one in a known unit, as far as the drive has these quantities."""
    own = subject(chosen.subject).quantities()
    return tuple(known if is_known(own[known], crank) else share for share, known in pairs if share in own)


def over_angle(question: AngleQuestion, wish: Wish) -> Picture:
    """Return what is drawn of drives over the crank angle: the columns of the page, both strokes as one turn.

    Beside the infinite rod its curves are dotted. Raises ProblemError.
    """
    if wish.polar:
        return _polar(question)
    if wish.over_path:
        from kurbel.plot.over.path import of_turn

        return of_turn(question, wish)
    asked = unfolded(question)
    beside = infinite(asked) if wish.infinite else None
    drives = asked.solved()
    return Picture(asked, motion_panels(asked, beside, drives), around(asked, drives, beside))


def unfolded(question: AngleQuestion) -> AngleQuestion:
    """Return the question over smooth angles; where both strokes stand side by side, over the whole turn."""
    columns = columns_of(question)
    both = _is_stroke(question.angles) and (question.has_return or _is_of_layout(question))
    keys = [one.key.replace("_return", "") if both else one.key for one in columns]
    angles = (Fraction(0), Fraction(360)) if both else question.angles
    return asked_of(
        question,
        columns=tuple(dict.fromkeys(keys)),
        angles=smooth(angles),
        whole_turns=both or question.whole_turns,
    )


def _is_stroke(angles: Sequence[Fraction]) -> bool:
    return [*ends(angles)] == [0, 180]


def _is_of_layout(question: AngleQuestion) -> bool:
    return [*question.angles] == [*as_angles(question.layout.angles or "0")]


def infinite(question: AngleQuestion) -> AngleQuestion:
    """Return the same of the rod of infinite length. Raises ProblemError for other drives."""
    first = question.moving[1] if question.moving else None
    if not hasattr(question, "method") or getattr(getattr(first, "crank", first), "offset", None):
        raise ProblemError(
            "--infinite is for the straight crank alone; leave it out, or the offset or mechanism"
        )
    changes: dict[str, Any] = {"method": "infinite"}
    return replace(question, **changes)


def _polar(question: AngleQuestion) -> Picture:
    """Return the force on the crank pin in the crank's frame, of one drive."""
    page = asked_of(question, columns=(), whole_turns=True)
    chosen = mechanism(question.moving[0]) if question.moving else STRAIGHT
    drives = page.solved()
    if not drives or not set(PIN_FORCE) <= set(page.subject.quantities()) or not chosen.crosshead:
        raise ProblemError(f"the polar diagram of {chosen.title} is not drawn; leave --polar out")
    check_one(len(drives), "crank ratios")
    keys = pin_force_keys(chosen, drives[0].crank)
    asked = asked_of(page, columns=keys, angles=smooth(_whole(question.angles)))
    return Picture(asked, force=pin_force(asked, drives[0]))


def _whole(angles: Sequence[Fraction]) -> Sequence[Fraction]:
    """Return the turn where the angles are those of a stroke."""
    return (Fraction(0), Fraction(360)) if _is_stroke(angles) else angles


def motion_panels(
    question: AngleQuestion, beside: AngleQuestion | None = None, drives: Sequence[Drive] = ()
) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one drive, a panel for each unit.

    The values are those of `kurbel.compute`. A question beside it, of the infinite rod, has dotted curves. Of
    a single drive as conditions see it the extremes are named. Raises ProblemError for one angle, or more
    than can be drawn.
    """
    told = len(question.told)
    check_drawn(question.angles, told + (beside is not None))
    drive = drives[0] if len(drives) == 1 else None
    traces = [*_traces(question, drive), *(_traces(beside, dotted=True) if beside else ())]
    apart = told > 1 or beside is not None
    return panels_of(traces, question.lang, apart=apart)


def _traces(question: AngleQuestion, drive: Drive | None = None, dotted: bool = False) -> Iterator[Trace]:
    lang, angles, told = question.lang, degrees(question.angles), question.told
    drawn, keys = question.curves(np.asarray(angles)), [one.quantity.key for one in question.page_columns]
    for place, (column, of_drives) in enumerate(zip(question.page_columns, drawn, strict=True)):
        one = column.quantity
        alike = drive is not None and column.methods == (drive.method,)
        named = partial(_spots, question, place, drive) if drive is not None and alike else None
        for telling, values in zip(told, of_drives, strict=True):
            stroke = STROKES[one.stroke][lang] if one.stroke in STROKES else ""
            again = column.heading[-1] if keys.count(one.key) > 1 else ""
            yield Trace(one, (*telling, stroke, again), angles, values.tolist(), dotted, named)


def around(question: AngleQuestion, drives: Sequence[Drive], beside: AngleQuestion | None = None) -> Around:
    """Return what a drawing says of its drives, and their strokes where all have the same."""
    span = float(question.angles[0]), float(question.angles[-1])
    strokes = [strokes_of(drive, span, question.lang) for drive in drives]
    said = said_drive(drives[0], question) if len(drives) == 1 and beside is None else ""
    alike = strokes and all(one == strokes[0] for one in strokes)
    return Around(said, strokes[0] if alike else None)


def said_drive(drive: Drive, question: AngleQuestion) -> Label:
    """Return what a drawing says of a drive: its crank ratio and its offset."""
    crank, parts = drive.crank, [said_ratio(drive.ratio)] if question.ratios else []
    if crank.offset:
        parts.append(f"$e = {plain(crank.offset)} R$")
    return ", ".join(parts)


def _spots(question: AngleQuestion, place: int, drive: Drive, power: int) -> Sequence[Spot]:
    """Return where the column at a place is greatest and least."""

    def value(angle: float) -> float:
        return float(question.curves(np.asarray([angle]))[place][0][0])

    span = float(question.angles[0]), float(question.angles[-1])
    one = question.page_columns[place].quantity
    times = question.of_page(question.entry(one.key).unit["en"])
    return spots(drive, one, value, span, power, question.lang, times)


def said_ratio(ratio: Fraction) -> Label:
    """Return what a drawing says of a crank ratio."""
    return f"$R:L = {ratio_text(ratio)}$"


def pin_force(request: AngleQuestion, drive: Drive) -> PinForce:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has the columns `pin_force_keys`. The piston force is one and the same over the whole turn.
    """
    check_drawn(request.angles, 1)
    angles = degrees(request.angles)
    values = [of_crank.tolist() for (of_crank,) in request.curves(np.asarray(angles))]
    strokes = strokes_of(drive, (angles[0], angles[-1]), request.lang)
    quantities = [column.quantity for column in request.page_columns]
    return vector(quantities, request.lang, angles, values, strokes)
