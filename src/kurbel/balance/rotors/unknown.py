"""The masses, angles and planes that balance a rotor, found from the others.

Forces are balanced where the unbalances close a polygon, couples where their moments do; a polygon finds two
unknowns. About its own plane a mass of which nothing is known has no moment, so that the polygon of the
moments finds two others first. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import flint

from kurbel.balance.rotors.rotor import Mass, Placed, force, moment
from kurbel.balance.vector import Value, Vector, is_zero
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls
from kurbel.kernel.balance import Star

Solution = tuple[Placed, ...]
SOLVABLE = (
    "for static balance a mass with its angle or two angles can be asked for; for complete balance two masses"
    " with their angles, a mass with its angle and two other angles, or one of the first with two planes"
)


def solved(masses: Sequence[Mass]) -> tuple[Solution, ...]:
    """Return all ways in which the masses are balanced; as they are, where nothing is asked for.

    Raises ProblemError where it is not known how to find what is asked for, or where there is no such.
    """
    free = [place for place, one in enumerate(masses) if one.free]
    angles = [place for place, one in enumerate(masses) if one.angle is None and one.mass is not None]
    planes = [place for place, one in enumerate(masses) if one.plane is None]
    if any(one.mass is None and one.angle is not None for one in masses):
        raise ProblemError(f"a mass was asked for without its angle; {SOLVABLE}")
    if not (free or angles or planes):
        return (tuple(map(_placed, masses)),)
    find = _WAYS.get((len(free), len(angles), len(planes)))
    if find is None:
        raise ProblemError(
            f"{2 * len(free) + len(angles) + len(planes)} values are asked for with a ?, and these cannot be"
            f" found; {SOLVABLE}"
        )
    return find(masses, free, angles, planes)


def _placed(one: Mass, vector: Vector | None = None) -> Placed:
    here = one.plane
    # Where the forces alone are balanced the plane does not matter.
    return Placed(one.vector if vector is None else vector, Fraction(0) if here is None else here, one)


def _replaced(masses: Sequence[Mass], vectors: dict[int, Vector]) -> Solution:
    return tuple(_placed(one, vectors.get(place)) for place, one in enumerate(masses))


def _rest(masses: Sequence[Mass], unknown: Sequence[int]) -> list[Placed]:
    return [_placed(one) for place, one in enumerate(masses) if place not in unknown]


def _one_mass(masses: Sequence[Mass], free: list[int], *_: list[int]) -> tuple[Solution, ...]:
    """Forces: one mass lies opposite all others."""
    own = force(_rest(masses, free)) * Fraction(-1)
    return (_replaced(masses, {free[0]: _needed(own, free[0])}),)


def _needed(vector: Vector, place: int) -> Vector:
    if vector.vanishes():
        raise ProblemError(f"mass {place + 1} is asked for, but the others are balanced without it")
    return vector


def _two_angles(
    masses: Sequence[Mass], free: list[int], angles: list[int], planes: list[int]
) -> tuple[Solution, ...]:
    """Forces: two masses close a triangle with all others."""
    one, other = angles
    pairs = _triangles(force(_rest(masses, angles)), masses[one].unbalance, masses[other].unbalance, "forces")
    return tuple(_replaced(masses, {one: first, other: second}) for first, second in pairs)


def _two_masses(masses: Sequence[Mass], free: list[int], *_: list[int]) -> tuple[Solution, ...]:
    """Forces and couples: two masses in their planes."""
    one, other = free
    near, far = masses[one].plane, masses[other].plane
    assert near is not None and far is not None
    if near == far:
        raise ProblemError(
            f"masses {one + 1} and {other + 1} are asked for in one plane; they need different planes"
        )
    known = _rest(masses, free)
    there = moment(known, near) * (1 / (near - far))
    here = (force(known) + there) * Fraction(-1)
    return (_replaced(masses, {one: _needed(here, one), other: _needed(there, other)}),)


def _mass_and_angles(
    masses: Sequence[Mass], free: list[int], angles: list[int], planes: list[int]
) -> tuple[Solution, ...]:
    """Couples about the plane of the mass, a triangle; then forces."""
    own, (one, other) = free[0], angles
    here = masses[own].plane
    assert here is not None
    arms = []
    for place in angles:
        plane = masses[place].plane
        assert plane is not None
        if plane == here:
            raise ProblemError(
                f"mass {place + 1}, whose angle is asked for, lies in the plane of mass {own + 1} and has no"
                " moment about it; ask for others"
            )
        arms.append(plane - here)
    known = _rest(masses, [own, *angles])
    lengths = [masses[place].unbalance * arm for place, arm in zip(angles, arms, strict=True)]
    found = []
    for first, second in _triangles(moment(known, here), lengths[0], lengths[1], "couples"):
        vectors = {one: first * (1 / arms[0]), other: second * (1 / arms[1])}
        total = sum(vectors.values(), force(known))
        vectors[own] = _needed(total * Fraction(-1), own)
        found.append(_replaced(masses, vectors))
    return tuple(found)


def _triangles(rest: Vector, one: Fraction, other: Fraction, what: str) -> list[tuple[Vector, Vector]]:
    """Return the pairs of vectors of these lengths that close the polygon of the rest."""
    gap = rest * Fraction(-1)
    square = gap.star.square()
    if gap.vanishes():
        raise ProblemError(
            f"the {what} of the masses whose angles are known are balanced, so that nothing tells the two"
            " angles asked for; give one of them"
        )
    for end in (one + other, one - other):
        if (square - Star.ray(Fraction(0), end**2)).vanishes():
            # The triangle is a line.
            first = gap * (one / end)
            return [(first, gap - first)]
    if not _closes(gap, one, other):
        raise ProblemError(
            f"no two angles balance the {what}: the two masses and the rest of them make no triangle"
        )
    pairs = []
    for sign in (1, -1):
        corner = Vector(rest=((_corner(gap, one, other, sign), Fraction(1)),))
        pairs.append((corner, gap - corner))
    return pairs


def _closes(gap: Vector, one: Fraction, other: Fraction) -> bool:
    """Whether a triangle has these sides; none of its corners lies on a line."""
    bits = 128
    while True:
        with flint.ctx.workprec(bits):
            kind = balls()
            square = gap.square()(kind)
            within = (kind.of((one + other) ** 2) - square) * (square - kind.of((one - other) ** 2))
            if not within.contains(0):
                return bool(within > 0)
        bits *= 2


def _corner(gap: Vector, one: Fraction, other: Fraction, sign: int) -> Callable[[Kind], tuple[Any, Any]]:
    def point(kind: Kind) -> tuple[Any, Any]:
        x, y = gap.point(kind)
        square = x * x + y * y
        along = (kind.of(one**2 - other**2) + square) / (2 * square)
        across = (kind.of(one**2) / square - along * along) ** kind.exponent(Fraction(1, 2)) * sign
        return x * along - y * across, y * along + x * across

    return point


def _with_planes(
    masses: Sequence[Mass], free: list[int], angles: list[int], planes: list[int]
) -> tuple[Solution, ...]:
    """Forces first, then two planes from the polygon of the couples."""
    find = _one_mass if free else _two_angles
    return tuple(_planes_found(one, planes) for one in find(masses, free, angles, planes))


def _planes_found(placed: Solution, planes: list[int]) -> Solution:
    one, other = (placed[place].vector for place in planes)
    rest = moment([own for place, own in enumerate(placed) if place not in planes], Fraction(0))
    if is_zero(_cross(one, other)):
        raise ProblemError(
            f"masses {planes[0] + 1} and {planes[1] + 1}, whose planes are asked for, lie in one line"
            " with the shaft; their planes cannot be told"
        )
    found = {planes[0]: _ratio(other, rest, one, other), planes[1]: _ratio(rest, one, one, other)}
    return tuple(own._replace(plane=found.get(place, own.plane)) for place, own in enumerate(placed))


def _cross(one: Vector, other: Vector) -> Value:
    def value(kind: Kind) -> Any:
        (x, y), (u, v) = one.point(kind), other.point(kind)
        return x * v - y * u

    return value


def _ratio(first: Vector, second: Vector, third: Vector, fourth: Vector) -> Value:
    above, below = _cross(first, second), _cross(third, fourth)
    return lambda kind: above(kind) / below(kind)


# By how many masses with their angles, angles and planes are asked for.
_WAYS: Mapping[tuple[int, int, int], Callable[..., tuple[Solution, ...]]] = {
    (1, 0, 0): _one_mass,
    (0, 2, 0): _two_angles,
    (2, 0, 0): _two_masses,
    (1, 2, 0): _mass_and_angles,
    (1, 0, 2): _with_planes,
    (0, 2, 2): _with_planes,
}
