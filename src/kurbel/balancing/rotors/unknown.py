"""The masses, angles and planes that balance a rotor, found from the others.

Forces are balanced where the unbalances close a polygon, couples where their moments do; a polygon finds two
unknowns. About its own plane a mass of which nothing is known has no moment, so that the polygon of the
moments finds two others first. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.balancing.rotors.rotor import Mass, Placed, force, moment
from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits
from kurbel.exact.kind import Kind, balls
from kurbel.exact.real import Real
from kurbel.kernel.balance import Star

Solution = tuple[Placed, ...]
Unknown = tuple[list[int], list[int], list[int]]
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
        return (_with(masses, {}),)
    find = _WAYS.get((len(free), len(angles), len(planes)))
    if find is None:
        raise ProblemError(
            f"{2 * len(free) + len(angles) + len(planes)} values are asked for with a ?, and these cannot be"
            f" found; {SOLVABLE}"
        )
    return tuple(find(masses, (free, angles, planes)))


def _with(masses: Sequence[Mass], found: Mapping[int, Vector], left: Sequence[int] = ()) -> Solution:
    """Return the masses with the vectors that were found, but for those that are left out."""
    # Where the forces alone are balanced the plane does not matter.
    return tuple(
        Placed(found[place] if place in found else one.vector, Real.of(one.plane or 0), one)  # noqa: SIM401
        for place, one in enumerate(masses)
        if place not in left
    )


def _needed(vector: Vector, place: int) -> Vector:
    if vector.vanishes():
        raise ProblemError(f"mass {place + 1} is asked for, but the others are balanced without it")
    return vector


def _one_mass(masses: Sequence[Mass], unknown: Unknown) -> list[Solution]:
    """Forces: one mass lies opposite all others."""
    [place] = unknown[0]
    own = force(_with(masses, {}, [place])) * Fraction(-1)
    return [_with(masses, {place: _needed(own, place)})]


def _two_angles(masses: Sequence[Mass], unknown: Unknown) -> list[Solution]:
    """Forces: two masses close a triangle with all others."""
    lengths = [masses[place].unbalance for place in unknown[1]]
    pairs = _triangles("forces", force(_with(masses, {}, unknown[1])), *lengths)
    return [_with(masses, dict(zip(unknown[1], pair, strict=True))) for pair in pairs]


def _two_masses(masses: Sequence[Mass], unknown: Unknown) -> list[Solution]:
    """Forces and couples: two masses in their planes."""
    one, other = unknown[0]
    near, far = known(masses[one].plane), known(masses[other].plane)
    if near == far:
        raise ProblemError(
            f"masses {one + 1} and {other + 1} are asked for in one plane; they need different planes"
        )
    rest = _with(masses, {}, unknown[0])
    there = moment(rest, near) * (1 / (near - far))
    here = (force(rest) + there) * Fraction(-1)
    return [_with(masses, {one: _needed(here, one), other: _needed(there, other)})]


def _mass_and_angles(masses: Sequence[Mass], unknown: Unknown) -> list[Solution]:
    """Couples about the plane of the mass, a triangle; then forces."""
    [own], angles, _ = unknown
    here = known(masses[own].plane)
    arms = [known(masses[place].plane) - here for place in angles]
    for place, arm in zip(angles, arms, strict=True):
        if not arm:
            raise ProblemError(
                f"mass {place + 1}, whose angle is asked for, lies in the plane of mass {own + 1} and has no"
                " moment about it; ask for others"
            )
    rest = _with(masses, {}, [own, *angles])
    lengths = [masses[place].unbalance * arm for place, arm in zip(angles, arms, strict=True)]
    found = []
    for pair in _triangles("couples", moment(rest, here), *lengths):
        vectors = {place: one * (1 / arm) for place, one, arm in zip(angles, pair, arms, strict=True)}
        total = sum(vectors.values(), force(rest))
        found.append(_with(masses, {own: _needed(total * Fraction(-1), own), **vectors}))
    return found


def _triangles(what: str, rest: Vector, one: Fraction, other: Fraction) -> list[tuple[Vector, Vector]]:
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
    corners = (Vector(rest=((_corner(gap, one, other, sign), Fraction(1)),)) for sign in (1, -1))
    return [(corner, gap - corner) for corner in corners]


def _closes(gap: Vector, one: Fraction, other: Fraction) -> bool:
    """Whether a triangle has these sides; none of its corners lies on a line."""
    bits, square = 128, gap.square()
    within = ((one + other) ** 2 - square) * (square - (one - other) ** 2)
    while True:
        with at_bits(bits):
            found = within.on(balls())
            if not found.contains(0):
                return bool(found > 0)
        bits *= 2


def _corner(gap: Vector, one: Fraction, other: Fraction, sign: int) -> Callable[[Kind], tuple[Any, Any]]:
    def point(kind: Kind) -> tuple[Any, Any]:
        x, y = gap.point(kind)
        square = x * x + y * y
        along = (kind.of(one**2 - other**2) + square) / (2 * square)
        across = (kind.of(one**2) / square - along * along) ** kind.exponent(Fraction(1, 2)) * sign
        return x * along - y * across, y * along + x * across

    return point


def _with_planes(masses: Sequence[Mass], unknown: Unknown) -> list[Solution]:
    """Forces first, then two planes from the polygon of the couples."""
    found = (_one_mass if unknown[0] else _two_angles)(masses, unknown)
    return [_planes_found(one, unknown[2]) for one in found]


def _planes_found(placed: Solution, planes: list[int]) -> Solution:
    one, other = (placed[place].vector for place in planes)
    rest = moment([own for place, own in enumerate(placed) if place not in planes], Fraction(0))
    area = _cross(one, other)
    if area.vanishes():
        raise ProblemError(
            f"masses {planes[0] + 1} and {planes[1] + 1}, whose planes are asked for, lie in one line"
            " with the shaft; their planes cannot be told"
        )
    found = dict(zip(planes, (_cross(other, rest) / area, _cross(rest, one) / area), strict=True))
    return tuple(own._replace(plane=found.get(place, own.plane)) for place, own in enumerate(placed))


def _cross(one: Vector, other: Vector) -> Real:
    (x, y), (u, v) = one.parts, other.parts
    return x * v - y * u


# By how many masses with their angles, angles and planes are asked for.
_WAYS: Mapping[tuple[int, int, int], Callable[[Sequence[Mass], Unknown], list[Solution]]] = {
    (1, 0, 0): _one_mass,
    (0, 2, 0): _two_angles,
    (2, 0, 0): _two_masses,
    (1, 2, 0): _mass_and_angles,
    (1, 0, 2): _with_planes,
    (0, 2, 2): _with_planes,
}
