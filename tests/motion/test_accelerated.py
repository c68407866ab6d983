"""Masses accelerated by a crank that is accelerated itself, or to first order, against Newton's equations.

The positions of crank pin, crosshead and rod are differentiated over time by mpmath, and the unknown forces
are the solution of the equations of crosshead and rod; nothing here knows kurbel's formulas.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import pytest
from mpmath import mp

import kurbel
from kurbel.drive.crank import Crank
from kurbel.errors import KurbelError
from kurbel.motion.evaluation import certified
from kurbel.motion.quantities import registry
from kurbel.reading.units import Speed

# mpmath has no types.
Real = Any
FORCES = "rod_force_n,guide_force_n,crank_pin_force_n,tangential_force_n,torque_nm,bearing_along_n"
SIZES: dict[str, Any] = {"stroke": "300mm", "rod": "650mm"}
MASSES: dict[str, Any] = {"reciprocating": "80kg", "rod_mass": "60kg", "centre": "0.63", "gyration": "0.31"}


class Slider(NamedTuple):
    """A slider crank in metres and seconds, in the frame of the outstroke, at the time 0."""

    degrees: int
    omega: Real
    gain: Real
    offset: Real

    def pin(self, time: Real) -> Real:
        angle = mp.radians(self.degrees) + self.omega * time + self.gain * time**2 / 2
        return mp.mpf("0.15") * mp.mpc(mp.cos(angle), mp.sin(angle))

    def crosshead(self, time: Real) -> Real:
        pin = self.pin(time)
        return mp.mpc(pin.real + mp.sqrt(mp.mpf("0.65") ** 2 - (self.offset - pin.imag) ** 2), self.offset)

    def turned(self, time: Real) -> Real:
        return mp.arg(self.crosshead(time) - self.pin(time))

    def second(self, course: Any) -> Real:
        return mp.mpc(*(mp.diff(lambda at, part=part: getattr(course(at), part), 0, 2) for part in PARTS))


PARTS = ("real", "imag")


def moment(arm: Real, force: Real) -> Real:
    return (mp.conj(arm) * force).imag


class Inertia(NamedTuple):
    """What accelerates the rod: the force, and its moment about the crank pin; what the crosshead has."""

    force: Real
    moment: Real
    crosshead: Real


def exact(slider: Slider, mass: Real, centre: Real, gyration: Real) -> Inertia:
    """Of the rod as a body; `centre` counts from the crosshead pin, both in rod lengths."""

    def place(time: Real) -> Real:
        pin, end = slider.pin(time), slider.crosshead(time)
        return end + centre * (pin - end)

    pull = mass * slider.second(place)
    spin = mass * (gyration * mp.mpf("0.65")) ** 2 * mp.diff(slider.turned, 0, 2)
    arm = place(0) - slider.pin(0)
    return Inertia(pull, moment(arm, pull) + spin, slider.second(slider.crosshead))


def first_order(slider: Slider, mass: Real, centre: Real, gyration: Real) -> Inertia:
    """By two masses at the pins and the couple that they lack; n = L/R, as textbooks have it."""
    n, theta, omega = mp.mpf(650) / 150, mp.radians(slider.degrees), slider.omega
    end = -mp.mpf("0.15") * omega**2 * (mp.cos(theta) + mp.cos(2 * theta) / n)
    # The rod's angle above the slide, -ψ, has the acceleration ω² sin θ/n.
    couple = mass * (gyration**2 - centre * (1 - centre)) * mp.mpf("0.65") ** 2 * omega**2 * mp.sin(theta) / n
    at_pin, at_end = mass * centre, mass * (1 - centre)
    arm = slider.crosshead(0) - slider.pin(0)
    force = at_pin * slider.second(slider.pin) + at_end * end
    return Inertia(force, moment(arm, mp.mpc(at_end * end)) + couple, mp.mpc(end))


def newton(
    slider: Slider, of_rod: Inertia, reciprocating: Real, rotating: Real, push: Real
) -> dict[str, float]:
    """Return the forces of the drive: push acts on the piston towards the shaft."""
    pin, end = slider.pin(0), slider.crosshead(0)
    arm = end - pin
    # Force (b, c) of the rod on the crosshead: along the slide from the piston, across from the rod's moment.
    b = reciprocating * of_rod.crosshead.real + push
    # -(b, c) at the end and the rod's inertia about the crank pin: arm × -(b, c) = moment.
    c = (arm.imag * b - of_rod.moment) / arm.real
    on_rod = of_rod.force + mp.mpc(b, c)
    bearing = on_rod + rotating * slider.second(slider.pin)
    unit = arm / abs(arm)
    torque = -moment(pin, on_rod)
    found = {
        "rod_force_n": (mp.mpc(b, c) * mp.conj(unit)).real,
        "guide_force_n": -c,
        "crank_pin_force_n": abs(on_rod),
        "tangential_force_n": torque / mp.mpf("0.15"),
        "torque_nm": torque,
        "bearing_along_n": bearing.real,
    }
    return {key: float(value) for key, value in found.items()}


def printed(page: kurbel.Table) -> dict[str, float]:
    keys, row = kurbel.typeset(page, "csv").splitlines()
    return {key: float(one) for key, one in zip(keys.split(","), row.split(","), strict=True)}


@pytest.mark.parametrize(
    ("degrees", "gain", "offset"), [(63, "90", "0"), (218, "-240", "0"), (305, "150", "-50"), (40, "0", "60")]
)
def test_forces_under_an_accelerated_crank_are_those_of_newton(degrees: int, gain: str, offset: str) -> None:
    page = kurbel.forces_table(
        **SIZES, **MASSES, speed="23rad/s", acceleration=f"{gain} rad/s²", offset=f"{offset}mm",
        rotating="-30kg", force="4kN", angle=degrees, columns=FORCES, digits=6,
    )  # fmt: skip
    slider = Slider(degrees, mp.mpf(23), mp.mpf(gain), mp.mpf(offset) / 1000)
    of_rod = exact(slider, mp.mpf(60), mp.mpf("0.63"), mp.mpf("0.31"))
    true = newton(slider, of_rod, mp.mpf(80), mp.mpf(-30), mp.mpf(4000))
    assert printed(page) == pytest.approx(true, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize("degrees", [52, 143, 236])
def test_forces_to_first_order_are_those_of_textbooks(degrees: int) -> None:
    page = kurbel.forces_table(
        **SIZES, **MASSES, speed="23rad/s", method="series", rotating="-30kg", force="4kN", angle=degrees,
        columns=FORCES, digits=6,
    )  # fmt: skip
    slider = Slider(degrees, mp.mpf(23), mp.mpf(0), mp.mpf(0))
    of_rod = first_order(slider, mp.mpf(60), mp.mpf("0.63"), mp.mpf("0.31"))
    true = newton(slider, of_rod, mp.mpf(80), mp.mpf(-30), mp.mpf(4000))
    assert printed(page) == pytest.approx(true, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize(("method", "gain"), [("exact", "-75"), ("series", "0")])
def test_the_rod_alone_is_accelerated_the_same(method: str, gain: str) -> None:
    rod = {key: MASSES[key] for key in ("rod_mass", "centre", "gyration")}
    page = kurbel.inertia_table(
        **SIZES, **rod, speed="23rad/s", acceleration=f"{gain}rad/s2", method=method, angle=127, digits=6,
        columns="inertia_guide_n,inertia_pin_n,inertia_torque_nm",
    )  # fmt: skip
    slider = Slider(127, mp.mpf(23), mp.mpf(gain), mp.mpf(0))
    model = exact if method == "exact" else first_order
    of_rod = model(slider, mp.mpf(60), mp.mpf("0.63"), mp.mpf("0.31"))
    true = newton(slider, of_rod, mp.mpf(0), mp.mpf(0), mp.mpf(0))
    keys = ("guide_force_n", "crank_pin_force_n", "torque_nm")
    assert [*printed(page).values()] == pytest.approx([true[key] for key in keys], rel=1e-9, abs=1e-6)


def test_the_inertia_couple_is_that_of_the_rods_turning() -> None:
    rod = {key: MASSES[key] for key in ("rod_mass", "centre", "gyration")}
    page = kurbel.inertia_table(
        **SIZES, **rod, speed="23rad/s", acceleration="60rad/s2", offset="-25mm", angle=201, digits=6,
        columns="inertia_couple_nm,inertia_couple_two_mass_nm,inertia_correction_nm",
    )  # fmt: skip
    slider = Slider(201, mp.mpf(23), mp.mpf(60), mp.mpf("-0.025"))
    # The rod turns with the crank where ψ falls, and its inertia resists.
    spin = float(mp.diff(slider.turned, 0, 2)) * 60 * 0.65**2
    squares = 0.31**2, 0.63 * 0.37
    true = [squares[0] * spin, squares[1] * spin, (squares[0] - squares[1]) * spin]
    assert [*printed(page).values()] == pytest.approx(true, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize("degrees", [77, 261])
def test_the_piston_and_the_rod_of_an_accelerated_crank_are_the_second_slopes_over_time(degrees: int) -> None:
    page = kurbel.table(
        **SIZES, speed="23rad/s", acceleration="-310rad/s²", offset="35mm", angle=degrees, digits=7,
        columns="p_mps2,rod_acceleration_radps2",
    )  # fmt: skip
    slider = Slider(degrees, mp.mpf(23), mp.mpf(-310), mp.mpf("0.035"))
    true = -slider.second(slider.crosshead).real, -mp.diff(slider.turned, 0, 2)
    assert [*printed(page).values()] == pytest.approx([float(one) for one in true], rel=1e-9, abs=1e-7)


def test_a_tie_of_an_accelerated_crank_is_told_where_one_part_vanishes() -> None:
    # At the dead centre c = 0, and p = 1 + λ whatever the acceleration is, though ω has a factor π.
    turning = Crank(Fraction(1, 8), radius=Fraction(1), speed=Speed(Fraction(3)), acceleration=Fraction(37))
    assert certified(registry()["p"], "exact", turning, Fraction(0), 2, "half-even") == 112
    # The infinite rod has p = 0 at 90°, where p in m/s² is α R alone.
    endless = Crank(Fraction(0), radius=Fraction(1, 8), speed=Speed(Fraction(3)), acceleration=Fraction(9))
    assert certified(registry()["p_mps2"], "exact", endless, Fraction(90), 2, "half-even") == 112


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"acceleration": "5rad/s²"}, "--acceleration is that of the crank at the speed it has; add that,"),
        (
            {"acceleration": "5 1/s", "speed": "1/s", "stroke": "1m"},
            'acceleration "5 1/s" cannot be read; write an angular acceleration such as 50rad/s²',
        ),
        (
            {"acceleration": 5, "mechanism": "arc", "rocker": 6},
            "--acceleration does not belong to the arc crank; it is for --mechanism straight or offset",
        ),
    ],
)
def test_what_does_not_fit_an_acceleration_is_answered(asked: dict[str, Any], said: str) -> None:
    with pytest.raises(KurbelError) as caught:
        kurbel.table("1:4", **asked)
    assert str(caught.value).startswith(said)
