"""Speeds of rotation as they are given: turns or radians, both exact."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.reading.notation import about


@dataclass(frozen=True, slots=True)
class Speed:
    """Angular velocity ω = value (2π)^turns in 1/s: turns per second are exact, and so are radians."""

    value: Fraction
    turns: bool = True

    def __post_init__(self) -> None:
        if self.value <= 0:
            raise ProblemError(f"the speed is {about(self.value)}/s; it must be above 0")
