"""Forces of the arc crank and the parallel crank: virtual work and equilibrium of links closed by mpmath."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed, refusal
from links import CRANKS, DIGITS, FLOATS, Real, arc_crank, links, of_stroke, pointer, real, shown
from mpmath import mp
from numpy.testing import assert_allclose

from kurbel.drive.crank import Crank
from kurbel.drive.load import PistonForce
from kurbel.kernel import forces, linkage
from kurbel.kernel.circle import circle
from kurbel.kernel.parallel import coupler_place
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.linkage import certified, value
from kurbel.linkage.parallel import ParallelCrank, parallel_registry
from kurbel.motion.evaluation import OUT, RETURN

PLACES = [(OUT, "0"), (OUT, "73.1"), (OUT, "251"), (RETURN, "38.5"), (RETURN, "-77")]
PLACE = pytest.mark.parametrize(("stroke", "degrees"), PLACES)
EACH = pytest.mark.parametrize("crank", CRANKS, ids=shown)
DECIMALS = 12


def digits(key: str, crank: ArcCrank, stroke: int, degrees: str, decimals: int = DECIMALS) -> int:
    return certified(of_stroke(key, stroke), crank, Fraction(degrees), decimals)


def is_rounded(found: int, expected: Real) -> bool:
    return bool(abs(found - expected * mp.mpf(10) ** DECIMALS) <= mp.mpf("0.501"))


class Joint:
    """The joint of rod and rocker of closed links, and the forces there, F being 1 along its way."""

    def __init__(self, crank: ArcCrank, stroke: int, degrees: str) -> None:
        machine = links(crank)
        self.phi = mp.radians(real(Fraction(degrees))) + (0 if stroke == OUT else mp.pi)
        self.pin = pointer(self.phi)

        def end(phi: Real) -> Real:
            return machine.end(machine.angles(phi)[1])

        here = end(self.phi)
        # Of the two directions along the arc, the one away from the dead centre where the stroke begins.
        self.way = -1j * machine.right * stroke * (here - machine.pivot) / machine.rocker
        self.rod = (self.pin - here) / machine.rod
        self.slope = mp.diff(end, self.phi) / self.way
        self.across = -1j * self.way


@PLACE
@EACH
def test_the_torque_is_that_of_virtual_work(crank: ArcCrank, stroke: int, degrees: str) -> None:
    with mp.workdps(DIGITS):
        slope = Joint(crank, stroke, degrees).slope
        assert abs(slope.imag) < mp.mpf(10) ** -15
        for key in ("tangential_force", "torque"):
            assert is_rounded(digits(key, crank, stroke, degrees), slope.real)


@PLACE
@EACH
def test_the_forces_at_joint_and_pin_balance(crank: ArcCrank, stroke: int, degrees: str) -> None:
    """F, the rocker's force square to it and that of the rod are zero together; the rod turns the crank."""
    with mp.workdps(DIGITS):
        joint = Joint(crank, stroke, degrees)
        found = {
            key: mp.mpf(digits(key, crank, stroke, degrees, 30)) / mp.mpf(10) ** 30
            for key in ("rod_force", "guide_force", "tangential_force", "radial_force")
        }
        # A thrust on the outstroke, a pull on the return.
        pressed = stroke * found["rod_force"] * joint.rod
        assert abs(joint.way + found["guide_force"] * joint.across - pressed) < mp.mpf(10) ** -28
        on_pin = pressed / joint.pin
        assert abs(on_pin.imag - found["tangential_force"]) < mp.mpf(10) ** -28
        assert abs(-on_pin.real - found["radial_force"]) < mp.mpf(10) ** -28


@pytest.mark.parametrize(("rod", "offset"), [("5", "0"), ("3.2", "0.9")])
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("stroke", [OUT, RETURN])
def test_a_long_rocker_gives_the_forces_of_the_straight_and_the_offset_crank(
    rod: str, offset: str, side: int, stroke: int
) -> None:
    rocker = Fraction(10**9 - 10)
    crank = ArcCrank(Crank(1 / Fraction(rod)), rocker, None, Fraction(offset) + side * rocker)
    turn = circle(np.arange(0, 360, 3.7))
    ratio, e = stroke / float(Fraction(rod)), stroke * float(Fraction(offset))
    for key in ("rod_force", "guide_force", "tangential_force", "radial_force"):
        expected = getattr(forces, key)(turn, ratio, e)
        found = value(of_stroke(key, stroke), crank, turn, FLOATS)
        assert_allclose(found, expected, rtol=0, atol=2e-8, err_msg=key)


@pytest.mark.parametrize("degrees", ["0", "31.7", "90", "200", "301"])
def test_the_torque_of_the_parallel_crank_is_that_of_virtual_work(degrees: str) -> None:
    pushed = Crank(Fraction(0), radius=Fraction(3, 10), force=PistonForce(Fraction(10_000)))
    drive, phi = ParallelCrank(pushed), real(Fraction(degrees))
    with mp.workdps(DIGITS):
        slope = mp.diff(lambda angle: 1 - mp.cos(mp.radians(angle)), phi) * 180 / mp.pi
        along = mp.cos(mp.radians(phi))
        for key, expected in {
            "tangential_force": slope,
            "torque": slope,
            "radial_force": along,
            "tangential_force_n": 10_000 * slope,
            "torque_nm": 3000 * slope,
            "radial_force_n": 10_000 * along,
        }.items():
            found = certified(parallel_registry()[key], drive, Fraction(degrees), DECIMALS)
            assert is_rounded(found, expected), key


def test_forces_are_in_newtons_of_the_force_and_torques_of_the_radius() -> None:
    crank = CRANKS[2]
    loaded = replace(
        crank, crank=replace(crank.crank, radius=Fraction(3, 10), force=PistonForce(Fraction(70)))
    )
    for key, shares, factor in (("rod_force_n", "rod_force", 70), ("torque_nm", "torque", 21)):
        with mp.workdps(DIGITS):
            share = mp.mpf(digits(shares, crank, OUT, "73.1", 40)) / mp.mpf(10) ** 40
            found = certified(of_stroke(key, OUT), loaded, Fraction("73.1"), DECIMALS)
            assert is_rounded(found, factor * share), key


def test_a_tie_of_the_rod_force_is_told() -> None:
    # Where crank and rod are in line the rocker leans by asin 3/5 from the slide's perpendicular.
    central = arc_crank("5", "5/3", ("5", "4/3"))
    assert digits("rod_force", central, OUT, "0", 2) == 125
    assert digits("rod_force", central, OUT, "0", 1) == 13
    even = certified(of_stroke("rod_force", OUT), central, Fraction(0), 1, "half-even")
    assert even == 12
    assert abs(digits("guide_force", central, OUT, "0", 2)) == 75


@pytest.mark.parametrize("key", ["rod_force", "rocker_force", "tangential_force", "radial_force"])
def test_the_parallel_crank_has_the_forces_of_any_place(key: str) -> None:
    place = coupler_place(circle(33.0))
    straight = {
        "rod_force": 1.0,
        "rocker_force": 0.0,
        "tangential_force": place.sine,
        "radial_force": place.cosine,
    }
    assert getattr(linkage, key)(place) == straight[key]


ARC: tuple[Any, ...] = ("forces", "--mechanism", "arc", "--rocker", "6")


def test_pages_state_formulas_and_directions() -> None:
    page = " ".join(printed(*ARC, "--force", "10kN", "--stroke", "600mm", "--lang", "en").out.split())
    for said in (
        "S/F = 1/cos τ", "N/F = tan τ", "T/F = c/v = sin(ζ + τ)/cos τ", "Z/F = cos(ζ + τ)/cos τ",
        "M_d/(F R) = T/F", "F along the arc, in the direction of the stroke", "F = 10 kN", "R = 300 mm",
    ):  # fmt: skip
        assert said in page
    bare = printed("forces", "--mechanism", "parallel", "--lang", "en").out
    assert "T/F = sin φ, Z/F = cos φ" in " ".join(bare.split())


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (("--at", "tangent"), "--at does not belong to the arc crank; it is for --mechanism straight"),
        (("--columns", "torque_nm"), "column torque_nm is in N m and needs --force and --stroke"),
        (("--layout", "forces"), "layout forces is about something else; choose from arc, forces-arc"),
    ],
)
def test_what_is_not_computed_is_refused_in_one_sentence(more: tuple[str, ...], said: str) -> None:
    assert refusal(*ARC, *more) == said


def test_loads_that_act_on_other_drives_are_named() -> None:
    assert refusal("forces", "--mechanism", "parallel", "--eps", "4") == (
        "the parallel crank under steam is not computed; steam can act on the straight crank or the offset"
        " crank or the arc crank or the beam engine, and the parallel crank takes a constant force"
    )
