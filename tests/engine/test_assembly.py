"""Engines of unlike cylinders on drives whose dead centres lie aslant, against sums over a fine grid."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from cli import records
from hypothesis import given, settings
from hypothesis import strategies as st
from machines import machine

DEGREES = np.linspace(0, 360, 40_001)


class Piston(NamedTuple):
    """A piston under steam by Mariotte's law, as it is typed: metres, bar, degrees."""

    eps: float
    rod: float
    offset: float
    single_acting: bool
    angle: int
    bore: float
    stroke: float
    pressure: float

    def entry(self) -> str:
        return (
            f"eps={self.eps} back=0.2 ratio=1:{self.rod} offset={self.offset} angle={self.angle}"
            f" single_acting={str(self.single_acting).lower()} bore={self.bore}m stroke={self.stroke}m"
            f" pressure={self.pressure}bar"
        )

    def torque(self) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        """Return the torque on the shaft in N m over the grid."""
        own = machine(
            eps=str(self.eps), back="0.2", ratio=f"1:{self.rod}", offset=str(self.offset),
            single_acting=self.single_acting,
        )  # fmt: skip
        unit = math.pi / 4 * self.bore**2 * self.pressure * 1e5 * self.stroke / 2
        return np.asarray(own.force(DEGREES - self.angle) * unit)


def tenths(low: int, high: int) -> st.SearchStrategy[float]:
    return st.integers(low, high).map(lambda number: number / 10)


PISTONS = st.builds(
    Piston, tenths(12, 40), tenths(30, 80), tenths(-15, 15), st.booleans(), st.integers(0, 359), tenths(2, 9),
    tenths(4, 20), tenths(20, 90),
)  # fmt: skip


@settings(deadline=None, max_examples=20)
@given(st.lists(PISTONS, min_size=1, max_size=4))
def test_unlike_cylinders_turn_their_shaft_together(pistons: list[Piston]) -> None:
    pistons[0] = pistons[0]._replace(angle=0)
    asked = [f"--cylinder={one.entry()}" for one in pistons]
    columns = ("--delta=1:50", "--speed=120/min", "--columns=mean_torque,swing", "--digits=6")
    (row,) = records("flywheel", *asked, *columns)
    torque = sum((one.torque() for one in pistons), np.zeros_like(DEGREES))
    step = math.radians(DEGREES[1])
    work = np.concatenate([[0], np.cumsum((torque[1:] + torque[:-1]) / 2 * step)])
    mean = float(work[-1]) / math.tau
    assert float(row["mean_torque"]) == pytest.approx(mean, rel=1e-6)
    assert float(row["swing"]) == pytest.approx(float(np.ptp(work - mean * np.radians(DEGREES))), rel=1e-5)
