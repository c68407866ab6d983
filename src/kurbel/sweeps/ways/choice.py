"""Which way a sweep is computed: by its plan alone, so that its values are the same wherever it runs."""

from __future__ import annotations

from contextlib import suppress

from kurbel.engine.request import EngineRequest
from kurbel.errors import KurbelError
from kurbel.motion.page import Request
from kurbel.page.subject import Question
from kurbel.sweeps.columns import GIVEN
from kurbel.sweeps.plan import Plan
from kurbel.sweeps.ways.certified import CertifiedOverAngle, is_over_angle
from kurbel.sweeps.ways.irregularity import Irregularities, is_irregularity
from kurbel.sweeps.ways.motion import Motion, is_motion
from kurbel.sweeps.ways.over_angle import OverAngle, has_arrays
from kurbel.sweeps.ways.pointwise import Pointwise
from kurbel.sweeps.ways.records import DECIMALS, tried
from kurbel.sweeps.ways.way import Asked, Way


def way_of(asked: Asked) -> Way:
    """Return how the rows of a plan are computed."""
    plan, questions = asked.plan, _some(asked.plan)
    if any(column.role == GIVEN for column in asked.columns):
        # It stands in the records alone.
        return Pointwise(asked)
    if asked.each == 1 and is_motion(plan, questions[0]):
        assert isinstance(questions[0], Request)
        return Motion(asked, questions[0])
    if asked.each == 1 and all(is_irregularity(plan, one) for one in questions):
        assert isinstance(questions[0], EngineRequest)
        return Irregularities(asked, questions[0])
    alone = any(len(group) == 1 and group[0].option == "angle" for group in plan.groups)
    if asked.each == 1 and alone and all(has_arrays(plan, one) for one in questions):
        return OverAngle(asked)
    if asked.each == 1 and alone and all(map(is_over_angle, questions)):
        return CertifiedOverAngle(asked)
    return Pointwise(asked)


def _some(plan: Plan) -> list[Question]:
    """Return what is asked at some of the points that are not refused."""
    found = []
    for point in tried(plan):
        with suppress(KurbelError):
            found.append(plan.question(plan.at(point), DECIMALS).for_data)
    return found
