"""A steam engine that cannot be, or that is not computed, is refused in the user's words."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel.drive.crank import Crank
from kurbel.engine.engine import (
    LARGEST_CLEARANCE,
    LARGEST_EXPANSION,
    LARGEST_EXPONENT,
    MOST_CRANKS,
    Engine,
    Steam,
)
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball

TWO = Fraction(2)
FIFTH = Fraction(1, 5)
NOTHING = Fraction(0)
STEAM = Steam(TWO)


def sentence_of_steam(*arguments: Fraction | None) -> str:
    with pytest.raises(ProblemError) as raised:
        Steam(*arguments)  # type: ignore[arg-type]
    return one_sentence(raised.value)


def sentence_of_engine(*arguments: Any, **named: Any) -> str:
    with pytest.raises(ProblemError) as raised:
        Engine(*arguments, **named)
    return one_sentence(raised.value)


def one_sentence(error: ProblemError) -> str:
    text = str(error)
    assert "\n" not in text
    assert ". " not in text
    assert not text.endswith(".")
    return text


@pytest.mark.parametrize(
    ("expansion", "shown", "meant"),
    [
        (Fraction(1, 2), "0.5", ": after 0.5 of it, ε = 2"),
        (NOTHING, "0", ""),
        (Fraction(-3), "-3", ""),
        (Fraction(2, 3), "0.666666666666667", ": after 2/3 of it, ε = 1.5"),
    ],
)
def test_expansion_below_one_is_refused(expansion: Fraction, shown: str, meant: str) -> None:
    assert sentence_of_steam(expansion) == (
        f"expansion ratio ε is {shown}; it must be 1 (no expansion) or more,"
        f" for the cut-off comes after the share 1/ε of the stroke{meant}"
    )


def test_expansion_beyond_a_million_is_refused() -> None:
    assert sentence_of_steam(Fraction(2 * 10**6)) == (
        "expansion ratio ε is 2000000; at most 1000000 is allowed"
    )
    assert sentence_of_steam(LARGEST_EXPANSION + Fraction(1, 10**9)) == (
        "expansion ratio ε is 1000000.000000001; at most 1000000 is allowed"
    )


@pytest.mark.parametrize(
    ("back", "shown"),
    [(Fraction(-1, 10), "-0.1"), (Fraction(3, 2), "1.5"), (Fraction(4, 3), "1.33333333333333")],
)
def test_back_pressure_outside_zero_to_one_is_refused(back: Fraction, shown: str) -> None:
    assert sentence_of_steam(TWO, back) == (
        f"back pressure b is {shown}; it must lie within 0..1,"
        " for it is a share of the steam pressure before cut-off"
    )


@pytest.mark.parametrize(
    ("exponent", "shown"), [(NOTHING, "0"), (Fraction(-1), "-1"), (Fraction(21, 2), "10.5")]
)
def test_exponent_outside_zero_to_ten_is_refused(exponent: Fraction, shown: str) -> None:
    assert sentence_of_steam(TWO, None, exponent) == (
        f"exponent n is {shown}; it must be above 0 and at most 10,"
        " for the pressure falls as the steam expands"
    )


@pytest.mark.parametrize(("clearance", "shown"), [(Fraction(-1, 100), "-0.01"), (Fraction(11), "11")])
def test_clearance_outside_zero_to_ten_is_refused(clearance: Fraction, shown: str) -> None:
    assert sentence_of_steam(TWO, None, Fraction(1), clearance) == (
        f"clearance is {shown}; it must lie within 0..10, for it is a share of the volume swept in a stroke"
    )


def test_back_pressure_that_leaves_no_work_is_refused_with_the_greatest() -> None:
    # (1 + ln 2)/2 = 0.8465735..., Weisbach-Herrmann § 150; what is named must itself be allowed.
    assert sentence_of_steam(TWO, Fraction(17, 20)) == (
        "back pressure b = 0.85 leaves no work at ε = 2; b must be below 0.846573,"
        " or the mean force P would not be above 0"
    )
    assert sentence_of_steam(Fraction(1), Fraction(1)) == (
        "back pressure b = 1 leaves no work at ε = 1; b must be below 1,"
        " or the mean force P would not be above 0"
    )


def test_back_pressure_just_below_the_greatest_is_accepted() -> None:
    assert Steam(TWO, Fraction("0.846573")).back == Fraction("0.846573")
    assert "leaves no work" in sentence_of_steam(TWO, Fraction("0.846574"))


def test_best_back_pressure_without_expansion_leaves_no_work() -> None:
    assert sentence_of_steam(Fraction(1)) == (
        "expansion ratio ε = 1 at its best back pressure, that of the steam at the end of the stroke,"
        " leaves no work; give a lower one, for example --back 0"
    )


def test_every_bound_is_accepted_itself() -> None:
    assert Steam(Fraction(1), NOTHING).expansion == 1
    assert Steam(Fraction(LARGEST_EXPANSION), NOTHING).expansion == LARGEST_EXPANSION
    assert Steam(Fraction(LARGEST_EXPANSION)).back is None
    assert Steam(TWO, NOTHING, Fraction(LARGEST_EXPONENT)).exponent == LARGEST_EXPONENT
    assert Steam(TWO, NOTHING, Fraction(1, 10**9)).exponent == Fraction(1, 10**9)
    assert Steam(TWO, NOTHING, Fraction(1), Fraction(LARGEST_CLEARANCE)).clearance == LARGEST_CLEARANCE
    assert Steam(TWO, NOTHING, Fraction(1), NOTHING).clearance == 0


def test_mariotte_without_clearance_is_the_default() -> None:
    assert Steam(Fraction(3)) == Steam(Fraction(3), None, Fraction(1), NOTHING)


@settings(max_examples=50, deadline=None)
@given(st.integers(101, 5000))
def test_best_back_pressure_is_one_over_the_expansion(hundredths: int) -> None:
    expansion = Fraction(hundredths, 100)
    assert Steam(expansion).numbers(Fraction) == (1 / expansion, 1 / expansion, 1, 0)
    numbers = Steam(expansion).numbers(ball)
    assert isinstance(numbers.back, arb)
    assert numbers.back.overlaps(ball(1 / expansion))


def test_given_back_pressure_stays_as_given() -> None:
    assert Steam(TWO, NOTHING).numbers(Fraction).back == 0
    assert Steam(TWO, FIFTH, Fraction(1), Fraction(1, 20)).numbers(Fraction) == (
        Fraction(1, 2),
        FIFTH,
        1,
        Fraction(1, 20),
    )


@pytest.mark.parametrize("count", [0, MOST_CRANKS + 1])
def test_too_few_or_too_many_cranks_are_refused(count: int) -> None:
    assert sentence_of_engine(Crank(FIFTH), STEAM, cranks=(NOTHING,) * count) == (
        f"the engine has {count} cranks; 1 to 24 are allowed"
    )


def test_first_crank_must_be_at_zero() -> None:
    assert sentence_of_engine(Crank(FIFTH), STEAM, cranks=(Fraction(90), NOTHING)) == (
        "the first crank is at 90°; angles count from the first crank, write them as 0;90"
    )


def test_ratio_next_to_one_is_refused() -> None:
    assert Engine(Crank(1 - Fraction(1, 10**12)), STEAM).plain
    assert sentence_of_engine(Crank(1 - Fraction(1, 10**13)), STEAM) == (
        "crank ratio R:L is nearer to 1 than 10^-12; no engine is built so"
    )


@pytest.mark.parametrize("difference", [Fraction(1, 10**7), Fraction(-1, 10**30)])
def test_exponent_next_to_one_is_refused(difference: Fraction) -> None:
    for allowed in (Fraction(1), 1 + Fraction(1, 10**6), 1 - Fraction(1, 10**6)):
        assert Steam(Fraction(2), exponent=allowed).exponent == allowed
    with pytest.raises(ProblemError, match=r"nearer to 1 than 10\^-6; write 1, Mariotte's law"):
        Steam(Fraction(2), exponent=1 + difference)


def test_exponents_on_both_sides_of_one_enclose_mariottes_law() -> None:
    step = Fraction(1, 10**6)
    below, mariotte, above = (irregularity(Steam(TWO, exponent=n)) for n in (1 - step, Fraction(1), 1 + step))
    assert (below - mariotte) * (above - mariotte) < 0
    assert abs(above - below) < 1e-5


def irregularity(steam: Steam) -> float:
    return float(Turn(Engine(Crank(FIFTH), steam), "exact").irregularity())


def test_most_cranks_are_accepted() -> None:
    cranks = tuple(Fraction(15 * crank) for crank in range(MOST_CRANKS))
    assert Engine(Crank(FIFTH), STEAM, cranks=cranks).cranks == cranks


def test_one_double_acting_crank_is_the_plain_engine() -> None:
    assert Engine(Crank(FIFTH), STEAM).plain
    assert not Engine(Crank(FIFTH), STEAM, double=False).plain
    assert not Engine(Crank(FIFTH), STEAM, cranks=(NOTHING, Fraction(90))).plain
