"""The moving masses of a drive: piston and crosshead, connecting rod, crank, rocker, and what they weigh."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from kurbel.commands.options import Option, alone, amount, file, measure
from kurbel.commands.part import Part, Rivals, flag_of
from kurbel.commands.parts.drive import Speed
from kurbel.drive.at import acceleration_of
from kurbel.errors import NotationError, ProblemError
from kurbel.motion.mechanism import of_other_mechanisms
from kurbel.reading.amounts import STANDARD_GRAVITY
from kurbel.reading.given import (
    allowed_name,
    as_angle,
    as_displacement,
    as_duration,
    as_gravity,
    as_inertia,
    as_mass,
    as_number,
    as_share,
    as_share_or_length,
    as_signed_mass,
)
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.drive.moved import Drive
    from kurbel.drive.rod import Rod, Slope, Swing
    from kurbel.motion.mechanism import Mechanism

_UNKNOWN = "that of the rod is not known; add --stroke and one --ratio, or give a share of the rod's length"
# By which of these the rod's k is known, each with what says about which point.
SWUNG, WEIGHED = ("pendulum", "pendulum_from"), ("rod_inertia", "rod_inertia_about")
OF_ROD = ("rod_mass", "centre", "gyration", *SWUNG, *WEIGHED, "rod_file")


def each(value: object) -> Sequence[object]:
    """Return the entries of a list, which may be text."""
    if isinstance(value, str):
        return [part.strip() for part in value.split(";")]
    return [*value] if isinstance(value, list | tuple) else [value]


def _swings(value: object, what: str) -> tuple[Fraction, ...]:
    """Return the times of swings: 1.8s, 90s/50. Raises KurbelError."""
    found = []
    for one in each(value):
        time, slash, count = one.rpartition("/") if isinstance(one, str) else (one, "", "")
        swings = as_number(count, "number of swings") if slash else Fraction(1)
        if swings <= 0:
            raise ProblemError(f"the number of swings is {about(swings)}; it must be above 0")
        found.append(as_duration(time if slash else one, what) / swings)
    return tuple(found)


def place_on_rod(value: object, length: Fraction | None, what: str) -> Fraction:
    """Return a point of the rod, in its lengths from the crosshead pin. Raises KurbelError."""
    from kurbel.drive.rod import PINS
    from kurbel.reading.units import is_measure

    if isinstance(value, str) and not any(map(str.isdigit, value)):
        return PINS[allowed_name(value, PINS, what)]
    if not isinstance(value, str) or not is_measure(value):
        return as_share(value, what)
    if length is None:
        raise NotationError(f'{what} "{value[:40]}" is a length, but {_UNKNOWN}')
    return as_displacement(value, what) / length


class MovingRod(Part):
    """The masses of a connecting rod."""

    title, add = "a rod with a mass", "--rod-mass"
    topic = "masses"
    section = "masses"
    rivals: ClassVar[Rivals] = (
        *((name, "rod_file") for name in ("rod_mass", "centre", "gyration", *SWUNG, *WEIGHED)),
        *(("rod_file", name) for name in ("centre", "gyration", "pendulum", "rod_inertia")),
        *(("gyration", name) for name in (*SWUNG, *WEIGHED)),
        *((name, "gyration") for name in (*SWUNG, *WEIGHED)),
        *(pair for one in SWUNG for other in WEIGHED for pair in ((one, other), (other, one))),
    )

    rod_mass = measure(as_mass, "Mass of the connecting rod: 150kg.", "MASS", machine="masses.rod")
    centre = amount(
        "Centre of mass of the rod from the crosshead pin, in rod lengths: 0.6, 60%; or a length, where that"
        " of the rod is known.",
        "A", unit="rod lengths",
    )  # fmt: skip
    gyration = amount(
        "Radius of gyration about the centre of mass, in rod lengths: 0.3; or a length.", "K",
        unit="rod lengths",
    )  # fmt: skip
    pendulum = measure(
        _swings,
        "In place of --gyration the time of a full swing, to and fro, about the point that --pendulum-from"
        " names: 1.8s, or of 50 swings 90s/50; '1.83s;1.68s' of swings about two points, which give the"
        " centre of mass, too.",
        "TIME", unit="s", what="time of a swing", whole=True,
    )  # fmt: skip
    pendulum_from = amount(
        "The point about which the rod swung: crosshead or crank, the pins, or its place from the crosshead"
        " pin towards the crank, in rod lengths or as a length: -40mm; of two swings '-40mm;crank'.",
        "POINT", unit="rod lengths", whole=True,
    )  # fmt: skip
    rod_inertia = measure(
        as_inertia,
        "In place of --gyration the moment of inertia of the rod: '0.35 kg m²', with --rod-mass and its"
        " length.",
        "J", what="moment of inertia",
    )  # fmt: skip
    rod_inertia_about = amount(
        "The point about which that is: crosshead, crank, or its place as in --pendulum-from; default the"
        " centre of mass.",
        "POINT", unit="rod lengths",
    )  # fmt: skip
    rod_file = file(
        "The rod's masses from a CSV file in place of these: from, to, mass or position, mass, counted from"
        " the crank pin.",
        machine="masses.file",
    )  # fmt: skip

    def moving_rod(self, length: Fraction | None) -> Rod:
        """Return the connecting rod between pins so far apart, in metres, if that is known."""
        from kurbel.drive.rod_file import given_rod, swung_rod, weighed_rod

        centre = self._part_of(length, self.centre, "centre of mass")
        ways = {"--pendulum": SWUNG, "--rod-inertia": WEIGHED}
        way = next((flag for flag, names in ways.items() if self.says(*names)), "")
        if not way:
            gyration = self._part_of(length, self.gyration, "radius of gyration")
            return given_rod(centre, gyration, self.rod_file, self.rod_mass, length)
        for name in ("gyration", "rod_file", *(WEIGHED if way == "--pendulum" else ())):
            if self.says(name):
                raise ProblemError(f"{flag_of(name)} and {way} say the same; leave one out")
        if way == "--pendulum":
            return swung_rod(self.swings(length), centre, length, self.rod_mass)
        inertia, from_ = self.rod_inertia, self.rod_inertia_about
        if inertia is None:
            raise ProblemError("--rod-inertia-about is for --rod-inertia; add it, such as '0.35 kg m²'")
        place = None if from_ is None else place_on_rod(from_, length, "point")
        return weighed_rod(inertia, place, centre, length, self.rod_mass)

    def swings(self, length: Fraction | None) -> list[Swing]:
        """Return the swings that are described. Raises ProblemError where a time or a point is missing."""
        from kurbel.drive.rod import GREATEST_GRAVITY, Swing

        times, given = self.pendulum, self.pendulum_from
        if times is None:
            raise ProblemError(
                "--pendulum-from is for --pendulum, the time of a full swing; add it, such as 1.8s"
            )
        if given is None:
            raise ProblemError(
                "--pendulum needs the point about which the rod swung; add --pendulum-from crosshead"
            )
        gravity = self.as_part(Weight).gravity
        if gravity is not None and not 0 < gravity <= GREATEST_GRAVITY:
            raise ProblemError(f"gravity is {about(gravity)} m/s²; it must be above 0 and at most 1000")
        places = [place_on_rod(one, length, "point of a swing") for one in each(given)]
        if len(times) > 2 or len(places) != len(times):
            raise ProblemError(
                f"--pendulum has {len(times)} times, and --pendulum-from {len(places)} points; give a time"
                " and a point, or two of each"
            )
        own = STANDARD_GRAVITY if gravity is None else gravity
        return [Swing(time, place, own) for time, place in zip(times, places, strict=True)]

    def _part_of(self, length: Fraction | None, value: object, what: str) -> Fraction | None:
        return None if value is None else as_share_or_length(value, what, length, _UNKNOWN)


def _slope(value: object, what: str) -> Fraction:
    """Return the angle of a slope. Raises KurbelError."""
    from kurbel.drive.rod import VERTICAL

    is_word = isinstance(value, str) and value.strip().lower() == "vertical"
    return VERTICAL if is_word else as_angle(value, what)


class Weight(Part):
    """How the cylinder stands, by which moving masses have a weight."""

    title, add = "the weight of moving masses", "--reciprocating or a rod, --rod-mass"
    topic = "masses"
    section = "crank"

    slope = measure(
        _slope,
        "Angle by which the slide rises from the shaft to the cylinder, for the weight of what moves: 30;"
        " vertical is 90, above the shaft, and -90 below it. It counts in the sense of rotation: 180-30 with"
        " the crank pin below on the outstroke.",
        "ANGLE", unit="degrees",
    )  # fmt: skip
    gravity = measure(
        alone(as_gravity), "Acceleration of gravity, for the weight: 9.81; default 9.80665m/s².", "G",
        unit="m/s²",
    )  # fmt: skip

    def stands(self) -> bool:
        """Whether it is said how the cylinder stands."""
        return self.says("slope")

    def slope_of_slide(self) -> Slope | None:
        """Return how the slide rises, None where weight does not count; a cylinder of several leans by its
        `bank` from that."""
        angle = self.slope
        if angle is None:
            return None
        from kurbel.drive.rod import Slope

        gravity = self.gravity
        found = Slope(angle, STANDARD_GRAVITY if gravity is None else gravity)
        lean = as_angle(self.values.values.get("bank") or 0, "bank")
        return Slope((angle + lean + 180) % 360 - 180, found.gravity) if lean else found

    def unread(self, option: Option[object]) -> str:
        if option.name not in ("slope", "gravity"):
            return ""
        if not self.as_part(Masses).is_heavy():
            return f"--{option.name} is for {Weight.title}; add {Weight.add}"
        if option.name == "gravity" and not self.stands():
            return "--gravity is for weights; add --slope, by which the cylinder stands"
        return ""


class Rotating(Part):
    """The mass of the crank itself."""

    topic = "masses"

    rotating = measure(
        as_signed_mass,
        "Mass of the crank itself at its pin, for the main bearing: 60kg; -40kg if counterweights outweigh"
        " it.",
        "MASS", what="rotating mass", machine="masses",
    )  # fmt: skip


class Masses(MovingRod, Weight):
    """What moves with the drive."""

    title, add = "moving masses", "--reciprocating or a rod, --rod-mass"
    topic = "masses"

    reciprocating = measure(
        as_mass,
        "Mass of piston and crosshead: 200kg. Masses need --stroke and --speed, and beside steam --bore and"
        " --pressure.",
        "MASS", what="reciprocating mass", machine="masses",
    )  # fmt: skip
    rocker_inertia = measure(
        as_inertia,
        "Moment of inertia of the rocker about its pivot: '20kg m²'.",
        "INERTIA",
        machine="masses.rocker",
    )

    @classmethod
    def masses(cls) -> Iterator[str]:
        """Yield the names of the options of which each makes the drive heavy."""
        yield from ("reciprocating", *OF_ROD, "rotating", "rocker_inertia")

    def is_heavy(self) -> bool:
        """Whether any mass is given, or among the entries of cylinders."""
        names, cylinders = {*Masses.masses()}, self.values.values.get("cylinder")
        entries = cylinders if isinstance(cylinders, Sequence) else ()
        return self.says(*names) or any(names & {*one} for one in entries)

    def a_mass(self) -> str:
        """Return the first of the masses that are given."""
        return next(name for name in Masses.masses() if self.says(name))

    def weighed(
        self, chosen: Mechanism, drives: Sequence[Drive], *beside: str, even: bool = False
    ) -> list[Drive]:
        """Return the drives with their masses, and the speed that makes forces of these.

        `beside` are the names of further options that every mass needs; the crank of an engine turns `even`.
        """
        if not self.is_heavy():
            return list(drives)
        if not chosen.heavy:
            raise ProblemError(
                f"the forces of moving masses in {chosen.title} are not computed; leave"
                f" {flag_of(self.a_mass())} out, or --mechanism {chosen.name}"
            )
        foreign = of_other_mechanisms(chosen, [name for name in Masses.masses() if self.says(name)])
        for sentence in foreign.values():
            raise ProblemError(sentence)
        cranks = [chosen.crank(drive) for drive in drives]
        missing = [flag_of(name) for name in ("speed", *beside) if not self.says(name)]
        if any(crank.radius is None for crank in cranks):
            missing.insert(0, "--stroke")
        if missing:
            *others, last = missing
            needed = f"{', '.join(others)} and {last}" if others else last
            raise ProblemError(f"{flag_of(self.a_mass())} needs {needed} to become a force")
        from kurbel.drive.rod import MovingMasses

        # One rod for all ratios has a length of its own only if there is one ratio.
        length = cranks[0].rod_length if len(cranks) == 1 else None
        slope = self.slope_of_slide()
        moving = MovingMasses(
            self.reciprocating or Fraction(0),
            self.moving_rod(length) if self.says(*OF_ROD) else None,
            self.as_part(Rotating).rotating or Fraction(0),
            self.rocker_inertia or Fraction(0),
            slope=slope,
        )
        if slope is not None and not chosen.crosshead:
            raise ProblemError(
                f"{chosen.title} with the weight of its masses is not computed, for its rocker or axles have"
                " weights that are not given; leave --slope out"
            )
        speed = self.as_part(Speed).speed
        heavy = [replace(crank, speed=speed, moving=moving) for crank in cranks]
        if self.says("acceleration") and not even:
            if not chosen.crosshead:
                raise ProblemError(
                    f"{chosen.title} with its masses is computed for a crank that turns evenly; leave"
                    " --acceleration out"
                )
            gain = acceleration_of(self.raw("acceleration"), speed)
            heavy = [replace(crank, acceleration=gain) for crank in heavy]
        return [drive.of(crank) for drive, crank in zip(drives, heavy, strict=True)]
