"""What drawings show over the piston's path: of a crank drive the velocity ellipse and the acceleration
curve, and over the strokes the pressures on a piston, with those of the masses laid under the indicator
diagram, and the forces of an engine, the strokes of a cycle over one another."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import groupby
from math import cos, nan, pi
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kurbel.conditions.over import ANGLES, WORDS, PathRequest
from kurbel.engine.captions import inner
from kurbel.engine.pressures import PressureDrive, PressuresRequest, StrokePlace, is_carded, stroke_names
from kurbel.engine.request import EngineRequest
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls, floats
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import circle
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import OUT, STROKES, method_named
from kurbel.motion.mechanism import Mechanism, mechanism
from kurbel.motion.motion_page import AngleQuestion
from kurbel.page.quantity import Column, Quantity, Texts, enumerated, filled, for_ratio, words
from kurbel.plot.curves import drive_label, infinite, ratio_label, spots, unfolded, zeros
from kurbel.plot.drawings import DrawingWish, Picture, asked_of, columns_of, drawing_layout, refuse, smooth
from kurbel.plot.engine import around, course_of, lettered, turns_of
from kurbel.plot.panel import (
    DEAD_CENTRES,
    Curve,
    HorizontalAxis,
    MarkedPoint,
    Panel,
    PanelFrame,
    Strokes,
    Ticks,
    Trace,
    again,
    axis_name,
    check_drawn,
    in_floats,
    panels_of,
    plain_ticks,
    titled,
)

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn

PRESSED = Texts("engine", "pressed")

# What is drawn to scale, R, v and v²/R of one length, by the beginning of its key.
VELOCITY, ACCELERATION = ("c", "velocity"), ("p", "acceleration")
_UNIT = re.compile(r"_mps2?$")
# Marks of the crank angle, and where arrows point along a curve and have its stroke beside them.
MARKS, ARROWS = range(0, 360, 30), {45: OUT, 225: -OUT}
# Degrees from which a direction is taken, and a share of the greatest value that is none.
NEAR_BY, NOTHING = 1e-4, 1e-6
STROKE = words("Hub|Stroke")
EQUAL = words("$R$, $v$ und $v^2/R$ gleich lang|$R$, $v$ and $v^2/R$ of one length")


def over_path(question: PathRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of drives over the path of the piston: the columns of the page, each as one curve
    of both strokes."""
    refuse(wish, polar="a polar diagram is over the turn; leave --polar out")
    chosen = mechanism(question.mechanism)
    forces = question.subject.key == "forces over path"
    drives = tuple(one.drive for one in question.drives)
    asked = chosen.question(
        drives,
        question.method,
        layout=drawing_layout(chosen.forces_layout if forces else chosen.layout),
        angles=smooth((Fraction(0), Fraction(360))),
        lang=question.lang,
        caption=question.caption,
        units=question.units,
        columns=names_over(chosen, drives, columns_of(question), bool(question.columns)),
    )
    return _picture(asked, wish)


def of_turn(question: AngleQuestion, wish: DrawingWish) -> Picture:
    """Return the same of drives over the crank angle, with the columns of their page."""
    chosen, asked = mechanism(question.moving[0] if question.moving else "straight"), unfolded(question)
    if not (chosen.conditions() and asked.solved()):
        raise ProblemError(f"{asked.subject.key} are drawn over the crank angle; leave --over-path out")
    keys = names_over(chosen, asked.drives, asked.page_columns, bool(question.columns))
    return _picture(replace(asked, columns=keys), wish)


def _picture(asked: AngleQuestion, wish: DrawingWish) -> Picture:
    drawing = PathDrawing(asked, asked.solved(), infinite(asked) if wish.infinite else None)
    return Picture(asked, drawing.panels(), drawing.around(), title=drawing.title)


def names_over(
    chosen: Mechanism, drives: Sequence[Drive], columns: Sequence[Column], named: bool
) -> tuple[str, ...]:
    """Return the path, in mm where lengths are known, and what is drawn over it: the columns but for angles
    and, unless it was named, the path."""
    path, in_mm = chosen.motion[0]
    own = path if chosen.crank(drives[0]).radius is None else in_mm
    back = next((one.key for one in columns if named and "_return" in one.key), "")
    if back:
        raise ProblemError(
            f"column {back} is of the return stroke, and over the path both strokes are one curve; write"
            f" {back.replace('_return', '')}"
        )
    keys = dict.fromkeys(one.key for one in columns if one.key not in ANGLES and "_return" not in one.key)
    drawn = [one for one in keys if one != own and (named or one not in (path, in_mm))]
    if not drawn:
        raise ProblemError(
            "a path over itself is a straight line; name another column, such as --columns c,p"
        )
    return (own, *drawn)


class PathDrawing:
    """Drives over the path that is the first column of what is asked for; drives as conditions see them."""

    def __init__(
        self, question: AngleQuestion, drives: Sequence[Drive], beside: AngleQuestion | None = None
    ) -> None:
        check_drawn(question.angles, max(len(question.ratios), 1) + (beside is not None))
        self.question, self.drives, self.beside, self.lang = question, drives, beside, question.lang
        given = in_floats(question.angles)
        ends = [end for drive in drives for end in _dead_centres(drive, given[0], given[-1])]
        # With them a curve has its ends, and never the same path twice one after the other.
        self.angles = np.union1d(given, ends)

    @property
    def alone(self) -> Drive | None:
        """The drive of a drawing of one."""
        return self.drives[0] if len(self.drives) == 1 else None

    def panels(self) -> list[Panel]:
        """Return a panel for each quantity, or of one drive for each unit. Raises ProblemError."""
        own = self._traces(self.question, dotted=False)
        traces = [*own, *(self._traces(self.beside, dotted=True) if self.beside else ())]
        apart = len(self.question.ratios) > 1 or self.beside is not None
        found = panels_of(traces, self.lang, apart=apart)
        named = ((axis_name(one.quantity, self.lang), self._scale(one.quantity)) for one in traces)
        scales = {titled(name, heading): scale for (name, heading, _), scale in named}
        return [panel._replace(scale=scales.get(panel.label)) for panel in found]

    def around(self) -> PanelFrame:
        """Return the axis of the path, the dead centres, and what is drawn."""
        name, heading, unit = axis_name(self._columns[0].quantity, self.lang)
        known = bool(unit) and any(self._scale(one.quantity) for one in self._columns[1:])
        label = f"{name} {heading}" + (f" in {unit}" if unit else "")
        said = drive_label(self.drives[0], self.question) if self.alone and self.beside is None else ""
        paths = [value for path in self._paths(self.question) for value in path]
        ends = (min(paths), max(paths))
        if known:
            label += f" ({EQUAL[self.lang]})"
        return PanelFrame(said, self._strokes(ends), HorizontalAxis(label, partial(_ticks, ends)))

    @property
    def _columns(self) -> Sequence[Column]:
        return self.question.page_columns

    def _paths(self, question: AngleQuestion) -> list[list[float]]:
        return [path.tolist() for path in question.curves(self.angles)[0]]

    def _strokes(self, ends: tuple[float, float]) -> Strokes | None:
        """Return the one stroke between the dead centres, if all drives have these and the turn is whole."""
        longest = [max(path) for path in self._paths(self.question)]
        angles, near = self.question.angles, NOTHING * ends[1]
        if max(longest) - min(longest) > near or angles[-1] - angles[0] < 360:
            return None
        dead = [DEAD_CENTRES[which][self.lang] for which in ("inner", "outer")]
        return Strokes(ends, dead, [STROKE[self.lang]])

    def _traces(self, question: AngleQuestion, dotted: bool) -> Iterator[Trace]:
        paths, *drawn = question.curves(self.angles)
        for place, of_drives in enumerate(drawn, 1):
            one = question.page_columns[place].quantity
            for ratio, (path, values) in enumerate(zip(paths, of_drives, strict=True)):
                stroke = STROKES[one.stroke][self.lang] if one.stroke in STROKES else ""
                told = (ratio_label(question.ratios[ratio]), stroke) if question.ratios else ()
                named = partial(self._spots, place) if self.alone and not dotted else None
                seen = self._once(question, place, ratio)
                yield Trace(one, told, path[seen].tolist(), values[seen].tolist(), dotted, named)

    def _once(self, question: AngleQuestion, place: int, ratio: int) -> NDArray[np.bool_]:
        """Return which angles are drawn: of a return over the curve of the outstroke none, lest a pattern be
        drawn twice."""
        first, last = self.angles[0], self.angles[-1]
        there, back = (question.curves(angles) for angles in (self.angles, first + last - self.angles))
        pairs = ((there[one][ratio], back[one][ratio]) for one in (0, place))
        alike = all(np.abs(one - other).max() <= NOTHING * np.abs(one).max() for one, other in pairs)
        return self.angles <= (first + last) / 2 if alike else np.ones(len(self.angles), bool)

    def _scale(self, quantity: Quantity) -> float | None:
        """Return how much of a quantity is as long as a unit of the path: v and v²/R as long as R."""
        if _UNIT.sub("", quantity.key) not in (*VELOCITY, *ACCELERATION):
            return None
        one, path = (
            float(each.scale(self.drives[0].crank, floats())) if each.scale else 1.0
            for each in (quantity, self._columns[0].quantity)
        )
        return one / path

    def _spots(self, place: int, power: int) -> Sequence[MarkedPoint]:
        """Return what is named in the curve of a column: extremes, zeros, angles, strokes."""
        drive, quantity = self.drives[0], self._columns[place].quantity
        span = float(self.angles[0]), float(self.angles[-1])

        def value(angle: float) -> float:
            return self._at(angle, place)[1]

        key = _UNIT.sub("", quantity.key)
        times = self.question.of_page(self.question.entry(quantity.key).unit["en"])
        found = spots(drive, quantity, value, span, power, self.lang, times)
        if key in ACCELERATION:
            found += zeros(drive, quantity, span, self.lang)
        if key in VELOCITY:
            found += [
                MarkedPoint(float(mark), value(mark), f"$φ = {mark}°$" if mark == MARKS[1] else f"{mark}°")
                for mark in MARKS
                if _within(mark, span)
            ]
        over = [one._replace(angle=self._at(one.angle, place)[0]) for one in found]
        return [*_apart(over), *self._ways(place, span)]

    def _ways(self, place: int, span: tuple[float, float]) -> Iterator[MarkedPoint]:
        """Yield arrowheads with the names of the strokes, where these have curves of their own."""
        apart = np.abs(np.subtract(self._at(105, place), self._at(255, place)))
        if apart.max() < NOTHING * max(1.0, *np.abs(self._at(105, place))):
            return
        for angle, stroke in ARROWS.items():
            if _within(angle, span):
                here, there = (np.asarray(self._at(one, place)) for one in (angle, angle + NEAR_BY))
                across, up = (there - here) / NEAR_BY
                yield MarkedPoint(
                    float(here[0]), float(here[1]), STROKES[stroke][self.lang], (float(across), float(up))
                )

    def _at(self, angle: float, place: int) -> tuple[float, float]:
        """Return path and value at an angle."""
        found = self.question.curves(np.asarray([angle], float))
        return float(found[0][0][0]), float(found[place][0][0])

    @property
    def title(self) -> Label:
        """What is drawn, over what and of which drive."""
        names = (column.quantity.name[self.lang] for column in self._columns[1:])
        one = len(self.question.ratios) == 1 and self.beside is None
        parts = {
            "{quantities}": enumerated(names, self.lang),
            "{for_ratio}": for_ratio(self.question.ratios[0], self.lang) if one else "",
            "{method}": method_named(self.drives[0].method).caption[self.lang],
        }
        return filled(WORDS["caption"][self.lang], parts.items())


def _ticks(ends: tuple[float, float], low: float, high: float, mark: str, most: int) -> Ticks:
    """Return the ticks of the path between the dead centres, beyond which there is none."""
    found, near = plain_ticks(low, high, mark, most), NOTHING * (ends[1] - ends[0])
    kept = [
        (place, text) for place, text in zip(*found, strict=True) if ends[0] - near <= place <= ends[1] + near
    ]
    places, texts = zip(*kept, strict=True) if kept else ((), ())
    return Ticks(places, texts)


def _dead_centres(drive: Drive, first: float, last: float) -> Iterator[float]:
    """Yield the dead centres of a drive between two angles."""
    for place in drive.ends(OUT):
        yield from again(180 * float(place.half_turns().mid()), 360, first, last)


def _within(angle: float, span: tuple[float, float]) -> bool:
    return span[0] <= angle <= span[1]


def _apart(found: Sequence[MarkedPoint]) -> list[MarkedPoint]:
    """Return the spots without those where another one is: the strokes of a straight crank share a curve."""
    near = NOTHING * max((abs(one.value) for one in found), default=nan)
    kept: list[MarkedPoint] = []
    for one in found:
        if all(max(abs(one.angle - other.angle), abs(one.value - other.value)) > near for other in kept):
            kept.append(one)
    return kept


# So many steps of a stroke make its curves smooth; they are closer near the dead centres.
STEPS = 120


def over_stroke(request: PressuresRequest, wish: DrawingWish) -> Picture:
    """Return what is drawn of the pressures: those of the page, over each stroke."""
    sentence = "pressures are drawn over the strokes; leave {} out"
    refuse(wish, infinite=sentence.format("--infinite"), over_path=sentence.format("--over-path"))
    keys = tuple(one.key for one in request.page_columns if one.quantity.plain_unit("en") != "°")
    if not keys:
        raise ProblemError("there is no pressure to draw; name one, such as --columns gas_pressure")
    asked = asked_of(request, columns=keys)
    return Picture(asked, pressure_panels(asked), PanelFrame(across=across_stroke(request.lang)))


def pressure_panels(request: PressuresRequest) -> list[Panel]:
    """Return a panel for each stroke, over the share of the outstroke: a return runs back over it.

    The request has the columns that are drawn.
    """
    names, lang = stroke_names(request.pressed.cycle, request.lang), request.lang
    columns, times = request.page_columns, float(request.of_page("bar"))
    # Their letters stand beside the curves.
    said = PRESSED["pressures"][lang] if len(columns) > 1 else inner(columns[0].quantity.name[lang], lang)
    panels = []
    for stroke, name in enumerate(names):
        places = [StrokePlace(stroke, share) for share in _shares(request.pressed, stroke)]
        # From left to right.
        places = places[::-1] if stroke % 2 else places
        across = [
            float(1 - one.share if stroke % 2 else one.share) for one in places if one.share is not None
        ]
        curves = [
            Curve(
                column.quantity.symbol,
                across,
                [times * _value(request.pressed, column.key, one) for one in places],
            )
            for column in columns
        ]
        panels.append(Panel(curves, f"{name}: {said}", columns[0].quantity.plain_unit(lang)))
    return panels


def across_stroke(lang: str) -> HorizontalAxis:
    """Return the axis of the share of the stroke."""
    return HorizontalAxis(f"{PRESSED['share'][lang]} $x/S$", plain_ticks)


def _shares(pressed: PressureDrive, stroke: int) -> list[Fraction]:
    """Return rising shares of a stroke, the corners of the force among them."""
    even = [Fraction(1 - cos(pi * step / STEPS)) / 2 for step in range(STEPS + 1)]
    corners: list[Fraction] = []
    if pressed.engine is not None:
        acting = pressed.engine.steam.strokes(floats(), pressed.engine.double)[stroke]
        # An indicator card has points in place of corners.
        corners = [Fraction(float(one)) for one in getattr(acting, "corners", ())]
    within = sorted({share for share in (*even, *corners) if 0 <= share <= 1})
    return [share for share, _ in groupby(within)]


def _value(pressed: PressureDrive, key: str, where: StrokePlace) -> float:
    carded = is_carded(pressed)
    masses = 0.0 if key == "gas_pressure" else float(pressed.masses(where, balls()))
    if key == "inertia_pressure":
        return masses
    kind: Kind = floats() if carded else balls()
    return float(pressed.gas(where, kind)) - masses


def force_panels_over_path(request: EngineRequest) -> list[Panel]:
    """Return the panels of forces over the share of the stroke of the first crank's piston."""
    turns = turns_of(request)
    traces = []
    for column in lettered(request):
        for label, turn in turns:
            course = course_of((column.quantity,), turn, request.angles)
            traces.append(Trace(column.quantity, (label,), _gone(turn, course.angles), course.values[0]))
    return panels_of(traces, request.lang, apart=len(turns) > 1)


def around_path(request: EngineRequest) -> PanelFrame:
    """Return what stands around them: what the engines have in common, the stroke, the axis."""
    dead = [DEAD_CENTRES[which][request.lang] for which in ("inner", "outer")]
    whole = Strokes((0.0, 1.0), dead, [STROKE[request.lang]])
    strokes = whole if request.angles[-1] - request.angles[0] >= 180 else None
    return around(request, strokes=False)._replace(strokes=strokes, across=across_stroke(request.lang))


def _gone(turn: AnyTurn, angles: Iterable[float]) -> list[float]:
    """Return how much of its stroke the piston has gone from the inner dead centre at angles in degrees."""
    moved = turn.cylinder.drive
    return [float(moved.path(0, circle(angle))) / float(moved.length) for angle in angles]
