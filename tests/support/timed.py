"""kurbel's digits, which may not keep anyone waiting."""

from __future__ import annotations

from fractions import Fraction
from time import process_time

from textbook import Drive

from kurbel.drive.crank import Crank
from kurbel.drive.load import PistonForce
from kurbel.motion.evaluation import RETURN, certified
from kurbel.motion.quantities import registry
from kurbel.reading.units import Speed

ONE_SECOND = 1.0
WITHOUT_UNITS = [key for key, quantity in registry().items() if not quantity.needs]


def runs(keys: list[str]) -> list[tuple[int, list[str]]]:
    """Return last angles of pages with their columns: of both strokes to 180°, and through the whole turn."""
    return [(180, keys), (360, [key for key in keys if registry()[key].stroke != RETURN])]


def crank_of(drive: Drive) -> Crank:
    return Crank(
        drive.ratio, drive.offset, drive.radius, Speed(drive.speed, drive.turns), PistonForce(drive.force)
    )


def kurbel(
    key: str, method: str, drive: Drive, angle: Fraction, decimals: int, rounding: str = "half-away"
) -> int:
    """Return kurbel's digits, which must not take longer than a second."""
    before = process_time()
    scaled = certified(registry()[key], method, crank_of(drive), angle, decimals, rounding)
    took = process_time() - before
    assert took < ONE_SECOND, f"{key} for {drive} at {angle}° to {decimals} decimals took {took:.1f} s"
    return scaled
