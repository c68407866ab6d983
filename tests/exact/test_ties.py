"""Ties, values that nearly tie, and zeros, against exact fractions."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from itertools import product
from math import inf, isqrt
from typing import Any

import flint
import pytest
import textbook
from cli import kurbel as ran
from cli import printed
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp
from textbook import Drive
from timed import WITHOUT_UNITS, kurbel, runs

from kurbel.errors import ProblemError
from kurbel.exact import certify
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.motion.evaluation import DIFFERENCE, METHODS

MOST_DECIMALS = 50
BITS = 640
"""50 decimals take 166 bits and the check of the boundary 150; a rod of 10^9 R costs the textbook 60."""


def root(number: Fraction) -> Fraction:
    """Return the square root of a rational square."""
    found = Fraction(isqrt(number.numerator), isqrt(number.denominator))
    assert found**2 == number
    return found


def rounded_fraction(exact: Fraction, decimals: int, rounding: str) -> int:
    scaled = exact * 10**decimals
    below = int(scaled.numerator // scaled.denominator)
    rest = scaled - below
    if rest == Fraction(1, 2):
        away = below + 1 if exact > 0 else below
        return below + below % 2 if rounding == "half-even" else away
    return below + int(rest > Fraction(1, 2))


def is_tie(exact: Fraction, decimals: int) -> bool:
    return bool((exact * 10**decimals).denominator == 2)


def assert_tie(exact: Fraction, key: str, method: str, drive: Drive, angle: Fraction, decimals: int) -> None:
    assert is_tie(exact, decimals), f"{exact} is no tie to {decimals} decimals"
    for rounding in ("half-away", "half-even"):
        expected = rounded_fraction(exact, decimals, rounding)
        assert kurbel(key, method, drive, angle, decimals, rounding) == expected
    # As λ nears 1, up to 10^-100 here, the textbook's root loses half of that many digits.
    with mp.workprec(2 * BITS):
        distance = textbook.evaluate(key, method, drive, angle, 2 * BITS) - textbook.real(exact)
        assert abs(distance) < mp.mpf(2) ** -BITS


COSINES = {0: Fraction(1), 60: Fraction(1, 2), 90: Fraction(0), 120: Fraction(-1, 2), 180: Fraction(-1)}
COSINES |= {360 - angle: cosine for angle, cosine in COSINES.items()}


# With R = 0.3 m and ω = 5/s where a unit is asked for.
@pytest.mark.parametrize(
    ("key", "method", "ratio", "angle", "exact", "decimals", "away", "even"),
    [
        ("x", "series", "1/5", 60, "0.575", 2, 58, 58),
        ("x_stroke", "series", "1/4", 90, "0.5625", 3, 563, 562),
        ("x_return_stroke", "series", "1/4", 90, "0.4375", 3, 438, 438),
        ("p", "series", "1/4", 0, "1.25", 1, 13, 12),
        ("p", "exact", "1/4", 0, "1.25", 1, 13, 12),
        ("p", "exact", "1/4", 180, "-0.75", 1, -8, -8),
        ("p_return", "exact", "1/4", 180, "-1.25", 1, -13, -12),
        ("p_return", "series", "1/4", 0, "0.75", 1, 8, 8),
        ("p", "series", "1/8", 90, "-0.125", 2, -13, -12),
        ("p_return", "series", "1/8", 90, "0.125", 2, 13, 12),
        ("p", "series", "1/8", 120, "-0.5625", 3, -563, -562),
        ("x", "exact", "4/5", 90, "1.5", 0, 2, 2),
        ("x_return", "exact", "4/5", 90, "0.5", 0, 1, 0),
        ("x", "exact", "8/17", 90, "1.25", 1, 13, 12),
        ("x_return", "exact", "8/17", 90, "0.75", 1, 8, 8),
        ("x_return_percent", "exact", "8/17", 90, "37.5", 0, 38, 38),
        ("p", "exact", "3/5", 90, "-0.75", 1, -8, -8),
        ("p", "exact", "3/5", 270, "-0.75", 1, -8, -8),
        ("p_return", "exact", "3/5", 90, "0.75", 1, 8, 8),
        ("x", "infinite", "1/5", 60, "0.5", 0, 1, 0),
        ("x", "infinite", "1/5", 120, "1.5", 0, 2, 2),
        ("c", "infinite", "1/5", 30, "0.5", 0, 1, 0),
        ("c", "infinite", "1/5", 210, "-0.5", 0, -1, 0),
        ("c_return", "infinite", "1/5", 210, "-0.5", 0, -1, 0),
        ("p", "infinite", "1/5", 120, "-0.5", 0, -1, 0),
        ("p", "infinite", "1/5", -60, "0.5", 0, 1, 0),
        ("x_mm", "series", "1/5", 60, "172.5", 0, 173, 172),
        ("c_mps", "exact", "1/5", 90, "1.5", 0, 2, 2),
        ("p_mps2", "series", "1/4", 0, "9.375", 2, 938, 938),
        ("p_return_mps2", "exact", "1/4", 180, "-9.375", 2, -938, -938),
    ],
)  # fmt: skip
def test_ties_that_tables_meet(
    key: str, method: str, ratio: str, angle: int, exact: str, decimals: int, away: int, even: int
) -> None:
    drive = Drive(Fraction(ratio), Fraction(0), Fraction(3, 10), Fraction(5))
    assert_tie(Fraction(exact), key, method, drive, Fraction(angle), decimals)
    assert kurbel(key, method, drive, Fraction(angle), decimals) == away
    assert kurbel(key, method, drive, Fraction(angle), decimals, "half-even") == even


HALF_UNITS = st.integers(0, MOST_DECIMALS).flatmap(
    lambda decimals: st.tuples(st.just(decimals), st.integers(0, 10**decimals - 1))
)
"""Decimals d and k of an odd number of half units, (k + ½)/10^d, between 0 and 1."""
SHORTEST = Fraction(1, 10**9)
"""The ratio of the longest rod."""


def half_units(drawn: tuple[int, int]) -> Fraction:
    decimals, count = drawn
    return Fraction(2 * count + 1, 2 * 10**decimals)


# The same below 3/8, and not so small that the rod becomes longer than kurbel allows.
SMALL_HALF_UNITS = st.integers(1, MOST_DECIMALS).flatmap(
    lambda decimals: st.tuples(
        st.just(decimals), st.integers(10 ** max(decimals - 9, 0) - 1, 3 * 10**decimals // 8 - 1)
    )
)


@settings(max_examples=150, deadline=None)
@given(
    drawn=SMALL_HALF_UNITS,
    angle=st.sampled_from([60, 120, 240, 300]),
    key=st.sampled_from(["x", "x_return"]),
)
def test_first_order_path_at_60_degrees_meets_ties(drawn: tuple[int, int], angle: int, key: str) -> None:
    # x = 1 - cos φ ± 3/8 λ, made to end in half a unit by the choice of λ.
    decimals, ratio = drawn[0], half_units(drawn) * Fraction(8, 3)
    assert SHORTEST < ratio < 1
    exact = 1 - COSINES[angle] + (1 if key == "x" else -1) * Fraction(3, 8) * ratio
    assert is_tie(exact, decimals)
    assert_tie(exact, key, "series", Drive(ratio), Fraction(angle), decimals)


@settings(max_examples=150, deadline=None)
@given(
    drawn=HALF_UNITS,
    angle=st.sampled_from([60, 90, 120, 240, 270, 300]),
    key=st.sampled_from(["x", "x_return", "x_mm", "x_return_stroke"]),
)
def test_exact_path_meets_ties_where_its_root_is_rational(
    drawn: tuple[int, int], angle: int, key: str
) -> None:
    # With λ = 2t/(t² + sin² φ) the share of the rod, (1 - cos ψ)/λ, is t itself.
    t, square = half_units(drawn), 1 - COSINES[angle] ** 2
    ratio = 2 * t / (t**2 + square)
    assume(t**2 < square and SHORTEST < ratio < 1)
    assert (1 - root(1 - ratio**2 * square)) / ratio == t
    share = 1 - COSINES[angle]
    exact = share + (-t if "return" in key else t)
    unit = {"x_mm": Fraction(1000), "x_return_stroke": Fraction(1, 2)}.get(key, Fraction(1))
    decimals = next((d for d in range(drawn[0] + 3) if is_tie(exact * unit, d)), None)
    assume(decimals is not None)
    assert decimals is not None
    assert_tie(exact * unit, key, "exact", Drive(ratio), Fraction(angle), decimals)


@settings(max_examples=100, deadline=None)
@given(
    drawn=HALF_UNITS,
    angle=st.sampled_from([0, 60, 90, 120, 180, 240, 270, 300, 360]),
    back=st.booleans(),
)
def test_first_order_acceleration_meets_ties(drawn: tuple[int, int], angle: int, back: bool) -> None:
    twice = 2 * COSINES[angle] ** 2 - 1
    ratio = half_units(drawn) / abs(twice)
    assume(SHORTEST < ratio < 1)
    exact = COSINES[angle] + (-ratio if back else ratio) * twice
    decimals = max(drawn[0], 1)
    assume(is_tie(exact, decimals))
    key = "p_return" if back else "p"
    assert_tie(exact, key, "series", Drive(ratio), Fraction(angle), decimals)
    if angle % 180 == 0:
        assert_tie(exact, key, "exact", Drive(ratio), Fraction(angle), decimals)


@pytest.mark.parametrize(
    ("rod", "offset", "key", "angle", "exact", "decimals"),
    [
        ("13/4", "2", "x", 270, "5/2", 0),
        ("29/8", "3/2", "x", 270, "7/4", 1),
        ("45/8", "7/2", "x", 270, "9/4", 1),
        ("29/8", "3/2", "x", -90, "7/4", 1),
        ("3", "9/5", "c", 0, "-3/4", 1),
        ("3", "9/5", "c_return", 0, "-3/4", 1),
        ("3", "-4/5", "p", 90, "-3/4", 1),
        ("2", "-1/5", "p", 90, "-3/4", 1),
        ("3", "4/5", "p_return", 90, "3/4", 1),
    ],
)
def test_offset_cranks_meet_ties(
    rod: str, offset: str, key: str, angle: int, exact: str, decimals: int
) -> None:
    drive = Drive(1 / Fraction(rod), Fraction(offset))
    assert_tie(Fraction(exact), key, "exact", drive, Fraction(angle), decimals)


@pytest.mark.parametrize(
    ("sine_squared", "angle", "t", "decimals"),
    [
        ("1", 90, "3/4", 2),
        ("1", 270, "3/4", 2),
        ("1", 90, "1/2", 1),
        ("1/2", 45, "1/4", 2),
        ("1/2", 135, "1/4", 2),
    ],
)
def test_difference_of_the_methods_meets_ties(sine_squared: str, angle: int, t: str, decimals: int) -> None:
    share, square = Fraction(t), Fraction(sine_squared)
    ratio = 2 * share / (share**2 + square)
    exact = share - ratio * square / 2
    # In mm, with a radius that makes it 3½ units in the last place.
    radius = Fraction(2 * 3 + 1, 2 * 10**decimals) / exact / 1000
    drive = Drive(ratio, Fraction(0), radius)
    assert_tie(exact * radius * 1000, "x_mm", DIFFERENCE, drive, Fraction(angle), decimals)


def test_rod_angle_of_30_degrees_is_exact() -> None:
    half = Drive(Fraction(1, 2))
    for decimals in (0, 1, MOST_DECIMALS):
        assert kurbel("psi", "exact", half, Fraction(90), decimals) == 30 * 10**decimals
        assert kurbel("psi_return", "exact", half, Fraction(90), decimals) == -30 * 10**decimals
        assert kurbel("psi", "exact", half, Fraction(180), decimals) == 0


@pytest.mark.parametrize("side", [-1, 1], ids=["below", "above"])
@pytest.mark.parametrize("agreeing", [20, 40, 55])
@pytest.mark.parametrize("angle", ["37", "60", "11.25", "90", "123.456", "61/3"])
@pytest.mark.parametrize("method", ["exact", "series"])
def test_values_that_nearly_tie_are_resolved(method: str, angle: str, agreeing: int, side: int) -> None:
    # x is the tie that lies nearest to its value for λ = 1/4, but for a few units in decimal `agreeing`.
    phi = Fraction(angle)
    with mp.workprec(BITS):
        cosine = mp.cos(textbook.real(phi) * mp.pi / 180)
        guess = textbook.evaluate("x", "series", Drive(Fraction(1, 4)), phi)
        tie = (mp.floor(guess * 100) + mp.mpf(0.5)) / 100
        t, square = tie - (1 - cosine), 1 - cosine**2
        ratio = 2 * t / square if method == "series" else 2 * t / (t**2 + square)
        drive = Drive(Fraction(int(mp.nint(ratio * 10**agreeing)) + 5 * side, 10**agreeing))
        assert 0 < drive.ratio < 1
        distance = textbook.evaluate("x", method, drive, phi) - tie
        assert 0 < side * distance < mp.mpf(10) ** (2 - agreeing)
        expected = int(mp.floor(tie * 100)) + (side > 0)
    assert kurbel("x", method, drive, phi, 2) == expected
    assert kurbel("x", method, drive, phi, 2, "half-even") == expected


@pytest.mark.parametrize("side", [-1, 1], ids=["below", "above"])
@pytest.mark.parametrize("tiny", [Fraction(1, 10**50), Fraction(1, 3 * 10**45), Fraction(1, 10**30 + 57)])
def test_angles_that_nearly_tie_are_resolved(tiny: Fraction, side: int) -> None:
    angle = 60 + side * tiny
    assert kurbel("x", "infinite", Drive(Fraction(0)), angle, 0, "half-even") == (side > 0)
    assert kurbel("x", "series", Drive(Fraction(1, 5)), angle, 2) == 57 + (side > 0)


def test_methods_need_not_agree_on_a_tie() -> None:
    drive = Drive(Fraction(1, 5))
    assert [kurbel("x", method, drive, Fraction(60), 2) for method in METHODS] == [58, 58, 50]
    assert [kurbel("x", method, drive, Fraction(60), 4) for method in METHODS] == [5756, 5750, 5000]


def negative_zero(text: str) -> bool:
    """Whether a zero with a sign stands anywhere in a rendered table."""
    return re.search(r"(?<![\d°])[-−]0(?:[.,]0+)?(?![\d.]|,\d)", text) is not None


def test_a_negative_zero_would_be_found() -> None:
    for text in ("-0.000", "−0,00", "$-0$", "a,-0.0,b", "<td>−0</td>", "[-0.0, 1]"):
        assert negative_zero(text), text
    for text in ("-0.001", "1-0.05", "−0,0001", "0.000", "-0,010"):
        assert not negative_zero(text), text


@pytest.mark.parametrize("name", [name for name, one in FORMATS.items() if not isinstance(one, BytesFormat)])
def test_no_zero_has_a_sign(name: str) -> None:
    for (last, keys), digits in product(runs(WITHOUT_UNITS), range(3)):
        first = ["--from=-90"] if last == 360 else []
        run = [*first, f"--to={last}", "--columns=phi," + ",".join(keys)]
        page = ran("table", "--ratio=1:5", "--step=7.5", *run, f"--digits={digits}", "-f", name)
        # So wide a table is turned in LaTeX, which is said.
        assert page.code == 0
        assert page.out
        assert not negative_zero(page.out)
    assert not negative_zero(printed("table", "--layout=verfahren", "--digits=2", "-f", name).out)


def test_negative_values_that_round_to_nothing_are_a_plain_zero() -> None:
    run = ["--ratio=1:5", "--angle=181;359;360", "--columns=c", "--digits=1"]
    assert [row["c"] for row in printed("table", *run, "-f", "csv").records()] == ["0.0"] * 3
    rows = json.loads(printed("table", *run, "-f", "json").out)["rows"]
    assert str([row["c"] for row in rows]) == str([0.0] * 3)


def test_dead_centres_are_zero_to_every_decimal() -> None:
    for ratio in (Fraction(0), Fraction(1, 5), Fraction(99, 100)):
        for angle in (Fraction(0), Fraction(180), Fraction(360), Fraction(-540)):
            for key in ("c", "c_return", "c_mps", "psi"):
                assert kurbel(key, "exact", Drive(ratio), angle, MOST_DECIMALS) == 0
        assert kurbel("x", "exact", Drive(ratio), Fraction(360), MOST_DECIMALS) == 0
        assert kurbel("x_return_mm", "exact", Drive(ratio), Fraction(0), MOST_DECIMALS) == 0


def test_precision_in_force_is_left_as_it_was() -> None:
    before = flint.ctx.prec
    kurbel("x", "series", Drive(Fraction(1, 5)), Fraction(60), 2)
    assert flint.ctx.prec == before
    with pytest.raises(ZeroDivisionError):
        certify.rounded(lambda: certify.ball(Fraction(1, 0)), 3, "half-away", certify.NEVER_TIES)
    assert flint.ctx.prec == before


def test_a_doubtful_digit_raises_the_precision() -> None:
    seen: list[int] = []

    def third() -> Any:
        seen.append(flint.ctx.prec)
        exact = certify.ball(Fraction(1, 2) + Fraction(1, 10**60))
        return exact

    assert certify.rounded(third, 0, "half-even", lambda boundary: 10**6) == 1
    assert len(seen) > 1
    assert seen == sorted(set(seen))


@pytest.mark.parametrize("bits", [1e7, inf])
def test_a_tie_that_would_take_minutes_to_prove_is_given_up_with_a_sentence(bits: float) -> None:
    def quarter() -> flint.arb:
        return certify.pi() / certify.pi() / 4

    assert certify.rounded(quarter, 1, "half-away", lambda boundary: 300.0) == 3
    assert certify.rounded(quarter, 1, "half-even", lambda boundary: 300.0) == 2
    most = certify.MOST_BITS if bits == inf else certify.MOST_TIE_BITS
    before = flint.ctx.prec
    with pytest.raises(ProblemError) as raised:
        certify.rounded(quarter, 1, "half-away", lambda boundary: bits)
    found = re.fullmatch(
        r"a digit is not settled by (\d+) bits: the value may lie half-way between two printed ones;"
        r" ask for another number of digits",
        str(raised.value),
    )
    assert found is not None
    assert most / 2 < int(found[1]) <= most
    assert flint.ctx.prec == before


# A page, the row and the column of a value, that value half-way with both roundings, and one beside it.
HALVES = [
    # Four axles have a quarter of the torque each.
    ("forces --mechanism=parallel --axles=4 --force={}N --stroke=2m --angle=90 --digits=0", 0, "torque_nm",
     ("10", "3", "2"), ("10.001", "3")),
    ("forces --mechanism=parallel --axles=4 --angle={} --digits=2", 0, "tangential_force",
     ("30", "0.13", "0.12"), ("30.001", "0.13")),
    ("turning --torque=1000+0.5sinφ --angle={} --digits=1", 0, "excess_torque",
     ("30", "0.3", "0.2"), ("30.001", "0.3")),
    ("turning --areas=1;-1 --area-scale={}J --digits=0", 1, "excess_energy",
     ("2.5", "3", "2"), ("2.501", "3")),
    ("pressures --eps=2 --stroke=1m --bore=1m --speed=1/s --reciprocating=1kg --pressure={}bar --angle=30"
     " --digits=2", 0, "gas_pressure", ("8.25", "4.13", "4.12"), ("8.2501", "4.13")),
    # 1 - cos 60° = 1/2.
    ("construct blau-9 --ratio=1:4 --angle={} --table --digits=0", 1, "drawn",
     ("60", "1", "0"), ("60.001", "1")),
]  # fmt: skip


@pytest.mark.parametrize(("words", "row", "column", "tie", "beside"), HALVES, ids=[one[2] for one in HALVES])
def test_pages_round_what_lies_half_way_as_asked_and_what_lies_beside_it_to_its_side(
    words: str, row: int, column: str, tie: tuple[str, str, str], beside: tuple[str, str]
) -> None:
    def shown(given: str, rounding: str) -> str:
        asked = (*words.format(given).split(), f"--rounding={rounding}", "--format=csv")
        return printed(*asked).records()[row][column]

    roundings = ("half-away", "half-even")
    assert [shown(tie[0], one) for one in roundings] == [*tie[1:]]
    assert [shown(beside[0], one) for one in roundings] == [beside[1]] * 2
