"""What drawings show of a crank drive: curves over the crank angle, the force on the crank pin, and where its
quantities are greatest and least, as `kurbel solve` has it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from math import ceil
from typing import Any, NamedTuple

import numpy as np

from kurbel.conditions.solve import MEASURES, Root, solve
from kurbel.drive.crank import Crank, ends
from kurbel.errors import NoRootError, ProblemError, UnsettledError
from kurbel.exact.numerals import Label, Number, degrees_text, figures, number_text
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import LOADED, OUT, RETURN, STROKES, is_known
from kurbel.motion.mechanism import STRAIGHT, Mechanism, mechanism
from kurbel.motion.motion_page import AngleQuestion
from kurbel.page.quantity import Quantity, words
from kurbel.page.subject import subject
from kurbel.plot.drawings import DrawingWish, Picture, asked_of, check_one, columns_of, smooth
from kurbel.plot.panel import (
    PIN_FORCE,
    MarkedPoint,
    Panel,
    PanelFrame,
    PinForce,
    Strokes,
    Trace,
    check_drawn,
    in_floats,
    named_again,
    panels_of,
    strokes_between,
    vector,
)
from kurbel.reading.given import as_angles
from kurbel.reading.notation import plain, ratio_text
from kurbel.reading.where import MAX, MIN, Condition

TURN = 360
# The decimals of an angle at which a mark is drawn.
DECIMALS = 12
# Values so near to each other, by the greatest, are one.
NEAR = 1e-9
AT = words("{number} bei {angle}|{number} at {angle}")
ROUNDING = "half-away"

# A curve's value at an angle.
Values = Callable[[float], float]


class _Found(NamedTuple):
    """A place of a curve: its angle from 0 to 360°, the value there, and the root that tells both."""

    angle: float
    value: float
    root: Root


def spots(
    drive: Drive,
    quantity: Quantity,
    values: Values,
    span: tuple[float, float],
    power: int,
    lang: str,
    times: Fraction = Fraction(1),
) -> list[MarkedPoint]:
    """Return where a quantity is greatest and least over the turn, with certified values and angles.

    The values are in the units of its axis, those of its page divided by a power of ten; they are so many
    `times` those of a metric page. A value of 0 has no name. Of a quantity that conditions do not know there
    are none, and none where two places are not told apart.
    """
    asked = _conditions(drive).get(quantity.key)
    if asked is None or not _is_solved(drive, asked) or drive.course(asked, OUT).is_constant:
        return []
    try:
        roots = [root for kind in (MAX, MIN) for root in solve(drive, Condition(asked, kind))]
    except UnsettledError:
        return []
    found = [one for root in roots for one in _on_curve(root, quantity, values, times)]
    near = NEAR * max((abs(one.value) for one in found), default=0.0)
    named: list[MarkedPoint] = []
    for end in dict.fromkeys(choose(one.value for one in found) for choose in (max, min) if found):
        alike = [one for one in found if abs(one.value - end) <= near < abs(end)]
        apart = {round(one.angle, 6) % TURN: one for one in reversed(alike)}
        named.extend(_named(apart.values(), quantity, span, times * Fraction(10) ** -power, lang))
    return named


def zeros(drive: Drive, quantity: Quantity, span: tuple[float, float], lang: str) -> list[MarkedPoint]:
    """Return where a quantity is zero over the turn, with certified angles."""
    asked = _conditions(drive).get(quantity.key)
    if asked is None or not _is_solved(drive, asked):
        return []
    try:
        roots = solve(drive, Condition(asked))
    except NoRootError:
        return []
    number = f"${quantity.symbol.strip('$')} = 0$"
    found = [(_float(root.angle(True, 1, DECIMALS, ROUNDING)), root) for root in roots]
    return [
        MarkedPoint(angle, 0.0, AT[lang].format(number=number, angle=_degrees(root, 0)))
        for angle, root in found
        if span[0] <= angle <= span[1]
    ]


def strokes_of(drive: Drive, span: tuple[float, float], lang: str) -> Strokes:
    """Return the strokes of a drive between dead centres, those at the ends of a span and all within."""
    inner, outer = (180 * float(place.half_turns().mid()) for place in drive.ends(OUT))
    names = [STROKES[stroke][lang] for stroke in (OUT, RETURN)]
    return strokes_between((inner, outer - 180), names, span, lang)


def _conditions(drive: Drive) -> dict[str, str]:
    """Return the names by which conditions know the columns of a drive."""
    known = {drive.column_of(name): name for name in dict.fromkeys(drive.names.values())}
    return known | {one.column: name for name, one in MEASURES.items() if name in drive.names}


def _is_solved(drive: Drive, asked: str) -> bool:
    """Whether it is proved where the quantity rises and falls."""
    one = drive.asked(asked, OUT)
    if one.exists:
        return False
    heavy = bool(getattr(drive.crank, "loaded", False)) and LOADED in one.formulas
    return heavy or one.rises or drive.jet(one) is not None


def _on_curve(root: Root, quantity: Quantity, values: Values, times: Fraction) -> Iterator[_Found]:
    """Yield a root if the curve over the turn has its value, maybe of the other sign.

    On the return a stroke counts the other way, and its path from the other dead centre.
    """
    angle = _float(root.angle(True, 1, DECIMALS, ROUNDING))
    value, drawn = _float(root.number(quantity.key, DECIMALS, ROUNDING, times)), values(angle)
    if abs(abs(drawn) - abs(value)) <= NEAR * abs(value):
        yield _Found(angle, drawn, root)


def _named(
    found: Iterable[_Found], quantity: Quantity, span: tuple[float, float], times: Fraction, lang: str
) -> Iterator[MarkedPoint]:
    """Yield the marks of places; of one that comes again after a turn, the first has the text."""
    for one in found:
        number = _number(one.root, quantity, times)
        signed = number._replace(scaled=abs(number.scaled) * (-1 if one.value < 0 else 1))
        turn = ceil((span[0] - one.angle) / TURN)
        text = AT[lang].format(number=f"${number_text(signed)}$", angle=_degrees(one.root, turn))
        yield from named_again(one.angle, one.value, TURN, span, text)


def _degrees(root: Root, turn: int) -> str:
    """Return the angle of a root in so many turns, in degrees and minutes."""
    minutes = root.angle(True, 60, 0, ROUNDING).scaled + 60 * TURN * turn
    return degrees_text(Fraction(minutes, 60)) if minutes % 60 else f"{minutes // 60}°"


def _number(root: Root, quantity: Quantity, times: Fraction) -> Number:
    """Return so many times the certified value, to as many figures as pages have."""
    if times != 1 or quantity.decimals is None:
        decimals = figures(_float(root.number(quantity.key, DECIMALS, ROUNDING, times)))
    else:
        decimals = quantity.decimals
    return root.number(quantity.key, decimals, ROUNDING, times)


def _float(number: Number) -> float:
    return float(Fraction(number.scaled, 10**number.decimals))


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


def over_angle(question: AngleQuestion, wish: DrawingWish) -> Picture:
    """Return what is drawn of drives over the crank angle: the columns of the page, both strokes as one turn.

    Beside the infinite rod its curves are dotted. Raises ProblemError.
    """
    if wish.polar:
        return _polar(question)
    if wish.over_path:
        from kurbel.plot.over_path import of_turn

        return of_turn(question, wish)
    asked = unfolded(question)
    beside = infinite(asked) if wish.infinite else None
    drives = asked.solved()
    return Picture(asked, motion_panels(asked, beside, drives), around(asked, drives, beside))


def unfolded(question: AngleQuestion) -> AngleQuestion:
    """Return the question over smooth angles; where both strokes stand side by side, over the whole turn."""
    columns = columns_of(question)
    usual = [*as_angles(question.layout.angles or "0")]
    both = _is_stroke(question.angles) and (question.has_return or [*question.angles] == usual)
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
    turn = (Fraction(0), Fraction(360)) if _is_stroke(question.angles) else question.angles
    asked = asked_of(page, columns=keys, angles=smooth(turn))
    return Picture(asked, force=pin_force(asked, drives[0]))


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
    lang, angles, told = question.lang, in_floats(question.angles), question.told
    drawn, keys = question.curves(np.asarray(angles)), [one.quantity.key for one in question.page_columns]
    for place, (column, of_drives) in enumerate(zip(question.page_columns, drawn, strict=True)):
        one = column.quantity
        alike = drive is not None and column.methods == (drive.method,)
        named = partial(_spots, question, place, drive) if drive is not None and alike else None
        for telling, values in zip(told, of_drives, strict=True):
            stroke = STROKES[one.stroke][lang] if one.stroke in STROKES else ""
            again = column.heading[-1] if keys.count(one.key) > 1 else ""
            yield Trace(one, (*telling, stroke, again), angles, values.tolist(), dotted, named)


def around(
    question: AngleQuestion, drives: Sequence[Drive], beside: AngleQuestion | None = None
) -> PanelFrame:
    """Return what a drawing says of its drives, and their strokes where all have the same."""
    span = float(question.angles[0]), float(question.angles[-1])
    strokes = [strokes_of(drive, span, question.lang) for drive in drives]
    said = drive_label(drives[0], question) if len(drives) == 1 and beside is None else ""
    alike = strokes and all(one == strokes[0] for one in strokes)
    return PanelFrame(said, strokes[0] if alike else None)


def drive_label(drive: Drive, question: AngleQuestion) -> Label:
    """Return what a drawing says of a drive: its crank ratio and its offset."""
    crank, parts = drive.crank, [ratio_label(drive.ratio)] if question.ratios else []
    if crank.offset:
        parts.append(f"$e = {plain(crank.offset)} R$")
    return ", ".join(parts)


def _spots(question: AngleQuestion, place: int, drive: Drive, power: int) -> Sequence[MarkedPoint]:
    """Return where the column at a place is greatest and least."""

    def value(angle: float) -> float:
        return float(question.curves(np.asarray([angle]))[place][0][0])

    span = float(question.angles[0]), float(question.angles[-1])
    one = question.page_columns[place].quantity
    times = question.of_page(question.entry(one.key).unit["en"])
    return spots(drive, one, value, span, power, question.lang, times)


def ratio_label(ratio: Fraction) -> Label:
    """Return what a drawing says of a crank ratio."""
    return f"$R:L = {ratio_text(ratio)}$"


def pin_force(request: AngleQuestion, drive: Drive) -> PinForce:
    """Return the force on the crank pin in the crank's frame, the names of its components, and their unit.

    The request has the columns `pin_force_keys`. The piston force is one and the same over the whole turn.
    """
    check_drawn(request.angles, 1)
    angles = in_floats(request.angles)
    values = [of_crank.tolist() for (of_crank,) in request.curves(np.asarray(angles))]
    strokes = strokes_of(drive, (angles[0], angles[-1]), request.lang)
    quantities = [column.quantity for column in request.page_columns]
    return vector(quantities, request.lang, angles, values, strokes)
