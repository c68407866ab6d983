"""Angles by what holds there: the page is that of the triangle of crank, rod and slide at this place."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import printed, records
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

DIGITS = 20


@given(rod=st.integers(180, 900), share=st.fractions(Fraction(1, 50), Fraction(49, 50), max_denominator=60))
@settings(deadline=None, max_examples=6)
def test_a_path_gives_the_triangle_and_its_forces(rod: int, share: Fraction) -> None:
    path = 240 * share
    rows = records(
        "forces", "--stroke=240mm", f"--rod={rod}mm", "--force=7kN", f"--angle=x={path}mm",
        "--columns=phi,psi,x_mm,torque_nm", f"--digits={DIGITS}",
    )  # fmt: skip
    assert len(rows) == 2
    with mp.workdps(60):
        for row, way in zip(rows, (1, -1), strict=True):
            # On the return the path counts from the other end.
            y = rod + 120 - (path if way > 0 else 240 - path)
            y = mpf(y.numerator) / y.denominator
            cosine = (mpf(120) ** 2 + y**2 - mpf(rod) ** 2) / (240 * y)
            phi = way * mp.acos(cosine)
            psi = mp.asin(mpf(120) / rod * mp.sin(phi))
            torque = 7000 * mpf("0.12") * mp.sin(phi + psi) / mp.cos(psi)
            assert abs(mp.degrees(phi) % 360 - mpf(row["phi"])) < mpf("0.51e-4")
            for key, value in (("psi", mp.degrees(psi)), ("torque_nm", torque)):
                assert abs(value - mpf(row[key])) <= mpf(10) ** -DIGITS


def test_the_greatest_velocity_has_no_acceleration() -> None:
    words = ("--stroke=240mm", "--rod=420mm", "--speed=900/min", "--digits=30")
    rows = records("table", *words, "--angle=c=max;30", "--columns=phi,p,p_mps2")
    zero = "0." + 30 * "0"
    assert [row["p"] for row in rows[:2]] == [row["p_mps2"] for row in rows[:2]] == [zero, zero]
    assert rows[2]["phi"] == "30.0000"


@pytest.mark.parametrize(("rounding", "digits"), [("half-away", "0.1813"), ("half-even", "0.1812")])
def test_what_lies_half_way_is_proved_to(rounding: str, digits: str) -> None:
    # From crosshead to shaft it is 4.8 R: cos φ = 0.8375, and of the middle of the rod ξ = 0.1 + 0.08125.
    words = ("table", "--ratio=1:4", "--point=0.5", "--angle=s=10%", f"--rounding={rounding}")
    assert records(*words, "--columns=path_along")[0]["path_along"] == digits


def test_under_a_load_conditions_are_those_of_its_forces_and_of_every_turn() -> None:
    (at,) = records("solve", "--eps=3", "--where=torque=max", "--columns=tangential", "--digits=12")
    rows = records("forces", "--eps=3", "--angle=torque=max", "--columns=tangential_force", "--digits=12")
    assert [row["tangential_force"] for row in rows] == [at["tangential"]]
    twice = records("turning", "--compression=6", "--heat=8", "--angle=s=10%", "--columns=phi,energy")
    phi = [Fraction(row["phi"]) for row in twice]
    assert [phi[2] - phi[0], phi[3] - phi[1]] == [360, 360]


def test_the_zero_of_the_page_shifts_what_is_printed_and_not_the_place() -> None:
    words = ("table", "--ratio=1:5", "--columns=phi,x", "--angle=psi=max;c=max")
    rows, shifted = records(*words), records(*words, "--zero=90")
    assert [row["x"] for row in rows] == [row["x"] for row in shifted]
    assert [Fraction(row["phi"]) - 90 for row in rows] == [Fraction(row["phi"]) for row in shifted]


def test_every_point_of_a_sweep_has_its_own_angles() -> None:
    found = printed("sweep", "table", "--ratio=1:4;1:5", "--angle=c=max", "-f", "csv", "-o", "-").records()
    assert [row["p"] for row in found] == ["0"] * 4
    assert len({row["phi"] for row in found}) == 4


def test_an_unknown_is_at_such_an_angle() -> None:
    words = ("--stroke=300mm", "--rod=600mm", "--where=p=10 m/s²", "--angle=s=10%", "--digits=6", "-f=csv")
    (row,) = printed("solve", "--unknown=speed", *words).records()
    with mp.workdps(40):
        y, ratio = mpf(750 - 30) / 150, mpf(1) / 4
        cosine = (1 + y**2 - 16) / (2 * y)
        sine = mp.sqrt(1 - cosine**2)
        steep = mp.sqrt(1 - (ratio * sine) ** 2) ** 3
        share = cosine + ratio * (2 * cosine**2 - 1 + ratio**2 * sine**4) / steep
        turns = 30 / mp.pi * mp.sqrt(10 / (mpf("0.15") * share))
    assert abs(turns - mpf(row["speed"])) < mpf("0.51e-6")
