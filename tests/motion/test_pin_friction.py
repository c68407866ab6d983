"""The friction of the pins against the lines that touch two circles, and against the balance of power."""

from __future__ import annotations

import cmath
from itertools import product
from math import asin, cos, pi, radians, sqrt
from typing import Any

import numpy as np
import pytest
from machines import Slide

import kurbel
from kurbel import verify

RADIUS, LENGTH, FRICTION = 0.24, 0.9, 0.09
PINS: dict[str, float] = {"crosshead_pin": 0.08, "crank_pin": 0.13, "shaft": 0.15}
LIMITS = [one / 2 * FRICTION / sqrt(1 + FRICTION**2) for one in PINS.values()]
ASKED: dict[str, Any] = {
    "stroke": "crank:240mm", "rod": "900mm", "pin_friction": FRICTION, "digits": 5,
    **{name: f"{1000 * one:.0f}mm" for name, one in PINS.items()},
}  # fmt: skip


def printed(**asked: Any) -> list[float]:
    page = kurbel.forces(**ASKED, **asked)
    return [float(one) for one in kurbel.typeset(page, "csv").split()[-1].split(",")]


def touching(degrees: float, force: float, offset: float, sides: tuple[int, ...]) -> tuple[float, float]:
    """Return the torque about the shaft and the force in the rod, of a line of thrust that passes both pins
    at these sides of their circles: `sides` are -1 with the pin's centre on its left, seen to the crank."""
    angle = radians(degrees)
    pin = RADIUS * cmath.exp(1j * angle)
    head = RADIUS * Slide(LENGTH / RADIUS, offset / RADIUS).motion(np.array(angle)).place
    away = [sides[0] * LIMITS[0], sides[1] * LIMITS[1]]
    # The line leans by the angle whose sine is the difference of its distances from both centres over L.
    along = (pin - head) / LENGTH * cmath.exp(1j * asin((away[1] - away[0]) / LENGTH))
    thrust = -force / along.real
    passes = head + away[0] * 1j * along
    return thrust * (passes.conjugate() * along).imag, thrust


@pytest.mark.parametrize(
    ("degrees", "force", "offset"),
    [(25, 9000.0, 0.0), (130, -9000.0, 0.0), (215, 9000.0, 0.07), (285, -9000.0, 0.07), (340, 9000.0, 0.07)],
)
def test_the_torque_is_the_least_that_lines_of_thrust_leave(
    degrees: int, force: float, offset: float
) -> None:
    bore: dict[str, Any] = {"bore": "300mm", "pressure_difference": f"{force / (pi / 4 * 0.09):.9f}Pa"}
    (torque,) = printed(**bore, angle=degrees, columns="net_torque_nm", offset=f"{1000 * offset:.0f}mm")
    lines = [touching(degrees, force, offset, sides) for sides in product((1, -1), repeat=2)]
    assert torque == pytest.approx(
        min(moment - abs(thrust) * LIMITS[2] for moment, thrust in lines), abs=1e-4
    )


def test_what_the_pins_take_is_the_power_that_is_lost() -> None:
    """Also where masses push: P c = M ω + |S| (k_B |ψ̇| + k_A (ω + ψ̇) + k_O ω), with the force in the rod."""
    masses: dict[str, Any] = {"reciprocating": "120kg", "speed": "25rad/s", "force": 5000, "angle": 50}
    thrust, torque, net = printed(**masses, columns="crosshead_load_n,torque_nm,net_torque_nm")
    drive = verify.drive("24:90")
    slant, swing = (float(drive.value(key, 50)) for key in ("psi", "rod_velocity"))
    # S by the angle at which the line of thrust leans.
    lean = asin((LIMITS[0] + LIMITS[1]) / LENGTH)
    force = abs(thrust) / cos(radians(slant) - (lean if thrust > 0 else -lean))
    lost = force * (LIMITS[0] * swing + LIMITS[1] * (1 + swing) + LIMITS[2])
    assert torque - net == pytest.approx(lost, abs=1e-4)


def test_the_return_stroke_loses_as_the_other_half_of_the_turn() -> None:
    pressed = {"bore": "300mm", "pressure_difference": "2bar"}
    (there,) = printed(**pressed, angle=250, columns="net_torque_nm")
    (back,) = printed(**pressed, angle=70, columns="net_torque_return_nm")
    assert there == back != 0
