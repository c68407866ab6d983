"""Conditions as text: what is read, what is written out again, and how bad ones are answered."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

import kurbel
from kurbel.reading.where import (
    ACCELERATIONS,
    ANGLES,
    DEAD_CENTRE,
    MAX,
    MEASURED,
    MIN,
    VALUE,
    Condition,
    read_condition,
)

NAMES = {key: key for key in ("x", "s", "c", "p", "psi", "guide_force")} | {"ψ": "psi"}


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("p=0", Condition("p")),
        ("x = 1,1", Condition("x", VALUE, Fraction("1.1"))),
        ("p = -1/6", Condition("p", VALUE, Fraction(-1, 6))),
        ("p = −1/6", Condition("p", VALUE, Fraction(-1, 6))),
        ("s = 25%", Condition("s", VALUE, Fraction(1, 4))),
        ("s = 12,5 %", Condition("s", VALUE, Fraction(1, 8))),
        ("c = max", Condition("c", MAX)),
        ("p=min", Condition("p", MIN)),
        ("p = 1/6 of dead centre", Condition("p", DEAD_CENTRE, Fraction(1, 6))),
        ("p = -25% of the dead center", Condition("p", DEAD_CENTRE, Fraction(-1, 4))),
        ("p = of dead centre", Condition("p", DEAD_CENTRE, Fraction(1))),
        ("psi = 2°30'", Condition("psi", VALUE, Fraction(5, 2))),
        ("ψ = -5", Condition("psi", VALUE, Fraction(-5))),
        ("x = 200mm", Condition("x", VALUE, Fraction(200), "mm")),
        ("x = 2,5e1 mm", Condition("x", VALUE, Fraction(25), "mm")),
        ("c = 3 m/s", Condition("c", VALUE, Fraction(3), "m/s")),
        ("p = -50 m/s²", Condition("p", VALUE, Fraction(-50), "m/s²")),
        ("guide_force = 0.1", Condition("guide_force", VALUE, Fraction(1, 10))),
    ],
)
def test_conditions_are_read(text: str, condition: Condition) -> None:
    assert read_condition(text, NAMES) == condition


quantities = st.sampled_from(sorted({*NAMES.values()}))
small = st.fractions(-1000, 1000, max_denominator=9999)


@st.composite
def conditions(draw: st.DrawFn) -> Condition:
    quantity = draw(quantities)
    kinds = [VALUE, MAX, MIN] + [DEAD_CENTRE] * (quantity in ACCELERATIONS)
    kind = draw(st.sampled_from(kinds))
    if kind in (MAX, MIN):
        return Condition(quantity, kind)
    if quantity in ANGLES:
        # Degrees, minutes and thousandths of seconds are what is written out.
        return Condition(
            quantity, kind, draw(st.integers(-(10**8), 10**8).map(lambda n: Fraction(n, 3600000)))
        )
    if quantity in MEASURED and kind == VALUE and draw(st.booleans()):
        return Condition(quantity, kind, Fraction(draw(st.integers(-(10**6), 10**6)), 1000), "mm")
    return Condition(quantity, kind, draw(small))


@given(conditions())
def test_a_condition_that_is_written_out_is_read_again(condition: Condition) -> None:
    assert read_condition(str(condition), NAMES) == condition
    assert read_condition(f"{condition.quantity}={condition.right_side(',')}", NAMES) == condition


pieces = st.sampled_from([*"xspc=0123456789.,/-+eE% °'", "max", "min", " of dead centre", "mm", "m/s", "psi"])


@given(st.one_of(st.text(max_size=30), st.lists(pieces, max_size=12).map("".join)))
def test_any_text_is_a_condition_or_an_error_in_a_sentence(text: str) -> None:
    try:
        found = read_condition(text, NAMES)
    except kurbel.KurbelError as error:
        assert str(error)
    else:
        assert found.quantity in NAMES.values()
