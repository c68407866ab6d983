"""The parts of the inertia of a rod that moves a rocker: against point masses on links closed by mpmath."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from bodies import Body, Mass, Real, of_body
from links import CRANKS, DIGITS, links, pointer, real, shown
from mpmath import mp
from rockers import Heavy

from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.inertia.parts import PARTS, Parted, Vector, parted_rocker
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.motion.evaluation import OUT

EACH = pytest.mark.parametrize("crank", CRANKS[1::3], ids=shown)
NOTHING = mp.mpf(0)
ANGLES = (0.3, 4.9)


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(DIGITS):
        yield


def body() -> Body:
    """A rod of three points, one beyond its end and a pair beside its line."""
    pair = [Mass(mp.mpf("0.7"), mp.mpf("0.2"), side * mp.mpf("0.3")) for side in (1, -1)]
    return [Mass(mp.mpf("-0.2"), mp.mpf("0.5")), *pair, Mass(mp.mpf("0.9"), mp.mpf("0.1"))]


def heavy(crank: ArcCrank) -> Heavy:
    return Heavy(crank, body(), mp.mpf(1), NOTHING, NOTHING, NOTHING, NOTHING)


def rod_at(crank: ArcCrank, angle: Real) -> Parted:
    circle = Circle(mp.sin(angle), mp.cos(angle), 2 * mp.sin(angle / 2) ** 2)
    at = crank.at(OUT, circle, Kind(real))
    return parted_rocker(at.circle, at.place, at.arc, of_body(body()))


def number(vector: Vector[Real]) -> Real:
    return mp.mpc(vector.along, vector.across)


def fields(drive: Heavy, angle: Real) -> dict[str, Callable[[Real], Real]]:
    """The acceleration in each part of the point that lies so from B, as complex numbers."""
    of_a, of_b = (drive.acceleration(angle, Mass(mp.mpf(share), mp.mpf(0))) for share in (0, 1))
    turned = (of_a - of_b) / (pointer(angle) - drive.joint(angle))
    return {
        "common": lambda place: of_b,
        "turning": lambda place: 1j * turned.imag * place,
        "stretching": lambda place: turned.real * place,
    }


@EACH
def test_forces_of_a_part_hold_the_rod_under_it_alone(crank: ArcCrank) -> None:
    drive, machine = heavy(crank), links(crank)
    for angle in map(mp.mpf, ANGLES):
        rod, joint, pin = rod_at(crank, angle), drive.joint(angle), pointer(angle)
        line = (joint - machine.pivot) / machine.rocker
        for part, field in fields(drive, angle).items():
            assert abs(number(rod.part_at(part, 1)) + field(pin - joint)) < 1e-30
            places = [(one.mass, drive.point(angle, one) - joint) for one in drive.body]
            force = mp.fsum(mass * field(place) for mass, place in places)
            about_b = mp.fsum(mass * (mp.conj(place) * field(place)).imag for mass, place in places)
            in_a, in_b = number(rod.in_pin(part)), number(rod.in_crosshead(part))
            assert abs(in_a + in_b - force) < 1e-28
            assert abs((mp.conj(pin - joint) * in_a).imag - about_b) < 1e-28
            # The rocker alone holds B, in its own line.
            on_pin = number(rod.at_pin(part))
            assert abs((mp.conj(pin - joint) * on_pin).imag - about_b) < 1e-28
            assert abs((mp.conj(line) * (force - on_pin)).imag) < 1e-28
            assert abs(abs(rod.guide(part)) - abs(force - on_pin)) < 1e-28
            assert abs(rod.torque(part) + (mp.conj(pin) * on_pin).imag) < 1e-28


@EACH
def test_the_parts_add_up_to_the_forces_of_newton(crank: ArcCrank) -> None:
    for angle in map(mp.mpf, ANGLES):
        rod, true = rod_at(crank, angle), heavy(crank).newton(OUT, angle)
        for force, name in ((rod.guide, "guide_force"), (rod.torque, "torque")):
            assert abs(force() - true[name]) < 1e-16 * (1 + abs(true[name])), name
            assert abs(sum(force(part) for part in PARTS) - force()) < 1e-30, name
        on_pin = mp.mpc(true["pin_force_along"], true["pin_force_across"])
        assert abs(number(rod.at_pin()) - on_pin) < 1e-16 * (1 + abs(on_pin))
        for forces in (rod.at_pin, rod.in_pin, rod.in_crosshead):
            assert abs(number(forces()) - sum(number(forces(part)) for part in PARTS)) < 1e-30
