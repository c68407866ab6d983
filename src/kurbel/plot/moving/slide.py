"""The straight and the offset crank as they move."""

from __future__ import annotations

import math
from collections.abc import Sequence

from kurbel.drive.crank import Crank
from kurbel.kernel.kinematics import dead_centre_sine
from kurbel.page.steps import Line, Link, Scene
from kurbel.plot.moving.positions import LONGEST_ROD, position
from kurbel.plot.moving.turn import LETTERS, SHAFT, TURN, crossed, fixed, joint

# Half the length of the crosshead, half the height of its way and the place of dimensions below it, in R.
HEAD, GUIDE, LEVEL = 0.17, 0.15, 0.5


def slide_scene(crank: Crank, angles: Sequence[float] = TURN) -> Scene | None:
    """Return the crank drive, nothing for a rod too long to be drawn beside its crank."""
    if crank.ratio * LONGEST_ROD < 1:
        return None
    ratio, offset = float(crank.ratio), float(crank.offset)
    inner = position(ratio, offset, math.degrees(math.asin(dead_centre_sine(ratio, offset))))
    outer = position(ratio, offset, 180 + math.degrees(math.asin(dead_centre_sine(-ratio, -offset))))
    pin = joint(lambda angle: position(ratio, offset, angle).pin, angles)
    head = joint(lambda angle: position(ratio, offset, angle).head, angles)
    (first, last), low, high = (outer.head[0], inner.head[0]), offset - GUIDE, offset + GUIDE
    start, end = first - 2 * HEAD, last + 2 * HEAD
    level = min(offset, -1.0) - LEVEL if offset < 0 else offset - GUIDE - LEVEL
    return Scene(
        low=(-1.25, min(-1.25, level - 0.2)),
        high=(end + 0.1, max(1.25, high + 0.2)),
        fixed=(
            *crossed(SHAFT),
            Line("centre", ((-1.25, 0), (1.25 if offset else end + 0.1, 0))),
            *([Line("centre", ((-1.25, offset), (end + 0.1, offset)))] if offset else ()),
            Line("left", ((start, high), (end, high))),
            Line("right", ((start, low), (end, low))),
            Line("bearing", (SHAFT,)),
            *(Line("dead", (place,)) for dead in (inner, outer) for place in (dead.pin, dead.head)),
        ),
        links=(Link("crank", fixed(SHAFT), pin, LETTERS["crank"]), Link("rod", pin, head, LETTERS["rod"])),
        pins=(pin, head),
        heads=(head,),
        path=(last, level),
    )
