"""What drawings show of the motion of the arc crank and of the parallel crank."""

from __future__ import annotations

from kurbel.kernel.circle import circle
from kurbel.kernel.linkage import coupler
from kurbel.linkage.arc import ArcCrank, floats, value
from kurbel.linkage.page import LinkageRequest
from kurbel.linkage.quantities import LinkageQuantity
from kurbel.plot.curves import ratio_label
from kurbel.plot.panels import Trace, check_drawn, degrees, panels_of
from kurbel.plot.plotting import Panel

# What is drawn of the arc crank unless columns are named.
ARC_MOTION = ("path", "velocity", "acceleration")


def linkage_panels(request: LinkageRequest) -> list[Panel]:
    """Return a panel for each quantity, with all ratios in it; of one drive, a panel for each unit.

    Raises ProblemError for one angle, or more than can be drawn.
    """
    check_drawn(request.angles, len(request.drives))
    traces = (_trace(one, drive, request) for one in request.quantities for drive in request.drives)
    return panels_of(traces, request.lang, apart=len(request.drives) > 1)


def _trace(quantity: LinkageQuantity, drive: ArcCrank | None, request: LinkageRequest) -> Trace:
    lang, angles = request.lang, degrees(request.angles)
    heading = quantity.heading.removesuffix(f" in {quantity.unit}")
    return Trace(
        quantity.name[lang],
        heading,
        quantity.unit,
        quantity.unit if heading == quantity.symbol else "",
        (ratio_label(drive.crank.ratio), quantity.part[lang]) if drive else (),
        angles,
        _values(quantity, drive, angles),
    )


def _values(quantity: LinkageQuantity, drive: ArcCrank | None, angles: list[float]) -> list[float]:
    import numpy as np

    places = circle(np.asarray(angles))
    if drive is None:
        found = getattr(coupler(places), quantity.motion)
    else:
        found = value(quantity.motion, drive, quantity.stroke, places, floats())
    return [float(one) for one in found]
