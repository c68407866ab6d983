"""A gas engine of four strokes from the textbook: its pressures over the strokes and over the crank angle."""

from __future__ import annotations

from random import Random
from typing import Any, NamedTuple

import numpy as np


class Gas(NamedTuple):
    """A four-stroke cylinder: volumes compressed, exponent, pressures in bar; rod ratio and offset."""

    compression: float
    exponent: float
    peak: float
    exhaust: float
    suction: float
    ratio: float
    offset: float = 0.0

    def pressure(self, stroke: int, share: Any) -> Any:
        """The pressure at a share of the stroke in the direction of travel."""
        clearance = 1 / (self.compression - 1)
        if stroke == 0:
            return self.peak * (clearance / (clearance + share)) ** self.exponent
        if stroke == 3:
            whole = 1 + clearance
            return self.suction * (whole / (whole - share)) ** self.exponent
        return (self.exhaust if stroke == 1 else self.suction) + 0 * share

    def place(self, degrees: Any) -> Any:
        """Where the crosshead stands, in R from the shaft, and its slope over the angle."""
        angle = np.radians(degrees)
        lower = np.sin(angle) - self.offset
        slant = np.sqrt(1 - (self.ratio * lower) ** 2)
        return np.cos(angle) + slant / self.ratio, np.sin(angle) + self.ratio * lower * np.cos(angle) / slant

    @property
    def dead_centres(self) -> list[float]:
        rod = 1 / self.ratio
        inner = float(np.degrees(np.arcsin(self.offset / (rod + 1))))
        outer = 180 + float(np.degrees(np.arcsin(self.offset / (rod - 1))))
        return [inner, outer, 360 + inner, 360 + outer, 720 + inner]

    def over_angle(self, degrees: Any) -> Any:
        """The pressure in bar and the slope of the path at angles within a cycle that begins with the first
        dead centre."""
        centres = self.dead_centres
        stroke = np.clip(np.searchsorted(centres, degrees, side="right") - 1, 0, 3)
        (far, near), (at, slope) = self.place(np.array(centres[:2]))[0], self.place(degrees)
        share = (far - at) / (far - near)
        share = np.clip(np.where(stroke % 2, 1 - share, share), 0, 1)
        return np.choose(stroke, [self.pressure(one, share) for one in range(4)]), slope


def drawn(seed: int, offset: float = 0.0) -> Gas:
    random = Random(seed)
    compression, exponent = random.uniform(4, 12), random.uniform(1.1, 1.4)
    return Gas(
        compression, exponent, random.uniform(1.5, 3) * compression**exponent, random.uniform(1.02, 1.2),
        random.uniform(0.8, 0.98), 1 / random.randint(3, 6), offset,
    )  # fmt: skip
