"""The friction of the pins against the lines that touch two circles, and against the balance of power."""

from __future__ import annotations

import re
from itertools import product
from math import atan2, cos, hypot, pi, radians, sin, sqrt
from typing import Any

import pytest

import kurbel
from kurbel.errors import KurbelError

RADIUS, LENGTH, FRICTION = 0.24, 0.9, 0.09
PINS: dict[str, float] = {"crosshead_pin": 0.08, "crank_pin": 0.13, "shaft": 0.15}
LIMITS = [one / 2 * FRICTION / sqrt(1 + FRICTION**2) for one in PINS.values()]
ASKED: dict[str, Any] = {
    "crank": "240mm", "rod": "900mm", "pin_friction": FRICTION, "digits": 5,
    **{name: f"{1000 * one:.0f}mm" for name, one in PINS.items()},
}  # fmt: skip


def printed(**asked: Any) -> list[float]:
    page = kurbel.forces_table(**ASKED, **asked)
    return [float(one) for one in kurbel.typeset(page, "csv").split()[-1].split(",")]


def touching(degrees: float, force: float, offset: float, sides: tuple[int, ...]) -> tuple[float, float]:
    """Return the torque about the shaft and the force in the rod, of a line of thrust that passes both pins
    at these sides of their circles: `sides` are -1 with the pin's centre on its left, seen to the crank."""
    angle = radians(degrees)
    pin = RADIUS * cos(angle), RADIUS * sin(angle)
    head = pin[0] + sqrt(LENGTH**2 - (offset - pin[1]) ** 2), offset
    away = [sides[0] * LIMITS[0], sides[1] * LIMITS[1]]
    line = pin[0] - head[0], pin[1] - head[1]
    # The line leans by the angle whose sine is the difference of its distances from both centres over L.
    leaning = atan2(line[1], line[0]) + atan2(away[1] - away[0], sqrt(LENGTH**2 - (away[1] - away[0]) ** 2))
    along = cos(leaning), sin(leaning)
    thrust = -force / along[0]
    passes = head[0] - away[0] * along[1], head[1] + away[0] * along[0]
    return thrust * (passes[0] * along[1] - passes[1] * along[0]), thrust


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
    slant = RADIUS / LENGTH * sin(radians(50))
    swing = RADIUS / LENGTH * cos(radians(50)) / sqrt(1 - slant**2)
    # S by the angle at which the line of thrust leans.
    lean = (LIMITS[0] + LIMITS[1]) / LENGTH
    upright = sqrt(1 - slant**2) * sqrt(1 - lean**2) + slant * lean * (1 if thrust > 0 else -1)
    force = abs(thrust) / upright
    lost = force * (LIMITS[0] * swing + LIMITS[1] * (1 + swing) + LIMITS[2])
    assert torque - net == pytest.approx(lost, abs=1e-4)


def test_the_return_stroke_loses_as_the_other_half_of_the_turn() -> None:
    pressed = {"bore": "300mm", "pressure_difference": "2bar"}
    (there,) = printed(**pressed, angle=250, columns="net_torque_nm")
    (back,) = printed(**pressed, angle=70, columns="net_torque_return_nm")
    assert there == back
    assert hypot(there) > 0


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"pin_friction": 0.1}, "--pin-friction needs the diameter of a pin; add one of --crosshead-pin"),
        ({"crank_pin": "8cm"}, "--crank-pin is for the friction of the pins; add --pin-friction"),
        ({"pin_friction": 2, "crank_pin": "8cm"}, "friction of the pins is 2; it must lie within 0..1"),
        ({"pin_friction": 0.1, "crank_pin": "8cm", "rod_mass": "9kg"}, "--rod-mass does not go with"),
        ({"pin_friction": 0.1, "crank_pin": "8cm", "eps": 3}, "is for a given force or pressures"),
        ({"pin_friction": 0.9, "crank_pin": "9m"}, "together as large as the rod is long"),
    ],
)
def test_pins_that_say_nothing_are_refused(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(KurbelError, match=re.escape(sentence)):
        force: dict[str, Any] = {} if "eps" in options else {"force": 900}
        kurbel.forces_table(crank="240mm", rod="900mm", **force, **options)
