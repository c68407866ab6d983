"""Compasses and ruler on numbers of any kind: floats, balls, separation bounds.

Points are pairs of such numbers. Nothing here asks what a number is or which of two is greater: where two
points answer, the caller says which one by a sign.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from kurbel.kernel.circle import root


class Point(NamedTuple):
    """A point, or a vector, across and up."""

    x: Any
    y: Any


def plus(point: Point, vector: Point, times: Any = 1) -> Point:
    """Return a point moved by so many times a vector."""
    return Point(point.x + times * vector.x, point.y + times * vector.y)


def to(start: Point, end: Point) -> Point:
    """Return the vector from one point to another."""
    return Point(end.x - start.x, end.y - start.y)


def turned(vector: Point) -> Point:
    """Return the vector turned by 90° to the left."""
    return Point(-vector.y, vector.x)


def dot(one: Point, other: Point) -> Any:
    return one.x * other.x + one.y * other.y


def cross(one: Point, other: Point) -> Any:
    """Return the area between two vectors, positive where the second is on the left of the first."""
    return one.x * other.y - one.y * other.x


def distance(start: Point, end: Point) -> Any:
    """Return the length between two points; positive, and 0 where they are the same."""
    vector = to(start, end)
    return root(dot(vector, vector))


def foot(point: Point, start: Point, end: Point) -> Point:
    """Return where the perpendicular from a point meets the line through two others."""
    along = to(start, end)
    return plus(start, along, dot(to(start, point), along) / dot(along, along))


def meet(start: Point, along: Point, other: Point, way: Point) -> Point:
    """Return where a line through one point along a vector meets that through another along its vector."""
    return plus(start, along, cross(to(start, other), way) / cross(along, way))


def on_circle(start: Point, along: Point, centre: Point, radius: Any, side: int = 1) -> Point:
    """Return where a line meets a circle, the farther point along the vector (1) or the nearer (-1)."""
    back = to(centre, start)
    square, half = dot(along, along), dot(along, back)
    deep = root(half * half - square * (dot(back, back) - radius * radius))
    return plus(start, along, (side * deep - half) / square)


def circles(one: Point, radius: Any, other: Point, second: Any, side: int = 1) -> Point:
    """Return where two circles meet, on the left (1) or the right (-1) of the way between their centres."""
    way = to(one, other)
    square = dot(way, way)
    share = (square + radius * radius - second * second) / (2 * square)
    high = root(radius * radius / square - share * share)
    return plus(plus(one, way, share), turned(way), side * high)
