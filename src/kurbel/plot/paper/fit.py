"""The largest scale at which what is drawn to scale fits a page."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil
from typing import TYPE_CHECKING

from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.plot.style import Size

# Lower left and upper right in units of a drawing's own, by how many of them a millimetre is.
Corners = Callable[[float], tuple[tuple[float, float], tuple[float, float]]]
# In mm for a unit: below the least nothing can be told apart.
LEAST, MOST = 4.0, 1000.0
STEPS = 60


def fitted(
    corners: Corners, usual: float, size: Size
) -> tuple[tuple[float, float], tuple[float, float], float]:
    """Return corners that fill a page, and a millimetre in the drawing's units.

    The drawing is in the middle of the page. So many mm for a unit are usual; a page of another width or
    height has as many as fit it. Raises ProblemError for a page that is too small.
    """
    if not size.exact and size.height is None:
        return (*corners(1 / usual), 1 / usual)
    least = _extent(corners, LEAST)
    if not _fits(least, size):
        height = "" if size.height is None else f" and {size.height:.6g} mm high"
        raise ProblemError(
            f"the drawing is {size.width:.6g} mm wide{height}; to scale this one needs {ceil(least[0])} mm"
            f" and {ceil(least[1])} mm"
        )
    low, high = LEAST, MOST if size.exact else usual
    for _ in range(STEPS):
        middle = (low + high) / 2
        low, high = (middle, high) if _fits(_extent(corners, middle), size) else (low, middle)
    (left, bottom), (right, top) = corners(1 / low)
    across, up = _extent(corners, low)
    spare = (size.width - across if size.exact else 0.0, size.height - up if size.height else 0.0)
    along, above = (one / 2 / low for one in spare)
    return (left - along, bottom - above), (right + along, top + above), 1 / low


def _extent(corners: Corners, scale: float) -> tuple[float, float]:
    """Return width and height in mm at so many mm for a unit."""
    (left, bottom), (right, top) = corners(1 / scale)
    return (right - left) * scale, (top - bottom) * scale


def _fits(extent: tuple[float, float], size: Size) -> bool:
    return extent[0] <= size.width and (size.height is None or extent[1] <= size.height)
