"""Energy and torque of the arc crank's masses, and their slopes; tests/verify asks Newton for the torque."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp

from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.moving import Masses, joined, rod_masses
from kurbel.kernel.rocker import LoadedRocker
from kurbel.kernel.rod import LoadedCrank
from kurbel.linkage.arc import ArcCrank

# mpmath has no types.
Real = Any


def arc(rod: str, rocker: str, distance: str, height: str, circuit: int = 1) -> ArcCrank:
    pivot = Fraction(distance), Fraction(height)
    return ArcCrank(Crank(1 / Fraction(rod)), Fraction(rocker), *pivot, circuit)


# A rocker in place of a slide, a pivot below, a four-bar of either circuit.
CRANKS = [arc("5", "6", "5", "6"), arc("3.5", "9", "3.7", "-9.2")]
CRANKS += [arc("3", "2.5", "4", "0", circuit) for circuit in (1, -1)]
EACH = pytest.mark.parametrize("crank", CRANKS, ids=range(4))
STROKES = pytest.mark.parametrize("stroke", [1, -1])
RECIPROCATING, ROCKER, FORCE = mp.mpf("0.9"), mp.mpf("2.3"), mp.mpf("1.3")


def real(number: Fraction) -> Real:
    return mp.mpf(number.numerator) / number.denominator


NUMBERS = Kind(real)


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(50):
        yield


def on_circle(angle: Real) -> Circle[Real]:
    return Circle(mp.sin(angle), mp.cos(angle), 2 * mp.sin(angle / 2) ** 2)


def masses() -> Masses[Real]:
    return joined(rod_masses(mp.mpf("0.27"), mp.mpf("0.3")), mp.mpf("1.7"), RECIPROCATING)


def loaded(crank: ArcCrank, stroke: int, angle: Real, force: Real = FORCE) -> LoadedRocker:
    """The kernel's, at an angle that counts as those of the stroke do."""
    at = crank.at(stroke, on_circle(angle), NUMBERS, "exact")
    whole = masses()._replace(rocker=ROCKER)
    own = {"place": at.place, "arc": at.arc}
    return LoadedRocker(at.circle, at.arc.ratio, whole, None, force, RECIPROCATING, **own)


@STROKES
@EACH
def test_the_masses_take_the_torque_that_their_energy_gains(crank: ArcCrank, stroke: int) -> None:
    for angle in (mp.mpf("1.1"), mp.mpf("4.9")):
        gain = mp.diff(lambda at: loaded(crank, stroke, at).kinetic_energy(), angle)
        assert abs(loaded(crank, stroke, angle, 0 * FORCE).torque() + gain) < 1e-14


@STROKES
@EACH
def test_torque_slope_is_the_slope_of_the_torque(crank: ArcCrank, stroke: int) -> None:
    for angle in (mp.mpf("0.4"), mp.mpf("3.6")):
        found: Real = loaded(crank, stroke, angle).torque_slope()
        expected = mp.diff(lambda at: loaded(crank, stroke, at, 0 * FORCE).torque(), angle)
        assert abs(found - expected) < 1e-18 * (1 + abs(expected))


@pytest.mark.parametrize(("ratio", "offset"), [("0.28", "0.9"), ("-0.31", "-1.2")])
def test_energy_and_slope_of_the_offset_crank_are_those_of_its_torque(ratio: str, offset: str) -> None:
    def at(angle: Real, offset: str | None = offset) -> Any:
        return LoadedCrank(
            on_circle(angle), mp.mpf(ratio), masses(), None if offset is None else mp.mpf(offset)
        )

    for angle in (mp.mpf("0.7"), mp.mpf("3.9")):
        assert abs(mp.diff(lambda one: at(one).kinetic_energy(), angle) + at(angle).torque()) < 1e-18
        assert abs(at(angle).torque_slope() - mp.diff(lambda one: at(one).torque(), angle)) < 1e-18
        # The straight crank, without one, has formulas of its own.
        assert abs(at(angle, "0").torque_slope() - at(angle, None).torque_slope()) < 1e-45
