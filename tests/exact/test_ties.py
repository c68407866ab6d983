"""Ties, values that nearly tie, and zeros, against exact fractions."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from math import inf, isqrt
from typing import Any

import flint
import pytest
from cli import kurbel as ran
from cli import printed
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel import KurbelError, certified, verify
from kurbel.exact import certify
from kurbel.formats.registry import FORMATS, BytesFormat

F = Fraction
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


def assert_tie(
    exact: F, key: str, method: str, ratio: F, angle: int, decimals: int, offset: str | F = "0"
) -> None:
    """Both roundings of both arithmetics are those of the fraction."""
    assert is_tie(exact, decimals), f"{exact} is no tie to {decimals} decimals"
    true = verify.drive(ratio, offset).value(key, angle, method)
    for rounding in ("half-away", "half-even"):
        expected = rounded_fraction(exact, decimals, rounding)
        assert true.scaled(decimals, rounding) == expected
        assert digits(key, ratio, angle, decimals, method, rounding, offset) == expected


def digits(
    key: str, ratio: F, angle: F | int, decimals: int, method: str = "exact", rounding: str = "half-away",
    offset: str | F = "0",
) -> int:  # fmt: skip
    """Return what kurbel prints, in units of the last decimal."""
    found = certified(key, ratio, angle, digits=decimals, method=method, rounding=rounding, offset=offset)
    return int(Fraction(found) * 10**decimals)


COSINES = {0: Fraction(1), 60: Fraction(1, 2), 90: Fraction(0), 120: Fraction(-1, 2), 180: Fraction(-1)}
COSINES |= {360 - angle: cosine for angle, cosine in COSINES.items()}


@pytest.mark.parametrize(
    ("key", "method", "ratio", "angle", "exact", "decimals", "away", "even"),
    [
        ("x", "series", "1/5", 60, "0.575", 2, 58, 58),
        ("x_stroke", "series", "1/4", 90, "0.5625", 3, 563, 562),
        ("x_return_stroke", "series", "1/4", 90, "0.4375", 3, 438, 438),
        ("p", "series", "1/4", 0, "1.25", 1, 13, 12),
        ("p", "exact", "1/4", 0, "1.25", 1, 13, 12),
        ("p", "exact", "1/4", 180, "-0.75", 1, -8, -8),
        ("p", "series", "1/8", 90, "-0.125", 2, -13, -12),
        ("x", "exact", "4/5", 90, "1.5", 0, 2, 2),
        ("x_return", "exact", "4/5", 90, "0.5", 0, 1, 0),
        ("x", "exact", "8/17", 90, "1.25", 1, 13, 12),
        ("x_return", "exact", "8/17", 90, "0.75", 1, 8, 8),
        ("x_return_percent", "exact", "8/17", 90, "37.5", 0, 38, 38),
        ("p", "exact", "3/5", 90, "-0.75", 1, -8, -8),
        ("x", "infinite", "1/5", 60, "0.5", 0, 1, 0),
        ("x", "infinite", "1/5", 120, "1.5", 0, 2, 2),
        ("c", "infinite", "1/5", 30, "0.5", 0, 1, 0),
        ("c", "infinite", "1/5", 210, "-0.5", 0, -1, 0),
        ("p", "infinite", "1/5", -60, "0.5", 0, 1, 0),
    ],
)  # fmt: skip
def test_ties_that_tables_meet(
    key: str, method: str, ratio: str, angle: int, exact: str, decimals: int, away: int, even: int
) -> None:
    assert rounded_fraction(Fraction(exact), decimals, "half-away") == away
    assert rounded_fraction(Fraction(exact), decimals, "half-even") == even
    assert_tie(Fraction(exact), key, method, Fraction(ratio), angle, decimals)


HALF_UNITS = st.integers(0, MOST_DECIMALS).flatmap(
    lambda decimals: st.tuples(st.just(decimals), st.integers(0, 10**decimals - 1))
)
"""Decimals d and k of an odd number of half units, (k + ½)/10^d, between 0 and 1."""
SHORTEST = Fraction(1, 10**9)
"""The ratio of the longest rod."""


def half_units(drawn: tuple[int, int]) -> Fraction:
    decimals, count = drawn
    return Fraction(2 * count + 1, 2 * 10**decimals)


@settings(max_examples=40, deadline=None)
@given(
    drawn=HALF_UNITS,
    angle=st.sampled_from([60, 90, 120, 240, 270, 300]),
    key=st.sampled_from(["x", "x_return", "x_return_stroke"]),
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
    unit = Fraction(1, 2) if key == "x_return_stroke" else Fraction(1)
    decimals = next((d for d in range(drawn[0] + 3) if is_tie(exact * unit, d)), None)
    assume(decimals is not None)
    assert decimals is not None
    assert_tie(exact * unit, key, "exact", ratio, angle, decimals)


@settings(max_examples=40, deadline=None)
@given(drawn=HALF_UNITS, angle=st.sampled_from([0, 60, 90, 120, 180, 240, 270, 300, 360]), back=st.booleans())
def test_first_order_path_and_acceleration_meet_ties(drawn: tuple[int, int], angle: int, back: bool) -> None:
    # x = 1 - cos φ ± ½ λ sin² φ, made to end in half a unit by the choice of λ; p with λ cos 2φ.
    cosine, sign = COSINES[angle], -1 if back else 1
    for key, share, rest in (("x", (1 - cosine**2) / 2, 1 - cosine), ("p", 2 * cosine**2 - 1, cosine)):
        ratio = half_units(drawn) / abs(share) if share else Fraction(0)
        exact, decimals = rest + sign * ratio * share, max(drawn[0], 1)
        if not SHORTEST < ratio < 1 or not is_tie(exact, decimals):
            continue
        key = f"{key}_return" if back else key
        assert_tie(exact, key, "series", ratio, angle, decimals)
        if angle % 180 == 0:
            assert_tie(exact, key, "exact", ratio, angle, decimals)


@pytest.mark.parametrize(
    ("rod", "offset", "key", "angle", "exact", "decimals"),
    [
        ("13/4", "2", "x", 270, "5/2", 0),
        ("29/8", "3/2", "x", 270, "7/4", 1),
        ("3", "9/5", "c", 0, "-3/4", 1),
        ("3", "9/5", "c_return", 0, "-3/4", 1),
        ("3", "-4/5", "p", 90, "-3/4", 1),
        ("3", "4/5", "p_return", 90, "3/4", 1),
    ],
)
def test_offset_cranks_meet_ties(
    rod: str, offset: str, key: str, angle: int, exact: str, decimals: int
) -> None:
    assert_tie(Fraction(exact), key, "exact", 1 / Fraction(rod), angle, decimals, Fraction(offset))


def test_rod_angle_of_30_degrees_is_exact() -> None:
    for decimals in (0, 1, MOST_DECIMALS):
        for key, angle, degrees in (("psi", 90, 30), ("psi_return", 90, -30), ("psi", 180, 0)):
            assert digits(key, Fraction(1, 2), angle, decimals) == degrees * 10**decimals


@pytest.mark.parametrize("side", [-1, 1], ids=["below", "above"])
@pytest.mark.parametrize("agreeing", [20, 55])
@pytest.mark.parametrize("angle", ["37", "60", "90", "61/3"])
@pytest.mark.parametrize("method", ["exact", "series"])
def test_values_that_nearly_tie_are_resolved(method: str, angle: str, agreeing: int, side: int) -> None:
    # x is the tie that lies nearest to its value for λ = 1/4, but for a few units in decimal `agreeing`.
    phi = Fraction(angle)
    with mp.workdps(150):
        cosine = mp.cos(mp.mpf(phi.numerator) / phi.denominator * mp.pi / 180)
        t = (mp.floor((1 - cosine + (1 - cosine**2) / 8) * 100) + mp.mpf(0.5)) / 100 - (1 - cosine)
        square = 1 - cosine**2
        ratio = 2 * t / square if method == "series" else 2 * t / (t**2 + square)
        near = Fraction(int(mp.nint(ratio * 10**agreeing)) + 5 * side, 10**agreeing)
        expected = int(mp.floor((t + 1 - cosine) * 100)) + (side > 0)
    for rounding in ("half-away", "half-even"):
        assert verify.drive(near).value("x", phi, method).scaled(2, rounding) == expected
        assert digits("x", near, phi, 2, method, rounding) == expected


@pytest.mark.parametrize("side", [-1, 1], ids=["below", "above"])
@pytest.mark.parametrize("tiny", [Fraction(1, 10**50), Fraction(1, 3 * 10**45), Fraction(1, 10**30 + 57)])
def test_angles_that_nearly_tie_are_resolved(tiny: Fraction, side: int) -> None:
    angle = 60 + side * tiny
    assert digits("x", Fraction(0), angle, 0, "infinite", "half-even") == (side > 0)
    assert digits("x", Fraction(1, 5), angle, 2, "series") == 57 + (side > 0)


def negative_zero(text: str) -> bool:
    """Whether a zero with a sign stands anywhere in a rendered table."""
    return re.search(r"(?<![\d°])[-−]0(?:[.,]0+)?(?![\d.]|,\d)", text) is not None


@pytest.mark.parametrize("name", [name for name, one in FORMATS.items() if not isinstance(one, BytesFormat)])
def test_no_zero_has_a_sign(name: str) -> None:
    assert negative_zero("$-0$")
    assert not negative_zero("−0,0001")
    for last, columns in ((180, "x,x_return,c,c_return,p,p_return"), (360, "c,p,psi,guide_force,torque")):
        for digits in (0, 2):
            run = ["--step=7.5", f"--to={last}", f"--columns=phi,{columns}", f"--digits={digits}"]
            page = ran("table", "--ratio=1:5", *run, "-f", name)
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
        for angle in (0, 180, 360, -540):
            for key in ("c", "c_return", "psi"):
                assert digits(key, ratio, angle, MOST_DECIMALS) == 0
        assert digits("x", ratio, 360, MOST_DECIMALS) == 0
        assert digits("x_return", ratio, 0, MOST_DECIMALS) == 0


def test_precision_in_force_is_left_as_it_was() -> None:
    before = flint.ctx.prec
    digits("x", Fraction(1, 5), 60, 2, "series")
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
    with pytest.raises(KurbelError) as raised:
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
    # 345/2 mm; exact and first-order path differ by 1/2 mm.
    ("table --stroke=600mm --ratio=1:5 --method=series --angle={} --digits=0", 0, "x_mm",
     ("60", "173", "172"), ("60.01", "173")),
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
