"""Vectors in the plane across the shaft, with certified length and direction.

A vector is a star, whose zeros are known by exact arithmetic, and multiples of others that are known on any
kind of number.

Free forces in newtons and moments in newton metres: what mass, radius, speed and spacing make of them.

Along its slide a rod is exactly two masses at its pins that keep its centre of mass (Ensslin): to and fro
goes the share at the crosshead pin, and that at the crank pin turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import inf
from typing import TypeAlias

import flint

from kurbel.balancing.arrangement import Arrangement
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact import certify
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Label, Number, figure, nearest
from kurbel.exact.real import ESTIMATE_BITS, PI, Real
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.harmonics import Star
from kurbel.motion.notes import moving_notes, turns_label
from kurbel.page.quantity import Texts
from kurbel.reading.amounts import Units, amount, digits, unit_of_page
from kurbel.reading.notation import check_bounds
from kurbel.reading.units import Speed

Point: TypeAlias = Callable[[Kind], tuple[Numeric, Numeric]]


@dataclass(frozen=True, slots=True)
class Vector:
    """A star and rational multiples of further points, each point once."""

    star: Star = field(default_factory=Star)
    rest: tuple[tuple[Point, Fraction], ...] = ()

    @classmethod
    def ray(cls, degrees: Fraction, length: Fraction) -> Vector:
        return cls(Star.ray(degrees, length))

    def __add__(self, other: Vector) -> Vector:
        multiples: dict[Point, Fraction] = dict(self.rest)
        for point, times in other.rest:
            multiples[point] = multiples.get(point, Fraction(0)) + times
        return Vector(self.star + other.star, tuple(one for one in multiples.items() if one[1]))

    def __sub__(self, other: Vector) -> Vector:
        return self + other * Fraction(-1)

    def __mul__(self, times: Fraction) -> Vector:
        return Vector(self.star * times, tuple((point, own * times) for point, own in self.rest if times))

    def point(self, kind: Kind) -> tuple[Numeric, Numeric]:
        """Return x and y."""
        x, y = self.star.point(kind.circle, kind.of)
        for of, times in self.rest:
            along, across = of(kind)
            x, y = x + kind.of(times) * along, y + kind.of(times) * across
        return x, y

    def doubled(self) -> Vector:
        """Return a vector of the same length, not 0, twice as far from 0°."""

        def point(kind: Kind) -> tuple[Numeric, Numeric]:
            x, y = self.point(kind)
            length = root(x * x + y * y)
            return (x * x - y * y) / length, 2 * x * y / length

        return Vector(rest=((point, Fraction(1)),))

    @property
    def parts(self) -> tuple[Real, Real]:
        return Real(lambda kind: self.point(kind)[0]), Real(lambda kind: self.point(kind)[1])

    def vanishes(self) -> bool:
        """Return whether it is 0, by proof."""
        return all(one.vanishes() for one in self.parts) if self.rest else self.star.vanishes()

    def lies_along(self, degrees: Fraction) -> bool:
        """Return whether it has this direction or the opposite one, by proof."""
        if not self.rest:
            turned = self.star.turned(-degrees)
            return (turned - turned.mirrored()).vanishes()

        def across(kind: Kind) -> Numeric:
            (x, y), circle = self.point(kind), kind.circle(degrees)
            return y * circle.cosine - x * circle.sine

        return Real(across).vanishes()

    def square(self) -> Real:
        """Return the square of the length."""

        def on(kind: Kind) -> Numeric:
            x, y = self.point(kind)
            return x * x + y * y

        return Real(on)

    def length(self) -> Real:
        return Real.of(0) if self.vanishes() else self.square().root()

    def component(self, axis: int) -> Real:
        """Return x (axis 0) or y (axis 1)."""
        return Real.of(0) if self.lies_along(Fraction(90 - 90 * axis)) else self.parts[axis]

    def number(self, decimals: int, rounding: str = "half-away", parts: int = 1) -> Number | None:
        """Return the direction in degrees within 0..360, correctly rounded, None where there is none; or one
        of so many parts of it.

        That a direction lies half-way between two printed ones is decided by exact arithmetic for stars;
        others are arcs of what is algebraic.
        """
        if self.vanishes():
            return None
        quarter = self._quarter()
        if self.lies_along(Fraction(90 * quarter)):
            return nearest(Fraction(90 * quarter, parts), decimals, rounding)

        def value() -> Numeric:
            x, y = map(ball, self.point(balls()))
            for _ in range(quarter):
                x, y = y, -x
            turn = 360 if not quarter and y < 0 else 90 * quarter
            return (flint.arb.atan2(y, x) * 180 / flint.arb.pi() + turn) / parts

        def tie_bits(boundary: Fraction) -> float:
            return 0.0 if self.lies_along(boundary * parts) else inf

        ties = certify.NEVER_TIES if self.rest else tie_bits
        return Number(certify.rounded(value, decimals, rounding, ties), decimals)

    def _quarter(self) -> int:
        """Return the quarter turn that is nearest to the direction of a vector that is not 0."""
        bits = ESTIMATE_BITS
        while bits <= certify.MOST_BITS:
            with at_bits(bits):
                x, y = map(ball, self.point(balls()))
                if abs(x) > abs(y) * flint.arb(0.5):
                    if not x.contains(0):
                        return 0 if x > 0 else 2
                elif not y.contains(0):
                    return 1 if y > 0 else 3
            bits *= 2
        raise ProblemError(
            f"a direction is not settled by {bits // 2} bits: what it is of may be 0; leave its column out"
        )


def omega(speed: Speed) -> Real:
    """Return the angular velocity in 1/s."""
    return 2 * speed.value * PI if speed.turns else Real.of(speed.value)


def pin_acceleration(crank: Crank) -> Real:
    """Return R ω² in m/s²."""
    turning = omega(known(crank.speed))
    return turning * turning * known(crank.radius)


IN_NEWTONS = "_n"
WORDS = Texts("balancing", "vector")


@dataclass(frozen=True, slots=True)
class CrankWithMasses:
    """The crank of a cylinder with its masses, its radius and the speed; `spacing` is the unit of length
    of the positions in metres, None where it is not known.

    `each` are the masses in kg that go to and fro in the cylinders where these are not alike, and
    `revolving` those that turn with the cranks at their radius, where they are not balanced apart.
    Counterweights balance the share of the arrangement of the first and `revolving_share` of the second.
    """

    crank: Crank
    spacing: Fraction | None = None
    each: tuple[Fraction, ...] = ()
    revolving: tuple[Fraction, ...] = ()
    revolving_share: Fraction = Fraction(0)
    balance_radius: Fraction | None = None
    # Those of the page, None of one in newtons.
    units: Units | None = None

    def __post_init__(self) -> None:
        check_bounds(
            "the spacing of the cranks", self.spacing, "be above 0, for it is the unit of the positions", " m"
        )
        if not self.mass:
            raise ProblemError(
                "no mass goes to and fro; add that of piston and crosshead, --reciprocating 300kg"
            )

    @property
    def mass(self) -> Fraction:
        """m in kg, what goes to and fro in a cylinder."""
        return Fraction(known(self.crank.moving).joined.crosshead)

    def knows(self, residual: str) -> bool:
        """Whether the unit of this residual is known."""
        return residual == "force" or self.spacing is not None

    def scale(self, residual: str) -> Real:
        """Return the unit m R ω² of a residual in newtons, of a moment in newton metres."""
        return pin_acceleration(self.crank) * (self.mass * self._arm(residual))

    def _arm(self, residual: str) -> Fraction:
        """Return by what a force in newtons becomes one in the unit of the page, or a moment."""
        arm, unit = (Fraction(1), "N") if residual == "force" else (known(self.spacing), "N m")
        return arm if self.units is None else arm * self.units.times(unit)

    def on(self, arrangement: Arrangement) -> Arrangement:
        """Return the arrangement with the masses of its cylinders, in units of m."""
        count = len(arrangement.cylinders)
        each, revolving = self.each or (self.mass,) * count, self._turning(count)
        for what, masses in (("reciprocating", each), ("revolving", revolving)):
            if len(masses) != count:
                raise ProblemError(
                    f"the number of {what} masses is {len(masses)} and that of cylinders {count}; give"
                    " one for each, or one for all"
                )
        free = 1 - self.revolving_share
        return replace(
            arrangement,
            cylinders=tuple(
                one._replace(mass=mass / self.mass, revolving=free * turning / self.mass)
                for one, mass, turning in zip(arrangement.cylinders, each, revolving, strict=True)
            ),
        )

    def _turning(self, count: int) -> tuple[Fraction, ...]:
        """Return the masses that turn with the cranks, of one that is given for all of them."""
        given = self.revolving or (Fraction(0),)
        return given * count if len(given) == 1 else given

    def counterweights(self, arrangement: Arrangement) -> tuple[Fraction, ...]:
        """Return mass times radius of the counterweights opposite the cranks, in kg m."""
        revolving, radius = self._turning(len(arrangement.cylinders)), known(self.crank.radius)
        return tuple(
            (arrangement.share * one.mass * self.mass + self.revolving_share * turning) * radius
            for one, turning in zip(arrangement.cylinders, revolving, strict=True)
        )

    def notes(
        self, arrangement: Arrangement, ratio_symbol: str, lang: str, metres: bool = False
    ) -> Iterator[Label]:
        """Yield the lines about masses, size and speed; positions in metres need no unit of their own."""
        if not self.each:
            yield from moving_notes(self.crank, ratio_symbol, lang)
        rod = WORDS["rod"][lang] if known(self.crank.moving).rod is not None else ""
        spacing = "" if self.spacing is None or metres else f"$a = {amount(self.spacing, 'mm')}$"
        if self.each:
            size = f"${ratio_symbol[0]} = {amount(known(self.crank.radius), 'mm')}$"
            yield WORDS["each"][lang].format(masses=_listed(self.each), rod=rod)
            yield ", ".join(filter(None, (size, turns_label(known(self.crank.speed)), spacing)))
        else:
            yield ", ".join(filter(None, (f"$m = {amount(self.mass, 'kg')}${rod}", spacing)))
        if self.revolving:
            yield WORDS["revolving"][lang].format(
                masses=_listed(self.revolving), share=f"${figure(self.revolving_share)}$"
            )
        told = self.revolving or self.balance_radius is not None
        if told and any(weights := self.counterweights(arrangement)):
            times, unit = unit_of_page("kg m")
            moments = "; ".join(f"${digits(one, times)}$" for one in dict.fromkeys(weights))
            said = WORDS["counterweights"][lang].format(unit=f"${unit}$", moments=moments)
            yield said + self._at_radius(weights, lang)

    def _at_radius(self, weights: Sequence[Fraction], lang: str) -> Label:
        if self.balance_radius is None:
            return ""
        masses = [one / self.balance_radius for one in weights]
        return WORDS["at_radius"][lang].format(
            radius=f"${amount(self.balance_radius, 'mm')}$", masses=_listed(masses)
        )


def _listed(masses: Sequence[Fraction]) -> Label:
    """Return masses in kg in a row, once where all are alike."""
    shown = masses[:1] if len(set(masses)) == 1 else masses
    return "; ".join(f"${amount(one, 'kg')}$" for one in shown)
