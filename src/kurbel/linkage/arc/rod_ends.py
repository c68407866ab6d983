"""The rod of a crank that moves a rocker, for points on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kurbel.kernel import linkage
from kurbel.kernel.coupler.point import Reach, Rod, rocker_reach, rocker_rod
from kurbel.linkage.arc.rocker import STROKE
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import entry

if TYPE_CHECKING:
    from kurbel.exact.kind import Kind
    from kurbel.linkage.arc.rocker import RockerCrank

# What asks for the way from the dead centre.
_WAY = entry("way", "", "", "", 0, {}, of=STROKE)


def rod(
    drive: RockerCrank, method: str, circle: Any, kind: Kind, beside: bool
) -> tuple[Rod[Any], Reach[Any] | None]:
    """Return the ends of the rod at a crank angle, and its reach if points beside its axis are asked for."""
    at = drive.at(_WAY, circle, kind)
    place, arc = at.place, at.arc
    height = drive.figures(OUT, kind)[2]
    ends = rocker_rod(circle, place, arc, height, linkage.slide_path(place, arc))
    return ends, rocker_reach(circle, place, arc) if beside else None
