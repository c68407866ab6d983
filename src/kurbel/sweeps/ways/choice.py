"""Which way a sweep is computed: by its plan alone, so that its values are the same wherever it runs."""

from __future__ import annotations

from kurbel.errors import KurbelError
from kurbel.sweeps.ways.over_angle import OverAngle, has_arrays
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.records import DECIMALS, tried
from kurbel.sweeps.ways.way import Asked, Way


def way_of(asked: Asked) -> Way:
    """Return how the rows of a plan are computed."""
    plan = asked.plan
    alone = any(len(group) == 1 and group[0].option == "angle" for group in plan.groups)
    if asked.each == 1 and alone and _all_have_arrays(asked):
        return OverAngle(asked)
    return Pointwise(asked)


def _all_have_arrays(asked: Asked) -> bool:
    found = False
    for point in tried(asked.plan):
        try:
            question = asked.plan.question(asked.plan.at(point), DECIMALS).for_data
        except KurbelError:
            continue
        if not has_arrays(asked.plan, question):
            return False
        found = True
    return found
