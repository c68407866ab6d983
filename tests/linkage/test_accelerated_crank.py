"""A crank that is itself accelerated, in a four-bar: what turns is the slope of its own angular velocity."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import records

FOUR_BAR = (
    "--mechanism=arc", "--stroke=crank:90mm", "--rod=320mm", "--rocker=210mm", "--pivot=310mm;0",
    "--circuit=-1", "--speed=25rad/s", "--digits=25",
)  # fmt: skip
OMEGA, GAIN, STEP = 25, 40, Fraction(1, 10**8)
# A degree, the step's unit, in radians.
DEGREE = Fraction(31415926535897932384626433832795, 180 * 10**31)


@pytest.mark.parametrize("beside", ["", "--point=0.3"])
@pytest.mark.parametrize("name", ["turn", "rod"])
def test_to_the_even_acceleration_comes_that_of_the_crank(name: str, beside: str) -> None:
    velocity = f"{name}_velocity_radps"
    angles = "--angle=66.99999999;67;67.00000001"
    rows = records("table", *FOUR_BAR, angles, f"--columns={velocity}")
    before, at, after = (Fraction(row[velocity]) for row in rows)
    # dω/dt = ω dω/dφ of an even crank, and ω/ω_1 times the crank's own.
    wanted = (after - before) / (2 * STEP * DEGREE) * OMEGA + at / OMEGA * GAIN
    more = (beside,) if beside else ()
    (row,) = records(
        "table", *FOUR_BAR, *more, "--angle=67", f"--acceleration={GAIN}rad/s2",
        f"--columns={name}_acceleration_radps2",
    )  # fmt: skip
    assert abs(Fraction(row[f"{name}_acceleration_radps2"]) - wanted) < Fraction(1, 10**9)
