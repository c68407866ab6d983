"""The parts of the rod's inertia: against bodies of point masses on which each part is imposed alone."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from bodies import (
    Body,
    Drive,
    Mass,
    Real,
    energy,
    few,
    fields,
    moment,
    of_body,
    point_on_circle,
    pulled,
    reactions,
    spread,
)
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp

from kurbel.kernel.inertia.mollier import moving_force
from kurbel.kernel.inertia.parts import PARTS, STRETCHING, TURNING, Parted, Vector, parted
from kurbel.kernel.rod import Masses


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(40):
        yield


times = st.floats(-7, 7, allow_subnormal=False).map(mp.mpf)


@st.composite
def drives(draw: st.DrawFn) -> Drive:
    ratio = mp.mpf(draw(st.floats(0.02, 0.7)))
    return Drive(ratio, draw(st.floats(-0.8, 0.8)) * (1 / ratio - 1))


@st.composite
def bodies(draw: st.DrawFn) -> Body:
    """A symmetric body of mass 1, its centre between the pins."""
    return spread(mp.mpf(draw(st.floats(0.05, 0.95))), mp.mpf(draw(st.floats(0.02, 0.3))))


def vector(pair: Vector[Real]) -> Real:
    return mp.matrix(list(pair))


def near(found: Real, true: Real, scale: Real = 1) -> bool:
    return bool(mp.norm(found - true) < 1e-13 * (scale + mp.norm(true)))


def rod_at(drive: Drive, time: Real, masses: Masses[Real]) -> Parted:
    return parted(point_on_circle(time), drive.ratio, masses, drive.offset)


@few
@given(drive=drives(), time=times, share=st.floats(-0.3, 1.3))
def test_parts_make_up_the_acceleration_of_every_point(drive: Drive, time: Real, share: float) -> None:
    rod = rod_at(drive, time, Masses(mp.mpf(0), mp.mpf(0)))
    true, whole = drive.acceleration(time, 1 - share), 1 + mp.norm(drive.acceleration(time, 0))
    assert near(-vector(rod.at_point(share)), true, whole)
    assert near(-sum((vector(rod.part_at(part, share)) for part in PARTS), mp.matrix([0, 0])), true, whole)
    assert near(-vector(rod.pin), drive.acceleration(time, 0))
    replaced = drive.acceleration(time, 0) - drive.acceleration(time, 1)
    assert near(-vector(rod.replaced()), replaced)
    assert abs(rod.replaced_size() - mp.norm(replaced)) < 1e-13 * whole
    assert abs(rod.pin.size() - 1) < 1e-30


@pytest.mark.parametrize("part", PARTS)
@few
@given(drive=drives(), time=times, body=bodies())
def test_forces_of_a_part_hold_the_body_under_it_alone(
    part: str, drive: Drive, time: Real, body: Body
) -> None:
    rod, ends, arm = rod_at(drive, time, of_body(body)), fields(drive, time)[part], drive.rod(time)
    force, about_b = pulled(body, drive, time, ends)
    in_a, in_b = vector(rod.in_pin(part)), vector(rod.in_crosshead(part))
    whole = 1 + mp.norm(ends[0])
    # Newton, moments about B, and both forces in the direction of the acceleration.
    assert near(in_a + in_b, force, whole)
    assert abs(moment(-arm, in_a) - about_b) < 1e-13 * whole * mp.norm(arm)
    assert abs(moment(ends[0], in_a)) + abs(moment(ends[0], in_b)) < 1e-12 * whole**2
    # The same where the guide alone holds B.
    pin, guide = vector(rod.at_pin(part)), rod.guide(part)
    assert near(pin + mp.matrix([0, guide]), force, whole)
    assert abs(moment(-arm, pin) - about_b) < 1e-13 * whole * mp.norm(arm)
    assert abs(rod.torque(part) + moment(drive.pin(time), pin)) < 1e-13 * whole


@few
@given(drive=drives(), time=times, body=bodies())
def test_forces_of_the_parts_add_up_to_those_of_the_drive(drive: Drive, time: Real, body: Body) -> None:
    rod, true, nothing = rod_at(drive, time, of_body(body)), reactions(drive, body, time), mp.matrix([0, 0])
    whole = 1 + mp.norm(drive.acceleration(time, 1))
    for forces in ([rod.at_pin()], [rod.at_pin(part) for part in PARTS]):
        assert near(sum(map(vector, forces), nothing), mp.matrix([true["along"], true["across"]]), whole)
    for guides in ([rod.guide()], [rod.guide(part) for part in PARTS]):
        assert abs(sum(guides) - true["guide"]) < 1e-13 * whole
    for torques in ([rod.torque()], [rod.torque(part) for part in PARTS]):
        assert abs(sum(torques) - true["torque"]) < 1e-13 * whole
    for end in (rod.in_pin, rod.in_crosshead):
        assert near(vector(end()), sum((vector(end(part)) for part in PARTS), nothing), whole)


@few
@given(drive=drives(), time=times, share=st.floats(0.05, 0.95))
def test_turning_part_is_that_of_two_masses_if_k_squared_is_a_b(
    drive: Drive, time: Real, share: float
) -> None:
    centre = mp.mpf(share)
    rod = rod_at(drive, time, of_body(spread(centre, centre * (1 - centre))))
    two = [Mass(mp.mpf(0), 1 - centre), Mass(mp.mpf(1), centre)]
    force, _ = pulled(two, drive, time, fields(drive, time)[TURNING])
    assert near(vector(rod.in_pin(TURNING)), force)
    assert near(vector(rod.in_crosshead(TURNING)), mp.matrix([0, 0]))
    assert vector(rod.in_crosshead(STRETCHING)) == mp.matrix([0, 0])


# Mollier's force.


@few
@given(drive=drives(), time=times, body=bodies(), straight=st.booleans())
def test_moving_force_is_what_the_energy_gains_over_the_path(
    drive: Drive, time: Real, body: Body, straight: bool
) -> None:
    drive, offset = (drive._replace(offset=mp.mpf(0)), None) if straight else (drive, drive.offset)
    velocity = -mp.diff(lambda at: drive.place(at, 1)[0], time)
    assume(abs(velocity) > 0.01)
    gain = mp.diff(lambda at: energy(drive, body, at), time)
    found = moving_force(point_on_circle(time), drive.ratio, of_body(body), offset)
    assert abs(found - gain / velocity) < 1e-12 * (1 + abs(found))
    # Under it the crank takes no torque, by Newton.
    assert abs(reactions(drive, body, time, found)["torque"]) < 1e-12 * (1 + abs(found))


@pytest.mark.parametrize("dead", [mp.mpf(0), mp.pi])
def test_moving_force_of_the_straight_crank_passes_the_dead_centres(dead: Real) -> None:
    drive, body = Drive(mp.mpf("0.23"), mp.mpf(0)), spread(mp.mpf("0.37"), mp.mpf("0.07"))
    beside = dead + mp.mpf("1e-9")
    energy_slope = mp.diff(lambda at: energy(drive, body, at), beside)
    limit = energy_slope / -mp.diff(lambda at: drive.place(at, 1)[0], beside)
    assert abs(moving_force(point_on_circle(dead), drive.ratio, of_body(body)) - limit) < 1e-8
