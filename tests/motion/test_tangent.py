"""The sheet of the exercise: rod square to crank, closed forms and numbers, in triangles of whole sides."""

from __future__ import annotations

from fractions import Fraction

from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from pages import cells

import kurbel
from kurbel.exact.numerals import Number
from kurbel.page.labels import plain


def records(*words: str) -> list[dict[str, str]]:
    return printed("forces", "--at", "tangent", *words, "-f", "csv").records()


def test_forces_of_a_triangle_of_whole_sides() -> None:
    # R:L = 3:4, so that √(R² + L²) is 5; F = 8 kN, R = 0.3 m.
    place = {"ratio": "3:4", "phi": "53.1301", "psi": "36.8699"}
    (unit,) = records("--ratio=3:4")
    assert unit == place | {"rod_force": "1.2500", "guide_force": "0.7500", "torque": "1.2500"}
    (newtons,) = records("--ratio=3:4", "--force=8kN", "--stroke=600mm")
    assert newtons == place | {"rod_force_n": "10000.0", "guide_force_n": "6000.0", "torque_nm": "3000.0"}


@settings(max_examples=25, deadline=None)
@given(st.fractions(Fraction(1, 50), Fraction(49, 50), max_denominator=97))
def test_numbers_are_those_of_the_closed_forms(ratio: Fraction) -> None:
    keys = ("phi", "psi", *(key + end for key in ("rod_force", "guide_force") for end in ("", "_n")))
    table = kurbel.forces(
        ratio,
        at="tangent",
        digits=20,
        force=12345,
        stroke=Fraction(14, 10),
        columns=(*keys, "torque", "torque_nm"),
    )
    (row,) = table.records.rows
    found = {
        field.key: value
        for field, value in zip(table.records.fields, row, strict=True)
        if field.key != "ratio"
    }
    with mp.workdps(60):
        lam = mp.mpf(ratio.numerator) / ratio.denominator
        root = mp.sqrt(lam * lam + 1)
        true = {
            "phi": mp.atan(1 / lam) * 180 / mp.pi, "psi": mp.atan(lam) * 180 / mp.pi,
            "rod_force": root, "rod_force_n": 12345 * root, "guide_force": lam, "guide_force_n": 12345 * lam,
            "torque": root, "torque_nm": mp.mpf("8641.5") * root,
        }  # fmt: skip
        assert true.keys() == found.keys()
        for key, value in found.items():
            assert isinstance(value, Number)
            assert abs(value.scaled - true[key] * mp.mpf(10) ** 20) <= mp.mpf("0.5") + mp.mpf(10) ** -20, key


def test_motion_in_the_position_can_be_asked_for() -> None:
    # sin φ = 4/5 and cos φ = 3/5; c is S/F, x = 1 - 3/5 + (1 - 4/5)/(3/4), in R.
    (record,) = records("--ratio=3:4", "--columns=x,c,tangential_force,radial_force")
    assert record == {"x": "0.6667", "c": "1.2500", "tangential_force": "1.2500", "radial_force": "0.0000"}


def test_ties_are_proved() -> None:
    for rounding, rod, guide in (("half-away", "1.3", "0.8"), ("half-even", "1.2", "0.8")):
        (record,) = records("--ratio=3:4", "--digits=1", f"--rounding={rounding}")
        assert (record["rod_force"], record["guide_force"]) == (rod, guide)


def test_an_infinite_rod_is_square_to_the_crank_at_a_right_angle() -> None:
    (record,) = records("--ratio=1:∞")
    assert record["phi"] == "90.0000"
    assert (record["psi"], record["rod_force"], record["guide_force"]) == ("0.0000", "1.0000", "0.0000")


def test_sheet_has_closed_forms_beside_degrees_and_minutes() -> None:
    table = kurbel.forces("1:5;1:4", lang="en", at="tangent")
    found = {
        (plain(stub), plain(ratio), plain(unit)): plain(text)
        for (_, stub, ratio, unit), text in cells(table).items()
    }
    # tan 11°18.6' = 1/5, tan 14°2.2' = 1/4.
    assert found["Crank angle φ = arctan(L/R)", "R:L = 1:5", ""] == "78°41′"
    assert found["Rod angle ψ = arctan(R/L)", "R:L = 1:4", ""] == "14°2′"
    assert found["Rod force S = F √((R/L)² + 1)", "R:L = 1:5", "F"] == "1.0198"
    assert found["Guide force N = F R/L", "R:L = 1:4", "F"] == "0.2500"
    assert found["Torque M_d = F R √((R/L)² + 1)", "R:L = 1:4", "F R"] == "1.0308"
    assert r"F\sqrt{(R/L)^{2}+1}" in kurbel.typeset(table, "latex")
    assert "<msqrt>" in kurbel.typeset(table, "html")


def test_the_layout_alone_is_the_position() -> None:
    assert printed("forces", "--layout=forces-tangent").out == printed("forces", "--at=tangent").out
