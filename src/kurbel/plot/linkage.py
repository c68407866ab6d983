"""What drawings show of the motion of the arc crank and of the parallel crank."""

from __future__ import annotations

from kurbel.exact.kind import floats
from kurbel.kernel.circle import circle
from kurbel.linkage.evaluation import Linkage, value
from kurbel.linkage.page import LinkageRequest
from kurbel.page.quantity import Quantity
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
    quantities = [column.quantity for column in request.page_columns]
    traces = (_trace(one, drive, request) for one in quantities for drive in request.drives)
    return panels_of(traces, request.lang, apart=len(request.drives) > 1)


def _trace(quantity: Quantity, drive: Linkage, request: LinkageRequest) -> Trace:
    lang, angles, unit = request.lang, degrees(request.angles), quantity.plain_unit(request.lang)
    heading = quantity.heading[lang].removesuffix(f" in {unit}")
    assert quantity.part is not None
    return Trace(
        quantity.name[lang],
        heading,
        unit,
        unit if heading == quantity.symbol else "",
        (ratio_label(drive.crank.ratio), quantity.part[lang]) if request.cranks else (),
        angles,
        _values(quantity, drive, angles),
    )


def _values(quantity: Quantity, drive: Linkage, angles: list[float]) -> list[float]:
    import numpy as np

    found = value(quantity, drive, circle(np.asarray(angles)), floats())
    return [float(one) for one in found]
