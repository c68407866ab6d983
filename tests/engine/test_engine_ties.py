"""Values of the turning effort that lie exactly half-way between two printed numbers are recognised."""

from __future__ import annotations

import pytest
from cli import printed
from pace import within


def shown(column: str, words: str, rounding: str = "half-away") -> str:
    result = printed("turning", *words.split(), "--rounding", rounding, "--columns", column, "-f", "csv")
    return result.out.splitlines()[1]


# T = (f - b) c and W = 2 A - P α by hand; with an infinite rod c = sin φ, and at 90° half the stroke is done.
TIES = {
    # Before cut-off f = 1: (1 - 1/4) sin 30°.
    "full pressure": ("tangential", "--eps 2 --ratio 1:∞ --back 0.25 --angle 30 --digits 2", "0.38", "0.38"),
    "at cut-off": ("tangential", "--eps 2 --ratio 1:∞ --back 0.75 --angle 90 --digits 1", "0.3", "0.2"),
    # (1/8)/(1/2) = 1/4 of the pressure by Mariotte's law, to the power 3/2 by this one.
    "polytropic": (
        "tangential", "--eps 8 --ratio 1:∞ --exponent 1.5 --back 0 --angle 90 --digits 2", "0.13", "0.12",
    ),
    # ε = 1: W = (1 - b)(s - α/90°), and for λ = 3/5 the path at 90° is s = 1 + 1/3.
    "no expansion": ("energy", "--eps 1 --ratio 3:5 --back 0.25 --angle 90 --digits 1", "0.3", "0.2"),
    "return stroke": ("energy", "--eps 1 --ratio 3:5 --back 0.25 --angle 270 --digits 1", "-0.3", "-0.2"),
    # ε = 4 at 90°: 2 A = (1/4)(2 + 2 ln 2) - b, P α = (1 + ln 4)/4 - b: the logarithms cancel, W = 1/4.
    "logarithms cancel": ("energy", "--eps 4 --ratio 1:∞ --back 0.25 --angle 90 --digits 1", "0.3", "0.2"),
    "logarithms cancel on the way back": (
        "energy", "--eps 4 --ratio 1:∞ --back 0.25 --angle 270 --digits 1", "0.3", "0.2",
    ),
    # Two cranks at 180° do the same at the same time.
    "two cranks": (
        "energy", "--eps 4 --ratio 1:∞ --back 0.25 --angle 90 --cranks 0;180 --digits 0", "1", "0",
    ),
    # 2 (1 - 1/8) = 7/4 of two cranks at 90° that do the same, of which one has turned once more.
    "equal cranks": (
        "tangential", "--eps 1.5 --ratio 1:5 --back 0.125 --angle 90 --cranks 0;360 --digits 1", "1.8", "1.8",
    ),
    # At 60° behind, 30° and 90°: (1 + 1/2) (1 - 1/4) = 9/8.
    "cranks apart": (
        "tangential", "--eps 1 --ratio 1:∞ --back 0.25 --angle 90 --cranks 0;60 --digits 2", "1.13", "1.12",
    ),
    "given back pressure": ("back", "--eps 2 --back 0.05 --angle 0 --digits 1", "0.1", "0.0"),
    # (1/4)^(3/2) = 1/8.
    "best back pressure": ("back", "--eps 4 --exponent 1.5 --angle 0 --digits 2", "0.13", "0.12"),
}  # fmt: skip


@pytest.mark.parametrize(("column", "words", "away", "even"), TIES.values(), ids=TIES)
def test_a_tie_is_rounded_as_one(column: str, words: str, away: str, even: str) -> None:
    assert shown(column, words) == away
    assert shown(column, words, "half-even") == even


def test_a_back_pressure_on_a_tie_is_rounded_as_one_by_delta() -> None:
    words = (
        "delta",
        "--eps",
        "2",
        "--back",
        "0.05",
        "--columns",
        "epsilon,back",
        "--digits",
        "1",
        "-f",
        "csv",
    )
    assert printed(*words).records() == [{"epsilon": "2", "back": "0.1"}]
    assert printed(*words, "--rounding", "half-even").records() == [{"epsilon": "2", "back": "0.0"}]


# With n = 1.135 the expansion line is a 200th root, but at 90° steam is still admitted: T = 1 - b.
@pytest.mark.parametrize(("back", "away", "even"), [("0.125", "0.88", "0.88"), ("0.135", "0.87", "0.86")])
def test_a_tie_before_an_expansion_of_a_high_root_takes_seconds(back: str, away: str, even: str) -> None:
    words = f"--eps 1.5 --ratio 1:5 --exponent 1.135 --back {back} --digits 2 --angle 90"
    with within(150):
        assert shown("tangential", words) == away
        assert shown("tangential", words, "half-even") == even
        # All columns of the page, too.
        assert f" {away.replace('.', ',')} " in printed("turning", *words.split()).out


@pytest.mark.parametrize("angle", ["89.9999999999", "90.0000000001"])
def test_next_to_a_tie_the_digit_is_the_true_one(angle: str) -> None:
    # W is 1/4 at 90° and rises there, for T = 1/2 - 1/4 is above P = ln 4/(2 π) = 0.2206.
    words = f"--eps 4 --ratio 1:∞ --back 0.25 --angle {angle} --digits 1"
    assert shown("energy", words, "half-even") == ("0.2" if angle < "90" else "0.3")
    assert shown("energy", words) == ("0.2" if angle < "90" else "0.3")


def test_zero_is_printed_as_zero() -> None:
    assert shown("energy", "--eps 3 --ratio 1:5 --angle 180 --digits 20") == f"0.{'0' * 20}"
    assert shown("tangential", "--eps 3 --ratio 1:5 --angle 180 --digits 20") == f"0.{'0' * 20}"
