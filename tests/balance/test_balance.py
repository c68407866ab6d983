"""Balance of engines: against the summed accelerations of all pistons, and sums of roots of unity."""

from __future__ import annotations

import math
from fractions import Fraction

import flint
import numpy as np
import pytest
from cli import records
from courses import course, slide
from hypothesis import given, settings
from hypothesis import strategies as st
from pace import within

from kurbel.exact import certify
from kurbel.kernel.harmonics import Star

HALF = Fraction(1, 2)
STEPS = 256
TURN = 2 * np.pi * np.arange(STEPS) / STEPS
COLUMNS = ("along", "across", "forward", "backward", "greatest", "least")


ANGLES = st.one_of(
    st.integers(-360, 720).map(Fraction),
    st.sampled_from([0, 60, 72, 90, 120, 144, 180, 240, 270]).map(Fraction),
    st.integers(-3600, 3600).map(lambda tenths: Fraction(tenths, 10)),
)
CYLINDERS = st.lists(
    st.tuples(ANGLES, st.integers(-40, 40).map(lambda tenths: Fraction(tenths, 10)), ANGLES),
    min_size=1,
    max_size=8,
    unique_by=lambda one: (one[1], one[2] % 360),
)


@settings(max_examples=30, deadline=None)
@given(cylinders=CYLINDERS, percent=st.integers(0, 100), rod=st.integers(2, 9))
def test_residuals_are_the_fourier_analysis_of_what_the_pistons_push(
    cylinders: list[tuple[Fraction, Fraction, Fraction]], percent: int, rod: int
) -> None:
    listed = [";".join(f"{float(one):g}" for one in part) for part in zip(*cylinders, strict=True)]
    words = [f"--{name}={part}" for name, part in zip(("cranks", "positions", "banks"), listed, strict=True)]
    asked = (
        *words,
        f"--share={percent}%",
        f"--ratio=1:{rod}",
        "--orders=6",
        f"--columns={','.join(COLUMNS)}",
    )
    found = records("balance", *asked, "--digits=9")
    places = [float(place) for _, place, _ in cylinders]
    middle = (min(places) + max(places)) / 2
    force = np.zeros(STEPS, complex)
    moment = np.zeros(STEPS, complex)
    for (crank, _, bank), place in zip(cylinders, places, strict=True):
        pin, leaning = TURN + math.radians(crank), math.radians(bank)
        piston = course(slide(Fraction(1, rod)), "p")(pin - leaning) * np.exp(1j * leaning)
        pushed = piston - percent / 100 * np.exp(1j * pin)
        force += pushed
        moment += (place - middle) * pushed
    assert [(row["residual"], row["order"]) for row in found] == [
        (residual, order) for residual in ("force", "moment") for order in "1246"
    ]
    for row in found:
        whole, order = (force if row["residual"] == "force" else moment), int(row["order"])
        forward, backward = ((whole * np.exp(turn * order * TURN)).mean() for turn in (-1j, 1j))
        # What cos φ and sin φ are multiplied by; the matrix turns the unit circle into the ellipse.
        both = np.array([forward + backward, 1j * (forward - backward)])
        greatest, least = np.linalg.svd(np.array([both.real, both.imag]), compute_uv=False)
        true = (np.hypot(*both.real), np.hypot(*both.imag), abs(forward), abs(backward), greatest, least)
        assert [float(row[key]) for key in COLUMNS] == pytest.approx(true, rel=0, abs=1.5e-9)


@pytest.mark.parametrize("count", [2, 3, 5, 8, 15, 24])
def test_equally_turned_cranks_balance_all_orders_but_multiples_of_their_number(count: int) -> None:
    cranks = ";".join(str(Fraction(360 * number, count)) for number in range(count))
    rows = records("balance", f"--cranks={cranks}", f"--orders={count + 1}", "--columns=factor,along")
    for row in rows:
        if row["residual"] == "force" and int(row["order"]) % count:
            assert row["along"] == "0"
        elif row["residual"] == "force":
            assert float(row["along"]) == pytest.approx(count * abs(float(row["factor"])), abs=count * 6e-5)


@pytest.mark.parametrize(
    ("words", "column", "digits", "away", "even"),
    [
        ("--engine=inline-1", "forward", 0, "1", "0"),
        ("--cranks=0;120 --share=7/8", "greatest", 2, "0.88", "0.88"),
        # One cylinder with 1/8 balanced: half axes 7/8 and 1/8, whose squares solve the same equation.
        ("--engine=inline-1 --share=1/8", "least", 2, "0.13", "0.12"),
        ("--engine=inline-1 --share=1/8", "greatest", 2, "0.88", "0.88"),
        ("--cranks=0;0 --banks=-30;30 --share=1/4", "greatest", 0, "1", "1"),
        # |1 + e^60°i| = √3.
        ("--cranks=0;60", "along", 20, "1.73205080756887729353", "1.73205080756887729353"),
    ],
)  # fmt: skip
def test_ties_are_recognised(words: str, column: str, digits: int, away: str, even: str) -> None:
    for rounding, number in (("half-away", away), ("half-even", even)):
        asked = (*words.split(), f"--columns={column}", f"--digits={digits}", f"--rounding={rounding}")
        assert records("balance", *asked)[0][column] == number


SMALL = st.sampled_from([Fraction(1), Fraction(-1), Fraction(1, 10**12)])


@st.composite
def stars(draw: st.DrawFn) -> Star:
    """Regular polygons, which vanish, turned and weighed, often with a ray too many."""
    star = Star()
    for _ in range(draw(st.integers(1, 3))):
        corners = draw(st.sampled_from([2, 3, 4, 5, 6, 7, 9, 11]))
        turn, length = draw(st.fractions(0, 1, max_denominator=30)), draw(st.integers(1, 3))
        star += Star.of((turn + Fraction(one, corners), Fraction(length)) for one in range(corners))
    if draw(st.booleans()):
        star += Star.of(draw(st.lists(st.tuples(st.fractions(0, 1, max_denominator=30), SMALL), max_size=2)))
    return star


@settings(max_examples=40, deadline=None)
@given(star=st.one_of(stars(), st.tuples(stars(), stars()).map(lambda two: two[0] * two[1])))
def test_a_star_vanishes_where_its_sum_is_zero(star: Star) -> None:
    with flint.ctx.workprec(3000):
        x, y = star.point(certify.ball_circle, certify.ball)
        assert star.vanishes() == (abs(x) + abs(y) < flint.arb(2) ** -2900)


def test_famous_sums_of_roots_of_unity_vanish() -> None:
    # cos 36° - cos 72° = ½, and Conway and Jones: cos π/7 - cos 2π/7 + cos 3π/7 = ½.
    half = Star.ray(Fraction(0), HALF)

    def cosine(degrees: Fraction) -> Star:
        return (Star.ray(degrees) + Star.ray(-degrees)) * HALF

    assert (cosine(Fraction(36)) - cosine(Fraction(72)) - half).vanishes()
    seventh = Fraction(180, 7)
    sevenths = cosine(seventh) - cosine(2 * seventh) + cosine(3 * seventh) - half
    assert sevenths.vanishes()
    assert not (sevenths + Star.ray(seventh, Fraction(1, 10**60))).vanishes()
    assert Star().vanishes()


def test_angles_of_thirty_digits_take_no_time() -> None:
    cranks = ";".join(f"0.{number**7 + 10**29}" for number in range(24))
    with within(90):
        assert len(records("balance", f"--cranks={cranks}", "--digits=30")) == 4
