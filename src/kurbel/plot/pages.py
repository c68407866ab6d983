"""What is drawn of pages over other axes than the crank angle, and of an engine's free forces."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from fractions import Fraction
from math import ceil, isfinite, nan
from typing import NamedTuple

from kurbel.balancing.angles import AngleRequest
from kurbel.balancing.arrangement import IN_NEWTONS
from kurbel.balancing.balance_page import RESIDUALS, UNITS, WORDS, BalanceRequest
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number
from kurbel.page.axes import RATIO, Axis, ListAxis, PageAxis, Place, places
from kurbel.page.quantity import Column, Quantity, entry, words
from kurbel.page.subject import Question
from kurbel.plot.drawings import (
    DrawingWish,
    Picture,
    asked_of,
    check_one,
    columns_of,
    drawing_layout,
    refuse,
    smooth,
)
from kurbel.plot.panel import (
    HorizontalAxis,
    PanelFrame,
    PinForce,
    Ticks,
    Trace,
    Vector,
    axis_label,
    over_angle,
    panels_of,
    plain_ticks,
    value_ticks,
)

# What a page is drawn over where it has several places of it, in this order; then what has most places.
FIRST = ("angle", "share", "order", "expansion")
# How several places of an axis are typed, or several loads of a kind.
SEVERAL = {
    "ratio": "--ratio '1:4;1:5'", "steam": "--eps 2..6", "compressor": "--pressure-ratio 2..6",
    "gas": "--compression 4..8", "target": "--delta '1:100;1:50' with --columns inertia",
    "share": "--share '1/3;1/2'", "arm": "--beam '2;3'",
}  # fmt: skip
# What has no place between two of its own, and is drawn as lines from 0.
APART = ("order", "place")
# What pages have beside the same in other words.
DOUBLED = ("phi_turn", "x_stroke")
# The steps of a turn, whose values are certified one by one.
ANGLE_STEPS = 360
# So far apart are lines at one place.
BESIDE = 0.12


class _Across(NamedTuple):
    """The axis that a page is drawn over: its name, where its places are, and how it is written."""

    name: str
    places: Sequence[float]
    axis: HorizontalAxis | None


def over_axes(question: Question, wish: DrawingWish) -> Picture:
    """Return what is drawn of a page over the axis that has several places. Raises ProblemError for a page
    without one."""
    keys = tuple(one.key for one in columns_of(question) if one.key not in DOUBLED)
    # What is of one column has no names for it.
    keys = keys if "column" in question.axes else ()
    angles = getattr(question, "angles", ()) if "angle" in question.axes else ()
    many = {"angles": smooth(angles, ANGLE_STEPS)} if angles else {}
    return _drawn(asked_of(question, columns=keys, **many), wish)


def deviations(question: Question, wish: DrawingWish) -> Picture:
    """Return what is drawn of a collation: the differences of the printed values, place by place."""
    if question.columns:
        raise ProblemError("a drawing of a collation has its deviations; leave --columns out")
    return _drawn(question, wish, ("difference",))


def _drawn(asked: Question, wish: DrawingWish, keys: Sequence[str] = ()) -> Picture:
    sentence = "this page is drawn over an axis of its own; leave {} out"
    refuse(wish, infinite=sentence.format("--infinite"), over_path=sentence.format("--over-path"))
    across = _across(asked)
    # Of a value at one place there is no line.
    traces = [one for one in _traces(asked, across, keys) if sum(map(isfinite, one.values)) > 1]
    if not traces:
        raise ProblemError("the page has no number that could be drawn; name another column by --columns")
    if across.name in APART:
        traces = [*_stems(traces)]
    several = len({one.telling for one in traces}) > 1
    return Picture(asked, panels_of(traces, asked.lang, apart=several), PanelFrame(across=across.axis))


def _across(asked: Question) -> _Across:
    axes = {name: axis for name, axis in asked.axes.items() if name != "column" and axis.size > 1}
    known = {name: found for name, axis in axes.items() if (found := _numbers(asked, name, axis))}
    if not known:
        several = [SEVERAL[one] for one in (*asked.axes, *_loads(asked)) if one in SEVERAL]
        instead = f"give several values, {' or '.join(several)}" if several else asked.undrawn
        raise ProblemError(
            f"a drawing needs an axis with several places, and this page has one of each; {instead}"
        )
    name = next((one for one in FIRST if one in known), max(known, key=lambda one: len(known[one])))
    lang = asked.lang
    if name == "angle":
        return _Across(name, known[name], over_angle(lang))
    axis = axes[name]
    if name == "ratio":
        label = f"{RATIO[lang].removesuffix(' R:L')} $R/L$"
    else:
        field = axis.field() if isinstance(axis, Axis) else None
        label = axis_label(f"{field.name} {field.symbol}", field.unit) if field else axis.stub_heading()
    return _Across(name, known[name], HorizontalAxis(label, _whole_ticks if name in APART else plain_ticks))


def _loads(asked: Question) -> Iterator[str]:
    """Yield the kind of the loads, if the page has an axis of these."""
    loads = getattr(asked, "steams", getattr(asked, "loads", ())) if "expansion" in asked.axes else ()
    yield from (one.name for one in loads[:1])


def _numbers(asked: Question, name: str, axis: PageAxis) -> list[float]:
    """Return the numbers of an axis, none if its places are none."""
    if name == "ratio":
        return [float(ratio) for ratio in getattr(asked, "ratios", ())]
    if name == "place":
        return [float(place + 1) for place in range(axis.size)]
    if name == "angle":
        return [float(angle) for angle in getattr(asked, "angles", ())]
    if not isinstance(axis, Axis) or axis.found:
        return []
    if isinstance(axis, ListAxis):
        fractions = [one for one in axis.things if isinstance(one, Fraction)]
        if len(fractions) == axis.size:
            return [*map(float, fractions)]
    numbers = [_float(axis.value({name: place})) for place in range(axis.size)]
    # What is of all orders has no number.
    return numbers if any(map(isfinite, numbers)) and name != "stroke" else []


def _traces(asked: Question, across: _Across, keys: Sequence[str]) -> Iterator[Trace]:
    axes = {name: axis for name, axis in asked.axes.items() if name != "column"}
    others = {name: axis.size for name, axis in axes.items() if name != across.name}
    columns = [(place, one) for place, one in enumerate(asked.page_columns) if not keys or one.key in keys]
    found = [axis for axis in axes.values() if isinstance(axis, Axis) and axis.found and axis.field().symbol]
    quantities: list[tuple[Quantity, Axis | tuple[int, Column]]] = [
        *((_of_axis(axis), axis) for axis in found),
        *((one.quantity, (place, one)) for place, one in columns),
    ]
    for quantity, what in quantities:
        for place in places(others, lambda place: True):
            telling = tuple(axes[name].over_group(place) for name, size in others.items() if size > 1)
            values = [
                _at(asked, what, {**place, across.name: number}) for number in range(len(across.places))
            ]
            ranked = sorted(zip(across.places, values, strict=True))
            drawn = [(where, value) for where, value in ranked if isfinite(where)]
            yield Trace(quantity, telling, [where for where, _ in drawn], [value for _, value in drawn])


def _of_axis(axis: Axis) -> Quantity:
    """Return what is found on an axis as a quantity."""
    field = axis.field()
    return entry(field.key, field.name, field.symbol, field.unit, field.decimals, {})


def _at(asked: Question, what: Axis | tuple[int, Column], place: Mapping[str, int]) -> float:
    if not asked.subject.exists(asked, place):
        return nan
    if isinstance(what, Axis):
        return _float(what.value(place))
    number, column = what
    found = asked.number(column, {**place, "column": number})
    return 0.0 if found is None and column.key == "difference" else _float(found)


def _float(value: object) -> float:
    return value.scaled / 10**value.decimals if isinstance(value, Number) else nan


def _stems(traces: Sequence[Trace]) -> Iterator[Trace]:
    """Yield the traces as lines from 0 at their places, those of one unit beside one another."""
    units = [one.quantity.unit["en"] for one in traces]
    for number, one in enumerate(traces):
        beside, count = units[:number].count(units[number]), units.count(units[number])
        shift = BESIDE * (beside - (count - 1) / 2) if count > 1 else 0.0
        angles, values = [min(one.angles) - 0.5], [nan]
        for place, value in zip(one.angles, one.values, strict=True):
            angles += [place + shift, place + shift + 1e-6, place + shift + 2e-6]
            values += [0.0, value, nan]
        yield one._replace(angles=[*angles, max(one.angles) + 0.5], values=[*values, nan])


def _whole_ticks(low: float, high: float, mark: str, most: int) -> Ticks:
    """Return ticks at whole numbers, in so many steps at most."""
    step = Fraction(max(1, ceil((high - low) / most)))
    return value_ticks(max(low, 1), high, step, 0, mark)


# The steps of the turn; each takes exact numbers.
STEPS = 120
# A share of the greatest value that is none.
NEARLY = 1e-3
NEWTONS = {"force": "N", "moment": "N m"}
ALONG, ACROSS = "along", "across"
TITLE = words("Polardiagramm: {residual}, {caption}|Polar diagram: {residual}, {caption}")


def unbalanced(request: BalanceRequest, wish: DrawingWish) -> Picture:
    """Return the free force over the turn, of an engine without one the free moment, of all orders together.

    Raises ProblemError where both are balanced.
    """
    sentence = "free forces are drawn as their vector; leave {} out"
    refuse(wish, infinite=sentence.format("--infinite"), over_path=sentence.format("--over-path"))
    check_one(len(request.ratios), "crank ratios")
    own = {one.name: getattr(request, one.name) for one in fields(BalanceRequest)}
    newtons = IN_NEWTONS if request.weighed is not None else ""
    angles = smooth((Fraction(0), Fraction(360)), STEPS)
    asked = AngleRequest(
        **{
            **own,
            "layout": drawing_layout("balance-angle"),
            "columns": (ACROSS + newtons, ALONG + newtons),
            "digits": None,
            "angles": angles,
        }
    )
    found = {key: _force(asked, place, newtons) for place, key in enumerate(RESIDUALS)}
    most = {key: max(map(abs, (*one.vector.across, *one.vector.up))) for key, one in found.items()}
    if not any(most.values()):
        raise ProblemError(
            "all free forces and moments of this engine are balanced; there is nothing to draw"
        )
    # What is left of high orders alone is not drawn.
    key = next(key for key in RESIDUALS if most[key] > NEARLY * max(most.values()))
    caption = asked.subject.caption(asked)
    title = TITLE[request.lang].format(residual=WORDS[key][request.lang], caption=caption)
    return Picture(asked, force=found[key], title=title)


def _force(asked: AngleRequest, residual: int, newtons: str) -> PinForce:
    """Return the vector of all orders together over the angles."""
    key, last = RESIDUALS[residual], len(asked.lines) - 1
    places = [
        {"ratio": 0, "residual": residual, "angle": angle, "order": last}
        for angle in range(len(asked.angles))
    ]

    def value(column: Column, place: Place) -> float:
        found = asked.number(column, place)
        return float(found.scaled) / 10**found.decimals if isinstance(found, Number) else 0.0

    across, up = ([value(column, place) for place in places] for column in asked.page_columns)
    name, words = WORDS[key][asked.lang], [one.quantity.heading[asked.lang] for one in asked.page_columns]
    names = f"{name} {words[0].partition(' in ')[0]}", f"{name} {words[1].partition(' in ')[0]}"
    unit = NEWTONS[key] if newtons else UNITS[key]
    return PinForce(Vector([*map(float, asked.angles)], across, up), names, unit, ways=("", ""))
