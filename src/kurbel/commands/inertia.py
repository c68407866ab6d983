"""The forces of the moving rod alone, over the crank angle, and the masses that stand in for it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from fractions import Fraction

from kurbel.commands.options import Option, measure
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.angles import Angles
from kurbel.commands.parts.drive import OF_MASSES, AnyDrive, Turning
from kurbel.commands.parts.masses import MovingRod, Weight, each
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_over_angle, layout_option
from kurbel.commands.subject import function
from kurbel.errors import ProblemError
from kurbel.linkage.arc_quantities import RockerInertiaRequest
from kurbel.motion.inertia_page import ErrorsRequest, InertiaRequest
from kurbel.motion.mechanism import Mechanism
from kurbel.motion.rod_masses import RodMassesRequest
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question
from kurbel.reading.given import as_angular_acceleration, as_length, as_ratios

# What several rods have lists of.
LISTED = ("centre", "gyration", "rod_mass")
MASSES, ERRORS = ("rod masses", "pin masses"), "inertia errors"
INERTIA, ROCKER_INERTIA = ("inertia", ERRORS, *MASSES), "rocker inertia"


class InertiaOptions(Angles, AnyDrive, MovingRod, Turning, Layouts, Sheet, CommandOptions):
    """Print the forces that the moving rod calls up at guide and crank pin, and the torque.

    Exact, by two masses at the pins that keep the centre of mass, and by the railway rule, 6/10 of the mass
    rotating and 4/10 reciprocating. Layout inertia-errors has the greatest forces and errors of a turn,
    rod-masses the masses themselves, and those that are dynamically equivalent.

    \b
    kurbel inertia --centre 0.6 --gyration 0.3  # without dimensions
    kurbel inertia --centre 0.6 --gyration 0.3 --digits 6  # more decimals
    kurbel inertia --machine engine.toml  # in newtons
    kurbel inertia --rod-file rod.csv --stroke 600mm --speed 120/min
    kurbel inertia --centre 0.65 --gyration 0.35 --layout inertia-errors
    kurbel inertia --rod 500mm --centre 325mm --pendulum 1.3s --pendulum-from crosshead --layout rod-masses
    kurbel inertia --centre 0.65 --gyration 0.35 --mechanism arc --rocker 6
    \f
    >>> import kurbel
    >>> page = kurbel.inertia("1:5", centre=0.6, gyration=0.48, angle=90, columns="inertia_guide")
    >>> print(kurbel.typeset(page, "csv"), end="")
    inertia_guide
    0.0067
    """

    unnamed = "ratio"
    sequence = (
        "angle from_ to step zero columns offset stroke time_ratio rod mechanism rocker"
        " pivot circuit beam rod_mass centre gyration rod_file speed acceleration method"
    )
    in_short = "ratio stroke rod speed machine rod_mass centre gyration rod_file angle columns digits"

    columns = columns_over_angle("inertia", "phi,inertia_guide,inertia_pin")
    speed = Turning.speed.but(help="Speed, for columns in N and N m: 120/min, 12.5rad/s.")
    centre = MovingRod.centre.but(
        help="Centre of mass of the rod from the crosshead pin, in rod lengths: 0.6, 60%; or a length, where"
        " that of the rod is known. Several rods on one page are lists: '0.6;0.65;0.7'."
    )
    method = OF_MASSES.but()
    layout = layout_option(*INERTIA, ROCKER_INERTIA)
    rod_acceleration = measure(
        as_angular_acceleration,
        "With --layout rod-masses: angular acceleration of the rod, for the correction couple: 23000rad/s².",
        "ALPHA", topic="masses",
    )  # fmt: skip
    gravity = Weight.gravity.but(help="Acceleration of gravity, for --pendulum: 9.81; default 9.80665m/s².")

    def question(self) -> Question:
        if self.layout_subject in MASSES:
            self.refuse("mechanism")
        chosen = self.drive()
        if not (chosen.crosshead or "rocker_inertia" in chosen.takes):
            raise ProblemError(
                f"{chosen.title} has no rod that swings; its inertia is computed of the straight, offset and"
                " arc crank and of the beam engine"
            )
        if not chosen.crosshead:
            if self.says("acceleration"):
                raise ProblemError(
                    f"{chosen.title} with its masses is computed for a crank that turns evenly; leave"
                    " --acceleration out"
                )
            return self._rocker(chosen)
        page = self.page("inertia", *INERTIA)
        if page.subject in MASSES:
            return self._masses(page)
        _, described = self.described()
        cranks, rods = described.cranks(page.ratios), self._rods()
        if rods[1:] and cranks[1:]:
            raise ProblemError(
                f"several rods stand beside each other at one crank ratio, and {len(cranks)} were given; give"
                " one, or one rod"
            )
        cranks = tuple(
            replace(crank, rod=one.moving_rod(crank.rod_length)) for crank in cranks for one in rods
        )
        if page.subject == ERRORS:
            self.check_whole(page)
            for name in ("method", "acceleration"):
                if self.says(name):
                    raise ProblemError(
                        f"layout {page.key} is of a whole even turn, by the exact formulas; leave --{name}"
                        " out, or use --layout inertia"
                    )
            return ErrorsRequest(drives=cranks, **self.on_page(page, "greatest,error_percent"))
        question = InertiaRequest(
            drives=cranks,
            angles=self.angles(page),
            method=self.method,
            zero=self.zero_angle,
            **self.on_page(page, "phi,x,c,p"),
        )
        return self.over_strokes(question)

    def shared(self) -> Collection[str]:
        return ("stroke", "speed")

    def unread(self, option: Option[object]) -> str:
        name = option.name
        if name == "gravity":
            return "--gravity is for the time of a swing; add --pendulum, or leave it out"
        if name == "rod_acceleration":
            return "--rod-acceleration is for the masses of a rod by itself; add --layout rod-masses"
        if self.layout_subject not in MASSES:
            return ""
        why = f"layout {self.layout} is of the rod by itself"
        if name not in ("ratio", "stroke"):
            return f"{why}; leave --{name} out"
        if self.says("rod"):
            return f"{why}, whose length --rod gives; leave --{name} out"
        stroke = "--stroke"
        lone, other = ("--ratio", stroke) if name == "ratio" else (stroke, "--ratio")
        return f"{why}, whose length {stroke} and --ratio give together; add {other}, or leave {lone} out"

    def _rods(self) -> Sequence[MovingRod]:
        """Return the options of each rod, of several by their lists."""
        lists = {name: each(self.raw(name)) for name in LISTED if self.says(name)}
        count = max(map(len, lists.values()), default=1)
        if count == 1:
            return [self]
        for name, values in lists.items():
            if len(values) not in (1, count):
                raise ProblemError(
                    f"{flag_of(name)} has {len(values)} values, and there are {count} rods; give one for"
                    " each, or one for all"
                )
        own = [{name: one[place % len(one)] for name, one in lists.items()} for place in range(count)]
        return [InertiaOptions(self.values.instead(one, own=True)) for one in own]

    def _masses(self, page: Layout) -> Question:
        """Return what is asked for of the masses that stand in for the rod, at rest."""
        self.check_whole(page)
        length = self._length()
        return RodMassesRequest(
            rod=self.moving_rod(length),
            length=length,
            acceleration=self.rod_acceleration,
            **self.on_page(page, "model,crosshead_mass"),
        )

    def _length(self) -> Fraction | None:
        """Return the length of the rod in metres, given or by the stroke and one ratio, None if not known."""
        if self.says("rod"):
            return as_length(self.rod, "rod")
        if not (self.says("stroke") and self.says("ratio")):
            return None
        ratios, stroke = as_ratios(self.ratio), as_length(self.stroke, "stroke")
        return stroke / 2 / ratios[0] if len(ratios) == 1 and ratios[0] else None

    def _rocker(self, chosen: Mechanism) -> Question:
        """Return what is asked for of the rod that moves a rocker."""
        page = self.page("inertia-rocker", ROCKER_INERTIA)
        _, described = self.described(beside=("stroke",), leaving=("speed",))
        speed = self.speed
        drives = []
        for drive in chosen.drives(described, page.ratios):
            crank = chosen.crank(drive)
            rod = self.moving_rod(crank.rod_length)
            drives.append(drive.of(replace(crank, rod=rod, speed=speed)))
        printed = self.on_page(page, "phi,inertia_guide")
        for name in printed["columns"]:
            if name.startswith("inertia_mollier"):
                raise ProblemError(
                    f"column {name} is a force along a slide, and {chosen.title} has none; leave it out"
                )
        return RockerInertiaRequest(
            drives=tuple(drives), angles=self.angles(page), zero=self.zero_angle, **printed
        )


inertia = function(InertiaOptions, "inertia")
