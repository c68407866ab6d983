"""Firing orders: those that handbooks give of usual engines, and the cranks of an order and back."""

from __future__ import annotations

from itertools import pairwise

import pytest
from cli import column, printed, records
from hypothesis import given, settings
from hypothesis import strategies as st

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
    found = records("firing", f"--engine={engine}")
    assert {row["firing_order"] for row in found} == KNOWN[engine]
    count = len(found[0]["firing_order"].split("-"))
    assert {row["intervals"] for row in found} == {"; ".join([f"{720 // count}°"] * count)}


def test_the_v8_with_crossed_pins_fires_as_american_ones_do() -> None:
    # The left bank leads; it has the odd numbers, and the axes stand against the sense of rotation first.
    found = column("firing_order", "firing", "--engine=v8-90")
    assert len(found) == 8
    orders = [order.split("-") for order in found]
    orders += [[str(int(part) + (1 if int(part) % 2 else -1)) for part in order] for order in orders]
    # An order may begin elsewhere.
    begun = {"-".join((order * 2)[start : start + 8]) for order in orders for start in range(8)}
    assert CROSS_PLANE in begun


def test_a_v2_on_one_pin_fires_at_the_angle_of_its_banks_and_the_rest() -> None:
    assert column("intervals", "firing", "--engine=v2-90") == ["450°; 270°"]


@settings(deadline=None, max_examples=25)
@given(
    st.permutations(range(2, 8)),
    st.sampled_from([2, 4]),
    st.lists(st.integers(0, 359), min_size=7, max_size=7),
)
def test_cranks_of_an_order_fire_in_it_at_equal_intervals(
    others: list[int], strokes: int, banks: list[int]
) -> None:
    order = "-".join(map(str, (1, *others)))
    axes = (f"--banks={';'.join(map(str, banks))}", f"--strokes={strokes}", "--digits=20")
    rows = {row["cylinder"]: row for row in records("firing", f"--order={order}", *axes)}
    # Step by step: each piston is in its dead centre when its turn has come.
    centres = {name: float(row["bank"]) - float(row["crank"]) for name, row in rows.items()}
    for before, after in pairwise(order.split("-")):
        apart = centres[after] - centres[before] - 180 * strokes / 7
        assert (apart + 180) % 360 == pytest.approx(180, abs=1e-9)
        interval = (float(rows[after]["fires_at"]) - float(rows[before]["fires_at"])) % (180 * strokes)
        assert interval == pytest.approx(180 * strokes / 7, abs=1e-9)


def test_an_order_is_held_against_cranks_at_unequal_intervals() -> None:
    rows = records("firing", "--cranks=0;180", "--order=2-1")
    assert sorted(row["interval"] for row in rows) == ["180", "540"]
    page = printed("firing", "--order=1-2", "--banks=0;45", "--intervals=405;315", "-f", "csv")
    assert [record["crank"] for record in page.records()] == ["0", "0"]
