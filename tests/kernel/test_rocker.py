"""The arc crank with its masses: Newton's equations of point masses on links closed by mpmath, and limits."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import pytest
from bodies import Mass, Real, of_body
from links import CRANKS, DIGITS, arc_crank, real, shown
from mpmath import mp
from numpy.testing import assert_allclose
from rockers import Heavy

from kurbel.exact.kind import Kind
from kurbel.kernel import rocker, rod
from kurbel.kernel.circle import Circle, circle
from kurbel.kernel.rocker import LoadedRocker
from kurbel.kernel.rod import Loaded, Masses, joined
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.motion.evaluation import OUT, RETURN

EACH = pytest.mark.parametrize("crank", CRANKS, ids=shown)
STROKES = pytest.mark.parametrize("stroke", [OUT, RETURN])
# A rod of three points, one beyond its end and one beside its line; its mass, and those at the rocker.
BODY = [Mass(mp.mpf("-0.2"), mp.mpf("0.5")), Mass(mp.mpf("0.7"), mp.mpf("0.2"), mp.mpf("0.3"))]
BODY += [Mass(mp.mpf("0.7"), mp.mpf("0.2"), mp.mpf("-0.3")), Mass(mp.mpf("0.9"), mp.mpf("0.1"))]
ROD, RECIPROCATING, ROCKER, FORCE = mp.mpf("1.7"), mp.mpf("0.9"), mp.mpf("2.3"), mp.mpf("1.3")
NUMBERS = Kind(real)
HEAVY = Heavy(CRANKS[0], BODY, ROD, RECIPROCATING, ROCKER, mp.mpf(0), FORCE)
FORCES = (
    "guide_force", "rod_force", "crosshead_pin_force", "pin_force", "pin_force_along", "pin_force_across",
    "radial_force", "torque", "thrust",
)  # fmt: skip


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(DIGITS):
        yield


def on_circle(angle: Real) -> Circle[Real]:
    return Circle(mp.sin(angle), mp.cos(angle), 2 * mp.sin(angle / 2) ** 2)


def masses() -> Masses[Real]:
    return joined(of_body(BODY), ROD, RECIPROCATING)


def loaded(crank: ArcCrank, stroke: int, angle: Real, force: Real = FORCE) -> LoadedRocker:
    """The kernel's, at an angle that counts as those of the stroke do."""
    at = crank.at(stroke, on_circle(angle), NUMBERS)
    return LoadedRocker(at.circle, at.place, at.arc, masses()._replace(rocker=ROCKER), force, RECIPROCATING)


@STROKES
@EACH
def test_forces_obey_newton(crank: ArcCrank, stroke: int) -> None:
    for angle in (mp.mpf("0.3"), mp.mpf("2.2"), mp.mpf("4.9")):
        expected = HEAVY._replace(crank=crank).newton(stroke, angle)
        here = loaded(crank, stroke, angle)
        for name in FORCES:
            assert abs(getattr(here, name)() - expected[name]) < 1e-16 * (1 + abs(expected[name])), name


@STROKES
@EACH
def test_torque_is_the_work_of_the_force_less_the_gain_of_energy(crank: ArcCrank, stroke: int) -> None:
    angle = mp.mpf("1.1")
    phi = angle + (0 if stroke == OUT else mp.pi)
    drive = HEAVY._replace(crank=crank)
    here = loaded(crank, stroke, angle)
    path = abs(mp.diff(drive.joint, phi)) * mp.sign(here.place.velocity)
    assert abs(here.torque() - FORCE * path + mp.diff(drive.energy, phi)) < 1e-14
    # The mass at the crank pin has an energy that never changes.
    own = rocker.kinetic_energy(here.place, here.masses) + here.masses.pin / 2
    assert abs(own - drive.energy(phi)) < 1e-16


@STROKES
@EACH
def test_torque_slope_is_the_slope_of_the_torque(crank: ArcCrank, stroke: int) -> None:
    for angle in (mp.mpf("0.4"), mp.mpf("3.6")):
        here = loaded(crank, stroke, angle)
        found = rocker.torque_slope(here.place, here.arc, here.masses)
        expected = mp.diff(lambda at: loaded(crank, stroke, at, 0 * FORCE).torque(), angle)
        assert abs(found - expected) < 1e-18 * (1 + abs(expected))


@pytest.mark.parametrize(("ratio", "offset"), [("0.28", "0.9"), ("-0.31", "-1.2")])
def test_energy_and_slope_of_the_offset_crank_are_those_of_its_torque(ratio: str, offset: str) -> None:
    drive = mp.mpf(ratio), mp.mpf(offset)

    def torque(at: Real) -> Real:
        return Loaded(on_circle(at), drive[0], masses(), drive[1]).torque()

    for angle in (mp.mpf("0.7"), mp.mpf("3.9")):
        energy = mp.diff(lambda at: rod.kinetic_energy(on_circle(at), drive[0], masses(), drive[1]), angle)
        assert abs(energy + torque(angle)) < 1e-18
        slope = rod.torque_slope(on_circle(angle), drive[0], masses(), drive[1])
        assert abs(slope - mp.diff(torque, angle)) < 1e-18
        # Without an offset it is what the straight crank has formulas of its own for.
        level = rod.torque_slope(on_circle(angle), drive[0], masses(), mp.mpf(0))
        assert abs(level - rod.torque_slope(on_circle(angle), drive[0], masses())) < 1e-45


@pytest.mark.parametrize("offset", ["0", "0.9"])
@pytest.mark.parametrize("side", [1, -1])
@STROKES
def test_a_long_rocker_gives_the_forces_of_straight_and_offset_crank(
    offset: str, side: int, stroke: int
) -> None:
    length = Fraction(10**9 - 10)
    crank = arc_crank("3.2", str(length), ("3.2", str(Fraction(offset) + side * length)))
    turn, kind = circle(np.arange(0, 360, 3.7)), Kind(float)
    at = crank.at(stroke, turn, kind)
    weights = Masses(0.7, 1.9, -0.2)
    bent = LoadedRocker(at.circle, at.place, at.arc, weights, 1.3, 0.9)
    straight = Loaded(turn, stroke / 3.2, weights, stroke * float(offset), 1.3, 0.9)
    for name in FORCES:
        assert_allclose(getattr(bent, name)(), getattr(straight, name)(), rtol=0, atol=1e-7, err_msg=name)
