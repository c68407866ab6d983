"""Weisbach's works of a stroke, against the pressures of the stroke by quadrature."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import printed
from energy_curve import Exact, Plant
from mpmath import mp


@pytest.mark.parametrize(
    ("options", "plant"),
    [
        ("--eps 3 --back 0.17", Plant(Fraction(3), Fraction(1, 5), Fraction(17, 100))),
        ("--eps 3.5", Plant(Fraction(7, 2), Fraction(1, 5))),
        (
            "--eps 4 --exponent 2 --clearance 7%",
            Plant(Fraction(4), Fraction(1, 5), None, Fraction(2), Fraction(7, 100)),
        ),
        (
            "--eps 4 --exponent 1.13 --back 0.1",
            Plant(Fraction(4), Fraction(1, 5), Fraction(1, 10), Fraction(113, 100)),
        ),
    ],
)
def test_the_works_of_a_stroke_are_integrals_of_its_pressures(options: str, plant: Plant) -> None:
    columns = "full_pressure_work,expansion_work,back_work"
    words = ("delta", *options.split(), "--columns", columns, "--digits", "15", "-f", "csv")
    (row,) = printed(*words).records()
    with mp.workdps(25):
        curve = Exact(plant)
        admitted, expanded = (
            2 * mp.quad(lambda share: curve.pressure(share) + curve.back, span)
            for span in ((0, curve.cut_off), (curve.cut_off, 1))
        )
        found = [mp.mpf(row[key]) for key in columns.split(",")]
        for one, true in zip(found, (admitted, expanded, 2 * curve.back), strict=True):
            assert abs(one - true) < mp.mpf("6e-16")
