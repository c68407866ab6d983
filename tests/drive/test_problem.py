"""A crank drive that cannot turn is refused in the user's words."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.reading.notation import Progression
from kurbel.reading.units import Speed

FIFTH = Fraction(1, 5)


def sentence_of_crank(*arguments: Fraction | Speed | None) -> str:
    with pytest.raises(ProblemError) as raised:
        Crank(*arguments)  # type: ignore[arg-type]
    return str(raised.value)


@pytest.mark.parametrize(
    ("ratio", "shown"),
    [
        (Fraction(1), "1"),
        (Fraction(3, 2), "1.5"),
        (Fraction(4, 3), "1.33333333333333"),
        (Fraction(10) ** 400, "1e+400"),
    ],
)
def test_a_rod_no_longer_than_the_crank_is_too_short(ratio: Fraction, shown: str) -> None:
    assert sentence_of_crank(ratio) == (
        f"crank ratio R:L is {shown}; it must be below 1, or the rod is too short to pass the dead centre"
    )


def test_a_negative_ratio_is_refused() -> None:
    assert sentence_of_crank(-FIFTH) == (
        "crank ratio R:L is -0.2; it must not be negative, for both are lengths"
    )


def test_a_rod_of_a_thousand_million_radii_is_the_longest() -> None:
    assert Crank(Fraction(1, 10**9)).ratio == Fraction(1, 10**9)
    assert sentence_of_crank(Fraction(1, 10**9 + 1)) == (
        "crank ratio R:L is below 1:1000000000; no rod is that long, write 1:∞ or 1:inf for an infinite one"
    )


@pytest.mark.parametrize("ratio", [Fraction(0), Fraction(999999999, 10**9)])
def test_every_ratio_below_one_can_turn(ratio: Fraction) -> None:
    assert Crank(ratio).ratio == ratio


@pytest.mark.parametrize(
    ("offset", "where"),
    [
        (Fraction(4), "for at φ = 270° the rod stands square to the slide"),
        (Fraction(-4), "for at φ = 90° the rod stands square to the slide"),
        (Fraction(9, 2), "for at φ = 210° the rod stands square to the slide"),
        (Fraction(-11, 2), "for at φ = 330° the rod stands square to the slide"),
        (Fraction(6), "and this rod reaches the slide at no angle"),
    ],
)
def test_an_offset_as_large_as_rod_less_crank_cannot_turn(offset: Fraction, where: str) -> None:
    assert sentence_of_crank(FIFTH, offset) == (
        f"offset e = {float(offset):g} R is too large for R:L = 1:5;"
        f" the crank turns only if |e| < L - R = 4 R, {where}"
    )
    Crank(FIFTH, offset * Fraction(399, 400) * 4 / abs(offset))


def test_lengths_and_speeds_are_above_zero() -> None:
    assert sentence_of_crank(FIFTH, Fraction(0), Fraction(-3, 10)) == (
        "the crank radius is -0.3 m; it must be above 0"
    )
    with pytest.raises(ProblemError, match=r"^the speed is -2/s; it must be above 0$"):
        Speed(Fraction(-2))


def test_a_speed_without_a_length_gives_no_metres() -> None:
    assert sentence_of_crank(FIFTH, Fraction(0), None, Speed(Fraction(2))) == (
        "a speed needs a length to give m/s; add --stroke, for example --stroke 600mm"
    )


def test_a_table_needs_an_angle() -> None:
    with pytest.raises(ProblemError, match=r"^no angle was given; write them as --angle 0;45;90"):
        check_angles(())


@pytest.mark.parametrize(
    "angles",
    [
        (Fraction(0), Fraction(10**6 + 1), Fraction(1)),
        (Fraction(-(10**6) - 1),),
        Progression(Fraction(0), Fraction(1, 10), 10**7 + 2),
        Progression(Fraction(-(10**6) - 1), Fraction(1), 3),
    ],
)
def test_angles_beyond_a_million_degrees_are_refused(angles: tuple[Fraction, ...] | Progression) -> None:
    with pytest.raises(
        ProblemError, match=r"^an angle is beyond 1000000°; give it within one turn, 0\.\.360$"
    ):
        check_angles(angles)


def test_angles_up_to_a_million_degrees_are_allowed_in_either_direction() -> None:
    check_angles((Fraction(10**6), Fraction(-(10**6))))
    check_angles(Progression(Fraction(-(10**6)), Fraction(10**6), 3))
