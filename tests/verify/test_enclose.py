"""Enclosures hold the true number, are as narrow as their bits say, and settle digits without a doubt."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel import verify
from kurbel.verify import enclose
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import Number, Undecided, degrees_of, number, sine_cosine, spread
from kurbel.verify.surd import parted
from kurbel.verify.value import Value
from kurbel.verify.zeros import between

POSITIVE = st.one_of(
    st.fractions(Fraction(1, 1000), 1000, max_denominator=10**6),
    st.integers(-300, 300).map(lambda power: Fraction(10) ** power),
)
ANGLES = st.one_of(st.fractions(-720, 720, max_denominator=9999), st.integers(-48, 48).map(lambda n: 15 * n))


def exact(one: Fraction | int) -> Any:
    return mp.mpf(Fraction(one).numerator) / Fraction(one).denominator


def as_fraction(one: Any) -> Fraction:
    sign, man, exponent, _ = one._mpf_
    size = int(man) * Fraction(2) ** int(exponent)
    return -size if sign else size


def assert_holds(found: Number, true: Any, bits: int) -> None:
    """It holds the number that mpmath knows to 200 digits, and is narrow beside its size."""
    near = as_fraction(true)
    slack = max(abs(near), Fraction(1, 10**10)) / 10**190
    assert found.low - slack <= near <= found.high + slack
    assert found.high - found.low <= max(Fraction(1), abs(near)) * Fraction(2) ** (12 - bits)


@settings(max_examples=60, deadline=None)
@given(x=POSITIVE, angle=ANGLES, exponent=st.fractions(-3, 3, max_denominator=12), bits=st.integers(60, 400))
def test_every_function_encloses_its_value(
    x: Fraction, angle: Fraction, exponent: Fraction, bits: int
) -> None:
    with mp.workdps(210), enclose.working(bits):
        radians = exact(angle) * mp.pi / 180
        sine, cosine = sine_cosine(Fraction(angle))
        assert_holds(sine, mp.sin(radians), bits)
        assert_holds(cosine, mp.cos(radians), bits)
        assert_holds(number(x).log(), mp.log(exact(x)), bits - 10)
        power = number(x).power(exponent)
        true = exact(x) ** exact(exponent)
        assert_holds(power / spread(*2 * [as_fraction(true)]), mp.mpf(1), bits - 25)
        for side in (1, -1):
            turned = degrees_of(number(side), number(x))
            assert_holds(turned, mp.degrees(mp.atan2(exact(x), side)), bits - 10)
        assert_holds(Number(enclose.pi()), +mp.pi, bits)


FUNCTIONS: list[tuple[Callable[[Number], Number], Callable[[Any], Any]]] = [
    (lambda x: Number(enclose.arctangent(x.span)), mp.atan),
    (lambda x: Number(enclose.sine_cosine(x.span / 1001)[0]), lambda x: mp.sin(x / 1001)),
    (lambda x: x.log(), mp.log),
    (lambda x: Number(enclose.exponential(x.span / 100)), lambda x: mp.exp(x / 100)),
    (lambda x: x.root(), mp.sqrt),
]


@settings(max_examples=60, deadline=None)
@given(x=st.fractions(1, 1000), width=st.fractions(0, 1), share=st.fractions(0, 1))
def test_a_wide_interval_is_taken_whole(x: Fraction, width: Fraction, share: Fraction) -> None:
    with mp.workdps(60), enclose.working(100):
        for enclosed, true in FUNCTIONS:
            found, near = enclosed(spread(x, x + width)), as_fraction(true(exact(x + share * width)))
            assert found.low - Fraction(1, 10**50) <= near <= found.high + Fraction(1, 10**50)
        sine, cosine = sine_cosine(x + width / 2, width / 2)
        turn = exact(x + share * width) * mp.pi / 180
        assert as_fraction(mp.sin(turn)) in sine
        assert as_fraction(mp.cos(turn)) in cosine


def test_the_proved_bounds_hold_what_a_series_leaves_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Broken off after a few terms, an enclosure is wide, and still holds the number."""
    monkeypatch.setattr(enclose, "_tiny", lambda term, bits: abs(term) * 500 < 2**bits)
    for kept in ("pi", "log_two"):
        monkeypatch.setattr(enclose, kept, getattr(enclose, kept).__wrapped__)
    with mp.workdps(60), enclose.working(120):
        assert as_fraction(+mp.pi) in Number(enclose.pi())
        for x in (Fraction(3, 7), Fraction(9, 10), Fraction(17, 12), Fraction(71, 10)):
            for enclosed, true in FUNCTIONS:
                found = enclosed(number(x))
                assert found.low <= as_fraction(true(exact(x))) <= found.high
        for degrees in (11, 29, 44):
            assert as_fraction(mp.cos(mp.radians(degrees))) in sine_cosine(Fraction(degrees))[1]


@given(st.integers(1, 10**30))
def test_whole_numbers_longer_than_the_precision_are_rounded_outwards(whole: int) -> None:
    with enclose.working(1):
        assert Fraction(whole) in number(Fraction(whole, 7)) * 7
        assert enclose.low(enclose.of(whole)) <= whole <= enclose.high(enclose.of(whole))


@given(st.integers(1, 10**12))
def test_squares_are_taken_out_of_a_root(whole: int) -> None:
    outside, inside = parted(whole)
    assert outside * outside * inside == whole


def test_exact_numbers_stay_exact() -> None:
    sine, cosine = sine_cosine(Fraction(75))
    assert (sine * sine + cosine * cosine).rational == 1
    assert (4 * sine * cosine).rational == 1
    assert ((sine + cosine) * (1 / (sine + cosine))).rational == 1
    assert number(Fraction(49, 36)).root().rational == Fraction(7, 6)
    assert number(8).power(Fraction(-3, 2)).exact == {2: Fraction(1, 32)}
    assert degrees_of(cosine_of(60), sine).rational is None
    assert degrees_of(-cosine_of(30), cosine_of(60)).rational == 150


def cosine_of(degrees: int) -> Number:
    return sine_cosine(Fraction(degrees))[1]


def test_what_is_not_known_is_not_decided() -> None:
    about = spread(Fraction(-1, 10), Fraction(1, 10))
    for question in (about.sign, lambda: 1 / about, lambda: degrees_of(about, about)):
        with pytest.raises(Undecided):
            question()
    with pytest.raises(ValueError, match="root of a negative"):
        (about - 1).root()
    assert (about + 5).sign() == 1
    assert (about * about).low <= 0


@given(st.fractions(Fraction(1, 5), 3, max_denominator=50))
def test_slopes_of_a_series_are_those_of_the_function(at: Fraction) -> None:
    with enclose.working(80):
        x = Jet([number(at), number(1), number(0), number(0)])
        root = ((1 + x * x).root() / x) * x
        u = 1 + at * at
        assert (root * root).terms[3].low <= 0 <= (root * root).terms[3].high
        # (√(1 + x²))'' = (1 + x²)^(-3/2).
        error = root.slope(2) * number(u).power(Fraction(3, 2)) - 1
        assert max(abs(error.low), abs(error.high)) < Fraction(1, 2**60)
        assert (2 / (1 - (x - at))).at(number(Fraction(1, 2))).rational == Fraction(15, 4)


@pytest.mark.parametrize("bits", [80, 300])
def test_a_zero_is_proved_and_narrow(bits: int) -> None:
    with enclose.working(bits):
        found = between(lambda x: x.angle * x.angle * x.angle - 2, Fraction(1), Fraction(3, 2)).angle
        assert (found * found * found - 2).low <= 0 <= (found * found * found - 2).high
        assert found.high - found.low < Fraction(1, 2 ** (bits - 10))


def test_a_double_zero_is_not_claimed() -> None:
    with pytest.raises(Undecided), enclose.working(80):
        between(lambda x: x.angle * x.angle, Fraction(-1, 4), Fraction(1, 8))


# Printed decimals.


def value(fraction: str) -> Value:
    return Value(lambda: number(fraction))


@pytest.mark.parametrize(
    ("of", "decimals", "away", "even"),
    [
        ("0.125", 2, "0.13", "0.12"), ("-0.125", 2, "-0.13", "-0.12"), ("2.5", 0, "3", "2"),
        ("-0.004", 2, "0.00", "0.00"), ("1/3", 5, "0.33333", "0.33333"), ("199/200", 2, "1.00", "1.00"),
    ],
)  # fmt: skip
def test_ties_are_rounded_as_asked(of: str, decimals: int, away: str, even: str) -> None:
    assert (value(of).digits(decimals), value(of).digits(decimals, "half-even")) == (away, even)
    assert value(of).confirms(away.replace(".", ",").replace("-", "−")) == verify.CONFIRMED
    wrong = away[:-1] + ("8" if away[-1] != "8" else "7")
    assert value(of).confirms(wrong) == verify.WRONG


def test_a_tie_that_is_not_known_to_be_one_stays_undecided() -> None:
    # log 2 + log (1/2) is 0, of which no enclosure knows more than that it is near.
    half = Value(lambda: number(2).log() + number(Fraction(1, 2)).log() + Fraction(1, 2))
    assert half.confirms("1") == verify.UNDECIDED
    assert half.confirms("0.50") == verify.CONFIRMED
    near = Value(lambda: number(1).log() + Fraction(1, 2) - Fraction(1, 10**90))
    assert (near.digits(0), near.confirms("1")) == ("0", verify.WRONG)


def test_a_span_below_zero_has_no_root() -> None:
    with pytest.raises(ZeroDivisionError, match="root of a negative number"):
        enclose.root(-enclose.of(1))


def test_an_enclosure_without_an_end_has_none() -> None:
    for end in (enclose.low, enclose.high):
        with pytest.raises(OverflowError, match="without an end"):
            end(1 / enclose.between(-1, 1))
