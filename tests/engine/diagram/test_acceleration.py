"""The greatest and the least angular acceleration of a flywheel, against SciPy and by hand."""

from __future__ import annotations

import re
from math import pi, sin

import pytest
from cli import printed
from scipy.optimize import minimize_scalar


def line(*words: str) -> tuple[float, list[float], float, list[float]]:
    """The greatest acceleration, its angles, the least and its angles."""
    page = " ".join(printed(*words, "--lang=en").out.split()).replace("−", "-")
    found = re.search(r"T_L\)/J greatest (\S+) rad/s² at (.*?), least (\S+) rad/s² at ([-\d.°; to]+)", page)
    assert found
    most, high, least, low = found.groups()
    return float(most), _angles(high), float(least), _angles(low)


def _angles(text: str) -> list[float]:
    return [float(one) for one in re.findall(r"[\d.]+(?=°)", text)]


def test_waves_are_steepest_where_the_excess_is_greatest() -> None:
    def excess(angle: float) -> float:
        return 600 * sin(2 * angle) - 500 * sin(angle)

    top = minimize_scalar(lambda angle: -excess(angle), bounds=(pi, 1.5 * pi), options={"xatol": 1e-12})
    words = ("--torque=5000 + 600 sin 2φ", "--load-torque=5000 + 500 sin φ")
    most, high, least, low = line("flywheel", *words, "--mass=500kg", "--radius=0.4m", "--speed=150/min")
    assert (most, least) == pytest.approx((excess(top.x) / 80, -excess(top.x) / 80), abs=6e-4)
    assert high + low == pytest.approx([top.x * 180 / pi, 360 - top.x * 180 / pi], abs=6e-4)


@pytest.mark.parametrize(
    ("torque", "expected"),
    [
        # Each a triangle of 90 N m at 60°: three of them make 67.5 N m on the mean, 22.5 N m above and below.
        (
            ("--torque=0:0;60:90;180:0;360:0", "--cranks=0;120;240", "--inertia=0.0768kgm2"),
            (292.97, [60, 180, 300], -292.97, [0, 120, 240]),
        ),
        (("--torque=0:100;180:100;180:0;360:0", "--inertia=2kgm2"), (25, [0, 180], -25, [180, 360])),
        (("--torque=5000 + 1500 sin 3φ", "--inertia=200kgm2"), (7.5, [30, 150, 270], -7.5, [90, 210, 330])),
        # 8 kJ in two turns: 2000/π N m below the peak of 12 kJ of a triangle over half a turn, 24000/π N m.
        (
            ("--triangles=0;-1;3;0", "--turns=2", "--power=20kW", "--speed=300/min", "--inertia=100kgm2"),
            (70.028, [450], -31.831, [270]),
        ),
    ],
)  # fmt: skip
def test_lines_and_waves_have_theirs_at_rational_angles(
    torque: tuple[str, ...], expected: tuple[float, list[float], float, list[float]]
) -> None:
    assert line("turning", *torque) == expected
