"""Engines of unlike cylinders, and of drives whose dead centres lie aslant, against sums over fine grids."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from kurbel.drive.crank import Crank
from kurbel.engine.assembly import Assembly
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.turn import Turn, turn_of
from kurbel.errors import ProblemError

Grid = NDArray[np.float64]


class Piston(NamedTuple):
    """A piston under steam by Mariotte's law, in metres and pascals; angles in degrees."""

    expansion: Fraction
    ratio: Fraction
    offset: Fraction = Fraction(0)
    double: bool = True
    start: Fraction = Fraction(0)
    radius: Fraction = Fraction(1)
    bore: Fraction = Fraction(1)
    pressure: Fraction = Fraction(1)

    @property
    def back(self) -> Fraction:
        return self.pressure / 5

    def engine(self) -> Engine:
        crank = Crank(self.ratio, self.offset, self.radius)
        steam = Steam(self.expansion, Fraction(1, 5))
        return Engine(crank, steam, self.double, load=Load(self.bore, self.pressure), lag=self.start)

    def torque(self, degrees: Grid) -> Grid:
        """Return the torque on the shaft in N m at shaft angles, by the law of virtual work."""
        angle = np.radians(degrees - float(self.start))
        length, side = 1 / float(self.ratio), float(self.offset)
        slant = (np.sin(angle) - side) / length
        place = np.cos(angle) + length * np.sqrt(1 - slant**2)
        far, near = (math.sqrt((length + sign) ** 2 - side**2) for sign in (1, -1))
        speed = np.sin(angle) + np.cos(angle) * slant / np.sqrt(1 - slant**2)
        share = np.where(speed >= 0, far - place, place - near) / (far - near)
        full = float(self.pressure)
        acting = np.minimum(full, full / np.maximum(share, 1e-9) / float(self.expansion)) - float(self.back)
        if not self.double:
            acting = np.where(speed >= 0, acting, 0)
        area = math.pi / 4 * float(self.bore) ** 2
        return acting * area * np.abs(speed) * float(self.radius)


def swing(pistons: list[Piston]) -> tuple[float, float]:
    """Return the mean torque in N m and the swing of energy over it, from 20,000 steps."""
    degrees = np.linspace(0, 360, 20_001)
    torque = sum((one.torque(degrees) for one in pistons), np.zeros_like(degrees))
    step = math.radians(degrees[1])
    work = np.concatenate([[0], np.cumsum((torque[1:] + torque[:-1]) / 2 * step)])
    mean = float(work[-1]) / math.tau
    return mean, float(np.ptp(work - mean * np.radians(degrees))) / mean


ratios = st.fractions(Fraction(1, 8), Fraction(1, 3), max_denominator=50)
expansions = st.fractions(Fraction(6, 5), Fraction(4), max_denominator=20)
offsets = st.fractions(Fraction(-3, 2), Fraction(3, 2), max_denominator=20)
pistons = st.tuples(expansions, ratios, offsets, st.booleans()).map(lambda given: Piston(*given))
starts = st.fractions(Fraction(0), Fraction(359), max_denominator=3)
sizes = st.fractions(Fraction(1, 3), Fraction(3), max_denominator=9)
others = st.builds(
    Piston, expansions, ratios, offsets, st.booleans(), start=starts, radius=sizes, bore=sizes, pressure=sizes
)


@settings(deadline=None, max_examples=25)
@given(pistons)
def test_an_offset_engine_turns_as_a_sum_over_fine_steps_says(piston: Piston) -> None:
    turn = Turn(piston.engine(), "exact")
    mean, irregularity = swing([piston])
    assert math.isclose(float(turn.mean_force() * turn.torque_unit()), mean, rel_tol=1e-6)
    assert math.isclose(float(turn.irregularity()), irregularity, rel_tol=1e-5)


@settings(deadline=None, max_examples=25)
@given(pistons, st.lists(others, min_size=1, max_size=3))
def test_unlike_cylinders_turn_their_shaft_together(first: Piston, more: list[Piston]) -> None:
    every = [first, *more]
    turn = turn_of(Assembly(tuple(one.engine() for one in every)), "exact")
    mean, irregularity = swing(every)
    assert math.isclose(float(turn.mean_force() * turn.torque_unit()), mean, rel_tol=1e-6)
    assert math.isclose(float(turn.irregularity()), irregularity, rel_tol=2e-5, abs_tol=1e-6)


@settings(deadline=None, max_examples=25)
@given(pistons, st.fractions(Fraction(-360), Fraction(720), max_denominator=10))
def test_the_energy_of_an_offset_engine_is_the_work_since_its_dead_centre(
    piston: Piston, degrees: Fraction
) -> None:
    turn = Turn(piston.engine(), "exact")
    length, side = 1 / float(piston.ratio), float(piston.offset)
    begin = math.degrees(math.asin(side / (length + 1)))
    angles = np.linspace(begin, float(degrees), 20_001)
    torque, step = piston.torque(angles), math.radians(angles[1] - angles[0])
    mean, _ = swing([piston])
    work = float((torque.sum() - (torque[0] + torque[-1]) / 2) * step) - mean * math.radians(
        angles[-1] - begin
    )
    unit = float(turn.torque_unit())
    assert math.isclose(float(turn.energy_at(degrees / 180)) * unit, work, abs_tol=1e-4 * unit)


def test_two_alike_cranks_are_an_assembly_of_two_engines() -> None:
    one, other = (Piston(Fraction(4), Fraction(1, 5), start=Fraction(start)).engine() for start in (0, 90))
    apart = turn_of(Assembly((one, other)), "exact").irregularity()
    cranks = (Fraction(0), Fraction(90))
    together = Turn(Engine(one.drive, one.steam, cranks=cranks, load=one.load), "exact").irregularity()
    assert abs(float(apart - together)) < 1e-12


def test_cylinders_without_sizes_cannot_be_compared() -> None:
    bare = Engine(Crank(Fraction(1, 5)), Steam(Fraction(4)))
    with pytest.raises(ProblemError, match="cylinder 1 needs its bore, its pressure and its stroke"):
        Assembly((bare, bare))
