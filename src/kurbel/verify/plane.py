"""Points and arrows of a plane: lines and circles meet, and an arrow turns."""

from __future__ import annotations

from typing import Any, NamedTuple

# A number or a jet.
Coordinate = Any


class Arrow(NamedTuple):
    """Along the slide from the shaft to the cylinder, and to the side of the crank pin on the outstroke."""

    x: Coordinate
    y: Coordinate

    def plus(self, other: Arrow) -> Arrow:
        return Arrow(self.x + other.x, self.y + other.y)

    def minus(self, other: Arrow) -> Arrow:
        return Arrow(self.x - other.x, self.y - other.y)

    def times(self, factor: Coordinate) -> Arrow:
        return Arrow(self.x * factor, self.y * factor)

    def right(self) -> Arrow:
        """A quarter turn to the right."""
        return Arrow(self.y, -self.x)

    def dot(self, other: Arrow) -> Coordinate:
        return self.x * other.x + self.y * other.y

    def cross(self, other: Arrow) -> Coordinate:
        return self.x * other.y - self.y * other.x

    def rotated(self, ray: Arrow) -> Arrow:
        """Turned to the left by the angle of the ray, and as many times as long as the ray."""
        return Arrow(self.dot(Arrow(ray.x, -ray.y)), self.dot(Arrow(ray.y, ray.x)))

    def square(self) -> Coordinate:
        return self.x * self.x + self.y * self.y

    def size(self) -> Coordinate:
        return self.square().root()

    def value(self) -> Arrow:
        return Arrow(self.x.value, self.y.value)

    def derived(self) -> Arrow:
        return Arrow(self.x.derived(), self.y.derived())

    def slope(self, order: int) -> Arrow:
        return Arrow(self.x.slope(order), self.y.slope(order))


def circle_meets_circle(one: Arrow, reach: Coordinate, other: Arrow, far: Coordinate, right: int) -> Arrow:
    """Return where a circle about `one` meets one about `other`, to the right of the way there or, -1, left.

    Of p = s d + h d⊥ from `one`, d the way to `other`, p² = reach² and (p - d)² = far² leave
    s = (1 + (reach² - far²)/d²)/2, and s² + h² = reach²/d².
    """
    way = other.minus(one)
    square = way.square()
    along = (1 + (reach * reach - far * far) / square) / 2
    beside = (reach * reach / square - along * along).root()
    return one.plus(way.times(along)).plus(way.right().times(beside * right))


def circle_meets_level(one: Arrow, reach: Coordinate, level: Coordinate) -> Arrow:
    """Return where a circle meets the line y = level, on the side of larger x."""
    across = level - one.y
    return Arrow(one.x + (reach * reach - across * across).root(), one.y * 0 + level)
