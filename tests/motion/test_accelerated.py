"""Masses accelerated by a crank that is accelerated itself, against the bodies of kurbel.verify.

To first order they are the textbooks' two masses, of which kurbel.verify knows nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from courses import slide
from figures import rows

import kurbel
from kurbel import verify

FORCES = (
    "rod_force_n", "guide_force_n", "crank_pin_force_n", "tangential_force_n", "torque_nm", "bearing_along_n",
)  # fmt: skip
SIZES: dict[str, Any] = {"stroke": "300mm", "rod": "650mm", "speed": "23rad/s"}
ROD: dict[str, Any] = {"rod_mass": "60kg", "centre": "0.63", "gyration": "0.31"}
RATIO, RADIUS, OMEGA = Fraction(150, 650), 0.15, 23
ROD_KEYS = ("guide_force_n", "crank_pin_force_n", "torque_nm")


def drive(millimetres: int) -> verify.Drive:
    return verify.drive(RATIO, Fraction(millimetres, 150), radius=str(RADIUS), speed=OMEGA)


def bodies(millimetres: int, gain: int, **masses: int) -> verify.Bodies:
    rod: dict[str, Any] = {"rod_mass": 60, "centre": "0.63", "gyration": "0.31"}
    return verify.bodies(drive(millimetres), acceleration=gain, **rod, **masses)


@pytest.mark.parametrize(
    ("degrees", "gain", "offset"), [(63, 90, 0), (218, -240, 0), (305, 150, -50), (40, 0, 60)]
)
def test_forces_under_an_accelerated_crank_are_those_of_newton(degrees: int, gain: int, offset: int) -> None:
    page = kurbel.forces(
        **SIZES, **ROD, reciprocating="80kg", acceleration=f"{gain} rad/s²", offset=f"{offset}mm",
        rotating="-30kg", force="4kN", angle=degrees, columns=FORCES, digits=6,
    )  # fmt: skip
    true = bodies(offset, gain, reciprocating=80, rotating=-30, force=4000)
    for key, text in rows(page)[0].items():
        assert true.value(key, degrees).confirms(text) == verify.CONFIRMED, key


def test_the_rod_alone_is_accelerated_the_same() -> None:
    columns = ("inertia_guide_n", "inertia_pin_n", "inertia_torque_nm")
    page = kurbel.inertia(**SIZES, **ROD, acceleration="-75rad/s2", angle=127, digits=6, columns=columns)
    for key, text in zip(ROD_KEYS, rows(page)[0].values(), strict=True):
        assert bodies(0, -75).value(key, 127).confirms(text) == verify.CONFIRMED, key


def first_order(degrees: int, piston: float, rotating: float, push: float) -> Mapping[str, float]:
    """By two masses of the rod at its pins and the couple that they lack; n = L/R, as textbooks have it."""
    n, theta, centre, length = float(1 / RATIO), np.radians(degrees), 0.63, 0.65
    pin = RADIUS * np.exp(1j * theta)
    arm = RADIUS * slide(RATIO).motion(np.array(theta)).place - pin
    towards = RADIUS * OMEGA**2 * (np.cos(theta) + np.cos(2 * theta) / n)
    # The rod's angle above the slide, -ψ, has the acceleration ω² sin θ/n.
    couple = 60 * (0.31**2 - centre * (1 - centre)) * length**2 * OMEGA**2 * np.sin(theta) / n
    at_end = 60 * (1 - centre)
    along = push - piston * towards
    # The rod turns about the crank pin under its inertia and the crosshead's force on it, -(along, across).
    across = (arm.imag * along - np.imag(np.conj(arm) * -at_end * towards) - couple) / arm.real
    thrust = along + 1j * across
    on_pin = thrust - at_end * towards - 60 * centre * OMEGA**2 * pin
    torque = -np.imag(np.conj(pin) * on_pin)
    return {
        "rod_force_n": np.real(thrust * np.conj(arm)) / abs(arm),
        "guide_force_n": -across,
        "crank_pin_force_n": abs(on_pin),
        "tangential_force_n": torque / RADIUS,
        "torque_nm": torque,
        "bearing_along_n": np.real(on_pin - rotating * OMEGA**2 * pin),
    }


@pytest.mark.parametrize("degrees", [52, 143, 236])
def test_forces_to_first_order_are_those_of_textbooks(degrees: int) -> None:
    words: dict[str, Any] = {**SIZES, **ROD, "method": "series", "angle": degrees, "digits": 6}
    page = kurbel.forces(**words, reciprocating="80kg", rotating="-30kg", force="4kN", columns=FORCES)
    (found,) = rows(page)
    true = first_order(degrees, 80, -30, 4000)
    assert {key: float(one) for key, one in found.items()} == pytest.approx(true, rel=0, abs=6e-7)
    (found,) = rows(kurbel.inertia(**words, columns="inertia_guide_n,inertia_pin_n,inertia_torque_nm"))
    alone = first_order(degrees, 0, 0, 0)
    assert [float(one) for one in found.values()] == pytest.approx([alone[key] for key in ROD_KEYS], abs=6e-7)


def over_time(key: str, slope: str, degrees: int, millimetres: int, gain: int) -> Fraction:
    """Return x'' ω² + x' α of the slopes by the crank angle."""
    bend, first = (drive(millimetres).value(one, degrees).near() for one in (key, slope))
    return bend * OMEGA**2 + first * gain


def test_the_inertia_couple_is_that_of_the_rods_turning() -> None:
    page = kurbel.inertia(
        **SIZES, **ROD, acceleration="60rad/s2", offset="-25mm", angle=201, digits=6,
        columns="inertia_couple_nm,inertia_couple_two_mass_nm,inertia_correction_nm",
    )  # fmt: skip
    # The rod turns with the crank where ψ falls, and its inertia resists.
    spin = -float(over_time("rod_acceleration", "rod_velocity", 201, -25, 60)) * 60 * 0.65**2
    squares = 0.31**2, 0.63 * 0.37
    true = [squares[0] * spin, squares[1] * spin, (squares[0] - squares[1]) * spin]
    assert [float(one) for one in rows(page)[0].values()] == pytest.approx(true, rel=0, abs=6e-7)


@pytest.mark.parametrize("degrees", [77, 261])
def test_the_piston_and_the_rod_of_an_accelerated_crank_are_the_second_slopes_over_time(degrees: int) -> None:
    page = kurbel.table(
        **SIZES, acceleration="-310rad/s²", offset="35mm", angle=degrees, digits=7,
        columns="p_mps2,rod_acceleration_radps2",
    )  # fmt: skip
    piston = over_time("p", "c", degrees, 35, -310) * Fraction("0.15")
    rod = over_time("rod_acceleration", "rod_velocity", degrees, 35, -310)
    for text, true in zip(rows(page)[0].values(), (piston, rod), strict=True):
        assert abs(Fraction(text) - true) <= Fraction(1, 2 * 10**7)


def test_a_tie_of_an_accelerated_crank_is_told_where_one_part_vanishes() -> None:
    even: dict[str, Any] = {"speed": "3/s", "digits": 2, "rounding": "half-even"}
    # At the dead centre c = 0, and p = 1 + λ whatever the acceleration is, though ω has a factor π.
    page = kurbel.table("1:8", stroke="2m", acceleration="37rad/s²", angle=0, columns="p", **even)
    assert rows(page)[0] == {"p": "1.12"}
    # The infinite rod has p = 0 at 90°, where p in m/s² is α R alone.
    page = kurbel.table("1:∞", stroke="1/4 m", acceleration="9rad/s²", angle=90, columns="p_mps2", **even)
    assert rows(page)[0] == {"p_mps2": "1.12"}
