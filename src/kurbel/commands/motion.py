"""The motion of the piston, over the crank angle or over its path, of points of the rod, and dead centres."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import ClassVar

from kurbel.commands.options import Columns, Option, flag, measure
from kurbel.commands.part import CommandOptions, Rivals
from kurbel.commands.parts.angles import ANGLE, ENDS, FORCES_OVER_PATH, OVER_PATH, Angles
from kurbel.commands.parts.drive import (
    APPROXIMATE,
    POINTS,
    AnyDrive,
    Linked,
    PinSizes,
    Series,
    Speed,
    Turning,
    with_pins,
)
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, columns_over_angle, layout_option
from kurbel.commands.subject import function
from kurbel.drive.crank import DescribedDrive
from kurbel.drive.mechanisms import MOTIONS
from kurbel.drive.moved import Drive
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_numbers

ERRORS = "series errors"
BEAM, DRIVE = "dead centres", "drive dead centres"
_OF_DRIVES = ("mechanism", "offset", "rocker", "pivot", "circuit", "speed")
_LENGTHS = ("stroke", "rod")


class OverPath(Angles, AnyDrive, Layouts, Sheet):
    """A drive over the crank angle, or over the piston's path."""

    def is_over_path(self) -> bool:
        """Whether a page over the piston's path is asked for, by its layout or by shares of the stroke alone.
        Raises ProblemError where the layout is given angles."""
        over = self.layout_subject in (OVER_PATH, FORCES_OVER_PATH)
        if not over:
            alone = self.layout is None and self.says(ANGLE) and bool(self.shares())
            return alone and not self.drive().quick
        if (chosen := self.drive()).quick:
            raise ProblemError(
                f"layout {self.layout} has one velocity for both strokes, and the return of {chosen.title} is"
                " quick; leave the layout out and give its places, --angle 's=0..100%:10%'"
            )
        angles = any(self.says(one) and self.values.typed(one) for one in (*ENDS, "zero"))
        if angles or not self.shares():
            raise ProblemError(
                f"layout {self.layout} is over the path; give shares of the stroke, --angle 's=0..100%:5%',"
                " or leave the angles out"
            )
        return True

    def over_path(
        self,
        chosen: Mechanism,
        described: DescribedDrive,
        page: Layout,
        method: str | None,
        drives: Sequence[Drive] = (),
    ) -> Question:
        """Return what is asked for of drives that were described, or of these, at shares of the stroke."""
        from kurbel.conditions.over import PathRequest

        if self.says("acceleration"):
            raise ProblemError(
                "--acceleration is at crank angles of a turn, and this page is over the path; leave it out"
            )
        drives = some(drives or chosen.drives(described, page.ratios))
        return PathRequest(
            mechanism=chosen.name,
            drives=chosen.solved(drives, method),
            shares=self.shares(),
            **self.on_page(page, "share,phi,c"),
        )


class MotionOptions(OverPath, Turning, Series, PinSizes, CommandOptions):
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5  # the motion
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min  # in m and m/s
    kurbel table --ratio '1:4;1:4,5' --step 15 -o table.tex  # for LaTeX
    kurbel table --mechanism arc --ratio 1:5 --rocker 6  # of a rocker
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --ratio 1:5 --angle 's=0..100%:5%'
    kurbel table --ratio 1:5 --angle psi=max
    kurbel table --ratio 1:5 --point 0.5
    \f
    >>> import kurbel
    >>> page = kurbel.table("1:5", angle=[0, 45, 90], columns=["phi", "x", "c"])
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,x,c
    0,0.0000,0.0000
    45,0.3431,0.8081
    90,1.1010,1.0000
    >>> page = kurbel.table("1:5", mechanism="arc", rocker=6, angle="0;90", columns="phi,path,rocker")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,path,rocker
    0,0.0001,9.587
    90,1.1049,-0.963
    >>> page = kurbel.table("1:5", angle="s=0;s=50%", columns="share,phi,c,c_return")
    >>> print(kurbel.typeset(page, "csv"), end="")
    share,phi,c,c_return
    0.0,0.0000,0.0000,0.0000
    0.5,84.2608,1.0153,1.0153
    """

    topic = "question"

    unnamed = "ratio"
    sequence = (
        "point angle from_ to step zero columns offset stroke time_ratio rod"
        " method order speed acceleration mechanism rocker pivot circuit beam crosshead_pin crank_pin shaft"
    )
    in_short = "ratio stroke rod speed machine mechanism offset method angle step columns digits"
    rivals: ClassVar[Rivals] = (("mechanism", "layout"), ("layout", "mechanism"))

    columns = columns_over_angle("kinematics", "phi,x,c,p", point="rod-points")
    layout = layout_option(*MOTIONS, OVER_PATH, POINTS, *APPROXIMATE)
    point: Option[Sequence[Exact]] = Option(
        "Points of the rod by their share from the crosshead pin to the crank pin: 0.5, beyond the ends -0.2;"
        " beside its axis 0.5,0.1 in rod lengths; with --rod 150mm; lists '0;0.5;1', ranges 0..1:0.25.",
        "POINTS", many=True, numbers=False,
    )  # fmt: skip

    def question(self) -> Question:
        chosen, described = self.described(self.layout)
        if self.says("point"):
            return self._points(chosen, described)
        if self.layout_subject == POINTS:
            raise ProblemError(
                f"layout {self.layout} is about points of the rod, and none was given; add --point, for"
                " example --point 0.5"
            )
        if self.is_over_path():
            page = self.page("over-path", OVER_PATH)
            return self.over_path(chosen, described, page, self.series())
        # A linkage has none of these pages: they are refused by themselves, and not offered for others.
        apart = chosen.crosshead or self.layout_subject in APPROXIMATE
        page = self.page(chosen.layout, chosen.subject, *(APPROXIMATE if apart else ()))
        if page.subject in APPROXIMATE:
            return self._approximations(chosen, described, page)
        question = chosen.question(
            with_pins(self, chosen, chosen.drives(described, page.ratios)),
            self.series(),
            angles=self.angles(page),
            zero=self.zero_angle,
            **self.on_page(page, chosen.examples["table"]),
        )
        return self.over_strokes(question)

    def _points(self, chosen: Mechanism, described: DescribedDrive) -> Question:
        """Return what is asked for of points of the rod at crank angles."""
        from kurbel.motion.points import points_of
        from kurbel.motion.points_page import SUBJECT, PointsRequest

        if self.says("order"):
            raise ProblemError("series of points of the rod are of first order; leave --order out")
        chosen.rod_ends()
        page = self.page(SUBJECT.layout, POINTS)
        drives = tuple(with_pins(self, chosen, chosen.drives(described, page.ratios)))
        return PointsRequest(
            mechanism=chosen,
            drives=drives,
            points=points_of(self.point, [chosen.crank(one) for one in drives]),
            method=self.method,
            angles=self.angles(page),
            zero=self.zero_angle,
            **self.on_page(page, "phi,path_along,path_across"),
        )

    def _approximations(self, chosen: Mechanism, described: DescribedDrive, page: Layout) -> Question:
        """Return what is asked for of the errors of series, or of Rötscher's steps."""
        if chosen.name != "straight":
            raise ProblemError(
                f"layout {page.key} is of the straight crank, and {chosen.title} was described; leave that"
                " out"
            )
        if self.says("method"):
            raise ProblemError(f"layout {page.key} compares formulas and takes no method; leave --method out")
        if self.says("acceleration"):
            raise ProblemError(f"layout {page.key} is of a crank that turns evenly; leave --acceleration out")
        cranks = chosen.drives(described, page.ratios)
        if page.subject == ERRORS:
            from kurbel.motion.series_errors import ORDERS, SeriesErrorsRequest

            self.check_whole(page)
            columns = self.on_page(page, "order,error_x,error_c,error_p")
            return SeriesErrorsRequest(drives=cranks, orders=self.order or ORDERS, **columns)
        if self.says("order"):
            raise ProblemError(
                f"layout {page.key} has steps and no series; leave --order out, or choose columns, gf_1 to"
                " gf_9"
            )
        from kurbel.motion.chord_page import ChordRequest

        return ChordRequest(
            drives=cranks, angles=self.angles(page), zero=self.zero_angle,
            **self.on_page(page, "phi,gf_1,gf_2,gf"),
        )  # fmt: skip


table = function(MotionOptions, "table")


def some(drives: Sequence[Drive]) -> Sequence[Drive]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives


class DeadCentresOptions(Linked, Speed, Layouts, Sheet, CommandOptions):
    """Print the dead centres of a crank drive, its stroke and the times of both strokes.

    With --stroke and --speed also the crank-pin velocity and the mean piston speed. Of a beam engine: angles
    μ and ν of the rod in the dead centres, their distance, the small paths.

    \b
    kurbel deadcentres --ratio 1:4 --offset 0.3  # of an offset crank
    kurbel deadcentres --mechanism beam --beam 3  # of a beam engine
    kurbel deadcentres --mechanism arc --ratio 1:5 --rocker 6  # of a rocker
    kurbel deadcentres --beam 3 --ratio 1:5 --exact
    kurbel deadcentres --ratio 1:4 --offset 0.5 --stroke 600mm --speed 120/min
    \f
    >>> import kurbel
    >>> page = kurbel.deadcentres(3, ratio="1:5", columns="mu,path_1")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mu,path_1
    0.7958,0.00010
    >>> page = kurbel.deadcentres(ratio="1:4", offset=0.5, columns="phi_i,phi_o,time_ratio")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi_i,phi_o,time_ratio
    5.739,189.594,1.0438
    """

    topic = "question"

    unnamed = "beam"
    sequence = "ratio exact mechanism offset rocker pivot circuit stroke time_ratio rod speed columns"
    in_short = "exact ratio stroke rod time_ratio speed machine mechanism offset rocker beam columns"

    beam: Option[Sequence[Fraction] | None] = measure(
        as_numbers, "Arm of the beam in crank radii: 3; lists '3;4', ranges 3..6:0.5.", "A:R", many=True,
        what="beam arm", topic="linkage",
    )  # fmt: skip
    ratio = Linked.ratio.but(help="Crank ratio: 1:5; lists and ranges 1:3..6.")
    exact = flag("From the true geometry of the linkage; default: the formulas of § 149.")
    speed = Speed.speed.but(help="Speed, for columns in m/s: 120/min, 12.5rad/s.")
    columns = columns_option("weisbach-149", "mu,nu,path_1", ".").but(
        kind=Columns("weisbach-149", "dead-centres")
    )
    layout = layout_option(BEAM, DRIVE)

    def question(self) -> Question:
        if self._of_beam():
            return self._beam()
        from kurbel.linkage.dead_centres import DeadCentresRequest, drives_of

        page = self.page("dead-centres", DRIVE)
        arm = self._arm() if "beam" in self.drive().takes else None
        drive = Linked(self.values.instead({"beam": arm}))
        chosen, described = drive.described(beside=("stroke", "speed"))
        return DeadCentresRequest(
            mechanism=chosen.name,
            drives=drives_of(chosen, described, page.ratios),
            **self.on_page(page, "phi_i,phi_o"),
        )

    def _of_beam(self) -> bool:
        """Whether dead centres are those of a beam engine, and not of a crank drive that is described."""
        if self.layout:
            return self.page("", BEAM, DRIVE).subject == BEAM
        if self.says("mechanism"):
            return False
        return self.says("beam", "exact") or not self.says(*_OF_DRIVES, *_LENGTHS)

    def _beam(self) -> Question:
        from kurbel.linkage.beam_engine import BeamRequest

        page = self.page("weisbach-149", BEAM)
        known = all(map(self.says, _LENGTHS))
        lengths = map(self.raw, _LENGTHS) if known else ()
        return BeamRequest(
            arms=as_numbers(page.arms, "beam arm") if self.beam is None else tuple(self.beam),
            ratios=tuple(one.ratio for one in DescribedDrive(self.ratio, *lengths).cranks(page.ratios)),
            exact=self.exact,
            **self.on_page(page, "mu,nu"),
        )

    def _arm(self) -> Fraction | None:
        """Return the arm of a beam engine that is described as a crank drive."""
        first, *others = self.beam or (None,)
        if others:
            raise ProblemError(
                f"--mechanism beam is one engine, and {1 + len(others)} arms were given; leave --mechanism"
                " out for the angles of § 149"
            )
        return first

    def unread(self, option: Option[object]) -> str:
        name = option.name
        if not self._of_beam():
            of_beam = name in ("beam", "exact")
            why = "is for the beam engine, and a crank drive was described; leave one of the two out"
            return f"--{name} {why}" if of_beam else super().unread(option)
        if name in _OF_DRIVES:
            return (
                f"--{name} does not belong to the beam engine; leave --beam and --exact out for a crank drive"
            )
        return (
            f"--{name} gives the ratio of the beam engine only where both are known, --stroke and --rod;"
            " add the other"
        )


deadcentres = function(DeadCentresOptions, "deadcentres")
