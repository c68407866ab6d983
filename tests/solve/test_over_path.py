"""Tables over the path: at the angles that stand there the drive that verify encloses has gone the share."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import printed, records
from hypothesis import example, given, settings
from hypothesis import strategies as st

import kurbel
from kurbel import verify

DIGITS = 20
ratios = st.fractions(Fraction(1, 20), Fraction(7, 10), max_denominator=40)
shares = st.fractions(Fraction(0), Fraction(1), max_denominator=30)


def asked(ratio: Fraction, share: Fraction, columns: str, *more: str) -> dict[str, str]:
    words = ("table", f"--ratio={ratio}", f"--angle=s={share}", f"--columns=share,{columns}")
    (found,) = records(*words, f"--digits={DIGITS}", *more)
    return found


def check(drive: verify.Drive, ratio: Fraction, share: Fraction, *more: str, method: str = "exact") -> None:
    """Beside the angle the share is another on either side; what stands there is had at a closer angle."""
    row = asked(ratio, share, COLUMNS, *more)
    (close,) = records(
        "table", f"--ratio={ratio}", f"--angle=s={share}", "--columns=phi,phi_return",
        "--digits=45", *more,
    )  # fmt: skip
    half = Fraction(1, 2 * 10**DIGITS)
    for back in ("", "_return"):
        angle, known = Fraction(row[f"phi{back}"]), Fraction(close[f"phi{back}"])
        assert abs(angle - known) <= half
        for side in (-1, 1):
            beside = drive.value(f"x{back}_stroke", known + side * Fraction(1, 10**44), method).near(450)
            # At its ends the stroke stands still.
            still = share in (0, 1) and abs(beside - share) < Fraction(1, 10**86)
            assert still or (beside - share) * side > 0
        for key in ("c", "p", "psi"):
            value = drive.value(f"{key}{back}", known, method)
            assert value.confirms(row[f"{key}{back}"]) == verify.CONFIRMED, (key, back, share)


COLUMNS = "phi,phi_return,c,c_return,p,p_return,psi,psi_return"


@given(ratio=ratios, share=shares)
@example(ratio=Fraction(1, 5), share=Fraction(1, 10))
@example(ratio=Fraction(5, 8), share=Fraction(1))
@settings(deadline=None, max_examples=12)
def test_angles_velocities_and_accelerations_are_those_of_the_links(ratio: Fraction, share: Fraction) -> None:
    check(verify.drive(ratio), ratio, share)


@given(
    ratio=st.fractions(Fraction(1, 12), Fraction(2, 5), max_denominator=20),
    offset=st.fractions(Fraction(-9, 10), Fraction(9, 10), max_denominator=12),
    share=shares,
)
@settings(deadline=None, max_examples=10)
def test_offset_cranks_are_found_from_their_own_dead_centres(
    ratio: Fraction, offset: Fraction, share: Fraction
) -> None:
    check(verify.drive(ratio, offset), ratio, share, f"--offset={offset}")


def test_first_order_has_its_own_path() -> None:
    ratio = Fraction(2, 9)
    check(verify.drive(ratio), ratio, Fraction(3, 10), "--method=series", method="series")


def test_the_return_stroke_is_the_outstroke_from_its_other_end() -> None:
    rows = records("table", "--ratio=1:4", "--angle=s=0..1:0.125")
    assert len(rows) == 9
    for row, other in zip(rows, reversed(rows), strict=True):
        assert row["c"] == other["c_return"]
        assert Fraction(row["p"]) == -Fraction(other["p_return"])
        assert Fraction(row["phi"]) + Fraction(other["phi_return"]) == 180


def test_values_on_a_rounding_boundary_are_proved_to_lie_there() -> None:
    # 1 - cos φ = 1/2 at 60°, and there p = cos 60°.
    (row,) = records("table", "--method=infinite", "--angle=s=25%", "--digits=0")
    assert (row["phi"], row["p"], row["p_return"]) == ("60", "1", "1")
    # R, L and the way from shaft to crosshead are as 3, 4 and 5: sin φ = 4/5, tan ψ = 3/4, c/v = 5/4.
    words = ("table", "--ratio=3:4", "--angle=s=1/3", "--columns=c", "--digits=1")
    roundings = ("half-even", "half-away")
    found = [records(*words, f"--rounding={one}")[0]["c"] for one in roundings]
    assert found == ["1.2", "1.3"]


def test_forces_of_masses_are_those_at_the_angle() -> None:
    about = (
        "--offset=0.3", "--force=10kN", "--stroke=600mm", "--speed=120/min", "--reciprocating=200kg",
        "--friction=500N", "--digits=3",
    )  # fmt: skip
    (row,) = records(
        "forces", *about, "--angle=s=35%", "--columns=phi,torque_nm,guide_force_return_n,phi_return"
    )
    fine = asked(Fraction(1, 5), Fraction(7, 20), "phi,phi_return", "--offset=0.3")
    for angle, key in (("phi", "torque_nm"), ("phi_return", "guide_force_return_n")):
        (other,) = records("forces", *about, f"--angle={fine[angle]}", f"--columns={key}")
        assert row[key] == other[key]


def test_friction_at_an_end_is_that_of_the_stroke_which_begins_there() -> None:
    rows = records(
        "forces", "--offset=0.2", "--force=10kN", "--stroke=600mm", "--friction=500N",
        "--angle=s=0..1:0.5", "--columns=friction_force_n,torque_nm",
    )  # fmt: skip
    assert [row["friction_force_n"] for row in rows] == ["-500.0", "-500.0", "500.0"]


def test_linkages_move_over_their_arcs() -> None:
    words = ("--mechanism=arc", "--rocker=6", "--ratio=1:5", f"--digits={DIGITS}")
    rows = records("table", *words, "--angle=s=0..1:0.2", "--columns=share,phi,path,velocity")
    whole, unit = Fraction(rows[-1]["path"]), Fraction(1, 10**DIGITS)
    for row in rows:
        assert abs(Fraction(row["path"]) - whole * Fraction(row["share"])) <= unit
        (at,) = records("table", *words, f"--angle={row['phi']}", "--columns=path,velocity")
        # The angle is printed to as many places as what follows from it.
        for key in ("path", "velocity"):
            assert abs(Fraction(at[key]) - Fraction(row[key])) <= 2 * unit


def test_python_takes_the_same_words() -> None:
    page = kurbel.table("1:5", angle="s=0..1:0.25", columns=["share", "phi"])
    assert kurbel.typeset(page, "csv").splitlines()[1] == "0.00,0.0000"
    assert len(list(page.records.rows)) == 5


TRIANGLE = "cos φ = ±(R² + y² - L²)/(2 R y)"


@pytest.mark.parametrize(
    ("words", "there", "absent"),
    [
        ("table", ["for R:L = 1:5; exact", "S = 2 R", TRIANGLE], ["S stroke", "lengths"]),
        ("table --ratio 1:4;1:5", ["path; exact"], ["for R:L"]),
        ("table --method infinite", ["path; infinitely", "x/R = 1 - cos φ, c/v"], ["R:L", "y between"]),
        ("table --ratio 1:∞", ["x/R = 1 - cos φ, c/v"], ["y between"]),
        ("table --method series", ["1/2 λ sin² φ"], ["y between"]),
        ("table --offset 0.3", ["φ from the slide direction; S stroke", "cos φᵢ"], ["S =", "y between"]),
        ("table --mechanism arc --rocker 6", ["S stroke", "sin(ζ + τ)/cos τ"], ["y between", "S ="]),
        ("forces", ["Forces of the crank drive over"], ["Crank angle, rod force", "Masses"]),
        ("forces --columns rod_force,guide_force", ["Forces of the crank drive over"], ["Rod force and"]),
        ("forces --columns phi,c", ["Crank angle and piston velocity over"], ["Forces of"]),
        (
            "forces --force 1kN --stroke 1m --speed 2/s --reciprocating 100kg",
            ["F = 1000 N", "Masses: piston and crosshead 100 kg"],
            ["S/F ="],
        ),
    ],
)
def test_a_page_says_what_holds_for_its_own_drive(words: str, there: list[str], absent: list[str]) -> None:
    page = printed(*words.split(), "--angle=s=50%", "--lang=en").out
    said = " ".join(page.replace("−", "-").split())
    assert [one for one in there if one not in said] == []
    assert [one for one in absent if one in said] == []


def test_defaults_in_degrees_are_left_out() -> None:
    words = ("table", "--angle=s=0..1:0.2")
    assert printed(*words, KURBEL_TABLE_ZERO="outer", KURBEL_TABLE_TO="180").out == printed(*words).out
