"""The turn of a steam engine: sizes and places of its extreme speeds against quadrature and § 150."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from cli import records
from figures import rows as rows_of
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from machines import machine
from mpmath import mp
from verified import verified, words

import kurbel

DIGITS = 50
STROKES = ("outstroke", "return")
AT = ("tangential", "energy")


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with mp.workdps(DIGITS + 10):
        yield


def hundredths(low: int, high: int) -> st.SearchStrategy[str]:
    return st.integers(low, high).map(lambda count: f"{count / 100:.2f}")


angles = st.lists(st.integers(0, 3600).map(lambda count: f"{count / 10}"), max_size=3)
# Cranks that coincide, whole turns apart and evenly spaced have corners in common.
cranks = st.one_of(
    st.sampled_from(("0", "0;0", "0;720;-360", "0;180", "0;90;180;270", "0;120;240", "0;72;144;216;288")),
    angles.map(lambda later: ";".join(["0", *later])),
)
engines = st.fixed_dictionaries(
    {
        "eps": st.one_of(hundredths(100, 300), hundredths(100, 5000)),
        "ratio": hundredths(0, 90),
        "exponent": st.one_of(st.just("1"), hundredths(50, 200)),
        "clearance": st.one_of(st.just("0"), hundredths(0, 30)),
        "single_acting": st.booleans(),
        "cranks": cranks,
        "method": st.sampled_from(("exact", "series")),
    },
    optional={"back": hundredths(0, 80)},
)


@settings(max_examples=12, deadline=None)
@given(engines)
def test_extremes_of_the_turn_and_of_each_stroke_are_those_of_quadrature(options: dict[str, Any]) -> None:
    turn = machine(**options).turn
    # An engine that hardly works loses digits of δ.
    assume(turn.mean > 1e-3 and turn.delta < 100)
    *strokes, whole = rows_of(kurbel.delta(**options, detail=True, digits=8))
    assert float(whole["mean_force"]) == pytest.approx(turn.mean, abs=6e-9)
    assert float(whole["delta"]) == pytest.approx(turn.delta, abs=2e-8)
    for end, least in (("min", True), ("max", False)):
        assert float(whole[f"v_{end}"]) == pytest.approx(turn.extreme(not least).energy, abs=6e-9)
        place = turn.at(turn.energy, float(whole[f"alpha_{end}"]))
        assert float(whole[f"v_{end}"]) == pytest.approx(float(place[0]), abs=2e-8)
    for number, one in enumerate(strokes):
        begin = 180 * number
        own = [at for at in turn.extremes if begin <= at.degrees < begin + 180]
        for end, rising in (("min", True), ("max", False)):
            found = (float(one[f"alpha_{end}"]) + begin, float(one[f"v_{end}"]))
            assert found in [
                pytest.approx((at.degrees, at.energy), abs=1e-6) for at in own if at.rising is rising
            ]


HARD: list[dict[str, Any]] = [
    {"eps": "2"},
    {"eps": "2", "method": "series"},
    {"eps": "47/3", "ratio": "0.9", "back": "0"},
    {"eps": "1", "back": "0", "method": "series"},
    {"eps": "3", "back": "1/7", "exponent": "13/10", "clearance": "1/20", "single_acting": True},
    {"eps": "7/3", "ratio": "2/9", "exponent": "3/4", "clearance": "1/9", "cranks": "0;90"},
    {"eps": "50", "ratio": "1:∞", "exponent": "1/2", "clearance": "3/10", "single_acting": True},
    {"eps": "4", "ratio": "1:4", "back": "1/10", "single_acting": True, "cranks": "0;140.7"},
]  # fmt: skip


@pytest.mark.parametrize("options", HARD, ids=str)
def test_fifty_digits_are_true(options: dict[str, Any]) -> None:
    turn, asked = verified(**options), [*words(options), f"--digits={DIGITS}"]
    columns = ("mean_force", "delta", "v_min", "v_max", "alpha_min", "alpha_max")
    (page,) = records("delta", *asked, f"--columns={','.join(columns)}")
    assert page == {key: turn.value(key).digits(DIGITS) for key in columns}
    # Of this turn and of a later one.
    places = {"0": 720, "37/3": 0, "90": 720, "180": 0, "911/3": 720}
    at = tuple(Fraction(place) + around for place, around in places.items())
    rows = rows_of(kurbel.turning(**options, angle=at, columns=",".join(AT), digits=DIGITS))
    for place, row in zip(places, rows, strict=True):
        for key in AT:
            assert turn.value(key, place).digits(DIGITS) == row[key], (key, place)


def detail(*words: str) -> dict[str, dict[str, Any]]:
    """Return the figures of the strokes and of the turn, angles in radians from the stroke's dead centre."""
    found = {}
    for record in records("delta", "--detail", f"--digits={DIGITS}", *words):
        own = {key: mp.mpf(record[key]) for key in ("v_min", "v_max")}
        own |= {key: mp.radians(mp.mpf(record[key])) for key in ("alpha_min", "alpha_max")}
        own |= {key: mp.mpf(record[key]) for key in ("mean_force", "delta") if record[key]}
        found[record["stroke"]] = own | {"cut_off": record["alpha_cutoff"]}
    return found


def test_constant_force_and_infinite_rod_have_the_closed_form() -> None:
    # Q(1 - cos α) - P α with P/Q = 2/π is least at sin α = 2/π and greatest half a turn less that angle on.
    found = detail("--eps=1", "--ratio=1:∞", "--back=0")
    least = mp.asin(2 / mp.pi)
    for stroke in STROKES:
        one = found[stroke]
        assert abs(one["alpha_min"] - least) < mp.mpf("1e-49")
        assert abs(one["alpha_max"] - mp.pi + least) < mp.mpf("1e-49")
        assert mp.mpf(one["cut_off"]) == 180
    assert abs(found["turn"]["mean_force"] - 2 / mp.pi) < mp.mpf("1e-49")
    swing = 2 * mp.cos(least) - 2 / mp.pi * (mp.pi - 2 * least)
    assert abs(found["turn"]["delta"] - swing * mp.pi / 2) < mp.mpf("1e-49")


@pytest.mark.parametrize("method", ["exact", "series"])
def test_cut_off_is_where_the_path_is_the_share(method: str) -> None:
    turn = verified(eps="7/3", ratio="2/9", method=method)
    found = detail("--eps=7/3", "--ratio=2/9", f"--method={method}")
    for stroke in STROKES:
        assert found[stroke]["cut_off"] == turn.value("alpha_cutoff", stroke=stroke).digits(DIGITS)


# ε, λ, b: at the best back pressure, greatest speed before the cut-off and beyond it on either stroke.
WEISBACH = [("3", "1/5", None), ("1.1", "0.6", "0.8"), ("1.35", "0.9", "0.9"), ("12", "0.31", "0.05"),
            ("1.15", "0.4", "0"), ("2.5", "0", "0.3"), ("1", "0.25", "0.2")]  # fmt: skip


@pytest.mark.parametrize(("eps", "ratio", "back"), WEISBACH)
def test_weisbachs_angles_fulfil_his_equations(eps: str, ratio: str, back: str | None) -> None:
    """His equations as § 150 prints them; the upper sign is the return stroke."""
    words = (f"--eps={eps}", f"--ratio={ratio}", *(() if back is None else (f"--back={back}",)))
    turn = verified(eps=eps, ratio=ratio, method="series", **({} if back is None else {"back": back}))
    expansion, rod = mp.mpf(eps), mp.mpf(Fraction(ratio).numerator) / Fraction(ratio).denominator
    against = 1 / expansion if back is None else mp.mpf(back)
    found, series = detail(*words, "--method=weisbach"), detail(*words, "--method=series")
    mean = 2 / mp.pi * ((1 + mp.log(expansion)) / expansion - against)
    for number, upper in enumerate((-1, 1)):
        one, other = found[STROKES[number]], series[STROKES[number]]
        angle = one["alpha_min"]
        least = mean / (1 - against)
        assert abs(mp.sin(angle) - least - upper * rod / 2 * mp.sin(2 * angle)) < mp.mpf("1e-45")
        cut_off = Fraction(turn.value("alpha_cutoff", stroke=STROKES[number]).digits(30)) + 180 * number
        if eps == "1" or float(turn.value("power", cut_off)) < mean:
            assert one["alpha_max"] == other["alpha_max"]
            continue
        angle = one["alpha_max"]
        square = mp.sin(angle / 2) ** 2
        loss = expansion * against
        bracket = 1 + upper * rod * square - loss * square * (1 - upper * rod * mp.cos(angle))
        right = (1 + mp.log(expansion) - loss) / (mp.pi * bracket)
        assert abs(mp.cot(angle / 2) - right) < mp.mpf("1e-44")


@pytest.mark.parametrize("eps", ["1", "7/3"])
@pytest.mark.parametrize("method", ["exact", "series", "weisbach"])
def test_infinite_rod_makes_both_strokes_alike(eps: str, method: str) -> None:
    found = detail(f"--eps={eps}", "--ratio=1:∞", "--back=1/8", f"--method={method}")
    assert found["outstroke"] == found["return"]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        # Two single-acting cranks opposite to each other, and two double-acting ones, on infinite rods.
        (("--ratio=1:∞",), ("--ratio=1:∞", "--single-acting", "--cranks=0;180")),
        (("--ratio=1:∞",), ("--ratio=1:∞", "--cranks=0;180")),
        ((), ("--cranks=0;0;720",)),
        # Another crank is the first.
        (("--cranks=0;100;155",), ("--cranks=0;55;260",)),
    ],
)
def test_engines_that_are_the_same_are_equally_irregular(
    one: tuple[str, ...], other: tuple[str, ...]
) -> None:
    common = ("delta", "--eps=2.7", "--back=0.1", "--clearance=4%", "--exponent=1.13", "--columns=delta")
    assert (
        records(*common, "--digits=50", *one)[0]["delta"]
        == records(*common, "--digits=50", *other)[0]["delta"]
    )
