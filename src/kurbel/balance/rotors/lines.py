"""The lines of a rotor's page: its masses, what they leave, what balances them, what bearings take."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.balance.rotors.rotor import Mass, Placed, Rotor, balancing, force, moment, shares
from kurbel.balance.rotors.unknown import Solution
from kurbel.balance.vector import Value, Vector
from kurbel.exact.kind import Kind

# What is known exactly, or on every kind of number; None where a line says nothing.
Known = Fraction | Value | None


class Line(NamedTuple):
    """A line by its key: of a mass, balancing mass or bearing by its number, or of all masses together."""

    key: str
    number: int = 0
    mass: Known = None
    radius: Known = None
    plane: Known = None
    unbalance: Known = None
    moment: Known = None
    angle: Fraction | Vector | None = None


class Places(NamedTuple):
    """The planes of balancing masses with the radii of these, and those of bearings, in m."""

    balance: tuple[Fraction, ...] = ()
    radii: tuple[Fraction | None, ...] = ()
    bearings: tuple[Fraction, ...] = ()


def lines(rotor: Rotor, solution: Solution, places: Places) -> Iterator[Line]:
    """Yield the lines of a way in which the masses stand."""
    yield from _masses("mass", solution, rotor.about)
    yield from _sums("", solution, rotor.about)
    standing = solution
    if places.balance:
        added = [
            Placed(vector, plane, Mass(None, radius, None, plane))
            for vector, plane, radius in zip(
                balancing(solution, places.balance), places.balance, places.radii, strict=True
            )
        ]
        yield from _masses("balance", added, rotor.about)
        standing = (*solution, *added)
        yield from _sums("left_", standing, rotor.about)
    if places.bearings:
        pulls = zip(shares(standing, places.bearings), places.bearings, strict=True)
        for number, (vector, plane) in enumerate(pulls, 1):
            yield Line("bearing", number, plane=plane, unbalance=amount(vector), angle=vector)


def _masses(key: str, masses: Sequence[Placed], about: Fraction) -> Iterator[Line]:
    for number, one in enumerate(masses, 1):
        mass, radius, angle, _ = one.given
        known = mass is not None and angle is not None
        unbalance = one.given.unbalance if mass is not None else amount(one.vector)
        yield Line(
            key,
            number,
            mass=_over(unbalance, radius) if mass is None else mass,
            radius=radius,
            plane=one.plane,
            unbalance=unbalance,
            moment=_times(unbalance, one.plane, about),
            angle=angle if known else one.vector,
        )


def _sums(before: str, masses: Sequence[Placed], about: Fraction) -> Iterator[Line]:
    """Yield what masses leave together: an unbalance and a couple."""
    rest, couple = force(masses), moment(masses, about)
    yield Line(f"{before}unbalance", unbalance=amount(rest), angle=rest)
    yield Line(f"{before}couple", moment=amount(couple), angle=couple)


def amount(vector: Vector) -> Fraction | Value:
    """Return the length of a vector, 0 where it is proved to be 0."""
    return Fraction(0) if vector.vanishes() else vector.length()


def _over(unbalance: Fraction | Value, radius: Fraction | None) -> Known:
    if radius is None:
        return None
    if isinstance(unbalance, Fraction):
        return unbalance / radius
    return lambda kind: unbalance(kind) / kind.of(radius)


def _times(unbalance: Fraction | Value, plane: Fraction | Value, about: Fraction) -> Fraction | Value:
    """Return the moment, below 0 on the other side of the zero of moments."""
    if isinstance(unbalance, Fraction) and isinstance(plane, Fraction):
        return unbalance * (plane - about)
    if plane == about:
        return Fraction(0)

    def value(kind: Kind) -> Any:
        arm = on(plane, kind) - kind.of(about)
        return on(unbalance, kind) * arm

    return value


def on(known: Fraction | Value, kind: Kind) -> Any:
    """Return what is known on a kind of number."""
    return kind.of(known) if isinstance(known, Fraction) else known(kind)
