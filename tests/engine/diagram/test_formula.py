"""Formulas of torques against the same written in Python, and the sentences that refuse others."""

from __future__ import annotations

from fractions import Fraction
from math import cos, pi, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel.engine.diagram.formula import torque_of
from kurbel.errors import KurbelError
from kurbel.exact.kind import floats

ANGLES = (Fraction(0), Fraction(37), Fraction(211, 2), Fraction(299))


def at(text: str, degrees: Fraction) -> float:
    return float(torque_of(text).at(degrees, floats()))


@pytest.mark.parametrize(
    ("text", "python"),
    [
        ("5000 + 1500 sin(3φ)", lambda t: 5000 + 1500 * sin(3 * t)),
        ("5000 − 600·sin θ N m", lambda t: 5000 - 600 * sin(t)),
        ("(12,5 + 3 cos 2φ) kN m", lambda t: 12500 + 3000 * cos(2 * t)),
        ("200 sin² φ cos(φ + 30°)", lambda t: 200 * sin(t) ** 2 * cos(t + pi / 6)),
        ("-4 sin^3(2(phi - 120)) + 7/2", lambda t: -4 * sin(2 * (t - 2 * pi / 3)) ** 3 + 3.5),
        ("(sin φ + 2cos(φ/2))² / 4", lambda t: (sin(t) + 2 * cos(t / 2)) ** 2 / 4),
        ("30 (2 - sin(π/5 - φ·3)) cos θ", lambda t: 30 * (2 - sin(pi / 5 - 3 * t)) * cos(t)),
    ],
)
def test_a_formula_is_what_it_says(text: str, python: object) -> None:
    assert callable(python)
    for angle in ANGLES:
        assert at(text, angle) == pytest.approx(python(radians(angle)), rel=1e-13, abs=1e-13)


numbers = st.integers(-9, 9)


@settings(max_examples=15, deadline=None)
@given(numbers, numbers, numbers, st.integers(1, 5), st.integers(0, 359))
def test_products_of_sines_are_sums(a: int, b: int, c: int, order: int, phase: int) -> None:
    text = f"({a} + ({b}) sin({order}φ + {phase})) ({c} cos φ - 2)^2"
    for angle in ANGLES:
        t = radians(angle)
        true = (a + b * sin(order * t + radians(phase))) * (c * cos(t) - 2) ** 2
        assert at(text, angle) == pytest.approx(true, rel=1e-11, abs=1e-9)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "ends where a number or a sine is missing"),
        ("5000 + 1500 sin(3φ", "has a bracket at place 16 that is not closed"),
        ("16 000 + 2 sin φ", "has two numbers side by side at place 4; write 16000 or 2*3"),
        ("5 + sin(2 3φ)", "has two numbers side by side at place 11"),
        ("5,000 + sin φ", "has 5,000 at place 1, which may be 5000 or 5.000"),
        ("cos φ/2", 'has a "/" at place 6 that may belong to the angle or not; write cos'),
        ("3 + 20 φ", "has φ at place 8 outside of a sine or cosine; a torque in straight lines"),
        ("1/(1 + sin φ)", "divides by a function of φ at place 3"),
        ("4/(2 - 2)", "divides by 0 at place 3"),
        ("tan φ", 'has "tan" at place 1, which is neither sin, cos nor φ'),
        ("sin(φφ)", "multiplies two angles"),
        ("sin φ^21", 'has a "^" at place 6'),
        ("sin^21 φ", "has a power at place 5 that is no whole number from 1 to 20"),
        ("sin(-500φ)", "has a wave of an order above 200"),
        ("(" * 40 + "1" + ")" * 40, "has more than 30 brackets within each other"),
        ("5 $ 3", 'has "$" at place 3, which no formula has'),
        ("1" * 1001, "has 1001 characters; at most 1000 are read"),
        (
            "(((((1.1^20)^20)^20)^20)^20)^20",
            'torque, "(((((1.1^20)^20)^20)^20)^20)^20": a number of more than 3000 figures would come out',
        ),
        ("((sin φ + 1.123456789)^10)^10" + "*(cos φ + 1.123456789)^20" * 9, "more than 3000 figures"),
    ],
)
def test_what_is_no_formula_is_told_where(text: str, why: str) -> None:
    with pytest.raises(KurbelError) as told:
        torque_of(text)
    assert why in str(told.value)
