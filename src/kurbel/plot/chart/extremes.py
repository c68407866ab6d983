"""Where a crank drive's quantities are greatest and least, as `kurbel solve` has it, and its strokes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from math import ceil, floor
from typing import NamedTuple

from kurbel.conditions.solve import MEASURES, Root, solve
from kurbel.errors import NoRootError
from kurbel.exact.numerals import Number, degrees_text, figures, number_text
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import LOADED, OUT, RETURN, STROKES
from kurbel.page.quantity import Quantity, words
from kurbel.plot.chart.model import Spot, Strokes
from kurbel.plot.sketch import DEAD_CENTRES
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
) -> list[Spot]:
    """Return where a quantity is greatest and least over the turn, with certified values and angles.

    The values are in the units of its axis, those of its page divided by a power of ten; they are so many
    `times` those of a metric page. A value of 0 has no name. Of a quantity that conditions do not know there
    are none.
    """
    asked = _conditions(drive).get(quantity.key)
    if asked is None or not _is_solved(drive, asked) or drive.course(asked, OUT).is_constant:
        return []
    roots = (root for kind in (MAX, MIN) for root in solve(drive, Condition(asked, kind)))
    found = [one for root in roots for one in _on_curve(root, quantity, values, times)]
    near = NEAR * max((abs(one.value) for one in found), default=0.0)
    named: list[Spot] = []
    for end in dict.fromkeys(choose(one.value for one in found) for choose in (max, min) if found):
        alike = [one for one in found if abs(one.value - end) <= near < abs(end)]
        apart = {round(one.angle, 6) % TURN: one for one in reversed(alike)}
        named.extend(_named(apart.values(), quantity, span, times * Fraction(10) ** -power, lang))
    return named


def zeros(drive: Drive, quantity: Quantity, span: tuple[float, float], lang: str) -> list[Spot]:
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
        Spot(angle, 0.0, AT[lang].format(number=number, angle=_degrees(root, 0)))
        for angle, root in found
        if span[0] <= angle <= span[1]
    ]


def strokes_of(drive: Drive, span: tuple[float, float], lang: str) -> Strokes:
    """Return the strokes of a drive between dead centres, those at the ends of a span and all within."""
    first, last = (180 * float(place.half_turns().mid()) for place in drive.ends(OUT))
    turns = range(floor((span[0] - last) / TURN), ceil((span[1] - first) / TURN) + 1)
    ends = [TURN * turn + end for turn in turns for end in (first, last)]
    names = [STROKES[stroke][lang] for _ in turns for stroke in (OUT, RETURN)]
    dead = [DEAD_CENTRES[which][lang] for _ in turns for which in ("inner", "outer")]
    kept = [
        number
        for number, end in enumerate(ends)
        if span[0] - TURN < end < span[1] + TURN and _touches(ends, number, span)
    ]
    begin, beyond = kept[0], kept[-1] + 1
    return Strokes(ends[begin:beyond], dead[begin:beyond], names[begin : beyond - 1])


def _touches(ends: Sequence[float], number: int, span: tuple[float, float]) -> bool:
    """Whether a stroke that begins or ends at a dead centre is seen."""
    before, after = ends[max(number - 1, 0)], ends[min(number + 1, len(ends) - 1)]
    return before < span[1] and after > span[0]


def _conditions(drive: Drive) -> dict[str, str]:
    """Return the names by which conditions know the columns of a drive."""
    known = {drive.column_of(name): name for name in dict.fromkeys(drive.names.values())}
    return known | {one.column: name for name, one in MEASURES.items() if name in drive.names}


def _is_solved(drive: Drive, asked: str) -> bool:
    """Whether it is proved where the quantity rises and falls."""
    one = drive.asked(asked, OUT)
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
) -> Iterator[Spot]:
    """Yield the marks of places; of one that comes again after a turn, the first has the text."""
    for one in found:
        number = _number(one.root, quantity, times)
        signed = number._replace(scaled=abs(number.scaled) * (-1 if one.value < 0 else 1))
        turns = range(ceil((span[0] - one.angle) / TURN), floor((span[1] - one.angle) / TURN) + 1)
        for turn in turns:
            text = AT[lang].format(number=f"${number_text(signed)}$", angle=_degrees(one.root, turn))
            yield Spot(one.angle + TURN * turn, one.value, text if turn == turns[0] else "")


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
