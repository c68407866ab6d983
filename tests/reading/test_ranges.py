"""Ranges, lists and shares as others write them: understood, or answered with how they are written here."""

from __future__ import annotations

import shlex
from fractions import Fraction

import numpy as np
import pytest
from cli import printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel
from kurbel.reading import notation
from kurbel.reading.foreign import respelled
from kurbel.reading.notation import share

# Spellings of a range with a step and of one without, and of a list.
WITH_STEP = (
    "{0}-{1}:{2}", "{0}–{1}/{2}", "{0} - {1} step {2}", "{0}..{1}..{2}", "{0}…{1}:{2}", "{0} to {1} by {2}",
    "{0} bis {1} in Schritten von {2}", "{0}:{2}:{1}", "[{0}:{2}:{1}]",
)  # fmt: skip
PLAIN = ("{0}-{1}", "{0}–{1}", "{0}…{1}", "{0}...{1}", "{0} to {1}", "{0}:{1}", "({0} bis {1})")
LISTS = ("{0} {1} {2}", "{0}|{1}|{2}", "[{0}, {1}, {2}]", "{0} - {1} - {2}")


@settings(deadline=None, max_examples=40)
@given(
    st.integers(0, 90), st.integers(1, 10), st.integers(1, 9), st.sampled_from((*WITH_STEP, *PLAIN, *LISTS))
)
def test_a_range_is_answered_with_the_very_range(first: int, step: int, count: int, spelling: str) -> None:
    last = first + count * step
    text = spelling.format(first, last, step)
    with pytest.raises(kurbel.KurbelError) as raised:
        notation.angles([text])
    (written,) = shlex.split(str(raised.value).rpartition("write it as ")[2])
    asked = [*range(first, last + 1, step if spelling in WITH_STEP else 1)]
    assert [*notation.angles([written])] == (
        [*dict.fromkeys((first, last, step))] if spelling in LISTS else asked
    )


@settings(deadline=None, max_examples=20)
@given(st.integers(-90, 90), st.integers(1, 180), st.integers(2, 19))
def test_functions_of_numpy_are_answered_with_their_numbers(first: int, over: int, count: int) -> None:
    even = respelled(f"np.linspace({first}, {first + over}, {count})")
    np.testing.assert_allclose(
        [*map(float, notation.angles([even]))],
        np.linspace(first, first + over, count),
        rtol=1e-12,
        atol=1e-12,
    )
    if over > count:
        steps = respelled(f"arange({first}, {first + over}, {count})")
        assert [*notation.angles([steps])] == np.arange(first, first + over, count).tolist()


@pytest.mark.parametrize(
    ("words", "written"),
    [
        (("table", "--ratio=1:5", "--angle=0-180"), "0..180"),
        (("table", "--ratio=1:5", "--angle=0:10:180"), "0..180:10"),
        (("table", "--ratio=1:5", "--angle=2°30'–10°"), '"2°30\'..10°"'),
        (("table", "--ratio=1:3…6:0.5"), "1:3..6:0.5"),
        (("table", "--ratio=1:4 1:5"), "'1:4;1:5'"),
        (("delta", "--eps=2-6"), "2..6"),
        (("deadcentres", "--ratio=1:5", "--beam=3-4:0,5"), "3..4:0,5"),
        (("balance", "--cranks=0-180-180-0"), "'0;180;180;0'"),
    ],
    ids=lambda one: one if isinstance(one, str) else " ".join(one),
)
def test_every_list_of_a_command_is_answered_so(words: tuple[str, ...], written: str) -> None:
    assert refusal(*words).endswith(f" is not how lists and ranges are written; write it as {written}")


@pytest.mark.parametrize(
    "text", ["0..180:0", "180-0", "1 1/2 x", "a-b", "0-", "-5", "…", "linspace(0)", "1" * 130]
)
def test_what_is_no_range_keeps_its_own_sentence(text: str) -> None:
    with pytest.raises(kurbel.KurbelError) as raised:
        notation.angles([text, "no angle"])
    assert "write it as" not in str(raised.value) or "22°30'" in str(raised.value)


@settings(deadline=None, max_examples=30)
@given(st.text(st.sampled_from("0123 .,:-–…/;[]()°'tobyrangelisp"), max_size=30))
def test_any_text_is_respelled_or_left(text: str) -> None:
    respelled(text)
    respelled(text, ratios=True)
    try:
        notation.angles([text])
    except kurbel.KurbelError as error:
        assert str(error).isprintable()


# Shares ------------------------------------------------------------------------------------------

TENTH = ("0,1", "0.1", "10 %", "10%", "1/10", "1:10", "100‰", "10 percent", "10 Prozent")


def test_a_share_has_many_spellings() -> None:
    assert {share(text) for text in TENTH} == {Fraction(1, 10)}
    assert share("2 1/2 %") == Fraction(1, 40)
    for text in ("1:0", "x%", "1:2:3", "%", ":", "10%%"):
        with pytest.raises(kurbel.KurbelError, match="share"):
            share(text)


def test_ratios_of_pressures_and_volumes_are_ratios_and_no_ranges() -> None:
    three = printed("delta", "--pressure-ratio=3", "-f", "csv").out
    assert printed("delta", "--pressure-ratio=3:1", "-f", "csv").out == three
    five = ("delta", "--cycle=otto", "--peak-pressure=30", "-f", "csv")
    assert printed(*five, "--compression=5:1").out == printed(*five, "--compression=5").out
    assert refusal("delta", "--eps=4:1").startswith('expansion ratio "4:1" is not a number')


STEAM = ("--eps=4", "--ratio=1:5")
WHEEL = ("flywheel", "--swing=5kJ", "--speed=300/min", "--radius=1m")
SHARES = {
    "clearance": ("delta", *STEAM),
    "back": ("delta", *STEAM),
    "efficiency": ("power", "--eps=4", "--pressure=8bar", "--bore=30cm", "--stroke=60cm", "--speed=2/s"),
    "diagram_factor": ("power", "--eps=4", "--pressure=8bar", "--bore=30cm", "--stroke=60cm", "--speed=2/s"),
    "share": ("balance", "--engine=v2-90"),
    "shares": ("pressures", *STEAM, "--bore=30cm", "--pressure=8bar"),
    "offset": ("table", "--ratio=1:5"),
    "delta": WHEEL,
    "rim_share": (*WHEEL, "--delta=1%", "--rim-diameter=2m"),
    "energy_fluctuation": ("flywheel", "--power=9kW", "--speed=90/min", "--delta=1%", "--radius=2m"),
    "pin_friction": ("forces", "--ratio=1:5", "--force=9kN", "--stroke=1m", "--crank-pin=9cm"),
}


@pytest.mark.parametrize("option", SHARES)
def test_options_that_ask_for_a_share_take_any_spelling(option: str) -> None:
    flag, words = f"--{option.replace('_', '-')}", SHARES[option]
    assert len({printed(*words, flag, text, "-f", "csv").out for text in ("0,1", "10 %", "1:10")}) == 1
