"""What is drawn over the piston's path: its columns, and the drawing."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism

if TYPE_CHECKING:
    from kurbel.motion.drives import Drive
    from kurbel.motion.page import AngleQuestion
    from kurbel.plot.drawings import Drawing
    from kurbel.plot.style import Size


def names_over(chosen: Mechanism, crank: Crank, names: Sequence[str], named: bool) -> tuple[str, ...]:
    """Return the path, in mm where lengths are known, and what is drawn over it: the columns that were named,
    or those that a drive has by itself but for the path."""
    if not chosen.conditions():
        raise ProblemError(
            f"{chosen.title} has no piston with a stroke; leave --over path out, or --mechanism for a rod of"
            " infinite length, --ratio 1:∞"
        )
    path, in_mm = chosen.motion[0]
    if back := next((one for one in names if "_return" in one), ""):
        raise ProblemError(
            f"column {back} is of the return stroke, and over the path both strokes are one curve; write"
            f" {back.replace('_return', '')}"
        )
    own = path if crank.radius is None else in_mm
    drawn = [one for one in names if one != own and (named or one not in (path, in_mm))]
    if not drawn:
        raise ProblemError(
            "a path over itself is a straight line; name another column, such as --columns c,p"
        )
    return (own, *drawn)


def drawn_over(
    question: "AngleQuestion",
    drives: "Sequence[Drive]",
    beside: "AngleQuestion | None",
    mark: str,
    size: "Size",
) -> "Drawing":
    """Return the drawing of columns over the first of them, the path."""
    from kurbel.plot.drawings import curves_drawing
    from kurbel.plot.over.path import PathDrawing

    drawing = PathDrawing(question, drives, beside)
    drawn = curves_drawing(question, drawing.panels(), mark, drawing.around(), size)
    return drawn._replace(title=drawing.title)
