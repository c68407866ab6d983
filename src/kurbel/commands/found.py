"""Crank angles by what holds there: --angle 's=10%', where the piston has gone a tenth of its stroke."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.commands.part import Values
from kurbel.commands.parts.effort import PRESSING
from kurbel.commands.solve import OF_MOTION, SolveOptions
from kurbel.conditions.solve_page import SolveRequest
from kurbel.errors import ProblemError
from kurbel.exact.kind import Found
from kurbel.exact.place import Place
from kurbel.motion.evaluation import RETURN
from kurbel.reading.where import ACCELERATIONS

HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
# What is asked for beside the angles, and where a condition is on the motion also what acts there.
APART = ("unknown", "angle", "columns", "layout", "units", "digits")
ACTING = ("force", "eps", *PRESSING)


@dataclass(frozen=True)
class Held:
    """A place at which a condition holds, by its number among all of what was asked for."""

    asked: object
    number: int

    def __call__(self) -> Place:
        return places_of(self.asked)[self.number][0]


def angles_of(text: str, values: Values, ratios: Sequence[str], cycle: Fraction) -> tuple[Fraction, ...]:
    """Return the crank angles of the cycle at which a condition holds, in their order.

    A drive that no option gives is one of these `ratios`. Raises KurbelError.
    """
    of_motion = text.partition("=")[0].strip() in OF_MOTION
    own: dict[str, object] = {"where": (text,), **dict.fromkeys(APART)}
    method = values.values.get("method")
    if isinstance(method, Sequence) and not isinstance(method, str):
        own["method"] = method[0] if method else None
    if not values.says("ratio", "rod"):
        own["ratio"] = tuple(ratios)
    if of_motion:
        own |= dict.fromkeys((*ACTING, "acceleration"))
        # Without a unit such as m/s the speed says nothing here.
        own["speed"] = values.values.get("speed") if "/s" in text else None
    asked: Any = SolveOptions(values.instead(own, own=True)).question()
    if len(asked.drives) != 1:
        raise ProblemError(
            f"--angle {text} is at other angles for each crank ratio, and {len(asked.drives)} were given;"
            " give one, or kurbel sweep with the ratios"
        )
    if values.says("acceleration") and asked.conditions[0].quantity in ACCELERATIONS:
        raise ProblemError(
            f"--angle {text} is that of a crank that turns evenly; leave --acceleration out, or give the"
            " angle in degrees"
        )
    found = [_turned(asked, number, *one) for number, one in enumerate(places_of(asked))]
    turns = int(cycle // FULL_TURN) if of_motion else 1
    return tuple(one + FULL_TURN * turn for turn in range(max(turns, 1)) for one in sorted(found))


def places_of(asked: Any) -> list[tuple[Place, Fraction]]:
    """Return all places that a question of conditions has, and by how many degrees each is to be turned."""
    if isinstance(asked, SolveRequest):
        roots = [root for found in asked.found.values() for root in found]
        return [(one.place, HALF_TURN if one.stroke == RETURN else Fraction(0)) for one in roots]
    roots = asked.roots({"expansion": 0, "ratio": 0, "condition": 0})
    return [(one.place, Fraction(0)) for one in roots]


def _turned(asked: object, number: int, place: Place, turned: Fraction) -> Fraction:
    degrees = place.degrees
    found = Found(Held(asked, number), HALF_TURN) if degrees is None else degrees
    return found + turned
