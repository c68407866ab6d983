"""What options ask for of points of the rod."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kurbel.commands.drives.given import PATH
from kurbel.commands.old_motion import POINTS, angles_of, sheet_of
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Given, Names
from kurbel.drive.crank import Crank, Described
from kurbel.errors import ProblemError
from kurbel.motion.evaluation import is_known
from kurbel.motion.mechanism import Mechanism
from kurbel.motion.points.page import SUBJECT, PointsRequest
from kurbel.motion.points.point import Point, points_of
from kurbel.motion.points.quantities import points_registry
from kurbel.page.layouts import layout_of
from kurbel.reading.given import as_names

EXAMPLE = "phi,path_along,path_across"


# What is drawn and told of points unless columns are named, and what stands for it where its unit is known.
USUAL = (("velocity", "velocity_mps"), ("acceleration", "acceleration_mps2"))


def rod_points(chosen: Mechanism, drive: Any, point: Given) -> tuple[Point, ...]:
    """Return the points on the rod of a drive."""
    chosen.rod_ends()
    return points_of(point, [chosen.crank(drive)])


def usual_columns(crank: Crank) -> tuple[str, ...]:
    """Return what is drawn of points by itself."""
    known = points_registry()
    return tuple(unit if is_known(known[unit], crank) else share for share, unit in USUAL)


def points_question(
    chosen: Mechanism,
    said: Described,
    point: Given,
    layout: str | None,
    columns: Names,
    given: Mapping[str, Any],
) -> PointsRequest:
    """Return what is asked for of points of the rod at crank angles."""
    if given["over"] == PATH:
        raise ProblemError("points of the rod are tabulated over the crank angle; leave --over out")
    if is_given(given["order"]):
        raise ProblemError("series of points of the rod are of first order; leave --order out")
    chosen.rod_ends()
    page = layout_of(layout or SUBJECT.layout, (POINTS,), given["layouts"])
    drives = chosen.drives(said, page.ratios)
    return PointsRequest(
        mechanism=chosen,
        drives=drives,
        points=points_of(point, [chosen.crank(one) for one in drives]),
        method=given["method"],
        layout=page,
        angles=angles_of(page, given),
        columns=as_names(columns, EXAMPLE),
        **sheet_of(given),
    )
