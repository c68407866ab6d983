"""The arc crank and the beam engine as they move."""

from __future__ import annotations

from collections.abc import Sequence

from kurbel.exact.kind import floats
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.steps import Joint, Line, Link, Point, Scene
from kurbel.plot.moving.arcs import arc_pivot, arc_position, swept
from kurbel.plot.moving.positions import LONGEST_ROD, polar_point
from kurbel.plot.moving.turn import LETTERS, SHAFT, TURN, around, crossed, fixed, joint


def rocker_scene(crank: RockerCrank, angles: Sequence[float] = TURN) -> Scene | None:
    """Return the drive, nothing for a rod or a rocker too long to be drawn beside its crank."""
    if crank.crank.ratio * LONGEST_ROD < 1 or crank.rocker > LONGEST_ROD:
        return None
    pivot, length = arc_pivot(crank), float(crank.rocker)
    inner = arc_position(crank, float(crank.dead_angle(OUT, floats())))
    outer = arc_position(crank, 180 + float(crank.dead_angle(RETURN, floats())))
    pin = joint(lambda angle: arc_position(crank, angle).pin, angles)
    head = joint(lambda angle: arc_position(crank, angle).head, angles)
    end = fixed(pivot) if crank.at_end else _beyond(head, pivot)
    path = tuple(polar_point(pivot, length, turn) for turn in swept(pivot, inner.head, outer.head))
    low, high = around([*path, *end, pivot, (-1.0, -1.0), (1.0, 1.0)], 0.25)
    return Scene(
        low=low,
        high=high,
        fixed=(
            *crossed(SHAFT),
            Line("centre", ((-1.25, 0), (high[0], 0))),
            Line("centre", path),
            Line("bearing", (SHAFT,)),
            Line(_bearing(crank, pivot), (pivot,)),
            *(Line("dead", (place,)) for dead in (inner, outer) for place in (dead.pin, dead.head)),
        ),
        links=(
            Link("crank", fixed(SHAFT), pin, LETTERS["crank"]),
            Link("rod", pin, head, LETTERS["rod"]),
            Link("rocker", head, end, crank.letter),
        ),
        pins=(pin, head) if crank.at_end else (pin, head, end),
    )


def _beyond(head: Joint, pivot: Point) -> Joint:
    """Return where the other arm of a beam ends."""
    return tuple((2 * pivot[0] - x, 2 * pivot[1] - y) for x, y in head)


def _bearing(crank: RockerCrank, pivot: Point) -> str:
    """Return where the ground of the pivot is: away from the rocker, or beside a beam."""
    if not crank.at_end:
        return "beside"
    return "hung" if pivot[1] >= 0 else "below"
