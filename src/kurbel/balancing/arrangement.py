"""Balance of engines with several cranks: free forces and moments of each order, with certified digits.

Forces are in units of m R ω², m being the reciprocating mass of a cylinder; moments in that times the unit
of the cylinders' positions. They are vectors in the plane across the shaft, see kernel/harmonics.py. What
mass, radius, speed and spacing make of them are newtons and newton metres.

Along its slide a rod is exactly two masses at its pins that keep its centre of mass (Ensslin): to and fro
goes the share at the crosshead pin, and that at the crank pin turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.balancing import harmonics
from kurbel.balancing.vector import Vector, omega
from kurbel.drive.at import known
from kurbel.drive.crank import LARGEST_ANGLE, Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, figure
from kurbel.exact.real import Real
from kurbel.kernel import harmonics as of_kernel
from kurbel.kernel.harmonics import Star
from kurbel.motion.notes import moving_notes, turns_label
from kurbel.page.quantity import Texts
from kurbel.reading.amounts import Units, amount, digits, unit_of_page
from kurbel.reading.notation import about, check_bounds

MOST_CYLINDERS = 24
LARGEST_POSITION = 10**6


class Cylinder(NamedTuple):
    """Angle of the crank pin and of the slide (`bank`) in degrees, from the same line and counted as the
    shaft turns; position along the shaft in any unit, from the point to which moments refer.

    `mass` is what goes to and fro, and `revolving` what turns with the crank at its radius and is not
    balanced, both in units of m.
    """

    crank: Fraction
    position: Fraction = Fraction(0)
    bank: Fraction = Fraction(0)
    mass: Fraction = Fraction(1)
    revolving: Fraction = Fraction(0)


@dataclass(frozen=True)
class Arrangement:
    """The cylinders of an engine, and the share of each reciprocating mass that counterweights balance.

    The counterweights turn with the shaft, opposite each cylinder's pin; rotating masses are balanced
    apart, but what a cylinder has as `revolving`. Two rods on a pin bring two counterweights: of a V of 90°
    the share ½ is one whole reciprocating mass opposite each pin. Valid for 1 to 24 cylinders, no two of
    them in one place, and 0 <= share <= 1.
    """

    cylinders: tuple[Cylinder, ...]
    share: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_count(len(self.cylinders))
        check_bounds(
            "share of the counterweights", self.share,
            "lie within 0..1, for it is a share of the reciprocating mass",
        )  # fmt: skip
        places: dict[tuple[Fraction, Fraction], int] = {}
        for number, cylinder in enumerate(self.cylinders, 1):
            _check_cylinder(number, cylinder)
            first = places.setdefault((cylinder.position, cylinder.bank % 360), number)
            if first != number:
                raise ProblemError(
                    f"cylinders {first} and {number} are both at position {about(cylinder.position)} in the"
                    f" bank at {about(cylinder.bank)}°; they must differ in one of the two"
                )


def check_count(cylinders: int) -> None:
    """Raise ProblemError unless an engine can have so many cylinders."""
    if not 1 <= cylinders <= MOST_CYLINDERS:
        raise ProblemError(f"{cylinders} cylinders were given; an engine has 1 to {MOST_CYLINDERS}")


def _check_cylinder(number: int, cylinder: Cylinder) -> None:
    if abs(cylinder.position) > LARGEST_POSITION:
        raise ProblemError(f"cylinder {number} lies beyond {LARGEST_POSITION}; take a larger unit of length")
    for what, angle in (("crank", cylinder.crank), ("bank", cylinder.bank)):
        if abs(angle) > LARGEST_ANGLE:
            raise ProblemError(
                f"{what} angle of cylinder {number} is beyond {LARGEST_ANGLE}°;"
                " give it within one turn, 0..360"
            )


def row(
    cranks: Sequence[Fraction | int],
    banks: Sequence[Fraction | int] = (),
    share: Fraction = Fraction(0),
) -> Arrangement:
    """Return cylinders the unit of length apart, each with a pin and a bank of its own, all in one bank
    without any; moments are about the middle."""
    places = zip(cranks, _positions(len(cranks)), banks or [0] * len(cranks), strict=True)
    cylinders = (Cylinder(Fraction(crank), position, Fraction(bank)) for crank, position, bank in places)
    return Arrangement(tuple(cylinders), share)


def vee(
    cranks: Sequence[Fraction | int], bank_angle: Fraction | int, share: Fraction = Fraction(0)
) -> Arrangement:
    """Return two cylinders at each pin, in banks on either side of the middle line, from which angles count;
    the pins are the unit of length apart."""
    half = Fraction(bank_angle) / 2
    places = zip(cranks, _positions(len(cranks)), strict=True)
    cylinders = (Cylinder(Fraction(crank), z, bank) for crank, z in places for bank in (-half, half))
    return Arrangement(tuple(cylinders), share)


def _positions(count: int) -> list[Fraction]:
    return [Fraction(2 * number - count + 1, 2) for number in range(count)]


@cache
def usual() -> Mapping[str, Arrangement]:
    """Return the usual arrangements by name, without counterweights.

    Three to six cylinders in a line fire in the order 1-3-2, 1-3-4-2, 1-2-4-5-3, 1-5-3-6-2-4, at equal
    intervals over two turns.
    """
    six = (0, 240, 120, 120, 240, 0)
    return {
        "inline-1": row((0,)),
        "inline-2-180": row((0, 180)),
        "inline-2-360": row((0, 0)),
        "inline-3": row((0, 240, 120)),
        "inline-4": row((0, 180, 180, 0)),
        "inline-5": row((0, 216, 144, 72, 288)),
        "inline-6": row(six),
        "v2-90": vee((0,), 90),
        "v6-90": vee((0, 240, 120), 90),
        "v8-90": vee((0, 90, 270, 180), 90),
        "v12-60": vee(six, 60),
        "boxer-2": row((0, 180), (0, 180)),
        "boxer-4": row((0, 180, 180, 0), (0, 180, 0, 180)),
    }


class Residual(NamedTuple):
    """What is left of an order: a vector that turns forward by kφ and one backward, at φ = 0.

    In units of m R ω² |B_k|, for a moment times the unit of length. The angle φ of the shaft counts as the
    crank angles do; a direction counts as the banks do.
    """

    forward: Star
    backward: Star

    def component(self, degrees: Fraction) -> Star:
        """Return the component in a direction: its magnitude is the amplitude, its angle α the phase of
        cos(kφ + α)."""
        return self.forward.turned(-degrees) + self.backward.turned(-degrees).mirrored()


# What a cylinder's force counts: 1, or its arm. The vector of a moment is that of the forces of the couple,
# in their direction; the axis of the couple is square to it.
WEIGH: Mapping[str, Callable[[Cylinder], Fraction]] = {
    "force": lambda cylinder: Fraction(1),
    "moment": lambda cylinder: cylinder.position,
}


def residual(arrangement: Arrangement, key: str, order: int) -> Residual:
    """Return the free force of an order, or the moment: each force times its position along the shaft."""
    check_order(order)
    # B_k is negative for k = 4, 8, 12, ...
    sign = -1 if order % 4 == 0 else 1
    forward, backward = Star(), Star()
    for cylinder in arrangement.cylinders:
        arm = WEIGH[key](cylinder)
        weight = sign * arm * cylinder.mass
        forward += of_kernel.forward(order, cylinder.crank, cylinder.bank, weight)
        backward += of_kernel.backward(order, cylinder.crank, cylinder.bank, weight)
        if order == 1:
            turning = arm * cylinder.revolving - weight * arrangement.share
            forward += Star.ray(cylinder.crank, turning)
    return Residual(forward, backward)


def check_order(order: int) -> None:
    """Raise ProblemError unless the order is one of 1..MOST_ORDERS."""
    if not 1 <= order <= harmonics.MOST_ORDERS:
        raise ProblemError(
            f"free forces of order {order} were asked for; orders 1 to {harmonics.MOST_ORDERS} are given"
        )


def factor(order: int, crank: Crank, method: str = "exact") -> Real:
    """Return |B_k|, by which residuals are multiplied to be in units of m R ω²."""
    check_order(order)
    return abs(harmonics.real(harmonics.HARMONICS["p"], order, crank, method))


def _length(star: Star) -> Real:
    return Vector(star).length()


def _half_axis(sign: int) -> Callable[[Residual], Real]:
    """Return the half axis |f| ± |b| of the ellipse that the two vectors describe; a line's lesser is 0."""

    def length(residual: Residual) -> Real:
        forward, backward = residual
        if sign < 0 and (forward.square() - backward.square()).vanishes():
            return Real.of(0)
        return abs(_length(forward) + _length(backward) * sign)

    return length


LENGTHS: Mapping[str, Callable[[Residual], Real]] = {
    "along": lambda residual: _length(residual.component(Fraction(0))),
    "across": lambda residual: _length(residual.component(Fraction(90))),
    "forward": lambda residual: _length(residual.forward),
    "backward": lambda residual: _length(residual.backward),
    "greatest": _half_axis(1),
    "least": _half_axis(-1),
}
"""Amplitudes of the components along and across the line from which angles count; the magnitudes of the
two turning vectors; the half axes of the ellipse that they describe."""


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
            yield WORDS["each"][lang].format(masses=listed_once(self.each), rod=rod)
            yield ", ".join(filter(None, (size, turns_label(known(self.crank.speed)), spacing)))
        else:
            yield ", ".join(filter(None, (f"$m = {amount(self.mass, 'kg')}${rod}", spacing)))
        if self.revolving:
            yield WORDS["revolving"][lang].format(
                masses=listed_once(self.revolving), share=f"${figure(self.revolving_share)}$"
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
            radius=f"${amount(self.balance_radius, 'mm')}$", masses=listed_once(masses)
        )


def listed_once(masses: Sequence[Fraction]) -> Label:
    """Return masses in kg in a row, once where all are alike."""
    shown = masses[:1] if len(set(masses)) == 1 else masses
    return "; ".join(f"${amount(one, 'kg')}$" for one in shown)
