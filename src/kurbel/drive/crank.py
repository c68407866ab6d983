"""The crank drive that a table is about, checked once, and as the options described it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import asin, degrees
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import At, acceleration_of, known
from kurbel.drive.moved import DeadCentres, Moved, moved
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Numeric
from kurbel.reading.given import as_fraction, as_length, as_number, as_ratios, as_share, as_speed
from kurbel.reading.notation import Progression, about, check_bounds, ratio_text

if TYPE_CHECKING:
    from kurbel.drive.effort import Effort
    from kurbel.drive.load import PistonForce
    from kurbel.drive.rod import MovingMasses, Rod
    from kurbel.reading.units import Speed

LONGEST_ROD = 10**9
LARGEST_ANGLE = 10**6


class Diameters(NamedTuple):
    """Those of crosshead pin, crank pin and shaft in metres, where they are known."""

    crosshead_pin: Fraction | None = None
    crank_pin: Fraction | None = None
    shaft: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Crank(DeadCentres):
    """A crank drive: ratio λ = R/L, offset e/R, crank radius R in metres, speed, piston force,
    connecting rod, moving masses and what else acts on piston and crosshead, where they are known; its
    angular acceleration in rad/s²; the diameters of its pins.

    Valid for 0 <= λ < 1 and |e| < L − R; λ = 0 is the infinite rod.
    """

    ratio: Fraction
    offset: Fraction = Fraction(0)
    radius: Fraction | None = None
    speed: Speed | None = None
    force: PistonForce | None = None
    rod: Rod | None = None
    moving: MovingMasses | None = None
    acceleration: Fraction = Fraction(0)
    effort: Effort | None = None
    diameters: Diameters | None = None

    @property
    def crank(self) -> Crank:
        """What is known of the crank, as of other drives."""
        return self

    def of(self, crank: Crank) -> Crank:
        """Return the drive with what else is known of its crank, as of other drives."""
        return crank

    def at(self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None) -> At:
        """Return a place of the drive, as other drives do."""
        ratio = numbers.of(stroke * (Fraction(0) if method == "infinite" else self.ratio))
        offset = numbers.of(stroke * self.offset) if self.offset else None
        return At(circle, self, numbers, stroke, ratio, offset, method == "series")

    def moved(self, kind: Kind, method: str) -> Moved:
        """Return the drive as a turn of an engine asks it, by a method, on a kind of number."""
        return moved(self, kind, method)

    @property
    def loaded(self) -> bool:
        """Whether more than one force that is given acts on the drive."""
        return self.moving is not None or self.effort is not None

    @property
    def weighed(self) -> bool:
        """Whether the weight of its masses counts."""
        return self.moving is not None and self.moving.slope is not None

    @property
    def has_friction(self) -> bool:
        """Whether there is friction on piston and crosshead."""
        return self.effort is not None and bool(self.effort.friction)

    @property
    def pinned(self) -> bool:
        """Whether the friction of its pins is known."""
        return self.effort is not None and self.effort.pins is not None and self.radius is not None

    @property
    def pushed(self) -> bool:
        """Whether forces in newtons are known."""
        return self.force is not None or self.loaded

    @property
    def rod_length(self) -> Fraction | None:
        """L in metres, None if it is not known or infinite."""
        return self.radius / self.ratio if self.radius is not None and self.ratio else None

    def way(self, numbers: Kind) -> Numeric:
        """Return the stroke in units of R."""
        if not self.offset:
            return numbers.of(Fraction(2))
        return kinematics.stroke(numbers.of(self.ratio), numbers.of(self.offset))

    def dead_angle(self, stroke: int, kind: Kind) -> Numeric:
        if not self.offset:
            return super(Crank, self).dead_angle(stroke, kind)
        return kind.arc(
            kinematics.dead_centre_sine(kind.of(stroke * self.ratio), kind.of(stroke * self.offset))
        )

    def least_transmission(self, kind: Kind) -> Numeric:
        return 90 - kind.arc(kind.of(self.ratio * (1 + abs(self.offset))))

    def pin_velocity(self, numbers: Kind) -> Numeric:
        """Return v = R ω of the crank pin in m/s."""
        speed, radius = known(self.speed), known(self.radius)
        if not speed.turns:
            return numbers.of(radius * speed.value)
        return numbers.of(2 * radius * speed.value) * numbers.pi

    def mean_velocity(self, numbers: Kind, way: Any = None) -> Numeric:
        """Return c_m of the piston in m/s. Of turns it is S n/30, without the π of the crank-pin velocity.

        Source: Blau, eq. (23), (24); S is the drive's own stroke, or another `way`.
        """
        speed, stroke = known(self.speed), self.way(numbers) if way is None else way
        if speed.turns:
            metres = stroke * numbers.of(known(self.radius))
            return kinematics.mean_piston_speed(metres, numbers.of(60 * speed.value))
        return self.pin_velocity(numbers) * kinematics.mean_piston_velocity(stroke, numbers.pi)

    def pin_to_mean(self, numbers: Kind) -> Numeric:
        """Return v : c_m = π R : S. Source: Blau, eq. (24), for any stroke."""
        return numbers.pi / self.way(numbers)

    def pin_acceleration(self, numbers: Kind) -> Numeric:
        """Return v²/R of the crank pin in m/s²."""
        velocity = self.pin_velocity(numbers)
        return velocity * velocity / numbers.of(known(self.radius))

    def millimetres(self, numbers: Kind) -> Numeric:
        return numbers.of(1000 * known(self.radius))

    def newtons(self, numbers: Kind) -> Numeric:
        """What makes newtons of a unit force; forces of moving masses are in newtons as they are."""
        return numbers.of(Fraction(1) if self.loaded else known(self.force).first)

    def newton_metres(self, numbers: Kind) -> Numeric:
        return self.newtons(numbers) * numbers.of(known(self.radius))

    def shaft_gain(self, numbers: Kind) -> Numeric:
        """What makes the angular acceleration of the shaft in 1/s² of a force at R in newtons, R/J."""
        return numbers.of(known(self.radius) / known(known(self.effort).shaft).inertia)

    def __post_init__(self) -> None:
        check_ratio(self.ratio)
        if abs(self.offset) > LONGEST_ROD:
            raise ProblemError(f"offset e is above {LONGEST_ROD} R; no crank turns so far from its slide")
        if self.ratio and abs(self.offset) >= 1 / self.ratio - 1:
            raise ProblemError(
                f"offset e = {about(self.offset)} R is too large for R:L = {ratio_text(self.ratio)};"
                f" the crank turns only if |e| < L - R = {about(1 / self.ratio - 1)} R,"
                f" {_where_stuck(self.ratio, self.offset)}"
            )
        check_bounds("the crank radius", self.radius, "be above 0", " m")
        if self.speed is not None and self.radius is None and self.moving is None:
            raise ProblemError("a speed needs a length to give m/s; add --stroke, for example --stroke 600mm")
        if self.moving is not None and (self.radius is None or self.speed is None):
            raise ProblemError(
                "masses need the stroke and the speed to become forces; add these, for example --stroke 600mm"
                " --speed 120/min"
            )


def check_angles(angles: Sequence[Fraction]) -> None:
    """Raise ProblemError unless there are angles and all lie within a million degrees of zero."""
    if not angles:
        raise ProblemError(
            "no angle was given; write them as --angle '0;45;90' or --from 0 --to 180 --step 10"
        )
    if largest(angles) > LARGEST_ANGLE:
        raise ProblemError(f"an angle is beyond {LARGEST_ANGLE}°; give it within one turn, 0..360")


def largest(angles: Sequence[Fraction]) -> Fraction:
    """Return the greatest magnitude among the angles."""
    return max(map(abs, ends(angles)))


def ends(angles: Sequence[Fraction]) -> Sequence[Fraction]:
    """Return angles among which are the extremes of all."""
    # A progression has its ends for its extremes, and may be too long to be looked at whole.
    return (angles[0], angles[-1]) if isinstance(angles, Progression) else angles


def _where_stuck(ratio: Fraction, offset: Fraction) -> str:
    """Say at which crank angle an offset beyond the dead centres stops the crank."""
    spare = float(1 / ratio - abs(offset))
    if spare <= -1:
        return "and this rod reaches the slide at no angle"
    angle = (180 if offset > 0 else 0) + degrees(asin(spare))
    return f"for at φ = {angle % 360:.4g}° the rod stands square to the slide"


def check_ratio(ratio: Fraction) -> None:
    if ratio < 0:
        raise ProblemError(
            f"crank ratio R:L is {about(ratio)}; it must not be negative, for both are lengths"
        )
    if ratio >= 1:
        upright = 1 < ratio <= 100 and ratio.denominator <= 10
        hint = f"; a rod of {about(ratio)} cranks is {ratio_text(1 / ratio)}" if upright else ""
        raise ProblemError(
            f"crank ratio R:L is {about(ratio)}; it must be below 1,"
            f" or the rod is too short to pass the dead centre{hint}"
        )
    if 0 < ratio < Fraction(1, LONGEST_ROD):
        raise ProblemError(
            f"crank ratio R:L is below 1:{LONGEST_ROD}; no rod is that long,"
            " write 1:∞ or 1:inf for an infinite one"
        )


def _given_twice(made: Fraction, said: Sequence[Fraction]) -> str:
    """Return the sentence on ratios beside the lengths that give one, with both where they contradict."""
    if said == (made,):
        return "--stroke and --rod already give the ratio; leave --ratio out"
    ratios = ";".join(map(ratio_text, said))
    return f"--stroke and --rod give the ratio {ratio_text(made)}, and --ratio says {ratios}; leave one out"


class DescribedDrive(NamedTuple):
    """What was said of a crank drive, None where nothing was: its options as they were given, in the order
    in which one too many is refused; the force as it was read."""

    ratio: object = None
    stroke: object = None
    rod: object = None
    speed: object = None
    method: str | None = None
    offset: object = None
    rocker: object = None
    pivot: object = None
    circuit: object = None
    beam: object = None
    rocker_inertia: object = None
    force: PistonForce | None = None
    acceleration: object = None

    @classmethod
    def of(cls, given: Mapping[str, object]) -> DescribedDrive:
        """Return what is given by the names of options. Raises KurbelError."""
        known = {name: given[name] for name in cls._fields if name in given}
        force, method, read = known.pop("force", None), known.pop("method", None), None
        if force is not None:
            from kurbel.drive.load import read_force

            read = read_force(force)
        return cls(**known, method=method if isinstance(method, str) else None, force=read)

    def ratios(self, default: Sequence[str]) -> tuple[Fraction, ...]:
        """Return the crank ratios, or those of a layout."""
        return as_ratios(default if self.ratio is None else self.ratio)

    @property
    def radius(self) -> Fraction | None:
        """R in metres of 2R."""
        return None if self.stroke is None else as_length(self.stroke, "stroke") / 2

    @property
    def rodless(self) -> Crank:
        """What is known of the crank of a drive without a rod."""
        turns = None if self.speed is None else as_speed(self.speed)
        return replace(RODLESS, radius=self.radius, speed=turns, force=self.force)

    def cranks(self, default: Sequence[str]) -> tuple[Crank, ...]:
        """Return the straight or offset cranks, of a layout's ratios if nothing gives one."""
        if self.method == "infinite" and self.rod is not None and self.stroke is None:
            raise ProblemError("--rod gives the rod a length, but --method infinite takes none; use --stroke")
        radius = self.radius
        length = None if self.rod is None else as_length(self.rod, "rod")
        check_bounds("the length of the rod", length, "be above 0", " m")
        if radius is not None and length is not None:
            values: Sequence[Fraction] = (radius / length,)
            if self.ratio is not None:
                raise ProblemError(_given_twice(radius / length, self.ratios(())))
        else:
            values = self.ratios(default)
            if length is not None and 0 in values:
                raise ProblemError(
                    "--rod gives the rod a length, but ratio 1:∞ asks for an infinite one; leave one out"
                )
        turns = None if self.speed is None else as_speed(self.speed)
        gain = Fraction(0)
        if self.acceleration is not None:
            gain = acceleration_of(self.acceleration, turns)
        return tuple(
            Crank(value, self._offset(size), size, turns, self.force, acceleration=gain)
            for value in values
            for size in [length * value if length is not None and radius is None else radius]
        )

    def _offset(self, radius: Fraction | None) -> Fraction:
        """e/R from a share of R or a length, which may be negative."""
        value = self.offset
        if value is None:
            return Fraction(0)
        if not isinstance(value, str):
            return as_fraction(value)
        from kurbel.reading import units

        share = value.strip().removesuffix("R")
        if not units.is_measure(share):
            return as_share(share, "offset")
        displacement = units.displacement(value, "offset")
        if radius is None:
            raise NotationError(
                f'offset "{value[:40]}" is a length, but no length of the crank is known;'
                " add --stroke or give e as a share of R"
            )
        return displacement / radius


def radii(value: object, what: str, radius: Fraction | None) -> Fraction:
    """Return a length of a drive in units of R, which is so many metres if it is known: 6, 6R, 900mm."""
    if not isinstance(value, str):
        return as_fraction(value)
    from kurbel.reading import units

    share = value.strip().removesuffix("R")
    if not units.is_measure(share):
        return as_number(share, what)
    length = units.displacement(value, what)
    if radius is None:
        raise NotationError(
            f'{what} "{value[:40]}" is a length, but no length of the crank is known; add --stroke,'
            " or give it in units of R, for example 6"
        )
    return length / radius


# Of a drive without a rod.
RODLESS = Crank(Fraction(0))
