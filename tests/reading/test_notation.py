"""Text as engineers write it, read to exact numbers; what cannot be read is answered with a sentence."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import pytest
from cli import sentence_of
from hypothesis import example, given, settings
from hypothesis import strategies as st

import kurbel
from kurbel.exact.numerals import degrees_text
from kurbel.reading import notation
from kurbel.reading.notation import Progression, share

positive = st.fractions(min_value=Fraction(1, 1000), max_value=1000, max_denominator=1000)
# Text that nearly is notation finds more than arbitrary text.
notations = st.text(st.sampled_from("0123456789.,:;/°'\"′″+-eE∞ ٣１²\n"), max_size=30)
anything = st.one_of(st.text(max_size=80), notations)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (" 7 ", Fraction(7)),
        ("-2e-3", Fraction(-1, 500)),
        ("+1,25E+2", Fraction(125)),
        (".5", Fraction(1, 2)),
        ("3.", Fraction(3)),
        ("0.1000000000000000055511151231257827", Fraction(1000000000000000055511151231257827, 10**34)),
    ],
)
def test_numbers_are_read_exactly_with_point_or_comma(text: str, value: Fraction) -> None:
    assert notation.number(text) == value


@given(st.decimals(allow_nan=False, allow_infinity=False, places=12, min_value=-(10**9), max_value=10**9))
def test_a_decimal_is_read_back_from_what_plain_writes(value: Any) -> None:
    exact = Fraction(value)
    assert notation.number(notation.plain(exact)) == exact
    assert notation.number(notation.plain(exact, ",")) == exact


decimals = st.decimals(allow_nan=False, allow_infinity=False, places=4, min_value=0, max_value=10**6)
signs = st.sampled_from(["", "+", "-", "−"])
marks = st.sampled_from(".,")


@settings(max_examples=60)
@given(signs, decimals, decimals.filter(bool), marks, st.sampled_from(["/", " / "]))
def test_a_fraction_is_the_quotient_of_its_numbers(
    sign: str, above: Decimal, below: Decimal, mark: str, bar: str
) -> None:
    written = f"{sign}{above}{bar}{below}".replace(".", mark)
    quotient = Fraction(above) / Fraction(below) * (-1 if sign in "-−" and sign else 1)
    assert notation.number(written) == quotient
    assert share(f"{written}%") == quotient / 100
    assert notation.angle(f"{sign}{above}".replace(".", mark) + "°") == quotient * Fraction(below)


@settings(max_examples=40)
@given(signs, st.integers(0, 999), st.integers(0, 999), st.integers(1, 999))
def test_a_mixed_number_is_the_sum_of_its_parts(sign: str, whole: int, above: int, below: int) -> None:
    total = (whole + Fraction(above, below)) * (-1 if sign in "-−" and sign else 1)
    assert notation.number(f"{sign}{whole} {above}/{below}") == total
    assert notation.angle(f"{sign}{whole} {above}/{below}°") == total
    assert notation.number(str(total)) == total


def test_fractions_stand_in_lists_and_ranges() -> None:
    assert notation.numbers(["1/3;2/3", "1..2:1/2"], "share") == (
        Fraction(1, 3), Fraction(2, 3), Fraction(1), Fraction(3, 2), Fraction(2),
    )  # fmt: skip
    assert sentence_of(lambda text: notation.numbers([text], "share"), "1/3,2/3") == (
        "share \"1/3,2/3\" has commas between its values; write the list as '1/3;2/3'"
    )


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1:10/3", Fraction(3, 10)),
        ("1:4 1/2", Fraction(2, 9)),
        ("1:4,5", Fraction(2, 9)),
        ("1/4.5", Fraction(2, 9)),
        ("2:9", Fraction(2, 9)),
        ("0.2", Fraction(1, 5)),
        (" 1 : 6 ", Fraction(1, 6)),
        ("0", Fraction(0)),
        ("1:∞", Fraction(0)),
        ("1:inf", Fraction(0)),
        ("1/oo", Fraction(0)),
    ],
)
def test_ratios_are_the_fractions_that_were_typed(text: str, value: Fraction) -> None:
    assert notation.ratio(text) == value


@given(st.fractions(min_value=0, max_value=1, max_denominator=10**6))
def test_a_ratio_is_read_back_from_what_is_printed(value: Fraction) -> None:
    assert notation.ratio(notation.ratio_text(value)) == value
    assert notation.ratio(notation.ratio_text(value, ",")) == value


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Fraction(1, 5), "1:5"),
        (Fraction(2, 9), "1:4.5"),
        (Fraction(3, 7), "3:7"),
        (Fraction(4, 9), "1:2.25"),
        (Fraction(0), "1:∞"),
    ],
)
def test_a_ratio_is_printed_over_one_where_the_rod_is_a_finite_decimal(value: Fraction, text: str) -> None:
    assert notation.ratio_text(value) == text


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("22,5", Fraction(45, 2)),
        ("2°30'", Fraction(5, 2)),
        ("2° 30′", Fraction(5, 2)),
        ("30'", Fraction(1, 2)),
        ("79°20'15\"", 79 + Fraction(20, 60) + Fraction(15, 3600)),
        ("79°20'15''", 79 + Fraction(20, 60) + Fraction(15, 3600)),
        ("-79°20′15″", -79 - Fraction(20, 60) - Fraction(15, 3600)),
        ("12deg", Fraction(12)),
        ("1e-8", Fraction(1, 10**8)),
    ],
)
def test_angles_are_read_in_degrees_minutes_and_seconds(text: str, value: Fraction) -> None:
    assert notation.angle(text) == value


@given(st.integers(-(10**7), 10**7))
def test_an_angle_in_seconds_is_read_back_from_what_is_printed(seconds: int) -> None:
    angle = Fraction(seconds, 3600)
    assert notation.angle(degrees_text(angle)) == angle


@pytest.mark.parametrize(
    ("texts", "rods"),
    [
        (["1:4;1:4,5", "1:5"], [4, Fraction(9, 2), 5]),
        (["1:3..1:6"], [3, 4, 5, 6]),
        (["1/3..4:0,5"], [3, Fraction(7, 2), 4]),
        (["0.2..0.25:0.05"], [5, 4]),
        (["1:5;0.2;2:10"], [5]),
        # A comma before another ratio parts a list, which needs no quotes in a shell; others are decimals.
        (["1:4,1:4,5,1:10/3"], [4, Fraction(9, 2), Fraction(10, 3)]),
        (["1:4,5, 1:5;1:6"], [Fraction(9, 2), 5, 6]),
        (["1:3..4,5:0,5"], [3, Fraction(7, 2), 4, Fraction(9, 2)]),
        (["0,5:4,5", "1:4,10/3"], [9, Fraction("4.10") / 3]),
    ],
)
def test_lists_and_ranges_of_ratios(texts: list[str], rods: list[Fraction]) -> None:
    assert notation.ratios(texts) == tuple(1 / Fraction(rod) for rod in rods)


@pytest.mark.parametrize(
    ("texts", "angles"),
    [
        (["0", "30;60", "30"], [0, 30, 60]),
        (["0..25:10"], [0, 10, 20]),
        (["88..91"], [88, 89, 90, 91]),
        (["2°30'..7°30':2°30'"], [Fraction(5, 2), 5, Fraction(15, 2)]),
        (["0..20:10;45"], [0, 10, 20, 45]),
        (["0..1,5:0,5"], [0, Fraction(1, 2), 1, Fraction(3, 2)]),
    ],
)
def test_lists_and_ranges_of_angles(texts: list[str], angles: list[Fraction]) -> None:
    assert list(notation.angles(texts)) == angles


def test_a_range_of_a_billion_angles_is_not_written_out() -> None:
    angles = notation.angles(["0..999.999999:1e-6"])
    assert len(angles) == 10**9
    assert angles[-1] == Fraction(999999999, 10**6)


@pytest.mark.parametrize("read", [notation.ratios, notation.angles])
@pytest.mark.parametrize(
    "text", ["." * 100_000 + ":", "1:" + " " * 100_000 + "..", "0.." * 50_000, "9" * 100_000]
)
def test_a_text_of_enormous_length_is_refused_at_once(read: Callable[[list[str]], object], text: str) -> None:
    assert len(sentence_of(read, [text])) < 200


@given(anything)
@example("1:4..∞")
@example("1e999..1e-999:1e-999")
def test_any_text_is_read_or_answered_with_one_sentence(text: str) -> None:
    def as_list(read: Callable[[list[str]], object]) -> Callable[[str], object]:
        return lambda one: read([one])

    for read in (
        notation.number,
        notation.ratio,
        notation.angle,
        as_list(notation.ratios),
        as_list(notation.angles),
    ):
        try:
            read(text)
        except kurbel.KurbelError as error:
            assert 0 < len(str(error)) < 300


@given(start=st.fractions(max_denominator=60), step=positive, size=st.integers(0, 40), cut=st.slices(45))
def test_a_progression_is_the_list_of_its_numbers(
    start: Fraction, step: Fraction, size: int, cut: slice
) -> None:
    progression = Progression(start, step, size)
    written = [start + place * step for place in range(size)]
    assert list(progression) == written
    assert list(reversed(progression)) == written[::-1]
    assert list(progression[cut]) == written[cut]
    assert [progression[-place] for place in range(1, size + 1)] == written[::-1]
    assert all(number in progression and progression.count(number) == 1 for number in written)
    for beyond in (size, -size - 1):
        with pytest.raises(IndexError):
            progression[beyond]


@given(start=positive, width=positive, step=positive)
def test_a_progression_ends_at_or_within_a_step_before_the_stop(
    start: Fraction, width: Fraction, step: Fraction
) -> None:
    stop = start + max(width, step)
    numbers = notation.progression(start, stop, step)
    assert numbers[0] == start
    assert stop - step < numbers[-1] <= stop


def test_a_run_from_an_angle_to_itself_is_that_angle() -> None:
    assert list(notation.progression(Fraction(7), Fraction(7), Fraction(10))) == [7]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Fraction(-1, 5), "-0.2"),
        (Fraction(0), "0"),
        (Fraction(1, 3), "0.333333333333333"),
        (Fraction(1, 10**300), "1e-300"),
        (Fraction(10) ** 400, "1e+400"),
    ],
)
def test_a_value_in_a_sentence_is_short_and_never_a_false_zero(value: Fraction, text: str) -> None:
    assert notation.about(value) == text
