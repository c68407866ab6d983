"""The table of the motion of the piston, over the crank angle or over its path, or of points of the rod."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from kurbel.commands.options import Option
from kurbel.commands.part import CommandOptions, Rivals
from kurbel.commands.parts.angles import FORCES_OVER_PATH, OVER_PATH, PATH, Over
from kurbel.commands.parts.drive import APPROXIMATE, POINTS, AnyDrive, Series, Turning
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_over_angle, layout_option
from kurbel.commands.subject import function
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MOTIONS
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question

ERRORS = "series errors"


class OverPath(Over, AnyDrive, Layouts, Sheet):
    """A drive over the crank angle, or over the piston's path."""

    def is_over_path(self) -> bool:
        """Whether a page over the piston's path is asked for, by --over or by its layout. Raises ProblemError
        where the two contradict each other."""
        name, path = self.layout, self.over == PATH
        over = self.layout_subject in (OVER_PATH, FORCES_OVER_PATH)
        if name and path and not over:
            raise ProblemError(
                f"layout {name} is not over the path; leave --over out, or --layout, for a page of its own"
            )
        return over or path

    def over_path(
        self,
        chosen: Mechanism,
        described: Described,
        page: Layout,
        method: str | None,
        drives: Sequence[Any] = (),
    ) -> Question:
        """Return what is asked for of drives that were described, or of these, at shares of the stroke."""
        from kurbel.conditions.over.page import PathRequest

        if self.says("acceleration"):
            raise ProblemError("--acceleration is at crank angles of a turn; leave it out, or --over path")
        drives = some(drives or chosen.drives(described, page.ratios))
        return PathRequest(
            layout=page,
            mechanism=chosen.name,
            drives=chosen.solved(drives, method),
            shares=self.path_shares(),
            columns=self.names("share,phi,c"),
            **self.printed(),
        )


class MotionOptions(OverPath, Turning, Series, CommandOptions):
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5
    kurbel table --ratio '1:4;1:4,5' --step 15 --to 180 -f latex -o anhang.tex
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min
    kurbel table --mechanism arc --ratio 1:5 --rocker 6
    kurbel table --ratio 1:5 --over path --step 5%
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
    >>> page = kurbel.table("1:5", over="path", shares="0;50%", columns="share,phi,c,c_return")
    >>> print(kurbel.typeset(page, "csv"), end="")
    share,phi,c,c_return
    0.0,0.0000,0.0000,0.0000
    0.5,84.2608,1.0153,1.0153
    """

    unnamed = "ratio"
    sequence = (
        "point angle from_ to step zero over shares columns offset stroke crank true_stroke time_ratio rod"
        " method order speed acceleration mechanism rocker pivot circuit beam"
    )
    rivals: ClassVar[Rivals] = (("mechanism", "layout"), ("layout", "mechanism"))

    columns = columns_over_angle("kinematics", "phi,x,c,p")
    layout = layout_option(*MOTIONS, OVER_PATH, POINTS, *APPROXIMATE)
    point: Option[Any] = Option(
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
            chosen.drives(described, page.ratios),
            self.series(),
            layout=page,
            angles=self.angles(page),
            columns=self.names(chosen.examples["table"]),
            zero=self.zero_angle,
            **self.printed(),
        )
        return self.over_strokes(question)

    def _points(self, chosen: Mechanism, described: Described) -> Question:
        """Return what is asked for of points of the rod at crank angles."""
        from kurbel.motion.points.page import SUBJECT, PointsRequest
        from kurbel.motion.points.point import points_of

        if self.over == PATH:
            raise ProblemError("points of the rod are tabulated over the crank angle; leave --over out")
        if self.says("order"):
            raise ProblemError("series of points of the rod are of first order; leave --order out")
        chosen.rod_ends()
        page = self.page(SUBJECT.layout, POINTS)
        drives = chosen.drives(described, page.ratios)
        return PointsRequest(
            mechanism=chosen,
            drives=drives,
            points=points_of(self.point, [chosen.crank(one) for one in drives]),
            method=self.method,
            layout=page,
            angles=self.angles(page),
            columns=self.names("phi,path_along,path_across"),
            zero=self.zero_angle,
            **self.printed(),
        )

    def _approximations(self, chosen: Mechanism, described: Described, page: Layout) -> Question:
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
            from kurbel.motion.series.errors_page import ORDERS, SeriesErrorsRequest

            self.check_whole(page)
            names = self.names("order,error_x,error_c,error_p")
            return SeriesErrorsRequest(
                layout=page, drives=cranks, orders=self.order or ORDERS, columns=names, **self.printed()
            )
        if self.says("order"):
            raise ProblemError(
                f"layout {page.key} has steps and no series; leave --order out, or choose columns, gf_1 to"
                " gf_9"
            )
        from kurbel.motion.series.chord_page import ChordRequest

        names = self.names("phi,gf_1,gf_2,gf")
        return ChordRequest(
            layout=page, drives=cranks, angles=self.angles(page), columns=names, zero=self.zero_angle,
            **self.printed(),
        )  # fmt: skip


table = function(MotionOptions, "table")


def some(drives: Sequence[Any]) -> Sequence[Any]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives
