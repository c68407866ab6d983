"""Cranks that nearly cannot turn, and those of which the true stroke is given."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import printed, records
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel

lengths = st.fractions(min_value=Fraction(1, 20), max_value=2, max_denominator=200)
shares = st.fractions(min_value=-1, max_value=1, max_denominator=50)
few = settings(max_examples=25, deadline=None)


@pytest.mark.parametrize(
    "words",
    [
        ("--ratio=1:1000000000", "--angle=1000000"),
        ("--ratio=999999999:1000000000", "--angle=-1000000"),
        ("--ratio=1:5", "--offset=3.99", "--from=-1000000", "--to=1000000", "--step=1000000"),
        ("--ratio=1:5", "--offset=-3.99", "--angle=90"),
        ("--mechanism=beam", "--beam=1.010598", "--angle=90"),
        ("--mechanism=beam", "--beam=1.005", "--ratio=1:9", "--angle=90"),
    ],
    ids=" ".join,
)
def test_what_nearly_cannot_turn_turns(words: tuple[str, ...]) -> None:
    assert records("table", *words)


def made(**words: Fraction | str | None) -> tuple[Fraction, Fraction] | None:
    """Return stroke and ratio of times of the crank that is made of these, if one is."""
    try:
        page = kurbel.deadcentres(columns="stroke_mm,time_ratio", digits=30, **words)
    except kurbel.KurbelError:
        return None
    stroke, times = kurbel.typeset(page, "csv").split()[1].split(",")
    return Fraction(stroke) / 1000, Fraction(times)


def metres(length: Fraction) -> str:
    return f"{length.numerator}/{length.denominator} m"


@few
@given(lengths, lengths, st.fractions(Fraction(1, 20), Fraction(3, 4), max_denominator=60), shares)
def test_a_rod_or_a_ratio_makes_the_stroke(
    stroke: Fraction, rod: Fraction, ratio: Fraction, share: Fraction
) -> None:
    for offset in (metres(share * stroke / 5), share / 4):
        for length in ({"rod": metres(rod)}, {"ratio": ratio}):
            found = made(stroke=f"true:{metres(stroke)}", offset=offset, **length)
            assert found is None or abs(found[0] - stroke) <= Fraction(1, 10**33)


@few
@given(
    lengths,
    st.fractions(Fraction(1, 50), Fraction(3, 4), max_denominator=80),
    st.fractions(Fraction(51, 50), 2, max_denominator=60),
    st.booleans(),
)
def test_a_ratio_of_times_makes_crank_and_rod(
    stroke: Fraction, share: Fraction, ratio: Fraction, below: bool
) -> None:
    side, times = (-1, 1 / ratio) if below else (1, ratio)
    about = {"stroke": f"true:{metres(stroke)}", "offset": metres(side * share * stroke)}
    found = made(**about, time_ratio=f"{times.numerator}/{times.denominator}")
    if found is not None:
        assert abs(found[0] - stroke) <= Fraction(1, 10**33)
        assert abs(found[1] - times) <= Fraction(1, 10**30)


def test_some_crank_is_made_of_each() -> None:
    about = {"stroke": "true:300mm", "offset": "50mm"}
    for more in ({"rod": "1m"}, {"ratio": "1:4"}, {"time_ratio": "6/5"}):
        found = made(**about, **more)
        assert found is not None
        assert found[0] == Fraction(3, 10)
        assert "time_ratio" not in more or found[1] == Fraction(6, 5)
    # Without an offset it is 2R.
    straight = ("table", "--rod=1m", "--angle=60", "-f", "csv")
    assert printed(*straight, "--stroke=true:250mm").out == printed(*straight, "--stroke=250mm").out
