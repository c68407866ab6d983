"""Firing orders: those that handbooks give of usual engines, and the cranks of an order and back."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from cli import printed, refusal
from hypothesis import given
from hypothesis import strategies as st

from kurbel.balance.arrangement import row, usual
from kurbel.balance.firing import cranks_of, dead_centres, firings, fitting, read_order

# As the books of engines list them, by the usual arrangements.
KNOWN = {
    "inline-1": {"1"},
    "inline-2-360": {"1-2"},
    "inline-3": {"1-3-2"},
    "inline-4": {"1-3-4-2", "1-2-4-3"},
    "inline-5": {"1-2-4-5-3"},
    "inline-6": {"1-5-3-6-2-4", "1-2-4-6-5-3", "1-5-4-6-2-3", "1-2-3-6-5-4"},
    "boxer-2": {"1-2"},
}
# Cylinders by pins: 1-8-4-3-6-5-7-2 of American V8 engines, whose pins carry 1 and 2, 3 and 4, and so on.
CROSS_PLANE = "1-8-4-3-6-5-7-2"


@pytest.mark.parametrize("engine", KNOWN)
def test_usual_engines_have_the_firing_orders_of_the_books(engine: str) -> None:
    found = firings(usual()[engine].cylinders, 4)
    assert {one.text for one in found} == KNOWN[engine]
    assert {interval for one in found for interval in one.intervals} == {Fraction(720, len(found[0].order))}


def test_the_v8_with_crossed_pins_fires_as_american_ones_do() -> None:
    # The left bank leads; it has the odd numbers, and the axes stand against the sense of rotation first.
    found = firings(usual()["v8-90"].cylinders, 4)
    mirrored = {"-".join(str(int(part) + (1 if int(part) % 2 else -1)) for part in one.text.split("-"))
                for one in found}  # fmt: skip
    orders = {one.text for one in found} | mirrored
    assert len(found) == 8
    assert any(_alike(CROSS_PLANE, one) for one in orders)


def _alike(order: str, other: str) -> bool:
    """Whether one is the other, begun elsewhere."""
    doubled = other.split("-") * 2
    return any(doubled[start:][: len(other.split("-"))] == order.split("-") for start in range(8))


def test_a_v2_on_one_pin_fires_at_the_angle_of_its_banks_and_the_rest() -> None:
    (only,) = firings(usual()["v2-90"].cylinders, 4)
    assert [*only.intervals] == [450, 270]


@given(
    st.permutations(range(2, 8)),
    st.sampled_from([2, 4]),
    st.lists(st.integers(0, 359), min_size=7, max_size=7),
)
def test_cranks_of_an_order_fire_in_it_at_equal_intervals(
    others: list[int], strokes: int, banks: list[int]
) -> None:
    order = ((1,), *((one,) for one in others))
    axes = [Fraction(one) for one in banks]
    cylinders = row(cranks_of(order, strokes, axes), axes).cylinders
    assert order in [one.order for one in firings(cylinders, strokes)]
    # Step by step: each piston is in its dead centre when its turn has come.
    step = Fraction(180 * strokes, 7)
    centres = dead_centres(cylinders)
    for (before,), (after,) in pairwise(order):
        assert (centres[after - 1] - centres[before - 1] - step) % 360 == 0


def test_an_order_is_held_against_cranks_at_unequal_intervals() -> None:
    cylinders = row((0, 180)).cylinders
    assert set(fitting(cylinders, 4, read_order("2-1")).intervals) == {180, 540}
    page = printed("firing", "--order=1-2", "--banks=0;45", "--intervals=405;315", "-f", "csv")
    assert [record["crank"] for record in page.records()] == ["0", "0"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--cranks=0;180;180;0 --order=1-2-3-4", "cannot fire in the order 1-2-3-4; they can in 1-2-4-3"),
        ("--order=1-2-2-4", "must have each of the cylinders 1 to 4 once"),
        ("--order=1-x", '"1-x" is not understood; write the numbers of the cylinders as 1-3-4-2'),
        ("--order=1-2 --intervals=300;405", "add up to 705°; each must be above 0, and their sum 720°"),
        ("--order=1-2 --intervals=1;2;3", "3 intervals were given, and the order 1-2 has 2"),
        ("--order=1-2 --banks=1;2;3", "the number of banks is 3, and the order has 2 cylinders"),
        ("--intervals=360;360", "give --order and no cranks"),
        ("--strokes=3", "it has 4, of which one works, or 2"),
    ],
)  # fmt: skip
def test_what_no_engine_does_is_refused(words: str, said: str) -> None:
    assert said in refusal("firing", *words.split())


def test_too_many_unequal_cranks_are_refused() -> None:
    cranks = ";".join(str(7 * number) for number in range(15))
    assert "looked for with at most 14" in refusal("firing", f"--cranks={cranks}")
