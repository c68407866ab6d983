"""The crank of which the true stroke is given, against the two dead centres of its triangle by mpmath."""

from __future__ import annotations

from fractions import Fraction

import pytest
from cli import printed, refusal
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel.drive.size.true_stroke import Offset, by_ratio, by_rod, by_time_ratio
from kurbel.errors import ProblemError

lengths = st.fractions(min_value=Fraction(1, 20), max_value=2, max_denominator=200)
shares = st.fractions(min_value=-1, max_value=1, max_denominator=50)
few = settings(max_examples=40, deadline=None)


def real(value: Fraction) -> mp.mpf:
    return mp.mpf(value.numerator) / value.denominator


def dead_centres(radius: Fraction, rod: Fraction, offset: Fraction) -> tuple[mp.mpf, mp.mpf]:
    """The stroke, and by how many degrees the crank turns more than 180° on the outstroke."""
    crank, length, off = map(real, (radius, rod, offset))
    outer, inner = mp.sqrt((length + crank) ** 2 - off**2), mp.sqrt((length - crank) ** 2 - off**2)
    lead = mp.asin(off / (length - crank)) - mp.asin(off / (length + crank))
    return outer - inner, mp.degrees(lead)


@few
@given(lengths, lengths, shares)
def test_the_crank_of_a_rod_makes_the_stroke(stroke: Fraction, rod: Fraction, share: Fraction) -> None:
    with mp.workdps(60):
        for offset in (Offset(share * stroke), Offset(None, share)):
            try:
                radius = by_rod(stroke, offset, rod)
            except ProblemError:
                continue
            across = share * radius if offset.metres is None else offset.metres
            # Beyond this the crank does not turn, as pages of it say.
            if abs(across) < rod - radius:
                assert abs(dead_centres(radius, rod, across)[0] - real(stroke)) < mp.mpf(10) ** -36


@few
@given(lengths, st.fractions(min_value=Fraction(1, 20), max_value=Fraction(3, 4), max_denominator=60), shares)
def test_the_crank_of_a_ratio_makes_the_stroke(stroke: Fraction, ratio: Fraction, share: Fraction) -> None:
    with mp.workdps(60):
        for offset in (Offset(share * stroke / 5), Offset(None, share / 4)):
            try:
                radius = by_ratio(stroke, offset, ratio)
            except ProblemError:
                continue
            across = share / 4 * radius if offset.metres is None else offset.metres
            if abs(across) < radius / ratio - radius:
                found = dead_centres(radius, radius / ratio, across)[0]
                assert abs(found - real(stroke)) < mp.mpf(10) ** -36


@few
@given(
    lengths,
    st.fractions(min_value=Fraction(1, 50), max_value=Fraction(3, 4), max_denominator=80),
    st.fractions(min_value=Fraction(51, 50), max_value=2, max_denominator=60),
    st.booleans(),
)
def test_crank_and_rod_of_a_time_ratio_make_it_and_the_stroke(
    stroke: Fraction, share: Fraction, ratio: Fraction, below: bool
) -> None:
    offset = -share * stroke if below else share * stroke
    times = 1 / ratio if below else ratio
    try:
        radius, rod = by_time_ratio(stroke, Offset(offset), times)
    except ProblemError:
        return
    assume(abs(offset) < rod - radius)
    with mp.workdps(60):
        found, lead = dead_centres(radius, rod, offset)
        assert abs(found - real(stroke)) < mp.mpf(10) ** -33
        assert abs((180 + lead) / (180 - lead) - real(times)) < mp.mpf(10) ** -33


def test_the_page_says_the_stroke_that_was_given_and_the_times() -> None:
    asked = (
        "--true-stroke",
        "300mm",
        "--time-ratio",
        "6/5",
        "--offset",
        "50mm",
        "--columns",
        "stroke_mm,time_ratio",
    )
    assert printed("deadcentres", *asked, "--digits", "9", "-f", "csv").out.split()[1] == (
        "300.000000000,1.200000000"
    )
    # Without an offset it is 2R.
    straight = ("table", "--rod", "1m", "--angle", "60", "-f", "csv")
    assert printed(*straight, "--true-stroke", "250mm").out == printed(*straight, "--stroke", "250mm").out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--true-stroke 250mm --offset 9cm", "add --rod, one --ratio or --time-ratio"),
        (
            "--true-stroke 250mm --offset 9cm --rod 15cm",
            "no crank makes a stroke of 0.25 m with a rod of 0.15 m",
        ),
        (
            "--true-stroke 250mm --offset 9cm --rod 1m --stroke 250mm",
            "and the true stroke 250mm takes one of 248.969 mm",
        ),
        ("--true-stroke 200mm --offset 10cm --rod 15cm", "no crank makes a stroke of 0.2 m"),
        ("--time-ratio 1.2 --offset 9cm", "add --true-stroke"),
        ("--true-stroke 250mm --time-ratio 1.2", "needs the offset as a length"),
        ("--true-stroke 250mm --time-ratio 0.8 --offset 9cm", "with an offset above 0 it is above 1"),
        ("--true-stroke 250mm --time-ratio 1.2 --offset 9cm --rod 1m", "leave --rod and --ratio out"),
        # Of R nothing is left at 40 decimals of a metre.
        ("--true-stroke 1e-60m --offset 9cm --rod 1m", "the true stroke 1e-60m is too small"),
        ("--true-stroke 1e-60m --offset 0.1 --ratio 1:4", "the true stroke 1e-60m is too small"),
        ("--true-stroke 250mm --mechanism arc --rocker 6", "is for the straight and the offset crank"),
    ],
)
def test_what_makes_no_crank_is_refused(words: str, said: str) -> None:
    assert said in refusal("table", *words.split())
