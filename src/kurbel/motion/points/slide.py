"""The rod of the straight or offset crank, by every method, for points on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kurbel.kernel import kinematics
from kurbel.kernel.coupler.point import Reach, Rod, first_order_reach, slide_reach, slide_rod

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.exact.kind import Kind


def rod(
    drive: Crank, method: str, circle: Any, kind: Kind, beside: bool
) -> tuple[Rod[Any], Reach[Any] | None]:
    """Return the ends of the rod at a crank angle, and its reach if points beside its axis are asked for."""
    ratio = kind.of(drive.ratio)
    if drive.offset:
        offset = kind.of(drive.offset)
        by = (kinematics.offset_path, kinematics.offset_velocity, kinematics.offset_acceleration)
        x, c, p = (one(circle, ratio, offset) for one in by)
        return slide_rod(circle, ratio, offset, (x, c, p)), (
            slide_reach(circle, ratio, offset) if beside else None
        )
    first_order = method == "series"
    formulas = _FIRST_ORDER if first_order else _EXACT
    x, c, p = (one(circle, ratio) for one in formulas)
    ends = slide_rod(circle, ratio, None, (x, c, p))
    if not beside:
        return ends, None
    return ends, first_order_reach(circle, ratio) if first_order else slide_reach(circle, ratio, None)


_EXACT = (kinematics.piston_path, kinematics.piston_velocity, kinematics.piston_acceleration)
_FIRST_ORDER = (
    kinematics.piston_path_first_order,
    kinematics.piston_velocity_first_order,
    kinematics.piston_acceleration_first_order,
)
