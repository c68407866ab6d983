"""Rotating masses of a shaft: what they leave unbalanced, and what balances them in given planes.

The unbalance of a mass is its mass times its radius, a vector from the shaft to it; its moment is that times
the position of its plane along the shaft. Turning at ω it pulls at the shaft with ω² times the unbalance.

Forces are balanced where the unbalances close a polygon, couples where their moments do; a polygon finds two
unknowns. About its own plane a mass of which nothing is known has no moment, so that the polygon of the
moments finds two others first. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.drive.crank import LARGEST_ANGLE, check_ratio
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls
from kurbel.exact.real import Real
from kurbel.kernel.circle import Numeric
from kurbel.kernel.harmonics import Star
from kurbel.reading.notation import about

MOST_MASSES = 100
LARGEST = 10**6


class Mass(NamedTuple):
    """A mass in kg at a radius in m, in a direction in degrees, in a plane in m; None is asked for."""

    mass: Fraction | None
    radius: Fraction | None
    angle: Fraction | None
    plane: Fraction | None

    @property
    def free(self) -> bool:
        """Whether nothing is known but its radius, and its plane or not."""
        return self.mass is None and self.angle is None

    @property
    def vector(self) -> Vector:
        """The unbalance in kg m of a mass that is known."""
        return Vector.ray(known(self.angle), self.unbalance)

    @property
    def unbalance(self) -> Fraction:
        return known(self.mass) * known(self.radius)


class PlacedMass(NamedTuple):
    """A mass as it is known or found: its unbalance in kg m, its plane in m; as it was given, if it was."""

    vector: Vector
    plane: Real
    given: Mass

    def moment(self, about: Fraction) -> Vector:
        """Return the moment of the unbalance about a plane, in kg m²."""
        arm = self.plane - about
        if arm.rational is not None:
            return self.vector * arm.rational

        def point(kind: Kind) -> tuple[Numeric, Numeric]:
            (x, y), length = self.vector.point(kind), arm.on(kind)
            return x * length, y * length

        return Vector(rest=((point, Fraction(1)),))

    def second(self, ratio: Fraction) -> PlacedMass:
        """Return the same as it acts in the second order where it goes to and fro, λ m r at the double angle.

        λ is the crank ratio; times ω² it is the greatest force. Source: the textbooks; the series of the
        piston's acceleration to the first order of λ.
        """
        mass, _, angle, _ = self.given
        known_angle = mass is not None and angle is not None
        vector = Vector.ray(2 * known(angle), self.given.unbalance) if known_angle else self.vector.doubled()
        return self._replace(vector=vector * ratio)


@dataclass(frozen=True, slots=True)
class Rotor:
    """The masses of a shaft, the zero of the moments along it, and the crank ratio of those that go to and
    fro."""

    masses: tuple[Mass, ...]
    about: Fraction = Fraction(0)
    ratio: Fraction | None = None

    def __post_init__(self) -> None:
        if not 1 <= len(self.masses) <= MOST_MASSES:
            raise ProblemError(f"{len(self.masses)} masses were given; a rotor has 1 to {MOST_MASSES}")
        for number, one in enumerate(self.masses, 1):
            _check(number, one)
        if self.ratio is not None:
            check_ratio(self.ratio)


def _check(number: int, one: Mass) -> None:
    for what, unit, value in (("mass", "kg", one.mass), ("radius", "m", one.radius)):
        if value is not None and not 0 < value <= LARGEST:
            raise ProblemError(
                f"{what} {number} is {about(value)} {unit}; it must be above 0 and at most {LARGEST} {unit},"
                " and what lies opposite has its angle 180° farther"
            )
    if one.radius is None and one.mass is not None:
        raise ProblemError(f"mass {number} has no radius; give all, --radii, or one for all masses")
    if one.angle is not None and abs(one.angle) > LARGEST_ANGLE:
        raise ProblemError(f"the angle of mass {number} is beyond {LARGEST_ANGLE}°; give it within one turn")
    if one.plane is not None and abs(one.plane) > LARGEST:
        raise ProblemError(f"the plane of mass {number} lies beyond {LARGEST} m")


def force(masses: Sequence[PlacedMass]) -> Vector:
    """Return the unbalance of all masses together, in kg m."""
    return sum((one.vector for one in masses), Vector())


def moment(masses: Sequence[PlacedMass], about: Fraction) -> Vector:
    """Return the moment of the unbalances in kg m², in the direction of the forces of the couple.

    Without an unbalance of all together it is the same about any point.
    """
    if any(one.plane.rational is None for one in masses):
        # Planes are found from two linear equations, so that masses balanced in their forces have no couple.
        return Vector()
    return sum((one.moment(about) for one in masses), Vector())


def shares(masses: Sequence[PlacedMass], planes: Sequence[Fraction]) -> tuple[Vector, ...]:
    """Return the unbalances in one or two planes that have the force and the moment of the masses.

    Times ω² they are the forces on bearings there; the opposite ones balance the masses. In one plane they
    leave a couple.
    """
    if len(planes) == 1:
        return (force(masses),)
    near, far = planes
    if near == far:
        raise ProblemError(f"both lie at {about(near)} m; only different planes or bearings take up a couple")
    there = moment(masses, near) * (1 / (far - near))
    return force(masses) - there, there


class Places(NamedTuple):
    """The planes of balancing masses with the radii of these, and those of bearings, in m."""

    balance: tuple[Fraction, ...] = ()
    radii: tuple[Fraction | None, ...] = ()
    bearings: tuple[Fraction, ...] = ()


class Line(NamedTuple):
    """A line of a page by its key: of a mass, balancing mass or bearing by its number, or of all masses
    together. What it says nothing of is None."""

    key: str
    number: int = 0
    mass: Real | None = None
    radius: Real | None = None
    plane: Real | None = None
    unbalance: Real | None = None
    moment: Real | None = None
    angle: Fraction | Vector | None = None


def lines(rotor: Rotor, standing: Sequence[PlacedMass], places: Places) -> Iterator[Line]:
    """Yield the lines of a way in which the masses stand: these, what they leave, what balances them; of
    masses that go to and fro what they leave of the second order."""
    yield from _masses("mass", standing, rotor.about)
    yield from _sums("", force(standing), moment(standing, rotor.about))
    if rotor.ratio is not None:
        second = [one.second(rotor.ratio) for one in standing]
        couple = sum((one.moment(rotor.about) for one in second), Vector())
        yield from _sums("second_", force(second), couple)
    if places.balance:
        found = zip(shares(standing, places.balance), places.balance, places.radii, strict=True)
        added = [
            PlacedMass(one * Fraction(-1), Real.of(plane), Mass(None, radius, None, plane))
            for one, plane, radius in found
        ]
        yield from _masses("balance", added, rotor.about)
        standing = (*standing, *added)
        yield from _sums("left_", force(standing), moment(standing, rotor.about))
    if places.bearings:
        pulls = zip(shares(standing, places.bearings), places.bearings, strict=True)
        for number, (one, plane) in enumerate(pulls, 1):
            yield Line("bearing", number, plane=Real.of(plane), unbalance=one.length(), angle=one)


def _masses(key: str, masses: Sequence[PlacedMass], about: Fraction) -> Iterator[Line]:
    for number, (vector, plane, given) in enumerate(masses, 1):
        mass, radius, angle, _ = given
        of_radius = None if radius is None else Real.of(radius)
        unbalance = vector.length() if mass is None else Real.of(given.unbalance)
        own = Real.of(mass) if mass is not None else unbalance / of_radius if of_radius else None
        direction = vector if mass is None or angle is None else angle
        yield Line(key, number, own, of_radius, plane, unbalance, unbalance * (plane - about), direction)


def _sums(before: str, rest: Vector, couple: Vector) -> Iterator[Line]:
    """Yield what masses leave together: an unbalance and a couple."""
    yield Line(f"{before}unbalance", unbalance=rest.length(), angle=rest)
    yield Line(f"{before}couple", moment=couple.length(), angle=couple)


Solution = tuple[PlacedMass, ...]
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
        PlacedMass(found[place] if place in found else one.vector, Real.of(one.plane or 0), one)  # noqa: SIM401
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
            found = ball(within.on(balls()))
            if not found.contains(0):
                return bool(found > 0)
        bits *= 2


def _corner(
    gap: Vector, one: Fraction, other: Fraction, sign: int
) -> Callable[[Kind], tuple[Numeric, Numeric]]:
    def point(kind: Kind) -> tuple[Numeric, Numeric]:
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
