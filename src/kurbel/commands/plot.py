"""Drawings of what has no page: crank drives to scale, the paths of points of their rods, how they move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

from kurbel.commands.motion import some
from kurbel.commands.options import Option, alone, measure
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.drawing import DECIMAL, DrawingOptions, DrawingSize, FilmOptions
from kurbel.commands.parts.drive import AnyDrive
from kurbel.commands.parts.sheet import PlainPrinting, Sheet
from kurbel.commands.shown import Drawing, carrying, drawing_of, mark_of, paged, spoken, staged
from kurbel.commands.subject import function
from kurbel.drive.moved import Drive
from kurbel.errors import ProblemError
from kurbel.motion.evaluation import is_known
from kurbel.motion.mechanism import Mechanism
from kurbel.motion.point_quantities import points_registry
from kurbel.motion.points import RodPoint, points_of
from kurbel.motion.points_page import SUBJECT, PointsRequest
from kurbel.reading.given import Exact, as_angles, found_at

if TYPE_CHECKING:
    from kurbel.motion.motion_page import AngleQuestion

# Where the crank stands beside the path of a point, unless that is asked for.
POSITION = "60"
TURN = (Fraction(0), Fraction(360))
# What is read beside points that move, and what stands for it where its unit is known.
OF_POINTS = (("velocity", "velocity_mps"), ("acceleration", "acceleration_mps2"))
PAGES = (
    "kurbel plot draws mechanisms to scale; add --positions 30, --point 0.5 or --animate, or have the curves"
    " of a page drawn by what prints it: kurbel table --ratio 1:5 -o motion.svg"
)


class PlotOptions(AnyDrive, DrawingSize, FilmOptions, CommandOptions):
    """Draw a mechanism to scale, the paths of points of its rod, and how it moves.

    Curves of pages are a format of these: kurbel table --ratio 1:5 -o motion.svg, kurbel forces --eps 4 -o
    forces.svg. Drawings need the extra `plot`.

    \b
    kurbel plot --positions 30 --ratio 1:5 -o drive.svg  # to scale
    kurbel plot --point 0.5 --ratio 1:5 -o coupler.svg  # the path of a point
    kurbel plot --animate --ratio 1:4 -o turn.html  # what moves
    kurbel plot --positions '30;90;150' --mechanism arc --rocker 6 -o bogenschubkurbel.pdf
    \f
    Lengths are in mm, angles in degrees. Source of lines and arrowheads: ISO 128-2 and ISO 129-1.
    """

    topic = "question"

    unnamed = "positions"
    in_short = "positions point animate ratio stroke rod offset mechanism rocker machine seconds"

    positions = measure(
        alone(as_angles),
        "Draw the mechanism to scale at these crank angles: 30, or '30;90;150'.", "ANGLES", unit="degrees",
        many=True,
    )  # fmt: skip
    point: Option[Sequence[Exact]] = Option(
        "Draw the paths of points of the rod beside the mechanism: 0.5, 0.5,0.1, '0;0.5;1'.", "POINTS",
        many=True, numbers=False,
    )  # fmt: skip
    lang: Option[str] = PlainPrinting.lang.but(help="Language of the labels: de or en.")
    units = Sheet.units.but(
        help="Units of the numbers beside what moves: metric, imperial or a list, 'cm;kN'. Default: metric;"
        " of what is given in imperial units alone these."
    )
    decimal = DECIMAL.but()

    def question(self) -> Drawing:
        if not (self.says("positions", "point") or self.animate):
            raise ProblemError(PAGES)
        from kurbel.plot.drawings import drawing_layout

        chosen, described = self.described()
        drives = some(chosen.drives(described, drawing_layout(chosen.layout).ratios))
        if not self.says("positions", "point"):
            question = replace(_motion(chosen, drives, self.lang), units=self.units)
            return drawing_of(question, self.as_part(DrawingOptions), self.decimal)
        if len(drives) > 1:
            flag = "positions" if self.says("positions") else "point"
            raise ProblemError(
                f"--{flag} draws one crank drive, and {len(drives)} ratios were given; choose one"
            )
        angles = as_angles(POSITION) if self.positions is None else self.positions
        if self.says("stroke") != (self.says("rod") or self.compares_lengths()) and not self.animate:
            self.refuse("stroke", *(("rod",) if "ratio" in chosen.takes else ()))
        return self._mechanism(chosen, drives[0], angles)

    def _mechanism(self, chosen: Mechanism, drive: Drive, angles: Sequence[Fraction]) -> Drawing:
        """Return the mechanism to scale at crank angles, the first one strong."""
        from kurbel.plot.animated import mechanism_film
        from kurbel.plot.drawings import standing_drawing
        from kurbel.plot.stage import coupled

        lang, mark, turn = self.lang, mark_of(self.lang, self.decimal), self.turn
        points: tuple[RodPoint, ...] = ()
        if self.says("point"):
            chosen.rod_ends()
            points = points_of(self.point, [chosen.crank(drive)])
        paths = coupled(points, found_at(chosen.moving)(drive)) if points else ()
        standing, title = found_at(chosen.drawing)(drive, lang)
        drawn = standing_drawing(standing, title, angles, lang, mark, self.size, paths)
        if turn is None:
            return Drawing.of(drawn, lang, mark)
        beside = _of_points(chosen, drive, points, lang) if points else _motion(chosen, [drive], lang)
        question = replace(beside, units=self.units)
        show = partial(carrying, question, staged(chosen.name, drive))
        made = mechanism_film(show, angles, mark, turn, self.size)
        # A drive that was drawn has a scene.
        assert made is not None
        found = drawn._replace(figure=made[0], film=made[1])
        return Drawing.of(found, lang, mark, paged(found, lang, mark, spoken(question)))

    def unread(self, option: Option[object]) -> str:
        """Return the sentence that refuses what is read beside a drawing that moves."""
        if option.name == "units":
            return "--units are of the numbers beside what moves; leave it out"
        if option.name in ("stroke", "rod"):
            other = "rod" if option.name == "stroke" else "stroke"
            flag = flag_of(option.name)
            return (
                f"{flag} gives the ratio of a drawing to scale with --{other}; add that, or leave {flag} out"
            )
        return ""


plot_mechanism = function(PlotOptions, "plot_mechanism", drawn=True)


def _motion(chosen: Mechanism, drives: Sequence[Drive], lang: str) -> AngleQuestion:
    """Return what is read beside a mechanism: the motion of the driven end."""
    from kurbel.plot.curves import motion_keys
    from kurbel.plot.drawings import drawing_layout

    return chosen.question(
        drives, None, layout=drawing_layout(chosen.layout), angles=TURN, lang=lang,
        columns=motion_keys(chosen, chosen.crank(drives[0])),
    )  # fmt: skip


def _of_points(chosen: Mechanism, drive: Drive, points: tuple[RodPoint, ...], lang: str) -> AngleQuestion:
    """Return what is read beside points of the rod: how they move."""
    from kurbel.plot.drawings import drawing_layout

    known, crank = points_registry(), chosen.crank(drive)
    keys = tuple(unit if is_known(known[unit], crank) else share for share, unit in OF_POINTS)
    return PointsRequest(
        mechanism=chosen, drives=(drive,), points=points, layout=drawing_layout(SUBJECT.layout), angles=TURN,
        lang=lang, columns=keys,
    )  # fmt: skip
