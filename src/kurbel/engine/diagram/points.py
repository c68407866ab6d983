"""A torque by points of its diagram, joined by straight lines: 0:0; 60:90; 180:0, or every 30°: 0; 45; 90,
or a CSV file; or by the areas of triangles.

    angle [°];torque [N m]
    0;0
    60;90
    180;0

An angle that comes twice is a jump. The points cover a cycle: the last is at its end, or no farther from the
first of the next cycle than two neighbours are from each other. Columns are in any order, more of them are
ignored; semicolons, tabs or commas part them.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import groupby, pairwise
from typing import NamedTuple

from kurbel.engine.diagram.torque import MOST_TURNS, TURN, Line, Torque, Waves
from kurbel.errors import NotationError, ProblemError
from kurbel.reading import notation, units
from kurbel.reading.csv_file import Column, Head, Kind, check_once, digits_and_unit, read_head, read_rows
from kurbel.reading.notation import about

KIND = Kind("turning-moment diagram", "point", NotationError)
MOST_POINTS = 10_000
_COLUMNS = ("angle", "torque")
_SPACED = re.compile(r"\s*(?:every|alle)\s+([^:]*):(.*)", re.DOTALL)
_DEGREES = ("", "°", "deg", "degree", "degrees", "°CA", "degCA")


class Point(NamedTuple):
    """A torque in N m at an angle in degrees."""

    angle: Fraction
    torque: Fraction


def points_of(text: str, what: str = "torque") -> list[Point]:
    """Return the points of "0:0; 60:90; 180:0" or of "every 30°: 0; 45; 90", which begin at 0°.

    A torque may have its unit, 60:0,09kNm.
    """
    if spaced := _SPACED.fullmatch(text):
        step = notation.angle(spaced[1], f"{what}: angle")
        if step <= 0:
            raise NotationError(f"the {what} has points every {about(step)}°; write a step above 0")
        if ";" not in spaced[2]:
            raise NotationError(
                f"the {what} has no ; between its values every {about(step)}°; write them as in"
                ' "every 30°: 0; 45; 90"'
            )
        torques = (_torque(part, what) for part in spaced[2].split(";"))
        return [Point(number * step, torque) for number, torque in enumerate(torques)]
    found = []
    for part in text.split(";"):
        angle, sign, torque = part.partition(":")
        if not sign:
            raise NotationError(
                f"the {what} has the part {notation.quoted(part.strip())}, which is no point; write an angle"
                " and a torque, 0:0; 60:90; 180:0"
            )
        found.append(Point(notation.angle(angle, f"{what}: angle"), _torque(torque, what)))
    return found


def triangles(areas: Sequence[Fraction], turns: Fraction) -> Torque:
    """Return the torque, in J per degree, of triangles alike in width one behind the other over a cycle.

    `areas` are those between them and the line of no torque, in J. The swing does not depend on where in
    their widths the peaks are, which are taken in the middle.
    """
    if not 2 <= len(areas) <= MOST_POINTS:
        raise ProblemError(f"{len(areas)} triangles were given; a diagram has 2 to {MOST_POINTS}")
    width = turns * TURN / len(areas)
    points = [Point(Fraction(0), Fraction(0))]
    for number, area in enumerate(areas):
        begun = number * width
        points += [Point(begun + width / 2, 2 * area / width), Point(begun + width, Fraction(0))]
    return Torque(Waves({}), tuple(_lines(points)))


def _torque(text: str, what: str) -> Fraction:
    if any(map(str.isalpha, text.strip().lower().rstrip("e"))) and not text.strip()[-1].isdecimal():
        return units.signed_torque(text, what)
    return notation.number(text, what)


def read_points(path: str | os.PathLike[str]) -> list[Point]:
    """Return the points in a CSV file; the text above says how it is written."""
    starts = "a turning-moment diagram starts with the heads angle and torque"
    return list(read_rows(path, KIND, _head, _point, starts))


def _head(line: str) -> Head:
    head, fields = read_head(line, _COLUMNS)
    check_once(head, KIND.noun)
    missing = [name for name in _COLUMNS if name not in [column.name for column in head.columns]]
    if missing:
        raise NotationError(
            f"there is no column {' and no '.join(missing)}; the heads are {', '.join(fields)[:60]}, and a"
            " turning-moment diagram needs angle and torque [N m]"
        )
    return head


def _point(texts: list[str], head: Head, line: int) -> Point:
    angle, torque = (
        _measured(text, column, head.delimiter) for text, column in zip(texts, head.columns, strict=True)
    )
    return Point(angle, torque)


def _measured(text: str, column: Column, delimiter: str) -> Fraction:
    digits, unit = digits_and_unit(text, column, delimiter, "8.1")
    value = notation.number(digits, column.name)
    if column.name == "torque":
        return value * (units.signed_torque(f"1 {unit}", "unit of the torque") if unit else 1)
    if unit not in _DEGREES:
        raise NotationError(f'angle has the unit "{unit[:40]}"; crank angles are in degrees, °')
    return value


def torque_through(points: Sequence[Point], turns: Fraction | None, what: str) -> Torque:
    """Return the torque of lines through points, over a cycle of these turns, or to the last point."""
    if len(points) > MOST_POINTS:
        raise ProblemError(f"the {what} has {len(points)} points; at most {MOST_POINTS} are allowed")
    _check_order(points, what)
    cycle = _cycle(points, turns, what)
    return Torque(Waves({}), tuple(_lines(_closed(points, cycle, what))))


def _check_order(points: Sequence[Point], what: str) -> None:
    if len({point.angle for point in points}) < 2:
        raise ProblemError(f"the {what} has points at one angle only; a diagram has at least two")
    if points[0].angle < 0:
        raise ProblemError(
            f"the {what} begins at {about(points[0].angle)}°; angles count from 0°, where its cycle begins"
        )
    for one, two in pairwise(points):
        if two.angle < one.angle:
            raise ProblemError(
                f"the {what} has {about(two.angle)}° behind {about(one.angle)}°; the angles of its points"
                " must rise, or be the same twice for a jump"
            )
    for angle, several in groupby(points, key=lambda point: point.angle):
        if len([*several]) > 2:
            raise ProblemError(f"the {what} has more than two points at {about(angle)}°; a jump has two")


def _cycle(points: Sequence[Point], turns: Fraction | None, what: str) -> Fraction:
    last = points[-1].angle
    if turns is None:
        if last % TURN or last > MOST_TURNS * TURN:
            raise ProblemError(
                f"the points of the {what} end at {about(last)}°, and no number of turns was given; add"
                f" --turns, of which {last / TURN} means that the diagram comes again from there on, or"
                " points up to whole turns, with the torque 0 where there is none"
            )
        return last
    if last > turns * TURN:
        raise ProblemError(
            f"the points of the {what} end at {about(last)}°, and a cycle of {turns} turns at"
            f" {about(turns * TURN)}°; give more turns or fewer points"
        )
    return turns * TURN


def _closed(points: Sequence[Point], cycle: Fraction, what: str) -> list[Point]:
    """Return the points with one at the beginning and one at the end of the cycle."""
    first, last = points[0], points[-1]
    gap = cycle - last.angle + first.angle
    if gap > max(two.angle - one.angle for one, two in pairwise(points)):
        raise ProblemError(
            f"the points of the {what} run from {about(first.angle)}° to {about(last.angle)}°, and the cycle"
            f" to {about(cycle)}°; add points up to there, with the torque 0 where there is none, or --turns"
            " for a diagram that comes again sooner"
        )
    if not gap:
        return [*points]
    level = last.torque + (first.torque - last.torque) * (cycle - last.angle) / gap
    begun = [Point(Fraction(0), level)] if first.angle else []
    ended = [Point(cycle, level)] if last.angle < cycle else []
    return [*begun, *points, *ended]


def _lines(points: Iterable[Point]) -> Iterable[Line]:
    for one, two in pairwise(points):
        if two.angle > one.angle:
            slope = (two.torque - one.torque) / (two.angle - one.angle)
            yield Line(one.angle, two.angle, one.torque, slope)
