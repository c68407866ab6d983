"""The motion of points of the rod over the crank angle, drawn."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from kurbel.commands.drawn.film import curves_of
from kurbel.commands.drives.given import PATH
from kurbel.commands.old_motion import described, some
from kurbel.commands.parameters import Given, Names
from kurbel.commands.plots import curve_angles, page_of
from kurbel.commands.points.asked import EXAMPLE, usual_columns
from kurbel.commands.shown import Drawing
from kurbel.errors import ProblemError
from kurbel.motion.points.page import SUBJECT, PointsRequest
from kurbel.motion.points.point import points_of
from kurbel.reading.given import as_names


def points_drawn(point: Given, columns: Names, infinite: bool, given: Mapping[str, Any]) -> Drawing:
    """Draw columns of points of the rod over the crank angle."""
    from kurbel.plot.chart.model import Around
    from kurbel.plot.curves import motion_panels

    if given["over"] == PATH:
        raise ProblemError("points of the rod are drawn over the crank angle; leave --over out")
    if given["force"] is not None:
        raise ProblemError("--force says nothing about points of the rod; leave it out")
    chosen, said = described(given)
    chosen.rod_ends()
    drives = tuple(some(chosen.drives(said, page_of(SUBJECT.layout).ratios)))
    cranks = [chosen.crank(one) for one in drives]
    question = PointsRequest(
        mechanism=chosen,
        drives=drives,
        points=points_of(point, cranks),
        method=given["method"],
        layout=page_of(SUBJECT.layout),
        angles=curve_angles(given),
        lang=given["lang"],
        units=given["units"],
        columns=as_names(columns, EXAMPLE) or usual_columns(cranks[0]),
    )
    dotted = replace(question, method="infinite") if infinite else None
    panels = motion_panels(question, dotted)
    lone = question.told[0] if len(question.told) == 1 and dotted is None else ()
    return curves_of(question, panels, Around(", ".join(lone)), given)
